"""The register of a wall: every mechanism it may have is looked at, not possible and why, or not looked at."""

from collections.abc import Iterable
from typing import NamedTuple

from core.case.hinges import WallPart
from core.case.mechanisms.mechanism import Mechanism, NotLookedAt, find_set_aside
from core.case.mechanisms.registry import REGISTER, part_moves_by
from core.case.site import Building
from core.case.wall import Wall
from core.known import require_value
from core.text.sentence import Number, Sentence, sentence

LOOKED_AT, NOT_POSSIBLE, NOT_LOOKED_AT, SET_ASIDE = "looked_at", "not_possible", "not_looked_at", "set_aside"
"""Status of a row. What is not looked at leaves an outcome that passes indicative; the engineer may set it aside."""


class RegisterRow(NamedTuple):
    """A mechanism of a wall.

    low, high : heights above the base between which it moves [m], high None of a wall without a height
    hinge : about which it turns [m], None where it bends
    direction : outward, inward, both, or an angle in plan from that of the thickness; "" of what is not looked at
    why : it is not possible, what is missing, or the engineer's reason
    """

    name: str
    status: str
    low: float = 0.0
    high: float | None = None
    hinge: float | None = None
    direction: str = ""
    why: Sentence | str = ""


def row_of_part(part: WallPart, way: str) -> RegisterRow:
    """The row of what is looked at. way : one of the mechanisms of the wall of the part"""
    top, moves = part.body.height_m if part.top is None else part.top, part_moves_by(part, way)
    return RegisterRow(moves.name, LOOKED_AT, part.hinge, top, moves.hinge(part), moves.direction(part, way))


def row_passed_over(part: WallPart, mechanism: str, zeta: float | None, way: int) -> RegisterRow:
    """The row of a part of a held wall of a way it does not take (`best_way`). zeta : the lowest of that way; way :
    `WallPart.held` of the one it takes"""
    goes = part.held != 0 and (way == 0 or part.held < way)
    why = sentence("mechanism", "holds_give_way" if goes else "anchors_hold", zeta=Number(zeta))
    return row_of_part(part, mechanism)._replace(status=NOT_POSSIBLE, why=why)


def find_left_out(part: WallPart, building: Building | None) -> tuple[Sentence, ...]:
    """Sentences on what nobody looks at of the wall, or of its leaf, that a part is the whole of."""
    if part.hinge > 0.0 or (part.top is not None and not part.held):
        return ()
    rows = _rows_left(part.body, building, part.aspect)
    sentences = (row.why for row in rows if row.status == NOT_LOOKED_AT and isinstance(row.why, Sentence))
    return tuple(dict.fromkeys(sentences))


def find_mechanisms_left_out(parts: Iterable[WallPart], building: Building | None) -> tuple[str, ...]:
    """Names of the mechanisms of a wall that nobody looks at. parts : of the wall"""
    rows = (row for part in _wholes(parts) for row in _rows_left(part.body, building, part.aspect))
    return tuple(dict.fromkeys(row.name for row in rows if row.status == NOT_LOOKED_AT))


def _wholes(parts: Iterable[WallPart]) -> list[WallPart]:
    """The parts that are the whole of a wall, of its leaf, or of a direction of it."""
    return [part for part in parts if part.hinge == 0.0 and part.top is None]


def other_rows(parts: Iterable[WallPart], looked: set[str], building: Building | None) -> list[RegisterRow]:
    """Rows of a wall beside those of what is looked at. parts : of the wall; looked : names that have a row"""
    whole = _wholes(parts)
    rows = list(dict.fromkeys(row for part in whole for row in _rows_left(part.body, building, part.aspect)))
    names, wall = looked | {row.name for row in rows}, whole[0].body
    return rows + [
        RegisterRow(moves.name, NOT_POSSIBLE, 0.0, wall.height_m, why=sentence("mechanism", moves.why_not(wall)))
        for moves in REGISTER
        if moves.name not in names
    ]


def _rows_left(wall: Wall, building: Building | None, aspect: str) -> list[RegisterRow]:
    """What is not looked at of a wall about its base, or is set aside with a reason. aspect : of `WallPart`"""
    return [_row_left(moves, left, wall) for moves in REGISTER for left in moves.left_out(wall, building, aspect)]


def _row_left(moves: Mechanism, left: NotLookedAt, wall: Wall) -> RegisterRow:
    low, high = (left.low, wall.height_m) if left.hinge is None else (left.hinge, left.hinge)
    entry = find_set_aside(wall, moves.name, low, high)
    why = left.why if entry is None else require_value(entry.evidence).words
    status = NOT_LOOKED_AT if entry is None else SET_ASIDE
    return RegisterRow(moves.name, status, left.hinge or 0.0, wall.height_m, left.hinge, "", why)
