"""Histories of a wall held at its top, by its own equation (resources/docs/physics.md, section 24).

The one degree of freedom is followed in the coordinate y with y' = sqrt(I(theta)/I_0) theta', whose kinetic energy has
a constant mass: y'' = p2 (beta x(y) - v(y)), v and x the work of the weights and of the push by y over I_0 p2. The
steps are those of Dormand and Prince, cut at samples; uplift, impacts and turning points are located on the step
itself.
"""

import functools
import math
from typing import NamedTuple

import numpy as np

from core.jit.decorators import kernel, subkernel
from core.rocking.compared.dormand_prince import STAGES, tableau
from core.rocking.events import IMPACTS_PER_SAMPLE, leave_impact, next_uplift, uplift_thresholds
from core.rocking.grounds import Grounds
from core.rocking.outcome import COLLAPSED, IMPACT_LIMIT, STABLE
from core.units import G
from core.wall.bending import HeldTop, Motion, near_rest
from core.wall.rocking_model import RockingModel

TOLERANCE = 1e-13
"""Largest error of a step, of y over that of collapse [-]."""

BEYOND, SHORT_OF = 2.5, 0.8
"""The motion is followed to so many times the rotation of collapse, at most to this share of the way to where the
upper block no longer reaches what holds it: beyond it the wall has overturned."""

PIECES, DEGREE = 64, 7
"""Pieces of the functions of y, and the degree of each: 1e-12 of their size (tests/core/rocking/test_held_top.py)."""

SPECTRAL = 96
"""Degree of the series by which y, its inverse and the potential are made."""

FINEST = 2.0**-12
"""Share of a sample down to which it is cut where the wall may turn twice in it."""


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

NONE, ROOM = np.empty(0), np.zeros(2 * STAGES)
"""Histories nobody wants, and room for the stages of a step."""


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
    domain = [0.0, last]
    rate = cheb.interpolate(lambda theta: np.sqrt(motion.parts(theta)[0] / inertia), SPECTRAL, domain)
    work = cheb.interpolate(lambda theta: motion.parts(theta)[1] / (inertia * p2), SPECTRAL, domain)
    y_of, stored = rate.integ(lbnd=0.0), work.integ(lbnd=0.0)
    end = float(y_of(last))
    nodes = np.cos(math.pi * (np.arange(DEGREE + 1) + 0.5) / (DEGREE + 1))
    y = ((np.arange(PIECES)[:, None] + 0.5 * (1.0 + nodes)) * (end / PIECES)).ravel()
    theta = y * (last / end)
    for _ in range(50):
        step = (y_of(theta) - y) / rate(theta)
        theta = np.clip(theta - step, 0.0, last)
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
def acceleration(y, beta, p2, side):
    """y'' [rad/s2] at y under u''/g = beta seen from this side."""
    at = y * side.scale
    piece = min(max(int(at), 0), PIECES - 1)
    s, held, push = 2.0 * (at - piece) - 1.0, 0.0, 0.0
    for k in range(DEGREE, -1, -1):
        held = held * s + side.values[piece, V, k]
        push = push * s + side.values[piece, X, k]
    return p2 * (beta * push - held)


@subkernel
def advance(y, speed, beta, slope, h, p2, side, table, rates, pushes):
    """y [rad] and y' [rad/s] after h, in as many steps as the tolerance asks.

    beta : u''/g at the start, seen from this side [-]
    slope : rate of beta [1/s]
    h : time to go [s]
    side : Side
    table : of `tableau` [-], shape (16 * STAGES,)
    rates : room for the velocities of the stages [rad/s], shape (STAGES,)
    pushes : room for their accelerations [rad/s2], shape (STAGES,)
    """
    done, step, p = 0.0, h, math.sqrt(p2)
    for _ in range(100_000):
        step = min(step, h - done)
        for i in range(STAGES):
            x, v = y, speed
            for j in range(i):
                x += step * table[i * STAGES + j] * rates[j]
                v += step * table[i * STAGES + j] * pushes[j]
            rates[i] = v
            pushes[i] = acceleration(x, beta + (done + step * table[13 * STAGES + i]) * slope, p2, side)
        x, v, fifth, third = y, speed, 0.0, 0.0
        for which in range(2):
            part, five, three = 0.0, 0.0, 0.0
            for i in range(STAGES):
                stage = rates[i] if which == 0 else pushes[i] / p
                part += table[12 * STAGES + i] * stage
                five += table[14 * STAGES + i] * stage
                three += table[15 * STAGES + i] * stage
            x += step * part if which == 0 else 0.0
            v += step * part * p if which == 1 else 0.0
            fifth += five * five
            third += three * three
        total = fifth + 0.01 * third
        error = step * fifth / math.sqrt(total) / side.top if total > 0.0 else 0.0
        if error <= TOLERANCE or step < 1e-6 * h:
            y, speed = x, v
            if step >= h - done:
                break
            done += step
            step *= 3.0
        else:
            step *= max(0.2, 0.9 * (TOLERANCE / error) ** 0.125)
    return y, speed


@subkernel
def turning(y, speed, beta, slope, h, p2, side, table, rates, pushes):
    """Time [s] at which y' passes through zero, between 0 and h, at whose ends its signs differ; as `advance`."""
    low, high, time = 0.0, h, 0.5 * h
    for _ in range(100):
        x, v = advance(y, speed, beta, slope, time, p2, side, table, rates, pushes)
        if v == 0.0:
            break
        if (v < 0.0) == (speed < 0.0):
            low = time
        else:
            high = time
        rate = acceleration(x, beta + slope * time, p2, side)
        following = time - v / rate if rate != 0.0 else 0.5 * (low + high)
        if not (low < following < high):
            following = 0.5 * (low + high)
        if abs(following - time) <= 1e-15 * h or following in (low, high):
            break
        time = following
    return time


@subkernel
def crossing(y, speed, beta, slope, h, p2, side, table, rates, pushes, level, sign):
    """Time [s] at which sign * (y - level) falls to zero, between 0 and h, where it is negative; 0.0 for a start on
    the level that only falls. As `advance`."""
    low, high = 0.0, h
    if y == level:
        low = h
        for _ in range(60):
            low *= 0.5
            x, _ = advance(y, speed, beta, slope, low, p2, side, table, rates, pushes)
            if sign * (x - level) > 0.0:
                break
            high = low
        else:
            return 0.0
    time = 0.5 * (low + high)
    for _ in range(100):
        x, v = advance(y, speed, beta, slope, time, p2, side, table, rates, pushes)
        if x == level:
            break
        if sign * (x - level) > 0.0:
            low = time
        else:
            high = time
        following = time - (x - level) / v if v != 0.0 else 0.5 * (low + high)
        if not (low < following < high):
            following = 0.5 * (low + high)
        if following == time or following in (low, high):
            break
        time = following
    return time


@subkernel
def at_rest_again(y, speed, p2, side, other, ratio, peaks, here):
    """Decide by energy what the wall does once the ground is still. side, other : Side it moves on and the other one;
    peaks : largest y of both, which grow with the free motion, shape (2,); here : place of this side. Returns the
    outcome."""
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
    ground, dt, scale, model, outward, inward, start, rotation, velocity, impact_time, impact_velocity, table, peaks
):
    """Integrate one history as `taylor.integrate` does.

    Length: one loop over samples and their events, which change the same state.

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
    table : of `tableau` with room for 2 STAGES [-]
    peaks : results, largest y outward and inward [rad], shape (2,)
    Returns (outcome, impacts, samples done).
    """
    rates, pushes = table[16 * STAGES : 17 * STAGES], table[17 * STAGES :]
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
        t, impacts_before, cut = 0.0, impacts, 1.0
        while t < dt:
            if not moving:
                t, sign = next_uplift(ground0, slope, t, dt, thresholds)
                if t >= dt:
                    break
                moving, y, speed = True, 0.0, 0.0
            side, k = (outward, 0) if sign > 0.0 else (inward, 1)
            beta, rate = sign / G * (ground0 + slope * t), sign / G * slope
            h = min(cut * dt, dt - t)
            x, v = advance(y, speed, beta, rate, h, p2, side, table, rates, pushes)
            before = acceleration(y, beta, p2, side)
            after = acceleration(x, beta + rate * h, p2, side)
            may_turn_twice = (before > 0.0) == (speed < 0.0) and (after > 0.0) != (before > 0.0)
            if may_turn_twice and (speed < 0.0) == (v < 0.0) and h > FINEST * dt:
                cut = 0.5 * h / dt
                continue
            lowest = x
            if speed < 0.0 < v or v < 0.0 < speed:
                turn = turning(y, speed, beta, rate, h, p2, side, table, rates, pushes)
                reached, _ = advance(y, speed, beta, rate, turn, p2, side, table, rates, pushes)
                if speed < 0.0:
                    lowest = min(lowest, reached)
                    if reached <= 0.0:
                        h = turn
                else:
                    peaks[k] = max(peaks[k], reached)
            cut = 1.0
            if lowest < 0.0 or (x == 0.0 and v < 0.0):
                h = crossing(y, speed, beta, rate, h, p2, side, table, rates, pushes, 0.0, 1.0)
                _, v = advance(y, speed, beta, rate, h, p2, side, table, rates, pushes)
                t = t + h if h < dt - t else dt
                arriving = max(-v, 0.0)
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
            peaks[k] = max(peaks[k], y)
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
def to_rotations(y, rate, outward, inward):
    """Turn y [rad] and y' [rad/s] into theta and theta' in place, shape (n,). outward, inward : Side"""
    for i in range(y.size):
        side, sign = (outward, 1.0) if y[i] >= 0.0 else (inward, -1.0)
        rate[i] *= slope(THETA, sign * y[i], side)
        y[i] = sign * value(THETA, sign * y[i], side)


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
def scan_record(ground, dt, scales, model, outward, inward, outcomes, peaks, none, table, both):
    """`history.scan` of a wall held at its top; peaks are those of theta [rad].

    ground : ground acceleration [m/s2], shape (n,)
    dt : its time step [s]
    scales : multipliers [-], shape (m,)
    model : RockingModel, without `bending`
    outward, inward : Side
    outcomes : results, codes of outcome.py, int64, shape (m,)
    peaks : results [rad], shape (m,)
    none : in place of the histories, which nobody wants, shape (0,)
    table : of `tableau` with room for 2 STAGES [-]
    both : room for the peaks of both sides, shape (2,)
    """
    for j in range(scales.size):
        outcomes[j], _, _ = integrate(
            ground, dt, scales[j], model, outward, inward, (0.0, 0.0), none, none, none, none, table, both
        )
        peaks[j] = max(value(THETA, both[0], outward), value(THETA, both[1], inward))


def _parts(model: RockingModel) -> tuple[RockingModel, Side, Side, np.ndarray]:
    """The model as the kernels take it, its sides, and the table of the steps."""
    assert model.bending is not None
    alpha = model.slenderness
    collapse = alpha + model.restoring.lean, alpha + model.mirrored.lean
    return model._replace(bending=None), *sides_of(model.bending, alpha, collapse), np.append(tableau(), ROOM)


def scan(grounds: Grounds, which, scales, model, outcomes, peaks) -> np.ndarray:
    """`history.scan_records` of a wall held at its top; no velocity ratio is ever clamped."""
    bare, outward, inward, table = _parts(model)
    for k in np.unique(which):
        here = np.nonzero(which == k)[0]
        codes, reached = outcomes[here], peaks[here]
        ground = grounds.ground[grounds.first[k] : grounds.last[k] + 1]
        scan_record(ground, grounds.dt, scales[here], bare, outward, inward, codes, reached, NONE, table, np.zeros(2))
        outcomes[here], peaks[here] = codes, reached
    return np.zeros(scales.size, np.int64)


def history(ground, dt, scale, model, start, trace, impact_time, impact_velocity) -> tuple[int, float, int, int, int]:
    """One history in full, theta in `trace`, shape (2, n); returns as `taylor.integrate` does."""
    bare, outward, inward, table = _parts(model)
    sign = -1.0 if start[0] < 0.0 or (start[0] == 0.0 and start[1] < 0.0) else 1.0
    y, speed = to_y(sign * start[0], sign * start[1], outward if sign > 0.0 else inward)
    begin = (sign * y, sign * speed)
    parts = bare, outward, inward, begin, trace[0], trace[1], impact_time, impact_velocity, table
    peaks = np.zeros(2)
    outcome, impacts, done = integrate(ground, dt, scale, *parts, peaks)
    to_rotations(trace[0], trace[1], outward, inward)
    to_rotations(np.zeros(impact_velocity.size), impact_velocity, outward, inward)
    peak = max(float(value_of(peaks[0], outward)), float(value_of(peaks[1], inward)))
    return outcome, peak, impacts, 0, done


@kernel
def value_of(y, side):
    """theta [rad] at y; side : Side"""
    return value(THETA, y, side)
