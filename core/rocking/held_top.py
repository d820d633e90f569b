"""Histories of a wall held at its top, by its own equation (resources/docs/physics.md, section 19).

The one degree of freedom is followed in the coordinate y with y' = sqrt(I(theta)/I_0) theta', whose kinetic energy has
a constant mass: y'' = p2 (beta x(y) - v(y)), v and x the work of the weights and of the push by y over I_0 p2, which
are polynomials in pieces of y. A step is its Taylor series of order 8, cut at samples; impacts and turning points are
roots of the series.
"""

import numpy as np

from core.jit.decorators import inner_kernel, kernel, subkernel
from core.jit.fma import fma
from core.rocking.events import IMPACTS_PER_SAMPLE, apply_impact, next_uplift, uplift_thresholds
from core.rocking.outcome import COLLAPSED, IMPACT_LIMIT, STABLE
from core.rocking.side_functions import (
    POTENTIAL,
    Side,
    evaluate_side,
    invert_side,
    rotation_at,
    sides_of,
    to_rotations,
    to_y,
)
from core.rocking.side_series import landing, series, speed_of, step_of
from core.units import G
from core.wall.rocking_model import RockingModel


@subkernel
def outcome_by_energy(y, speed, p2, side, other, ratio, peaks, here):
    """Decide by energy what the wall does once the ground is still; returns the outcome.

    y, speed : y [rad] and y' [rad/s] then
    p2 : of the model [1/s2]
    side, other : Side it moves on, and the other one
    ratio : velocity ratio of its impacts [-]
    peaks : results, largest y of both, which grow with the free motion [rad], shape (2,)
    here : place of this side in them
    """
    energy = 0.5 * speed * speed / p2 + evaluate_side(POTENTIAL, y, side)
    if (speed >= 0.0 and energy > side.barrier) or (y > side.top and energy <= side.barrier):
        return COLLAPSED
    if speed > 0.0:
        peaks[here] = max(peaks[here], invert_side(POTENTIAL, energy, side.top, side))
    energy *= ratio * ratio
    if energy > other.barrier:
        return COLLAPSED
    peaks[1 - here] = max(peaks[1 - here], invert_side(POTENTIAL, energy, other.top, other))
    energy *= ratio * ratio
    if energy > side.barrier:
        return COLLAPSED
    peaks[here] = max(peaks[here], invert_side(POTENTIAL, energy, side.top, side))
    return STABLE


@inner_kernel
def land(y, terms, h, t, sign, instant, ground0, slope, dt, model, thresholds, impacts, impact_time, impact_velocity):
    """Carry the wall through the impact in which a step ends.

    y : at the start of the step [rad]
    terms, h : of `series`, and the length of the step [s]
    t : local time at its start [s]
    sign, instant, ground0, slope, dt, model, thresholds, impacts, impact_time, impact_velocity : of `through_sample`
    Returns (local time of the impact [s], y' after it [rad/s], sign, moving).
    """
    h = landing(y, terms, h)
    arriving = max(-speed_of(terms, h), 0.0)
    t = t + h if h < dt - t else dt
    now = fma(slope, t, ground0)
    speed, sign, moving, _, stuck = apply_impact(
        arriving, sign, now, model, thresholds, h, instant + t, impacts, impact_time, impact_velocity
    )
    return t + (1e-12 * dt if stuck else 0.0), speed, sign, moving


@subkernel
def first_state(start, peaks):
    """(y, speed, sign, moving) of `through_sample` at the first sample. start, peaks : of `integrate`"""
    sign = -1.0 if start[0] < 0.0 or (start[0] == 0.0 and start[1] < 0.0) else 1.0
    y, speed = sign * start[0], sign * start[1]
    peaks[:] = 0.0
    peaks[0 if sign > 0.0 else 1] = y
    return y, speed, sign, y != 0.0 or speed != 0.0


@subkernel
def through_sample(
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
    impact_time,
    impact_velocity,
    peaks,
):
    """Carry the wall through one sample, or until it has overturned.

    y, speed : at its start [rad], [rad/s], seen from the side it is on
    sign : of that side, 1.0 outward, -1.0 inward
    moving : False at rest
    impacts : so far
    instant : of its start [s]
    ground0, slope : ground acceleration then [m/s2] and its rate [m/s3]
    thresholds : of `uplift_thresholds` [m/s2]
    dt, model, outward, inward, impact_time, impact_velocity : of `integrate`
    peaks : largest y outward and inward so far, which grow [rad], shape (2,)
    Returns (y, speed, sign, moving, impacts, outcome).
    """
    p2, t, before = model.p2, 0.0, impacts
    while t < dt:
        if not moving:
            t, sign = next_uplift(ground0, slope, t, dt, thresholds)
            if t >= dt:
                break
            moving, y, speed = True, 0.0, 0.0
        side, k = (outward, 0) if sign > 0.0 else (inward, 1)
        beta, rate = sign / G * fma(slope, t, ground0), sign / G * slope
        terms, holds, s, per = series(y, speed, beta, rate, p2, side, dt - t)
        h, x, v, top, lands = step_of(y, speed, terms, holds, s, per, 1e-9 * dt)
        peaks[k] = max(peaks[k], top)
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
                model,
                thresholds,
                impacts,
                impact_time,
                impact_velocity,
            )
            y = 0.0
            impacts += 1
            if impacts - before > IMPACTS_PER_SAMPLE:
                return y, speed, sign, moving, impacts, IMPACT_LIMIT
            continue
        t = t + h if h < dt - t else dt
        y, speed = x, v
        if y > side.end:
            return y, speed, sign, moving, impacts, COLLAPSED
    return y, speed, sign, moving, impacts, STABLE


@subkernel
def outcome_after_record(y, speed, sign, moving, model, outward, inward, peaks):
    """`outcome_by_energy` of a wall that may rest already.

    y, speed, sign, moving : of `through_sample`, at the end of the record
    model, outward, inward : of `integrate`
    peaks : largest y outward and inward, which grow with the free motion [rad], shape (2,)
    """
    if not moving:
        return STABLE
    if sign > 0.0:
        return outcome_by_energy(y, speed, model.p2, outward, inward, model.ratio_at_rest, peaks, 0)
    return outcome_by_energy(y, speed, model.p2, inward, outward, model.ratio_at_rest, peaks, 1)


@kernel
def integrate(
    ground, dt, scale, model, outward, inward, start, rotation, velocity, impact_time, impact_velocity, peaks
):
    """Integrate one history as `taylor.integrate` does.

    ground : ground acceleration [m/s2], shape (n,)
    dt : its time step [s]
    scale : multiplier [-], negative for the reversed record
    model : RockingModel, without `bending`
    outward, inward : Side
    start : y [rad] and y' [rad/s] at the first sample, outward positive
    rotation : results, y at the samples, inward negative [rad], shape (n,)
    velocity : results, y' at the samples [rad/s], of the same shape
    impact_time : results [s], up to its size
    impact_velocity : results, y' just after each impact [rad/s], of the same shape
    peaks : results, largest y outward and inward [rad], shape (2,)
    Returns (outcome, impacts, samples done).
    """
    thresholds = uplift_thresholds(model)
    y, speed, sign, moving = first_state(start, peaks)
    impacts = 0
    rotation[0], velocity[0] = start
    for i in range(ground.size - 1):
        ground0, slope = scale * ground[i], scale * (ground[i + 1] - ground[i]) / dt
        y, speed, sign, moving, impacts, outcome = through_sample(
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
            impact_time,
            impact_velocity,
            peaks,
        )
        if outcome != STABLE:
            return outcome, impacts, i + 1
        rotation[i + 1] = sign * y if moving else 0.0
        velocity[i + 1] = sign * speed if moving else 0.0
    return outcome_after_record(y, speed, sign, moving, model, outward, inward, peaks), impacts, ground.size


@kernel
def fill_energy(rotation, velocity, p2, outward, inward, ratios):
    """Energy over that at collapse on its side. rotation [rad], velocity [rad/s], ratios : results [-], shape (n,)"""
    for i in range(rotation.size):
        side, sign = (outward, 1.0) if rotation[i] >= 0.0 else (inward, -1.0)
        y, speed = to_y(sign * rotation[i], sign * velocity[i], side)
        ratios[i] = (0.5 * speed * speed / p2 + evaluate_side(POTENTIAL, y, side)) / side.barrier


def energy_ratios(rotation: np.ndarray, velocity: np.ndarray, model: RockingModel) -> np.ndarray:
    """The ratios of core/rocking/energy.py for a wall held at its top."""
    bare, outward, inward = split_model(model)
    ratios = np.zeros(rotation.size)
    fill_energy(rotation, velocity, bare.p2, outward, inward, ratios)
    return ratios


def split_model(model: RockingModel) -> tuple[RockingModel, Side, Side]:
    """The model as the kernels take it, and its sides."""
    assert model.bending is not None
    alpha = model.slenderness
    collapse = alpha + model.restoring.lean, alpha + model.mirrored.lean
    return model._replace(bending=None), *sides_of(model.bending, alpha, collapse)


def history(ground, dt, scale, model, start, trace, impact_time, impact_velocity) -> tuple[int, float, int, int, int]:
    """One history in full, in theta; returns as `taylor.integrate` does.

    ground : ground acceleration [m/s2], shape (n,)
    dt : its time step [s]
    scale : multiplier [-], negative for the reversed record
    model : RockingModel with `bending`
    start : theta [rad] and theta' [rad/s] at the first sample
    trace : results, theta and theta' at the samples, shape (2, n)
    impact_time : results [s], up to its size
    impact_velocity : results, theta' just after each impact [rad/s], of the same shape
    """
    bare, outward, inward = split_model(model)
    peaks = np.zeros(2)
    parts = bare, outward, inward, start_on_side(start, outward, inward), trace[0], trace[1]
    outcome, impacts, done = integrate(ground, dt, scale, *parts, impact_time, impact_velocity, peaks)
    return outcome, turn_results(trace, impact_velocity, peaks, outward, inward), impacts, 0, done


def start_on_side(start: tuple[float, float], outward: Side, inward: Side) -> tuple[float, float]:
    """y [rad] and y' [rad/s] of theta [rad] and theta' [rad/s] at the first sample, outward positive."""
    sign = -1.0 if start[0] < 0.0 or (start[0] == 0.0 and start[1] < 0.0) else 1.0
    y, speed = to_y(sign * start[0], sign * start[1], outward if sign > 0.0 else inward)
    return sign * y, sign * speed


def turn_results(
    trace: np.ndarray, impact_velocity: np.ndarray, peaks: np.ndarray, outward: Side, inward: Side
) -> float:
    """Turn the results of a history from y into theta, in place; returns the largest theta [rad].

    trace : y [rad] and y' [rad/s] first, shape (2 or more, n); impact_velocity : y' just after each impact [rad/s]
    peaks : largest y outward and inward [rad]
    """
    to_rotations(trace[0], trace[1], outward, inward)
    to_rotations(np.zeros(impact_velocity.size), impact_velocity, outward, inward)
    return max(float(rotation_at(peaks[0], outward)), float(rotation_at(peaks[1], inward)))
