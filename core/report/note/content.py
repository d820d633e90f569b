"""The calculation note of a result, part after part."""

from collections.abc import Collection, Iterator, Sequence
from itertools import groupby

from core.case.document import document_of
from core.case.register import SET_ASIDE
from core.case.site import FULL_FACTOR
from core.known import require_value
from core.report import assumption_table, register_words
from core.report.confirmed import confirmation_codes
from core.report.derived import cell_prefix
from core.report.note import plan_figure, site, wall_figures
from core.report.note.certainty import certainty, certainty_line
from core.report.note.parts import (
    Bars,
    Blanks,
    Box,
    Contents,
    Derivation,
    Figures,
    Heading,
    Item,
    Paragraph,
    Part,
    Step,
    Table,
)
from core.report.note.record_parts import record_parts
from core.report.note.wall_steps import Derivations
from core.report.place_lines import place_of
from core.report.tie_words import tie_lines
from core.report.uncertainty_text import verdict_of
from core.report.verdict_words import lines_of, sentence_of, sort_results, tone_of
from core.report.words import Words
from core.study.register import make_register
from core.study.results import StudyResult, WallResult
from core.text.sentence import localized
from core.units import G
from core.version import NAME, VERSION, commit

JUDGEMENT_LINES = 7

FULL_WALLS = 24
"""Walls, of the lowest zeta, whose derivations and figures are in the note; of the others verdict and reasons."""

CONTENTS_FROM = 4
"""Walls from which on the note has a table of contents."""

TOLD = 6
"""Walls whose verdict is told on the first page."""

MAX_REASON_LINES = 3
"""Lines that stand below a verdict; the others end the section of the wall."""


def full_note(result: StudyResult, language: str) -> list[Part]:
    """The note with everything: first the answer, then each wall about each hinge, then what it rests on."""
    words = Words(language)
    say = words.say
    ordered = [wall for wall, _ in sort_results(result)]
    parts = _answer(result, words)
    if len(ordered) >= CONTENTS_FROM:
        parts += [Heading(say("Contents"), new_page=True, listed=False), Contents()]
    parts += [*plan_figure.plan(result, words), *site.compare_variants_table(result, words)]
    for wall in ordered[:FULL_WALLS]:
        parts += wall_parts(result, wall, cell_prefix(result, wall), words)
    if ordered[FULL_WALLS:]:
        parts.append(Heading(say("Other walls: the derivations are on the sheet Check"), new_page=True))
    for wall in ordered[FULL_WALLS:]:
        parts.append(Heading(_name(wall, words), 3, wall=result.walls.index(wall)))
        parts += _verdict(result, wall, words)
    parts += (
        demand_parts(result, words)
        + site.place(result, words)
        + site.hazard(result, words)
        + site.building(result, words)
    )
    return [*parts, *record_parts(result, words), *certainty(result, words), *closing_parts(result, words)]


def _name(wall: WallResult, words: Words) -> str:
    return f"{words.titled(wall.name)} – {words.word(wall.mechanism)}"


def head_parts(result: StudyResult, words: Words) -> list[Part]:
    """Title, works and demand, and the heading of the outcomes."""
    say = words.say
    return [
        Heading(result.case.title, 1),
        Paragraph(
            say("Calculation note: out-of-plane overturning of masonry walls (Circolare 7/2019, C8.7.1.2.1)"), "quiet"
        ),
        Table((), works(result, words), (1, 4)),
        Heading(say("Outcome")),
    ]


def _answer(result: StudyResult, words: Words) -> list[Part]:
    """The first page: the works, the demand, the outcome of each wall, what decides and what is to be done."""
    say = words.say
    parts = [*head_parts(result, words), *_verdicts(result, words)]
    told = [(wall, one) for wall, one in sort_results(result) if one and wall.assessment]
    for wall, _ in told[:TOLD]:
        tone = tone_of(result, wall)
        parts.append(Paragraph(sentence_of(wall, words.language), tone))
        parts += [Item(line, sign="→") for line in lines_of(result, wall, words.language, ("to_do",))]
        parts += [*_assumed(result, wall, words), *_limiting(result, wall, words)]
    if told[TOLD:]:
        parts.append(Paragraph(say("{n} more walls: each has its section.", n=len(told) - TOLD), "quiet"))
    return [*parts, Blanks((say("Engineer"), say("Place and date"), say("Signature and stamp")))]


def _assumed(result: StudyResult, wall: WallResult, words: Words) -> list[Part]:
    """The table of assumptions of a wall, what turns the outcome marked."""
    rows = assumption_table.rows_of(result, wall, words.language)
    if not rows:
        return []
    tones = {(k, column): "bad" for k, (_, turns) in enumerate(rows) if turns for column in (4, 5)}
    return [
        Table(assumption_table.heads(words.say), [cells for cells, _ in rows], assumption_table.COLUMN_SHARES, tones)
    ]


def _limiting(result: StudyResult, wall: WallResult, words: Words) -> list[Part]:
    """Sentences that limit the verdict of a wall and are no row of that table."""
    lines = lines_of(result, wall, words.language, ("limits",))
    told = assumption_table.tabled(wall, words.language)
    return [Item(line, "quiet") for line in lines if line not in told]


def works(result: StudyResult, words: Words) -> list[tuple[str, str]]:
    """Works, site and demand, a line each."""
    say, report, asked, demand = words.say, result.case.report, result.case.demand, result.demand
    place = [line for _, line in place_of(result.case.site, words.language)[:2]] if result.case.site else []
    site_of = ", ".join(filter(None, (report.site, *place, *((asked.site, asked.coordinates) if asked else ()))))
    rows = [
        (say("Project"), report.project),
        (say("Client"), report.client),
        (say("Site"), site_of),
        (say("Author"), report.author),
        (say("Date"), ", ".join(filter(None, (report.date, report.revision)))),
        (say("Demand"), say("No demand given: no check.")),
    ]
    if demand is not None:
        said = [
            say("Limit state {state}", state=demand.limit_state),
            f"a_g {words.number(demand.ag / G, '.3f')} g",
            f"S {words.number(demand.soil_factor, '.2f')}",
            f"S a_g {words.number(demand.pga / G, '.3f')} g",
        ]
        if demand.return_period is not None:
            said.append(f"T_R {words.number(demand.return_period, '.0f')} {say('years')}")
        if demand.target is not None:
            said.append(demand.target.name)
        said.append(f"FC {words.number(demand.confidence_factor, '.2f')}")
        said.append(say("ζ required {zeta}", zeta=words.number(demand.zeta_target, ".2f")))
        rows[-1] = (say("Demand"), "; ".join(said))
    return [row for row in rows if row[1]]


def demand_parts(result: StudyResult, words: Words, plan: Sequence[Part] = ()) -> list[Part]:
    """Demand, its spectrum, and FC. plan : of the building, beneath the heading"""
    say, demand, asked = words.say, result.demand, result.case.demand
    parts: list[Part] = [Heading(say("Site and demand"), new_page=True), *plan]
    if demand is None or asked is None:
        return [*parts, Paragraph(say("No demand given: no check."), "strong")]
    steps = []
    for symbol, value, unit in (("V_N", asked.nominal_life_years, say("years")), ("C_U", asked.use_class_factor, "–")):
        if value is not None:
            steps.append(Step(symbol, value, "g", unit))
    if demand.return_period is not None:
        steps.append(Step("T_R", demand.return_period, ".0f", say("years"), "3.2.0"))
    steps += Derivations(result, words).demand
    return [*parts, Derivation(steps), Paragraph(_confidence(result, words), "quiet")]


def _declared(result: StudyResult, words: Words) -> Iterator[str]:
    """What the engineer shows by a document: of each wall, and of the demand."""
    demand = result.case.demand
    titles = dict.fromkeys(
        (wall.part.asked.title, entry) for wall in result.walls for entry in wall.part.asked.evidence
    )
    for title, entry in titles:
        yield f"{title}: {words.word(f'key_{entry.of}')}, {entry.words.text(words.language)}"
    for given in demand.evidence if demand else ():
        yield f"{words.word(f'key_{given.of}')}, {given.words.text(words.language)}"


def _confidence(result: StudyResult, words: Words) -> str:
    """Why FC is what it is."""
    demand = require_value(result.case.demand)
    fc = words.number(demand.confidence_factor, ".2f")
    if demand.confidence_factor >= FULL_FACTOR:
        return words.say(
            "FC {fc}: knowledge level LC1, or the compressive strength is not counted on (C8.7.1.2.1).", fc=fc
        )
    shown = document_of(demand.evidence, "confidence_factor")
    done = shown.words.text(words.language) if shown else ""
    level = demand.knowledge_level or ""
    return words.say("FC {fc}: knowledge level {level}, {investigations}.", fc=fc, level=level, investigations=done)


def _verdicts(result: StudyResult, words: Words) -> list[Part]:
    """Every wall, the lowest zeta first."""
    say = words.say
    heads = [say("Wall"), say("Mechanism"), "H [m]", "t [m]", "q", "ζ_E", say("Deciding check"), say("Verdict")]
    rows, tones = [], {}
    ordered = sort_results(result)
    for n, (wall, decides) in enumerate(ordered):
        assessment = wall.assessment
        row = [
            words.titled(wall.name) if decides else f"– {words.titled(wall.name)}",
            words.word(wall.mechanism),
            words.number(wall.height, ".2f"),
            words.number(wall.thickness, ".3f"),
            words.number(wall.q_set, ".2f"),
        ]
        if assessment:
            verdict = assessment.verdict
            by = next((check for check in assessment.checks if check.name == verdict.governing), None)
            row += [words.number(verdict.zeta_e, ".2f"), words.short(by) if by else "–", words.word(verdict.code)]
            tones[n, 5] = tones[n, 7] = tone_of(result, wall)
        else:
            row += ["–", "–", "–"]
        rows.append(row)
    numbers = [result.walls.index(wall) for wall, _ in ordered]
    return [Table(heads, rows, (3.1, 1.2, 0.8, 0.8, 0.6, 0.7, 1.6, 2.3), tones, numbers)]


def in_runs(steps: list[Step]) -> list[Derivation]:
    """Steps with a formula, and those without, which stand side by side."""
    return [Derivation(list(run)) for _, run in groupby(steps, lambda step: bool(step.formula))]


def wall_parts(result: StudyResult, wall: WallResult, name: str, words: Words) -> list[Part]:
    """Parts of one wall, on at most three pages. name : begins the names of its cells on the sheet Check"""
    say, assessment = words.say, wall.assessment
    parts: list[Part] = [Heading(_name(wall, words), 2, True, result.walls.index(wall))]
    first = [wall_figures.drawing(wall, words), wall_figures.elevation(wall, words)]
    derived = Derivations(result, words, name).wall(wall)
    if assessment is None or assessment.kinematic is None:
        parts += [
            *_verdict(result, wall, words),
            *side_by_side(first),
            *site.solids(wall, words),
            *site.loads(wall, words),
        ]
        q = Step("q", wall.q_set, ".2f", "–", "Eq. 10", cell=f"{name}q_set", label=say("at collapse"))
        for title, steps in derived:
            parts += [Heading(say(title), 3), Derivation([*steps, q])]
        return parts
    kinematic, language = assessment.kinematic, words.language
    held = say("element free to vibrate") if kinematic.free_element else say("not free to vibrate")
    if kinematic.floor:
        held = say("wall at {z:g} m, {kind}", z=float(require_value(wall.wall.demand_height_m)), kind=held)
    parts.append(Paragraph(sentence_of(wall, language), tone_of(result, wall)))
    reasons = lines_of(result, wall, language)
    parts += [Item(line) for line in reasons[:MAX_REASON_LINES]]
    parts += [check_bars(result, wall, words), Paragraph(held, "quiet"), *register_parts(result, wall, words)]
    parts += side_by_side([*first, wall_figures.capacity(result, wall, words)])
    parts += site.solids(wall, words) + site.loads(wall, words)
    for title, steps in derived:
        if steps:
            parts += [Heading(say(title), 3), *in_runs(steps)]
    drawn = [wall_figures.histories(result, wall, words), wall_figures.peaks(wall, words)]
    drawn += [wall_figures.forces_of_ties(result, wall, words)]
    parts += side_by_side(drawn)
    tabled = assumption_table.tabled(wall, language)
    rest = [
        *certainty_line(result, wall, words),
        *(line for line in reasons[MAX_REASON_LINES:] if line not in tabled),
        *tie_lines(wall, language),
        *(warning.text(language) for warning in wall.warnings),
    ]
    if rest:
        parts.append(Heading(say("What else is to be read"), 3))
    return [*parts, *(Item(line, "quiet") for line in rest)]


def register_parts(
    result: StudyResult, wall: WallResult, words: Words, brief: bool = False, shared: Collection[str] = ()
) -> list[Part]:
    """The register of a wall, where this result decides about it. brief : the hinges that do not decide in one row;
    shared : lines that stand elsewhere"""
    verdict = verdict_of(result, wall)
    if verdict is None:
        return []
    describe = register_words.describe_briefly if brief else register_words.describe_rows
    rows = describe(result, verdict, words.say, words.language)
    table = Table(register_words.column_heads(words.say), rows, register_words.COLUMN_SHARES)
    taken = register_words.reactions_line(result, verdict, words.say, words.language)
    last = [taken, register_words.not_possible(result, verdict, words.language)]
    return [table, *(Paragraph(line, "quiet") for line in last if line and line not in shared)]


def check_bars(result: StudyResult, wall: WallResult, words: Words) -> Bars:
    """zeta of each check of a wall over the zeta required."""
    assessed = wall.required_assessment
    rows = [
        (
            words.short(check),
            check.clause,
            check.zeta,
            "good" if check.passed else "bad",
            check.name == assessed.verdict.governing,
        )
        for check in assessed.checks
    ]
    target = result.demand_required.zeta_target
    caption = words.say(
        "ζ of each check; the mark is the ζ required, {zeta}; bold: the check that decides",
        zeta=words.number(target, ".2f"),
    )
    return Bars(rows, target, caption)


def side_by_side(figures: list) -> list[Part]:
    """The figures that are there, up to three in a row."""
    drawn = [figure for figure in figures if figure is not None]
    count = 2 if len(drawn) in (2, 4) else 3
    return [Figures(drawn[k : k + count]) for k in range(0, len(drawn), count)]


def _verdict(result: StudyResult, wall: WallResult, words: Words) -> list[Part]:
    """The sentence of the verdict with every reason and every warning of the wall."""
    assessment, language = wall.assessment, words.language
    parts: list[Part] = []
    if assessment is not None:
        parts = [Paragraph(sentence_of(wall, language), tone_of(result, wall))]
        parts += [Item(line) for line in (*lines_of(result, wall, language), *tie_lines(wall, language))]
    return [*parts, *(Item(warning.text(language), "quiet") for warning in wall.warnings)]


def set_aside_lines(result: StudyResult, words: Words) -> Iterator[str]:
    """What the engineer sets aside, with its document."""
    aside = dict.fromkeys(
        (wall.part.asked.title, entry) for wall in result.walls for entry in wall.part.asked.set_aside
    )
    used = {
        (result.walls[verdict.governing].part.asked.title, looked.row.why)
        for verdict in result.verdicts
        for looked in make_register(result, verdict)
        if looked.row.status == SET_ASIDE
    }
    for title, entry in aside:
        named = {"mechanism": localized("mechanism", entry.mechanism, words.language)}
        named["document"] = require_value(entry.evidence).words.text(words.language)
        low, high = (words.number(height, "g") for height in (entry.from_m or 0.0, entry.to_m))
        named["where"] = f"{low}–{high} m" if entry.to_m is not None else f"≥ {low} m"
        if (title, require_value(entry.evidence).words) in used:
            yield words.say("{wall}: {mechanism}, {where}, is set aside, {document}", wall=title, **named)
        else:
            yield words.say(
                "{wall}: {mechanism}, {where}, is looked at: setting it aside has no effect", wall=title, **named
            )


def closing_parts(result: StudyResult, words: Words, new_page: bool = True) -> list[Part]:
    """Assumptions, the program (NTC 2018 10.2), the engineer's judgement and signature. new_page : they begin one"""
    say = words.say
    walls, written = [wall.wall for wall in result.walls], result.case.report.judgement.strip()
    ticks = []
    for code in confirmation_codes(walls):
        ticked = code == "no_load" and all(wall.unloaded_confirmed for wall in walls)
        ticks.append(Item(localized("assumption", code, words.language), sign="☑" if ticked else "☐"))
    ticks += [Item(line, sign="☑") for line in (*set_aside_lines(result, words), *_declared(result, words))]
    shared = [(motion.name, warning.text(words.language)) for motion in result.motions for warning in motion.warnings]
    if result.demand:
        shared += [(say("demand"), warning.text(words.language)) for warning in result.demand_required.warnings]
    parts: list[Part] = []
    if shared:
        parts = [
            Heading(say("Warnings on demand and records")),
            *(Item(f"{name}: {line}", "quiet") for name, line in shared),
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
        (say("Input"), f"SHA-256 {result.case.sha256}"),
    ]
    return [
        *parts,
        Heading(say("Assumptions confirmed by the engineer"), new_page=new_page),
        *ticks,
        Blanks((say("Confirmed by"), say("Date"))),
        Heading(say("The program (NTC 2018 10.2)")),
        Table((), program, (1, 4)),
        Heading(say("Reasoned judgement on the results (NTC 2018 10.2)")),
        *([Paragraph(line) for line in written.splitlines() if line.strip()] if written else [Box(JUDGEMENT_LINES)]),
    ]
