"""Compatible motions: spectrum, PGA, length, ends, reproducibility; compliance of sets."""

import numpy as np
import pytest

from core.codes import target_spectrum as ts
from core.codes.spectrum_codes import en1998
from core.ground.artificial import compatible_motion, filtered_noise
from core.ground.ground_motion import GroundMotion
from core.ground.response_spectrum import displacement_spectrum, pseudo_acceleration_spectrum
from core.units import G

PERIODS = np.arange(0.1, 2.501, 0.02)
TARGETS = [en1998(0.26 * G, 1, "B"), en1998(0.10 * G, 2, "D"), ts.ntc2018(0.26 * G, 2.4, 0.35, "C", "T1")]


@pytest.mark.shows("demand.generated")
@pytest.mark.parametrize("target", TARGETS, ids=lambda target: target.name)
@pytest.mark.parametrize("seed", [1, 500])
def test_that_a_set_of_seven_follows_its_spectrum(target, seed):
    motions = [compatible_motion(target, seed + k) for k in range(7)]
    spectra = [pseudo_acceleration_spectrum(motion, 0.01, PERIODS) for motion in motions]
    ratio = np.mean(spectra, axis=0) / target.acceleration(PERIODS)
    assert ratio.min() >= 0.95 and ratio.max() <= 1.10
    for motion in motions:
        record = GroundMotion("m", motion, 0.01)
        # samples are rounded to 1e-7 m/s2: what is left of drift is their sum
        assert record.pga == pytest.approx(target.pga, abs=1e-6)
        assert abs(record.velocity[-1]) < 1e-6
        assert abs(np.trapezoid(record.velocity, dx=0.01)) < 1e-5
        assert record.duration >= 25.0
        # at long periods S_De tends to PGD: its last branch is the scale of a plausible one
        plateau = ts.displacement(target, [4.0])[0]
        assert 0.2 * plateau < record.pgd < 1.5 * plateau
        assert motion[0] == 0.0 == motion[-1]


@pytest.mark.shows("demand.generated")
@pytest.mark.parametrize("seeds", [6, pytest.param(30, marks=pytest.mark.long)])
@pytest.mark.parametrize("soil", ["D", "E"])
def test_that_the_peak_is_a_g_s_where_peaks_stand_side_by_side(soil, seeds):
    target = en1998(0.26 * G, 1, soil)
    for seed in range(1, seeds + 1):
        assert np.abs(compatible_motion(target, seed)).max() == pytest.approx(target.pga, abs=1e-6)


def test_that_a_seed_gives_the_same_motion_and_another_seed_another():
    one = compatible_motion(TARGETS[0], 5)
    assert np.array_equal(one, compatible_motion(TARGETS[0], 5))
    assert not np.array_equal(one, compatible_motion(TARGETS[0], 6))


@pytest.mark.shows("mechanics.spectra")
def test_that_looks_between_samples_find_the_peak_of_a_harmonic():
    # resonance of a 0.1 s oscillator sampled four times a period: the samples miss the peaks
    dt, period = 0.025, 0.1
    time = np.arange(0.0, 6.0, dt)
    ground = np.sin(2.0 * np.pi * time / 0.11 + 0.3)
    fine = np.interp(np.arange(0.0, time[-1], dt / 64), time, ground)
    truth = displacement_spectrum(fine, dt / 64, np.array([period]), 0.05, 0)[0]
    seen = displacement_spectrum(ground, dt, np.array([period]), 0.05, 40)[0]
    coarse = displacement_spectrum(ground, dt, np.array([period]), 0.05, 0)[0]
    assert seen == pytest.approx(truth, rel=3e-3)
    assert coarse < 0.99 * truth


@pytest.mark.parametrize(("duration", "step"), [(20.0, 0.01), (12.5, 0.005)])
def test_that_a_motion_lasts_as_long_as_is_asked(duration, step):
    """n steps have n + 1 samples, the first and the last of them at rest."""
    noise = filtered_noise(3, 1.0, duration, step)
    followed = compatible_motion(TARGETS[0], 3, duration, step, rounds=1)
    for motion in (noise, followed):
        assert (motion.size - 1) * step == pytest.approx(duration, rel=1e-12)
        assert motion[0] == 0.0 == motion[-1]
