"""One rocking history in full, and the outcomes of many multipliers of a record."""

import math
from dataclasses import dataclass, field

import numpy as np

from core.rocking import held_lanes, held_top, held_top_with_bars, lane_scheduler, taylor, taylor_with_bars
from core.rocking.analysis_count import MADE
from core.rocking.compared.comparison import integrate_comparison, scan_comparison
from core.rocking.grounds import Grounds
from core.rocking.methods import METHODS, NO_TABLE, TAYLOR, Method, resolve_auto
from core.rocking.outcome import BAD_INPUT, MAX_GROUND
from core.wall.rocking_model import RockingModel


def scan_multipliers(method: Method, ground, dt, scales, model, outcomes, peaks) -> np.ndarray:
    """Analyses of one record at many multipliers; returns the clamped velocity ratios of each, shape (m,).

    method : how the motion is integrated
    ground : [m/s2], shape (n,)
    dt : [s]
    scales : multipliers [-], shape (m,), negative reverses the record
    model : RockingModel
    outcomes : results, codes of outcome.py, int64, shape (m,)
    peaks : results [rad], shape (m,)
    """
    which = np.zeros(scales.size, np.int64)
    return scan_records(method, Grounds.of([ground], dt), which, scales, model, outcomes, peaks)


def uses_lanes(method: Method, model: RockingModel) -> bool:
    """Whether `scan_records` takes analyses side by side; others go one after another, and many at once only make a
    cancel wait."""
    return method.code == TAYLOR or requires_order_8(model) or model.bending is not None


def requires_order_8(model: RockingModel) -> bool:
    """Whether analyses of a wall are by the series of order 8 whatever the method."""
    return model.other is not None or model.driven is not None or bool(model.bars)


def scan_records(method: Method, grounds: Grounds, which, scales, model, outcomes, peaks) -> np.ndarray:
    """`scan` of several records of one time step. A wall with bars, a two-sided body that is not symmetric and a
    branch in closed form are always taken by the Taylor series of order 8, a wall held at its top by its own series.

    Analyses of a ground that is no number or beyond MAX_GROUND end at once with BAD_INPUT.

    method : how the motion is integrated
    grounds : the records
    which : record of each multiplier, int64, shape (m,)
    scales : multipliers [-], shape (m,), negative reverses the record
    model : RockingModel
    outcomes : results, codes of outcome.py, int64, shape (m,)
    peaks : results [rad], shape (m,)
    """
    sound = np.abs(scales) * grounds.strongest[which] <= MAX_GROUND
    if not sound.all():
        outcomes[:], peaks[:] = BAD_INPUT, 0.0
        clamped = np.zeros(scales.size, np.int64)
        if sound.any():
            codes, reached = np.zeros(int(sound.sum()), np.int64), np.zeros(int(sound.sum()))
            clamped[sound] = scan_records(method, grounds, which[sound], scales[sound], model, codes, reached)
            outcomes[sound], peaks[sound] = codes, reached
        return clamped
    MADE.add(scales.size)
    if model.bending is not None and model.bending.outward.bars:
        return held_top_with_bars.scan(grounds, which, scales, model, outcomes, peaks)
    if model.bending is not None:
        return held_lanes.scan(grounds, which, scales, model, outcomes, peaks)
    if requires_order_8(model):
        return lane_scheduler.scan(8, grounds, which, scales, model, outcomes, peaks)
    method = resolve_auto(method, model, grounds.dt)
    if method.code == TAYLOR:
        return lane_scheduler.scan(method.order, grounds, which, scales, model, outcomes, peaks)
    clamped = np.zeros(scales.size, np.int64)
    for k in np.unique(which):
        first, last, here = grounds.first[k], grounds.last[k], np.nonzero(which == k)[0]
        codes, reached, clamps = outcomes[here], peaks[here], clamped[here]
        scan_comparison(
            method.code,
            method.option,
            grounds.ground[first : last + 1],
            grounds.dt,
            scales[here],
            model,
            codes,
            reached,
            clamps,
            NO_TABLE,
            method.table,
        )
        outcomes[here], peaks[here], clamped[here] = codes, reached, clamps
    return clamped


@dataclass(frozen=True)
class History:
    """One analysis in full.

    rotation, velocity : at the samples up to the stop [rad], [rad/s]
    impact_time, impact_velocity : [s], and just after each impact [rad/s]
    outcome : a code of outcome.py
    peak : largest |rotation|, the free motion after the record included [rad]
    clamped : count of impacts whose Eq. 7 was held at 0
    residual : of each bar of the wall, its residual elongation over its height at the samples, inf where it has gone;
        shape (bars, samples)
    of_bars : of each bar of a wall held at its top, its residual elongation [m], of that shape
    """

    rotation: np.ndarray
    velocity: np.ndarray
    impact_time: np.ndarray
    impact_velocity: np.ndarray
    outcome: int
    peak: float
    clamped: int
    residual: np.ndarray
    of_bars: np.ndarray = field(default_factory=lambda: np.zeros((0, 0)))


def integrate_history(
    ground: np.ndarray,
    dt: float,
    scale: float,
    model: RockingModel,
    method: Method = METHODS["taylor"],
    start: tuple[float, float] = (0.0, 0.0),
) -> History:
    """Rocking history of one wall under one scaled record (Eq. 1); units as `taylor.integrate`.

    A ground or a start that is no number, or a ground beyond MAX_GROUND, ends at once with BAD_INPUT.
    """
    largest = abs(scale) * float(np.abs(ground).max(initial=0.0))
    if not (largest <= MAX_GROUND and math.isfinite(start[0]) and math.isfinite(start[1])):
        none = np.zeros(0)
        return History(none, none, none, none, BAD_INPUT, 0.0, 0, none.reshape(0, 0))
    MADE.add(1)
    method, of_order_8 = resolve_auto(method, model, dt), requires_order_8(model)
    yielded = () if model.bending is None else model.bending.outward.bars
    trace = np.zeros((2 + len(model.bars) + len(yielded), ground.size))
    rotation, velocity = trace[:2]
    times = np.zeros(4096)
    while True:
        velocities = np.zeros(times.size)
        wanted = (start, rotation, velocity, times, velocities)
        if model.bending is not None:
            follow = held_top_with_bars.history if yielded else held_top.history
            outcome, peak, impacts, clamped, done = follow(ground, dt, scale, model, start, trace, times, velocities)
        elif model.bars:
            outcome, peak, impacts, clamped, done = taylor_with_bars.integrate(
                ground, dt, scale, model, start, trace, times, velocities
            )
        elif method.code == TAYLOR or of_order_8:
            integrate = taylor.INTEGRATE[8 if of_order_8 else method.order]
            outcome, peak, impacts, clamped, done = integrate(ground, dt, scale, model, *wanted)
        else:
            outcome, peak, impacts, clamped, done = integrate_comparison(
                method.code, ground, dt, scale, model, method.option, *wanted, method.table
            )
        if impacts <= times.size:
            break
        times = np.zeros(impacts)
    return History(
        rotation[:done],
        velocity[:done],
        times[:impacts],
        velocities[:impacts],
        outcome,
        peak,
        clamped,
        trace[2 : 2 + len(model.bars), :done],
        trace[2 + len(model.bars) :, :done],
    )
