"""Sets of motions that scatter about a spectrum as natural ones do."""

import numpy as np
import pytest

from core.codes import target_spectrum
from core.ground.artificial import MATCHED_PERIODS
from core.ground.response_spectrum import pseudo_acceleration_spectrum
from core.ground.scattered import MIN_MEAN, SPREAD, TIME_STEP, correlation, deviations, scattered_set
from core.units import G

TARGET = target_spectrum.ntc2018(0.2 * G, 2.45, 0.33, "B", "T1")
BAND = 0.15, 2.0


@pytest.fixture(scope="module")
def motions():
    return scattered_set(TARGET, 14, 1, SPREAD, BAND)


@pytest.mark.shows("demand.scattered")
def test_that_the_correlation_is_the_published_one():
    """Baker and Jayaram (2008): 1 at one period, near 1 beside it, and C1 by hand for 0.2 and 2 s."""
    assert correlation(1.0, 1.0) == pytest.approx(1.0) and correlation(0.05, 0.05) == pytest.approx(1.0)
    assert correlation(0.2, 2.0) == pytest.approx(1.0 - np.cos(np.pi / 2.0 - 0.366 * np.log(10.0)))
    # C1 = 1 - sin(0.366 ln 5) = 0.44442; cos(pi / 2) = 0, thus C4 = C1 + (0.66665 - C1) / 2
    assert correlation(0.0545, 0.545) == pytest.approx(0.55554, abs=1e-5)
    assert correlation(0.109, 1.0) == pytest.approx(correlation(0.109 + 1e-9, 1.0), abs=1e-7)
    assert correlation(0.05, 0.1) == correlation(0.1, 0.05) > 0.9
    periods = np.array([0.01, *MATCHED_PERIODS])
    matrix = np.array([[correlation(a, b) for b in periods] for a in periods])
    assert np.linalg.eigvalsh(matrix).min() > -1e-3 and matrix.max() <= 1.0 + 1e-12


@pytest.mark.shows("demand.scattered")
def test_that_the_deviations_of_a_set_have_no_mean_and_the_spread_and_correlation_asked_for():
    periods = np.array([0.2, 0.5, 1.0, 2.0])
    eps = deviations(2000, 4, periods)
    assert np.abs(eps.mean(axis=0)).max() < 1e-12 and eps.std(axis=0) == pytest.approx(np.ones(4), abs=0.02)
    assert np.corrcoef(eps[:, 0], eps[:, 3])[0, 1] == pytest.approx(correlation(0.2, 2.0), abs=0.05)


@pytest.mark.shows("demand.scattered")
def test_that_the_mean_of_a_set_is_compatible_and_its_motions_scatter(motions):
    periods = np.geomspace(*BAND, 90)
    spectra = np.array([pseudo_acceleration_spectrum(motion, TIME_STEP, periods) for motion in motions])
    ratio = spectra.mean(axis=0) / TARGET.acceleration(periods)
    assert ratio.min() >= MIN_MEAN * (1.0 - 1e-3) and ratio.mean() < 1.25
    assert np.mean([np.abs(motion).max() for motion in motions]) >= TARGET.pga
    assert np.log(spectra).std(axis=0, ddof=1).mean() == pytest.approx(SPREAD, abs=0.1)


def test_that_each_motion_ends_at_rest_and_a_seed_gives_the_same_bits(motions):
    for motion in motions:
        velocity = np.cumsum(motion) * TIME_STEP
        assert abs(velocity[-1]) < 0.02 * np.abs(velocity).max() and motion[-1] == pytest.approx(0.0, abs=1e-6)
    again = scattered_set(TARGET, 14, 1, SPREAD, BAND)
    assert [one.tobytes() for one in again] == [motion.tobytes() for motion in motions]
    assert scattered_set(TARGET, 14, 2, SPREAD, BAND)[0].tobytes() != motions[0].tobytes()
