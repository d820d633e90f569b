"""Bending between transverse walls, as an arch in the thickness: horizontal bending (C8.7.1.2.1.1)."""

from collections.abc import Iterator

from core.case.hinges import WallPart
from core.case.mechanisms.mechanism import Mechanism, Moving, NotLookedAt
from core.case.mechanisms.vertical_bending import strip_that_moves
from core.case.set_aside import HORIZONTAL_BENDING
from core.case.site import Building
from core.case.wall import Wall
from core.codes.vertical_bending import model_of_bending
from core.known import require_value
from core.mechanism.holds import HoldLimit, limit_of_ends
from core.text.sentence import Key, sentence
from core.wall.arch import MIN_THRUST
from core.wall.bending import strip_of
from core.wall.rocking_model import RockingModel


class HorizontalBending(Mechanism):
    """Two blocks between transverse walls."""

    name = HORIZONTAL_BENDING

    def covers(self, part: WallPart, way: str) -> bool:
        return self.moves(part.wall)

    def moves(self, wall: Wall) -> bool:
        return wall.kinematics.arches

    def hinge(self, part: WallPart) -> float | None:
        return None

    def direction(self, part: WallPart, way: str) -> str:
        return "inward" if part.inward else "both"

    def left_out(self, wall: Wall, building: Building | None, aspect: str) -> Iterator[NotLookedAt]:
        if not aspect and wall.leans and wall.held_by is not None and wall.held_by.only_there:
            names = {"arch": "spacing_m", "tie": "tie_kn_m", "shoulder": "shoulder_length_m"}
            keys = names | {"strength": "compressive_strength_mpa"}
            yield NotLookedAt(sentence("reason", "no_arch", **{name: Key(key) for name, key in keys.items()}))

    def why_not(self, wall: Wall) -> str:
        return "no_spacing" if any(hold.only_there for hold in wall.hold) else "no_cross_walls"

    def motion(self, wall: Wall, way: str) -> RockingModel:
        strip = strip_of(wall.in_si)  # alike to both sides, but for what presses it outward
        return model_of_bending(strip, strip)

    def moving(self, wall: Wall) -> Moving:
        return {"outward": [(wall.in_si, strip_that_moves(wall.in_si))]}

    def hold_limits(self, moving: Moving) -> tuple[HoldLimit, ...]:
        wall, strip = moving["outward"][0]
        return (limit_of_ends(wall, strip),) if require_value(wall.arch).thrust > MIN_THRUST else ()
