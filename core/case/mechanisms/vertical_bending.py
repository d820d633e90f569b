"""Bending between two holds, with a hinge between them: vertical bending (C8.7.1.2.1.1)."""

from collections.abc import Iterator

from core.case.held_top import mirror_inward
from core.case.hinges import WallPart
from core.case.hold import ShareOfHold
from core.case.mechanisms.mechanism import Mechanism, Moving, NotLookedAt
from core.case.set_aside import VERTICAL_BENDING
from core.case.site import Building
from core.case.spans_between_ties import is_backed, leaves_stretches_out
from core.case.wall import Wall
from core.codes.vertical_bending import lowest_hinge, model_of_bending
from core.known import require_value
from core.mechanism.bending_reactions import MovingStrip
from core.mechanism.holds import INWARD, HoldLimit, limits_of_bending
from core.text.sentence import Key, sentence
from core.wall.bars import TieBar
from core.wall.bending import strip_of
from core.wall.masonry import Masonry
from core.wall.rocking_model import RockingModel


class VerticalBending(Mechanism):
    """Two blocks between two holds."""

    name = VERTICAL_BENDING

    def covers(self, part: WallPart, way: str) -> bool:
        return self.moves(part.wall)

    def moves(self, wall: Wall) -> bool:
        return wall.kinematics.bends_up

    def hinge(self, part: WallPart) -> float | None:
        return None

    def direction(self, part: WallPart, way: str) -> str:
        return "inward" if part.inward else "both"

    def left_out(self, wall: Wall, building: Building | None, aspect: str) -> Iterator[NotLookedAt]:
        if leaves_stretches_out(wall):
            yield NotLookedAt(sentence("reason", "stretches_left_out", set_aside=Key("set_aside")))

    def why_not(self, wall: Wall) -> str:
        if wall.ties:
            return "turns_before"
        if wall.restraints:
            at_heights = all(hold.has_height for hold in wall.restraints)
            return "turns_outward_before" if at_heights else "held_all_along"
        return "stands_free"

    def motion(self, wall: Wall, way: str) -> RockingModel:
        return model_of_bending(strip_of(wall.in_si), strip_of(mirror_inward(wall).in_si))

    def walls_of_checks(self, wall: Wall) -> dict[str, Masonry]:
        outward = {"outward": wall.in_si}
        return outward if _is_backed(wall) else outward | {INWARD: mirror_inward(wall).in_si}

    def moving(self, wall: Wall) -> Moving:
        """To each side, with each of the bars that have yielded along it slack and at yield: a reaction is extreme at
        one of these."""
        own = wall.in_si
        outward = [own.add_pulls(pulling) for pulling in _pulling(own.yielded)]
        walls = {"outward": outward, INWARD: [mirror_inward(wall).in_si]}
        return {side: [(each, strip_that_moves(each)) for each in of_side] for side, of_side in walls.items()}

    def hold_limits(self, moving: Moving) -> tuple[HoldLimit, ...]:
        if moving["outward"][0][0].declared.strength is None:
            return ()
        ways = [(side, *way) for side, of_side in moving.items() for way in of_side]
        limits = [limit for side, wall, strip in ways for limit in limits_of_bending(wall, strip, side)]
        first: dict[tuple, HoldLimit] = {}
        for limit in sorted(limits, key=lambda limit: limit.push):
            first.setdefault((limit.hold, limit.side, limit.presses), limit)
        return tuple(limit for limit in limits if limit in first.values())


def strip_that_moves(wall: Masonry) -> MovingStrip:
    """The strip of a wall with the hinge of the least multiplier."""
    strip = strip_of(wall)
    return MovingStrip(strip, lowest_hinge(strip))


def _pulling(bars: tuple[TieBar, ...]) -> list[tuple[TieBar, ...]]:
    """Bars that pull, of those that have yielded, where a reaction of the top is extreme: it is linear in each force,
    and falls with that of any bar above one with whose force it falls. None first, then one more from below."""
    ordered = sorted(bars, key=lambda bar: bar.height)
    return [tuple(ordered[:count]) for count in range(len(ordered) + 1)]


def _is_backed(wall: Wall) -> bool:
    """Whether something is behind the wall all along."""
    shares = (hold for hold in wall.hold if isinstance(hold, ShareOfHold))
    return any(hold.backed for hold in shares) or is_backed(wall, 0.0, require_value(wall.height_m))
