"""What the checks of a wall say together: the one that decides, its judgement, what a verdict must know beside it."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.case.rules import parse_case
from core.codes.multiplier_search import Precision
from core.codes.outcomes import FAILS, OPEN, PASSES
from core.errors import InputError
from core.ground.ground_motion import GroundMotion
from core.rocking.methods import AUTO, METHODS
from core.setting.plan import make_plan, read_inputs
from core.variation import evaluate as evaluate_module
from core.variation.evaluate import AT_LIMIT, BUNDLED_HEADER, COARSE_PRECISION, check_by_histories, evaluate
from tests.conftest import COARSE
from tests.core.variation.one_evaluation import BARE, MOTION, NTC, SOIL, WALL, history, scene_of, with_histories
from tests.core.variation.random_walls import accepted, table_of
from tests.holds import carries

TIE = {"kind": "tie", "out_kn_m": 1.0, "h_m": 4.0, "bar_length_m": 6.0}


def judged(zeta=1.3, wall=WALL, demand=SOIL, by_default=False, **values):
    """The evaluation of a wall whose histories say this."""
    return evaluate(with_histories(scene_of(wall, demand), lambda *_: history(zeta, **values), by_default=by_default))


@pytest.mark.shows("dynamic.exact_methods")
@pytest.mark.parametrize("method", [AUTO, *METHODS.values()], ids=lambda method: method.name)
def test_that_a_verdict_rests_on_the_methods_that_solve_the_equation_alone(method):
    """The series of Taylor and Dormand and Prince; the others are there for comparison."""
    exact = evaluate(scene_of().replace_parts(method=method)).evidence.circumstances.exact
    assert exact == (method.name in ("auto", "taylor", "taylor_6", "dormand_prince"))


def test_that_the_low_end_of_zeta_is_that_of_its_spread_where_it_has_one():
    assert judged(1.3, zeta_spread=(1.2, 1.4)).low == 1.2
    assert judged(1.3).low == 1.3
    alone = evaluate(scene_of())
    assert alone.low == alone.zeta == pytest.approx(2.0 * 0.05 / (1.35 * 0.1))


@pytest.mark.parametrize(
    "spread, holds, judgement",
    [
        ((1.01, 1.4), True, PASSES),
        ((1.0, 1.4), True, AT_LIMIT),
        ((0.9, 1.4), True, AT_LIMIT),
        ((0.9, 1.4), False, PASSES),
        (None, True, PASSES),
    ],
)
def test_that_histories_whose_spread_contains_what_is_required_are_at_their_limit(spread, holds, judgement):
    found = judged(1.3, zeta_spread=spread, holds_at_target=holds)
    assert found.judgement(found.decides) == judgement and found.satisfied == (judgement == PASSES)
    linear = found.made("linear_q_code")  # FC is 1.35: it fails whatever the histories are near
    assert found.judgement(linear) == FAILS and found.judgement(replace(linear, passed=True)) == PASSES


def test_that_a_check_that_was_not_made_or_has_no_number_leaves_its_wall_open():
    found = judged(None, passed=False)
    assert found.decides.name == "dynamic" and found.judgement(found.decides) == OPEN and not found.satisfied
    assert found.judgement(None) == OPEN and found.made("nonlinear") is None
    failing = judged(None, passed=False, fails_at_target=True)
    assert failing.judgement(failing.decides) == FAILS


@pytest.mark.shows("dynamic.by_default")
@pytest.mark.parametrize(
    "zeta, values, decides",
    [
        (1.2, {}, "dynamic"),
        (3.0, {}, "nonlinear"),
        (3.0, {"passed": False}, "dynamic"),
        (3.0, {"zeta_spread": (0.9, 3.2)}, "dynamic"),
        (None, {"passed": False}, "dynamic"),
    ],
)
def test_that_of_histories_by_default_and_displacement_check_the_worse_decides(zeta, values, decides):
    """Given records decide whatever they say."""
    demand = {"ag_g": 0.05, "spectrum": NTC}
    found = judged(zeta, demand=demand, by_default=True, **values)
    assert 1.2 < found.made("nonlinear").zeta < 3.0
    assert found.decides.name == decides and {check.name for check in found.checks[:2]} == {"dynamic", "nonlinear"}
    assert found.checks[2].name == "linear_q_code" and len(found.checks) == 3
    assert judged(zeta, demand=demand, **values).decides.name == "dynamic"


def test_that_a_check_that_fails_decides_over_one_that_passes_and_of_two_that_fail_the_lower_zeta():
    found = judged(1.1, demand={"ag_g": 0.1, "spectrum": NTC}, by_default=True)
    assert found.made("nonlinear").zeta < 1.0 and found.decides.name == "nonlinear"
    both = judged(0.2, demand={"ag_g": 0.1, "spectrum": NTC}, by_default=True, passed=False)
    assert both.made("nonlinear").zeta > 0.2 and both.decides.name == "dynamic"


def test_that_a_glance_has_no_outcome():
    scene = with_histories(scene_of(), lambda *_: history(1.3))
    assert evaluate(scene).outcome == "indicative" and evaluate(scene, COARSE_PRECISION).outcome == "undetermined"


@pytest.mark.parametrize("asked, other", [({}, True), ({"other": True}, True), ({"other": False}, False)])
def test_that_fc_on_the_other_side_is_looked_at_too_unless_it_is_not_asked(asked, other):
    def said(*parts):
        *_, every, searched, cancelled = parts
        assert (every, searched, cancelled()) == (Precision(COARSE), other, False)
        return history(1.3)

    scene = replace(scene_of(), ground=(MOTION,), histories=said, histories_off=False)
    assert evaluate(scene, **asked).zeta == 1.3


def test_that_a_wall_above_the_ground_has_no_check_without_its_building():
    found = evaluate(scene_of(WALL | {"base_z_m": 3.0}))
    assert (found.kinematic, found.dynamic, found.checks, found.zeta, found.low) == (None, None, (), None, None)


def test_that_a_wall_that_falls_by_itself_is_refused_with_its_threshold():
    """Uplift of 4.0 x 0.4 m, hinge at 0.1 m: W 28.8 kN/m at 0.1 m; a thrust of 0.72 kN/m at 4 m brings it to zero."""
    scene = scene_of(BARE | {"load": [{"kind": "thrust", "kn_m": 0.5, "h_m": 4.0}]})
    (thrust,) = scene.wall.load
    assert evaluate(scene).zeta == pytest.approx(2.0 * (28.8 * 0.1 - 0.5 * 4.0) / (28.8 * 2.0) / (1.35 * 0.1))
    for kn_m in (0.7201, 0.75):
        with pytest.raises(InputError) as error:
            evaluate(scene.replace_parts(wall=replace(scene.wall, load=(replace(thrust, kn_m=kn_m),))))
        assert error.value.code == "unstable_under_loads"


@pytest.mark.parametrize(
    "given", [[], [TIE], [{"kind": "vertical", "kn_m": 9.0, "d_m": 0.2, "h_m": 4.0, "mass": "horizontal"}]]
)
def test_that_q_of_the_searches_multiplies_what_uplifts_the_wall_without_its_ties(given):
    """zeta = q alpha_0 g / (FC a_g S): neither e* nor what a tie adds counts, alpha_0 by hand (C8.7.1.1)."""
    scene = scene_of(carries(*given, **BARE))
    alpha = 0.05 if not given or given[0]["kind"] == "tie" else (28.8 + 9.0) * 0.1 / (28.8 * 2.0 + 9.0 * 4.0)
    found = evaluate(scene.replace_parts(q_slv=(1.5, 1.8))).made("linear_q_slv")
    assert found.zeta == pytest.approx(1.5 * alpha / (1.35 * 0.1))
    assert evaluate(scene).made("linear_q_slv") is None


@pytest.mark.parametrize(
    "q, said",
    [((2.5, 2.8), True), ((2.75, 2.8), False), ((2.5, 2.65), False), ((None, 2.8), False), ((2.5, None), False)],
)
def test_that_a_linear_check_that_fails_by_the_spread_of_its_q_alone_is_said(q, said):
    """It takes q = 2.70 to reach zeta 1."""
    words = evaluate(scene_of().replace_parts(q_slv=q)).lower_q_remark
    assert (words is not None) == said
    if words:
        assert words.code == "lower_q_slv" and dict(words.values) == {"low": q[0], "q": q[1]}


def test_that_a_verdict_knows_the_strongest_motion_and_whether_one_is_of_the_example():
    weak = GroundMotion("s", 0.5 * np.sin(np.arange(200) / 10.0), 0.01, details=(("a", f"{BUNDLED_HEADER} 3"),))
    for ground, bundled in (((MOTION,), False), ((MOTION, weak), True), ((weak,), True)):
        seen = evaluate(with_histories(scene_of(), lambda *_: history(1.3), ground)).evidence.circumstances
        assert seen.strongest == pytest.approx(1.0 if MOTION in ground else 0.5, rel=1e-3) and seen.bundled == bundled
        assert seen.stations == len(ground)
    assert evaluate(scene_of()).evidence.circumstances.strongest == 0.0
    scaled = SOIL | {"demand_scaling": "pga"}
    of_scaled = judged(demand=scaled).evidence.circumstances
    assert of_scaled.strongest == pytest.approx(0.1 * 9.80665)


@pytest.mark.shows("dynamic.signs")
@pytest.mark.parametrize(
    "mechanism, polarity, both",
    [
        ("one_sided", "both", True),
        ("one_sided", "as_recorded", False),
        ("one_sided", "reversed", False),
        ("two_sided", "as_recorded", True),
    ],
)
def test_that_a_one_sided_wall_asks_for_each_record_with_both_signs(mechanism, polarity, both):
    wall = WALL | {"mechanism": mechanism}
    assert evaluate(scene_of(wall).replace_parts(polarity=polarity)).evidence.circumstances.both_signs == both


PARAPET = {"name": "p", "height_m": 1.2, "thickness_m": 0.25, "mechanism": "two_sided", "base_z_m": 0.0}
PARAPET |= {"unit_weight_kn_m3": 18.0, "unloaded_confirmed": True}


@pytest.mark.shows("kinematic.branch")
@pytest.mark.parametrize(
    "zetas, calls, worst",
    [
        ({"soft": (1.4, True), "stiff": (1.2, True)}, 2, 1.2),
        ({"soft": (1.2, True), "stiff": (1.4, True)}, 2, 1.2),
        ({"soft": (1.2, True), "stiff": (1.4, False)}, 2, 1.4),
        ({"soft": (1.2, True), "stiff": (None, True)}, 2, None),
        ({"soft": (0.9, False), "stiff": (0.5, False)}, 1, 0.9),
    ],
)
def test_that_the_worst_branch_decides_and_of_an_assumed_modulus_the_soft_end_is_enough_where_it_fails(
    zetas, calls, worst
):
    scene, seen = scene_of(PARAPET), []
    soft, stiff = scene.branches
    assert soft.assumed and soft.modulus < stiff.modulus and soft.limit > stiff.limit

    def said(model, *_):
        seen.append(model.plateau_end)
        zeta, passed = zetas["soft" if model.plateau_end == soft.of(scene.model).plateau_end else "stiff"]
        return history(zeta, passed)

    assert check_by_histories(with_histories(scene, said)).zeta == worst and len(seen) == calls


@pytest.mark.parametrize("walls", [8, pytest.param(80, marks=pytest.mark.long)])
def test_that_the_worst_branch_is_that_of_searches_to_their_end(walls):
    """Random walls that bend, and elements free to vibrate, under motions: a branch is searched as far as that before
    it, which changes neither the worst nor its numbers; FC on the other side is of the worst."""
    seen, seed = 0, 0
    while seen < walls:
        table = table_of(seed, histories=True) | {"analysis": {"q_step": 0.1}}
        seed += 1
        if accepted(table) is None:
            continue
        try:
            case = parse_case(table)
            inputs = read_inputs(case, Path())
            scenes = [make_plan(case, inputs).scene(0, inputs[0])]
            branches = scenes[0].branches
        except InputError:
            continue
        if len(branches) < 2:
            continue
        seen += 1
        scene = scenes[0]
        precision = Precision(evaluate_module.FINEST)
        parts = scene.motions, scene.signs, scene.demand, scene.method, precision, True
        every = [replace(scene.histories(branch.of(scene.model), *parts), branch=branch) for branch in branches]
        worst = min(every, key=lambda check: (check.passed, check.zeta is not None, check.zeta or 0.0))
        softest_fails = branches[0].assumed and not every[0].satisfied(scene.demand.zeta_target)
        assert check_by_histories(scene, precision, other=True) == (every[0] if softest_fails else worst)


def test_that_with_a_given_modulus_both_branches_are_analysed_though_the_first_fails():
    scene, seen = scene_of(PARAPET | {"elastic_modulus_mpa": 1000.0}), []

    def said(model, *_):
        seen.append(model.plateau_end)
        return history(0.9 - 0.1 * len(seen), False)

    found = check_by_histories(with_histories(scene, said))
    assert len(set(seen)) == 2 and found.zeta == pytest.approx(0.7) and not found.branch.assumed


def test_that_histories_are_of_the_model_as_it_is_where_it_has_no_branch_and_none_without_records():
    rigid = scene_of(PARAPET | {"law": "rigid"})
    said = check_by_histories(with_histories(rigid, lambda model, *_: history(1.1 + model.plateau_end)))
    assert said.zeta == 1.1 and said.branch is None and check_by_histories(rigid) is None


@pytest.mark.parametrize(
    "change, unbranched",
    [
        ({}, ""),
        ({"law": "rigid"}, ""),
        ({"height_m": 4.0, "elastic_modulus_mpa": 20.0}, "does_not_rock"),
        ({"hold": [TIE | {"h_m": 1.0}]}, "rigid_free"),
    ],
)
def test_that_histories_of_a_free_element_without_a_branch_say_why(change, unbranched):
    wall = {key: value for key, value in (PARAPET | change).items() if value is not False}
    assert evaluate(scene_of(wall)).evidence.circumstances.unbranched == unbranched
