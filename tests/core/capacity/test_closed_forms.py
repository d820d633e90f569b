"""Eq. 9 and 12 to 16, the power law, restitution, block: values by hand and ranges."""

import math

import numpy as np
import pytest

from core.capacity import closed_forms
from core.units import G
from core.wall.block import Block

WALL = Block.rectangle(7.0, math.radians(6.8))


def test_that_a_power_law_is_found_back():
    si = np.array([0.2, 0.5, 0.9, 1.4])
    fit = closed_forms.fit_power_law(list(si), list(321.0 * (100 * si) ** -0.93))
    assert fit.c1 == pytest.approx(321.0, rel=1e-12)
    assert fit.c2 == pytest.approx(-0.93, rel=1e-12)
    assert fit.r_squared == pytest.approx(1.0)
    assert fit.si_range_cm == pytest.approx((20.0, 140.0))
    assert fit.q_eff(0.5) == pytest.approx(321.0 * 50.0**-0.93)


@pytest.mark.shows("paper.eq_13")
def test_that_a_power_law_is_scipys_regression():
    from scipy.stats import linregress

    rng = np.random.default_rng(4)
    si, q_eff = rng.uniform(0.1, 2.0, 9), rng.uniform(2.0, 30.0, 9)
    fit = closed_forms.fit_power_law(list(si), list(q_eff))
    line = linregress(np.log(100 * si), np.log(q_eff))
    assert fit.c2 == pytest.approx(line.slope, rel=1e-10)
    assert fit.c1 == pytest.approx(math.exp(line.intercept), rel=1e-10)
    assert fit.r_squared == pytest.approx(line.rvalue**2, rel=1e-9)


@pytest.mark.shows("paper.eq_13")
@pytest.mark.parametrize("si", [[], [1.0, 2.0], [1.0, 1.0, 1.0]])
def test_that_a_power_law_needs_three_points_and_a_spread(si):
    assert closed_forms.fit_power_law(si, [5.0] * len(si)) is None


@pytest.mark.shows("paper.eq_16")
def test_that_leaving_the_fitted_range_is_said():
    inside = closed_forms.range_notices(math.radians(6.8), 7.0, [("a", 0.2 * G)])
    assert inside == []
    for edge in ((3.1, 3.0, 0.106), (11.3, 11.0, 0.312)):
        alpha, height, pga = edge
        assert not closed_forms.range_notices(math.radians(alpha), height, [("a", pga * G)])
    codes = [entry.code for entry in closed_forms.range_notices(math.radians(15), 2.0, [("a", G), ("b", 0.2 * G)])]
    assert codes == ["eq15_slenderness", "eq15_height", "eq15_pga"]
