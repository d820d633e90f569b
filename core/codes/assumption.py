"""What a verdict takes to be true and nobody measured: the rows of one table."""

from collections.abc import Iterable
from dataclasses import dataclass

from core.codes.outcomes import severity_key
from core.text.sentence import Sentence, format_number

GIVEN, DEFAULT, LEFT_OUT, DECLARED = "given", "default", "left_out", "declared"
"""Where a value comes from: typed, of the program where a clause permits it, of the program for want of one, said by
the engineer of what no program can see."""

RESTRAINT = "hold"
"""Key of what stands behind a wall or holds its top; its reason is what shows it."""

ARCH = "evidence"
"""Key of what the ends of a wall between its transverse walls push against."""

ALL_TOGETHER_KEY = "together"
"""Key of the last row: all others at their other ends."""


def value_format(value: float) -> str:
    """How a value of any size is written: three significant digits, whole from 1000 on, never with an exponent."""
    return ".0f" if abs(value) >= 999.5 else ".3g"


DisplayValue = float | str | Sentence
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
    reason : of the engineer, his own words or those of what shows it; "" without one
    turns_q : the other end turns the check with q of the code alone
    permitted : by a clause, without a reason: the outcome stands, and its sentence says what would turn it
    raises : zeta is lower at the other end
    check : name of the check whose zeta this is; "" of the one that decides
    asks : the table its document stands in, and the kinds that show it; "" where none is asked for
    """

    key: str
    words: Sentence
    value: DisplayValue
    other_end: DisplayValue
    source: str = GIVEN
    zeta: float | None = None
    outcome: str = "undetermined"
    turns: bool = False
    reason: str | Sentence = ""
    turns_q: bool = False
    permitted: bool = False
    raises: bool = True
    check: str = ""
    asks: Sentence | str = ""

    @property
    def has_switch(self) -> bool:
        """Whether the wall can be tried at the other end of this input alone, the restraint as it is."""
        return self.key not in (ALL_TOGETHER_KEY, RESTRAINT, ARCH)

    @property
    def open(self) -> bool:
        """Whether a reason is asked for, and missing."""
        return not (self.permitted or self.reason or self.key == ALL_TOGETHER_KEY)


def sort_assumptions(rows: Iterable[Assumption]) -> tuple[Assumption, ...]:
    """The rows that turn something, in the order of the table: those that turn the outcome first, then the worse
    outcome, at last all together; of a key that stands twice the first."""

    def place(row: Assumption) -> tuple:
        return row.key == ALL_TOGETHER_KEY, not row.turns, severity_key(row.outcome, row.zeta, 1.0)

    ordered = sorted((row for row in rows if row.turns or row.turns_q), key=place)
    return tuple({row.key: row for row in reversed(ordered)}.values())[::-1]


VALUE_UNITS = {
    "hinge_setback_m": (100.0, " cm"),
    "base_z_m": (1.0, " m"),
    "contact": (1.0, " m"),
    "compressive_strength_mpa": (1.0, " MPa"),
    "elastic_modulus_mpa": (1.0, " MPa"),
    "unit_weight_kn_m3": (1.0, " kN/m3"),
    "period_s": (1.0, " s"),
    "tc_star_s": (1.0, " s"),
    "ag_g": (1.0, " g"),
}
"""Key of a row -> what its numbers are multiplied with, and their unit."""


def format_value(row: Assumption, value: DisplayValue, language: str) -> str:
    """Value of a row in the words of a language, a number with three digits and its unit."""
    if isinstance(value, Sentence):
        return value.text(language)
    if isinstance(value, str):
        return value
    factor, unit = VALUE_UNITS.get(row.key, (1.0, ""))
    return format_number(factor * value, value_format(factor * value), language) + unit
