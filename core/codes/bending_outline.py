"""The outline of a wall that bends, turned, for every drawing."""

import itertools
import math

from core.codes.vertical_bending import Bending, displaced_blocks
from core.wall.bending import Strip, hinges_of
from core.wall.solids import changes, faces_at

DRAWN_ROTATION = math.radians(4.0)
"""Rotation of the lower block in drawings, less where the wall has fallen before."""


def shown_rotation(mechanism: Bending) -> float:
    """theta of the lower block [rad] in a drawing."""
    return min(DRAWN_ROTATION, mechanism.theta0)


def outlines(strip: Strip, h1: float, theta: float) -> list[list[tuple[float, float]]]:
    """Corners of the lower and of the upper block, closed, x inward and z up [m], for every drawing."""
    turn, at, height = displaced_blocks(strip, h1, theta), hinges_of(strip, h1), strip.height

    def placed(x: float, z: float, about: tuple[float, float], to: tuple[float, float], angle: float):
        c, s = math.cos(angle), math.sin(angle)
        a, b = x - about[0], z - about[1]
        return to[0] + a * c - b * s, to[1] + b * c + a * s

    def block(low: float, high: float) -> list[tuple[float, float]]:
        levels = [low, *(z for z in changes(strip.parts) if low < z < high), high] if strip.parts else [low, high]
        rows = []
        for below, above in itertools.pairwise(levels):
            faces = faces_at(strip.parts, below), faces_at(strip.parts, above, below=True)
            rows += [(z, pair or (0.0, strip.thickness)) for z, pair in zip((below, above), faces, strict=True)]
        corners = [(pair[1], z) for z, pair in rows]
        return [(rows[0][1][0], low), *corners, *((pair[0], z) for z, pair in reversed(rows))]

    foot, hinge = (at.base, 0.0), (at.between, h1)
    return [
        [placed(x, z, foot, foot, theta) for x, z in block(0.0, h1)],
        [placed(x, z, hinge, turn.hinge, -turn.phi) for x, z in block(h1, height)],
    ]
