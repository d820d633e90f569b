"""A part that turns as a rigid body about a hinge: what its mechanisms have in common."""

from collections.abc import Sequence

from core.case.hinges import WallPart
from core.case.mechanisms.mechanism import Mechanism
from core.case.wall import Wall
from core.text.sentence import Key, Number, Sentence, sentence
from core.wall.kinematics import kinematics
from core.wall.rocking_model import RockingModel, rocking_model


class TurningBody(Mechanism):
    """A rigid body about a hinge, to one side or both."""

    def direction(self, part: WallPart, way: str) -> str:
        return "outward" if kinematics(way).one_way else "both"

    def motion(self, wall: Wall, way: str) -> RockingModel:
        own, one_sided, restitution = wall.in_si, kinematics(way).one_way, wall.restitution_of(way)
        return rocking_model(own.block, one_sided, restitution, own.law, own.restoring, own.bars, own.inner_block)


def hinges_not_looked_at(wall: Wall, heights: Sequence[float]) -> Sentence:
    """That hinges of a wall are not looked at, and by what they would be. heights : [m]"""
    code = "heights_left_out" if wall.hinge_heights is None else "hinges_as_asked"
    keys = {"key": Key("hinge_heights"), "building": Key("[building]")}
    return sentence("reason", code, heights=tuple(Number(height, ".4g") for height in heights), **keys)
