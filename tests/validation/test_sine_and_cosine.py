"""sin and cos of the steps against those of fifty digits."""

import math

import mpmath
import numpy as np
import pytest

from core.rocking.short_series import SHORT_SERIES, sine_and_cosine_short


@pytest.mark.shows("mechanics.sine")
def test_that_sine_and_cosine_are_exact_but_for_the_last_digit():
    worst = np.zeros(2)
    with mpmath.workdps(50):
        for x in np.random.default_rng(1).uniform(0.0, SHORT_SERIES, 2000).tolist() + [0.0, 1e-9, SHORT_SERIES]:
            for k, (found, exact) in enumerate(
                zip(sine_and_cosine_short(x), (mpmath.sin(x), mpmath.cos(x)), strict=True)
            ):
                worst[k] = max(worst[k], abs(mpmath.mpf(float(found)) - exact) / math.ulp(float(exact)))
    assert worst[0] < 0.7 and worst[1] < 1.3
