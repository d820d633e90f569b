"""A sweep from the window: nothing written, nothing of the case changed."""

import os

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from app.shell import menus
from app.shell.sweep_window import SweepWindow
from app.views.chart import Chart
from app.views.table import Table
from core.case.site import Demand
from core.case.wall import Wall
from core.study.sweep import SweepKey
from tests.app.driving import Held, settle


@pytest.fixture
def asked(opened):
    """The window of a sweep of three values."""
    menus.open_sweep_window(opened)
    made = opened.findChild(SweepWindow)
    made.count.setValue(3)
    yield made
    assert made.close() and not made.isVisible()


def choose(made: SweepWindow, section: type, name: str, low: str, high: str) -> None:
    made.key.setCurrentIndex(made.keys.index(SweepKey(section, name)))
    made.low.setText(low)
    made.high.setText(high)


def swept(application, made: SweepWindow) -> None:
    made.run()
    settle(application, lambda: made.job is None)


@pytest.mark.shows("window.sweep")
def test_that_a_sweep_shows_each_check_and_q_and_changes_nothing(application, opened, asked):
    case, past, result = opened.session.case, list(opened.session.past), opened.session.result
    choose(asked, Wall, "thickness_m", "40", "60")  # [cm]
    swept(application, asked)
    assert (opened.session.case, opened.session.past, opened.session.result) == (case, past, result)
    assert [point.value for point in asked.points] == pytest.approx([0.4, 0.5, 0.6])
    charts = {chart.name: chart for chart in asked.tabs.widget(0).findChildren(Chart)}
    zeta, q = charts["ζ of each check"], charts["q of the set"]
    (_, x, y), (target, _, required) = zeta.data
    assert list(x) == pytest.approx([40.0, 50.0, 60.0]) and (target, *required) == ("ζ required", 1.0, 1.0)
    assert list(y) == [point.zeta["dynamic"] for point in asked.points] and y[0] < y[2]
    assert list(q.data[0][1]) == pytest.approx([40.0, 50.0, 60.0])
    assert list(q.data[0][2]) == [point.q for point in asked.points]
    assert zeta.caption.startswith("w: ") and not zeta.is_stale
    table = asked.tabs.widget(1).findChild(Table)
    assert table.rowCount() == 3 and table.columnCount() == len(asked.points[0].zeta) + 4


def test_that_a_sweep_of_the_demand_is_of_the_same_wall(application, opened, asked):
    opened.session.edit_section("demand", demand_scaling="pga")
    menus.open_sweep_window(opened)
    choose(asked, Demand, "ag_g", "0,1", "0,2")
    swept(application, asked)
    first, middle, last = (point.zeta["dynamic"] for point in asked.points)
    assert first > middle > last


def test_that_a_refused_value_is_named_beside_the_numbers_of_the_others(application, asked):
    choose(asked, Wall, "hinge_setback_m", "0", "30")  # [cm] of 50
    swept(application, asked)
    assert [point.error is None for point in asked.points] == [True, True, False]
    assert asked.word.text().startswith("2 of 3 values; refused at 30: ")
    choose(asked, Wall, "hinge_setback_m", "25", "30")
    swept(application, asked)
    assert asked.word.text().startswith("0 of 3 values") and asked.tabs.count() == 2


@pytest.mark.parametrize("low, said", [("", "number"), ("a", "number"), ("-3", "from 0.5 to 2000 cm")])
def test_that_a_range_the_key_does_not_accept_is_said_and_nothing_runs(asked, low, said):
    choose(asked, Wall, "thickness_m", low, "50")
    asked.run()
    assert asked.job is None and asked.word.text().startswith("Thickness t [cm]: ") and said in asked.word.text()


def test_that_a_sweep_is_cancelled_with_what_is_finished_and_closes_while_it_runs(
    application, opened, asked, monkeypatch
):
    from core.study import sweep

    held = Held(monkeypatch, sweep, "make_sweep_point")
    choose(asked, Wall, "thickness_m", "40", "60")
    asked.run()
    held.await_call()
    assert asked.cancel_button.isEnabled() and not asked.run_button.isEnabled()
    asked.close()
    held.let_go()
    settle(application, lambda: asked.job is None)
    assert len(asked.points) == 1 and asked.word.text() == "1 of 3 values"
    menus.open_sweep_window(opened)
    assert opened.findChild(SweepWindow) is asked


def test_that_a_case_that_cannot_run_cannot_be_swept(opened, asked):
    opened.session.edit_wall(0, thickness_m=None)
    menus.open_sweep_window(opened)
    assert not asked.run_button.isEnabled() and asked.word.text() and asked.key.count() == 0
    asked.run()
    assert asked.job is None
    opened.session.undo()
    menus.open_sweep_window(opened)
    assert asked.run_button.isEnabled() and asked.key.currentText() == "Thickness t [cm]"


def test_that_another_language_or_theme_makes_the_window_of_a_sweep_again(application, opened, asked):
    opened.set_choice("theme", "dark")
    menus.open_sweep_window(opened)
    again = opened.findChild(SweepWindow)
    assert again is not asked and again.look[1] == "dark"


def test_that_a_case_that_changes_beside_an_open_sweep_is_the_one_that_runs(application, opened, asked):
    choose(asked, Wall, "thickness_m", "40", "60")
    opened.session.edit_wall(0, height_m=6.0)
    swept(application, asked)
    assert asked.shown[0].wall[0].height_m == 6.0 and len(asked.points) == 3
    opened.session.edit_wall(0, name="another")
    asked.run()
    assert asked.job is None and asked.word.text() == "The case has changed: choose again."
    assert asked.wall.currentText() == "another"
