"""Overturning of the outer leaf of a wall of several leaves."""

from core.case.hinges import WallPart
from core.case.mechanisms.turning import TurningBody
from core.case.set_aside import LEAF
from core.case.wall import Wall


class LeafOverturning(TurningBody):
    """The outer leaf alone."""

    name = LEAF

    def covers(self, part: WallPart, way: str) -> bool:
        return bool(part.aspect) and part.body.leans and not part.wall.bends and part.wall.corner is None

    def why_not(self, wall: Wall) -> str:
        return "one_leaf"
