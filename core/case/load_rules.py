"""What is wrong with the loads of a wall: not complete, against each other, or more than it carries as one block."""

import math
from dataclasses import replace

from core.case.loads import Load
from core.case.wall import Wall
from core.errors import InputError, place
from core.known import require_value
from core.text.sentence import Key
from core.wall import ties
from core.wall.masonry import MAX_COLLAPSE, Masonry, is_stable, load_to_force
from core.wall.solids import faces_at
from core.wall.wall_loads import hinge_inside, largest_tie_share

COMBINED = "g_kn_m", "q_kn_m", "psi_2"
"""Keys of a weight given by its parts."""

OF_A_TIE = ("bar_length_m", "fy_mpa", "elongation_m", "elongation", "slack_mm", "prestress", "bar")
"""Keys of a load that only a tie has."""

MAX_STRAIN = 0.30
"""Largest elongation of a bar before it breaks, of its length."""

MAX_THREAD = 1.5
"""Largest thread at the ends of a bar, of its diameter: upset ends."""


def carries(wall: Wall) -> bool:
    """Whether a wall that turns outward stands under its loads and is one rigid block, see `check_loads`."""
    outward = replace(wall, mechanism="one_sided")
    try:
        _check_stands(outward)
    except InputError:
        return False
    return not _held_inward(outward.in_si) or hinge_inside(outward.in_si) is None


def check_given(wall: Wall) -> None:
    """Raise InputError for loads that are not complete, contradict each other or are not on the wall."""
    here = (place("wall", name=wall.title),)
    across, tie = wall.return_walls, wall.tie_height_m
    if not wall.load and across is None and tie is None:
        return
    if wall.height_m is None or wall.thickness is None or wall.unit_weight_kn_m3 is None:
        raise InputError("loads_need_weight", place=here)
    if across is not None:
        if wall.length_m is None:
            raise InputError("return_walls_need_length", place=here, key="length_m")
        if (total_thickness := across.number * across.thickness_m) > wall.length_m:
            raise InputError("return_walls_too_many", place=here, found=total_thickness, length=wall.length_m)
    for key, given in (("return_walls", across), ("tie_height_m", tie)):
        if given is not None and wall.mechanism == "two_sided":
            raise InputError("holds_one_side", place=here, key=key)
    if tie is not None and tie > wall.height_m:
        raise InputError("load_outside", place=here, key="tie_height_m", found=tie, most=wall.height_m)
    if not wall.load:
        return
    if wall.unloaded_confirmed:
        raise InputError("loads_contradict", place=here, key="unloaded_confirmed")
    for number, load in enumerate(wall.load, start=1):
        _check_load(wall, load, (*here, place("load", n=number)))


def check_design(wall: Wall) -> None:
    """Raise InputError for a tie to be designed of which something else is missing, or that cannot be. Of the wall of a
    case: a hinge above that tie leaves what is said of its bar as it is."""
    here = (place("wall", name=wall.title),)
    for key, needed in (
        ("tie_bar_length_m", "tie_height_m"),
        ("tie_spacing_m", "tie_height_m"),
        ("tie_elongation_m", "tie_bar_length_m"),
    ):
        if getattr(wall, key) is not None and getattr(wall, needed) is None:
            raise InputError("tie_design_needs", place=here, key=key, needed=Key(needed))
    if wall.tie_height_m is not None and not wall.moment_law().is_rigid:
        raise InputError("tie_needs_rigid_law", place=here, key="law")
    if wall.tie_elongation_m is not None:
        length = require_value(wall.tie_bar_length_m)
        _check_elongation(wall.tie_elongation_m, ties.elongation_at_yield(length), length, here, "tie_elongation_m")


def _check_elongation(stated: float, at_yield: float, length: float, here, key: str) -> None:
    """Refuse an elongation [m] a bar of this length [m] cannot have."""
    if stated < at_yield:
        raise InputError("tie_elongation_below_yield", place=here, key=key, found=stated, least=at_yield)
    if stated > MAX_STRAIN * length:
        raise InputError(
            "tie_elongation_too_large", place=here, key=key, found=stated, most=MAX_STRAIN * length, share=MAX_STRAIN
        )


def check_loads(wall: Wall, numbers: tuple[int, ...] = (), bends: bool = False) -> None:
    """Raise InputError for loads under which the wall does not stand, or is no one rigid block; of a wall that bends
    core/case/held_top.py says that. numbers : of its loads in the wall it is a part of; bends : it is also looked at as
    it bends between its ties, so that no tie is too strong"""
    _check_stands(wall)
    if wall.load and not wall.bends and not bends:
        _check_inward(wall, (place("wall", name=wall.name),), numbers or tuple(range(1, len(wall.load) + 1)))


def _check_stands(wall: Wall) -> None:
    """Raise InputError for loads under which the wall does not stand as one body about each of its hinges."""
    if wall.bends or (not wall.load and not wall.parts):
        return
    here, masonry = (place("wall", name=wall.name),), wall.in_si
    two_sided, unlike = masonry.is_two_sided, masonry.is_two_sided and masonry.inner_block is not None
    if two_sided and not masonry.is_centred and not unlike:
        raise InputError("moving_mass_off_centre", place=here)
    if unlike and masonry.ties:
        raise InputError("tie_on_unlike_sides", place=here)
    for block, side in masonry.sides if two_sided else masonry.sides[:1]:
        if not is_stable(block, side):
            threshold = side.sine * math.tan(block.slenderness) + side.cosine
            raise InputError("unstable_under_loads", place=here, threshold=threshold)
        if block.slenderness + side.lean > MAX_COLLAPSE:
            raise InputError(
                "collapse_too_far",
                place=here,
                found=math.degrees(block.slenderness + side.lean),
                most=math.degrees(MAX_COLLAPSE),
            )
    if two_sided and (masonry.restoring[0] != masonry.restoring[1] or unlike) and not masonry.law.is_rigid:
        raise InputError("two_sided_loads_rigid", place=here, key="law")


def _check_load(wall: Wall, load: Load, here) -> None:
    """Rules of one load."""
    if load.kind == "vertical" and load.mass is None:
        raise InputError("load_mass_missing", place=here, key="mass")
    _check_size(wall, load, here)
    fixed = "moving" if load.kind == "carried_mass" else "none" if not load.is_weight else load.mass
    if load.mass not in (None, fixed):
        raise InputError("load_mass_refused", place=here, key="mass", kind=load.kind)
    if load.is_weight and load.d_m is None:
        raise InputError("load_distance_missing", place=here, key="d_m")
    _check_on_body(wall, load, here)
    height, thickness = require_value(wall.height_m), require_value(wall.thickness)
    highest = 2.0 * height if load.kind == "carried_mass" else height
    # heights of loads above a hinge are differences
    if not 0.0 <= (load.d_m or 0.0) <= thickness * (1.0 + 1e-9):
        raise InputError("load_outside", place=here, key="d_m", found=load.d_m, most=thickness)
    if load.h_m > highest * (1.0 + 1e-9):
        raise InputError("load_outside", place=here, key="h_m", found=load.h_m, most=highest)


def _check_size(wall: Wall, load: Load, here) -> None:
    """Rules of the size of a load, and of what a tie is."""
    if (key := next((key for key in COMBINED if getattr(load, key) is not None), None)) is not None:
        if not load.is_weight:
            raise InputError("combined_weight", place=here, key=key, kind=load.kind)
        if (load.q_kn_m is None) != (load.psi_2 is None):
            raise InputError("combined_share", place=here)
        if load.kn_m is not None and abs(load.kn_m - (stated := require_value(load.combined))) > 5e-4 + 1e-6 * stated:
            raise InputError("combined_sum", place=here, found=load.kn_m, stated=stated)
    if not load.is_tie:
        if given := [key for key in OF_A_TIE if getattr(load, key) not in (None, 0.0)]:
            raise InputError("key_of_a_tie", place=here, key=given[0], kind=load.kind)
        if load.kn_m is None:
            raise InputError("load_size_missing", place=here, key="kn_m")
        if load.kn_m == 0.0 or (load.kn_m < 0.0 and load.kind != "thrust"):
            raise InputError("load_size", place=here, key="kn_m", found=load.kn_m, kind=load.kind)
        return
    _check_bar(wall, load, here)
    if load.slack_mm and load.prestress:
        raise InputError("tie_slack_and_prestress", place=here, key="prestress")
    if load.d_m:
        raise InputError("tie_at_outer_face", place=here, key="d_m", found=load.d_m)
    if not wall.moment_law().is_rigid:
        raise InputError("tie_needs_rigid_law", place=here, key="law")
    if load.prestress and "two_sided" in wall.mechanisms():
        raise InputError("prestress_one_sided", place=here, key="prestress")
    if (stated := load.stated_elongation) is not None:
        key = "elongation" if load.elongation_m is None else "elongation_m"
        at_yield = load.tie(wall.length_m).bar.elongation_at_yield
        _check_elongation(stated, at_yield, require_value(load.bar_length_m), here, key)


def _check_bar(wall: Wall, load: Load, here) -> None:
    """Rules of the bars of a tie."""
    if load.bar_length_m is None:
        raise InputError("tie_needs_length", place=here, key="bar_length_m")
    if (load.kn_m is None) == (load.bar is None):
        raise InputError("tie_size_or_bar", place=here, key="kn_m")
    if load.kn_m is not None and load.kn_m <= 0.0:
        raise InputError("load_size", place=here, key="kn_m", found=load.kn_m, kind=load.kind)
    if load.bar is not None and (load.fy_mpa is not None or load.elongation_m is not None):
        raise InputError("tie_bar_says", place=here, key="fy_mpa" if load.fy_mpa is not None else "elongation_m")
    if load.bar is not None and wall.length_m is None:
        raise InputError("tie_bar_needs_length", place=here, key="length_m")
    if load.bar is not None and load.bar.existing and None in (load.bar.fy_mpa, load.bar.fu_mpa):
        raise InputError("tie_existing_steel", place=here, key="fy_mpa" if load.bar.fy_mpa is None else "fu_mpa")
    if load.bar is not None and load.bar.tensile < load.bar.strength:
        raise InputError("tie_fu_below_fy", place=here, key="fu_mpa", found=load.bar.tensile, least=load.bar.strength)
    if load.bar is not None and (load.bar.thread_mm or 0.0) > (most := MAX_THREAD * load.bar.diameter_mm):
        raise InputError("tie_thread_too_large", place=here, key="thread_mm", found=load.bar.thread_mm, most=most)
    if load.elongation_m is not None and load.elongation is not None:
        raise InputError("tie_two_elongations", place=here, key="elongation")


def _check_on_body(wall: Wall, load: Load, here) -> None:
    """Raise InputError for a weight off the wall: it rests on what is there at its height."""
    if not (load.is_weight and load.d_m is not None and wall.has_shape):
        return
    faces = faces_at(wall.parts, min(load.h_m, require_value(wall.top)) * (1.0 - 1e-6))
    if faces and not faces[0] - 1e-6 <= load.d_m <= faces[1] + 1e-6:
        raise InputError("load_off_body", place=here, key="d_m", found=load.d_m, low=faces[0], high=faces[1])


def _forces_inward(wall: Masonry) -> list[float]:
    """Horizontal forces of the loads of a wall, inward, of ties at yield [N/m]."""
    return [load_to_force(load, wall, 1.0, at_yield=True).horizontal for load in wall.loads]


def _held_inward(wall: Masonry) -> float:
    """Sum of those that hold it [N/m]."""
    return sum(force for force in _forces_inward(wall) if force > 0.0)


def _check_inward(wall: Wall, here, numbers: tuple[int, ...]) -> None:
    """Raise InputError for ties, or other forces inward, under which the wall opens a hinge above its base.
    numbers : of the loads, the strongest of which is named"""
    masonry = wall.in_si
    forces, held = _forces_inward(masonry), _held_inward(masonry)
    if not held or (hinge := hinge_inside(masonry)) is None:
        return
    k = forces.index(max(forces))
    raise InputError(
        "tie_too_strong",
        place=(*here, place("load", n=numbers[k])),
        key="kn_m" if wall.load[k].bar is None else "diameter_mm",
        found=1e-3 * held,
        hinge=hinge,
        most=1e-3 * held * largest_tie_share(masonry),
    )
