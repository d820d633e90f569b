"""Independent truth: the rocking block in multi-precision arithmetic by Taylor series, no event jumped over.

Shares no code with the product. Slow (some 0.2 s per hundred samples): for tests, the chart and the answers of
resources/benchmark.
"""

from itertools import pairwise
from operator import mul
from typing import Any, NamedTuple

import mpmath as mp

ORDER = 24

BARE = ((1, 0), (1, 0))
"""A wall without loads."""


class Motion(NamedTuple):
    """A history: rotations at the samples [rad], impacts (time [s], velocity before, after [rad/s]), and the state at
    the last sample, `phi` and its rate `speed` seen from the pivot."""

    rotations: list
    impacts: list
    phi: Any
    speed: Any


def _coefficients(phi, speed, beta, slope, p2, alpha, branch, order=ORDER):
    """Taylor coefficients of phi; branch (sine, slope, constant) of the moment law over I0 p2.

    Computed in whole numbers of 2^-bits, ten times faster than in those of mpmath: they are never multiplied by a time
    above 1, so that no error grows.
    """
    bits = mp.mp.prec + 32

    def whole(value):
        return int(mp.ldexp(mp.mpf(value), bits))

    def product(one, other):
        return sum(map(mul, one, other)) >> bits

    s_factor, m, constant = map(whole, branch)
    beta, slope, p2 = map(whole, (beta, slope, p2))
    c, rates = [whole(phi), whole(speed)], []
    sine, cosine = [whole(mp.sin(alpha - phi))], [whole(mp.cos(alpha - phi))]
    for k in range(order - 1):
        moment = product((s_factor, m), (sine[k], c[k])) + (constant if k == 0 else 0)
        forcing = product((beta, slope), (cosine[k], cosine[k - 1] if k else 0))
        c.append(product((p2,), (forcing - moment,)) // ((k + 1) * (k + 2)))
        rates.append((k + 1) * c[k + 1])
        sine.append(-product(rates, reversed(cosine)) // (k + 1))
        cosine.append(product(rates, reversed(sine[:-1])) // (k + 1))
    return [mp.ldexp(mp.mpf(coefficient), -bits) for coefficient in c]


def _value(c, t):
    total = mp.mpf(0)
    for coefficient in reversed(c):
        total = total * t + coefficient
    return total


def _rate(c, t):
    return _value([k * c[k] for k in range(1, len(c))], t)


def _converged(c, h):
    """The largest of h, h/2, h/4, ... at which the last two terms are below the last digit of the largest."""
    while True:
        terms, power = [], mp.mpf(1)
        for coefficient in c[1:]:
            power *= h
            terms.append(abs(coefficient) * power)
        if max(terms[-2:]) <= mp.eps * max(terms):
            return h
        h /= 2


def _first_root(c, level, h):
    """First t in (0, h] where phi falls to (or passes) the level it started away from or on.

    Of q, phi - level over the power of t that a start on the level takes out: a part of (0, h] has no root where q in
    its middle, its slope there and a bound of q'' exclude one, and at most one where the slope keeps its sign.
    """
    q = [c[0] - level, *c[1:]]
    while len(q) > 1 and q[0] == 0:
        q = q[1:]
    if q[0] < 0:
        q = [-coefficient for coefficient in q]
    bend = _value([k * (k - 1) * abs(q[k]) for k in range(2, len(q))], h)
    parts = [(mp.mpf(0), h)]
    while parts:
        low, high = parts.pop()
        middle, half = (low + high) / 2, (high - low) / 2
        value, slope = _value(q, middle), _rate(q, middle)
        if value - abs(slope) * half - bend * half**2 / 2 > 0:
            continue
        if slope + bend * half < 0:
            if _value(q, high) <= 0:
                return _falling_root(q, low, high)
        elif half > h * mp.eps:
            parts += [(middle, high), (low, middle)]
        elif value <= 0:
            return middle
    return None


def _falling_root(q, low, high):
    """The root of a series that falls from low to high, by Newton's method within what the signs leave."""
    t = (low + high) / 2
    for _ in range(int(mp.mp.prec)):
        value = _value(q, t)
        low, high = (t, high) if value > 0 else (low, t)
        new = t - value / _rate(q, t)
        new = new if low <= new <= high else (low + high) / 2
        if abs(new - t) <= mp.eps * t:
            return new
        t = new
    return t


def history(ground, dt, alpha, p2, one_sided, ratio_of, kinks=None, gravity="9.80665", digits=30, loads=BARE):
    """Rotations at the samples [rad] and impacts [(time s, velocity before, velocity after rad/s)] from rest.

    ground, dt, alpha, p2 : exact numbers (float or mpf) [m/s2], [s], [rad], [1/s2];
    ratio_of : velocity ratio as a function of the impact speed; kinks : (phi1, phi2) or None;
    loads : (a, c) of positive and of negative rotations: the moment is a sin(alpha - phi) + c cos(alpha - phi), under a
    trilinear law beyond the plateau, whose moment it is at phi2.
    """
    with mp.workdps(digits):
        return motion(ground, dt, alpha, p2, one_sided, ratio_of, kinks, gravity, loads)[:2]


def motion(
    ground,
    dt,
    alpha,
    p2,
    one_sided,
    ratio_of,
    kinks=None,
    gravity="9.80665",
    loads=BARE,
    start=(0, 0),
    order=ORDER,
    last=mp.inf,
):
    """The Motion of a wall in the digits mpmath works with; parameters as of `history`.

    start : rotation [rad] and its rate [rad/s]; order : of the series; last : rotation [rad] beyond which it ends
    """
    alpha, p2, dt, g = mp.mpf(alpha), mp.mpf(p2), mp.mpf(dt), mp.mpf(gravity)
    side = 1 if mp.mpf(start[0]) >= 0 else -1
    phi, speed = abs(mp.mpf(start[0])), side * mp.mpf(start[1])
    moving = phi > 0
    levels = [mp.mpf(0)] if kinks is None else [mp.mpf(0), mp.mpf(kinks[0]), mp.mpf(kinks[1])]
    sine, cosine = ({1: mp.mpf(a), -1: mp.mpf(b)} for a, b in zip(*loads, strict=True))
    threshold = {s: mp.mpf(0) if kinks else sine[s] * mp.tan(alpha) + cosine[s] for s in (1, -1)}
    zone = sum(phi > level for level in levels[1:])
    rest_speed = mp.sqrt(p2) * alpha / 10**6
    rotations, impacts = [side * phi], []
    for i, (first, second) in enumerate(pairwise(ground)):
        b0, b1 = mp.mpf(first) / g, mp.mpf(second) / g
        rate = (b1 - b0) / dt
        t = mp.mpf(0)
        while t < dt:
            now = b0 + rate * t
            if not moving:
                if now > threshold[1]:
                    side = 1
                elif now < -threshold[-1] and not one_sided:
                    side = -1
                else:
                    t, side = _uplift(b0, rate, t, dt, threshold, one_sided)
                    if t is None:
                        break
                    now = side * threshold[side]
                phi, speed, zone, moving = mp.mpf(0), mp.mpf(0), 0, True
            branch = _branch(zone, levels, alpha, sine[side], cosine[side])
            held = cosine[side] if branch[0] else 0
            c = _coefficients(phi, speed, side * now - held, side * rate, p2, alpha, branch, order)
            if phi == 0 and speed == 0 and now == side * threshold[side]:
                c[2] = mp.mpf(0)
            h = _converged(c, dt - t)
            events = []
            lower = _first_root(c, levels[zone], h)
            if lower is not None:
                events.append((lower, -1))
            if zone + 1 < len(levels):
                upper = _first_root(c, levels[zone + 1], h)
                if upper is not None:
                    events.append((upper, 1))
            if not events:
                phi, speed, t = _value(c, h), _rate(c, h), dt if h == dt - t else t + h
                continue
            h, step = min(events)
            t += h
            speed = _rate(c, h)
            phi = levels[zone] if step < 0 else levels[zone + 1]
            if zone + step >= 0:
                zone += step
                continue
            before = side * speed
            speed = ratio_of(-speed) * -speed
            side = side if one_sided else -side
            impacts.append((i * dt + t, before, side * speed))
            now = b0 + rate * t
            lifts = now > threshold[1] or (now < -threshold[-1] and not one_sided)
            # of one that is stopped dead, the ground chooses the side again
            moving = speed > 0 and not (speed < rest_speed and not lifts)
        if not moving:
            phi, speed = mp.mpf(0), mp.mpf(0)
        rotations.append(side * phi)
        if phi > last:
            break
    return Motion(rotations, impacts, phi, speed)


def _branch(zone, levels, alpha, sine, cosine):
    if len(levels) == 1 or zone == 2:
        return sine, 0, 0
    plateau = sine * mp.sin(alpha - levels[2]) + cosine * mp.cos(alpha - levels[2])
    return (0, plateau / levels[1], 0) if zone == 0 else (0, 0, plateau)


def _uplift(b0, rate, t, dt, threshold, one_sided):
    if rate > 0:
        root, side = (threshold[1] - b0) / rate, 1
    elif rate < 0 and not one_sided:
        root, side = (-threshold[-1] - b0) / rate, -1
    else:
        return None, 1
    return (root, side) if t <= root < dt else (None, side)
