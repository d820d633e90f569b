"""The elastic branch of a wall without plateau, solved in closed form.

On it the wall is the linear oscillator of Circolare 7/2019 C8.7.1.2.1.3, phi'' = -omega^2 phi + p2 cos(alpha - phi1)
u''/g: the ground pushes with the arm it has at the end of the branch, phi1. Between samples u'' is linear in time, so
that with x = omega t and what the ground would hold the wall at, f(x) = f0 + f1 x,
    phi(x) = phi0 + u0 sin x + a0 (1 - cos x) + f1 (x - sin x),   u = phi'/omega,   a0 = f0 - phi0
whatever the period: a step of the series takes a sixteenth of a sample there (resources/docs/physics.md, section 6).
"""

import math
from typing import NamedTuple

from core.jit.decorators import inner_kernel, subkernel
from core.jit.fma import fma
from core.rocking.events import BlockState
from core.rocking.short_series import SHORT_SERIES, sine_and_cosine_short

SWING_ENDS, SWING_FALLS, SWING_RISES = 0, 1, 2
"""Ends of a swing: the sample, or a part of it; an impact; the end of the branch."""

MAX_SPAN = 2.0 * SHORT_SERIES
"""Longest part of a swing [rad]: below pi, so that the rotation turns twice at most in it."""

MIN_SPAN = 1e-3
"""Part of a swing [rad] in which two turning points are not told apart: the rotation between them is below 1e-10 of the
amplitude."""

MAX_LAST_STEP = 1e-6
"""Newton's step [rad] after which the third-order one is exact to rounding."""


class Oscillation(NamedTuple):
    """Constants of the branch that every sample needs.

    rate : omega [rad/s]
    static : rotation under a steady ground acceleration [rad per m/s2]
    end : phi1 [rad]
    span : omega dt, and its sine and 1 - cosine, where it is below MAX_SPAN [-]
    """

    rate: float
    static: float
    end: float
    span: float
    sine: float
    versine: float


@inner_kernel
def sine_and_versine(x):
    """sin x and 1 - cos x of a part of a swing [rad], the latter without cancellation."""
    sine, cosine = sine_and_cosine_short(0.5 * x)
    return 2.0 * sine * cosine, 2.0 * sine * sine


@subkernel
def swing_of(driven, model, dt):
    """Swing of a model and the time step of the record [s]; None where no oscillator is in it. driven : of the model"""
    if driven is None:
        return None
    rate = math.sqrt(model.p2 * driven.stiffness)
    span = rate * dt
    sine, versine = sine_and_versine(min(span, MAX_SPAN))
    return Oscillation(rate, driven.static, model.elastic_end, span, sine, versine)


@inner_kernel
def is_oscillating(driven, zone):
    """Whether a wall is on its branch in closed form. driven : of the model, which decides at compile time"""
    if driven is None:
        return False
    return zone == 0


@inner_kernel
def swing_on(parts, state, ground, jump, t):
    """`advance_oscillation`; for a wall without a branch in closed form, which is never on it, the state as it is."""
    if parts is None:
        return state, t, SWING_ENDS
    return advance_oscillation(parts, state, ground, jump, t)


@inner_kernel
def state_on(state, zone):
    """BlockState on another branch of the moment law."""
    return BlockState(state.side, state.phi, state.speed, True, zone, state.peak, state.impacts, state.clamped)


@inner_kernel
def branch_stride(driven):
    """How far the number of a branch is from that of the next one: without a plateau there are two, 0 and 2."""
    return 1 if driven is None else 2


@subkernel
def turning_time(u0, a0, f1, amplitude):
    """First time [rad] at which a rotation that rises turns; amplitude : of its swing about f(x), more than |f1|."""
    time = math.atan2(a0, u0 - f1) + math.acos(max(-1.0, min(1.0, -f1 / amplitude)))
    turn = 2.0 * math.pi
    return time - turn * math.floor(time / turn)


@subkernel
def falling_root(gap, u0, a0, f1, span):
    """First time in (0, span] [rad] at which gap + u0 sin x + a0 (1 - cos x) + f1 (x - sin x) falls to zero. It is not
    positive at the end, and until there it only falls, or rises and then falls. Newton in a bracket, from the root of
    the parabola, the last step of third order."""
    low, high = 0.0, span
    root = math.sqrt(max(u0 * u0 - 2.0 * a0 * gap, 0.0))
    if u0 < 0.0:
        time = 2.0 * gap / (root - u0)
    else:
        time = -(u0 + root) / a0 if a0 < 0.0 else span
    if not 0.0 < time < span:
        time = span
    for _ in range(60):
        sine, versine = sine_and_versine(time)
        moved = fma(u0, sine, fma(a0, versine, f1 * (time - sine)))
        speed = fma(-u0, versine, fma(a0, sine, f1 * versine)) + u0
        if speed >= 0.0:
            low, high = (low, time) if u0 < 0.0 else (time, high)
            time = 0.5 * (low + high)
            continue
        off = gap + moved
        low, high = (time, high) if off > 0.0 else (low, time)
        step = off / speed
        if abs(step) < MAX_LAST_STEP:
            bend = a0 + f1 * time - moved
            return max(0.0, min(span, time - step * (1.0 + 0.5 * bend * step / speed)))
        time -= step
        if not low < time < high:
            time = 0.5 * (low + high)
    return time


@subkernel
def advance_oscillation(parts, state, ground, jump, t):
    """Carry a wall on its branch to the next event, or to the end of the sample or of a part of it; returns
    (BlockState, t, SWING_ENDS, SWING_FALLS or SWING_RISES).

    parts : Swing
    state : BlockState at t, its zone that of the branch
    ground, jump : ground acceleration at the start of the sample and its change over it [m/s2]
    t : where in the sample it is, 0 to 1
    """
    span, phi, u0 = parts.span * (1.0 - t), state.phi, state.speed / parts.rate
    f0 = parts.static * state.side * fma(jump, t, ground)
    f1 = parts.static * state.side * jump / parts.span
    a0, part, sine, versine = f0 - phi, 1.0, parts.sine, parts.versine
    while span > MAX_SPAN:
        span *= 0.5
        part *= 0.5
    if part < 1.0 or t > 0.0:
        sine, versine = sine_and_versine(span)
    square = fma(a0, a0, (u0 - f1) * (u0 - f1))
    while True:
        dphi = fma(u0, sine, fma(a0, versine, f1 * (span - sine)))
        u1 = fma(-u0, versine, fma(a0, sine, f1 * versine)) + u0
        a1 = fma(f1, span, a0) - dphi
        twice = (u0 < 0.0) == (u1 < 0.0) and (a0 > 0.0) == (u0 < 0.0) and (a1 > 0.0) != (a0 > 0.0)
        if not twice or f1 * f1 >= square or span < MIN_SPAN:
            break
        span *= 0.5
        part *= 0.5
        sine, versine = sine_and_versine(span)
    y, end, peak = phi + dphi, parts.end, state.peak
    line_low, line_high = f0 + min(0.0, f1 * span), f0 + max(0.0, f1 * span)
    swung = math.sqrt(max(square - f1 * f1, 0.0))
    falls, rises, until = y <= 0.0, y >= end, span
    if u0 < 0.0 and u1 > 0.0 and not falls and line_low - swung <= 0.0:
        turn = turning_time(-u0, -a0, -f1, math.sqrt(square))
        if f0 + f1 * turn - swung <= 0.0:
            falls, until = True, min(turn, span)
    top = phi
    if u0 >= 0.0 and u1 < 0.0 and line_high + swung > min(peak, end):
        turn = turning_time(u0, a0, f1, math.sqrt(square))
        top = f0 + f1 * turn + swung
        if top >= end:
            rises, until = True, min(turn, span)
    rises &= u0 >= 0.0 or u1 > 0.0
    if phi >= end and u0 >= 0.0:
        return (
            BlockState(state.side, end, state.speed, True, 0, max(peak, end), state.impacts, state.clamped),
            t,
            SWING_RISES,
        )
    if rises and not (falls and u0 < 0.0):
        event, x = SWING_RISES, falling_root(end - phi, -u0, -a0, -f1, until)
        y, peak = end, max(peak, end)
    elif falls:
        event, x = SWING_FALLS, falling_root(phi, u0, a0, f1, until)
        y, peak = 0.0, max(peak, top)
    else:
        event, x, peak = SWING_ENDS, span, max(peak, max(y, top))
    if event != SWING_ENDS:
        sine, versine = sine_and_versine(x)
        u1 = fma(-u0, versine, fma(a0, sine, f1 * versine)) + u0
        t = min(t + x / parts.span, 1.0)
    else:
        t = fma(part, 1.0 - t, t) if part < 1.0 else 1.0
    return BlockState(state.side, y, parts.rate * u1, True, 0, peak, state.impacts, state.clamped), t, event
