"""Closed form of the linearised block: cosh and sinh under linear forcing, events located.

phi'' = p2 A (phi - theta_c + b), b = (u''/g) theta_c / (a tan(alpha) + c): the same threshold as Eq. 2, rigid law
only; without loads A = a = 1, c = 0, theta_c = alpha.
Cost: one exponential a step. Fails: by the linearisation itself, 2e-2 alpha at alpha 6.8 deg, whatever
the step; the stockier the wall the more.
"""

import math

from core.jit.decorators import subkernel


@subkernel
def advance(phi, speed, beta, slope, h, model, zone):
    """Rotation [rad] and velocity [rad/s] after one step.

    phi : rotation at its start, seen from the pivot [rad]
    speed : velocity at its start [rad/s]
    beta : u''/g at its start, seen from the pivot [-]
    slope : rate of beta [1/s]
    h : its length [s]
    model : RockingModel as the pivot sees it
    zone : branch of the moment law; the rigid one has only one, so it is not read
    """
    restoring = model.restoring
    top = model.slenderness + restoring.lean
    p = math.sqrt(model.p2 * restoring.amplitude)
    match = top / (restoring.sine * math.tan(model.slenderness) + restoring.cosine)
    rest = top - match * beta
    drift = -match * slope
    x = p * h
    if x < 0.1:
        # sinh by series: e^x - e^-x loses digits near 0
        square = x * x
        sine = x * (1.0 + square / 6.0 * (1.0 + square / 20.0 * (1.0 + square / 42.0)))
        cosine = math.sqrt(1.0 + sine * sine)
    else:
        grown = math.exp(x)
        cosine = 0.5 * (grown + 1.0 / grown)
        sine = 0.5 * (grown - 1.0 / grown)
    away = phi - rest
    relative = speed - drift
    return (rest + drift * h + away * cosine + relative / p * sine, drift + p * away * sine + relative * cosine)
