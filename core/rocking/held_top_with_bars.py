"""Histories of a wall held at its top with ties along it that have yielded (resources/docs/physics.md, section 19).

As held_top.py, with what the bars add to the work of the weights on each of their branches, and with more events: a bar
becomes taut, yields, turns back, is slack, breaks (bar_state.py). Bars pull at a wall that moves outward alone; their
elongations are in metres here.
"""

import math

import numpy as np

from core.jit.decorators import kernel, subkernel
from core.jit.fma import fma
from core.rocking.bar_state import PHASE, RESIDUAL, TAUT, YIELDING, cross_kinks
from core.rocking.events import IMPACTS_PER_SAMPLE, apply_impact, next_uplift, uplift_thresholds
from core.rocking.grounds import Grounds
from core.rocking.held_bars import (
    FORCE,
    SPRING,
    begin_bars,
    ends_of_branch,
    residual_length,
    split_with_bars,
    turn_back,
)
from core.rocking.outcome import COLLAPSED, IMPACT_LIMIT, STABLE
from core.rocking.side_functions import DEGREE, OVERLAP, PIECES, V, X, rotation_at, to_rotations, to_y, turned_by
from core.rocking.side_series import (
    SIDE_TOLERANCE,
    TINIEST,
    has_converged,
    landing,
    moved,
    push_of,
    root,
    shift_polynomial,
    speed_of,
    terms_of,
)
from core.rocking.taylor_with_bars import STILL_TIME
from core.units import G
from core.wall.bars import STIFFNESS, YIELD
from core.wall.rocking_model import RockingModel

LANDINGS_AFTER = 3
"""Landings after a record from which on no swing is larger than one before: each takes energy, and so does a bar."""


@subkernel
def series_on_branch(y, speed, sign, beta, slope, p2, side, bars, h):
    """`side_series.series` with what the bars add to v on their branch.

    y, speed, beta, slope, p2, side, h : of that
    sign : of the side, 1.0 outward
    bars : HeldBars
    """
    at = y * side.scale
    piece = min(max(int(at), 0), PIECES - 1)
    s, per = 2.0 * (at - piece) - 1.0, 2.0 * side.scale
    for n in range(DEGREE + 1):
        bars.room[n] = side.values[piece, V, n]
    if sign > 0.0:
        for j in range(bars.rows.shape[0]):
            phase, stiffness = bars.held[j, PHASE], bars.rows[j, STIFFNESS]
            if phase == TAUT:
                residual = bars.held[j, RESIDUAL]
                for n in range(DEGREE + 1):
                    force = bars.values[piece, j, FORCE, n]
                    bars.room[n] += stiffness * (bars.values[piece, j, SPRING, n] - residual * force)
            elif phase == YIELDING:
                for n in range(DEGREE + 1):
                    bars.room[n] += stiffness * bars.rows[j, YIELD] * bars.values[piece, j, FORCE, n]
    terms = terms_of(
        speed, beta, slope, p2, per, shift_polynomial(s, bars.room), shift_polynomial(s, side.values[piece, X])
    )
    if not has_converged(terms[7], h, side.top):
        h = min(h, (SIDE_TOLERANCE * side.top / max(abs(terms[7]), TINIEST)) ** 0.125)
    return terms, h, s, per


@subkernel
def step_one_way(y, speed, terms, h, s, per, least):
    """A step that ends where the wall turns: length [s], y and y' after it.

    y, speed, terms, h, s, per, least : of `side_series.step_of`
    """
    while abs(s + per * moved(terms, h)) > OVERLAP and h > least:
        h *= 0.5
    v = speed_of(terms, h)
    slows = (terms[1] > 0.0) == (speed < 0.0) and (push_of(terms, h) > 0.0) != (terms[1] > 0.0)
    if slows and speed != 0.0 and (v < 0.0) == (speed < 0.0):  # it may turn twice
        slow = root(2, y, terms, 0.0, h)
        if (speed_of(terms, slow) < 0.0) != (speed < 0.0):
            h, v = slow, speed_of(terms, slow)
    if speed < 0.0 < v or v < 0.0 < speed:
        h, v = root(1, y, terms, 0.0, h), 0.0
    return h, y + moved(terms, h), v


@subkernel
def through_sample_on_branches(
    y,
    speed,
    sign,
    moving,
    impacts,
    instant,
    ground0,
    slope,
    dt,
    model,
    thresholds,
    outward,
    inward,
    bars,
    impact_time,
    impact_velocity,
    peaks,
):
    """`held_top.through_sample` of a wall with bars.

    y, speed, sign, moving, impacts, instant, ground0, slope, dt, model, thresholds : of that
    outward, inward, impact_time, impact_velocity, peaks : of that
    bars : HeldBars
    """
    p2, t, events = model.p2, 0.0, 0
    while t < dt:
        if not moving:
            t, sign = next_uplift(ground0, slope, t, dt, thresholds)
            if t >= dt:
                break
            moving, y, speed = True, 0.0, 0.0
        side, k = (outward, 0) if sign > 0.0 else (inward, 1)
        beta, rate = sign / G * fma(slope, t, ground0), sign / G * slope
        terms, holds, s, per = series_on_branch(y, speed, sign, beta, rate, p2, side, bars, dt - t)
        h, x, v = step_one_way(y, speed, terms, holds, s, per, 1e-9 * dt)
        low, high = ends_of_branch(sign, bars)
        rises, falls = x > high, x < low and low > 0.0
        if rises or falls:
            end = high if rises else low
            h = root(0, y - end, terms, 0.0, h)
            x, v = end, speed_of(terms, h)
        elif x < 0.0 or (x == 0.0 and v < 0.0):
            h = landing(y, terms, h)
            arriving = max(-speed_of(terms, h), 0.0)
            t = t + h if h < dt - t else dt
            y, now = 0.0, fma(slope, t, ground0)
            speed, sign, moving, _, stuck = apply_impact(
                arriving, sign, now, model, thresholds, h, instant + t, impacts, impact_time, impact_velocity
            )
            t += 1e-12 * dt if stuck else 0.0
            impacts += 1
            events += 1
            if events > IMPACTS_PER_SAMPLE:
                return y, speed, sign, moving, impacts, IMPACT_LIMIT
            continue
        turns = v == 0.0 and speed > 0.0 and sign > 0.0
        t = t + h if h < dt - t else dt
        y, speed = x, v
        peaks[k] = max(peaks[k], y)
        if rises or falls:
            cross_kinks(y, falls, bars.rows, bars.held)
            events += 1
            if events > IMPACTS_PER_SAMPLE:
                return y, speed, sign, moving, impacts, IMPACT_LIMIT
        if turns:
            turn_back(y, side, bars)
        if y > side.end:
            return y, speed, sign, moving, impacts, COLLAPSED
    return y, speed, sign, moving, impacts, STABLE


@subkernel
def outcome_in_still_ground(y, speed, sign, moving, dt, model, thresholds, outward, inward, bars, none, peaks):
    """What the wall does once its record has ended: it is followed through LANDINGS_AFTER. One that leans on its bars
    beyond collapse, and stays there, has collapsed.

    y, speed, sign, moving, dt, model, thresholds, outward, inward, bars, peaks : of `through_sample_on_branches`
    none : in place of the impacts, shape (0,)
    """
    landed = 0
    for _ in range(int(STILL_TIME / (math.sqrt(model.p2) * dt)) + 1):
        if not moving or landed >= LANDINGS_AFTER:
            return STABLE
        y, speed, sign, moving, landed, outcome = through_sample_on_branches(
            y,
            speed,
            sign,
            moving,
            landed,
            0.0,
            0.0,
            0.0,
            dt,
            model,
            thresholds,
            outward,
            inward,
            bars,
            none,
            none,
            peaks,
        )
        if outcome != STABLE:
            return outcome
    return COLLAPSED if y > (outward.top if sign > 0.0 else inward.top) else STABLE


@kernel
def integrate_with_bars(
    ground, dt, scale, model, outward, inward, bars, start, trace, impact_time, impact_velocity, none, peaks
):
    """`held_top.integrate` of a wall with bars.

    ground, dt, scale, model, outward, inward, start, impact_time, impact_velocity, peaks : of that
    bars : HeldBars
    trace : results, y, y' and the residual elongations [m] at the samples, shape (2 + bars, n); of shape (0, 0) none
    none : of `outcome_in_still_ground`
    """
    thresholds = uplift_thresholds(model)
    peaks[:] = 0.0
    sign = -1.0 if start[0] < 0.0 or (start[0] == 0.0 and start[1] < 0.0) else 1.0
    y, speed = sign * start[0], sign * start[1]
    moving, impacts = y != 0.0 or speed != 0.0, 0
    peaks[0 if sign > 0.0 else 1] = y
    begin_bars(max(start[0], 0.0), outward, bars)
    kept = trace.shape[0] > 0
    for i in range(ground.size):
        if kept:
            trace[0, i] = sign * y if moving else 0.0
            trace[1, i] = sign * speed if moving else 0.0
            for j in range(bars.rows.shape[0]):
                trace[2 + j, i] = residual_length(j, y if sign > 0.0 else 0.0, outward, bars)
        if i == ground.size - 1:
            break
        ground0, slope = scale * ground[i], scale * (ground[i + 1] - ground[i]) / dt
        y, speed, sign, moving, impacts, outcome = through_sample_on_branches(
            y,
            speed,
            sign,
            moving,
            impacts,
            i * dt,
            ground0,
            slope,
            dt,
            model,
            thresholds,
            outward,
            inward,
            bars,
            impact_time,
            impact_velocity,
            peaks,
        )
        if outcome != STABLE:
            return outcome, impacts, i + 1
    outcome = outcome_in_still_ground(y, speed, sign, moving, dt, model, thresholds, outward, inward, bars, none, peaks)
    return outcome, impacts, ground.size


@kernel
def scan_with_bars(
    ground,
    dt,
    firsts,
    lasts,
    strongest,
    which,
    scales,
    model,
    outward,
    inward,
    bars,
    none,
    trace,
    both,
    outcomes,
    peaks,
):
    """Analyses one after the other.

    ground, dt, firsts, lasts, strongest, which, scales, model, outward, inward : of `held_lanes.one_pass`
    outcomes, peaks : of that
    bars, none, trace : of `integrate_with_bars`
    both : its peaks, room of shape (2,)
    """
    thresholds = uplift_thresholds(model)
    for m in range(scales.size):
        record = which[m]
        outcomes[m], peaks[m] = STABLE, 0.0
        if abs(scales[m]) * strongest[record] > (1.0 - 1e-9) * min(thresholds[0], thresholds[1]):
            own = ground[firsts[record] : lasts[record] + 1]
            outcomes[m], _, _ = integrate_with_bars(
                own, dt, scales[m], model, outward, inward, bars, (0.0, 0.0), trace, none, none, none, both
            )
            peaks[m] = max(turned_by(both[0], outward), turned_by(both[1], inward))


def scan(grounds: Grounds, which, scales, model: RockingModel, outcomes, peaks) -> np.ndarray:
    """`held_lanes.scan` of a wall with bars."""
    parts = split_with_bars(model)
    records = grounds.ground, grounds.dt, grounds.first, grounds.last, grounds.strongest
    scan_with_bars(*records, which, scales, *parts, np.zeros(0), np.zeros((0, 0)), np.zeros(2), outcomes, peaks)
    return np.zeros(scales.size, np.int64)


def history(ground, dt, scale, model, start, trace, impact_time, impact_velocity) -> tuple[int, float, int, int, int]:
    """`held_top.history` of a wall with bars.

    ground, dt, scale, model, start, impact_time, impact_velocity : of that
    trace : with their residual elongations [m], shape (2 + bars, n)
    """
    bare, outward, inward, bars = split_with_bars(model)
    sign = -1.0 if start[0] < 0.0 or (start[0] == 0.0 and start[1] < 0.0) else 1.0
    y, speed = to_y(sign * start[0], sign * start[1], outward if sign > 0.0 else inward)
    parts, peaks = (bare, outward, inward, bars), np.zeros(2)
    room = trace, impact_time, impact_velocity, np.zeros(0), peaks
    outcome, impacts, done = integrate_with_bars(ground, dt, scale, *parts, (sign * y, sign * speed), *room)
    to_rotations(trace[0], trace[1], outward, inward)
    to_rotations(np.zeros(impact_velocity.size), impact_velocity, outward, inward)
    peak = max(float(rotation_at(peaks[0], outward)), float(rotation_at(peaks[1], inward)))
    return outcome, peak, impacts, 0, done
