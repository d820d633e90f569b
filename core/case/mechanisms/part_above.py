"""What stands above the highest hold of a wall: free, it rocks to both sides (C8.7.1.2.1.3: porzioni svettanti)."""

from collections.abc import Iterator
from functools import partial

from core.case.hinges import WallPart, find_unchecked_hinges, highest_hold, leaves_end_open
from core.case.mechanisms.mechanism import NotLookedAt, hinges_left_out
from core.case.mechanisms.turning import TurningBody, hinges_not_looked_at
from core.case.set_aside import PART_ABOVE
from core.case.site import Building
from core.case.wall import Wall
from core.text.sentence import Key, sentence


class FreePart(TurningBody):
    """What stands above the highest hold."""

    name = PART_ABOVE

    def covers(self, part: WallPart, way: str) -> bool:
        return part.turns and not part.wall.bends and part.wall.corner is None and way not in part.body.mechanisms()

    def left_out(self, wall: Wall, building: Building | None, aspect: str) -> Iterator[NotLookedAt]:
        if aspect:
            return
        above = highest_hold(wall, building)
        heights = (height for height in find_unchecked_hinges(wall, building) if height == above)
        yield from hinges_left_out(self.name, wall, heights, partial(hinges_not_looked_at, wall))
        if leaves_end_open(wall, building):
            why = sentence("reason", "end_left_open", key=Key("to_m"), building=Key("[building]"))
            yield NotLookedAt(why, low=wall.height_m or 0.0)  # nobody says where it begins

    def why_not(self, wall: Wall) -> str:
        return "held_at_top" if wall.bends else "held_to_top" if wall.restraints else "stands_free"
