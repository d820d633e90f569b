"""The stretches of a wall between floors and ties that are shown to hold it outward: it bends between them."""

import itertools
import math
from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from typing import NamedTuple

from core.case.above_holds import (
    SAME_HEIGHT,
    find_part_above,
    find_stub_above,
    rocks_above,
    stands_above,
    upper_share,
    weight_beside,
)
from core.case.held_top import mirror_inward
from core.case.hold import TIE, Hold, ShareOfHold
from core.case.loads import Load
from core.case.spans_between_ties import bears_stretch, cut_span, is_backed, is_one_sheet, is_stopped
from core.case.wall import Wall
from core.codes.vertical_bending import MIN_SLENDERNESS, lowest_hinge, start_multiplier
from core.errors import InputError
from core.known import require_value
from core.units import G
from core.wall.bending import strip_of

BRITTLE = 0.5
"""Share of its force that a tie which stands no elongation beyond yield holds: the wall runs into it."""


BENDS_WELL_BEFORE = 1.25
"""Multiple of the alpha at which a wall bends at which its weakest hold would give way, from which that is not looked
at: the demand shares out what a hold stands between two stretches a little differently."""


class HeldStretch(NamedTuple):
    """A stretch of a wall between two heights above its base [m], as a wall of its own.

    gone : heights of the holds without which it bends, or which yield along it [m]; inward : mirrored, over holds that
        stop nothing inward
    within : it ends where a tie has yielded, within a stretch of the same way
    """

    low: float
    high: float
    wall: Wall
    gone: tuple[float, ...] = ()
    inward: bool = False
    within: bool = False


def stands_outward(hold: Hold) -> bool:
    """Whether a floor, a roof, a ring beam or an anchor is said to hold a wall outward."""
    return hold.has_height and not hold.is_bar and hold.out_kn_m is not None


MOST_HOLDS = 8
"""Holds among which those are chosen that are far enough apart: of more, the highest."""


def find_held_ways(wall: Wall) -> list[list[HeldStretch]]:
    """The stretches of a wall with all its holds and, one after the other, without each that then gives way first while
    the wall is at rest: a tie that stands an elongation beyond yield goes on pulling. Empty as `find_held_stretches`
    says."""
    ways: list[list[HeldStretch]] = []
    gone: tuple[float, ...] = ()
    while stretches := find_held_stretches(left := _without(wall, gone), yielded := _yielded_at(wall, gone)):
        within = list(_stretches_at_bars(left, stretches, yielded))
        more = (*within, *_bent_inward(left, stretches, within))
        ways.append([stretch._replace(gone=gone) for stretch in (*stretches, *more)])
        lost = _first_to_go(stretches)
        if lost is None:
            break
        gone = (*gone, lost)
    return ways


def _without(wall: Wall, gone: tuple[float, ...]) -> Wall:
    """A wall whose holds at some heights [m] have given way outward."""
    left = (_weakened(hold) if _is_at(hold, gone) else hold for hold in wall.hold)
    return replace(wall, hold=tuple(hold for hold in left if hold is not None)) if gone else wall


MOST_YIELDED = 3
"""Ties that go on pulling once they have yielded, the strongest: of more the others are left out, the safe side."""


def _yielded_at(wall: Wall, gone: tuple[float, ...]) -> tuple[ShareOfHold, ...]:
    """The ties at some heights [m] that go on pulling once they have yielded. A prestress is left out: they yield the
    later."""
    ties = ((hold, hold.tie(wall.length_m)) for hold in wall.ties if _is_at(hold, gone) and not hold.slack_mm)
    ductile = sorted((pair for pair in ties if pair[1].stands_more), key=lambda pair: -pair[1].bar.strength)
    return tuple(
        ShareOfHold(
            TIE,
            hold.name,
            h_m=hold.h_m,
            out_kn_m=1e-3 * tie.bar.strength,
            evidence=hold.evidence,
            yielded=replace(tie.bar, slack=0.0, stands=tie.bar.breaks_at),
        )
        for hold, tie in ductile[:MOST_YIELDED]
    )


def _stretches_at_bars(
    wall: Wall, stretches: list[HeldStretch], yielded: tuple[ShareOfHold, ...]
) -> Iterator[HeldStretch]:
    """The stretches of a wall that end where a tie has yielded: it may bend up to there, or from there on, without
    making that tie longer. What holds an end at a hold is that of the stretch over the ties."""
    least = MIN_SLENDERNESS * require_value(wall.thickness)
    for whole in stretches:
        inside = sorted(h for h in map(_height, yielded) if whole.low + SAME_HEIGHT < h < whole.high - SAME_HEIGHT)
        apart = [h for h, before in zip(inside, [-math.inf, *inside], strict=False) if h - before > SAME_HEIGHT]
        places = [whole.low, *apart, whole.high]
        for low, high in itertools.combinations(places, 2):
            if high - low < least or (low, high) == (whole.low, whole.high) or not bears_stretch(wall, low, high):
                continue
            span = cut_span(wall, low, high, foot_stays=low > whole.low or whole.low > 0.0)
            ties = (tie for tie in yielded if any(abs(_height(tie) - end) <= SAME_HEIGHT for end in (low, high)))
            named = min(ties, key=lambda tie: tie.shows_strength)  # of both the one that nothing shows
            top, held = replace(span.hold[-1], name=named.name, evidence=named.evidence), whole.wall.hold[-1]
            if high == whole.high and isinstance(held, ShareOfHold):
                beside = max(held.beside_kn_m, weight_beside(wall, low, high, last=high == stretches[-1].high))
                top = replace(held, h_m=high - low, beside_kn_m=beside, backed=is_stopped(wall, low, high))
            foot = [hold for hold in whole.wall.hold if hold.h_m == 0.0] if low == whole.low else span.hold[:-1]
            part = replace(span, hold=(*foot, top))
            yield _add_bars(HeldStretch(low, high, part, within=True), yielded)


def _first_to_go(stretches: list[HeldStretch]) -> float | None:
    """Height of the hold that gives way first [m], of stiff ones; None where the wall bends well before."""
    pushes = _pushes_of_holds(stretches)
    first = min(pushes, key=lambda height: pushes[height])
    return first if pushes[first] <= BENDS_WELL_BEFORE * _start_of_bending(stretches) else None


def _pushes_of_holds(stretches: list[HeldStretch]) -> dict[float, float]:
    """Height of each hold of some stretches -> alpha at which it gives way, a stiff one [-]."""
    tops = [stretch.wall.hold[-1] for stretch in stretches]
    return {
        stretch.high: require_value(top.out_kn_m) / (0.5 * _pushed(stretch.wall) + _pushed_beside(top))
        for stretch, top in zip(stretches, tops, strict=True)
    }


def _place(stretches: list[HeldStretch]) -> tuple[float, float]:
    """What tells the better of two choices of holds: how high they hold, then alpha at which the first of them gives
    way or a stretch bends [-]."""
    return stretches[-1].high, min(*_pushes_of_holds(stretches).values(), _start_of_bending(stretches))


def _bent_inward(wall: Wall, stretches: list[HeldStretch], within: list[HeldStretch]) -> Iterator[HeldStretch]:
    """A wall as it bends inward over anchors and ties that pull and stop nothing: between what is behind it. within :
    stretches that end at ties, which bend both ways where no strength inward is said"""
    heights = {height: stretch.wall.hold[-1] for stretch in stretches if _is_stopped(wall, height := stretch.high)}
    behind = {require_value(hold.h_m): hold for hold in wall.hold if hold.is_contact and hold.has_height}
    apart = {height: hold for height, hold in behind.items() if all(abs(height - at) > SAME_HEIGHT for at in heights)}
    tops = {height: hold for height, hold in (heights | apart).items() if height <= stretches[-1].high}
    least = MIN_SLENDERNESS * require_value(wall.thickness)
    for low, high in pairwise([0.0, *sorted(tops)]):
        both_ways = stretches if tops[high].in_kn_m is not None else [*stretches, *within]
        looked_at = any(stretch.low == low and stretch.high == high for stretch in both_ways)
        if not looked_at and high - low >= least and not is_backed(wall, low, high):
            span = mirror_inward(cut_span(wall, low, high, foot_stays=True))
            top = tops[high]  # it presses on what it leans on
            stands = math.inf if top.in_kn_m is None else top.in_kn_m
            over = replace(span.hold[-1], kind=top.kind, name=top.name, out_kn_m=stands, evidence=top.evidence)
            held = (over if hold.h_m else hold for hold in span.hold)
            yield HeldStretch(low, high, replace(span, hold=tuple(held)), inward=True)


def _is_stopped(wall: Wall, height: float) -> bool:
    """Whether something is behind a wall at a height [m]."""

    def reaches(hold: Hold) -> bool:
        if hold.has_height:
            return _is_at(hold, (height,))
        low, high = hold.from_m or 0.0, math.inf if hold.to_m is None else hold.to_m
        return low - SAME_HEIGHT <= height <= high + SAME_HEIGHT

    return any(hold.is_contact and reaches(hold) for hold in wall.hold)


def _is_at(hold: Hold, heights: tuple[float, ...]) -> bool:
    """Whether it holds a wall at one of some heights [m]."""
    return hold.has_height and any(abs(require_value(hold.h_m) - height) <= SAME_HEIGHT for height in heights)


def _weakened(hold: Hold) -> Hold | None:
    """A hold that has given way outward: it stops the wall inward alone, by what it stands there; None of one that only
    pulled."""
    return replace(hold, out_kn_m=None, elongation_m=None, stiffness_kn_m2=None) if hold.is_contact else None


def _pushed_beside(top: Hold) -> float:
    """Weight [kN/m] whose inertia goes to a hold beside its stretch."""
    if not isinstance(top, ShareOfHold):
        return 0.0
    return top.beside_kn_m + (1e-3 * top.rocking.lever * top.rocking.weight if top.rocking else 0.0)


def _start_of_bending(stretches: list[HeldStretch]) -> float:
    """Least alpha_0 of some stretches [-]; none above 0 of one that its thrust bends without an earthquake."""
    strips = [strip_of(stretch.wall.in_si) for stretch in stretches]
    return min(start_multiplier(strip, lowest_hinge(strip)) for strip in strips)


def find_held_stretches(wall: Wall, yielded: tuple[ShareOfHold, ...] = ()) -> list[HeldStretch]:
    """The stretches of a wall that is held by floors, or by ties at two heights, from its base to its highest hold. A
    hold between two of them is shared out in the proportion of the weights that hang on it from below and from above:
    what both ask for is then within what it stands; a thrust at a hold, or above the highest, is taken first, one
    between two bends the stretch there. Empty where a pull inward acts between two holds, nothing is behind the wall up
    to the highest, no stretch is slender enough to bend, the stub above may fall, or the wall is not one sheet.

    yielded : ties that pull along the stretches
    """
    taut = sorted(require_value(tie.h_m) for tie in wall.ties if not tie.slack_mm)
    held = (bool(taut) and taut[-1] - taut[0] > SAME_HEIGHT) or any(stands_outward(hold) for hold in wall.hold)
    held = held or bool(taut and yielded)
    sized = wall.thickness is not None and wall.height_m is not None and wall.unit_weight_kn_m3 is not None
    if not held or not sized or not wall.leans or wall.return_walls is not None or not is_one_sheet(wall):
        return []
    ways = (_stretches_between(wall, levels, yielded) for levels in _spaced_sets(wall, _levels(wall)))
    return max(filter(None, ways), key=_place, default=[])


def refuse_uncounted_holds(wall: Wall, here) -> None:
    """Raise InputError for a wall that has no `find_held_stretches`, though a hold is said to stand something: what is
    at fault. here : place of the hold"""
    heights = [require_value(hold.h_m) for hold in _outward_holds(wall)]
    highest = max(heights)

    def pulls(load: Load) -> bool:
        return load.is_thrust and load.h_m < highest and require_value(load.kn_m) < 0.0

    if wall.leans and not _is_stopped(wall, highest):
        raise InputError("hold_nothing_behind", place=here, key="out_kn_m", height=highest)
    if load := next(filter(pulls, wall.load), None):
        raise InputError("hold_thrust_between", place=here, key="out_kn_m", height=load.h_m)
    if wall.leans and wall.height_m is not None and is_one_sheet(wall) and not stands_above(wall, highest):
        raise InputError("hold_stub_falls", place=here, key="out_kn_m", height=highest)
    raise InputError("hold_not_counted", place=here, key="out_kn_m", least=MIN_SLENDERNESS)


def _stretches_between(wall: Wall, levels: list[Hold], yielded: tuple[ShareOfHold, ...]) -> list[HeldStretch]:
    """The stretches of a wall between its base and these holds, with the ties that have yielded; empty as
    `find_held_stretches` says."""
    pairs = list(pairwise([0.0, *(require_value(level.h_m) for level in levels)]))
    if not stands_above(wall, pairs[-1][1]):
        return []
    if not all(bears_stretch(wall, low, high) for low, high in pairs):
        return []
    stretches = [cut_span(wall, low, high) for low, high in pairs]
    stretches = stretches[:-1] + _bent_above(stretches[-1], wall, pairs[-1][1])
    shares = _less_thrusts(wall, levels, pairs)
    if not shares or len(stretches) != len(pairs):
        return []
    return [_add_bars(stretch, yielded) for stretch in _share_levels(wall, shares, stretches, pairs)]


def _height(hold: Hold) -> float:
    """Height of a hold that has one [m]."""
    return require_value(hold.h_m)


def _add_bars(stretch: HeldStretch, yielded: tuple[ShareOfHold, ...]) -> HeldStretch:
    """A stretch with the ties between its ends, of which one that nothing shows is named."""
    low, high, (*foot, top) = stretch.low, stretch.high, stretch.wall.hold
    bars = [
        replace(tie, h_m=height - low, yielded=replace(require_value(tie.yielded), height=height - low))
        for tie in yielded
        if low + SAME_HEIGHT < (height := require_value(tie.h_m)) < high - SAME_HEIGHT
    ]
    if unshown := next((tie for tie in bars if not tie.shows_strength), None):
        top = replace(top, kind=unshown.kind, name=unshown.name, evidence=unshown.evidence)
    return stretch._replace(wall=replace(stretch.wall, hold=(*foot, *bars, top)))


def _share_levels(
    wall: Wall, levels: list[Hold], stretches: list[Wall], pairs: list[tuple[float, float]]
) -> list[HeldStretch]:
    """The stretches with what each hold has for them."""
    halves = [0.5 * _pushed(stretch) for stretch in stretches]
    above = find_part_above(wall, *pairs[-1])
    beside = [weight_beside(wall, *pair, last=pair == pairs[-1] and above is None) for pair in pairs]
    held = []
    for n, ((low, high), stretch) in enumerate(zip(pairs, stretches, strict=True)):
        from_below, from_above = halves[n] + beside[n], sum(halves[n + 1 : n + 2])
        top = _share(levels[n], high - low, from_below / (from_below + from_above), beside[n])
        top = replace(top, backed=is_stopped(wall, low, high))
        if n == len(pairs) - 1:
            top = replace(top, rocking=above, stub=None if above else find_stub_above(wall, high))
        foot: tuple[ShareOfHold, ...] = ()
        if n > 0:
            under = halves[n - 1] + beside[n - 1]
            foot = (_share(levels[n - 1], 0.0, halves[n] / (under + halves[n])),)
            if not foot[0].shows_strength:  # that one is named
                top = replace(top, kind=foot[0].kind, name=foot[0].name, evidence=foot[0].evidence)
        held.append(HeldStretch(low, high, replace(stretch, hold=(*foot, top))))
    return held


def _less_thrusts(wall: Wall, levels: list[Hold], pairs: list[tuple[float, float]]) -> list[Hold]:
    """The holds less the thrusts they take first; none where one pulls inward."""
    left = list(levels)
    for load in wall.load:
        if not load.is_thrust:
            continue
        n = next((n for n, (_, high) in enumerate(pairs) if abs(load.h_m - high) <= SAME_HEIGHT), None)
        n = len(pairs) - 1 if n is None and load.h_m > pairs[-1][1] else n
        if require_value(load.kn_m) < 0.0:
            return []
        if n is None:  # between two
            continue
        taken = require_value(load.kn_m) * max(1.0, upper_share(load.h_m, *pairs[n]))
        left[n] = replace(left[n], out_kn_m=max(0.0, require_value(left[n].out_kn_m) - taken))
    return left


def highest_anchors(wall: Wall) -> set[float]:
    """Heights of the highest holds of an anchored wall that reaches well above them, so that the part there turns [m]:
    of all of them and of those that are left."""
    highest = {max(stretch.high for stretch in way) for way in find_held_ways(wall)}
    return {height for height in highest if rocks_above(wall, height)}


def _pushed(stretch: Wall) -> float:
    """Weight of a stretch and of what it carries that the earthquake pushes [kN/m]."""
    own = stretch.in_si
    return 1e-3 * (own.weight + G * sum(point.mass for point in own.masses))


def _share(level: Hold, height: float, share: float, beside: float = 0.0) -> ShareOfHold:
    inward = None if level.in_kn_m is None else share * level.in_kn_m
    stands = share * require_value(level.out_kn_m)
    stiffness = None if level.stiffness_kn_m2 is None else share * level.stiffness_kn_m2
    shared = ShareOfHold(level.kind, level.name, h_m=height, out_kn_m=stands, in_kn_m=inward, beside_kn_m=beside)
    stretched = None if level.is_bar else level.elongation_m
    return replace(shared, evidence=level.evidence, stiffness_kn_m2=stiffness, elongation_m=stretched)


def _outward_holds(wall: Wall) -> Iterator[Hold]:
    """What holds a wall outward, its ties among it but those with slack, which hold nothing before they are taut."""
    for hold in wall.hold:
        if stands_outward(hold):
            yield hold
    for hold in wall.ties:
        if not hold.slack_mm:
            tie = hold.tie(wall.length_m)
            stands = 1e-3 * tie.bar.strength * (1.0 if tie.stands_more else BRITTLE)
            yield Hold(TIE, hold.name, h_m=hold.h_m, out_kn_m=stands, evidence=hold.evidence)


def _bent_above(stretch: Wall, wall: Wall, high: float) -> list[Wall]:
    """The last stretch as a thrust above its hold bends it: the weights on its top stand as much nearer to its outer
    face; none where they would be off it."""
    thrusts = (load for load in wall.load if load.is_thrust and load.h_m > high)
    moment = sum(require_value(load.kn_m) * (load.h_m - high) for load in thrusts)
    top = require_value(stretch.height_m)
    weight = sum(require_value(load.kn_m) for load in stretch.load if load.h_m >= top)
    if moment == 0.0:
        return [stretch]
    if weight <= 0.0:
        return []
    by = moment / weight
    moved = [replace(load, d_m=require_value(load.d_m) - by) if load.h_m >= top else load for load in stretch.load]
    inside = all(0.0 <= require_value(load.d_m) <= require_value(stretch.thickness) for load in moved)
    return [replace(stretch, load=tuple(moved))] if inside else []


def _levels(wall: Wall) -> list[Hold]:
    """One hold for each height, from below: what all there stand."""
    levels: list[Hold] = []
    for hold in sorted(_outward_holds(wall), key=lambda hold: require_value(hold.h_m)):
        if levels and require_value(hold.h_m) - require_value(levels[-1].h_m) <= SAME_HEIGHT:
            both = require_value(levels[-1].out_kn_m) + require_value(hold.out_kn_m)
            shown = next((one.evidence for one in (levels[-1], hold) if not one.shows_strength), hold.evidence)
            stiff = [one.stiffness_kn_m2 for one in (levels[-1], hold) if one.stiffness_kn_m2 is not None]
            stretches = [one.elongation_m for one in (levels[-1], hold)]
            least = None if None in stretches else min(filter(None, stretches))  # brittle if one of both is
            levels[-1] = replace(levels[-1], out_kn_m=both, evidence=shown, elongation_m=least)
            levels[-1] = replace(levels[-1], stiffness_kn_m2=sum(stiff) or None)
        else:
            levels.append(hold)
    return levels


def _spaced_sets(wall: Wall, levels: list[Hold]) -> Iterator[list[Hold]]:
    """The sets of holds between which, and above the base, a wall is slender enough to bend, the highest with something
    behind it, each as large as it can be: what is between two that are nearer stays whole, and one counts alone."""
    least = MIN_SLENDERNESS * require_value(wall.thickness)
    heights = [height for level in levels if (height := require_value(level.h_m)) >= least]
    spaced: list[set[float]] = []
    for count in range(min(len(heights), MOST_HOLDS), 0, -1):
        for kept in itertools.combinations(heights[-MOST_HOLDS:], count):
            far = all(upper - lower >= least for lower, upper in pairwise(kept))
            if far and _is_stopped(wall, kept[-1]) and not any(larger.issuperset(kept) for larger in spaced):
                spaced.append(set(kept))
                yield [level for level in levels if require_value(level.h_m) in kept]
