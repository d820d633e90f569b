"""The rate against quadrature, against Cornell's closed form, and against one step of a fragility without spread."""

import itertools
import math
import subprocess
import sys

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.stats import norm

from core.codes.collapse_rate import STATION_DRAWS, exceedance_probability, mean_rate, state_rate, typical_rate
from core.ground.provenance import bootstrap_counts
from tests.conftest import ROOT

HAZARD = [(30, 0.6), (50, 0.8), (72, 0.95), (101, 1.1), (140, 1.25), (201, 1.45), (475, 2.1), (975, 2.7), (2475, 3.7)]
"""(T_R [years], a_g [m/s2])."""


def rate(median, deviation, hazard=HAZARD):
    total, beyond, weaker = mean_rate(np.array([median]), np.array([deviation]), hazard)
    return float(total[0]), float(beyond[0]), float(weaker[0])


def by_quadrature(median, deviation, hazard=HAZARD):
    """Of F |dH/da| da, row by row, one step on at both ends, then as the docstring says."""
    years, ags = np.array(hazard, float).T
    slopes = np.diff(np.log(years)) / np.diff(np.log(ags))
    first, last = ags[0] ** 2 / ags[1], ags[-1] ** 2 / ags[-2]

    def slice_of(u, k):
        return (
            norm.cdf((u - math.log(median)) / deviation) * slopes[k] / years[k] * (math.exp(u) / ags[k]) ** -slopes[k]
        )

    edges = [first, *ags[1:-1], last]
    parts = [
        quad(slice_of, math.log(low), math.log(high), args=(k,), epsabs=0.0, epsrel=1e-10, limit=500)[0]
        for k, (low, high) in enumerate(itertools.pairwise(edges))
    ]
    above = (last / ags[-1]) ** -slopes[-1] / years[-1]
    return sum(parts) + above, above / (sum(parts) + above), norm.cdf(math.log(first / median) / deviation)


@pytest.mark.shows("risk.rate")
@pytest.mark.parametrize("median, deviation", [(3.0, 0.4), (1.0, 0.3), (6.0, 0.5), (2.0, 0.05), (0.7, 0.8)])
def test_that_the_closed_form_is_the_integral(median, deviation):
    assert rate(median, deviation) == pytest.approx(by_quadrature(median, deviation), rel=1e-9)


@pytest.mark.parametrize("deviation", [0.4, 0.6, 1.0, 2.0])
@pytest.mark.parametrize("median", [0.2, 0.24, 0.3, 0.6])
def test_that_rows_close_in_a_g_and_records_that_scatter_leave_its_digits(median, deviation):
    """Rounded rows of a weak site, slopes of 7 and 14: exp((slope deviation)^2 / 2) is up to 1e170."""
    rows = [(30, 0.20), (50, 0.22), (72, 0.23), (101, 0.24), (140, 0.2457), (201, 0.26), (475, 0.32)]
    assert rate(median, deviation, rows) == pytest.approx(by_quadrature(median, deviation, rows), rel=1e-8)


@pytest.mark.shows("risk.rate")
def test_that_on_one_straight_hazard_it_is_cornell_s():
    """lambda = H(median) exp(k^2 beta^2 / 2), Cornell 1996; the tail above the last row adds its upper bound."""
    k, at = 2.5, 1.0
    years = np.geomspace(1e-3, 3e9, 16)
    hazard = [(float(y), at * (float(y) / 475.0) ** (1.0 / k)) for y in years]
    for median, deviation in ((1.0, 0.3), (1.4, 0.5)):
        cornell = (median / at) ** -k / 475.0 * math.exp(0.5 * (k * deviation) ** 2)
        assert rate(median, deviation, hazard)[0] == pytest.approx(cornell, rel=1e-6)


def test_that_a_wall_without_spread_fails_as_often_as_its_a_g_is_exceeded():
    for years, ag in HAZARD[1:-1]:
        assert rate(ag, 1e-6)[0] == pytest.approx(1.0 / years, rel=1e-4)


def test_that_what_the_hazard_does_not_hold_is_counted_as_failure_and_said():
    total, beyond, weaker = rate(30.0, 0.2)
    last = (3.7**2 / 2.7 / 3.7) ** -(math.log(2475 / 975) / math.log(3.7 / 2.7)) / 2475
    assert total == pytest.approx(last, rel=1e-3) and beyond > 0.99 and weaker == pytest.approx(0.0, abs=1e-12)
    weak, _, weaker = rate(0.1, 0.2)  # fails under motions the hazard does not tell
    assert weak == pytest.approx((0.6 / 0.8) ** -(math.log(50 / 30) / math.log(0.8 / 0.6)) / 30) and weaker > 0.99


def test_the_rate_of_a_state_with_fc_its_interval_and_its_life():
    capacities = [2.0, 3.0, 2.5, 4.0, 3.3, 2.2, 2.8]
    found = state_rate("SLV", capacities, list("abcdefg"), HAZARD, 1.35, 50.0)
    logs = np.log(capacities)
    assert found.fragility.median == pytest.approx(math.exp(logs.mean()) / 1.35)
    assert found.fragility.deviation == pytest.approx(logs.std(ddof=1))
    assert found.rate == pytest.approx(rate(math.exp(logs.mean()) / 1.35, logs.std(ddof=1))[0])
    with_factor = rate(math.exp(logs.mean()) / 1.35, logs.std(ddof=1))
    assert (found.beyond, found.weaker) == pytest.approx(with_factor[1:])
    assert found.without_factor == pytest.approx(rate(math.exp(logs.mean()), logs.std(ddof=1))[0])
    assert found.low < found.rate < found.high and found.without_factor < found.rate
    assert found.in_life == pytest.approx(1.0 - math.exp(-50.0 * found.rate))
    assert found == state_rate("SLV", capacities, list("abcdefg"), HAZARD, 1.35, 50.0)
    assert exceedance_probability(1e-12, 50.0) == pytest.approx(5e-11, rel=1e-9)


@pytest.mark.shows("risk.rate")
def test_that_the_components_of_one_station_are_drawn_together():
    """Two files of each station: the interval is that of the stations, wider than that of as many of their own."""
    capacities = [2.0, 2.0, 3.0, 3.0, 4.0, 4.0, 5.0, 5.0]
    paired = state_rate("SLV", capacities, list("aabbccdd"), HAZARD, 1.0, None)
    single = state_rate("SLV", capacities, list("abcdefgh"), HAZARD, 1.0, None)
    assert paired.rate == single.rate and paired.high - paired.low > 1.1 * (single.high - single.low)
    assert paired.in_life is None


@pytest.mark.shows("risk.rate")
def test_that_the_interval_is_nine_tenths_of_the_drawn_sets():
    """The rate of each set by itself: a record drawn twice is there twice."""
    capacities, names = np.array([2.0, 3.0, 2.5, 4.0, 3.3, 2.2, 2.8]), list("aabcdef")
    found = state_rate("SLV", capacities, names, HAZARD, 1.35, None)
    rates = [typical_rate(np.repeat(capacities, row) / 1.35, HAZARD) for row in bootstrap_counts(names, STATION_DRAWS)]
    assert (found.low, found.high) == pytest.approx(np.quantile(rates, (0.05, 0.95)), rel=1e-12)
    assert found.rate == pytest.approx(typical_rate(capacities / 1.35, HAZARD), rel=1e-12)


@pytest.mark.shows("risk.rate")
def test_that_two_stations_and_a_site_without_hazard_have_no_rate():
    assert state_rate("SLV", [2.0, 3.0, 4.0], ["a", "a", "b"], HAZARD, 1.0, 50.0) is None
    assert state_rate("SLV", [2.0, 3.0, 4.0], ["a", "b", "c"], (), 1.0, 50.0) is None
    assert state_rate("SLV", [2.0, 3.0, 4.0], ["a", "b", "c"], HAZARD, 1.0, 50.0).rate > 0.0


def test_that_rows_of_nearly_one_a_g_are_a_step():
    """The limit of the slope: a row that is as good as vertical, where the closed form would overflow."""
    near = [(30, 0.6), (475, 2.1), (975, 2.10001), (2475, 3.7)]
    first, last = [(30, 0.6), (475, 0.60001), (975, 2.7)], [(30, 0.6), (975, 2.7), (2475, 2.70001)]
    for median, deviation in ((2.0, 0.3), (1.0, 1.5)):
        for rows in (near, first, last):  # F hardly changes along a step
            expected = by_quadrature(median, deviation, rows)
            assert rate(median, deviation, rows) == pytest.approx(expected, rel=1e-4)
    gap = [(30, 0.6), (475, 2.1), (2475, 3.7)]
    jump = rate(2.0, 0.3, [(30, 0.6), (475, 2.1), (476, 2.1 * (1 + 1e-9)), (2475, 3.7)])[0]
    assert jump == pytest.approx(rate(2.0, 0.3, gap)[0], rel=2e-2)
    assert rate(1.0, 30.0) == rate(1.0, 2.0)  # of records that tell nothing


def test_that_nothing_of_scipy_is_needed():
    """A batch installation has none."""
    program = (
        f"import sys; sys.path.insert(0, {str(ROOT)!r}); sys.modules['scipy'] = None; import numpy as np;"
        "from core.codes.collapse_rate import mean_rate;"
        "print(mean_rate(np.array([1.0]), np.array([0.3]), [(30, 0.6), (475, 2.1)])[0][0])"
    )
    done = subprocess.run([sys.executable, "-P", "-c", program], capture_output=True, text=True)
    assert float(done.stdout) > 0.0, done.stderr
