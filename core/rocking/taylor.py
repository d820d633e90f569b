"""Taylor series of order 6 or 8, one step per sample, events at the roots of the step's polynomial.

The ground acceleration is linear between samples, so Eq. 1 is analytic inside a sample and inside a
branch of the moment law. sin and cos of the lean follow from those of the upright block by the addition
theorem, so that no rounding is carried from step to step.
Cost: about 100 floating-point operations a step. Fails: nowhere found; a step whose series has not
converged is shortened until it has.
"""

import math

from core.kernel_cache import inner_kernel, kernel
from core.moment_rotation import FAR, moment_branch, zone_of
from core.rocking.events import (
    IMPACTS_PER_SAMPLE,
    LAST_ROTATION,
    LOOK_EVERY,
    end_of_record,
    leave_impact,
    lift_threshold,
    next_uplift,
    remaining_push,
    settled,
)
from core.rocking.outcome import COLLAPSED, IMPACT_LIMIT, STABLE
from core.rocking.polynomial import (
    first_crossing,
    increment,
    rate,
    summit,
    turns_at_most_once,
)
from core.units import G

SMALL_BOUNCE = 1e-3
"""Speed over p alpha below which a bounce takes the short series."""

SERIES_TOLERANCE = 1e-17
"""Largest neglected term of a step, as a fraction of alpha."""


@inner_kernel
def series(phi, speed, net, sine, cosine, beta, slope, p2, branch, order):
    """Taylor coefficients c0..c9 of phi(t) about the step's start, c8 = c9 = 0 for order 6 (Eq. 1).
    The velocity is then of the named order, the rotation one higher.

    net : moment law less forcing at the start [-]; sine, cosine : of alpha - phi [-];
    beta : u''/g seen from the pivot [-]; slope : its rate [1/s].
    """
    _, _, s, m, _ = branch
    v0 = speed
    v1 = -p2 * net
    c2 = 0.5 * v1
    s1 = -v0 * cosine
    k1 = v0 * sine
    a = -p2 * (s * s1 + m * v0 - beta * k1 - slope * cosine)
    v2 = 0.5 * a
    c3 = v2 * (1.0 / 3.0)
    s2 = -0.5 * (v0 * k1 + v1 * cosine)
    k2 = 0.5 * (v0 * s1 + v1 * sine)
    a = -p2 * (s * s2 + m * c2 - beta * k2 - slope * k1)
    v3 = a * (1.0 / 3.0)
    c4 = 0.25 * v3
    s3 = (-1.0 / 3.0) * (v0 * k2 + v1 * k1 + v2 * cosine)
    k3 = (1.0 / 3.0) * (v0 * s2 + v1 * s1 + v2 * sine)
    a = -p2 * (s * s3 + m * c3 - beta * k3 - slope * k2)
    v4 = 0.25 * a
    c5 = 0.2 * v4
    s4 = -0.25 * (v0 * k3 + v1 * k2 + v2 * k1 + v3 * cosine)
    k4 = 0.25 * (v0 * s3 + v1 * s2 + v2 * s1 + v3 * sine)
    a = -p2 * (s * s4 + m * c4 - beta * k4 - slope * k3)
    v5 = 0.2 * a
    c6 = v5 * (1.0 / 6.0)
    s5 = -0.2 * (v0 * k4 + v1 * k3 + v2 * k2 + v3 * k1 + v4 * cosine)
    k5 = 0.2 * (v0 * s4 + v1 * s3 + v2 * s2 + v3 * s1 + v4 * sine)
    a = -p2 * (s * s5 + m * c5 - beta * k5 - slope * k4)
    v6 = a * (1.0 / 6.0)
    c7 = v6 * (1.0 / 7.0)
    if order == 6:
        return phi, v0, c2, c3, c4, c5, c6, c7, 0.0, 0.0
    s6 = (-1.0 / 6.0) * (v0 * k5 + v1 * k4 + v2 * k3 + v3 * k2 + v4 * k1 + v5 * cosine)
    k6 = (1.0 / 6.0) * (v0 * s5 + v1 * s4 + v2 * s3 + v3 * s2 + v4 * s1 + v5 * sine)
    a = -p2 * (s * s6 + m * c6 - beta * k6 - slope * k5)
    v7 = a * (1.0 / 7.0)
    c8 = 0.125 * v7
    s7 = v0 * k6 + v1 * k5 + v2 * k4 + v3 * k3 + v4 * k2 + v5 * k1 + v6 * cosine
    k7 = v0 * s6 + v1 * s5 + v2 * s4 + v3 * s3 + v4 * s2 + v5 * s1 + v6 * sine
    a = -p2 * ((-1.0 / 7.0) * s * s7 + m * c7 - (1.0 / 7.0) * beta * k7 - slope * k6)
    c9 = a * (1.0 / 72.0)
    return phi, v0, c2, c3, c4, c5, c6, c7, c8, c9


@inner_kernel
def sine_and_cosine_short(x):
    """sin and cos of a rotation up to 0.25 rad by a short series, to full precision."""
    y = x * x
    tail = 1.0 / 5040.0 - y * (1.0 / 362880.0 - y * (1.0 / 39916800.0))
    s = x * (1.0 - y * (1.0 / 6.0 - y * (1.0 / 120.0 - y * tail)))
    tail = 1.0 / 720.0 - y * (1.0 / 40320.0 - y * (1.0 / 3628800.0 - y * (1.0 / 479001600.0)))
    return s, 1.0 - y * (0.5 - y * (1.0 / 24.0 - y * tail))


@kernel
def sine_and_cosine(x):
    """sin and cos of a rotation [rad]."""
    if x > 0.25:
        return math.sin(x), math.cos(x)
    return sine_and_cosine_short(x)


@kernel
def converged_step(c, h, order, stiffness, alpha):
    """Largest h / 2^n at which the first neglected term is below SERIES_TOLERANCE alpha.

    stiffness : p2 (1 + |beta| + slope of the branch) + phi'^2 [1/s2], the square of the rate at which
    the terms of the series can grow.
    """
    for _ in range(60):
        square = h * h
        power = square * square * h
        if order == 8:
            tail = power * square * h * (abs(c[8]) + h * abs(c[9]))
            ratio = stiffness * square * (1.0 / 90.0)
        else:
            tail = power * h * (abs(c[6]) + h * abs(c[7]))
            ratio = stiffness * square * (1.0 / 56.0)
        if tail * ratio <= SERIES_TOLERANCE * alpha and ratio < 0.05:
            break
        h *= 0.5
    return h


@inner_kernel
def turning_margin(speed, after, rise, forcing, p2, push, h):
    """How far the speed [rad/s] can leave its chord within a step: h^2 / 8 by the bound of its second
    derivative, after Eq. 1.

    speed, after : at both ends; rise : of the forcing u''/g over the step [-]; forcing : its bound plus
    the slope of the moment law [-]; push : bound of the angular acceleration [1/s2].
    """
    fastest = max(abs(speed), abs(after)) + push * h
    return 0.125 * h * p2 * (h * fastest * (1.0 + forcing) + abs(rise))


@inner_kernel
def small_bounce(speed, net, sine, cosine, beta, slope, p2):
    """Flight of a small bounce from theta = 0, rigid law, by its series of fourth order (Eq. 1).

    Returns (flight time [s], speed at its end, highest point); time -1 where the bounce is not that
    simple. For speeds below SMALL_BOUNCE p alpha what is left out is below 1e-11 of p alpha.
    """
    v1 = -p2 * net
    c2 = 0.5 * v1
    s1 = -speed * cosine
    k1 = speed * sine
    v2 = -0.5 * p2 * (s1 - beta * k1 - slope * cosine)
    s2 = -0.5 * (speed * k1 + v1 * cosine)
    k2 = 0.5 * (speed * s1 + v1 * sine)
    c4 = (-1.0 / 12.0) * p2 * (s2 - beta * k2 - slope * k1)
    c3 = v2 * (1.0 / 3.0)
    t = -speed / c2
    if not (c2 < 0.0 and abs(c3) * t < -5e-3 * c2 and abs(c4) * t * t < -1e-5 * c2):
        return -1.0, 0.0, 0.0
    for _ in range(4):
        value = speed + t * (c2 + t * (c3 + t * c4))
        t -= value / (c2 + t * (2.0 * c3 + t * 3.0 * c4))
    top = -0.5 * speed / c2
    highest = top * (speed + top * (c2 + top * (c3 + top * c4)))
    return t, speed + t * (2.0 * c2 + t * (3.0 * c3 + t * 4.0 * c4)), highest


@kernel
def upright(model):
    """Lift threshold [m/s2], sin(alpha) and cos(alpha): what every sample needs of the model."""
    return lift_threshold(model), math.sin(model.slenderness), math.cos(model.slenderness)


@inner_kernel
def land(speed, side, ground, time, model, threshold, impacts, clamped, times, velocities):
    """An impact at theta = 0: (speed, side, moving, impacts, clamped) after it, noted in times [s] and
    velocities [rad/s]. speed : just before it, inward negative (Eq. 3, 7)."""
    speed, after, side, moving, clamp = leave_impact(
        max(-speed, 0.0), side, ground, model, threshold
    )
    if impacts < times.size:
        times[impacts] = time
        velocities[impacts] = after * speed
    if not moving:
        speed = 0.0
    return speed, side, moving, impacts + 1, clamped + clamp


@kernel
def through_sample(
    ground0, ground1, dt, model, constants, order, state, start_time, impact_time, impact_velocity
):
    """Carry the block through one sample, rest, uplift, kinks and impacts included.

    ground0, ground1 : ground acceleration at both ends [m/s2]; constants : of `upright`;
    state : (side, phi [rad], speed [rad/s], moving, zone, peak [rad], impacts, clamped);
    start_time [s] and the last two arguments : as `integrate`. Returns (outcome so far, state).
    """
    threshold, sine_upright, cosine_upright = constants
    side, phi, speed, moving, zone, peak, impacts, clamped = state
    alpha = model.slenderness
    p2 = model.p2
    small = SMALL_BOUNCE * math.sqrt(p2) * alpha if threshold > 0.0 else 0.0
    slope = (ground1 - ground0) / dt
    t = 0.0
    impacts_before = impacts
    events = 0
    while t < dt:
        if not moving:
            t, side = next_uplift(ground0, slope, t, dt, model, threshold)
            if t >= dt:
                break
            moving = True
            phi = 0.0
            speed = 0.0
            zone = zone_of(phi, model)
        branch = moment_branch(zone, model)
        beta = (side / G) * (ground0 + slope * t)
        if phi == 0.0 and 0.0 < speed < small:
            net = cosine_upright * (threshold - side * (ground0 + slope * t)) / G
            flight, landing, highest = small_bounce(
                speed, net, sine_upright, cosine_upright, beta, side / G * slope, p2
            )
            if 0.0 < flight < dt - t:
                t += flight
                peak = max(peak, highest)
                speed, side, moving, impacts, clamped = land(
                    landing, side, ground0 + slope * t, start_time + t, model, threshold,
                    impacts, clamped, impact_time, impact_velocity,
                )  # fmt: skip
                if impacts - impacts_before > IMPACTS_PER_SAMPLE:
                    return IMPACT_LIMIT, (side, phi, speed, moving, zone, peak, impacts, clamped)
                continue
        s, k = sine_and_cosine(phi)
        sine = sine_upright * k - cosine_upright * s
        cosine = cosine_upright * k + sine_upright * s
        if threshold > 0.0:
            # sin(alpha - phi) - beta cos(alpha - phi) without its cancellation near uplift
            short = (threshold - side * (ground0 + slope * t)) / G
            net = cosine_upright * short * k - (cosine_upright + beta * sine_upright) * s
        else:
            net = branch[2] * sine + branch[3] * phi + branch[4] - beta * cosine
        c = series(phi, speed, net, sine, cosine, beta, side / G * slope, p2, branch, order)
        if phi == 0.0 and speed == 0.0:
            # at uplift phi'' is zero or outward; its rounding must not push the block down
            c = (phi, speed, max(c[2], 0.0), c[3], c[4], c[5], c[6], c[7], c[8], c[9])
        push = p2 * (1.0 + max(abs(ground0), abs(ground1)) / G)
        stiff = push + p2 * branch[3] + speed * speed
        h = converged_step(c, dt - t, order, stiff, alpha)
        # a chord stays within h^2/8 max|phi''| of the curve: far from both ends nothing happens
        dphi = increment(c, h)
        reach = 0.125 * h * h * push
        crossing = -1.0
        falling = True
        if min(phi, phi + dphi) - branch[0] <= reach or branch[1] - max(phi, phi + dphi) <= reach:
            for _ in range(30):
                if turns_at_most_once(c, h):
                    break
                h *= 0.5
            crossing = first_crossing(c, branch[0], 1.0, h)
            if branch[1] < FAR:
                upper = first_crossing(c, branch[1], -1.0, h)
                if upper >= 0.0 and (crossing < 0.0 or upper < crossing):
                    crossing = upper
                    falling = False
            if crossing >= 0.0:
                h = crossing
            dphi = increment(c, h)
        speed_after = rate(c, h)
        forcing = max(abs(ground0), abs(ground1)) / G + branch[3]
        margin = turning_margin(speed, speed_after, h * slope / G, forcing, p2, push, h)
        if min(speed, -speed_after) > -margin and max(phi, phi + dphi) + reach > peak:
            peak = max(peak, phi + summit(c, h))
        t = t + h if h < dt - t else dt
        speed = speed_after
        if crossing < 0.0:
            phi += dphi
            peak = max(peak, phi)
            if phi > LAST_ROTATION:
                return COLLAPSED, (side, phi, speed, moving, zone, peak, impacts, clamped)
            continue
        events += 1
        if events > 10 * IMPACTS_PER_SAMPLE:
            return IMPACT_LIMIT, (side, phi, speed, moving, zone, peak, impacts, clamped)
        if not falling or branch[0] > 0.0:
            phi = branch[0] if falling else branch[1]
            zone += -1 if falling else 1
            peak = max(peak, phi)
            continue
        phi = 0.0
        speed, side, moving, impacts, clamped = land(
            speed, side, ground0 + slope * t, start_time + t, model, threshold, impacts, clamped,
            impact_time, impact_velocity,
        )  # fmt: skip
        if impacts - impacts_before > IMPACTS_PER_SAMPLE:
            return IMPACT_LIMIT, (side, phi, speed, moving, zone, peak, impacts, clamped)
    return STABLE, (side, phi, speed, moving, zone, peak, impacts, clamped)


@kernel
def integrate(
    ground, dt, scale, model, order, start, rotation, velocity, impact_time, impact_velocity
):
    """Rocking history of one wall under one scaled record (Eq. 1), rest, uplift and impacts included.

    ground : ground acceleration [m/s2], shape (n,); dt : its time step [s]; scale : multiplier [-],
    negative for the reversed record; model : RockingModel; order : 6 or 8; start : initial rotation
    [rad] and velocity [rad/s]; rotation, velocity : results at the samples [rad], [rad/s], shape (n,)
    or (0,) if not wanted; impact_time, impact_velocity : results [s], [rad/s] just after each impact.
    Returns (outcome, peak rotation [rad], impacts, clamped ratios, samples done).
    """
    constants = upright(model)
    keep = rotation.size > 0
    # without a history to write nothing is integrated that decides nothing; Eq. 7 counts its clamps
    stops = not keep and model.ratio_drop == 0.0
    left = remaining_push(ground, dt) if stops else impact_time
    side = -1.0 if start[0] < 0.0 or (start[0] == 0.0 and start[1] < 0.0) else 1.0
    phi = side * start[0]
    moving = phi != 0.0 or start[1] != 0.0
    state = (side, phi, side * start[1], moving, zone_of(phi, model), phi, 0, 0)
    if keep:
        rotation[0] = start[0]
        velocity[0] = start[1]
    for i in range(ground.size - 1):
        outcome, state = through_sample(
            scale * ground[i], scale * ground[i + 1], dt, model, constants, order, state, i * dt,
            impact_time, impact_velocity,
        )  # fmt: skip
        if outcome != STABLE:
            return outcome, state[5], state[6], state[7], i + 1
        if stops and i % LOOK_EVERY == 0:
            push = abs(scale) * left[i + 1]
            if settled(state[1], state[2], state[5], push, model):
                return STABLE, state[5], state[6], state[7], i + 2
        if keep:
            rotation[i + 1] = state[0] * state[1] if state[3] else 0.0
            velocity[i + 1] = state[0] * state[2] if state[3] else 0.0
    outcome, peak = at_end(state, model)
    return outcome, peak, state[6], state[7], ground.size


@kernel
def at_end(state, model):
    """(outcome, peak [rad]) once the ground is still, from the state after the last sample."""
    if state[3]:
        return end_of_record(state[1], state[2], state[5], model)
    return STABLE, state[5]
