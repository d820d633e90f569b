"""The paper's integrator, for comparison only: trapezoidal rule at the record's step.

Order 1 because of its events: uplift and impact take place at the end of the step. Fails on chatter and
small hops (error 0.6 to 1.4 alpha on the reference histories); no step makes it converge on `hard`.
"""

import math

from core.jit.decorators import subkernel
from core.rocking.events import (
    LAST_ROTATION,
    end_of_record,
    stops_rocking,
    uplift_side,
    uplift_threshold,
)
from core.rocking.outcome import COLLAPSED, STABLE
from core.units import G
from core.wall.moment_rotation import moment, moment_branch, zone_of
from core.wall.restitution import velocity_ratio

NEWTON_TOLERANCE = 1e-14
"""Change of rotation at which Newton's iteration stops [rad]."""


@subkernel
def acceleration(phi, beta, model):
    """phi'' [rad/s2] at u''/g = beta seen from the pivot, Eq. 1."""
    return model.p2 * (beta * math.cos(model.slenderness - phi) - moment(phi, model))


@subkernel
def stiffness(phi, beta, model):
    """d phi''/d phi [1/s2]."""
    _, _, sine, slope, _ = moment_branch(zone_of(phi, model), model)
    gradient = slope - sine * math.cos(model.slenderness - phi)
    return model.p2 * (beta * math.sin(model.slenderness - phi) - gradient)


@subkernel
def trapezoidal_step(phi, speed, push, beta_end, dt, model):
    """One implicit step; push is phi'' at its start. Returns phi, phi' and phi'' at its end."""
    quarter = 0.25 * dt * dt
    known = phi + dt * speed + quarter * push
    end = known
    for _ in range(50):
        residual = end - known - quarter * acceleration(end, beta_end, model)
        step = residual / (1.0 - quarter * stiffness(end, beta_end, model))
        end -= step
        if abs(step) < NEWTON_TOLERANCE:
            break
    push_end = acceleration(end, beta_end, model)
    return end, speed + 0.5 * dt * (push + push_end), push_end


@subkernel
def integrate(
    ground, dt, scale, model, reset, start, rotation, velocity, impact_time, impact_velocity
):
    """Rocking history by the paper's method; arguments and results as `taylor.integrate`.

    reset : 1 sets the rotation to zero at an impact, 0 keeps the overshoot (one-sided: always zero).
    """
    threshold = uplift_threshold(model)
    keep = rotation.size > 0
    impacts = 0
    clamped = 0
    side = -1.0 if start[0] < 0.0 or (start[0] == 0.0 and start[1] < 0.0) else 1.0
    phi = side * start[0]
    speed = side * start[1]
    moving = phi != 0.0 or speed != 0.0
    push = acceleration(phi, side * scale * ground[0] / G, model)
    peak = phi
    if keep:
        rotation[0] = start[0]
        velocity[0] = start[1]
    for i in range(ground.size - 1):
        ground1 = scale * ground[i + 1]
        if not moving:
            lifted = uplift_side(ground1, model, threshold)
            if lifted != 0.0:
                moving = True
                side = lifted
                push = max(acceleration(0.0, side * scale * ground[i] / G, model), 0.0)
        if moving:
            beta1 = side * ground1 / G
            phi, speed, push = trapezoidal_step(phi, speed, push, beta1, dt, model)
            if phi < 0.0:
                arriving = max(-speed, 0.0)
                ratio, clamp = velocity_ratio(arriving, model)
                clamped += clamp
                speed = ratio * arriving
                if model.one_sided == 0.0:
                    side = -side
                phi = 0.0 if reset == 1 or model.one_sided != 0.0 else -phi
                if impacts < impact_time.size:
                    impact_time[impacts] = (i + 1) * dt
                    impact_velocity[impacts] = side * speed
                impacts += 1
                push = acceleration(phi, side * ground1 / G, model)
                if stops_rocking(speed, ground1, model, threshold):
                    moving = False
                    phi = 0.0
                    speed = 0.0
            peak = max(peak, phi)
            if phi > LAST_ROTATION:
                return COLLAPSED, peak, impacts, clamped, i + 1
        if keep:
            rotation[i + 1] = side * phi if moving else 0.0
            velocity[i + 1] = side * speed if moving else 0.0
    outcome = STABLE
    if moving:
        outcome, peak = end_of_record(phi, speed, peak, model)
    return outcome, peak, impacts, clamped, ground.size
