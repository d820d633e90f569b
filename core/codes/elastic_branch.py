"""The initial elastic branch of an element free to vibrate, Circolare 7/2019 C8.7.1.2.1.3: necessary for parapets,
gables, free-standing parts of facades. It rises with (2 pi / T_0)^2 d to where it meets the falling line of the rigid
body, T_0 of C8.7.1.7; there is no plateau, so that both ends of the trilinear law are one, D.
"""

import math
from dataclasses import dataclass, replace

from core.codes.kinematic import elastic_period
from core.codes.kinematic_chain import sum_chain
from core.codes.masonry_types import moduli
from core.units import G
from core.wall.kinematics import kinematics
from core.wall.masonry import Masonry
from core.wall.rocking_model import RockingModel, with_branch

ELASTIC, AUTO = "elastic", "auto"
"""Laws with the branch: always, and of an element free to vibrate alone."""

TABLE_WEIGHTS = 13e3, 22e3
"""Unit weights of Table C8.5.I [N/m3], where none is given."""

MAX_LIMIT = 0.4
"""D from which a wall is elastic up to d_SLV: it does not rock."""

MIN_LIMIT = 1e-4
"""Least D: below it the branch is over before the motion of a common wall is seen on it."""

MAX_BISECTIONS = 60


@dataclass(frozen=True)
class Branch:
    """The elastic branch of a wall.

    modulus : E it follows from [Pa]; assumed : where none is given, an end of the table's range
    period : T_0 of C8.7.1.7 [s]
    limit : D, its end over theta_c [-]
    own_period : that of small rotations by the equation of motion with this D [s]
    """

    modulus: float
    assumed: bool
    period: float
    limit: float
    own_period: float

    def of(self, model: RockingModel) -> RockingModel:
        """The rigid model of the wall with this branch."""
        return with_branch(model, self.limit)


def wants_branch(wall: Masonry, mechanism: str) -> bool:
    """Whether the clause asks for the branch, or the case does."""
    return wall.branch == ELASTIC or (wall.branch == AUTO and not wall.bends and wall.is_free(mechanism))


def can_have_branch(wall: Masonry, mechanism: str) -> bool:
    """Whether the kernels and the formula of T_0 know it: a wall without ties, alike on both sides if it rocks both
    ways, of a height and a thickness."""
    if wall.bends or wall.height is None or wall.thickness is None or wall.ties:
        return False
    return kinematics(mechanism).one_way or wall.sides_are_alike


def branches_of(wall: Masonry, mechanism: str, model: RockingModel) -> tuple[Branch, ...]:
    """The branches of a wall, the worst of which decides: D by the curve, and D for which the equation of motion has
    T_0 itself; without a modulus D by the curve at both ends of its range in Table C8.5.I. Empty where there is none,
    and where the wall would be elastic up to d_SLV. model : rigid"""
    if not can_have_branch(wall, mechanism):
        return ()
    given, weight = wall.modulus, wall.unit_weight
    ends = tuple(1e6 * end for end in moduli(wall.kind)) if given is None else (given, given)
    heavy, light = (TABLE_WEIGHTS[1], TABLE_WEIGHTS[0]) if weight is None else (weight, weight)
    branches = []
    for modulus, heaviness in dict.fromkeys(((ends[0], heavy), (ends[1], light))):
        there = replace(wall, modulus=modulus, unit_weight=heaviness)
        sums = sum_chain(wall if weight is not None else there, kinematics(mechanism).both_ways)
        period = elastic_period(there)
        assert period is not None
        alpha0, share, _ = sums.start
        stiffness = (2.0 * math.pi / period) ** 2
        limits = [1.0 / (1.0 + stiffness * sums.d0 / (alpha0 * G / share))]
        if given is not None:
            limits.append(_by_motion(model, stiffness, limits[0]))
        for limit in limits:
            kept = max(limit, MIN_LIMIT)
            if kept < MAX_LIMIT:
                own = 2.0 * math.pi * math.sqrt(kept * model.collapse_rotation / _moment(model, kept))
                branches.append(Branch(modulus, given is None, period, kept, own))
    return tuple(branches)


def _by_motion(model: RockingModel, stiffness: float, limit: float) -> float:
    """D = p2 M(D) / (theta_c omega^2), a small part of which depends on D. stiffness : omega^2 [1/s2]; limit : where it
    begins"""
    for _ in range(MAX_BISECTIONS):
        before, limit = limit, _moment(model, limit) / (model.collapse_rotation * stiffness)
        if limit == before:
            break
    return limit


def _moment(model: RockingModel, limit: float) -> float:
    """Restoring moment at the end of a branch over I_0 [1/s2]."""
    return model.p2 * model.amplitude * math.sin((1.0 - limit) * model.collapse_rotation)
