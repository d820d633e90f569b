"""Histories of a wall held at its top, by its own equation (resources/docs/physics.md, section 24).

The one degree of freedom is followed in the coordinate y with y' = sqrt(I(theta)/I_0) theta', whose kinetic energy has
a constant mass: y'' = p2 (beta x(y) - v(y)), v and x the work of the weights and of the push by y over I_0 p2, which
are polynomials in pieces of y. A step is its Taylor series of order 8, cut at samples; impacts and turning points are
roots of the series.
"""

import functools
import math
from typing import NamedTuple

import numpy as np

from core.jit.decorators import kernel, subkernel
from core.rocking.events import IMPACTS_PER_SAMPLE, leave_impact, next_uplift, uplift_thresholds
from core.rocking.grounds import Grounds
from core.rocking.outcome import COLLAPSED, IMPACT_LIMIT, STABLE
from core.units import G
from core.wall.bending import HeldTop, Motion, near_rest
from core.wall.rocking_model import RockingModel

TOLERANCE = 1e-14
"""Largest last term of a step, over y of collapse [-]."""

BEYOND, SHORT_OF = 2.5, 0.8
"""The motion is followed to so many times the rotation of collapse, at most to this share of the way to where the
upper block no longer reaches what holds it: beyond it the wall has overturned."""

PIECES, DEGREE, OVERLAP = 32, 7, 1.5
"""Pieces of the functions of y, the degree of each, and how far it holds over its half width: to 1e-13 of their size
(tests/core/rocking/test_held_top.py)."""

SPECTRAL = 96
"""Degree of the series by which y, its inverse and the potential are made."""

NEAREST, TINIEST = 1e-15, 1e-300
"""Share of a step to which an event is located, and in place of zero where it is divided by."""


class Side(NamedTuple):
    """Functions of y to one side.

    scale : pieces in a unit of y [-]; end : y at which the wall has overturned, top : y of collapse [rad]
    barrier : potential at `top` [-]
    values : polynomials of v, x, the potential and theta in each piece, in -1 to 1, shape (PIECES, 4, DEGREE + 1)
    """

    scale: float
    end: float
    top: float
    barrier: float
    values: np.ndarray


V, X, POTENTIAL, THETA = range(4)
"""The functions of `Side.values`."""

NONE = np.empty(0)
"""Histories nobody wants."""


@functools.lru_cache(maxsize=64)
def sides_of(held: HeldTop, slenderness: float, collapse: tuple[float, float]) -> tuple[Side, Side]:
    """The functions outward and inward. slenderness : alpha of the model; collapse : theta_c of both sides [rad]"""
    first = held.side(1.0)
    inertia, (p2, _, _) = float(first.parts(np.zeros(1))[0][0]), near_rest(first, slenderness)
    return side_of(first, inertia, p2, collapse[0]), side_of(held.side(-1.0), inertia, p2, collapse[1])


def side_of(motion: Motion, inertia: float, p2: float, collapse: float) -> Side:
    """The functions of one side. inertia : I_0 [kg m]; collapse : theta_c [rad]"""
    cheb = np.polynomial.chebyshev.Chebyshev
    last = min(BEYOND * collapse, collapse + SHORT_OF * (motion.last - collapse))
    domain = [-last / PIECES, last]  # the first piece overlaps rest
    rate = cheb.interpolate(lambda theta: np.sqrt(motion.parts(theta)[0] / inertia), SPECTRAL, domain)
    work = cheb.interpolate(lambda theta: motion.parts(theta)[1] / (inertia * p2), SPECTRAL, domain)
    y_of, stored = rate.integ(lbnd=0.0), work.integ(lbnd=0.0)
    end = float(y_of(last)) * PIECES / (PIECES + OVERLAP)  # the last piece overlaps it
    nodes = OVERLAP * np.cos(math.pi * (np.arange(DEGREE + 1) + 0.5) / (DEGREE + 1))
    y = ((np.arange(PIECES)[:, None] + 0.5 * (1.0 + nodes)) * (end / PIECES)).ravel()
    theta = y * (last / end)
    for _ in range(50):
        step = (y_of(theta) - y) / rate(theta)
        theta = theta - step
        if np.abs(step).max() < 1e-15:
            break
    inertias, risen, moved = motion.parts(theta)
    slope = np.sqrt(inertias / inertia) * inertia * p2
    at_nodes = np.stack([risen / slope, moved / slope, stored(theta), theta], axis=1).reshape(PIECES, DEGREE + 1, 4)
    values = np.linalg.solve(np.vander(nodes, increasing=True), at_nodes)
    top = float(y_of(collapse))
    return Side(PIECES / end, end, top, float(stored(collapse)), np.ascontiguousarray(values.transpose(0, 2, 1)))


@subkernel
def value(which, y, side):
    """One of the functions of y, continued beyond its ends. which : V, X, POTENTIAL or THETA; side : Side"""
    at = y * side.scale
    piece = min(max(int(at), 0), PIECES - 1)
    s, found = 2.0 * (at - piece) - 1.0, 0.0
    for k in range(DEGREE, -1, -1):
        found = found * s + side.values[piece, which, k]
    return found


@subkernel
def series(y, speed, beta, slope, p2, side):
    """Coefficients 1 to 8 of y as a power series in time, and the time [s] up to which it holds.

    y, speed : at its start [rad], [rad/s]
    beta : u''/g then, seen from this side [-]
    slope : its rate [1/s]
    side : Side
    """
    at = y * side.scale
    piece = min(max(int(at), 0), PIECES - 1)
    s, per = 2.0 * (at - piece) - 1.0, 2.0 * side.scale
    v0 = v1 = v2 = v3 = v4 = v5 = v6 = 0.0
    x0 = x1 = x2 = x3 = x4 = x5 = x6 = 0.0
    for k in range(DEGREE, -1, -1):  # both functions about s
        v6 = v6 * s + v5
        v5 = v5 * s + v4
        v4 = v4 * s + v3
        v3 = v3 * s + v2
        v2 = v2 * s + v1
        v1 = v1 * s + v0
        v0 = v0 * s + side.values[piece, V, k]
        x6 = x6 * s + x5
        x5 = x5 * s + x4
        x4 = x4 * s + x3
        x3 = x3 * s + x2
        x2 = x2 * s + x1
        x1 = x1 * s + x0
        x0 = x0 * s + side.values[piece, X, k]
    rate = per * p2
    s1 = per * speed
    s2 = 0.5 * rate * (beta * x0 - v0)
    g1 = x1 * s1
    s3 = rate / 6.0 * (beta * g1 + slope * x0 - v1 * s1)
    q2 = s1 * s1
    g2 = x1 * s2 + x2 * q2
    s4 = rate / 12.0 * (beta * g2 + slope * g1 - v1 * s2 - v2 * q2)
    q3, r3 = 2.0 * s1 * s2, s1 * q2
    g3 = x1 * s3 + x2 * q3 + x3 * r3
    s5 = rate / 20.0 * (beta * g3 + slope * g2 - v1 * s3 - v2 * q3 - v3 * r3)
    q4, r4, w4 = 2.0 * s1 * s3 + s2 * s2, s1 * q3 + s2 * q2, s1 * r3
    g4 = x1 * s4 + x2 * q4 + x3 * r4 + x4 * w4
    s6 = rate / 30.0 * (beta * g4 + slope * g3 - v1 * s4 - v2 * q4 - v3 * r4 - v4 * w4)
    q5, r5 = 2.0 * (s1 * s4 + s2 * s3), s1 * q4 + s2 * q3 + s3 * q2
    w5, z5 = s1 * r4 + s2 * r3, s1 * w4
    g5 = x1 * s5 + x2 * q5 + x3 * r5 + x4 * w5 + x5 * z5
    s7 = rate / 42.0 * (beta * g5 + slope * g4 - v1 * s5 - v2 * q5 - v3 * r5 - v4 * w5 - v5 * z5)
    q6, r6 = 2.0 * (s1 * s5 + s2 * s4) + s3 * s3, s1 * q5 + s2 * q4 + s3 * q3 + s4 * q2
    w6, z6 = s1 * r5 + s2 * r4 + s3 * r3, s1 * w5 + s2 * w4
    g6 = x1 * s6 + x2 * q6 + x3 * r6 + x4 * w6 + x5 * z6 + x6 * s1 * z5
    s8 = rate / 56.0 * (beta * g6 + slope * g5 - v1 * s6 - v2 * q6 - v3 * r6 - v4 * w6 - v5 * z6 - v6 * s1 * z5)
    holds = (TOLERANCE * per * side.top / max(abs(s8), TINIEST)) ** 0.125
    terms = (s1 / per, s2 / per, s3 / per, s4 / per, s5 / per, s6 / per, s7 / per, s8 / per)
    return terms, holds, s, per


@subkernel
def moved(terms, t):
    """What a series adds to y after a time [s]."""
    a, b, c, d, e, f, g, h = terms
    return t * (a + t * (b + t * (c + t * (d + t * (e + t * (f + t * (g + t * h)))))))


@subkernel
def speed_of(terms, t):
    """y' of a series after a time [s]."""
    a, b, c, d, e, f, g, h = terms
    high = 5.0 * e + t * (6.0 * f + t * (7.0 * g + t * 8.0 * h))
    return a + t * (2.0 * b + t * (3.0 * c + t * (4.0 * d + t * high)))


@subkernel
def push_of(terms, t):
    """y'' of a series after a time [s]."""
    _, b, c, d, e, f, g, h = terms
    return 2.0 * b + t * (6.0 * c + t * (12.0 * d + t * (20.0 * e + t * (30.0 * f + t * (42.0 * g + t * 56.0 * h)))))


@subkernel
def slowest(terms, h):
    """Time [s] at which y'' passes through zero, between 0 and h, at whose ends its signs differ."""
    low, high, falls = 0.0, h, push_of(terms, 0.0) < 0.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        if (push_of(terms, middle) < 0.0) == falls:
            low = middle
        else:
            high = middle
    return high


@subkernel
def turning(terms, h):
    """Time [s] at which y' passes through zero, between 0 and h, at whose ends its signs differ."""
    low, high, falls = 0.0, h, terms[0] < 0.0
    time = 0.5 * h
    for _ in range(100):
        v = speed_of(terms, time)
        if (v < 0.0) == falls:
            low = time
        else:
            high = time
        rate = push_of(terms, time)
        following = time - v / rate if rate != 0.0 else 0.5 * (low + high)
        if not low < following < high:
            following = 0.5 * (low + high)
        if abs(following - time) <= NEAREST * h or high - low <= NEAREST * h:
            break
        time = following
    return time


@subkernel
def landing(y, terms, h):
    """Time [s] at which y falls to zero within h, where it is not above zero; 0.0 for a start at zero that only
    falls."""
    low, high = 0.0, h
    if y == 0.0:
        low = h
        for _ in range(60):
            low *= 0.5
            if moved(terms, low) > 0.0:
                break
            high = low
        else:
            return 0.0
    time = 0.5 * (low + high)
    for _ in range(100):
        x = y + moved(terms, time)
        if x > 0.0:
            low = time
        else:
            high = time
        v = speed_of(terms, time)
        following = time - x / v if v != 0.0 else 0.5 * (low + high)
        if not low < following < high:
            following = 0.5 * (low + high)
        if abs(following - time) <= NEAREST * h or high - low <= NEAREST * h:
            break
        time = following
    return time


@subkernel
def step_of(y, speed, terms, h, s, per, least):
    """One step by its series: length [s], y and y' after it, largest y in it [rad], and whether the wall lands in it.

    y, speed : at its start [rad], [rad/s]
    terms : of `series`
    h : longest it may be [s]
    s, per : place in the piece, of `series`, which the step does not leave
    least : shortest it is cut to for that [s]
    """
    while abs(s + per * moved(terms, h)) > OVERLAP and h > least:
        h *= 0.5
    v = speed_of(terms, h)
    slows = (terms[1] > 0.0) == (speed < 0.0) and (push_of(terms, h) > 0.0) != (terms[1] > 0.0)
    if slows and speed != 0.0 and (v < 0.0) == (speed < 0.0):  # it may turn twice
        slow = slowest(terms, h)
        if (speed_of(terms, slow) < 0.0) != (speed < 0.0):
            h, v = slow, speed_of(terms, slow)
    x = y + moved(terms, h)
    top = max(x, 0.0)
    if speed < 0.0 < v or v < 0.0 < speed:
        turn = turning(terms, h)
        reached = y + moved(terms, turn)
        if speed > 0.0:
            top = max(top, reached)
        elif reached < 0.0:
            h, x = turn, reached
    return h, x, v, top, x < 0.0 or (x == 0.0 and v < 0.0)


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
        peaks[here] = max(peaks[here], y_at(energy, side))
    energy *= ratio * ratio
    if energy > other.barrier:
        return COLLAPSED
    peaks[1 - here] = max(peaks[1 - here], y_at(energy, other))
    energy *= ratio * ratio
    if energy > side.barrier:
        return COLLAPSED
    peaks[here] = max(peaks[here], y_at(energy, side))
    return STABLE


@subkernel
def y_at(stored, side):
    """y in [0, top] at which the potential reaches `stored`, below the barrier [rad]."""
    low, high = 0.0, side.top
    for _ in range(60):
        middle = 0.5 * (low + high)
        if value(POTENTIAL, middle, side) < stored:
            low = middle
        else:
            high = middle
    return high


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
                speed, left, sign, moving, _ = leave_impact(arriving, sign, ground0 + slope * t, model, thresholds)
                y = 0.0
                if impacts < impact_time.size:
                    impact_time[impacts] = i * dt + t
                    impact_velocity[impacts] = left * speed
                if arriving == 0.0 and h == 0.0:
                    # pushed back by the rounding of the threshold: no hop, and time must go on
                    moving = False
                    t += 1e-12 * dt
                if not moving:
                    speed = 0.0
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


@subkernel
def slope(which, y, side):
    """The derivative of `value` by y."""
    at = y * side.scale
    piece = min(max(int(at), 0), PIECES - 1)
    s, found = 2.0 * (at - piece) - 1.0, 0.0
    for k in range(DEGREE, 0, -1):
        found = found * s + k * side.values[piece, which, k]
    return 2.0 * side.scale * found


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


@subkernel
def turned_by(y, side):
    """theta [rad] at y, zero exactly at rest."""
    return max(value(THETA, y, side), 0.0) if y > 0.0 else 0.0


@kernel
def to_rotations(y, rate, outward, inward):
    """Turn y [rad] and y' [rad/s] into theta and theta' in place, shape (n,). outward, inward : Side"""
    for i in range(y.size):
        side, sign = (outward, 1.0) if y[i] >= 0.0 else (inward, -1.0)
        rate[i] *= slope(THETA, sign * y[i], side)
        y[i] = sign * turned_by(sign * y[i], side)


@kernel
def to_y(theta, speed, side):
    """y [rad] and y' [rad/s] of a rotation to this side, by bisection. speed : theta' [rad/s]; side : Side"""
    low, high = 0.0, side.end
    for _ in range(80):
        middle = 0.5 * (low + high)
        if value(THETA, middle, side) < theta:
            low = middle
        else:
            high = middle
    return high if theta > 0.0 else 0.0, speed / slope(THETA, high if theta > 0.0 else 0.0, side)


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


@kernel
def rotation_at(y, side):
    """theta [rad] at y; side : Side"""
    return turned_by(y, side)
