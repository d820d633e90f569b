"""Up to which push what holds a wall holds: its top, the bed joint at its base, its ends between transverse walls.

A reaction is never divided by q, and a moving one takes no confidence factor: a stronger wall pushes harder.
"""

import math
from collections.abc import Callable, Iterator
from typing import NamedTuple

from core.boundary import narrowed
from core.known import require_value
from core.mechanism.bending_reactions import MovingStrip
from core.mechanism.rest import (
    BISECTIONS,
    Reach,
    base_reaction,
    greatest_at_top,
    least_at_top,
    simple_reactions,
    top_holds,
    top_multiplier,
)
from core.mechanism.sections import Sections
from core.wall.masonry import Masonry

TOP, BASE, FOOT, ENDS, STUB = "top", "base", "foot", "ends", "stub"
"""What holds a wall: at its top, the joint at its base, a floor at its foot, its ends; what is left above its highest
hold, which stands by its weight."""

INWARD = "inward"
"""Side to which a wall presses what holds it."""

UNLIMITED = 1e9
"""Strength that no wall reaches [N/m]."""


class HoldLimit(NamedTuple):
    """A hold that a push may overcome.

    hold : TOP, BASE, FOOT, ENDS or STUB; stands : [N/m], of ENDS across each of them, per metre of height
    push : alpha up to which it holds [-]; side : the motion that asks most of it, "outward" or "inward"
    presses : the wall presses it inward, and does not pull
    """

    hold: str
    stands: float
    push: float
    side: str
    presses: bool = False

    def share(self, alpha: float) -> float:
        """n_F: multiple of a demand of largest push alpha [-] up to which it holds."""
        return self.push / alpha


def reaction_of_top(sections: Sections, moving: MovingStrip, alpha: float) -> float:
    """Largest reaction [N/m] of a hold at the top under pushes up to alpha [-]. At rest, of a stiff one the lesser of
    the simple beam and of what pulls the wall in over its inner edge, of one that yields the least with which the wall
    stays; from the start of the mechanism on, where all of them meet, the bound of what moves."""
    if alpha >= moving.alpha0:
        return moving.bound(alpha)
    height = require_value(sections.wall.height)
    if sections.wall.declared.elongation is not None:
        return least_at_top(sections, height, alpha)
    return max(0.0, min(simple_reactions(sections, [height], alpha)[0], greatest_at_top(sections, height, alpha)))


def force_on_top(sections: Sections, moving: MovingStrip, alpha: float) -> float:
    """Largest force [N/m] on the hold at the top under pushes up to alpha [-]: the reaction of the wall below it, with
    the inertia of what goes to the hold beside that and what rocks above."""
    return reaction_of_top(sections, moving, alpha) + force_beside(sections.wall, alpha)


def force_beside(wall: Masonry, alpha: float) -> float:
    """Largest force [N/m] on the hold at the top of a wall beside what the wall hands to it, under pushes up to alpha
    [-]."""
    declared = wall.declared
    return alpha * declared.beside + (declared.above.force(alpha) if declared.above else 0.0)


def reaction_of_foot(sections: Sections, moving: MovingStrip, alpha: float) -> float:
    """Largest reaction [N/m] of what holds the foot of a wall across, under pushes up to alpha [-]."""
    if alpha >= moving.alpha0:
        return moving.bound(alpha, at_base=True)
    return max(0.0, base_reaction(sections, [reaction_of_top(sections, moving, alpha)], alpha))


def limits_of_bending(wall: Masonry, moving: MovingStrip, side: str) -> Iterator[HoldLimit]:
    """Limits of a wall that bends to one of its sides: of what holds its top, and of the joint at its base where that
    slides before the wall bends.

    wall : as it moves outward, or mirrored; moving : its strip with the hinge of the least multiplier
    """
    sections, declared = Sections(wall), wall.declared
    strength, alpha0 = require_value(declared.strength), moving.alpha0

    def push_at(reaction: Callable[[float], float], most: float) -> float:
        """alpha up to which a reaction is at most what a hold stands."""
        if reaction(alpha0) <= most:  # from there on it grows evenly
            slope = reaction(alpha0 + 1.0) - reaction(alpha0)
            return alpha0 + (most - reaction(alpha0)) / slope if slope > 0.0 else UNLIMITED
        return narrowed(lambda alpha: reaction(alpha) <= most, 0.0, alpha0, steps=BISECTIONS)[0]

    if math.isfinite(strength):  # else it is looked at where the stretch is chosen
        yield HoldLimit(TOP, strength, push_at(lambda alpha: force_on_top(sections, moving, alpha), strength), side)
    if side == INWARD and (pressed := declared.inward) is not None:
        push = push_at(lambda alpha: force_on_top(sections, moving, alpha), pressed)
        yield HoldLimit(TOP, pressed, push, side, presses=True)
    if side != INWARD and (stub := declared.stub) is not None:
        yield HoldLimit(STUB, stub.weight * stub.multiplier, stub.multiplier / stub.factor, side)
    if (foot := declared.foot_strength) is not None and math.isinf(foot):
        return
    if foot is not None:
        yield HoldLimit(FOOT, foot, push_at(lambda alpha: reaction_of_foot(sections, moving, alpha), foot), side)
        return
    reach = reach_of_top(wall, side)
    if not top_holds(sections, reach, alpha0 * (1.0 - 1e-6), wall.friction):  # it slides before it bends
        push = top_multiplier(sections, reach, wall.friction)
        if top_holds(sections, reach, push * (1.0 + 1e-6), UNLIMITED):  # else its top does not hold it there
            yield HoldLimit(BASE, wall.friction * sections.at(0.0).weight, push, side)


def reach_of_top(wall: Masonry, side: str) -> Reach:
    """What the hold at the top of a wall gives as it moves to a side: inward it is pressed, which nothing bounds but
    `in_kn_m`."""
    declared = wall.declared
    strength, pressed = require_value(declared.strength), declared.inward
    forces = min(strength, UNLIMITED), UNLIMITED if pressed is None else pressed
    return Reach(require_value(wall.height), *(forces if side != INWARD else forces[::-1]))


def reaction_of_base(sections: Sections, moving: MovingStrip, alpha: float, side: str) -> float:
    """Largest shear [N/m] of the joint at the base under pushes up to alpha [-]: at rest the least that what holds the
    top leaves to it."""
    if alpha >= moving.alpha0:
        return moving.bound(alpha, at_base=True)
    reach = reach_of_top(sections.wall, side)
    most = min(reach.outward, greatest_at_top(sections, reach.height, alpha))
    return max(0.0, base_reaction(sections, [most], alpha))


def limit_of_ends(wall: Masonry, moving: MovingStrip) -> HoldLimit:
    """Limit of the ends of a wall that spans between transverse walls: each stands the friction of its thrust across
    it and what is said to hold it, against V = (alpha W + what presses the wall)/2. The thrust of the masonry beyond
    is what its own inertia along the wall leaves of it.

    moving : the strip that lies, a metre of its height
    """
    arch, strip = require_value(wall.arch), moving.strip
    at_rest = max(0.0, 2.0 * arch.held_across / strip.weight - strip.pressed)
    if not arch.beyond:
        return HoldLimit(ENDS, arch.held_across, at_rest, "outward")

    def holds(alpha: float) -> bool:
        return 0.5 * (alpha + strip.pressed) * strip.weight <= arch.under(alpha).held_across

    push, _, _ = narrowed(holds, 0.0, at_rest, steps=BISECTIONS)
    return HoldLimit(ENDS, arch.under(push).held_across, push, "outward")
