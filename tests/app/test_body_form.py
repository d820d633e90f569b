"""The section Shape of the form of a wall: short forms, wedges, solids, and their drawing."""

import os
from dataclasses import replace

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QToolButton

from app.look.body_drawing import BodyDrawing, turned
from app.look.drawing import WallDrawing, outline
from app.look.language import tr
from app.look.section import unfold_to
from app.work.session import Session
from core.case.hold import Hold
from core.case.reader import read_case
from core.case.solids import Opening, Solid, Step, Wedges
from core.case.wall import Wall
from tests.app.driving import type_into
from tests.conftest import ROOT

FACADE = ROOT / "resources" / "cases" / "facade.toml"


def field(form, key):
    return next(one for one in form.fields if one.key == key)


@pytest.fixture
def body(opened):
    """The form of the shape of a wall of 6 x 0.5 m, 4 m long."""
    sizes = {"height_m": 6.0, "thickness_m": 0.5, "length_m": 4.0, "unit_weight_kn_m3": 18.0, "base_z_m": 0.0}
    opened.session.edit_wall(0, mechanism="one_sided", slenderness_deg=None, hold=(Hold("contact"),), **sizes)
    assert opened.session.problem() is None
    unfold_to(opened.walls.body)
    return opened.walls.body


def press(entries, label: str) -> None:
    button = next(one for one in entries.findChildren(QToolButton) if one.text() == label)
    QApplication.processEvents()  # it has its place
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)


def head_of(opened) -> str:
    return opened.walls.sections["body"].head.words


def test_that_a_gable_openings_steps_and_wedges_are_typed_and_said_in_the_head(opened, body):
    assert head_of(opened) == "rectangle"
    type_into(body.gable_fields[0], "2")
    press(body.openings, tr("Rectangle"))
    for key, text in (("s_m", "0,5"), ("z_m", "1"), ("width_m", "1,2"), ("height_m", "1,5")):
        type_into(field(body.openings, key), text)
    press(body.openings, tr("Circle"))
    for key, text in (("s_m", "2"), ("z_m", "4"), ("diameter_m", "0,8")):
        type_into(field(body.openings, key), text)
    wall = opened.session.case.wall[0]
    assert wall.openings == (Opening(0.5, 1.0, 1.2, 1.5), Opening(2.0, 4.0, diameter_m=0.8))
    assert body.openings.list.item(0).text() == "1.2 × 1.5 m, s 0.5, z 1 m"
    assert body.openings.list.item(1).text() == "⌀ 0.8 m, s 2, z 4 m"
    assert not field(body.openings, "width_m").isVisibleTo(body) and head_of(opened) == "gable 2 m, 2 openings"
    body.wedges.setChecked(True)
    for one, text in zip(body.wedges.fields, ("2", "40", "1,5"), strict=False):
        type_into(one, text)
    assert opened.session.case.wall[0].return_wedges == Wedges(2, 0.4, 1.5)
    assert opened.session.problem() is None and head_of(opened).endswith(", wedges")
    press(body.steps, tr("Add"))
    for key, text in (("from_z_m", "3"), ("thickness_m", "35")):
        type_into(field(body.steps, key), text)
    assert opened.session.case.wall[0].steps == (Step(3.0, 0.35),)
    assert body.steps.list.item(0).text() == "35 cm from z 3 m"
    body.openings.list.setCurrentRow(0)
    body.openings.delete_button.click()
    assert [opening.diameter_m for opening in opened.session.case.wall[0].openings] == [0.8]
    while opened.session.past:
        opened.session.undo()
    assert not opened.session.case.wall[0].openings and head_of(opened) == "rectangle"


def test_that_the_length_of_a_wedge_follows_from_the_bricks_only_when_asked_for(opened, body):
    body.wedges.setChecked(True)
    for one, text in zip(body.wedges.fields, ("2", "40"), strict=False):
        type_into(one, text)
    assert not body.fill.isEnabled()
    for line, text in ((body.brick_length, "12"), (body.brick_height, "20")):
        line.setFocus()
        QTest.keyClicks(line, text)
    assert body.fill.isEnabled() and "1.8" in body.fill.text()
    assert not opened.session.case.wall[0].return_wedges.length_at_top_m
    body.fill.click()
    assert opened.session.case.wall[0].return_wedges.length_at_top_m == pytest.approx(6.0 * 12.0 / 40.0)
    assert opened.session.problem() is None
    opened.session.undo()
    assert not opened.session.case.wall[0].return_wedges.length_at_top_m


@pytest.mark.parametrize(
    "text", ["0\t0\n4\t0\n4\t5,5\n0\t5,5\n", "0;0\r\n4;0\r\n4;5.5\r\n0;5.5", "0 0\n4   0\n4 5,5\n\n0 5.5"]
)
def test_that_two_columns_of_a_spreadsheet_are_pasted_as_corners(opened, body, text):
    press(body.solids, tr("Add"))
    assert opened.session.case.wall[0].solid[0].polygon_m == ((0.0, 0.0), (4.0, 0.0), (4.0, 6.0), (0.0, 6.0))
    corners = field(body.solids, "polygon_m")
    QGuiApplication.clipboard().setText(text)
    corners.editor.setFocus()
    corners.editor.selectAll()
    corners.editor.paste()
    assert opened.session.case.wall[0].solid[0].polygon_m == ((0.0, 0.0), (4.0, 0.0), (4.0, 5.5), (0.0, 5.5))
    assert max(z for one in opened.walls.drawing.body.elevation for _, z in one.points) == 5.5
    corners.editor.setPlainText("0 0\n4 0\n4 5.5\n2")
    assert opened.session.case.wall[0].solid[0].polygon_m[2] == (4.0, 5.5)  # what was good before stays
    assert "line 4" in corners.message.text() and not opened.run_button.isEnabled()


def test_that_nothing_of_one_opening_or_wall_stays_in_the_fields_of_the_next(opened, body):
    opened.session.edit_wall(0, openings=(Opening(1.0, 1.0, 1.0, 1.0), Opening(1.0, 3.0, 1.0, 1.0)))
    type_into(field(body.openings, "s_m"), "x")
    assert field(body.openings, "s_m").wrong
    body.openings.list.setCurrentRow(1)
    assert field(body.openings, "s_m").editor.text() == "1" and not field(body.openings, "s_m").wrong
    body.wedges.setChecked(True)
    body.brick_length.setText("25")
    body.wedges.setChecked(False)
    while opened.session.case.wall:
        opened.walls.delete()
    assert body.openings.list.count() == 0 and body.wedges.former is None and not body.brick_length.text()
    assert body.gable_fields[0].editor.text() == "" and head_of(opened) == ""


def test_that_what_is_wrong_with_a_shape_stands_at_its_field(opened, body):
    press(body.openings, tr("Rectangle"))
    press(body.openings, tr("Circle"))
    opened.session.edit_wall(0, openings=(Opening(1.0, 1.0, 1.0), Opening(2.0, 4.0, diameter_m=0.8)))
    body.openings.list.setCurrentRow(1)
    assert "opening 1" in opened.missing.text()
    opened.missing.lead()
    assert body.openings.list.currentRow() == 0 and "opening 1" in field(body.openings, "width_m").message.text()
    crossed = Solid("elevation", ((0.0, 0.0), (4.0, 6.0), (0.0, 6.0), (4.0, 0.0)), 0.5)
    opened.session.edit_wall(0, openings=(), solid=(crossed,))
    assert "meet" in field(body.solids, "polygon_m").message.text()
    opened.session.edit_wall(0, solid=(replace(crossed, plane="oblique"),))
    assert field(body.solids, "angle_deg").message.text()
    opened.session.edit_wall(0, solid=(), return_wedges=Wedges(2, 0.4, 1.0, 7.0))
    assert "leaves no wedge" in body.wedges.fields[3].message.text()
    opened.session.edit_wall(0, return_wedges=None, gable_m=2.0, length_m=None)
    assert "length" in opened.walls.fields["length_m"].message.text()


DRAFTS = (
    {"openings": (Opening("", ""),)},
    {"openings": (Opening(1.0, 1.0, width_m=1.0), Opening(1.0, "", diameter_m=0.5))},
    {"steps": (Step("", ""), Step(3.0, ""))},
    {"solid": (Solid("", (), ""),)},
    {"solid": (Solid("elevation", ((0.0, 0.0), (4.0, 0.0)), 0.5),)},
    {"solid": (Solid("oblique", ((0.0, 0.0), (4.0, 0.0), (0.0, 6.0)), 0.5),)},
    {"solid": (Solid("section", ((0.0, 0.0), (1.0, 1.0), (2.0, 2.0)), 0.5, opening=True),)},
    {"return_wedges": Wedges("", "", "")},
    {"return_wedges": Wedges(2, 0.4, "", 9.0), "gable_m": 9.0},
    {"gable_m": 2.0, "length_m": None, "unit_weight_kn_m3": None},
    {"gable_m": 2.0, "height_m": None},
    {"gable_m": 2.0, "thickness_m": None, "slenderness_deg": 5.0, "compressive_strength_mpa": 1.0},
)
"""Shapes in the making."""


MECHANISMS = "one_sided", "both", "vertical_bending"


@pytest.mark.parametrize("every", [False, pytest.param(True, marks=pytest.mark.long)])
@pytest.mark.parametrize("mechanism", MECHANISMS)
def test_that_a_shape_in_the_making_is_shown_and_read_back_equal(opened, body, faults, tmp_path, mechanism, every):
    """In the short form each shape with one mechanism."""
    before = opened.session.case.wall[0]
    for k, shape in enumerate(DRAFTS if every else DRAFTS[MECHANISMS.index(mechanism) :: len(MECHANISMS)]):
        opened.session.edit_wall(0, mechanism=mechanism, hinge_heights=(2.0,), **shape)
        opened.walls.drawing.grab()
        assert faults == [], shape
        wanted = opened.session.case.wall[0]
        opened.session.save(tmp_path / f"draft_{k}.toml")
        other = Session(tmp_path / "recovery_folder")
        other.open(tmp_path / f"draft_{k}.toml")
        assert other.case.wall[0] == wanted, shape
        other.close()
        opened.session.undo()
        assert opened.session.case.wall[0] == before and faults == [], shape


def test_that_a_rectangle_is_drawn_as_before_and_a_body_by_its_own_outline(application):
    """Turned about the hinge of the side it turns to."""
    drawing = WallDrawing()
    wall = Wall("w", "both", height_m=6.0, thickness_m=0.5, length_m=4.0, unit_weight_kn_m3=18.0)
    drawing.show_wall(wall)
    assert drawing.body.section == [] and drawing.body.ends == (-0.25, 0.25)
    drawing.show_wall(replace(wall, steps=(Step(3.0, 0.3),)))
    ends = [(min(x for x, _ in one.points), max(z for _, z in one.points)) for one in drawing.body.section]
    assert ends == [(-0.25, 3.0), (pytest.approx(-0.05), 6.0)]
    for rotation in (0.2, -0.2):
        corner = turned([(0.25 if rotation > 0 else -0.25, 0.0)], 0.25, rotation)[0]
        assert (abs(corner.x()), abs(corner.y())) == (0.25, 0.0)
        whole = turned([(-0.25, 0.0), (0.25, 0.0), (0.25, 6.0), (-0.25, 6.0)], 0.25, rotation)
        assert outline(6.0, 0.5, 0.0, rotation) == whole


@pytest.mark.parametrize("width", [170, 640])
def test_that_the_facade_is_drawn_in_section_and_where_there_is_room_in_elevation(application, width):
    drawing = WallDrawing()
    drawing.resize(width, 500)
    before, bonded, _ = read_case(FACADE).wall
    for wall, kinds in ((before, ["solid", "opening", "opening"]), (bonded, ["solid", "opening", "opening", "wedge"])):
        drawing.show_wall(wall)
        assert [one.kind for one in drawing.body.section] == kinds and wall.parts
        assert drawing.has_elevation == (width > 420)
        assert drawing.grab().toImage().width() == width
    assert drawing.body.ends == pytest.approx((-0.45 - 1.6, 0.45))


def test_that_an_empty_thickness_marks_the_field_of_the_wedges_or_of_the_wall_alone(opened, body):
    own = next(one for one in opened.walls.shape_fields if one.key == "thickness_m")
    of_wedges = next(one for one in body.wedges.fields if one.key == "thickness_m")
    opened.session.edit_wall(0, return_wedges=Wedges(2, "", 1.0))
    assert of_wedges.rule and not own.rule
    assert "[wall.return_wedges]" not in of_wedges.rule and "Wedges of return walls" in of_wedges.rule


def test_that_the_length_of_oblique_solids_is_that_of_the_wall():
    solid = Solid("oblique", ((0.0, 0.0), (1.0, 0.0), (1.0, 6.0), (0.0, 6.0)), 0.5, angle_deg=30.0)
    sizes = {"height_m": 6.0, "thickness_m": 0.5, "length_m": 10.0, "unit_weight_kn_m3": 18.0}
    assert BodyDrawing(Wall("w", "one_sided", solid=(solid,), **sizes), 0.25).length == 10.0
    plain = replace(solid, plane="elevation", angle_deg=None)
    assert BodyDrawing(Wall("w", "one_sided", solid=(plain,), **sizes), 0.25).length is None
