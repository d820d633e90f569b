"""A second truth, a thousand times faster than high_precision.py: the rocking wall in double-double arithmetic (about
31 digits), Taylor order 24, bare, trilinear, loaded or held by bars.

It shares no code with the program's kernels but the instruction fma. The unknowns are phi, x = sin(phi) and y =
cos(phi), so that a bar, whose elongation over its height is x, is taut, yields and breaks where polynomials of x have
roots. Steps are cut until the last terms are below 1e-32 of the largest. A root is approached from the left in strides
in which a bound of the second derivative excludes it: none is jumped over.

A double-double is a tuple (high, low), the number high + low; in an array the last axis. Dekker (1971, Numer. Math.
18), Knuth's sum of two, and the algorithms of Hida, Li and Bailey (2001, ARITH-15).
"""

import math
from fractions import Fraction

import numpy as np

from core.jit.decorators import inner_kernel, kernel, subkernel
from core.jit.fma import fma

ORDER = 24

MAX_IMPACTS = 10_000  # in a sample
NEGLIGIBLE = 1e-32
"""Last terms of the series at the end of a step, over its largest."""

SLACK, TAUT, YIELDING, BROKEN = 0, 1, 2, 3
"""What a bar does."""

NOTHING, FALLS, RISES, TIGHTENS, SLACKENS, YIELDS, TURNS, BREAKS = range(8)
"""What ends a step."""

FREE, AT_RESIDUAL, AT_YIELD = 0, 1, 2
"""Where the elongation of a bar is at the start of a step: exactly at an end of its branch, or not."""

STIFFNESS, YIELD, START, BREAK = 1, 2, 3, 4
"""Columns of the array of bars (core/wall/bars.py)."""


def split(value: Fraction) -> tuple[float, float]:
    """The double-double next to a fraction."""
    return float(value), float(value - Fraction(float(value)))


INVERSE = np.array([split(Fraction(1, n)) for n in range(1, ORDER + 2)])
"""1/1, 1/2, ..."""

FACTORIAL = np.array([split(Fraction(1, math.factorial(n))) for n in range(40)])
"""1/0!, 1/1!, ..."""


@inner_kernel
def two_sum(x, y):
    """x + y of two doubles, exactly."""
    high = x + y
    part = high - x
    return high, (x - (high - part)) + (y - part)


@inner_kernel
def add(x, y):
    high, low = two_sum(x[0], y[0])
    other, rest = two_sum(x[1], y[1])
    low += other
    total = high + low
    low = (low - (total - high)) + rest
    high = total + low
    return high, low - (high - total)


@inner_kernel
def mul(x, y):
    high = x[0] * y[0]
    low = fma(x[0], y[0], -high) + (x[0] * y[1] + x[1] * y[0])
    total = high + low
    return total, low - (total - high)


@inner_kernel
def minus(x):
    return -x[0], -x[1]


@subkernel
def div(x, y):
    first = x[0] / y[0]
    rest = add(x, minus(mul((first, 0.0), y)))
    second = rest[0] / y[0]
    rest = add(rest, minus(mul((second, 0.0), y)))
    return add(add((first, 0.0), (second, 0.0)), (rest[0] / y[0], 0.0))


@subkernel
def horner(c, last, t):
    """c[0] + c[1] t + ... + c[last] t^last."""
    total = (c[last, 0], c[last, 1])
    for k in range(last - 1, -1, -1):
        total = add(mul(total, t), (c[k, 0], c[k, 1]))
    return total


@subkernel
def sine_or_cosine(x, odd):
    """sin(x) where odd is 1, cos(x) where it is 0, by its series; |x| up to 2."""
    square, total = mul(x, x), (0.0, 0.0)
    for k in range(38 + odd, -1, -2):
        part = (FACTORIAL[k, 0], FACTORIAL[k, 1])
        total = add(part, minus(mul(total, square)))
    return mul(total, x) if odd == 1 else total


@subkernel
def product(c, d, n):
    """n-th coefficient of the product of two series."""
    total = (0.0, 0.0)
    for i in range(n + 1):
        total = add(total, mul((c[i, 0], c[i, 1]), (d[n - i, 0], d[n - i, 1])))
    return total


@inner_kernel
def put(c, n, value):
    c[n, 0], c[n, 1] = value


@inner_kernel
def row(c, n):
    return c[n, 0], c[n, 1]


@subkernel
def set_terms(terms, side, zone, beta, rate, wall, bars, residual, phase):
    """Factors of x_n, y_n, x_(n-1), y_(n-1), phi_n, 1 and x y in -phi'' / p2 on the branch the wall is on."""
    one = 0 if side > 0.0 else 1
    k, m, a, c = (0.0, 0.0), (0.0, 0.0), 0.0, 0.0
    if zone == 0:
        m = div(wall.plateau, wall.phi1)
    elif zone == 1:
        k = wall.plateau
    else:
        a, c = wall.a[one], wall.c[one]
    held = add((c, 0.0), minus(beta))
    spring, tied = (0.0, 0.0), (0.0, 0.0)
    for j in range(bars.shape[0] if side > 0.0 else 0):
        stiffness = (bars[j, STIFFNESS], 0.0)
        if phase[j] == TAUT:
            spring = add(spring, stiffness)
            tied = add(tied, minus(mul(stiffness, row(residual, j))))
        elif phase[j] == YIELDING:
            tied = add(tied, mul(stiffness, (bars[j, YIELD], 0.0)))
    put(terms, 0, add(mul(held, wall.sine), mul((-a, 0.0), wall.cosine)))
    put(terms, 1, add(add(mul(held, wall.cosine), mul((a, 0.0), wall.sine)), tied))
    put(terms, 2, mul(minus(rate), wall.sine))
    put(terms, 3, mul(minus(rate), wall.cosine))
    put(terms, 4, m)
    put(terms, 5, k)
    put(terms, 6, spring)


@subkernel
def expand(phi, speed, at_threshold, terms, wall, series):
    """Coefficients of phi, of its rate and of x, y about an instant. series : results, shape (4, ORDER + 1, 2)"""
    c, v, x, y = series[0], series[1], series[2], series[3]
    put(c, 0, phi)
    put(c, 1, speed)
    put(v, 0, speed)
    put(x, 0, sine_or_cosine(phi, 1))
    put(y, 0, sine_or_cosine(phi, 0))
    for n in range(ORDER - 1):
        total = add(mul(row(terms, 0), row(x, n)), mul(row(terms, 1), row(y, n)))
        total = add(total, mul(row(terms, 4), row(c, n)))
        if n == 0:
            total = add(total, row(terms, 5))
        else:
            total = add(total, add(mul(row(terms, 2), row(x, n - 1)), mul(row(terms, 3), row(y, n - 1))))
        if terms[6, 0] != 0.0:
            total = add(total, mul(row(terms, 6), product(x, y, n)))
        rate = mul(mul(wall.minus_p2, row(INVERSE, n)), total)
        if n == 0 and at_threshold:
            rate = (0.0, 0.0)
        put(v, n + 1, rate)
        put(c, n + 2, mul(rate, row(INVERSE, n + 1)))
        put(x, n + 1, mul(product(v, y, n), row(INVERSE, n)))
        put(y, n + 1, minus(mul(product(v, x, n), row(INVERSE, n))))
    put(x, ORDER, mul(product(v, y, ORDER - 1), row(INVERSE, ORDER - 1)))


@subkernel
def converged(series, h):
    """Largest of h, 0.8 h, 0.64 h, ... [s] at which the last terms of phi and x are negligible."""
    for _ in range(200):
        accepted = True
        for one in (0, 2):
            power, largest, term, last = h, 0.0, 0.0, 0.0
            for k in range(1, ORDER + 1):
                last, term = term, abs(series[one, k, 0]) * power
                largest = max(largest, term)
                power *= h
            accepted = accepted and max(last, term) <= NEGLIGIBLE * largest
        if accepted:
            break
        h *= 0.8
    return h


@subkernel
def first_root(c, sign, level, shift, last, h, room):
    """First t [s] in (0, h] at which sign (c(t) - level) falls to zero, of a series c to its term `last`, or -1.

    shift : 1 where it starts there exactly: then of this over t, and again over t where that starts at zero
    room : a series
    """
    if h <= 0.0:
        return -1.0, 0.0
    for k in range(last + 1):
        room[k, 0], room[k, 1] = sign * c[k, 0], sign * c[k, 1]
    put(room, 0, add(row(room, 0), (-sign * level[0], -sign * level[1])))
    while 0 < shift < 4:
        for k in range(last):
            put(room, k, row(room, k + 1))
        last -= 1
        shift = shift + 1 if room[0, 0] == 0.0 else 0
    t = (0.0, 0.0)
    for _ in range(10_000):
        value, slope = horner(room, last, t)[0], 0.0
        if value <= 0.0:
            return t
        for k in range(last, 0, -1):
            slope = slope * t[0] + k * room[k, 0]
        stride = safe_stride(room, last, value, slope, t[0], h)
        if stride <= 1e-31 * t[0]:
            return t
        t = add(t, (stride * (1.0 - 1e-12), 0.0))
        if t[0] > h:
            return -1.0, 0.0
    return t


@subkernel
def safe_stride(c, last, value, slope, t, h):
    """How far from t the series, there of this value and slope, surely stays positive [s]: value + slope s - bend s^2/2
    does where c'' >= -bend, of which the negative coefficients give a bound up to t + window (h, h/4, h/16, ...)."""
    stride, window, before = 0.0, 1.001 * h, math.inf
    for _ in range(60):
        bend, power = -2.0 * c[2, 0], 1.0
        for k in range(3, last + 1):
            power *= t + window
            bend += k * (k - 1) * max(-c[k, 0], 0.0) * power
        bend = max(bend, 0.0)
        root = math.sqrt(slope * slope + 2.0 * bend * value)
        if slope < 0.0:
            far = 2.0 * value / (root - slope)
        else:
            far = (slope + root) / bend if bend > 0.0 else window
        stride = max(stride, min(far, window))
        if 8.0 * stride > window or bend > 0.5 * before:
            break
        window, before = 0.25 * window, bend
    return stride


@subkernel
def next_event(series, side, zone, on_low, on_high, h, wall, bars, residual, phase, at, room):
    """(time [s], or h; what happens; to which bar) of the first event of a step of length h [s]."""
    best, kind, which = (h, 0.0), NOTHING, 0
    low = wall.phi1 if zone == 1 else (wall.phi2 if zone == 2 else (0.0, 0.0))
    t = first_root(series[0], 1.0, low, int(on_low), ORDER, h, room)
    if t[0] >= 0.0:
        best, kind = t, FALLS
    if zone < 2:
        high = wall.phi1 if zone == 0 else wall.phi2
        t = first_root(series[0], -1.0, high, int(on_high), ORDER, best[0], room)
        if t[0] >= 0.0:
            best, kind = t, RISES
    for j in range(bars.shape[0] if side > 0.0 else 0):
        if phase[j] == BROKEN:
            continue
        taut_at, at_yield = row(residual, j), add(row(residual, j), (bars[j, YIELD], 0.0))
        found = NOTHING
        if phase[j] == SLACK:
            t, found = first_root(series[2], -1.0, taut_at, int(at[j] == AT_RESIDUAL), ORDER, best[0], room), TIGHTENS
        elif phase[j] == YIELDING:
            t, found = first_root(series[1], 1.0, (0.0, 0.0), 0, ORDER - 1, best[0], room), TURNS
        elif taut_at[0] > 0.0:
            t, found = first_root(series[2], 1.0, taut_at, int(at[j] == AT_RESIDUAL), ORDER, best[0], room), SLACKENS
        if found != NOTHING and t[0] >= 0.0:
            best, kind, which = t, found, j
        if phase[j] == TAUT:
            t = first_root(series[2], -1.0, at_yield, int(at[j] == AT_YIELD), ORDER, best[0], room)
            if t[0] >= 0.0:
                best, kind, which = t, YIELDS, j
        t = first_root(series[2], -1.0, (bars[j, BREAK], 0.0), 0, ORDER, best[0], room)
        if t[0] >= 0.0:
            best, kind, which = t, BREAKS, j
    return best, kind, which


@subkernel
def set_phases(residual, phase, at):
    """What the bars do at theta = 0."""
    for j in range(phase.size):
        at[j] = FREE
        if phase[j] != BROKEN:
            phase[j] = SLACK if residual[j, 0] > 0.0 else TAUT


@subkernel
def change_bars(kind, which, x, bars, residual, phase, at):
    """What the bars do after an event of one of them, at the elongation x."""
    if kind == TIGHTENS:
        phase[which], at[which] = TAUT, AT_RESIDUAL
    elif kind == SLACKENS:
        phase[which], at[which] = SLACK, AT_RESIDUAL
    elif kind == YIELDS:
        phase[which], at[which] = YIELDING, FREE
    elif kind == BREAKS:
        phase[which] = BROKEN
    else:
        for j in range(phase.size):
            if phase[j] == YIELDING:
                put(residual, j, add(x, (-bars[j, YIELD], 0.0)))
                phase[j], at[j] = TAUT, AT_YIELD


@subkernel
def uplift(first, rate, t, dt, wall, bars, residual, phase):
    """(whether and to which side the ground lifts the wall now, the same for later in this sample, when [s])."""
    now, right = add(first, mul(rate, t)), wall.right
    for j in range(bars.shape[0]):
        if phase[j] != BROKEN and residual[j, 0] < 0.0:
            held = mul((bars[j, STIFFNESS], 0.0), minus(row(residual, j)))
            right = add(right, div(held, wall.cosine))
    over, under = add(now, minus(right)), add(now, wall.left)
    if over[0] > 0.0:
        return 1.0, 0.0, t
    if under[0] < 0.0 and not wall.one_sided:
        return -1.0, 0.0, t
    later, level = 0.0, right
    if rate[0] > 0.0:
        later = 1.0
    elif rate[0] < 0.0 and not wall.one_sided:
        later, level = -1.0, minus(wall.left)
    if later == 0.0:
        return 0.0, 0.0, t
    when = div(add(level, minus(first)), rate)
    if when[0] < t[0]:
        when = t
    return 0.0, later if when[0] < dt else 0.0, when


@subkernel
def after_impact(speed, side, wall):
    """(speed [rad/s], side) after an impact at this speed."""
    ratio = add((wall.ratio, 0.0), minus(mul((wall.drop, 0.0), mul(speed, speed))))
    return mul(ratio if ratio[0] > 0.0 else (0.0, 0.0), minus(speed)), side if wall.one_sided else -side


@kernel
def run(ground, dt, gravity, wall, bars, rotation, series, terms, residual, phase, at):
    """(samples done, impacts) of a history from rest; it ends beyond 90 degrees or with MAX_IMPACTS in a sample.

    ground : [m/s2]; dt : [s]; gravity : 1/g, double-double
    wall : Wall (double_double_walls.py); bars : rows of Bars; rotation : results at the samples [rad]
    series, terms, residual, phase, at : room
    """
    phi, speed, t = (0.0, 0.0), (0.0, 0.0), (0.0, 0.0)
    side, moving, zone, on_low, on_high, lifting, total = 1.0, False, 2, True, False, False, 0
    for j in range(bars.shape[0]):
        residual[j, 0], residual[j, 1], phase[j] = bars[j, START], 0.0, TAUT
    for i in range(ground.size - 1):
        first, impacts, steps = mul((ground[i], 0.0), gravity), 0, 0
        rate = div(mul(two_sum(ground[i + 1], -ground[i]), gravity), (dt, 0.0))
        t = (0.0, 0.0)
        while t[0] < dt:
            steps += 1
            if impacts > MAX_IMPACTS or steps > 100 * MAX_IMPACTS:
                return i + 1, total
            if not moving:
                now, later, t = uplift(first, rate, t, dt, wall, bars, residual, phase)
                if now == 0.0 and later == 0.0:
                    break
                side, lifting = now + later, now == 0.0
                phi, speed, moving, on_low, on_high = (0.0, 0.0), (0.0, 0.0), True, True, False
                zone = 2 if wall.phi2[0] == 0.0 else 0
                set_phases(residual, phase, at)
            beta = mul((side, 0.0), add(first, mul(rate, t)))
            set_terms(terms, side, zone, beta, mul((side, 0.0), rate), wall, bars, residual, phase)
            expand(phi, speed, lifting, terms, wall, series)
            rest = add((dt, 0.0), minus(t))
            h = converged(series, rest[0])
            end, kind, which = next_event(
                series, side, zone, on_low, on_high, h, wall, bars, residual, phase, at, series[4]
            )
            whole = kind == NOTHING and h == rest[0]
            end = rest if whole else end
            phi, speed = horner(series[0], ORDER, end), horner(series[1], ORDER - 1, end)
            t = (dt, 0.0) if whole else add(t, end)
            if end[0] > 0.0:
                on_low, on_high, lifting = False, False, False
                at[:] = FREE
            if kind == RISES:
                phi = wall.phi1 if zone == 0 else wall.phi2
                zone, on_low, on_high = zone + 1, True, False
            elif kind == FALLS and zone > 0 and wall.phi2[0] > 0.0:
                phi = wall.phi1 if zone == 1 else wall.phi2
                zone, on_low, on_high = zone - 1, False, True
            elif kind == FALLS:
                impacts, total, phi = impacts + 1, total + 1, (0.0, 0.0)
                speed, side = after_impact(speed, side, wall)
                on_low, on_high, lifting = True, False, False
                set_phases(residual, phase, at)
                lifts, _, _ = uplift(first, rate, t, dt, wall, bars, residual, phase)
                moving = speed[0] > 0.0 and not (speed[0] < wall.rest and lifts == 0.0)
            elif kind != NOTHING:
                change_bars(kind, which, horner(series[2], ORDER, end), bars, residual, phase, at)
                speed = (0.0, 0.0) if kind == TURNS else speed
        rotation[i + 1] = side * phi[0] if moving else 0.0
        if phi[0] > 1.6:
            return i + 2, total
    return ground.size, total
