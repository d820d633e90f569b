"""Summary: one page of all that decides, and the overview of all walls."""

from copy import copy

from core.derivation.wall import deciding
from core.ground.ground_motion import GroundMotion
from core.report.assumption_table import heads, rows_of
from core.report.cells import (
    ACCELERATION,
    AMBER,
    BAD,
    GOOD,
    INK,
    QUIET,
    RATIO,
    Book,
    header,
    heighten,
    number,
    paragraph,
    rule,
    text,
    title,
)
from core.report.derived import cell_prefix
from core.report.note.content import works
from core.report.rows import changed_cell
from core.report.sheet_table import write_table
from core.report.stated.quantity import select_quantities, serialize
from core.report.stated.walls import WALL, WallResultSource
from core.report.tie_words import tie_lines
from core.report.uncertainty_text import risk_of
from core.report.verdict_words import lines_of, sentence_of, sort_results, tone_of
from core.report.wall_tables import checks_of_wall, rows_of_checks, rows_of_comparison
from core.report.words import Words
from core.study.results import StudyResult, WallResult
from core.text.sentence import word
from core.units import G

SUMMARY_WALLS = 8
"""Walls listed on the Summary, which is one page; all are on the Overview."""

COLUMN_WIDTHS = [30, 12, 8, 9, 9, 7, 8, 14, 9, 8, 9, 9, 26]
LAST_COLUMN = len(COLUMN_WIDTHS)
ASSUMED = 1, 2, 5, 6, 9, 10, 13
"""Columns of the table of assumptions."""

TONE_COLORS = {"": INK, "good": GOOD, "amber": AMBER, "bad": BAD}


def verdict_color(result: StudyResult, wall: WallResult) -> str:
    """Green only where nothing is left to read: a warning or a reason turns it amber."""
    return TONE_COLORS[tone_of(result, wall)]


def summary(book: Book, result: StudyResult) -> None:
    """Write one page: title block, demand, walls, the governing wall's checks, its verdict, warnings."""
    say, case = book.say, result.case
    sheet = book.sheet("Summary", COLUMN_WIDTHS, landscape=True)
    sheet.page_setup.fitToHeight = 1
    title(sheet, 1, case.title, 16)
    paragraph(
        sheet,
        2,
        say(
            "Out-of-plane overturning of masonry walls: rocking analysis, force reduction factor q "
            "(Coccia, Di Carlo, Imperatore 2016) and checks of the Circolare 7/2019, C8.7.1.2.1"
        ),
        LAST_COLUMN,
        160,
        color=QUIET,
    )
    row = 3
    for label, value in works(result, Words(book.language)):
        text(sheet, row, 1, label, color=QUIET)
        text(sheet, row, 2, value)
        row += 1
    changed_cell(book, sheet, row, 1)
    row += 1
    ordered = [wall for wall, decides in sort_results(result) if decides]
    row = _walls_table(book, sheet, result, ordered[:SUMMARY_WALLS], row + 1)
    if len(ordered) > SUMMARY_WALLS:
        row = paragraph(
            sheet,
            row,
            say(
                "The {SUMMARY_WALLS} lowest of {n} walls; all on the sheet Overview.",
                SUMMARY_WALLS=SUMMARY_WALLS,
                n=len(ordered),
            ),
            LAST_COLUMN,
            150,
            color=QUIET,
        )
    if ordered[0].assessment:
        row = _governing(book, sheet, result, ordered[0], row + 1)
    _warnings(book, sheet, result, row + 1, LAST_COLUMN)


QUANTITIES_SHOWN = select_quantities(
    WALL, "height_m", "thickness_m", "slenderness_deg", "threshold_acceleration_g", "q_set", "q_robust_set"
)
"""Quantities of the results that the table of the walls shows."""


def lists_all(result: StudyResult) -> bool:
    """Whether the Summary has every hinge and mechanism: of each wall it has the one that decides."""
    return len(result.walls) <= SUMMARY_WALLS and all(decides for _, decides in sort_results(result))


def overview(book: Book, result: StudyResult) -> None:
    """All walls, the lowest zeta first."""
    sheet = book.sheet("Overview", COLUMN_WIDTHS, landscape=True)
    title(sheet, 1, book.say("Overview of the walls"))
    last = _walls_table(book, sheet, result, [wall for wall, _ in sort_results(result)], 3)
    sheet.auto_filter.ref = f"A3:M{last - 1}"
    sheet.freeze_panes = "B4"
    sheet.print_title_rows = "3:3"


def _walls_table(book: Book, sheet, result: StudyResult, walls: list[WallResult], row: int) -> int:
    say = book.say
    header(
        sheet,
        row,
        [
            say("Wall"),
            say("Mechanism"),
            "H [m]",
            "t [m]",
            "u [m]",
            "H/t",
            "α [°]",
            "a_RM [g]",
            "W [kN]",
            "q",
            say("q robust"),
            "ζ",
            say("Verdict"),
        ],
    )
    for wall in book.steps.each(walls):
        row += 1
        text(sheet, row, 1, book.titled(wall.name), wrap=True)
        text(sheet, row, 2, word(wall.mechanism, book.language))
        verdict = wall.required_assessment.verdict if wall.assessment else None
        label = word(verdict.code, book.language) if verdict else "–"
        heighten(sheet, row, (book.titled(wall.name), 24), (label, 26))
        weight = wall.wall.weight
        setback = wall.wall.setback if wall.wall.height_m else None
        values = serialize(QUANTITIES_SHOWN, WallResultSource(wall, result))
        for column, value, shape in (
            (3, values["height_m"], RATIO),
            (4, values["thickness_m"], RATIO),
            (5, setback, ACCELERATION),
            (6, wall.height / wall.thickness, "0.0"),
            (7, values["slenderness_deg"], RATIO),
            (8, values["threshold_acceleration_g"], ACCELERATION),
            (9, weight / 1000.0 if weight else None, "0.0"),
            (10, values["q_set"], RATIO),
            (11, values["q_robust_set"], RATIO),
        ):
            number(sheet, row, column, value, shape)
        color = verdict_color(result, wall)
        number(sheet, row, 12, verdict.zeta_e if verdict else None, RATIO, bold=True, color=color)
        _link(book, sheet, result, wall, row)
        text(sheet, row, 13, label, bold=True, color=color, wrap=True)
        rule(sheet, row, 1, LAST_COLUMN)
    return row + 1


def _link(book: Book, sheet, result: StudyResult, wall: WallResult, row: int) -> None:
    """alpha, a_RM, q and zeta as those of the sheet Check, live."""
    name = cell_prefix(result, wall)
    names = book.workbook.defined_names
    links = {3: f"{name}height", 4: f"{name}thickness", 7: f"{name}slenderness", 8: f"{name}a_rm", 10: f"{name}q_set"}
    if links[3] in names and links[4] in names:
        size = f"{links[3]}*{links[4]}"
        links[6] = f"{links[3]}/{links[4]}"
        if wall.wall.weight:
            links[9] = f"{wall.wall.weight / 1000.0 / (wall.height * wall.thickness)!r}*{size}"
    if wall.assessment and wall.required_assessment.verdict.governing:
        links[12] = name + deciding(wall, result.demand)
    for column, target in links.items():
        cell = sheet.cell(row, column)
        if (target in names or column in (6, 9)) and isinstance(cell.value, float):
            look = copy(cell._style)
            book.formula(cell, f"={target}", cell.value, cell.number_format)
            cell._style = look


def _governing(book: Book, sheet, result: StudyResult, wall: WallResult, row: int) -> int:
    """The wall with the lowest zeta: table of methods, verdict."""
    label = f"{book.titled(wall.name)} – {word(wall.mechanism, book.language)}"
    title(sheet, row, label, 12)
    if risk := risk_of(result, wall):
        row = paragraph(sheet, row + 1, _risk_line(book, risk), LAST_COLUMN, 150, color=QUIET) - 1
    rows = [*rows_of_checks(wall, book.language), *rows_of_comparison(wall, book.language)]
    row = write_table(book, sheet, row + 1, checks_of_wall(book), rows)
    row = paragraph(
        sheet,
        row + 2,
        sentence_of(wall, book.language),
        LAST_COLUMN,
        120,
        bold=True,
        size=12,
        color=verdict_color(result, wall),
    )
    row = _assumed(book, sheet, result, wall, row)
    for line in (*lines_of(result, wall, book.language), *tie_lines(wall, book.language)):
        row = paragraph(sheet, row, f"• {line}", LAST_COLUMN, 150)
    return row


def _assumed(book: Book, sheet, result: StudyResult, wall: WallResult, row: int) -> int:
    """The table of assumptions of a wall, what turns the outcome in the colour of what fails."""
    rows = rows_of(result, wall, book.language)
    if not rows:
        return row
    for column, words in zip(ASSUMED, heads(book.say), strict=True):
        text(sheet, row, column, words, color=QUIET, bold=True, size=9)
    rule(sheet, row, 1, LAST_COLUMN)
    for cells, turns in rows:
        row += 1
        for column, words in zip(ASSUMED, cells, strict=True):
            text(sheet, row, column, words, color=BAD if turns and column in (9, 10) else INK, bold=turns, size=9)
        rule(sheet, row, 1, LAST_COLUMN)
    return row + 1


def _risk_line(book: Book, risk) -> str:
    """Write what the mechanism withstands, in one line."""
    parts = [f"PGA_C {book.digits(risk.pga / G, '.3f')} g"]
    if risk.years is not None:
        parts.append(f"T_R,C {risk.years} {book.say('years')}")
    if risk.index is not None:
        parts.append(f"IS-V {book.digits(risk.index, '.2f')} ({risk.letter})")
    return ", ".join(parts)


def _warnings(book: Book, sheet, result: StudyResult, row: int, last: int, most: int = 7) -> int:
    """Write each warning once, with the walls or records it belongs to."""
    owners: dict[str, list[str]] = {}
    # first what all the walls rest on: more than most are not shown
    for warning in result.demand_required.warnings if result.demand else ():
        owners.setdefault(warning.text(book.language), []).append(book.say("demand"))
    named: list[WallResult | GroundMotion] = [*result.walls, *result.motions]
    for owner in named:
        for warning in owner.warnings:
            name = owner.name
            if isinstance(owner, WallResult):
                name += f" ({word(owner.mechanism, book.language)})"
            owners.setdefault(warning.text(book.language), []).append(name)
    text(sheet, row, 1, book.say("Warnings"), bold=True)
    row += 1
    if not owners:
        text(sheet, row, 1, book.say("none"))
        row += 1
    for line, names in list(owners.items())[:most]:
        who = ", ".join(names[:4]) + (f" +{len(names) - 4}" if len(names) > 4 else "")
        row = paragraph(sheet, row, f"• {line}  [{who}]", last, 165)
    if len(owners) > most:
        row = paragraph(
            sheet, row, book.say("{n} more on the sheets Records and Check.", n=len(owners) - most), last, 140
        )
    return row
