"""The polynomial of a Taylor step, phi' = v0 + v1 t + ... + v8 t^8, t in units of the step, and where it
crosses and turns. Angles in rad, rates in rad per step. Summed in pairs, so that one sum does not wait
for the other."""

import math

from core.kernel_cache import inner_kernel, subkernel

ROTATION, RATE, CURVATURE = 0.0, 1.0, 2.0
"""What `bracketed_root` looks for; floats, since numba compiles anew for every constant integer."""


@inner_kernel
def increment(v, t):
    """phi(t) - phi(0) [rad]."""
    square = t * t
    first = (0.5 * v[1] + t * ((1.0 / 3.0) * v[2])) + square * (0.25 * v[3] + t * (0.2 * v[4]))
    last = (1.0 / 6.0) * v[5] + t * ((1.0 / 7.0) * v[6])
    last = last + square * (0.125 * v[7] + t * ((1.0 / 9.0) * v[8]))
    return t * v[0] + square * (first + square * square * last)


@inner_kernel
def change(v, t):
    """phi'(t) - phi'(0) [rad per step]."""
    square = t * t
    first = (v[1] + t * v[2]) + square * (v[3] + t * v[4])
    last = (v[5] + t * v[6]) + square * (v[7] + t * v[8])
    return t * (first + square * square * last)


@subkernel
def curvature(v, t):
    """phi''(t) [rad per step squared]."""
    tail = 5.0 * v[5] + t * (6.0 * v[6] + t * (7.0 * v[7] + t * 8.0 * v[8]))
    return v[1] + t * (2.0 * v[2] + t * (3.0 * v[3] + t * (4.0 * v[4] + t * tail)))


@subkernel
def value_and_slope(v, gap, which, t):
    """gap + phi(t) - phi(0), phi'(t) or phi''(t), by `which`, and its slope."""
    if which == ROTATION:
        return gap + increment(v, t), v[0] + change(v, t)
    if which == RATE:
        return v[0] + change(v, t), curvature(v, t)
    tail = 20.0 * v[5] + t * (30.0 * v[6] + t * (42.0 * v[7] + t * (56.0 * v[8])))
    return curvature(v, t), 2.0 * v[2] + t * (6.0 * v[3] + t * (12.0 * v[4] + t * tail))


@subkernel
def bracketed_root(v, gap, which, low, high):
    """Root of `value_and_slope` between low and high, where its sign changes: Newton in a bracket."""
    at_low, _ = value_and_slope(v, gap, which, low)
    rising = at_low < 0.0
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


@subkernel
def part_turning_once(v, h):
    """Largest h / 2^n such that phi'' changes sign at most once in [0, h], by bounds on the polynomial."""
    a2 = abs(v[1])
    a3 = abs(v[2]) * 2.0
    for _ in range(30):
        t3 = h * (6.0 * abs(v[3]) + h * (12.0 * abs(v[4]) + h * (20.0 * abs(v[5]))))
        t3 += h * h * h * h * (30.0 * abs(v[6]) + h * (42.0 * abs(v[7]) + h * 56.0 * abs(v[8])))
        if t3 <= a3 or h * (a3 + t3) <= a2:
            break
        h *= 0.5
    return h


@inner_kernel
def falls_faster_and_faster(v):
    """Whether phi'' is negative all over the step, by a bound on the polynomial's tail."""
    tail = (2.0 * abs(v[2]) + 3.0 * abs(v[3])) + (4.0 * abs(v[4]) + 5.0 * abs(v[5]))
    return v[1] + (tail + (6.0 * abs(v[6]) + 7.0 * abs(v[7])) + 8.0 * abs(v[8])) < 0.0


@subkernel
def landing(v, gap, h):
    """Time in (0, h] at which gap + phi(t) - phi(0) falls to zero; -1.0 if it stays above. gap not negative.
    Valid where phi'' < 0 in [0, h]: there is one such time at most."""
    if gap + increment(v, h) > 0.0:
        return -1.0
    # the parabola's root is close, and then each step of Halley's triples the digits; a start that is short
    # of the landing or beyond the step is replaced by the end, from where Newton's steps come down to it
    square = max(v[0] * v[0] - 2.0 * v[1] * gap, 0.0)
    time = min(-(v[0] + math.sqrt(square)) / v[1], h)
    for _ in range(60):
        slope = v[0] + change(v, time)
        if slope >= 0.0:
            time = h
            continue
        inverse = 1.0 / slope
        step = (gap + increment(v, time)) * inverse
        bend = 0.5 * step * inverse * curvature(v, time)
        near = abs(step) <= 1e-6 * time and abs(bend) <= 1e-6
        time -= step * (1.0 + bend) if abs(bend) < 0.1 else step
        if near or not time > 0.0:
            break
        time = min(time, h)
    return min(max(time, 0.0), h)


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
        if (v[0] + change(v, start) < 0.0) != (v[0] + change(v, stop) < 0.0):
            middle = bracketed_root(v, 0.0, RATE, start, stop)
        for part in range(2):
            low = start if part == 0 else middle
            high = middle if part == 0 else stop
            if high > low and sign * (gap + increment(v, high)) <= 0.0:
                if sign * (gap + increment(v, low)) <= 0.0:
                    rises = sign * (v[0] + change(v, 0.5 * (low + high))) > 0.0
                    return high if rises and low == 0.0 else low
                return bracketed_root(v, gap, ROTATION, low, high)
        start = stop
    return -1.0


@subkernel
def summit(v, h):
    """Largest increment of the step's polynomial at a turning point inside [0, h] [rad], else 0."""
    bend = h
    bends_at_start = curvature(v, 0.0)
    bends_at_end = curvature(v, h)
    if bends_at_start < 0.0 and bends_at_end < 0.0:
        # concave: at most one summit, and an error of its time counts squared
        if v[0] <= 0.0 or v[0] + change(v, h) >= 0.0:
            return 0.0
        time = min(-v[0] / bends_at_start, h)
        for _ in range(60):
            step = (v[0] + change(v, time)) / curvature(v, time)
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
        if (v[0] + change(v, start) < 0.0) != (v[0] + change(v, stop) < 0.0):
            highest = max(highest, increment(v, bracketed_root(v, 0.0, RATE, start, stop)))
        start = stop
    return highest
