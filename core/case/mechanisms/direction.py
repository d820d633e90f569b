"""Overturning of a prism that stands free, along its length and about its corners."""

from collections.abc import Iterator

from core.case.directions import falls_sooner_along
from core.case.hinges import WallPart, highest_hold
from core.case.mechanisms.mechanism import NotLookedAt
from core.case.mechanisms.turning import TurningBody
from core.case.set_aside import DIRECTION
from core.case.site import Building
from core.case.wall import Wall
from core.text.sentence import Key, sentence


class Direction(TurningBody):
    """A prism about its other edges and its corners."""

    name = DIRECTION

    def covers(self, part: WallPart, way: str) -> bool:
        return bool(part.aspect) and not part.body.leans and not part.wall.bends and part.wall.corner is None

    def direction(self, part: WallPart, way: str) -> str:
        return part.aspect

    def left_out(self, wall: Wall, building: Building | None, aspect: str) -> Iterator[NotLookedAt]:
        if not aspect and falls_sooner_along(wall, highest_hold(wall, building)):
            yield NotLookedAt(sentence("reason", "direction_left_out", set_aside=Key("set_aside")))

    def why_not(self, wall: Wall) -> str:
        if wall.leans or wall.bends:
            return "held_in_plane"
        return "taken_as_long" if wall.length_m is None else "stockier_along"
