"""Eq. 1 of a wall held by tie bars, by the Taylor series of order 8 (resources/docs/physics.md, section 18).

As `taylor.py`, with one more term in the equation and more events: a bar becomes taut, yields, turns back, is slack,
breaks. Walls of the rigid law only. One analysis after another: no vector instructions, the same results for a
single history and for many.
"""

import math

import numpy as np

from core.jit.decorators import inner_kernel, kernel, subkernel
from core.rocking.bar_state import (
    BROKEN,
    PHASE,
    all_broken,
    at_start,
    cross_kinks,
    keep,
    pull_of,
    residual_of,
    set_phases,
    thresholds_with,
    unload,
)
from core.rocking.early_stop import LOOKAHEAD, MAX_SETTLED_RATIO, cannot_recover
from core.rocking.events import IMPACTS_PER_SAMPLE, LAST_ROTATION, BlockState, next_uplift
from core.rocking.outcome import COLLAPSED, IMPACT_LIMIT, STABLE
from core.rocking.series_with_bars import bounded_with, step_with_bars, until_turn
from core.rocking.short_series import sine_and_cosine
from core.rocking.taylor import advance, first_event, impact
from core.rocking.taylor_series import PER_G, WallConstants, wall_constants
from core.units import G
from core.wall.bars import bar_rows, stored, work_to
from core.wall.moment_rotation import FAR, potential
from core.wall.rocking_model import RockingModel, seen_from

SETTLED_EVERY = 16
"""Samples between two checks of whether an analysis is settled."""

STILL_TIME = 60.0
"""How long a wall is followed in still ground after its record, times 1/p: it then leans on a bar, or bounces without
loss."""


@subkernel
def through_sample_with_bars(ground0, ground1, dt, model, constants, strongest, state, start, bars, held):
    """Carry the block to its next impact or through the sample, as `taylor.through_sample`.

    ground0, ground1 : ground acceleration at both ends [m/s2]
    dt : the sample [s]
    model : RockingModel without bars
    constants : WallConstants
    strongest : bound of |u''|/g for `cannot_recover` [-]
    state : BlockState
    start : where in the sample it is, 0 to 1
    bars : of `bar_rows`, shape (bars, 5)
    held : state of the bars, shape (bars, 5)
    Returns (outcome so far, where in the sample, rotation speed after the impact [rad/s], BlockState).
    """
    jump = ground1 - ground0
    t, hit, outcome, kinks = start, 0.0, STABLE, 0
    while t < 1.0:
        if not state.moving:
            t, side = next_uplift(ground0, jump, t, 1.0, thresholds_with(constants, bars, held))
            if t >= 1.0:
                break
            state = BlockState(side, 0.0, 0.0, True, 2, state.peak, state.impacts, state.clamped)
            set_phases(0.0, bars, held)
        seen = seen_from(model, state.side)
        pull = pull_of(state.side, bars, held)
        bounds = bounded_with(constants, pull)
        v, begun, part = step_with_bars(state, ground0, ground1, t, dt, pull, seen, constants, bounds)
        # the moment is bounded by that of the wall and of the bars
        moment = seen.restoring.amplitude + abs(pull.constant)
        event = first_event(v, begun, state.phi, (pull.low, pull.high, 0.0, pull.spring, moment, 0.0), bounds)
        turns = False
        if pull.yields:
            event, turns = until_turn(v, event)
        state, t = advance(state, v, part, event, t, dt)
        if turns:
            unload(state.phi, bars, held)
            state = at_kink(state, state.phi, 0.0)
        elif event.crossing < 0.0:
            if state.phi > LAST_ROTATION or (
                all_broken(held) and cannot_recover(state.phi, state.speed, strongest, seen)
            ):
                outcome = COLLAPSED
                break
            continue
        elif event.falls and pull.low == 0.0:
            thresholds = thresholds_with(constants, bars, held)
            state, hit = impact(state, ground0 + jump * t, model, with_thresholds(constants, thresholds))
            set_phases(0.0, bars, held)
            break
        else:
            phi = pull.low if event.falls else pull.high
            state = at_kink(state, phi, state.speed)
            cross_kinks(phi, event.falls, bars, held)
        kinks += 1
        if kinks > IMPACTS_PER_SAMPLE:
            outcome = IMPACT_LIMIT
            break
    return outcome, t, hit, state


@inner_kernel
def at_kink(state, phi, speed):
    """BlockState at a kink of the bars, phi [rad], with this speed [rad/s]."""
    return BlockState(state.side, phi, speed, True, state.zone, max(state.peak, phi), state.impacts, state.clamped)


@inner_kernel
def with_thresholds(constants, thresholds):
    """WallConstants with these thresholds of uplift [m/s2]."""
    return WallConstants(
        thresholds,
        constants.tangent,
        constants.sine,
        constants.cosine,
        constants.tolerance,
        constants.strength,
        constants.sine_bound,
        constants.collapse,
        constants.other,
    )


@subkernel
def settled_with_bars(state, push, model, bars, held):
    """As `early_stop.settled`: whether the rest of the ground can neither overturn the wall nor move it beyond its peak
    so far. To come to its peak again outward, it must do the work of the bars too, which only grows where they yield.

    state : BlockState; push : bound of the integral of |u''| [m/s]; model : RockingModel without bars
    """
    seen = seen_from(model, state.side)
    top = seen.slenderness + seen.restoring.lean
    if state.phi >= top:
        return False
    energy = state.speed * state.speed + 2.0 * model.p2 * potential(state.phi, seen)
    outward = model.slenderness + model.restoring.lean
    allowed = potential(min(state.peak, outward), model)
    sine, _ = sine_and_cosine(state.phi)
    highest, _ = sine_and_cosine(min(state.peak, outward))
    for j in range(bars.shape[0]):
        if held[j, PHASE] != BROKEN:
            residual = residual_of(j, sine, bars, held)
            if state.side > 0.0:
                energy += 2.0 * model.p2 * stored(bars[j], residual, sine)
            allowed += work_to(bars[j], residual, highest)
    if model.one_sided == 0.0:
        other = seen_from(model, -1.0)
        allowed = min(allowed, potential(min(state.peak, other.slenderness + other.restoring.lean), other))
    reach = math.sqrt(energy) + model.p2 / G * push
    return reach * reach < 1.999999 * model.p2 * allowed


@subkernel
def in_still_ground(dt, model, constants, state, bars, held):
    """(outcome, BlockState) once the record has ended: the wall is followed until it cannot reach its peak again. One
    that leans on its bars beyond theta_c, and stays there, has collapsed.

    dt : the sample [s]
    model : RockingModel without bars
    constants : WallConstants
    state : BlockState
    bars, held : the bars and their state, shape (bars, 5)
    """
    samples = int(STILL_TIME / (math.sqrt(model.p2) * dt)) + 1
    for _ in range(samples):
        if not state.moving or settled_with_bars(state, 0.0, model, bars, held):
            return STABLE, state
        t, before = 0.0, state.impacts
        while t < 1.0:
            outcome, t, _, state = through_sample_with_bars(0.0, 0.0, dt, model, constants, 0.0, state, t, bars, held)
            if state.impacts - before > IMPACTS_PER_SAMPLE:
                outcome = IMPACT_LIMIT
            if outcome != STABLE:
                return outcome, state
    seen = seen_from(model, state.side)
    return COLLAPSED if state.phi > seen.slenderness + seen.restoring.lean else STABLE, state


@kernel
def integrate_with_bars(ground, dt, scale, model, start, bars, held, trace, impact_time, impact_velocity):
    """Integrate the history of a wall held by bars, as the kernels of `taylor.INTEGRATE`.

    ground : ground acceleration [m/s2], shape (n,)
    dt : its time step [s]
    scale : multiplier [-], negative for the reversed record
    model : RockingModel without bars, of the rigid law
    start : initial rotation [rad] and velocity [rad/s]
    bars : of `bar_rows`, shape (bars, 5)
    held : room, shape (bars, 5)
    trace : results, rotation [rad], velocity [rad/s] and residual elongations of `keep`, shape (2 + bars, n)
    impact_time : results [s], up to its size
    impact_velocity : results just after each impact [rad/s], of the same shape
    Returns (outcome, peak rotation [rad], impacts, clamped ratios, samples done).
    """
    constants = wall_constants(model, dt)
    state = at_start(start, bars, held)
    keep(trace, 0, state, bars, held)
    for i in range(ground.size - 1):
        t, before = 0.0, state.impacts
        while t < 1.0:
            impacts = state.impacts
            outcome, t, hit, state = through_sample_with_bars(
                scale * ground[i], scale * ground[i + 1], dt, model, constants, FAR, state, t, bars, held
            )
            if impacts < state.impacts and impacts < impact_time.size:
                impact_time[impacts] = i * dt + t * dt
                impact_velocity[impacts] = hit
            if state.impacts - before > IMPACTS_PER_SAMPLE:
                outcome = IMPACT_LIMIT
            if outcome != STABLE:
                return outcome, state.peak, state.impacts, state.clamped, i + 1
        keep(trace, i + 1, state, bars, held)
    outcome, after = in_still_ground(dt, model, constants, state, bars, held)
    return outcome, after.peak, state.impacts, state.clamped, ground.size


@subkernel
def outcome_with_bars(ground, ahead, first, last, dt, scale, strength, model, constants, bars, held):
    """(outcome, BlockState at the end) of one analysis from rest that ends as soon as nothing it is asked for can
    change.

    ground, ahead, dt : as `scan_with_bars`
    first, last : samples of the record
    scale : multiplier [-]
    strength : bound of |u''|/g [-]
    model, constants : RockingModel without bars, WallConstants
    bars, held : as `scan_with_bars`
    """
    state = at_start((0.0, 0.0), bars, held)
    may_settle = model.ratio_drop == 0.0 and model.ratio_at_rest <= MAX_SETTLED_RATIO
    i = first
    while i < last:
        if not state.moving:
            right, left = thresholds_with(constants, bars, held)
            one, other = scale * ahead[0, i], scale * ahead[1, i]
            if max(one, other) <= right and min(one, other) >= -left:
                i = min(i + LOOKAHEAD - 1, last)
                continue
        t, before = 0.0, state.impacts
        while t < 1.0:
            outcome, t, _, state = through_sample_with_bars(
                scale * ground[i], scale * ground[i + 1], dt, model, constants, strength, state, t, bars, held
            )
            if state.impacts - before > IMPACTS_PER_SAMPLE:
                outcome = IMPACT_LIMIT
            if outcome != STABLE:
                return outcome, state
        i += 1
        checks = may_settle and (i - first) % SETTLED_EVERY == 1
        if checks and settled_with_bars(state, abs(scale) * ahead[3, i], model, bars, held):
            return STABLE, state
    clamped = state.clamped
    outcome, state = in_still_ground(dt, model, constants, state, bars, held)
    return outcome, BlockState(
        state.side, state.phi, state.speed, state.moving, state.zone, state.peak, state.impacts, clamped
    )


@kernel
def scan_with_bars(
    ground, ahead, dt, firsts, lasts, strongest, which, scales, model, bars, held, outcomes, peaks, clamped
):
    """Analyses of a wall held by bars, one after another.

    ground, ahead, dt, firsts, lasts, strongest, which, scales : as lane_scheduler.py `one_pass`
    model : RockingModel without bars, of the rigid law
    bars : of `bar_rows`, shape (bars, 5)
    held : room, shape (bars, 5)
    outcomes, peaks, clamped : results, as there
    """
    constants = wall_constants(model, dt)
    for k in range(scales.size):
        record = which[k]
        strength = abs(scales[k]) * strongest[record] * PER_G
        outcomes[k], state = outcome_with_bars(
            ground, ahead, firsts[record], lasts[record], dt, scales[k], strength, model, constants, bars, held
        )
        peaks[k] = state.peak
        clamped[k] = state.clamped


def with_bars_apart(model: RockingModel) -> tuple[RockingModel, np.ndarray, np.ndarray]:
    """(the wall without its bars, its bars as an array, room for their state), as the kernels take them."""
    bars = bar_rows(model.bars)
    return model._replace(bars=()), bars, np.zeros(bars.shape)


def integrate(ground, dt, scale, model, start, trace, impact_time, impact_velocity):
    """`integrate_with_bars` of a RockingModel with its bars.

    ground, dt, scale, start, trace : as there
    model : RockingModel
    impact_time, impact_velocity : as there
    """
    bare, *bars = with_bars_apart(model)
    return integrate_with_bars(ground, dt, scale, bare, start, *bars, trace, impact_time, impact_velocity)


def scan(grounds, which, scales, model, outcomes, peaks) -> np.ndarray:
    """`core.rocking.history.scan_records` of a wall with bars; parameters as there. Returns the clamped velocity ratios
    of each, shape (m,)."""
    bare, *bars = with_bars_apart(model)
    clamped = np.zeros(scales.size, np.int64)
    records = grounds.first, grounds.last, grounds.strongest
    scan_with_bars(
        grounds.ground, grounds.ahead, grounds.dt, *records, which, scales, bare, *bars, outcomes, peaks, clamped
    )
    return clamped
