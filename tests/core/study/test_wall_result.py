"""From runs to the result of a wall: sign, set, warnings."""

import json
import math
from dataclasses import replace

import numpy as np
import pytest

from core.case.rules import parse_case
from core.report import json_report
from core.setting.demand_input import read_demand
from core.study import run as study
from core.study.wall_result import wall_result
from core.units import G
from tests.conftest import STANDING
from tests.core.report import whole_workbook
from tests.core.study.cases import case
from tests.holds import BOUND


@pytest.mark.shows("dynamic.signs")
def test_that_the_lower_sign_governs_quantity_by_quantity(result):
    wall = result.walls[1]
    for entry in wall.per_record:
        runs = [run for run in wall.runs if run.motion == entry.motion]
        assert entry.q == min(run.ida.q for run in runs)
        assert entry.q_robust == min(run.ida.q_robust for run in runs)
        assert entry.q_slv == min(run.ida.q_slv for run in runs)


STATIONS = "AABBCCD"
"""Stations of seven files: both components of three."""


def of_stations(folder, reference, names: str, **more):
    """The study of a wall 3.0 x 0.3 m under as many short motions, written as PEER files of these stations."""
    ground = reference("standard")[0][:900] / G
    entries = []
    for k, station in enumerate(names):
        samples = np.roll(ground, 31 * k)
        lines = [
            "PEER STRONG MOTION DATABASE RECORD",
            f"Event, 1/2/1990, Station {station}, {k:03d}",
            "ACCELERATION TIME HISTORY IN UNITS OF G",
            f"NPTS= {samples.size}, DT= .01000 SEC",
            *(f"{value:.7E}" for value in samples),
        ]
        (folder / f"{k}.AT2").write_text("\n".join(lines))
        entries.append({"file": f"{k}.AT2"})
    wall = {"name": "w", "height_m": 3.0, "thickness_m": 0.3, "base_z_m": 0.0, "mechanism": "two_sided"} | BOUND
    demand = {"ag_g": 0.1, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}, "demand_scaling": "pga"}
    table = {"wall": [wall], "record": entries, "demand": demand, "analysis": {"q_step": 0.02}, **more}
    return study.run(parse_case(table), base_dir=folder)


@pytest.mark.shows("dynamic.stations")
def test_that_seven_files_of_four_stations_take_the_minimum_in_every_check(tmp_path, reference):
    wall = of_stations(tmp_path, reference, STATIONS).walls[0]
    check = wall.assessment.dynamic
    assert (wall.set_rule, check.set_rule) == ("minimum", "maximum")
    for name in ("q", "q_slv", "q_slv_low", "q_slv_robust", "q_slv_safe", "q_robust"):
        values = [getattr(entry, name) for entry in wall.per_record]
        assert len(values) == 7 and getattr(wall, f"{name}_set") == min(values) < np.mean(values)
    assert check.peak_ratio == max(run.peak_ratio for run in check.runs)
    (linear,) = (one for one in wall.assessment.checks if one.name == "linear_q_slv")
    assert linear.q == wall.q_slv_safe_set <= min(wall.q_slv_low_set, wall.q_slv_robust_set)
    (said,) = (warning for warning in wall.warnings if warning.code == "few_stations")
    assert "7 records" in said.text("en") and "4 station" in said.text("en")
    assert "4 stazioni" in said.text("it")


@pytest.mark.shows("dynamic.stations")
def test_that_seven_stations_take_the_mean_in_every_check(tmp_path, reference):
    wall = of_stations(tmp_path, reference, "ABCDEFG").walls[0]
    assert (wall.set_rule, wall.assessment.dynamic.set_rule) == ("mean", "mean")
    assert wall.q_slv_set == pytest.approx(np.mean([entry.q_slv for entry in wall.per_record]))
    assert not [warning for warning in wall.warnings if warning.code == "few_stations"]


def test_that_a_station_without_a_collapse_does_not_count(tmp_path, reference):
    """Of seven stations some stand up to the largest q searched: fewer are left, and the minimum."""
    free = of_stations(tmp_path, reference, "ABCDEFG").walls[0]
    limit = {"q_step": 0.02, "q_limit": 0.97 * max(entry.q for entry in free.per_record)}
    wall = of_stations(tmp_path, reference, "ABCDEFG", analysis=limit).walls[0]
    assert 1 <= [run.ida.status for run in wall.runs].count("no_collapse_found") <= 4
    assert free.set_rule == "mean" and wall.set_rule == "minimum" and wall.q_set == free.q_min
    assert any(warning.code == "no_collapse" for warning in wall.warnings)


def test_that_the_stations_are_counted_where_no_spectrum_is_given(tmp_path, reference):
    """Three files of one station: fewer than three stations, said as such."""
    demand = {"ag_g": 0.1, "soil_factor": 1.2}
    wall = of_stations(tmp_path, reference, "AAA", demand=demand).walls[0]
    (said,) = (reason for reason in wall.assessment.verdict.reasons if reason.code == "few_records")
    assert said.text("en").startswith("1 station")


@pytest.mark.shows("search.set")
def test_that_three_records_take_the_minimum(result):
    wall = result.walls[0]
    assert wall.set_rule == "minimum"
    assert wall.q_set == wall.q_min == min(entry.q for entry in wall.per_record)


@pytest.mark.shows("search.set")
def test_that_fewer_records_are_flagged(folder):
    few = study.run(case(record=[{"file": "r0.txt", "unit": "m/s2", "time_step_s": 0.01}]), base_dir=folder)
    assert few.walls[0].set_rule == "too_few"
    assert any(notice.code == "too_few" for notice in few.walls[0].warnings)


@pytest.mark.shows("search.set")
def test_that_a_standing_wall_is_left_out_and_counted(folder):
    found = study.run(case(wall=[STANDING], analysis={"q_step": 0.05, "q_limit": 1.5}), base_dir=folder)
    wall = found.walls[0]
    assert {run.ida.status for run in wall.runs} == {"no_collapse_found"}
    assert wall.q_set is None and wall.power_law is None
    assert any(notice.code == "no_collapse" for notice in wall.warnings)
    assert len(found.runs_without_q) == 3
    assert json.loads(json_report.dumps(found))["walls"][0]["runs"][0]["q"] is None


@pytest.mark.parametrize(
    ("wall", "code"),
    [
        ({"thickness_m": 0.05, "height_m": 1.0}, "thin"),
        ({"thickness_m": 0.12, "height_m": 4.0}, "slender"),
        ({"unit_weight_kn_m3": 8.0}, "odd_weight"),
        ({"elastic_modulus_mpa": 20.0}, "odd_modulus"),
        ({}, None),
    ],
)
def test_that_input_no_engineer_means_is_questioned(wall, code, tmp_path):
    base = {
        "name": "w",
        "height_m": 4.0,
        "thickness_m": 0.5,
        "base_z_m": 0.0,
        "mechanism": "two_sided",
        "unit_weight_kn_m3": 18.0,
        "elastic_modulus_mpa": 900.0,
    }
    asked = parse_case({"wall": [{**base, **wall}], "demand": {"ag_g": 0.2}})
    found = study.run(asked, base_dir=tmp_path)
    unusual = {"thin", "slender", "odd_weight", "odd_modulus"}
    codes = {warning.code for warning in found.walls[0].warnings} & unusual
    assert codes == ({code} if code else set())
    assert not [w for w in found.demand.warnings if w.code == "large_ag"]


@pytest.mark.shows("kinematic.q_slv")
def test_that_the_linear_check_takes_the_lower_q_slv_and_says_where_that_decides(tmp_path, reference):
    """a_g between those at which the check with the safe q SLV and with q SLV itself just passes: it fails."""

    def at(ag: float):
        demand = {"ag_g": ag, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}}
        wall = of_stations(tmp_path, reference, "ABC", demand=demand).walls[0]
        (linear,) = (check for check in wall.assessment.checks if check.name == "linear_q_slv")
        said = [reason for reason in wall.assessment.verdict.reasons if reason.code == "lower_q_slv"]
        return wall, linear, said

    wall, linear, _ = at(0.1)
    ratio, limit = wall.q_slv_set / wall.q_slv_safe_set, 0.1 * linear.zeta
    assert linear.q == wall.q_slv_safe_set and ratio > 1.001
    _, linear, (words,) = at(limit * ratio**0.5)
    assert not linear.passed and linear.zeta == pytest.approx(ratio**-0.5)
    assert f"q {wall.q_slv_safe_set:.2f}" in words.text("en")
    assert "il minore fra q SLV robusto e l'estremo inferiore" in words.text("it")
    for ag in (0.999 * limit, 1.001 * limit * ratio):  # both ends decide alike: nothing is said
        assert not at(ag)[2]


@pytest.mark.shows("kinematic.q_slv")
@pytest.mark.parametrize("stations", ["ABC", "ABCDEFG"])
def test_that_the_q_of_the_linear_check_is_the_lowest_of_each_record_whichever_that_is(tmp_path, reference, stations):
    """Of the lower ends and the robust values of both signs, some of which are missing, then the rule of the set."""
    study_result = of_stations(tmp_path, reference, stations)
    wall, rng = study_result.walls[0], np.random.default_rng(3)
    for _ in range(40):
        runs, lowest = [], {}
        for run in wall.runs:
            low, robust = rng.uniform(1.0, 9.0, 2).tolist()
            robust = None if rng.random() < 0.2 else robust
            runs.append(replace(run, ida=replace(run.ida, q_slv=9.5, q_slv_low=low, q_slv_robust=robust)))
            lowest[run.motion] = min(lowest.get(run.motion, math.inf), low, math.inf if robust is None else robust)
        asked = wall.part, wall.mechanism, wall.model, runs, study_result.motions, study_result.search, None
        found = wall_result(*asked)
        values = list(lowest.values())
        assert found.set_rule == ("mean" if len(stations) == 7 else "minimum")
        expected = np.mean(values) if len(stations) == 7 else min(values)
        assert found.q_slv_safe_set == pytest.approx(expected, rel=1e-15)
        assert found.q_slv_safe_set <= found.q_slv_low_set


@pytest.mark.parametrize("alike", ["intensity", "pga", "file"])
def test_that_records_alike_in_their_measure_end_no_study(tmp_path, alike):
    """Three records scaled to one SI or one PGA, or copies of one record a hair apart: what is optional is not given,
    with its reason, and everything else is there."""
    from core.ground.artificial import compatible_motion
    from core.ground.ground_motion import GroundMotion

    target = read_demand(parse_case({"wall": [WALL_OF_LAW], "demand": DEMAND_OF_LAW}), tmp_path).target
    records = []
    for k in range(3):
        motion = compatible_motion(target, 1 if alike == "file" else k + 1)
        made = GroundMotion("m", motion, 0.01)
        factor = {"intensity": 1.0 / made.housner_intensity, "pga": 3.0 / made.pga, "file": 1.0 + 1e-6 * k}[alike]
        np.savetxt(tmp_path / f"r{k}.txt", factor * motion)
        records.append({"file": f"r{k}.txt", "unit": "m/s2", "time_step_s": 0.01})
    case = parse_case({"wall": [WALL_OF_LAW], "record": records, "demand": DEMAND_OF_LAW, "analysis": {"q_step": 0.05}})
    result = study.run(case, base_dir=tmp_path)
    (wall,) = result.walls
    given = wall.power_law is not None
    assert alike == "pga" or not given
    assert ("no_power_law" in {warning.code for warning in wall.warnings}) == (not given)
    assert json_report.dumps(result) and whole_workbook.build(result, [])


WALL_OF_LAW = {"name": "w", "height_m": 5.0, "thickness_m": 0.5, "base_z_m": 0.0, "mechanism": "two_sided"}
DEMAND_OF_LAW = {"ag_g": 0.2, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}}
