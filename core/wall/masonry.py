"""A wall in SI, as the mechanics and the clauses take it, per metre of its length; core/case/wall.py makes it.

x is inward from the outer face of the base, z above it.
"""

import math
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from core.units import G
from core.wall.arch import Arch
from core.wall.bars import Bar, TieBar
from core.wall.block import Block
from core.wall.body import Body
from core.wall.kinematics import Kinematics, kinematics
from core.wall.load_kinds import OfLoadKind
from core.wall.loads import UNLOADED, Force, PointMass, RestoringMoment, composite, restoring_moment
from core.wall.moment_rotation import RIGID, MomentLaw
from core.wall.restitution import Contact
from core.wall.solids import MIN_BASE, Part, Section, section_area, sections_of, sum_of, top_of
from core.wall.ties import Tie

MAX_COLLAPSE = math.radians(60.0)
"""Largest collapse rotation: beyond it a wall is no wall that overturns."""

CENTRED = 1e-6
"""Distance from the middle of the wall up to which moving masses are centred [of t]."""

SYMMETRY_TOLERANCE = 1e-9
"""What a and c of both sides may differ by and still be the same [-]."""

COUNTED = 0.40
"""Share of theta_c up to which alpha_0 counts what the ties hold: that of d_SLV (C8.7.1.2.1.6)."""

GAUSS = np.polynomial.legendre.leggauss(5)
CANTILEVER_MEAN_SQUARE = 104.0 / 405.0
"""Points and weights between -1 and 1; mean square of the deflection of a cantilever under a constant load, over that
of its end."""


@dataclass(frozen=True)
class Load(OfLoadKind):
    """A force of constant size and direction on a metre of wall, a mass that moves with it, or a tie.

    kind : vertical, thrust, tie or carried_mass
    force : of a thrust positive outward, of a tie that at yield [N/m]
    depth, height : of its point, from the outer face inward and above the hinge [m]
    pushes : whether its mass is moved by the wall: Q of C8.7.1.1, and part of the moving block
    """

    kind: str
    force: float
    depth: float
    height: float
    pushes: bool = False
    tie: Tie | None = None

    @property
    def slack(self) -> bool:
        """Whether it is a tie that does nothing before the wall has moved: no check of the clauses counts it."""
        return self.tie is not None and self.tie.is_slack


@dataclass(frozen=True)
class ReturnWalls:
    """The walls across behind a facade, whose courses it drags out by friction.

    number : of them along the wall; thickness : t_s [m]; course, unit : height h_b of a course and length l of a unit
    [m]; friction : coefficient mu [-]
    """

    number: int
    thickness: float
    course: float
    unit: float
    friction: float


SLIDING = 0.4
"""Friction coefficient of a bed joint (EN 1996-1-1, 3.6.2, and NTC 2018, 11.10.3.3, both from memory)."""


@dataclass(frozen=True)
class PartAbove:
    """What is above the highest hold of a wall, which rocks about it, and what it hands to that hold.

    weight : that the earthquake pushes [N/m]; lever : share of it that goes to the hold at rest, its moment included
    multiplier : alpha_0 [-]; growth : kappa [N/m], growth of the reaction with the push from there on
    factor : push at the hold over the push on the stretch below
    """

    weight: float
    lever: float
    multiplier: float
    growth: float
    factor: float = 1.0

    def force(self, alpha: float) -> float:
        """Largest force [N/m] under pushes up to alpha [-] on the stretch below."""
        push = self.factor * alpha
        at_rest = self.lever * self.weight * min(push, self.multiplier)
        return at_rest + self.growth * max(0.0, push - self.multiplier)


@dataclass(frozen=True)
class StubAbove:
    """What is above the highest hold of a wall and too low to rock: it falls as soon as it turns.

    weight : that the earthquake pushes [N/m]; multiplier : push at which it turns about an edge [-]
    factor : push at the hold over the push on the stretch below
    """

    weight: float
    multiplier: float
    factor: float = 1.0


@dataclass(frozen=True)
class Declared:
    """What the engineer says of a wall, which no number shows.

    restraint : what stands behind it or holds its top, a key of words, None : nothing; evidence, note : what shows it
    unloaded : that nothing rests on it
    strength : of what holds its top [N/m]; beside : weight whose inertia that takes beside the wall's own [N/m]
    above : what rocks above what holds its top; stub : what may fall there, too low to rock; None of a wall that ends
        there
    inward : strength of what holds its top against a motion inward [N/m]; None where it is not compared
    foot_strength : of what holds its base across [N/m]; None of one that rests on the friction of its bed joint
    at_foot : what that is, and what shows it
    elongation : with which what holds its top yields at its strength before it is gone [m]; None of a brittle one
    stiffness : of what holds its top [N/m2]; None where it is not known
    """

    restraint: str | None = None
    evidence: str | None = None
    note: str = ""
    unloaded: bool = False
    strength: float | None = None
    beside: float = 0.0
    foot_strength: float | None = None
    inward: float | None = None
    elongation: float | None = None
    above: PartAbove | None = None
    stub: StubAbove | None = None
    stiffness: float | None = None
    at_foot: "Declared | None" = None


@dataclass(frozen=True)
class Masonry:
    """A wall of one geometry whose keys were judged.

    mechanism : two_sided, one_sided, both, vertical_bending or horizontal_bending
    bare : the wall alone about its outer hinge
    height, thickness : to where it meets its restraint, and of its base [m]; None of a block given by its radius
    setback : u, of the hinges inside the edges [m]
    length : [m]; unit_weight : [N/m3]; modulus, strength : E and f of the masonry [Pa]; kind : row of Table C8.5.I
    law : of its moment; branch : where the check at the demand gives it an elastic branch: auto or elastic, else ""
    bound : whether something is shown to hold it before it moves
    friction : of the bed joint at its base [-]
    felt : height above the ground at which its demand is taken [m], None where it is not given
    parts : its solids, none of a rectangle
    across : the walls behind it, dragged by friction
    arch : of a wall that spans between transverse walls (horizontal_bending)
    yielded : ties between the ends of a stretch that bends, which have yielded
    """

    name: str
    mechanism: str
    bare: Block
    height: float | None = None
    thickness: float | None = None
    setback: float = 0.0
    length: float | None = None
    unit_weight: float | None = None
    modulus: float | None = None
    strength: float | None = None
    kind: str | None = None
    law: MomentLaw = RIGID
    branch: str = ""
    bound: bool = False
    friction: float = SLIDING
    felt: float | None = None
    parts: tuple[Part, ...] = ()
    loads: tuple[Load, ...] = ()
    across: ReturnWalls | None = None
    declared: Declared = Declared()
    arch: Arch | None = None
    yielded: tuple[TieBar, ...] = ()

    @property
    def bends(self) -> bool:
        """Whether it is held at its top, or at both ends, and opens a hinge between."""
        return self.kinematics.bends

    @property
    def kinematics(self) -> Kinematics:
        """What its mechanism does."""
        return kinematics(self.mechanism)

    @property
    def is_two_sided(self) -> bool:
        """Whether it rocks to both sides, alone or too."""
        return self.kinematics.rocks_both_ways

    @property
    def above_ground(self) -> bool:
        """Whether what moves it is above the ground."""
        return (self.felt or 0.0) > 0.0

    def is_free(self, mechanism: str) -> bool:
        """Whether the wall is free to vibrate before it moves, not restrained by continuity with transverse walls
        (Circolare 7/2019 C8.7.1.2.1.3, .5): a two-sided one that nothing is shown to hold."""
        return kinematics(mechanism).both_ways and not self.bound

    @cached_property
    def body(self) -> Body | None:
        """The sums of its solids; None of a rectangle."""
        return sum_of(self.parts) if self.parts else None

    @cached_property
    def top(self) -> float | None:
        """Height of the body [m]."""
        return top_of(self.parts) if self.parts else self.height

    @cached_property
    def weight(self) -> float:
        """W of the wall alone [N/m]: of a body its weight over its length. Of a wall with a unit weight."""
        return weight_per_metre(self.parts, self.length, self.unit_weight, self.thickness, self.height)

    @property
    def moving_weight(self) -> float:
        """m g of what moves [N/m]."""
        return self.weight + sum(load.force for load in self.loads if load.pushes)

    @property
    def vertical_loads(self) -> float:
        """Sum of the vertical loads [N/m]."""
        return sum(load.force for load in self.loads if load.is_weight)

    @cached_property
    def masses(self) -> list[PointMass]:
        """Q over g: the masses that move with the wall or push it [kg/m], about its outer hinge."""
        pushing = (load for load in self.loads if load.pushes)
        return [PointMass(load.force / G, load.depth - self.setback, load.height) for load in pushing]

    @cached_property
    def ties(self) -> tuple[Tie, ...]:
        """The ties among its loads, in their order."""
        return tuple(load.tie for load in self.loads if load.tie is not None)

    def add_pulls(self, pulling: tuple[TieBar, ...]) -> "Masonry":
        """A stretch whose ties have yielded with these alone, each a force of its strength."""
        pulls = (Load("thrust", -bar.strength, 0.0, bar.height) for bar in pulling)
        return replace(self, yielded=(), loads=(*self.loads, *pulls))

    @cached_property
    def block(self) -> Block:
        """The wall and the masses that move with it as one block about its outer hinge."""
        masses = [] if self.bends else self.masses
        return composite(self.bare, self.weight / G, masses) if masses else self.bare

    @cached_property
    def inner_block(self) -> Block | None:
        """`block` about the inner hinge, of a wall that is not symmetric."""
        return None if self.bends else inner_of(self, self.block)

    @cached_property
    def restoring(self) -> tuple[RestoringMoment, RestoringMoment]:
        """What its loads add to its moment, for outward and for inward rotations; its ties add `bars`."""
        held = [load for load in self.loads if not load.pushes and load.tie is None]
        if not held or self.bends:
            return UNLOADED, UNLOADED
        outward, inward = (
            restoring_moment(about, self.moving_weight, [load_to_force(load, self, side) for load in held])
            for about, side in ((self.block, 1.0), (self.inner_block or self.block, -1.0))
        )
        # alike but for rounding: alike
        same = max(abs(one - other) for one, other in zip(outward, inward, strict=True)) < SYMMETRY_TOLERANCE
        return outward, outward if same else inward

    @cached_property
    def bars(self) -> tuple[Bar, ...]:
        """Its ties as the kernels take them."""
        return tuple(tie.bar.scaled(self.moment_of_weight) for tie in self.ties)

    @property
    def moment_of_weight(self) -> float:
        """m g R of what moves [N m/m]."""
        return self.moving_weight * self.block.radius

    @property
    def contact(self) -> Contact | None:
        """Where a body, or a wall with masses that move with it, meets its base and, at its height, its restraint; None
        of a rectangle alone, which is symmetric."""
        if (not self.parts and not self.masses) or self.thickness is None or self.height is None:
            return None
        return Contact(self.thickness - 2.0 * self.setback, self.height)

    @property
    def sides(self) -> list[tuple[Block, RestoringMoment]]:
        """The block about each of its hinges, the outer one first, and the moment of its loads there."""
        outward, inward = self.restoring
        return [(self.block, outward), (self.inner_block or self.block, inward)]

    @property
    def is_centred(self) -> bool:
        """Whether what moves is symmetric, so that the wall is one block for both its hinges."""
        return is_centred(self, self.block)

    @property
    def rocks_both_ways(self) -> bool:
        """Whether a one-sided wall without its restraint is a two-sided one of this model: stable to both sides, and
        rigid where its loads or its shape make them differ."""
        if not self.loads and not self.parts:
            return True
        (_, outward), (about, inward) = self.sides
        if self.is_centred:
            return ((outward == inward and not self.ties) or self.law.is_rigid) and is_stable(about, inward)
        unlike = self.inner_block is not None and self.law.is_rigid and not self.ties
        return unlike and is_stable(about, inward)

    @property
    def sides_are_alike(self) -> bool:
        """Whether it turns the same way about both its hinges: nothing makes them differ."""
        outward, inward = self.restoring
        return outward == inward and self.inner_block is None

    @property
    def leans_inward(self) -> bool:
        """Whether a body falls inward at rest without its restraint: its centre of mass is not before its inner
        hinge."""
        if self.body is None or self.thickness is None:
            return False
        return self.body.centroid[0] >= self.thickness - self.setback

    def uplift_multiplier(self, mechanism: str) -> float:
        """a_RM / g = a tan(alpha) + c [-] (Eq. 2), of a two-sided wall the smaller one of its sides."""
        sides = self.sides if kinematics(mechanism).both_ways else self.sides[:1]
        return min(side.sine * math.tan(block.slenderness) + side.cosine for block, side in sides)

    def sections(self, count: int) -> tuple[Section, ...]:
        """So many sections over its height, the lowest one above the base. Of a wall with a unit weight."""
        assert self.height is not None and self.thickness is not None
        if self.parts:
            assert self.length is not None
            return sections_of(self.parts, self.length, count)
        middle = 0.5 * self.thickness
        return tuple(
            Section(y, middle, self.thickness, self.weight * (1.0 - y / self.height), middle, 0.5 * (self.height - y))
            for y in np.linspace(0.0, self.height, count + 1)[1:-1].tolist()
        )


def weight_per_metre(parts: tuple[Part, ...], length, unit_weight, thickness, height) -> float:
    """W of a wall [N/m]: of solids theirs over its length [m], else unit weight [N/m3] times thickness and height."""
    if parts:
        return sum_of(parts).mass * G / length
    return unit_weight * thickness * height


def base_length(parts: tuple[Part, ...], length: float, thickness: float) -> float:
    """Length of the base of a wall less its openings [m], of which its thickness [m] and this are the section; 0 where
    nothing stands there. length : of the wall [m]"""
    if not parts:
        return length
    area = section_area(parts, 0.0, 0.0, thickness)
    return area / thickness if area > MIN_BASE else 0.0


def period_share(wall: Masonry) -> float:
    """The square of T_0 of a body over that of its base section as a rectangle of the same height, by Rayleigh's
    quotient with the deflection of a cantilever under a constant load: between corners of its solids the mass times
    the square of the deflection is a polynomial of degree 9."""
    parts, top = wall.parts, wall.top
    assert top is not None and wall.length is not None and wall.thickness is not None and wall.unit_weight is not None
    levels = np.array(sorted({0.0, top, *(z for part in parts for _, z in part.polygon if 0.0 < z < top)}))
    nodes, shares = GAUSS
    z = (0.5 * (levels[1:] + levels[:-1])[:, None] + 0.5 * np.diff(levels)[:, None] * nodes).ravel()
    eta, step = z / top, (0.5 * np.diff(levels)[:, None] * shares).ravel()
    deflection = eta**2 * (6.0 - 4.0 * eta + eta**2) / 3.0
    mass = sum(part.weight * (part.ends[1] - part.ends[0]) * part.widths_at(z) for part in parts)
    base = wall.unit_weight * wall.thickness * base_length(parts, wall.length, wall.thickness)
    return float((mass * deflection**2 * step).sum() / (base * top * CANTILEVER_MEAN_SQUARE))


def inner_of(wall: Masonry, block: Block) -> Block | None:
    """A block about the inner hinge of a wall; None where it is the same, or leans beyond that hinge. block : about the
    outer one, of the wall alone or with what moves with it"""
    if wall.thickness is None or is_centred(wall, block):
        return None
    (x, z), width = block.centroid, wall.thickness - 2.0 * wall.setback
    if x >= width:
        return None
    own = block.inertia_over_mass - block.radius**2
    radius = math.hypot(width - x, z)
    return Block(math.atan2(width - x, z), radius, own + radius * radius)


def is_centred(wall: Masonry, block: Block) -> bool:
    """Whether a block about the outer hinge of a wall has its centre of mass in the middle between both hinges."""
    if wall.thickness is None:
        return True
    middle = 0.5 * wall.thickness - wall.setback
    return abs(block.centroid[0] - middle) <= CENTRED * wall.thickness


def is_stable(block: Block, side: RestoringMoment) -> bool:
    """Whether a wall stands at rest under its own loads on this side."""
    return side.sine > 0.0 and side.sine * math.tan(block.slenderness) + side.cosine > 0.0


def held_at(wall: Masonry) -> float:
    """Rotation up to COUNTED of theta_c at which the ties of a wall, slack ones apart, hold the largest moment [rad]:
    their forces count where they act together."""
    bars = [tie.bar for tie in wall.ties if not tie.is_slack]
    most = COUNTED * (wall.block.slenderness + wall.restoring[0].lean)
    ends = [math.asin(end / bar.height) for bar in bars for end in bar.ends if end < bar.height * math.sin(most)]
    return max((most, *ends), key=lambda theta: sum(bar.height * bar.force_at(theta) for bar in bars))


def load_to_force(load: Load, wall: Masonry, side: float, at_yield: bool = False) -> Force:
    """A load about the hinge of this side, 1.0 the outer one [N/m, m]; its weight too where its mass moves. Of a tie
    what alpha_0 counts (C8.7.1.1): nothing of a slack one, else its force at `held_at`; none on a wall that turns
    inward. at_yield : of a tie its force at yield, slack or not"""
    assert wall.thickness is not None
    inward, push = load.depth if side > 0.0 else wall.thickness - load.depth, 0.0
    if load.is_thrust:
        push = -load.force * side
    elif load.tie is not None and side > 0.0 and at_yield:
        push = load.force
    elif load.tie is not None and side > 0.0 and not load.slack:
        push = load.tie.bar.force_at(held_at(wall))
    return Force(load.force if load.is_weight else 0.0, push, inward - wall.setback, load.height)
