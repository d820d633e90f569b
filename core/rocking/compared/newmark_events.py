"""The paper's trapezoidal rule with located uplift and impact: what its events alone cost.

Order 2. Fails: on small hops (0.6 alpha on `hard` at the record's step), where order 2 is too low.
"""

from core.jit.decorators import subkernel
from core.rocking.compared.branch import acceleration, stiffness

NEWTON_TOLERANCE = 1e-14
"""Change of rotation at which Newton's iteration stops [rad]."""


@subkernel
def advance(phi, speed, beta, slope, h, model, zone):
    """Rotation [rad] and velocity [rad/s] after h [s]; beta, slope : u''/g [-] and its rate [1/s]."""
    push = acceleration(phi, beta, model, zone)
    beta_end = beta + h * slope
    quarter = 0.25 * h * h
    known = phi + h * speed + quarter * push
    end = known
    for _ in range(50):
        residual = end - known - quarter * acceleration(end, beta_end, model, zone)
        step = residual / (1.0 - quarter * stiffness(end, beta_end, model, zone))
        end -= step
        if abs(step) < NEWTON_TOLERANCE:
            break
    return end, speed + 0.5 * h * (push + acceleration(end, beta_end, model, zone))
