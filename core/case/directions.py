"""A body that stands free, a pinnacle, a chimney, a statue on its base, as it falls along both plan directions and over
a corner."""

import math
from collections.abc import Iterator
from dataclasses import replace

from core.case.solids import Solid
from core.case.wall import Wall
from core.errors import InputError, place
from core.known import require_value
from core.wall.solids import contact_at

CENTRED = 0.01
"""Distance of a load from the middle of the thickness, at most [of it]."""

LONGEST = 2.0
"""Length over thickness beyond which a body falls across itself: along itself it is as much more slender there."""


def directions_of(wall: Wall) -> Iterator[tuple[str, Wall]]:
    """The body as a wall of its other directions, and what tells them, in degrees from that of the thickness: along its
    length, and along the diagonal, over a corner, where it is not too stocky to rock there (a negative velocity ratio).
    Nothing of a wall that falls across itself alone, or that is not known in all directions."""
    for aspect, turned in _all_of(wall) if falls_all_ways(wall) else ():
        try:
            turned.restitution_of("two_sided")
        except InputError as error:
            if error.code == "eq4_negative":
                continue
            raise error.at(place("wall", name=turned.name)) from None
        yield aspect, turned


def falls_all_ways(wall: Wall) -> bool:
    """Whether a wall is a prism that stands free, no longer than LONGEST times as thick, with weights in its middle
    alone: of one that rocks both ways no hold is counted."""
    if not wall.kinematics.both_ways or wall.ties or wall.has_shape:
        return False
    if None in (wall.thickness, wall.length_m, wall.height_m, wall.unit_weight_kn_m3):
        return False
    middle = 0.5 * require_value(wall.thickness)
    centred = all(load.is_weight and abs(require_value(load.d_m) - middle) <= CENTRED * middle for load in wall.load)
    return centred and require_value(wall.length_m) <= 2.0 * LONGEST * middle


def falls_sooner_along(wall: Wall, free_above: float | None) -> bool:
    """Whether a wall that is free, or its part above a height [m], is shorter than thick, so that it falls along its
    length first, and that is not looked at."""
    if wall.length_m is None or wall.thickness is None or falls_all_ways(wall):
        return False
    if not wall.kinematics.rocks_both_ways and free_above is None:
        return False
    faces = contact_at(wall.parts, free_above) if wall.parts and free_above is not None else None
    return wall.length_m < (faces[1] - faces[0] if faces else wall.thickness)


def _all_of(wall: Wall) -> Iterator[tuple[str, Wall]]:
    """Both other directions of a body."""
    thickness, length = require_value(wall.thickness), require_value(wall.length_m)
    diagonal = math.hypot(thickness, length)
    angle = math.atan2(thickness, length)
    outline = ((0.0, 0.0), (length, 0.0), (length, require_value(wall.height_m)), (0.0, require_value(wall.height_m)))
    if angle > 0.25 * math.pi:  # s along the longer side: an oblique plane is not near an elevation
        angle, outline = 0.5 * math.pi - angle, tuple((thickness / length * s, z) for s, z in outline)
    solid = Solid("oblique", outline, min(thickness, length), angle_deg=math.degrees(angle))
    crushed = 1.5 * wall.setback * length  # N / f of a triangle of stress along the edge [m2]
    over_corner = 0.5 * math.sqrt(6.0 * length * thickness * crushed) / diagonal
    across = 2.0 * thickness * length / diagonal
    yield "90°", _turned(wall, "90°", length, thickness, wall.setback * length / thickness)
    aspect = f"{math.degrees(math.atan2(length, thickness)):.3g}°"
    yield aspect, replace(_turned(wall, aspect, diagonal, across, over_corner), solid=(solid,))


def _turned(wall: Wall, aspect: str, thickness: float, length: float, setback: float) -> Wall:
    """The body as a wall of this thickness and length [m], its loads in the middle. setback : of its hinges [m]"""
    share = require_value(wall.length_m) / length
    loads = (replace(load, kn_m=share * require_value(load.kn_m), d_m=0.5 * thickness) for load in wall.load)
    return replace(
        wall,
        name=f"{wall.name} ({aspect})",
        thickness_m=thickness,
        slenderness_deg=None,
        height_over_thickness=None,
        length_m=length,
        hinge_setback_m=setback,
        compressive_strength_mpa=None,
        load=tuple(replace(load, g_kn_m=None, q_kn_m=None, psi_2=None) for load in loads),
    )
