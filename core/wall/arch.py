"""The wall that spans as a flat arch between transverse walls: horizontal bending (Circolare 7/2019 C8.7.1.2.1.1).

Vertical hinges open at the outer face of both ends and on the inner face between them. What holds the wall is the
thrust H of its ends, per metre of height: alpha_0 = 2 H b (1/L1 + 1/L2)/W, with b = t - 2 u between the hinges, least
in the middle.
"""

import math
from typing import NamedTuple

MAX_SETBACK = 0.25
"""Hinge setback over the thickness at which a larger thrust no longer holds more: H (t - 2 u) has its maximum, as u is
proportional to H."""

FRICTION = 0.4
"""Friction coefficient of the masonry against which the ends of an arch push."""

TIE, SHOULDER, CRUSHING = "arch_tie", "arch_shoulder", "arch_crushing"
"""What the thrust of the ends is limited by."""


class Arch(NamedTuple):
    """A metre of height of a wall between two transverse walls.

    spacing : L between them [m]; thrust : H [N/m]; setback : u of its hinges inside the faces [m]
    by : TIE, SHOULDER or CRUSHING; stands : by how much the ends may part before the tie that holds them breaks [m]
    """

    spacing: float
    thrust: float
    setback: float
    by: str
    stands: float = math.inf


def parted_flat(spacing: float, thickness: float) -> float:
    """By how much the ends of an arch have parted [m] when its three hinges lie in one line: sqrt(L^2 + 4 t^2) - L."""
    return math.hypot(spacing, 2.0 * thickness) - spacing


def thrust_of_shoulder(length: float, thickness: float, height: float, unit_weight: float, parted: float) -> float:
    """H [N/m] that masonry beyond a transverse wall takes: the least of what overturns it about the edge of its base,
    w s b^2/h (1 - 2 v/b) with H spread over the height, and of what makes it slide, mu w s b.

    length, thickness : b along the thrust and s across it [m]; height : h [m]; unit_weight : w [N/m3]
    parted : v, by which the ends have parted at mid-height, all to this side: so far it leans [m]
    """
    weight, leaning = unit_weight * thickness * length, max(0.0, 1.0 - 2.0 * parted / length)
    return min(weight * length / height * leaning, FRICTION * weight)


def setback_of(thrust: float, strength: float) -> float:
    """u = 2 H/(3 f) [m], the resultant of a triangle of stress. thrust : [N/m]; strength : f [Pa]"""
    return 2.0 * thrust / (3.0 * strength)


def arch_of(
    spacing: float, thickness: float, strength: float, tie: tuple[float, float] | None, shoulder: float | None
) -> Arch:
    """The arch by what its ends take: the larger of what the tie alone and the shoulder alone do, no more than what the
    hinges are crushed by.

    spacing, thickness : L and t [m]; strength : f of the masonry [Pa]
    tie : its yield force per metre of height [N/m] and the elongation it stands [m]; shoulder : `thrust_of_shoulder`
    """
    takes = [(shoulder, SHOULDER, math.inf)] if shoulder is not None else []
    takes += [(tie[0], TIE, tie[1])] if tie is not None else []
    thrust, by, stands = max(takes)
    most = 1.5 * strength * MAX_SETBACK * thickness
    if thrust > most:
        thrust, by = most, CRUSHING
    return Arch(spacing, thrust, setback_of(thrust, strength), by, stands)
