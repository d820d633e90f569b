"""The part of a wall that spans between transverse walls (mechanism horizontal_bending), and what it needs."""

from dataclasses import replace

from core.case.hold import Hold
from core.case.loads import Load
from core.case.tie_rules import MAX_STRAIN
from core.case.wall import Wall
from core.codes.vertical_bending import bending
from core.errors import InputError, place
from core.known import require_value
from core.text.sentence import Key
from core.wall.bending import spread_over
from core.wall.kinematics import ARCHES

LEAST_COURSES = 0.5
"""Height of a band of courses that goes through from end to end, at least [m]."""

NOT_OF_AN_ARCH = ("restitution", "velocity_ratio", "hinge_heights", "return_walls")
"""Keys of walls that rock or turn about their base."""


def spans(wall: Wall) -> bool:
    """Whether a wall that may overturn is looked at between its transverse walls too."""
    return wall.arch is not None and not wall.kinematics.arches


def named_spanning(name: str, spacing: float) -> str:
    """What a wall between its transverse walls is called."""
    return f"{name} (L {spacing:.4g} m)"


def make_spanning_part(wall: Wall) -> Wall:
    """A wall between its transverse walls: a rectangle of its least thickness. What pushes it or presses it outward is
    spread over a metre of its height; weights that rest on it hold nothing there, and no tie across it is counted. With
    openings or a gable the courses that go through from end to end bear the weight of all."""
    assert wall.arch is not None
    thickness, load = least_thickness(wall), wall.load
    if wall.parts:
        courses, height = whole_courses(wall), require_value(wall.height_m)
        more = 1e-3 * wall.in_si.weight / courses - require_value(wall.unit_weight_kn_m3) * thickness
        own = Load("vertical", more * spread_over(height), 0.5 * height, d_m=0.5 * thickness, mass="horizontal")
        load += (own,) if more > 0.0 else ()
    return replace(
        wall,
        name=named_spanning(wall.title, require_value(wall.arch.spacing_m)),
        mechanism=ARCHES,
        thickness_m=thickness,
        slenderness_deg=None,
        height_over_thickness=None,
        restitution=None,
        velocity_ratio=None,
        law="auto",
        hinge_heights=None,
        load=tuple(load),
        return_walls=None,
        hold=(wall.arch,),
        unloaded_confirmed=wall.unloaded_confirmed and not wall.load,
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
    return min([require_value(wall.thickness), *(step.thickness_m for step in wall.steps)])


def whole_courses(wall: Wall) -> float:
    """Height of the courses that go through from end to end of a wall, between its openings and below its gable [m]:
    bands of LEAST_COURSES at least."""
    eaves, left, z = wall.shoulder, 0.0, 0.0
    spans = sorted(
        (min(z for _, z in opening.corners), max(z for _, z in opening.corners)) for opening in wall.openings
    )
    for low, high in [*spans, (eaves, eaves)]:
        band = min(low, eaves) - z
        left += band if band >= LEAST_COURSES else 0.0
        z = max(z, high)
    return left


def _check_along(given: Hold, inside) -> None:
    """Refuse ties along the wall that do not reach from end to end, or an elongation their bars cannot have."""
    length, stands = require_value(given.tie_bar_length_m), require_value(given.tie_elongation_m)
    if length < (spacing := require_value(given.spacing_m)):
        raise InputError("arch_bar", place=inside, key="tie_bar_length_m", found=length, least=spacing)
    if stands < given.at_yield:
        least = {"found": stands, "least": given.at_yield}
        raise InputError("tie_elongation_below_yield", place=inside, key="tie_elongation_m", **least)
    if stands > MAX_STRAIN * length:
        most = {"found": stands, "most": MAX_STRAIN * length, "share": MAX_STRAIN}
        raise InputError("tie_elongation_too_large", place=inside, key="tie_elongation_m", **most)


def check_arch(wall: Wall) -> None:
    """Raise InputError for a wall between transverse walls that is not complete, or has what does not go with it."""
    here = (place("wall", name=wall.name),)
    if (given := wall.arch) is None:
        if wall.kinematics.arches:
            raise InputError("arch_missing", place=here, key="spacing_m", arch=Key("[[wall.hold]]"))
        return
    inside = (*here, place("hold", n=1 + wall.hold.index(given)))
    if not (wall.leans or wall.kinematics.arches):
        raise InputError("arch_mechanism", place=inside, found=wall.mechanism)
    for key, size in (("height_m", wall.height_m), ("thickness_m", wall.thickness)):
        if size is None:
            raise InputError("arch_needs", place=here, key=key, arch=Key("spacing_m"))
    if wall.solid or wall.corner or (wall.has_shape and wall.kinematics.arches):
        raise InputError("arch_rectangle", place=inside)
    if not whole_courses(wall):
        raise InputError("arch_openings", place=inside, least=LEAST_COURSES)
    tied = ("tie_kn_m", "tie_bar_length_m"), ("tie_kn_m", "tie_elongation_m")
    for key, other in (*tied, ("shoulder_length_m", "shoulder_thickness_m"), ("corner_side", "corner_wall")):
        if (getattr(given, key) in (None, "")) != (getattr(given, other) in (None, "")):
            raise InputError("arch_pair", place=inside, key=key, other=Key(other))
    if given.with_tie:
        _check_along(given, inside)
    if not given.with_tie and not given.with_shoulder:
        keys = {"tie": Key("tie_kn_m"), "shoulder": Key("shoulder_length_m")}
        raise InputError("arch_without_thrust", place=inside, key="tie_kn_m", **keys)
    if not wall.kinematics.arches:
        bending(make_spanning_part(wall).in_si)
        return
    for key in NOT_OF_AN_ARCH:
        if getattr(wall, key) is not None:
            raise InputError("arch_key", place=here, key=key)
    if wall.law not in ("auto", "rigid"):
        raise InputError("arch_key", place=here, key="law")
    keys = {"tie": Key("tie_kn_m"), "arch": Key("[[wall.hold]]")}
    if n := next((n for n, hold in enumerate(wall.hold, start=1) if hold.is_bar), None):
        raise InputError("arch_tie", place=(*here, place("hold", n=n)), key="kind", **keys)
    bending(wall.in_si)
