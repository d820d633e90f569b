"""A step of a wall held at its top as the power series of its coordinate, and its roots."""

from core.jit.decorators import subkernel
from core.rocking.side_functions import DEGREE, OVERLAP, PIECES, V, X

TOLERANCE = 1e-14
"""Largest last term of a step, over y of collapse [-]."""

NEAREST, TINIEST = 1e-15, 1e-300
"""Share of a step to which an event is located, and in place of zero where it is divided by."""


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
def derived(order, y, terms, t):
    """y, y' or y'' of a series after a time [s]. order : 0, 1 or 2"""
    if order == 0:
        return y + moved(terms, t)
    return speed_of(terms, t) if order == 1 else push_of(terms, t)


@subkernel
def root(order, y, terms, low, high):
    """Time [s] at which y, y' or y'' passes through zero between two times at which its signs differ, by Newton inside
    the bracket. order : 0, 1 or 2"""
    least, positive = NEAREST * high, derived(order, y, terms, high) <= 0.0
    time = 0.5 * (low + high)
    for _ in range(100):
        found = derived(order, y, terms, time)
        if (found > 0.0) == positive:
            low = time
        else:
            high = time
        rate = derived(order + 1, y, terms, time) if order < 2 else 0.0
        following = time - found / rate if rate != 0.0 else 0.5 * (low + high)
        if not low < following < high:
            following = 0.5 * (low + high)
        if abs(following - time) <= least or high - low <= least:
            break
        time = following
    return time


@subkernel
def landing(y, terms, h):
    """Time [s] at which y falls to zero within h, where it is not above zero; 0.0 for a start at zero that only
    falls."""
    low = 0.0
    if y == 0.0:
        low = h
        for _ in range(60):
            low *= 0.5
            if moved(terms, low) > 0.0:
                break
            h = low
        else:
            return 0.0
    return root(0, y, terms, low, h)


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
        slow = root(2, y, terms, 0.0, h)
        if (speed_of(terms, slow) < 0.0) != (speed < 0.0):
            h, v = slow, speed_of(terms, slow)
    x = y + moved(terms, h)
    top = max(x, 0.0)
    if speed < 0.0 < v or v < 0.0 < speed:
        turn = root(1, y, terms, 0.0, h)
        reached = y + moved(terms, turn)
        if speed > 0.0:
            top = max(top, reached)
        elif reached < 0.0:
            h, x = turn, reached
    return h, x, v, top, x < 0.0 or (x == 0.0 and v < 0.0)
