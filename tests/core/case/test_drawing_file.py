"""A wall from a drawing: areas and centroids against shapely, the same wall as solids, refusals in a sentence."""

import hashlib
import itertools
import json
import math
import random
import re
import tracemalloc

import pytest

ezdxf = pytest.importorskip("ezdxf", reason="without the group dxf")
shapely = pytest.importorskip("shapely", reason="no wheel of shapely")

from ezdxf.xclip import XClip  # noqa: E402
from hypothesis import given, settings  # noqa: E402
from hypothesis import strategies as st  # noqa: E402
from shapely.geometry import Polygon, box  # noqa: E402

from app import __main__ as program  # noqa: E402
from app.terminal.inspection import inspect  # noqa: E402
from core.case import drawing_file, drawing_outlines  # noqa: E402
from core.case.drawing_file import DRAWING_TOLERANCE, DxfFile, Unread, likely_unit  # noqa: E402
from core.case.drawing_outlines import arc, join_lines, parts_above  # noqa: E402
from core.case.drawn_solids import expand_drawings, replace_solids  # noqa: E402
from core.case.problems import find_problems  # noqa: E402
from core.case.reader import read_case  # noqa: E402
from core.case.rules import parse_case, parse_draft, parse_wall  # noqa: E402
from core.case.writer import dumps, table_of  # noqa: E402
from core.errors import InputError, OutputError  # noqa: E402
from core.wall.body import crossing, point_within, polygon_sums  # noqa: E402
from tests.conftest import ROOT  # noqa: E402
from tests.core.case import sheets  # noqa: E402

WALL = """
[[wall]]
name = "facade"
height_m = {height}
thickness_m = {thickness}
length_m = {length}
unit_weight_kn_m3 = 20.0
mechanism = "one_sided"
base_z_m = 0.0
"""

SHEETS = {
    "church": (
        {"height": 10.9, "thickness": 0.6, "length": 9.0},
        'layers = "MURATURA"\nopening_layers = ["FORI", "rosone"]\nplane = "elevation"\nto_m = 0.6\nhinge_y_m = 12.5',
    ),
    "palace": (
        {"height": 7.9, "thickness": 0.5, "length": 12.0},
        'layers = ["Pareti"]\nopening_layers = ["Finestre"]\nunit = "cm"\nplane = "elevation"\nto_m = 0.5',
    ),
    "nave": (
        {"height": 8.5, "thickness": 0.9, "length": 5.0},
        'layers = "SEZIONE"\nunit = "m"\nplane = "section"\nto_m = 5.0\nhinge_y_m = 3.0',
    ),
}


def written(folder, name, drawing=None, **more):
    """The case of a sheet and what shapely says of it."""
    sizes, keys = SHEETS[name]
    path, body, openings = getattr(sheets, name)(folder / f"{name}.dxf")
    case = folder / f"{name}.toml"
    text = WALL.format(**(sizes | more)) + f'[[wall.drawing]]\nfile = "{path.name}"\n{drawing or keys}\n'
    case.write_text(text)
    return case, body if openings is None else body.difference(openings)


def area_of(solids):
    """The solids of a wall by shapely."""
    body = shapely.union_all([Polygon(s.polygon_m) for s in solids if not s.opening])
    return body.difference(shapely.union_all([Polygon(s.polygon_m) for s in solids if s.opening]))


@pytest.mark.shows("bodies.drawing")
@pytest.mark.parametrize("name", SHEETS)
def test_that_area_and_centroid_are_those_of_shapely(tmp_path, name):
    """By shapely from its own description, within the tolerance of an arc along the outline; by shapely from the
    corners exactly, so that the body weighs what was drawn."""
    case, drawn = written(tmp_path, name)
    (wall,) = read_case(case).wall
    read = area_of(wall.solid)
    assert abs(read.area - drawn.area) <= DRAWING_TOLERANCE * drawn.length
    assert read.hausdorff_distance(drawn) <= 1.5 * DRAWING_TOLERANCE
    assert math.dist(read.centroid.coords[0], drawn.centroid.coords[0]) <= DRAWING_TOLERANCE
    depth, body = wall.solid[0].to_m, wall.in_si.body
    assert body.mass * 9.80665 == pytest.approx(20e3 * depth * read.area, rel=1e-9)
    assert body.centroid[1] == pytest.approx(read.centroid.y, rel=1e-9)
    if wall.solid[0].plane == "section":
        assert body.centroid[0] == pytest.approx(read.centroid.x, rel=1e-9)


def test_that_a_ring_within_an_opening_and_a_frame_within_a_window_count_once(tmp_path):
    openings = {name: read_case(written(tmp_path, name)[0]).wall[0].solid for name in ("church", "palace")}
    assert {name: sum(solid.opening for solid in solids) for name, solids in openings.items()} == {
        "church": 4,
        "palace": 4,
    }


@pytest.mark.shows("bodies.drawing")
def test_that_a_batch_from_a_drawing_is_that_of_its_solids(tmp_path, capsys):
    """And its file is named by its hash, in the JSON and in the sheet Input."""
    case, _ = written(tmp_path, "church")
    demand = "[demand]\nag_g = 0.2\nsoil_factor = 1.2\n"
    case.write_text(case.read_text() + demand)
    solids = tmp_path / "solids.toml"
    solids.write_text(dumps(read_case(case)))
    assert "drawing" not in solids.read_text()
    for path in (case, solids):
        assert program.main(["--batch", str(path), "--quiet"]) == 0
    drawn, plain = (json.loads(path.with_suffix(".json").read_text()) for path in (case, solids))
    assert drawn["walls"] == plain["walls"] and drawn["verdicts"] == plain["verdicts"] and drawn["walls"]
    assert drawn["case"] == plain["case"] and drawn["case_sha256"] != plain["case_sha256"]
    digest = hashlib.sha256((tmp_path / "church.dxf").read_bytes()).hexdigest()
    assert [(one["wall"], one["file"], one["sha256"]) for one in drawn["drawings"]] == [
        ("facade", "church.dxf", digest)
    ]
    assert "drawings" not in plain
    import openpyxl

    book = openpyxl.load_workbook(case.with_suffix(".xlsx"))
    said = [str(cell.value) for sheet in book for row in sheet.iter_rows() for cell in row if cell.value]
    assert any(digest in text and "1 solids and 4 openings" in text for text in said)


def test_that_a_drawing_that_changed_is_another_case(tmp_path):
    case, _ = written(tmp_path, "church")
    before = read_case(case)
    document = ezdxf.readfile(tmp_path / "church.dxf")
    document.modelspace().query("CIRCLE").first.dxf.radius = 1000.0
    document.saveas(tmp_path / "church.dxf")
    after = read_case(case)
    assert after.sha256 != before.sha256
    assert area_of(after.wall[0].solid).area > area_of(before.wall[0].solid).area + 1.0


def test_that_solids_and_drawings_stand_beside_each_other_and_variants_take_both(tmp_path):
    case, _ = written(tmp_path, "nave", length=5.0)
    case.write_text(
        case.read_text()
        + '[[wall.solid]]\nplane = "section"\npolygon_m = [[0.9, 0], [1.2, 0], [1.2, 2], [0.9, 2]]\nto_m = 5.0\n'
        + '[[wall]]\nvariant_of = "facade"\nheight_m = 8.0\n'
    )
    as_is, designed = read_case(case).wall
    assert len(as_is.solid) == 3 and designed.solid == as_is.solid and designed.height_m == 8.0


def test_that_a_draft_keeps_its_drawing_and_says_what_is_missing(tmp_path):
    table = {
        "wall": [{"name": "w", "drawing": [{"file": "none.dxf", "layers": "A", "plane": "elevation", "to_m": 0.5}]}]
    }
    draft = parse_draft(table)
    assert draft.wall[0].drawing[0].layers == ("A",)
    assert parse_draft(table_of(draft)).wall == draft.wall
    whole = {"wall": [table["wall"][0] | {"height_m": 5.0, "thickness_m": 0.5, "mechanism": "one_sided"}]}
    with pytest.raises(InputError, match="the drawing none.dxf has not been read"):
        parse_case(whole)
    assert any("none.dxf has not been read" in str(error) for error in find_problems(parse_draft(whole)))


def sheet(path, draw, units=6, version="R2010"):
    document = ezdxf.new(version, units=units)
    draw(document.modelspace())
    document.saveas(path)
    return path


def rectangle(space, x=0.0, y=0.0, width=6.0, height=5.0, layer="A", **keys):
    corners = [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]
    space.add_lwpolyline(corners, close=True, dxfattribs={"layer": layer}, **keys)


def refused(folder, draw, keys="", units=6, layers='"A"'):
    sheet(folder / "d.dxf", draw, units)
    case = folder / "case.toml"
    sizes = {"height": 5.0, "thickness": 0.5, "length": 6.0}
    case.write_text(
        WALL.format(**sizes)
        + f'[[wall.drawing]]\nfile = "d.dxf"\nlayers = {layers}\nplane = "elevation"\nto_m = 0.5\n{keys}\n'
    )
    try:
        read_case(case)
    except InputError as error:
        assert str(error).startswith(f'{case}: wall "facade": ') and "\n" not in str(error)
        error.text("it")
        return error.code, str(error)
    return None, ""


def _nothing(space):
    pass


def _open(space):
    rectangle(space)
    space.add_lwpolyline([(1, 1), (2, 1), (2, 2), (1, 2), (1, 1.012)], dxfattribs={"layer": "A"})


def _lines_with_a_gap(space):
    corners = [(0, 0), (6, 0), (6, 5), (0, 5), (0, 0.25)]
    for start, end in itertools.pairwise(corners):
        space.add_line(start, end, dxfattribs={"layer": "A"})


def _millimetres_as_metres(space):
    """Its last outline is open by a tenth of a millimetre, which in m is more than may be."""
    rectangle(space, width=6000.0, height=5000.0)
    space.add_lwpolyline([(10, 10), (20, 10), (20, 20), (10, 10.1)], dxfattribs={"layer": "A"})


def _bow_tie(space):
    space.add_lwpolyline([(0, 0), (6, 5), (6, 0), (0, 4)], close=True, dxfattribs={"layer": "A"})


def _twice(space):
    rectangle(space)
    rectangle(space, 1.0, 1.0, 1.0, 1.0)


def _one_hook_within_another(space):
    """The mean of the corners of a hook is in neither."""
    for gap in (0.0, 0.1):
        hook = [(0, 0), (6, 0), (6, 5), (0, 5), (0, 4.5), (5.5, 4.5), (5.5, 0.5), (0, 0.5)]
        inner = [(gap, gap), (6 - gap, gap), (6 - gap, 5 - gap), (gap, 5 - gap), (gap, 4.5 + gap)]
        inner += [(5.5 + gap, 4.5 + gap), (5.5 + gap, 0.5 - gap), (gap, 0.5 - gap)]
        space.add_lwpolyline(inner if gap else hook, close=True, dxfattribs={"layer": "A"})


def _jagged(space):
    teeth = [(0.002 * k, 5.0 - 0.5 * (k % 2)) for k in range(2400)]
    space.add_lwpolyline([(4.8, 0), *reversed(teeth), (0, 0)], close=True, dxfattribs={"layer": "A"})


def _windows_that_overlap(space):
    rectangle(space)
    rectangle(space, 1.0, 1.0, 1.0, 1.0, layer="O")
    rectangle(space, 1.5, 1.5, 1.0, 1.0, layer="O")


OPENINGS = 'opening_layers = "O"'


@pytest.mark.shows("bodies.drawing_refused")
@pytest.mark.parametrize(
    ("draw", "more", "code", "words"),
    [
        (_open, {}, "drawing_gap", "open by 12 mm at x = 1 m, y = 1"),
        (_lines_with_a_gap, {}, "drawing_gap", "open by 250 mm at x = 0 m, y = 0"),
        (_millimetres_as_metres, {}, "drawing_size", "the likely unit is mm"),
        (_bow_tie, {}, "drawing_crosses", "the layer A crosses itself"),
        (_nothing, {"layers": '"0"'}, "drawing_no_shape", "no closed shape on the layer 0"),
        (rectangle, {"layers": '"MURI"'}, "drawing_layer", "no layer MURI; there are 0, A, Defpoints"),
        (rectangle, {"keys": 'opening_layers = "a"'}, "drawing_layer_twice", "layer A is given for the body and"),
        (rectangle, {"units": 0}, "drawing_unit", "give unit (by its size m)"),
        (
            lambda space: rectangle(space, width=6000.0, height=7000.0),
            {},
            "drawing_size",
            "the wall is 7e+03 m large: the likely unit is mm",
        ),
        (rectangle, {"units": 4}, "drawing_size", "in the unit mm the wall is 0.006 m large: the likely unit is m"),
        (lambda space: rectangle(space, width=1e9), {}, "drawing_size_of_none", "in no unit it has the size"),
        (rectangle, {"keys": "hinge_y_m = 7.0"}, "drawing_hinge", "above hinge_y_m = 7 m: its top is at y = 5 m"),
        (_jagged, {}, "drawing_corners", "has 2402 corners (up to 2000)"),
        (_twice, {}, "solids_overlap", "two solids of solid in parallel planes overlap"),
        (_one_hook_within_another, {}, "solids_overlap", "overlap"),
        (_windows_that_overlap, {"keys": OPENINGS}, "openings_overlap", "taken away twice"),
        (
            lambda space: (rectangle(space), rectangle(space, 5.5, 1.0, 1.0, 1.0, layer="O")),
            {"keys": OPENINGS},
            "opening_outside",
            "is not within one solid",
        ),
        (rectangle, {"keys": "to = 1"}, "unknown_key_near", "to"),
        (rectangle, {"layers": "3"}, "not_accepted", "text of up to 500 characters, or a list"),
    ],
)
def test_that_what_is_no_wall_is_refused_in_a_sentence(tmp_path, draw, more, code, words):
    found, said = refused(tmp_path, draw, **more)
    assert (found, words in said) == (code, True), said


def test_that_what_is_sound_beside_each_refusal_is_read(tmp_path):
    """The millimetre an outline may be open by, the unit of the key against that of the header, walls in feet."""

    def nearly(space):
        space.add_lwpolyline([(0, 0), (6, 0), (6, 5), (0, 5), (0, 0.0009)], dxfattribs={"layer": "A"})

    assert refused(tmp_path, nearly) == (None, "")
    assert refused(tmp_path, rectangle, 'unit = "m"', units=4) == (None, "")
    feet = lambda space: rectangle(space, width=6.0 / 0.3048, height=5.0 / 0.3048)  # noqa: E731
    assert refused(tmp_path, feet, units=2) == (None, "")
    assert refused(tmp_path, rectangle, "hinge_y_m = -0.001")[0] == "hinge_off_body"


def test_that_a_door_to_the_ground_and_piers_below_the_hinge_are_cut(tmp_path):
    """Of a front whose lowest part is two piers, cut within the piers, each stands for itself."""
    front = [(0, 0), (2, 0), (2, 3), (4, 3), (4, 0), (6, 0), (6, 5), (0, 5)]
    drawing = sheet(tmp_path / "d.dxf", lambda space: space.add_lwpolyline(front, close=True))
    (shape,) = DxfFile(drawing).sheet().shapes
    parts = parts_above([(x, z) for x, z in shape.corners], 1.0)
    assert len(parts) == 1 and polygon_sums(parts[0]).area == pytest.approx(20.0)
    (whole,) = parts_above(front, -1.0)
    assert whole == front
    upside_down = [(x, 5 - z) for x, z in front]
    legs = parts_above(upside_down, 3.0)
    assert sorted(polygon_sums(leg).area for leg in legs) == pytest.approx([4.0, 4.0])
    assert parts_above(front, 5.0) == []


@settings(deadline=None, max_examples=80)
@given(st.lists(st.tuples(st.floats(-5, 5), st.floats(-5, 5)), min_size=3, max_size=9), st.floats(-4, 4))
def test_that_the_part_above_a_line_is_that_of_shapely(corners, level):
    corners = [(round(x, 2), round(y, 2)) for x, y in corners]
    level = round(level, 1)
    drawn = Polygon(corners)
    if not drawn.is_valid or drawn.area < 1e-3 or crossing(corners):
        return
    above = drawn.intersection(box(-9, level, 9, 9))
    parts = [Polygon(part) for part in parts_above(corners, level)]
    assert sum(part.area for part in parts) == pytest.approx(above.area, abs=1e-9)
    assert shapely.union_all(parts).symmetric_difference(above).area < 1e-9
    assert drawn.buffer(1e-9).contains(shapely.Point(point_within(corners)))


@given(st.floats(-3.0, 3.0), st.floats(0.0, 6.28), st.floats(0.01, 100.0))
def test_that_a_bulge_is_divided_within_its_tolerance(bulge, turn, chord):
    start, end = (3.0, -2.0), (3.0 + chord * math.cos(turn), -2.0 + chord * math.sin(turn))
    points = [start, *arc(start, end, bulge, 1e-3)]
    assert points[-1] == end
    if len(points) < 3:
        assert abs(bulge) * chord <= 2e-3
        return
    sagitta = 0.5 * bulge * chord
    radius = (0.25 * chord**2 + sagitta**2) / (2.0 * abs(sagitta))
    centre = ezdxf.math.bulge_center(start, end, bulge)
    assert all(math.dist(point, centre) == pytest.approx(radius, rel=1e-9) for point in points)
    middles = [(0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])) for a, b in itertools.pairwise(points)]
    assert all(radius - math.dist(middle, centre) <= 1.001e-3 for middle in middles)


def test_that_lines_meet_end_to_end_and_nowhere_else():
    square = [[(0.0, 0.0), (1.0, 0.0)], [(1.0, 1.0), (1.0, 0.0005)], [(1.0, 1.0), (0.0, 1.0)], [(0.0, 0.0), (0.0, 1.0)]]
    (outline,), loose = join_lines(square, 1e-3)
    assert not loose and polygon_sums(outline).area == pytest.approx(1.0, abs=1e-3)
    closed, loose = join_lines([*square, [(1.0, 1.0), (2.0, 2.0)]], 1e-3)
    assert len(closed) == len(loose) == 1
    closed, loose = join_lines([*square, [(1.0, 1.0), (0.0, 0.0)]], 1e-3)  # three ends at two corners: which two?
    assert closed == [] and len(loose) == 3


@pytest.mark.parametrize(("radius", "is_read"), [(0.9e-3, False), (1.1e-3, True), (9_990.0, True), (10_010.0, False)])
def test_that_a_circle_is_read_from_a_millimetre_to_10_km(tmp_path, radius, is_read):
    found = DxfFile(sheet(tmp_path / "d.dxf", lambda space: space.add_circle((0, 0), radius))).sheet()
    assert (len(found.shapes), len(found.unread)) == ((1, 0) if is_read else (0, 1))


def test_that_a_rectangle_of_lines_drawn_over_is_one_shape_without_a_gap(tmp_path):
    corners = [(0, 0), (6, 0), (6, 5), (0, 5)]

    def draw(space):
        for one, other in zip(corners, corners[1:] + corners[:1], strict=True):
            space.add_line(one, other)
        space.add_line(corners[2], corners[1])
        space.add_line(corners[0], corners[0])

    found = DxfFile(sheet(tmp_path / "d.dxf", draw)).sheet()
    assert [shape.extent for shape in found.shapes] == [(0.0, 0.0, 6.0, 5.0)] and not found.gaps


@pytest.mark.parametrize(("length", "specks", "gaps"), [(0.0003, 1, 0), (0.0009, 1, 0), (0.002, 0, 1)])
def test_that_a_stroke_shorter_than_the_tolerance_is_left_out_and_counted(tmp_path, length, specks, gaps):
    """One of 0.3 mm refused a whole facade: "open by 0 mm"."""

    def draw(space):
        space.add_lwpolyline([(0, 0), (6, 0), (6, 5), (0, 5)], close=True)
        space.add_line((8.0, 1.0), (8.0 + length, 1.0))

    found = DxfFile(sheet(tmp_path / "d.dxf", draw)).sheet()
    assert len(found.shapes) == 1 and len(found.gaps) == gaps
    assert [(one.kind, one.n) for one in found.unread] == [("speck", 1)] * specks


def test_that_a_hatch_without_an_outline_is_a_shape(tmp_path):
    def draw(space):
        hatch = space.add_hatch(dxfattribs={"layer": "A"})
        hatch.paths.add_polyline_path([(0, 0), (6, 0), (6, 5), (0, 5)], is_closed=True)

    found = DxfFile(sheet(tmp_path / "d.dxf", draw)).sheet()
    assert [shape.extent for shape in found.shapes] == [(0.0, 0.0, 6.0, 5.0)] and not found.gaps


def test_that_a_periodic_spline_is_divided_no_finer_than_its_tolerance_asks(tmp_path):
    """Through 32 chords it would be off by 1.05 mm: h^2 / 8 of its second derivative, (side, side) at a corner and
    (-side, side) at the next, in the middle of the first of the 8 chords of a span (h = 1/8)."""
    side = 8 * 64 * 1.05 * DRAWING_TOLERANCE / math.hypot(1.0, 1.0 - 1.0 / 8.0)

    def draw(space):
        spline = space.add_spline(dxfattribs={"layer": "S"})
        spline.set_closed([(0, 0, 0), (side, 0, 0), (side, side, 0), (0, side, 0)], degree=3)

    ((_, points),) = DxfFile(sheet(tmp_path / "d.dxf", draw)).sheet().lines
    fourth = points[::4]
    off = max(_off_chord(points[k], fourth[k // 4], fourth[k // 4 + 1]) for k in range(2, len(points) - 4, 4))
    assert off == pytest.approx(1.05 * DRAWING_TOLERANCE, rel=2e-3)  # across the chord, not to its middle


def _off_chord(point, start, end) -> float:
    across = (end[0] - start[0]) * (point[1] - start[1]) - (end[1] - start[1]) * (point[0] - start[0])
    return abs(across) / math.dist(start, end)


@pytest.mark.parametrize("depth", [20, 21])
def test_that_a_block_within_20_others_is_read_and_one_within_more_is_named(tmp_path, depth):
    document = ezdxf.new("R2010", units=6)
    area(document.blocks.new("B0"), 0.0, 6.0, 0.0, 5.0)
    for k in range(1, depth):
        document.blocks.new(f"B{k}").add_blockref(f"B{k - 1}", (0, 0), dxfattribs={"layer": "IN"})
    document.modelspace().add_blockref(f"B{depth - 1}", (0, 0))
    document.saveas(tmp_path / "d.dxf")
    found = DxfFile(tmp_path / "d.dxf").sheet()
    shapes, unread = [shape.layer for shape in found.shapes], found.unread
    assert (shapes, unread) == ((["M"], ()) if depth == 20 else ([], (Unread("IN", "INSERT", 1),)))


def test_that_references_that_are_not_read_are_counted(tmp_path):
    document = ezdxf.new("R2010", units=6)
    document.add_xref_def("other.dxf", "OTHER")
    for x in (0, 5, 9):
        document.modelspace().add_blockref("OTHER", (x, 0), dxfattribs={"layer": "M"})
    document.saveas(tmp_path / "d.dxf")
    assert DxfFile(tmp_path / "d.dxf").sheet().unread == (Unread("M", "XREF", 3),)


def test_that_blocks_are_on_the_layer_of_their_reference_and_mirrored_ones_are_not_turned(tmp_path):
    document = ezdxf.new("R2010", units=6)
    block = document.blocks.new("B")
    block.add_lwpolyline([(1, 0), (2, 0), (2, 1, 1.0), (1, 1)], format="xyb", close=True)
    block.add_lwpolyline([(1, 3), (2, 3), (2, 4)], close=True, dxfattribs={"layer": "OWN"})
    document.modelspace().add_blockref("B", (10, 0), dxfattribs={"layer": "A", "xscale": -1})
    document.saveas(tmp_path / "d.dxf")
    found = {shape.layer: shape.extent for shape in DxfFile(tmp_path / "d.dxf").sheet().shapes}
    assert found["A"] == pytest.approx((8.0, 0.0, 9.0, 1.5), abs=DRAWING_TOLERANCE)
    assert found["OWN"] == pytest.approx((8.0, 3.0, 9.0, 4.0))


def test_that_borders_of_hatches_are_shapes_and_one_with_its_outline(tmp_path):
    def draw(space):
        rectangle(space)
        hatch = space.add_hatch(dxfattribs={"layer": "A"})
        hatch.paths.add_polyline_path([(0, 0), (6, 0), (6, 5), (0, 5)], is_closed=True)
        edges = space.add_hatch(dxfattribs={"layer": "B"}).paths.add_edge_path()
        edges.add_line((0, 0), (2, 0))
        edges.add_arc((1, 0), 1.0, 0.0, 180.0)

    shapes = DxfFile(sheet(tmp_path / "d.dxf", draw)).sheet().shapes
    areas = {shape.layer: polygon_sums(shape.corners).area for shape in shapes}
    assert len(shapes) == 2
    assert areas == pytest.approx({"A": 30.0, "B": 0.5 * math.pi}, abs=DRAWING_TOLERANCE * math.pi)


def test_that_the_unit_of_a_drawing_that_says_none_is_guessed_by_its_size(tmp_path):
    for size, unit in ((7.0, "m"), (700.0, "cm"), (7000.0, "mm"), (20.0, "m")):
        drawing = sheet(tmp_path / "d.dxf", lambda space, size=size: rectangle(space, width=size), units=0)
        found = DxfFile(drawing).sheet()
        assert (found.stated, found.unit) == (None, unit)
    with open(tmp_path / "r12.dxf", "w") as stream:  # no header at all: nothing is stated
        stream.write("0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\nA\n10\n0\n20\n0\n40\n350\n0\nENDSEC\n0\nEOF\n")
    found = DxfFile(tmp_path / "r12.dxf").sheet()
    assert (found.stated, found.unit, len(found.shapes)) == (None, "cm", 1)


@pytest.mark.parametrize(
    ("size", "unit"),
    [(0.79, None), (0.81, "m"), (79.0, "m"), (81.0, "cm"), (790.0, "cm"), (8100.0, "mm"), (79e3, "mm"), (81e3, None)],
)
def test_that_a_wall_is_taken_to_be_between_80_cm_and_80_m_large(size, unit):
    """The nearest to 8 m of the three units, none beyond a factor of ten."""
    assert likely_unit(size) == unit


@pytest.mark.shows("bodies.drawing_refused")
def test_that_the_limits_of_a_drawing_are_those_the_page_names(tmp_path):
    page = (ROOT / "resources" / "docs" / "case.md").read_text(encoding="utf-8")
    most_mb, most = re.search(r"one of more than (\d+) MB or ([\d ]+) entities", page).groups()
    path = tmp_path / "d.dxf"
    with open(path, "wb") as stream:
        stream.truncate(25_000_000)  # of zeros that take no place on the disk
    with pytest.raises(InputError, match=rf"25 MB are too large for the drawing of a wall \(up to {most_mb} MB\)"):
        DxfFile(path)
    array = ezdxf.new("R2010", units=6)
    array.blocks.new("B").add_circle((0, 0), 1)
    many = {"column_count": 400, "row_count": 251, "column_spacing": 1, "row_spacing": 1}
    array.modelspace().add_blockref("B", (0, 0), dxfattribs=many)
    array.saveas(path)
    with pytest.raises(InputError, match=f"more than {most.replace(' ', '')} entities"):
        DxfFile(path)


@pytest.mark.parametrize("kind", ["spline", "subclass"])
def test_that_an_entity_that_cannot_be_read_is_named_and_refuses_only_its_own_layer(tmp_path, kind):
    """A spline whose knots do not fit, or a polyline that does not say what it is, beside a wall: counted by layer and
    type; on the layer of the wall it may be wall, and is refused."""

    def draw(layer):
        def within(space):
            rectangle(space)
            if kind == "spline":
                spline = space.add_spline(dxfattribs={"layer": layer})
                spline.control_points, spline.knots = [(0, 0), (1, 1), (2, 0), (3, 1)], [0.0, 1.0, 2.0]
            else:
                rectangle(space, x=20.0, layer=layer)

        return within

    def break_it(layer):
        path = sheet(tmp_path / "d.dxf", draw(layer))
        lines = path.read_text(encoding="utf-8").splitlines()
        if kind == "subclass":
            last = max(k for k in range(1, len(lines)) if lines[k] == "AcDbPolyline")
            del lines[last - 1 : last + 1]
        path.write_text("\n".join([*lines, ""]), encoding="utf-8")
        return path

    path = break_it("FIORI")
    read = DxfFile(path).sheet("m")
    assert [shape.layer for shape in read.shapes] == ["A"]
    (left,) = read.unread
    assert left.layer == "FIORI" and left.n == 1 and "damaged" in left.kind
    broken = break_it("A")
    assert [one.layer for one in DxfFile(broken).sheet("m").unread] == ["A"]
    case = tmp_path / "case.toml"
    sizes = {"height": 5.0, "thickness": 0.5, "length": 6.0}
    entry = '[[wall.drawing]]\nfile = "d.dxf"\nlayers = "A"\nplane = "elevation"\nto_m = 0.5\n'
    case.write_text(WALL.format(**sizes) + entry)
    with pytest.raises(InputError, match="damaged"):
        read_case(case)


WORDS = [b"", b"0", b"-1", b"1e400", b"nan", b"SECTION", b"ENTITIES", b"POLYLINE", b"10", b"EOF", b"$INSUNITS"]


def test_that_hostile_files_are_refused_in_a_sentence(tmp_path, monkeypatch):
    """Empty, of random bytes, cut at any place, with lines changed, a DWG, too large, a folder, nothing at all."""
    whole = church_of(tmp_path)
    chance, path = random.Random(7), tmp_path / "x.dxf"

    def code_of(content: bytes):
        path.write_bytes(content)
        try:
            DxfFile(path).sheet("mm")
        except InputError as error:
            assert str(error).startswith(str(path)) and "\n" not in str(error)
            return error.code
        return None

    assert code_of(b"") == code_of(b"\0" * 4000) == code_of(b"EOF") == "drawing_damaged"
    assert code_of(b"AC1032" + chance.randbytes(3000)) == "drawing_dwg"
    assert all(code_of(chance.randbytes(chance.randrange(5000))) == "drawing_damaged" for _ in range(20))
    assert all(code_of(whole[: chance.randrange(len(whole) - 5)]) == "drawing_damaged" for _ in range(20))
    ended = (whole[: chance.randrange(len(whole))] + b"\n0\nEOF\n" for _ in range(40))
    assert {code_of(content) for content in ended} <= {None, "drawing_damaged"}
    binary = tmp_path / "b.dxf"
    ezdxf.readfile(tmp_path / "church.dxf").saveas(binary, fmt="bin")
    content = binary.read_bytes()
    assert code_of(content) is None
    assert {code_of(content[: chance.randrange(len(content))]) for _ in range(10)} <= {"drawing_damaged"}
    lines = whole.split(b"\n")
    for _ in range(40):
        changed = list(lines)
        for _ in range(chance.randrange(1, 30)):
            changed[chance.randrange(len(lines))] = chance.choice(WORDS)
        assert code_of(b"\n".join(changed)) in (None, "drawing_damaged", "drawing_too_much")
    monkeypatch.setattr(drawing_file, "MAX_DRAWING_BYTES", 1000)
    assert code_of(whole) == "drawing_too_large"
    for missing in (tmp_path / "none.dxf", tmp_path):
        with pytest.raises(InputError, match="there is no such drawing"):
            DxfFile(missing)


def church_of(folder) -> bytes:
    return sheets.church(folder / "church.dxf")[0].read_bytes()


@pytest.mark.parametrize("most", [2_000, pytest.param(drawing_file.MAX_ENTITIES, marks=pytest.mark.long)])
def test_that_blocks_without_an_end_are_refused(tmp_path, monkeypatch, most):
    monkeypatch.setattr(drawing_file, "MAX_ENTITIES", most)
    document = ezdxf.new("R2010", units=6)
    one, other = document.blocks.new("ONE"), document.blocks.new("OTHER")
    for block, name in ((one, "OTHER"), (other, "ONE")):
        for _ in range(3):
            block.add_blockref(name, (1, 0))
    document.modelspace().add_blockref("ONE", (0, 0))
    document.saveas(tmp_path / "d.dxf")
    with pytest.raises(InputError, match=f"more than {most} entities|damaged"):
        DxfFile(tmp_path / "d.dxf")
    array = ezdxf.new("R2010", units=6)
    array.blocks.new("B").add_circle((0, 0), 1)
    many = {"column_count": 30_000, "row_count": 30_000, "column_spacing": 1, "row_spacing": 1}
    array.modelspace().add_blockref("B", (0, 0), dxfattribs=many)
    array.saveas(tmp_path / "d.dxf")
    with pytest.raises(InputError, match=f"more than {most} entities"):
        DxfFile(tmp_path / "d.dxf")


def test_that_without_ezdxf_the_absence_is_said_before_the_run(tmp_path, monkeypatch):
    from core import packages

    case, _ = written(tmp_path, "church")
    monkeypatch.setattr(packages.importlib, "import_module", lambda name: exec("raise ImportError(name)"))
    with pytest.raises(OutputError, match=r"a drawing \(DXF\) needs .*ezdxf"):
        read_case(case)


@pytest.mark.shows("batch.inspect")
def test_that_inspect_lists_the_layers_of_a_drawing(tmp_path, capsys):
    church = sheets.church(tmp_path / "church.dxf")[0]
    nave = sheets.nave(tmp_path / "nave.dxf")[0]
    palace = sheets.palace(tmp_path / "palace.dxf")[0]
    assert program.main(["--inspect", str(church), str(nave), str(palace)]) == 0
    said = capsys.readouterr().out
    assert f"{church}: DXF R2010, unit mm\n" in said
    assert "  MURATURA: closed shapes 1, area 92.7 m², x 0 to 9 m, y 11.7 to 23.5 m\n" in said
    assert "  QUOTE: an outline open by 10000 mm at x = 9.5 m, y = 12.5 m\n" in said
    assert "  VOLTA: an outline open by 4384 mm" in said
    assert f"{palace}: DXF R2000, unit not stated, cm by the size\n" in said
    (tmp_path / "x.dxf").write_bytes(b"no drawing")
    assert program.main(["--inspect", str(tmp_path / "x.dxf")]) == 1
    assert "refused" in capsys.readouterr().err


def drawn(path, draw, layers="M", more=(), **keys):
    """The wall of a drawing in metres that `draw(space, document)` makes."""
    document = ezdxf.new("R2010")
    document.units = ezdxf.units.M
    draw(document.modelspace(), document)
    document.saveas(path / "d.dxf")
    own = {"file": "d.dxf", "layers": layers, "plane": "section", "to_m": 5.0} | keys
    table = {"name": "w", "mechanism": "one_sided", "height_m": 6.0, "thickness_m": 0.6, "length_m": 5.0}
    table |= {"unit_weight_kn_m3": 18.0, "drawing": [own, *more]}
    whole, read = expand_drawings({"title": "t", "wall": [table]}, path)
    return parse_case(whole).wall[0], read[0].notice


def area(space, x0, x1, y0, y1, layer="M"):
    space.add_lwpolyline([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], close=True, dxfattribs={"layer": layer})


def test_that_drawings_of_one_file_have_one_origin(tmp_path):
    """A wall and its cornice on two layers, as two drawings: the cornice stays where it is drawn."""

    def draw(space, document):
        area(space, 10.0, 10.6, 3.0, 8.5)
        area(space, 9.7, 10.6, 8.5, 9.0, "C")

    cornice = {"file": "d.dxf", "layers": "C", "plane": "section", "to_m": 5.0}
    apart, _ = drawn(tmp_path, draw, more=[cornice])
    together, _ = drawn(tmp_path, draw, layers=["M", "C"])
    assert sorted(s.polygon_m for s in apart.solid) == sorted(s.polygon_m for s in together.solid)
    assert apart.block() == together.block()
    with pytest.raises(InputError) as refused:
        drawn(tmp_path, draw, more=[cornice | {"hinge_y_m": 8.5}], hinge_y_m=3.0)
    assert refused.value.code == "drawing_two_origins"
    given, _ = drawn(tmp_path, draw, more=[cornice], hinge_y_m=3.0)
    assert given.block() == together.block()


def test_that_drawings_of_two_files_have_no_common_origin(tmp_path):
    other = ezdxf.new("R2010", units=6)
    area(other.modelspace(), 0.0, 0.9, 0.0, 0.5)
    other.saveas(tmp_path / "e.dxf")
    with pytest.raises(InputError) as refused:
        more = [{"file": "e.dxf", "layers": "M", "plane": "section", "to_m": 5.0}]
        drawn(tmp_path, lambda space, document: area(space, 0.0, 0.6, 0.0, 6.0), more=more)
    assert refused.value.code == "drawing_two_files"


@pytest.mark.parametrize("plane", ["elevation", "section"])
def test_that_the_depth_of_a_drawn_body_is_from_one_end_to_the_other(plane):
    """Of an elevation its thickness, of a section its length."""
    wall = parse_wall({"name": "w", "mechanism": "one_sided", "height_m": 3.0, "thickness_m": 0.3})
    corners = [[0.0, 0.0], [0.8, 0.0], [0.8, 5.0], [0.0, 5.0]]
    solid = {"plane": plane, "polygon_m": corners, "from_m": 0.125, "to_m": 0.625}
    drawn = replace_solids(wall, [solid], sizes=True)
    sizes = (0.5, 0.8) if plane == "elevation" else (0.8, 0.5)
    assert (drawn.height_m, drawn.thickness_m, drawn.length_m) == (5.0, *sizes)


@pytest.mark.parametrize("walls", [[3], ["drawing"], [None, {"name": "w"}], {"drawing": 1}])
def test_that_walls_that_are_no_tables_are_left_to_the_rules(tmp_path, walls):
    assert expand_drawings({"wall": walls}, tmp_path) == ({"wall": walls}, [])


def _region(space, document):
    space.add_region(dxfattribs={"layer": "M"}).sat = ("400 0 1 0",)


def _mesh(space, document):
    space.add_polyface(dxfattribs={"layer": "M"}) if hasattr(space, "add_polyface") else space.add_mesh(
        dxfattribs={"layer": "M"}
    )


def _mline(space, document):
    space.add_mline([(0, 0), (1, 0)], dxfattribs={"layer": "M"})


def _tilted(space, document):
    space.add_polyline3d([(0, 0, 0), (1, 0, 0), (1, 0, 2), (0, 0, 2)], close=True, dxfattribs={"layer": "M"})


def _upright(space, document):
    """A shape drawn in XZ."""
    attributes = {"layer": "M", "extrusion": (0, -1, 0)}
    space.add_lwpolyline([(0, 0), (1, 0), (1, 2), (0, 2)], close=True, dxfattribs=attributes)


def _reference(space, document):
    document.add_xref_def("other.dxf", "OTHER")
    space.add_blockref("OTHER", (0, 0), dxfattribs={"layer": "M"})


def _clipped(space, document):
    block = document.blocks.new("B")
    area(block, 0.0, 1.0, 0.0, 2.0)
    insert = space.add_blockref("B", (3, 0), dxfattribs={"layer": "M"})
    XClip(insert).set_block_clipping_path([(0, 0), (0.5, 1.0)])


LEFT = {
    "a region": _region,
    "a solid": lambda space, document: space.add_solid([(0, 0), (1, 0), (0, 1), (1, 1)], dxfattribs={"layer": "M"}),
    "a trace": lambda space, document: space.add_trace([(0, 0), (1, 0), (0, 1), (1, 1)], dxfattribs={"layer": "M"}),
    "a face": lambda space, document: space.add_3dface([(0, 0), (1, 0), (1, 1)], dxfattribs={"layer": "M"}),
    "a multiline": _mline,
    "a mesh": _mesh,
    "a tilted polyline": _tilted,
    "a shape in XZ": _upright,
    "a reference": _reference,
    "a clipped block": _clipped,
}


@pytest.mark.shows("bodies.drawing_refused")
@pytest.mark.parametrize("name", LEFT)
def test_that_what_may_be_wall_and_is_not_read_is_refused_on_a_chosen_layer(name, tmp_path):
    def draw(space, document):
        area(space, 0.0, 0.6, 0.0, 6.0)
        LEFT[name](space, document)

    with pytest.raises(InputError) as refused:
        drawn(tmp_path, draw)
    assert refused.value.code == "drawing_unread", refused.value


def test_that_what_is_hidden_is_not_read_and_all_that_is_not_read_is_named(tmp_path, capsys):
    def draw(space, document):
        area(space, 0.0, 0.6, 0.0, 6.0)
        space.add_lwpolyline([(2, 0), (3, 0), (3, 6)], close=True, dxfattribs={"layer": "M", "invisible": 1})
        document.layers.add("OFF").off()
        area(space, 0.6, 2.0, 0.0, 6.0, "OFF")
        space.add_text("H", dxfattribs={"layer": "M"})
        space.add_solid([(0, 0), (1, 0), (0, 1), (1, 1)], dxfattribs={"layer": "R"})

    wall, said = drawn(tmp_path, draw)
    assert wall.block().slenderness == pytest.approx(math.atan(0.1))
    for words in ("M: 1 invisible", "OFF: 1 hidden layer", "M: 1 TEXT", "R: 1 SOLID"):
        assert words in str(dict(said.values)["left"])
    assert inspect([tmp_path / "d.dxf"]) == 0
    assert "R: not read 1 SOLID" in capsys.readouterr().out
    with pytest.raises(InputError) as refused:
        drawn(tmp_path, draw, layers=["M", "OFF"])
    assert refused.value.code == "drawing_no_shape"


def test_that_a_flattened_block_and_a_periodic_spline_are_read(tmp_path):
    def draw(space, document):
        block = document.blocks.new("B")
        area(block, 0.0, 0.6, 0.0, 6.0)
        space.add_blockref("B", (0, 0), dxfattribs={"layer": "M", "zscale": 0.0})
        spline = space.add_spline(dxfattribs={"layer": "S"})
        spline.set_closed([(5, 0, 0), (6, 0, 0), (6, 1, 0), (5, 1, 0)], degree=3)

    wall, _ = drawn(tmp_path, draw)
    assert wall.block().slenderness == pytest.approx(math.atan(0.1))
    sheet = DxfFile(tmp_path / "d.dxf").sheet()
    assert [shape.layer for shape in sheet.shapes] == ["M", "S"] and not sheet.unread
    # a uniform cubic B-spline over a unit square, by its blending functions
    corners = [(5.0, 0.0), (6.0, 0.0), (6.0, 1.0), (5.0, 1.0)]
    points = []
    for k in range(4):
        p = [corners[(k + n) % 4] for n in range(4)]
        for t in (n / 400 for n in range(400)):
            share = ((1 - t) ** 3, 3 * t**3 - 6 * t**2 + 4, -3 * t**3 + 3 * t**2 + 3 * t + 1, t**3)
            points.append(tuple(sum(w * q[axis] for w, q in zip(share, p, strict=True)) / 6.0 for axis in (0, 1)))
    assert polygon_sums(sheet.shapes[1].corners).area == pytest.approx(Polygon(points).area, rel=3e-3)


def test_that_a_block_on_a_layer_that_is_off_is_shown_and_on_a_frozen_one_not(tmp_path):
    def draw(space, document):
        area(space, 0.0, 0.6, 0.0, 6.0)
        block = document.blocks.new("B")
        area(block, 0.0, 0.3, 0.0, 0.5, "M")
        area(block, 0.3, 0.6, 0.0, 0.5, "0")
        for name, x in (("OFF", 0.6), ("ICE", 2.0)):
            layer = document.layers.add(name)
            layer.off() if name == "OFF" else layer.freeze()
            space.add_blockref("B", (x, 0), dxfattribs={"layer": name})

    wall, said = drawn(tmp_path, draw)
    assert len(wall.solid) == 2 and "OFF: 1 hidden layer" in str(dict(said.values)["left"])


def test_that_a_section_that_stands_on_nothing_has_no_outer_face(tmp_path):
    more = [{"file": "d.dxf", "layers": "C", "plane": "section", "to_m": 5.0}]

    def draw(space, document):
        area(space, 0.0, 5.0, 30.0, 39.0)
        area(space, 19.6, 20.6, 39.0, 39.5, "C")

    with pytest.raises(InputError) as refused:
        drawn(tmp_path, draw, plane="elevation", to_m=0.6, more=[more[0] | {"hinge_y_m": 30.0}])
    assert refused.value.code == "drawing_section_floats"


def placed_often(model, fill, count: int) -> None:
    fill(model.doc.blocks.new("b"))
    for k in range(count):
        model.add_blockref("b", (k, 0))


def nested(model, depth: int) -> None:
    """Each block holds the one before a hundred times, as a grid, and twice."""
    grid = {"column_count": 10, "row_count": 10, "column_spacing": 1.0, "row_spacing": 1.0}
    model.doc.blocks.new("b0").add_line((0, 0), (1, 1))
    for k in range(1, depth):
        block = model.doc.blocks.new(f"b{k}")
        for _ in range(2):
            block.add_blockref(f"b{k - 1}", (0, 0), grid)
    model.add_blockref(f"b{depth - 1}", (0, 0))


HOSTILE = {
    "a curve of a thousand points a span": lambda model, at: setattr(
        model.add_spline(), "control_points", [(*at(), 0.0) for _ in range(100)]
    ),
    "lines that meet at one point": lambda model, at: [model.add_line(at(), (1.0, 1.0)) for _ in range(1_000)],
    "arcs on long chords": lambda model, at: model.add_lwpolyline([(*at(), 0.9) for _ in range(500)], format="xyb"),
    "a block of many corners placed often": lambda model, at: placed_often(
        model, lambda block: block.add_lwpolyline([at() for _ in range(3_000)]), 200
    ),
    "blocks in blocks": lambda model, at: nested(model, 12),
    "lines within a gap": lambda model, at: [
        model.add_line(*([c * 3e-6 for c in at()] for _ in range(2))) for _ in range(1_000)
    ],
}


@pytest.mark.shows("doors.bombs")
@pytest.mark.parametrize("kind", HOSTILE)
@pytest.mark.parametrize("most", [4_000, pytest.param(10_000, marks=pytest.mark.long)])
def test_that_a_hostile_drawing_takes_no_more_than_its_size(kind, most, tmp_path, monkeypatch):
    random.seed(1)
    monkeypatch.setattr(drawing_file, "MAX_POINTS", most)
    monkeypatch.setattr(drawing_outlines, "MAX_POINTS", most)
    document = ezdxf.new()
    HOSTILE[kind](document.modelspace(), lambda: (1e3 * random.random(), 1e3 * random.random()))
    document.saveas(tmp_path / "a.dxf")
    tracemalloc.start()
    try:
        DxfFile(tmp_path / "a.dxf").sheet("m")
    except InputError as error:
        assert error.code in ("drawing_too_much", "drawing_too_many_points")
    most = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert most < 30e6 + 100 * (tmp_path / "a.dxf").stat().st_size
