"""The paper's trapezoidal rule with located uplift and impact: what its events alone cost.

Order 2. Fails: on small hops (0.6 alpha on `hard` at the record's step), where order 2 is too low.
"""

from core.jit.decorators import subkernel
from core.rocking.compared.branch import acceleration
from core.rocking.compared.newmark_paper import trapezoidal_step


@subkernel
def advance(phi, speed, beta, slope, h, model, zone):
    """Rotation [rad] and velocity [rad/s] after one step.

    phi : rotation at its start, seen from the pivot [rad]
    speed : velocity at its start [rad/s]
    beta : u''/g at its start, seen from the pivot [-]
    slope : rate of beta [1/s]
    h : its length [s]
    model : RockingModel as the pivot sees it
    zone : branch of the moment law
    """
    push = acceleration(phi, beta, model, zone)
    end, speed, _ = trapezoidal_step(phi, speed, push, beta + h * slope, h, model, zone, False)
    return end, speed
