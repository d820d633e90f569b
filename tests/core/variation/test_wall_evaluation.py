"""The checks of a changed wall are those of its run."""

from dataclasses import replace

import numpy as np
import pytest

from core.codes.dynamic_check import DynamicCheck
from core.codes.multiplier_search import Precision
from core.codes.outcomes import FAILS, PASSES
from core.errors import InputError
from core.setting.plan import read_inputs
from core.study.run import run
from core.variation.changes import scale_theory_ratio
from core.variation.wall_evaluation import (
    NO_EVALUATION,
    drop_record,
    evaluate_wall,
    make_wall_context,
    replace_demand,
    replace_wall,
)
from tests.clauses_alone import parse_case
from tests.conftest import ROOT
from tests.core.variation.test_sensitivity import CASES, LOADED, case_of


def test_that_zeta_of_all_hinges_is_that_of_the_run():
    table = case_of(LOADED, building={"height_m": 6.0, "storeys": 3, "period_s": 0.3})
    result = run(parse_case(table), base_dir=CASES)
    case = parse_case(table)
    found = evaluate_wall(make_wall_context(case, 0, CASES, read_inputs(case, CASES)))
    assert len(result.walls) > 1
    for label, zeta in found.by_check.items():
        each = [check.zeta for wall in result.walls for check in wall.assessment.checks if check.label == label]
        assert zeta == min(each), label
    (verdict,) = result.verdicts
    assert found.zeta == verdict.zeta_least and found.sure == (verdict.zeta_least >= 1.0)


@pytest.mark.long
def test_that_every_point_of_the_grid_gives_zeta_of_the_run():
    from core.case.reader import read_case

    case = read_case(ROOT / "resources" / "cases" / "example.toml")
    inputs = read_inputs(case, CASES)
    result = run(case, base_dir=CASES)
    for k, verdict in enumerate(result.verdicts):
        found = evaluate_wall(make_wall_context(case, k, CASES, inputs))
        assert found.by_check["dynamic"] == result.walls[verdict.governing].assessment.dynamic.zeta
        kinematic = evaluate_wall(make_wall_context(case, k, CASES, inputs), None)
        assert "dynamic" not in kinematic.by_check and set(kinematic.by_check) < set(found.by_check)


def test_that_a_wall_that_breaks_a_rule_is_refused():
    case = parse_case(case_of(LOADED))
    here = make_wall_context(case, 0, CASES, read_inputs(case, CASES))
    with pytest.raises(InputError):
        replace_wall(here, replace(here.case.wall[0], hinge_setback_m=0.4))


def check_of(zeta, passed=True, spread=None):
    """Of histories, with what a wall is judged by."""
    return DynamicCheck("SLV", (), 0, 0.2, 0.3, "mean", 0.4, zeta, passed, passed, zeta_spread=spread)


DOWN, NEAR, UP = check_of(0.8, False, (0.7, 0.9)), check_of(1.1, True, (0.95, 1.2)), check_of(1.5, True, (1.3, 1.6))


@pytest.mark.parametrize(
    "each, satisfied, judgement",
    [
        ((UP, UP), True, PASSES),
        ((NEAR, UP), None, FAILS),
        ((UP, NEAR), None, FAILS),
        ((NEAR, DOWN), False, FAILS),
        ((DOWN, NEAR), False, FAILS),
        ((UP, DOWN), False, FAILS),
    ],
)
def test_that_a_wall_is_as_its_hinges_are_together(each, satisfied, judgement, fine):
    """Satisfied where all are, not known where a spread holds what is required, which counts as failed; the lowest
    zeta."""
    table = case_of(
        LOADED, building={"height_m": 6.0, "storeys": 2, "period_s": 0.3}, generate={"scatter": 0.0, "count": 7}
    )
    case = parse_case(table)
    left = list(each)

    def histories(model, motions, signs, demand, method, precision, other, cancelled):
        assert not other and precision == Precision()
        return left.pop(0)

    inputs = read_inputs(case, CASES)
    found = evaluate_wall(make_wall_context(case, 0, CASES, inputs, histories))
    assert not left
    assert (found.satisfied["dynamic"], found.sure) == (satisfied, judgement == PASSES)
    assert found.zeta == found.by_check["dynamic"] == min(one.zeta for one in each)
    clauses = evaluate_wall(make_wall_context(case, 0, CASES, inputs), None)
    assert {label: found.satisfied[label] for label in clauses.satisfied} == clauses.satisfied
    assert clauses.satisfied and None not in clauses.satisfied.values()


def test_that_only_records_used_as_given_follow_a_g():
    case = parse_case(case_of(LOADED, generate={"scatter": 0.0, "count": 2}))
    here = make_wall_context(case, 0, CASES, read_inputs(case, CASES))
    before = here.inputs[1]
    for share in (0.9, 1.1):
        demand = replace(here.demand, pga=share, record_scaling="as_given")
        after = replace_demand(replace(here, inputs=(replace(here.demand, pga=1.0), *here.inputs[1:])), demand).inputs[
            1
        ]
        for one, other in zip(before, after, strict=True):
            assert np.array_equal(other.acceleration, share * one.acceleration)
        demand = replace(demand, record_scaling="pga")
        same = replace_demand(here, demand).inputs[1]
        assert all(one is other for one, other in zip(same, before, strict=True))


def test_that_a_record_is_left_out_with_its_kind_and_no_other():
    case = parse_case(case_of(LOADED, generate={"scatter": 0.0, "count": 3}))
    here = make_wall_context(case, 0, CASES, read_inputs(case, CASES))
    demand, motions, _ = here.inputs
    here = replace(here, inputs=(demand, motions, ["first", "second", "third"]))
    for k, left in enumerate(((1, 2), (0, 2), (0, 1))):
        less, fewer, named = drop_record(here, k).inputs
        assert less is demand and fewer == [motions[n] for n in left]
        assert named == [("first", "second", "third")[n] for n in left]


def test_that_a_wall_that_does_not_stand_is_satisfied_by_nothing():
    assert NO_EVALUATION.zeta is None and NO_EVALUATION.by_check == {} and not NO_EVALUATION.sure


@pytest.mark.parametrize("mechanism", ["one_sided", "two_sided", "both"])
def test_that_a_velocity_ratio_is_a_share_of_the_theoretical_and_at_most_one(mechanism):
    """An impact gives no energy; of the ratios of a wall with two the larger one."""
    wall = {**LOADED, "mechanism": mechanism, "velocity_ratio": 0.5}
    own = parse_case(case_of(wall, generate={"scatter": 0.0, "count": 2})).wall[0]
    by_theory = replace(own, velocity_ratio=None)
    theory = [by_theory.restitution_of(one) for one in own.mechanisms()]
    largest = max(ratio for one in theory for ratio in (one.ratio_at_rest, one.ratio_inward or 0.0))
    assert scale_theory_ratio(own, 0.9).velocity_ratio == pytest.approx(0.9 * largest, rel=1e-12)
    assert scale_theory_ratio(own, 5.0).velocity_ratio == 1.0


def test_that_histories_decide_where_there_are_records():
    case = parse_case(case_of(LOADED, generate={"scatter": 0.0, "count": 2}))
    here = make_wall_context(case, 0, CASES, read_inputs(case, CASES))
    assert here.has_histories
    demand, motions, kinds = here.inputs
    for other in ((demand, [], kinds), (replace(demand, limit_state="SLD"), motions, kinds)):
        assert not replace(here, inputs=other).has_histories
