"""What a verdict takes to be true and nobody measured: the rows of one table."""

from collections.abc import Iterable
from dataclasses import dataclass

from core.codes.outcomes import severity
from core.text.sentence import Number, Sentence, numeral

GIVEN, DEFAULT, LEFT_OUT, DECLARED = "given", "default", "left_out", "declared"
"""Where a value comes from: typed, of the program where a clause permits it, of the program for want of one, said by
the engineer of what no program can see."""

RESTRAINT = "back_restraint"
"""Key of what stands behind a wall or holds its top; its reason is what shows it."""

TOGETHER = "together"
"""Key of the last row: all others at their other ends."""

Shown = float | str | Sentence
"""A value as the table shows it: a number, a name of the case, or words."""


@dataclass(frozen=True)
class Assumption:
    """A value that raises zeta, with the wall at the other end of its range.

    key : of the case, and of [wall.justification] or [demand.justification]
    words : Sentence of the group "reason" that says it whole
    value, other_end : as the table shows them
    source : GIVEN, DEFAULT, LEFT_OUT or DECLARED
    zeta, outcome : at the other end; zeta is None where it has none
    turns : the other end turns what is satisfied into what is not, alone or with others that have no reason
    reason : of the engineer, "" without one
    turns_q : the other end turns the check with q of the code alone
    permitted : by a clause, without a reason: the outcome stands, and its sentence says what would turn it
    """

    key: str
    words: Sentence
    value: Shown
    other_end: Shown
    source: str = GIVEN
    zeta: float | None = None
    outcome: str = "undetermined"
    turns: bool = False
    reason: str = ""
    turns_q: bool = False
    permitted: bool = False

    @property
    def other_end_shown(self) -> Shown | Number:
        """The value at the other end for a sentence, a number with three digits."""
        return Number(self.other_end, ".3g") if isinstance(self.other_end, float) else self.other_end

    @property
    def open(self) -> bool:
        """Whether a reason is asked for, and missing."""
        return not (self.permitted or self.reason or self.key == TOGETHER)


def table(rows: Iterable[Assumption]) -> tuple[Assumption, ...]:
    """The rows in the order of the table: those that turn the outcome first, then the worse outcome, at last all
    together; of a key that stands twice the first."""
    ordered = sorted(rows, key=lambda row: (row.key == TOGETHER, not row.turns, severity(row.outcome, row.zeta, 1.0)))
    return tuple({row.key: row for row in reversed(ordered)}.values())[::-1]


def shown(value: Shown, language: str) -> str:
    """A value of a row in words of a language, a number with three digits."""
    if isinstance(value, Sentence):
        return value.text(language)
    return value if isinstance(value, str) else numeral(value, ".3g", language)
