"""The outcomes of a hinge, a wall, a limit state, a variant: one table, one order."""

from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

FAILS, OPEN, PASSES = "fails", "open", "passes"
"""What an outcome allows: a wall that fails, one of which nothing may be said yet, one that may be called satisfied."""


class Outcome(NamedTuple):
    """A row of the table.

    code : of its words: its sentence in the group "verdict", its name and client_<code> in "word"
    tone : its colour, good, amber or bad
    judgement : FAILS, OPEN or PASSES: what the check that decides says
    """

    code: str
    tone: str
    judgement: str


OUTCOMES = {
    row.code: row
    for row in (
        Outcome("not_verified", "bad", FAILS),
        Outcome("q2_unsafe", "bad", FAILS),
        Outcome("at_limit", "bad", FAILS),
        Outcome("undetermined", "amber", OPEN),
        Outcome("indicative", "amber", PASSES),
        Outcome("verified_refined", "amber", PASSES),
        Outcome("verified", "good", PASSES),
        Outcome("not_activated", "good", PASSES),
    )
}
"""The outcomes, worst first."""

NO_HAZARD = "no_hazard"
"""Code of a limit state that is not asked for: it stands outside the order."""

_RANK = {code: rank for rank, code in enumerate(OUTCOMES)}


def severity_key(code: str, zeta: float | None, target: float) -> tuple[int, bool, float]:
    """Key that sorts outcomes, worst first: by the table, among equal ones a missing zeta first, then the lowest zeta
    over the one required."""
    return _RANK[code], zeta is not None, 0.0 if zeta is None else zeta / target


def worst_outcome(rows: Iterable[Any], of: Callable[[Any], tuple[str, float | None, float]]) -> Any:
    """The row with the worst outcome. of : its code, zeta and the zeta required"""
    return min(rows, key=lambda row: severity_key(*of(row)))


def way_key(rows: Iterable[tuple[str, float | None, float]]) -> tuple[int, int, float]:
    """Key that sorts ways in which a wall may be held, worst first: by what the worst of its mechanisms allows, among
    ways that fail by the lowest zeta, else by the table and zeta. rows : code, zeta and the zeta required of each"""
    every = list(rows)
    code, zeta, target = min(every, key=lambda row: severity_key(*row))
    judgement = OUTCOMES[code].judgement
    if judgement == FAILS:
        return 0, 0, min((low / need for _, low, need in every if low is not None), default=0.0)
    return (FAILS, OPEN, PASSES).index(judgement), _RANK[code], (zeta or 0.0) / target


def min_if_all_known(values: Iterable[float | None]) -> float | None:
    """The lowest of several numbers that all count; None where one of them is not known, or there is none."""
    known = list(values)
    return None if not known or None in known else min(value for value in known if value is not None)
