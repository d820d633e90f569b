"""The stretches of a wall between its base and what holds it, in which it bends before it turns about its base."""

import math
from collections.abc import Sequence
from dataclasses import replace

from core.case.loads import Load
from core.case.wall import BENDS, Wall
from core.codes.vertical_bending import MIN_SLENDERNESS, bending
from core.known import known
from core.units import G
from core.wall.wall_loads import hinge_inside, restoring_with_ties

MIN_SHARE_OF_BENDING = 0.8
"""Share of the multiplier by which a wall bends from which it is looked at: where turning about the base with its ties
at yield starts at less, that governs."""


def spans_of(wall: Wall) -> tuple[tuple[float, float], ...]:
    """Stretches (from, to) above the base [m] in which a rectangle on one side bends below its ties, where these hold
    about as much as one block takes, or more: from its base, each tie and each weight (which holds only what is below
    it) to each tie above, over ties too weak for what the stretches beside them push with; at least MIN_SLENDERNESS
    times as high as thick. Empty of any other wall, and where more than weights acts below the highest tie (a thrust
    there goes into it), or a tie has slack."""
    ties = sorted({load.h_m for load in wall.load if load.is_tie})
    if not ties or any(load.slack_mm for load in wall.load) or wall.thickness is None:
        return ()
    if wall.mechanism != "one_sided" or wall.has_shape or wall.return_walls is not None:
        return ()
    others = [load.h_m for load in wall.load if load.kind not in ("vertical", "tie")]
    least = MIN_SLENDERNESS * wall.thickness
    if any(height < ties[-1] for height in others):
        return ()
    holds = _holds(wall, ties)
    lows = sorted({0.0, *ties, *(load.h_m for load in wall.load if load.is_weight)})
    pairs = tuple(
        (low, high)
        for high in ties
        for low in lows
        if high - low >= least and not any(low < hold < high for hold in holds)
    )
    if not pairs or hinge_inside(wall.in_si) is not None:
        return pairs
    turning = _at_yield(wall)
    return tuple(pair for pair in pairs if turning >= MIN_SHARE_OF_BENDING * bending(between(wall, *pair).in_si).alpha0)


def _holds(wall: Wall, ties: Sequence[float]) -> list[float]:
    """Heights of the ties that stand what the stretches below and above push on them with as they bend [m]."""
    heights, strength = [], {}
    for load, one in zip(wall.load, wall.in_si.loads, strict=True):
        if load.is_tie:
            strength[load.h_m] = strength.get(load.h_m, 0.0) + one.force
    for below, height, above in zip([0.0, *ties], ties, ties[1:], strict=False):
        least = MIN_SLENDERNESS * known(wall.thickness)
        if min(height - below, above - height) < least:
            continue
        lower, upper = (bending(between(wall, *pair).in_si) for pair in ((below, height), (height, above)))
        pushes = lower.top_force + upper.alpha0 * upper.mass * G - upper.top_force
        if strength[height] >= pushes:
            heights.append(height)
    return heights


def _at_yield(wall: Wall) -> float:
    """alpha_0 of the wall about its base, its ties at yield."""
    masonry = wall.in_si
    side = restoring_with_ties(masonry)
    return side.sine * math.tan(masonry.block.slenderness) + side.cosine


def _is_shown(wall: Wall) -> bool:
    """Whether the engineer says what shows the ties: evidence of the restraint behind the wall is none of them."""
    reasons = wall.justification
    return reasons is not None and bool(reasons.anchorage_kn or reasons.elongation_m)


def named_between(name: str, low: float, high: float) -> str:
    """What a stretch of a wall is called."""
    return f"{name} ({low:.4g}–{high:.4g} m)"


def between(wall: Wall, low: float, high: float) -> Wall:
    """The stretch of a wall between two heights above its base [m], held at its top by the tie there. What is above
    stands on it, at the middle of the wall: its mass is held by the tie."""
    assert wall.thickness is not None and wall.height_m is not None and wall.unit_weight_kn_m3 is not None
    above = wall.unit_weight_kn_m3 * wall.thickness * (wall.height_m - high)
    loads = [
        replace(load, kind="vertical", h_m=min(load.h_m, high) - low, mass="none" if load.h_m >= high else load.mass)
        for load in wall.load
        if load.is_weight and load.h_m > low
    ]
    if above > 0.0:
        loads.append(Load(kind="vertical", kn_m=above, d_m=0.5 * wall.thickness, h_m=high - low, mass="none"))
    return replace(
        wall,
        name=named_between(wall.title, low, high),
        mechanism=BENDS,
        height_m=high - low,
        thickness_m=wall.thickness,
        slenderness_deg=None,
        height_over_thickness=None,
        base_z_m=None if wall.base_z_m is None else wall.base_z_m + low,
        hinge_heights=None,
        restitution=None,
        velocity_ratio=None,
        law="auto",
        free_element=None,
        load=tuple(loads),
        unloaded_confirmed=wall.unloaded_confirmed or not loads,
        tie_height_m=None,
        tie_bar_length_m=None,
        tie_elongation_m=None,
        tie_spacing_m=None,
        back_restraint="other",
        restraint_evidence=wall.restraint_evidence if _is_shown(wall) else None,
        arch=None,
        restraint_kn_m=math.inf,  # the tie: what it stands is looked at where the stretch is chosen
        restraint_note=f"tie, catena: {high:.4g} m",
    )
