"""The polynomial of a Taylor step, phi' = v0 + v1 t + ... + v8 t^8, t in units of the step, and where it
crosses and turns (resources/docs/physics.md, section 8). Angles in rad, rates in rad per step. Summed in pairs, so
that one sum does not wait for the other."""

import math

from core.jit.decorators import inner_kernel, subkernel
from core.jit.fma import fma

ROTATION, RATE, CURVATURE = 0.0, 1.0, 2.0
"""Quantity whose root `bracketed_root` looks for; floats, since numba compiles anew for every constant integer."""


@inner_kernel
def increment(v, t):
    """phi(t) - phi(0) [rad]."""
    square = t * t
    first = fma((1.0 / 3.0) * t, v[2], 0.5 * v[1])
    first = fma(square, fma(0.2 * t, v[4], 0.25 * v[3]), first)
    last = fma((1.0 / 7.0) * t, v[6], (1.0 / 6.0) * v[5])
    last = fma(square, fma((1.0 / 9.0) * t, v[8], 0.125 * v[7]), last)
    return fma(square, fma(square * square, last, first), t * v[0])


@inner_kernel
def speed_increment(v, t):
    """phi'(t) - phi'(0) [rad per step]."""
    square = t * t
    first = fma(square, fma(t, v[4], v[3]), fma(t, v[2], v[1]))
    last = fma(square, fma(t, v[8], v[7]), fma(t, v[6], v[5]))
    return t * fma(square * square, last, first)


@inner_kernel
def whole_step(v):
    """(phi(1) - phi(0) [rad], phi'(1) - phi'(0) [rad per step]): `increment` and `change` at the end of the step. The
    terms come in as they become known, v8 last, and v0, by far the largest, is added to their sum."""
    low = fma(0.25, v[3], fma(1.0 / 3.0, v[2], 0.5 * v[1]))
    high = fma(0.125, v[7], fma(1.0 / 7.0, v[6], fma(1.0 / 6.0, v[5], 0.2 * v[4])))
    dphi = v[0] + fma(1.0 / 9.0, v[8], low + high)
    dv = ((v[1] + v[2]) + (v[3] + v[4])) + ((v[5] + v[6]) + v[7]) + v[8]
    return dphi, dv


@inner_kernel
def curvature(v, t):
    """phi''(t) [rad per step squared]."""
    tail = fma(t, fma(t, fma(t, 8.0 * v[8], 7.0 * v[7]), 6.0 * v[6]), 5.0 * v[5])
    return fma(t, fma(t, fma(t, fma(t, tail, 4.0 * v[4]), 3.0 * v[3]), 2.0 * v[2]), v[1])


@subkernel
def value_and_slope(v, gap, which, t):
    """gap + phi(t) - phi(0), phi'(t) or phi''(t), by `which`, and its slope."""
    if which == ROTATION:
        return gap + increment(v, t), v[0] + speed_increment(v, t)
    if which == RATE:
        return v[0] + speed_increment(v, t), curvature(v, t)
    tail = 20.0 * v[5] + t * (30.0 * v[6] + t * (42.0 * v[7] + t * (56.0 * v[8])))
    return curvature(v, t), 2.0 * v[2] + t * (6.0 * v[3] + t * (12.0 * v[4] + t * tail))


@subkernel
def bracketed_root(v, gap, which, low, high):
    """Root of `value_and_slope` between low and high, where its sign changes: Newton in a bracket."""
    at_low, _ = value_and_slope(v, gap, which, low)
    at_high, _ = value_and_slope(v, gap, which, high)
    rising = at_low < 0.0
    time = low + (high - low) * (at_low / (at_low - at_high))
    if not (low < time < high):
        time = 0.5 * (low + high)
    for _ in range(100):
        value, gradient = value_and_slope(v, gap, which, time)
        if value == 0.0:
            return time
        if (value < 0.0) == rising:
            low = time
        else:
            high = time
        step = value / gradient if gradient != 0.0 else 0.0
        following = time - step
        if not (low < following < high):
            following = 0.5 * (low + high)
        if following == time or following in (low, high):
            return following
        time = following
    return time


@inner_kernel
def third_derivative_variation(v, h):
    """Bound of how far phi''' strays from 2 v2 in [0, h] [rad per step cubed]."""
    square = h * h
    tail = fma(20.0 * square, abs(v[5]), fma(12.0 * h, abs(v[4]), 6.0 * abs(v[3])))
    last = fma(56.0 * square, abs(v[8]), fma(42.0 * h, abs(v[7]), 30.0 * abs(v[6])))
    return h * fma(square * h, last, tail)


@subkernel
def part_turning_once(v, h):
    """Largest h / 2^n such that phi'' changes sign at most once in [0, h], by bounds on the polynomial."""
    a2 = abs(v[1])
    a3 = abs(v[2]) * 2.0
    for _ in range(30):
        strays = third_derivative_variation(v, h)
        if strays <= a3 or h * (a3 + strays) <= a2:
            break
        h *= 0.5
    return h


@inner_kernel
def step_shape(v, gap, dphi, dv, h):
    """(upper bound of phi'' in [0, h], whether phi only rises, whether gap + phi(t) - phi(0) surely does not
    fall to zero in (0, h]); gap not negative, dphi, dv : of phi and phi' over [0, h].

    Where phi''' keeps its sign, phi' turns once at most, and phi then lies above one of its ends.
    """
    strays = third_derivative_variation(v, h)
    bend = fma(0.5 * h, strays, fma(2.0 * h, abs(v[2]), v[1]))
    rises = (v[0] >= 0.0) & (v[1] >= 0.0) & (2.0 * v[2] >= strays)
    steady = 2.0 * abs(v[2]) >= strays
    after = v[0] + dv
    up = (v[0] >= 0.0) & ((v[2] <= 0.0) | (after <= 0.0))
    down = (v[0] < 0.0) & (v[2] >= 0.0) & (after <= 0.0)
    return bend, rises, rises | ((gap + dphi > 0.0) & ((bend < 0.0) | (steady & (up | down))))


@inner_kernel
def landing(v, gap, h):
    """(first time in (0, h] at which gap + phi(t) - phi(0) falls to zero, bound of that sum until then, whether
    this is sure); gap not negative.

    From the root of the parabola, or where phi'' is outward at first and then inward that of the cubic without the gap,
    or from the end, two Newton steps on the cubic and two third-order steps. The time found is the first one where
    phi'' is negative until then, or where phi''' keeps its sign and phi' thus turns from outward to inward once.
    (1.001 and 1.998, for 1 and 2, are margins for rounding on the side of a larger bound.)
    """
    # v1 < 0: v0 + root over -v1; else 3/4 v1 + root over -v2, from v0 + v1 t/2 + v2 t^2/3 = 0
    inward = v[1] < 0.0
    square = fma(v[0], v[0], -2.0 * v[1] * gap) if inward else fma(0.5625 * v[1], v[1], -3.0 * v[2] * v[0])
    root = math.sqrt(max(square, 0.0))
    divisor = v[1] if inward else v[2]
    time = min(-((v[0] if inward else 0.75 * v[1]) + root) / divisor, h)
    time = time if inward | ((v[2] < 0.0) & (v[0] >= 0.0)) else h
    for _ in range(2):
        off = fma(time, fma(time, fma(time, (1.0 / 3.0) * v[2], 0.5 * v[1]), v[0]), gap)
        slope = fma(time, fma(time, v[2], v[1]), v[0])
        time -= off / slope if slope < 0.0 else 0.0
    time, _, _, _ = third_order_step(v, gap, min(time, h))
    time, step, more, slope = third_order_step(v, gap, time)
    near = (abs(step) <= 1e-6 * time) & (abs(more) <= 1e-6) & (time > 0.0) & (time <= h) & (slope < 0.0)
    strays = third_derivative_variation(v, time)
    bend = fma(time, fma(0.5, strays, 2.0 * abs(v[2])), v[1])
    steady = 2.0 * abs(v[2]) >= strays
    once = (v[0] > 0.0) | (v[2] >= 0.0) | (v[0] + max(v[1], 0.0) * time < 0.0)
    top = 1.001 * max(v[0] + 0.5 * max(bend, 0.0) * time, 0.0) * time
    highest = min(top, v[0] * v[0] / (-1.998 * bend)) if (bend < 0.0) & (v[0] > 0.0) else top
    return time, gap + highest, near & ((bend < 0.0) | (steady & once))


@inner_kernel
def mirrored(v):
    """The series of -phi'."""
    return -v[0], -v[1], -v[2], -v[3], -v[4], -v[5], -v[6], -v[7], -v[8]


@inner_kernel
def third_order_step(v, gap, time):
    """(time, Newton's step, third-order correction relative to it, slope) of one step to the root of gap + phi(t) -
    phi(0): Halley's correction expanded to first order (Chebyshev's method)."""
    slope = v[0] + speed_increment(v, time)
    inverse = 1.0 / slope if slope < 0.0 else 0.0
    step = (gap + increment(v, time)) * inverse
    bend = 0.5 * step * inverse * curvature(v, time)
    return fma(-step, 1.0 + bend, time), step, bend, slope


@subkernel
def first_crossing(v, gap, sign, h):
    """First time in (0, h] at which sign * (gap + phi(t) - phi(0)) falls to zero, from above or from a
    start at zero; -1.0 if never. Splits [0, h] where phi' is monotone, then where phi is, so that a
    double crossing inside the step is found. Valid where `part_turning_once` is h."""
    bends_at_start = sign * curvature(v, 0.0)
    bends_at_end = sign * curvature(v, h)
    bend = h
    if (bends_at_start < 0.0) != (bends_at_end < 0.0):
        bend = bracketed_root(v, 0.0, CURVATURE, 0.0, h)
    start = 0.0
    for half in range(2):
        stop = bend if half == 0 else h
        middle = stop
        if (v[0] + speed_increment(v, start) < 0.0) != (v[0] + speed_increment(v, stop) < 0.0):
            middle = bracketed_root(v, 0.0, RATE, start, stop)
        for part in range(2):
            low = start if part == 0 else middle
            high = middle if part == 0 else stop
            if high > low and sign * (gap + increment(v, high)) <= 0.0:
                if sign * (gap + increment(v, low)) <= 0.0:
                    rises = sign * (v[0] + speed_increment(v, 0.5 * (low + high))) > 0.0
                    return high if rises and low == 0.0 else low
                return bracketed_root(v, gap, ROTATION, low, high)
        start = stop
    return -1.0


@subkernel
def interior_maximum(v, h):
    """Largest increment of the step's polynomial at a turning point inside [0, h] [rad], else 0."""
    bend = h
    bends_at_start = curvature(v, 0.0)
    bends_at_end = curvature(v, h)
    if bends_at_start < 0.0 and bends_at_end < 0.0:
        # concave: at most one turning point, and an error of its time counts squared
        if v[0] <= 0.0 or v[0] + speed_increment(v, h) >= 0.0:
            return 0.0
        time = min(-v[0] / bends_at_start, h)
        for _ in range(60):
            step = (v[0] + speed_increment(v, time)) / curvature(v, time)
            time -= step
            if abs(step) <= 1e-9 * h:
                break
        if 0.0 < time < h:
            return max(0.0, increment(v, time))
    if (bends_at_start < 0.0) != (bends_at_end < 0.0):
        bend = bracketed_root(v, 0.0, CURVATURE, 0.0, h)
    highest = 0.0
    start = 0.0
    for half in range(2):
        stop = bend if half == 0 else h
        if (v[0] + speed_increment(v, start) < 0.0) != (v[0] + speed_increment(v, stop) < 0.0):
            highest = max(highest, increment(v, bracketed_root(v, 0.0, RATE, start, stop)))
        start = stop
    return highest
