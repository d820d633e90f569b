"""One-sided and trilinear histories against scipy's DOP853 restarted at samples and events."""

import math

import mpmath as mp
import numpy as np
import pytest

from core.capacity import independent_solver
from core.rocking.history import integrate_history
from tests.validation import high_precision
from tests.validation.test_loaded_walls import ROOF, wall_model

SAMPLES = 800
"""8 s of `standard`: a dozen impacts, and the amplification of rounding stays below 1e-9."""


@pytest.mark.shows("paper.eq_1")
@pytest.mark.parametrize("scale", [1.0, pytest.param(2.5, marks=pytest.mark.long)])
@pytest.mark.parametrize(
    "one_sided, restitution, law",
    [
        (True, "one_sided_theoretical", "rigid"),
        (True, "one_sided_experimental", "rigid"),
        (True, "one_sided_theoretical", "doherty"),
        (True, "one_sided_experimental", "al_shawa"),
        (False, "housner", "doherty"),
        (False, "housner", "al_shawa"),
        (False, "sorrentino_experimental", "rigid"),
    ],
)
def test_that_dop853_gives_the_same_history(reference, make_model, one_sided, restitution, law, scale):
    ground = scale * reference("standard")[0][:SAMPLES]
    model = make_model(one_sided=one_sided, model=restitution, law=law)
    kinks = None if law == "rigid" else (model.elastic_end, model.plateau_end)

    def ratio_of(speed):
        return max(0.0, model.ratio_at_rest - model.ratio_drop * speed**2)

    truth, impacts = independent_solver.history(ground, 0.01, model.slenderness, model.p2, one_sided, ratio_of, kinks)
    found = integrate_history(ground, 0.01, 1.0, model)
    assert found.impact_time.size == impacts
    size = min(found.rotation.size, truth.size)
    falls = np.abs(truth).max() > 0.5 * math.pi  # it ends with the first sample beyond, or before it
    assert abs(truth.size - found.rotation.size) <= falls and (size < SAMPLES) == falls
    inside = np.abs(truth[:size]) < 0.4 * math.pi
    difference = np.abs(found.rotation[:size] - truth[:size])[inside]
    assert difference.max() / model.slenderness <= 1e-9


@pytest.mark.parametrize(
    "one_sided, law, samples",
    [
        (False, "al_shawa", 110),
        *(
            pytest.param(one_sided, law, 400, marks=pytest.mark.long)
            for law in ("al_shawa", (0.005, 0.28))
            for one_sided in (False, True)
        ),
    ],
)
def test_that_a_small_stiff_wall_is_as_exact(reference, make_model, one_sided, law, samples):
    """H 1 m, D1 down to 0.005: an elastic branch 140 times as stiff as p2, steps must shorten."""
    ground = 0.9 * reference("standard")[0][:samples]
    model = make_model(height=1.0, one_sided=one_sided, law="al_shawa")
    if isinstance(law, tuple):
        ends = {"elastic_end": law[0] * model.slenderness, "plateau_end": law[1] * model.slenderness}
        model = model._replace(**ends)
    truth, impacts = high_precision.history(
        ground,
        0.01,
        model.slenderness,
        model.p2,
        one_sided,
        lambda v: mp.mpf(model.ratio_at_rest),
        (model.elastic_end, model.plateau_end),
    )
    found = integrate_history(ground, 0.01, 1.0, model)
    difference = np.abs(found.rotation - np.array([float(value) for value in truth]))
    assert difference.max() / model.slenderness <= 1e-11
    assert found.impact_time.size == len(impacts) > 2


@pytest.mark.parametrize("dt", [0.01, 0.05])
def test_that_strong_motion_of_a_small_wall_shortens_the_steps(reference, make_model, dt):
    """u'' of 60 a_RM on 20 cm: against the same record resampled 16 times finer."""
    model = make_model(height=0.2)
    ground = 60.0 * reference("standard")[0][160:200]
    fine = np.interp(np.arange(16 * 39 + 1) / 16, np.arange(40), ground)
    coarse = integrate_history(ground, dt, 1.0, model)
    finer = integrate_history(fine, dt / 16, 1.0, model)
    size = min(coarse.rotation.size, finer.rotation[::16].size) - 1
    assert size >= 2
    difference = np.abs(coarse.rotation[:size] - finer.rotation[::16][:size])
    assert difference.max() / model.slenderness <= 1e-10


@pytest.mark.shows("mechanics.loaded")
@pytest.mark.parametrize("mechanism", ["one_sided", "two_sided"])
def test_that_dop853_gives_the_same_history_of_a_wall_with_a_roof(reference, mechanism):
    """a sin(alpha - phi) + c cos(alpha - phi), with a and c of either side."""
    ground = 1.5 * reference("standard")[0][:300]
    model = wall_model(ROOF, mechanism=mechanism)
    sides = tuple((side.sine, side.cosine) for side in (model.restoring, model.mirrored))
    assert abs(sides[0][1]) > 0.01
    truth, impacts = independent_solver.history(
        ground, 0.01, model.slenderness, model.p2, mechanism == "one_sided", lambda speed: 0.6, loads=sides
    )
    found = integrate_history(ground, 0.01, 1.0, model)
    assert found.impact_time.size == impacts > 0
    assert np.abs(found.rotation - truth).max() / model.slenderness <= 1e-9
