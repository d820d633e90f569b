"""The part of a wall that spans between transverse walls (mechanism horizontal_bending), and what it needs."""

from dataclasses import replace

from core.case.loads import Load
from core.case.wall import ARCHES, Wall
from core.codes.vertical_bending import bending
from core.errors import InputError, place
from core.known import known
from core.text.sentence import Key

LEAST_COURSES = 0.5
"""Height of the courses that go through from end to end, at least [m]."""

NOT_OF_AN_ARCH = ("restitution", "velocity_ratio", "hinge_heights", "return_walls", "tie_height_m", "free_element")
"""Keys of walls that rock or turn about their base."""


def spans(wall: Wall) -> bool:
    """Whether a wall that may overturn is looked at between its transverse walls too."""
    return wall.arch is not None and wall.mechanism != ARCHES


def named_spanning(name: str, spacing: float) -> str:
    """What a wall between its transverse walls is called."""
    return f"{name} (L {spacing:.4g} m)"


def spanning(wall: Wall) -> Wall:
    """A wall between its transverse walls: a rectangle of its least thickness. What pushes it or presses it outward is
    spread over its height; weights that rest on it hold nothing there, and no tie across it is counted. With openings
    or a gable the courses that go through from end to end bear the weight of all."""
    assert wall.arch is not None
    height, thickness, load = whole_courses(wall), least_thickness(wall), [one for one in wall.load if _pushes(one)]
    if wall.parts:
        of_courses = 1e3 * known(wall.unit_weight_kn_m3) * thickness * height
        more = 1e-3 * (wall.in_si.weight - of_courses)
        depth = 0.5 * thickness
        load += [Load(kind="vertical", kn_m=more, d_m=depth, h_m=0.5 * height, mass="horizontal")] if more > 0.0 else []
    higher = known(wall.height_m) - height
    return replace(
        wall,
        name=named_spanning(wall.title, wall.arch.spacing_m),
        mechanism=ARCHES,
        height_m=height,
        thickness_m=thickness,
        slenderness_deg=None,
        height_over_thickness=None,
        base_z_m=None if wall.base_z_m is None else wall.base_z_m + higher,
        restitution=None,
        velocity_ratio=None,
        law="auto",
        hinge_heights=None,
        free_element=None,
        load=tuple(replace(one, h_m=min(one.h_m, height)) for one in load),
        return_walls=None,
        tie_height_m=None,
        tie_bar_length_m=None,
        tie_elongation_m=None,
        tie_spacing_m=None,
        back_restraint="cross_walls",
        restraint_evidence=wall.restraint_evidence if wall.back_restraint == "cross_walls" else None,
        restraint_kn_m=None,
        unloaded_confirmed=wall.unloaded_confirmed and not load,
        gable_m=None,
        out_of_plumb_m=None,
        return_wedges=None,
        corner=None,
        solid=(),
        openings=(),
        steps=(),
    )


def least_thickness(wall: Wall) -> float:
    """Thickness of the thinnest part of a wall [m]."""
    return min([known(wall.thickness), *(step.thickness_m for step in wall.steps)])


def whole_courses(wall: Wall) -> float:
    """Height of the courses that go through from end to end of a wall, between its openings and below its gable [m]."""
    eaves, left, z = wall.shoulder, 0.0, 0.0
    spans = sorted((min(z for _, z in one.corners), max(z for _, z in one.corners)) for one in wall.openings)
    for low, high in [*spans, (eaves, eaves)]:
        left += max(0.0, min(low, eaves) - z)
        z = max(z, high)
    return left


def _pushes(load: Load) -> bool:
    """Whether the mass of a load pushes the wall, or it presses the wall outward."""
    return load.pushes or (load.kind == "thrust" and (load.kn_m or 0.0) > 0.0)


def check_arch(wall: Wall) -> None:
    """Raise InputError for a wall between transverse walls that is not complete, or has what does not go with it."""
    here = (place("wall", name=wall.name),)
    if (given := wall.arch) is None:
        if wall.mechanism == ARCHES:
            raise InputError("arch_missing", place=here, key="arch", arch=Key("[wall.arch]"))
        return
    inside = (*here, place("arch"))
    if wall.mechanism not in ("one_sided", "both", ARCHES):
        raise InputError("arch_mechanism", place=inside, found=wall.mechanism)
    for key, size in (("height_m", wall.height_m), ("thickness_m", wall.thickness)):
        if size is None:
            raise InputError("arch_needs", place=here, key=key, arch=Key("[wall.arch]"))
    if wall.solid or wall.corner or (wall.has_shape and wall.mechanism == ARCHES):
        raise InputError("arch_rectangle", place=inside)
    if whole_courses(wall) < LEAST_COURSES:
        raise InputError("arch_openings", place=inside, least=LEAST_COURSES)
    for key, other in (("tie_kn_m", "tie_elongation_m"), ("shoulder_length_m", "shoulder_thickness_m")):
        if (getattr(given, key) is None) != (getattr(given, other) is None):
            raise InputError("arch_pair", place=inside, key=key, other=Key(other))
    if not given.with_tie and not given.with_shoulder:
        keys = {"tie": Key("tie_kn_m"), "shoulder": Key("shoulder_length_m")}
        raise InputError("arch_without_thrust", place=inside, key="tie_kn_m", **keys)
    if wall.mechanism != ARCHES:
        bending(spanning(wall).in_si)
        return
    for key in NOT_OF_AN_ARCH:
        if getattr(wall, key) is not None:
            raise InputError("arch_key", place=here, key=key)
    if wall.law not in ("auto", "rigid"):
        raise InputError("arch_key", place=here, key="law")
    said = {"tie": Key("tie_kn_m"), "arch": Key("[wall.arch]")}
    for n, load in enumerate(wall.load, start=1):
        if load.is_tie:
            raise InputError("arch_tie", place=(*here, place("load", n=n)), key="kind", **said)
    bending(wall.in_si)
