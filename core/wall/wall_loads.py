"""Moments of the loads of a wall about its hinge, and the hinge that they open inside it."""

from dataclasses import replace

from core.boundary import narrowed
from core.units import G
from core.wall.loads import RestoringMoment, restoring_moment
from core.wall.masonry import Masonry, inner_of, load_to_force

SECTIONS_TRIED = 400
"""Sections of a wall between which a hinge inside it is looked for."""


def without_ties(wall: Masonry) -> Masonry:
    """The wall with its other loads alone."""
    return replace(wall, loads=tuple(load for load in wall.loads if load.tie is None))


def restoring_with_ties(wall: Masonry) -> RestoringMoment:
    """a and c of a wall that turns outward, were each of its ties a force of its yield strength up to collapse."""
    forces = [load_to_force(load, wall, 1.0, at_yield=True) for load in wall.loads if not load.pushes]
    return restoring_moment(wall.block, wall.moving_weight, forces)


def start_multiplier(weight: float, x: float, y: float, forces, pushed) -> float:
    """alpha_0 of one block: the moments that hold it over those of its masses [-] (C8.7.1.1).

    weight : of the wall [N/m]; x, y : of its centroid, inward from the hinge and above it [m]
    forces : all Forces on it; pushed : PointMasses that move with it or push it
    """
    holding = weight * x + sum(f.vertical * f.distance + f.horizontal * f.height for f in forces)
    return holding / (weight * y + sum(mass.mass * G * mass.height for mass in pushed))


def start_moments(wall: Masonry, side: float) -> tuple[float, float, float, float, float, float]:
    """W x, sum N d, sum F h, sum T h of the ties as `load_to_force` counts them, W y, sum Q h [N]: what alpha_0 of a
    wall with loads is made of (C8.7.1.1).

    side : 1.0 about the outer hinge, -1.0 about the inner one
    """
    bare = wall.bare
    if side < 0.0:
        bare = inner_of(wall, bare) or bare
    weight, (x, y) = wall.weight, bare.centroid
    forces = [load_to_force(load, wall, side) for load in wall.loads if load.tie is None]
    held = [load_to_force(load, wall, side) for load in wall.loads if load.tie is not None]
    return (
        weight * x,
        sum(force.vertical * force.distance for force in forces),
        sum(force.horizontal * force.height for force in forces),
        sum(force.horizontal * force.height for force in held),
        weight * y,
        sum(mass.mass * G * mass.height for mass in wall.masses),
    )


def hinge_inside(wall: Masonry, share: float = 1.0) -> float | None:
    """Height [m] at which a wall with ties opens a hinge before it turns about its base; None where it does not.

    At the acceleration that uplifts the wall the resultant of each section must stay inside it, by u = 2 N / (3 f)
    where the compressive strength f is given. share : of the force of the ties at yield
    """
    forces = [load_to_force(load, wall, 1.0, at_yield=True) for load in wall.loads]
    forces = [
        replace(force, horizontal=share * force.horizontal) if force.horizontal > 0.0 else force for force in forces
    ]
    weight, (x, y), pushed = wall.weight, wall.bare.centroid, wall.masses
    push = start_multiplier(weight, x, y, forces, pushed)
    for section in wall.sections(SECTIONS_TRIED):
        middle, y = section.middle - wall.setback, section.height
        above = [force for force in forces if force.height > y]
        pressed = section.weight + sum(force.vertical for force in above)
        outward = push * section.weight * section.lever - section.weight * (section.x - section.middle)
        outward += sum(push * m.mass * G * (m.height - y) for m in pushed if m.height > y)
        outward -= sum(f.vertical * (f.distance - middle) + f.horizontal * (f.height - y) for f in above)
        crushed = 0.0
        if wall.strength is not None:
            crushed = 2.0 * pressed / (3.0 * wall.strength)
        if abs(outward) > pressed * (0.5 * section.thickness - crushed) * (1.0 + 1e-9):
            return float(y)
    return None


def largest_tie_share(wall: Masonry) -> float:
    """Share of the force of its ties up to which a wall turns about its base, see `hinge_inside`."""
    return narrowed(lambda share: hinge_inside(wall, share) is None, 0.0, 1.0, steps=40).good
