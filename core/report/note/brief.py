"""The calculation note of a result, and its brief form: the outcome of all walls and the signature on the first page, a
wall on two pages with what decides about it, what the engineer confirms. All else is in the full one (content.py)."""

from collections import Counter
from collections.abc import Iterable, Sequence

from core.answer.answer import Answer, collect_actions
from core.codes.assumption import ALL_TOGETHER_KEY, Assumption, format_value
from core.codes.outcomes import FAILS, OUTCOMES
from core.report import assumption_table
from core.report.derived import cell_prefix
from core.report.note import plan_figure, site, wall_figures
from core.report.note.certainty import certainty_line
from core.report.note.content import (
    check_bars,
    closing_parts,
    demand_parts,
    full_note,
    head_parts,
    in_runs,
    register_parts,
    set_aside_lines,
    side_by_side,
    wall_parts,
)
from core.report.note.parts import Blanks, Heading, Item, Paragraph, Part, Table
from core.report.note.record_parts import record_parts
from core.report.note.wall_steps import Derivations
from core.report.register_words import not_possible
from core.report.verdict_words import names_in, say_in_note, sentence_of, tone_of
from core.report.words import Words
from core.study.results import StudyResult, WallResult, WallVerdict
from core.study.wall_verdict import collect_assumptions, hinge_location, sort_by_severity
from core.text.sentence import Sentence, apart, localized, sentence, word
from core.variation.limit_states import LIMIT_STATES

MAX_WALLS = 24
"""Walls, the worst first, that have pages of their own."""

FEW = 2
"""Walls up to which the documents that show an input stand on the first page, in their own words."""

MAX_COLUMNS = 12
"""Walls beside one another in the table of what their outcomes rest on."""

FIGURES = 3
"""Figures of a wall, in one row."""

ONLY_IN_FULL = ("supports", "top_force", "ties_at_sld", "stiff_building", "no_period", "arch_parts", "other_state")
"""Limits that change no outcome, or stand in the table of all walls; all others stand beside an outcome that passes."""

OF_CLAUSES = ("code_below_records", "ties_displacement")
"""Limits of the checks of the clauses, where histories decide."""

OF_WHAT_PASSES = ("weaker_fails", "code_below_records", "hinge_highest", "unasked_range")
"""Limits that say nothing more of a wall that fails."""


def note(result: StudyResult, language: str) -> list[Part]:
    """The note that an engineer signs, as long as [report] asks for; without a demand the full one."""
    if result.case.report.extent == "full" or not result.verdicts:
        return full_note(result, language)
    words, ordered = Words(language), sort_by_severity(result.verdicts, result.walls)
    shared, impossible = _shared_limits(result, ordered, words), _shared_impossible(result, ordered, words)
    parts, plan = _first_page(result, ordered, shared, words), plan_figure.plan(result, words, ranked=False)
    demand = [*demand_parts(result, words, plan), *record_parts(result, words, brief=True)]
    if impossible:
        rows = [(", ".join(names), line) for line, names in impossible.items()]
        demand += [Heading(words.say("Mechanisms that are not possible"), 3), Table((), rows, (1.3, 4))]
    parts += demand if plan else []  # a page of its own before the walls
    for verdict in ordered[:MAX_WALLS]:
        parts += _wall_pages(result, verdict, [*shared, *impossible], words)
    if len(ordered) > MAX_WALLS:
        parts.append(
            Paragraph(words.say("{n} more walls: on the first page alone.", n=len(ordered) - MAX_WALLS), "quiet")
        )
    parts += [] if plan else demand
    return [*parts, *closing_parts(result, words, new_page=bool(plan))]


def _first_page(result: StudyResult, ordered: Sequence[WallVerdict], shared: Sequence[str], words: Words) -> list[Part]:
    """All walls, what is to be done and what the outcomes rest on, the signature. shared : limits of every wall"""
    say = words.say
    codes = Counter(_governing(result, verdict).required_assessment.verdict.code for verdict in ordered)
    counted = ", ".join(f"{words.word(code).lower()}: {codes[code]}" for code in OUTCOMES if code in codes)
    worst = tone_of(result, _governing(result, ordered[0]))
    parts: list[Part] = [
        *head_parts(result, words),
        Paragraph(say("Walls: {n}; {counted}.", n=len(ordered), counted=counted), worst),
        _walls_table(result, ordered, words),
        *_to_do(result, ordered, words),
        *_rests_on(result, ordered, words),
        *site.compare_variants_table(result, words),
    ]
    parts += [Item(line, "quiet") for line in shared]
    parts += [Item(line, sign="☑") for line in set_aside_lines(result, words)]
    key = words.word("key_extent")
    parts.append(Paragraph(say("Every hinge and check is in the full note ({key}: full).", key=key), "quiet"))
    return [*parts, Blanks((say("Engineer"), say("Place and date"), say("Signature and stamp")))]


def _governing(result: StudyResult, verdict: WallVerdict) -> WallResult:
    return result.walls[verdict.governing]


def _walls_table(result: StudyResult, ordered: Sequence[WallVerdict], words: Words) -> Table:
    """A row a wall, the worst first."""
    say, number = words.say, words.number
    states = [
        state
        for state in LIMIT_STATES
        if any(verdict.states[state].check for verdict in ordered if state in verdict.states)
    ]
    states = [state for state in states if state != result.demand_required.limit_state]
    heads = [say("Wall, H × t [m]"), say("Mechanism and hinge that decide"), "ζ_E", say("least"), say("by")]
    heads += [*states, say("Verdict")]
    rows, tones, places = [], {}, plan_figure.plan_numbers(result)
    for n, verdict in enumerate(ordered):
        wall = _governing(result, verdict)
        found, checks = wall.required_assessment.verdict, wall.required_assessment.checks
        by = next((words.short(check) for check in checks if check.name == found.governing), "–")
        where = hinge_location(wall)
        place = where.text(words.language) if isinstance(where, Sentence) else where
        size = f"{number(wall.part.asked.height_m or wall.height, '.2f')} × {number(wall.thickness, '.2f')}"
        number_there = f"{places[verdict.governing]} " if verdict.governing in places else ""
        row = [f"{number_there}{verdict.title}, {size}", f"{words.word(wall.mechanism)}{place}"]
        row += [number(found.zeta_e, ".2f"), number(verdict.zeta_least, ".2f"), by + _histories_beside(wall, words)]
        row += [number(verdict.states[state].zeta if state in verdict.states else None, ".2f") for state in states]
        rows.append([*row, words.word(found.code)])
        tones[n, 2] = tones[n, len(row)] = tone_of(result, wall)
    numbers = [verdict.governing for verdict in ordered]
    widths = (3.0, 3.3, 0.7, 0.9, 1.6, *[0.7] * len(states), 2.0)
    return Table(heads, rows, widths, tones, numbers)


def _histories_beside(wall: WallResult, words: Words) -> str:
    """What the time histories say beside the check that decides, of which they are no part."""
    beside = wall.required_assessment.beside
    if beside is None:
        return ""
    histories = sentence("short", "dynamic").text(words.language)
    return f"; {histories} ζ {words.number(beside.zeta, '.2f')}"


def _to_do(result: StudyResult, ordered: Iterable[WallVerdict], words: Words) -> list[Part]:
    """What the designer does next: each sentence once, with the walls it is of."""
    rows = [
        (
            ", ".join(verdict.title for verdict in walls),
            say_in_note(action).text(words.language, names_in(words.language)),
        )
        for action, walls in collect_actions(result, ordered).items()
    ]
    if not rows:
        return []
    return [Heading(words.say("What is to be done"), 3), Table((), rows, (1.3, 4))]


def _rests_on(result: StudyResult, ordered: Iterable[WallVerdict], words: Words) -> list[Part]:
    """What the outcomes that pass rest on: zeta at the other end of each input that turns one, inputs by walls."""
    of_walls: list[tuple[str, dict[str, Assumption]]] = []
    for verdict in ordered:
        rows = [row for row in collect_assumptions(result, verdict) if row.turns and row.key != ALL_TOGETHER_KEY]
        if rows:
            of_walls.append((verdict.title, {row.key: row for row in rows}))
    of_walls = of_walls[:MAX_COLUMNS]
    keys = dict.fromkeys(key for _, rows in of_walls for key in rows)
    if not keys:
        return []
    table, tones, target = [], {}, result.demand_required.zeta_target
    for n, key in enumerate(keys):
        cells = []
        for k, (_, rows) in enumerate(of_walls, start=1):
            row = rows.get(key)
            cells.append("" if row is None else _other_end(row, words, target, with_documents=len(of_walls) <= FEW))
            if row is not None and row.open:
                tones[n, k] = "bad"
        table.append([words.word(f"key_{key}"), *cells])
    heads = [words.say("ζ at the other end"), *(name for name, _ in of_walls)]
    return [
        Heading(words.say("What the outcomes rest on"), 3),
        Table(heads, table, (2.4, *[1.0] * len(of_walls)), tones),
        Paragraph(words.say("✓: shown by a document, or permitted by a clause; the others are to be shown."), "quiet"),
    ]


def _other_end(row: Assumption, words: Words, target: float, with_documents: bool) -> str:
    """zeta at the other end of an input, with a mark where it is shown or permitted, or with what shows it."""
    zeta, reason = _zeta_there(row, words, target), format_value(row, row.reason, words.language)
    if row.open:
        return zeta
    return f"{zeta} ✓ {reason}" if with_documents and reason else f"{zeta} ✓"


def _shared_limits(result: StudyResult, ordered: Sequence[WallVerdict], words: Words) -> list[str]:
    """Limits that every wall of a case has, of several: they stand once."""
    if len(ordered) < 2:
        return []
    each = [_limits(result, _governing(result, verdict), words) for verdict in ordered]
    return [line for line in each[0] if all(line in others for others in each[1:])]


def _shared_impossible(result: StudyResult, ordered: Sequence[WallVerdict], words: Words) -> dict[str, list[str]]:
    """Why mechanisms are not possible, where the line is of several walls -> these walls."""
    names: dict[str, list[str]] = {}
    for verdict in ordered[:MAX_WALLS]:
        if line := not_possible(result, verdict, words.language):
            names.setdefault(line, []).append(verdict.title)
    return {line: walls for line, walls in names.items() if len(walls) > 1}


def _limits(result: StudyResult, wall: WallResult, words: Words) -> list[str]:
    """What keeps an outcome from being more, what it is to be read with, and the line of what no clause asks about."""
    assessment = wall.required_assessment
    verdict, tabled = assessment.verdict, assumption_table.tabled(wall, words.language)
    extra = [limit for each in result.verdicts if _governing(result, each) is wall for limit in each.extra]
    passed_over = (*ONLY_IN_FULL, *(OF_WHAT_PASSES if OUTCOMES[verdict.code].judgement == FAILS else ()))
    passed_over += OF_CLAUSES if verdict.governing == "dynamic" else ()
    chosen = [limit for limit in (*verdict.limits, *extra) if limit.code not in passed_over]
    lines = [
        f"{word('limits', words.language)}: {limit.text(words.language, names_in(words.language))}" for limit in chosen
    ]
    return [line for line in dict.fromkeys(lines) if line not in tabled]


def _wall_pages(result: StudyResult, verdict: WallVerdict, shared: Sequence[str], words: Words) -> list[Part]:
    """A wall by the hinge and mechanism that decide about it. shared : lines of several walls, which stand once"""
    wall, say = _governing(result, verdict), words.say
    assessment, language = wall.required_assessment, words.language
    if assessment.kinematic is None:
        return wall_parts(result, wall, cell_prefix(result, wall), words)
    found = assessment.verdict
    outcome = f"{words.word(found.code)}, ζ {words.number(found.zeta_e, '.2f')}"
    if least := Answer(result, verdict).lower_elsewhere:
        whose = f"{localized('mechanism', least.mechanism, language)}, +{words.number(least.hinge, '.4g')} m"
        outcome += f", {say('least')} {words.number(least.zeta, '.2f')} ({whose})"
    parts: list[Part] = [
        Heading(f"{verdict.title} – {outcome}", 2, True, verdict.governing),
        Paragraph(sentence_of(wall, language), tone_of(result, wall)),
    ]
    own = [line for line in _limits(result, wall, words) if line not in shared]
    parts += [Item(line, "quiet") for line in (*own, *certainty_line(result, wall, words))]
    parts += [check_bars(result, wall, words), *register_parts(result, wall, words, brief=True, shared=shared)]
    parts += _turning_rows(result, verdict, words)
    parts += [*site.solids(wall, words, grouped=True), *site.loads(wall, words)]
    drawn = [wall_figures.drawing(wall, words), wall_figures.elevation(wall, words)]
    drawn += [wall_figures.capacity(result, wall, words) if found.governing == "nonlinear" else None]
    drawn += [wall_figures.peaks(wall, words, named=False), wall_figures.histories(result, wall, words)]
    parts += side_by_side([figure for figure in drawn if figure is not None][:FIGURES])
    for title, steps in Derivations(result, words, cell_prefix(result, wall)).deciding(wall):
        if steps:
            parts += [Heading(say(title), 3), *in_runs(steps)]
    return parts


def _zeta_there(row: Assumption, words: Words, target: float) -> str:
    """zeta at the other end of an input, not rounded onto what is required; the outcome there where it has none."""
    if row.zeta is None:
        return words.word(row.outcome).lower()
    shown = apart(row.zeta, target)
    return words.number(shown.value, shown.form)


def _turning_rows(result: StudyResult, verdict: WallVerdict, words: Words) -> list[Part]:
    """The inputs whose other ends turn the outcome of a wall."""
    rows = [row for row in collect_assumptions(result, verdict) if row.turns]
    language = words.language
    table = [
        [
            words.word("together" if row.key == ALL_TOGETHER_KEY else f"key_{row.key}"),
            format_value(row, row.value, language),
            format_value(row, row.other_end, language),
            _zeta_there(row, words, result.demand_required.zeta_target),
            format_value(row, row.reason, language) or ("–" if row.open else words.say("permitted")),
        ]
        for row in rows
    ]
    heads = [words.say(text) for text in ("Assumption", "Taken", "Other end", "ζ there", "Shown by")]
    return [Table(heads, table, (2.2, 2.0, 2.0, 0.9, 2.6))] if table else []
