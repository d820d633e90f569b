"""What a wall that turns hands to its ties and to what stands behind it, as results."""

import math

from core.codes.dynamic_check import DynamicCheck
from core.codes.kinematic import KinematicAnalysis
from core.mechanism.sections import Sections
from core.mechanism.turning_reactions import force_behind, impulse_behind, largest_forces, speed_before, tie_forces
from core.rocking.history import integrate_history
from core.setting.check_input import CheckInput
from core.units import G
from core.variation.hold_check import BY_CLAUSES, BY_HISTORIES, Reaction, find_motion_push
from core.wall.bars import TieBar

TIED, BEHIND = "tie", "behind"
"""Holds of a wall that turns."""


def reactions_of_turning(
    scene: CheckInput, kinematic: KinematicAnalysis, dynamic: DynamicCheck | None, zeta: float | None
) -> tuple[Reaction, ...]:
    """What a wall that turns hands to its ties, and at rest and as it comes back to what stands behind it; none of a
    wall without a unit weight, nor of a corner. zeta : of the check that decides"""
    wall, behind = scene.wall.in_si, _height_behind(scene)
    weighs = wall.unit_weight is not None and wall.height is not None and wall.thickness is not None
    if not weighs or scene.wall.corner is not None:
        return ()
    rows, sections, bars = [], Sections(wall), tuple(tie.bar for tie in wall.ties)
    if kinematic.acceleration_demand is not None:
        alpha = kinematic.acceleration_demand / G
        at_end = None if zeta is None or not math.isfinite(zeta) else zeta * alpha
        at_zeta = [None] * len(bars) if at_end is None else tie_forces(sections, wall.ties, at_end)
        for bar, first, last in zip(bars, tie_forces(sections, wall.ties, alpha), at_zeta, strict=True):
            rows.append(Reaction(TIED, "outward", BY_CLAUSES, first, last, bar.strength, None, None))
        if behind is not None:
            pressed = None if at_end is None else force_behind(sections, behind, at_end)
            first = force_behind(sections, behind, alpha)
            rows.append(Reaction(BEHIND, "inward", BY_CLAUSES, first, pressed, None, None, None))
    if dynamic is not None and dynamic.holds and (bars or behind is not None):
        rows += _history_rows(scene, sections, bars, behind)
    return tuple(rows)


def _height_behind(scene: CheckInput) -> float | None:
    """Height up to which something stands behind a wall that turns one way [m]; None of another wall."""
    if not scene.kinematics.one_way:
        return None
    top = scene.wall.height_m
    heights = [hold.h_m or hold.to_m or top for hold in scene.wall.hold if hold.is_contact]
    return max((height for height in heights if height is not None), default=None)


def _history_rows(
    scene: CheckInput, sections: Sections, bars: tuple[TieBar, ...], behind: float | None
) -> list[Reaction]:
    """Rows of the ties and of what stands behind along the histories at the demand."""
    forces, speed, model = [0.0] * len(bars), 0.0, scene.model
    for motion in scene.motions:
        for sign in scene.signs:
            scale = sign * scene.demand.scaling(motion)
            history = integrate_history(motion.acceleration, motion.time_step, scale, model, scene.method)
            speed = max(speed, speed_before(history, model.ratio_at_rest))
            forces = list(map(max, forces, largest_forces(bars, history)))
    rows = [
        Reaction(TIED, "outward", BY_HISTORIES, force, None, bar.strength, None, None)
        for force, bar in zip(forces, bars, strict=True)
    ]
    if behind is not None:
        wall = scene.wall.in_si
        impulse = impulse_behind(wall.moment_of_weight / wall.block.p2, speed, model.ratio_at_rest, behind)
        pressed = force_behind(sections, behind, find_motion_push(scene.demand, scene))
        rows.append(Reaction(BEHIND, "inward", BY_HISTORIES, pressed, None, None, None, impulse))
    return rows
