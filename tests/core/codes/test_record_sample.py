"""What other samples of records give, against the check of the set itself."""

from dataclasses import replace

import numpy as np
import pytest

from core.case.rules import parse_case
from core.codes import record_sample
from core.codes.dynamic_check import DemandRuns, run_dynamic_check
from core.codes.multiplier_search import MULTIPLIER_STEP
from core.codes.record_sample import (
    RecordPeaks,
    leave_one_out_zetas,
    record_peaks,
    sample_interval,
    zetas_of_resampled_sets,
)
from core.ground.artificial import filtered_noise
from core.ground.ground_motion import GroundMotion
from core.rocking.methods import AUTO
from core.rocking.outcome import STABLE
from core.setting.check_input import make_rocking_model
from core.setting.demand_input import read_demand

WITHIN = (1.0 + MULTIPLIER_STEP) ** (2 * record_sample.EVERY)
"""Two points of the coarse grid."""


@pytest.fixture(scope="module")
def scene():
    case = parse_case(
        {
            "wall": [{"name": "w", "height_m": 3.0, "thickness_m": 0.4, "mechanism": "two_sided", "base_z_m": 0.0}],
            "demand": {"ag_g": 0.25, "soil_factor": 1.2},
        }
    )
    motions = [GroundMotion(f"m{k}", 2.5 * filtered_noise(k + 1, 2.0), 0.01) for k in range(8)]
    return make_rocking_model(case.wall[0], "two_sided"), motions, read_demand(case, None)


@pytest.fixture(scope="module")
def peaks(scene):
    model, motions, demand = scene
    zeta = run_dynamic_check(model, motions, (1,), demand, AUTO, other=False).zeta
    return zeta, record_peaks(model, motions, (1,), demand, AUTO, zeta)


def test_that_the_whole_set_is_the_check_itself(peaks):
    zeta, found = peaks
    (whole,) = zetas_of_resampled_sets(found, np.ones((1, 8), int))
    assert zeta / WITHIN < whole < zeta * WITHIN


def test_that_a_record_left_out_is_the_check_of_the_others(scene, peaks):
    """Eight stations, so that seven keep the rule of the mean."""
    model, motions, demand = scene
    without = leave_one_out_zetas(peaks[1])
    for k in range(8):
        others = [motion for n, motion in enumerate(motions) if n != k]
        alone = run_dynamic_check(model, others, (1,), demand, AUTO, other=False).zeta
        assert alone / WITHIN < without[k] < alone * WITHIN
    assert without.max() > without.min()


def test_that_a_record_taken_twice_counts_twice(scene, peaks):
    model, motions, demand = scene
    (twice,) = zetas_of_resampled_sets(peaks[1], np.array([[2, 1, 1, 1, 1, 1, 1, 0]]))
    again = [*motions[:7], replace(motions[0], name="again")]
    alone = run_dynamic_check(model, again, (1,), demand, AUTO, other=False).zeta
    assert alone / WITHIN < twice < alone * WITHIN


@pytest.mark.shows("search.sample")
def test_that_the_interval_is_that_of_the_drawn_stations_and_the_same_again(scene, peaks):
    _, motions, _ = scene
    found = sample_interval(peaks[1], motions, peaks[0])
    assert found == sample_interval(peaks[1], motions, peaks[0])
    assert found.low < peaks[0] < found.high and found.stations == 8 and not found.open_end
    rng, zetas = np.random.default_rng(7), []
    for _ in range(400):
        zetas += list(zetas_of_resampled_sets(peaks[1], np.bincount(rng.integers(8, size=8), minlength=8)[None]))
    share = np.mean([(found.low <= zeta) & (zeta <= found.high) for zeta in zetas])
    assert 0.85 <= share <= 1.0


def test_that_records_of_one_kind_have_no_interval_and_two_stations_none_at_all(scene):
    model, motions, demand = scene
    same = [replace(motions[0], name=f"s{k}") for k in range(7)]
    zeta = run_dynamic_check(model, same, (1,), demand, AUTO, other=False).zeta
    found = sample_interval(record_peaks(model, same, (1,), demand, AUTO, zeta), same, zeta)
    assert found.low == found.high == pytest.approx(zeta, rel=1e-12)
    assert sample_interval(record_peaks(model, same[:2], (1,), demand, AUTO, zeta), same[:2], zeta) is None


def by_hand(found, counts):
    """zeta_E of one set: the first multiplier with half of those within +-10 % failing, one after the other."""
    fails = []
    for at in found.peaks.T:
        peaks = np.repeat(at, counts)
        fails.append(peaks.max() > 1.0 or (peaks.mean() if found.mean else peaks.max()) > found.limit)
    last = len(fails) - 1
    for k, multiplier in enumerate(found.multipliers):
        around = [place >= 0 and fails[min(place, last)] for place in range(k - 10, k + 11)]
        if sum(around) >= 0.5 * len(around):
            return multiplier / 1.01**0.5
    return np.inf


@pytest.mark.parametrize("mean", [True, False])
def test_that_zeta_of_a_set_is_where_half_of_its_neighbours_fail(mean):
    """Also of walls that survive stronger motions than those that overturned them."""
    rng = np.random.default_rng(3)
    for rise in (0.2, 0.4, 0.8):
        peaks = rise * rng.uniform(0.0, 2.0, (4, 60)) * np.linspace(0.2, 1.6, 60)
        found = RecordPeaks(0.5 * 1.01 ** np.arange(60), peaks, 0.4, mean)
        counts = rng.multinomial(4, [0.25] * 4, 30)
        assert zetas_of_resampled_sets(found, counts) == pytest.approx(
            [by_hand(found, row) for row in counts], rel=1e-12
        )


@pytest.mark.parametrize("target", [1.0, 0.6])
def test_that_the_peaks_begin_at_half_of_zeta_unless_a_record_alone_breaks_the_rule_there(scene, target):
    """A tall wall that rocks long before it overturns; half of three times zeta_E is beyond what it bears. Nothing is
    asked of a wall at rest."""
    _, motions, demand = scene
    wall = {"name": "w", "height_m": 12.0, "thickness_m": 0.8, "mechanism": "two_sided", "base_z_m": 0.0}
    model = make_rocking_model(parse_case({"wall": [wall]}).wall[0], "two_sided")
    demand, step = replace(demand, zeta_target=target), (1.0 + MULTIPLIER_STEP) ** record_sample.EVERY
    zeta = run_dynamic_check(model, motions, (1,), demand, AUTO, other=False).zeta
    found = record_peaks(model, motions, (1,), demand, AUTO, zeta)
    assert 0.5 / step <= found.multipliers[0] / zeta <= 0.5
    assert 1.5 / step <= found.multipliers[-1] / zeta < 1.5 * step
    (whole,) = zetas_of_resampled_sets(found, np.ones((1, 8), int))
    assert zeta / WITHIN < whole < zeta * WITHIN
    rest = DemandRuns(model, motions, (1,), demand, demand.confidence_on, AUTO, lambda: False).rest
    for asked in (3.0 * zeta, 1.9 * rest):
        assert rest / step <= record_peaks(model, motions, (1,), demand, AUTO, asked).multipliers[0] <= rest


def test_that_a_set_that_fails_nowhere_has_an_open_end(peaks):
    _, found = peaks
    short = replace(found, multipliers=found.multipliers[:5], peaks=0.0 * found.peaks[:, :5])
    motions = [GroundMotion(f"m{k}", np.ones(10), 0.01) for k in range(8)]
    interval = sample_interval(short, motions, 1.0)
    assert interval.open_end and interval.high == interval.low == short.multipliers[-1]


def test_that_the_peaks_are_known_by_one_percent(peaks):
    """`by_hand` counts ten of these points on either side, +-10 %."""
    _, found = peaks
    assert np.diff(np.log(found.multipliers)) == pytest.approx(0.01, rel=2e-3)


def test_that_every_point_is_analysed_however_little_a_record_rocks_beside_it(scene, peaks):
    """A wall whose peaks are below 0.20 theta_c at two multipliers 4 % apart overturns between them now and then."""
    (model, motions, demand), (_, found) = scene, peaks
    runs = DemandRuns(model, motions, (1,), demand, demand.confidence_on, AUTO, lambda: False)
    for record, shown in enumerate(found.peaks):
        outcomes, reached = runs.analyse([record], found.multipliers)
        assert np.array_equal(shown, np.where(outcomes == STABLE, reached, np.inf)[0, 0])
