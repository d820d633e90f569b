"""What the sample of records does to zeta_E: the interval that the same number of stations, drawn again, would give.

Of each record the largest rotation is found once, on a grid of multipliers of the demand; every set of them is then a
sum. The sets are those of the bootstrap (Efron 1979): stations, not files, are drawn with replacement, for the
components of one station are not independent. The rule (mean, or the most unfavourable) stays that of the whole set.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from core.capacity.ida import collapse_count
from core.capacity.limit_states import LIMIT_FRACTION
from core.codes.demand import DemandResult
from core.codes.dynamic_check import DemandRuns
from core.codes.multiplier_search import HALF_FAIL, MAX_MULTIPLIER, STEP, WINDOW
from core.ground.ground_motion import GroundMotion
from core.ground.provenance import station_of
from core.rocking.methods import Method
from core.rocking.outcome import COLLAPSED, STABLE
from core.wall.rocking_model import RockingModel

EVERY = 12
"""Every how many points of the grid of zeta_E the peaks are known: by 3 %."""

SPAN = 2.5
"""Multiplier over zeta_E up to which peaks are found; a set that fails nowhere below is said to reach it."""

DRAWS, SEED = 1000, 1
"""Sets that are drawn, and the seed that makes them the same in every run."""

SHARE = 0.90
"""Share of the drawn sets within the interval."""

LEAST_STATIONS = 3
"""Stations below which nothing is drawn."""


@dataclass(frozen=True)
class RecordPeaks:
    """Largest rotations of a wall under each record.

    multipliers : of the demand, rising by one factor [-], shape (m,)
    peaks : over theta_c, of each record its worse sign, infinite where it overturns and where it has no number,
        shape (records, m)
    limit : the share of theta_c the rule allows; mean : it takes the mean
    """

    multipliers: np.ndarray
    peaks: np.ndarray
    limit: float
    mean: bool


@dataclass(frozen=True)
class SampleInterval:
    """Where zeta_E lies for nine of ten sets of as many stations.

    low, high : [-]; high is that of the last multiplier where `open_end`
    stations : drawn from
    """

    low: float
    high: float
    stations: int
    open_end: bool


def record_peaks(
    model: RockingModel,
    motions: list[GroundMotion],
    polarities: tuple[int, ...],
    demand: DemandResult,
    method: Method,
    zeta: float,
    cancelled: Callable[[], bool] = lambda: False,
) -> RecordPeaks:
    """The peaks of every record, from rest to SPAN times zeta_E [-]; the rest as `demand_check` takes it.

    Raises Cancelled.
    """
    runs = DemandRuns(model, motions, polarities, demand, demand.confidence_on, method, cancelled)
    step = EVERY * math.log1p(STEP)
    first = math.floor(math.log(runs.rest / demand.zeta_target) / step)
    last = math.ceil(math.log(min(SPAN * zeta, MAX_MULTIPLIER) / demand.zeta_target) / step)
    multipliers = demand.zeta_target * np.exp(step * np.arange(first, max(first, last) + 1))
    peaks = np.empty((len(motions), multipliers.size))
    for batch, grounds in runs.batches:
        outcomes, reached = runs.analyse(batch, grounds, multipliers)
        reached[(outcomes != STABLE) | (outcomes == COLLAPSED)] = math.inf
        peaks[batch] = reached.max(axis=1)
    return RecordPeaks(multipliers, peaks, LIMIT_FRACTION[demand.limit_state], runs.mean)


def zeta_of_sets(found: RecordPeaks, counts: np.ndarray) -> np.ndarray:
    """zeta_E of sets of the records, shape (sets,); infinite where the rule fails at too few of the multipliers.

    counts : how often each record is in each set, shape (sets, records)
    """
    here = np.minimum(found.peaks, 1e9)  # no 0 times infinity
    taken = counts > 0
    worst = np.max(np.where(taken[:, :, None], here[None], 0.0), axis=1)
    value = counts @ here / counts.sum(axis=1)[:, None] if found.mean else worst
    fails = (worst > 1.0) | (value > found.limit)
    step = math.log(found.multipliers[1] / found.multipliers[0])
    half = round(WINDOW / step)
    # the last multiplier stands for those beyond it
    padded = np.concatenate([fails, np.repeat(fails[:, -1:], half, axis=1)], axis=1)
    reached = np.array([collapse_count(row, half)[: fails.shape[1]] for row in padded]) >= HALF_FAIL * (2 * half + 1)
    zeta = found.multipliers[reached.argmax(axis=1)] * math.exp(-0.5 * step)
    return np.where(reached.any(axis=1), zeta, math.inf)


def sample_interval(found: RecordPeaks, motions: list[GroundMotion]) -> SampleInterval | None:
    """The interval of zeta_E; None below LEAST_STATIONS stations. motions : those of `record_peaks`, in their order"""
    names = [station_of(motion, k) for k, motion in enumerate(motions)]
    known = sorted(set(names))
    if len(known) < LEAST_STATIONS:
        return None
    drawn = np.random.default_rng(SEED).integers(len(known), size=(DRAWS, len(known)))
    times = np.array([np.bincount(row, minlength=len(known)) for row in drawn])
    zetas = zeta_of_sets(found, times[:, [known.index(name) for name in names]])
    low, high = np.quantile(zetas, (0.5 - SHARE / 2, 0.5 + SHARE / 2), method="inverted_cdf")
    top = float(found.multipliers[-1])
    return SampleInterval(min(float(low), top), min(float(high), top), len(known), not math.isfinite(high))


def one_left_out(found: RecordPeaks) -> np.ndarray:
    """zeta_E without each of the records in turn, shape (records,)."""
    n = len(found.peaks)
    return zeta_of_sets(found, 1 - np.eye(n, dtype=np.int64))
