"""The elastic branch of a wall against its formulas: T_0 of C8.7.1.7, D where the branch meets the curve."""

import math

import pytest

from core.case.rules import parse_wall
from core.codes import elastic_branch
from core.codes.elastic_branch import branches_of
from core.setting.check_input import make_rocking_model
from core.units import G

PARAPET = {"name": "w", "mechanism": "two_sided", "height_m": 1.2, "thickness_m": 0.25}
PARAPET |= {"unit_weight_kn_m3": 18.0, "elastic_modulus_mpa": 1200.0, "law": "rigid"}


def found_of(**changes):
    wall = parse_wall({key: value for key, value in (PARAPET | changes).items() if value is not None})
    return branches_of(wall.in_si, wall.mechanism, make_rocking_model(wall, wall.mechanism))


def by_hand(modulus: float, weight: float, height: float = 1.2, thickness: float = 0.25) -> tuple[float, float]:
    """(T_0 [s], D) of a rectangle: alpha_0 = t/H, d_0 = t/2 at its centroid but for the second order, e* = 1."""
    period = 6.2 * (height / thickness) * height * math.sqrt(1e3 * weight / (1e6 * modulus * G))
    half, middle = 0.5 * thickness, 0.5 * height
    d0 = math.hypot(half, middle) * math.sin(math.atan2(half, middle))
    return period, 1.0 / (1.0 + (2.0 * math.pi / period) ** 2 * d0 / (thickness / height * G))


@pytest.mark.shows("kinematic.branch")
def test_that_the_branch_ends_where_it_meets_the_curve():
    by_curve, by_motion = found_of()
    period, limit = by_hand(1200.0, 18.0)
    assert (by_curve.modulus, by_curve.assumed) == (1200e6, False)
    assert by_curve.period == by_motion.period == pytest.approx(period, rel=1e-12)
    assert by_curve.limit == pytest.approx(limit, rel=1e-3)
    assert by_motion.own_period == pytest.approx(period, rel=1e-9)  # D for which the motion has T_0 itself
    assert by_curve.own_period != pytest.approx(period, rel=1e-3)


@pytest.mark.shows("kinematic.branch_without_modulus")
def test_that_without_a_modulus_both_ends_of_the_table_are_taken_with_the_weight_that_makes_each_further():
    slow, fast = found_of(elastic_modulus_mpa=None, unit_weight_kn_m3=None)
    assert (slow.modulus, fast.modulus) == (690e6, 5600e6) and slow.assumed and fast.assumed
    assert slow.period == pytest.approx(by_hand(690.0, 22.0)[0], rel=1e-12)
    assert fast.period == pytest.approx(by_hand(5600.0, 13.0)[0], rel=1e-12)
    assert slow.limit > fast.limit


def test_that_a_wall_elastic_up_to_its_limit_has_none_and_a_stiff_one_the_least():
    assert found_of(height_m=12.0, elastic_modulus_mpa=50.0) == ()
    stiff = found_of(elastic_modulus_mpa=100_000.0, height_m=0.4, thickness_m=0.4)
    assert all(branch.limit >= elastic_branch.MIN_LIMIT for branch in stiff)


@pytest.mark.shows("kinematic.branch_without_modulus")
def test_that_ties_and_unlike_sides_have_no_branch():
    tie = {"kind": "tie", "out_kn_m": 2.0, "h_m": 1.0, "bar_length_m": 6.0, "elongation_m": 0.2}
    assert found_of(hold=[tie]) == ()
    one = parse_wall(PARAPET | {"mechanism": "one_sided"})
    assert branches_of(one.in_si, "one_sided", make_rocking_model(one, "one_sided"))
