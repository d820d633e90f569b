"""A wall held at its top as two blocks: its weights, the hinges, how the blocks turn (Circolare 7/2019
C8.7.1.2.1.1).

The lower block turns by theta about the outer edge of the base, the upper one by -phi about a hinge on the inner face,
so that the outer edge of the top, which is held and free to rise, stays on its vertical. x is inward from the outer
face, z above the base, forces are per metre of wall.

With a hinge setback u the base hinge is at x = u and the one between at t - u, both by the weight on the base, the
largest there is; the edge held at the top, which no weight crushes, stays at x = 0.
"""

import functools
import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from core.known import require_value
from core.units import G
from core.wall.bars import TieBar
from core.wall.body import Body, cut_above, sum_bodies
from core.wall.masonry import Load, Masonry
from core.wall.solids import Part, contact_at, faces_at, sum_of

TOP_TOLERANCE = 1e-6
"""How near to the top of the wall a load is on it [of H]."""


TINY = 1e-30
"""Imaginary step of a derivative: exact, nothing cancels."""


class Weight(NamedTuple):
    """A weight on a block: force [N/m] at x, z [m]; pushed : its mass moves sideways with the block; works : it rises
    with the block, as no weight of a strip that lies does"""

    force: float
    x: float
    z: float
    pushed: bool = True
    works: bool = True

    @property
    def lifted(self) -> float:
        """Force that does work as the block rises [N/m]."""
        return self.force if self.works else 0.0


class Thrust(NamedTuple):
    """A force [N/m] that pushes a block outward at x, z [m], whatever its rotation."""

    force: float
    x: float
    z: float


class Strip(NamedTuple):
    """A metre of wall. height, thickness, setback : H, t at the base, u [m]; weight : W [N/m]
    loads : (N [N/m], d inward of the outer face [m]) on its top, held there: their masses do not move sideways
    below : the loads below it
    parts, length : the solids of a wall with openings or steps, and its length [m]; none of a rectangle
    lies : it spans along the wall between transverse walls (core/wall/arch.py): a metre of its height, z along the
        wall; its weight does no work, both ends turn alike, and the thrust of the ends is its load
    pressed : of a strip that lies, what presses it outward without an earthquake, over its weight [-]
    stands : of a strip that lies, by how much its ends may part before the tie along it breaks [m]
    thrusts : between its base and its top
    bars : ties between them that have yielded: each pulls at its outer face as the wall moves outward, at `bar.height`
        above the base"""

    height: float
    thickness: float
    setback: float
    weight: float
    loads: tuple[tuple[float, float], ...] = ()
    below: tuple[Weight, ...] = ()
    parts: tuple[Part, ...] = ()
    length: float = 1.0
    lies: bool = False
    pressed: float = 0.0
    stands: float = math.inf
    thrusts: tuple[Thrust, ...] = ()
    bars: tuple[TieBar, ...] = ()

    @property
    def is_plain(self) -> bool:
        """Whether it is a rectangle with loads on its top alone, of which all is in closed form."""
        return not (self.parts or self.below or self.lies or self.thrusts or self.bars)

    @property
    def width(self) -> float:
        """Distance between the hinges of the lower block of a rectangle [m]."""
        return self.thickness - 2.0 * self.setback


class Hinges(NamedTuple):
    """x of the hinge at the base, of the one between and of the edge held at the top [m]."""

    base: float
    between: float
    top: float


def hinges_of(strip: Strip, h1: float) -> Hinges:
    """Hinges of a strip whose middle hinge is at h1 [m]: within the faces that both blocks share there."""
    inner, top = strip.thickness, strip.setback if strip.lies else 0.0
    if strip.parts:
        faces, highest = contact_at(strip.parts, h1), _held_faces(strip.parts, strip.height)
        inner, top = faces[1] if faces else inner, highest[0] if highest else top
    return Hinges(strip.setback, inner - strip.setback, top)


def outer_face(strip: Strip, height: float) -> float:
    """x of the outer face of a strip at a height [m]."""
    faces = contact_at(strip.parts, height) if strip.parts else None
    return faces[0] if faces else 0.0


@functools.lru_cache(maxsize=64)
def _held_faces(parts: tuple[Part, ...], height: float) -> tuple[float, float] | None:
    """x of the faces at the top that is held, the same wherever the hinge between is."""
    return faces_at(parts, height, below=True)


def _bodies(strip: Strip, h1: float) -> tuple[Body, Body]:
    """The solids below and above the hinge between, x and z of the wall."""
    cut = ((part, cut_above(part.polygon, h1)) for part in strip.parts)
    above = _lifted(sum_bodies(part._replace(polygon=tuple(polygon)).body for part, polygon in cut if polygon), h1)
    return Body(*(all_of - of_upper for all_of, of_upper in zip(sum_of(strip.parts), above, strict=True))), above


@functools.lru_cache(maxsize=4096)
def blocks_of(strip: Strip, h1: float) -> tuple[tuple[Weight, ...], tuple[Weight, ...]]:
    """The weights of the lower and of the upper block, its own first."""
    height = strip.height
    if strip.parts:
        (lower, above), per = _bodies(strip, h1), G / strip.length
        (x1, z1), (x2, z2) = lower.centroid, above.centroid
        own = Weight(per * lower.mass, x1, z1), Weight(per * above.mass, x2, z2)
    else:
        first, middle = strip.weight * h1 / height, 0.5 * strip.thickness
        own = tuple(
            Weight(force, middle, z, works=not strip.lies)
            for force, z in ((first, 0.5 * h1), (strip.weight - first, 0.5 * (h1 + height)))
        )
    on_lower = tuple(load for load in strip.below if load.z <= h1)
    on_upper = tuple(load for load in strip.below if load.z > h1)
    held = tuple(Weight(n, d, height, False) for n, d in strip.loads)
    return (own[0], *on_lower), (own[1], *on_upper, *held)


def _lifted(body: Body, z: float) -> Body:
    """A body whose zero is at a height, from the ground [m]."""
    inertia = body.inertia + 2.0 * z * body.first_z + z * z * body.mass
    return Body(body.mass, body.first_x, body.first_z + z * body.mass, inertia)


class Turning(NamedTuple):
    """Both blocks with the hinge between at one height, whatever the rotation.

    at : hinges; h1, above : heights of the lower and of the upper block [m]; width, edge : between the hinges of the
    lower block, and from the edge held at the top to the hinge between [m]
    lower : (force that does work, x inward of the hinge at the base, z, force that is pushed) of each weight; upper :
        the same, x outward of the hinge between and z above it
    pressed : of the strip
    pushed : (force, x, z) of the thrusts on the lower and on the upper block, x and z as of their weights
    """

    at: Hinges
    h1: float
    above: float
    width: float
    edge: float
    lower: tuple[tuple[float, float, float, float], ...]
    upper: tuple[tuple[float, float, float, float], ...]
    pressed: float = 0.0
    pushed: tuple[tuple[tuple[float, float, float], ...], tuple[tuple[float, float, float], ...]] = ((), ())

    @classmethod
    def of(cls, strip: Strip, h1: float) -> "Turning":
        """The blocks of a strip whose middle hinge is at h1 [m]."""
        at, (lower, upper) = hinges_of(strip, h1), blocks_of(strip, h1)
        below = tuple((one.lifted, one.x - at.base, one.z, one.force * one.pushed) for one in lower)
        over = tuple((one.lifted, at.between - one.x, one.z - h1, one.force * one.pushed) for one in upper)
        pushed = (
            tuple((push.force, push.x - at.base, push.z) for push in strip.thrusts if push.z <= h1),
            tuple((push.force, at.between - push.x, push.z - h1) for push in strip.thrusts if push.z > h1),
        )
        widths = at.between - at.base, at.between - at.top
        return cls(at, h1, strip.height - h1, *widths, below, over, strip.pressed, pushed)

    def upper_rotation(self, cos: float, sin: float) -> float:
        """phi [rad] at a rotation of the lower block. Raises ValueError where the upper one no longer reaches."""
        x = self.at.base + self.width * cos - self.h1 * sin
        return math.atan2(self.edge, self.above) - math.asin((x - self.at.top) / math.hypot(self.edge, self.above))

    def risen(self, theta: float) -> float:
        """`Turned.risen` at a rotation [rad] of the lower block. Raises ValueError as `upper_rotation`."""
        cos, sin = math.cos(theta), math.sin(theta)
        phi = self.upper_rotation(cos, sin)
        c, s = math.cos(phi), math.sin(phi)
        up = self.width * cos - self.h1 * sin  # of the hinge, by theta
        rate = (self.width * sin + self.h1 * cos) / (self.edge * s + self.above * c)  # of phi, by theta
        risen = math.fsum([force * (x * cos - z * sin) for force, x, z, _ in self.lower])
        risen += math.fsum([force * (up + rate * (x * c - z * s)) for force, x, z, _ in self.upper])
        along = self.width * sin + self.h1 * cos
        risen -= math.fsum([force * (x * sin + z * cos) for force, x, z in self.pushed[0]])
        risen -= math.fsum([force * (along - rate * (x * s + z * c)) for force, x, z in self.pushed[1]])
        return risen - self.pressed * self.moved(cos, sin, c, s) if self.pressed else risen

    def moved(self, cos: float, sin: float, c: float, s: float) -> float:
        """`Turned.moved` by cosine and sine of the rotations of the lower and of the upper block."""
        along = self.width * sin + self.h1 * cos  # of the hinge, by theta
        rate = along / (self.edge * s + self.above * c)
        moved = math.fsum([pushed * (x * sin + z * cos) for _, x, z, pushed in self.lower])
        return moved + math.fsum([pushed * (along - rate * (x * s + z * c)) for _, x, z, pushed in self.upper])


MAX_SPREAD = 1.0
"""Height of a wall between transverse walls that bears what acts on it along a line, at most [m]: a rule of ours."""


def spread_over(height: float) -> float:
    """Height over which what acts along a line is spread [m]. height : of the wall [m]"""
    return min(height, MAX_SPREAD)


def pressing(loads: tuple[Load, ...]) -> float:
    """Thrusts on a wall between transverse walls, whatever their sign, for it bends outward and inward alike, and none
    helps where another acts [N/m]."""
    return sum(abs(load.force) for load in loads if load.is_thrust)


def strip_of(wall: Masonry) -> Strip:
    """A metre of length of a wall, of one that spans between transverse walls a metre of its height."""
    height, thickness = require_value(wall.height), require_value(wall.thickness)
    if wall.arch is not None:
        arch, per = wall.arch, wall.arch.spacing / spread_over(height)
        weight = wall.weight / height * arch.spacing + per * sum(load.force for load in wall.loads if load.pushes)
        pressed, ends = per * pressing(wall.loads), ((arch.thrust, arch.setback),)
        return Strip(
            arch.spacing, thickness, arch.setback, weight, ends, lies=True, pressed=pressed / weight, stands=arch.stands
        )
    weights = [load for load in wall.loads if not load.is_thrust]
    on_top = [load for load in weights if abs(load.height - height) <= TOP_TOLERANCE * height]
    loads = tuple((load.force, load.depth) for load in on_top)
    below = tuple(Weight(load.force, load.depth, load.height, load.pushes) for load in weights if load not in on_top)
    length = require_value(wall.length) if wall.parts else 1.0
    thrusts = tuple(Thrust(load.force, load.depth, load.height) for load in wall.loads if load.is_thrust)
    shape = wall.parts, length
    return Strip(height, thickness, wall.setback, wall.weight, loads, below, *shape, thrusts=thrusts, bars=wall.yielded)


class Mass(NamedTuple):
    """What moves with a block: mass [kg/m] at x, z [m], and its inertia about its own centre [kg m]."""

    mass: float
    x: float
    z: float
    own: float


@functools.lru_cache(maxsize=256)
def masses_of(strip: Strip, h1: float) -> tuple[tuple[Mass, ...], tuple[Mass, ...]]:
    """The masses of the lower and of the upper block: its own, and those of the loads that move with it. A mass on the
    top, held elsewhere, is in neither."""
    (own1, *on_lower), (own2, *on_upper) = blocks_of(strip, h1)
    t, height = strip.thickness, strip.height
    if strip.parts:
        bodies = _bodies(strip, h1)
        inertias = [(body.inertia - math.hypot(*body.centroid) ** 2 * body.mass) / strip.length for body in bodies]
    else:
        blocks = ((own1, h1), (own2, height - h1))
        inertias = [one.force / G * (high * high + t * t) / 12.0 for one, high in blocks]

    def block(own: Weight, inertia: float, loads: list[Weight]) -> tuple[Mass, ...]:
        moving = [Mass(load.force / G, load.x, load.z, 0.0) for load in loads if load.pushed]
        return (Mass(own.force / G, own.x, own.z, inertia), *moving)

    return block(own1, inertias[0], on_lower), block(own2, inertias[1], on_upper)


class Sums(NamedTuple):
    """Sums over a block about its hinge, x as of `Turning`: all forces, those whose masses push sideways, the masses
    that move, each with its first moments, and the inertia of the masses [N/m, N; kg/m, kg; kg m]."""

    force: float
    force_x: float
    force_z: float
    pushed: float
    pushed_x: float
    pushed_z: float
    mass: float
    mass_x: float
    mass_z: float
    inertia: float


class Motion:
    """The one degree of freedom of a strip whose middle hinge is at h1 [m] (resources/docs/physics.md, section 19):
    I(theta) theta''+ I'(theta) theta'^2/2 + V'(theta) = a X'(theta), theta >= 0 the rotation of the lower block."""

    def __init__(self, strip: Strip, h1: float):
        self.strip, self.turning = strip, Turning.of(strip, h1)
        at = self.turning.at
        lower, upper = blocks_of(strip, h1)
        moving_lower, moving_upper = masses_of(strip, h1)
        self.lower = _sums(lower, moving_lower, lambda x: x - at.base, 0.0)
        self.upper = _sums(upper, moving_upper, lambda x: at.between - x, h1)
        self.thrusts = [_moments(list(pushes)) for pushes in self.turning.pushed]

    @property
    def last(self) -> float:
        """The rotation [rad] at which the upper block no longer reaches what holds it."""
        of, radius = self.turning, math.hypot(self.turning.edge, self.turning.above)
        sine = (radius + of.at.base - of.at.top) / math.hypot(of.width, of.h1)
        return math.atan2(of.width, of.h1) + (math.asin(sine) if sine < 1.0 else 0.5 * math.pi)

    def stretched(self, theta, bar: TieBar):
        """Elongation of a bar [m], and its rate by theta, at a rotation of the lower block [rad] below `last`, or at
        several."""
        of, cos, sin = self.turning, np.cos(theta), np.sin(theta)
        face, z = outer_face(self.strip, bar.height), bar.height
        if z <= of.h1:
            a = face - of.at.base
            return face - of.at.base - a * cos + z * sin, a * sin + z * cos
        reach = of.at.base + of.width * cos - of.h1 * sin
        phi = math.atan2(of.edge, of.above) - np.arcsin((reach - of.at.top) / math.hypot(of.edge, of.above))
        along, c, s = of.width * sin + of.h1 * cos, np.cos(phi), np.sin(phi)
        rate, a, b = along / (of.edge * s + of.above * c), face - of.at.between, z - of.h1
        return face - reach - a * c - b * s, along + rate * (a * s - b * c)

    def parts(self, theta: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """I [kg m], V' and X' g [N], at rotations of the lower block [rad] below `last`, each per metre of wall."""
        of, low, up = self.turning, self.lower, self.upper
        cos, sin = np.cos(theta), np.sin(theta)
        radius = math.hypot(of.edge, of.above)
        reach = of.at.base + of.width * cos - of.h1 * sin - of.at.top
        phi = math.atan2(of.edge, of.above) - np.arcsin(reach / radius)
        c, s = np.cos(phi), np.sin(phi)
        rise, along = of.width * cos - of.h1 * sin, of.width * sin + of.h1 * cos  # of the hinge between, by theta
        rate = along / (of.edge * s + of.above * c)  # of phi, by theta
        inertia = low.inertia + up.mass * (rise**2 + along**2) + rate**2 * up.inertia
        inertia += 2.0 * rate * (rise * (up.mass_x * c - up.mass_z * s) - along * (up.mass_x * s + up.mass_z * c))
        risen = low.force_x * cos - low.force_z * sin + up.force * rise + rate * (up.force_x * c - up.force_z * s)
        moved = low.pushed_x * sin + low.pushed_z * cos
        moved += up.pushed * along - rate * (up.pushed_x * s + up.pushed_z * c)
        (_, low_x, low_z), (push, up_x, up_z) = (map(math.fsum, moments) for moments in self.thrusts)
        risen = risen - (low_x * sin + low_z * cos + push * along - rate * (up_x * s + up_z * c))
        return inertia, risen, moved


def _sums(weights: tuple[Weight, ...], masses: tuple[Mass, ...], x_of: Callable[[float], float], z: float) -> Sums:
    """Sums over a block. x_of : x from its hinge; z : height of the hinge [m]"""
    forces = [(weight.lifted, x_of(weight.x), weight.z - z) for weight in weights]
    pushed = [(weight.force, x_of(weight.x), weight.z - z) for weight in weights if weight.pushed]
    moving = [(mass.mass, x_of(mass.x), mass.z - z) for mass in masses]
    each = [math.fsum(value) for rows in (forces, pushed, moving) for value in _moments(rows)]
    inertia = math.fsum(m * (x * x + y * y) for m, x, y in moving) + math.fsum(mass.own for mass in masses)
    return Sums._make([*each, inertia])


def _moments(rows: list[tuple[float, float, float]]) -> tuple[list[float], list[float], list[float]]:
    """Amounts, and amounts times x and z, of (amount, x, z)."""
    return [one for one, _, _ in rows], [one * x for one, x, _ in rows], [one * z for one, _, z in rows]


def kept_at_impact(outward: Strip, inward: Strip, h1: float) -> float:
    """Share e of the velocity that an impact at theta = 0 leaves, in the coordinate whose kinetic energy has a constant
    mass: the momentum projected on the mechanism that opens, the same both ways. inward : the wall mirrored"""
    first, second = (_rates(strip, h1) for strip in (outward, inward))
    cross = lone = other = 0.0
    for (mass, own), one, two in zip(_moving(outward, h1), first, second, strict=True):
        # returning from outward, and going on inward: the same way sideways
        cross += mass * (one[0] * two[0] - one[1] * two[1]) + own * one[2] * two[2]
        lone += mass * (one[0] ** 2 + one[1] ** 2) + own * one[2] ** 2
        other += mass * (two[0] ** 2 + two[1] ** 2) + own * two[2] ** 2
    return cross / math.sqrt(lone * other)


def _moving(strip: Strip, h1: float) -> list[tuple[float, float]]:
    return [(one.mass, one.own) for block in masses_of(strip, h1) for one in block]


def _rates(strip: Strip, h1: float) -> list[tuple[float, float, float]]:
    """Sideways, upwards [m] and turn of each mass by a unit of theta at rest."""
    (lower, upper), at, k = masses_of(strip, h1), hinges_of(strip, h1), h1 / (strip.height - h1)
    of_lower = [(one.z, one.x - at.base, 1.0) for one in lower]
    rise = at.between - at.base
    return of_lower + [(h1 - k * (one.z - h1), rise + k * (at.between - one.x), k) for one in upper]


class HeldTop(NamedTuple):
    """The two mechanisms of a wall held at its top. outward, inward : the wall, and the wall mirrored; h1 : height of
    the hinge between, the same of both [m]"""

    outward: Strip
    inward: Strip
    h1: float

    def side(self, sign: float) -> "Motion":
        """The motion to one side, 1.0 outward."""
        return Motion(self.outward if sign > 0.0 else self.inward, self.h1)


def near_rest(motion: "Motion", slenderness: float) -> tuple[float, float, float]:
    """(p2 [1/s2], a, c) of the block that moves alike at small rotations (DeJong, Dimitrakopoulos 2014), of any
    slenderness alpha [rad]: p2 cos(alpha) = g X'/I, p2 (a sin + c cos) = V'/I, p2 (a cos - c sin) = -V''/I, at 0."""
    inertia, risen, moved = (part[0] for part in motion.parts(np.array([1j * TINY])))
    cos, sin = math.cos(slenderness), math.sin(slenderness)
    p2 = moved.real / (inertia.real * cos)
    held, falls = risen.real / (inertia.real * p2), -risen.imag / (TINY * inertia.real * p2)
    return p2, held * sin + falls * cos, held * cos - falls * sin
