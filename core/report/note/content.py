"""The calculation note of a result, part after part."""

from core.ground.provenance import provenance
from core.report.assumptions import assumptions_of
from core.report.derived import cell_prefix
from core.report.note import site, wall_figures
from core.report.note.parts import Blanks, Box, Derivation, Figures, Heading, Paragraph, Part, Step, Table
from core.report.note.wall_steps import Derivations
from core.report.note.words import Words
from core.report.tie_words import tie_lines
from core.report.verdict_words import in_order, lines_of, sentence_of, tone_of
from core.study.results import StudyResult, WallResult
from core.text.sentence import localized
from core.units import G
from core.version import NAME, VERSION, commit

JUDGEMENT_LINES = 7

FULL_WALLS = 24
"""Walls, of the lowest zeta, whose derivations and figures are in the note; of the others verdict and reasons."""


def note(result: StudyResult, language: str) -> list[Part]:
    """What an engineer signs: site and demand, verdicts of all walls, records, each wall, what was assumed."""
    words = Words(language)
    say = words.say
    parts: list[Part] = [
        Heading(result.case.title, 1),
        Paragraph(
            say("Calculation note: out-of-plane overturning of masonry walls (Circolare 7/2019, C8.7.1.2.1)"), "quiet"
        ),
    ]
    parts += _title(result, words)
    parts += _demand(result, words)
    parts += site.hazard(result, words) + site.building(result, words)
    parts += _verdicts(result, words) + site.before_and_after(result, words)
    parts += _records(result, words)
    ordered = [wall for wall, _ in in_order(result)]
    for wall in ordered[:FULL_WALLS]:
        parts += wall_parts(result, wall, cell_prefix(result, wall), words)
    if ordered[FULL_WALLS:]:
        title = say("Other walls: the derivations are on the sheet Check")
        parts.append(Heading(title, new_page=True))
    for wall in ordered[FULL_WALLS:]:
        parts.append(Heading(f"{wall.name} – {words.word(wall.mechanism)}", 3))
        parts += _verdict(result, wall, words)
    parts += _closing(result, words)
    return parts


def _title(result: StudyResult, words: Words) -> list[Part]:
    say, report, asked = words.say, result.case.report, result.case.demand
    rows = [
        (say("Client"), report.client),
        (say("Site"), report.site),
        (say("Project"), report.project),
        (say("Author"), report.author),
        (say("Revision"), report.revision),
        (say("Date"), report.date),
    ]
    if asked:
        rows.append((say("Seismic site"), ", ".join(filter(None, (asked.site, asked.coordinates)))))
    rows = [row for row in rows if row[1]]
    return [Table((), rows, (1, 3))] if rows else []


def _demand(result: StudyResult, words: Words) -> list[Part]:
    say, demand, asked = words.say, result.demand, result.case.demand
    parts: list[Part] = [Heading(say("Site and demand"))]
    if demand is None:
        return [*parts, Paragraph(say("No demand given: no check."), "strong")]
    steps = []
    for symbol, value, unit in (("V_N", asked.nominal_life_years, say("years")), ("C_U", asked.use_class_factor, "–")):
        if value is not None:
            steps.append(Step(symbol, value, "g", unit))
    if demand.return_period is not None:
        steps.append(Step("T_R", demand.return_period, ".0f", say("years"), "3.2.0"))
    steps += Derivations(result, words).demand
    name = say("Limit state {state}", state=demand.limit_state)
    if demand.target is not None:
        name += f", {demand.target.name}"
    return [*parts, Paragraph(name, "strong"), Derivation(steps)]


def _verdicts(result: StudyResult, words: Words) -> list[Part]:
    """Every wall, the lowest zeta first."""
    say = words.say
    heads = [say("Wall"), say("Mechanism"), "H [m]", "t [m]", "q", "ζ_E", say("Deciding check"), say("Verdict")]
    rows, tones = [], {}
    for n, (wall, decides) in enumerate(in_order(result)):
        found = wall.assessment
        row = [
            wall.name if decides else f"– {wall.name}",
            words.word(wall.mechanism),
            words.number(wall.height, ".2f"),
            words.number(wall.thickness, ".3f"),
            words.number(wall.q_set, ".2f"),
        ]
        if found:
            verdict = found.verdict
            label = next((c.label for c in found.checks if c.name == verdict.governing), None)
            row += [words.number(verdict.zeta_e, ".2f"), words.word(label) if label else "–", words.word(verdict.code)]
            tones[n, 5] = tones[n, 7] = tone_of(result, wall)
        else:
            row += ["–", "–", "–"]
        rows.append(row)
    return [Heading(say("Verdicts of all walls")), Table(heads, rows, (2.3, 1.5, 0.9, 1.0, 0.9, 0.9, 1.9, 1.6), tones)]


def _records(result: StudyResult, words: Words) -> list[Part]:
    """Event, station, filter, and the scale each record is used with."""
    if not result.motions:
        return []
    say = words.say
    heads = [
        say("Record"),
        say("Event and station"),
        say("Date"),
        "M",
        say("Distance [km]"),
        say("Filter [Hz], processing"),
        say("PGA used [g]"),
        say("Scale used"),
        say("Kind"),
    ]
    rows = []
    for motion, kind in zip(result.motions, result.kinds, strict=True):
        where = provenance(motion)
        at_demand = result.demand.scaling(motion) if result.demand else 1.0
        scale = motion.scale * at_demand
        station = ", ".join(part for part in (where.event, where.station) if part)
        cells = [
            station,
            where.date.split()[0] if where.date else "",
            where.magnitude,
            where.distance_km,
            where.filter_and_processing,
        ]
        rows.append(
            [
                motion.name,
                *(cell or "–" for cell in cells),
                words.number(at_demand * motion.pga / G, ".3f"),
                words.number(scale, ".3f"),
                words.word(kind),
            ]
        )
    widths = (2.2, 2.4, 1.2, 0.6, 1.3, 1.9, 1.0, 1.0, 1.4)
    unsaid = [k for k in range(len(heads)) if all(row[k] == "–" for row in rows)]
    told = [k for k in range(len(heads)) if k not in unsaid]
    table = Table([heads[k] for k in told], [[row[k] for k in told] for row in rows], [widths[k] for k in told])
    parts: list[Part] = [Heading(say("Records")), table]
    if unsaid and "natural" in result.kinds:
        parts.append(Paragraph(say("No file states: {columns}.", columns=", ".join(heads[k] for k in unsaid)), "quiet"))
    rules = result.compliance
    if rules is not None:
        line = (
            say("The set is compatible with the spectrum (workbook, sheet Spectral compatibility).")
            if rules.compatible
            else say("The set is not compatible with the spectrum (workbook, sheet Spectral compatibility).")
        )
        parts.append(Paragraph(line))
    return parts


def wall_parts(result: StudyResult, wall: WallResult, name: str, words: Words) -> list[Part]:
    """One wall on at most two pages. name : begins the names of its cells on the sheet Check."""
    say, found = words.say, wall.assessment
    parts: list[Part] = [Heading(f"{wall.name} – {words.word(wall.mechanism)}", 2, new_page=True)]
    first = [wall_figures.drawing(wall, words)]
    derived = Derivations(result, words, name).wall(wall)
    if found is None or found.kinematic is None:
        parts += _pair(first) + site.loads(wall, words)
        q = Step("q", wall.q_set, ".2f", "–", "Eq. 10", cell=f"{name}q_set", label=say("at collapse"))
        for title, steps in derived:
            parts += [Heading(say(title), 3), Derivation([*steps, q])]
        return [*parts, *_verdict(result, wall, words)]
    kinematic = found.kinematic
    held = say("element free to vibrate") if kinematic.free_element else say("not free to vibrate")
    if kinematic.floor:
        held = say("wall at {z:g} m, {kind}", z=float(wall.wall.base_z_m), kind=held)
    parts.append(Paragraph(held, "quiet"))
    parts += _pair([*first, wall_figures.capacity(result, wall, words)]) + site.loads(wall, words)
    for title, steps in derived:
        if steps:
            parts += [Heading(say(title), 3), Derivation(steps)]
    parts += _pair([wall_figures.histories(result, wall, words), wall_figures.peaks(wall, words)])
    parts += _pair([wall_figures.forces_of_ties(result, wall, words), wall_figures.tie_heights(wall, words)])
    return [*parts, *_verdict(result, wall, words)]


def _pair(figures: list) -> list[Part]:
    """The figures that are there, side by side."""
    drawn = [figure for figure in figures if figure is not None]
    return [Figures(drawn)] if drawn else []


def _verdict(result: StudyResult, wall: WallResult, words: Words) -> list[Part]:
    """The sentence of the verdict with every reason and every warning of the wall."""
    say, found, language = words.say, wall.assessment, words.language
    parts: list[Part] = []
    if found is not None:
        parts = [Heading(say("Verdict"), 3), Paragraph(sentence_of(result, wall, language), tone_of(result, wall))]
        lines = [*lines_of(result, wall, language), *tie_lines(wall, language)]
        parts += [Paragraph(f"• {line}") for line in lines]
    parts += [Paragraph(f"• {warning.text(language)}", "quiet") for warning in wall.warnings]
    return parts


def _closing(result: StudyResult, words: Words) -> list[Part]:
    """Assumptions, the program (NTC 2018 10.2), the engineer's judgement and signature."""
    say = words.say
    walls = [wall.wall for wall in result.walls]
    ticks = []
    for code in assumptions_of(walls):
        ticked = code == "no_load" and all(wall.unloaded_confirmed for wall in walls)
        ticks.append(Paragraph(f"{'☑' if ticked else '☐'}  {localized('assumption', code, words.language)}"))
    shared = [(motion.name, warning.text(words.language)) for motion in result.motions for warning in motion.warnings]
    if result.demand:
        shared += [(say("demand"), warning.text(words.language)) for warning in result.demand.warnings]
    parts: list[Part] = []
    if shared:
        parts = [
            Heading(say("Warnings on demand and records"), new_page=True),
            *(Paragraph(f"• {name}: {line}", "quiet") for name, line in shared),
        ]
    program = [
        (say("Title"), NAME),
        (say("Author"), say("the Ribalta authors")),
        (say("Version"), f"{VERSION} {commit()[:12]}".strip()),
        (say("Licence"), "BSD-3-Clause"),
        (
            say("Range of use"),
            say(
                "Rigid block, simple overturning about a hinge, loads of constant size and direction, no sliding, no "
                "vertical motion; equations and limits in the sheet Method of the workbook."
            ),
        ),
        (
            say("Validation"),
            say(
                "Histories against 40-digit solutions and closed forms, checks against hand calculations, both "
                "repeated by the tests that come with the program; method of this analysis: {method}.",
                method=result.method_words,
            ),
        ),
        (say("Input"), f"SHA-256 {result.case.sha256[:16]}…, {result.started_utc[:16].replace('T', ' ')} UTC"),
    ]
    return [
        *parts,
        Heading(say("Assumptions confirmed by the engineer"), new_page=not parts),
        *ticks,
        Blanks((say("Confirmed by"), say("Date"))),
        Heading(say("The program (NTC 2018 10.2)")),
        Table((), program, (1, 4)),
        Heading(say("Reasoned judgement on the results (NTC 2018 10.2)")),
        Box(JUDGEMENT_LINES),
        Blanks((say("Engineer"), say("Place and date"), say("Signature and stamp"))),
    ]
