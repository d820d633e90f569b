"""One verdict for each wall: its worst hinge, its limit states, what was not checked."""

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import pytest

from core.answer.answer import collect_actions
from core.case.rules import parse_case
from core.report import json_report
from core.study.run import run
from core.study.wall_verdict import wall_severity, wall_verdicts
from tests.conftest import ROOT
from tests.holds import aside

WALL = {
    "name": "facade",
    "height_m": 9.0,
    "thickness_m": 0.6,
    "mechanism": "one_sided",
    "base_z_m": 0.0,
    "unit_weight_kn_m3": 18.0,
    "hold": [{"kind": "cross_walls"}],
}
ROOF = {"kind": "vertical", "kn_m": 8.0, "d_m": 0.4, "h_m": 6.5, "mass": "none"}
BUILDING = {"height_m": 9.0, "storeys": 3, "period_s": 0.26}
SPECTRUM = {"code": "EN1998", "type": 1, "soil": "B"}
HAZARD = [{"return_period_years": y, "ag_g": a} for y, a in ((30, 0.08), (475, 0.2), (2475, 0.4))]
SITE = {"nominal_life_years": 50, "use_class_factor": 1.0, "hazard": HAZARD}


def case(*walls, building=BUILDING, **demand):
    table = {
        "wall": [{**WALL, **wall} for wall in walls or ({},)],
        "record": [{"file": "tests/motions/noise_1.txt"}],
        "analysis": {"q_step": 0.05},
        "demand": {"ag_g": 0.2, "spectrum": SPECTRUM, **demand},
    }
    return parse_case(table | ({"building": building} if building else {}))


def made(*walls, **demand):
    return run(case(*walls, **demand), base_dir=ROOT)


def fake(zeta, code="not_verified", target=1.0):
    verdict = SimpleNamespace(zeta_e=zeta, code=code, zeta_target=target)
    return SimpleNamespace(required_assessment=SimpleNamespace(verdict=verdict))


@pytest.mark.shows("verdict.worst")
def test_that_hinges_are_ordered_by_the_table_of_outcomes_and_then_by_zeta():
    order = [
        fake(0.5),
        fake(0.7, target=1.0),
        fake(0.6, target=0.8),
        fake(0.4, "q2_unsafe"),
        fake(1.02, "at_limit"),
        fake(None, "undetermined"),
        fake(1.8, "indicative"),
        fake(1.3, "verified_refined"),
        fake(1.1, "verified"),
        fake(0.9, "not_activated"),
    ]
    for turned in (order[::-1], order[3:] + order[:3]):
        assert sorted(turned, key=wall_severity) == order


@pytest.mark.shows("verdict.worst")
def test_that_the_worst_hinge_and_mechanism_is_the_wall_s():
    result = made({"mechanism": "both", "load": [{**ROOF, "d_m": 0.3}]})
    (found,) = result.verdicts
    assert len(found.results) == len(result.walls) >= 6
    lowest = min(w.assessment.verdict.zeta_e for w in result.walls)
    worst = result.walls[found.governing]
    assert worst.assessment.verdict.zeta_e == lowest
    (entry,) = json_report.results(result)["verdicts"]
    assert entry["wall"] == "facade" and entry["variant"] is None
    assert (entry["hinge_m"], entry["mechanism"]) == (worst.part.hinge, worst.mechanism)
    # its records are weaker than the demand: the clauses decide
    assert entry["zeta_e"] == lowest and entry["check"] == "nonlinear" and entry["clause"] == "C8.7.1.2.1.8"
    zetas = [row["zeta"] for row in entry["mechanisms"] if row["status"] == "looked_at"]
    assert zetas == sorted(zetas) and len(zetas) == len(found.results)
    assert entry["text_en"].startswith("facade: ") and entry["text_it"].startswith("facade: ")
    for kind in ("to_do", "limits", "notes"):
        assert all(set(one) == {"key", "text_it", "text_en"} for one in entry[kind])


def test_that_each_variant_is_a_wall_of_its_own():
    walls = ({"variant": "stato di fatto"}, {"variant": "progetto", "thickness_m": 0.9})
    entries = json_report.results(made(*walls, building=None))["verdicts"]
    assert [(e["wall"], e["variant"]) for e in entries] == [("facade", "stato di fatto"), ("facade", "progetto")]
    assert entries[0]["zeta_e"] < entries[1]["zeta_e"]


@pytest.mark.shows("verdict.hinges")
def test_that_without_a_building_the_heights_left_out_are_named():
    loads = {"load": [{**ROOF, "h_m": 5.0}]}
    result = made(loads, building=None)
    (left,), said = result.verdicts, result.walls[0].required_assessment.verdict
    assert left.extra == () and said.limits[0].code == "heights_left_out"
    assert "5 m" in said.limits[0].text("en") and "[building]" in said.limits[0].text("it")
    alone = made({**loads, "hinge_heights": "base"})
    said = alone.walls[0].required_assessment.verdict
    assert alone.verdicts[0].extra == () and said.limits[0].code == "hinges_as_asked" and said.blocking
    shown = {"set_aside": [aside("overturning")]}
    (alone,) = made({**loads, **shown, "hinge_heights": "base"}).verdicts
    assert [one.code for one in alone.extra] == ["hinges_set_aside"]
    assert made(loads).verdicts[0].extra == ()
    (some,) = made({**loads, **shown, "hinge_heights": [5.0]}).verdicts
    assert "base is checked" not in some.extra[0].text("en") and "5 m" not in some.extra[0].text("en")


@pytest.mark.shows("risk.states")
def test_that_every_limit_state_has_its_outcome_and_a_failing_one_limits_the_verdict():
    result = made({"thickness_m": 1.5, "height_m": 6.0}, building=None, **SITE)
    (entry,) = json_report.results(result)["verdicts"]
    states = entry["states"]
    assert states["SLV"] == {"code": entry["code"], "zeta_e": entry["zeta_e"], "check": entry["check"]}
    assert states["SLD"]["check"] == "linear_sld" and states["SLC"]["check"] == "nonlinear"
    assert states["SLD"]["zeta_e"] is not None
    said = [one["key"] for one in entry["limits"]]
    failing = [s for s, one in states.items() if s != "SLV" and one["code"] == "not_verified"]
    assert said.count("other_state") == len(failing)
    without = json_report.results(made(building=None))["verdicts"][0]["states"]
    assert without["SLD"] == without["SLC"] == {"code": "no_hazard", "zeta_e": None, "check": None}


@pytest.mark.shows("risk.states")
def test_that_another_state_that_fails_is_in_limits_and_never_in_code():
    result = made({"thickness_m": 1.5, "height_m": 6.0}, building=None, **SITE)
    wall = result.walls[0]
    failing = [
        replace(state, zeta=0.6, code="not_verified")
        if state.state == "SLD"
        else replace(state, zeta=1.5, code="verified")
        for state in wall.assessment.states
    ]
    changed = replace(wall, assessment=replace(wall.assessment, states=tuple(failing)))
    (found,) = wall_verdicts(result.case, (changed,))
    assert [one.code for one in found.extra] == ["other_state"]
    assert "SLD" in found.extra[0].text("en") and "0.60" in found.extra[0].text("en")
    assert found.states["SLV"].code == wall.assessment.verdict.code


def test_that_without_a_demand_there_is_no_verdict():
    table = {"wall": [WALL], "record": [{"file": "tests/motions/noise_1.txt"}]}
    result = run(parse_case(table), base_dir=ROOT)
    assert result.verdicts == () and json_report.results(result)["verdicts"] == []


@pytest.mark.parametrize("state", ["SLV", "SLC", "SLD"])
def test_that_the_state_asked_for_is_the_verdict_itself(state):
    (entry,) = json_report.results(made(building=None, limit_state=state))["verdicts"]
    assert entry["states"][state]["code"] == entry["code"]


@pytest.mark.shows("verdict.documents")
def test_that_what_is_set_aside_and_what_is_seldom_so_are_said_with_an_outcome_that_passes():
    """A hinge set aside by a calculation is what the outcome rests on too; a load of 1 500 kN/m is asked about in the
    first place, and holds nothing back."""
    load = {"kind": "vertical", "kn_m": 1500.0, "d_m": 0.3, "h_m": 6.0, "mass": "none"}
    shown = {"kind": "calculation", "reference": "C-12"}
    wall = {"name": "w", "height_m": 6.0, "thickness_m": 0.6, "base_z_m": 0.0, "length_m": 8.0}
    wall |= {"unit_weight_kn_m3": 18.0, "hinge_heights": "base", "compressive_strength_mpa": 9.0}
    wall |= {"hold": [{"kind": "contact", "to_m": 6.0, "evidence": {"kind": "survey", "reference": "R1"}}]}
    wall |= {"load": [load], "set_aside": [{"mechanism": "overturning", "evidence": shown}]}
    wall |= {"evidence": [{"of": "compressive_strength_mpa", "kind": "test", "reference": "T1"}]}
    wall["evidence"] += [{"of": "mass", "kind": "survey", "reference": "R1"}]
    demand = {
        "ag_g": 0.05,
        "spectrum": {"code": "NTC2018", "f0": 2.4, "tc_star_s": 0.33, "soil": "A", "topography": "T1"},
    }
    building = {"height_m": 6.0, "storeys": 2}
    result = run(parse_case({"wall": [wall], "demand": demand, "building": building}), base_dir=Path())
    (verdict,) = result.verdicts
    codes = [line.code for line in verdict.extra]
    assert "odd_load" in codes and "odd_load" in [action.code for action in collect_actions(result, [verdict])]
    also = next(line for line in verdict.extra if line.code == "also_rests_on")
    assert "overturning set aside (by a calculation: C-12)" in also.text("en")
