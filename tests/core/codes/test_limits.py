"""Numbers of the limit states and of sets, each against its clause."""

from types import SimpleNamespace

import numpy as np
import pytest

from core.capacity.ida import multiplier_of
from core.capacity.limit_states import LIMIT_FRACTION
from core.codes.limits import (
    MIN_STATIONS_FOR_MEAN,
    MIN_STATIONS_FOR_MINIMUM,
    check_return_period,
    counted_mask,
    counted_stations,
    set_capacity,
    set_rule,
)
from core.errors import InputError
from core.ground.ground_motion import GroundMotion


@pytest.mark.shows("kinematic.d_slv")
def test_that_the_limits_are_those_of_the_clauses():
    assert LIMIT_FRACTION == {"SLV": 0.40, "SLC": 0.60}  # C8.7.1.2.1.6
    assert (MIN_STATIONS_FOR_MEAN, MIN_STATIONS_FOR_MINIMUM) == (7, 3)  # EN 1998-1 4.3.3.4.3(3)


@pytest.mark.shows("dynamic.stations")
@pytest.mark.parametrize(
    ("count", "rule"), [(0, "too_few"), (2, "too_few"), (3, "minimum"), (6, "minimum"), (7, "mean"), (30, "mean")]
)
def test_that_the_stations_decide_the_rule_of_a_set(count, rule):
    assert set_rule({f"station {k}" for k in range(count)}) == rule


@pytest.mark.shows("search.set")
@pytest.mark.parametrize(
    ("values", "rule", "value"),
    [
        ([], "mean", None),
        ([None, None], "too_few", None),
        ([2.0, None], "too_few", 2.0),
        ([3.0, 2.0, 4.0], "minimum", 2.0),
        ([1.0, 2.0, 6.0], "mean", 3.0),
        ([1.0, 2.0, 6.0, None], "mean", 3.0),
        ([1.0, 2.0], "incomplete", None),
        ([1.0, 2.0], None, None),
    ],
)
def test_that_a_set_is_the_mean_or_the_most_unfavourable_of_its_numbers(values, rule, value):
    assert set_capacity(values, rule) == value


@pytest.mark.shows("dynamic.silent")
def test_that_a_record_below_a_fifth_of_the_mean_pga_does_not_count():
    """Six of 1 m/s2 and one of x: x = 0.2 (6 + x) / 7 is 3/17. By the PGA on the ground, at the demand."""

    pulse = np.eye(1, 12, 5)[0]

    def counted(last, ground=None, scale=1.0):
        motions = [GroundMotion(f"m{k}", pulse, 0.01) for k in range(6)]
        motions.append(GroundMotion("m6", last * pulse, 0.01, ground_pga=ground))
        demand = SimpleNamespace(scaling=lambda motion: scale if motion.name == "m6" else 1.0)
        assert counted_mask(motions, demand)[:6] == [True] * 6
        assert len(counted_stations(motions, demand)) == 6 + counted_mask(motions, demand)[6]
        return counted_mask(motions, demand)[6]

    assert counted(3.0 / 17.0 + 1e-6) and not counted(3.0 / 17.0 - 1e-6)
    assert not counted(1.0, ground=0.17) and counted(0.1, ground=0.18)
    assert counted(0.1, scale=1.8) and not counted(0.34, scale=0.5)
    assert counted_mask([], SimpleNamespace()) == []


@pytest.mark.shows("paper.eq_10")
def test_that_q_is_c_pga_over_a_rm():
    # Eq. 10: q = 2.4 under a PGA of 3 m/s2 with a_RM = 1.2 m/s2 is C = 0.96
    assert multiplier_of(2.4, 3.0, 1.2) == pytest.approx(0.96, rel=1e-15)


# T_R of SLV and of SLD by hand, -V_R / ln(0.9) and -V_R / ln(0.37), for V_R of NTC 2018 2.4 (V_N C_U)
SLV = {35: 332.2, 50: 474.6, 75: 711.8, 100: 949.1, 150: 1423.7, 200: 1898.2}
SLD = {35: 35.2, 50: 50.3, 75: 75.4, 100: 100.6, 150: 150.9, 200: 201.2}


@pytest.mark.shows("demand.return_period")
@pytest.mark.parametrize("life", SLV)
def test_that_the_period_of_a_weaker_limit_state_is_refused(life):
    # at SLC the T_R of SLV of every usual V_R, from the shortest that SLC has (682 years)
    if SLV[life] < 682.0:
        with pytest.raises(InputError, match="below the 682 years of SLC"):
            check_return_period("SLC", SLV[life], None)
    else:
        with pytest.raises(InputError, match=f"is that of SLV for V_R = {life} years"):
            check_return_period("SLC", SLV[life] * 1.009, None)
        check_return_period("SLC", SLV[life] * 1.012, None)
    with pytest.raises(InputError, match="below the 332 years of SLV"):
        check_return_period("SLV", SLD[life], None)
    check_return_period("SLV", SLV[life], None)


def test_that_a_period_stated_beside_the_life_is_the_one_it_gives():
    check_return_period("SLV", 475.0, 474.6)
    check_return_period("SLV", 475.0, None)
    # the hazard ends at 30 and at 2475 years
    check_return_period("SLO", 30.0, 21.1)
    check_return_period("SLC", 2475.0, 3899.2)
    for stated in (479.6, 469.6, 30.0, 2475.0):
        with pytest.raises(InputError, match="give 475 years at SLV"):
            check_return_period("SLV", stated, 474.6)
    with pytest.raises(InputError, match="give 3899 years"):
        check_return_period("SLC", 2400.0, 3899.2)
