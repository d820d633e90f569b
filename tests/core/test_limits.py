"""Numbers of the limit states and of sets, each against its clause."""

import pytest

from core.limits import LIMIT_FRACTION, MEAN_FROM, MINIMUM_FROM, multiplier_of, return_period


@pytest.mark.parametrize(
    ("state", "years"), [("SLO", 30.11), ("SLD", 50.29), ("SLV", 474.56), ("SLC", 974.79)]
)
def test_that_t_r_of_fifty_years_is_the_known_one(state, years):
    # NTC 2018 3.2.0: -50 / ln(1 - P_VR), P_VR 81, 63, 10, 5 %
    assert return_period(50.0, state) == pytest.approx(years, abs=0.005)


def test_that_the_limits_are_those_of_the_clauses():
    assert LIMIT_FRACTION == {"SLV": 0.40, "SLC": 0.60}  # C8.7.1.2.1.6
    assert (MEAN_FROM, MINIMUM_FROM) == (7, 3)  # EN 1998-1 4.3.3.4.3(3)


def test_that_q_is_c_pga_over_a_rm():
    # Eq. 10: q = 2.4 under a PGA of 3 m/s2 with a_RM = 1.2 m/s2 is C = 0.96
    assert multiplier_of(2.4, 3.0, 1.2) == pytest.approx(0.96, rel=1e-15)
