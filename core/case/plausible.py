"""Values of a wall that are seldom right: the engineer is asked about them, and no outcome is held back."""

from collections.abc import Iterator

from core.case.site import Building
from core.case.variant_names import AS_IS, DESIGNED
from core.case.wall import Wall
from core.text.sentence import Number, Sentence, sentence

MOST_FLOOR = 12.0
"""Permanent load of a floor [kN/m2]: vaults with their fill and stone slabs are below it."""

MOST_WEIGHT = 150.0
"""Load on a metre of wall [kN/m]: ten metres of span, half of them on the wall, of such a floor and three storeys."""

MOST_THICKNESS, LEAST_SLENDERNESS = 2.5, 1.5
"""Thickness [m] above which, and H/t below which, a number is asked about that may be in another unit."""

NEAR_FACE = 0.9
"""Share of the thickness from the outer face from which on a weight stands at the inner one [-]."""

MOST_LEAF = 0.75
"""Thickness of the outer leaf over that of its wall [-]: an inner one stands behind it."""


QUESTIONS = "odd_floor", "odd_load", "odd_place", "odd_sizes", "odd_leaf", "straightened", "odd_storeys"
"""Codes of what is asked, of the storeys of a building among them."""


def plausibility_questions(wall: Wall, building: Building | None, others: tuple[Wall, ...]) -> Iterator[Sentence]:
    """What is asked of a wall, of the floors that bear on it, and of its design beside the wall as it is.

    others : walls of the case, its other variant among them
    """
    for floor in building.floors if building else ():
        if floor.bears_on(wall.name) and floor.g_kn_m2 > MOST_FLOOR:
            yield sentence("reason", "odd_floor", name=floor.name, g=Number(floor.g_kn_m2, ".3g"), most=MOST_FLOOR)
    for load in wall.load:
        if load.is_weight and (load.kn_m or 0.0) > MOST_WEIGHT:
            yield sentence("reason", "odd_load", load=Number(load.kn_m, ".4g"), most=MOST_WEIGHT)
        if load.is_weight and wall.thickness and (load.d_m or 0.0) > NEAR_FACE * wall.thickness:
            yield sentence("reason", "odd_place", d=Number(load.d_m, ".3g"), thickness=Number(wall.thickness, ".3g"))
    height, thickness = wall.height_m, wall.thickness
    if thickness and (thickness > MOST_THICKNESS or (height and height < LEAST_SLENDERNESS * thickness)):
        yield sentence("reason", "odd_sizes", height=Number(height, ".3g"), thickness=Number(thickness, ".3g"))
    if wall.leaf is not None and wall.thickness and wall.leaf.thickness_m > MOST_LEAF * wall.thickness:
        cm = Number(100.0 * wall.leaf.thickness_m, ".3g"), Number(100.0 * wall.thickness, ".3g")
        yield sentence("reason", "odd_leaf", leaf=cm[0], whole=cm[1])
    if wall.variant == DESIGNED:
        leans = [each.out_of_plumb_m or 0.0 for each in others if (each.name, each.variant) == (wall.name, AS_IS)]
        if any(lean > (wall.out_of_plumb_m or 0.0) for lean in leans):
            lean = Number(100.0 * max(leans), ".3g"), Number(100.0 * (wall.out_of_plumb_m or 0.0), ".3g")
            yield sentence("reason", "straightened", before=lean[0], after=lean[1])
