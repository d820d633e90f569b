"""Sums of the kinematic chain of one wall with its loads, Circolare 7/2019 C8.7.1.2.1.1 to .3.

One block turns about its hinge, so that the virtual displacement of every point is its height. P are the weights on
the wall, Q those whose mass pushes it, F the forces that do not depend on the earthquake.
"""

import math
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from core.codes.vertical_bending import LOST, Bending, bending
from core.codes.vertical_bending import start_multiplier as start_of_bending
from core.known import require_value
from core.units import G
from core.wall.bars import TieBar
from core.wall.bending import strip_of
from core.wall.masonry import MAX_COLLAPSE, Masonry, base_length, inner_of, load_to_force
from core.wall.wall_loads import restoring_with_ties, start_multiplier

DRAGGED = 0.4
"""Factor of the friction of the return walls (C8.7.1.2.1.1, literature of masonry of regular courses)."""

SINE_OF_MAX_COLLAPSE = math.sin(MAX_COLLAPSE)
"""Sine of the largest rotation a wall comes to."""

HEIGHTS_TRIED = 2000
"""Heights of the part that turns, tried for the smallest alpha_0 with friction."""


class CountedTie(NamedTuple):
    """A tie that counts in the capacity curve. lever : what a newton of it adds to alpha [1/N]"""

    lever: float
    bar: TieBar


@dataclass(frozen=True)
class ChainSums:
    """Sums of the kinematic chain of a wall.

    slenderness, reach : of the wall alone [rad], and the control point: d = reach [sin(alpha) - sin(alpha - theta)]
        (C8.7.1.4) [m]
    alpha0 : C8.7.1.1, with its ties (`load_to_force`), without friction [-]
    alpha0_bare : the same without its ties [-]
    e_star : C8.7.1.5 [-]
    mass : sum of (P + Q) / g per metre of wall [kg/m]; None without a unit weight
    d0 : displacement of the control point at which nothing but a tie holds the wall (C8.7.1.4) [m]: "azioni di cui è
        verificata la presenza fino al collasso" are its loads (C8.7.1.2.1.6), no tie, which yields and breaks
    ties : those counted (none with slack), of a wall that turns outward only
    d0_with_ties : the other reading, in which each tie pulls at yield up to collapse; shown, never taken [m]
    alpha0_friction, e_star_friction, mass_friction : the same with the friction of the return walls, of the part of the
        wall whose alpha_0 over e* is least; None without them, and of a two-sided wall
    friction_height : height of that part, from the top down [m]
    bending : of a wall that bends; these sums are then its own
    """

    slenderness: float
    reach: float
    alpha0: float
    e_star: float
    mass: float | None
    d0: float
    alpha0_bare: float
    ties: tuple[CountedTie, ...] = ()
    d0_with_ties: float | None = None
    alpha0_friction: float | None = None
    e_star_friction: float | None = None
    mass_friction: float | None = None
    friction_height: float | None = None
    bending: Bending | None = None

    @property
    def start(self) -> tuple[float, float, float | None]:
        """alpha_0 [-], e* [-] and the mass [kg/m] of what turns first: with the friction of the return walls where
        there is some."""
        if self.alpha0_friction is None or self.e_star_friction is None:
            return self.alpha0, self.e_star, self.mass
        return self.alpha0_friction, self.e_star_friction, self.mass_friction

    def displacement(self, theta):
        """d [m] of the control point at a rotation [rad], numbers or arrays."""
        return self.reach * (math.sin(self.slenderness) - np.sin(self.slenderness - theta))

    def rotation(self, d: float) -> float:
        """Rotation [rad] at a displacement of the control point [m]."""
        sine = math.sin(self.slenderness) - d / self.reach
        return self.slenderness - math.asin(max(-1.0, sine))

    def alpha_of_ties(self, d: float) -> float:
        """Contribution to alpha of the ties that are whole at d [m], elastic or at yield [-]."""
        theta = self.rotation(d)
        return sum(tie.lever * tie.bar.force_at(theta) for tie in self.ties)

    def alpha(self, d: float) -> float:
        """alpha(d) (C8.7.1.2.1.2) [-]."""
        if self.bending is not None:
            return self.bending.alpha(d)
        return (1.0 - d / self.d0) * self.alpha0_bare + self.alpha_of_ties(d)

    def ends_of_ties(self) -> list[float]:
        """d at which a tie is taut, yields and breaks [m], in order; those no wall comes to left out."""
        reached = ((end, tie.bar.height) for tie in self.ties for end in tie.bar.ends)
        return sorted(float(self.displacement(math.asin(u / h))) for u, h in reached if u < h * SINE_OF_MAX_COLLAPSE)

    def limit_of_ties(self, d: float) -> float:
        """d, or less where ties break before it that reduce the capacity by more than half of its largest value: "lo
        spostamento corrispondente a situazioni nelle quali si verifichino rotture di elementi, quali catene o altri
        collegamenti, che [...] producano una riduzione della capacità, in termini di accelerazione, superiore al 50%
        del valore massimo" (C8.7.1.2.1.6) [m]."""
        if self.bending is not None:
            return self.bending.limit_of_ties(d)
        if not self.ties:
            return d
        most = max(self.alpha(end) for end in (0.0, *self.ends_of_ties()))
        breaking = [tie for tie in self.ties if tie.bar.breaks_at < tie.bar.height * SINE_OF_MAX_COLLAPSE]
        lost = 0.0
        for tie in sorted(breaking, key=lambda tie: tie.bar.breaks_at / tie.bar.height):
            theta = math.asin(tie.bar.breaks_at / tie.bar.height)
            lost += tie.lever * tie.bar.force_at(theta)
            end = float(self.displacement(theta))
            if end < d and lost > LOST * most:
                return end
        return d


def sum_chain(wall: Masonry, two_sided: bool) -> ChainSums:
    """Sums of the chain; of a two-sided wall the smaller alpha_0 and d_0 of its two sides."""
    if wall.bends:
        return sum_bending_chain(wall, bending(wall))
    sides = [sum_chain_of_side(wall, side) for side in ((1.0, -1.0) if two_sided else (1.0,))]
    weaker = min(sides, key=lambda side: side.d0)
    alpha0, bare = (min(getattr(side, name) for side in sides) for name in ("alpha0", "alpha0_bare"))
    # the side that no tie holds decides
    sums = replace(weaker, alpha0=alpha0, alpha0_bare=bare, ties=()) if two_sided else weaker
    if wall.across is None or two_sided:  # they hold a wall that turns outward
        return sums
    parts = multipliers_with_friction(wall)
    k = int(np.argmin(parts[0] / parts[1]))
    alpha, share, of_part, height = (float(values[k]) for values in parts)
    return replace(sums, alpha0_friction=alpha, e_star_friction=share, mass_friction=of_part, friction_height=height)


def sum_bending_chain(wall: Masonry, own: Bending) -> ChainSums:
    """Sums of the chain of a wall that bends, held at its top or between transverse walls."""
    bare = wall.bare
    start = (own.alpha0, own.e_star, own.mass, own.d0, restraint_multiplier_at_rest(wall, own))
    return ChainSums(bare.slenderness, bare.radius, *start, bending=own)


def restraint_multiplier_at_rest(wall: Masonry, own: Bending) -> float:
    """alpha_0 of what holds a wall that bends before it moves [-]: no tie along or across it, which has to stretch
    first."""
    if own.strip.bars:
        return max(0.0, start_of_bending(own.strip._replace(bars=()), own.h1))
    if wall.arch is None or not wall.arch.tied:
        return own.alpha0
    return max(0.0, start_of_bending(strip_of(replace(wall, arch=wall.arch.without_tie)), own.h1))


def sum_chain_of_side(wall: Masonry, side: float) -> ChainSums:
    """The sums about one hinge, 1.0 the outer one, without the friction of return walls."""
    bare = wall.bare
    if side < 0.0:
        bare = inner_of(wall, bare) or bare
    if not wall.loads:
        alpha0, d0 = math.tan(bare.slenderness), bare.radius * math.sin(bare.slenderness)
        mass = None if wall.unit_weight is None or wall.height is None else wall.weight / G
        return ChainSums(bare.slenderness, bare.radius, alpha0, 1.0, mass, d0, alpha0)
    weight, (x, y) = wall.weight, bare.centroid
    pushed = wall.masses
    first = weight * y + sum(mass.mass * G * mass.height for mass in pushed)
    second = weight * y**2 + sum(mass.mass * G * mass.height**2 for mass in pushed)
    total = weight + sum(mass.mass * G for mass in pushed)
    own = [load_to_force(load, wall, side) for load in wall.loads if load.tie is None]
    forces = [load_to_force(load, wall, side) for load in wall.loads]
    alpha0, alpha0_bare = (start_multiplier(weight, x, y, all_of, pushed) for all_of in (forces, own))
    block, restoring = wall.sides[0 if side > 0.0 else 1]
    e_star, reach = first**2 / (total * second), bare.radius * second / (y * first)
    sums = ChainSums(bare.slenderness, reach, alpha0, e_star, total / G, 0.0, alpha0_bare)
    sums = replace(sums, d0=float(sums.displacement(block.slenderness + restoring.lean)))
    bars = [tie.bar for tie in wall.ties if not tie.is_slack]
    if not bars or side < 0.0:
        return sums
    with_ties = block.slenderness + restoring_with_ties(wall).lean
    return replace(
        sums,
        ties=tuple(CountedTie(bar.height / first, bar) for bar in bars),
        d0_with_ties=float(sums.displacement(with_ties)),
    )


def return_wall_friction(wall: Masonry, height):
    """F = 0.4 n (n + 1) phi mu l^2 t_s w of each return wall [N], n courses of it being dragged (C8.7.1.2.1.1).

    height : of the part that turns, of n courses [m], a number or an array
    phi = h_b / l is the shape of a unit, w the unit weight.
    """
    across, weight = require_value(wall.across), require_value(wall.unit_weight)
    n, shape = height / across.course, across.course / across.unit
    return DRAGGED * n * (n + 1.0) * shape * across.friction * across.unit**2 * across.thickness * weight


def multipliers_with_friction(wall: Masonry) -> tuple[np.ndarray, ...]:
    """(alpha_0 with the friction of the return walls at a third of its height [-], e* [-], sum of (P + Q) / g [kg/m],
    height [m]) of every part of the wall from its top down; shape (HEIGHTS_TRIED,) each. The friction acts on the
    length of the wall."""
    height, across = require_value(wall.height), require_value(wall.across)
    heights = height * np.arange(1, HEIGHTS_TRIED + 1) / HEIGHTS_TRIED
    weight = wall.weight * heights / height
    x = 0.5 * require_value(wall.thickness) - wall.setback
    dragged = across.number * return_wall_friction(wall, heights) / require_value(wall.length)
    holding = weight * x + dragged * heights / 3.0
    pushing, second, total = 0.5 * weight * heights, 0.25 * weight * heights**2, weight.copy()
    for load in wall.loads:
        force = load_to_force(load, wall, 1.0)
        lever = np.maximum(load.height - (height - heights), 0.0)
        on_part = lever > 0.0
        holding += on_part * force.vertical * force.distance + force.horizontal * lever
        if load.pushes:
            pushed = load.force * on_part
            total += pushed
            pushing += pushed * lever
            second += pushed * lever**2
    return holding / pushing, pushing**2 / (total * second), total / G, heights


def elastic_period_of_loads(wall: Masonry) -> float:
    """Sum of T_i^2 = 4 pi^2 m_i h_i^3 / (3 E I) [s2] of the masses that move with a cantilever wall, I = t^3 / 12 per
    metre, of a body on its base without openings: Dunkerley's rule adds it to the square of the period of the wall
    alone."""
    thickness = require_value(wall.thickness)
    stiffness = require_value(wall.modulus) * thickness**3 / 12.0
    if wall.parts:
        stiffness *= base_length(wall.parts, require_value(wall.length), thickness) / require_value(wall.length)
    return sum(4.0 * math.pi**2 * mass.mass * mass.height**3 / (3.0 * stiffness) for mass in wall.masses)
