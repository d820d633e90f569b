"""A step of a wall held at its top as the power series of its coordinate, and its roots."""

from core.jit.decorators import inner_kernel, subkernel
from core.jit.fma import fma
from core.rocking.side_functions import DEGREE, OVERLAP, PIECES, V, X

SIDE_TOLERANCE = 1e-14
"""Largest last term of a step, over y of collapse [-]."""

NEAREST, TINIEST = 1e-15, 1e-300
"""Share of a step to which an event is located, and in place of zero where it is divided by."""


@inner_kernel
def shift_polynomial(s, c):
    """Coefficients 0 to 6 of a polynomial of degree 7 about s. c : its own, from the lowest on"""
    c0 = c1 = c2 = c3 = c4 = c5 = c6 = 0.0
    for k in range(DEGREE, -1, -1):
        c6 = fma(c6, s, c5)
        c5 = fma(c5, s, c4)
        c4 = fma(c4, s, c3)
        c3 = fma(c3, s, c2)
        c2 = fma(c2, s, c1)
        c1 = fma(c1, s, c0)
        c0 = fma(c0, s, c[k])
    return c0, c1, c2, c3, c4, c5, c6


@inner_kernel
def terms_of(speed, beta, slope, p2, per, v, x):
    """Coefficients 1 to 8 of y as a power series in time.

    speed : y' at its start [rad/s]
    beta : u''/g then, seen from this side [-]
    slope : its rate [1/s]
    p2 : of the model [1/s2]
    per : change of the place in the piece with y [1/rad]
    v, x : of `about`, of both functions
    """
    v0, v1, v2, v3, v4, v5, v6 = v
    x0, x1, x2, x3, x4, x5, x6 = x
    rate = per * p2
    s1 = per * speed
    s2 = 0.5 * rate * (beta * x0 - v0)
    g1 = x1 * s1
    s3 = rate / 6.0 * fma(beta, g1, fma(slope, x0, -(v1 * s1)))
    q2 = s1 * s1
    g2 = fma(x1, s2, x2 * q2)
    s4 = rate / 12.0 * fma(beta, g2, fma(slope, g1, -fma(v1, s2, v2 * q2)))
    q3, r3 = 2.0 * s1 * s2, s1 * q2
    g3 = fma(x1, s3, fma(x2, q3, x3 * r3))
    s5 = rate / 20.0 * fma(beta, g3, fma(slope, g2, -fma(v1, s3, fma(v2, q3, v3 * r3))))
    q4, r4, w4 = fma(2.0 * s1, s3, s2 * s2), fma(s1, q3, s2 * q2), s1 * r3
    g4 = fma(x1, s4, fma(x2, q4, fma(x3, r4, x4 * w4)))
    s6 = rate / 30.0 * fma(beta, g4, fma(slope, g3, -fma(v1, s4, fma(v2, q4, fma(v3, r4, v4 * w4)))))
    q5, r5 = 2.0 * fma(s1, s4, s2 * s3), fma(s1, q4, fma(s2, q3, s3 * q2))
    w5, z5 = fma(s1, r4, s2 * r3), s1 * w4
    g5 = fma(x1, s5, fma(x2, q5, fma(x3, r5, fma(x4, w5, x5 * z5))))
    low5 = fma(v1, s5, fma(v2, q5, fma(v3, r5, fma(v4, w5, v5 * z5))))
    s7 = rate / 42.0 * fma(beta, g5, fma(slope, g4, -low5))
    q6 = fma(2.0, fma(s1, s5, s2 * s4), s3 * s3)
    r6 = fma(s1, q5, fma(s2, q4, fma(s3, q3, s4 * q2)))
    w6, z6, a6 = fma(s1, r5, fma(s2, r4, s3 * r3)), fma(s1, w5, s2 * w4), s1 * z5
    g6 = fma(x1, s6, fma(x2, q6, fma(x3, r6, fma(x4, w6, fma(x5, z6, x6 * a6)))))
    low6 = fma(v1, s6, fma(v2, q6, fma(v3, r6, fma(v4, w6, fma(v5, z6, v6 * a6)))))
    s8 = rate / 56.0 * fma(beta, g6, fma(slope, g5, -low6))
    y = 1.0 / per
    return y * s1, y * s2, y * s3, y * s4, y * s5, y * s6, y * s7, y * s8


@inner_kernel
def has_converged(last, h, top):
    """Whether a series holds for a time [s] by its last term, with a margin for what a root is rounded by.

    last : coefficient 8 of y; top : y of collapse [rad]
    """
    square = h * h
    fourth = square * square
    return abs(last) * (fourth * fourth) <= 0.99 * SIDE_TOLERANCE * top


@inner_kernel
def place_in(y, side):
    """Number of the piece of the functions, place in it and change of that with y. y : [rad]; side : Side"""
    at = y * side.scale
    piece = min(max(int(at), 0), PIECES - 1)
    return piece, 2.0 * (at - piece) - 1.0, 2.0 * side.scale


@inner_kernel
def series_about(speed, beta, slope, p2, s, per, v, x, top, h):
    """Coefficients 1 to 8 of y as a power series in time, the time [s] up to which it holds.

    speed, beta, slope, p2, h : of `series`
    s, per : of `place_in`
    v, x : coefficients of both functions in the piece, shape (DEGREE + 1,)
    top : y of collapse [rad]
    """
    terms = terms_of(speed, beta, slope, p2, per, shift_polynomial(s, v), shift_polynomial(s, x))
    if not has_converged(terms[7], h, top):
        h = min(h, (SIDE_TOLERANCE * top / max(abs(terms[7]), TINIEST)) ** 0.125)
    return terms, h


@subkernel
def series(y, speed, beta, slope, p2, side, h):
    """Coefficients 1 to 8 of y as a power series in time, the time [s] up to which it holds, place in the piece, change
    of that with y.

    y, speed : at its start [rad], [rad/s]
    beta : u''/g then, seen from this side [-]
    slope : its rate [1/s]
    p2 : of the model [1/s2]
    side : Side
    h : longest time that is wanted [s]
    """
    piece, s, per = place_in(y, side)
    terms, h = series_about(speed, beta, slope, p2, s, per, side.values[piece, V], side.values[piece, X], side.top, h)
    return terms, h, s, per


@inner_kernel
def moved(terms, t):
    """What a series adds to y after a time [s]."""
    a, b, c, d, e, f, g, h = terms
    return t * fma(t, fma(t, fma(t, fma(t, fma(t, fma(t, fma(t, h, g), f), e), d), c), b), a)


@inner_kernel
def speed_of(terms, t):
    """y' of a series after a time [s]."""
    a, b, c, d, e, f, g, h = terms
    high = fma(t, fma(t, fma(t, 8.0 * h, 7.0 * g), 6.0 * f), 5.0 * e)
    return fma(t, fma(t, fma(t, fma(t, high, 4.0 * d), 3.0 * c), 2.0 * b), a)


@inner_kernel
def push_of(terms, t):
    """y'' of a series after a time [s]."""
    _, b, c, d, e, f, g, h = terms
    high = fma(t, fma(t, fma(t, 56.0 * h, 42.0 * g), 30.0 * f), 20.0 * e)
    return fma(t, fma(t, fma(t, high, 12.0 * d), 6.0 * c), 2.0 * b)


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
    at_low, at_high = derived(order, y, terms, low), derived(order, y, terms, high)
    least, positive = NEAREST * high, at_high <= 0.0
    time = low + (high - low) * (at_low / (at_low - at_high))
    if not low < time < high:
        time = 0.5 * (low + high)
    for _ in range(100):
        residual = derived(order, y, terms, time)
        if (residual > 0.0) == positive:
            low = time
        else:
            high = time
        rate = derived(order + 1, y, terms, time) if order < 2 else 0.0
        step = residual / rate if rate != 0.0 else high - low
        if abs(step) <= least or high - low <= least:  # asked first: from there on rounding may leave the bracket
            break
        time = time - step if low < time - step < high else 0.5 * (low + high)
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


@inner_kernel
def turning_once(y, speed, terms, h, s, per, least):
    """Length of a step in which the wall turns once at most, and y' after it.

    y, speed, terms, h, s, per, least : of `step_of`
    """
    while abs(s + per * moved(terms, h)) > OVERLAP and h > least:
        h *= 0.5
    v = speed_of(terms, h)
    slows = (terms[1] > 0.0) == (speed < 0.0) and (push_of(terms, h) > 0.0) != (terms[1] > 0.0)
    if slows and speed != 0.0 and (v < 0.0) == (speed < 0.0):  # it may turn twice
        slow = root(2, y, terms, 0.0, h)
        if (speed_of(terms, slow) < 0.0) != (speed < 0.0):
            h, v = slow, speed_of(terms, slow)
    return h, v


@subkernel
def step_of(y, speed, terms, h, s, per, least):
    """One step by its series: length [s], y and y' after it, largest y in it [rad], and whether the wall lands in it.

    y, speed : at its start [rad], [rad/s]
    terms : of `series`
    h : longest it may be [s]
    s, per : place in the piece, of `series`, which the step does not leave
    least : shortest it is cut to for that [s]
    """
    h, v = turning_once(y, speed, terms, h, s, per, least)
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
