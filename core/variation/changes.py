"""A wall of a case with one of its inputs changed, and what follows that input changed with it."""

from dataclasses import replace
from typing import Any

from core.case.wall import Wall

WITHOUT_PARTS: dict[str, Any] = {"g_kn_m": None, "q_kn_m": None, "psi_2": None}
"""A weight that is moved is no longer the sum of its parts."""


def rescale_thickness(wall: Wall, thickness: float) -> Wall:
    """A wall of another thickness [m]; its loads keep their share of it, and so do its steps and what is drawn in its
    elevation. Of another solid nothing says how it grows: not for a wall that has one."""
    assert wall.thickness is not None
    share = thickness / wall.thickness
    steps = tuple(replace(step, thickness_m=share * step.thickness_m) for step in wall.steps)
    loads = tuple(load if load.d_m is None else replace(load, d_m=share * load.d_m) for load in wall.load)
    solids = tuple(
        replace(solid, from_m=share * solid.from_m, to_m=share * solid.to_m, x0_m=share * solid.x0_m)
        for solid in wall.solid
    )
    wall = replace(wall, slenderness_deg=None, height_over_thickness=None)
    return replace(wall, thickness_m=thickness, load=loads, steps=steps, solid=solids)


def has_own_thickness(wall: Wall) -> bool:
    """Whether another thickness of a wall says what it is then: all that is drawn of it is an elevation."""
    return wall.thickness is not None and all(solid.plane == "elevation" for solid in wall.solid)


def scale_loads(wall: Wall, factor: float) -> Wall:
    """A wall whose loads are so many times as large."""
    loads = (
        load if load.kn_m is None else replace(load, kn_m=factor * load.kn_m, **WITHOUT_PARTS) for load in wall.load
    )
    return replace(wall, load=tuple(loads))


def scale_theory_ratio(wall: Wall, factor: float) -> Wall:
    """A wall whose velocity ratio is that of Eq. 4 or 6 times a factor, at most 1; of a wall that is not symmetric, or
    that rocks by both mechanisms, the larger one."""
    by_theory = replace(wall, restitution=None, velocity_ratio=None)
    ratios = []
    for mechanism in wall.mechanisms():
        theory = by_theory.restitution_of(mechanism)
        ratios += [theory.ratio_at_rest, theory.ratio_inward or 0.0]
    return replace(by_theory, velocity_ratio=min(1.0, factor * max(ratios)))


def replace_setback(wall: Wall, setback: float) -> Wall:
    """The wall with another hinge setback [m]; where a strength gives the setback, with the strength that gives this
    one, so that it follows the weight above each hinge."""
    if wall.compressive_strength_mpa is None:
        return replace(wall, hinge_setback_m=setback)
    return replace(wall, compressive_strength_mpa=wall.compressive_strength_mpa * wall.setback / setback)
