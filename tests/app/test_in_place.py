"""The drawing of a wall: values at its arrows, loads still to be given dashed, values changed where they are drawn."""

from dataclasses import replace

import pytest

pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from PySide6.QtCore import QPointF, Qt
from PySide6.QtTest import QTest

from app.look.in_place import InPlaceEditor
from core.case.hold import Hold
from core.case.loads import Load
from core.case.solids import Opening


@pytest.fixture
def drawing(opened, application):
    """Of a wall with a floor, a tie and a roof whose weight is still to be given."""
    loads = Load("vertical", 12.5, 3.0, 0.2, mass="none"), Load("vertical", None, 5.0, 0.25, mass="none")
    tie = Hold("tie", h_m=4.5, out_kn_m=30.0, bar_length_m=5.0)
    session = opened.session
    wall = replace(session.case.wall[0], mechanism="one_sided", load=loads, hold=(tie,))
    session.edit(replace(session.case, wall=(wall,)))
    opened.navigator.show_input("wall", 0)
    application.processEvents()
    found = opened.walls.drawing
    found.grab()
    return found


def twice(drawing, kind: str, k: int = 0) -> InPlaceEditor:
    """The line that opens where this is drawn."""
    area = next(area for area, *spot in drawing.spots if spot == [kind, k])
    QTest.mouseDClick(drawing, Qt.MouseButton.LeftButton, pos=area.center().toPoint())
    return drawing.findChildren(InPlaceEditor)[-1]


def test_that_loads_have_their_size_and_what_is_to_be_given_is_dashed(drawing):
    assert [(arrow.load, arrow.words) for arrow in drawing.arrows] == [(0, "12.5 kN/m"), (1, "")]
    assert [(mark.hold, mark.low, mark.words, mark.bar) for mark in drawing.holds] == [
        (0, 4.5, "30 kN/m", True),
        (None, 0.0, "", False),
    ]


@pytest.mark.shows("window.drawing")
@pytest.mark.parametrize(
    ("kind", "k", "text", "seen"),
    [
        ("height", 0, "6.4", lambda wall: wall.height_m == 6.4),
        ("thickness", 0, "55", lambda wall: wall.thickness_m == 0.55),
        ("thickness", 0, "0.6 m", lambda wall: wall.thickness_m == 0.6),
        ("load", 0, "2*7", lambda wall: wall.load[0].kn_m == 14.0),
        ("load", 1, "8", lambda wall: wall.load[1].kn_m == 8.0),
    ],
)
def test_that_a_value_is_changed_where_it_is_drawn(opened, drawing, application, kind, k, text, seen):
    before = opened.session.case
    line = twice(drawing, kind, k)
    assert line.isVisible() and line.selectedText() == line.text()
    QTest.keyClicks(line, text)
    QTest.keyClick(line, Qt.Key.Key_Return)
    application.processEvents()
    assert seen(opened.session.case.wall[0]) and opened.session.case != before
    opened.session.undo()
    assert opened.session.case == before


def test_that_what_is_refused_is_marked_and_esc_gives_it_up(opened, drawing, application):
    before = opened.session.case.wall[0]
    line = twice(drawing, "height")
    QTest.keyClicks(line, "high")
    assert "border" in line.styleSheet()
    QTest.keyClick(line, Qt.Key.Key_Escape)
    application.processEvents()
    assert opened.session.case.wall[0] == before
    assert not any(field.wrong for field in opened.stages.fields)


def test_that_esc_gives_back_what_was_there_and_another_wall_or_an_undo_closes_the_line(opened, drawing, application):
    before = opened.session.case.wall[0]
    line = twice(drawing, "thickness")
    QTest.keyClicks(line, "20")
    assert opened.session.case.wall[0].thickness_m == 0.2
    QTest.keyClick(line, Qt.Key.Key_Escape)
    assert opened.session.case.wall[0] == before
    line = twice(drawing, "thickness")
    QTest.keyClicks(line, "33")
    opened.session.undo()
    assert line.is_closed and opened.session.case.wall[0] == before
    opened.session.edit(replace(opened.session.case, wall=(before, replace(before, name="other"))))
    line = twice(drawing, "thickness")
    opened.walls.select(1)
    assert line.is_closed


@pytest.mark.parametrize("shape", ["slenderness_deg", "height_over_thickness", "general"])
def test_that_no_other_quantity_is_changed_in_the_place_of_one(opened, drawing, application, shape):
    opened.session.edit_wall(0, load=(), hold=())
    opened.walls._shape_chosen(opened.walls.shape.findData(shape))
    application.processEvents()
    drawing.grab()
    area = next(area for area, *spot in drawing.spots if spot == ["thickness", 0])
    QTest.mouseDClick(drawing, Qt.MouseButton.LeftButton, pos=area.center().toPoint())
    assert not [line for line in drawing.findChildren(InPlaceEditor) if not line.is_closed]


def test_that_the_hinges_of_a_body_stand_in_its_elevation(opened, drawing, application):
    bare = replace(opened.session.case.wall[0], load=(), hold=())
    wall = replace(bare, length_m=4.0, openings=(Opening(1.0, 1.0, 1.0, 1.2),))
    drawing.resize(700, 500)
    drawing.show_wall(wall, [(0.0, 0.8), (3.0, 0.5)])
    assert drawing.has_elevation
    with_hinges = drawing.grab().toImage()
    drawing.show_wall(wall, [(0.0, 0.8)])
    without = drawing.grab().toImage()
    middle = QPointF(0.75 * drawing.width(), 0.0).toPoint().x()
    rows = [y for y in range(with_hinges.height()) if with_hinges.pixel(middle, y) != without.pixel(middle, y)]
    assert rows
