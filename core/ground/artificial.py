"""Artificial motions: filtered noise under an envelope, and sets compatible with a target spectrum."""

import math

import numpy as np

from core.ground.response_spectrum import pseudo_acceleration_spectrum

GROUND_FREQUENCY = 2.5
GROUND_DAMPING = 0.6
"""Kanai-Tajimi filter of a firm soil: centre frequency [Hz] and damping [-]."""

LOW_CUT = 0.15
"""Corner of the high-pass that keeps velocity and displacement bounded [Hz]."""


RISE_TIME, STRONG_END = 2.0, 14.0
"""Compatible motions: rise and end of the strong part [s]; at least 10 s stationary (NTC 2018 3.2.3.6)."""

MATCHED_PERIODS = np.geomspace(0.03, 4.0, 70)
MATCHED_CUT = 0.22
"""Below this frequency compatible motions are drained of content [Hz]."""

AIM = 1.02
"""Spectrum the motions are matched to, over the target: the rules are stricter below it than above."""

MATCHING_ROUNDS = 14

WAVELET, WAVELET_REACH = 0.012, 39.0
"""Width of the wavelets by which peaks are cut [s], and how far they reach [of it]: beyond, exp(-x^2 / 2) is zero."""


def _envelope(times: np.ndarray, rise: float, strong_end: float) -> np.ndarray:
    """Rise, strong part, decay, and zero at the last sample."""
    shape = np.minimum(times / rise, 1.0) ** 2
    after = times > strong_end
    shape[after] = np.exp(-0.35 * (times[after] - strong_end))
    return shape * np.clip((times[-1] - times) / 1.0, 0.0, 1.0)


class Rest:
    """Zero end velocity and displacement for motions of the same envelope, by a parabola under it."""

    def __init__(self, envelope: np.ndarray, times: np.ndarray):
        self.times = times
        self.shape = np.vstack([envelope * times**k for k in range(2)])
        self.weights = (1.0, times[-1] - times)
        self.goals = np.array([[np.trapezoid(s * w, times) for s in self.shape] for w in self.weights])

    def at_end_of(self, motion: np.ndarray) -> np.ndarray:
        """The motion without what it has of both at its end."""
        ends = [np.trapezoid(motion * w, self.times) for w in self.weights]
        return motion - np.linalg.solve(self.goals, ends) @ self.shape


def _noise(seed: int, times: np.ndarray, envelope: np.ndarray) -> np.ndarray:
    """Kanai-Tajimi noise without its longest periods, under the envelope."""
    n = times.size
    noise = np.random.Generator(np.random.PCG64(seed)).standard_normal(n)
    frequency = np.fft.rfftfreq(n, times[1])
    x = frequency / GROUND_FREQUENCY
    filter_ = (1.0 + 2j * GROUND_DAMPING * x) / (1.0 - x * x + 2j * GROUND_DAMPING * x)
    high_pass = (frequency / (frequency - 1j * LOW_CUT)) ** 2
    return np.fft.irfft(np.fft.rfft(noise) * filter_ * high_pass, n) * envelope


def filtered_noise(seed: int, pga: float, duration: float = 25.0, time_step: float = 0.01):
    """A seeded accelerogram [m/s2], shape (n,): Kanai-Tajimi noise, 2 s rise, 10 s strong part, decay.

    pga [m/s2]; duration, time_step [s]. Bit-reproducible for a seed; ends at rest and at zero
    displacement.
    """
    times = np.arange(round(duration / time_step) + 1) * time_step
    envelope = _envelope(times, 2.0, 12.0)
    motion = Rest(envelope, times).at_end_of(_noise(seed, times, envelope))
    return np.round(motion * (pga / np.abs(motion).max()), 6)


def compatible_motion(
    target, seed: int, duration: float = 26.0, time_step: float = 0.01, rounds: int = MATCHING_ROUNDS
):
    """A seeded accelerogram [m/s2], shape (n,), whose 5 % spectrum follows the target, PGA = a_g S.

    Fourier amplitudes of enveloped noise are scaled by target over response until they agree (SIMQKE,
    Gasparini and Vanmarcke 1976); 2 s rise, 12 s strong part, decay; it ends at rest and at zero
    displacement. target : of target_spectrum; duration, time_step [s]; rounds : of the scaling.
    """
    times = np.arange(round(duration / time_step) + 1) * time_step
    envelope = _envelope(times, RISE_TIME, STRONG_END)
    motion = _noise(seed, times, envelope)
    motion *= target.pga / np.abs(motion).max()
    frequency = np.fft.rfftfreq(times.size, time_step)
    goal = AIM * target.acceleration(MATCHED_PERIODS)
    falling = np.log(1.0 / MATCHED_PERIODS[::-1])
    log_frequency = np.log(np.maximum(frequency, frequency[1]))
    within, rest = np.minimum(1.0, 4.0 * envelope), Rest(envelope, times)
    for _ in range(rounds):
        response = pseudo_acceleration_spectrum(motion, time_step, MATCHED_PERIODS)
        ratio = np.interp(log_frequency, falling, (goal / response)[::-1])
        ratio[frequency > 1.0 / MATCHED_PERIODS[0]] = target.pga / np.abs(motion).max()
        ratio *= np.minimum(frequency / MATCHED_CUT, 1.0)  # nothing is matched there: no drift
        motion = np.fft.irfft(np.fft.rfft(motion) * ratio, times.size)
        motion = rest.at_end_of(motion * within)
    return np.round(_with_peak(motion, target.pga, times), 7)


def _with_peak(motion: np.ndarray, pga: float, times: np.ndarray) -> np.ndarray:
    """The motion with its peak at pga [m/s2], by narrow Ricker wavelets at the peaks: they have no area and
    no first moment, so that the motion still ends at rest, and next to no spectrum above 0.1 s."""
    reach = math.ceil(WAVELET_REACH * WAVELET / times[1])
    motion = motion.copy()
    for _ in range(200):
        k = int(np.argmax(np.abs(motion)))
        excess = motion[k] - np.copysign(pga, motion[k])
        if abs(excess) <= 1e-9:
            break
        near = slice(max(k - reach, 0), k + reach + 1)
        x = (times[near] - times[k]) / WAVELET
        motion[near] -= excess * (1.0 - x * x) * np.exp(-0.5 * x * x)
        if excess > 0.0:
            motion += 0.0  # what the wavelet is beyond its reach: of -0.0 it makes 0.0
    # where peaks side by side raise one another, what is left (0.6 %) is scaled away
    return motion * (pga / np.abs(motion).max()) if abs(excess) > 1e-9 else motion
