"""What is wrong with the loads of a wall: not complete, against each other, or more than it carries as one block."""

import math
from dataclasses import replace

from core.case.held_stretches import stands_outward
from core.case.loads import Load
from core.case.wall import Wall
from core.errors import InputError, place
from core.known import require_value
from core.text.sentence import Key, Sentence
from core.wall.masonry import MAX_COLLAPSE, Masonry, is_stable, load_to_force
from core.wall.solids import faces_at
from core.wall.wall_loads import hinge_inside, largest_tie_share

COMBINED = "g_kn_m", "q_kn_m", "psi_2"
"""Keys of a weight given by its parts."""


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
    here, across = (place("wall", name=wall.title),), wall.return_walls
    sized = wall.height_m is not None and wall.thickness is not None and wall.unit_weight_kn_m3 is not None
    if not sized and (wall.load or across or any(hold.is_bar for hold in wall.hold)):
        raise InputError("loads_need_weight", place=here)
    if across is not None:
        if wall.length_m is None:
            raise InputError("return_walls_need_length", place=here, key="length_m")
        if (total_thickness := across.number * across.thickness_m) > wall.length_m:
            raise InputError("return_walls_too_many", place=here, found=total_thickness, length=wall.length_m)
        if wall.kinematics.both_ways:
            raise InputError("holds_one_side", place=here, key="return_walls")
    if wall.load and wall.unloaded_confirmed:
        raise InputError("loads_contradict", place=here, key="unloaded_confirmed")
    for number, load in enumerate(wall.load, start=1):
        _check_load(wall, load, (*here, place("load", n=number)))


def check_loads(wall: Wall, places: tuple[Sentence, ...] = (), bends: bool = False) -> None:
    """Raise InputError for loads under which the wall does not stand, or is no one rigid block; of a wall that bends
    core/case/held_top.py says that. places : in the case of its loads and ties; bends : it is also looked at as it
    bends between its ties, so that no tie is too strong"""
    _check_stands(wall)
    if (wall.load or wall.ties) and not wall.bends and not bends:
        _check_inward(wall, places or places_of_forces(wall))


def places_of_forces(wall: Wall, hinge: float = 0.0) -> tuple[Sentence, ...]:
    """Places in the case of the loads and of the ties of a wall above a hinge [m above its base], in the order of
    `Masonry.loads`."""
    holds = enumerate(wall.hold, start=1)
    ties = (place("hold", n=n) for n, hold in holds if hold.is_tie and require_value(hold.h_m) > hinge + 1e-9)
    loads = (place("load", n=n) for n, load in enumerate(wall.load, start=1) if load.h_m > hinge + 1e-9)
    return (*loads, *ties)


def _check_stands(wall: Wall) -> None:
    """Raise InputError for loads under which the wall does not stand as one body about each of its hinges."""
    if wall.bends or not (wall.load or wall.ties or wall.parts):
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
            thrusts = any(load.is_thrust for load in wall.load) and any(stands_outward(hold) for hold in wall.hold)
            if thrusts:
                raise InputError("thrust_on_hold", place=here, threshold=threshold, strength=Key("out_kn_m"))
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
    if load.rests and load.mass is None:
        raise InputError("load_mass_missing", place=here, key="mass")
    _check_size(load, here)
    fixed = "moving" if load.is_carried else "none" if not load.is_weight else load.mass
    if load.mass not in (None, fixed):
        raise InputError("load_mass_refused", place=here, key="mass", kind=load.kind)
    if load.is_weight and load.d_m is None:
        raise InputError("load_distance_missing", place=here, key="d_m")
    _check_on_body(wall, load, here)
    height, thickness = require_value(wall.height_m), require_value(wall.thickness)
    highest = 2.0 * height if load.is_carried else height
    # heights of loads above a hinge are differences
    if not 0.0 <= (load.d_m or 0.0) <= thickness * (1.0 + 1e-9):
        raise InputError("load_outside", place=here, key="d_m", found=load.d_m, most=thickness)
    if load.h_m > highest * (1.0 + 1e-9):
        raise InputError("load_outside", place=here, key="h_m", found=load.h_m, most=highest)


def _check_size(load: Load, here) -> None:
    """Rules of the size of a load."""
    if (key := next((key for key in COMBINED if getattr(load, key) is not None), None)) is not None:
        if not load.is_weight:
            raise InputError("combined_weight", place=here, key=key, kind=load.kind)
        if (load.q_kn_m is None) != (load.psi_2 is None):
            raise InputError("combined_share", place=here)
        if load.kn_m is not None and abs(load.kn_m - (stated := require_value(load.combined))) > 5e-4 + 1e-6 * stated:
            raise InputError("combined_sum", place=here, found=load.kn_m, stated=stated)
    if load.kn_m is None:
        raise InputError("load_size_missing", place=here, key="kn_m")
    if load.kn_m == 0.0 or (load.kn_m < 0.0 and not load.is_thrust):
        raise InputError("load_size", place=here, key="kn_m", found=load.kn_m, kind=load.kind)


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


def _check_inward(wall: Wall, places: tuple[Sentence, ...]) -> None:
    """Raise InputError for ties, or other forces inward, under which the wall opens a hinge above its base.
    places : of its loads and ties, the strongest of which is named"""
    masonry = wall.in_si
    forces, held = _forces_inward(masonry), _held_inward(masonry)
    if not held or (hinge := hinge_inside(masonry)) is None:
        return
    k = forces.index(max(forces))
    tie = wall.ties[k - len(wall.load)] if k >= len(wall.load) else None
    raise InputError(
        "tie_too_strong",
        place=(place("wall", name=wall.name), places[k]),
        key="kn_m" if tie is None else "out_kn_m" if tie.bar is None else "diameter_mm",
        found=1e-3 * held,
        hinge=hinge,
        most=1e-3 * held * largest_tie_share(masonry),
    )
