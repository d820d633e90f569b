"""The stretches of a wall between its base and what holds it, in which it bends before it turns about its base."""

import itertools
from dataclasses import replace

from core.case.loads import Load
from core.case.wall import BENDS, Wall
from core.codes.vertical_bending import LEAST_SLENDERNESS
from core.wall.wall_loads import hinge_inside


def spans_of(wall: Wall) -> tuple[tuple[float, float], ...]:
    """Stretches (from, to) above the base [m] of a rectangle on one side whose ties would open a hinge above its base:
    between base and ties, also from where a weight stands between them, for the weight holds only what is below it; at
    least LEAST_SLENDERNESS times as high as thick. Empty of any other wall, and where more
    than weights acts below the highest tie (a thrust there goes into it), a tie has slack, or the hinge would open
    above that tie."""
    ties = sorted({load.h_m for load in wall.load if load.is_tie})
    if not ties or any(load.slack_mm for load in wall.load) or wall.thickness is None:
        return ()
    if wall.mechanism != "one_sided" or wall.has_shape or wall.return_walls is not None:
        return ()
    if (hinge := hinge_inside(wall.in_si)) is None:
        return ()
    weights = {load.h_m for load in wall.load if load.is_weight}
    pairs = [
        (low, high)
        for hold, high in itertools.pairwise([0.0, *ties])
        for low in sorted({hold, *(height for height in weights if hold < height < high)})
        if high - low >= LEAST_SLENDERNESS * wall.thickness
    ]
    if not any(low < hinge <= high for low, high in pairs):
        return ()
    others = [load.h_m for load in wall.load if load.kind not in ("vertical", "tie")]
    return () if any(height < ties[-1] for height in others) else tuple(pairs)


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
        name=f"{wall.title} ({low:.4g}–{high:.4g} m)",
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
        restraint_note=f"tie at {high:.4g} m",
    )
