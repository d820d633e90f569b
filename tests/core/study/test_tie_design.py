"""The force of a tie for the zeta required: linear checks have it in closed form."""

from pathlib import Path

import pytest

from core.case.rules import parse_case
from core.codes.kinematic import kinematic, linear
from core.study import run as study
from core.study.demand_input import demand_of
from core.study.tie_design import tie_design, with_tie
from core.units import G
from tests.validation.test_loaded_walls import DEMAND, ROOF, THRUST, WALL, case_of


def designed(wall, target, case):
    demand = demand_of(case, Path())

    def judged(force, step):
        found = kinematic(with_tie(wall, force), "one_sided", demand)
        zeta = linear("linear_q_code", found, demand, 2.0).zeta
        return zeta, zeta >= target

    return demand, tie_design(wall, judged(0.0, 0.0), "linear_q_code", judged)


def test_that_the_force_is_that_of_the_balance_of_moments():
    """zeta = q alpha_0 g / (e* FC a_g S): alpha_0 = zeta FC 0.312 / 2 = (5.4675 + 3 - 5 + 2.9 F) / 36.45."""
    case = case_of(ROOF, THRUST, tie_height_m=2.9)
    demand, found = designed(case.wall[0], 1.0, case)
    alpha0 = 1.35 * demand.pga / G / 2.0
    by_hand = (alpha0 * 36.45 - (5.4675 + 3.0 - 5.0)) / 2.9
    assert by_hand * 1e3 <= found.force <= 1.016 * by_hand * 1e3
    assert found.zeta >= 1.0 and found.alpha0 == pytest.approx(alpha0, rel=0.01)
    assert sum(found.holding) / found.pushing == found.alpha0


def test_that_no_tie_is_needed_or_none_is_enough_is_said():
    case = case_of(ROOF, tie_height_m=2.9)
    _, enough = designed(case.wall[0], 1.0, case)
    assert enough.force == 0.0 and enough.zeta > 1.0
    _, never = designed(case.wall[0], 10.0, case)
    assert never.force is None and never.zeta < 10.0 and never.largest > 1e3


def test_that_of_several_hinges_the_weakest_asks_the_force(tmp_path):
    wall = {
        **WALL,
        "height_m": 6.0,
        "load": [{**ROOF, "h_m": 6.0}, {**THRUST, "h_m": 6.0, "kn_m": 1.0}],
        "tie_height_m": 5.5,
        "hinge_heights": [3.0],
    }
    building = {"height_m": 9.0, "storeys": 3, "period_s": 0.26}
    table = {"wall": [wall], "demand": DEMAND, "building": building}
    result = study.run(parse_case(table), base_dir=tmp_path)
    ties = [one.assessment.tie for one in result.walls]
    assert [tie.height for tie in ties] == [5.5, 2.5] and ties[0].hinges == 2
    forces = [tie.force for tie in ties]
    assert {tie.governing for tie in ties} == {None if None in forces else max(forces)}


def test_that_the_tie_found_in_a_study_brings_the_dynamic_check_to_its_target(tmp_path):
    wall = {**WALL, "load": [ROOF, {**THRUST, "kn_m": 2.5}], "tie_height_m": 2.9, "back_restraint": "cross walls"}
    table = {"wall": [wall], "demand": DEMAND, "generate": {"count": 3}, "analysis": {"q_step": 0.02}}
    found = study.run(parse_case(table), base_dir=tmp_path).walls[0].assessment
    assert found.verdict.zeta_e < 1.0 and found.tie.force > 0.0
    tie = {"kind": "tie", "kn_m": 1e-3 * found.tie.force, "h_m": 2.9}
    held = {**wall, "load": [*wall["load"], tie]}
    again = study.run(parse_case({**table, "wall": [held]}), base_dir=tmp_path).walls[0].assessment
    assert again.verdict.governing == found.verdict.governing == "dynamic"
    assert again.verdict.zeta_e >= 1.0 and again.verdict.code in ("indicative", "verified", "verified_refined")
    assert again.dynamic.passed and not again.dynamic.within_spread(1.0)
    assert again.tie.force == 0.0
