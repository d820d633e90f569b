"""Where a reader who timed an engineer's tasks stumbled: each was so once."""

import os
import re
from dataclasses import replace

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from app.input.reasons_form import ReasonField
from core.case.loads import Bars, Load
from tests.app.driving import run, type_into


def choose(field, name) -> None:
    """A name of a list, as a click has it."""
    field.editor.setCurrentIndex(field.editor.findData(name))
    field.editor.activated.emit(field.editor.currentIndex())


def test_that_a_level_of_knowledge_proposes_its_confidence_factor_and_none_below_it(opened):
    fields, session = opened.demand.fields, opened.session
    for level, factor in (("LC2", 1.2), ("LC3", 1.0), ("LC1", 1.35), ("LC3", 1.0)):
        choose(fields["knowledge_level"], level)
        assert session.case.demand.confidence_factor == factor
    type_into(fields["confidence_factor"], "1.1")
    choose(fields["knowledge_level"], "LC2")
    assert session.case.demand.confidence_factor == 1.2
    type_into(fields["confidence_factor"], "1.3")
    choose(fields["knowledge_level"], "LC3")
    assert session.case.demand.confidence_factor == 1.3
    session.undo()
    assert (session.case.demand.knowledge_level, session.case.demand.confidence_factor) == ("LC2", 1.3)


def test_that_a_table_of_walls_asks_for_its_demand_too(opened, monkeypatch):
    from app.shell import first_run

    monkeypatch.setattr(opened.walls, "load_table", opened.walls.add)
    opened.show_first_run()
    first_run.follow(opened, "table")
    words = " ".join(problem.words for problem in opened.missing.problems)
    assert "a_g" in words and opened.walls.fields["base_z_m"].caption.text() in words


def test_that_a_base_above_the_ground_asks_for_its_building_before_the_run_and_in_the_answer(opened, application):
    opened.session.edit_wall(0, base_z_m=6.0)
    opened.show_input("wall", 0)
    (problem,) = opened.missing.problems
    assert "building" in problem.words and opened.run_button.isEnabled()
    opened.activateWindow()
    problem.lead()
    assert opened.stages.input.kind == "building" and opened.focusWidget() is opened.demand.building.given
    run(application, opened)
    opened.show_page("check")
    content = opened.pages["check"].content
    assert "building" in content.no_peaks.text() and "records" not in content.no_peaks.text()
    content.important.linkActivated.emit(re.findall(r"href='([^']*)'", content.important.text())[0])
    assert opened.stages.input.kind == "building"
    opened.demand.building.given.setChecked(True)
    assert not any("motion above the ground" in one.words for one in opened.missing.problems)


def test_that_a_restraint_that_is_asked_for_is_named_as_its_field_and_found(opened, application):
    opened.session.edit_wall(0, mechanism="one_sided")
    run(application, opened)
    content = opened.pages["check"].content
    field = opened.walls.fields["back_restraint"]
    words = content.important.text()
    assert "back_restraint)" not in words and field.caption.text().lower() in words
    opened.activateWindow()
    content.important.linkActivated.emit("key:back_restraint")
    assert opened.stages.front == "input" and opened.focusWidget() is field.editor


@pytest.mark.parametrize("bar", [None, Bars(2, 20.0)])
def test_that_a_tie_that_is_too_strong_is_marked_and_led_to(opened, bar):
    loads = (Load("vertical", 5.0, 5.0, 0.25, "none"), Load("tie", None if bar else 400.0, 2.5, bar_length_m=5.0))
    loads = (loads[0], replace(loads[1], bar=bar and replace(bar, number=60)))
    opened.session.edit_wall(0, load=loads, unit_weight_kn_m3=18.0, length_m=2.0)
    opened.show_input("wall", 0)
    (problem,) = opened.missing.problems
    assert "lower the force" in problem.words and "missing" not in opened.missing.heading.text()
    opened.activateWindow()
    problem.lead()
    loads_form = opened.walls.loads
    field = next(
        one
        for one in (*loads_form.load_fields, *loads_form.bar_fields)
        if one.key == ("diameter_mm" if bar else "kn_m")
    )
    assert loads_form.list.currentRow() == 1 and opened.focusWidget() is field.editor and field.rule


def test_that_of_several_fields_the_empty_one_is_led_to_and_its_section_unfolds(opened):
    opened.session.edit_wall(0, load=(Load("thrust", 2.0, 5.0),))
    opened.show_input("wall", 0)
    (problem,) = opened.missing.problems
    opened.activateWindow()
    problem.lead()
    assert opened.focusWidget() is opened.walls.fields["unit_weight_kn_m3"].editor
    assert opened.walls.fields["unit_weight_kn_m3"].isVisible()


def test_that_the_answer_leads_to_the_bars_it_asks_for(opened, application):
    tie = Load("tie", 4.0, 4.5, bar_length_m=5.0, elongation=0.05)
    opened.session.edit_wall(0, load=(tie,), unit_weight_kn_m3=18.0, mechanism="one_sided")
    run(application, opened)
    content = opened.pages["check"].content
    assert "key:anchorage_kn" in content.important.text() + content.others.text()
    opened.activateWindow()
    opened.ask("key:anchorage_kn")
    assert opened.focusWidget() is opened.walls.loads.bars and opened.walls.loads.bars.isVisible()
    opened.ask("reason:elongation_m")
    assert isinstance(opened.focusWidget().parentWidget(), ReasonField)
