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

ROUNDS = 50
"""Rounds of a thrust that depends on how far the ends part, from its yield down: it falls at each."""

FRICTION = 0.4
"""Friction coefficient of the masonry against which the ends of an arch push."""

ALONG = 0.3
"""Share of the demand across the wall that acts along it at the same time, and pushes the masonry beyond its ends
outward (NTC 2018 7.3.5)."""

TIE, SHOULDER, CRUSHING = "arch_tie", "arch_shoulder", "arch_crushing"
"""What the thrust of the ends is limited by."""


COUNTED = 0.4
"""Share of the displacement with all hinges in line up to which the thrust of a tie develops: that of d_SLV."""

MIN_THRUST = 1.0
"""Thrust of ends that push against nothing [N/m]: the wall then fails by its linear check, ζ about 0."""


class Arch(NamedTuple):
    """A metre of height of a wall between two transverse walls.

    spacing : L between them [m]; thrust : H [N/m]; setback : u of its hinges inside the faces [m]
    by : TIE, SHOULDER or CRUSHING; shoulder : H of the masonry beyond alone [N/m]
    tied : whether H is that of a tie, which pulls only once the ends have parted
    stands : by how much the ends may part before that tie breaks [m]; strength : f of the masonry [Pa]
    across : what holds each end across the wall beside the friction of its thrust [N/m]
    beyond : weight of the masonry beyond an end [N/m]; at_rest : H of it without a push along the wall, pull : of the
        ties, most : that crushes the hinges [N/m]; lasts : `stands` of the ties
    pushed : alpha across the wall at which these are [-]
    """

    spacing: float
    thrust: float
    setback: float
    by: str
    shoulder: float = 0.0
    tied: bool = False
    stands: float = math.inf
    strength: float = math.inf
    across: float = 0.0
    beyond: float = 0.0
    at_rest: float = 0.0
    pull: float = 0.0
    most: float = math.inf
    lasts: float = math.inf
    pushed: float = 0.0

    def under(self, alpha: float) -> "Arch":
        """The arch under a push of alpha across the wall [-]: the masonry beyond takes so much less as ALONG of it
        pushes it along the wall (its inertia)."""
        if not self.beyond:
            return self
        shoulder = max(0.0, self.at_rest - ALONG * alpha * self.beyond)
        return _find_thrust(self._replace(pushed=alpha), shoulder)

    @property
    def held_across(self) -> float:
        """What each end stands across the wall [N/m]: the friction of its thrust and what is said to hold it."""
        return FRICTION * self.thrust + self.across

    @property
    def without_tie(self) -> "Arch":
        """The arch by the masonry beyond alone, as it is before its ends have parted."""
        thrust = max(self.shoulder, MIN_THRUST)
        setback = setback_of(thrust, self.strength)
        return self._replace(thrust=thrust, setback=setback, by=SHOULDER, tied=False, stands=math.inf)


class Along(NamedTuple):
    """Ties along a wall: force at yield per metre of height [N/m], elongation at yield and the one they stand [m], each
    of the whole bar, and the bays it runs through."""

    force: float
    at_yield: float
    stands: float
    bays: float


def parted_at(spacing: float, width: float, displacement: float) -> float:
    """By how much the ends have parted [m] with the middle hinge moved by d_C: 2 (sqrt(L^2/4 + b^2 - (b - d_C)^2) -
    L/2). spacing, width : L and b between the hinges [m]"""
    half = 0.5 * spacing
    return 2.0 * (math.sqrt(half**2 + width**2 - (width - displacement) ** 2) - half)


def parted_flat(spacing: float, thickness: float) -> float:
    """`parted_at` of an arch whose three hinges lie in one line, at the faces: sqrt(L^2 + 4 t^2) - L [m]."""
    return math.hypot(spacing, 2.0 * thickness) - spacing


def thrust_of_shoulder(length: float, thickness: float, height: float, unit_weight: float, parted: float) -> float:
    """H [N/m] that masonry beyond a transverse wall takes at rest: the least of what overturns it about the edge of its
    base, w s b^2/h (1 - 2 v/b) with H spread over the height, and of what makes it slide, mu w s b.

    length, thickness : b along the thrust and s across it [m]; height : h [m]; unit_weight : w [N/m3]
    parted : v, by which the ends have parted at mid-height, all to this side: so far it leans [m]
    """
    weight, leaning = unit_weight * thickness * length, max(0.0, 1.0 - 2.0 * parted / length)
    return min(weight * length / height * leaning, FRICTION * weight)


def setback_of(thrust: float, strength: float) -> float:
    """u = 2 H/(3 f) [m], the resultant of a triangle of stress. thrust : [N/m]; strength : f [Pa]"""
    return 2.0 * thrust / (3.0 * strength)


def developed(along: Along, spacing: float, thickness: float, presses: float) -> float:
    """H [N/m] of ties along the wall at COUNTED of the displacement with all hinges in line: the whole of it where the
    ends have parted there by what the bar yields at, else in proportion; by the least distance of the hinges there may
    be, t/2, with which the ends part least. presses : P that presses the wall outward, between the transverse walls
    [N/m]: nothing holds it already before the hinges lie in line"""
    thrust, width = along.force, (1.0 - 2.0 * MAX_SETBACK) * thickness
    for _ in range(ROUNDS):
        share = max(0.0, 1.0 - presses * spacing / (8.0 * thrust * width)) if thrust > 0.0 else 0.0
        thrust = along.force * min(1.0, parted_at(spacing, width, COUNTED * share * width) / along.at_yield)
    return thrust


def arch_of(
    spacing: float,
    thickness: float,
    strength: float,
    tie: Along | None,
    shoulder: float | None,
    presses: float = 0.0,
    beyond: float = 0.0,
) -> Arch:
    """The arch by what its ends take: the larger of what the tie alone and the shoulder alone do, no more than what the
    hinges are crushed by.

    spacing, thickness : L and t [m]
    strength : f of the masonry [Pa]
    tie : along the wall
    shoulder : `thrust_of_shoulder` [N/m]
    presses : of `developed` [N/m]
    beyond : weight of the shoulder [N/m]
    """
    pull = 0.0 if tie is None else developed(tie, spacing, thickness, presses)
    lasts = math.inf if tie is None else tie.stands / tie.bays
    most, at_rest = 1.5 * strength * MAX_SETBACK * thickness, shoulder or 0.0
    arch = Arch(spacing, 0.0, 0.0, SHOULDER, 0.0, False, lasts, strength, 0.0, beyond, at_rest, pull, most, lasts)
    return _find_thrust(arch, at_rest)


def _find_thrust(arch: Arch, shoulder: float) -> Arch:
    """An arch with the thrust that its ends take. shoulder : what the masonry beyond does [N/m]"""
    beyond = min(shoulder, arch.most)
    tied = arch.pull > beyond
    thrust, by = max(arch.pull if tied else beyond, MIN_THRUST), TIE if tied else SHOULDER
    if thrust >= arch.most:
        thrust, by = arch.most, CRUSHING
    return arch._replace(
        thrust=thrust,
        setback=setback_of(thrust, arch.strength),
        by=by,
        shoulder=beyond,
        tied=tied,
        stands=arch.lasts if tied else math.inf,
    )
