"""A mechanism out of plane: what the register, the checks and the histories ask of it. None is recognised by its name.

A new one is a file here and a line of `REGISTER` (core/case/mechanisms/registry.py).
"""

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from core.case.hinges import WallPart
from core.case.set_aside import SetAside
from core.case.site import Building
from core.case.wall import Wall
from core.mechanism.bending_reactions import MovingStrip
from core.mechanism.holds import HoldLimit
from core.text.sentence import Sentence
from core.wall.masonry import Masonry
from core.wall.rocking_model import RockingModel

Moving = dict[str, list[tuple[Masonry, MovingStrip]]]
"""Side -> the walls that bend to it, each with its strip."""


class NotLookedAt(NamedTuple):
    """What nobody looks at. hinge : about which it would turn [m], None : of the whole wall; low : from where [m]"""

    why: Sentence
    hinge: float | None = None
    low: float = 0.0


class Mechanism:
    """A mechanism out of plane that a wall may have (Circolare 7/2019 C8.7.1.2.1.1)."""

    name = ""
    """As the register, a case file and the results have it."""

    def covers(self, part: WallPart, way: str) -> bool:
        """Whether a part moves by it. way : one of the mechanisms of its wall"""
        raise NotImplementedError

    def moves(self, wall: Wall) -> bool:
        """Whether it is how a wall moves, whatever it is a part of."""
        return False

    def hinge(self, part: WallPart) -> float | None:
        """Height about which it turns [m], None where it bends."""
        return part.hinge

    def direction(self, part: WallPart, way: str) -> str:
        """outward, inward, both, or an angle in plan."""
        raise NotImplementedError

    def left_out(self, wall: Wall, building: Building | None, aspect: str) -> Iterable[NotLookedAt]:
        """What nobody looks at of a wall about its base. aspect : of `WallPart`"""
        return ()

    def why_not(self, wall: Wall) -> str:
        """Code of why a wall has it not, where it is neither looked at nor left out."""
        raise NotImplementedError

    def motion(self, wall: Wall, way: str) -> RockingModel:
        """What the kernels integrate. Raises InputError."""
        raise NotImplementedError

    def walls_of_checks(self, wall: Wall) -> dict[str, Masonry]:
        """Side -> the wall that moves to it, where the checks of the clauses are made."""
        return {"outward": wall.in_si}

    def moving(self, wall: Wall) -> Moving:
        """The walls whose holds may be asked most; none of what hands no reaction to a hold with a strength."""
        return {}

    def hold_limits(self, moving: Moving) -> tuple[HoldLimit, ...]:
        """Limits of what holds it. moving : of `moving`"""
        return ()


def find_set_aside(wall: Wall, name: str, low: float, high: float | None) -> SetAside | None:
    """What sets a mechanism of a wall aside between two heights [m]."""
    return next((entry for entry in wall.set_aside if entry.covers(name, low, high)), None)


def hinges_left_out(name: str, wall: Wall, heights: Iterable[float], why) -> Iterator[NotLookedAt]:
    """The lowest hinge that nobody looks at, with a sentence on all of them, and each that is set aside.

    heights : [m]; why : a sentence of the heights that are not set aside
    """
    heights = list(heights)
    left = [height for height in heights if find_set_aside(wall, name, height, height) is None]
    for height in (*left[:1], *(height for height in heights if height not in left)):
        yield NotLookedAt(why(left), height)
