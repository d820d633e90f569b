"""Response spectra and the Housner intensity, Eq. 11."""

import math

import numpy as np
import pytest

from core.ground import records, response_spectrum
from core.ground.ground_motion import GroundMotion
from core.ground.records.grammar import Options
from core.units import G


def motion(samples, dt=0.01):
    return GroundMotion("test", np.asarray(samples, float), dt)


@pytest.mark.shows("mechanics.spectra")
@pytest.mark.parametrize("period", [0.05, 0.1, 0.5, 1.0, 2.5, 5.0])
def test_that_an_oscillator_follows_scipys_exact_linear_response(reference, period):
    """lsim with linear interpolation is exact for piecewise linear ground: another program, same peak."""
    from scipy.signal import lsim

    z, w = 0.05, 2 * math.pi / period
    ground = np.concatenate([reference("standard")[0], np.zeros(4000)])
    system = ([[0.0, 1.0], [-w * w, -2 * z * w]], [[0.0], [-1.0]], [[1.0, 0.0]], [[0.0]])
    _, response, _ = lsim(system, ground, np.arange(ground.size) * 0.01, interp=True)
    found = response_spectrum.displacement_spectrum(ground, 0.01, np.array([period]), z, 0)[0]
    assert found == pytest.approx(np.abs(response).max(), rel=1e-9)


@pytest.mark.shows("mechanics.spectra")
@pytest.mark.parametrize("u, v", [(1.0, 0.0), (0.3, 2.0), (-0.3, 2.0), (0.0, -1.5), (0.7, -40.0)])
def test_that_the_free_peak_is_the_largest_of_the_free_motion(u, v):
    z, w = 0.05, 7.0
    wd = w * math.sqrt(1 - z * z)
    t = np.linspace(0.0, 2.0, 400_001)
    motion = np.exp(-z * w * t) * (u * np.cos(wd * t) + (v + z * w * u) / wd * np.sin(wd * t))
    peak = max(abs(u), response_spectrum.free_peak(u, v, w, wd, z))
    assert peak == pytest.approx(np.abs(motion).max(), rel=1e-9)


def test_that_zero_padding_changes_no_spectrum(reference):
    ground = np.append(reference("standard")[0][:700], 0.0)
    periods = response_spectrum.HOUSNER_PERIODS
    bare = response_spectrum.displacement_spectrum(ground, 0.01, periods, 0.05, 0)
    behind = np.concatenate([ground, np.zeros(2000)])
    before = np.concatenate([np.zeros(333), ground])
    # sampled maxima against the exact one of the free motion after the record
    padded = response_spectrum.displacement_spectrum(behind, 0.01, periods, 0.05, 0)
    assert np.all(padded <= bare * (1 + 1e-12))
    assert np.allclose(padded, bare, rtol=3e-3)
    assert np.array_equal(response_spectrum.displacement_spectrum(before, 0.01, periods, 0.05, 0), bare)


@pytest.mark.parametrize("per_period", [0, 40])
def test_that_an_oscillator_beside_others_moves_as_one_alone(reference, per_period):
    ground, drawn = reference("standard")[0], np.random.default_rng(5)
    periods = drawn.permutation(np.geomspace(0.02, 4.0, 75))
    found = response_spectrum.displacement_spectrum(ground, 0.01, periods, 0.05, per_period)
    alone = [
        response_spectrum.displacement_spectrum(ground, 0.01, periods[k : k + 1], 0.05, per_period)[0]
        for k in range(75)
    ]
    assert np.array_equal(found, alone)


def test_that_looks_between_samples_are_of_the_ground_between_them(reference):
    """Four looks a sample are the same ground with four times as many samples."""
    ground = reference("standard")[0][:900]
    fine = np.interp(np.arange(4 * (ground.size - 1) + 1) / 4.0, np.arange(ground.size), ground)
    periods = np.array([0.1, 0.11, 0.13])
    seen = response_spectrum.displacement_spectrum(ground, 0.01, periods, 0.05, 40)
    assert seen == pytest.approx(response_spectrum.displacement_spectrum(fine, 0.0025, periods, 0.05, 0), rel=1e-12)


def test_that_the_housner_intensity_is_of_each_two_hundredths_of_a_second():
    assert np.diff(response_spectrum.HOUSNER_PERIODS) == pytest.approx(0.02, rel=1e-12)


def test_that_spectra_and_arias_agree_with_scipy(reference):
    """The oscillator as a linear system whose input is linear between samples, by scipy's own matrix exponential."""
    from scipy import signal

    ground = reference("standard")[0]
    times = 0.01 * np.arange(ground.size)
    for period in (0.1, 0.2, 0.5, 1.0, 1.7, 2.5):
        w = 2.0 * math.pi / period
        system = ([[0.0, 1.0], [-w * w, -2.0 * 0.05 * w]], [[0.0], [-1.0]], [[1.0, 0.0]], [[0.0]])
        _, response, _ = signal.lsim(system, ground, times, interp=True)
        ours = response_spectrum.displacement_spectrum(ground, 0.01, np.array([period]), 0.05, 0)[0]
        # the free motion after the record counts in ours
        assert ours == pytest.approx(np.abs(response).max(), rel=1e-9)
    assert motion(ground).arias == pytest.approx(math.pi / (2 * G) * np.trapezoid(ground**2, dx=0.01), rel=1e-12)


@pytest.mark.parametrize(
    "file, options, known",
    [
        ("PEER_AT2/IELC180.AT2", Options(), 128.96),
        ("plain_txt/P695_SortedEQFile_121711.txt", Options(unit="g"), 73.15),
        ("plain_txt/P695_SortedEQFile_120411.txt", Options(unit="g"), 211.25),
    ],
)
def test_that_the_housner_intensity_is_the_known_one(shelf, file, options, known):
    found = records.read(shelf / file, options)
    assert 100 * found.housner_intensity == pytest.approx(known, rel=1e-3)


@pytest.mark.shows("paper.eq_11")
def test_that_el_centro_has_the_intensity_of_the_paper(shelf):
    """Table 2 prints 124.27 cm, for the 0.319 g digitisation."""
    found = records.read(shelf / "plain_txt/elcentro_NS_trunc.dat", Options(unit="m/s2"))
    assert 100 * found.housner_intensity == pytest.approx(124.27, rel=1e-3)


def test_that_a_period_shorter_than_forty_samples_is_looked_at_between_them():
    """From 40 samples on they are near enough: 1 - cos(pi / 40) is 0.3 %."""
    ground = np.random.default_rng(1).normal(size=200)
    for period, between in ((0.4, False), (0.399, True)):
        at = np.array([period])
        looked = response_spectrum.pseudo_acceleration_spectrum(ground, 0.01, at)[0]
        samples = response_spectrum.pseudo_acceleration_spectrum(ground, 0.01, at, per_period=0)[0]
        assert (looked > 1.001 * samples) == between and (between or looked == samples)
