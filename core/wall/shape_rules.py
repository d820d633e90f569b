"""What is wrong with the shape of a wall: solids that are none, contradict each other or do not stand."""

import math

from core.errors import InputError, place
from core.wall.body import crossing, directions, holds, meet, point_within, polygon_sums
from core.wall.wall_body import SHORT_FORMS, Part, faces_at, has_shape, parts_of, shoulder, sum_of, top_of

TOUCH = 1e-6
"""What two sizes may differ by and still be the same [m]."""

LEAST_CONTACT = 0.5
"""Least height of the point that meets the restraint, of the height of the body."""


def check_shape(wall) -> None:
    """Raise InputError for solids that are none, contradict each other or do not stand."""
    if not has_shape(wall):
        return
    here = (place("wall", name=wall.title),)
    needed = {key: getattr(wall, key) for key in ("height_m", "unit_weight_kn_m3", "length_m")}
    for key, value in ({"height_m": wall.height_m, "thickness_m": wall.thickness} | needed).items():
        if value is None:
            raise InputError("solids_need", place=here, key=key)
    short = [key for key in SHORT_FORMS if getattr(wall, key)]
    if wall.solid and short:
        raise InputError("solids_or_short", place=here, key=short[0])
    if wall.return_walls is not None:
        raise InputError("solids_refuse", place=here, key="return_walls")
    _check_short(wall, here)
    for number, solid in enumerate(wall.solid, start=1):
        _check_solid(solid, (*here, place("solid", n=number)))
    parts = parts_of(wall)
    if not parts:
        return
    _check_openings(parts, here, "openings" if wall.openings else "solid")
    _check_overlap(parts, here, "openings" if wall.openings else "solid")
    top = top_of(wall)
    if not LEAST_CONTACT * top <= wall.height_m <= top * (1.0 + 1e-9):
        raise InputError(
            "contact_outside", place=here, key="height_m", found=wall.height_m, low=LEAST_CONTACT * top, top=top
        )
    _check_base(wall, parts, here)
    x, hinges = sum_of(parts).centroid[0], (wall.setback, wall.thickness - wall.setback)
    if x <= hinges[0]:
        raise InputError("body_falls", place=here, found=x, hinge=hinges[0])
    if "two_sided" in wall.mechanisms() and x >= hinges[1]:
        raise InputError("body_leans_back", place=here, found=x, hinge=hinges[1])


def _check_base(wall, parts: tuple[Part, ...], here) -> None:
    """Both hinges are on the body, and its loads act on no more than its length: else it stands better than it does. Of
    oblique solids the engineer says where its inner hinge is."""
    faces = faces_at(parts, 0.0)
    if faces is None or faces[0] > TOUCH:
        raise InputError("hinge_off_body", place=here, found=math.inf if faces is None else faces[0])
    if any(part.plane == "oblique" for part in parts):
        return
    if wall.thickness > faces[1] + TOUCH:
        raise InputError("base_beyond_body", place=here, key="thickness_m", found=wall.thickness, most=faces[1])
    along = [
        [s for s, _ in part.polygon] if part.plane == "elevation" else part.ends for part in parts if part.weight > 0.0
    ]
    most = max(max(ends) for ends in along) - min(min(ends) for ends in along)
    if wall.length_m > most + TOUCH:
        raise InputError("length_beyond_body", place=here, key="length_m", found=wall.length_m, most=most)


def _check_short(wall, here) -> None:
    """Rules of the short forms."""
    if wall.gable_m is not None and wall.gable_m > wall.height_m:
        raise InputError("gable_too_high", place=here, key="gable_m", found=wall.gable_m, most=wall.height_m)
    heights = [0.0, *(step.from_z_m for step in wall.steps), wall.height_m]
    if sorted(set(heights)) != heights:
        raise InputError("steps_not_rising", place=here, key="steps")
    for number, opening in enumerate(wall.openings, start=1):
        given = [key for key in ("width_m", "height_m", "diameter_m") if getattr(opening, key) is not None]
        if given not in (["width_m", "height_m"], ["diameter_m"]):
            raise InputError("opening_shape", place=here, key="openings", n=number)
    wedges = wall.return_wedges
    if wedges is not None and wedges.from_z_m >= shoulder(wall):
        raise InputError("wedge_above", place=here, key="from_z_m", found=wedges.from_z_m, most=shoulder(wall))


def _check_solid(solid, here) -> None:
    """Rules of one solid."""
    if (solid.angle_deg is None) == (solid.plane == "oblique"):
        raise InputError("solid_angle", place=here, key="angle_deg")
    if not solid.to_m > solid.from_m:
        raise InputError("solid_ends", place=here, key="to_m", first=solid.from_m, last=solid.to_m)
    if min(z for _, z in solid.polygon_m) < 0.0:
        raise InputError("solid_below", place=here, key="polygon_m", found=min(z for _, z in solid.polygon_m))
    if (edges := crossing(solid.polygon_m)) is not None:
        raise InputError("polygon_crosses", place=here, key="polygon_m", one=edges[0], other=edges[1])
    if polygon_sums(solid.polygon_m).area < 1e-6:
        raise InputError("polygon_empty", place=here, key="polygon_m")


def _check_openings(parts: tuple[Part, ...], here, key: str) -> None:
    """Each opening is in one solid of its plane. key : that gives them"""
    solids = [part for part in parts if part.weight > 0.0]
    for opening in (part for part in parts if part.weight < 0.0):
        if not any(_is_in(opening, solid) for solid in solids):
            s, z = opening.polygon[0]
            raise InputError("opening_outside", place=here, key=key, s=s, z=z)


def _is_in(opening: Part, solid: Part) -> bool:
    if (opening.angle, opening.weight) != (solid.angle, -solid.weight):
        return False
    shift = 0.0
    if opening.plane == "elevation":
        shift = opening.start - solid.start
    elif opening.start != solid.start:
        return False
    low, high = (end + shift for end in opening.ends)
    if not (solid.ends[0] - 1e-9 <= low and high <= solid.ends[1] + 1e-9):
        return False
    edges = [list(zip(p, (*p[1:], p[0]), strict=True)) for p in (opening.polygon, solid.polygon)]
    if any(_cross(one, other) for one in edges[0] for other in edges[1]):
        return False
    return all(holds(solid.polygon, corner) for corner in opening.polygon)


def _cross(one, other) -> bool:
    """Whether two edges cross within both; touching is none."""
    for k in (0, 1):  # most are apart
        if max(one[0][k], one[1][k]) < min(other[0][k], other[1][k]):
            return False
        if max(other[0][k], other[1][k]) < min(one[0][k], one[1][k]):
            return False
    touching = any(meet((p, p), other) for p in one) or any(meet((p, p), one) for p in other)
    return meet(one, other) and not touching


def _check_overlap(parts: tuple[Part, ...], here, key: str) -> None:
    """Solids of one plane have nothing in common: it would weigh twice; nor have openings. key : that gives them"""
    for k, one in enumerate(parts):
        for other in parts[k + 1 :]:
            alike = one.angle == other.angle and (one.weight > 0.0) == (other.weight > 0.0)
            if not (alike and _overlap(one, other)):
                continue
            if one.weight > 0.0:
                raise InputError("solids_overlap", place=here, key="solid")
            raise InputError("openings_overlap", place=here, key=key)


def _overlap(one: Part, other: Part) -> bool:
    """Whether two solids of parallel planes have more than a face in common."""
    shift = other.start - one.start
    if one.plane == "elevation":
        low, high = (end + shift for end in other.ends)
        polygon = other.polygon
    else:
        (low, high), cosine = other.ends, directions(one.angle)[0]
        polygon = tuple((s + shift / cosine, z) for s, z in other.polygon)
    if min(high, one.ends[1]) - max(low, one.ends[0]) <= 1e-9:
        return False
    apart = [
        max(p[k] for p in a) <= min(p[k] for p in b) + 1e-9
        for a, b in ((one.polygon, polygon), (polygon, one.polygon))
        for k in (0, 1)
    ]
    if any(apart):
        return False
    edges = [list(zip(p, (*p[1:], p[0]), strict=True)) for p in (one.polygon, polygon)]
    if any(_cross(a, b) for a in edges[0] for b in edges[1]):
        return True
    return any(holds(q, point_within(p)) for p, q in ((polygon, one.polygon), (one.polygon, polygon)))
