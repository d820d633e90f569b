"""Histories of a wall held at its top, by its own equation (resources/docs/physics.md, section 19).

The one degree of freedom is followed in the coordinate y with y' = sqrt(I(theta)/I_0) theta', whose kinetic energy has
a constant mass: y'' = p2 (beta x(y) - v(y)), v and x the work of the weights and of the push by y over I_0 p2, which
are polynomials in pieces of y. A step is its Taylor series of order 8, cut at samples; impacts and turning points are
roots of the series.
"""

import numpy as np

from core.jit.decorators import kernel, subkernel
from core.rocking.events import IMPACTS_PER_SAMPLE, land, next_uplift, uplift_thresholds
from core.rocking.grounds import Grounds
from core.rocking.outcome import COLLAPSED, IMPACT_LIMIT, STABLE
from core.rocking.side_functions import (
    POTENTIAL,
    Side,
    rotation_at,
    sides_of,
    to_rotations,
    to_y,
    turned_by,
    value,
    y_where,
)
from core.rocking.side_series import landing, series, speed_of, step_of
from core.units import G
from core.wall.rocking_model import RockingModel

NONE = np.empty(0)
"""Histories nobody wants."""


@subkernel
def at_rest_again(y, speed, p2, side, other, ratio, peaks, here):
    """Decide by energy what the wall does once the ground is still; returns the outcome.

    y, speed : y [rad] and y' [rad/s] then
    p2 : of the model [1/s2]
    side, other : Side it moves on, and the other one
    ratio : velocity ratio of its impacts [-]
    peaks : results, largest y of both, which grow with the free motion [rad], shape (2,)
    here : place of this side in them
    """
    energy = 0.5 * speed * speed / p2 + value(POTENTIAL, y, side)
    if (speed >= 0.0 and energy > side.barrier) or (y > side.top and energy <= side.barrier):
        return COLLAPSED
    if speed > 0.0:
        peaks[here] = max(peaks[here], y_where(POTENTIAL, energy, side.top, side))
    energy *= ratio * ratio
    if energy > other.barrier:
        return COLLAPSED
    peaks[1 - here] = max(peaks[1 - here], y_where(POTENTIAL, energy, other.top, other))
    energy *= ratio * ratio
    if energy > side.barrier:
        return COLLAPSED
    peaks[here] = max(peaks[here], y_where(POTENTIAL, energy, side.top, side))
    return STABLE


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
    rotation : results, y at the samples, inward negative [rad], shape (n,), or (0,) where nobody wants them
    velocity : results, y' at the samples [rad/s], of the same shape
    impact_time : results [s], up to its size
    impact_velocity : results, y' just after each impact [rad/s], of the same shape
    peaks : results, largest y outward and inward [rad], shape (2,)
    Returns (outcome, impacts, samples done).
    """
    thresholds, p2 = uplift_thresholds(model), model.p2
    peaks[:] = 0.0
    sign = -1.0 if start[0] < 0.0 or (start[0] == 0.0 and start[1] < 0.0) else 1.0
    y, speed = sign * start[0], sign * start[1]
    moving, impacts = y != 0.0 or speed != 0.0, 0
    peaks[0 if sign > 0.0 else 1] = y
    if rotation.size:
        rotation[0], velocity[0] = start
    for i in range(ground.size - 1):
        ground0, slope = scale * ground[i], scale * (ground[i + 1] - ground[i]) / dt
        t, impacts_before = 0.0, impacts
        while t < dt:
            if not moving:
                t, sign = next_uplift(ground0, slope, t, dt, thresholds)
                if t >= dt:
                    break
                moving, y, speed = True, 0.0, 0.0
            side, k = (outward, 0) if sign > 0.0 else (inward, 1)
            beta, rate = sign / G * (ground0 + slope * t), sign / G * slope
            terms, holds, s, per = series(y, speed, beta, rate, p2, side)
            h, x, v, top, lands = step_of(y, speed, terms, min(holds, dt - t), s, per, 1e-9 * dt)
            peaks[k] = max(peaks[k], top)
            if lands:
                h = landing(y, terms, h)
                arriving = max(-speed_of(terms, h), 0.0)
                t = t + h if h < dt - t else dt
                y, now = 0.0, ground0 + slope * t
                speed, sign, moving, _, stuck = land(
                    arriving, sign, now, model, thresholds, h, i * dt + t, impacts, impact_time, impact_velocity
                )
                t += 1e-12 * dt if stuck else 0.0
                impacts += 1
                if impacts - impacts_before > IMPACTS_PER_SAMPLE:
                    return IMPACT_LIMIT, impacts, i + 1
                continue
            t = t + h if h < dt - t else dt
            y, speed = x, v
            if y > side.end:
                return COLLAPSED, impacts, i + 1
        if rotation.size:
            rotation[i + 1] = sign * y if moving else 0.0
            velocity[i + 1] = sign * speed if moving else 0.0
    outcome = STABLE
    if moving:
        ratio = model.ratio_at_rest
        if sign > 0.0:
            outcome = at_rest_again(y, speed, p2, outward, inward, ratio, peaks, 0)
        else:
            outcome = at_rest_again(y, speed, p2, inward, outward, ratio, peaks, 1)
    return outcome, impacts, ground.size


@kernel
def fill_energy(rotation, velocity, p2, outward, inward, ratios):
    """Energy over that at collapse on its side. rotation [rad], velocity [rad/s], ratios : results [-], shape (n,)"""
    for i in range(rotation.size):
        side, sign = (outward, 1.0) if rotation[i] >= 0.0 else (inward, -1.0)
        y, speed = to_y(sign * rotation[i], sign * velocity[i], side)
        ratios[i] = (0.5 * speed * speed / p2 + value(POTENTIAL, y, side)) / side.barrier


def energy_ratios(rotation: np.ndarray, velocity: np.ndarray, model: RockingModel) -> np.ndarray:
    """The ratios of core/rocking/energy.py for a wall held at its top."""
    bare, outward, inward = _parts(model)
    ratios = np.zeros(rotation.size)
    fill_energy(rotation, velocity, bare.p2, outward, inward, ratios)
    return ratios


@kernel
def scan_record(ground, dt, scales, model, outward, inward, outcomes, peaks, none, both):
    """`history.scan` of a wall held at its top; peaks are those of theta [rad].

    ground : ground acceleration [m/s2], shape (n,)
    dt : its time step [s]
    scales : multipliers [-], shape (m,)
    model : RockingModel, without `bending`
    outward, inward : Side
    outcomes : results, codes of outcome.py, int64, shape (m,)
    peaks : results [rad], shape (m,)
    none : in place of the histories, which nobody wants, shape (0,)
    both : room for the peaks of both sides, shape (2,)
    """
    for j in range(scales.size):
        outcomes[j], _, _ = integrate(
            ground, dt, scales[j], model, outward, inward, (0.0, 0.0), none, none, none, none, both
        )
        peaks[j] = max(turned_by(both[0], outward), turned_by(both[1], inward))


def _parts(model: RockingModel) -> tuple[RockingModel, Side, Side]:
    """The model as the kernels take it, and its sides."""
    assert model.bending is not None
    alpha = model.slenderness
    collapse = alpha + model.restoring.lean, alpha + model.mirrored.lean
    return model._replace(bending=None), *sides_of(model.bending, alpha, collapse)


def scan(grounds: Grounds, which, scales, model, outcomes, peaks) -> np.ndarray:
    """`history.scan_records` of a wall held at its top; no velocity ratio is ever clamped."""
    bare, outward, inward = _parts(model)
    for k in np.unique(which):
        here = np.nonzero(which == k)[0]
        codes, reached = outcomes[here], peaks[here]
        ground = grounds.ground[grounds.first[k] : grounds.last[k] + 1]
        scan_record(ground, grounds.dt, scales[here], bare, outward, inward, codes, reached, NONE, np.zeros(2))
        outcomes[here], peaks[here] = codes, reached
    return np.zeros(scales.size, np.int64)


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
    bare, outward, inward = _parts(model)
    sign = -1.0 if start[0] < 0.0 or (start[0] == 0.0 and start[1] < 0.0) else 1.0
    y, speed = to_y(sign * start[0], sign * start[1], outward if sign > 0.0 else inward)
    begin = (sign * y, sign * speed)
    parts = bare, outward, inward, begin, trace[0], trace[1], impact_time, impact_velocity
    peaks = np.zeros(2)
    outcome, impacts, done = integrate(ground, dt, scale, *parts, peaks)
    to_rotations(trace[0], trace[1], outward, inward)
    to_rotations(np.zeros(impact_velocity.size), impact_velocity, outward, inward)
    peak = max(float(rotation_at(peaks[0], outward)), float(rotation_at(peaks[1], inward)))
    return outcome, peak, impacts, 0, done
