"""From runs to the result of a wall: sign, set, warnings."""

import json

import pytest

from core.case.rules import parse_case
from core.report import json_report
from core.study import run as study
from core.study.wall_result import set_rule, set_value
from tests.conftest import STANDING
from tests.core.study.cases import case


def test_that_the_lower_sign_governs_quantity_by_quantity(result):
    wall = result.walls[1]
    for entry in wall.per_record:
        runs = [run for run in wall.runs if run.record == entry.record]
        assert entry.q == min(run.ida.q for run in runs)
        assert entry.q_robust == min(run.ida.q_robust for run in runs)
        assert entry.q_slv == min(run.ida.q_slv for run in runs)


@pytest.mark.parametrize(
    "values, expected",
    [
        ([], None),
        ([None, None], None),
        ([2.0, None], 2.0),
        ([3.0, 2.0, 4.0], 2.0),
        ([3.0, 2.0, 4.0, 5.0, 6.0, 7.0], 2.0),
        ([1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0], 4.0),
        ([1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, None], 4.0),
    ],
)
def test_that_a_set_is_its_mean_from_seven_numbers_else_its_minimum(values, expected):
    numbers = sum(value is not None for value in values)
    assert set_value(values, set_rule(numbers)) == expected
    assert set_value(values, "incomplete") is None


def test_that_one_rule_holds_for_every_quantity_of_a_set():
    """Six records collapse, a seventh only reaches 0.40 alpha: q and q_slv are both minima."""
    assert set_value([2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0], set_rule(6)) == 2.0


def test_that_three_records_take_the_minimum(result):
    wall = result.walls[0]
    assert wall.set_rule == "minimum"
    assert wall.q_set == wall.q_min == min(entry.q for entry in wall.per_record)


def test_that_fewer_records_are_flagged(folder):
    few = study.run(
        case(record=[{"file": "r0.txt", "unit": "m/s2", "time_step_s": 0.01}]), base_dir=folder
    )
    assert few.walls[0].set_rule == "too_few"
    assert any(notice.code == "too_few" for notice in few.walls[0].warnings)


def test_that_a_standing_wall_is_left_out_and_counted(folder):
    found = study.run(
        case(wall=[STANDING], analysis={"q_step": 0.05, "q_limit": 1.5}), base_dir=folder
    )
    wall = found.walls[0]
    assert {run.ida.status for run in wall.runs} == {"no_collapse_found"}
    assert wall.q_set is None and wall.power_law is None
    assert any(notice.code == "no_collapse" for notice in wall.warnings)
    assert len(found.without_number) == 3
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
    base = {"name": "w", "height_m": 4.0, "thickness_m": 0.5, "base_z_m": 0.0, "mechanism": "two_sided",
            "unit_weight_kn_m3": 18.0, "elastic_modulus_mpa": 900.0}  # fmt: skip
    asked = parse_case({"wall": [{**base, **wall}], "demand": {"ag_g": 0.2}})
    found = study.run(asked, base_dir=tmp_path)
    unusual = {"thin", "slender", "odd_weight", "odd_modulus"}
    codes = {warning.code for warning in found.walls[0].warnings} & unusual
    assert codes == ({code} if code else set())
    assert not [w for w in found.demand.warnings if w.code == "large_ag"]
