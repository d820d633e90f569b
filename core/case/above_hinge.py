"""The part of a wall above one of its hinges: a wall of its own."""

import math
from collections.abc import Sequence
from dataclasses import replace

from core.case.one_body import find_body_fault
from core.case.solids import Solid
from core.case.wall import Wall
from core.errors import InputError, place
from core.known import require_value
from core.wall.body import cut_above
from core.wall.solids import Part, contact_at, is_dragged, snapped

MIN_HEIGHT_ABOVE = 0.1
"""Least height of the part of a wall above a hinge [m]: that of any wall."""


def part_name(name: str, hinge: float) -> str:
    """What the part of a wall above a hinge [m] is called; the whole wall keeps its name."""
    return f"{name} (+{hinge:.4g} m)" if hinge else name


def loads_above(wall: Wall, hinge: float, face: float) -> tuple:
    """Loads of the part above a hinge, with heights and distances from its own base and face. face : x of the outer
    face of the wall there [m]"""
    kept = (load for load in wall.load if load.h_m > hinge + 1e-9)
    return tuple(
        replace(load, h_m=load.h_m - hinge, d_m=None if load.d_m is None else load.d_m - face) for load in kept
    )


def cut_above_hinge(wall: Wall, hinge: float) -> Wall:
    """The part of a wall above a hinge [m above its base], with its variant and its height in its name."""
    name = part_name(wall.title, hinge)
    if hinge == 0.0 and name == wall.name and wall.hinge_heights is None:
        return wall
    if hinge == 0.0:
        return replace(wall, name=name, hinge_heights=None)
    assert wall.height_m is not None
    faces = contact_at(wall.parts, hinge)
    loads = loads_above(wall, hinge, faces[0] if faces and wall.corner is None else 0.0)
    changes = {"thickness_m": wall.thickness} | (_corner_above(wall, hinge) or _shape_above(wall, hinge))
    part = replace(
        wall,
        **changes,
        name=name,
        height_m=wall.height_m - hinge,
        slenderness_deg=None,
        height_over_thickness=None,
        base_z_m=None if wall.base_z_m is None else wall.base_z_m + hinge,
        hinge_heights=None,
        base_friction=None,
        load=loads,
        hold=tuple(above for hold in wall.hold if (above := hold.above(hinge)) is not None),
        unloaded_confirmed=wall.unloaded_confirmed or (bool(wall.load) and not loads),
    )
    if part.parts and find_body_fault(part.parts, require_value(part.thickness)) is not None:
        here = (place("wall", name=wall.title),)
        raise InputError("pieces_above", place=here, key="hinge_heights", hinge=hinge)
    return part


def _corner_above(wall: Wall, hinge: float) -> dict:
    """Keys of a corner that change for its part above a hinge [m above the base]: its cracks begin there, of the same
    inclination. Empty of another wall."""
    if (corner := wall.corner) is None:
        return {}
    share = 1.0 - hinge / require_value(wall.height_m)
    lengths = {"length_1_m": share * corner.length_1_m, "length_2_m": share * corner.length_2_m}
    return {"corner": replace(corner, **lengths)}


def _shape_above(wall: Wall, hinge: float) -> dict:
    """Keys that change for the part above a hinge [m above the base] of a wall that is no rectangle: the solids are cut
    there, the base lies between the edges of what it rests on, and the crack of the wedges begins at the hinge with the
    same inclination. Raises InputError at a height without a solid."""
    if not wall.has_shape:
        return {}
    plain: dict = {"solid": (), "return_wedges": None, "gable_m": None, "openings": (), "steps": ()}
    plain |= {"out_of_plumb_m": None, "corner": None}
    parts = tuple(part for part in wall.parts if not part.wedge)
    if not parts:  # a rectangle written as solids
        return plain
    faces = contact_at(parts, hinge)
    if faces is None:
        raise InputError("hinge_in_a_gap", place=(place("wall", name=wall.title),), key="hinge_heights", hinge=hinge)
    outer, inner = faces
    _, thickness, _, _ = wall.complete_sizes()
    weights = [solid.unit_weight_kn_m3 for solid in wall.solid] or [None] * len(parts)
    face = min(inner, thickness)
    there = snapped(parts, hinge)
    cut = zip(there, cut_above_cracks(there, hinge, face), weights, strict=True)
    solids = tuple(solid_of(part, polygon, outer, weight) for part, polygon, weight in cut if polygon)
    base = min(inner - outer, thickness)
    wedges = wall.return_wedges
    if wedges is not None:
        top, start = wall.shoulder - hinge, max(wedges.from_z_m - hinge, 0.0)
        rest = (top - start) / (wall.shoulder - wedges.from_z_m)
        if rest > 0.0:
            corners = ((base, start), (base + rest * wedges.length_at_top_m, top), (base, top))
            solids += (Solid("section", corners, wedges.number * wedges.thickness_m),)
    return plain | {"solid": solids, "thickness_m": base}


def solid_of(part: Part, polygon, outer: float, weight: float | None) -> Solid:
    """A solid of a wall as one of a part of it. polygon : what is left of its own, from the base of the part; outer : x
    of the outer face of the part [m]; weight : its unit weight where that is not the wall's [kN/m3]"""
    return Solid(
        plane=part.plane,
        polygon_m=tuple(polygon),
        to_m=part.ends[1],
        from_m=part.ends[0],
        opening=part.weight < 0.0,
        x0_m=part.start - outer,
        angle_deg=math.degrees(part.angle) if part.plane == "oblique" else None,
        unit_weight_kn_m3=weight,
    )


def cut_above_cracks(parts: Sequence[Part], hinge: float, face: float) -> list[tuple[tuple[float, float], ...]]:
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
    polygons = []
    for part, cut in zip(parts, cuts, strict=True):
        if part in dragged and cut:
            turned = cut_above([(z, face - part.start - s + flat * z) for s, z in cut], 0.0)
            cut = [(face - part.start + flat * z - left, z) for z, left in turned]
        polygons.append(tuple(cut))
    return polygons
