"""Acceleration on one branch of the moment law, continued analytically past its ends (Eq. 1)."""

import math

from core.jit.decorators import subkernel
from core.wall.moment_rotation import moment_branch


@subkernel
def acceleration(phi, beta, model, zone):
    """phi'' [rad/s2] at rotation phi [rad] and u''/g = beta seen from the pivot, as `model` is."""
    _, _, sine, slope, constant, cosine = moment_branch(zone, model)
    moment = slope * phi + constant
    if sine != 0.0:
        moment += sine * math.sin(model.slenderness - phi)
    return model.p2 * ((beta - cosine) * math.cos(model.slenderness - phi) - moment)


@subkernel
def stiffness(phi, beta, model, zone):
    """d phi'' / d phi [1/s2] on the same branch."""
    _, _, sine, slope, _, cosine = moment_branch(zone, model)
    gradient = slope - sine * math.cos(model.slenderness - phi)
    return model.p2 * ((beta - cosine) * math.sin(model.slenderness - phi) - gradient)
