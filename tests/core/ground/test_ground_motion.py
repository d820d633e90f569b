"""Intensity measures and spectra: closed forms, scipy, invariances."""

import math

import numpy as np
import pytest

from core.ground.ground_motion import GroundMotion


def motion(samples, dt=0.01):
    return GroundMotion("test", np.asarray(samples, float), dt)


def test_that_measures_scale_as_they_must(reference):
    ground = reference("standard")[0]
    one, three = motion(ground), motion(3.0 * ground)
    for name in ("pga", "pgv", "pgd", "housner_intensity"):
        assert getattr(three, name) == pytest.approx(3.0 * getattr(one, name), rel=1e-12)
    assert three.arias == pytest.approx(9.0 * one.arias, rel=1e-12)
    assert three.duration_5_95 == pytest.approx(one.duration_5_95, rel=1e-12)


@pytest.mark.parametrize(
    "samples, dt, word",
    [
        (np.zeros(100), 0.01, "zero"),
        (np.ones(5), 0.01, "too few"),
        ([1.0] * 50 + [math.nan] * 2 + [1.0] * 20, 0.01, "not a number"),
        (np.ones(50), 0.0, "time step"),
        (np.ones(50), math.nan, "time step"),
    ],
)
def test_that_a_motion_refuses_what_is_no_motion(samples, dt, word):
    from core.errors import RecordError

    with pytest.raises(RecordError, match=word):
        motion(samples, dt)


def test_that_samples_cannot_be_changed(reference):
    found = motion(reference("standard")[0])
    with pytest.raises(ValueError):
        found.acceleration[0] = 1.0
