"""Ties in C8.7.1.1 to C8.7.1.12, by hand: a wall of 3.0 x 0.45 m and 18 kN/m3 with a roof and a tie 2.8 m up."""

import itertools
import math
from dataclasses import replace
from pathlib import Path

import pytest

from core.codes.capacity_curve import capacity_curve
from core.codes.kinematic import analyse_mechanism, check_linear
from core.setting.demand_input import read_demand
from core.units import G
from tests.validation.test_loaded_walls import INWARD, ROOF, TIE, case_of

WX, ND, WY = 24.3 * 0.225, 10.0 * 0.30, 24.3 * 1.5
D0 = 0.19141
"""Of the wall with its roof, without its tie [m]."""


def found_of(*loads, state="SLV", **changes):
    given = [{key: value for key, value in load.items() if value is not None} for load in loads]
    case = case_of(*given, **changes)
    demand = replace(read_demand(case, Path()), limit_state=state)
    return analyse_mechanism(case.wall[0].in_si, case.wall[0].mechanism, demand), demand


@pytest.mark.shows("kinematic.ties", "kinematic.d_slv")
def test_that_alpha_0_counts_the_tie_at_yield_and_d_0_does_not_count_it():
    found, demand = found_of(ROOF, TIE)
    bare = (WX + ND) / WY
    assert found.chain.alpha0_bare == pytest.approx(bare, rel=1e-12)
    assert found.alpha0 == pytest.approx(bare + 5.0 * 2.8 / WY, rel=1e-12)
    assert found.d0 == pytest.approx(D0, abs=6e-6)
    assert check_linear("linear_q_code", found, demand, 2.0).zeta == pytest.approx(2.9268, abs=6e-5)
    # the other reading, in which it pulls up to collapse: that of a constant force
    assert found.chain.d0_with_ties == pytest.approx(0.49230, abs=6e-6)
    always, _ = found_of(ROOF, INWARD)
    assert always.d0 == pytest.approx(found.chain.d0_with_ties, rel=1e-12)


@pytest.mark.shows("kinematic.d_slv_of_ties")
def test_that_d_slv_ends_where_a_tie_breaks_that_holds_more_than_half():
    """Of 0.2323 and 0.3841 at yield 62 % go with the bar: at 60 mm of its own, a rotation of 0.0214."""
    short = {**TIE, "elongation_m": 0.06}
    found, _ = found_of(ROOF, short)
    theta = math.asin(0.06 / 2.8)
    alpha, radius = math.atan(0.15), math.hypot(0.225, 1.5)
    at_break = radius * (math.sin(alpha) - math.sin(alpha - theta))
    assert found.d_limit == pytest.approx(at_break, rel=1e-12) and at_break < 0.40 * found.d0
    bare, held = (WX + ND) / WY, 5.0 * 2.8 / WY
    a = ((1.0 - at_break / found.d0) * bare + held) * G / 1.35
    assert found.a_limit == pytest.approx(a, rel=1e-12)


@pytest.mark.shows("kinematic.d_slv_of_ties")
def test_that_a_tie_that_holds_less_than_half_is_gone_at_d_slv():
    found, demand = found_of(ROOF, {**TIE, "out_kn_m": 2.0, "elongation_m": 0.06})
    assert found.d_limit == pytest.approx(0.40 * found.d0, rel=1e-12)
    assert found.a_limit == pytest.approx(0.60 * (WX + ND) / WY * G / 1.35, rel=1e-12)
    # at yield without an elongation it is gone long before
    brittle, _ = found_of(ROOF, {**TIE, "out_kn_m": 2.0, "elongation_m": None})
    assert brittle.a_limit == found.a_limit
    curve = capacity_curve(found, demand).capacity
    drops = [a - b for (d, a), (after, b) in itertools.pairwise(curve) if after - d < 1e-9 and a - b > 1e-3]
    assert len(drops) == 1 and drops[0] == pytest.approx(2.0 * 2.8 / WY * G / 1.35, rel=1e-6)


@pytest.mark.shows("kinematic.d_slv_of_ties")
def test_that_ties_of_several_heights_break_one_after_another():
    """Neither holds half, both together do: d_SLV ends where the second breaks."""
    pair = ({**TIE, "out_kn_m": 2.2, "elongation_m": 0.03}, {**TIE, "out_kn_m": 2.2, "h_m": 2.7, "elongation_m": 0.08})
    found, _ = found_of(ROOF, *pair)
    first, second = (float(found.chain.displacement(math.asin(u / h))) for u, h in ((0.03, 2.8), (0.08, 2.7)))
    assert first < found.d_limit == pytest.approx(second, rel=1e-12) and second < 0.40 * found.d0
    assert found.chain.alpha_of_ties(found.d_limit) == pytest.approx(2.2 * 2.7 / WY)


def test_that_the_inward_side_of_a_two_sided_wall_has_no_tie():
    found, _ = found_of(ROOF, {**TIE, "out_kn_m": 1.0}, mechanism="two_sided")
    bare, _ = found_of(ROOF, mechanism="two_sided")
    assert (found.alpha0, found.d0, found.a_limit) == (bare.alpha0, bare.d0, bare.a_limit)
    assert found.chain.ties == () and found.chain.d0_with_ties is None


@pytest.mark.shows("kinematic.ties")
@pytest.mark.parametrize("slack", [0.1, 110.0, 400.0])
def test_that_a_slack_bar_counts_nothing_but_in_the_other_reading(slack):
    """At 0.40 theta_c, 142 mm of its own, one of 110 mm would just be taut."""
    found, bare = found_of(ROOF, {**TIE, "slack_mm": slack, "elongation_m": 0.6})[0], found_of(ROOF)[0]
    same = ("alpha0", "zeta_sld", "d0", "d_limit", "a_limit", "period", "s_de")
    assert [getattr(found, name) for name in same] == pytest.approx([getattr(bare, name) for name in same], rel=1e-12)


@pytest.mark.shows("kinematic.ties_at_sld")
def test_that_at_sld_no_tie_counts():
    found, bare = found_of(ROOF, TIE, state="SLD")[0], found_of(ROOF, state="SLD")[0]
    assert (found.alpha0, found.zeta_sld, found.d0) == pytest.approx((bare.alpha0, bare.zeta_sld, bare.d0), rel=1e-12)
    assert found_of(ROOF, TIE)[0].alpha0 > 1.5 * found.alpha0


@pytest.mark.shows("kinematic.ties")
def test_that_a_long_bar_gives_what_it_is_stretched_for():
    """100 m of 1500 MPa yield at 732 mm: at 0.40 theta_c, 142 mm, a fifth of its force is counted in alpha_0."""
    found, _ = found_of(ROOF, {**TIE, "bar_length_m": 100.0, "fy_mpa": 1500.0, "elongation_m": None})
    share = 2.8 * math.sin(0.40 * 0.126744) / (1500e6 * 100.0 / 205e9)
    assert found.alpha0 == pytest.approx((WX + ND + share * 5.0 * 2.8) / WY, rel=1e-5) and share < 0.25


@pytest.mark.shows("kinematic.sld_shown")
def test_that_no_floor_of_the_displacement_check_counts_a_tie():
    """a_g,SLD counts for SLV too, but a tie has to be stretched first."""
    found, _ = found_of(ROOF, TIE)
    bare, _ = found_of(ROOF)
    assert found.zeta_floor == bare.zeta_floor < found.zeta_sld


@pytest.mark.parametrize(("elongation", "reached"), [(2.42, True), (2.43, False), (2.79, False), (2.9, False)])
def test_that_no_wall_comes_to_a_break_beyond_sixty_degrees(elongation, reached):
    """u = h sin(60 degrees) = 2.4249 m of a tie 2.8 m up; it is taut at once, and yields at 13.756 mm of its 12 m."""
    found, _ = found_of(ROOF, {**TIE, "bar_length_m": 12.0, "elongation_m": elongation})
    ends = found.chain.ends_of_ties()
    turned = [math.asin(u / 2.8) for u in (0.0, 0.0137561, *((elongation,) if reached else ()))]
    alpha, radius = math.atan(0.15), math.hypot(0.225, 1.5)
    by_hand = [radius * (math.sin(alpha) - math.sin(alpha - theta)) for theta in turned]
    assert ends == pytest.approx(by_hand, abs=1e-6)
