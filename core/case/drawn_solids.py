"""Solids of a wall from the shapes of a drawing: [[wall.drawing]], and the dialog of the window."""

import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

from core.case.drawing_file import (
    DRAWING_UNITS,
    MAX_WALL_SIZE,
    MIN_CORNER_DISTANCE,
    MIN_WALL_SIZE,
    DxfFile,
    Shape,
    Sheet,
    largest,
    likely_unit,
)
from core.case.drawing_outlines import Point, parts_above
from core.case.shape import ANGLES
from core.case.solids import Drawing, Solid
from core.case.values import MAX_CORNERS, parse_section
from core.case.wall import Wall
from core.errors import InputError, place, section
from core.file_names import name_of, shown
from core.text.sentence import Sentence, notice
from core.wall.body import Body, contains_point, crossing, polygon_sums
from core.wall.solids import Part, sum_of

CORNER_DECIMALS = 6
"""Decimals of a corner [m]: corners drawn at one place are at one place."""

MAX_LAYERS_NAMED = 20
"""Layers repeated in a sentence."""


class Drawn(NamedTuple):
    """A drawing that was read for a wall. file : as the case names it; sha256 : of it"""

    file: str
    sha256: str
    notice: Sentence


def expand_drawings(table: dict, folder: Path) -> tuple[dict, list[Drawn]]:
    """The mapping of a case whose walls have solids in place of their drawings. Raises InputError."""
    walls = table.get("wall")
    if not isinstance(walls, list):
        return table, []
    drawn: list[Drawn] = []
    whole = []
    for n, wall in enumerate(walls, start=1):
        if not isinstance(wall, dict) or not isinstance(wall.get("drawing"), list):
            whole.append(wall)
            continue
        name = str(wall.get("name", wall.get("variant_of", n)))
        try:
            views = [_view(entry, k, folder) for k, entry in enumerate(wall["drawing"], start=1)]
            made = [_solids_of(view, views) for view in views]
        except InputError as error:
            raise error.at(place("wall", name=name)) from None
        drawn += [_said(name, view, solids) for view, solids in zip(views, made, strict=True)]
        given = wall.get("solid", [])
        rest = {key: value for key, value in wall.items() if key != "drawing"}
        solids = [solid for one in made for solid in one]
        whole.append({**rest, "solid": [*given, *solids] if isinstance(given, list) else given})
    return {**table, "wall": whole}, drawn


class View(NamedTuple):
    """What a [[wall.drawing]] takes of a file. body, openings : its shapes"""

    drawing: Drawing
    file: DxfFile
    sheet: Sheet
    body: list[Shape]
    openings: list[Shape]


def _view(entry: Any, k: int, folder: Path) -> View:
    """The k-th drawing of a wall. Raises InputError."""
    drawing = parse_section(Drawing, entry, "drawing", section(f"[[drawing]] {k}"))
    file = DxfFile(folder / name_of(drawing.file))
    try:
        sheet = file.sheet(drawing.unit)
        return View(drawing, file, sheet, *select_shapes(sheet, drawing))
    except InputError as error:
        raise error.at(file.path) from None


def _solids_of(view: View, views: Sequence[View]) -> list[dict]:
    """The solids of a drawing, placed by the origin that all views of the same plane of a wall share: the hinge line
    one of them gives, else the lowest point of their bodies together. Raises InputError."""
    plane = view.drawing.plane
    beside = [one for one in views if one.drawing.plane == plane]
    if len({one.file.sha256 for one in beside}) > 1:
        raise InputError("drawing_two_files", plane=plane)
    hinges = {one.drawing.hinge_y_m for one in beside} - {None}
    if len(hinges) > 1 or len({one.sheet.unit for one in beside}) > 1:
        raise InputError("drawing_two_origins", key="hinge_y_m" if len(hinges) > 1 else "unit")
    ends = view.drawing.from_m, view.drawing.to_m
    body = [shape for one in beside for shape in one.body]
    try:
        origin = origin_of(body, view.sheet.unit, plane, next(iter(hinges), None))
        return made_solids(view.body, view.openings, view.sheet.unit, plane, ends, origin)
    except InputError as error:
        raise error.at(view.file.path) from None


def _said(wall: str, view: View, made: list[dict]) -> Drawn:
    openings = sum("opening" in solid for solid in made)
    told: dict[str, Any] = {"wall": wall, "file": shown(view.drawing.file), "sha256": view.file.sha256}
    told |= {"solids": len(made) - openings, "openings": openings}
    if not view.sheet.unread:
        return Drawn(view.drawing.file, view.file.sha256, notice("drawing_read", **told))
    left = ", ".join(map(str, view.sheet.unread[:MAX_LAYERS_NAMED]))
    return Drawn(view.drawing.file, view.file.sha256, notice("drawing_read_in_part", left=left, **told))


def select_shapes(sheet: Sheet, drawing: Drawing) -> tuple[list[Shape], list[Shape]]:
    """(shapes of the body, of openings) on the layers a drawing names. Raises InputError."""
    names = {layer.casefold(): layer for layer in sheet.layers}
    for layer in (*drawing.layers, *drawing.opening_layers):
        if layer.casefold() not in names:
            known = tuple(sheet.layers[:MAX_LAYERS_NAMED])
            raise InputError("drawing_layer", layer=layer, known=known)
    body, openings = ({layer.casefold() for layer in layers} for layers in (drawing.layers, drawing.opening_layers))
    if both := body & openings:
        raise InputError("drawing_layer_twice", layer=names[min(both)])
    if sheet.stated is None and drawing.unit is None:
        raise InputError("drawing_unit", key="unit", likely=sheet.unit)
    unread = [one for one in sheet.unread if one.is_ground and one.layer.casefold() in body | openings]
    if unread:
        raise InputError("drawing_unread", layer=unread[0].layer, n=unread[0].n, kind=unread[0].kind)
    scale = DRAWING_UNITS[sheet.unit]
    chosen = [[shape for shape in sheet.shapes if shape.layer.casefold() in layers] for layers in (body, openings)]
    if chosen[0]:
        _check_size(chosen[0], sheet.unit)  # gaps in a wrong unit are none
    gaps = [gap for gap in sheet.gaps if gap.layer.casefold() in body | openings]
    if gaps:
        gap = min(gaps, key=lambda one: one.size)
        x, y = (scale * number for number in gap.at)
        raise InputError("drawing_gap", layer=gap.layer, n=len(gaps), mm=1e3 * scale * gap.size, x=x, y=y)
    for layer in (*drawing.layers, *drawing.opening_layers):
        if not any(shape.layer.casefold() == layer.casefold() for shapes in chosen for shape in shapes):
            raise InputError("drawing_no_shape", layer=layer)
    return chosen[0], chosen[1]


def origin_of(body: Sequence[Shape], unit: str, plane: str, hinge: float | None) -> Point:
    """Point of a drawing that becomes s = 0, z = 0 [m]: x of the left edge of its body (in a section, of the edge of
    its base), y of its hinge line, or of the lowest point without one. Raises InputError."""
    scale = DRAWING_UNITS[unit]
    _check_size(body, unit)
    base = min(shape.extent[1] for shape in body) * scale if hinge is None else hinge
    solid = [part for shape in body for part in _above(shape, scale, base)]
    if not solid:
        top = max(shape.extent[3] for shape in body) * scale
        raise InputError("drawing_hinge", key="hinge_y_m", found=base, top=top)
    if plane == "section" and all(y > MIN_CORNER_DISTANCE for part in solid for _, y in part):
        raise InputError("drawing_section_floats", key="hinge_y_m")
    low = MIN_CORNER_DISTANCE if plane == "section" else math.inf
    leftmost = min(x for part in solid for x, _ in part)
    return min((x for part in solid for x, y in part if y <= low), default=leftmost), base


def made_solids(
    body: Sequence[Shape], openings: Sequence[Shape], unit: str, plane: str, ends: tuple[float, float], origin: Point
) -> list[dict]:
    """Shapes as [[wall.solid]] has them, from an origin of `origin_of`; an opening within another one is a part of it.
    Raises InputError. ends : along the normal of the plane [m]"""
    scale, (left, base) = DRAWING_UNITS[unit], origin
    solid = [part for shape in body for part in _above(shape, scale, base)]
    taken = [part for shape in openings for part in _above(shape, scale, base)]
    taken = [
        part
        for k, part in enumerate(taken)
        if not any(n != k and _is_within(part, other) and (n < k or part != other) for n, other in enumerate(taken))
    ]
    return [
        {
            "plane": plane,
            "polygon_m": [[round(x - left, CORNER_DECIMALS), y] for x, y in part],
            **({"from_m": ends[0]} if ends[0] else {}),
            "to_m": ends[1],
            **({"opening": True} if is_opening else {}),
        }
        for is_opening, parts in ((False, solid), (True, taken))
        for part in parts
    ]


def _check_size(body: Sequence[Shape], unit: str) -> None:
    size = largest(body)
    metres = size * DRAWING_UNITS[unit]
    if not MIN_WALL_SIZE <= metres <= MAX_WALL_SIZE:
        likely = likely_unit(size)
        if likely is None:
            raise InputError("drawing_size_of_none", key="unit", found=metres, unit=unit)
        raise InputError("drawing_size", key="unit", found=metres, unit=unit, likely=likely)


def _above(shape: Shape, scale: float, base: float) -> list[list[Point]]:
    """A shape in metres above the hinge, none of what is below it."""
    corners = [(round(scale * x, CORNER_DECIMALS), round(scale * y - base, CORNER_DECIMALS)) for x, y in shape.corners]
    x, y = shape.corners[0]
    here = {"layer": shape.layer, "x": scale * x, "y": scale * y}
    if len(corners) > MAX_CORNERS:
        raise InputError("drawing_corners", n=len(corners), most=MAX_CORNERS, **here)
    if (edges := crossing(corners)) is not None:
        x, y = shape.corners[edges[0] - 1]
        raise InputError("drawing_crosses", layer=shape.layer, x=scale * x, y=scale * y)
    parts = parts_above(corners, 0.0)
    return [rounded for part in parts if polygon_sums(rounded := _rounded(part)).area > MIN_CORNER_DISTANCE]


def _rounded(part: list[Point]) -> list[Point]:
    corners = [(round(x, CORNER_DECIMALS), round(y, CORNER_DECIMALS)) for x, y in part]
    return [corner for k, corner in enumerate(corners) if corner != corners[k - 1]]


def _is_within(part: Sequence[Point], other: Sequence[Point]) -> bool:
    return all(contains_point(other, corner) for corner in part)


def replace_solids(wall: Wall, made: Sequence[dict], sizes: bool) -> Wall:
    """A wall of these solids alone, which are of one plane and between the same ends. Raises InputError.

    sizes : height, base and length are theirs too; without it those that the wall does not give
    """
    solids = tuple(parse_section(Solid, solid, "solid", place("solid", n=n)) for n, solid in enumerate(made, start=1))
    body = [solid for solid in solids if not solid.opening]
    corners = [corner for solid in body for corner in solid.polygon_m]
    along = [s for s, _ in corners]
    across = [s for s, z in corners if z == 0.0] or along
    depth = body[0].to_m - body[0].from_m
    widths = (depth, max(along) - min(along)) if body[0].plane == "elevation" else (max(across) - min(across), depth)
    extents = {"height_m": max(z for _, z in corners), "thickness_m": widths[0], "length_m": widths[1]}
    given = {"height_m": wall.height_m, "thickness_m": wall.thickness, "length_m": wall.length_m}
    values: dict[str, Any] = {
        k: round(value, CORNER_DECIMALS) for k, value in extents.items() if sizes or given[k] is None
    }
    if "thickness_m" in values:
        others = ("slenderness_deg", "height_over_thickness", "radius_m", "inertia_over_mass_m2")
        values |= dict.fromkeys(others)
    return replace(wall, solid=solids, drawing=(), gable_m=None, openings=(), steps=(), out_of_plumb_m=None, **values)


def sum_of_solids(solids: Sequence[Solid], weight: float) -> tuple[float, Body]:
    """Area [m2] and sums of solids in elevation or section. weight : [kN/m3]"""
    parts = [
        Part(s.polygon_m, (s.from_m, s.to_m), ANGLES[s.plane], s.x0_m, (-1e3 if s.opening else 1e3) * weight, s.plane)
        for s in solids
    ]
    body = sum_of(tuple(parts))
    if not body.mass > 0.0:
        raise InputError("polygon_empty", key="solid")
    return math.fsum(math.copysign(polygon_sums(p.polygon).area, p.weight) for p in parts), body
