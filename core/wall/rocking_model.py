"""The numbers a rocking kernel needs, in one flat tuple."""

import math
from typing import NamedTuple

from core.jit.decorators import subkernel
from core.units import G
from core.wall.bars import Bar
from core.wall.bending import HeldTop, near_rest
from core.wall.block import Block
from core.wall.impact import Restitution
from core.wall.loads import UNLOADED, RestoringMoment
from core.wall.moment_rotation import MomentLaw


class OtherSide(NamedTuple):
    """Quantities that differ when a body that is not symmetric turns about its other hinge; as of RockingModel.

    tangent, sine, cosine : of alpha [-]
    """

    slenderness: float
    p2: float
    ratio_at_rest: float
    tangent: float
    sine: float
    cosine: float

    @classmethod
    def of(cls, slenderness: float, p2: float, ratio_at_rest: float) -> "OtherSide":
        trigonometric = math.tan(slenderness), math.sin(slenderness), math.cos(slenderness)
        return cls(slenderness, p2, ratio_at_rest, *trigonometric)


class Oscillator(NamedTuple):
    """The branch of a wall without plateau as a linear oscillator (core/rocking/oscillator.py).

    stiffness : of the restoring moment over m g R [1/rad]
    static : rotation under a steady ground acceleration [rad per m/s2]
    """

    stiffness: float
    static: float


class RockingModel(NamedTuple):
    """Equation of motion of one wall (Coccia et al. 2016, Eq. 1 to 8, Fig. 3) as plain floats.

    With loads phi'' = -p2 (a sin(alpha - phi) + c cos(alpha - phi) - beta cos(alpha - phi)).

    slenderness : alpha [rad]
    p2 : squared frequency parameter m g R / I0 [1/s2]
    one_sided : 1.0 if only positive rotations are possible, else 0.0
    ratio_at_rest : velocity ratio of an impact at vanishing speed [-]
    ratio_drop : loss of velocity ratio with the square of the impact velocity [s2/rad2], Eq. 7
    elastic_end : phi1 [rad], end of the elastic branch; 0 for the rigid law
    plateau_end : phi2 [rad], end of the plateau; 0 for the rigid law
    restoring : a, c and what follows from them for positive rotations; functions of the rotation seen from the pivot
        read it, see `seen_from`
    mirrored : the same for negative rotations
    lean, amplitude : of `RestoringMoment`, of the side with the smaller theta_c; both are alike if trilinear
    bars : Bars that hold it when it turns outward; theta_c and a_RM are those of the wall without them. The kernels
        of walls with bars take them apart from the rest, which then has none
    other : of a two-sided body that is another one for negative rotations; None of a symmetric one, whose kernels then
        have nothing of it
    driven : its elastic branch where there is no plateau, solved in closed form; None of every other law
    bending : of a wall held at its top, which core/rocking/held_top.py integrates: the rest is the block it is near to
        rest, with its collapse rotations. None of every block
    """

    slenderness: float
    p2: float
    one_sided: float
    ratio_at_rest: float
    ratio_drop: float
    elastic_end: float
    plateau_end: float
    restoring: RestoringMoment = UNLOADED
    mirrored: RestoringMoment = UNLOADED
    lean: float = 0.0
    amplitude: float = 1.0
    bars: tuple[Bar, ...] = ()
    other: OtherSide | None = None
    driven: Oscillator | None = None
    bending: HeldTop | None = None

    @property
    def collapse_rotation(self) -> float:
        """theta_c [rad], where nothing holds the wall: alpha without loads, of both sides the smaller one."""
        return self.slenderness + self.lean

    @property
    def both_signs_alike(self) -> bool:
        """Whether a record and its reverse do the same to it: two-sided, and alike on both sides."""
        same = self.restoring == self.mirrored and self.other is None
        same &= self.bending is None or self.bending.outward == self.bending.inward
        return self.one_sided == 0.0 and same and not self.bars

    @property
    def threshold(self) -> float:
        """a_RM = g (a tan(alpha) + c) [m/s2], of both sides the smaller one (Eq. 2)."""
        sides = (self, seen_from.py_func(self, -1.0))
        return min(G * (s.restoring.sine * math.tan(s.slenderness) + s.restoring.cosine) for s in sides)


def with_branch(model: RockingModel, limit: float) -> RockingModel:
    """A rigid wall with an elastic branch in place of its law up to `limit` of theta_c, where the falling line begins.
    The ground pushes on the branch as at its end, which is more than below it."""
    end = limit * model.collapse_rotation
    stiffness = model.amplitude * math.sin(model.collapse_rotation - end) / end
    static = math.cos(model.slenderness - end) / (stiffness * G)
    return model._replace(elastic_end=end, plateau_end=end, driven=Oscillator(stiffness, static))


def weakened(model: RockingModel, factor: float) -> RockingModel:
    """The model with its strength over a factor, to be shaken by the ground times that factor: exactly, p^2 of both its
    sides over it."""
    other = model.other and model.other._replace(p2=model.other.p2 / factor)
    return model._replace(p2=model.p2 / factor, other=other)


@subkernel
def own_side(model, other, side):
    """alpha, p2 and velocity ratio about the hinge of this side. other : of the model, which decides at compile time"""
    if other is None:
        return model.slenderness, model.p2, model.ratio_at_rest
    if side > 0.0:
        return model.slenderness, model.p2, model.ratio_at_rest
    return other.slenderness, other.p2, other.ratio_at_rest


@subkernel
def far_side(model, other, side):
    """OtherSide as this side sees it; None of a symmetric body."""
    if other is None:
        return other
    if side > 0.0:
        return other
    alpha = model.slenderness
    return OtherSide(alpha, model.p2, model.ratio_at_rest, math.tan(alpha), math.sin(alpha), math.cos(alpha))


@subkernel
def seen_from(model, side):
    """The model as the pivot of this side, 1.0 or -1.0, sees it: `restoring` is that of its rotations."""
    slenderness, p2, ratio_at_rest = own_side(model, model.other, side)
    return RockingModel(
        slenderness,
        p2,
        model.one_sided,
        ratio_at_rest,
        model.ratio_drop,
        model.elastic_end,
        model.plateau_end,
        model.restoring if side > 0.0 else model.mirrored,
        model.mirrored if side > 0.0 else model.restoring,
        model.lean,
        model.amplitude,
        model.bars,
        far_side(model, model.other, side),
        model.driven,
        model.bending,
    )


@subkernel
def unlike(other):
    """Whether there is an OtherSide, known at compile time."""
    return other is not None


@subkernel
def sides_differ(model):
    """Whether it is another wall for negative rotations, by its loads or its shape."""
    right, left = model.restoring, model.mirrored
    return unlike(model.other) or right.sine != left.sine or right.cosine != left.cosine


def rocking_model(
    block: Block,
    one_sided: bool,
    restitution: Restitution,
    law: MomentLaw,
    loads: tuple[RestoringMoment, RestoringMoment] = (UNLOADED, UNLOADED),
    bars: tuple[Bar, ...] = (),
    inner: Block | None = None,
) -> RockingModel:
    """The flat tuple of a wall for the kernels.

    block : about its outer hinge
    one_sided : only positive rotations are possible
    restitution : of its impacts
    law : of its moment
    loads : for positive and for negative rotations, of one collapse rotation where the law is trilinear
    bars : of a wall of the rigid law
    inner : the block about its inner hinge, of a two-sided body that is not symmetric and of the rigid law
    """
    weaker = loads[0] if one_sided else min(loads, key=lambda side: side.lean)
    lean, other = weaker.lean, None
    if inner is not None and not one_sided:
        ratio = restitution.ratio_at_rest if restitution.ratio_inward is None else restitution.ratio_inward
        other = OtherSide.of(inner.slenderness, inner.p2, ratio)
        sides = block.slenderness + loads[0].lean, inner.slenderness + loads[1].lean
        lean = min(sides) - block.slenderness
    collapse = block.slenderness + lean
    return RockingModel(
        slenderness=block.slenderness,
        p2=block.p2,
        one_sided=1.0 if one_sided else 0.0,
        ratio_at_rest=restitution.ratio_at_rest,
        ratio_drop=restitution.ratio_drop,
        elastic_end=law.elastic_limit * collapse,
        plateau_end=law.plateau_end * collapse,
        restoring=loads[0],
        mirrored=loads[0] if one_sided else loads[1],
        lean=lean,
        amplitude=weaker.amplitude,
        bars=bars,
        other=other,
    )


def bending_model(held: HeldTop, collapse: tuple[float, float], kept: float) -> RockingModel:
    """The model of a wall held at its top. collapse : theta_c outward and inward [rad]; kept : e of its impacts"""
    alpha = math.atan(held.outward.thickness / held.outward.height)
    sides = []
    for sign, end in zip((1.0, -1.0), collapse, strict=True):
        p2, sine, cosine = near_rest(held.side(sign), alpha)
        sides.append((p2, RestoringMoment(sine, cosine, math.hypot(sine, cosine), end - alpha)))
    (p2, outward), (_, inward) = sides
    weaker = min(outward, inward, key=lambda side: side.lean)
    return RockingModel(
        slenderness=alpha,
        p2=p2,
        one_sided=0.0,
        ratio_at_rest=kept,
        ratio_drop=0.0,
        elastic_end=0.0,
        plateau_end=0.0,
        restoring=outward,
        mirrored=outward if held.outward == held.inward else inward,
        lean=weaker.lean,
        amplitude=weaker.amplitude,
        bending=held,
    )
