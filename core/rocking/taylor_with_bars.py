"""Eq. 1 of a wall held by tie bars, by the Taylor series of order 8 (resources/docs/physics.md, section 18).

As `taylor.py`, with more terms in the equation (series_with_bars.py) and more events: a bar becomes taut, yields, turns
back, is slack, breaks. Walls of the rigid law only. Many analyses run in lanes (lane_scheduler.py), of which these are
the functions where something happens.
"""

import math

import numpy as np

from core.jit.decorators import inner_kernel, kernel, subkernel
from core.rocking.bar_state import (
    BROKEN,
    PHASE,
    all_broken,
    bar_pull,
    cross_kinks,
    initial_state,
    residual_of,
    store_sample,
    thresholds_with,
    unload,
)
from core.rocking.early_stop import cannot_recover
from core.rocking.events import IMPACTS_PER_SAMPLE, LAST_ROTATION, BlockState, next_uplift
from core.rocking.outcome import COLLAPSED, IMPACT_LIMIT, STABLE
from core.rocking.series_with_bars import ORDER, bounds_held
from core.rocking.short_series import sine_and_cosine
from core.rocking.taylor import Crossing, advance, converged_step, first_event, impact
from core.rocking.taylor_polynomial import (
    CURVATURE,
    RATE,
    bracketed_root,
    curvature,
    increment,
    part_turning_once,
    speed_increment,
)
from core.rocking.taylor_series import WallConstants, wall_constants
from core.units import G
from core.wall.bars import bar_rows, stored, work_to
from core.wall.moment_rotation import NEVER_REACHED, potential
from core.wall.rocking_model import RockingModel, seen_from

STILL_TIME = 60.0
"""How long a wall is followed in still ground after its record, times 1/p: it then leans on a bar, or bounces without
loss."""

ON, AT_IMPACT, AT_KINK = 0, 1, 2
"""Where a step of a wall held by bars ends: nothing happens there; at zero; a bar becomes another one."""


@subkernel
def until_turn(v, event):
    """(Crossing that ends no later than where the wall, moving outward, first turns back, whether it does there)."""
    if event.part == 1.0 and min(v[0], v[0] + event.dv) > event.margin:
        return event, False
    part = part_turning_once(v, event.part)
    turn, low = -1.0, 0.0
    if v[0] <= 0.0 and v[1] <= 0.0:
        turn = 0.0
    elif v[0] + speed_increment(v, part) < 0.0:
        if v[0] <= 0.0:  # it starts at rest, outward
            low = bracketed_root(v, 0.0, CURVATURE, 0.0, part)
        turn = bracketed_root(v, 0.0, RATE, low, part)
    elif v[1] < 0.0 < curvature(v, part):
        lowest = bracketed_root(v, 0.0, CURVATURE, 0.0, part)
        if v[0] + speed_increment(v, lowest) < 0.0:
            turn = bracketed_root(v, 0.0, RATE, 0.0, lowest)
    if turn < 0.0 and part >= event.part:
        return event, False
    end = turn if turn >= 0.0 else part
    dphi, dv = increment(v, end), speed_increment(v, end)
    return Crossing(end, -1.0, event.falls, event.margin, event.bend, event.reach, dphi, dv), turn >= 0.0


@subkernel
def end_of_step(state, v, begun, part, t, dt, ground0, jump, branch, yields, seen, bounds, bars, held):
    """Carry the wall through a step, to its first event.

    state : BlockState at t
    v, begun, part : of `converged_step`
    t : where in the sample it is, 0 to 1
    dt : the sample [s]
    ground0, jump : ground acceleration at the start of the sample, and its change over it [m/s2]
    branch : (low, high, a, K, C, c) of `series_with_bars`
    yields : whether a bar does
    seen : RockingModel without bars as the pivot sees it
    bounds : of `bounds_held`
    bars, held : the bars and their state, shape (bars, 5)
    Returns (BlockState, t, rotation speed after an impact [rad/s], ON, AT_IMPACT or AT_KINK).
    """
    event, turns = first_event(v, begun, state.phi, branch, bounds, bars), False
    if yields:
        event, turns = until_turn(v, event)
    state, t = advance(state, v, part, event, t, dt)
    if turns:
        unload(state.phi, bars, held)
        return state_at_kink(state, state.phi, 0.0), t, 0.0, AT_KINK
    if event.crossing < 0.0:
        return state, t, 0.0, ON
    low, high, _, _, _, _ = branch
    if event.falls and low == 0.0:
        there = replace_thresholds(bounds, thresholds_with(bounds, bars, held))
        state, hit = impact(state, ground0 + jump * t, seen, there)
        return state, t, hit, AT_IMPACT
    phi = low if event.falls else high
    cross_kinks(phi, event.falls, bars, held)
    return state_at_kink(state, phi, state.speed), t, 0.0, AT_KINK


@subkernel
def through_sample_with_bars(ground0, ground1, dt, model, constants, strongest, state, start, bars, held):
    """Carry the block to its next impact or through the sample, as `taylor.through_sample`.

    ground0, ground1 : ground acceleration at both ends [m/s2]
    dt : the sample [s]
    model : RockingModel without bars
    constants : WallConstants
    strongest : bound of |u''|/g for `cannot_recover_with_bars` [-]
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
        seen = seen_from(model, state.side)
        pull = bar_pull(state.side, bars, held)
        wall = seen.restoring
        branch = (pull.low, pull.high, wall.sine, pull.spring, pull.constant, wall.cosine)
        bounds = bounds_held(constants, branch[2:], bars)
        v, begun, part = converged_step(state, ground0, ground1, t, dt, branch, seen, bounds, ORDER, bars)
        state, t, hit, what = end_of_step(
            state, v, begun, part, t, dt, ground0, jump, branch, pull.yields, seen, bounds, bars, held
        )
        if what == AT_IMPACT:
            break
        if what == ON and cannot_recover_with_bars(state, strongest, seen, held):
            outcome = COLLAPSED
            break
        kinks += int(what == AT_KINK)
        if kinks > IMPACTS_PER_SAMPLE:
            outcome = IMPACT_LIMIT
            break
    return outcome, t, hit, state


@subkernel
def cannot_recover_with_bars(state, strongest, model, held):
    """As `early_stop.cannot_recover`, of a BlockState; bars that are left may still hold it."""
    if state.phi > LAST_ROTATION:
        return True
    return all_broken(held) and cannot_recover(state.phi, state.speed, strongest, model)


@inner_kernel
def state_at_kink(state, phi, speed):
    """BlockState at a kink of the bars, phi [rad], with this speed [rad/s]."""
    return BlockState(state.side, phi, speed, True, state.zone, max(state.peak, phi), state.impacts, state.clamped)


@inner_kernel
def replace_thresholds(constants, thresholds):
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
def integrate_after_record(dt, model, constants, state, bars, held):
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
    state = initial_state(start, bars, held)
    store_sample(trace, 0, state, bars, held)
    for i in range(ground.size - 1):
        t, before = 0.0, state.impacts
        while t < 1.0:
            impacts = state.impacts
            outcome, t, hit, state = through_sample_with_bars(
                scale * ground[i], scale * ground[i + 1], dt, model, constants, NEVER_REACHED, state, t, bars, held
            )
            if impacts < state.impacts and impacts < impact_time.size:
                impact_time[impacts] = i * dt + t * dt
                impact_velocity[impacts] = hit
            if state.impacts - before > IMPACTS_PER_SAMPLE:
                outcome = IMPACT_LIMIT
            if outcome != STABLE:
                return outcome, state.peak, state.impacts, state.clamped, i + 1
        store_sample(trace, i + 1, state, bars, held)
    outcome, after = integrate_after_record(dt, model, constants, state, bars, held)
    return outcome, after.peak, state.impacts, state.clamped, ground.size


def separate_bars(model: RockingModel) -> tuple[RockingModel, np.ndarray, np.ndarray]:
    """(the wall without its bars, its bars as an array, room for their state), as the kernels take them."""
    bars = bar_rows(model.bars)
    return model._replace(bars=()), bars, np.zeros(bars.shape)


def integrate(ground, dt, scale, model, start, trace, impact_time, impact_velocity):
    """`integrate_with_bars` of a RockingModel with its bars.

    ground, dt, scale, start, trace : as there
    model : RockingModel
    impact_time, impact_velocity : as there
    """
    bare, *bars = separate_bars(model)
    return integrate_with_bars(ground, dt, scale, bare, start, *bars, trace, impact_time, impact_velocity)
