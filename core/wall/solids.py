"""The solids of a wall: their sections, faces and contact at a height, and where the wall changes.

x is inward from the outer face of the base, z above it.
"""

import itertools
import math
from collections.abc import Iterable, Iterator
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from core.units import G
from core.wall.body import Body, cut_above, directions, extruded, polygon_sums, spans, sum_bodies
from core.wall.plan import area_of, cells_of, edge_reached, length_of, pieces_at, section_at

MIN_BASE = 1e-6
"""Area of a base on which something stands [m2]."""


class Part(NamedTuple):
    """A solid as a number sees it.

    polygon : corners (s, z) [m]; ends : along the normal [m]; angle : [rad]; start : x of s = n = 0 [m]
    weight : [N/m3], negative of an opening; plane, wedge : what it is drawn as
    """

    polygon: tuple[tuple[float, float], ...]
    ends: tuple[float, float]
    angle: float
    start: float
    weight: float
    plane: str
    wedge: bool = False

    @property
    def body(self) -> Body:
        return extruded(self.polygon, self.ends, self.angle, self.start, self.weight / G)

    @property
    def top(self) -> float:
        return max(z for _, z in self.polygon)

    def x_of(self, s: float, n: float) -> float:
        """x [m] of a point of the solid."""
        cosine, sine = directions(self.angle)
        return self.start + s * cosine + n * sine

    def spans_at(self, z: float, below: bool = False) -> list[tuple[float, float]]:
        """Stretches of the polygon, from and to along s, just above a height [m], or just below it."""
        return spans(self.polygon, z, below)

    def widths_at(self, z: np.ndarray) -> np.ndarray:
        """Width of the polygon along s at heights [m]."""
        widths = np.zeros(z.size)
        sign = 0.0
        for (s0, z0), (s1, z1) in zip(self.polygon, (*self.polygon[1:], self.polygon[0]), strict=True):
            sign += s0 * z1 - s1 * z0
            if z0 != z1:
                on = (min(z0, z1) <= z) & (z < max(z0, z1))
                widths += np.where(on, math.copysign(1.0, z1 - z0) * (s0 + (s1 - s0) * (z - z0) / (z1 - z0)), 0.0)
        return math.copysign(1.0, sign) * widths


def lies_behind(part: Part, thickness: float) -> bool:
    """Whether a solid is dragged along behind the base of this thickness [m]: wedges of return walls."""
    faces = [part.x_of(s, n) for s, _ in part.polygon for n in part.ends]
    return part.weight > 0.0 and min(faces) >= thickness * (1.0 - 1e-9)


def clipped(part: Part, thickness: float) -> Part | None:
    """A solid or an opening without what is beyond the base of this thickness [m], None where nothing is left;
    an oblique one ends where its first corner is beyond."""
    if part.plane == "elevation":
        last = min(part.ends[1], thickness - part.start)
        if part.ends[1] <= last + 1e-6:
            return part
        return part._replace(ends=(part.ends[0], last)) if last > part.ends[0] + 1e-6 else None
    cosine, sine = directions(part.angle)
    most = (thickness - part.start - max(end * sine for end in part.ends)) / cosine if sine else thickness - part.start
    if max(s for s, _ in part.polygon) <= most + 1e-6:
        return part
    left = cut_above([(z, -s) for s, z in part.polygon], -most)
    polygon = tuple((most - rest, z) for z, rest in left)
    return part._replace(polygon=polygon) if polygon and polygon_sums(polygon).area > 1e-6 else None


@lru_cache(maxsize=4096)
def sum_of(parts: tuple[Part, ...]) -> Body:
    """The Body of solids."""
    return sum_bodies(part.body for part in parts)


def top_of(parts: Iterable[Part]) -> float:
    """Height of solids [m]."""
    return max(part.top for part in parts if part.weight > 0.0)


def section_area(parts: tuple[Part, ...], z: float, outer: float = -math.inf, inner: float = math.inf) -> float:
    """Area of the horizontal section of solids less their openings just above a height [m2], between x = outer and
    x = inner; of oblique solids the whole. Wedges hang and are no part of it."""
    area = 0.0
    for part in parts:
        if part.wedge:
            continue
        low, high = part.ends
        stretches = part.spans_at(z)
        if part.plane == "elevation":
            low, high = max(low, outer - part.start), min(high, inner - part.start)
        elif part.plane == "section":
            stretches = [(max(one, outer - part.start), min(other, inner - part.start)) for one, other in stretches]
        width = math.fsum(max(other - one, 0.0) for one, other in stretches)
        area += math.copysign(width * max(high - low, 0.0), part.weight)
    return area


class Section(NamedTuple):
    """A horizontal section of a wall, and what is above it.

    height : [m]; middle, thickness : of the section, x of its middle [m]
    weight : above it [N/m]; x, lever : of its centroid, inward and above the section [m]
    """

    height: float
    middle: float
    thickness: float
    weight: float
    x: float
    lever: float


def faces_at(parts, z: float, below: bool = False) -> tuple[float, float] | None:
    """x of the outer and of the inner face of solids just above a height [m], or just below it, their wedges left
    out."""
    kept = [part for part in parts if not part.wedge]
    if any(part.weight < 0.0 and part.spans_at(z, below) for part in kept):
        edges = [x for cell in section_at(kept, z, below) for edge in (cell.outer, cell.inner) for x in edge]
    else:
        edges = [x for piece in pieces_at(kept, z, below) for x, _ in piece.corners]
    return (min(edges), max(edges)) if edges else None


def aligned(parts) -> tuple[Part, ...]:
    """Solids beside each other along the wall, without its wedges: the place of sections along a wall is nominal beside
    elevations, and where they are drawn beyond these they stand at their beginning."""
    kept = [part for part in parts if not part.wedge]
    seen = [s for part in kept if part.plane == "elevation" for s, _ in part.polygon]
    ends = [end for part in kept if part.plane == "section" for end in part.ends]
    if not seen or not ends or (min(seen) <= min(ends) and max(ends) <= max(seen)):
        return tuple(kept)
    by = min(seen) - min(ends)
    return tuple(
        part._replace(ends=(part.ends[0] + by, part.ends[1] + by)) if part.plane == "section" else part for part in kept
    )


SNAP = 1e-6
"""Corners nearer to a height than this are at it [m]: sums of sizes differ in their last digit."""


def snapped(parts: Iterable[Part], z: float) -> tuple[Part, ...]:
    """Solids whose corners near a height [m] are at it."""
    near = [any(0.0 < abs(corner - z) < SNAP for _, corner in part.polygon) for part in parts]
    return tuple(
        part._replace(polygon=tuple((s, z if abs(corner - z) < SNAP else corner) for s, corner in part.polygon))
        if moved
        else part
        for part, moved in zip(parts, near, strict=True)
    )


def is_dragged(part: Part, parts: Iterable[Part], face: float) -> bool:
    """Whether a solid is a section that reaches behind a face [m] over less than half of the length of the wall."""
    if part.plane != "section" or part.weight < 0.0 or part.wedge:
        return False
    if max(part.start + s for s, _ in part.polygon) <= face + SNAP:
        return False
    whole = [one for one in parts if one.weight > 0.0 and not one.wedge]
    seen = [s for one in whole if one.plane == "elevation" for s, _ in one.polygon]
    seen = seen or [end for one in whole if one.plane == "section" for end in one.ends]
    return part.ends[1] - part.ends[0] < CARRIED * (max(seen) - min(seen))


FOOT_HEIGHT, FOOT = 0.05, 0.1
"""At this share of the height the outer face is inward of the hinge by no more than this share of the thickness."""

CARRIED = 0.5
"""Least share of the base that reaches the outer hinge."""


def reached_at(placed: tuple[Part, ...], z: float) -> tuple[float, float] | None:
    """x of the outer and of the inner face just above a height [m] as half of the length of the wall has them, of
    oblique solids the extremes: a pilaster or a foot alone is none."""
    cells = section_at(placed, z)
    if area_of(cells) <= MIN_BASE:
        return None
    share = 0.0 if any(part.plane == "oblique" for part in placed) else CARRIED
    return edge_reached(cells, share), edge_reached(cells, share, inner=True)


OPEN_JOINT = 2e-3
"""How far two solids may be apart above one another and still touch [m]."""


@lru_cache(maxsize=4096)
def contact_at(parts: tuple[Part, ...], z: float) -> tuple[float, float] | None:
    """x of the outer and of the inner edge along which what stands above a height [m] rests on what is below it: of
    the section that both share, the lines that half of its length reaches; of oblique solids its extremes. What a foot
    alone reaches is no edge. None where nothing is above, or nothing is shared."""
    placed = snapped(aligned(parts), z)
    above = pieces_at(placed, z) or pieces_at(placed, z + OPEN_JOINT)
    below = pieces_at(placed, z, below=True) or pieces_at(placed, z - OPEN_JOINT) if z > 0.0 else above
    shared = cells_of(above, below)
    if area_of(shared) <= MIN_BASE:
        return None
    share = 0.0 if any(part.plane == "oblique" for part in placed) else CARRIED
    outer, inner = edge_reached(shared, share), edge_reached(shared, share, inner=True)
    top = max(part.top for part in placed)
    foot = reached_at(placed, z + FOOT_HEIGHT * (top - z))
    if foot and outer + FOOT * (inner - outer) < foot[0] < inner:
        outer = foot[0]
    return (outer, inner) if inner > outer else None


MIN_STEP_AREA, MIN_KINK = 0.01, 0.25
"""Area of a section that is on one side of a height alone [m2], and how much faster a wall becomes shorter above it,
or thinner below it [m/m], where it is said to change there."""


@lru_cache(maxsize=1024)
def changes(parts: tuple[Part, ...]) -> tuple[float, ...]:
    """Heights [m] at which a wall changes, between solids or within the outline of one: its faces step, sills and
    lintels, another masonry, the beginning of a gable."""
    placed = aligned(parts)
    weights = {abs(part.weight) for part in placed}
    alike = [[part for part in placed if abs(part.weight) == weight] for weight in weights]
    flat = {z for part in placed for z in _level_edges(part.polygon) if z > 0.0}
    heights = {z for z in flat if math.fsum(_only_on_one_side(group, z) for group in alike) > MIN_STEP_AREA}
    solids = [part for part in placed if part.weight > 0.0]
    levels = sorted({z for part in solids for _, z in part.polygon})
    heights |= {
        z for below, z, above in zip(levels, levels[1:], levels[2:], strict=False) if _bends(solids, below, z, above)
    }
    heights |= {z for part in placed if part.weight < 0.0 for z in _ends_of(part.polygon)}
    ordered = sorted(heights)  # of an open joint its upper side
    return tuple(z for z, after in itertools.zip_longest(ordered, ordered[1:]) if not after or after - z > OPEN_JOINT)


def _level_edges(polygon) -> Iterator[float]:
    """Heights of the level edges of a polygon [m]: at others no section steps."""
    for (_, z0), (_, z1) in zip(polygon, (*polygon[1:], polygon[0]), strict=True):
        if abs(z0 - z1) < SNAP:
            yield z0


def _only_on_one_side(parts: list[Part], z: float) -> float:
    """Area that a section of solids has on one side of a height alone [m2]."""
    below, above = sorted(pieces_at(parts, z, below=True)), sorted(pieces_at(parts, z))
    if below == above:
        return 0.0
    return area_of(cells_of(below)) + area_of(cells_of(above)) - 2.0 * area_of(cells_of(below, above))


def _ends_of(polygon) -> list[float]:
    """Heights of the sill and of the lintel of an opening [m] that are no level edge: sloped, pointed or round."""
    level, heights = set(_level_edges(polygon)), [z for _, z in polygon]
    return [z for z in (min(heights), max(heights)) if z > 0.0 and z not in level]


def _bends(solids: list[Part], below: float, z: float, above: float) -> bool:
    """Whether a wall, its openings filled, begins to become shorter at a height, or ends to become thinner: a gable,
    a step that slopes. below, above : the corners next to it [m]"""
    rates, length = [], 0.0
    for end, beneath in ((below, True), (above, False)):
        half = 0.5 * (z - end)
        here, there = section_at(solids, z, beneath), section_at(solids, z - half)
        length = length_of(here)
        rates.append([(of(here) - of(there)) / half for of in (length_of, area_of)])
    (shorter, thinner), (on_shorter, on_thinner) = rates
    return shorter - on_shorter > MIN_KINK or on_thinner - thinner > MIN_KINK * length


@lru_cache(maxsize=256)
def sections_of(parts: tuple[Part, ...], length: float, count: int) -> tuple[Section, ...]:
    """Cut so many sections of solids over their height, the lowest one above the base. length : of the wall [m]"""
    sections = []
    for z in np.linspace(0.0, top_of(parts), count + 1)[1:-1].tolist():
        faces = faces_at(parts, z)
        cut = [(part, cut_above(part.polygon, z)) for part in parts]
        above = sum_bodies(part._replace(polygon=tuple(polygon)).body for part, polygon in cut if polygon)
        if faces is None or above.mass <= 0.0:
            continue
        x, lever = above.centroid
        sections.append(Section(z, 0.5 * sum(faces), faces[1] - faces[0], above.mass * G / length, x, lever))
    return tuple(sections)
