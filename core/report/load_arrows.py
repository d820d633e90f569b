"""The loads of a wall as arrows, for every drawing of it."""

from core.case.wall import Wall
from core.known import require_value

MAX_ARROW, MIN_ARROW = 0.22, 0.08
"""Length of the arrow of the strongest load and of a vanishing one, of the height of the wall."""

PLATE = 0.02
"""Half of the plate of a tie, of the height of the wall."""

ARROW_HEAD = 0.2
"""Length of the head of an arrow, of that of the arrow [-]."""


def arrows(wall: Wall, height: float, thickness: float) -> list[list[tuple[float, float]]]:
    """An arrow to each load at its place, as long as it is strong: the corners of a line [m], x from the inner face
    outward, y up. height, thickness : of the wall [m]."""
    sizes = [abs(load.in_si.force) for load in wall.load]
    strongest = max(sizes, default=0.0) or 1.0
    lines = []
    for load, one in zip(wall.load, sizes, strict=True):
        size = height * (MIN_ARROW + (MAX_ARROW - MIN_ARROW) * one / strongest)
        x, y, head = thickness - (load.d_m or 0.0), load.h_m, ARROW_HEAD * size
        if load.is_weight:
            lines.append([(x, y + size), (x, y), (x - head, y + head), (x, y), (x + head, y + head)])
            continue
        # a thrust ends where it pushes outward
        outward = load.is_thrust and require_value(load.kn_m) > 0.0
        start, end = (x - size, x) if outward else (x, x - size)
        back = end - head if outward else end + head
        lines.append([(start, y), (end, y), (back, y + head), (end, y), (back, y - head)])
    return lines


def tie_bars(wall: Wall, height: float, thickness: float) -> list[list[tuple[float, float]]]:
    """The bar of each tie and its plate on the outer face, as `arrows`."""
    heights, plate = [require_value(tie.h_m) for tie in wall.ties], PLATE * height
    return [[(-MAX_ARROW * height, y), (thickness, y), (thickness, y + plate), (thickness, y - plate)] for y in heights]
