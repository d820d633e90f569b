"""Dynamic check of the Circolare 7/2019, C8.7.1.2.1.9: every record at the demand.

The rule: d_0 is exceeded in no run, and the mean of the largest rotations stays below 0.40 (SLV) or 0.60 (SLC)
of it. With fewer than seven stations the largest rotation takes the place of the mean (EN 1998-1
4.3.3.4.3(3)); the components of one station count once, and a record far weaker than its set does not count.

The confidence factor FC acts on the strength of the capacity curve, as clause .3 has it ("si applica
direttamente alla capacità in termini di resistenza"): strength over FC is, exactly, p^2 / FC under the ground
times FC. Or, more cautiously, on the demand: the wall as it is under the ground times FC.

Whether the rule holds is not monotone in the multiplier of the demand: zeta_E and zeta_16 are those of
multiplier_search.py.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from core.capacity.ida import CHUNK, TRILINEAR_FLOOR, multiplier_of, threshold_of
from core.capacity.limit_states import LIMIT_FRACTION
from core.codes.demand import SeismicDemand
from core.codes.kinematic import ZETA_ROUNDING, Check
from core.codes.limits import counted_mask, counted_stations, set_rule
from core.codes.multiplier_search import ROCKING_PEAK_RATIO, RUN, Precision, ZetaSearchResult, search_zeta
from core.errors import Cancelled
from core.ground.ground_motion import GroundMotion
from core.known import require_value
from core.rocking.grounds import Grounds
from core.rocking.history import scan_records
from core.rocking.methods import Method
from core.rocking.outcome import COLLAPSED, IMPACT_LIMIT, STABLE
from core.wall.rocking_model import RockingModel, weakened

BESIDE_A_FAILURE = 4
"""Points of the grid from one to the next with FC on the other side of a wall that fails, whose outcome does not hang
on it."""

FIRST = 1, 1, 2, 4
"""How many records, the worst at the demand first, are analysed before the others: most failures need no other."""

MIN_BATCHED = 16
"""Multipliers below which all records are analysed at once: a lane more costs less than another pass."""

REST_ROUNDING = 1e-9
"""What is left below a_RM for rounding: a run nearer to it is integrated [-]."""

CLAUSE = "C8.7.1.2.1.9"

STATUS = {STABLE: "stable", COLLAPSED: "overturned", IMPACT_LIMIT: "impact_limit"}


@dataclass(frozen=True)
class DemandRun:
    """One record and sign at the demand.

    record : its name for people; motion : its index in the study
    factor : multiplier of the record, scaling and an FC on the demand included
    peak_ratio : largest rotation over theta_c, None unless stable
    exceeded : theta_c was exceeded
    """

    record: str
    motion: int
    polarity: int
    factor: float
    peak_ratio: float | None
    exceeded: bool
    status: str


@dataclass(frozen=True)
class AlternativeConfidence:
    """The check with FC on the other side.

    confidence_on : capacity or demand
    zeta : zeta_E, None where a run has no number
    passed, spread : as passed and zeta_spread of DemandCheck
    """

    confidence_on: str
    zeta: float | None
    passed: bool
    spread: tuple[float, float] | None = None


@dataclass(frozen=True)
class DynamicCheck:
    """Result of the dynamic check: the rule at the demand, and zeta_E.

    mean_peak_ratio : over the records, of each its worse sign; None where a run overturns
    set_rule : mean, or maximum below seven stations
    confidence_on : where FC acts, capacity or demand
    zeta : zeta_E, lowest multiplier of the demand around which half of the multipliers fail the rule, no more than is
        required where the rule fails there or is at its limit; None where a run below it has no number
    zeta_spread : multipliers around which 45 % and 55 % fail: zeta_E on another grid lies between them
    zeta_16, zeta_first : the same as zeta of 16 %, and the first failure on the grid
    share_failing_at_demand : share of failing multipliers within +-10 % of zeta_target
    holds, holds_at_target : the rule at the demand itself, and at zeta_target of it
    fails_at_target : it fails there by runs that have a number
    passed : it holds at zeta_target, and zeta reaches zeta_target
    zeta_other : the check with FC on the other side; None where FC is 1
    not_counted : records too weak beside the others to count for the rule of the set
    beyond : zeta is at least this: more was not asked for
    limited : zeta is what is required, for the rule fails there, or is at its limit, and holds again above
    """

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
    holds_at_target: bool = True
    fails_at_target: bool = False
    confidence_on: str = "capacity"
    zeta_spread: tuple[float, float] | None = None
    zeta_16: float | None = None
    zeta_first: float | None = None
    share_failing_at_demand: float = 0.0
    zeta_other: AlternativeConfidence | None = None
    not_counted: tuple[str, ...] = ()
    branch: Any = None
    beyond: bool = False
    limited: bool = False

    @property
    def peak_ratio(self) -> float | None:
        """Value that the rule compares with the limit: mean or maximum of the peaks over theta_c [-]."""
        return self.mean_peak_ratio if self.set_rule == "mean" else self.max_peak_ratio

    def as_check(self, target: float) -> Check:
        """This check as a row of the table of methods; at the limit it counts as failed. target : the zeta required"""
        passed = None if self.zeta is None and not self.fails_at_target else self.satisfied(target)
        return Check("dynamic", CLAUSE, "-", self.limit_ratio, self.peak_ratio, self.zeta, passed)

    def satisfied(self, target: float) -> bool:
        """Whether the rule surely holds at the target, its spread included."""
        return self.passed and not self.within_spread(target)

    def within_spread(self, target: float) -> bool:
        """Whether the rule holds at the target, but the spread of zeta_E contains it, its lower end included."""
        if self.zeta_spread is None or not self.holds_at_target:
            return False
        return self.zeta_spread[0] <= target < self.zeta_spread[1]


def model_and_scale_at_demand(
    model: RockingModel, demand: SeismicDemand, confidence_on: str, motion: GroundMotion
) -> tuple[RockingModel, float]:
    """Model and multiplier of the record for the check at the demand, with FC on the capacity (p^2 / FC) or on the
    demand."""
    confidence = demand.confidence_factor
    if confidence_on == "capacity":  # strength over FC is p^2 / FC under the ground times FC
        model = weakened(model, confidence)
    return model, confidence * demand.scaling(motion)


def group_by_time_step(motions: list[GroundMotion]) -> list[tuple[Grounds, int]]:
    """Grounds of the time step of each record and its place in them, as `DemandRuns` takes them: no batch copies a
    record."""
    steps: dict[float, list[np.ndarray]] = {}
    places = []
    for motion in motions:
        places.append(len(steps.setdefault(motion.time_step, [])))
        steps[motion.time_step].append(motion.acceleration)
    grounds = {dt: Grounds.of(records, dt) for dt, records in steps.items()}
    return [(grounds[motion.time_step], place) for motion, place in zip(motions, places, strict=True)]


class DemandRuns:
    """Runs all records of a wall at one multiplier of the demand after another."""

    def __init__(self, model, motions, polarities, demand, confidence_on, method, cancelled, grounds=None):
        """model : RockingModel of the wall
        motions : the records
        polarities : signs each is taken with, 1 as recorded, -1 reversed
        demand : DemandResult
        confidence_on : where FC acts, capacity or demand
        method : how the motion is integrated
        cancelled : asked between two chunks of analyses
        grounds : of `group_by_time_step`, made here where they are not given
        """
        at = [model_and_scale_at_demand(model, demand, confidence_on, motion) for motion in motions]
        self.model, self.method, self.cancelled = at[0][0], method, cancelled
        self.motions, self.polarities = motions, polarities
        self.grounds = grounds or group_by_time_step(motions)
        self.ground_factors = [factor for _, factor in at]
        # what of it is of the demand
        on_demand = demand.confidence_factor if confidence_on == "demand" else 1.0
        self.factors = [on_demand * demand.scaling(motion) for motion in motions]
        self.limit = LIMIT_FRACTION[demand.limit_state]
        self.mean = set_rule(counted_stations(motions, demand)) == "mean"
        self.in_order(range(len(motions)))

    def in_order(self, order) -> None:
        """Which records `failures` takes first: the worst few, then all others, those of a time step at once."""
        order, self.batches, start = list(order), [], 0
        for size in (*FIRST, len(order)):
            group, start = order[start : start + size], start + size
            steps = dict.fromkeys(self.motions[k].time_step for k in group)
            self.batches += [[k for k in group if self.motions[k].time_step == dt] for dt in steps]
        steps = dict.fromkeys(self.motions[k].time_step for k in order)
        self.together = [[k for k in order if self.motions[k].time_step == dt] for dt in steps]

    def analyse(self, batch: list[int], multipliers: np.ndarray):
        """Integrate a batch at these multipliers, but for runs whose ground does not move the wall; returns outcomes
        and peaks over theta_c, shape (records, signs, multipliers). batch : records of one time step"""
        grounds = self.grounds[batch[0]][0]
        signed = np.outer([self.ground_factors[k] for k in batch], np.array(self.polarities, float))
        every = np.multiply.outer(signed, multipliers)
        moves = multipliers > self.at_rest[batch, :, None]
        scales, which = every[moves], np.array([self.grounds[k][1] for k in batch])[np.nonzero(moves)[0]]
        codes, reached = np.empty(scales.size, np.int64), np.empty(scales.size)
        for start in range(0, scales.size, CHUNK):
            if self.cancelled():
                raise Cancelled
            part = slice(start, start + CHUNK)
            scan_records(self.method, grounds, which[part], scales[part], self.model, codes[part], reached[part])
        outcomes, peaks = np.full(every.shape, STABLE, np.int64), np.zeros(every.shape)
        outcomes[moves], peaks[moves] = codes, reached / self.model.collapse_rotation
        return outcomes, peaks

    def runs(self) -> tuple[DemandRun, ...]:
        """Every record and sign at the demand itself."""
        runs = {}
        for batch in self.together:
            outcomes, peaks = self.analyse(batch, np.ones(1))
            for k, record in enumerate(batch):
                runs[record] = [
                    DemandRun(
                        self.motions[record].name,
                        record,
                        sign,
                        self.factors[record],
                        float(peaks[k, n, 0]) if outcomes[k, n, 0] == STABLE else None,
                        bool(outcomes[k, n, 0] == COLLAPSED or peaks[k, n, 0] > 1.0),
                        STATUS[int(outcomes[k, n, 0])],
                    )
                    for n, sign in enumerate(self.polarities)
                ]
        return tuple(run for record in sorted(runs) for run in runs[record])

    def failures(self, multipliers: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Flags of the multipliers at which the rule fails, at which that is for want of a number, and at which it
        fails or the peak of a run is ROCKS of theta_c or more. A multiplier at which one record makes it fail needs no
        other."""
        fails, unknown, rocks = np.zeros((3, multipliers.size), bool)
        total = np.zeros(multipliers.size)
        for batch in self.batches if multipliers.size >= MIN_BATCHED else self.together:
            here = np.nonzero(~fails | unknown)[0]
            if here.size == 0:
                break
            outcomes, peaks = self.analyse(batch, multipliers[here])
            worse = peaks.max(axis=1)
            total[here] += worse.sum(axis=0)
            value = total[here] / len(self.motions) if self.mean else worse.max(axis=0)
            limited = (outcomes == IMPACT_LIMIT).any(axis=(0, 1))
            failed = ((outcomes == COLLAPSED) | (peaks > 1.0)).any(axis=(0, 1))
            failed |= value > self.limit
            unknown[here] = (unknown[here] | limited) & ~failed
            fails[here] |= failed | limited
            rocks[here] |= fails[here] | (peaks >= ROCKING_PEAK_RATIO).any(axis=(0, 1))
        return fails, unknown, rocks

    def rule_holds(self, worse: np.ndarray) -> bool:
        """Whether the rule holds for these peaks over theta_c, of each record its worse sign; it fails where a run
        overturns."""
        value = worse.mean() if self.mean else worse.max()
        return bool(worse.max() <= 1.0 and value <= self.limit)

    @property
    def rest(self) -> float:
        """Multiplier up to which the wall does not move, or, trilinear, from which the search starts."""
        most = max(factor * motion.pga for motion, factor in zip(self.motions, self.ground_factors, strict=True))
        least = multiplier_of(1.0, most, threshold_of(self.model))
        return least * (1.0 if self.model.plateau_end == 0.0 else TRILINEAR_FLOOR)

    @cached_property
    def at_rest(self) -> np.ndarray:
        """Multiplier of each record and sign up to which it does not move the wall, shape (records, signs): of a wall
        that turns one way by what pushes it that way. A trilinear one always moves."""
        if self.model.plateau_end != 0.0:
            return np.zeros((len(self.motions), len(self.polarities)))
        pushes = [
            [
                factor * (motion.pga if self.model.one_sided == 0.0 else (sign * motion.acceleration).max())
                for sign in self.polarities
            ]
            for motion, factor in zip(self.motions, self.ground_factors, strict=True)
        ]
        with np.errstate(divide="ignore"):
            return (1.0 - REST_ROUNDING) * threshold_of(self.model) / np.maximum(pushes, 0.0)


def run_dynamic_check(
    model: RockingModel,
    motions: list[GroundMotion],
    polarities: tuple[int, ...],
    demand: SeismicDemand,
    method: Method,
    precision: Precision = RUN,
    other: bool = True,
    cancelled: Callable[[], bool] = lambda: False,
) -> DynamicCheck | None:
    """The dynamic check of one wall; None without records or for a limit state the clause has no limit for.

    model : of the wall
    motions : the records
    polarities : signs each is taken with, 1 as recorded, -1 reversed
    demand : what is required
    method : how the motion is integrated
    precision : of zeta
    other : search zeta with FC on the other side too
    cancelled : asked between two chunks of analyses
    Raises Cancelled.
    """
    if not motions or demand.limit_state not in LIMIT_FRACTION:
        return None
    side, target = demand.confidence_on, demand.zeta_target
    grounds = group_by_time_step(motions)
    sides = {
        name: DemandRuns(model, motions, polarities, demand, name, method, cancelled, grounds)
        for name in ("demand", "capacity")
    }
    work = sides[side]
    runs = work.runs()
    peaks = [run.peak_ratio for run in runs]
    worse = None
    if None not in peaks:
        worse = np.array(peaks).reshape(len(motions), -1).max(axis=1)
    worst = [0.0] * len(motions)
    for run in runs:
        worst[run.motion] = max(worst[run.motion], run.peak_ratio or 2.0)

    def judged(there: DemandRuns, precision: Precision) -> tuple[ZetaSearchResult, bool]:
        there.in_order(np.argsort(-np.array(worst), kind="stable").tolist())
        zeta = search_zeta(there.failures, there.rest, target, precision)
        reaches = zeta.half is not None and zeta.half >= target - ZETA_ROUNDING
        return limit_to_required(zeta, target), zeta.holds_at_target and reaches

    zeta_found, passed = judged(work, precision)
    second = None
    if other and demand.confidence_factor > 1.0:
        beside = precision if passed else precision._replace(every=max(precision.every, BESIDE_A_FAILURE))
        (name,) = set(sides) - {side}
        zeta, fine = judged(sides[name], beside)
        second = AlternativeConfidence(name, zeta.half, fine, zeta.spread)
    return DynamicCheck(
        limit_state=demand.limit_state,
        runs=runs,
        n_exceeded=sum(run.exceeded for run in runs),
        mean_peak_ratio=None if worse is None else float(worse.mean()),
        max_peak_ratio=None if worse is None else float(worse.max()),
        set_rule="mean" if work.mean else "maximum",
        limit_ratio=work.limit,
        zeta=zeta_found.half,
        holds=worse is not None and work.rule_holds(worse),
        passed=passed,
        holds_at_target=zeta_found.holds_at_target,
        fails_at_target=zeta_found.fails_at_target,
        confidence_on=side,
        zeta_spread=zeta_found.spread,
        zeta_16=zeta_found.sixteen,
        zeta_first=zeta_found.first,
        share_failing_at_demand=zeta_found.share_at_target,
        zeta_other=second,
        beyond=zeta_found.beyond,
        limited=zeta_found.limited,
        not_counted=tuple(
            motion.name for motion, counts in zip(motions, counted_mask(motions, demand), strict=True) if not counts
        ),
    )


def limit_to_required(found: ZetaSearchResult, target: float) -> ZetaSearchResult:
    """What was found of a wall, of one that fails at what is required or is at its limit there no zeta above that: what
    it withstands above is no capacity."""
    if found.half is None or found.spread is None or found.half <= target:
        return found
    if not found.holds_at_target:
        low, high, sixteen = (min(value, target) for value in (*found.spread, require_value(found.sixteen)))
        return replace(found, half=target, sixteen=sixteen, spread=(low, high), limited=True)
    return replace(found, half=target, limited=True) if found.spread[0] <= target else found


AROUND = 1.0, 1.03
"""Multiples of what is required at which a wall is looked at where its zeta is not asked for."""


def check_around_demand(
    model: RockingModel,
    motions: list[GroundMotion],
    polarities: tuple[int, ...],
    demand: SeismicDemand,
    method: Method,
    precision: Precision = RUN,
    other: bool = True,
    cancelled: Callable[[], bool] = lambda: False,
) -> DynamicCheck | None:
    """Whether the dynamic check may pass, by a few analyses around what is required: zeta is not searched, and stands
    for what is required where the rule holds, 0 where not.

    model : of the wall
    motions : the records
    polarities : signs each is taken with
    demand : what is required
    method : how the motion is integrated
    precision, other : not asked for
    cancelled : asked between two chunks of analyses
    Raises Cancelled.
    """
    if not motions or demand.limit_state not in LIMIT_FRACTION:
        return None
    work = DemandRuns(model, motions, polarities, demand, demand.confidence_on, method, cancelled)
    fails, _, _ = work.failures(demand.zeta_target * np.array(AROUND))
    holds, rule = not fails.any(), "mean" if work.mean else "maximum"
    zeta = demand.zeta_target if holds else 0.0
    return DynamicCheck(demand.limit_state, (), 0, None, None, rule, work.limit, zeta, holds, holds)
