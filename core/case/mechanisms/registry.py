"""The mechanisms out of plane, in the order in which the register has them."""

from core.case.hinges import WallPart
from core.case.mechanisms.corner import CornerOverturning
from core.case.mechanisms.direction import Direction
from core.case.mechanisms.horizontal_bending import HorizontalBending
from core.case.mechanisms.leaf import LeafOverturning
from core.case.mechanisms.mechanism import Mechanism
from core.case.mechanisms.overturning import Overturning
from core.case.mechanisms.part_above import FreePart
from core.case.mechanisms.vertical_bending import VerticalBending
from core.case.wall import Wall

REGISTER: list[Mechanism] = [
    Overturning(),
    VerticalBending(),
    HorizontalBending(),
    CornerOverturning(),
    LeafOverturning(),
    FreePart(),
    Direction(),
]
"""None is without a row (Circolare 7/2019 C8.7.1.2.1.1)."""


def part_moves_by(part: WallPart, way: str) -> Mechanism:
    """By which a part moves. way : one of the mechanisms of its wall"""
    return next(mechanism for mechanism in REGISTER if mechanism.covers(part, way))


def how_it_moves(wall: Wall) -> Mechanism:
    """How a wall moves, whatever it is a part of."""
    return next(mechanism for mechanism in REGISTER if mechanism.moves(wall))
