"""The stretches of a wall between its base and what holds it, in which it bends before it turns about its base."""

import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from core.case.above_hinge import cut_above_hinge, solid_of
from core.case.document import Document
from core.case.held_top import mirror_inward
from core.case.hold import TIE, Hold, ShareOfHold
from core.case.loads import Load, OwnWeight
from core.case.shape import cut_between
from core.case.wall import Wall
from core.codes.vertical_bending import MIN_SLENDERNESS, bending, lowest_hinge, start_multiplier
from core.errors import InputError
from core.known import require_value
from core.units import G
from core.wall.bending import strip_of
from core.wall.body import cut_above, sum_bodies
from core.wall.kinematics import BENDS
from core.wall.solids import contact_at, faces_at, is_dragged
from core.wall.wall_loads import hinge_inside, restoring_with_ties

MIN_SHARE_OF_BENDING = 0.8
"""Share of the multiplier by which a wall bends from which it is looked at: where turning about the base with its ties
at yield starts at less, that governs."""

TURNS_WELL_BEFORE = 4.0 / 3.0
"""Multiplier of bending over that of turning from which turning governs: its e* is 3/4 of a plain wall, and none is
above 1."""


def find_bending_spans(wall: Wall, hinges: Sequence[float] = ()) -> tuple[tuple[float, float], ...]:
    """Stretches (from, to) above the base [m] in which a wall on one side bends below a tie that holds about as much as
    one block takes, or more, whatever holds it between: from its base, each tie and each weight (which holds only what
    is below it) to each tie above, where it bends from none of these from each of its hinges about which it is no
    longer one block; at least MIN_SLENDERNESS times as high as thick. What it drags along of return walls is no part of
    them. Empty of a corner and of oblique or dragged solids, and where more than weights acts below the highest tie (a
    thrust there goes into it), or a tie has slack."""
    ties = sorted({require_value(tie.h_m) for tie in wall.ties})
    if not ties or wall.thickness is None or has_load_below_tie(wall):
        return ()
    if not wall.leans or wall.return_walls is not None or not is_one_sheet(wall):
        return ()
    weights = {load.h_m for load in wall.load if load.is_weight}
    if found := _spans_from(wall, sorted({0.0, *ties, *weights}), ties):
        return found
    return _spans_from(wall, [hinge for hinge in hinges if hinge < ties[-1] and opens_inside(wall, hinge)], ties)


def _spans_from(wall: Wall, lows: Sequence[float], ties: Sequence[float]) -> tuple[tuple[float, float], ...]:
    """`find_bending_spans` from these heights [m]."""
    least = MIN_SLENDERNESS * require_value(wall.thickness)
    pairs = tuple(
        (low, high) for high in ties for low in lows if high - low >= least and bears_stretch(wall, low, high)
    )
    pairs = tuple(pair for pair in pairs if stands_between(wall, *pair) or not _has_tie_inside(wall, *pair))
    if not pairs or hinge_inside(wall.in_si) is not None:
        return pairs
    return tuple(pair for pair in pairs if _bends_first(wall, *pair))


def stands_between(wall: Wall, low: float, high: float) -> bool:
    """Whether a stretch of a wall stands on its two ends alone, without an earthquake, under its thrusts."""
    if not any(load.is_thrust and low < load.h_m < high for load in wall.load):
        return True
    strip = strip_of(cut_span(wall, low, high).in_si)
    return start_multiplier(strip, lowest_hinge(strip)) > 0.0


def _has_tie_inside(wall: Wall, low: float, high: float) -> bool:
    """Whether a tie holds a wall between two heights [m]."""
    return any(low < require_value(tie.h_m) < high for tie in wall.ties)


def _bends_first(wall: Wall, low: float, high: float) -> bool:
    """Whether a stretch of a wall bends before the wall, or its part from there up, turns: that opens a hinge inside,
    or starts at no much smaller multiplier."""
    starts = MIN_SHARE_OF_BENDING * bending(cut_span(wall, low, high).in_si).alpha0
    if low == 0.0 or multiplier_at_yield(wall) >= starts:
        return multiplier_at_yield(wall) >= starts
    try:
        return opens_inside(wall, low) or multiplier_at_yield(cut_above_hinge(wall, low)) >= starts
    except InputError:  # nothing turns there
        return False


def opens_inside(wall: Wall, hinge: float) -> bool:
    """Whether the part of a wall above a hinge opens another one before it turns: its ties are that strong."""
    return hinge_inside(cut_above_hinge(wall, hinge).in_si) is not None


def find_inward_spans(
    wall: Wall, hinges: Sequence[float], outward: Sequence[tuple[float, float]]
) -> list[tuple[float, float]]:
    """Stretches (from, to) above the base [m] in which a wall that leans bends inward, pressed against the floors
    behind it, unless it turns outward well before; none of a stretch with
    something behind it all along.

    hinges : about which it turns; outward : stretches that are looked at as they bend both ways
    """
    sized = wall.thickness is not None and wall.height_m is not None and wall.unit_weight_kn_m3 is not None
    if not sized or not wall.leans or not is_one_sheet(wall):
        return []
    height, least = require_value(wall.height_m), MIN_SLENDERNESS * require_value(wall.thickness)
    floors = {require_value(hold.h_m) for hold in wall.restraints if hold.has_height and hold.is_contact}
    along = [(hold.from_m or 0.0, hold.to_m or height) for hold in wall.restraints if not hold.has_height]
    stops = sorted({0.0, *floors, *(min(end, height) for ends in along for end in ends)})
    free = [pair for pair in pairwise(stops) if not any(low <= pair[0] and pair[1] <= high for low, high in along)]
    between = [(low, high) for low, high in free if high - low >= least and bears_stretch(wall, low, high)]
    return [pair for pair in between if pair not in outward and not _turns_well_before(wall, hinges, *pair)]


def _turns_well_before(wall: Wall, hinges: Sequence[float], low: float, high: float) -> bool:
    """Whether a wall turns outward about a hinge that is looked at, at the foot of a stretch or above, where the motion
    is no less, long before it bends inward there."""
    inward = bending(mirror_inward(cut_span(wall, low, high)).in_si).alpha0
    feet = (hinge for hinge in (0.0, *hinges) if hinge >= low)
    return any(inward >= TURNS_WELL_BEFORE * multiplier_at_yield(cut_above_hinge(wall, foot)) for foot in feet)


def leaves_stretches_out(wall: Wall) -> bool:
    """Whether a wall may bend between its base and a tie, and that is not looked at: beside a thrust, a slack tie,
    friction of return walls or solids at an angle."""
    if not wall.leans or wall.thickness is None:
        return False
    least = MIN_SLENDERNESS * wall.thickness
    if not any(require_value(tie.h_m) >= least for tie in wall.ties):
        return False
    if has_load_below_tie(wall) or wall.return_walls is not None or not is_one_sheet(wall):
        return True
    highest = max(require_value(tie.h_m) for tie in wall.ties)
    return not stands_between(wall, 0.0, highest)  # it needs the ties between


def has_load_below_tie(wall: Wall) -> bool:
    """Whether something acts below the highest tie of a wall that no stretch is looked at with, or a tie has slack."""
    highest = max((require_value(tie.h_m) for tie in wall.ties), default=0.0)
    others = (load.h_m for load in wall.load if not load.rests and not load.pushes_outward)
    return any(tie.slack_mm for tie in wall.ties) or any(height < highest for height in others)


def is_one_sheet(wall: Wall) -> bool:
    """Whether nothing but wedges of return walls is at an angle to a wall, or behind it."""
    if wall.corner is not None:
        return False
    parts, face = wall.parts, require_value(wall.thickness)
    return not any(part.plane == "oblique" or is_dragged(part, parts, face) for part in parts)


def bears_stretch(wall: Wall, low: float, high: float) -> bool:
    """Whether a stretch of a wall stands on what is below it, and reaches the tie above it."""
    parts = _sheet(wall)
    return not parts or (contact_at(parts, low) is not None and faces_at(parts, high, below=True) is not None)


def _sheet(wall: Wall) -> tuple:
    """The solids of a wall without wedges; none of a rectangle."""
    return tuple(part for part in wall.parts if not part.wedge)


def multiplier_at_yield(wall: Wall) -> float:
    """alpha_0 of the wall about its base, its ties at yield."""
    masonry = wall.in_si
    side = restoring_with_ties(masonry)
    return side.sine * math.tan(masonry.block.slenderness) + side.cosine


def _shown(wall: Wall) -> Document | None:
    """What shows that the ties of a wall hold, of one that shows it of its tie not that: what shows that something
    stands behind the wall is none of them."""
    unshown = [tie for tie in wall.ties if not tie.shows_strength]
    return next((tie.evidence for tie in (*unshown, *wall.ties)), None)


def named_between(name: str, low: float, high: float) -> str:
    """What a stretch of a wall is called."""
    return f"{name} ({low:.4g}–{high:.4g} m)"


def cut_span(wall: Wall, low: float, high: float, foot_stays: bool = False) -> Wall:
    """The stretch of a wall between two heights above its base [m], held at its top by the tie there. What is above
    stands on it, a rectangle at its middle, another wall where its centroid is: its mass is held by the tie.

    foot_stays : the joint at its foot is taken to hold; else it is compared, but at a tie
    """
    assert wall.thickness is not None and wall.height_m is not None and wall.unit_weight_kn_m3 is not None
    cut, outer, held = _cut(wall, low, high)
    heights = {tie.h_m for tie in wall.ties}
    thickness, (weight, depth, _) = require_value(cut["thickness_m"]), weight_above(wall, high)

    def inside(load: Load) -> float:
        """Distance of a weight from the outer face of the stretch [m]: on the stretch, what is above it at its top."""
        least, most = held if load.h_m >= high else (0.0, thickness)
        return min(max(require_value(load.d_m) - outer, least), most)

    loads = [
        replace(
            load,
            kind="vertical",
            d_m=inside(load) if wall.has_shape else load.d_m,
            h_m=min(load.h_m, high) - low,
            mass="none" if load.h_m >= high else load.mass,
        )
        for load in wall.load
        if load.is_weight and load.h_m > low
    ]
    loads += [
        replace(load, d_m=min(max((load.d_m or 0.0) - outer, 0.0), thickness), h_m=load.h_m - low)
        for load in wall.load
        if load.is_thrust and low < load.h_m < high and not _is_tied(wall, load)
    ]
    if weight > 0.0:
        on_top = OwnWeight(kind="vertical", kn_m=weight, d_m=depth, h_m=high, mass="none")
        loads.append(replace(on_top, d_m=inside(on_top) if wall.has_shape else depth, h_m=high - low))
    return replace(
        wall,
        **cut,
        name=named_between(wall.title, low, high),
        mechanism=BENDS,
        height_m=high - low,
        slenderness_deg=None,
        height_over_thickness=None,
        base_z_m=None if wall.base_z_m is None else wall.base_z_m + low,
        hinge_heights=None,
        base_friction=wall.base_friction if low == 0.0 else None,
        restitution=None,
        velocity_ratio=None,
        law="auto",
        load=tuple(loads),
        unloaded_confirmed=wall.unloaded_confirmed or not loads,
        # what the ties stand is looked at where the stretch is chosen
        hold=(
            *([ShareOfHold(TIE, h_m=0.0, out_kn_m=math.inf)] if foot_stays or low in heights else []),
            ShareOfHold(
                TIE, h_m=high - low, out_kn_m=math.inf, evidence=_shown(wall), backed=is_stopped(wall, low, high)
            ),
        ),
    )


AT_TIE = 0.05
"""How near to a tie a thrust goes into it [m]."""


def _is_tied(wall: Wall, load: Load) -> bool:
    """Whether a tie takes a thrust where it acts."""
    near = (tie for tie in wall.ties if abs(require_value(tie.h_m) - load.h_m) <= AT_TIE and not tie.slack_mm)
    return sum(1e-3 * tie.tie(wall.length_m).bar.strength for tie in near) >= require_value(load.kn_m)


def is_backed(wall: Wall, low: float, high: float) -> bool:
    """Whether something that a document shows is behind a wall all along between two heights [m]."""
    along = (hold for hold in wall.hold if hold.is_contact and not hold.has_height and hold.evidence is not None)
    return any(
        (hold.from_m or 0.0) <= low + AT_TIE and high - AT_TIE <= (math.inf if hold.to_m is None else hold.to_m)
        for hold in along
    )


def is_stopped(wall: Wall, low: float, high: float) -> bool:
    """Whether a wall cannot bend inward over all of a stretch: something that a document shows is behind it all along,
    or a floor within it, below and above which it is looked at as it bends inward: far enough from both ends for that,
    and where all that is behind the stretch is shown. A floor with a strength inward (`in_kn_m`) may give way, so that
    it stops nothing here."""
    least = MIN_SLENDERNESS * require_value(wall.thickness)
    behind = [hold for hold in wall.hold if hold.is_contact and _reaches_into(hold, low, high)]
    floors = [hold for hold in behind if hold.has_height and hold.in_kn_m is None]
    inside = any(low + least <= require_value(floor.h_m) <= high - least for floor in floors)
    return is_backed(wall, low, high) or (inside and all(hold.evidence is not None for hold in behind))


def _reaches_into(hold: Hold, low: float, high: float) -> bool:
    """Whether a hold is between two heights [m], or behind some of what is between them."""
    if hold.has_height:
        return low + AT_TIE < require_value(hold.h_m) < high - AT_TIE
    return (hold.from_m or 0.0) < high and low < (math.inf if hold.to_m is None else hold.to_m)


NO_SHAPE: dict = {"openings": (), "steps": (), "gable_m": None, "out_of_plumb_m": None, "return_wedges": None}
"""Keys of a shape of a wall that is written as solids."""


def _cut(wall: Wall, low: float, high: float) -> tuple[dict, float, tuple[float, float]]:
    """Keys of a stretch of a wall that change with its shape; x of its outer face at its base [m], and of the faces at
    its top from there."""
    parts, thickness = _sheet(wall), require_value(wall.thickness)
    if not parts:
        return {"solid": (), **NO_SHAPE, "thickness_m": thickness}, 0.0, (0.0, thickness)
    (outer, inner), highest = require_value(contact_at(parts, low)), require_value(faces_at(parts, high, below=True))
    weights = [solid.unit_weight_kn_m3 for solid in wall.solid] or [None] * len(parts)
    solids = []
    for part, weight in zip(parts, weights, strict=True):
        if polygon := cut_between(part.polygon, low, high):
            solids.append(solid_of(part, [(s, z - low) for s, z in polygon], outer, weight))
    keys = {"solid": tuple(solids), **NO_SHAPE, "thickness_m": min(inner - outer, thickness)}
    return keys, outer, (highest[0] - outer, highest[1] - outer)


def weight_above(wall: Wall, height: float) -> tuple[float, float, float]:
    """Weight of what is above a height of a wall [kN/m], x of its centroid from the outer face of its base, and z of it
    from that height [m]."""
    if not (parts := _sheet(wall)):
        thickness, left = require_value(wall.thickness), require_value(wall.height_m) - height
        return require_value(wall.unit_weight_kn_m3) * thickness * left, 0.5 * thickness, 0.5 * left
    cut = ((part, cut_above(part.polygon, height)) for part in parts)
    bodies = [part._replace(polygon=tuple(polygon)).body for part, polygon in cut if polygon]
    body = sum_bodies(bodies) if bodies else None
    if body is None or body.mass <= 0.0:  # the tie is at the top
        return 0.0, 0.0, 0.0
    return 1e-3 * G * body.mass / require_value(wall.length_m), *body.centroid
