"""Loads, ties, hinges, variants and hazard in the forms, and all walls on one tab."""

import os

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QMessageBox

from core.case.hold import Bars
from core.case.loads import Load
from core.case.variant_names import AS_IS, DESIGNED
from tests.app.driving import run, type_into


def field(form, key):
    return next(one for one in form.fields if one.key == key)


def loaded(opened):
    """The wall of the window with a vertical load entered by hand."""
    form = opened.walls.loads
    type_into(opened.walls.fields["unit_weight_kn_m3"], "18")
    form.add("vertical")
    type_into(field(form, "kn_m"), "10")
    type_into(field(form, "d_m"), "0,30")
    field(form, "mass").offer("none")
    return form


def test_that_a_load_entered_by_hand_is_in_the_case_the_drawing_and_the_threshold(opened):
    before = opened.walls.summary.text()
    form = loaded(opened)
    assert opened.session.case.wall[0].load == (Load("vertical", 10.0, 5.0, 0.3, "none"),)
    assert opened.session.problem() is None
    assert len(opened.walls.drawing.arrows) == 1
    assert opened.walls.summary.text() != before
    assert form.list.item(0).text() == "vertical load, 10 kN/m, h 5 m"
    opened.walls.drawing.grab()
    opened.session.undo()
    opened.session.undo()
    assert opened.session.case.wall[0].load[0].mass is None


def test_that_what_is_missing_of_a_load_is_said_and_blocks_the_run(opened):
    form = opened.walls.loads
    type_into(opened.walls.fields["unit_weight_kn_m3"], "18")
    opened.session.edit_wall(0, mechanism="one_sided")
    form.add("thrust")
    assert "load 1" in opened.missing.text() and "Size" in opened.missing.text()
    assert not opened.run_button.isEnabled()
    type_into(field(form, "kn_m"), "1")
    assert opened.run_button.isEnabled() and not field(form, "mass").isVisibleTo(form)


def test_that_what_is_missing_of_a_tie_is_said_and_blocks_the_run(opened):
    form = opened.walls.holds
    opened.session.edit_wall(0, mechanism="one_sided")
    type_into(opened.walls.fields["unit_weight_kn_m3"], "18")
    form.add("tie")
    assert "hold 1" in opened.missing.text() and "Length of the bar" in opened.missing.text()
    assert not opened.run_button.isEnabled()
    type_into(field(form, "bar_length_m"), "8")
    assert not opened.run_button.isEnabled() and "force at yield" in opened.missing.text()
    type_into(field(form, "out_kn_m"), "2")
    assert opened.run_button.isEnabled()
    assert not any(field(form, key).isVisibleTo(form) for key in ("from_m", "to_m", "spacing_m", "tie_kn_m"))


def test_that_the_bars_of_a_tie_are_given_in_place_of_its_force(opened):
    form = opened.walls.holds
    opened.session.edit_wall(0, mechanism="one_sided", length_m=10.0)
    type_into(opened.walls.fields["unit_weight_kn_m3"], "18")
    form.add("tie")
    type_into(field(form, "bar_length_m"), "8")
    form.bars.setChecked(True)
    (number, diameter), anchorage = form.bars.fields[:2], form.bars.fields[-1]
    type_into(number, "4")
    type_into(diameter, "6")
    type_into(anchorage, "60")
    hold = opened.session.case.wall[0].hold[0]
    assert (hold.out_kn_m, hold.bar.number, hold.bar.diameter_mm, hold.bar.anchorage_kn) == (None, 4, 6.0, 60.0)
    assert opened.run_button.isEnabled() and not field(form, "out_kn_m").isVisibleTo(form)
    form.bars.setChecked(False)
    assert opened.session.case.wall[0].hold[0].bar is None
    form.bars.setChecked(True)
    assert opened.session.case.wall[0].hold[0].bar.number == 4
    form.delete()
    assert opened.session.case.wall[0].hold == () and not form.list.isVisibleTo(form)


def test_that_nothing_of_one_tie_stays_at_the_next(opened):
    """Neither a refused text, nor bars that were switched off."""
    form = opened.walls.holds
    for _ in range(2):
        form.add("tie")
    form.bars.setChecked(True)
    type_into(form.bars.fields[0], "4")
    form.bars.setChecked(False)
    type_into(field(form, "out_kn_m"), "5,5,5")
    assert field(form, "out_kn_m").wrong
    form.list.setCurrentRow(0)
    assert not field(form, "out_kn_m").wrong and field(form, "out_kn_m").editor.text() == ""
    form.bars.setChecked(True)
    assert opened.session.case.wall[0].hold[0].bar == Bars("", "")


def test_that_an_unstable_wall_is_said_in_one_sentence(opened):
    form = opened.walls.loads
    type_into(opened.walls.fields["unit_weight_kn_m3"], "18")
    form.add("thrust")
    type_into(field(form, "kn_m"), "50")
    assert "unstable under its own loads" in opened.missing.text()


def test_that_hinges_and_return_walls_are_edited(opened):
    hinges, across = opened.walls.fields["hinge_heights"], opened.walls.across
    opened.session.edit_wall(0, mechanism="one_sided", unit_weight_kn_m3=18.0, length_m=4.0)
    type_into(hinges, "1,5; 3")
    assert opened.session.case.wall[0].hinge_heights == (1.5, 3.0)
    assert [level for level, _ in opened.walls.drawing.hinges] == [0.0, 1.5, 3.0]
    type_into(hinges, "high")
    assert "not heights" in hinges.message.text()
    type_into(hinges, "")
    across.setChecked(True)
    assert opened.session.problem() is not None
    for key, text in (("number", "2"), ("thickness_m", "40"), ("brick_height_m", "20"), ("brick_length_m", "30")):
        type_into(field(across, key), text)
    assert opened.session.problem() is None
    assert opened.session.case.wall[0].return_walls.brick_length_m == pytest.approx(0.30)
    across.setChecked(False)
    across.setChecked(True)
    assert opened.session.case.wall[0].return_walls.number == 2


def test_that_a_hazard_is_pasted_and_nonsense_is_refused(opened, monkeypatch):
    said = []
    monkeypatch.setattr(QMessageBox, "warning", lambda *a: said.append(a[-1]))
    form = opened.demand.hazard
    QGuiApplication.clipboard().setText("T_R a_g\n30\t0,08\n475\t0,26\n")
    form.paste()
    assert [row.ag_g for row in opened.session.case.demand.hazard] == [0.08, 0.26] and not said
    assert "2 rows" in form.words.text()
    QGuiApplication.clipboard().setText("hello")
    form.paste()
    assert said and len(opened.session.case.demand.hazard) == 2


def test_that_all_walls_are_on_one_tab_the_lowest_first_and_variants_are_compared(opened, application):
    loaded(opened)
    opened.session.edit_wall(0, variant=AS_IS)
    opened.walls.duplicate()
    assert [wall.variant for wall in opened.session.case.wall] == [AS_IS, DESIGNED]
    opened.session.edit_wall(1, thickness_m=0.7)
    run(application, opened)
    opened.navigator.show_page("walls")
    tab = opened.pages["walls"].content
    zetas = [opened.session.result.walls[k].assessment.verdict.zeta_e for k in tab.order]
    assert zetas == sorted(zetas) and tab.table.rowCount() == 2
    assert tab.pairs.rowCount() == 1 and tab.pairs.item(0, 7).text() == "thickness"
    tab.table.cellDoubleClicked.emit(1, 0)
    assert opened.navigator.shown == tab.order[1] and opened.navigator.page == "check"
    opened.navigator.show_page("intensity")
    assert opened.pages["intensity"].content.chart.data == []


def test_that_the_histories_show_what_a_tie_does(opened, application, tmp_path):
    """Force and elongation under the rotation; the bar in the drawing; the same motion again."""
    from app.views.histories_tab import HistoriesTab
    from core.case.rules import parse_case
    from core.rocking.bar_state import BROKEN
    from core.study.run import run

    tie = {"kind": "tie", "out_kn_m": 2.0, "h_m": 6.0, "bar_length_m": 8.0, "elongation_m": 0.3}
    wall = {
        "name": "w",
        "mechanism": "one_sided",
        "height_m": 7.0,
        "thickness_m": 0.5,
        "unit_weight_kn_m3": 18.0,
        "base_z_m": 0.0,
        "hinge_heights": "base",
    }
    spectrum = {"code": "EN1998", "soil": "B", "type": 1}
    table = {
        "generate": {"scatter": 0.0, "count": 1},
        "demand": {"ag_g": 0.3, "spectrum": spectrum},
        "analysis": {"q_step": 0.05},
    }
    result = run(parse_case({**table, "wall": [wall | {"hold": [tie]}, wall | {"name": "bare"}]}), base_dir=tmp_path)
    tab = HistoriesTab()
    tab.setParent(opened)
    tab.show_wall(result, result.walls[0])
    assert tab.force.isVisibleTo(tab) and [len(tab.force.data), len(tab.elongation.data)] == [1, 2]
    assert "kJ/m" in tab.words.text()
    once = tab.history.rotation.size
    tab.again.setChecked(True)
    assert tab.history.rotation.size > once or tab.history.outcome != 0
    tab.set_time(0.0)
    assert [height for height, phase in tab.walls.drawings[0].bars if phase != BROKEN] == [6.0]
    tab.walls.drawings[0].grab()
    tab.show_wall(result, result.walls[1])
    assert (
        not tab.below.tabBar().isVisibleTo(tab)
        and tab.energy.isVisibleTo(tab)
        and not tab.again.isVisibleTo(tab)
        and tab.walls.drawings[0].bars == []
    )
    tab.setParent(None)  # the window is lent to the next test
