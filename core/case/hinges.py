"""The hinges of a wall of several storeys: one wall for each, from the hinge up."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

from core.case.above_hinge import MIN_HEIGHT_ABOVE, cut_above_hinge, part_name
from core.case.above_holds import rocks_above
from core.case.detached import leaf_label, make_leaf_wall
from core.case.directions import directions_of, falls_all_ways
from core.case.floor_loads import add_corner_thrust, add_floor_loads
from core.case.held_stretches import HeldStretch, find_held_ways, highest_anchors
from core.case.held_top import mirror_inward
from core.case.hold import Hold, ShareOfHold, hold_kind
from core.case.schema import Case
from core.case.site import Building
from core.case.spanning import make_spanning_part, named_spanning, spans
from core.case.spans_between_ties import (
    cut_span,
    find_bending_spans,
    find_inward_spans,
    multiplier_at_yield,
    named_between,
    opens_inside,
)
from core.case.wall import Wall
from core.codes.vertical_bending import MIN_SLENDERNESS, bending
from core.errors import InputError, place
from core.known import require_value
from core.wall.solids import SNAP, changes, contact_at

FLOORS, BASE = "floors", "base"
"""Hinges at every floor of the building between the base of the wall and its top; the one at its base alone."""

SLENDER_ABOVE = 3.0
"""Without `hinge_heights` a hinge is looked at where the wall above it has at least this H/t: a lower part of a wall is
a parapet's or a sill's, which turns as a block of its own."""

SAME_HINGE = 0.05
"""A load or a floor nearer than this to a step, or to another one, has no hinge of its own [m]."""


@dataclass(frozen=True)
class WallPart:
    """A wall of the case from one of its hinges up.

    origin : index of the wall in the case; asked : the wall there
    hinge : above its base [m], 0 for the whole wall
    wall : to be analysed, with a name for people
    top : of a stretch that bends between the hinge and a tie, the height of the tie above the base [m], of a wall that
        spans between transverse walls its own; else None
    aspect : of what is not the wall itself but its outer leaf, or the wall in another direction, what tells it
    of : what it is the part of: the wall with the floors that bear on it, or that leaf or direction
    inward : it bends inward there, between what stands behind it
    held : between holds that are shown to hold it, 1 with all of them, 2 without those that have gone; 0 of another one
    gone : heights of these above the base [m]; within : it ends at one of them that has yielded
    """

    origin: int
    asked: Wall
    hinge: float
    wall: Wall
    top: float | None = None
    aspect: str = ""
    of: Wall | None = None
    inward: bool = False
    held: int = 0
    gone: tuple[float, ...] = ()
    within: bool = False

    @property
    def body(self) -> Wall:
        """What it is the part of."""
        return self.asked if self.of is None else self.of

    @property
    def is_whole(self) -> bool:
        """Whether it is the wall of the case about its base, which keeps its name."""
        return self.hinge == 0.0 and self.turns

    @property
    def turns(self) -> bool:
        """Whether it is the wall itself that turns about a hinge."""
        return self.top is None and not self.aspect

    @property
    def own_name(self) -> str:
        """Name of the wall as people read it, without the variant."""
        if self.wall.arch is not None and self.top is not None and self.wall.kinematics.arches:
            return named_spanning(self.body.name, require_value(self.wall.arch.spacing_m))
        if self.held:
            return f"{self.body.name} {held_stretch_name(self.hinge, self.top, self.gone, self.wall, self.within)}"
        if self.top is not None:
            return named_between(self.body.name, self.hinge, self.top)
        return part_name(self.body.name, self.hinge)


def hinges_of(wall: Wall, building: Building | None) -> Sequence[float]:
    """Heights of the hinges above the base of a wall [m], without the one at its base: as asked, else those of
    `default_hinges` where the building is known."""
    asked = wall.hinge_heights
    if wall.bends:  # its hinge is where alpha_0 is lowest
        return ()
    if asked is not None and not isinstance(asked, str):
        return asked
    if asked == BASE or building is None:
        return ()
    if asked is None:
        return default_hinges(wall, building)
    return storey_ends(wall, building)


def find_unchecked_hinges(wall: Wall, building: Building | None) -> tuple[float, ...]:
    """Hinges that a wall about its base has too and that nobody looks at [m]: their motion is not known without its
    building, or the engineer leaves them out."""
    # what moves it at its highest hold is not known without it, the participation of modes at one height alone
    free = highest_hold(wall, building) if building is None or building.modes else None
    usual: Sequence[float] = default_hinges(wall, building)
    if wall.hinge_heights is not None:
        looked = turning_hinges(wall, building)
        usual = [height for height in usual if all(abs(height - hinge) > SAME_HINGE for hinge in looked)]
    elif building is not None:
        usual = ()
    if free is None:
        return tuple(usual)
    return tuple(sorted({free, *(height for height in usual if abs(height - free) > SAME_HINGE)}))


def storey_ends(wall: Wall, building: Building) -> tuple[float, ...]:
    """Heights of the floors of a building above the base of a wall, between it and the top of the wall [m]."""
    if wall.height_m is None:
        return ()
    storey, base = building.height_m / building.storeys, wall.base_z_m or 0.0
    heights = (storey * floor - base for floor in range(1, building.storeys + 1))
    return tuple(h for h in heights if MIN_HEIGHT_ABOVE <= h <= wall.height_m - MIN_HEIGHT_ABOVE)


def default_hinges(wall: Wall, building: Building | None) -> tuple[float, ...]:
    """Heights above the base of a wall at which it carries something, its tie to be designed too, a storey ends, its
    section changes (a step, a sill, a lintel, another masonry) or its gable begins, and SLENDER_ABOVE times the
    thickness there is above [m]. A mechanism may start at any of them (Circolare 7/2019 C8.7.1.2.1)."""
    if wall.height_m is None or wall.thickness is None or wall.bends:
        return ()
    ties = (require_value(hold.h_m) for hold in wall.hold if hold.is_bar)
    loads = (*(load.h_m for load in wall.load), *ties)
    shape = changes(wall.parts) if wall.parts else ()
    others = [*loads, *(storey_ends(wall, building) if building else ())]
    apart = [height for height in others if all(abs(height - z) > SAME_HINGE + SNAP for z in shape)]
    heights: list[float] = []
    for height in sorted({*shape, *apart}):
        faces = contact_at(wall.parts, height) if wall.parts else None
        thickness = min(faces[1] - faces[0], wall.thickness) if faces else wall.thickness
        highest = wall.height_m - max(SLENDER_ABOVE * thickness, MIN_HEIGHT_ABOVE)
        near = bool(heights) and height - heights[-1] <= SAME_HINGE + SNAP and height not in shape
        if MIN_HEIGHT_ABOVE <= height <= highest + 1e-9 and not near:
            heights.append(height)
    return tuple(heights)


def check_hinges(wall: Wall, building: Building | None) -> None:
    """Raise InputError for hinges a wall cannot have."""
    if wall.hinge_heights is None:
        return
    here = (place("wall", name=wall.title),)
    if wall.height_m is None:
        raise InputError("hinges_need_rectangle", place=here, key="hinge_heights")
    if wall.hinge_heights == BASE:
        return
    if isinstance(wall.hinge_heights, str):
        if building is None:
            raise InputError("hinges_need_building", place=here, key="hinge_heights")
        return
    highest = max(wall.hinge_heights)
    if highest > wall.height_m - MIN_HEIGHT_ABOVE:
        raise InputError(
            "hinge_above_wall", place=here, key="hinge_heights", hinge=highest, most=wall.height_m - MIN_HEIGHT_ABOVE
        )


def variant_key(part: WallPart, mechanism: str) -> tuple[str, float, str]:
    """Key that a wall about a hinge shares only with its other variant: name given, hinge [m], mechanism. A wall held
    at its top has here the mechanism one_sided, the overturning that its restraint prevents."""
    if not part.turns:
        return part.own_name, part.hinge, mechanism
    return part.asked.name, part.hinge, "one_sided" if part.wall.bends else mechanism


def make_wall_parts(k: int, asked: Wall, building: Building | None) -> list[WallPart]:
    """The k-th wall of a case from every hinge of its up, where its ties make it bend between them, between its
    transverse walls, its outer leaf alone, and in its other directions."""
    whole = add_floor_loads(asked, building)
    of = None if whole is asked else whole
    made = _of_ties(WallPart(k, asked, 0.0, whole, of=of), turning_hinges(whole, building), building)
    if spans(whole):
        made.append(WallPart(k, asked, 0.0, make_spanning_part(whole), whole.height_m, of=of))
    if whole.leaf is not None:
        leaf = make_leaf_wall(whole)
        part = WallPart(k, asked, 0.0, leaf, None, leaf_label(whole.leaf), leaf)
        made += _of_ties(part, _hinges_of_leaf(leaf, building), building)
    for aspect, turned in directions_of(whole):
        part = WallPart(k, asked, 0.0, turned, None, aspect, turned)
        made += _of_ties(part, turning_hinges(turned, building), building)
    return made


def _of_ties(part: WallPart, hinges: Sequence[float], building: Building | None) -> list[WallPart]:
    """A wall about its base and these hinges, and as it bends between its ties. part : the whole of it"""
    whole = part.wall
    held_to = None if part.aspect or (building and building.modes) else highest_hold(whole, building)
    turning = []
    for hinge in (0.0, *hinges):
        above = add_corner_thrust(cut_above_hinge(whole, hinge))
        unheld = bool(whole.restraints) and not above.restraints and not above.ties
        free = unheld or (held_to is not None and hinge >= held_to - SAME_HINGE)
        turning.append(replace(part, hinge=hinge, wall=make_free(above) if free else above))
    spans = _spans_of_leaf(whole) if part.aspect else find_bending_spans(whole, hinges)
    bending = [replace(part, hinge=low, wall=cut_span(whole, low, high), top=high) for low, high in spans]
    inward = () if part.aspect else find_inward_spans(whole, hinges, spans)
    held = () if part.aspect else find_held_ways(whole)
    return [
        *turning,
        *bending,
        *(_bent_inward(part, low, high) for low, high in inward),
        *(_held_part(part, stretch, n) for n, way in enumerate(held, start=1) for stretch in way),
    ]


def held_stretch_name(low: float, high: float | None, gone: tuple[float, ...], stretch: Wall, within: bool) -> str:
    """What tells a stretch between holds: its heights, those of the holds that have gone, and of the ties that have
    yielded along it or at its ends, marked by ~ [m]."""
    shares = (hold for hold in stretch.hold if isinstance(hold, ShareOfHold) and hold.yielded)
    yields = [low + require_value(hold.h_m) for hold in shares] + ([low, high or 0.0] if within else [])
    pulls = [any(abs(height - other) <= SAME_HINGE for other in yields) for height in gone]
    without = "".join(f", {'~' if pull else '−'}{height:.4g}" for height, pull in zip(gone, pulls, strict=True))
    return f"[{low:.4g}–{high:.4g}{without} m]"


def _held_part(part: WallPart, stretch: HeldStretch, way: int) -> WallPart:
    held = replace(part, hinge=stretch.low, wall=stretch.wall, top=stretch.high, held=way, gone=stretch.gone)
    held = replace(held, inward=stretch.inward, within=stretch.within)
    name = (
        f"{part.wall.title} {held_stretch_name(stretch.low, stretch.high, stretch.gone, stretch.wall, stretch.within)}"
    )
    return replace(held, wall=replace(stretch.wall, name=name))


def best_way(
    parts: Sequence[WallPart], worst: Callable[[list[int]], Any], loses_hold: Callable[[int], bool]
) -> list[int]:
    """Numbers of the parts of a wall that count: an anchored wall bends between its holds as long as these hold. Where
    one of them gives way before all else, and while the wall is at rest, the wall without it takes its place if that is
    better: between the others, and so on, at last as it turns. What moves whatever holds it below counts in all ways.

    worst : of parts by their numbers, what the worst of them comes to, the more the better
    loses_hold : whether what decides about a part is a hold that gives way while the wall is at rest
    """
    numbers = list(range(len(parts)))
    counted: list[int] = []
    for way in [*range(1, 1 + max(part.held for part in parts)), 0]:
        held = [k for k in numbers if parts[k].held == way]
        top = max((require_value(parts[k].top) for k in held), default=None) if way else None
        shared = [k for k in numbers if not parts[k].held and (top is None or _counts_anyway(parts[k], top))]
        found = sorted({*held, *shared})
        if not counted or worst(found) > worst(counted):
            counted = found
        first = min(held, key=lambda k: worst([k])) if way else 0
        if way and (parts[first].inward or not loses_hold(first)):  # what fails inward stops nothing in any way
            break
    return counted


def _counts_anyway(part: WallPart, top: float) -> bool:
    """Whether a part moves whatever holds the wall below a height: what is above, a leaf. Between transverse walls it
    would bend across the floors that hold it, if nothing above these leans on the transverse walls."""
    free = part.turns and (part.hinge >= top - SAME_HINGE or not part.wall.leans)
    arch, height = part.wall.arch if part.wall.kinematics.arches else None, part.body.height_m or 0.0
    reach = min(arch.to_m or height, height) if arch is not None else 0.0
    leans_above = reach > top + SAME_HINGE and rocks_above(part.body, top)
    return bool(part.aspect) or free or leans_above


def _bent_inward(part: WallPart, low: float, high: float) -> WallPart:
    """A stretch of a wall as it bends inward: its mirror as it bends outward."""
    stretch = cut_span(part.wall, low, high, foot_stays=True)  # a floor stands behind the foot, or what it is built on
    return replace(part, hinge=low, wall=mirror_inward(stretch), top=high, inward=True)


def highest_hold(wall: Wall, building: Building | None) -> float | None:
    """Height above the base of a wall that leans up to which something stops it inward [m]: its highest hold. What
    stands above is free, and rocks to both sides (C8.7.1.2.1.3: porzioni svettanti). None of a wall that
    does not reach higher by so much that it rocks, that begins there, or of which nobody says how far it is held."""
    if not wall.leans or wall.height_m is None or wall.corner is not None:
        return None
    tops = _tops_of_holds(wall, building)
    if None in tops or not tops:
        return None
    held = max(top for top in tops if top is not None)  # a tie above that stops nothing inward
    if held <= 0.0:
        return None
    return held if rocks_above(wall, held) else None


def _heights(holds: Iterable[Hold]) -> set[float]:
    """Heights of holds above the base of their wall [m]."""
    return {require_value(hold.h_m) for hold in holds}


def _tops_of_holds(wall: Wall, building: Building | None) -> list[float | None]:
    """Heights above the base of a wall up to which each of its holds holds it [m]; None of one whose end nobody
    says."""
    least = [require_value(hold.h_m) for hold in wall.hold if hold_kind(hold.kind).of_building]
    least = [max(least)] if least else []
    least += [wall.shoulder] if wall.gable_m else []
    least += [building.height_m - (wall.base_z_m or 0.0)] if building else []
    return [hold.top(least) for hold in wall.hold if hold.is_contact]


def leaves_end_open(wall: Wall, building: Building | None) -> bool:
    """Whether nobody says up to which height a wall that leans is held: its own part above that may be free."""
    return wall.leans and wall.corner is None and None in _tops_of_holds(wall, building)


def make_free(wall: Wall) -> Wall:
    """The part of a wall above what holds it, which rocks to both sides; itself where its loads let it stand to one
    side alone."""
    sides: dict[str, Any] = {"mechanism": "two_sided", "restitution": None, "velocity_ratio": None, "law": "auto"}
    free = replace(wall, **sides, hold=())
    return free if free.in_si.rocks_both_ways else wall


MOST_ROWS, MOST_SPANS = 8, 6
"""Rows of connectors above which a leaf is looked at, and stretches up to the highest of them: evenly spread where
there are more, beside the one that starts the soonest."""


def _spread(ordered: Sequence, most: int) -> list:
    """So many of some values, evenly spread, the first and the last among them."""
    if len(ordered) <= most:
        return list(ordered)
    return [ordered[round(k * (len(ordered) - 1) / (most - 1))] for k in range(most)]


def _spans_of_leaf(leaf: Wall) -> list[tuple[float, float]]:
    """The stretches that are looked at of the many between rows of connectors: those up to the highest row, evenly
    spread, and the one that starts to bend the soonest."""
    spans = find_bending_spans(leaf)
    highest = max((high for _, high in spans), default=0.0)
    kept = _spread(sorted(span for span in spans if span[1] == highest), MOST_SPANS)
    soonest = sorted(spans, key=lambda span: bending(cut_span(leaf, *span).in_si).alpha0)[:1]
    return sorted({*kept, *soonest})


def _hinges_of_leaf(leaf: Wall, building: Building | None) -> list[float]:
    """The usual hinges of a leaf, its rows of connectors among them, and those that are asked for."""
    asked = leaf.hinge_heights
    given = asked if asked is not None and not isinstance(asked, str) else ()
    rows = _heights(leaf.ties)
    usual = default_hinges(leaf, building)
    there = [height for height in usual if height in rows]
    soonest = sorted(there, key=lambda row: multiplier_at_yield(cut_above_hinge(leaf, row)))[:1]
    others = [height for height in usual if height not in rows]
    return sorted({*given, *others, *_spread(there, MOST_ROWS), *soonest})


def count_wall_parts(asked: Wall, building: Building | None) -> int:
    """Number of `parts_of` by each of their mechanisms, without making them where they are those of most walls."""
    whole = add_floor_loads(asked, building)
    if whole.leaf is not None or falls_all_ways(whole) or len(whole.mechanisms()) > 1:
        return sum(len(part.wall.mechanisms()) for part in make_wall_parts(0, whole, building))
    hinges = turning_hinges(whole, building)
    between_ties = find_bending_spans(whole, hinges)
    bending = len(between_ties) + len(find_inward_spans(whole, hinges, between_ties))
    held = sum(map(len, find_held_ways(whole)))
    return (1 + len(hinges)) * len(whole.mechanisms()) + bending + spans(whole) + held


def turns_above_ties(wall: Wall, hinge: float) -> bool:
    """Whether a wall turns about the highest of the ties above a hinge of its before it bends between: it is too stocky
    there."""
    ties = [height for height in _heights(wall.ties) if height > hinge]
    stocky = all(tie - hinge < MIN_SLENDERNESS * require_value(wall.thickness) for tie in ties)
    return bool(ties) and stocky and max(ties) in default_hinges(wall, None)


def turning_hinges(wall: Wall, building: Building | None) -> Sequence[float]:
    """Heights of the hinges about which a wall turns, with what is brought to it; above a tie below which it bends it
    may, whatever is asked."""
    hinges = hinges_of(wall, building)
    held_to = None if building is None or building.modes else highest_hold(wall, building)
    if held_to is not None and all(abs(held_to - hinge) > SAME_HINGE for hinge in hinges):
        hinges = sorted([*hinges, held_to])
    for anchor in highest_anchors(wall):
        if all(abs(anchor - hinge) > SAME_HINGE for hinge in hinges):
            hinges = sorted([*hinges, anchor])
    ties = {high for _, high in find_bending_spans(wall, hinges)}
    if any(turns_above_ties(wall, hinge) and opens_inside(wall, hinge) for hinge in (0.0, *hinges)):
        ties.add(max(_heights(wall.ties)))
    if not ties:
        return hinges
    more = [height for height in default_hinges(wall, building) if height in ties and height not in hinges]
    return sorted([*hinges, *more]) if more else hinges


def parts(case: Case) -> list[WallPart]:
    """Every wall of the case from every hinge of its up."""
    return [part for k, asked in enumerate(case.wall) for part in make_wall_parts(k, asked, case.building)]
