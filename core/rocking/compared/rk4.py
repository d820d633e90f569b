"""Classical Runge-Kutta of order 4 with located events.

Cost: four evaluations of sin and cos a step. Fails: on small hops, whose errors it makes at order 4 and
the motion amplifies (1e-4 alpha on `hard` at the record's step); on a dip and return within one step.
"""

from core.jit.decorators import subkernel
from core.rocking.compared.branch import acceleration


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
    half = 0.5 * h
    middle = beta + half * slope
    a1 = acceleration(phi, beta, model, zone)
    v2 = speed + half * a1
    a2 = acceleration(phi + half * speed, middle, model, zone)
    v3 = speed + half * a2
    a3 = acceleration(phi + half * v2, middle, model, zone)
    v4 = speed + h * a3
    a4 = acceleration(phi + h * v3, beta + h * slope, model, zone)
    phi += h / 6.0 * (speed + 2.0 * (v2 + v3) + v4)
    return phi, speed + h / 6.0 * (a1 + 2.0 * (a2 + a3) + a4)
