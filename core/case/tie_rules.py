"""What is wrong with the ties of a wall: not complete, contradicting themselves, or no bar that there can be."""

from core.case.hold import LEAST_BELOW_SOUGHT, Bars, Hold
from core.case.wall import Wall
from core.errors import InputError
from core.known import require_value
from core.text.sentence import Key
from core.wall.ties import elongation_at_yield

OF_A_TIE = ("bar_length_m", "fy_mpa", "slack_mm", "prestress", "bar", "design")
"""Keys of a hold that only a tie has."""

OF_AN_OLD_TIE = ("bar_length_m", "fy_mpa", "elongation_m", "slack_mm", "prestress", "bar")
"""Keys of a tie that was among the loads."""

NOT_SOUGHT = ("out_kn_m", "fy_mpa", "slack_mm", "prestress", "bar")
"""Keys of what a tie is, which one that is sought has not."""

MAX_STRAIN = 0.30
"""Largest elongation of a bar before it breaks, of its length."""

MAX_THREAD = 1.5
"""Largest thread at the ends of a bar, of its diameter: upset ends."""


def check_tie(wall: Wall, hold: Hold, here) -> None:
    """Raise InputError for a tie that is not complete, contradicts itself, or is no bar. here : its place"""
    if not hold.is_bar:
        if given := [key for key in OF_A_TIE if getattr(hold, key)]:
            raise InputError("hold_key", place=here, key=given[0], kind=hold.kind)
        return
    if not wall.moment_law().is_rigid:
        raise InputError("tie_needs_rigid_law", place=here[:1], key="law")
    if hold.design:
        _check_sought(wall, hold, here)
    else:
        _check_bar(wall, hold, here)
    if hold.elongation_m is not None:
        length = require_value(hold.bar_length_m)
        least = elongation_at_yield(length) if hold.design else hold.tie(wall.length_m).bar.elongation_at_yield
        _check_elongation(hold.elongation_m, least, length, here)


def _check_sought(wall: Wall, hold: Hold, here) -> None:
    """Rules of a tie that is to be designed."""
    if wall.kinematics.both_ways:
        raise InputError("holds_one_side", place=here, key="design")
    if require_value(hold.h_m) < LEAST_BELOW_SOUGHT:
        raise InputError("tie_sought_low", place=here, key="h_m", found=hold.h_m, least=LEAST_BELOW_SOUGHT)
    if given := [key for key in NOT_SOUGHT if getattr(hold, key)]:
        raise InputError("tie_sought", place=here, key=given[0])
    if hold.elongation_m is not None and hold.bar_length_m is None:
        raise InputError("tie_design_needs", place=here, key="elongation_m", needed=Key("bar_length_m"))


def _check_bar(wall: Wall, hold: Hold, here) -> None:
    """Rules of a tie that is there."""
    if hold.bar_length_m is None:
        raise InputError("tie_needs_length", place=here, key="bar_length_m")
    if (hold.out_kn_m is None) == (hold.bar is None):
        raise InputError("tie_size_or_bar", place=here, key="out_kn_m")
    if hold.bar is not None:
        _check_steel(wall, hold, hold.bar, here)
    if hold.slack_mm and hold.prestress:
        raise InputError("tie_slack_and_prestress", place=here, key="prestress")
    if hold.prestress and wall.kinematics.rocks_both_ways:
        raise InputError("prestress_one_sided", place=here, key="prestress")


def _check_steel(wall: Wall, hold: Hold, bar: Bars, here) -> None:
    """Rules of the bars of a tie."""
    if hold.fy_mpa is not None:
        raise InputError("tie_bar_says", place=here, key="fy_mpa")
    if wall.length_m is None:
        raise InputError("tie_bar_needs_length", place=here, key="length_m")
    if bar.existing and None in (bar.fy_mpa, bar.fu_mpa):
        raise InputError("tie_existing_steel", place=here, key="fy_mpa" if bar.fy_mpa is None else "fu_mpa")
    if bar.tensile < bar.strength:
        raise InputError("tie_fu_below_fy", place=here, key="fu_mpa", found=bar.tensile, least=bar.strength)
    if (bar.thread_mm or 0.0) > (most := MAX_THREAD * bar.diameter_mm):
        raise InputError("tie_thread_too_large", place=here, key="thread_mm", found=bar.thread_mm, most=most)


def _check_elongation(stated: float, at_yield: float, length: float, here) -> None:
    """Refuse an elongation [m] a bar of this length [m] cannot have."""
    if stated < at_yield:
        raise InputError("tie_elongation_below_yield", place=here, key="elongation_m", found=stated, least=at_yield)
    if stated > (most := MAX_STRAIN * length):
        raise InputError(
            "tie_elongation_too_large", place=here, key="elongation_m", found=stated, most=most, share=MAX_STRAIN
        )
