"""Dynamic check of the Circolare 7/2019, C8.7.1.2.1.9: every record at the demand.

d_0 is exceeded in no run, and the mean of the largest rotations stays below 0.40 (SLV) or 0.60 (SLC) of
it. The demand is amplified by the confidence factor; with fewer than seven records the largest rotation
takes the place of the mean (EN 1998-1 4.3.3.4.3(3)); the components of one station count once.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from core.compliance import station_of
from core.demand import DemandResult
from core.errors import Cancelled
from core.ground_motion import GroundMotion
from core.ida import BRACKET, CHUNK, TRILINEAR_FLOOR, bisections, threshold_of
from core.kinematic import LIMIT_FRACTION, Check
from core.rocking import COLLAPSED, IMPACT_LIMIT, Grounds, Method, RockingModel, scan_records

MEAN_FROM = 7
SPREAD = 0.02
"""What zeta, a first failure on a grid, moves by when the grid starts elsewhere or the record is rounded
(measured on the wall of the bundled case: 1 to 3 %)."""

AT_ONCE = 32
"""Multipliers of a look for zeta, which often ends within the first."""

MOST = 100.0
"""Multiplier of the demand up to which zeta is searched."""

STATUS = {0: "stable", COLLAPSED: "overturned", IMPACT_LIMIT: "impact_limit"}


@dataclass(frozen=True)
class DemandRun:
    """One record and sign at the demand. factor : multiplier of the record, FC and scaling included;
    peak_ratio : largest rotation over alpha, None unless stable; exceeded : alpha was exceeded."""

    record: str
    polarity: int
    factor: float
    peak_ratio: float | None
    exceeded: bool
    status: str


@dataclass(frozen=True)
class DemandCheck:
    """The rule at the demand. mean_peak_ratio : over the records, of each its worse sign; None where a
    run overturns; set_rule : mean, or maximum below seven records; zeta : multiplier of the demand at
    which the rule first fails, None where a run has no number; holds : the rule at the demand itself."""

    limit_state: str
    runs: tuple[DemandRun, ...]
    n_exceeded: int
    mean_peak_ratio: float | None
    max_peak_ratio: float | None
    set_rule: str
    limit_ratio: float
    zeta: float | None
    holds: bool
    passed: bool

    @property
    def peak_ratio(self) -> float | None:
        """What the rule compares with the limit: mean or maximum of the peaks."""
        return self.mean_peak_ratio if self.set_rule == "mean" else self.max_peak_ratio

    def as_check(self) -> Check:
        """This check as a row of the table of methods."""
        passed = self.passed if self.zeta is not None else None
        return Check(
            "dynamic", "C8.7.1.2.1.9", "-", self.limit_ratio, self.peak_ratio, self.zeta, passed
        )


class _Set:
    """All runs of a wall at one multiplier of the demand after another."""

    def __init__(self, model, motions, polarities, demand, method, cancelled):
        self.model, self.method, self.cancelled = model, method, cancelled
        self.pairs = [(motion, sign) for motion in motions for sign in polarities]
        self.signs = len(polarities)
        # records of one time step run together
        self.groups = []
        for dt in sorted({motion.time_step for motion in motions}):
            records = [k for k, motion in enumerate(motions) if motion.time_step == dt]
            grounds = Grounds.of([motions[k].acceleration for k in records], dt)
            rows = [k * self.signs + j for k in records for j in range(self.signs)]
            self.groups.append((grounds, np.array(rows), np.arange(len(rows)) // self.signs))
        self.factors = [
            demand.confidence_factor * demand.scaling(motion) for motion, _ in self.pairs
        ]
        self.limit = LIMIT_FRACTION[demand.limit_state]
        stations = {station_of(motion) or f"file {k}" for k, motion in enumerate(motions)}
        self.mean = len(stations) >= MEAN_FROM

    def analyse(self, multipliers: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Outcomes and peaks over alpha, shape (runs, multipliers)."""
        shape = (len(self.pairs), multipliers.size)
        outcomes, peaks = np.empty(shape, np.int64), np.empty(shape)
        signed = np.array([sign * f for (_, sign), f in zip(self.pairs, self.factors, strict=True)])
        for grounds, rows, record in self.groups:
            scales = np.outer(signed[rows], multipliers).ravel()
            which = np.repeat(record, multipliers.size)
            found, reached = np.empty(scales.size, np.int64), np.empty(scales.size)
            for start in range(0, scales.size, CHUNK):
                if self.cancelled():
                    raise Cancelled
                part = slice(start, start + CHUNK)
                scan_records(self.method, grounds, which[part], scales[part], self.model,
                             found[part], reached[part])  # fmt: skip
            outcomes[rows], peaks[rows] = (
                found.reshape(len(rows), -1),
                reached.reshape(len(rows), -1),
            )
        return outcomes, peaks / self.model.slenderness

    def governing(self, peaks: np.ndarray) -> np.ndarray:
        """Worse sign of each record, shape (records, multipliers)."""
        return peaks.reshape(-1, self.signs, peaks.shape[1]).max(axis=1)

    def holds(self, outcomes: np.ndarray, peaks: np.ndarray) -> np.ndarray:
        """Whether the rule holds at each multiplier."""
        worse = self.governing(peaks)
        value = worse.mean(axis=0) if self.mean else worse.max(axis=0)
        exceeded = ((outcomes != 0) | (peaks > 1.0)).any(axis=0)
        return ~exceeded & (value <= self.limit)

    def zeta(self, step: float, reached: list[float] | None) -> float | None:
        """First failure of the rule on a geometric grid, bisected; None for an outcome without a number.

        reached : q of each run up to which its search found no peak at the limit: below the lowest of
        them none is there, and the rule holds.
        """
        per_q = np.array(
            [
                threshold_of(self.model) / (factor * motion.pga)
                for (motion, _), factor in zip(self.pairs, self.factors, strict=True)
            ]
        )
        if reached is not None:
            low = float((np.array(reached) * per_q).min()) * (1.0 - 2.0 * BRACKET)
        else:
            low = per_q.min() * (1.0 if self.model.plateau_end == 0.0 else TRILINEAR_FLOOR)
        while low < MOST:
            grid = low * (1.0 + step) ** np.arange(1, AT_ONCE + 1)
            outcomes, peaks = self.analyse(grid)
            fails = ~self.holds(outcomes, peaks)
            if fails.any():
                k = int(np.argmax(fails))
                if (outcomes[:, k] == IMPACT_LIMIT).any():
                    return None
                edges = (float(grid[k - 1]) if k else low, float(grid[k]))
                (bracket,) = bisections([edges], lambda points: [self.failures(points[0])])
                return min(bracket[0], MOST) if bracket else None
            low = float(grid[-1])
        return MOST

    def failures(self, multipliers: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Where the rule fails, and where a run has no number."""
        outcomes, peaks = self.analyse(multipliers)
        return ~self.holds(outcomes, peaks), (outcomes == IMPACT_LIMIT).any(axis=0)


def demand_check(
    model: RockingModel,
    motions: list[GroundMotion],
    polarities: tuple[int, ...],
    demand: DemandResult,
    method: Method,
    step: float,
    reached: list[float] | None = None,
    cancelled: Callable[[], bool] = lambda: False,
) -> DemandCheck | None:
    """The dynamic check of one wall; None without records or for a limit state the clause has no limit for.

    step : of the search for zeta [-]; reached : as `_Set.zeta`, by record and sign. Raises Cancelled.
    """
    if not motions or demand.limit_state not in LIMIT_FRACTION:
        return None
    work = _Set(model, motions, polarities, demand, method, cancelled)
    outcomes, peaks = work.analyse(np.ones(1))
    runs = tuple(
        DemandRun(
            motion.name, sign, factor,
            float(peaks[k, 0]) if outcomes[k, 0] == 0 else None,
            bool(outcomes[k, 0] == COLLAPSED or peaks[k, 0] > 1.0),
            STATUS[int(outcomes[k, 0])],
        )
        for k, ((motion, sign), factor) in enumerate(zip(work.pairs, work.factors, strict=True))
    )  # fmt: skip
    known = all(run.peak_ratio is not None for run in runs)
    worse = work.governing(peaks)[:, 0]
    zeta = work.zeta(step, reached)
    holds = bool(work.holds(outcomes, peaks)[0])
    target = demand.zeta_target
    at_target = holds if target == 1.0 else bool(work.holds(*work.analyse(np.array([target])))[0])
    if zeta is not None:
        # the grid of the search may step over a failure that the demand or the target itself shows
        failures = [1.0] * (not holds) + [target] * (not at_target)
        zeta = min([zeta, *failures])
    return DemandCheck(
        limit_state=demand.limit_state,
        runs=runs,
        n_exceeded=sum(run.exceeded for run in runs),
        mean_peak_ratio=float(worse.mean()) if known else None,
        max_peak_ratio=float(worse.max()) if known else None,
        set_rule="mean" if work.mean else "maximum",
        limit_ratio=work.limit,
        zeta=zeta,
        holds=holds,
        passed=at_target and zeta is not None and zeta >= target - 1e-12,
    )


def numerical_spread(zeta: float, target: float, searched: bool) -> bool:
    """Whether zeta is within what rounding leaves open of the target; searched : and the grid, where
    time histories stand behind it."""
    return math.isclose(zeta, target, rel_tol=SPREAD if searched else 10.0 * BRACKET)
