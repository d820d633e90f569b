"""The loads of a wall as forces, masses and moments about its hinge, per metre of wall; and what it cannot carry.

A tie is no part of a, c and theta_c; what alpha_0 counts of it (C8.7.1.1) says `as_force`.
"""

import math
from dataclasses import replace

from core.boundary import narrowed
from core.errors import InputError, place
from core.text.sentence import Key
from core.units import G
from core.wall import ties, wall_body
from core.wall.block import Block
from core.wall.loads import BARE, Force, PointMass, RestoringMoment, composite, restoring_moment
from core.wall.restitution import Contact
from core.wall.wall_body import weight_per_metre

MOST_COLLAPSE = math.radians(60.0)
"""Largest collapse rotation: beyond it a wall is no wall that overturns."""

CENTRED = 1e-6
"""Distance from the middle of the wall up to which moving masses are centred [of t]."""

ALIKE = 1e-9
"""What a and c of both sides may differ by and still be the same [-]."""

COMBINED = "g_kn_m", "q_kn_m", "psi_2"
"""Keys of a weight given by its parts."""

OF_A_TIE = ("bar_length_m", "fy_mpa", "elongation_m", "elongation", "slack_mm", "prestress", "bar")
"""Keys of a load that only a tie has."""

MOST_STRAIN = 0.30
"""Largest elongation of a bar before it breaks, of its length."""

MOST_THREAD = 1.5
"""Largest thread at the ends of a bar, of its diameter: upset ends."""

COUNTED = 0.40
"""Share of theta_c up to which alpha_0 counts what the ties hold: that of d_SLV (C8.7.1.2.1.6)."""

SECTIONS = 400
"""Sections of a wall between which a hinge inside it is looked for."""


def vertical_loads(wall) -> float:
    """Sum of the vertical loads [N/m]. Raises InputError where one has no size yet."""
    for n, load in enumerate(wall.load, start=1):
        if load.is_weight and load.kn_m in (None, ""):
            raise InputError(
                "load_size_missing", place=(place("wall", name=wall.title), place("load", n=n)), key="kn_m"
            )
    return sum(1e3 * load.kn_m for load in wall.load if load.is_weight)


def size_of(load, wall) -> float:
    """Size of a load [N/m], of a tie its force at yield."""
    return ties.tie_of(load, wall).bar.strength if load.is_tie else 1e3 * load.kn_m


def held_at(wall) -> float:
    """Rotation up to COUNTED of theta_c at which the ties of a wall, slack ones apart, hold the largest moment [rad]:
    their forces count where they act together."""
    bars, block = ties.counted(wall), wall.block()
    most = COUNTED * (block.slenderness + restoring_of(wall, block)[0].lean)
    ends = [math.asin(end / bar.height) for bar in bars for end in bar.ends if end < bar.height * math.sin(most)]
    return max((most, *ends), key=lambda theta: sum(bar.height * bar.force_at(theta) for bar in bars))


def as_force(load, wall, side: float, at_yield: bool = False) -> Force:
    """A load about the hinge of this side, 1.0 the outer one [N/m, m]; its weight too where its mass moves. Of a tie
    what alpha_0 counts (C8.7.1.1): nothing of a slack one, else its force at `held_at`; none on a wall that turns
    inward. at_yield : of a tie its force at yield, slack or not"""
    depth = load.d_m or 0.0
    inward = depth if side > 0.0 else wall.thickness - depth
    size, push = size_of(load, wall), 0.0
    if load.kind == "thrust":
        push = -size * side
    elif load.is_tie and side > 0.0 and at_yield:
        push = size
    elif load.is_tie and side > 0.0 and not load.slack_mm:
        push = ties.tie_of(load, wall).bar.force_at(held_at(wall))
    return Force(size if load.is_weight else 0.0, push, inward - wall.setback, load.h_m)


def without_ties(wall):
    """The wall with its other loads alone."""
    return replace(wall, load=tuple(load for load in wall.load if not load.is_tie))


def masses(wall) -> list[PointMass]:
    """Q over g: the masses that move with the wall or push it [kg/m], about its outer hinge."""
    return [PointMass(1e3 * load.kn_m / G, load.d_m - wall.setback, load.h_m) for load in wall.load if load.pushes]


def moving_block(wall, bare: Block) -> Block:
    """The wall and the masses that move with it as one block. bare : the wall alone."""
    if not any(load.pushes for load in wall.load):
        return bare
    return composite(bare, weight_per_metre(wall) / G, masses(wall))


def contact_of(wall) -> Contact | None:
    """Where a body, or a wall with masses that move with it, meets its base and, at height_m, its restraint; None of a
    rectangle alone, which is symmetric."""
    if wall_body.body_of(wall) is None and not any(load.pushes for load in wall.load):
        return None
    return Contact(wall.thickness - 2.0 * wall.setback, wall.height_m)


def restoring_of(wall, block: Block) -> tuple[RestoringMoment, RestoringMoment]:
    """a and c of a wall for outward and for inward rotations. block : of `moving_block`, which holds the weight of
    the masses that move."""
    held = [load for load in wall.load if not load.pushes and not load.is_tie]
    if not held:
        return BARE, BARE
    weight = weight_per_metre(wall) + sum(1e3 * load.kn_m for load in wall.load if load.pushes)
    outward, inward = (
        restoring_moment(about, weight, [as_force(load, wall, side) for load in held])
        for about, side in ((block, 1.0), (inner_of(wall, block) or block, -1.0))
    )
    # alike but for rounding: alike
    same = max(abs(one - other) for one, other in zip(outward, inward, strict=True)) < ALIKE
    return outward, outward if same else inward


def restoring_with_ties(wall, block: Block) -> RestoringMoment:
    """a and c of a wall that turns outward, were each of its ties a force of its yield strength up to collapse."""
    weight = weight_per_metre(wall) + sum(1e3 * load.kn_m for load in wall.load if load.pushes)
    forces = [as_force(load, wall, 1.0, at_yield=True) for load in wall.load if not load.pushes]
    return restoring_moment(block, weight, forces)


def inner_of(wall, block: Block) -> Block | None:
    """A block about the inner hinge of a wall; None where it is the same, or leans beyond that hinge. block : about the
    outer one, of the wall alone or with what moves with it"""
    if wall.thickness is None or is_centred(wall, block):
        return None
    (x, z), width = block.centroid, wall.thickness - 2.0 * wall.setback
    if x >= width:
        return None
    own = block.inertia_over_mass - block.radius**2
    radius = math.hypot(width - x, z)
    return Block(math.atan2(width - x, z), radius, own + radius * radius)


def is_centred(wall, block: Block) -> bool:
    """Whether what moves is symmetric, so that the wall is one block for both its hinges."""
    middle = 0.5 * wall.thickness - wall.setback
    return abs(block.centroid[0] - middle) <= CENTRED * wall.thickness


def is_stable(block: Block, side: RestoringMoment) -> bool:
    """Whether the wall stands at rest under its own loads on this side."""
    return side.sine > 0.0 and side.sine * math.tan(block.slenderness) + side.cosine > 0.0


def rocks_both_ways(wall) -> bool:
    """Whether a one-sided wall without its restraint is a two-sided one of this model: stable to both sides, and rigid
    where its loads or its shape make them differ."""
    if not wall.load and wall_body.body_of(wall) is None:
        return True
    block = wall.block()
    outward, inward = restoring_of(wall, block)
    rigid, tied = wall.moment_law().is_rigid, any(load.is_tie for load in wall.load)
    if is_centred(wall, block):
        return ((outward == inward and not tied) or rigid) and is_stable(block, inward)
    about = inner_of(wall, block)
    return about is not None and rigid and not tied and is_stable(about, inward)


def sides_are_alike(wall) -> bool:
    """Whether a wall turns the same way about both its hinges: nothing makes them differ."""
    block = wall.block()
    outward, inward = restoring_of(wall, block)
    return outward == inward and inner_of(wall, block) is None


def carries(wall) -> bool:
    """Whether a wall that turns outward stands under its loads and is one rigid block, see `check_loads`."""
    try:
        check_loads(replace(wall, mechanism="one_sided"))
    except InputError:
        return False
    return True


def check_given(wall) -> None:
    """Raise InputError for loads that are not complete, contradict each other or are not on the wall."""
    here = (place("wall", name=wall.title),)
    across, tie = wall.return_walls, wall.tie_height_m
    if not wall.load and across is None and tie is None:
        return
    if wall.height_m is None or wall.thickness is None or wall.unit_weight_kn_m3 is None:
        raise InputError("loads_need_weight", place=here)
    if across is not None and wall.length_m is None:
        raise InputError("return_walls_need_length", place=here, key="length_m")
    if across is not None and across.number * across.thickness_m > wall.length_m:
        raise InputError(
            "return_walls_too_many", place=here, found=across.number * across.thickness_m, length=wall.length_m
        )
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


def check_design(wall) -> None:
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
    length, stated = wall.tie_bar_length_m, wall.tie_elongation_m
    if stated is not None:
        _check_elongation(stated, ties.elongation_at_yield(length), length, here, "tie_elongation_m")


def _check_elongation(stated: float, at_yield: float, length: float, here, key: str) -> None:
    """Refuse an elongation [m] a bar of this length [m] cannot have."""
    if stated < at_yield:
        raise InputError("tie_elongation_below_yield", place=here, key=key, found=stated, least=at_yield)
    if stated > MOST_STRAIN * length:
        raise InputError(
            "tie_elongation_too_large", place=here, key=key, found=stated, most=MOST_STRAIN * length, share=MOST_STRAIN
        )


def check_loads(wall, numbers: tuple[int, ...] = ()) -> None:
    """Raise InputError for loads under which the wall does not stand, or is no one rigid block; of a wall that bends
    core/case/held_top.py says that. numbers : of its loads in the wall it is a part of"""
    if wall.bends or (not wall.load and wall_body.body_of(wall) is None):
        return
    here = (place("wall", name=wall.name),)
    block = wall.block()
    outward, inward = restoring_of(wall, block)
    two_sided = "two_sided" in wall.mechanisms()
    about = inner_of(wall, block) or block
    unlike = two_sided and about is not block
    if two_sided and not is_centred(wall, block) and not unlike:
        raise InputError("moving_mass_off_centre", place=here)
    if unlike and any(load.is_tie for load in wall.load):
        raise InputError("tie_on_unlike_sides", place=here)
    for hinge, side in ((block, outward), (about, inward)) if two_sided else ((block, outward),):
        if not is_stable(hinge, side):
            threshold = side.sine * math.tan(hinge.slenderness) + side.cosine
            raise InputError("unstable_under_loads", place=here, threshold=threshold)
        if hinge.slenderness + side.lean > MOST_COLLAPSE:
            raise InputError(
                "collapse_too_far",
                place=here,
                found=math.degrees(hinge.slenderness + side.lean),
                most=math.degrees(MOST_COLLAPSE),
            )
    if two_sided and (outward != inward or unlike) and not wall.moment_law().is_rigid:
        raise InputError("two_sided_loads_rigid", place=here, key="law")
    if not wall.load:
        return
    _check_inward(wall, here, numbers or tuple(range(1, len(wall.load) + 1)))


def _check_load(wall, load, here) -> None:
    """Rules of one load."""
    if load.kind == "vertical" and load.mass is None:
        raise InputError("load_mass_missing", place=here, key="mass")
    _check_size(wall, load, here)
    fixed = "moving" if load.kind == "carried_mass" else "none" if not load.is_weight else load.mass
    if load.mass not in (None, fixed):
        raise InputError("load_mass_refused", place=here, key="mass", kind=load.kind)
    if load.is_weight and load.d_m is None:
        raise InputError("load_distance_missing", place=here, key="d_m")
    wall_body.check_on_body(wall, load, here)
    highest = 2.0 * wall.height_m if load.kind == "carried_mass" else wall.height_m
    # heights of loads above a hinge are differences
    if not 0.0 <= (load.d_m or 0.0) <= wall.thickness * (1.0 + 1e-9):
        raise InputError("load_outside", place=here, key="d_m", found=load.d_m, most=wall.thickness)
    if load.h_m > highest * (1.0 + 1e-9):
        raise InputError("load_outside", place=here, key="h_m", found=load.h_m, most=highest)


def _check_size(wall, load, here) -> None:
    """Rules of the size of a load, and of what a tie is."""
    if (key := next((key for key in COMBINED if getattr(load, key) is not None), None)) is not None:
        if not load.is_weight:
            raise InputError("combined_weight", place=here, key=key, kind=load.kind)
        if (load.q_kn_m is None) != (load.psi_2 is None):
            raise InputError("combined_share", place=here)
        if load.kn_m is not None and abs(load.kn_m - load.combined) > 5e-4 + 1e-6 * load.combined:
            raise InputError("combined_sum", place=here, found=load.kn_m, stated=load.combined)
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
    if (stated := ties.stated_elongation(load)) is not None:
        key = "elongation" if load.elongation_m is None else "elongation_m"
        at_yield = ties.tie_of(load, wall).bar.elongation_at_yield
        _check_elongation(stated, at_yield, load.bar_length_m, here, key)


def _check_bar(wall, load, here) -> None:
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
    if load.bar is not None and (load.bar.thread_mm or 0.0) > (most := MOST_THREAD * load.bar.diameter_mm):
        raise InputError("tie_thread_too_large", place=here, key="thread_mm", found=load.bar.thread_mm, most=most)
    if load.elongation_m is not None and load.elongation is not None:
        raise InputError("tie_two_elongations", place=here, key="elongation")


def start_multiplier(weight: float, x: float, y: float, forces, pushed) -> float:
    """alpha_0 of one block: the moments that hold it over those of its masses [-] (C8.7.1.1).

    weight : of the wall [N/m]; x, y : of its centroid, inward from the hinge and above it [m]
    forces : all Forces on it; pushed : PointMasses that move with it or push it
    """
    holding = weight * x + sum(f.vertical * f.distance + f.horizontal * f.height for f in forces)
    return holding / (weight * y + sum(mass.mass * G * mass.height for mass in pushed))


def start_moments(wall, side: float) -> tuple[float, float, float, float, float, float]:
    """W x, sum N d, sum F h, sum T h of the ties as `as_force` counts them, W y, sum Q h [N]: what alpha_0 of a wall
    with loads is made of (C8.7.1.1).

    side : 1.0 about the outer hinge, -1.0 about the inner one
    """
    bare = wall.bare_block()
    if side < 0.0:
        bare = inner_of(wall, bare) or bare
    weight, (x, y) = weight_per_metre(wall), bare.centroid
    forces = [as_force(load, wall, side) for load in wall.load if not load.is_tie]
    held = [as_force(load, wall, side) for load in wall.load if load.is_tie]
    return (
        weight * x,
        sum(force.vertical * force.distance for force in forces),
        sum(force.horizontal * force.height for force in forces),
        sum(force.horizontal * force.height for force in held),
        weight * y,
        sum(mass.mass * G * mass.height for mass in masses(wall)),
    )


def hinge_inside(wall, share: float = 1.0) -> float | None:
    """Height [m] at which a wall with ties opens a hinge before it turns about its base; None where it does not.

    At the acceleration that uplifts the wall the resultant of each section must stay inside it, by u = 2 N / (3 f)
    where the compressive strength f is given. share : of the force of the ties at yield
    """
    forces = [as_force(load, wall, 1.0, at_yield=True) for load in wall.load]
    forces = [
        replace(force, horizontal=share * force.horizontal) if force.horizontal > 0.0 else force for force in forces
    ]
    weight, (x, y), pushed = weight_per_metre(wall), wall.bare_block().centroid, masses(wall)
    push = start_multiplier(weight, x, y, forces, pushed)
    for section in wall_body.sections(wall, SECTIONS):
        middle, y = section.middle - wall.setback, section.height
        above = [force for force in forces if force.height > y]
        pressed = section.weight + sum(force.vertical for force in above)
        outward = push * section.weight * section.lever - section.weight * (section.x - section.middle)
        outward += sum(push * m.mass * G * (m.height - y) for m in pushed if m.height > y)
        outward -= sum(f.vertical * (f.distance - middle) + f.horizontal * (f.height - y) for f in above)
        crushed = 0.0
        if wall.compressive_strength_mpa is not None:
            crushed = 2.0 * pressed / (3e6 * wall.compressive_strength_mpa)
        if abs(outward) > pressed * (0.5 * section.thickness - crushed) * (1.0 + 1e-9):
            return float(y)
    return None


def largest_tie_share(wall) -> float:
    """Share of the force of its ties up to which a wall turns about its base, see `hinge_inside`."""
    return narrowed(lambda share: hinge_inside(wall, share) is None, 0.0, 1.0, steps=40).good


def _check_inward(wall, here, numbers: tuple[int, ...]) -> None:
    """Raise InputError for ties, or other forces inward, under which the wall opens a hinge above its base.
    numbers : of the loads, the strongest of which is named"""
    forces = [as_force(load, wall, 1.0, at_yield=True).horizontal for load in wall.load]
    held = sum(force for force in forces if force > 0.0)
    if not held or (hinge := hinge_inside(wall)) is None:
        return
    k = forces.index(max(forces))
    raise InputError(
        "tie_too_strong",
        place=(*here, place("load", n=numbers[k])),
        key="kn_m" if wall.load[k].bar is None else "diameter_mm",
        found=1e-3 * held,
        hinge=hinge,
        most=1e-3 * held * largest_tie_share(wall),
    )
