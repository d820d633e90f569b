"""What stands beside a verdict: the interval of its records and the rates of its limit states, never part of it."""

from dataclasses import replace

import numpy as np
import pytest

from core.case.reader import read_case
from core.case.rules import parse_case
from core.case.writer import table_of
from core.codes.collapse_rate import state_rate
from core.errors import Cancelled
from core.setting.demand_input import rescale_ag
from core.study import verdict_uncertainty
from core.study.run import run
from core.study.verdict_uncertainty import make_ag_function, record_capacities
from core.units import G
from tests.conftest import ROOT
from tests.core.variation.test_sensitivity import LOADED

CASES = ROOT / "resources" / "cases"
ROWS = [(30, 0.06), (50, 0.08), (101, 0.11), (201, 0.145), (475, 0.2), (975, 0.26), (2475, 0.35)]


@pytest.fixture(scope="module")
def case():
    table = table_of(read_case(CASES / "building.toml"))
    (wall,) = [one for one in table["wall"] if one["name"] == "parapet"]
    table = {key: value for key, value in table.items() if key != "site"} | {"wall": [wall | {"law": "rigid"}]}
    table["analysis"] = {"q_step": 0.02}
    table["demand"] = {
        "ag_g": 0.2,
        "spectrum": {"code": "NTC2018", "f0": 2.4, "tc_star_s": 0.33, "soil": "B", "topography": "T1"},
        "nominal_life_years": 50.0,
        "use_class_factor": 1.0,
        "hazard": [{"return_period_years": t, "ag_g": ag, "f0": 2.4, "tc_star_s": 0.33} for t, ag in ROWS],
    }
    return parse_case(table)


@pytest.fixture(scope="module")
def result(case):
    return run(case, base_dir=CASES)


def test_that_the_rates_are_of_the_capacities_of_the_searches(result):
    """Collapse at the multiplier of the search: of both signs the lower, a_g in proportion; uplift first."""
    (verdict,), wall = result.verdicts, result.walls[0]
    motions = list(wall.floor.motions)
    ag = result.demand.ag
    found = record_capacities(wall, motions, result.demand, result.search.q_limit, lambda multiplier: multiplier * ag)
    by_hand = [min(run.scale for run in wall.runs if run.motion == k) * 0.2 * G for k in range(14)]
    assert found["collapse"] == pytest.approx(by_hand, rel=1e-12)
    assert np.all(np.array(found["SLV"]) <= found["SLC"]) and np.all(np.array(found["SLC"]) <= found["collapse"])
    assert np.all(np.array(found["SLD"]) < found["SLV"])
    # each record is scaled to a_g S first
    to_pga = replace(result.demand, record_scaling="pga", pga=2.0 * result.demand.pga)
    found = record_capacities(wall, motions, to_pga, result.search.q_limit, lambda multiplier: multiplier * ag)
    scalings = [to_pga.pga / (motion.ground_pga or motion.pga) for motion in motions]
    assert found["collapse"] == pytest.approx(np.divide(by_hand, scalings), rel=1e-12)
    hazard = [(t, ag * G) for t, ag in ROWS]
    follows = make_ag_function(result.demand, result.case.demand, CASES)
    true = [follows(one / (0.2 * G)) for one in by_hand]
    expected = state_rate("collapse", true, [f"file {k}" for k in range(14)], hazard, 1.35, 50.0)
    assert verdict.rates[-1].rate == pytest.approx(expected.rate, rel=1e-12)
    assert [rate.state for rate in verdict.rates] == ["SLD", "SLV", "SLC", "collapse"]
    rates = [rate.rate for rate in verdict.rates]
    assert rates == sorted(rates, reverse=True)


@pytest.mark.shows("search.sample")
def test_that_the_interval_is_beside_the_verdict_and_changes_nothing(result, monkeypatch, case):
    assert result.verdicts[0].interval.stations == 14
    monkeypatch.setattr(verdict_uncertainty, "MAX_WALLS_WITH_INTERVAL", 0)
    plain = run(case, base_dir=CASES)
    assert plain.verdicts[0].interval is None
    assert plain.walls[0].assessment == result.walls[0].assessment
    assert replace(plain.verdicts[0], interval=result.verdicts[0].interval) == result.verdicts[0]


def test_that_a_search_in_vain_stands_for_its_end_and_a_run_without_a_number_for_none(result):
    wall, motions = result.walls[0], list(result.walls[0].floor.motions)
    idas = [replace(run.ida, status="no_collapse_found", q=None, q_slv=None, q_slc=None) for run in wall.runs]
    lost = replace(wall, runs=tuple(replace(run, ida=ida) for run, ida in zip(wall.runs, idas, strict=True)))
    found = record_capacities(lost, motions, result.demand, 10.0, lambda one: one)
    assert found["collapse"] == found["SLV"] == pytest.approx([10.0 * one for one in found["SLD"]])
    broken = replace(wall, runs=(replace(wall.runs[0], ida=replace(idas[0], status="impact_limit")), *wall.runs[1:]))
    assert record_capacities(broken, motions, result.demand, 10.0, lambda one: one) is None


def test_that_a_cancel_during_the_moves_ends_the_run(case):
    table = table_of(case)
    asked = parse_case({**table, "sensitivity": {}, "generate": {**table["generate"], "count": 3}})
    seen = []

    def on_progress(done, planned, left):
        seen.append((done, planned))

    (verdict,) = run(asked, base_dir=CASES, on_progress=on_progress).verdicts
    assert "record_left_out" in [swing.key for swing in verdict.sensitivity.swings]
    assert seen[-1][0] == seen[-1][1]
    calls = iter(range(10**9))
    with pytest.raises(Cancelled):
        run(asked, base_dir=CASES, cancelled=lambda: bool(seen) and next(calls) > 400)


def test_that_s_follows_a_g_where_the_code_says_so(result):
    """a S(a) of the a_g found is the multiplier times a_g S of the demand."""
    demand, asked = result.demand, result.case.demand
    for multiplier in (0.2, 0.9, 1.7, 4.0):
        ag = make_ag_function(demand, asked, CASES)(multiplier)
        there = rescale_ag(demand, asked, CASES, ag / demand.ag)
        assert there.pga == pytest.approx(multiplier * demand.pga, rel=1e-4)
    assert make_ag_function(demand, asked, CASES)(1.7) > 1.7 * demand.ag * 1.005  # soil B: S falls
    assert make_ag_function(replace(demand, target=None), asked, CASES)(1.7) == 1.7 * demand.ag


@pytest.mark.shows("risk.rate")
def test_that_of_several_hinges_each_state_has_the_rate_of_the_worst(case):
    """Each hinge by itself, with FC and in the nominal life of the case."""
    table = table_of(case)
    wall = {key: value for key, value in LOADED.items() if key not in ("load", "hold")}
    wall |= {"mechanism": "two_sided", "unloaded_confirmed": True}
    table |= {
        "wall": [wall],
        "building": {"height_m": 6.0, "storeys": 2, "period_s": 0.3},
        "generate": {"scatter": 0.0, "count": 3},
    }
    table["analysis"] = {"q_step": 0.05, "q_limit": 20.0}
    result = run(parse_case({key: value for key, value in table.items() if key != "records"}), base_dir=CASES)
    (verdict,) = result.verdicts
    assert len(verdict.results) == 2
    ag, names = make_ag_function(result.demand, result.case.demand, CASES), [f"file {k}" for k in range(3)]
    of_hinges = []
    for hinge in result.walls:
        motions = list(hinge.floor.motions) if hinge.floor else result.motions
        found = record_capacities(hinge, motions, result.demand, result.search.q_limit, ag)
        of_hinges.append([state_rate(state, found[state], names, result.demand.hazard, 1.35, 50.0) for state in found])
    for here, *each in zip(verdict.rates, *of_hinges, strict=True):
        assert here == max(each, key=lambda one: one.rate) and each[0].rate != each[1].rate


def test_that_a_g_of_a_multiplier_is_made_once_for_all_walls(case, monkeypatch):
    """400 spectra: 24 ms a wall, in the thread that hands out the tasks."""
    calls = []
    monkeypatch.setattr(
        "core.study.run.make_ag_function", lambda *given: calls.append(given) or make_ag_function(*given)
    )
    walls = tuple(replace(case.wall[0], name=f"parapet {k}") for k in range(2))
    found = run(replace(case, wall=walls, record=()), base_dir=CASES)
    assert len(found.verdicts) == 2 and len(calls) == 1
