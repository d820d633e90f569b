"""The numbers a rocking kernel needs, in one flat tuple."""

from typing import NamedTuple

from core.wall.block import Block
from core.wall.moment_rotation import MomentLaw
from core.wall.restitution import Restitution


class RockingModel(NamedTuple):
    """Equation of motion of one wall (Coccia et al. 2016, Eq. 1 to 8, Fig. 3) as plain floats.

    slenderness : alpha [rad]
    p2 : squared frequency parameter m g R / I0 [1/s2]
    one_sided : 1.0 if only positive rotations are possible, else 0.0
    ratio_at_rest : velocity ratio of an impact at vanishing speed [-]
    ratio_drop : loss of velocity ratio with the square of the impact velocity [s2/rad2], Eq. 7
    elastic_end : phi1 [rad], end of the elastic branch; 0 for the rigid law
    plateau_end : phi2 [rad], end of the plateau; 0 for the rigid law
    """

    slenderness: float
    p2: float
    one_sided: float
    ratio_at_rest: float
    ratio_drop: float
    elastic_end: float
    plateau_end: float


def rocking_model(
    block: Block, one_sided: bool, restitution: Restitution, law: MomentLaw
) -> RockingModel:
    """The flat tuple of a wall for the kernels."""
    return RockingModel(
        slenderness=block.slenderness,
        p2=block.p2,
        one_sided=1.0 if one_sided else 0.0,
        ratio_at_rest=restitution.ratio_at_rest,
        ratio_drop=restitution.ratio_drop,
        elastic_end=law.elastic_limit * block.slenderness,
        plateau_end=law.plateau_end * block.slenderness,
    )
