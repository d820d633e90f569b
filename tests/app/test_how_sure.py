"""The tab How sure and the sliders of What if show the numbers of core; the case changes only where they are told."""

import os
from dataclasses import replace

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from app.shell import menus
from app.shell.what_if_window import WhatIfWindow
from core.case.rules import parse_case
from core.case.writer import dumps
from core.study.plan import read_inputs
from core.study.what_if import setting_of, zetas
from tests.app.driving import settle
from tests.core.study.test_how_sure import ROWS
from tests.core.study.test_sensitivity import LOADED, SPECTRUM


@pytest.fixture
def asked(application, opened, tmp_path):
    """The window with a loaded wall at a site with a hazard, run."""
    hazard = [{"return_period_years": t, "ag_g": ag, "f0": 2.4, "tc_star_s": 0.33} for t, ag in ROWS]
    demand = {"ag_g": 0.2, "spectrum": SPECTRUM, "nominal_life_years": 50.0, "use_class_factor": 1.0, "hazard": hazard}
    table = {"wall": [LOADED], "demand": demand, "generate": {"count": 7}, "analysis": {"q_step": 0.05}}
    path = tmp_path / "case.toml"
    path.write_text(dumps(parse_case(table)), encoding="utf-8")
    opened.session.open(path)
    settle(application, lambda: not opened.records.pending and bool(opened.records.motions))
    opened.run()
    settle(application, lambda: opened.session.result is not None and opened.job is None)
    return opened


def test_that_the_tab_asks_for_the_moves_and_shows_them(application, asked):
    asked.show_page("sure")
    tab = asked.pages["sure"].content
    assert "nine of ten" in tab.words.text() and tab.rates.rowCount() == 4
    assert tab.button.isVisibleTo(tab) and not tab.moves.isVisibleTo(tab)
    tab.button.click()
    settle(application, lambda: not asked.session.stale and asked.job is None)
    assert asked.session.case.sensitivity is not None
    asked.show_page("sure")
    tab = asked.pages["sure"].content
    found = asked.session.result.verdicts[0].sensitivity
    assert tab.moves.rowCount() == len(found.swings) and tab.reach.rowCount() == len(found.reach)
    assert tab.moves.item(0, 2).text() == f"{found.swings[0].ends[0].zeta:.2f}"
    assert not tab.button.isVisibleTo(tab) and tab.chart.data
    asked.session.undo()
    assert asked.session.case.sensitivity is None


def test_that_the_sliders_give_the_zeta_of_the_changed_wall_and_change_nothing_until_taken(application, asked):
    before = asked.session.case
    menus.what_if(asked)
    sliders = asked.findChild(WhatIfWindow)
    assert sorted(sliders.sliders) == ["ag_g", "height_m", "load_factor", "thickness_m"]
    settle(application, lambda: bool(sliders.known))
    run = {check.label: check.zeta for check in asked.session.result.walls[0].assessment.checks}
    assert sliders.known == {label: zeta for label, zeta in run.items() if label != "linear_q_slv"}
    sliders.sliders["thickness_m"].setValue(40)
    value = sliders.values["thickness_m"]
    assert value == pytest.approx(0.5 * 2.0**0.2)
    shown = {rung.name: rung.zeta for rung in sliders.ladder.rungs}
    kinematic = zetas(sliders._setting(), every=0).by_check
    assert shown[sliders._check("nonlinear")] == kinematic["nonlinear"] and sliders.ladder.rungs[0].zeta is None
    settle(application, lambda: sliders.ladder.rungs[0].zeta is not None)
    assert asked.session.case == before
    sliders.take_it()
    wall = asked.session.case.wall[0]
    assert wall.thickness_m == value and wall.load[0].d_m == pytest.approx(0.35 * 2.0**0.2)
    case = asked.session.checked()
    inputs = read_inputs(case, asked.session.base_dir)
    assert zetas(setting_of(case, 0, asked.session.base_dir, inputs), every=0).by_check == kinematic
    asked.session.undo()
    assert asked.session.case == before
    sliders.reject()


def test_that_a_wall_that_does_not_stand_is_said_and_the_search_finds(application, asked):
    menus.what_if(asked)
    sliders = asked.findChild(WhatIfWindow)
    sliders.sliders["height_m"].setValue(-200)  # its load stands above it
    assert sliders.word.text() and all(rung.zeta is None for rung in sliders.ladder.rungs)
    sliders.reset()
    assert not sliders.values
    sliders.search()
    settle(application, lambda: "\n" in sliders.word.text())
    assert "a_g [g]" in sliders.word.text() and "Thickness [cm]" in sliders.word.text()
    sliders.reject()


def test_that_without_a_demand_there_is_nothing_to_move(opened):
    opened.session.edit(replace(opened.session.case, demand=None))
    menus.what_if(opened)
    sliders = opened.findChild(WhatIfWindow)
    assert not sliders.take.isEnabled() and not sliders.sliders and sliders.heading.text()
    sliders.reject()
