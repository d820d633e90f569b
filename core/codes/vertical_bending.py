"""A wall held at its top that bends outward: two blocks and three hinges (Circolare 7/2019 C8.7.1.2.1.1 to .3).

The lower block turns by theta about the outer edge of the base, the upper one by -phi about a hinge on the inner face,
so that the outer edge of the top, which is held and free to rise, stays on its vertical. x is inward from the outer
face, z above the base, forces are per metre of wall.

With a hinge setback u the base hinge is at x = u and the one between at t - u, both by the weight on the base, the
largest there is; the edge held at the top, which no weight crushes, stays at x = 0.
"""

import functools
import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

from core.boundary import narrowed
from core.errors import InputError, place
from core.units import G
from core.wall import wall_loads

LEAST_SLENDERNESS = 3.0
"""Smallest H/t: both blocks are at least as high as thick, and stockier walls do not bend."""

HEIGHTS = 400
"""Heights of the hinge among which the lowest multiplier is looked for, before its bracket is narrowed."""

SEARCHED, SECTIONS, GOLDEN = 16, 12, 0.5 * (math.sqrt(5.0) - 1.0)
"""Heights among which the least zeta of a check is looked for, and sections of the bracket around it: to 0.04 % of
H."""

BISECTIONS = 50
"""Of the bracket of a root, to its last digits."""

STEP = 2e-3
"""Between two rotations at which the multiplier is looked at for a change of sign [rad]."""

SHOWN = math.radians(4.0)
"""Rotation of the lower block in drawings, less where the wall has fallen before."""

REACHED = 0.999
"""Sine up to which the upper block is followed: beyond it no longer reaches its support."""


class Strip(NamedTuple):
    """A metre of wall. height, thickness, setback : H, t, u [m]; weight : W [N/m]
    loads : (N [N/m], d inward of the outer face [m]) on its top, held there: their masses do not move sideways."""

    height: float
    thickness: float
    setback: float
    weight: float
    loads: tuple[tuple[float, float], ...] = ()

    @property
    def width(self) -> float:
        """Between the hinges of the lower block [m]."""
        return self.thickness - 2.0 * self.setback


class Turned(NamedTuple):
    """The blocks turned by a rotation of the lower one.

    phi : rotation of the upper one [rad]; hinge : (x, z) of the hinge between [m]
    risen : work of the weights, moved : of their masses pushed by their own weight, both per radian of theta [N]
    """

    phi: float
    hinge: tuple[float, float]
    risen: float
    moved: float


def start_multiplier(strip: Strip, h1: float) -> float:
    """alpha_0 with the hinge at h1 [m] (C8.7.1.1) [-]: [W1 b/2 + W2 (b + k b/2) + sum N (b + k (t - u - d))] over
    (W1 + W2) h1/2, with k = h1/(H - h1) and b = t - 2 u."""
    lower, k = strip.weight * h1 / strip.height, h1 / (strip.height - h1)
    width, edge = strip.width, strip.thickness - strip.setback
    holding = 0.5 * lower * width + (strip.weight - lower) * (1.0 + 0.5 * k) * width
    holding += sum(n * (width + k * (edge - d)) for n, d in strip.loads)
    return holding / (0.5 * strip.weight * h1)


def rises(strip: Strip, h1: float) -> bool:
    """Whether alpha_0 grows with the height of the hinge there: the sign of P' h1 - P, alpha_0 = 2 P/(W h1)."""
    edge, turns = strip.thickness - strip.setback, strip.height / (strip.height - h1) ** 2  # dk/dh1
    k, per_metre = h1 / (strip.height - h1), strip.weight / strip.height
    slope = (
        per_metre * strip.width * (0.5 - (1.0 + 0.5 * k)) + per_metre * (strip.height - h1) * 0.5 * turns * strip.width
    )
    slope += sum(n * turns * (edge - d) for n, d in strip.loads)
    return slope * h1 > 0.5 * strip.weight * h1 * start_multiplier(strip, h1)


def lowest_hinge(strip: Strip) -> float:
    """h1 [m] of the lowest alpha_0, both blocks at least as high as thick: the best of HEIGHTS, then bisections of the
    bracket around it. Without a load on the top, or with one near the inner face, it is as high as it may be."""
    low, high = strip.thickness, strip.height - strip.thickness
    found = [low + (high - low) * n / HEIGHTS for n in range(HEIGHTS + 1)]
    best = min(range(len(found)), key=lambda n: start_multiplier(strip, found[n]))
    low, high = found[max(best - 1, 0)], found[min(best + 1, HEIGHTS)]
    above, below, _ = narrowed(lambda h1: rises(strip, h1), high, low, steps=BISECTIONS)
    return min((below, above, found[best]), key=lambda h1: start_multiplier(strip, h1))


def turned(strip: Strip, h1: float, theta: float) -> Turned:
    """The blocks at a rotation [rad] of the lower one. Raises ValueError where the upper one no longer reaches."""
    width, edge, above = strip.width, strip.thickness - strip.setback, strip.height - h1
    cos, sin = math.cos(theta), math.sin(theta)
    x, z = strip.setback + width * cos - h1 * sin, h1 * cos + width * sin
    phi = math.atan2(edge, above) - math.asin(x / math.hypot(edge, above))
    c, s = math.cos(phi), math.sin(phi)
    along, up = width * sin + h1 * cos, width * cos - h1 * sin  # of the hinge, by theta
    rate = along / (edge * s + above * c)  # of phi, by theta
    lower = strip.weight * h1 / strip.height
    upper = strip.weight - lower
    risen = 0.5 * lower * up + upper * (up + 0.5 * rate * (width * c - above * s))
    risen += sum(n * (up + rate * ((edge - d) * c - above * s)) for n, d in strip.loads)
    moved = 0.5 * lower * along + upper * (along - 0.5 * rate * (width * s + above * c))
    return Turned(phi, (x, z), risen, moved)


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
    def d0(self) -> float:
        """d of the equivalent oscillator at which alpha is zero [m]."""
        return self.share * self.d_c0

    @property
    def top_force(self) -> float:
        """What holds the top takes as the mechanism starts [N/m]: alpha_0 W H/2 less the moments of the weights about
        the base hinge, over H. The inertia of what stands on the wall is not in it."""
        strip = self.strip
        held = 0.5 * strip.weight * strip.width + sum(n * (d - strip.setback) for n, d in strip.loads)
        return 0.5 * self.alpha0 * strip.weight - held / strip.height

    @property
    def highest(self) -> bool:
        """Whether the hinge is as high as it may be."""
        strip = self.strip
        return self.h1 > strip.height - strip.thickness - 1e-6 * strip.height

    def rotation(self, d: float) -> float:
        """theta of the lower block [rad] at d of the equivalent oscillator [m]."""
        width = self.strip.width
        sine = (d / self.share - width) / math.hypot(width, self.h1)
        return math.atan2(width, self.h1) + math.asin(sine)

    def alpha(self, d: float) -> float:
        """alpha(d) [-] by the finite geometry (C8.7.1.2.1.2): it lies below the straight line to d_0."""
        at = turned(self.strip, self.h1, self.rotation(d))
        return at.risen / at.moved


@functools.lru_cache(maxsize=4096)
def mechanism(strip: Strip, h1: float | None = None) -> Bending:
    """The mechanism of a strip with its hinge at h1 [m], None : where alpha_0 is lowest. Raises ValueError where
    alpha_0 is not positive."""
    h1 = lowest_hinge(strip) if h1 is None else h1
    alpha0 = start_multiplier(strip, h1)
    if not alpha0 > 0.0:
        raise ValueError(alpha0)
    lower, k, above = strip.weight * h1 / strip.height, h1 / (strip.height - h1), strip.height - h1
    moved = ((lower, 0.5 * h1), (strip.weight - lower, h1 - 0.5 * k * above))
    first, second = (sum(weight * delta**power for weight, delta in moved) for power in (1, 2))
    theta0 = _collapse(strip, h1)
    d_c0 = strip.width * (1.0 - math.cos(theta0)) + h1 * math.sin(theta0)
    return Bending(
        strip, h1, alpha0, first**2 / (strip.weight * second), strip.weight / G, theta0, d_c0, second / (h1 * first)
    )


def _collapse(strip: Strip, h1: float) -> float:
    """The smallest theta [rad] at which the weights no longer hold the wall."""
    edge, above, width = strip.thickness - strip.setback, strip.height - h1, strip.width
    sine = (REACHED * math.hypot(edge, above) + strip.setback) / math.hypot(width, h1)
    last = math.atan2(width, h1) + math.asin(min(sine, 1.0))
    steps = math.ceil(last / STEP)
    low = 0.0
    for n in range(1, steps + 1):
        high = last * n / steps
        if turned(strip, h1, high).risen <= 0.0:
            break
        low = high
    held, lost, _ = narrowed(lambda theta: turned(strip, h1, theta).risen > 0.0, low, high, steps=BISECTIONS)
    return 0.5 * (held + lost)


def strip_of(wall) -> Strip:
    """A metre of a wall of the case."""
    loads = tuple((1e3 * load.kn_m, load.d_m) for load in wall.load)
    return Strip(wall.height_m, wall.thickness, wall.setback, wall_loads.weight_per_metre(wall), loads)


def weakest(strip: Strip, zeta: Callable[[Bending], float]) -> Bending:
    """The mechanism of least zeta, where the hinge may be: the best of SEARCHED heights and of the one of the lowest
    alpha_0, then the golden section between its neighbours."""
    low, high = strip.thickness, strip.height - strip.thickness
    heights = sorted({*(low + (high - low) * n / SEARCHED for n in range(SEARCHED + 1)), lowest_hinge(strip)})
    zetas = [zeta(mechanism(strip, h1)) for h1 in heights]
    best = min(range(len(heights)), key=lambda n: zetas[n])
    low, high = heights[max(best - 1, 0)], heights[min(best + 1, len(heights) - 1)]
    for _ in range(SECTIONS):
        inside = [high - GOLDEN * (high - low), low + GOLDEN * (high - low)]
        found = [zeta(mechanism(strip, h1)) for h1 in inside]
        heights, zetas = [*heights, *inside], [*zetas, *found]
        low, high = (low, inside[1]) if found[0] <= found[1] else (inside[0], high)
    return mechanism(strip, heights[min(range(len(heights)), key=lambda n: zetas[n])])


def bending(wall) -> Bending:
    """The mechanism of a wall of the case with the lowest alpha_0. Raises InputError for one that does not stand, or is
    too stocky."""
    here, ratio = (place("wall", name=wall.name),), wall.height_m / wall.thickness
    if not ratio >= LEAST_SLENDERNESS * (1.0 - 1e-9):
        raise InputError("bending_too_stocky", place=here, found=ratio, least=LEAST_SLENDERNESS)
    try:
        return mechanism(strip_of(wall))
    except ValueError:
        raise InputError("bending_unstable", place=here) from None


def bent_inward(wall):
    """The wall as it is for a motion inward: its loads as far from the inner face as they are from the outer one."""
    return replace(wall, load=tuple(replace(load, d_m=wall.thickness - load.d_m) for load in wall.load))


def shown_rotation(found: Bending) -> float:
    """theta of the lower block [rad] in a drawing."""
    return min(SHOWN, found.theta0)


def outlines(strip: Strip, h1: float, theta: float) -> list[list[tuple[float, float]]]:
    """Corners of the lower and of the upper block, closed, x inward and z up [m], for every drawing."""
    at = turned(strip, h1, theta)
    t, u, height = strip.thickness, strip.setback, strip.height

    def placed(x: float, z: float, about: tuple[float, float], to: tuple[float, float], angle: float):
        c, s = math.cos(angle), math.sin(angle)
        a, b = x - about[0], z - about[1]
        return to[0] + a * c - b * s, to[1] + b * c + a * s

    lower = [(0.0, 0.0), (t, 0.0), (t, h1), (0.0, h1), (0.0, 0.0)]
    upper = [(0.0, h1), (t, h1), (t, height), (0.0, height), (0.0, h1)]
    hinge = (t - u, h1)
    return [
        [placed(x, z, (u, 0.0), (u, 0.0), theta) for x, z in lower],
        [placed(x, z, hinge, at.hinge, -at.phi) for x, z in upper],
    ]
