"""Sheets of three facades, drawn with ezdxf, and their outlines by shapely, each from its own description."""

import itertools
import math
from pathlib import Path

import ezdxf
from shapely import affinity
from shapely.geometry import Point, Polygon, box
from shapely.ops import unary_union

FINE = 512
"""Segments of a quarter of a circle where shapely draws one."""


def _disc(x: float, y: float, radius: float):
    return Point(x, y).buffer(radius, quad_segs=FINE)


def _arched(x: float, y: float, width: float, springing: float):
    """A window with a round arch, its lower left corner at (x, y)."""
    head = _disc(x + 0.5 * width, y + springing, 0.5 * width)
    return unary_union([box(x, y, x + width, y + springing), head])


def _save(document, path: Path) -> Path:
    document.saveas(path)
    return path


def church(path: Path):
    """A gabled front in mm: an arched portal down to the ground, a rose window, two oculi, a hatch and dimensions on
    layers of their own, the ground at y = 12 500. Returns (body, openings) in m, z above the ground."""
    document = ezdxf.new("R2010")
    document.units = ezdxf.units.MM
    space, y = document.modelspace(), 12_500.0

    def on(layer: str) -> dict:
        return {"layer": layer}

    outline = [(0, y - 800), (9000, y - 800), (9000, y + 8000), (4500, y + 11000), (0, y + 8000)]
    space.add_lwpolyline(outline, close=True, dxfattribs=on("MURATURA"))
    portal = [(3500, y - 800, 0), (5500, y - 800, 0), (5500, y + 2500, 1.0), (3500, y + 2500, 0)]
    space.add_lwpolyline(portal, format="xyb", close=True, dxfattribs=on("FORI"))
    space.add_circle((4500, y + 6500), 1250, dxfattribs=on("ROSONE"))
    space.add_circle((4500, y + 6500), 400, dxfattribs=on("ROSONE"))  # its inner ring: the opening counts once
    for x in (1500, 7500):
        space.add_ellipse((x, y + 6000), major_axis=(0, 700), ratio=0.6, dxfattribs=on("FORI"))
    hatch = space.add_hatch(dxfattribs=on("CAMPITURA"))
    hatch.paths.add_polyline_path(outline, is_closed=True)
    space.add_line((-500, y), (9500, y), dxfattribs=on("QUOTE"))
    space.add_text("+0.00", dxfattribs=on("QUOTE"))
    body = Polygon([(0, 0), (9, 0), (9, 8), (4.5, 11), (0, 8)])
    oculi = [affinity.scale(_disc(x, 6.0, 0.7), 0.6, 1.0) for x in (1.5, 7.5)]
    return _save(document, path), body, unary_union([_arched(3.5, 0.0, 2.0, 2.5), _disc(4.5, 6.5, 1.25), *oculi])


def palace(path: Path):
    """A front in cm whose header says no unit, its outline of lines and one arc, windows as blocks: arched, mirrored,
    in an array, one within another block, each with a frame drawn within."""
    document = ezdxf.new("R2000", units=0)
    space, walls = document.modelspace(), {"layer": "Pareti"}
    corners = [(1000, 500), (1000, 0), (2200, 0), (2200, 500)]
    for start, end in itertools.pairwise(corners):
        space.add_line(start, end, dxfattribs=walls)
    half = math.degrees(math.asin(600.0 / 750.0))  # of a segment 300 high over 1200
    space.add_arc((1600, 500 - 450), 750.0, 90 - half, 90 + half, dxfattribs=walls)
    window = document.blocks.new("FINESTRA")
    window.add_lwpolyline([(0, 0), (120, 0), (120, 100, 1.0), (0, 100)], format="xyb", close=True)
    window.add_lwpolyline([(10, 10), (110, 10), (110, 90), (10, 90)], close=True)
    bay = document.blocks.new("CAMPATA")
    bay.add_blockref("FINESTRA", (0, 0))
    openings = {"layer": "Finestre"}
    space.add_blockref("FINESTRA", (1100, 100), dxfattribs=openings | {"column_count": 2, "column_spacing": 300})
    space.add_blockref("CAMPATA", (2100, 100), dxfattribs=openings | {"xscale": -1})
    space.add_blockref("FINESTRA", (1600, 420), dxfattribs=openings | {"rotation": 90, "xscale": 0.5})
    crowned = _disc(6.0, 0.5, 7.5).intersection(box(0, 5, 12, 9))
    arched = _arched(0.0, 0.0, 1.2, 1.0)
    flat = affinity.scale(arched, 0.5, 1.0, origin=(0, 0))
    turned = affinity.translate(affinity.rotate(flat, 90, origin=(0, 0)), 6.0, 4.2)
    mirrored = affinity.translate(affinity.scale(arched, -1.0, 1.0, origin=(0, 0)), 11.0, 1.0)
    rows = [affinity.translate(arched, x, 1.0) for x in (1.0, 4.0)]
    return _save(document, path), unary_union([box(0, 0, 12, 5), crowned]), unary_union([*rows, mirrored, turned])


def nave(path: Path):
    """The section of a wall in m, in the format of R12, which states no unit: thick below and thin above with a hollow
    on an arc, its base at y = 3; a vault left open in a layer of its own."""
    document = ezdxf.new("R12")
    space = document.modelspace()
    below = [(20.0, 3.0), (20.9, 3.0), (20.9, 7.0), (20.0, 7.0)]
    above = [(20.0, 7.0, 0.0), (20.7, 7.0, 0.0), (20.7, 11.0, -0.5), (20.7, 11.6, 0.0), (20.0, 11.6, 0.0)]
    space.add_polyline2d(below, close=True, dxfattribs={"layer": "SEZIONE"})
    space.add_polyline2d(above, format="xyb", close=True, dxfattribs={"layer": "sezione"})
    space.add_arc((24.0, 7.0), 3.1, 90, 180, dxfattribs={"layer": "VOLTA"})
    radius = (0.15**2 + 0.3**2) / (2.0 * 0.15)
    bitten = _disc(0.7 - 0.15 + radius, 8.3, radius)
    return _save(document, path), unary_union([box(0, 0, 0.9, 4), box(0, 4, 0.7, 8.6).difference(bitten)]), None
