"""The polynomial of a Taylor step, c0 + c1 t + ... + c9 t^9 [rad], and where it crosses and turns."""

import math

from core.kernel_cache import inner_kernel, kernel


@inner_kernel
def increment(c, t):
    """phi(t) - phi(0) of the step's polynomial [rad]."""
    tail = c[5] + t * (c[6] + t * (c[7] + t * (c[8] + t * c[9])))
    return t * (c[1] + t * (c[2] + t * (c[3] + t * (c[4] + t * tail))))


@inner_kernel
def rate(c, t):
    """phi'(t) of the step's polynomial [rad/s]."""
    tail = 5.0 * c[5] + t * (6.0 * c[6] + t * (7.0 * c[7] + t * (8.0 * c[8] + t * 9.0 * c[9])))
    return c[1] + t * (2.0 * c[2] + t * (3.0 * c[3] + t * (4.0 * c[4] + t * tail)))


@kernel
def curvature(c, t):
    """phi''(t) of the step's polynomial [rad/s2]."""
    tail = 20.0 * c[5] + t * (30.0 * c[6] + t * (42.0 * c[7] + t * (56.0 * c[8] + t * 72.0 * c[9])))
    return 2.0 * c[2] + t * (6.0 * c[3] + t * (12.0 * c[4] + t * tail))


@kernel
def derivative(c, t, level, which):
    """phi(t) - level, phi'(t) or phi''(t) for which = 0, 1, 2, and its slope."""
    if which == 0:
        return (c[0] - level) + increment(c, t), rate(c, t)
    if which == 1:
        return rate(c, t), curvature(c, t)
    tail = 60.0 * c[5] + t * (120.0 * c[6] + t * (210.0 * c[7] + t * (336.0 * c[8])))
    return curvature(c, t), 6.0 * c[3] + t * (24.0 * c[4] + t * tail)


@kernel
def bracketed_root(c, level, which, low, high):
    """Root of `derivative` between low and high, where its sign changes: Newton inside a bracket."""
    at_low, _ = derivative(c, low, level, which)
    rising = at_low < 0.0
    time = 0.5 * (low + high)
    for _ in range(100):
        value, gradient = derivative(c, time, level, which)
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


@kernel
def turns_at_most_once(c, h):
    """Whether phi'' changes sign at most once in [0, h], by bounds on the polynomial's tail."""
    a2 = abs(c[2]) * 2.0
    a3 = abs(c[3]) * 6.0
    t3 = h * (24.0 * abs(c[4]) + h * (60.0 * abs(c[5]) + h * (120.0 * abs(c[6]))))
    t3 += h * h * h * h * (210.0 * abs(c[7]) + h * (336.0 * abs(c[8]) + h * 504.0 * abs(c[9])))
    return t3 <= a3 or h * (a3 + t3) <= a2


@kernel
def first_crossing(c, level, sign, h):
    """First time in (0, h] at which sign * (phi - level) falls to zero, from above or from a start
    on the level; -1.0 if never. Splits [0, h] where phi' is monotone, then where phi is, so that a
    double crossing inside the step is found. Valid where `turns_at_most_once` holds."""
    bends_at_start = sign * curvature(c, 0.0)
    bends_at_end = sign * curvature(c, h)
    if bends_at_start < 0.0 and bends_at_end < 0.0:
        # concave: one crossing at most, and Newton from its far side comes down to it
        time = h
        value = sign * ((c[0] - level) + increment(c, time))
        if value > 0.0:
            return -1.0
        # the parabola's root is close; where it falls short, one Newton step leads past the crossing
        v, a = sign * c[1], sign * c[2]
        guess = -(v + math.sqrt(max(v * v - 4.0 * a * sign * (c[0] - level), 0.0))) / (2.0 * a)
        if 0.0 < guess < h:
            at_guess = sign * ((c[0] - level) + increment(c, guess))
            gradient = sign * rate(c, guess)
            if at_guess > 0.0 and gradient < 0.0:
                guess -= at_guess / gradient
                at_guess = sign * ((c[0] - level) + increment(c, guess))
            if at_guess <= 0.0 and guess < h:
                time = guess
                value = at_guess
        for _ in range(60):
            gradient = sign * rate(c, time)
            following = time - value / gradient if gradient < 0.0 else 0.0
            if not 0.0 < following < time:
                break
            time = following
            value = sign * ((c[0] - level) + increment(c, time))
        return time
    bend = h
    if (bends_at_start < 0.0) != (bends_at_end < 0.0):
        bend = bracketed_root(c, 0.0, 2, 0.0, h)
    start = 0.0
    for half in range(2):
        stop = bend if half == 0 else h
        middle = stop
        if (rate(c, start) < 0.0) != (rate(c, stop) < 0.0):
            middle = bracketed_root(c, 0.0, 1, start, stop)
        for part in range(2):
            low = start if part == 0 else middle
            high = middle if part == 0 else stop
            if high > low and sign * ((c[0] - level) + increment(c, high)) <= 0.0:
                if sign * ((c[0] - level) + increment(c, low)) <= 0.0:
                    rises = sign * rate(c, 0.5 * (low + high)) > 0.0
                    return high if rises and low == 0.0 else low
                return bracketed_root(c, level, 0, low, high)
        start = stop
    return -1.0


@kernel
def summit(c, h):
    """Largest increment of the step's polynomial at a turning point inside [0, h] [rad], else 0."""
    bend = h
    if (curvature(c, 0.0) < 0.0) != (curvature(c, h) < 0.0):
        bend = bracketed_root(c, 0.0, 2, 0.0, h)
    highest = 0.0
    start = 0.0
    for half in range(2):
        stop = bend if half == 0 else h
        if (rate(c, start) < 0.0) != (rate(c, stop) < 0.0):
            highest = max(highest, increment(c, bracketed_root(c, 0.0, 1, start, stop)))
        start = stop
    return highest
