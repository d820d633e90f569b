"""The table of assumptions of a wall as note, workbook and window show it."""

from collections.abc import Callable

from core.codes.assumption import ALL_TOGETHER_KEY, Assumption, format_value
from core.report.verdict_words import names_in
from core.study.results import StudyResult, WallResult
from core.study.wall_verdict import collect_assumptions
from core.text.sentence import Number, format_number, sentence, word

COLUMN_SHARES = 2.4, 2.0, 1.3, 2.0, 0.9, 1.9, 2.2
"""Relative widths of the columns."""


def heads(say: Callable[[str], str]) -> list[str]:
    """Heads of the columns."""
    return [
        say("Assumption"),
        say("Taken"),
        say("Source"),
        say("Other end"),
        say("ζ there"),
        say("Outcome there"),
        say("Reason"),
    ]


def rows_of(result: StudyResult, wall: WallResult, language: str) -> list[tuple[list[str], bool]]:
    """(cells of a row, whether its other end turns the outcome) of the wall that a result decides about; none of a
    result that does not."""
    verdict = next((one for one in result.verdicts if result.walls[one.governing] is wall), None)
    rows = []
    for row in collect_assumptions(result, verdict) if verdict else ():
        last = row.key == ALL_TOGETHER_KEY
        cells = [
            word("together" if last else f"key_{row.key}", language),
            format_value(row, row.value, language),
            "" if last else word(f"source_{row.source}", language),
            format_value(row, row.other_end, language),
            format_number(row.zeta, ".2f", language)
            + (f" ({_check_name(result, row, language)})" if row.check else ""),
            word(row.outcome, language),
            format_value(row, row.reason, language),
        ]
        rows.append((cells, row.turns))
    return rows


def _check_name(result: StudyResult, row: Assumption, language: str) -> str:
    """Name of the check whose zeta a row gives."""
    return sentence("short", row.check, q=Number(result.demand_required.q_code, "g")).text(language)


def tabled(wall: WallResult, language: str) -> set[str]:
    """Lines of what limits the verdict of a result that are rows of the table of its wall."""
    rows = wall.required_assessment.verdict.assumptions if wall.assessment else ()
    return {f"{word('limits', language)}: {row.words.text(language, names_in(language))}" for row in rows}
