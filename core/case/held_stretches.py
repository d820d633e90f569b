"""The stretches of a wall between floors that are shown to hold it outward: it bends between them."""

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from typing import NamedTuple

from core.case.hold import AT_A_HEIGHT, Hold, ShareOfHold
from core.case.spans_between_ties import bears_stretch, cut_span, is_one_sheet, shown_ties, weight_above
from core.case.wall import Wall
from core.codes.vertical_bending import MIN_SLENDERNESS
from core.known import require_value
from core.units import G

SAME_HEIGHT = 0.05
"""Holds and loads nearer than this act at one height [m]."""


class HeldStretch(NamedTuple):
    """A stretch of a wall between two heights above its base [m], as a wall of its own."""

    low: float
    high: float
    wall: Wall


def stands_outward(hold: Hold) -> bool:
    """Whether a floor, a roof, a ring beam or an anchor is said to hold a wall outward."""
    return hold.kind in AT_A_HEIGHT and hold.out_kn_m is not None


def find_held_stretches(wall: Wall) -> list[HeldStretch]:
    """The stretches of an anchored wall from its base to its highest hold. A hold between two of them is shared out in
    the proportion of the weights that hang on it from below and from above: what both ask for is then within what it
    stands. Empty where a thrust acts between two holds, a stretch is too stocky to bend, or the wall is not one sheet.
    """
    if not wall.leans or not any(stands_outward(hold) for hold in wall.hold) or not _is_cut(wall):
        return []
    levels = _levels(wall)
    pairs = list(pairwise([0.0, *(require_value(level.h_m) for level in levels)]))
    least = MIN_SLENDERNESS * require_value(wall.thickness)
    if any(high - low < least or not bears_stretch(wall, low, high) for low, high in pairs):
        return []
    stretches = [cut_span(wall, low, high) for low, high in pairs]
    halves = [0.5 * _pushed(stretch) for stretch in stretches]
    beside = [_beside(wall, *pair, last=pair == pairs[-1]) for pair in pairs]
    held = []
    for n, ((low, high), stretch) in enumerate(zip(pairs, stretches, strict=True)):
        from_below, from_above = halves[n] + beside[n], sum(halves[n + 1 : n + 2])
        top = _share(levels[n], high - low, from_below / (from_below + from_above), beside[n])
        foot = ()
        if n > 0:
            under = halves[n - 1] + beside[n - 1]
            foot = (_share(levels[n - 1], 0.0, halves[n] / (under + halves[n])),)
            top = top if foot[0].evidence else replace(top, evidence=None)
        held.append(HeldStretch(low, high, replace(stretch, hold=(*foot, top))))
    return held


def highest_anchor(wall: Wall) -> float | None:
    """Height of the highest hold of an anchored wall that reaches above it by more than it is thick [m], so that the
    part there turns; None of another wall."""
    if not (stretches := find_held_stretches(wall)):
        return None
    top = stretches[-1].high
    return top if require_value(wall.height_m) - top > require_value(wall.thickness) else None


def _pushed(stretch: Wall) -> float:
    """Weight of a stretch and of what it carries that the earthquake pushes [kN/m]."""
    own = stretch.in_si
    return 1e-3 * (own.weight + G * sum(point.mass for point in own.masses))


def _share(level: Hold, height: float, share: float, beside: float = 0.0) -> ShareOfHold:
    stands = share * require_value(level.out_kn_m)
    return ShareOfHold(level.kind, level.name, h_m=height, out_kn_m=stands, evidence=level.evidence, beside_kn_m=beside)


def _outward_holds(wall: Wall) -> Iterator[Hold]:
    """What holds a wall outward, its ties among it but those with slack, which hold nothing before they are taut; what
    is not shown to stand without its document."""
    for hold in wall.hold:
        if stands_outward(hold):
            yield hold if hold.shows_strength else replace(hold, evidence=None)
    for load, in_si in zip(wall.load, wall.in_si.loads, strict=True):
        if load.is_tie and not load.slack_mm:
            yield Hold("tie", h_m=load.h_m, out_kn_m=1e-3 * in_si.force, evidence=shown_ties(wall))


def _levels(wall: Wall) -> list[Hold]:
    """One hold for each height, from below: what all there stand, less the thrusts they take first."""
    levels: list[Hold] = []
    for hold in sorted(_outward_holds(wall), key=lambda hold: require_value(hold.h_m)):
        if levels and require_value(hold.h_m) - require_value(levels[-1].h_m) <= SAME_HEIGHT:
            both = require_value(levels[-1].out_kn_m) + require_value(hold.out_kn_m)
            shown = levels[-1].evidence and hold.evidence
            levels[-1] = replace(levels[-1], out_kn_m=both, evidence=shown)
        else:
            levels.append(hold)
    thrusts = [load for load in wall.load if load.kind == "thrust"]
    for n, level in enumerate(levels):
        pressed = sum(require_value(load.kn_m) for load in thrusts if _acts_at(load.h_m, level))
        levels[n] = replace(level, out_kn_m=max(0.0, require_value(level.out_kn_m) - max(0.0, pressed)))
    return levels


def _acts_at(height: float, level: Hold) -> bool:
    return abs(height - require_value(level.h_m)) <= SAME_HEIGHT


def _is_cut(wall: Wall) -> bool:
    """Whether a wall is one sheet, with no thrust but at its holds."""
    sized = wall.thickness is not None and wall.height_m is not None and wall.unit_weight_kn_m3 is not None
    if not sized or wall.return_walls is not None or not is_one_sheet(wall):
        return False
    levels = list(_outward_holds(wall))
    thrusts = [load.h_m for load in wall.load if load.kind == "thrust"]
    return all(any(_acts_at(height, level) for level in levels) for height in thrusts)


def _beside(wall: Wall, low: float, high: float, last: bool) -> float:
    """Weight [kN/m] whose inertia goes to the hold at the top of a stretch beside what the stretch hands to it: what
    the wall carries there, and above the highest hold all that is above, by its lever over the stretch."""
    carried = [load for load in wall.load if load.is_weight and load.pushes]
    above = [load for load in carried if (load.h_m >= high if last else abs(load.h_m - high) <= SAME_HEIGHT)]
    beside = sum(require_value(load.kn_m) * max(1.0, (load.h_m - low) / (high - low)) for load in above)
    if last and require_value(wall.height_m) > high:
        weight, _, over = weight_above(wall, high)
        beside += weight * (high + over - low) / (high - low)
    return beside
