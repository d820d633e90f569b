"""Where the polynomial of a step crosses."""

import pytest

from core.rocking import taylor_polynomial


@pytest.mark.shows("mechanics.impact")
def test_that_a_landing_is_found_to_rounding():
    """Newton with a wrong curvature is 1e-9 off here (root by 50 digits); where the fourth coefficient is ten times as
    large, two third-order steps are not enough, and the time is not said to be sure."""
    v = [
        2.484121509596945e-08,
        -5.909802994313008e-08,
        -6.60767306546701e-10,
        3.1464401658184993e-12,
        -1.4177133816426165e-09,
        8.92526227610986e-13,
        -1.7473643133420071e-10,
        -1.1823685623718447e-14,
        -6.8720760775001e-13,
    ]
    time, _, found = taylor_polynomial.landing(v, 6.20553598787473e-14, 1.0)
    assert found and time == pytest.approx(0.83070663397247034895, rel=4e-15)
    v[4] *= 10.0
    time, _, found = taylor_polynomial.landing(v, 6.20553598787473e-14, 1.0)
    assert not found and time == pytest.approx(0.79702206168541351481, rel=1e-10)
