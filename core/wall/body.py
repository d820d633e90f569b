"""One rigid body of any shape, from extruded polygons (resources/docs/physics.md, section 20).

A solid is a polygon (s, z) in a vertical plane, extruded along the normal of the plane. An opening is a solid of
negative density. Of all solids M, M x, M z and I about the outer edge of the base add up.
"""

import itertools
import math
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from core.errors import InputError
from core.wall.block import Block

Polygon = Sequence[tuple[float, float]]


class PolygonSums(NamedTuple):
    """Integrals of 1, s, z, s2, z2 over a polygon [m2, m3, m4]."""

    area: float
    s: float
    z: float
    ss: float
    zz: float


class Body(NamedTuple):
    """mass [kg]; first_x, first_z : M x and M z [kg m]; inertia : about the line x = z = 0 [kg m2]. x inward from the
    outer edge of the base, z above it."""

    mass: float
    first_x: float
    first_z: float
    inertia: float

    @property
    def centroid(self) -> tuple[float, float]:
        """x, z [m]."""
        return self.first_x / self.mass, self.first_z / self.mass

    def about(self, hinge: float) -> Block:
        """The Block about a hinge at this x [m], turning towards smaller x. Raises InputError for a body that does not
        stand on it, or that its openings leave no mass."""
        if not self.mass > 0.0:
            raise InputError("body_without_mass")
        x, z = self.centroid
        if x <= hinge:
            raise InputError("body_falls", found=x, hinge=hinge)
        inertia = self.inertia / self.mass - 2.0 * hinge * x + hinge * hinge
        if not (z > 0.0 and inertia > (x - hinge) ** 2 + z * z):
            raise InputError("body_without_mass")
        return Block(math.atan2(x - hinge, z), math.hypot(x - hinge, z), inertia)


def polygon_sums(polygon: Polygon) -> PolygonSums:
    """Green's theorem, positive whichever way the corners follow each other.

    polygon : corners (s, z) [m]
    """
    area = s = z = ss = zz = 0.0
    for (s0, z0), (s1, z1) in zip(polygon, (*polygon[1:], polygon[0]), strict=True):
        cross = s0 * z1 - s1 * z0
        area += cross
        s += cross * (s0 + s1)
        z += cross * (z0 + z1)
        ss += cross * (s0 * s0 + s0 * s1 + s1 * s1)
        zz += cross * (z0 * z0 + z0 * z1 + z1 * z1)
    turn = math.copysign(1.0, area)
    return PolygonSums(turn * area / 2.0, turn * s / 6.0, turn * z / 6.0, turn * ss / 12.0, turn * zz / 12.0)


def directions(angle: float) -> tuple[float, float]:
    """cos and sin of an angle [rad], exact of a right one."""
    return (0.0 if abs(angle) == 0.5 * math.pi else math.cos(angle)), math.sin(angle)


def extruded(polygon: Polygon, ends: tuple[float, float], angle: float, start: float, density: float) -> Body:
    """A solid: x = start + s cos(angle) + n sin(angle).

    polygon : corners (s, z) [m]; ends : n from and to, along the normal of the plane [m]
    angle : of the plane from the direction of motion, in plan [rad]; start : x of s = n = 0 [m]
    density : [kg/m3], negative for an opening
    """
    of, (first, last) = polygon_sums(polygon), ends
    cosine, sine = directions(angle)
    one, two, three = last - first, (last**2 - first**2) / 2.0, (last**3 - first**3) / 3.0
    across = cosine * of.s * one + sine * two * of.area
    squares = cosine**2 * of.ss * one + 2.0 * sine * cosine * of.s * two + sine**2 * three * of.area
    inertia = start**2 * of.area * one + 2.0 * start * across + squares + of.zz * one
    return Body(
        density * of.area * one, density * (start * of.area * one + across), density * of.z * one, density * inertia
    )


def sum_bodies(bodies: Iterable[Body]) -> Body:
    """Sum of several bodies as one."""
    return Body(*(math.fsum(parts) for parts in zip(*bodies, strict=True)))


def cut_above(polygon: Polygon, z: float) -> list[tuple[float, float]]:
    """The part of a polygon above a height, with that height as its zero; empty where there is none. Of a polygon that
    is not convex it may have edges along the cut twice, which no sum notices."""
    return [(s, height - z) for s, height in clipped_above(polygon, z)]


def clipped_above(polygon: Polygon, z: float) -> list[tuple[float, float]]:
    """The part of a polygon above a height, with the heights of its corners as they are; empty where there is none."""
    corners: list[tuple[float, float]] = []
    for (s0, z0), (s1, z1) in zip(polygon, (*polygon[1:], polygon[0]), strict=True):
        if z0 > z:
            corners.append((s0, z0))
        if (z0 > z) != (z1 > z):
            corners.append((s0 + (s1 - s0) * (z - z0) / (z1 - z0), z))
    return corners if len(corners) > 2 else []


def crossing(polygon: Polygon) -> tuple[int, int] | None:
    """Numbers of two edges of a polygon, from 1, that cross or touch without following each other; None of a simple
    polygon."""
    edges = list(zip(polygon, (*polygon[1:], polygon[0]), strict=True))
    for i, one in enumerate(edges):
        for j in range(i + 1, len(edges)):
            beside = j == i + 1 or (i == 0 and j == len(edges) - 1)
            if (_folds(one, edges[j]) if beside else edges_touch(one, edges[j])) or one[0] == one[1]:
                return i + 1, j + 1
    return None


def _turn(a, b, c) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _folds(one, other) -> bool:
    """Whether two edges that follow each other go back on themselves."""
    (a, b), (c, d) = one, other
    common, far, end = (b, a, d) if b == c else (a, b, c)
    dot = (far[0] - common[0]) * (end[0] - common[0]) + (far[1] - common[1]) * (end[1] - common[1])
    return _turn(far, common, end) == 0.0 and dot > 0.0


def edges_touch(one, other) -> bool:
    """Whether two edges, each of two corners, have a point in common."""
    (a, b), (c, d) = one, other
    sides = [_turn(a, b, c), _turn(a, b, d), _turn(c, d, a), _turn(c, d, b)]
    if sides[0] * sides[1] < 0.0 and sides[2] * sides[3] < 0.0:
        return True
    return any(
        side == 0.0 and min(p[0], q[0]) <= r[0] <= max(p[0], q[0]) and min(p[1], q[1]) <= r[1] <= max(p[1], q[1])
        for side, (p, q, r) in zip(sides, ((a, b, c), (a, b, d), (c, d, a), (c, d, b)), strict=True)
    )


def contains_point(polygon: Polygon, point: tuple[float, float]) -> bool:
    """Whether a point is in a polygon or on its edge."""
    s, z = point
    inside = False
    for one, other in zip(polygon, (*polygon[1:], polygon[0]), strict=True):
        if edges_touch((one, other), (point, point)):
            return True
        if (one[1] > z) != (other[1] > z) and s < one[0] + (other[0] - one[0]) * (z - one[1]) / (other[1] - one[1]):
            inside = not inside
    return inside


def point_within(polygon: Polygon) -> tuple[float, float]:
    """A point inside a polygon that does not cross itself: on a level without a corner, between its first two edges; a
    corner of one that is a level line."""
    levels = sorted({z for _, z in polygon})
    if len(levels) == 1:
        return polygon[0]
    widest = max(range(len(levels) - 1), key=lambda k: levels[k + 1] - levels[k])
    z = 0.5 * (levels[widest] + levels[widest + 1])
    first, last = spans(polygon, z)[0]
    return 0.5 * (first + last), z


def spans(polygon: Polygon, z: float, below: bool = False) -> list[tuple[float, float]]:
    """Stretches of a polygon, from and to along s, just above a height, or just below it."""
    crossed = sorted(
        s0 + (s1 - s0) * (z - z0) / (z1 - z0)
        for (s0, z0), (s1, z1) in zip(polygon, (*polygon[1:], polygon[0]), strict=True)
        if ((z0 >= z) != (z1 >= z) if below else (z0 > z) != (z1 > z))
    )
    return list(zip(crossed[::2], crossed[1::2], strict=True))


def shared_area(one: Polygon, other: Polygon) -> float:
    """Area that two polygons have in common: between two levels on which no corner lies and no edges cross it is a
    sum of trapezia."""
    ends = [
        (max(min(p[k] for p in q) for q in (one, other)), min(max(p[k] for p in q) for q in (one, other)))
        for k in (0, 1)
    ]
    if any(low >= high for low, high in ends):
        return 0.0
    low, high = ends[1]
    levels = {low, high, *(z for _, z in (*one, *other) if low < z < high)}
    edges = [list(zip(p, (*p[1:], p[0]), strict=True)) for p in (one, other)]
    levels.update(
        z for a in edges[0] for b in edges[1] if (z := _level_of_crossing(a, b)) is not None and low < z < high
    )
    ordered, area = sorted(levels), 0.0
    for bottom, top in itertools.pairwise(ordered):
        z = 0.5 * (bottom + top)
        common = math.fsum(max(min(a[1], b[1]) - max(a[0], b[0]), 0.0) for a in spans(one, z) for b in spans(other, z))
        area += common * (top - bottom)
    return area


def _level_of_crossing(one, other) -> float | None:
    """z of the point in which two edges cross; None of none."""
    (a, b), (c, d) = one, other
    if max(a[0], b[0]) < min(c[0], d[0]) or max(c[0], d[0]) < min(a[0], b[0]):
        return None
    if max(a[1], b[1]) < min(c[1], d[1]) or max(c[1], d[1]) < min(a[1], b[1]):
        return None
    first, last = _turn(c, d, a), _turn(c, d, b)
    return a[1] + (b[1] - a[1]) * first / (first - last) if first * last < 0.0 else None
