"""Values nobody gave are missing until they are given, and unusual ones are asked about where they are typed."""

import os
from dataclasses import replace

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.input.wall_text import ASKED_AT, input_questions
from app.look import theme
from app.shell import first_run
from core.case.loads import Load
from core.case.rules import parse_case
from core.case.wall import Wall
from core.study.run import run as run_study
from tests.app.driving import type_into


@pytest.mark.parametrize("way", ["first_run", "tree"])
def test_that_a_new_wall_has_no_size_until_it_is_given(opened, application, way):
    if way == "first_run":
        opened.show_first_run()
        opened.activateWindow()
        first_run.open_first_choice(opened, "wall")
    else:
        opened.walls.add()
    fields, wall = opened.walls.fields, opened.session.case.wall[-1]
    assert (wall.height_m, wall.thickness, wall.mechanism) == (None, None, "")
    for key in ("height_m", "thickness_m"):
        assert fields[key].editor.text() == "" and fields[key].message.text(), key
    assert fields["slenderness_deg"].isHidden() and fields["height_over_thickness"].isHidden()
    said = " ".join(problem.words for problem in opened.missing.problems)
    assert all(fields[key].caption.text() in said for key in ("height_m", "thickness_m")), said
    assert not opened.run_button.isEnabled()
    type_into(fields["height_m"], "6.4")
    application.processEvents()
    assert fields["thickness_m"].message.text() and not fields["height_m"].message.text()
    type_into(fields["thickness_m"], "50")
    application.processEvents()
    said = " ".join(problem.words for problem in opened.missing.problems)
    assert fields["thickness_m"].caption.text() not in said and not fields["thickness_m"].message.text()
    assert (opened.session.case.wall[-1].height_m, opened.session.case.wall[-1].thickness_m) == (6.4, 0.5)


def test_that_a_number_typed_where_the_program_puts_the_cursor_is_the_number_of_the_case(opened, application):
    opened.show_first_run()
    opened.activateWindow()
    first_run.open_first_choice(opened, "wall")
    QTest.keyClicks(application.focusWidget(), "6.4")
    assert opened.session.case.wall[0].height_m == 6.4
    opened.demand.fields["ag_g"].editor.setFocus()
    opened.walls.drawing.picked.emit("height", 0)  # in a wall that has one
    assert application.focusWidget() is opened.walls.fields["height_m"].editor
    QTest.keyClicks(application.focusWidget(), "3.2")
    assert opened.session.case.wall[0].height_m == 3.2


@pytest.mark.shows("window.marks")
@pytest.mark.parametrize("language", ["en", "it"])
def test_that_a_slenderness_few_mean_is_asked_about_where_it_is_typed(opened, application, language):
    """46.4 m and 40 cm, H/t 116: accepted, and said."""
    opened.set_choice("language", language)
    fields = opened.walls.fields
    type_into(fields["thickness_m"], "40")
    type_into(fields["height_m"], "46.4")
    application.processEvents()
    words = fields["height_m"].message.text()
    assert "H/t = 116" in words and words.endswith("?") and not fields["height_m"].wrong
    assert theme.current.amber in fields["height_m"].message.styleSheet() and opened.run_button.isEnabled()
    type_into(fields["height_m"], "4.64")
    application.processEvents()
    assert not fields["height_m"].message.text()


@pytest.mark.parametrize(
    ("key", "usual", "unusual", "part"),
    [
        ("thickness_m", "40", "4", "below 10 cm"),
        ("unit_weight_kn_m3", "18", "38", "kg/m3"),
        ("elastic_modulus_mpa", "1500", "15", "GPa"),
        ("compressive_strength_mpa", "2.4", "24", "kg/cm2"),
    ],
)
def test_that_a_stress_a_weight_or_a_thickness_out_of_range_is_asked_about_at_its_field(
    opened, application, key, usual, unusual, part
):
    opened.session.edit_wall(0, unit_weight_kn_m3=18.0)
    field = opened.walls.fields[key]
    field.show()
    type_into(field, unusual)
    application.processEvents()
    assert part in field.message.text() and not field.wrong
    type_into(field, usual)
    application.processEvents()
    assert not field.message.text()


def test_that_a_load_that_crushes_the_base_is_asked_about_at_its_size(opened, application):
    opened.session.edit_wall(0, unit_weight_kn_m3=18.0, length_m=4.0)
    opened.walls.loads.add("vertical")
    size = next(field for field in opened.walls.loads.fields if field.key == "kn_m")
    type_into(size, "9000")
    application.processEvents()
    assert "MPa" in size.message.text()
    type_into(size, "9")
    application.processEvents()
    assert "MPa" not in size.message.text()


def test_that_a_question_is_not_taken_to_another_wall(opened, application):
    opened.session.add_walls([replace(opened.session.case.wall[0], name="v", height_m=60.0)])
    opened.navigator.show_input("wall", 1)
    application.processEvents()
    assert "H/t" in opened.walls.fields["height_m"].message.text()
    opened.navigator.show_input("wall", 0)
    application.processEvents()
    assert not opened.walls.fields["height_m"].message.text()


def test_that_the_form_asks_all_that_is_asked_with_the_result(tmp_path):
    wall = {
        "name": "w",
        "mechanism": "two_sided",
        "height_m": 4.0,
        "thickness_m": 0.08,
        "unit_weight_kn_m3": 40.0,
        "elastic_modulus_mpa": 20.0,
        "masonry": "solid_brick",
        "base_z_m": 0.0,
        "length_m": 3.0,
        "load": [{"kind": "vertical", "kn_m": 500.0, "h_m": 4.0, "d_m": 0.04, "mass": "none"}],
    }
    case = parse_case({"wall": [wall], "demand": {"ag_g": 0.2}})
    result = run_study(case, base_dir=tmp_path)
    asked = {warning.code for warning in result.walls[0].warnings} & set(ASKED_AT)
    assert asked == set(ASKED_AT) - {"odd_strength"}  # which is a question of the form alone
    assert set(input_questions(case.wall[0])) == {ASKED_AT[code] for code in asked}


@pytest.mark.parametrize(
    "wall", [Wall("w", ""), Wall("w", "", height_m=4.0), Wall("w", "", height_m="", load=(Load("", "", ""),))]
)
def test_that_a_wall_still_to_be_given_is_asked_nothing(wall):
    assert input_questions(wall) == {}


@pytest.mark.shows("window.marks")
@pytest.mark.parametrize(
    ("language", "key", "text", "asked"),
    [
        ("en", "height_m", "1,200", True),
        ("it", "height_m", "1,200", True),
        ("it", "height_m", "1.200", True),
        ("en", "height_m", "1.200", False),
        ("en", "height_m", "1,20", False),
        ("en", "height_m", "0,312", False),
        ("en", "thickness_m", "12,500", True),
        ("en", "unit_weight_kn_m3", "18,000", True),
        ("en", "length_m", "12,500", True),
        ("en", "f0", "2,614", False),
    ],
)
def test_that_a_number_that_may_have_a_separator_of_thousands_is_asked_about(
    opened, application, language, key, text, asked
):
    opened.set_choice("language", language)
    field = {**opened.walls.fields, **opened.demand.fields}[key]
    type_into(field, text)
    application.processEvents()
    assert not field.wrong
    words = field.message.text()
    assert (text in words and text.replace(",", "").replace(".", "") in words) == asked, words
    QTest.keyClick(field.editor, Qt.Key.Key_Backspace)
    application.processEvents()
    assert text not in field.message.text()
