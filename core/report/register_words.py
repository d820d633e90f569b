"""The register of the mechanisms of a wall in words, for note and window."""

from collections.abc import Callable

from core.answer.answer import zeta_range
from core.case.register import NOT_POSSIBLE
from core.known import require_value
from core.report.verdict_words import names_in
from core.study.register import Looked, make_register
from core.study.results import StudyResult, WallVerdict
from core.text.sentence import Sentence, format_number, localized, word
from core.variation.hold_check import Reaction

COLUMN_SHARES = (2.2, 2.2, 1.3, 0.7, 3.6)
"""Widths of the columns."""


def column_heads(say: Callable[..., str]) -> list[str]:
    """Heads of the columns of `describe_rows`."""
    return [say("Mechanism"), say("Where"), say("Direction"), "ζ_E", say("Outcome, or what is missing")]


def describe_rows(result: StudyResult, verdict: WallVerdict, say: Callable[..., str], language: str) -> list[list[str]]:
    """A row for each mechanism of a wall that is looked at, set aside or left out."""
    rows = (looked for looked in make_register(result, verdict) if looked.row.status != NOT_POSSIBLE)
    return [_cells(looked, say, language) for looked in rows]


def describe_briefly(
    result: StudyResult, verdict: WallVerdict, say: Callable[..., str], language: str
) -> list[list[str]]:
    """The rows of `describe_rows`, the hinges that do not decide in one for each mechanism, direction and outcome."""
    rows: list[list[str]] = []
    of_hinges: dict[tuple[str, str, str], list[Looked]] = {}
    for looked in make_register(result, verdict):
        row = looked.row
        if row.status == NOT_POSSIBLE:
            continue
        decides = looked.result is result.walls[verdict.governing]
        if decides or row.hinge is None or looked.result is None:
            rows.append(_cells(looked, say, language))
            continue
        cells = _cells(looked, say, language)
        of_hinges.setdefault((cells[0], cells[2], cells[4]), []).append(looked)
    for (name, direction, outcome), group in of_hinges.items():
        heights = ", ".join(f"+{format_number(looked.row.hinge, '.4g', language)}" for looked in group)
        ends = zeta_range(require_value(looked.result) for looked in group)
        least, most = (format_number(zeta, ".2f", language) for zeta in ends)
        shown = least if least == most else f"{least}–{most}"
        rows.append([name, say("hinges at {heights} m", heights=heights), direction, shown, outcome])
    return rows


def not_possible(result: StudyResult, verdict: WallVerdict, language: str) -> str:
    """The mechanisms a wall cannot have, each with its reason, in one sentence; "" of one that may have all."""
    rows = [looked.row for looked in make_register(result, verdict) if looked.row.status == NOT_POSSIBLE]
    each = dict.fromkeys(f"{_word(row.name, language)} ({_words(row.why, language)})" for row in rows)
    return f"{_word(NOT_POSSIBLE, language).capitalize()}: {'; '.join(each)}." if each else ""


REACTION_WORDS = {
    "top": "takes_top",
    "base": "takes_base",
    "foot": "takes_foot",
    "ends": "takes_ends",
    "stub": "takes_stub",
    "tie": "takes_tie",
    "behind": "takes_behind",
}
"""Hold of a reaction -> its word."""


def reactions_line(result: StudyResult, verdict: WallVerdict, say: Callable[..., str], language: str) -> str:
    """What the holds of a wall take at the demand, of each the most that any of its mechanisms hands to it beside what
    it stands; "" of a wall without."""
    rows: dict[str, Reaction] = {}
    for k in verdict.results:
        for row in result.walls[k].required_assessment.reactions:
            most = rows.setdefault(row.hold, row)
            if _strain(row) > _strain(most):
                rows[row.hold] = row

    def told(row: Reaction) -> str:
        asked = format_number(1e-3 * row.at_demand, ".1f", language)
        words = [_word(REACTION_WORDS[row.hold], language), asked]
        if row.stands is not None:
            words.append(say("of {stands}", stands=format_number(1e-3 * row.stands, ".1f", language)))
        if row.impulse:
            words.append(f"({format_number(row.impulse, '.0f', language)} N s/m)")
        return " ".join(words)

    each = ", ".join(map(told, rows.values()))
    return say("Taken at the demand [kN/m]: {each}.", each=each) if each else ""


def _strain(row: Reaction) -> tuple[float, float]:
    """How near a hold is to what it stands; of what is not compared how much it takes."""
    return (0.0 if row.stands is None else row.at_demand / max(row.stands, 1e-9)), row.at_demand


def describe_lines(result: StudyResult, verdict: WallVerdict, say: Callable[..., str], language: str) -> list[str]:
    """The register as lines: what is looked at, set aside and left out, and at last what is not possible."""
    rows = describe_rows(result, verdict, say, language)
    lines = [", ".join(filter(None, (*head, zeta and f"ζ {zeta}", outcome))) for *head, zeta, outcome in rows]
    last = reactions_line(result, verdict, say, language), not_possible(result, verdict, language)
    return [line for line in (*lines, *last) if line]


def _cells(looked: Looked, say: Callable[..., str], language: str) -> list[str]:
    row, where = looked.row, ""
    if row.hinge is not None:
        where = say("hinge at +{height} m", height=format_number(row.hinge, ".4g", language))
    elif row.high is not None:
        where = f"{format_number(row.low, '.4g', language)}–{format_number(row.high, '.4g', language)} m"
    direction = row.direction if row.direction.endswith("°") or not row.direction else _word(row.direction, language)
    if looked.result is None:
        outcome = f"{_word(row.status, language)}: {_words(row.why, language)}"
        return [_word(row.name, language), where, direction, "", outcome]
    verdict = looked.result.required_assessment.verdict
    zeta = format_number(verdict.zeta_e, ".2f", language)
    return [_word(row.name, language), where, direction, zeta, word(verdict.code, language)]


def _word(code: str, language: str) -> str:
    return localized("mechanism", code, language)


def _words(why: Sentence | str, language: str) -> str:
    return why.text(language, names_in(language)) if isinstance(why, Sentence) else why
