"""The result of moving each input of a wall: what zeta becomes."""

import math
from dataclasses import dataclass

from core.errors import InputError
from core.text.sentence import Number, Sentence, sentence

SWING_FORMATS = {
    "thickness_factor": ("moved_thickness", 100.0, ".3g"),
    "unit_weight_factor": ("moved_unit_weight", 1.0, ".3g"),
    "load_factor": ("moved_loads", 100.0, ".0f"),
    "setback_m": ("moved_setback", 100.0, ".2g"),
    "out_of_plumb_m": ("moved_plumb", 100.0, ".2g"),
    "velocity_ratio_factor": ("moved_velocity_ratio", 1.0, ".2f"),
    "modulus_factor": ("moved_modulus", 1.0, ".4g"),
    "building_period_factor": ("moved_building_period", 1.0, ".2f"),
    "building_damping_factor": ("moved_building_damping", 100.0, ".3g"),
    "ag_factor": ("moved_ag", 1.0, ".3f"),
    "restraint_lost": ("moved_restraint", 1.0, "g"),
    "record_left_out": ("moved_record", 1.0, "g"),
}
"""Key of the ranges -> code of its words, what a value is multiplied with for their unit, its format."""


@dataclass(frozen=True)
class SwingEnd:
    """An input moved to one end of its range.

    value : of the input there, in the unit of its key, a factor of loads; None of what is lost or left out
    name : of the record that is left out
    zeta : of the wall, None where it then falls without an earthquake
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
    ends: tuple[SwingEnd, ...]

    @property
    def lowest(self) -> SwingEnd:
        return min(self.ends, key=_worth)

    @property
    def turning(self) -> SwingEnd:
        """The end that is not surely satisfied, the lower one of two."""
        return min((end for end in self.ends if not end.sure), key=_worth, default=self.lowest)

    def width(self, base: float | None) -> float:
        """Width of the swing, from the lowest zeta to the highest, zeta as it is among them; without a number as wide
        as any."""
        zetas = [base, *(end.zeta for end in self.ends)]
        known = [zeta for zeta in zetas if zeta is not None]
        return max(known) - min(known) if len(known) == len(zetas) else math.inf


@dataclass(frozen=True)
class TargetValue:
    """Inverse design for one input: its value at which each check reaches what is required.

    key : thickness_m, tie_kn_m or ag_g; given : its value now
    by_check : label -> the value at which zeta of the check reaches what is required, None where none does
    throughout : labels of the checks that are satisfied at every value that is searched and accepted
    """

    key: str
    given: float
    by_check: dict[str, float | None]
    throughout: tuple[str, ...] = ()


@dataclass(frozen=True)
class Sensitivity:
    """Sensitivity of zeta of a wall, over all its hinges.

    base : zeta_E of the wall as it is, None where it has none: nothing is moved
    swings : of what moves zeta, the widest first
    still : keys of what was moved and does not
    turning : keys of the swings an end of which turns a satisfied verdict
    reach : the answer turned round
    refused : (key, why) of what cannot be moved so
    """

    base: float | None
    swings: tuple[Swing, ...]
    still: tuple[str, ...]
    turning: tuple[str, ...]
    reach: tuple[TargetValue, ...] = ()
    refused: tuple[tuple[str, InputError], ...] = ()


def _worth(end: SwingEnd) -> float:
    return -math.inf if end.zeta is None else end.zeta


def describe_swing_end(swing: Swing, end: SwingEnd) -> Sentence:
    """An end of a swing in words: 79 cm instead of 83."""
    code, factor, form = SWING_FORMATS[swing.key]
    given, value = (None if one is None else factor * one for one in (swing.given, end.value))
    return sentence("added", code, given=Number(given, form), value=Number(value, form), name=end.name)
