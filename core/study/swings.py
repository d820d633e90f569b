"""The result of moving each input of a wall: what zeta becomes."""

import math
from dataclasses import dataclass

from core.text.sentence import Number, Sentence, sentence

SHOWN = {
    "thickness_factor": (100.0, ".3g"),
    "unit_weight_factor": (1.0, ".3g"),
    "load_factor": (100.0, ".0f"),
    "setback_shares": (100.0, ".2g"),
    "velocity_ratio_factor": (1.0, ".2f"),
    "modulus_factor": (1.0, ".4g"),
    "building_period_factor": (1.0, ".2f"),
    "building_damping_factor": (100.0, ".3g"),
    "ag_factor": (1.0, ".3f"),
}
"""Key of the ranges -> what a value is multiplied with for the unit of its words, and its format."""


@dataclass(frozen=True)
class End:
    """An input moved to one end of its range.

    value : of the input there, in the unit of its key, a factor of loads; None of what is lost or left out
    name : of the record that is left out
    zeta : of the wall, None where the wall then has none, or does not stand
    sure : surely satisfied, its spread included
    """

    value: float | None
    zeta: float | None
    sure: bool
    name: str = ""


@dataclass(frozen=True)
class Swing:
    """An input that is moved. key : of the ranges; given : its value, None of what has none; ends : one or two"""

    key: str
    given: float | None
    ends: tuple[End, ...]

    @property
    def lowest(self) -> End:
        return min(self.ends, key=_worth)

    @property
    def width(self) -> float:
        """From the lowest zeta to the highest; without a number as wide as any."""
        found = [end.zeta for end in self.ends]
        return math.inf if None in found else max(found) - min(found)


@dataclass(frozen=True)
class Sensitivity:
    """Of a wall with all its hinges.

    base : zeta of the wall as it is, on the coarser grid the ends are searched on
    swings : of what moves zeta, the widest first
    still : keys of what was moved and does not
    turning : keys of the swings an end of which turns a satisfied verdict
    """

    base: float | None
    swings: tuple[Swing, ...]
    still: tuple[str, ...]
    turning: tuple[str, ...]


def _worth(end: End) -> float:
    return -math.inf if end.zeta is None else end.zeta


def move_words(swing: Swing, end: End) -> Sentence:
    """An end of a swing in words: 79 cm instead of 83."""
    factor, form = SHOWN.get(swing.key, (1.0, "g"))
    given, value = (None if one is None else factor * one for one in (swing.given, end.value))
    return sentence("added", f"moved_{swing.key}", given=Number(given, form), value=Number(value, form), name=end.name)
