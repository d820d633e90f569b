"""Loads of constant size and direction on a rocking wall (resources/docs/physics.md, section 17).

A force at a point of the wall adds to its restoring moment a sine and a cosine of alpha - theta, so that two numbers,
a and c, hold all of them exactly. A mass that moves with the wall makes it another block.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from core.wall.block import Block


class RestoringMoment(NamedTuple):
    """Restoring moment of the rigid law over m g R: sine sin(alpha - phi) + cosine cos(alpha - phi).

    sine, cosine : a, c; 1 and 0 without loads [-]
    amplitude : sqrt(a^2 + c^2): the moment is amplitude sin(theta_c - phi) [-]
    lean : theta_c - alpha [rad]
    """

    sine: float = 1.0
    cosine: float = 0.0
    amplitude: float = 1.0
    lean: float = 0.0


UNLOADED = RestoringMoment()
"""Restoring moment of a wall without loads."""


@dataclass(frozen=True)
class Force:
    """A force on the wall.

    vertical : downward positive [N]
    horizontal : inward, against the overturning, positive [N]
    distance, height : of its point, inward from the pivot and above it [m]
    """

    vertical: float
    horizontal: float
    distance: float
    height: float


@dataclass(frozen=True)
class PointMass:
    """A mass that moves with the wall: mass [kg]; distance, height : inward from the pivot and above it [m]."""

    mass: float
    distance: float
    height: float


def restoring_moment(block: Block, weight: float, forces: Sequence[Force]) -> RestoringMoment:
    """a and c of a block under these forces. weight : m g of the block [N]."""
    if not forces:
        return UNLOADED
    sine_alpha, cosine_alpha = math.sin(block.slenderness), math.cos(block.slenderness)
    scale = weight * block.radius
    sine, cosine = 1.0, 0.0
    for force in forces:
        # r cos(alpha_i - alpha) and r sin(alpha_i - alpha)
        along = force.height * cosine_alpha + force.distance * sine_alpha
        across = force.distance * cosine_alpha - force.height * sine_alpha
        sine += (force.vertical * along - force.horizontal * across) / scale
        cosine += (force.vertical * across + force.horizontal * along) / scale
    return RestoringMoment(sine, cosine, math.hypot(sine, cosine), math.atan2(cosine, sine))


def composite(block: Block, mass: float, masses: Sequence[PointMass]) -> Block:
    """The block and what moves with it, as one block about the same pivot. mass : of the block [kg]."""
    if not masses:
        return block
    total = mass + sum(part.mass for part in masses)
    x = mass * block.radius * math.sin(block.slenderness)
    y = mass * block.radius * math.cos(block.slenderness)
    inertia = mass * block.inertia_over_mass
    for part in masses:
        x += part.mass * part.distance
        y += part.mass * part.height
        inertia += part.mass * (part.distance**2 + part.height**2)
    return Block(math.atan2(x, y), math.hypot(x, y) / total, inertia / total)
