"""One sample by a method that only knows one step: uplift, impacts and kinks located by root finding.

A crossing is seen at the end of a step; a dip and return within one step is missed (Taylor sees it).
"""

from core.jit.decorators import inner_kernel, subkernel
from core.rocking.compared import dormand_prince, linearised, newmark_events, rk4
from core.rocking.events import IMPACTS_PER_SAMPLE, LAST_ROTATION, BlockState, apply_impact, next_uplift
from core.rocking.outcome import COLLAPSED, IMPACT_LIMIT, STABLE
from core.units import G
from core.wall.moment_rotation import moment_branch, zone_of
from core.wall.rocking_model import seen_from

NEWMARK_EVENTS = 2
RK4 = 3
DORMAND_PRINCE = 4
LINEARISED = 5


@subkernel
def advance(code, phi, speed, beta, slope, h, model, zone, tolerance, table, rates, pushes):
    """Rotation [rad] and velocity [rad/s] after one step by the method of this code.

    code : one of this module
    phi : rotation at its start, seen from the pivot [rad]
    speed : velocity at its start [rad/s]
    beta : u''/g at its start, seen from the pivot [-]
    slope : rate of beta [1/s]
    h : its length [s]
    model : RockingModel as the pivot sees it
    zone : branch of the moment law
    tolerance : of dormand_prince [-]
    table : of `Method.table` [-]
    rates, pushes : room for the stages of dormand_prince [rad/s], [rad/s2]
    """
    if code == NEWMARK_EVENTS:
        return newmark_events.advance(phi, speed, beta, slope, h, model, zone)
    if code == RK4:
        return rk4.advance(phi, speed, beta, slope, h, model, zone)
    if code == LINEARISED:
        return linearised.advance(phi, speed, beta, slope, h, model, zone)
    return dormand_prince.advance(phi, speed, beta, slope, h, model, zone, tolerance, table, rates, pushes)


@subkernel
def locate(code, phi, speed, beta, slope, h, model, zone, tolerance, table, rates, pushes, level, sign):
    """Length of the step [s] at which sign * (phi - level) falls to zero, between 0 and h: Newton inside
    a bracket on the method's own step. 0.0 for a start on the level that only falls.

    code : one of this module
    phi : rotation at its start, seen from the pivot [rad]
    speed : velocity at its start [rad/s]
    beta : u''/g at its start, seen from the pivot [-]
    slope : rate of beta [1/s]
    h : length of the step that crosses the level [s]
    model : RockingModel as the pivot sees it
    zone : branch of the moment law
    tolerance : of dormand_prince [-]
    table : of `Method.table` [-]
    rates, pushes : room for the stages of dormand_prince [rad/s], [rad/s2]
    level : end of the branch that is crossed [rad]
    sign : 1.0 where it is crossed downwards, -1.0 upwards
    """
    low = 0.0
    high = h
    if phi == level:
        low = h
        for _ in range(60):
            low *= 0.5
            x, _ = advance(code, phi, speed, beta, slope, low, model, zone, tolerance, table, rates, pushes)
            if sign * (x - level) > 0.0:
                break
            high = low
        else:
            return 0.0
    time = 0.5 * (low + high)
    for _ in range(100):
        x, v = advance(code, phi, speed, beta, slope, time, model, zone, tolerance, table, rates, pushes)
        if x == level:
            return time
        if sign * (x - level) > 0.0:
            low = time
        else:
            high = time
        following = time - (x - level) / v if v != 0.0 else 0.5 * (low + high)
        if not (low < following < high):
            following = 0.5 * (low + high)
        if following == time or following in (low, high):
            break
        time = following
    return time


@inner_kernel
def through_sample(
    code,
    ground0,
    ground1,
    start,
    dt,
    model,
    thresholds,
    option,
    state,
    impact_time,
    impact_velocity,
    table,
    rates,
    pushes,
):
    """Carry the block over one sample; see `comparison.integrate_comparison`.

    Length: one loop over the events of a sample; steps, branches of the law and impacts change the same state.

    code : one of this module
    ground0, ground1 : ground acceleration at both ends [m/s2]
    start : time of its start [s]
    dt : the sample [s]
    model : RockingModel
    thresholds : of `uplift_thresholds` [m/s2]
    option : steps a sample, of dormand_prince -log10 of its tolerance
    state : BlockState at its start
    impact_time : results [s], up to its size
    impact_velocity : results just after each impact [rad/s], of the same shape
    table : of `Method.table` [-]
    rates, pushes : room for the stages of dormand_prince [rad/s], [rad/s2]
    Returns (outcome so far, BlockState).
    """
    steps = 1 if code == DORMAND_PRINCE else option
    tolerance = 10.0 ** (-option) if code == DORMAND_PRINCE else 0.0
    side, phi, speed, moving, zone, peak, impacts, clamped = state
    slope = (ground1 - ground0) / dt
    t = 0.0
    impacts_before = impacts
    events = 0
    outcome = STABLE
    while t < dt:
        if not moving:
            t, side = next_uplift(ground0, slope, t, dt, thresholds)
            if t >= dt:
                break
            moving = True
            phi = 0.0
            speed = 0.0
            zone = zone_of(phi, model)
        seen = seen_from(model, side)
        low, high, _, _, _, _ = moment_branch(zone, seen)
        beta = side / G * (ground0 + slope * t)
        rate = side / G * slope
        h = min(dt / steps, dt - t)
        x, v = advance(code, phi, speed, beta, rate, h, seen, zone, tolerance, table, rates, pushes)
        crossed = x < low or x > high or (x == low and v < 0.0)
        falling = x <= low
        if crossed:
            level = low if falling else high
            h = locate(
                code,
                phi,
                speed,
                beta,
                rate,
                h,
                seen,
                zone,
                tolerance,
                table,
                rates,
                pushes,
                level,
                1.0 if falling else -1.0,
            )
            x, v = advance(code, phi, speed, beta, rate, h, seen, zone, tolerance, table, rates, pushes)
            x = level
        t = t + h if h < dt - t else dt
        phi = x
        speed = v
        peak = max(peak, phi)
        if phi > LAST_ROTATION:
            outcome = COLLAPSED
            break
        if not crossed:
            continue
        events += 1
        if events > 10 * IMPACTS_PER_SAMPLE:
            outcome = IMPACT_LIMIT
            break
        if not falling or low > 0.0:
            zone += -1 if falling else 1
            continue
        arriving = max(-speed, 0.0)
        now = ground0 + slope * t
        speed, side, moving, clamp, stuck = apply_impact(
            arriving, side, now, model, thresholds, h, start + t, impacts, impact_time, impact_velocity
        )
        clamped += clamp
        t += 1e-12 * dt if stuck else 0.0
        impacts += 1
        if impacts - impacts_before > IMPACTS_PER_SAMPLE:
            outcome = IMPACT_LIMIT
            break
    return outcome, BlockState(side, phi, speed, moving, zone, peak, impacts, clamped)
