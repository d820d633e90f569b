"""The place in the window: by name, by coordinates, on the map; the demand follows it and nothing is lost."""

import pytest

pytest.importorskip("PySide6")

from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from core.case.site import Spectrum
from tests.app.driving import rest, settle


@pytest.fixture
def placed(opened):
    opened.navigator.show_input("demand")
    form = opened.demand.place
    form.given.setChecked(True)
    form.municipality.choose("L'Aquila (AQ)")
    return opened, form


def test_that_a_municipality_gives_the_demand_and_hides_what_follows(placed, application):
    window, form = placed
    demand = window.session.case.demand
    assert round(demand.ag_g, 3) == 0.261 and window.session.checked() is not None
    assert window.demand.fields["ag_g"].isHidden() and window.demand.hazard.isHidden()
    assert "26305" in form.words.text() and "SLC" in form.states.columns[0][1].text()
    window.demand.kind.setCurrentIndex(window.demand.kind.findData("EN1998"))
    window.session.edit_section("demand", spectrum=Spectrum("EN1998", "B", type=1), soil_factor=None)
    settle(application, lambda: len(window.demand.curve.others) == 3)  # when the hand rests
    window.session.edit_section("demand", limit_state="SLC")
    assert round(window.session.case.demand.ag_g, 3) == 0.334
    form.given.setChecked(False)
    assert not window.demand.fields["ag_g"].isHidden() and round(window.session.case.demand.ag_g, 3) == 0.334


def test_that_names_are_offered_without_accents_and_apostrophes(placed):
    _, form = placed
    form.municipality.propose("l aquil")
    assert form.municipality.names.stringList()[0] == "L'Aquila (AQ)"
    form.municipality.propose("forli")
    assert any(name.startswith("Forlì") for name in form.municipality.names.stringList())


def test_that_coordinates_are_pasted_and_the_point_dragged(placed):
    window, form = placed
    form.point.setFocus()
    form.point.clear()
    QTest.keyClicks(form.point, "42.3498 N 13.3995 E")
    QTest.keyClick(form.point, Qt.Key.Key_Return)
    site = window.session.case.site
    assert (site.latitude, site.longitude) == (42.3498, 13.3995)
    before = window.session.case.demand.ag_g
    QTest.mouseClick(form.map, Qt.MouseButton.LeftButton, pos=QPoint(form.map.width() // 2, form.map.height() // 3))
    moved = window.session.case.site
    assert (moved.latitude, moved.longitude) != (42.3498, 13.3995)
    window.session.undo()
    assert window.session.case.demand.ag_g == before
    form.map.setFocus()
    QTest.keyClick(form.map, Qt.Key.Key_Up)
    assert window.session.case.site.latitude == pytest.approx(42.3598)


def test_that_a_point_outside_the_grid_is_said_and_missing_and_nothing_is_lost(placed, tmp_path):
    window, form = placed
    form._edit(None, latitude=41.0, longitude=11.0)
    assert "26305" not in form.words.text() and window.session.checked() is None
    assert window.missing.problems
    form._edit(None, latitude=42.35, longitude=13.4)
    window.session.save(tmp_path / "here.toml")
    case = window.session.case
    assert "ag_g" not in (tmp_path / "here.toml").read_text()
    window.session.open(tmp_path / "here.toml")
    assert window.session.case == case


@pytest.mark.parametrize("wrong", ["abc", "42.35"])
def test_that_a_case_does_not_run_with_another_point_than_the_one_that_stands_in_its_field(placed, wrong):
    window, form = placed
    form._edit(None, latitude=42.3498, longitude=13.3995)
    form.point.setFocus()
    form.point.clear()
    QTest.keyClicks(form.point, wrong)
    window.refresh()
    assert form.coordinates.wrong and form.coordinates.message.text()
    assert any(problem.words.startswith("Coordinates: ") for problem in window.missing.problems)
    assert not window.run_action.isEnabled() and form.point.text() == wrong
    form.point.clear()
    QTest.keyClicks(form.point, "42.35 13.40")
    window.refresh()
    assert not form.coordinates.wrong and not window.missing.problems and window.run_action.isEnabled()
    assert window.session.case.site.point == (42.35, 13.4)


def test_that_a_name_that_is_being_typed_leaves_no_other_place_to_run(placed):
    window, form = placed
    form.search.setFocus()
    form.search.clear()
    QTest.keyClicks(form.search, "Rom")
    assert not window.run_action.isEnabled()
    rest(form)
    assert window.session.case.site.municipality == "Rom" and window.session.checked() is None
    assert window.session.case.demand.ag_g == "" and form.municipality.rule
    QTest.keyClicks(form.search, "a (RM)")
    rest(form)
    assert window.session.checked() is not None and not form.municipality.rule


def test_that_a_place_without_a_point_draws_no_spectrum_and_gives_back_what_was_there(opened):
    window = opened
    window.navigator.show_input("demand")
    before = window.session.case.demand
    window.demand.place.given.setChecked(True)
    assert window.session.case.demand.ag_g == "" and window.demand.curve.isHidden()
    assert not window.demand.curve.others and "missing" in window.demand.summary.text()
    window.demand.place.given.setChecked(False)
    assert window.session.case.demand.ag_g == before.ag_g and window.session.case.demand.hazard == before.hazard


def test_that_a_place_that_goes_leaves_values_with_the_digits_of_a_table(placed):
    window, form = placed
    form.given.setChecked(False)
    demand = window.session.case.demand
    assert demand.ag_g == 0.261
    assert all(getattr(row, key) == round(getattr(row, key), 3) for row in demand.hazard for key in ("ag_g", "f0"))
    assert window.session.checked() is not None


def test_that_the_map_shows_all_of_italy_above_its_source_in_a_small_window(placed, application):
    window, form = placed
    window.resize(1024, 768)
    window.show()
    application.processEvents()
    application.processEvents()
    source = form.inside[-1]
    assert form.map.geometry().bottom() < source.geometry().top()
    corner = form.map.mapTo(window.stages.input.forms.currentWidget().viewport(), QPoint(form.map.width(), 0))
    assert corner.x() <= window.stages.input.forms.currentWidget().viewport().width() and source.geometry().height() > 0
    heel = form.map._at(40.0, 18.5)
    assert form.map.rect().contains(heel.toPoint())
    window.hide()
