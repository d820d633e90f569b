"""Broken on purpose: where a method or a rule fails, by how much, and that the default does not.

Each wrong variant is the product with one name replaced (wrong_methods.py); truth is the 40-digit
reference, 30 digits, a closed form, or the definition itself.
"""

import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.capacity.ida import Search, incremental_dynamic_analysis
from core.jit.decorators import kernel
from core.rocking.compared import stepped
from core.rocking.history import integrate_history
from core.rocking.methods import METHODS, Method
from core.rocking.outcome import IMPACT_LIMIT, STABLE
from core.units import G
from core.wall.block import Block
from core.wall.moment_rotation import LAWS
from core.wall.restitution import overturning_velocity, restitution
from core.wall.rocking_model import RockingModel, rocking_model
from tests.validation import high_precision, wrong_methods
from tests.validation.wrong_methods import stepped_history, taylor_history

DT = 0.01


def off(rotation, truth, model) -> float:
    """Largest error / alpha over the samples both have."""
    size = min(rotation.size, truth.size)
    return float(np.abs(rotation[:size] - truth[:size]).max() / model.slenderness)


@pytest.mark.shows("mechanics.uplift")
@pytest.mark.parametrize(
    "name, wrong, right", [("standard", 0.01, 1e-12), pytest.param("hard", 0.1, 1e-11, marks=pytest.mark.long)]
)
def test_uplift_taken_at_the_next_sample(reference, make_model, name, wrong, right):
    ground, truth, _, _ = reference(name)
    model = make_model()
    truth = truth * model.slenderness
    late, _ = taylor_history(wrong_methods.uplift_at_next_sample, ground, DT, model)
    assert off(late, truth, model) > wrong
    assert off(integrate_history(ground, DT, 1.0, model).rotation, truth, model) < right


@pytest.mark.long
def test_impact_at_the_end_of_the_step_does_not_converge_on_hard(reference, make_model):
    ground, truth, _, _ = reference("hard")
    model = make_model()
    truth = truth * model.slenderness
    errors = []
    for k in (1, 2, 4):
        fine = np.interp(np.arange(k * (ground.size - 1) + 1) / k, np.arange(ground.size), ground)
        late, _ = taylor_history(wrong_methods.impact_at_end_of_step, fine, DT / k, model)
        errors.append(off(late[::k], truth, model))
    assert min(errors) > 0.05
    assert off(integrate_history(ground, DT, 1.0, model).rotation, truth, model) < 1e-11


@pytest.mark.shows("mechanics.double_crossing")
def test_an_interior_double_crossing_within_a_sample(make_model):
    """A record with few samples: the block touches down and lifts again within one of them. A method
    that looks at the sample's end sees no impact."""
    model = make_model(one_sided=True, ratio=0.5)
    threshold = G * math.tan(model.slenderness)
    ground = threshold * np.array([0.0, -3.9, -3.3, 3.3, -1.8, 1.8, 4.6, -2.9])
    dt = 0.1
    truth, impacts = high_precision.history(ground, dt, model.slenderness, model.p2, True, lambda v: mp.mpf(0.5))
    truth = np.array([float(value) for value in truth])
    found = integrate_history(ground, dt, 1.0, model)
    assert found.impact_time.size == len(impacts)
    assert off(found.rotation, truth, model) < 1e-11
    missed, result = taylor_history(wrong_methods.double_crossing_missed, ground, dt, model)
    assert result[2] < len(impacts)
    assert off(missed, truth, model) > 1e-2


def test_a_grazing_impact_is_continuous_from_both_sides(make_model):
    """Free fall that just reaches the base: the same history up to the touch, with or without it."""
    model = make_model(one_sided=True, ratio=1.0)
    threshold = G * math.tan(model.slenderness)
    peaks = []
    for push in np.linspace(1.9, 2.1, 41):
        ground = threshold * np.concatenate([[0.0, push, 0.0], np.zeros(400)])
        peaks.append(integrate_history(ground, 0.05, 1.0, model).peak)
    steps = np.diff(peaks)
    assert (steps > 0).all() and steps.max() < 3.0 * steps.min()


@pytest.mark.shows("mechanics.end_of_record")
@pytest.mark.parametrize("law", ["rigid", "al_shawa"])
def test_the_rotation_at_the_last_sample_is_wrong_near_the_separatrix(make_model, law):
    """theta > alpha is no collapse if it comes back, theta < alpha no survival if it goes on."""
    model = make_model(law=law)
    still = np.zeros(3)
    none = np.empty(0)
    p = math.sqrt(model.p2)
    wrong = 0
    for phi, speed in ((0.8, 0.6), (0.95, 0.2), (1.05, -0.2), (1.1, -0.15)):
        start = (phi * model.slenderness, speed * p * model.slenderness)
        late = wrong_methods.rotation_decides_at_the_end(
            still, 1e-6, 1.0, model, start, np.zeros(3), np.zeros(3), none, none
        )[0]
        long = integrate_history(np.zeros(6001), 0.01, 1.0, model, start=start).outcome
        assert integrate_history(still, 1e-6, 1.0, model, start=start).outcome == long
        wrong += late != long
    assert wrong == 4


@pytest.mark.shows("mechanics.law")
@pytest.mark.long
@pytest.mark.parametrize("law, wrong", [("doherty", 1e-3), ("al_shawa", 2e-3)])
def test_trilinear_kinks_ignored(reference, make_model, law, wrong):
    """Order 4 through a kink is order 1: some 1e-3 of alpha over 20 s, growing with time."""
    ground = 0.6 * reference("standard")[0]
    model = make_model(law=law)
    found = integrate_history(ground, DT, 1.0, model).rotation
    through, _ = stepped_history(wrong_methods.kinks_ignored, stepped.RK4, ground, DT, model)
    assert off(through, found, model) > wrong
    located = integrate_history(ground, DT, 1.0, model, Method("rk4", stepped.RK4, 4, 4)).rotation
    assert off(located, found, model) < 1e-3 * wrong
    truth, _ = high_precision.history(
        ground[:700],
        DT,
        model.slenderness,
        model.p2,
        False,
        lambda v: mp.mpf(model.ratio_at_rest),
        (model.elastic_end, model.plateau_end),
        digits=25,
    )
    assert off(found, np.array([float(value) for value in truth]), model) < 1e-11


@pytest.mark.shows("mechanics.rest")
@pytest.mark.parametrize("one_sided, ratio", [(False, 0.7), pytest.param(True, 0.45, marks=pytest.mark.long)])
def test_chatter_without_a_rest_rule_never_ends(make_model, one_sided, ratio):
    """Zeno: impacts shrink geometrically. With the rule a few dozen, without it as many as are allowed."""
    model = make_model(one_sided=one_sided, ratio=ratio)
    ground = np.concatenate([[0.0, 2.0 * G * math.tan(model.slenderness), 0.0], np.zeros(60)])
    found = integrate_history(ground, 0.05, 1.0, model)
    assert found.outcome == STABLE
    assert 5 < found.impact_time.size < 60
    _, result = taylor_history(wrong_methods.no_rest, ground, 0.05, model)
    assert result[0] == IMPACT_LIMIT and result[2] > 1_000


@pytest.mark.shows("paper.eq_3")
def test_energy_ratio_taken_for_the_velocity_ratio_is_unsafe(reference, make_model):
    """r for sqrt(r): more damping, more q. One-sided, Eq. 6: 0.206 for 0.454."""
    ground = reference("standard")[0]
    pga = float(np.abs(ground).max())

    def q(model):
        return incremental_dynamic_analysis(ground, DT, pga, 1, model, METHODS["taylor"], Search(q_step=0.02)).q_robust

    # q_robust rises by 2 % two-sided (0.979 squared) and by 8 % one-sided (0.454 squared)
    for one_sided, unsafe in ((False, 1.01), (True, 1.05)):
        right = make_model(one_sided=one_sided)
        wrong = right._replace(ratio_at_rest=right.ratio_at_rest**2)
        assert q(wrong) > unsafe * q(right)


@pytest.mark.shows("paper.eq_8")
def test_eq_8_as_printed_turns_eq_7_off():
    """Without its root theta_r' is 0.029 for 0.171 at 6.8 deg, 7 m: Eq. 7 is 0 from 0.27 theta_r'."""
    block = Block.rectangle(7.0, math.radians(6.8))
    right = restitution(block, "one_sided_experimental")
    printed = overturning_velocity(block) ** 2
    e1s = right.ratio_at_rest / 1.18
    for fraction in (0.3, 0.6, 0.9):
        speed = fraction * overturning_velocity(block)
        as_printed = e1s * (1.18 - 0.473 * (speed / printed) ** 2)
        assert as_printed < 0.0
        assert right.ratio_at_rest - right.ratio_drop * speed**2 > 0.3


def test_eq_7_outside_its_range_is_held_at_zero_and_counted(reference, make_model):
    model = make_model(1.5, 3.0, one_sided=True, model="one_sided_experimental")
    ground = 4.0 * reference("standard")[0]
    found = integrate_history(ground, DT, 1.0, model)
    fast = integrate_history(np.zeros(200), DT, 1.0, model, start=(0.5 * model.slenderness, -0.3))
    assert fast.clamped == 1
    assert fast.outcome == STABLE and not fast.rotation[fast.rotation.size // 2 :].any()
    assert found.outcome in (0, 1)


@pytest.mark.shows("search.definition")
def test_bisection_over_the_multiplier_is_unsafe_by_more_than_half(reference, make_model):
    """It lands on whichever edge it meets: here above the first collapse by more than 50 %."""
    worst = 0.0
    for name, height in (("standard", 5.0), ("standard", 7.0), ("standard", 9.0), ("hard", 7.0)):
        ground = reference(name)[0]
        model = make_model(height=height)
        pga = float(np.abs(ground).max())
        found = incremental_dynamic_analysis(ground, DT, pga, 1, model, METHODS["taylor"], Search())
        for top in (4.0, 5.0, 6.0, 8.0, 12.0):
            low, high = 1.0, top
            while high / low - 1.0 > 1e-4:
                middle = 0.5 * (low + high)
                scale = middle * G * math.tan(model.slenderness) / pga
                if integrate_history(ground, DT, scale, model).outcome == STABLE:
                    low = middle
                else:
                    high = middle
            worst = max(worst, high / found.q - 1.0)
    assert worst > 0.5


@pytest.mark.shows("mechanics.fma")
def test_fastmath_deletes_the_check_for_nan():
    """Why no kernel uses it: the guard that turns NaN into a word is compiled away."""
    from numba import njit

    def guarded(x):
        return 1.0 if x != x else 0.0

    assert njit(guarded)(math.nan) == 1.0
    assert njit(fastmath=True)(guarded)(math.nan) == 0.0
    assert not kernel(guarded).dispatcher.targetoptions.get("fastmath")


@pytest.mark.parametrize("dt", [1e-4, 1e-3, 0.005, 0.02, 0.05])
@pytest.mark.parametrize("height", [0.05, 0.5, 7.0, 45.0])
def test_steps_from_1e_4_to_0_05_s_on_blocks_from_5_cm_to_45_m(make_model, dt, height):
    """p from 17 to 0.57 rad/s: halving the samples linearly changes nothing beyond its rounding."""
    model = make_model(height=height)
    rng = np.random.default_rng(7)
    size = 120
    ground = 2.0 * G * math.tan(model.slenderness) * rng.uniform(-1, 1, size)
    coarse = integrate_history(ground, dt, 1.0, model)
    fine = np.interp(np.arange(2 * size - 1) / 2, np.arange(size), ground)
    finer = integrate_history(fine, dt / 2, 1.0, model)
    assert coarse.outcome == finer.outcome
    both = min(coarse.rotation.size, finer.rotation[::2].size)
    difference = np.abs(coarse.rotation[:both] - finer.rotation[::2][:both])
    inside = np.abs(coarse.rotation[:both]) < 1.5 * model.slenderness
    assert difference[inside].max() / model.slenderness < 1e-8


@pytest.mark.shows("mechanics.time")
def test_a_decimated_record_is_another_record(reference, make_model):
    """Every second sample of `standard`: another history though nothing failed. No silent resampling."""
    ground = reference("standard")[0]
    model = make_model()
    difference = np.abs(
        integrate_history(ground[::2], 2 * DT, 1.0, model).rotation
        - integrate_history(ground, DT, 1.0, model).rotation[::2]
    )
    # 5e-3 of alpha on this smooth motion of 20 s, 1e9 times the error of the method
    assert difference.max() / model.slenderness > 2e-3


@pytest.mark.parametrize(
    "ratio, samples", [(0.0, 250), *(pytest.param(ratio, 600, marks=pytest.mark.long) for ratio in (0.0, 1.0))]
)
@pytest.mark.parametrize("one_sided", [False, True])
def test_plastic_and_elastic_impacts(reference, make_model, ratio, samples, one_sided):
    ground = reference("standard")[0][:samples]
    model = make_model(one_sided=one_sided, ratio=ratio)
    truth, impacts = high_precision.history(
        ground, DT, model.slenderness, model.p2, one_sided, lambda v: mp.mpf(ratio), digits=25
    )
    truth = np.array([float(value) for value in truth])
    found = integrate_history(ground, DT, 1.0, model)
    assert off(found.rotation, truth, model) < 1e-8
    assert abs(found.impact_time.size - len(impacts)) <= 1


@pytest.mark.parametrize("samples", [100_000, pytest.param(1_000_000, marks=pytest.mark.long)])
def test_a_million_samples(make_model, samples):
    """10 000 s of noise at 0.01 s, or a tenth: ends, and its first hundred seconds are those of a short record."""
    rng = np.random.default_rng(3)
    model = make_model(one_sided=True)
    ground = 1.5 * G * math.tan(model.slenderness) * rng.uniform(-1, 1, samples)
    long = integrate_history(ground, DT, 1.0, model)
    short = integrate_history(ground[:10_000], DT, 1.0, model)
    assert np.array_equal(long.rotation[:10_000], short.rotation)
    assert np.isfinite(long.rotation).all()


@pytest.mark.shows("mechanics.bad_input")
@settings(max_examples=150, deadline=None, derandomize=True)
@given(
    alpha=st.floats(0.1, 45.0),
    height=st.floats(0.1, 50.0),
    ratio=st.floats(0.0, 1.0),
    one_sided=st.booleans(),
    law=st.sampled_from(sorted(LAWS)),
    dt=st.floats(1e-4, 0.05),
    scale=st.floats(0.3, 30.0),
    seed=st.integers(0, 10_000),
    shape=st.sampled_from(["noise", "square", "spike", "still", "ramp"]),
    method=st.sampled_from(sorted(METHODS)),
)
def test_no_wall_and_no_record_hangs_or_gives_nan(alpha, height, ratio, one_sided, law, dt, scale, seed, shape, method):
    rng = np.random.default_rng(seed)
    size = 300
    ground = {
        "noise": rng.uniform(-1, 1, size),
        "square": np.where((np.arange(size) // (1 + seed % 40)) % 2 == 0, 1.0, -1.0),
        "spike": np.eye(1, size, seed % size)[0],
        "still": np.zeros(size),
        "ramp": np.linspace(0.0, 1.0, size),
    }[shape]
    if method == "linearised":
        law = "rigid"
    block = Block.rectangle(height, math.radians(alpha))
    model = rocking_model(block, one_sided, restitution(block, "user", ratio), LAWS[law])
    threshold = block.threshold_acceleration
    found = integrate_history(scale * threshold * ground, dt, 1.0, model, METHODS[method])
    assert found.outcome in (0, 1, 2)
    assert math.isfinite(found.peak)
    assert np.isfinite(found.rotation).all() and np.isfinite(found.velocity).all()
    if one_sided and method == "taylor":
        assert found.rotation.min() >= 0.0


@pytest.mark.shows("mechanics.time")
def test_very_small_and_very_large_blocks_follow_the_scale_of_time(reference):
    """p t is the only time of the equation: H x 10 000 at dt x 100 is the same history."""
    ground = reference("standard")[0][:500]
    alpha = math.radians(6.8)

    def run(height, dt):
        block = Block.rectangle(height, alpha)
        model = rocking_model(block, False, restitution(block, "housner"), LAWS["rigid"])
        return integrate_history(ground, dt, 1.0, model, Method("taylor", 0, 8, 8)).rotation

    small, large = run(0.004, 0.01 / 40), run(40.0, 0.01 * 2.5)
    assert np.abs(small - large).max() / alpha < 1e-10


def test_the_linearised_equation_errs_with_the_slenderness(reference):
    """alpha against error at the same u''/(g alpha): the stockier the wall, the worse."""
    ground = reference("standard")[0][:900]
    errors = []
    for degrees in (1.0, 3.0, 6.8, 11.3, 20.0):
        alpha = math.radians(degrees)
        model = RockingModel(alpha, 2.0866, 0.0, 0.97, 0.0, 0.0, 0.0)
        scaled = ground * math.tan(alpha) / math.tan(math.radians(6.8))
        exact = integrate_history(scaled, DT, 1.0, model).rotation
        linear = integrate_history(scaled, DT, 1.0, model, METHODS["linearised"]).rotation
        errors.append(float(np.abs(exact - linear).max() / alpha))
    assert errors[0] < 1e-3
    assert errors == sorted(errors)
    assert errors[-1] > 5e-3
