"""Eq. 1 by the Taylor series of order 6 or 8: one step per sample, events at the roots of the step's polynomial.

Cost: about 100 floating-point operations a step. Fails: nowhere found; a step whose series has not converged is
shortened until it has (resources/docs/physics.md, sections 6 to 8).
"""

from typing import NamedTuple

import numpy as np

from core.jit.decorators import inner_kernel, kernel, subkernel
from core.jit.fma import fma
from core.rocking.early_stop import cannot_recover
from core.rocking.events import IMPACTS_PER_SAMPLE, BlockState, end_of_record, leave_impact, next_uplift
from core.rocking.oscillator import SWING_FALLS, SWING_RISES, branch_stride, is_oscillating, state_on, swing_on
from core.rocking.outcome import COLLAPSED, IMPACT_LIMIT, STABLE
from core.rocking.series_with_bars import (
    initial_terms_held,
    strength_with_springs,
    taylor_coefficients_held,
    wall_alone,
)
from core.rocking.short_series import SHORT_SERIES, sine_and_cosine
from core.rocking.taylor_bounds import (
    MAX_GROWTH,
    converged_part,
    largest_push,
    neglected,
    relative_tolerance,
    shortened,
    turning_margin,
)
from core.rocking.taylor_polynomial import (
    first_crossing,
    increment,
    interior_maximum,
    landing,
    mirrored,
    part_turning_once,
    speed_increment,
    step_shape,
    whole_step,
)
from core.rocking.taylor_series import InitialTerms, constants_seen, wall_constants
from core.wall.moment_rotation import NEVER_REACHED, moment_branch, zone_of
from core.wall.rocking_model import seen_from


class Crossing(NamedTuple):
    """The end of a step.

    part : of the step that is taken [-]
    crossing : the same where the block then is at an end of its branch, else -1.0. (A flag here costs a fifth.)
    falls : that end is the lower one
    margin, bend, reach : bounds for `peak_may_grow`
    dphi, dv : changes of phi [rad] and of phi' [rad per step] in it
    """

    part: float
    crossing: float
    falls: bool
    margin: float
    bend: float
    reach: float
    dphi: float
    dv: float


@inner_kernel
def peak_may_grow(phi, dphi, speed, bend, reach, peak):
    """Whether a step that turns can go beyond the peak so far [rad]: a parabola of curvature `bend` through its start
    is above it.

    bend : of `shape`
    reach : how far the step strays from its chord [rad]
    (1.998 is 2 less a margin for rounding.)
    """
    return (max(phi, phi + dphi) + reach > peak) & (fma(speed, speed, 1.998 * bend * (peak - phi)) >= 0.0)


@inner_kernel
def climbs(speed, bend, gap):
    """Whether a step may rise by a gap [rad], not negative: a parabola of curvature `bend` through its start does.
    speed : at its start [rad per step]; bend : of `shape`. (1.998 as above.)"""
    return (bend >= 0.0) | ((speed > 0.0) & (fma(speed, speed, 1.998 * bend * gap) >= 0.0))


@inner_kernel
def converged_step(state, ground0, ground1, t, dt, branch, model, constants, order, bars):
    """(v0..v8, InitialTerms, part) of the first part of a step from t to the end of the sample, in which the series
    has converged, in units of that part.

    state : BlockState at t
    ground0, ground1 : ground acceleration at both ends of the sample [m/s2]
    t : where in the sample it is, 0 to 1
    dt : the sample [s]
    branch : of `moment_branch`, or with bars of `bar_state.branch_of_bars`
    model : RockingModel as the pivot sees it
    constants : WallConstants, with bars of `bounds_held`
    order : of the series, 6 or 8
    bars : their rows, None of a wall without
    """
    s, c = sine_and_cosine(state.phi)
    start = initial_terms_held(
        state.phi, state.speed, s, c, state.side, ground0, ground1, t, dt, branch[2:], model.p2, constants, bars
    )
    v, growth = taylor_coefficients_held(state.phi, start, branch[2:], constants, order, bars)
    weighed = wall_alone(branch[2:], bars)
    relative = relative_tolerance(state.phi, start.speed, start.forcing, start.p2, weighed, constants)
    strength = strength_with_springs(constants, branch[2:], bars)
    tail = neglected(v, growth, start.forcing, start.rise, start.p2, strength, order)
    part = 1.0
    if not (tail <= min(constants.tolerance, relative) and growth < MAX_GROWTH):
        part = converged_part(tail, growth, order, constants.tolerance, relative)
        v, p2, rise = shortened(v, start.p2, start.rise, part)
        start = InitialTerms(v[0], start.net, start.sine, start.cosine, start.beta, rise, p2, start.forcing)
    return v, start, part


@inner_kernel
def first_event(v, start, phi, branch, constants, bars):
    """The Crossing that ends a step: the first one of an end of the branch, else its end or that of a shorter one
    which turns once.

    v, start : of `converged_step`
    phi : rotation at its start [rad]
    branch, constants, bars : as there; with bars the upper end is looked for as an impact is, upside down
    """
    low, high, factor, slope, constant, _ = branch
    # a chord stays within 1/8 max|phi''| of the curve, one of the speed within the margin: far from
    # both ends of the branch, or moving away from it, nothing happens
    part = 1.0
    dphi, dv = whole_step(v)
    push = largest_push(max(phi, phi + dphi), start.forcing, start.p2, constants, factor, slope, constant)
    reach = 0.125 * push
    margin = turning_margin(v[0], dv, start.rise, start.forcing + slope, start.p2, constants.strength, push)
    falls = min(phi, phi + dphi) - low <= reach and min(v[0], v[0] + dv) <= margin
    rises = high - max(phi, phi + dphi) <= reach and max(v[0], v[0] + dv) >= -margin
    crossing = -1.0
    bend, stays = 0.0, True
    if falls or rises:
        bend, _, stays = step_shape(v, phi - low, dphi, dv, part)
    rises = rises and climbs(v[0], bend, high - phi)
    risen = False
    if bars is not None and rises and not falls and phi < high:
        crossing, _, risen = landing(mirrored(v), high - phi, 1.0)
        crossing = crossing if risen else -1.0
    if rises and not risen and bend >= 0.0:
        part = part_turning_once(v, part)
    if falls and not stays:
        crossing, _, located = landing(v, phi - low, part)
        if not located:
            part = part_turning_once(v, part)
            crossing = first_crossing(v, phi - low, 1.0, part)
    if rises and not risen:
        above = first_crossing(v, phi - high, -1.0, part)
        falls = not (above >= 0.0 and (crossing < 0.0 or above < crossing))
        crossing = crossing if falls else above
    if crossing >= 0.0:
        part = crossing
    if crossing >= 0.0 or part < 1.0:
        dphi = increment(v, part)
        dv = speed_increment(v, part)
    return Crossing(part, crossing, falls, margin, bend, reach, dphi, dv)


@inner_kernel
def advance(state, v, shortened_to, event, t, dt):
    """(BlockState, t) at the end of a step, before what happens there.

    v, shortened_to : of `converged_step`
    event : Crossing
    """
    phi, peak, part = state.phi, state.peak, event.part
    dphi, dv = event.dphi, event.dv
    if min(v[0], -(v[0] + dv)) > -2.0 * event.margin and peak_may_grow(phi, dphi, v[0], event.bend, event.reach, peak):
        peak = max(peak, phi + interior_maximum(v, part))
    speed = fma(dv, 1.0 / (dt * (1.0 - t)) * (1.0 / shortened_to), state.speed)
    part *= shortened_to
    t = fma(part, 1.0 - t, t) if part < 1.0 else 1.0
    if event.crossing < 0.0:
        phi += dphi
        peak = max(peak, phi)
    return BlockState(state.side, phi, speed, state.moving, state.zone, peak, state.impacts, state.clamped), t


@inner_kernel
def impact(state, ground, model, constants):
    """(BlockState, rotation speed just after [rad/s]) of an impact at theta = 0 (Eq. 3, 7); ground : [m/s2]."""
    speed, after, side, moving, clamp = leave_impact(
        max(-state.speed, 0.0), state.side, ground, model, constants.thresholds
    )
    hit = after * speed
    return BlockState(
        side, 0.0, speed if moving else 0.0, moving, state.zone, state.peak, state.impacts + 1, state.clamped + clamp
    ), hit


@inner_kernel
def cross_kink(state, event, branch, apart):
    """BlockState on the next branch of the moment law, at the end of this one that a step reached. apart : by how much
    their numbers differ"""
    low, high, _, _, _, _ = branch
    phi = low if event.falls else high
    return BlockState(
        state.side,
        phi,
        state.speed,
        True,
        state.zone + (-apart if event.falls else apart),
        max(state.peak, phi),
        state.impacts,
        state.clamped,
    )


@inner_kernel
def through_sample(ground0, ground1, dt, model, constants, order, strongest, state, start):
    """Carry the block to its next impact or through the sample; rest, uplift and kinks included.

    ground0, ground1 : ground acceleration at both ends [m/s2]
    dt : the sample [s]
    model : RockingModel
    constants : WallConstants
    order : of the series, 6 or 8
    strongest : bound of |u''|/g for `cannot_recover` [-]
    state : BlockState
    start : where in the sample it is, 0 to 1
    Returns (outcome so far, where in the sample, rotation speed after the impact [rad/s], BlockState).
    """
    jump = ground1 - ground0
    t = start
    hit = 0.0
    outcome = STABLE
    kinks = 0
    while t < 1.0:
        if not state.moving:
            t, side = next_uplift(ground0, jump, t, 1.0, constants.thresholds)
            if t >= 1.0:
                break
            state = BlockState(side, 0.0, 0.0, True, zone_of(0.0, model), state.peak, state.impacts, state.clamped)
        if is_oscillating(model.driven, state.zone):
            state, t, ended = swing_on(constants.swing, state, ground0, jump, t)
            if ended == SWING_FALLS:
                state, hit = impact(state, ground0 + jump * t, seen_from(model, state.side), constants)
                break
            if ended == SWING_RISES:
                state = state_on(state, 2)
                kinks += 1
            if kinks > IMPACTS_PER_SAMPLE:
                outcome = IMPACT_LIMIT
                break
            continue
        seen, own = seen_from(model, state.side), constants_seen(constants, constants.other, state.side)
        branch = moment_branch(state.zone, seen)
        v, begun, part = converged_step(state, ground0, ground1, t, dt, branch, seen, own, order, None)
        event = first_event(v, begun, state.phi, branch, own, None)
        state, t = advance(state, v, part, event, t, dt)
        if event.crossing < 0.0:
            if state.phi > SHORT_SERIES and cannot_recover(state.phi, state.speed, strongest, seen):
                outcome = COLLAPSED
                break
            continue
        if event.falls and branch[0] == 0.0:
            state, hit = impact(state, ground0 + jump * t, seen, constants)
            break
        state = cross_kink(state, event, branch, branch_stride(model.driven))
        kinks += 1
        if kinks > IMPACTS_PER_SAMPLE:
            outcome = IMPACT_LIMIT
            break
    return outcome, t, hit, state


def make_integrator(order):
    """The kernel `integrate` specialised at compile time for order 6 or 8."""

    @kernel
    def integrate(ground, dt, scale, model, start, rotation, velocity, impact_time, impact_velocity):
        """Rocking history of one wall under one scaled record (Eq. 1), rest, uplift and impacts included.

        ground : ground acceleration [m/s2], shape (n,)
        dt : its time step [s]
        scale : multiplier [-], negative for the reversed record
        model : RockingModel
        start : initial rotation [rad] and velocity [rad/s]
        rotation : results at the samples [rad], shape (n,)
        velocity : results at the samples [rad/s], shape (n,)
        impact_time : results [s], up to its size
        impact_velocity : results just after each impact [rad/s], of the same shape
        Returns (outcome, peak rotation [rad], impacts, clamped ratios, samples done).
        """
        constants = wall_constants(model, dt)
        zero = np.int64(0)  # a plain 0 would be a type of its own, and compile everything again
        side = -1.0 if start[0] < 0.0 or (start[0] == 0.0 and start[1] < 0.0) else 1.0
        phi = side * start[0]
        moving = phi != 0.0 or start[1] != 0.0
        state = BlockState(side, phi, side * start[1], moving, zone_of(phi, model), phi, zero, zero)
        rotation[0] = start[0]
        velocity[0] = start[1]
        for i in range(ground.size - 1):
            t = 0.0
            before = state.impacts
            while t < 1.0:
                impacts = state.impacts
                outcome, t, hit, state = through_sample(
                    scale * ground[i], scale * ground[i + 1], dt, model, constants, order, NEVER_REACHED, state, t
                )
                if impacts < state.impacts and impacts < impact_time.size:
                    impact_time[impacts] = i * dt + t * dt
                    impact_velocity[impacts] = hit
                if state.impacts - before > IMPACTS_PER_SAMPLE:
                    outcome = IMPACT_LIMIT
                if outcome != STABLE:
                    return outcome, state.peak, state.impacts, state.clamped, i + 1
            rotation[i + 1] = state.side * state.phi if state.moving else 0.0
            velocity[i + 1] = state.side * state.speed if state.moving else 0.0
        outcome, peak = at_end(state, model)
        return outcome, peak, state.impacts, state.clamped, ground.size

    return integrate


INTEGRATE = {order: make_integrator(order) for order in (6, 8)}


@subkernel
def at_end(state, model):
    """(outcome, peak [rad]) once the ground is still, from the BlockState after the last sample."""
    if state.moving:
        return end_of_record(state.phi, state.speed, state.peak, seen_from(model, state.side))
    return STABLE, state.peak
