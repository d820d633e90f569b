"""What an impact does to the velocity (Coccia et al. 2016, Eq. 3, 7). It stands apart from the models: a new one
discards no machine code."""

from dataclasses import dataclass

from core.jit.decorators import subkernel

MOMENTUM = "momentum"
"""Model of a wall held at its top, whose ratio follows from its geometry: the momentum of both blocks, projected."""


@dataclass(frozen=True)
class Restitution:
    """Velocity ratio of an impact at speed v: ratio_at_rest - ratio_drop v^2, not below 0.

    ratio_at_rest : [-]
    ratio_drop : [s2/rad2], zero but for Eq. 7
    ratio_inward : of an impact that leaves the inner hinge, of a two-sided body that is not symmetric; None : the same
    model : a name of MODELS of core/wall/restitution.py
    """

    model: str
    ratio_at_rest: float
    ratio_drop: float = 0.0
    ratio_inward: float | None = None


@subkernel
def velocity_ratio(speed, model):
    """Velocity ratio of an impact at the given speed [rad/s], and 1 if Eq. 7 had to be clamped at 0."""
    ratio = model.ratio_at_rest - model.ratio_drop * speed * speed
    if ratio < 0.0:
        return 0.0, 1
    return ratio, 0
