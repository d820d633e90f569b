"""What a tie holds and stands: steel, thread and anchorage by hand (NTC 2018 4.2.4.1.2.1, 4.2.8.1.1)."""

import math

import pytest

from core.case.hold import Bars, Hold
from core.case.wall import Wall
from core.wall.ties import bars_for

AREA_24 = 0.25 * math.pi * 24.0**2


def tie(**hold):
    return Hold("tie", h_m=6.5, bar_length_m=8.0, **hold).tie(10.0)


def test_that_a_force_gives_the_elongation_at_yield_and_what_is_counted_on():
    plain = tie(out_kn_m=6.0).bar
    assert plain.elongation_at_yield == pytest.approx(9.171e-3, abs=1e-6)  # 8 m of 235 MPa
    assert (plain.strength, plain.stands, plain.slack) == (6000.0, plain.elongation_at_yield, 0.0)
    assert tie(out_kn_m=6.0, elongation_m=0.4).bar.stands == 0.4
    assert tie(out_kn_m=6.0, fy_mpa=355.0).bar.elongation_at_yield == pytest.approx(355e6 * 8.0 / 205e9)
    assert tie(out_kn_m=6.0, slack_mm=3.0).bar.slack == pytest.approx(0.003)
    pulled = tie(out_kn_m=6.0, prestress=0.4, elongation_m=0.4).bar
    assert pulled.slack == pytest.approx(-0.4 * plain.elongation_at_yield)
    # the steel of a prestressed bar is that much longer already
    assert pulled.breaks_at == pytest.approx(0.4 - 0.4 * plain.elongation_at_yield)
    assert tie(out_kn_m=6.0, slack_mm=3.0, elongation_m=0.4).bar.breaks_at == 0.4
    assert tie(out_kn_m=6.0, slack_mm=3.0).bar.breaks_at == pytest.approx(0.003 + plain.elongation_at_yield)


@pytest.mark.shows("ties.bar")
def test_that_the_weakest_part_of_a_bar_governs():
    """24 mm of S 235: steel 452.4 x 235 / 1.05 = 101.2 kN; its thread 0.9 x 353 x 360 / 1.25 = 91.4 kN."""
    bar = Bars(4, 24.0)
    (_, steel), (_, thread) = bar.in_si().parts
    assert steel == pytest.approx(AREA_24 * 235.0 / 1.05) and thread == pytest.approx(0.9 * 353.0 * 288.0, rel=3e-3)
    found = tie(bar=bar, elongation_m=0.4)
    assert found.weakest == "thread" and not found.stands_more
    assert found.bar.strength == pytest.approx(4 * thread / 10.0)
    assert found.bar.stands == found.bar.elongation_at_yield == pytest.approx(thread * 8.0 / (205e3 * AREA_24))
    existing = dict(Bars(4, 24.0, 235.0, 360.0, existing=True).in_si().parts)
    assert existing["steel"] == pytest.approx(AREA_24 * 235.0)


@pytest.mark.shows("ties.ductile")
def test_that_an_elongation_counts_only_where_steel_yields_before_anything_else_goes():
    """An upset thread of 30 mm, and an anchorage that stands the bar at its tensile strength, 162.9 kN."""
    strongest = AREA_24 * 360e-3
    upset = Bars(4, 24.0, thread_mm=30.0, anchorage_kn=strongest + 0.1)
    assert upset.in_si().is_ductile
    found = tie(bar=upset, elongation_m=0.4)
    assert (found.weakest, found.stands_more, found.bar.stands) == ("steel", True, pytest.approx(0.4))
    for weaker in (
        Bars(4, 24.0, anchorage_kn=500.0),  # the thread goes first [4.2.8]
        Bars(4, 24.0, thread_mm=30.0),  # nobody checked the anchorage
        Bars(4, 24.0, thread_mm=30.0, anchorage_kn=strongest - 0.1),
    ):
        assert not weaker.in_si().is_ductile
        assert not tie(bar=weaker, elongation_m=0.4).stands_more
    weak = tie(bar=Bars(4, 24.0, thread_mm=30.0, anchorage_kn=40.0), elongation_m=0.4)
    assert weak.weakest == "anchorage" and weak.bar.strength == pytest.approx(4 * 40e3 / 10.0)


def test_that_the_bars_of_a_force_hold_it_with_a_stronger_thread():
    assert bars_for(15.58e3, 1.5) == (12, 14)
    assert bars_for(60e3, 1.5) == (24, 27)
    assert bars_for(1e6, 1.5) == (None, None)


def test_that_a_wall_without_ties_has_none():
    assert Wall("w", "one_sided", height_m=7.0, thickness_m=0.6).in_si.ties == ()


@pytest.mark.shows("ties.law")
def test_that_the_force_of_a_bar_on_its_first_way_out_is_slack_elastic_plastic_and_gone():
    bar = tie(out_kn_m=6.0, slack_mm=10.0, elongation_m=0.3).bar
    at = lambda u: bar.force_at(math.asin(u / 6.5))  # noqa: E731
    assert [at(0.0), at(0.01), at(0.2), at(0.3001)] == [0.0, 0.0, 6e3, 0.0]
    assert at(0.01 + 0.5 * bar.elongation_at_yield) == pytest.approx(3e3)
    assert bar.ends == (0.01, 0.01 + bar.elongation_at_yield, 0.3)
