"""Moment-rotation laws of the wall: rigid and trilinear (Coccia et al. 2016, Fig. 3)."""

import math
from dataclasses import dataclass

from core.errors import require
from core.jit.decorators import subkernel

NEVER_REACHED = 1e9
"""Upper end of the last branch of a law [rad]: never reached."""


@dataclass(frozen=True)
class MomentLaw:
    """Moment over m g R against rotation.

    elastic_limit, plateau_end : D1, D2, the ends of the elastic branch and of the plateau as
    fractions of alpha [-], 0 < D1 <= D2 < 1; both 0 for the rigid law.
    Raises InputError outside these ranges.
    """

    elastic_limit: float = 0.0
    plateau_end: float = 0.0

    def __post_init__(self):
        if self.is_rigid:
            return
        require(0.0 < self.elastic_limit < 1.0, "elastic_limit", self.elastic_limit, "0 < D1 < 1")
        require(self.elastic_limit <= self.plateau_end < 1.0, "plateau_end", self.plateau_end, "D1 <= D2 < 1")

    @property
    def is_rigid(self) -> bool:
        return self.elastic_limit == 0.0 and self.plateau_end == 0.0


WITH_BRANCH = ("auto", "elastic")
"""Laws of the case that are rigid but for the elastic branch of the check at the demand
(core/codes/elastic_branch.py)."""

RIGID = MomentLaw()

LAWS = {"rigid": RIGID, "doherty": MomentLaw(0.06, 0.28), "al_shawa": MomentLaw(0.02, 0.28)}
"""Named laws: Doherty et al. (2002), Al Shawa et al. (2015), as quoted by the paper, sect. 4.3."""


@subkernel
def zone_of(phi, model):
    """Branch of the moment law at this rotation (Fig. 3): 0 elastic, 1 plateau, 2 falling."""
    if phi >= model.plateau_end or model.plateau_end == 0.0:
        return 2
    return 1 if phi >= model.elastic_end else 0


@subkernel
def moment_branch(zone, model):
    """(lower end, upper end, sine factor, slope, constant, cosine factor) of a branch of the moment law: over I0 p2
    the moment is sine * sin(alpha - phi) + slope * phi + constant + cosine * cos(alpha - phi) (Fig. 3)."""
    phi1 = model.elastic_end
    phi2 = model.plateau_end
    restoring = model.restoring
    if zone == 2:
        return phi2, NEVER_REACHED, restoring.sine, 0.0, 0.0, restoring.cosine
    # not of `restoring`, which depends on the side: the sine is taken once
    plateau = model.amplitude * math.sin(model.slenderness + model.lean - phi2)
    if zone == 1:
        return phi1, phi2, 0.0, 0.0, plateau, 0.0
    return 0.0, phi1, 0.0, plateau / phi1, 0.0, 0.0


@subkernel
def moment(phi, model):
    """Restoring moment over m g R at rotation phi [-], continued analytically below 0."""
    _, _, sine, slope, constant, cosine = moment_branch(zone_of(phi, model), model)
    lean = model.slenderness - phi
    return sine * math.sin(lean) + cosine * math.cos(lean) + slope * phi + constant


@subkernel
def potential(phi, model):
    """Integral of the moment law from 0 to phi [-]: the stored energy over I0 p2 (Fig. 3)."""
    top = model.slenderness + model.restoring.lean
    amplitude = model.restoring.amplitude
    phi1 = model.elastic_end
    phi2 = model.plateau_end
    if phi2 == 0.0:
        # cos(theta_c - phi) - cos(theta_c), without cancellation for small phi
        return amplitude * 2.0 * math.sin(top - 0.5 * phi) * math.sin(0.5 * phi)
    k = amplitude * math.sin(top - phi2)
    if phi <= phi1:
        return 0.5 * k * phi * phi / phi1
    if phi <= phi2:
        return k * (phi - 0.5 * phi1)
    return k * (phi2 - 0.5 * phi1) + amplitude * math.cos(top - phi) - amplitude * math.cos(top - phi2)


@subkernel
def rotation_at_potential(stored, model):
    """Rotation in [0, theta_c] at which the potential reaches `stored`, below the barrier [rad]."""
    top = model.slenderness + model.restoring.lean
    amplitude = model.restoring.amplitude
    phi1 = model.elastic_end
    phi2 = model.plateau_end
    if phi2 == 0.0:
        return top - math.acos(min(1.0, stored / amplitude + math.cos(top)))
    k = amplitude * math.sin(top - phi2)
    if stored <= 0.5 * k * phi1:
        return math.sqrt(2.0 * stored * phi1 / k)
    if stored <= k * (phi2 - 0.5 * phi1):
        return stored / k + 0.5 * phi1
    rest = stored - k * (phi2 - 0.5 * phi1)
    return top - math.acos(min(1.0, rest / amplitude + math.cos(top - phi2)))
