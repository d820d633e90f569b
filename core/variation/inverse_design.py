"""The answer turned round: the thickness, the force of a tie, the a_g at which zeta of each check reaches what is
required."""

import functools
import math
from collections.abc import Callable
from dataclasses import replace

from core.boundary import Boundary, find_boundary
from core.case.held_top import move_top_loads
from core.case.wall import Wall
from core.codes.multiplier_search import Precision
from core.errors import InputError
from core.known import require_value
from core.setting.demand_input import rescale_ag
from core.variation.changes import rescale_thickness, scale_loads
from core.variation.evaluate import COARSE_PRECISION, FULL_PRECISION
from core.variation.swings import TargetValue
from core.variation.wall_evaluation import (
    NO_EVALUATION,
    WallContext,
    WallEvaluation,
    evaluate_wall,
    replace_demand,
    replace_wall,
)

SEARCH_TOLERANCE = 0.002
"""Width of the bracket of a value, of the value [-]."""

VALUE_MARGIN = 1.02
"""More of the value at which histories must hold as well: their rule is not monotone."""

CONFIRMATION_FACTORS = (1.05, 1.1, 1.2, 1.3, 1.5)
"""More of the value at which a check of the clauses must hold too: a tie that breaks early makes a step."""

RETRY_STEP, TRIES = 0.01, 30
"""Step and count by which a value of the histories is moved on until the run itself is satisfied."""

SEARCH_FACTOR = 1.25
"""Factor by which a search goes on until its outcome changes."""

SEARCH_RANGE_FACTORS = {"thickness_m": 4.0, "tie_kn_m": 64.0, "ag_g": 16.0}
"""Factor of the value given up to which, and share of it down to which, it is searched."""

ROUNDING_STEPS = {"thickness_m": 1e-3, "tie_kn_m": 1e-2, "ag_g": 1e-3}
"""Last digit a value is written with; it is rounded to the safe side."""

Change = Callable[[WallContext, float], WallContext]
"""Change of a setting: the setting with this value of the key."""


def _of_thickness(setting: WallContext, thickness: float) -> WallContext:
    return replace_wall(setting, rescale_thickness(setting.case.wall[0], thickness))


def _of_ties(setting: WallContext, force: float) -> WallContext:
    wall = setting.case.wall[0]
    share = force / tie_force(wall)
    stronger = {tie: replace(tie, out_kn_m=share * require_value(tie.out_kn_m)) for tie in wall.ties}
    return replace_wall(setting, replace(wall, hold=tuple(stronger.get(hold, hold) for hold in wall.hold)))


def _of_ag(setting: WallContext, ag_g: float) -> WallContext:
    asked = setting.case.demand
    assert asked is not None
    return replace_demand(setting, rescale_ag(setting.demand, asked, setting.base_dir, ag_g / asked.ag_g))


def _of_height(setting: WallContext, height: float) -> WallContext:
    wall = setting.case.wall[0]
    return replace_wall(setting, move_top_loads(wall, replace(wall, height_m=height)))


def _of_loads(setting: WallContext, factor: float) -> WallContext:
    return replace_wall(setting, scale_loads(setting.case.wall[0], factor))


def tie_force(wall: Wall) -> float:
    """Force of all ties of a wall, given by their forces at yield [kN/m]; 0 where a bar gives one, or there is none."""
    ties = [tie.out_kn_m for tie in wall.ties]
    return 0.0 if None in ties else math.fsum(force for force in ties if force is not None)


def design_keys(setting: WallContext) -> dict[str, float]:
    """Keys whose value is searched for a wall -> their value now."""
    wall, demand = setting.case.wall[0], setting.case.demand
    assert demand is not None
    values = {"ag_g": demand.ag_g}
    if wall.thickness is not None and not wall.solid:
        values["thickness_m"] = wall.thickness
    if tie_force(wall) > 0.0:
        values["tie_kn_m"] = tie_force(wall)
    return values


VALUE_SETTERS: dict[str, Change] = {
    "thickness_m": _of_thickness,
    "height_m": _of_height,
    "tie_kn_m": _of_ties,
    "load_factor": _of_loads,
    "ag_g": _of_ag,
}
"""Key -> the setting with another value of it, in the order they are applied; loads in shares of what they are."""


def slider_keys(setting: WallContext) -> dict[str, float]:
    """Keys of a wall that can be moved by hand -> their value now."""
    wall = setting.case.wall[0]
    values = design_keys(setting)
    if wall.height_m is not None and not wall.solid:
        values["height_m"] = wall.height_m
    if wall.load:
        values["load_factor"] = 1.0
    return {key: values[key] for key in VALUE_SETTERS if key in values}


def set_values(setting: WallContext, values: dict[str, float]) -> WallContext:
    """The setting with several values at once. Raises InputError where the wall does not stand with them."""
    for key, change in VALUE_SETTERS.items():
        if key in values:
            setting = change(setting, values[key])
    return setting


def find_target_value(
    setting: WallContext, key: str, given: float, cancelled: Callable[[], bool] = lambda: False
) -> TargetValue:
    """The value of a key from which on zeta of each check reaches what is required, nearest to the value now: of a_g
    up to which, in the digits it is written with. How far beyond it is looked: STRONGER, of histories VALUE_MARGIN.

    given : its value now
    Raises Cancelled.
    """
    known: dict[tuple[float, Precision | None], WallEvaluation] = {}

    def at(value: float, precision: Precision | None) -> WallEvaluation:
        if (value, precision) not in known:
            try:
                moved = VALUE_SETTERS[key](setting, value)
                known[value, precision] = evaluate_wall(moved, precision, cancelled=cancelled)
            except InputError:
                known[value, precision] = NO_EVALUATION
        return known[value, precision]

    by_check: dict[str, float | None] = {}
    throughout = []
    for label in at(given, COARSE_PRECISION).by_check:
        edge_of = _searched(functools.partial(_holds_at, at, label), key, given, label == "dynamic")
        by_check[label] = None if edge_of.bad is None else edge_of.good
        # what ends at a value that is refused holds at all that are accepted
        if edge_of.good is not None and (edge_of.bad is None or edge_of.refused):
            by_check[label], throughout = None, [*throughout, label]
    return TargetValue(key, given, by_check, tuple(throughout))


def _holds_at(
    at: Callable[[float, Precision | None], WallEvaluation], label: str, value: float, precision: Precision | None
) -> bool | None:
    """Whether a check surely holds about every hinge at a value; None where the wall is refused."""
    there = at(value, precision)
    return bool(there.satisfied.get(label)) if there.hinges else None


def _searched(
    holds: Callable[[float, Precision | None], bool | None], key: str, given: float, dynamic: bool
) -> Boundary:
    """Search the value at which a check begins to hold. holds(value, precision) : whether it does; dynamic : it is that
    of the histories, which must hold in the run itself near what a glance finds"""
    falls = key == "ag_g"
    sign = -1.0 if falls else 1.0
    ends = given / SEARCH_RANGE_FACTORS[key], given * SEARCH_RANGE_FACTORS[key]

    def fine(value: float, precision: Precision | None) -> bool | None:
        held = holds(value, precision)
        beyond = (VALUE_MARGIN,) if dynamic else CONFIRMATION_FACTORS
        # where it is refused it fails for another reason
        return held and all(holds(value * factor**sign, precision) is not False for factor in beyond)

    boundary = find_boundary(
        lambda value: fine(value, COARSE_PRECISION if dynamic else None),
        given,
        ends,
        not falls,
        SEARCH_FACTOR,
        SEARCH_TOLERANCE,
    )
    if boundary.good is None or boundary.bad is None or boundary.refused:
        return boundary
    for k in range(TRIES if dynamic else 1):
        value = _written(key, boundary.good * (1.0 + RETRY_STEP) ** (sign * k))
        if holds(value, FULL_PRECISION if dynamic else None):
            return boundary._replace(good=value)
    return Boundary(None, boundary.bad)


def _written(key: str, value: float) -> float:
    """A value rounded to the safe side, of a_g down, else up."""
    unit = ROUNDING_STEPS[key]
    rounded = math.floor(value / unit + 1e-9) if key == "ag_g" else math.ceil(value / unit - 1e-9)
    return round(rounded * unit, 6)
