"""Velocity ratios of an impact (Coccia et al. 2016, Eq. 3 to 8).

The paper's r is a ratio of kinetic energies; here every value is the velocity ratio sqrt(r).
"""

import math
from dataclasses import dataclass

from core.errors import InputError
from core.jit.decorators import subkernel
from core.wall.block import Block

MODELS = {
    "housner": "Eq. 4",
    "sorrentino_experimental": "Eq. 5",
    "costa_upper": "Costa et al. 2013",
    "one_sided_theoretical": "Eq. 6",
    "one_sided_experimental": "Eq. 7",
    "user": "given",
}
"""Restitution models and their source."""


@dataclass(frozen=True)
class Restitution:
    """Velocity ratio of an impact at speed v: ratio_at_rest - ratio_drop v^2, not below 0.

    ratio_at_rest : [-]
    ratio_drop : [s2/rad2], zero but for Eq. 7
    model : a name of MODELS
    """

    model: str
    ratio_at_rest: float
    ratio_drop: float = 0.0


def housner_ratio(block: Block) -> float:
    """sqrt(r) = 1 - 2 R^2 sin^2(alpha) m / I0 [-], Eq. 4; 1 - 1.5 sin^2(alpha) for a rectangle.

    Raises InputError where it is negative: the block is too stocky to rock.
    """
    factor = 2.0 * block.radius**2 / block.inertia_over_mass
    ratio = 1.0 - factor * math.sin(block.slenderness) ** 2
    if ratio < 0.0:
        raise InputError("eq4_negative", ratio=ratio, alpha=math.degrees(block.slenderness))
    return ratio


def one_sided_ratio(block: Block) -> float:
    """sqrt(r_1s) [-], Eq. 6: base, upper corner and base again. The bracket in cos is negative for
    slender blocks, which is the reversal of the motion: its modulus is the ratio. For a general
    block the contact at 2 R cos(alpha) above the pivot is an assumption."""
    factor = 2.0 * block.radius**2 / block.inertia_over_mass
    return housner_ratio(block) ** 2 * abs(1.0 - factor * math.cos(block.slenderness) ** 2)


def overturning_velocity(block: Block) -> float:
    """theta_r' = sqrt(2 p^2 (1 - cos alpha)) [rad/s], Eq. 8, which lacks the root as printed."""
    return math.sqrt(2.0 * block.p2 * (1.0 - math.cos(block.slenderness)))


def restitution(block: Block, model: str, velocity_ratio: float | None = None) -> Restitution:
    """Restitution of a named model for this block; velocity_ratio only with model "user"."""
    if model == "housner":
        return Restitution(model, housner_ratio(block))
    if model == "sorrentino_experimental":
        return Restitution(model, 0.95 * housner_ratio(block))
    if model == "costa_upper":
        return Restitution(model, 0.98)
    if model == "one_sided_theoretical":
        return Restitution(model, one_sided_ratio(block))
    if model == "one_sided_experimental":
        # Eq. 7: sqrt(r_1s) (1.18 - 0.473 (v / theta_r')^2)
        ratio = one_sided_ratio(block)
        if 1.18 * ratio > 1.0:
            raise InputError("eq7_above_one", ratio=1.18 * ratio)
        drop = 0.473 * ratio / overturning_velocity(block) ** 2
        return Restitution(model, 1.18 * ratio, drop)
    if model == "user" and velocity_ratio is not None and 0.0 <= velocity_ratio <= 1.0:
        return Restitution(model, velocity_ratio)
    raise InputError(
        "restitution_not_accepted", model=model, ratio=velocity_ratio, known=", ".join(MODELS)
    )


@subkernel
def velocity_ratio(speed, model):
    """Velocity ratio of an impact at the given speed [rad/s], and 1 if Eq. 7 had to be clamped at 0."""
    ratio = model.ratio_at_rest - model.ratio_drop * speed * speed
    if ratio < 0.0:
        return 0.0, 1
    return ratio, 0
