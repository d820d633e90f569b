"""The paper's integrator, for comparison only: trapezoidal rule at the record's step.

Order 1 because of its events: uplift and impact take place at the end of the step. Fails on chatter and
small hops (error 0.6 to 1.4 alpha on the reference histories); no step makes it converge on `hard`.
"""

from core.jit.decorators import inner_kernel
from core.rocking.compared.branch import acceleration, stiffness
from core.rocking.events import LAST_ROTATION, BlockState, stops_rocking, uplift_side
from core.rocking.outcome import COLLAPSED, STABLE
from core.units import G
from core.wall.impact import velocity_ratio
from core.wall.moment_rotation import zone_of
from core.wall.rocking_model import seen_from

NEWTON_TOLERANCE = 1e-14
"""Change of rotation at which Newton's iteration stops [rad]."""


@inner_kernel
def branch_at(phi, model, zone, across):
    """The zone itself, or, where the law is followed across its branches, that of this rotation."""
    return zone_of(phi, model) if across else zone


@inner_kernel
def trapezoidal_step(phi, speed, push, beta_end, h, model, zone, across):
    """One implicit step by the trapezoidal rule, solved by Newton's method.

    phi : rotation at its start, seen from the pivot [rad]
    speed : phi' at its start [rad/s]
    push : phi'' at its start [rad/s2]
    beta_end : u''/g at its end, seen from the pivot [-]
    h : its length [s]
    model : RockingModel as the pivot sees it
    zone : branch of the moment law, kept in the step unless it goes across the branches
    across : whether it does
    Returns phi, phi' and phi'' at its end.
    """
    quarter = 0.25 * h * h
    known = phi + h * speed + quarter * push
    end = known
    for _ in range(50):
        here = branch_at(end, model, zone, across)
        residual = end - known - quarter * acceleration(end, beta_end, model, here)
        step = residual / (1.0 - quarter * stiffness(end, beta_end, model, here))
        end -= step
        if abs(step) < NEWTON_TOLERANCE:
            break
    push_end = acceleration(end, beta_end, model, branch_at(end, model, zone, across))
    return end, speed + 0.5 * h * (push + push_end), push_end


@inner_kernel
def through_sample(ground0, ground1, time, dt, model, thresholds, reset, push, state, impact_time, impact_velocity):
    """Carry the block over one sample; see `comparison.integrate_comparison`.

    ground0, ground1 : ground acceleration at both ends [m/s2]
    time : of its end [s]
    dt : the sample [s]
    model : RockingModel
    thresholds : of `uplift_thresholds` [m/s2]
    reset : 1 sets the rotation to zero at an impact, 0 keeps the overshoot (one-sided: always zero)
    push : phi'' at its start [rad/s2]
    state : BlockState at its start
    impact_time : results [s], up to its size
    impact_velocity : results just after each impact [rad/s], of the same shape
    Returns (outcome so far, phi'' at its end, BlockState).
    """
    side, phi, speed, moving, zone, peak, impacts, clamped = state
    if not moving:
        lifted = uplift_side(ground1, thresholds)
        if lifted != 0.0:
            moving = True
            side = lifted
            push = max(acceleration(0.0, side * ground0 / G, seen_from(model, side), zone_of(0.0, model)), 0.0)
    outcome = STABLE
    if moving:
        beta1 = side * ground1 / G
        phi, speed, push = trapezoidal_step(phi, speed, push, beta1, dt, seen_from(model, side), zone, True)
        if phi < 0.0:
            arriving = max(-speed, 0.0)
            ratio, clamp = velocity_ratio(arriving, model)
            clamped += clamp
            speed = ratio * arriving
            if model.one_sided == 0.0:
                side = -side
            phi = 0.0 if reset == 1 or model.one_sided != 0.0 else -phi
            if impacts < impact_time.size:
                impact_time[impacts] = time
                impact_velocity[impacts] = side * speed
            impacts += 1
            seen = seen_from(model, side)
            push = acceleration(phi, side * ground1 / G, seen, zone_of(phi, model))
            if stops_rocking(speed, ground1, model, thresholds):
                moving = False
                phi = 0.0
                speed = 0.0
        peak = max(peak, phi)
        if phi > LAST_ROTATION:
            outcome = COLLAPSED
    return outcome, push, BlockState(side, phi, speed, moving, zone, peak, impacts, clamped)
