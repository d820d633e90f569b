"""Overturning of a wall about its base or a hinge above it (C8.7.1.2.1.1)."""

from collections.abc import Iterable
from functools import partial

from core.case.hinges import WallPart, find_unchecked_hinges, highest_hold
from core.case.mechanisms.mechanism import NotLookedAt, hinges_left_out
from core.case.mechanisms.turning import TurningBody, hinges_not_looked_at
from core.case.set_aside import OVERTURNING
from core.case.site import Building
from core.case.wall import Wall


class Overturning(TurningBody):
    """A wall about its base or a hinge above it, to one side or both."""

    name = OVERTURNING

    def covers(self, part: WallPart, way: str) -> bool:
        return part.turns and not part.wall.bends and part.wall.corner is None and way in part.body.mechanisms()

    def moves(self, wall: Wall) -> bool:
        return not wall.bends

    def left_out(self, wall: Wall, building: Building | None, aspect: str) -> Iterable[NotLookedAt]:
        if aspect:
            return ()
        above = highest_hold(wall, building)
        heights = (height for height in find_unchecked_hinges(wall, building) if height != above)
        return hinges_left_out(self.name, wall, heights, partial(hinges_not_looked_at, wall))

    def why_not(self, wall: Wall) -> str:
        return "turns_as_corner" if wall.corner else "held_at_ends" if wall.kinematics.arches else "held_at_top"
