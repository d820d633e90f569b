"""The checks of a changed wall are those of its run."""

from dataclasses import replace

import numpy as np
import pytest

from core.case.rules import parse_case
from core.codes.dynamic_check import DemandCheck
from core.errors import InputError
from core.study.plan import plan_of, read_inputs
from core.study.run import run
from core.study.what_if import NONE, model_of_theory, setting_of, with_demand, with_wall, zetas
from tests.conftest import ROOT
from tests.core.study.test_sensitivity import CASES, LOADED, case_of


def test_that_zeta_of_all_hinges_is_that_of_the_run():
    table = case_of(LOADED, building={"height_m": 6.0, "storeys": 3, "period_s": 0.3})
    result = run(parse_case(table), base_dir=CASES)
    case = parse_case(table)
    found = zetas(setting_of(case, 0, CASES, read_inputs(case, CASES)))
    assert len(result.walls) > 1
    for label, zeta in found.by_check.items():
        each = [check.zeta for wall in result.walls for check in wall.assessment.checks if check.label == label]
        assert zeta == min(each), label
    verdict = result.walls[result.verdicts[0].governing].assessment.verdict
    assert found.zeta == verdict.zeta_e and found.sure == (verdict.zeta_e >= 1.0)


def test_that_every_point_of_the_grid_gives_zeta_of_the_run():
    from core.case.reader import read_case

    case = read_case(ROOT / "resources" / "cases" / "example.toml")
    inputs = read_inputs(case, CASES)
    result = run(case, base_dir=CASES)
    for k, verdict in enumerate(result.verdicts):
        found = zetas(setting_of(case, k, CASES, inputs), every=1)
        assert found.by_check["dynamic"] == result.walls[verdict.governing].assessment.dynamic.zeta
        kinematic = zetas(setting_of(case, k, CASES, inputs), every=0)
        assert "dynamic" not in kinematic.by_check and set(kinematic.by_check) < set(found.by_check)


def test_that_a_wall_that_breaks_a_rule_is_refused():
    case = parse_case(case_of(LOADED))
    here = setting_of(case, 0, CASES, read_inputs(case, CASES))
    with pytest.raises(InputError):
        with_wall(here, replace(here.case.wall[0], hinge_setback_m=0.4))


def check_of(zeta, passed=True, spread=None):
    """Of histories, with what a wall is judged by."""
    return DemandCheck("SLV", (), 0, 0.2, 0.3, "mean", 0.4, zeta, passed, passed, zeta_spread=spread)


FAILS, NEAR, HOLDS = check_of(0.8, False, (0.7, 0.9)), check_of(1.1, True, (0.95, 1.2)), check_of(1.5, True, (1.3, 1.6))


@pytest.mark.parametrize(
    "each, satisfied, sure",
    [
        ((HOLDS, HOLDS), True, True),
        ((NEAR, HOLDS), None, False),
        ((HOLDS, NEAR), None, False),
        ((NEAR, FAILS), False, False),
        ((FAILS, NEAR), False, False),
        ((HOLDS, FAILS), False, False),
    ],
)
def test_that_a_wall_is_as_its_hinges_are_together(each, satisfied, sure):
    """Satisfied where all are, not known where a spread holds what is required; the lowest zeta and the lowest end."""
    table = case_of(LOADED, building={"height_m": 6.0, "storeys": 2, "period_s": 0.3}, generate={"count": 7})
    case = parse_case(table)
    left = list(each)

    def book(model, motions, signs, demand, method, every, other, cancelled):
        assert not other  # what FC on the other side gives is asked for by none
        return left.pop(0)

    inputs = read_inputs(case, CASES)
    found = zetas(setting_of(case, 0, CASES, inputs, book))
    assert not left
    assert (found.satisfied["dynamic"], found.sure) == (satisfied, sure)
    assert found.zeta == found.by_check["dynamic"] == min(one.zeta for one in each)
    assert found.low == min(one.zeta_spread[0] for one in each)
    kinematic = zetas(setting_of(case, 0, CASES, inputs), every=0)
    assert {label: found.satisfied[label] for label in kinematic.satisfied} == kinematic.satisfied
    assert kinematic.satisfied and None not in kinematic.satisfied.values()


def test_that_only_records_used_as_given_follow_a_g():
    case = parse_case(case_of(LOADED, generate={"count": 2}))
    here = setting_of(case, 0, CASES, read_inputs(case, CASES))
    before = here.inputs[1]
    for share in (0.9, 1.1):
        demand = replace(here.demand, pga=share, record_scaling="as_given")
        after = with_demand(replace(here, inputs=(replace(here.demand, pga=1.0), *here.inputs[1:])), demand).inputs[1]
        for one, other in zip(before, after, strict=True):
            assert np.array_equal(other.acceleration, share * one.acceleration)
        demand = replace(demand, record_scaling="pga")
        assert with_demand(here, demand).inputs[1] == before


def test_that_a_wall_that_does_not_stand_is_satisfied_by_nothing():
    assert NONE.zeta is None and NONE.by_check == {} and not NONE.sure


@pytest.mark.parametrize("mechanism", ["one_sided", "two_sided"])
def test_that_a_velocity_ratio_is_a_share_of_the_theoretical_and_at_most_one(mechanism):
    """An impact gives no energy."""
    wall = {**LOADED, "mechanism": mechanism, "velocity_ratio": 0.5}
    case = parse_case(case_of(wall, generate={"count": 2}))
    here = setting_of(case, 0, CASES, read_inputs(case, CASES))
    (entry,) = plan_of(here.case, CASES, here.inputs).entries
    theory, least, most = (model_of_theory(entry, factor) for factor in (1.0, 0.9, 5.0))
    assert entry.model.ratio_at_rest == 0.5 < theory.ratio_at_rest < 1.0
    assert least.ratio_at_rest == pytest.approx(0.9 * theory.ratio_at_rest, rel=1e-12)
    assert most.ratio_at_rest == 1.0
    if mechanism == "two_sided":  # the impact on the inner edge has its own
        inward = [model.other.ratio_at_rest for model in (theory, least, most)]
        assert inward[0] != theory.ratio_at_rest
        assert inward[1] == pytest.approx(0.9 * inward[0], rel=1e-12) and inward[2] == 1.0


def test_that_histories_decide_where_there_are_records():
    case = parse_case(case_of(LOADED, generate={"count": 2}))
    here = setting_of(case, 0, CASES, read_inputs(case, CASES))
    assert here.has_histories
    demand, motions, kinds = here.inputs
    for other in ((demand, [], kinds), (replace(demand, limit_state="SLD"), motions, kinds)):
        assert not replace(here, inputs=other).has_histories
