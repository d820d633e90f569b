"""What is wrong with the shape of a wall: solids that are none, contradict each other or do not stand."""

import math

from core.case.one_body import TOUCH, check_one_body, check_short_forms
from core.case.shape import SHORT_FORMS
from core.case.solids import Corner, Solid
from core.case.wall import Wall
from core.errors import InputError, place
from core.known import require_value
from core.text.sentence import Key
from core.wall.body import crossing, directions, polygon_sums, shared_area
from core.wall.masonry import base_length
from core.wall.solids import Part, faces_at, sum_of, top_of

RIGHT_SLIP, FLAT_SLIP = 1.0, 10.0
"""Angle from a section, and from an elevation, below which a plane is one of them, and not oblique [deg]: whether the
outer hinge carries a wall along it is judged of elevations."""

LENGTH_SLIP = 0.01
"""Share by which length_m may be less than the body with loads, which act on length_m."""

MIN_CONTACT = 0.5
"""Least height of the point that meets the restraint, of the height of the body."""


def check_shape(wall: Wall) -> None:
    """Raise InputError for solids that are none, contradict each other or do not stand."""
    if not wall.has_shape:
        return
    here = (place("wall", name=wall.title),)
    height, thickness, _, length = wall.complete_sizes()
    short = [key for key in SHORT_FORMS if getattr(wall, key)]
    if wall.solid and short:
        raise InputError("solids_or_short", place=here, key=short[0])
    if wall.return_walls is not None:
        raise InputError("solids_refuse", place=here, key="return_walls")
    _check_short(wall, here)
    for number, solid in enumerate(wall.solid, start=1):
        _check_solid(solid, (*here, place("solid", n=number)))
    parts = wall.parts
    if not parts:
        return
    _check_overlap(parts, here, "openings" if wall.openings else "solid")
    _check_openings(parts, here, "openings" if wall.openings else "solid")
    top = top_of(parts)
    if not MIN_CONTACT * top <= height <= top * (1.0 + 1e-9):
        raise InputError("contact_outside", place=here, key="height_m", found=height, low=MIN_CONTACT * top, top=top)
    _check_base(wall, parts, thickness, length, here)
    check_one_body(wall, parts, here)
    wall.bare_block()  # the setback, then a body that does not stand on it
    x, inner = sum_of(parts).centroid[0], thickness - wall.setback
    if wall.kinematics.rocks_both_ways and x >= inner:
        raise InputError("body_leans_back", place=here, found=x, hinge=inner)


def _across(part: Part) -> float:
    """Thickness of a solid along the direction of motion [m], no more than it reaches inward."""
    sine = abs(directions(part.angle)[1])
    reach = _reach(part, _inward)[1]
    return min(reach, (part.ends[1] - part.ends[0]) / sine) if sine > 0.0 else reach


def _check_base(wall: Wall, parts: tuple[Part, ...], thickness: float, length: float, here) -> None:
    """Both hinges are on the body, something stands there, and its loads act on the length it has: else it stands
    better than it does. Of oblique solids the engineer says where the inner hinge is, within the body."""
    faces = faces_at(parts, 0.0)
    if faces is None and any(part.weight > 0.0 and part.spans_at(0.0) for part in parts):
        raise InputError("nothing_at_base", place=here, key="solid")
    if faces is None or faces[0] > TOUCH:
        raise InputError("hinge_off_body", place=here, found=math.inf if faces is None else faces[0])
    oblique = any(part.plane == "oblique" for part in parts)
    most = faces[1]
    if oblique:  # a corner stands on an edge: the inner hinge is within the thickness of its walls along the motion
        most = max(most, *(_across(part) for part in parts if part.weight > 0.0))
    if thickness > most + TOUCH:
        raise InputError("base_beyond_body", place=here, key="thickness_m", found=thickness, most=most)
    stressed = not oblique or wall.elastic_modulus_mpa is not None or wall.compressive_strength_mpa is not None
    if stressed and not base_length(parts, length, thickness):
        raise InputError("nothing_at_base", place=here, key="solid")
    long = _extent(parts)
    if length > long + TOUCH:
        raise InputError("length_beyond_body", place=here, key="length_m", found=length, most=long)
    if wall.is_loaded and length < (1.0 - LENGTH_SLIP) * long:
        raise InputError("length_of_loads", place=here, key="length_m", found=length, most=long)


def _inward(part: Part, s: float, n: float) -> float:
    """x of a point of a solid, inward from the outer edge of the base [m]."""
    return part.x_of(s, n)


def _along(part: Part, s: float, n: float) -> float:
    """Coordinate along the wall of a point of a solid [m]."""
    if part.plane == "section":
        return n
    cosine, sine = directions(part.angle)
    return s * sine - n * cosine


def _reach(part: Part, of) -> tuple[float, float]:
    """Least and largest coordinate of a solid [m]. of : the coordinate, _inward or _along"""
    coordinates = [of(part, s, n) for s, _ in part.polygon for n in part.ends]
    return min(coordinates), max(coordinates)


def _extent(parts: tuple[Part, ...]) -> float:
    """Length of a body along the wall [m]: of its elevations and oblique solids, and where it has none of its
    sections, whose place along a wall is nominal beside an elevation."""
    solids = [part for part in parts if part.weight > 0.0 and not part.wedge]
    shown = [part for part in solids if part.plane != "section"] or solids
    ends = [_reach(part, _along) for part in shown]
    return max(high for _, high in ends) - min(low for low, _ in ends)


def _check_short(wall: Wall, here) -> None:
    """Rules of the short forms."""
    height = require_value(wall.height_m)
    if wall.gable_m is not None and wall.gable_m > height:
        raise InputError("gable_too_high", place=here, key="gable_m", found=wall.gable_m, most=height)
    heights = [0.0, *(step.from_z_m for step in wall.steps), height]
    if sorted(set(heights)) != heights:
        raise InputError("steps_not_rising", place=here, key="steps")
    for number, opening in enumerate(wall.openings, start=1):
        given = [key for key in ("width_m", "height_m", "diameter_m") if getattr(opening, key) is not None]
        if given not in (["width_m", "height_m"], ["diameter_m"]):
            raise InputError("opening_shape", place=here, key="openings", n=number)
    if wall.out_of_plumb_m:
        for key in ("gable_m", "openings", "return_wedges"):
            if getattr(wall, key):
                raise InputError("plumb_refuses", place=here, key="out_of_plumb_m", other=Key(key))
    if (corner := wall.corner) is not None:
        _check_corner(wall, corner, here)
    wedges = wall.return_wedges
    if wedges is not None and wedges.from_z_m >= wall.shoulder:
        raise InputError("wedge_above", place=here, key="from_z_m", found=wedges.from_z_m, most=wall.shoulder)
    check_short_forms(wall, here)


def _check_corner(wall: Wall, corner: Corner, here) -> None:
    """Rules of a corner of two walls."""
    for key in ("solid", "openings", "steps", "gable_m", "out_of_plumb_m", "return_wedges", "return_walls"):
        if getattr(wall, key):
            raise InputError("corner_refuses", place=here, key="corner", other=Key(key))
    for key, beyond in (("length_2_m", require_value(wall.thickness)), ("length_1_m", corner.thickness_2_m)):
        if getattr(corner, key) <= beyond:
            raise InputError("corner_short", place=here, key=key, found=getattr(corner, key), least=beyond)


def _check_solid(solid: Solid, here) -> None:
    """Rules of one solid."""
    if (solid.angle_deg is None) == (solid.plane == "oblique"):
        raise InputError("solid_angle", place=here, key="angle_deg")
    if solid.plane == "oblique" and not RIGHT_SLIP < abs(require_value(solid.angle_deg)) < 90.0 - FLAT_SLIP:
        # what elevations and sections are judged by would pass it over
        raise InputError("solid_angle_right", place=here, key="angle_deg", found=solid.angle_deg)
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
    area = polygon_sums(opening.polygon).area
    return area - shared_area(opening.polygon, solid.polygon) <= _slip(opening.polygon)


def _slip(polygon) -> float:
    """Area that two polygons may share, or one leave, by the rounding of its corners [m2]."""
    return TOUCH * sum(max(p[k] for p in polygon) - min(p[k] for p in polygon) for k in (0, 1))


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
    return shared_area(one.polygon, polygon) > min(_slip(one.polygon), _slip(polygon))
