"""What a wall held at its top (mechanism vertical_bending) needs, and what it cannot have."""

from dataclasses import replace

from core.case.hold import ShareOfHold
from core.case.loads import Load
from core.case.solids import Solid
from core.case.wall import Wall
from core.codes.vertical_bending import bending
from core.errors import InputError, place
from core.known import require_value
from core.wall.bending import TOP_TOLERANCE

OF_HISTORIES = ("restitution", "velocity_ratio")
"""Keys of what it has not."""


def check_held_top(wall: Wall) -> None:
    """Raise InputError for a wall held at its top that is not complete, or has what does not go with it."""
    if not wall.kinematics.bends_up:
        return
    here = (place("wall", name=wall.name),)
    for key in ("solid", "return_wedges", "corner", "gable_m", "out_of_plumb_m"):
        if getattr(wall, key):
            raise InputError("bending_rectangle", place=here, key=key)
    for key in OF_HISTORIES:
        if getattr(wall, key) is not None:
            raise InputError("bending_no_histories", place=here, key=key)
    if wall.law not in ("auto", "rigid"):
        raise InputError("bending_no_histories", place=here, key="law")
    if wall.hinge_heights is not None:
        raise InputError("bending_finds_hinge", place=here, key="hinge_heights")
    if wall.return_walls is not None:
        raise InputError("bending_return_walls", place=here, key="return_walls")
    if n := next((n for n, hold in enumerate(wall.hold, start=1) if hold.is_bar), None):
        raise InputError("bending_tie", place=(*here, place("hold", n=n)), key="kind")
    for key, given in (("height_m", wall.height_m), ("unit_weight_kn_m3", wall.unit_weight_kn_m3)):
        if given is None:
            raise InputError("bending_needs", place=here, key=key)
    for n, load in enumerate(wall.load, start=1):
        on = (*here, place("load", n=n))
        if not load.rests:
            raise InputError("bending_load", place=on, key="kind")
        if load.h_m > require_value(wall.height_m) * (1.0 + TOP_TOLERANCE):
            raise InputError("bending_load_height", place=on, key="h_m", found=load.h_m, height=wall.height_m)
    check_bends(wall)


def check_bends(wall: Wall) -> None:
    """Raise InputError for a wall held at its top that is not stable as it bends, outward or inward."""
    for moving in (wall, mirror_inward(wall)):
        bending(moving.in_si)


def mirror_inward(wall: Wall) -> Wall:
    """The wall as it is for a motion inward: mirrored, its loads as far from the inner face as they are from the outer
    one; a step that keeps one face plumb keeps the other. An outward thrust, which would hold it, is left out, and a
    tie, which pulls at a wall that moves outward alone."""
    mirrored = {"outer": "inner", "inner": "outer", "middle": "middle"}
    across = require_value(wall.thickness)
    loads = tuple(_mirror_load(load, across) for load in wall.load if not load.pushes_outward)
    steps = tuple(replace(step, flush=mirrored[step.flush]) for step in wall.steps)
    return replace(
        wall,
        load=loads,
        hold=tuple(hold for hold in wall.hold if not (isinstance(hold, ShareOfHold) and hold.yielded)),
        steps=steps,
        solid=tuple(_mirrored(solid, require_value(wall.thickness)) for solid in wall.solid),
    )


def _mirror_load(load: Load, across: float) -> Load:
    """A load as it lies from the inner face: what pulls inward pushes there. across : thickness [m]"""
    if not load.is_thrust:
        return replace(load, d_m=across - require_value(load.d_m))
    return replace(load, d_m=across - (load.d_m or 0.0), kn_m=-require_value(load.kn_m))


def _mirrored(solid: Solid, thickness: float) -> Solid:
    """An elevation or a section of a wall of this thickness [m], as it lies from the inner face outward."""
    across = thickness - solid.x0_m
    if solid.plane == "elevation":
        return replace(solid, from_m=across - solid.to_m, to_m=across - solid.from_m, x0_m=0.0)
    return replace(solid, polygon_m=tuple((-s, z) for s, z in reversed(solid.polygon_m)), x0_m=across)


def move_top_loads(was: Wall, wall: Wall) -> Wall:
    """A wall whose height changed: what held it at its top as it was holds it at its top, and of a wall held there what
    stood on it stands on it."""
    if was.height_m is None or wall.height_m is None or was.height_m == wall.height_m:
        return wall
    near, top = TOP_TOLERANCE * was.height_m, was.height_m

    def moved(height: float | None) -> float | None:
        return wall.height_m if height is not None and abs(height - top) <= near else height

    holds = tuple(replace(hold, h_m=moved(hold.h_m), to_m=moved(hold.to_m)) for hold in wall.hold)
    loads = wall.load
    if wall.bends:
        loads = tuple(replace(load, h_m=require_value(moved(load.h_m))) for load in wall.load)
    return replace(wall, load=loads, hold=holds)
