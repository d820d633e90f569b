"""The tab How sure and the sliders of What if show the numbers of core; the case changes only where they are told."""

import os
from dataclasses import replace
from types import SimpleNamespace

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from app.shell import menus, what_if_window
from app.shell.what_if_window import WhatIfWindow, why_ag_stays
from core.case.rules import parse_case
from core.case.schema import Record
from core.case.writer import dumps, table_of
from core.setting.plan import read_inputs
from core.study.journal import MemoryJournal
from core.variation.evaluate import COARSE_PRECISION, FULL_PRECISION
from core.variation.wall_evaluation import evaluate_wall, make_wall_context
from tests.app.driving import Held, settle
from tests.core.study.test_verdict_uncertainty import ROWS
from tests.core.variation.test_sensitivity import LOADED, SPECTRUM

KNOWN, RESULTS = MemoryJournal(), {}
"""Searches, checks and results of these windows, each made once: the case is the same."""


def run_of(application, opened, path, **sections):
    """The window with a loaded wall and three generated records, run."""
    demand = {"ag_g": 0.2, "spectrum": SPECTRUM} | sections.pop("demand", {})
    table = {
        "wall": [LOADED],
        "demand": demand,
        "generate": {"scatter": 0.0, "count": 3},
        "analysis": {"q_step": 0.05},
    } | sections
    path.write_text(dumps(parse_case(table)), encoding="utf-8")
    opened.session.open(path)
    settle(application, lambda: not opened.records.pending and bool(opened.records.motions))
    opened.runner.finished_runs = KNOWN
    text = path.read_text(encoding="utf-8")
    if text in RESULTS:
        opened.navigator.show_page("walls")
        opened.navigator.take(RESULTS[text])
    else:
        opened.run()
        settle(application, lambda: opened.session.result is not None and opened.runner.job is None)
        RESULTS[text] = opened.session.result
    assert not opened.session.stale
    return opened


@pytest.fixture
def asked(application, opened, tmp_path):
    """At a site with a hazard."""
    hazard = [{"return_period_years": t, "ag_g": ag, "f0": 2.4, "tc_star_s": 0.33} for t, ag in ROWS]
    demand = {"nominal_life_years": 50.0, "use_class_factor": 1.0, "hazard": hazard}
    return run_of(application, opened, tmp_path / "case.toml", demand=demand)


@pytest.fixture
def plain(application, opened, tmp_path):
    """Without a hazard."""
    return run_of(application, opened, tmp_path / "case.toml")


def sliders_of(window) -> WhatIfWindow:
    menus.open_what_if_window(window)
    return window.findChild(WhatIfWindow)


def settle_bars(application, sliders) -> None:
    """Until every point of the histories is searched."""
    settle(application, lambda: sliders.ladder.rungs[0].zeta is not None and not sliders.ladder.rungs[0].clause)


def tones(sliders) -> dict[str, str]:
    return {rung.name: rung.tone for rung in sliders.ladder.rungs}


def test_that_the_tab_asks_for_the_moves_and_shows_them(application, asked):
    asked.navigator.show_page("sure")
    tab = asked.pages["sure"].content
    assert "nine of ten" in tab.words.text() and tab.rates.rowCount() == 4
    assert tab.button.isVisibleTo(tab) and not tab.moves.isVisibleTo(tab)
    tab.button.click()
    settle(application, lambda: not asked.session.stale and asked.runner.job is None)
    assert asked.session.case.sensitivity is not None
    asked.navigator.show_page("sure")
    tab = asked.pages["sure"].content
    found = asked.session.result.verdicts[0].sensitivity
    assert tab.moves.rowCount() == len(found.swings) and tab.reach.rowCount() == len(found.reach)
    assert tab.moves.item(0, 2).text() == f"{found.swings[0].ends[0].zeta:.2f}"
    assert not tab.button.isVisibleTo(tab) and tab.chart.data
    low, high = tab.chart.plot.getViewBox().viewRange()[0]
    assert low < 1.0 < high and low < found.base < high  # zeta required and zeta as it is
    asked.session.undo()
    assert asked.session.case.sensitivity is None


@pytest.mark.shows("window.what_if")
def test_that_the_sliders_give_the_zeta_of_the_changed_wall_and_change_nothing_until_taken(application, plain):
    before = plain.session.case
    sliders = sliders_of(plain)
    assert sorted(sliders.sliders) == ["ag_g", "height_m", "load_factor", "thickness_m"]
    run = {check.label: check.zeta for check in plain.session.result.walls[0].assessment.checks}
    assert sliders.zetas == {label: zeta for label, zeta in run.items() if label != "linear_q_slv"}
    sliders.sliders["thickness_m"].setValue(40)
    sliders.sliders["load_factor"].setValue(31)
    sliders.sliders["ag_g"].setValue(-13)
    assert sliders.values == {"thickness_m": 0.574, "load_factor": 1.11, "ag_g": 0.191}  # 0.57435, 1.1134, 0.19119
    shown = {rung.name: rung.zeta for rung in sliders.ladder.rungs}
    kinematic = evaluate_wall(sliders._setting(), None).by_check
    assert shown[sliders._check("nonlinear")] == kinematic["nonlinear"] and sliders.ladder.rungs[0].zeta is None
    settle_bars(application, sliders)
    fine = sliders.ladder.rungs[0].zeta
    assert plain.session.case == before
    sliders.take_it()
    wall = plain.session.case.wall[0]
    assert (wall.thickness_m, wall.load[0].d_m, wall.load[0].kn_m) == (0.574, 0.402, 13.32)
    assert plain.session.case.demand.ag_g == 0.191
    case = plain.session.checked()
    inputs = read_inputs(case, plain.session.base_dir)
    taken = evaluate_wall(make_wall_context(case, 0, plain.session.base_dir, inputs)).by_check
    assert taken == pytest.approx({"dynamic": fine} | kinematic, rel=1e-9)
    plain.session.undo()
    assert plain.session.case == before
    sliders.reject()


def test_that_a_bar_is_green_only_where_the_check_is_surely_satisfied(application, plain, monkeypatch):
    """At a glance first, which says no outcome; then as a run finds it."""
    asked, satisfied = [], {}

    def found(_, precision, **__):
        asked.append(precision)
        by_check = {"dynamic": 1.3, "nonlinear": 1.2} if precision else {"nonlinear": 1.2}
        known = {"nonlinear": True} | ({"dynamic": satisfied["now"]} if precision else {})
        return SimpleNamespace(by_check=by_check, satisfied=known)

    monkeypatch.setattr(what_if_window, "evaluate_wall", found)
    for now, tone in ((True, "good"), (None, "amber"), (False, "bad")):
        satisfied["now"] = now
        asked.clear()
        sliders = sliders_of(plain)
        settle_bars(application, sliders)
        assert asked[-2:] == [COARSE_PRECISION, FULL_PRECISION]
        named = {label: sliders._check(label) for label in ("dynamic", "nonlinear")}
        assert tones(sliders)[named["dynamic"]] == tone and tones(sliders)[named["nonlinear"]] == "good"
        sliders._show(found(None, COARSE_PRECISION), COARSE_PRECISION)
        assert tones(sliders)[named["dynamic"]] == "amber"
        sliders.reject()


def test_that_satisfied_is_what_the_run_says(plain):
    result = plain.session.result
    inputs = (result.demand, list(result.motions), list(result.kinds))
    found = evaluate_wall(make_wall_context(result.case, 0, plain.session.base_dir, inputs))
    assessment, target = result.walls[0].assessment, result.demand.zeta_target
    run = {check.label: check.passed for check in assessment.checks}
    run["dynamic"] = None if assessment.dynamic.within_spread(target) else run["dynamic"]
    assert found.satisfied == {label: run[label] for label in found.by_check}
    on_it = replace(result.demand, zeta_target=assessment.dynamic.zeta_spread[0])
    close = evaluate_wall(make_wall_context(result.case, 0, plain.session.base_dir, (on_it, *inputs[1:])))
    assert not close.satisfied["dynamic"]  # not surely


def test_that_a_move_leaves_what_is_on_its_way(application, plain):
    sliders = sliders_of(plain)
    settle_bars(application, sliders)
    sliders.follow()
    job = sliders.jobs["zeta"]
    sliders.sliders["thickness_m"].setValue(10)
    assert job.cancelled() and "zeta" not in sliders.jobs and sliders.timer.isActive()
    sliders.reject()


def test_that_no_ag_is_taken_that_contradicts_the_case(application, plain, asked):
    sliders = sliders_of(asked)
    assert "ag_g" not in sliders.sliders and "hazard" in sliders.still.text() and not sliders.still.isHidden()
    sliders.reject()
    case = asked.session.checked()
    free = replace(case, demand=replace(case.demand, hazard=()))
    assert not why_ag_stays(free)
    assert why_ag_stays(replace(free, demand=replace(free.demand, spectrum_file="a.csv", spectrum=None)))
    recorded = replace(free, record=(Record(file="a.at2"),))
    assert why_ag_stays(recorded)
    assert not why_ag_stays(replace(recorded, demand=replace(free.demand, demand_scaling="pga")))


def test_that_the_records_are_read_off_the_thread_of_the_window(application, plain, monkeypatch):
    """Of a run that is still of the case its own are taken."""
    held = Held(monkeypatch, what_if_window, "read_inputs")
    sliders = sliders_of(plain)
    assert sliders.sliders and not held.reached.is_set()
    sliders.sliders["thickness_m"].setValue(40)
    sliders.take_it()
    held.await_call()
    assert sliders.word.text() == "Reading the records…" and not sliders.sliders and not sliders.take.isEnabled()
    held.let_go()
    settle(application, lambda: bool(sliders.sliders))
    assert not sliders.word.text() and sliders.take.isEnabled()
    first = sliders.ladder.rungs[0]
    assert first.name == sliders._check("dynamic") and first.decides
    sliders.reject()


def test_that_the_window_follows_the_case_and_closes_without_a_trace(application, plain):
    listeners = list(plain.session.listeners)
    sliders = sliders_of(plain)
    sliders.sliders["thickness_m"].setValue(40)
    plain.session.edit_wall(0, thickness_m=0.45)
    assert not sliders.take.isEnabled() and not sliders.sliders
    settle(application, lambda: bool(sliders.sliders))
    assert sliders.given["thickness_m"] == 0.45
    settle(application, lambda: bool(sliders.zetas))
    assert sliders.word.text() == "The case has changed: choose again."
    sliders.sliders["thickness_m"].setValue(40)
    assert not sliders.word.text()
    plain.session.add_walls([replace(plain.session.case.wall[0], name="other", thickness_m=0.7)])
    plain.walls.select(1)
    settle(application, lambda: sliders.given.get("thickness_m") == 0.7)
    assert "other" in sliders.heading.text()
    plain.walls.select(0)
    settle(application, lambda: sliders.given.get("thickness_m") == 0.45)
    plain.set_choice("language", "it")
    assert sliders.isHidden() and plain.session.listeners == listeners
    sliders = sliders_of(plain)
    assert sliders.windowTitle() == "E se" and len(plain.session.listeners) == len(listeners) + 1
    plain.set_choice("language", "en")
    assert plain.session.listeners == listeners


def test_that_a_load_on_the_top_of_a_wall_held_there_stays_on_it_as_the_height_moves(application, plain):
    table = table_of(plain.session.case)
    (wall,) = table["wall"]
    held = {key: value for key, value in wall.items() if key != "hold"}
    load = {"kind": "vertical", "kn_m": 12.0, "d_m": 0.25, "h_m": 6.0, "mass": "horizontal"}
    held |= {"mechanism": "vertical_bending", "load": [load]}
    plain.session.edit(parse_case(table | {"wall": [held]}))
    sliders = sliders_of(plain)
    settle(application, lambda: bool(sliders.sliders))
    sliders.sliders["height_m"].setValue(100)
    (wall,) = sliders._setting().case.wall
    assert wall.height_m > 6.0 and wall.load[0].h_m == wall.height_m
    sliders.reject()


def test_that_a_wall_that_does_not_stand_is_said_and_the_search_finds(application, plain):
    sliders = sliders_of(plain)
    sliders.sliders["height_m"].setValue(-200)  # its load stands above it
    assert sliders.word.text() and all(rung.zeta is None for rung in sliders.ladder.rungs)
    sliders.reset()
    assert not sliders.values
    sliders.search()
    settle(application, lambda: "\n" in sliders.word.text())
    assert "a_g [g]" in sliders.word.text() and "Thickness [cm]" in sliders.word.text()
    sliders.reject()


def test_that_without_a_demand_there_is_nothing_to_move(application, opened):
    opened.session.edit(replace(opened.session.case, demand=None))
    menus.open_what_if_window(opened)
    sliders = opened.findChild(WhatIfWindow)
    assert not sliders.take.isEnabled() and not sliders.sliders and sliders.heading.text()
    said = sliders.heading.text()
    opened.session.edit_wall(0, thickness_m=-1.0)
    settle(application, lambda: sliders.heading.text() != said)
    assert not sliders.take.isEnabled()
    sliders.reject()


def test_that_an_interval_that_is_not_known_is_no_missing_demand(asked):
    from app.views.sure_tab import SureTab

    result = asked.session.result
    silent = tuple(replace(verdict, interval=None, rates=()) for verdict in result.verdicts)
    tab = SureTab("en")
    tab.show_wall(replace(result, verdicts=silent), result.walls[0])
    assert "No demand" not in tab.words.text() and tab.words.text()
    tab.show_wall(replace(result, verdicts=()), result.walls[0])
    assert "No demand" in tab.words.text()
