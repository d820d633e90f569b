"""Taylor series of order 6 or 8, one step per sample, events at the roots of the step's polynomial.

The ground acceleration is linear between samples, so Eq. 1 is analytic inside a sample and inside a
branch of the moment law. sin and cos of the lean follow from those of the upright block by the addition
theorem, so that no rounding is carried from step to step.
Cost: about 100 floating-point operations a step. Fails: nowhere found; a step whose series has not
converged is shortened until it has.
"""

import functools
import math

import numpy as np

from core import compile_beside
from core.fused import fma
from core.kernel_cache import inner_kernel, kernel, subkernel
from core.moment_rotation import FAR, moment_branch, zone_of
from core.rocking.bounds import converged_part, largest_push, neglected, turning_margin
from core.rocking.events import (
    IMPACTS_PER_SAMPLE,
    LAST_ROTATION,
    end_of_record,
    leave_impact,
    lift_threshold,
    next_uplift,
)
from core.rocking.outcome import COLLAPSED, IMPACT_LIMIT, STABLE
from core.rocking.polynomial import (
    change,
    first_crossing,
    increment,
    landing,
    part_turning_once,
    shape,
    summit,
)
from core.units import G

SHORT = 0.8
"""Rotation up to which the short series of sin and cos holds [rad]."""

PER_G = 1.0 / G


@inner_kernel
def series(speed, net, sine, cosine, beta, rise, p2, factor, slope, order):
    """Taylor coefficients v0..v8 of phi' about the step's start, time in steps, v7 = v8 = 0 for order 6
    (Eq. 1). The velocity is then of the named order, the rotation one higher.

    speed : [rad per step]; net : moment law less forcing at the start [-]; sine, cosine : of alpha - phi;
    beta : u''/g seen from the pivot [-]; rise : of it over the step [-]; p2 : p^2 times the step squared
    [-]; factor, slope : of the branch of the moment law. In each sum the term known last comes last.
    """
    factor, slope = -p2 * factor, -p2 * slope
    beta, rise = p2 * beta, p2 * rise
    v0 = speed
    v1 = -p2 * net
    s1 = -v0 * cosine
    k1 = v0 * sine
    v2 = 0.5 * fma(beta, k1, fma(factor, s1, fma(rise, cosine, slope * v0)))
    s2 = -0.5 * fma(v0, k1, v1 * cosine)
    k2 = 0.5 * fma(v0, s1, v1 * sine)
    v3 = (1.0 / 3.0) * fma(beta, k2, fma(factor, s2, fma(rise, k1, slope * (0.5 * v1))))
    s3 = (-1.0 / 3.0) * fma(v0, k2, fma(v2, cosine, v1 * k1))
    k3 = (1.0 / 3.0) * fma(v0, s2, fma(v2, sine, v1 * s1))
    v4 = 0.25 * fma(beta, k3, fma(factor, s3, fma(rise, k2, slope * ((1.0 / 3.0) * v2))))
    s4 = -0.25 * fma(v0, k3, fma(v3, cosine, fma(v1, k2, v2 * k1)))
    k4 = 0.25 * fma(v0, s3, fma(v3, sine, fma(v1, s2, v2 * s1)))
    v5 = 0.2 * fma(beta, k4, fma(factor, s4, fma(rise, k3, slope * (0.25 * v3))))
    s5 = -0.2 * fma(v0, k4, fma(v4, cosine, fma(v1, k3, fma(v3, k1, v2 * k2))))
    k5 = 0.2 * fma(v0, s4, fma(v4, sine, fma(v1, s3, fma(v3, s1, v2 * s2))))
    v6 = (1.0 / 6.0) * fma(beta, k5, fma(factor, s5, fma(rise, k4, slope * (0.2 * v4))))
    if order == 6:
        return v0, v1, v2, v3, v4, v5, v6, 0.0, 0.0
    s6 = fma(v0, k5, fma(v5, cosine, fma(v1, k4, fma(v4, k1, fma(v2, k3, v3 * k2)))))
    k6 = fma(v0, s5, fma(v5, sine, fma(v1, s4, fma(v4, s1, fma(v2, s3, v3 * s2)))))
    s6, k6 = (-1.0 / 6.0) * s6, (1.0 / 6.0) * k6
    v7 = fma(beta, k6, fma(factor, s6, fma(rise, k5, slope * ((1.0 / 6.0) * v5))))
    v7 = (1.0 / 7.0) * v7
    s7 = fma(v2, k4, v3 * k3)
    k7 = fma(v2, s4, v3 * s3)
    s7 = fma(v0, k6, fma(v6, cosine, fma(v1, k5, fma(v5, k1, fma(v4, k2, s7)))))
    k7 = fma(v0, s6, fma(v6, sine, fma(v1, s5, fma(v5, s1, fma(v4, s2, k7)))))
    v8 = fma(rise, k6, slope * ((1.0 / 7.0) * v6))
    v8 = 0.125 * fma((1.0 / 7.0) * beta, k7, fma((-1.0 / 7.0) * factor, s7, v8))
    return v0, v1, v2, v3, v4, v5, v6, v7, v8


@inner_kernel
def set_out(x, speed, s, c, side, first, second, t, dt, branch, model, constants):
    """What the series of a step from t to the end of the sample begins with: (speed [rad per step], net, sine,
    cosine, beta, rise, p2) of `series`, and the largest |u''|/g.

    x, speed : rotation [rad] and its rate [rad/s]; s, c : sin and cos of x; first, second : ground
    acceleration at the ends of the sample [m/s2]; branch : (factor, slope, constant) of the moment law.
    """
    _, tangent, sine_upright, cosine_upright = constants
    factor, slope, constant = branch
    rest_of_sample = 1.0 - t
    step = dt * rest_of_sample
    p2 = model.p2 * (step * step)
    pull = side * PER_G
    jump = second - first
    beta = pull * fma(jump, t, first)
    rise = pull * jump * rest_of_sample
    forcing = max(abs(first), abs(second)) * PER_G
    sine = fma(sine_upright, c, -cosine_upright * s)
    cosine = fma(cosine_upright, c, sine_upright * s)
    # factor sin(alpha - phi) - beta cos(alpha - phi), without its cancellation near uplift
    net = fma(-s, fma(factor, cosine_upright, beta * sine_upright), fma(slope, x, constant))
    net = fma(cosine_upright * fma(factor, tangent, -beta), c, net)
    return speed * step, net, sine, cosine, beta, rise, p2, forcing


@inner_kernel
def expansion(x, start, factor, slope, order):
    """(series of a step, see `series`; its growth, see core.rocking.bounds). start : of `set_out`."""
    speed, net, sine, cosine, beta, rise, p2, forcing = start
    v = series(speed, net, sine, cosine, beta, rise, p2, factor, slope, order)
    # at uplift phi'' is zero or outward; its rounding must not push the block down
    v1 = max(v[1], 0.0) if (x == 0.0) & (speed == 0.0) else v[1]
    v = (v[0], v1, v[2], v[3], v[4], v[5], v[6], v[7], v[8])
    return v, fma(p2, 1.0 + forcing + slope, speed * speed)


@inner_kernel
def sine_and_cosine_short(x):
    """sin and cos of a rotation up to SHORT by a short series, to full precision."""
    y = x * x
    z = y * y
    tail = fma(-y, 1.0 / 1307674368000.0, 1.0 / 6227020800.0)
    tail = fma(z, 1.0 / 355687428096000.0, tail)
    tail = fma(z, tail, fma(-y, 1.0 / 39916800.0, 1.0 / 362880.0))
    tail = fma(z, tail, fma(-y, 1.0 / 5040.0, 1.0 / 120.0))
    s = x * fma(z, tail, fma(-y, 1.0 / 6.0, 1.0))
    last = fma(-y, 1.0 / 6402373705728000.0, 1.0 / 20922789888000.0)
    tail = fma(z, last, fma(-y, 1.0 / 87178291200.0, 1.0 / 479001600.0))
    tail = fma(z, tail, fma(-y, 1.0 / 3628800.0, 1.0 / 40320.0))
    tail = fma(z, tail, fma(-y, 1.0 / 720.0, 1.0 / 24.0))
    return s, fma(z, tail, fma(-y, 0.5, 1.0))


@subkernel
def sine_and_cosine(x):
    """sin and cos of a rotation [rad]."""
    if x > SHORT:
        return math.sin(x), math.cos(x)
    return sine_and_cosine_short(x)


@subkernel
def upright(model):
    """(lift threshold [m/s2]; tan, sin and cos of alpha): what every sample needs of the model."""
    alpha = model.slenderness
    return lift_threshold(model), math.tan(alpha), math.sin(alpha), math.cos(alpha)


@subkernel
def lost(phi, speed, strongest, model):
    """Whether the block never comes back: even the strongest ground, pushing inward all the time, lets it
    over its barrier (energy, Eq. 1 beyond alpha).

    phi [rad]; speed : outward positive [rad/s]; strongest : bound of |u''|/g, FAR if it is to fall.
    """
    if phi > LAST_ROTATION:
        return True
    lean = phi - model.slenderness
    if lean <= 0.0 or speed <= 0.0:
        return False
    if math.tan(lean) >= strongest:
        return True
    top = math.sqrt(1.0 + strongest * strongest)
    barrier = top - math.cos(lean) - strongest * math.sin(lean)
    return speed * speed > 2.0 * model.p2 * barrier


@inner_kernel
def may_top(phi, dphi, speed, bend, reach, peak):
    """Whether a step that turns can go beyond the peak so far [rad]. bend : of `shape`; reach :
    how far the step strays from its chord [rad]."""
    return (max(phi, phi + dphi) + reach > peak) & (
        fma(speed, speed, 1.998 * bend * (peak - phi)) >= 0.0
    )


@functools.partial(inner_kernel, awaited=compile_beside.wait)
def through_sample(
    ground0, ground1, dt, model, constants, order, strongest, state, start
):  # fmt: skip
    """Carry the block to its next impact or through the sample; rest, uplift and kinks included.

    ground0, ground1 : ground acceleration at both ends [m/s2]; constants : of `upright`;
    strongest : of `lost`;
    state : (side, phi [rad], speed [rad/s], moving, zone, peak [rad], impacts, clamped);
    start : where in the sample the state is, 0 to 1.
    Returns (outcome so far, where in the sample, rotation speed after the impact [rad/s], state).
    """
    threshold, _, sine_upright, _ = constants
    side, phi, speed, moving, zone, peak, impacts, clamped = state
    alpha = model.slenderness
    jump = ground1 - ground0
    t = start  # in samples
    hit = 0.0
    outcome = STABLE
    kinks = 0
    while t < 1.0:
        if not moving:
            t, side = next_uplift(ground0, jump, t, 1.0, model, threshold)
            if t >= 1.0:
                break
            moving = True
            phi = 0.0
            speed = 0.0
            zone = zone_of(phi, model)
        low, high, factor, slope, constant = moment_branch(zone, model)
        s, c = sine_and_cosine(phi)
        branch = factor, slope, constant
        begun = set_out(phi, speed, s, c, side, ground0, ground1, t, dt, branch, model, constants)
        v, growth = expansion(phi, begun, factor, slope, order)
        rise, p2, forcing = begun[5], begun[6], begun[7]
        tail = neglected(v, growth, forcing, rise, p2, order)
        part = converged_part(tail, growth, order, alpha)
        # a chord stays within 1/8 max|phi''| of the curve, one of the speed within the margin: far from
        # both ends of the branch, or moving away from it, nothing happens
        dphi = increment(v, part)
        dv = change(v, part)
        push = largest_push(max(phi, phi + dphi), forcing, p2, sine_upright)
        reach = 0.125 * push
        margin = turning_margin(v[0], dv, rise, forcing + slope, p2, push)
        falls = min(phi, phi + dphi) - low <= reach and min(v[0], v[0] + dv) <= margin
        rises = high - max(phi, phi + dphi) <= reach and max(v[0], v[0] + dv) >= -margin
        crossing = -1.0
        bend, stays = 0.0, True
        if falls or rises:
            bend, _, stays = shape(v, phi - low, dphi, dv, part)
        if rises and bend >= 0.0:
            part = part_turning_once(v, part)
        if falls and not stays:
            crossing, _, found = landing(v, phi - low, part)
            if not found:
                part = part_turning_once(v, part)
                crossing = first_crossing(v, phi - low, 1.0, part)
        if rises:
            above = first_crossing(v, phi - high, -1.0, part)
            falls = not (above >= 0.0 and (crossing < 0.0 or above < crossing))
            crossing = crossing if falls else above
        if crossing >= 0.0:
            part = crossing
        dphi = increment(v, part)
        dv = change(v, part)
        if min(v[0], -(v[0] + dv)) > -2.0 * margin and may_top(phi, dphi, v[0], bend, reach, peak):
            peak = max(peak, phi + summit(v, part))
        speed = fma(dv, 1.0 / (dt * (1.0 - t)), speed)
        t = fma(part, 1.0 - t, t) if part < 1.0 else 1.0
        if crossing < 0.0:
            phi += dphi
            peak = max(peak, phi)
            if phi > SHORT and lost(phi, speed, strongest, model):
                outcome = COLLAPSED
                break
            continue
        if falls and low == 0.0:
            phi = 0.0
            speed, after, side, moving, clamp = leave_impact(
                max(-speed, 0.0), side, ground0 + jump * t, model, threshold
            )
            hit = after * speed
            speed = speed if moving else 0.0
            impacts += 1
            clamped += clamp
            break
        phi = low if falls else high
        zone += -1 if falls else 1
        peak = max(peak, phi)
        kinks += 1
        if kinks > IMPACTS_PER_SAMPLE:
            outcome = IMPACT_LIMIT
            break
    return outcome, t, hit, (side, phi, speed, moving, zone, peak, impacts, clamped)


def integrate_by(order):
    """The kernel `integrate` of order 6 or 8, which the compiler is to know: it leaves other terms out."""

    @kernel
    def integrate(
        ground, dt, scale, model, start, rotation, velocity, impact_time, impact_velocity
    ):
        """Rocking history of one wall under one scaled record (Eq. 1), rest, uplift and impacts included.

        ground : ground acceleration [m/s2], shape (n,); dt : its time step [s]; scale : multiplier [-],
        negative for the reversed record; model : RockingModel; start : initial rotation [rad] and
        velocity [rad/s]; rotation, velocity : results at the samples [rad], [rad/s], shape (n,);
        impact_time, impact_velocity : results [s], [rad/s] just after each impact.
        Returns (outcome, peak rotation [rad], impacts, clamped ratios, samples done).
        """
        constants = upright(model)
        zero = np.int64(0)  # a plain 0 would be a type of its own, and compile everything again
        side = -1.0 if start[0] < 0.0 or (start[0] == 0.0 and start[1] < 0.0) else 1.0
        phi = side * start[0]
        moving = phi != 0.0 or start[1] != 0.0
        state = (side, phi, side * start[1], moving, zone_of(phi, model), phi, zero, zero)
        rotation[0] = start[0]
        velocity[0] = start[1]
        for i in range(ground.size - 1):
            t = 0.0
            before = state[6]
            while t < 1.0:
                impacts = state[6]
                outcome, t, hit, state = through_sample(
                    scale * ground[i], scale * ground[i + 1], dt, model, constants, order, FAR,
                    state, t,
                )  # fmt: skip
                if impacts < state[6] and impacts < impact_time.size:
                    impact_time[impacts] = i * dt + t * dt
                    impact_velocity[impacts] = hit
                if state[6] - before > IMPACTS_PER_SAMPLE:
                    outcome = IMPACT_LIMIT
                if outcome != STABLE:
                    return outcome, state[5], state[6], state[7], i + 1
            rotation[i + 1] = state[0] * state[1] if state[3] else 0.0
            velocity[i + 1] = state[0] * state[2] if state[3] else 0.0
        outcome, peak = at_end(state, model)
        return outcome, peak, state[6], state[7], ground.size

    return integrate


INTEGRATE = {order: integrate_by(order) for order in (6, 8)}


@subkernel
def at_end(state, model):
    """(outcome, peak [rad]) once the ground is still, from the state after the last sample."""
    if state[3]:
        return end_of_record(state[1], state[2], state[5], model)
    return STABLE, state[5]
