"""What a user types: refused in its field, kept in sight, taken back in steps, told in the words of the forms."""

import itertools
import math
import os
import re
import tomllib
from dataclasses import fields, replace

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from app.look.language import FORM_NAMES, describe_message
from core.case.loads import Load
from core.case.rules import parse_case
from core.case.schema import Analysis, Generate
from core.case.site import Building, Demand, Spectrum
from core.case.values import check_value
from core.case.wall import Wall
from core.errors import InputError
from core.quantities import factor_to
from core.text.catalogue import CATALOGUE
from tests.app.driving import rest, settle, type_into


def test_that_a_refused_number_stays_and_keeps_the_run_back(opened, application):
    """Its first digits are in the case already: they must not pass for what was meant."""
    height = opened.walls.fields["height_m"]
    thickness = opened.walls.fields["thickness_m"]
    type_into(height, "99999")
    type_into(thickness, "60")
    assert height.editor.text() == "99999" and height.wrong
    assert not opened.run_button.isEnabled()
    type_into(height, "6")
    assert not height.wrong and opened.session.case.wall[0].height_m == 6.0


BLOCKS = (
    {},
    {"hinge_setback_m": 0.1},
    {"unit_weight_kn_m3": 18.0, "load": (Load("carried_mass", 9.0, 5.0, 0.25),)},
    {"height_m": None, "thickness_m": None, "slenderness_deg": 11.0, "radius_m": 2.0, "inertia_over_mass_m2": 7.0},
)
"""A rectangle, one with a setback, one with a mass that moves with it, a general block."""


def test_that_a_restitution_formula_shown_gives_the_value_beside_it(opened, monkeypatch):
    plain = opened.session.case.wall[0]
    for language, model, shape in itertools.product(
        ("en", "it"), ("housner", "sorrentino_experimental", "one_sided_theoretical"), BLOCKS
    ):
        monkeypatch.setattr("app.look.language._current", [language])
        wall = replace(plain, mechanism="one_sided", restitution=model, **shape)
        opened.session.case = replace(opened.session.case, wall=(wall,))
        opened.walls.impact.show_case()
        line = opened.walls.impact.formula.text().splitlines()[0]
        line = re.sub(r"(?<=\d),(?=\d)", ".", line).replace(";", ",")
        degrees = re.search(r"α = ([\d.]+)°|$", line).group(1)
        expression, value = re.search(r"e = (.*) \(Eq.*= ([\d.]+)$", line).groups()
        # the formula as one reads it, in the notation of Python
        expression = expression.replace("−", "-").replace(")²", ")**2").replace("·", "*")
        expression = re.sub(r"\|(.*)\|", r"abs(\1)", expression)
        expression = re.sub(r"(sin|cos)²α", rf"\1(radians({degrees}))**2", expression)
        expression = re.sub(r"(?<=[\d)]) (?=[a-z(])", " * ", expression)
        assert eval(expression, vars(math).copy()) == pytest.approx(float(value), abs=1e-4)
        assert abs(float(value) - wall.restitution_of("one_sided").ratio_at_rest) < 1e-4


def test_that_another_case_does_not_take_over_what_was_wrong(opened, application):
    height = opened.walls.fields["height_m"]
    type_into(height, "abc")
    opened.files.open(opened.session.path)
    assert not height.wrong and height.editor.text() == "5"


def test_that_a_new_language_does_not_stop_the_run(opened, application):
    opened.run()
    opened.set_choice("language", "it")
    settle(application, lambda: opened.runner.job is None)
    assert opened.session.result is not None


def test_that_rules_between_fields_stand_at_the_fields(opened, application):
    walls = opened.walls
    walls.impact.law.setCurrentIndex(walls.impact.law.findData("own"))
    walls.impact._law_chosen(walls.impact.law.currentIndex())
    type_into(walls.impact.first, "0.5")
    application.processEvents()
    for field in (walls.impact.first, walls.impact.last):
        assert "0.5" in field.message.text() and "{" not in field.message.text()
    assert not opened.run_action.isEnabled()
    type_into(walls.impact.last, "0.6")
    application.processEvents()
    assert not walls.impact.first.message.text() and opened.run_action.isEnabled()
    type_into(walls.fields["hinge_setback_m"], "45")
    application.processEvents()
    assert "hinge setback" in walls.fields["hinge_setback_m"].message.text()
    type_into(walls.fields["hinge_setback_m"], "0")
    walls.duplicate()
    type_into(walls.fields["name"], "w")
    application.processEvents()
    assert "same name" in walls.fields["name"].message.text()
    type_into(walls.fields["name"], "v")
    demand = opened.demand
    type_into(demand.fields["confidence_factor"], "1.2")
    application.processEvents()
    said = opened.demand.fields["confidence_factor"].message.text()
    assert "Level of knowledge" in said and "Strength f" in said


@pytest.mark.shows("window.undo")
def test_that_undo_in_a_field_is_that_of_the_case_and_takes_refused_text_back_first(opened, application):
    field = opened.walls.fields["thickness_m"]
    before = opened.session.case.wall[0].thickness_m
    opened.activateWindow()
    type_into(field, "60")
    type_into(opened.walls.fields["height_m"], "6")
    QTest.keyClick(opened.walls.fields["height_m"].editor, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert opened.session.case.wall[0].height_m == 5.0
    assert opened.session.case.wall[0].thickness_m == 0.6
    type_into(field, "70x")
    assert field.wrong
    QTest.keyClick(field.editor, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    application.processEvents()
    assert not field.wrong and field.editor.text() == "60"
    for _ in range(3):
        QTest.keyClick(field.editor, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert opened.session.case.wall[0].thickness_m == before
    QTest.keyClick(field.editor, Qt.Key.Key_Y, Qt.KeyboardModifier.ControlModifier)
    assert opened.session.case.wall[0].thickness_m != before


def test_that_a_refused_choice_in_the_import_dialog_keeps_no_run_back(opened, application, tmp_path, monkeypatch):
    from app.input.import_dialog import ImportDialog

    def refused(dialog):
        type_into(dialog.fields[1], "abc")
        return dialog.DialogCode.Rejected

    bare = tmp_path / "bare.txt"
    bare.write_text("0.1 0.2")
    monkeypatch.setattr(ImportDialog, "exec", refused)
    opened.records.take([bare])
    opened.refresh()
    assert opened.run_action.isEnabled()


def test_that_a_pause_ends_a_step_of_undo(opened, monkeypatch):
    from app.work import session

    notes = opened.walls.fields["notes"]
    type_into(notes, "first")
    monkeypatch.setattr(session, "UNDO_PAUSE", -1.0)
    notes.editor.end(False)
    QTest.keyClicks(notes.editor, "!")
    opened.session.undo()
    assert opened.session.case.wall[0].notes == "first"


def test_that_a_wall_named_like_a_key_misleads_no_message(opened, application):
    type_into(opened.walls.fields["name"], "notes")
    type_into(opened.walls.fields["hinge_setback_m"], "45")
    application.processEvents()
    assert opened.walls.fields["hinge_setback_m"].message.text() and not opened.walls.fields["notes"].message.text()


@pytest.mark.parametrize("text", ["9..5", "999", "2,,6", ""])
def test_that_the_beginning_of_a_refused_number_does_not_stay_in_the_case(opened, text):
    type_into(opened.walls.fields["height_m"], text) if text else None
    if not text:
        opened.walls.fields["height_m"].editor.setFocus()
        opened.walls.fields["height_m"].editor.selectAll()
        QTest.keyClick(opened.walls.fields["height_m"].editor, Qt.Key.Key_Delete)
    assert opened.walls.fields["height_m"].wrong
    assert opened.session.case.wall[0].height_m == 5.0


def test_that_the_wheel_over_a_list_without_the_focus_changes_nothing(opened, application):
    from PySide6.QtCore import QPointF
    from PySide6.QtGui import QWheelEvent

    from app.input.editors import Choice

    opened.walls.fields["height_m"].editor.setFocus()
    before = opened.session.case
    lists = opened.findChildren(Choice)
    assert len(lists) > 8
    for choice in lists:
        place = QPointF(5, 5)
        turned = QWheelEvent(
            place,
            QPointF(choice.mapToGlobal(place.toPoint())),
            QPoint(),
            QPoint(0, -120),
            Qt.MouseButton.NoButton,
            Qt.KeyboardModifier.NoModifier,
            Qt.ScrollPhase.NoScrollPhase,
            False,
        )
        application.sendEvent(choice, turned)
    assert opened.session.case == before


def test_that_choosing_the_spectrum_again_or_the_demand_off_and_on_loses_nothing(opened):
    form = opened.demand
    opened.session.edit_section("demand", soil_factor=None)
    form._kind_chosen(form.kind.findData("NTC2018"))
    assert opened.session.problem() is not None  # nothing of the site is assumed
    type_into(form.fields["f0"], "2.4")
    type_into(form.fields["tc_star_s"], "0.35")
    form.fields["soil"].offer("B")
    form.fields["topography"].offer("T1")
    assert opened.session.problem() is None
    opened.session.edit(replace(opened.session.case, generate=Generate(count=1)))
    case = opened.session.case
    form._kind_chosen(form.kind.findData("NTC2018"))
    assert opened.session.case == case
    form._kind_chosen(form.kind.findData("EN1998"))
    form._kind_chosen(form.kind.findData("NTC2018"))
    assert opened.session.case == case
    form.given.setChecked(False)
    assert opened.session.case.demand is None and opened.session.case.generate is None
    form.given.setChecked(True)
    assert opened.session.case == case


@pytest.mark.parametrize("language", ["en", "it"])
def test_that_sentences_of_the_window_use_the_words_of_its_forms(opened, language):
    """Every key an error names is a placeholder, and has a caption; so no key is left in its words."""
    opened.set_choice("language", language)
    known = {f.name for kind in (Wall, Demand, Spectrum, Analysis) for f in fields(kind)}
    seen = set()
    for code, wording in CATALOGUE["error"].items():
        text = re.sub("{[^}]*}", "", wording[language == "it"])
        assert not {word for word in re.findall(r"\w+_\w+", text) if word in known}, code
        if "[[" not in text:
            assert not re.search(r"\[[a-z.]+\]", text), code
        keys = InputError(code).keys & known
        assert all(key in FORM_NAMES.captions for key in keys if "_" in key), (code, keys)
        seen |= keys
    assert len(seen) > 15


def test_that_sentences_of_the_window_keep_paths_and_show_values_as_the_fields_do(opened):
    path = "/data/one_sided/height_m.csv"
    assert describe_message(InputError("no_table", place=(path,))).startswith(path)
    case = {"analysis": {"robust_window": 0.01, "q_step": 0.05}}
    with pytest.raises(InputError) as caught:
        parse_case(case)
    assert describe_message(caught.value).startswith(
        "Analysis: Robust window = 1 % is narrower than one step of Step of the search = 5 %: widen"
    )
    for key, value, words in (
        ("thickness_m", 83.0, "Thickness t = 8300 cm is"),
        ("height_m", 83.0, "Height H = 83.0 is"),
    ):
        with pytest.raises(InputError) as caught:
            check_value(Wall, key, value)
        assert describe_message(caught.value).startswith(words)


def test_that_the_building_of_walls_above_the_ground_is_edited_saved_and_taken_back(opened, application):
    form = opened.demand.building
    assert opened.session.case.building is None and "above the ground" in form.summary.text()
    form.given.setChecked(True)
    application.processEvents()
    height, storeys, period, _, damping = form.fields
    assert not opened.run_action.isEnabled(), "the height and the storeys are never guessed"
    for field, text in ((height, "9"), (storeys, "3"), (period, "0.26"), (damping, "12")):
        type_into(field, text)
    application.processEvents()
    building = opened.session.case.building
    assert (building.height_m, building.storeys, building.period_s) == (9.0, 3, 0.26)
    assert building.damping == pytest.approx(0.12) and building.period_factor is None
    assert "T 0.390 s" in form.summary.text() and opened.run_action.isEnabled()
    opened.files.save()
    assert parse_case(tomllib.loads(opened.session.path.read_text())).building == building
    period.editor.selectAll()
    QTest.keyClick(period.editor, Qt.Key.Key_Delete)
    rest(period)
    assert "estimate" in form.summary.text()
    form.given.setChecked(False)
    assert opened.session.case.building is None
    opened.session.undo()
    assert opened.session.case.building is not None


def test_that_a_wall_above_the_ground_shows_its_floor(opened, application):
    opened.session.edit_wall(0, base_z_m=6.0)
    table = {"height_m": 9.0, "storeys": 3, "period_s": 0.26}
    opened.session.edit(replace(opened.session.case, building=Building(**table)))
    opened.session.edit_section("demand", soil_factor=None, spectrum=Spectrum("EN1998", "B", type=1))
    opened.run()
    settle(application, lambda: opened.session.result is not None and opened.runner.job is None)
    for name in [page for page in opened.pages if page != "note"]:
        opened.navigator.show_page(name)
        application.processEvents()
        if name == "spectra":
            assert opened.pages[name].content.floor.isVisible()
    wall = opened.navigator.wall  # the hinge that decides
    assert wall.floor.motions[0].pga > opened.session.result.motions[0].pga
    histories = opened.pages["histories"].content
    assert histories.motion is wall.floor.motions[0]


@pytest.mark.shows("window.marks")
def test_that_an_a_g_beyond_any_of_italy_is_asked_about_where_it_is_typed_and_with_the_result(
    opened, application, tmp_path
):
    from app.views.check_tab import CheckTab
    from core.case.rules import parse_case
    from core.study.run import run as run_study

    assert "S apart" in opened.demand.hint.text()
    type_into(opened.demand.fields["ag_g"], "2.55")
    application.processEvents()
    asked = "a_g = 2.55 g is above 0.6 g, beyond the hazard of Italy at 2475 years: was 2.55 m/s2 meant"
    assert asked in opened.demand.hint.text() and opened.session.problem() is None
    type_into(opened.demand.fields["ag_g"], "0.26")
    application.processEvents()
    assert "S apart" in opened.demand.hint.text()
    wall = {"name": "w", "height_m": 4.0, "thickness_m": 0.5, "base_z_m": 0.0, "mechanism": "two_sided"}
    result = run_study(parse_case({"wall": [wall], "demand": {"ag_g": 2.55}}), base_dir=tmp_path)
    tab = CheckTab("en")
    tab.show_wall(result, result.walls[0])
    assert asked in tab.to_do.words.text()


@pytest.mark.parametrize(
    "key",
    [
        *("thickness_m", "unit_weight_kn_m3"),
        *(pytest.param(key, marks=pytest.mark.long) for key in ("height_m", "hinge_setback_m", "length_m")),
    ],
)
def test_that_a_number_with_its_unit_means_that_unit(opened, key):
    """50 cm in a field of metres, 0.5 m in one of centimetres; what is no unit of the key is refused."""
    field, unit = opened.walls.fields[key], Wall.__dataclass_fields__[key].metadata["unit"]
    before = {field.value}
    for written in ("cm", "m", "mm", "piedi", "kN/m³", "kg/m3", "t/m", "s", "cmx"):
        factor = factor_to(written, unit)
        if factor is None:
            type_into(field, f"2 {written}")
            assert field.wrong and field.value in before
            continue
        target = 18.0 if unit == "kN/m3" else 0.07 if key == "hinge_setback_m" else 0.8
        type_into(field, f"{target / factor:.10g} {written}")
        assert not field.wrong and field.value == pytest.approx(target, rel=1e-9), written
        before.add(field.value)


@pytest.mark.parametrize(("text", "metres"), [("7*0,83", 5.81), ("3.2+2.6", 5.8), ("2*290 cm", 5.8), ("(5+6)/2", 5.5)])
def test_that_a_sum_or_product_is_its_value_and_says_so(opened, text, metres):
    field = opened.walls.fields["height_m"]
    type_into(field, text)
    assert not field.wrong and opened.session.case.wall[0].height_m == pytest.approx(metres, rel=1e-12)
    said = opened.stages.input.said
    assert said.of is field and field.said.startswith(f"{text} = ") and field.said in said.text()
    type_into(field, "7*")
    assert field.wrong and opened.session.case.wall[0].height_m == 5.0, "as before the editing"


def test_that_the_wheel_and_arrows_change_a_number_with_ctrl_alone(opened, application):
    from PySide6.QtCore import QPointF
    from PySide6.QtGui import QWheelEvent

    field = opened.walls.fields["thickness_m"]
    line, before = field.editor, field.value
    line.setFocus()

    def turn(modifier):
        place = QPointF(5, 5)
        seen = QPointF(line.mapToGlobal(place.toPoint()))
        button, phase = Qt.MouseButton.NoButton, Qt.ScrollPhase.NoScrollPhase
        application.sendEvent(line, QWheelEvent(place, seen, QPoint(), QPoint(0, 120), button, modifier, phase, False))

    turn(Qt.KeyboardModifier.NoModifier)
    assert field.value == before == 0.5
    turn(Qt.KeyboardModifier.ControlModifier)
    assert field.value == opened.session.case.wall[0].thickness_m == pytest.approx(0.51, rel=1e-12)
    QTest.keyClick(line, Qt.Key.Key_Down, Qt.KeyboardModifier.ControlModifier)
    QTest.keyClick(line, Qt.Key.Key_Down, Qt.KeyboardModifier.ControlModifier)
    assert field.value == pytest.approx(0.49, rel=1e-12)


def test_that_the_click_into_a_line_selects_all_of_it(opened):
    opened.walls.fields["height_m"].editor.setFocus()
    line = opened.walls.fields["thickness_m"].editor
    QTest.mouseClick(line, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, QPoint(line.width() - 8, 8))
    assert line.selectedText() == line.text() != ""
    QTest.mouseClick(line, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, QPoint(line.width() - 8, 8))
    assert line.selectedText() == "", "a click in a line that has the cursor places it"


def test_that_words_of_a_field_stand_in_room_of_their_own_once_it_is_left(opened, application):
    """Nothing below moves, neither while one types nor when the field is left."""
    said, fields = opened.stages.input.said, opened.walls.fields
    height, thickness = fields["height_m"], fields["thickness_m"]
    application.processEvents()
    places = [field.mapTo(opened, field.rect().topLeft()) for field in fields.values() if field.isVisible()]
    type_into(height, "tall")
    application.processEvents()
    assert height.wrong and said.text() == ""  # the hand is still there
    thickness.editor.setFocus()
    application.processEvents()
    assert said.of is height and "not a number" in said.text() and said.height() == said.sizeHint().height()
    assert places == [field.mapTo(opened, field.rect().topLeft()) for field in fields.values() if field.isVisible()]
    type_into(height, "4")
    application.processEvents()
    assert said.text() == ""
