"""The register of a wall: every mechanism it may have is looked at, not possible and why, or not looked at."""

from collections.abc import Iterable
from typing import NamedTuple

from core.case.directions import falls_sooner_along
from core.case.hinges import WallPart, find_unchecked_hinges, highest_hold, leaves_end_open
from core.case.set_aside import (
    CORNER,
    DIRECTION,
    HORIZONTAL_BENDING,
    LEAF,
    OVERTURNING,
    PART_ABOVE,
    ROWS,
    VERTICAL_BENDING,
    SetAside,
)
from core.case.site import Building
from core.case.spans_between_ties import leaves_stretches_out
from core.case.wall import Wall
from core.known import require_value
from core.text.sentence import Key, Number, Sentence, sentence
from core.wall.kinematics import kinematics

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


def row_of_part(part: WallPart, mechanism: str) -> RegisterRow:
    """The row of what is looked at. mechanism : one of those of the wall of the part"""
    body = part.body
    top = body.height_m if part.top is None else part.top
    if part.wall.bends:
        name = HORIZONTAL_BENDING if part.wall.kinematics.arches else VERTICAL_BENDING
        return RegisterRow(name, LOOKED_AT, part.hinge, top, None, "inward" if part.inward else "both")
    name, direction = OVERTURNING, "outward" if kinematics(mechanism).one_way else "both"
    if part.wall.corner is not None:
        name = CORNER
    elif part.aspect and body.leans:
        name = LEAF
    elif part.aspect:
        name, direction = DIRECTION, part.aspect
    elif mechanism not in body.mechanisms():
        name = PART_ABOVE
    return RegisterRow(name, LOOKED_AT, part.hinge, top, part.hinge, direction)


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
    return tuple(row.why for row in rows if row.status == NOT_LOOKED_AT and isinstance(row.why, Sentence))


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
        RegisterRow(name, NOT_POSSIBLE, 0.0, wall.height_m, why=sentence("mechanism", _why_not(name, wall)))
        for name in ROWS
        if name not in names
    ]


def _rows_left(wall: Wall, building: Building | None, aspect: str) -> list[RegisterRow]:
    """What is not looked at of a wall about its base, or is set aside with a reason. aspect : of `WallPart`"""
    rows: list[RegisterRow] = []

    def leave(name: str, why: Sentence, hinge: float | None = None) -> None:
        entry, status = _set_aside(wall, name, hinge), NOT_LOOKED_AT
        if entry is not None:
            why, status = require_value(entry.evidence).words, SET_ASIDE
        rows.append(RegisterRow(name, status, hinge or 0.0, wall.height_m, hinge, "", why))

    if leaves_stretches_out(wall):
        leave(VERTICAL_BENDING, sentence("reason", "stretches_left_out", set_aside=Key("set_aside")))
    if aspect:
        return rows
    unchecked, free_above = find_unchecked_hinges(wall, building), highest_hold(wall, building)
    names = {height: PART_ABOVE if height == free_above else OVERTURNING for height in unchecked}
    left = [height for height in unchecked if _set_aside(wall, names[height], height) is None]
    code = "heights_left_out" if wall.hinge_heights is None else "hinges_as_asked"
    keys = {"key": Key("hinge_heights"), "building": Key("[building]")}
    why = sentence("reason", code, heights=tuple(Number(height, ".4g") for height in left), **keys)
    for height in (*left[:1], *(height for height in unchecked if height not in left)):
        leave(names[height], why, height)
    if leaves_end_open(wall, building):
        keys = {"key": Key("to_m"), "building": Key("[building]")}
        leave(PART_ABOVE, sentence("reason", "end_left_open", **keys))
    if wall.leans and wall.held_by is not None and wall.held_by.only_there:
        names = {"arch": "spacing_m", "tie": "tie_kn_m", "shoulder": "shoulder_length_m"}
        keys = names | {"strength": "compressive_strength_mpa"}
        leave(HORIZONTAL_BENDING, sentence("reason", "no_arch", **{name: Key(key) for name, key in keys.items()}))
    if falls_sooner_along(wall, free_above):
        leave(DIRECTION, sentence("reason", "direction_left_out", set_aside=Key("set_aside")))
    return rows


def _set_aside(wall: Wall, name: str, hinge: float | None) -> SetAside | None:
    """What sets a mechanism aside, over the whole wall or about a hinge [m]."""
    low, high = (0.0, wall.height_m) if hinge is None else (hinge, hinge)
    if hinge is None and name == PART_ABOVE:  # of which nobody says where it begins
        low = wall.height_m or 0.0
    return next((entry for entry in wall.set_aside if entry.covers(name, low, high)), None)


def _why_not(name: str, wall: Wall) -> str:
    """Code of why a wall has not a mechanism that is neither looked at nor left out."""
    if name == OVERTURNING:
        return "turns_as_corner" if wall.corner else "held_at_ends" if wall.kinematics.arches else "held_at_top"
    if name == VERTICAL_BENDING and wall.ties:
        return "turns_before"
    if name == VERTICAL_BENDING and wall.restraints:
        at_heights = all(hold.has_height for hold in wall.restraints)
        return "turns_outward_before" if at_heights else "held_all_along"
    if name == PART_ABOVE and wall.bends:
        return "held_at_top"
    if name == PART_ABOVE and wall.restraints:
        return "held_to_top"
    if name == HORIZONTAL_BENDING and any(hold.only_there for hold in wall.hold):
        return "no_spacing"
    if name == DIRECTION and (wall.leans or wall.bends):
        return "held_in_plane"
    if name == DIRECTION and wall.length_m is None:
        return "taken_as_long"
    return {
        VERTICAL_BENDING: "stands_free",
        HORIZONTAL_BENDING: "no_cross_walls",
        CORNER: "no_corner",
        LEAF: "one_leaf",
        PART_ABOVE: "stands_free",
        DIRECTION: "stockier_along",
    }[name]
