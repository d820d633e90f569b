"""Whether the solids of a wall are one body that stands on its outer hinge."""

import itertools
import math

from core.errors import InputError
from core.wall.body import shared_area
from core.wall.wall_body import LEAST_BASE, Part, base_length, faces_at, lies_behind, section_area, shoulder, top_of

TOUCH = 1e-6
"""What two sizes may differ by and still be the same [m]."""

INTO = 1e-3
"""How far a section may reach into an elevation, and what two solids may be apart and still touch [m]."""

LEAST_TOUCH = 0.01
"""Length along which two solids touch to be one body [m]."""

FOOT_HEIGHT, FOOT = 0.05, 0.1
"""At this share of the height the outer face is inward of the hinge by no more than this share of the thickness."""

CARRIED = 0.5
"""Least share of the base that reaches the outer hinge."""

STEEPEST = 1.0
"""Largest length of a wedge at its top over its height: a crack at 45 degrees."""


def check_short_forms(wall, here) -> None:
    """Steps become thinner upwards; wedges hang on the wall over their whole height, are no longer than it together,
    and follow a crack that is not flat."""
    below = wall.thickness
    for step in wall.steps:
        if step.thickness_m > below + TOUCH:
            raise InputError("step_thicker", place=here, key="steps", found=step.thickness_m, most=below)
        below = step.thickness_m
    wedges = wall.return_wedges
    if wedges is None:
        return
    if wedges.number * wedges.thickness_m > wall.length_m + TOUCH:
        found = wedges.number * wedges.thickness_m
        raise InputError("wedges_too_long", place=here, key="return_wedges", found=found, most=wall.length_m)
    high = shoulder(wall) - wedges.from_z_m
    if wedges.length_at_top_m > STEEPEST * high + TOUCH:
        raise InputError("crack_too_flat", place=here, key="length_at_top_m", found=wedges.length_at_top_m, most=high)
    for step in wall.steps:
        if step.from_z_m < shoulder(wall) and step.flush != "inner" and step.thickness_m < wall.thickness - TOUCH:
            raise InputError("wedges_off_step", place=here, key="return_wedges", steps="steps")


def check_one_body(wall, parts: tuple[Part, ...], here) -> None:
    """Raise InputError for solids that share mass, are apart, or do not reach their outer hinge."""
    solids = [part for part in parts if part.weight > 0.0]
    for one in solids:
        for other in solids:
            if (one.plane, other.plane) == ("elevation", "section") and _reaches_into(other, one):
                raise InputError("planes_overlap", place=here, key="solid")
    if _pieces(solids) > 1:
        raise InputError("body_in_pieces", place=here, key="solid")
    if (level := _slot(parts, wall.thickness)) is not None:
        raise InputError("body_cut_through", place=here, z=level)
    if all(part.plane != "oblique" for part in parts):
        _check_foot(wall, parts, here)


def _box(part: Part) -> list[tuple[float, float]]:
    """An elevation in the plane of the sections."""
    low, high = (part.start + end for end in part.ends)
    bottom, top = min(z for _, z in part.polygon), part.top
    return [(low, bottom), (high, bottom), (high, top), (low, top)]


def _in_section(part: Part) -> list[tuple[float, float]]:
    """A section by x and z."""
    return [(part.start + s, z) for s, z in part.polygon]


def _reaches_into(section: Part, elevation: Part) -> bool:
    """Whether a section has mass within the thickness of an elevation, wherever along the wall it is drawn."""
    (low, bottom), (high, _), (_, top), _ = _box(elevation)
    if high - low <= 2.0 * INTO or top - bottom <= 2.0 * INTO:
        return False
    left, right, bottom, top = low + INTO, high - INTO, bottom + INTO, top - INTO
    inner = [(left, bottom), (right, bottom), (right, top), (left, top)]
    return shared_area(_in_section(section), inner) > TOUCH * (top - bottom)


def _touch(one: Part, other: Part) -> bool:
    """Whether two solids share more than a point; of oblique ones, whose place along the wall is free, whether x and z
    of both meet."""
    planes = {one.plane, other.plane}
    if "oblique" in planes:
        boxes = []
        for part in (one, other):
            x = [part.x_of(s, n) for s, _ in part.polygon for n in part.ends]
            z = [z for _, z in part.polygon]
            boxes.append(((min(x), max(x)), (min(z), max(z))))
        return all(min(a[1], b[1]) - max(a[0], b[0]) > -INTO for a, b in zip(*boxes, strict=True))
    if len(planes) == 2:
        first, second = (_box(part) if part.plane == "elevation" else _in_section(part) for part in (one, other))
    elif one.plane == "section":
        apart = max(one.ends[0], other.ends[0]) - min(one.ends[1], other.ends[1])
        if apart > INTO:
            return False
        first, second = _in_section(one), _in_section(other)
        if apart > -INTO:
            return shared_area(first, second) > INTO * LEAST_TOUCH
    else:
        apart = max(p.start + p.ends[0] for p in (one, other)) - min(p.start + p.ends[1] for p in (one, other))
        if apart > INTO:
            return False
        first, second = list(one.polygon), list(other.polygon)
        if apart > -INTO:
            return shared_area(first, second) > INTO * LEAST_TOUCH
    moves = ((0.0, 0.0), (INTO, 0.0), (-INTO, 0.0), (0.0, INTO), (0.0, -INTO))
    return any(shared_area([(s + a, z + b) for s, z in first], second) > INTO * LEAST_TOUCH for a, b in moves)


def _pieces(solids: list[Part]) -> int:
    """Number of bodies that solids which touch form."""
    left, count = list(solids), 0
    while left:
        count += 1
        reached = [left.pop()]
        while reached:
            one = reached.pop()
            beside = [other for other in left if _touch(one, other)]
            left = [other for other in left if other not in beside]
            reached += beside
    return count


def _slot(parts: tuple[Part, ...], thickness: float) -> float | None:
    """A height at which openings leave nothing of the body but what it drags along; None of none."""
    kept = [part for part in parts if not part.wedge and not (part.weight > 0.0 and lies_behind(part, thickness))]
    top = max((part.top for part in kept if part.weight > 0.0), default=0.0)
    levels = sorted({0.0, top, *(z for part in kept for _, z in part.polygon if z < top)})
    for low, high in itertools.pairwise(levels):
        z = 0.5 * (low + high)
        if high - low > TOUCH and section_area(tuple(kept), z) <= LEAST_BASE * (high - low):
            return z
    return None


def _check_foot(wall, parts: tuple[Part, ...], here) -> None:
    """The outer hinge carries the body, not a plinth or a foot alone."""
    low, most = FOOT_HEIGHT * top_of(wall), FOOT * wall.thickness
    faces = faces_at(parts, low)
    if faces is None or faces[0] > most + TOUCH:
        found = math.inf if faces is None else faces[0]
        raise InputError("foot_alone", place=here, found=found, z=low, most=most)
    carried = 0.0
    for part in parts:
        of_part = faces_at((part._replace(weight=abs(part.weight)),), 0.0)
        if part.wedge or of_part is None or of_part[0] > most + TOUCH:
            continue
        if part.plane == "section":
            along = part.ends[1] - part.ends[0]
        else:
            along = sum(end - start for start, end in part.spans_at(0.0))
        carried += math.copysign(along, part.weight)
    whole = base_length(wall)
    if carried < CARRIED * whole:
        raise InputError("foot_short", place=here, found=carried, whole=whole)
