"""Whether the solids of a wall are one body that stands on its outer hinge."""

import itertools
import math
from functools import lru_cache

from core.case.wall import Wall
from core.errors import InputError
from core.known import require_value
from core.wall.body import cut_above, shared_area
from core.wall.plan import Bodies, Cell, area_of, cells_of, length_of, pieces_at, section_at
from core.wall.solids import (
    CARRIED,
    FOOT,
    FOOT_HEIGHT,
    MIN_BASE,
    Part,
    aligned,
    is_dragged,
    lies_behind,
    reached_at,
    top_of,
)

TOUCH = 1e-6
"""What two sizes may differ by and still be the same [m]."""

INTO = 1e-3
"""How far a section may reach into an elevation, and what two solids may be apart and still touch [m]."""

MIN_TOUCH = 0.01
"""Length along which two solids touch to be one body [m]."""

LEAVES = 0.25
"""Share of the length of a wall over which a cavity from its foot to its top makes leaves of it: a flue does not."""

HEIGHT_SHARES = (0.02, 0.25, 0.5, 0.75, 0.98)
"""Shares of the height between corners at which oblique solids are looked at."""

DRIFT, MAX_HEIGHTS, ROUND_FROM = 0.02, 200, 12
"""How far an edge may move between two sections [m], so many at most between two corners; an opening with as many
corners is round, and parts nothing between its lowest, widest and highest."""

STEEPEST = 1.0
"""Largest length of a wedge at its top over its height: a crack at 45 degrees."""


def check_short_forms(wall: Wall, here) -> None:
    """Refuse steps that do not become thinner upwards, and wedges that do not hang on the wall over their whole height,
    are together longer than it, or follow a crack that is flat."""
    _, thickness, _, length = wall.complete_sizes()
    below = thickness
    for step in wall.steps:
        if step.thickness_m > below + TOUCH:
            raise InputError("step_thicker", place=here, key="steps", found=step.thickness_m, most=below)
        below = step.thickness_m
    wedges = wall.return_wedges
    if wedges is None:
        return
    if wedges.number * wedges.thickness_m > length + TOUCH:
        total_thickness = wedges.number * wedges.thickness_m
        raise InputError("wedges_too_long", place=here, key="return_wedges", found=total_thickness, most=length)
    high = wall.shoulder - wedges.from_z_m
    if wedges.length_at_top_m > STEEPEST * high + TOUCH:
        raise InputError("crack_too_flat", place=here, key="length_at_top_m", found=wedges.length_at_top_m, most=high)
    for step in wall.steps:
        if step.from_z_m < wall.shoulder and step.flush != "inner" and step.thickness_m < thickness - TOUCH:
            raise InputError("wedges_off_step", place=here, key="return_wedges", steps="steps")


def check_one_body(wall: Wall, parts: tuple[Part, ...], here) -> None:
    """Raise InputError for solids that share mass, are apart, or do not reach their outer hinge."""
    solids = [part for part in parts if part.weight > 0.0]
    for solid in solids:
        for other in solids:
            if (solid.plane, other.plane) == ("elevation", "section") and _reaches_into(other, solid):
                raise InputError("planes_overlap", place=here, key="solid")
            if solid is not other and solid.plane == "oblique" and solid.angle != other.angle and _share(solid, other):
                raise InputError("solids_overlap", place=here, key="solid")
    _check_pieces(wall, parts, here)
    _check_behind(wall, parts, here)
    _check_foot(wall, parts, here)


def _middles(parts) -> list[float]:
    """A height between each two at which a solid has a corner [m]."""
    levels = sorted({z for part in parts for _, z in part.polygon})
    return [0.5 * (low + high) for low, high in itertools.pairwise(levels) if high - low > 2.0 * INTO]


def _heights(parts) -> list[tuple[float, bool]]:
    """(height [m], whether just below it) at which a body is looked at: on both sides of each height at which it may
    come apart, and between them so often that no edge moves farther than DRIFT."""
    levels = set()
    for part in parts:
        zs = [z for _, z in part.polygon]
        wide = [min(part.polygon)[1], max(part.polygon)[1]]
        levels |= {*zs} if part.weight > 0.0 or len(zs) < ROUND_FROM else {min(zs), max(zs), *wide}
    ordered = sorted(levels)
    heights: list[tuple[float, bool]] = []
    for low, high in itertools.pairwise(ordered):
        if high - low <= 2.0 * INTO:
            continue
        moves = [0.0]
        for part in parts:
            for (s0, z0), (s1, z1) in zip(part.polygon, (*part.polygon[1:], part.polygon[0]), strict=True):
                if part.weight > 0.0 and min(z0, z1) < high and max(z0, z1) > low and z0 != z1:
                    moves.append(abs((s1 - s0) / (z1 - z0)) * (high - low))
        count = min(2 + math.ceil(max(moves) / DRIFT), MAX_HEIGHTS)
        heights += [(low + (high - low) * k / count, False) for k in range(count)]
        heights.append((high, True))
    return heights


def _check_pieces(wall: Wall, parts: tuple[Part, ...], here) -> None:
    """The wall is one body, also without what it drags along, and no two leaves."""
    fault = find_body_fault(parts, wall.thickness)
    if fault is not None:
        code, z = fault
        if code == "cut":
            raise InputError("body_cut_through", place=here, z=z)
        if code == "pieces":
            raise InputError("body_in_pieces", place=here, key="solid")
        raise InputError("body_of_leaves", place=here)


@lru_cache(maxsize=1024)
def find_body_fault(parts: tuple[Part, ...], thickness: float) -> tuple[str, float] | None:
    """Why solids are not one body: "cut", "pieces" or "leaves" and the height [m] of a gap; None of one body."""
    placed = aligned(parts)
    borne = tuple(part for part in placed if not lies_behind(part, thickness))
    sections: list[list[Cell]] = []
    for kept in (placed, borne) if borne != placed else (placed,):
        heights = _heights(kept)
        sections = [cells_of(pieces_at(kept, z, below, 0.5 * INTO), same=2.0 * INTO) for z, below in heights]
        middles = zip(heights, sections, strict=True)
        inside = ((z, cells) for k, ((z, _), cells) in enumerate(middles) if 0 < k < len(heights) - 1)
        empty = next((z for z, cells in inside if area_of(cells) <= MIN_BASE), None)
        if empty is not None and kept == borne:
            return "cut", empty
        if Bodies(sections, MIN_TOUCH, 2.0 * INTO).count > 1:
            return "pieces", 0.0
    cavity: list[tuple[float, float]] = []
    for n, cells in enumerate(sections):
        gaps = [
            one[:2]
            for one, other in itertools.pairwise(cells)
            if one[:2] == other[:2] and other.outer[1] - one.inner[1] > 2.0 * INTO
        ]
        cavity = _common(cavity, gaps) if n else gaps
    if cavity and math.fsum(end - start for start, end in cavity) > LEAVES * max(map(length_of, sections)):
        return "leaves", 0.0
    return None


def _common(one, other) -> list[tuple[float, float]]:
    """Intersections of two lists of stretches."""
    both = ((max(a[0], b[0]), min(a[1], b[1])) for a in one for b in other)
    return [(start, end) for start, end in both if end > start]


def _share(one: Part, other: Part) -> bool:
    """Whether two solids, of which one is oblique, have mass in common."""
    levels = sorted({z for part in (one, other) for _, z in part.polygon})
    for low, high in itertools.pairwise(levels):
        for share in HEIGHT_SHARES if high - low > 2.0 * INTO else ():
            z = low + share * (high - low)
            first, second = (pieces_at([part], z, grown=-INTO) for part in (one, other))
            if area_of(cells_of(first, second)) > MIN_BASE:
                return True
    return False


def _check_behind(wall: Wall, parts: tuple[Part, ...], here) -> None:
    """Refuse solids that hang behind the base further than wedges of return walls may: together longer than the wall,
    or one farther behind it than it is high."""
    _, thickness, _, length = wall.complete_sizes()
    solids = [part for part in parts if part.weight > 0.0 and not part.wedge]
    behind = [part for part in solids if part.plane == "section" and lies_behind(part, thickness)]
    for part in solids:
        if not is_dragged(part, solids, thickness):
            continue
        beyond = cut_above([(z, s) for s, z in part.polygon], thickness - part.start)
        if not beyond:
            continue
        far, high = max(x for _, x in beyond), max(z for z, _ in beyond) - min(z for z, _ in beyond)
        if far > STEEPEST * high + TOUCH:
            raise InputError("solid_too_far", place=here, key="solid", found=far, most=STEEPEST * high)
    rest = [part for part in solids if part not in behind]
    if not behind or not rest:
        return
    seen = [s for part in rest if part.plane == "elevation" for s, _ in part.polygon]
    seen += [end for part in rest if part.plane == "section" for end in part.ends]
    most = max(length, max(seen) - min(seen)) if seen else length
    longest = max(length_of(cells_of(pieces_at(behind, z))) for z in _middles(behind))
    if longest > most + TOUCH:
        raise InputError("wedges_too_long", place=here, key="solid", found=longest, most=most)


def _box(part: Part) -> list[tuple[float, float]]:
    """Outline of an elevation in the plane of the sections (x, z) [m]."""
    low, high = (part.start + end for end in part.ends)
    bottom, top = min(z for _, z in part.polygon), part.top
    return [(low, bottom), (high, bottom), (high, top), (low, top)]


def _in_section(part: Part) -> list[tuple[float, float]]:
    """Outline of a section as (x, z) [m]."""
    return [(part.start + s, z) for s, z in part.polygon]


def _reaches_into(section: Part, elevation: Part) -> bool:
    """Whether a section has mass within the thickness of an elevation, wherever along the wall it is drawn."""
    (low, bottom), (high, _), (_, top), _ = _box(elevation)
    if high - low <= 2.0 * INTO or top - bottom <= 2.0 * INTO:
        return False
    left, right, bottom, top = low + INTO, high - INTO, bottom + INTO, top - INTO
    inner = [(left, bottom), (right, bottom), (right, top), (left, top)]
    return shared_area(_in_section(section), inner) > TOUCH * (top - bottom)


def _check_foot(wall: Wall, parts: tuple[Part, ...], here) -> None:
    """Refuse a body whose outer hinge carries only a plinth or a foot; the inner hinge of a two-sided wall likewise."""
    thickness = require_value(wall.thickness)
    low, most = FOOT_HEIGHT * top_of(parts), FOOT * thickness
    placed = aligned(parts)
    base, faces = section_at(placed, 0.0), reached_at(placed, low)
    carried = length_of(cell for cell in base if cell.outer[1] <= most + TOUCH)
    if carried < CARRIED * length_of(base) and all(part.plane != "oblique" for part in placed):
        raise InputError("foot_short", place=here, found=carried, whole=length_of(base))
    if faces is None or faces[0] > most + TOUCH:
        outer_face = math.inf if faces is None else faces[0]
        raise InputError("foot_alone", place=here, found=outer_face, z=low, most=most)
    if wall.kinematics.rocks_both_ways and faces[1] < thickness - most - TOUCH:
        raise InputError("inner_foot_alone", place=here, found=thickness - faces[1], z=low, most=most)
