"""What the verdict of a wall held at its top is to be read with."""

from dataclasses import replace

from core.case.schema import Wall
from core.case.site import Building
from core.codes.demand import DemandResult
from core.codes.kinematic import Kinematic
from core.errors import InputError
from core.study.limit_states import zetas
from core.text.sentence import Sentence, sentence
from core.wall.wall_loads import carries


def overturning_zeta(wall: Wall, demand: DemandResult, building: Building | None) -> float | None:
    """zeta of a wall held at its top, were it not: it overturns about its base, by the same checks. None of another
    wall, where its loads would overturn it without an earthquake, and where a spectrum ends before its period."""
    if not wall.bends or not carries(wall):
        return None
    try:
        (alone,) = zetas(replace(wall, mechanism="one_sided"), "one_sided", {demand.limit_state: demand}, building)
    except InputError:
        return None
    return alone.zeta


def limits_of_bending(kinematic: Kinematic) -> list[Sentence]:
    """What limits the verdict of a wall held at its top: no histories, a hinge as high as one is looked for."""
    found = kinematic.chain.bending
    if found is None:
        return []
    limits = [sentence("reason", "no_histories", q=2), sentence("reason", "top_force", force=1e-3 * found.top_force)]
    if found.highest:
        limits.append(sentence("reason", "hinge_highest", height=found.h1))
    return limits
