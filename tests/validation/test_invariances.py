"""What the equation of motion leaves unchanged, on the reference history `standard`."""

import math

import numpy as np
import pytest

from core.rocking.history import integrate_history
from core.rocking.methods import METHODS
from core.rocking.outcome import STABLE
from core.units import G


@pytest.mark.shows("mechanics.mirror")
@pytest.mark.parametrize("method", METHODS.values(), ids=METHODS)
@pytest.mark.parametrize("law", ["rigid", "doherty"])
def test_that_a_mirrored_ground_moves_the_block_mirrored(reference, make_model, method, law):
    ground = reference("standard")[0]
    model = make_model(law=law)
    there = integrate_history(ground, 0.01, 1.0, model, method)
    for mirrored in (
        integrate_history(-ground, 0.01, 1.0, model, method),
        integrate_history(ground, 0.01, -1.0, model, method),
    ):
        assert np.array_equal(mirrored.rotation, -there.rotation)
        assert np.array_equal(mirrored.velocity, -there.velocity)
        assert mirrored.peak == there.peak


@pytest.mark.shows("mechanics.mirror")
@pytest.mark.parametrize("one_sided", [False, True])
@pytest.mark.parametrize("law", ["rigid", "al_shawa"])
def test_that_zeros_in_front_change_nothing(reference, make_model, one_sided, law):
    ground = reference("standard")[0]
    model = make_model(one_sided=one_sided, law=law)
    plain = integrate_history(ground, 0.01, 1.0, model)
    padded = integrate_history(np.concatenate([np.zeros(137), ground]), 0.01, 1.0, model)
    assert not padded.rotation[:137].any()
    assert np.array_equal(padded.rotation[137:], plain.rotation)


def test_that_zeros_behind_leave_outcome_and_peak(reference, make_model):
    ground = reference("standard")[0]
    for law in ("rigid", "doherty"):
        model = make_model(law=law)
        for cut in range(300, 2001, 77):
            # a last sample at rest: the ramp to zero is part of both records
            still = np.concatenate([ground[:cut], [0.0]])
            longer = np.concatenate([still, np.zeros(1500)])
            bare, padded = (integrate_history(g, 0.01, 1.0, model) for g in (still, longer))
            assert bare.outcome == padded.outcome
            if bare.outcome == STABLE:
                assert bare.peak == pytest.approx(padded.peak, rel=1e-11)


@pytest.mark.shows("mechanics.time")
def test_that_four_times_the_height_at_twice_the_step_is_the_same_history(reference, make_model):
    ground = reference("standard")[0]
    small, large = make_model(height=7.0), make_model(height=28.0)
    there = integrate_history(ground, 0.01, 1.0, small)
    scaled = integrate_history(ground, 0.02, 1.0, large)
    difference = np.abs(there.rotation - scaled.rotation) / small.slenderness
    assert difference.max() <= 1e-12  # p2 rounds differently, amplified 1e4 times


@pytest.mark.shows("mechanics.time")
def test_that_linear_resampling_changes_nothing(reference, make_model):
    ground = reference("standard")[0]
    fine = np.interp(np.arange(2 * ground.size - 1) / 2, np.arange(ground.size), ground)
    model = make_model()
    there = integrate_history(ground, 0.01, 1.0, model)
    finer = integrate_history(fine, 0.005, 1.0, model)
    difference = np.abs(there.rotation - finer.rotation[::2]) / model.slenderness
    # 2e-14 stated for the exact solution; the rounding of both runs adds up to some 1e-13
    assert difference.max() <= 2e-13


@pytest.mark.shows("mechanics.mirror")
@pytest.mark.parametrize("factor", [0.5, 3.0])
def test_that_scaling_the_record_is_scaling_the_multiplier(reference, make_model, factor):
    ground = reference("standard")[0]
    model = make_model()
    scaled = integrate_history(ground * factor, 0.01, 1.0, model)
    multiplied = integrate_history(ground, 0.01, factor, model)
    assert np.array_equal(scaled.rotation, multiplied.rotation)


@pytest.mark.shows("paper.eq_2")
@pytest.mark.parametrize("one_sided", [False, True])
def test_that_a_ground_below_the_threshold_moves_nothing(make_model, reference, one_sided):
    model = make_model(one_sided=one_sided)
    ground, _, _, _ = reference("standard")
    threshold = G * math.tan(model.slenderness)
    found = integrate_history(ground * (threshold / np.abs(ground).max()), 0.01, 1.0, model)
    exactly = np.clip(ground, -threshold, threshold)
    for quiet in (found, integrate_history(exactly, 0.01, 1.0, model)):
        assert not quiet.rotation.any()
        assert not quiet.velocity.any()
        assert quiet.impact_time.size == 0
        assert quiet.peak == 0.0
