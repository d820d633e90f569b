"""One-sided and trilinear histories against scipy's DOP853 restarted at samples and events."""

import math

import mpmath as mp
import numpy as np
import pytest

from core.rocking import history
from tests.validation import dop853, high_precision

SAMPLES = 800
"""8 s of `standard`: a dozen impacts, and the amplification of rounding stays below 1e-9."""


@pytest.mark.parametrize("scale", [1.0, 2.5])
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
def test_that_dop853_gives_the_same_history(
    reference, make_model, one_sided, restitution, law, scale
):
    ground = scale * reference("standard")[0][:SAMPLES]
    model = make_model(one_sided=one_sided, model=restitution, law=law)
    kinks = None if law == "rigid" else (model.elastic_end, model.plateau_end)

    def ratio_of(speed):
        return max(0.0, model.ratio_at_rest - model.ratio_drop * speed**2)

    truth, impacts = dop853.history(
        ground, 0.01, model.slenderness, model.p2, one_sided, ratio_of, kinks
    )
    found = history(ground, 0.01, 1.0, model)
    assert found.impact_time.size == impacts
    size = min(found.rotation.size, truth.size)
    inside = np.abs(truth[:size]) < 0.4 * math.pi
    difference = np.abs(found.rotation[:size] - truth[:size])[inside]
    assert difference.max() / model.slenderness <= 1e-9


@pytest.mark.parametrize("one_sided, law", [(True, "rigid"), (False, "al_shawa")])
def test_that_thirty_digits_give_the_same_history(reference, make_model, one_sided, law):
    ground = reference("standard")[0][:450]
    model = make_model(one_sided=one_sided, law=law)
    kinks = None if law == "rigid" else (model.elastic_end, model.plateau_end)
    truth, impacts = high_precision.history(
        ground, 0.01, model.slenderness, model.p2, one_sided,
        lambda v: mp.mpf(model.ratio_at_rest), kinks,
    )  # fmt: skip
    found = history(ground, 0.01, 1.0, model)
    assert found.impact_time.size == len(impacts)
    difference = np.abs(found.rotation - np.array([float(value) for value in truth]))
    assert difference.max() / model.slenderness <= 1e-12
