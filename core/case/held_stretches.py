"""The stretches of a wall between floors and ties that are shown to hold it outward: it bends between them."""

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


BRITTLE = 0.5
"""Share of its force that a tie which stands no elongation beyond yield holds: the wall runs into it."""


class HeldStretch(NamedTuple):
    """A stretch of a wall between two heights above its base [m], as a wall of its own."""

    low: float
    high: float
    wall: Wall


def stands_outward(hold: Hold) -> bool:
    """Whether a floor, a roof, a ring beam or an anchor is said to hold a wall outward."""
    return hold.kind in AT_A_HEIGHT and hold.out_kn_m is not None


def find_held_stretches(wall: Wall) -> list[HeldStretch]:
    """The stretches of a wall that is held by floors, or by ties at two heights, from its base to its highest hold. A
    hold between two of them is shared out in the proportion of the weights that hang on it from below and from above:
    what both ask for is then within what it stands; a thrust at a hold, or above the highest, is taken first. Empty
    where a thrust acts between two holds, no stretch is slender
    enough to bend, or the wall is not one sheet."""
    taut = {load.h_m for load in wall.load if load.is_tie and not load.slack_mm}
    held = len(taut) > 1 or any(stands_outward(hold) for hold in wall.hold)
    sized = wall.thickness is not None and wall.height_m is not None and wall.unit_weight_kn_m3 is not None
    if not held or not sized or not wall.leans or wall.return_walls is not None or not is_one_sheet(wall):
        return []
    levels = _levels(wall)
    pairs = list(pairwise([0.0, *(require_value(level.h_m) for level in levels)]))
    if not pairs or not all(bears_stretch(wall, low, high) for low, high in pairs):
        return []
    for load in wall.load:
        if load.kind == "thrust":
            n = next((n for n, (_, high) in enumerate(pairs) if abs(load.h_m - high) <= SAME_HEIGHT), None)
            n = len(pairs) - 1 if n is None and load.h_m > pairs[-1][1] else n
            if n is None:
                return []
            taken = max(0.0, require_value(load.kn_m)) * max(1.0, _lever(load.h_m, *pairs[n]))
            levels[n] = replace(levels[n], out_kn_m=max(0.0, require_value(levels[n].out_kn_m) - taken))
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
            share = 1.0 if require_value(in_si.tie).stands_more else BRITTLE
            yield Hold("tie", h_m=load.h_m, out_kn_m=share * 1e-3 * in_si.force, evidence=shown_ties(wall))


def _levels(wall: Wall) -> list[Hold]:
    """One hold for each height, from below: what all there stand. Of two between which the wall is too stocky to bend
    the stronger one counts alone."""
    levels: list[Hold] = []
    for hold in sorted(_outward_holds(wall), key=lambda hold: require_value(hold.h_m)):
        if levels and require_value(hold.h_m) - require_value(levels[-1].h_m) <= SAME_HEIGHT:
            both = require_value(levels[-1].out_kn_m) + require_value(hold.out_kn_m)
            shown = levels[-1].evidence and hold.evidence
            levels[-1] = replace(levels[-1], out_kn_m=both, evidence=shown)
        else:
            levels.append(hold)
    return _spaced(levels, MIN_SLENDERNESS * require_value(wall.thickness))


def _spaced(levels: list[Hold], least: float) -> list[Hold]:
    """The holds that are at least so far apart [m], the base among them."""
    spaced: list[Hold] = []
    for level in levels:
        height = require_value(level.h_m)
        if spaced and height - require_value(spaced[-1].h_m) < least:
            spaced[-1] = max(spaced[-1], level, key=lambda hold: require_value(hold.out_kn_m))
        elif height >= least:
            spaced.append(level)
    return spaced


def _beside(wall: Wall, low: float, high: float, last: bool) -> float:
    """Weight [kN/m] whose inertia goes to the hold at the top of a stretch beside what the stretch hands to it: what
    the wall carries there, and above the highest hold all that is above, by its lever over the stretch."""
    carried = [load for load in wall.load if load.is_weight and load.pushes]
    above = [load for load in carried if (load.h_m >= high if last else abs(load.h_m - high) <= SAME_HEIGHT)]
    beside = sum(require_value(load.kn_m) * max(1.0, _lever(load.h_m, low, high)) for load in above)
    if last and require_value(wall.height_m) > high:
        weight, _, over = weight_above(wall, high)
        beside += weight * _lever(high + over, low, high)
    return beside


def _lever(height: float, low: float, high: float) -> float:
    """Share of a force at a height that goes to the upper end of a stretch, a simple beam."""
    return (height - low) / (high - low)
