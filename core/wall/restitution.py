"""Velocity ratios of an impact (Coccia et al. 2016, Eq. 3 to 8).

The paper's r is a ratio of kinetic energies; here every value is the velocity ratio sqrt(r).
"""

import math
from dataclasses import dataclass
from typing import NamedTuple

from core.errors import InputError
from core.wall.block import Block
from core.wall.impact import Restitution


class Model(NamedTuple):
    """A restitution model.

    source : equation or publication
    one_sided : for walls restrained on one side only
    by_theory : follows from the conservation of momentum; of any other zeta by theory is shown beside
    """

    source: str
    one_sided: bool
    by_theory: bool


MODELS = {
    "housner": Model("Eq. 4", one_sided=False, by_theory=True),
    "sorrentino_experimental": Model("Eq. 5", one_sided=False, by_theory=False),
    "costa_upper": Model("Costa et al. 2013", one_sided=False, by_theory=False),
    "one_sided_theoretical": Model("Eq. 6", one_sided=True, by_theory=True),
    "one_sided_experimental": Model("Eq. 7", one_sided=True, by_theory=False),
    "user": Model("given", one_sided=False, by_theory=False),
}

EQ5_FACTOR = 0.95
"""EQ5_FACTOR: measured over theoretical ratio of walls that rock to both sides, Eq. 5."""

EQ7_FACTOR, EQ7_DROP = 1.18, 0.473
"""EQ7_FACTOR: measured over theoretical ratio of one-sided walls at rest. EQ7_DROP: its loss with the square of the
velocity over that of Eq. 8, Eq. 7."""


@dataclass(frozen=True)
class Contact:
    """Points at which a body, or a block with masses that move with it, meets its base and its restraint.

    width : B, from the outer hinge to the inner one [m]
    height : H_r, of the point above the inner hinge that meets the restraint of a one-sided wall [m]
    """

    width: float
    height: float


def impact_ratio(block: Block, pivot: tuple[float, float], new: tuple[float, float]) -> float:
    """Angular velocity after over before an impact that moves the pivot from P to Q [-]: angular momentum about Q,
    e = (I_G + m GP . GQ) / (I_G + m GQ^2).

    block : about its outer hinge, (0, 0)
    pivot, new : P and Q, inward from the outer hinge and above it [m]
    """
    x, y = block.centroid
    own = block.inertia_over_mass - block.radius**2
    (px, py), (qx, qy) = (pivot[0] - x, pivot[1] - y), (new[0] - x, new[1] - y)
    return (own + px * qx + py * qy) / (own + qx * qx + qy * qy)


def inward_ratio(block: Block, contact: Contact) -> float:
    """`housner_ratio` of an impact that leaves the inner hinge."""
    return _not_negative(impact_ratio(block, (contact.width, 0.0), (0.0, 0.0)), block)


def _not_negative(ratio: float, block: Block) -> float:
    """Raise InputError for a block that is too stocky to rock."""
    if ratio < 0.0:
        raise InputError("eq4_negative", ratio=ratio, alpha=math.degrees(block.slenderness))
    return ratio


def housner_ratio(block: Block, contact: Contact | None = None) -> float:
    """sqrt(r) = 1 - 2 R^2 sin^2(alpha) m / I0 [-], Eq. 4; 1 - 1.5 sin^2(alpha) for a rectangle. contact : of a body
    or of a block with masses that move with it, whose ratio from outer to inner hinge is that of `impact_ratio`.

    Raises InputError where it is negative: the block is too stocky to rock.
    """
    if contact is not None:
        return _not_negative(impact_ratio(block, (0.0, 0.0), (contact.width, 0.0)), block)
    factor = 2.0 * block.radius**2 / block.inertia_over_mass
    return _not_negative(1.0 - factor * math.sin(block.slenderness) ** 2, block)


def one_sided_ratio(block: Block, contact: Contact | None = None) -> float:
    """sqrt(r_1s) [-], Eq. 6: base, upper corner and base again. The bracket in cos is negative for
    slender blocks, which is the reversal of the motion: its modulus is the ratio. For a general
    block the contact at 2 R cos(alpha) above the pivot is an assumption. contact : of a body or of a block
    with masses that move with it; the same three impacts by `impact_ratio`."""
    if contact is not None:
        inner = contact.width, 0.0
        top = abs(impact_ratio(block, inner, (contact.width, contact.height)))
        return housner_ratio(block, contact) ** 2 * top
    factor = 2.0 * block.radius**2 / block.inertia_over_mass
    return housner_ratio(block) ** 2 * abs(1.0 - factor * math.cos(block.slenderness) ** 2)


def overturning_velocity(block: Block) -> float:
    """theta_r' = sqrt(2 p^2 (1 - cos alpha)) [rad/s], Eq. 8, which lacks the root as printed."""
    return math.sqrt(2.0 * block.p2 * (1.0 - math.cos(block.slenderness)))


def restitution(
    block: Block, model: str, velocity_ratio: float | None = None, contact: Contact | None = None
) -> Restitution:
    """Restitution of a named model for this block; velocity_ratio only with model "user", contact only of a body
    or of a block with masses that move with it. A body that lands elsewhere than Eq. 6 supposes (a corner, what weighs
    behind its restraint), for which it gives more than 1, loses nothing: the safe limit."""
    if model in ("housner", "sorrentino_experimental"):
        factor = 1.0 if model == "housner" else EQ5_FACTOR
        inward = factor * inward_ratio(block, contact) if contact else None
        return Restitution(model, factor * housner_ratio(block, contact), ratio_inward=inward)
    if model == "costa_upper":
        return Restitution(model, 0.98)
    if model == "one_sided_theoretical":
        return Restitution(model, min(one_sided_ratio(block, contact), 1.0))
    if model == "one_sided_experimental":
        # Eq. 7: sqrt(r_1s) (1.18 - 0.473 (v / theta_r')^2)
        ratio = one_sided_ratio(block, contact)
        if EQ7_FACTOR * ratio > 1.0:
            raise InputError("eq7_above_one", ratio=EQ7_FACTOR * ratio)
        drop = EQ7_DROP * ratio / overturning_velocity(block) ** 2
        return Restitution(model, EQ7_FACTOR * ratio, drop)
    if model == "user" and velocity_ratio is not None and 0.0 <= velocity_ratio <= 1.0:
        return Restitution(model, velocity_ratio)
    raise InputError("restitution_not_accepted", model=model, ratio=velocity_ratio, known=", ".join(MODELS))
