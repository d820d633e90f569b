"""Regressions give back what was planted in their data."""

import numpy as np
import pytest
from scipy import optimize

from core.capacity import regression, scale_free_law

RNG = np.random.default_rng(7)


@pytest.mark.shows("paper.eq_14")
def test_that_planted_coefficients_of_eq14_come_back():
    alpha, height = (axis.ravel() for axis in np.meshgrid([3.1, 6.8, 11.3], [3.0, 5.0, 7.0, 9.0, 11.0]))
    fit = regression.linear_c1(alpha, height, 30.0 * alpha + 78.0 * height + 90.0)
    assert fit.coefficients == pytest.approx((30.0, 78.0, 90.0), rel=1e-10)
    assert fit.r_squared == pytest.approx(1.0, abs=1e-12) and fit.n == 15


def test_that_a_planted_power_law_comes_back_from_a_given_exponent():
    si = np.geomspace(20.0, 200.0, 9)
    fit = regression.power_coefficient(si, 840.0 * si**-0.9, -0.9)
    assert fit.coefficients[0] == pytest.approx(840.0, rel=1e-12)
    assert fit.r_squared == pytest.approx(1.0, abs=1e-12)


def test_that_dependent_columns_and_too_few_points_are_refused():
    with pytest.raises(ValueError, match="dependent"):
        regression.least_squares([[1.0, 2.0], [2.0, 4.0], [3.0, 6.0]], [1.0, 2.0, 3.0])
    with pytest.raises(ValueError, match="underdetermined"):
        regression.least_squares([[1.0, 2.0]], [1.0])


@pytest.mark.parametrize("seed", range(20))
def test_that_a_law_that_is_not_linear_is_fitted_as_scipy_fits_it(seed):
    draw = np.random.default_rng(seed)
    x, s = draw.uniform(0.2, 8.0, 60), draw.uniform(0.05, 0.9, 60)
    q = scale_free_law.law_value((0.7, 3.2, 1.7, -0.9), 1.0, x, s) * np.exp(draw.normal(0.0, 0.1, 60))

    def residual(c):
        return np.log(scale_free_law.law_value(c, 1.0, x, s) / q)

    theirs = optimize.least_squares(residual, np.zeros(4), xtol=1e-14, ftol=1e-14, gtol=1e-14)
    ours = regression.least_squares_of(residual, np.zeros(4))
    assert (residual(ours) ** 2).sum() <= 2.0 * theirs.cost * (1.0 + 1e-12)
    assert ours == pytest.approx(theirs.x, abs=1e-5)


def test_that_a_fit_without_a_least_square_is_refused():
    with pytest.raises(ArithmeticError, match="settle"):
        regression.least_squares_of(lambda c: np.exp(-c), [0.0])


def test_that_agreement_counts_bias_scatter_and_share():
    truth = np.exp(RNG.normal(size=4000))
    law = 0.8 * truth * np.exp(RNG.normal(0.0, 0.1, size=4000))
    found = regression.agreement(law, truth)
    assert found.bias == pytest.approx(-0.2, abs=0.01)
    assert found.scatter == pytest.approx(0.1, abs=0.005)
    assert found.within == pytest.approx(0.342, abs=0.03) and found.n == 4000
    whole = regression.agreement(truth, truth)
    assert whole == regression.Agreement(0.0, 0.0, 1.0, 4000)


def test_that_r_squared_is_the_share_of_the_spread_about_the_mean():
    """Residuals 0.1, 0.1, 0.2, 0.2 of values that spread by 5 about 2.5; and two by themselves."""
    assert regression.r_squared([1.0, 2.0, 3.0, 4.0], [1.1, 1.9, 3.2, 3.8]) == pytest.approx(0.98, rel=1e-12)
    assert regression.r_squared([2.0, 2.0], [2.0, 2.0]) == 1.0 and regression.r_squared([2.0, 2.0], [2.0, 2.1]) == 0.0
