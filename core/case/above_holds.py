"""What is above the highest hold of a wall: a part that rocks, or a stub, and what it hands to the hold."""

import math
from dataclasses import replace

from core.case.above_hinge import MIN_HEIGHT_ABOVE, cut_above_hinge
from core.case.spans_between_ties import weight_above
from core.case.wall import Wall
from core.known import require_value
from core.units import G
from core.wall.masonry import PartAbove, StubAbove
from core.wall.solids import contact_at

SAME_HEIGHT = 0.05
"""Holds and loads nearer than this act at one height [m]."""

STUB_PUSH = 1.4
"""alpha up to which what is above the highest hold is looked at: a plain block that stands more is too stocky to rock,
its restitution (Eq. 4) is negative beyond 1.41."""


def stands_above(wall: Wall, top: float) -> bool:
    """Whether what is above the highest hold turns about it as a part that is looked at, or is a stub that stands
    without an earthquake."""
    return rocks_above(wall, top) or _push_of_stub(wall, top) > 0.0


def rocks_above(wall: Wall, top: float) -> bool:
    """Whether what is above a height of a wall is looked at as a part of its own: what is so low that a plain wall
    there stands STUB_PUSH is not."""
    left = require_value(wall.height_m) - top
    if left < MIN_HEIGHT_ABOVE:
        return False
    faces = contact_at(wall.parts, top) if wall.parts else None
    thickness = min(wall.thickness or math.inf, faces[1] - faces[0] if faces else math.inf)
    return STUB_PUSH * left > thickness - 2.0 * cut_above_hinge(wall, top).setback


def _push_of_stub(wall: Wall, top: float) -> float:
    """Least alpha at which what is above a height of a wall turns about one of its edges there, with what it carries
    [-]; inf of a wall of unknown weight."""
    if wall.unit_weight_kn_m3 is None or wall.thickness is None:
        return math.inf
    weight, x, over = weight_above(wall, top)
    outer, inner = (contact_at(wall.parts, top) if wall.parts else None) or (0.0, wall.thickness)
    outward, inward = weight * (x - outer - wall.setback), weight * (inner - wall.setback - x)
    pushed = weight * over
    for load in (load for load in wall.load if load.h_m > top + SAME_HEIGHT):
        size, lever = require_value(load.kn_m), load.h_m - top
        outward += size * (require_value(load.d_m) - outer - wall.setback) if load.is_weight else -size * lever
        inward += size * (inner - wall.setback - require_value(load.d_m)) if load.is_weight else size * lever
        pushed += size * lever if load.is_weight and load.pushes else 0.0
    held = min(outward, inward)
    return held / pushed if pushed > 0.0 else math.copysign(math.inf, held)


def find_part_above(wall: Wall, low: float, high: float) -> PartAbove | None:
    """What rocks above the highest hold of a wall; None where that is too little to be looked at. low, high : of the
    stretch below the hold [m]"""
    if not rocks_above(wall, high):
        return None
    above = cut_above_hinge(wall, high).without_ties()
    own = replace(above, hold=(), mechanism="two_sided").in_si
    block, weight = own.block, own.moving_weight
    rise = block.radius * math.cos(block.slenderness)
    multiplier = max(side.sine * math.tan(sides.slenderness) + side.cosine for sides, side in own.sides)
    growth = weight * (1.0 - block.p2 * rise**2 / (G * block.radius))
    return PartAbove(weight, 1.0 + rise / (high - low), max(0.0, multiplier), growth)


def find_stub_above(wall: Wall, top: float) -> StubAbove | None:
    """What may fall off the highest hold of a wall, at a height [m], before STUB_PUSH; None of a stub that stands that,
    or of unknown weight."""
    multiplier = _push_of_stub(wall, top)
    if multiplier >= STUB_PUSH:
        return None
    carried = (load for load in wall.load if load.is_weight and load.pushes and load.h_m > top + SAME_HEIGHT)
    weight = weight_above(wall, top)[0] + sum(require_value(load.kn_m) for load in carried)
    return StubAbove(1e3 * weight, multiplier)


def upper_share(height: float, low: float, high: float) -> float:
    """Share of a force at a height that goes to the upper end of a stretch, a simple beam."""
    return (height - low) / (high - low)


def weight_beside(wall: Wall, low: float, high: float, last: bool) -> float:
    """Weight [kN/m] whose inertia goes to the hold at the top of a stretch beside what the stretch hands to it: what
    the wall carries there, and above the highest hold all that is above, by its lever over the stretch."""
    carried = [load for load in wall.load if load.is_weight and load.pushes]
    above = [load for load in carried if (load.h_m >= high if last else abs(load.h_m - high) <= SAME_HEIGHT)]
    beside = sum(require_value(load.kn_m) * max(1.0, upper_share(load.h_m, low, high)) for load in above)
    if last and require_value(wall.height_m) > high:
        weight, _, over = weight_above(wall, high)
        beside += weight * upper_share(high + over, low, high)
    return beside
