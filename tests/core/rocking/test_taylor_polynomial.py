"""Where the polynomial of a step crosses."""

import pytest

from core.rocking import taylor_polynomial


def test_that_a_landing_is_found_to_rounding():
    """Newton with a wrong curvature stops at 3e-13 here (root by 50 digits)."""
    v = (
        2.484121509596945e-08,
        -5.909802994313008e-08,
        -6.60767306546701e-10,
        3.1464401658184993e-12,
        -1.4177133816426164e-08,
        8.92526227610986e-13,
        -1.7473643133420071e-10,
        -1.1823685623718447e-14,
        -6.8720760775001e-13,
    )
    time, _, found = taylor_polynomial.landing(v, 6.20553598787473e-14, 1.0)
    assert found and time == pytest.approx(0.7970220616854136, rel=4e-15)
