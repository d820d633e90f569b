"""Overturning of a corner, pushed by the two walls that meet in it."""

from core.case.hinges import WallPart
from core.case.mechanisms.turning import TurningBody
from core.case.set_aside import CORNER
from core.case.wall import Wall


class CornerOverturning(TurningBody):
    """A corner that two walls push over."""

    name = CORNER

    def covers(self, part: WallPart, way: str) -> bool:
        return part.wall.corner is not None and not part.wall.bends

    def why_not(self, wall: Wall) -> str:
        return "no_corner"
