"""The sheet Risk: every wall with what it withstands, the lowest first; limit states, variants."""

from core.answer.answer import smallest_zetas
from core.known import require_value
from core.report.cells import ACCELERATION, QUIET, RATIO, Book, header, heighten, number, paragraph, rule, text, title
from core.report.sheet_table import write_table
from core.report.verdict_words import sort_results
from core.report.wall_tables import variants_of_walls
from core.study.results import StudyResult, WallResult
from core.study.variants import compare_walls
from core.text.sentence import word
from core.units import G
from core.variation.limit_states import LIMIT_STATES

LAST_COLUMN = 11


def has_risk(result: StudyResult) -> bool:
    """Whether a wall has a zeta, and something beside it that the Summary does not show."""
    assessments = [wall.assessment for wall in result.walls if wall.assessment]
    beside = any(assessment.states for assessment in assessments) or bool(compare_walls(result.verdicts))
    return beside and any(assessment.risk for assessment in assessments)


def risk(book: Book, result: StudyResult) -> None:
    """The tables, one below the other."""
    say = book.say
    sheet = book.sheet("Risk", [26, 12, 9, 9, 30, 10, 10, 10, 10, 10, 10], landscape=True)
    title(sheet, 1, say("What each mechanism withstands"))
    row = paragraph(
        sheet,
        2,
        say(
            "PGA_C = ζ S a_g; the shape of the spectrum is taken as fixed. IS-V is of this mechanism: the class of the "
            "building asks for a global analysis (D.M. 65/2017, Annex A). Limit states by the hazard of the site and "
            "the kinematic check, or by time histories where they are asked for."
        ),
        LAST_COLUMN,
        150,
        color=QUIET,
    )
    row = _walls(book, sheet, result, row + 1)
    row = _variants(book, sheet, result, row + 1)
    sheet.freeze_panes = "B4"


def _walls(book: Book, sheet, result: StudyResult, row: int) -> int:
    say = book.say
    header(
        sheet,
        row,
        [
            say("Wall"),
            say("Mechanism"),
            "ζ_E",
            "ζ_16",
            say("by"),
            "PGA_C [g]",
            "T_R,C",
            "IS-V",
            *(f"ζ {state}" for state in LIMIT_STATES),
        ],
        1,
        30,
    )
    for wall, _ in book.steps.each(sort_results(result)):
        row += 1
        _wall(book, sheet, wall, row)
    row += 1
    text(sheet, row, 1, say("smallest"), bold=True)
    smallest = smallest_zetas(result)
    number(sheet, row, 3, smallest[""], RATIO)
    for column, state in enumerate(LIMIT_STATES, start=9):
        if state in smallest:
            number(sheet, row, column, smallest[state], RATIO)
    rule(sheet, row, 1, LAST_COLUMN)
    return row + 1


def _wall(book: Book, sheet, wall: WallResult, row: int) -> None:
    assessment, language = wall.assessment, book.language
    text(sheet, row, 1, book.titled(wall.name), wrap=True)
    text(sheet, row, 2, word(wall.mechanism, language))
    heighten(sheet, row, (book.titled(wall.name), 26))
    rule(sheet, row, 1, LAST_COLUMN)
    if assessment is None:
        return
    verdict = assessment.verdict
    number(sheet, row, 3, verdict.zeta_e, RATIO)
    if verdict.governing == "dynamic":
        number(sheet, row, 4, require_value(assessment.dynamic).zeta_16, RATIO)
    label = next((c.label for c in assessment.checks if c.name == verdict.governing), None)
    text(sheet, row, 5, word(label, language) if label else "–", wrap=True)
    if assessment.risk:
        number(sheet, row, 6, assessment.risk.pga / G, ACCELERATION)
        text(sheet, row, 7, assessment.risk.years or "–", align="right")
        letter = assessment.risk.letter
        text(sheet, row, 8, f"{book.digits(assessment.risk.index, '.2f')}  {letter}" if letter else "–", align="right")
    zetas = {one.state: one.zeta for one in assessment.states}
    for column, state in enumerate(LIMIT_STATES, start=9):
        number(sheet, row, column, zetas.get(state), RATIO)


def _variants(book: Book, sheet, result: StudyResult, row: int) -> int:
    """The walls as they are beside the walls as they are designed."""
    pairs = compare_walls(result.verdicts)
    if not pairs:
        return row
    title(sheet, row, book.say("Before and after"), 12)
    return write_table(book, sheet, row + 1, variants_of_walls(book, result), pairs, 30) + 1
