"""Sets of artificial motions that scatter about a target spectrum as natural ones do.

Motions matched one by one to a spectrum are too kind to a rocking wall: none of them is stronger than the mean where it
matters. Here each follows the target times exp(s eps(T)); eps, of one set, is normal and correlated over the periods as
that of natural records (Baker and Jayaram 2008), and the whole set has one factor, so that its mean fits the target.
"""

import functools
import math
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from statistics import NormalDist
from typing import Any

import numpy as np

from core.ground.artificial import MATCHED_PERIODS, compatible_motion
from core.ground.response_spectrum import pseudo_acceleration_spectrum

SPREAD = 0.65
"""s: standard deviation of ln S_a of natural records over the mean of their set, that of sets of one half of the events
of a shelf, the mean over twelve partings by lot, 0.51 to 0.76 (tests/validation/scatter_of_records.py)."""

MIN_MEAN = 0.9
"""Least mean S_a over the target within the band (NTC 2018 3.2.3.6, EN 1998-1 3.2.3.1.2(4)c)."""

PERIOD_OF_PGA = 0.01
"""Period [s] whose eps is that of the PGA."""

TIME_STEP = 0.01

SCALING_ROUNDS = 5
"""Rounds of the scaling: a motion that is to scatter need not be near to its own goal."""


def correlation(first: float, second: float) -> float:
    """Correlation of eps at two periods from 0.01 to 10 s, first and second [s]: Baker and Jayaram (2008), Earthquake
    Spectra 24(1), Eq. 9."""
    low, high = sorted((first, second))
    c1 = 1.0 - math.cos(math.pi / 2.0 - 0.366 * math.log(high / max(low, 0.109)))
    c2 = 0.0
    if high < 0.2:
        c2 = 1.0 - 0.105 * (1.0 - 1.0 / (1.0 + math.exp(100.0 * high - 5.0))) * (high - low) / (high - 0.0099)
    c3 = c2 if high < 0.109 else c1
    c4 = c1 + 0.5 * (math.sqrt(c3) - c3) * (1.0 + math.cos(math.pi * low / 0.109))
    if high <= 0.109:
        return c2
    if low > 0.109:
        return c1
    return min(c2, c4) if high < 0.2 else c4


@functools.lru_cache(maxsize=4)
def _modes(periods: tuple[float, ...]) -> tuple[np.ndarray, np.ndarray]:
    """Variances and directions of the correlation of eps over periods [s]: every set has the same."""
    variances, directions = np.linalg.eigh(np.array([[correlation(a, b) for b in periods] for a in periods]))
    return np.clip(variances, 0.0, None), directions


def deviations(count: int, seed: int, periods: np.ndarray) -> np.ndarray:
    """eps of the motions of a set, shape (count, periods). Stratified: along each direction of the correlation the
    values are the quantiles of the normal distribution, in an order drawn by the seed. periods : [s]"""
    variances, directions = _modes(tuple(periods))
    draw = np.random.Generator(np.random.PCG64(seed))
    levels = np.array([NormalDist().inv_cdf((k + 0.5) / count) for k in range(count)])
    scores = np.array([draw.permutation(levels) for _ in periods])
    eps = (directions * np.sqrt(variances)) @ scores
    return (eps / np.sqrt((directions**2 * variances).sum(axis=1))[:, None]).T


@dataclass(frozen=True, eq=False)
class Goal:
    """Spectrum one motion of a set is matched to: the target times factors at some periods.

    periods : [s], rising; factors : there; pga : [m/s2]
    """

    target: Any
    periods: np.ndarray
    factors: np.ndarray
    pga: float

    def acceleration(self, periods: np.ndarray) -> np.ndarray:
        """Spectrum S_a of the motion [m/s2] at periods [s]."""
        there = np.interp(np.log(periods), np.log(self.periods), np.log(self.factors))
        return self.target.acceleration(periods) * np.exp(there)


def scattered_set(target, count: int, seed: int, spread: float, band: tuple[float, float]) -> list[np.ndarray]:
    """Accelerations [m/s2] of the motions of a set, every TIME_STEP, under one factor: that for which the mean of the
    ratios of their mean spectrum to the target is 1, and at least the one for which the rules of the mean hold.

    target : of target_spectrum; count, seed : of the set; spread : s; band : periods of the rules [s]
    """
    periods = np.array([PERIOD_OF_PGA, *MATCHED_PERIODS])
    factors = np.exp(spread * deviations(count, seed, periods))
    goals = [Goal(target, periods, one, float(target.pga * one[0])) for one in factors]
    with ThreadPoolExecutor() as pool:  # the kernel, most of the time, holds no lock
        matched = functools.partial(compatible_motion, rounds=SCALING_ROUNDS)
        motions = list(pool.map(matched, goals, range(seed, seed + count)))
    compared = np.geomspace(*band, 120)
    mean = np.mean([pseudo_acceleration_spectrum(motion, TIME_STEP, compared) for motion in motions], axis=0)
    ratio = mean / target.acceleration(compared)
    start = float(np.mean([np.abs(motion).max() for motion in motions])) / target.pga
    factor = max(1.0 / float(ratio.mean()), MIN_MEAN / float(ratio.min()), 1.0 / start) * (1.0 + 1e-6)
    return [factor * motion for motion in motions]
