"""What the sample of records does to zeta_E: the interval that the same number of stations, drawn again, would give.

Of each record the largest rotation is found once, on a grid of multipliers of the demand; every set of them is then a
sum. The sets are those of the bootstrap (Efron 1979): stations, not files, are drawn with replacement, for the
components of one station are not independent. The rule (mean, or the most unfavourable) stays that of the whole set.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from core.codes.demand import SeismicDemand
from core.codes.dynamic_check import DemandRuns
from core.codes.multiplier_search import FAILURE_WINDOW, HALF_FAIL, MAX_MULTIPLIER, MULTIPLIER_STEP
from core.ground.ground_motion import GroundMotion
from core.ground.provenance import INTERVAL_SHARE, MIN_STATIONS, bootstrap_counts, station_of
from core.rocking.methods import Method
from core.rocking.outcome import STABLE
from core.wall.rocking_model import RockingModel

EVERY = 4
"""Every how many points of the grid of zeta_E the peaks are known, by 1 %."""

SEARCHED_RANGE = (0.5, 1.5)
"""Multipliers over zeta_E from which on, unless a record alone breaks the rule there, and up to which peaks are found;
a set that fails nowhere below is said to reach the last."""

SET_DRAWS = 1000
"""Sets that are drawn."""


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
    """Interval of zeta_E: nine of ten sets of as many stations lie in it.

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
    demand: SeismicDemand,
    method: Method,
    zeta: float,
    cancelled: Callable[[], bool] = lambda: False,
) -> RecordPeaks:
    """The peaks of every record, from rest to SEARCHED_RANGE times zeta_E.

    model, motions, polarities, demand, method, cancelled : as `run_dynamic_check` takes them
    zeta : zeta_E [-]
    Raises Cancelled.
    """
    runs = DemandRuns(model, motions, polarities, demand, demand.confidence_on, method, cancelled)
    step = EVERY * math.log1p(MULTIPLIER_STEP)
    low, high = runs.rest, min(SEARCHED_RANGE[1] * zeta, MAX_MULTIPLIER)
    if SEARCHED_RANGE[0] * zeta > low:
        fails = [runs.analyse(batch, np.array([SEARCHED_RANGE[0] * zeta])) for batch in runs.together]
        if all((outcomes == STABLE).all() and (peaks < runs.limit).all() for outcomes, peaks in fails):
            low = SEARCHED_RANGE[0] * zeta
    first, last = (math.floor(math.log(end / demand.zeta_target) / step) for end in (low, high))
    count = max(1, last - first) + 2
    multipliers = demand.zeta_target * np.exp(step * (first + np.arange(count)))
    peaks = np.empty((len(motions), count))
    for record in range(len(motions)):
        outcomes, reached = runs.analyse([record], multipliers)
        peaks[record] = np.where(outcomes == STABLE, reached, math.inf)[0].max(axis=0)
    return RecordPeaks(multipliers, peaks, runs.limit, runs.mean)


def zetas_of_resampled_sets(per_record: RecordPeaks, counts: np.ndarray) -> np.ndarray:
    """zeta_E of sets of the records, shape (sets,); infinite where the rule fails at too few of the multipliers.

    counts : how often each record is in each set, shape (sets, records)
    """
    here = np.minimum(per_record.peaks, 1e9)  # no 0 times infinity
    taken = counts > 0
    worst = np.max(np.where(taken[:, :, None], here[None], 0.0), axis=1)
    value = counts @ here / counts.sum(axis=1)[:, None] if per_record.mean else worst
    fails = (worst > 1.0) | (value > per_record.limit)
    step = math.log(per_record.multipliers[1] / per_record.multipliers[0])
    half = round(FAILURE_WINDOW / step)
    # below the first multiplier the rule holds, the last stands for those beyond it
    padded = np.concatenate([np.zeros((len(fails), half + 1), bool), fails, np.repeat(fails[:, -1:], half, 1)], axis=1)
    total = np.cumsum(padded, axis=1)
    reached = total[:, 2 * half + 1 :] - total[:, : -2 * half - 1] >= HALF_FAIL * (2 * half + 1)
    zeta = per_record.multipliers[reached.argmax(axis=1)] * math.exp(-0.5 * step)
    return np.where(reached.any(axis=1), zeta, math.inf)


def sample_interval(per_record: RecordPeaks, motions: list[GroundMotion], zeta: float) -> SampleInterval | None:
    """The interval of zeta_E; None below MIN_STATIONS stations.

    motions : those of `record_peaks`, in their order
    zeta : zeta_E on its own, finer grid, in proportion to which the interval is given
    """
    names = [station_of(motion, k) for k, motion in enumerate(motions)]
    if len(set(names)) < MIN_STATIONS:
        return None
    zetas = zetas_of_resampled_sets(
        per_record, np.vstack([np.ones(len(names), np.int64), bootstrap_counts(names, SET_DRAWS)])
    )
    low, high = np.quantile(zetas[1:], (0.5 - INTERVAL_SHARE / 2, 0.5 + INTERVAL_SHARE / 2), method="inverted_cdf")
    top, whole = float(per_record.multipliers[-1]), float(zetas[0])
    share = zeta / whole if math.isfinite(whole) else 1.0
    low, high, open_end = share * min(float(low), top), share * min(float(high), top), not math.isfinite(high)
    return SampleInterval(low, high, len(set(names)), open_end)


def leave_one_out_zetas(per_record: RecordPeaks) -> np.ndarray:
    """zeta_E without each of the records in turn, shape (records,)."""
    n = len(per_record.peaks)
    return zetas_of_resampled_sets(per_record, 1 - np.eye(n, dtype=np.int64))
