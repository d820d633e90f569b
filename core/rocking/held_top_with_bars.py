"""Histories of a wall held at its top with ties along it that have yielded (resources/docs/physics.md, section 19).

As held_top.py, with what the bars add to the work of the weights on each of their branches, and with more events: a bar
becomes taut, yields, turns back, is slack, breaks (bar_state.py). Bars pull at a wall that moves outward alone; their
elongations are in metres here.
"""

import math
from typing import NamedTuple

import numpy as np

from core.jit.decorators import kernel, subkernel
from core.jit.fma import fma
from core.rocking.bar_state import PHASE, RESIDUAL, TAUT, YIELDING, cross_kinks
from core.rocking.events import IMPACTS_PER_SAMPLE, next_uplift, uplift_thresholds
from core.rocking.grounds import Grounds
from core.rocking.held_bars import (
    FORCE,
    SPRING,
    begin_bars,
    ends_of_branch,
    residual_length,
    strip_with_bars,
    turn_back,
)
from core.rocking.held_lanes import SAFE_SHARE
from core.rocking.held_top import first_state, land, start_on_side, turn_results
from core.rocking.outcome import COLLAPSED, IMPACT_LIMIT, STABLE
from core.rocking.side_functions import DEGREE, V, X, turned_by
from core.rocking.side_series import moved, place_in, root, series_about, speed_of, turning_once
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
    piece, s, per = place_in(y, side)
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
    terms, h = series_about(speed, beta, slope, p2, s, per, bars.room, side.values[piece, X], side.top, h)
    return terms, h, s, per


@subkernel
def step_one_way(y, speed, terms, h, s, per, least):
    """A step that ends where the wall turns: length [s], y and y' after it.

    y, speed, terms, h, s, per, least : of `side_series.step_of`
    """
    h, v = turning_once(y, speed, terms, h, s, per, least)
    if speed < 0.0 < v or v < 0.0 < speed:
        h, v = root(1, y, terms, 0.0, h), 0.0
    return h, y + moved(terms, h), v


class OnBranch(NamedTuple):
    """The wall at one instant: y, speed [rad], [rad/s] seen from the side it is on; sign, moving, impacts : of
    `held_top.through_sample`"""

    y: float
    speed: float
    sign: float
    moving: bool
    impacts: int


@subkernel
def through_sample_on_branches(
    state, instant, ground0, slope, dt, strip, thresholds, impact_time, impact_velocity, peaks
):
    """Carry a wall with bars through one sample, or until it has overturned.

    state : OnBranch at its start
    instant, ground0, slope, dt, thresholds, impact_time, impact_velocity, peaks : of `held_top.through_sample`
    strip : HeldStrip
    Returns (OnBranch, outcome).
    """
    y, speed, sign, moving, impacts = state
    bars, t, events = strip.bars, 0.0, 0
    while t < dt:
        if not moving:
            t, sign = next_uplift(ground0, slope, t, dt, thresholds)
            if t >= dt:
                break
            moving, y, speed = True, 0.0, 0.0
        side, k = (strip.outward, 0) if sign > 0.0 else (strip.inward, 1)
        beta, rate = sign / G * fma(slope, t, ground0), sign / G * slope
        terms, holds, s, per = series_on_branch(y, speed, sign, beta, rate, strip.model.p2, side, bars, dt - t)
        h, x, v = step_one_way(y, speed, terms, holds, s, per, 1e-9 * dt)
        low, high = ends_of_branch(sign, bars)
        rises, falls = x > high, x < low and low > 0.0
        lands = not rises and not falls and (x < 0.0 or (x == 0.0 and v < 0.0))
        if lands:
            t, speed, sign, moving = land(
                y,
                terms,
                h,
                t,
                sign,
                instant,
                ground0,
                slope,
                dt,
                strip.model,
                thresholds,
                impacts,
                impact_time,
                impact_velocity,
            )
            y = 0.0
            impacts += 1
        else:
            turns = v == 0.0 and speed > 0.0 and sign > 0.0
            if rises or falls:
                x = high if rises else low
                h = root(0, y - x, terms, 0.0, h)
                v = speed_of(terms, h)
                turns = False
            t = t + h if h < dt - t else dt
            y, speed = x, v
            peaks[k] = max(peaks[k], y)
            if rises or falls:
                cross_kinks(y, falls, bars.rows, bars.held)
            if turns:
                turn_back(y, side, bars)
            if y > side.end:
                return OnBranch(y, speed, sign, moving, impacts), COLLAPSED
        events += int(lands or rises or falls)
        if events > IMPACTS_PER_SAMPLE:
            return OnBranch(y, speed, sign, moving, impacts), IMPACT_LIMIT
    return OnBranch(y, speed, sign, moving, impacts), STABLE


@subkernel
def outcome_in_still_ground(state, dt, strip, thresholds, none, peaks):
    """What the wall does once its record has ended: it is followed through LANDINGS_AFTER. One that leans on its bars
    beyond collapse, and stays there, has collapsed.

    state, dt, strip, thresholds, peaks : of `through_sample_on_branches`; none : in place of the impacts, shape (0,)
    """
    last = state.impacts + LANDINGS_AFTER
    for _ in range(int(STILL_TIME / (math.sqrt(strip.model.p2) * dt)) + 1):
        if not state.moving or state.impacts >= last:
            return STABLE
        state, outcome = through_sample_on_branches(state, 0.0, 0.0, 0.0, dt, strip, thresholds, none, none, peaks)
        if outcome != STABLE:
            return outcome
    return COLLAPSED if state.y > (strip.outward.top if state.sign > 0.0 else strip.inward.top) else STABLE


@subkernel
def keep(trace, i, state, strip):
    """Write y, y' and the residual elongation of each bar at sample i down. trace : of `integrate_with_bars`"""
    trace[0, i] = state.sign * state.y if state.moving else 0.0
    trace[1, i] = state.sign * state.speed if state.moving else 0.0
    for j in range(strip.bars.rows.shape[0]):
        trace[2 + j, i] = residual_length(j, state.y if state.sign > 0.0 else 0.0, strip.outward, strip.bars)


@kernel
def integrate_with_bars(ground, dt, scale, strip, start, trace, impact_time, impact_velocity, none, peaks):
    """`held_top.integrate` of a wall with bars.

    ground, dt, scale, start, impact_time, impact_velocity, peaks : of that
    strip : HeldStrip
    trace : results, y, y' and the residual elongations [m] at the samples, shape (2 + bars, n); of shape (0, 0) none
    none : of `outcome_in_still_ground`
    """
    thresholds = uplift_thresholds(strip.model)
    y, speed, sign, moving = first_state(start, peaks)
    state, kept = OnBranch(y, speed, sign, moving, np.int64(0)), trace.shape[0] > 0
    begin_bars(max(start[0], 0.0), strip.outward, strip.bars)
    for i in range(ground.size - 1):
        if kept:
            keep(trace, i, state, strip)
        ground0, slope = scale * ground[i], scale * (ground[i + 1] - ground[i]) / dt
        state, outcome = through_sample_on_branches(
            state, i * dt, ground0, slope, dt, strip, thresholds, impact_time, impact_velocity, peaks
        )
        if outcome != STABLE:
            return outcome, state.impacts, i + 1
    if kept:
        keep(trace, ground.size - 1, state, strip)
    return outcome_in_still_ground(state, dt, strip, thresholds, none, peaks), state.impacts, ground.size


@kernel
def scan_with_bars(ground, dt, firsts, lasts, strongest, which, scales, strip, none, trace, both, outcomes, peaks):
    """Analyses one after the other.

    ground, dt, firsts, lasts, strongest, which, scales, outcomes, peaks : of `held_lanes.one_pass`
    strip, none, trace : of `integrate_with_bars`
    both : its peaks, room of shape (2,)
    """
    thresholds = uplift_thresholds(strip.model)
    for m in range(scales.size):
        record = which[m]
        outcomes[m], peaks[m] = STABLE, 0.0
        if abs(scales[m]) * strongest[record] > SAFE_SHARE * min(thresholds[0], thresholds[1]):
            own = ground[firsts[record] : lasts[record] + 1]
            outcomes[m], _, _ = integrate_with_bars(
                own, dt, scales[m], strip, (0.0, 0.0), trace, none, none, none, both
            )
            peaks[m] = max(turned_by(both[0], strip.outward), turned_by(both[1], strip.inward))


def scan(grounds: Grounds, which, scales, model: RockingModel, outcomes, peaks) -> np.ndarray:
    """`held_lanes.scan` of a wall with bars."""
    records, strip = (
        (grounds.ground, grounds.dt, grounds.first, grounds.last, grounds.strongest),
        strip_with_bars(model),
    )
    scan_with_bars(*records, which, scales, strip, np.zeros(0), np.zeros((0, 0)), np.zeros(2), outcomes, peaks)
    return np.zeros(scales.size, np.int64)


def history(ground, dt, scale, model, start, trace, impact_time, impact_velocity) -> tuple[int, float, int, int, int]:
    """`held_top.history` of a wall with bars.

    ground, dt, scale, model, start, impact_time, impact_velocity : of that
    trace : with their residual elongations [m], shape (2 + bars, n)
    """
    strip, peaks = strip_with_bars(model), np.zeros(2)
    first = start_on_side(start, strip.outward, strip.inward)
    room = trace, impact_time, impact_velocity, np.zeros(0), peaks
    outcome, impacts, done = integrate_with_bars(ground, dt, scale, strip, first, *room)
    return outcome, turn_results(trace, impact_velocity, peaks, strip.outward, strip.inward), impacts, 0, done
