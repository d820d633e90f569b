"""The shape of a wall that is no rectangle: solids, and short forms of what is common."""

import math
from collections.abc import Sequence
from dataclasses import MISSING, dataclass

from core.case.keys import choice_key, flag_key, key, number_key, path_key
from core.errors import InputError, place
from core.wall.body import cut_above
from core.wall.wall_body import Part, contact_at, has_shape, is_dragged, parts_of, shoulder, snapped


@dataclass(frozen=True)
class Solid:
    """[[wall.solid]]: a polygon (s, z) in a vertical plane, extruded along its normal n.

    plane : elevation, s along the wall and n from the outer face inward; section, s from the outer face inward and n
        along the wall; oblique, angle_deg from the section in plan
    polygon_m : corners (s, z), z above the hinge; from_m, to_m : its ends along n
    opening : taken away; x0_m : from the outer face inward to s = n = 0; unit_weight_kn_m3 : that of the wall if
        none is given
    """

    plane: str = choice_key("elevation", "section", "oblique")
    polygon_m: tuple[tuple[float, float], ...] = key("polygon", MISSING)
    to_m: float = number_key(-200.0, 200.0, MISSING, unit="m")
    from_m: float = number_key(-200.0, 200.0, 0.0, unit="m")
    opening: bool = flag_key()
    x0_m: float = number_key(-20.0, 20.0, 0.0, unit="m")
    angle_deg: float | None = number_key(-90.0, 90.0, unit="deg")
    unit_weight_kn_m3: float | None = number_key(5.0, 40.0, unit="kN/m3")


@dataclass(frozen=True)
class Drawing:
    """[[wall.drawing]]: closed shapes of a DXF file, which become solids of the wall each time the case is read.

    file : relative to the case; layers : of the body; opening_layers : of what is taken away
    unit : of the drawing, in place of what its header says
    hinge_y_m : of the drawing at z = 0, else the lowest point of the body; what is below is cut off
    """

    file: str = path_key(MISSING)
    layers: tuple[str, ...] = key("texts", MISSING)
    plane: str = choice_key("elevation", "section")
    to_m: float = number_key(-200.0, 200.0, MISSING, unit="m")
    from_m: float = number_key(-200.0, 200.0, 0.0, unit="m")
    opening_layers: tuple[str, ...] = key("texts", ())
    unit: str | None = choice_key("m", "cm", "mm", "in", "ft", default=None)
    hinge_y_m: float | None = number_key(-1e7, 1e7, unit="m")


@dataclass(frozen=True)
class Opening:
    """[[wall.openings]]: a rectangle by its lower left corner, width and height, or a circle by its centre and its
    diameter.

    s_m : along the wall; z_m : above the hinge
    """

    s_m: float = number_key(0.0, 200.0, MISSING, unit="m")
    z_m: float = number_key(0.0, 60.0, MISSING, unit="m")
    width_m: float | None = number_key(0.05, 100.0, unit="m")
    height_m: float | None = number_key(0.05, 60.0, unit="m")
    diameter_m: float | None = number_key(0.05, 60.0, unit="m")


@dataclass(frozen=True)
class Wedges:
    """[wall.return_wedges]: what the wall drags along of the return walls behind it.

    number : of return walls; thickness_m : of each; length_at_top_m : of the wedge at the top of the wall
    from_z_m : where the crack begins, above the hinge
    """

    number: int = number_key(1, 20, MISSING, whole=True)
    thickness_m: float = number_key(0.05, 3.0, MISSING, unit="m", form_unit="cm")
    length_at_top_m: float = number_key(0.0, 30.0, MISSING, unit="m", exclusive=True)
    from_z_m: float = number_key(0.0, 60.0, 0.0, unit="m")


@dataclass(frozen=True)
class Step:
    """[[wall.steps]]: the thickness from a height on. flush : the face that goes on"""

    from_z_m: float = number_key(0.0, 60.0, MISSING, unit="m", exclusive=True)
    thickness_m: float = number_key(0.05, 20.0, MISSING, unit="m", form_unit="cm")
    flush: str = choice_key("outer", "inner", "middle", default="outer")


def above(wall, hinge: float) -> dict:
    """What changes of a wall above a hinge [m above its base], where it is no rectangle: the solids cut there, the base
    between the edges of what it rests on, and the wedges, whose crack begins at the hinge with the same inclination.
    Raises InputError at a height without a solid."""
    if not has_shape(wall):
        return {}
    plain: dict = {"solid": (), "return_wedges": None, "gable_m": None, "openings": (), "steps": ()}
    parts = tuple(part for part in parts_of(wall) if not part.wedge)
    if not parts:  # a rectangle written as solids
        return plain
    faces = contact_at(parts, hinge)
    if faces is None:
        raise InputError("hinge_in_a_gap", place=(place("wall", name=wall.title),), key="hinge_heights", hinge=hinge)
    outer, inner = faces
    face = min(inner, wall.thickness)
    there = snapped(parts, hinge)
    cut = zip(there, above_cracks(there, hinge, face), strict=True)
    solids = tuple(
        Solid(
            plane=part.plane,
            polygon_m=polygon,
            to_m=part.ends[1],
            from_m=part.ends[0],
            opening=part.weight < 0.0,
            x0_m=part.start - outer,
            angle_deg=math.degrees(part.angle) if part.plane == "oblique" else None,
            unit_weight_kn_m3=abs(part.weight),
        )
        for part, polygon in cut
        if polygon
    )
    base = min(inner - outer, wall.thickness)
    wedges = wall.return_wedges
    if wedges is not None:
        top, start = shoulder(wall) - hinge, max(wedges.from_z_m - hinge, 0.0)
        rest = (top - start) / (shoulder(wall) - wedges.from_z_m)
        if rest > 0.0:
            corners = ((base, start), (base + rest * wedges.length_at_top_m, top), (base, top))
            solids += (Solid("section", corners, wedges.number * wedges.thickness_m),)
    return plain | {"solid": solids, "thickness_m": base}


def above_cracks(parts: Sequence[Part], hinge: float, face: float) -> list[tuple[tuple[float, float], ...]]:
    """The polygons of solids above a hinge [m]. What sections drag along behind the inner face, x [m], begins at the
    hinge too, with the inclination of its own crack, as a wedge of return walls; what is there over half of the length
    of the wall is the wall."""
    cuts = [cut_above(part.polygon, hinge) for part in parts]
    dragged = [part for part in parts if is_dragged(part, parts, face)]
    corners = [(part.start + s - face, z) for part in dragged for s, z in part.polygon]
    behind = [(x, z) for x, z in corners if x > 1e-9]
    if not behind:
        return [tuple(cut) for cut in cuts]
    foot = min(z for x, z in corners if x > -1e-9)
    if min(z for _, z in behind) <= foot + 1e-9:  # it stands on something, or is a block
        return [tuple(cut) for cut in cuts]
    flat = max(x / (z - foot) for x, z in behind)
    found = []
    for part, cut in zip(parts, cuts, strict=True):
        if part in dragged and cut:
            turned = cut_above([(z, face - part.start - s + flat * z) for s, z in cut], 0.0)
            cut = [(face - part.start + flat * z - left, z) for z, left in turned]
        found.append(tuple(cut))
    return found


def outer_face(wall, hinge: float) -> float:
    """x of the edge that the part of a wall above a height [m] turns about, from the outer face of its base."""
    faces = contact_at(parts_of(wall), hinge)
    return faces[0] if faces else 0.0
