"""The kinematic checks of a wall held at its top that bends outward: two blocks and three hinges (Circolare 7/2019
C8.7.1.2.1.1 to .3); core/wall/bending.py has the blocks."""

import functools
import math
from collections.abc import Callable
from dataclasses import dataclass
from operator import mul
from typing import ClassVar, NamedTuple

from core.boundary import narrowed
from core.errors import InputError, place
from core.known import require_value
from core.units import G
from core.wall.bars import TieBar
from core.wall.bending import (
    TINY,
    HeldTop,
    Motion,
    Strip,
    Turning,
    Weight,
    blocks_of,
    hinges_of,
    kept_at_impact,
    strip_of,
)
from core.wall.masonry import COUNTED, Masonry
from core.wall.rocking_model import RockingModel, bending_model
from core.wall.solids import changes

MIN_SLENDERNESS = 3.0
"""Smallest H/t: both blocks are at least as high as thick, and stockier walls do not bend."""

MAX_ARCH_SLENDERNESS = 25.0
"""Largest L/t of a wall that spans between transverse walls: a more slender arch shortens under its thrust by as much
as it rises (a rule of ours; EN 1996-1-1, 6.3.2, has the same number, from memory)."""

HINGES_TRIED = 400
"""Heights of the hinge among which the lowest multiplier is looked for, before its bracket is narrowed."""

STEP_OFFSET = 1e-4
"""How far below and above a step a hinge is looked for too [m]."""

SEARCHED, GOLDEN_SECTIONS, GOLDEN = 16, 12, 0.5 * (math.sqrt(5.0) - 1.0)
"""Heights among which the least zeta of a check is looked for, and sections of the bracket around it: to 0.04 % of
H."""

BISECTIONS = 50
"""Bisections of the bracket of a root, down to its last digits."""

ROTATION_STEP = 1e-2
"""Step between two rotations at which the multiplier is looked at for a change of sign [rad]."""


LOST = 0.5
"""Share of the largest capacity of whose loss d_SLV is the end (C8.7.1.2.1.6)."""

REACHED = 0.999
"""Sine up to which the upper block is followed: beyond it no longer reaches its support."""


class Turned(NamedTuple):
    """The blocks turned by a rotation of the lower one.

    phi : rotation of the upper one [rad]; hinge : (x, z) of the hinge between [m]
    risen : work of the weights, moved : of their masses pushed by their own weight, both per radian of theta [N]
    """

    phi: float
    hinge: tuple[float, float]
    risen: float
    moved: float


def virtual(strip: Strip, h1: float) -> list[tuple[Weight, float, float]]:
    """(weight, its rise, its way outward) by a unit of the rotation of the lower block, at the start."""
    lower, upper = blocks_of(strip, h1)
    at, k = hinges_of(strip, h1), h1 / (strip.height - h1)
    of_lower = [(one, one.x - at.base, one.z) for one in lower]
    rise = at.between - at.base
    return of_lower + [(one, rise + k * (at.between - one.x), h1 - k * (one.z - h1)) for one in upper]


def work_of_thrusts(strip: Strip, h1: float, collapse: float | None = None) -> float:
    """Work of the thrusts on a strip, less that of its bars, by a unit of theta at rest [N]. h1, collapse : of
    `acting_thrusts`"""
    return math.fsum(force * way_outward(strip, h1, z) for force, z in acting_thrusts(strip, h1, collapse))


def way_outward(strip: Strip, h1: float, z: float) -> float:
    """Way of a point at a height [m] outward by a unit of theta at rest [m]."""
    return z if z <= h1 else h1 - h1 / (strip.height - h1) * (z - h1)


def acting_thrusts(strip: Strip, h1: float, collapse: float | None = None) -> list[tuple[float, float]]:
    """(force outward [N/m], height [m]) of the thrusts on a strip and of its bars: these where they act together, at
    the rotation up to COUNTED of collapse at which they hold most, as `masonry.held_at`.

    h1 : of the hinge [m]; collapse : theta_0 [rad], None : that of its own weight alone, nearly
    """
    thrusts = [(push.force, push.z) for push in strip.thrusts]
    if not strip.bars:
        return thrusts
    rates = [max(way_outward(strip, h1, bar.height), TINY) for bar in strip.bars]
    most = COUNTED * (strip.width / h1 if collapse is None else collapse)
    ends = [end / rate for bar, rate in zip(strip.bars, rates, strict=True) for end in bar.ends]

    def forces(theta: float) -> list[float]:
        return [bar.force_stretched(rate * theta) for bar, rate in zip(strip.bars, rates, strict=True)]

    best = max(
        (most, *(end for end in ends if end < most)), key=lambda theta: math.fsum(map(mul, forces(theta), rates))
    )
    return thrusts + [(-force, bar.height) for force, bar in zip(forces(best), strip.bars, strict=True)]


def start_multiplier(strip: Strip, h1: float, collapse: float | None = None) -> float:
    """alpha_0 with the hinge at h1 [m] (C8.7.1.1) [-]: of a rectangle [W1 b/2 + W2 (b + k b/2) + sum N (b + k (t - u -
    d))] over (W1 + W2) h1/2, with k = h1/(H - h1) and b = t - 2 u. collapse : of `acting_thrusts`"""
    weights = virtual(strip, h1)
    holding = math.fsum(one.lifted * rise for one, rise, _ in weights) - work_of_thrusts(strip, h1, collapse)
    return holding / math.fsum(one.force * way for one, _, way in weights if one.pushed) - strip.pressed


def multiplier_rises(strip: Strip, h1: float) -> bool:
    """Whether alpha_0 grows with the height of the hinge there: the sign of P' h1 - P, alpha_0 = 2 P/(W h1)."""
    edge, turns = strip.thickness - strip.setback, strip.height / (strip.height - h1) ** 2  # dk/dh1
    k, per_metre = h1 / (strip.height - h1), strip.weight / strip.height
    slope = (
        per_metre * strip.width * (0.5 - (1.0 + 0.5 * k)) + per_metre * (strip.height - h1) * 0.5 * turns * strip.width
    )
    slope += sum(n * turns * (edge - d) for n, d in strip.loads)
    return slope * h1 > 0.5 * strip.weight * h1 * start_multiplier(strip, h1)


def heights_of(strip: Strip, count: int) -> list[float]:
    """Heights among which a hinge is looked for [m], both blocks at least as high as thick: evenly, and just below and
    above those at which the wall changes or carries something."""
    low, high = strip.thickness, strip.height - strip.thickness
    levels = [
        *(changes(strip.parts) if strip.parts else ()),
        *(load.z for load in strip.below),
        *(push.z for push in strip.thrusts),
        *(bar.height for bar in strip.bars),
    ]
    beside = (z + side for z in levels for side in (-STEP_OFFSET, 0.0, STEP_OFFSET))
    return sorted({*(low + (high - low) * n / count for n in range(count + 1)), *(z for z in beside if low < z < high)})


@functools.lru_cache(maxsize=256)
def lowest_hinge(strip: Strip) -> float:
    """h1 [m] of the lowest alpha_0, of a strip that lies its middle: the best of HINGES_TRIED, then bisections of the
    bracket around it, of a wall that is no rectangle the golden section. Without a load on the top, or with one near
    the inner face, it is as high as it may be."""
    if strip.lies:
        return 0.5 * strip.height
    heights = heights_of(strip, HINGES_TRIED)
    values = [start_multiplier(strip, h1) for h1 in heights]
    best = min(range(len(heights)), key=lambda n: values[n])
    low, high = heights[max(best - 1, 0)], heights[min(best + 1, len(heights) - 1)]
    if not strip.is_plain:
        return min((_golden(lambda h1: start_multiplier(strip, h1), low, high, 40), (values[best], heights[best])))[1]
    above, below, _ = narrowed(lambda h1: multiplier_rises(strip, h1), high, low, steps=BISECTIONS)
    return min((below, above, heights[best]), key=lambda h1: start_multiplier(strip, h1))


def _golden(value: Callable[[float], float], low: float, high: float, steps: int) -> tuple[float, float]:
    """Minimise a function of one variable between two places by the golden section; returns (least value, its
    place)."""
    best = (math.inf, low)
    for _ in range(steps):
        inside = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
        points = [(value(place), place) for place in inside]
        best = min(best, *points)
        low, high = (low, inside[1]) if points[0] <= points[1] else (inside[0], high)
    return best


def displaced_blocks(strip: Strip, h1: float, theta: float) -> Turned:
    """The blocks at a rotation [rad] of the lower one. Raises ValueError where the upper one no longer reaches."""
    blocks = Turning.of(strip, h1)
    at, width = blocks.at, blocks.width
    cos, sin = math.cos(theta), math.sin(theta)
    phi = blocks.upper_rotation(cos, sin)
    hinge = at.base + width * cos - h1 * sin, h1 * cos + width * sin
    return Turned(phi, hinge, blocks.risen(theta), blocks.moved(cos, sin, math.cos(phi), math.sin(phi)))


@dataclass(frozen=True)
class Bending:
    """The mechanism of a strip.

    h1 : height of the hinge between [m]
    alpha0 : C8.7.1.1 [-]; e_star : C8.7.1.5 over the virtual displacements of both blocks [-]; mass : sum of
        (P + Q) / g of what moves sideways, the wall alone [kg/m]
    theta0, d_c0 : rotation of the lower block [rad] and displacement of the hinge [m] at which alpha is zero
    share : d over d_C, the displacement of the hinge (C8.7.1.4): both centroids move half as far [-]
    """

    strip: Strip
    h1: float
    alpha0: float
    e_star: float
    mass: float
    theta0: float
    d_c0: float
    share: float

    @property
    def width(self) -> float:
        """Distance between the hinges of the lower block [m]."""
        at = hinges_of(self.strip, self.h1)
        return at.between - at.base

    @property
    def d0(self) -> float:
        """d of the equivalent oscillator at which alpha is zero [m]."""
        return self.share * self.d_c0

    @property
    def top_force(self) -> float:
        """Force that what holds the top takes as the mechanism starts [N/m]: alpha_0 times the moment of what is pushed
        about the base, less the moments of the weights about its hinge, over H. The inertia of what stands on the top
        is not in it."""
        at, weights = hinges_of(self.strip, self.h1), [one for block in blocks_of(self.strip, self.h1) for one in block]
        pushed = self.alpha0 * math.fsum(weight.force * weight.z for weight in weights if weight.pushed)
        pushed += math.fsum(force * z for force, z in acting_thrusts(self.strip, self.h1, self.theta0))
        return (pushed - math.fsum(weight.force * (weight.x - at.base) for weight in weights)) / self.strip.height

    @property
    def highest(self) -> bool:
        """Whether the hinge is as high as it may be."""
        strip = self.strip
        return self.h1 > strip.height - strip.thickness - 1e-6 * strip.height

    def parted(self, theta: float) -> float:
        """By how much the ends of a strip that lies have parted [m], at theta of the first block [rad]."""
        blocks = Turning.of(self.strip, self.h1)
        cos, sin = math.cos(theta), math.sin(theta)
        phi = blocks.upper_rotation(cos, sin)
        first = self.h1 * cos + blocks.width * sin
        return first + blocks.above * math.cos(phi) + blocks.edge * math.sin(phi) - self.strip.height

    @property
    def breaks_at(self) -> float:
        """d of the equivalent oscillator at which the tie along a strip that lies breaks [m]; infinite where it stands
        what the ends part by up to collapse, and of another wall."""
        stands = self.strip.stands
        if math.isinf(stands) or self.parted(self.theta0) <= stands:
            return self._end_of_bars
        theta, _, _ = narrowed(lambda angle: self.parted(angle) <= stands, 0.0, self.theta0, steps=BISECTIONS)
        return self.displacement(theta)

    def displacement(self, theta: float) -> float:
        """d of the equivalent oscillator [m] at theta of the lower block [rad]."""
        return self.share * (self.width * (1.0 - math.cos(theta)) + self.h1 * math.sin(theta))

    def limit_of_ties(self, d: float) -> float:
        """d [m], or less where ties break before it with which more than half of the largest capacity goes
        (C8.7.1.2.1.6)."""
        theta = self.rotation(d) if self.strip.bars else 0.0
        if self.strip.bars and all(self._stretched(theta, bar)[0] <= bar.breaks_at for bar in self.strip.bars):
            return d
        return min(d, self.breaks_at)

    @property
    def _end_of_bars(self) -> float:
        """d [m] at which bars break with which more than half of the largest capacity goes; infinite where none do."""
        ends = [self._turned_at(end, bar) for bar in self.strip.bars for end in bar.ends]
        starts = [self.alpha(self.displacement(theta)) for theta in (0.0, *ends) if theta < self.theta0]
        breaks = sorted((self._turned_at(bar.breaks_at, bar), n) for n, bar in enumerate(self.strip.bars))
        lost = 0.0
        for theta, n in breaks:
            if theta >= self.theta0:
                break
            bar, moved = self.strip.bars[n], displaced_blocks(self.strip, self.h1, theta).moved
            lost += bar.force_stretched(bar.breaks_at) * self._stretched(theta, bar)[1] / moved
            if lost > LOST * max(starts):
                return self.displacement(theta)
        return math.inf

    def _stretched(self, theta: float, bar: TieBar) -> tuple[float, float]:
        """Elongation of a bar [m], and its rate by theta."""
        length, rate = self._motion.stretched(theta, bar)
        return float(length), float(rate)

    def _turned_at(self, u: float, bar: TieBar) -> float:
        """theta [rad] at which a bar is as long as this [m], by Newton; infinite where it never is before collapse."""
        theta, most = 0.0, self.theta0
        if self._stretched(most, bar)[0] <= u:
            return math.inf
        for _ in range(BISECTIONS):
            length, rate = self._stretched(theta, bar)
            step = (u - length) / rate
            theta = min(max(theta + step, 0.0), most)
            if abs(step) <= 1e-14 * most:
                break
        return theta

    def rotation(self, d: float) -> float:
        """theta of the lower block [rad] at d of the equivalent oscillator [m]."""
        width = self.width
        sine = (d / self.share - width) / math.hypot(width, self.h1)
        return math.atan2(width, self.h1) + math.asin(sine)

    def alpha(self, d: float) -> float:
        """alpha(d) [-] by the finite geometry (C8.7.1.2.1.2): it lies below the straight line to d_0."""
        theta = self.rotation(d)
        at = displaced_blocks(self.strip, self.h1, theta)
        return (at.risen + self._held_by_bars(theta)) / at.moved

    def _held_by_bars(self, theta: float) -> float:
        """Work of the bars by a unit of theta on the first way out to a rotation [rad] [N]."""
        rows = [(bar, *self._stretched(theta, bar)) for bar in self.strip.bars]
        return math.fsum(bar.force_stretched(length) * rate for bar, length, rate in rows)

    @functools.cached_property
    def _motion(self) -> Motion:
        return Motion(self.strip, self.h1)


@functools.lru_cache(maxsize=4096)
def mechanism(strip: Strip, h1: float | None = None) -> Bending:
    """The mechanism of a strip with its hinge at h1 [m], None : where alpha_0 is lowest. Raises ValueError where
    alpha_0 is not positive."""
    h1 = lowest_hinge(strip) if h1 is None else h1
    bare = start_multiplier(strip._replace(bars=()), h1)
    if not bare > 0.0:
        raise ValueError(bare)
    theta0, at = _collapse(strip, h1), hinges_of(strip, h1)
    alpha0 = start_multiplier(strip, h1, theta0) if strip.bars else bare
    moved = [(one.force, way) for one, _, way in virtual(strip, h1) if one.pushed]
    total, first, second = (math.fsum(force * way**power for force, way in moved) for power in (0, 1, 2))
    d_c0 = (at.between - at.base) * (1.0 - math.cos(theta0)) + h1 * math.sin(theta0)
    e_star = first**2 / (total * second)
    if any(load.pushed for load in strip.below):  # a mass that hardly moves must not raise a_0*: 1 mm below the top
        held = strip._replace(below=tuple(load._replace(pushed=False) for load in strip.below))
        e_star = max(e_star, alpha0 / start_multiplier(held, h1, theta0))
    return Bending(strip, h1, alpha0, e_star, total / G, theta0, d_c0, second / (h1 * first))


def _collapse(strip: Strip, h1: float) -> float:
    """The smallest theta [rad] at which the weights no longer hold the wall."""
    blocks = Turning.of(strip, h1)
    at, width = blocks.at, blocks.width
    sine = (REACHED * math.hypot(blocks.edge, blocks.above) + at.base - at.top) / math.hypot(width, h1)
    last = math.atan2(width, h1) + math.asin(min(sine, 1.0))
    steps = math.ceil(last / ROTATION_STEP)
    low = 0.0
    for n in range(1, steps + 1):
        high = last * n / steps
        if blocks.risen(high) <= 0.0:
            break
        low = high
    held, lost, _ = narrowed(lambda theta: blocks.risen(theta) > 0.0, low, high, steps=BISECTIONS)
    return 0.5 * (held + lost)


def governing_mechanism(strip: Strip, zeta: Callable[[Bending], float]) -> Bending:
    """The mechanism of least zeta, where the hinge may be: the best of SEARCHED heights and of the one of the lowest
    alpha_0, then the golden section between its neighbours. Of a strip that lies the one in its middle: both halves
    bear and weigh alike."""
    if strip.lies:
        return mechanism(strip)
    heights = sorted({*heights_of(strip, SEARCHED), lowest_hinge(strip)})
    lowest = min((zeta(mechanism(strip, h1)), n) for n, h1 in enumerate(heights))
    low, high = heights[max(lowest[1] - 1, 0)], heights[min(lowest[1] + 1, len(heights) - 1)]
    best = min(
        _golden(lambda h1: zeta(mechanism(strip, h1)), low, high, GOLDEN_SECTIONS), (lowest[0], heights[lowest[1]])
    )
    return mechanism(strip, best[1])


def bending(wall: Masonry) -> Bending:
    """The mechanism of a wall with the lowest alpha_0. Raises InputError for one that does not stand, or is too stocky;
    for one between transverse walls that is too slender too."""
    here = (place("wall", name=wall.name),)
    if wall.arch is not None:
        slender = wall.arch.spacing / require_value(wall.thickness)
        if not MIN_SLENDERNESS * (1.0 - 1e-9) <= slender <= MAX_ARCH_SLENDERNESS * (1.0 + 1e-9):
            at = (*here, place("arch"))
            bounds = {"least": MIN_SLENDERNESS, "most": MAX_ARCH_SLENDERNESS}
            raise InputError("arch_slender", place=at, key="spacing_m", found=slender, **bounds)
        try:
            return mechanism(strip_of(wall))
        except ValueError:
            raise InputError("arch_unstable", place=(*here, place("arch"))) from None
    ratio = require_value(wall.height) / require_value(wall.thickness)
    if not ratio >= MIN_SLENDERNESS * (1.0 - 1e-9):
        raise InputError("bending_too_stocky", place=here, found=ratio, least=MIN_SLENDERNESS)
    try:
        return mechanism(strip_of(wall))
    except ValueError:
        raise InputError("bending_unstable", place=here) from None


def uplift_multiplier(wall: Masonry, mechanism: str) -> float:
    """a_RM / g [-] (Eq. 2), of a two-sided wall the smaller one of its sides; of one held at its top alpha_0."""
    return bending(wall).alpha0 if wall.bends else wall.uplift_multiplier(mechanism)


def model_of_bending(outward: Strip, inward: Strip, h1: float | None = None) -> RockingModel:
    """The rocking model of a wall held at its top. inward : the wall mirrored; h1 : height of the hinge between [m],
    None : where alpha_0 outward is lowest. Raises InputError where it does not stand to one of its sides."""
    try:
        first = mechanism(outward, h1)
        second = mechanism(inward, first.h1)
    except ValueError:
        raise InputError("bending_unstable") from None
    held = HeldTop(outward, inward, first.h1)
    return bending_model(held, (first.theta0, second.theta0), kept_at_impact(outward, inward, first.h1))


@dataclass(frozen=True)
class HingeAt:
    """Another height of the hinge between, at which the histories are made too [m]."""

    h1: float
    assumed: ClassVar[bool] = False

    def of(self, model: RockingModel) -> RockingModel:
        """The model with its hinge here."""
        held = require_value(model.bending)
        return model_of_bending(held.outward, held.inward, self.h1)


MIN_HINGE_DISTANCE = 1e-2
"""Distance of two hinges that are taken as one [of H]: near the lowest, zeta differs by its square."""


def hinges_in_histories(model: RockingModel, displacement: Bending | None) -> tuple[HingeAt, ...]:
    """Heights of the hinge of which the worst decides by histories: those of the lowest alpha_0 outward and inward,
    that of the displacement check (a hinge belongs to a check), and the middle between it and the first."""
    held = require_value(model.bending)
    heights = [held.h1, lowest_hinge(held.inward)]
    if displacement:
        heights += [displacement.h1, 0.5 * (held.h1 + displacement.h1)]
    distinct: list[float] = []
    for h1 in heights:
        if all(abs(h1 - other) > MIN_HINGE_DISTANCE * held.outward.height for other in distinct):
            distinct.append(h1)
    return tuple(HingeAt(h1) for h1 in distinct)
