"""The answer turned round: the thickness, the force of a tie, the a_g at which zeta of each check reaches what is
required."""

import math
from collections.abc import Callable
from dataclasses import replace

from core.case.schema import Wall
from core.codes.kinematic import ROUNDING
from core.errors import InputError
from core.study.demand_input import with_ag
from core.study.sensitivity import loaded, thinner
from core.study.swings import Reach
from core.study.what_if import EVERY, NONE, Setting, Zetas, with_demand, with_wall, zetas

CLOSE = 0.002
"""Ratio of the ends of a search at which it stops."""

RAISED = 1.02
"""More of the value at which histories must hold as well: their rule is not monotone."""

BEYOND, TRIES = 0.01, 30
"""Step and count by which a value of the histories is moved on until the run itself is satisfied."""

WIDEST = {"thickness_m": 4.0, "tie_kn_m": 64.0, "ag_g": 16.0}
"""Factor of the value given up to which, and share of it down to which, it is searched."""

Change = Callable[[Setting, float], Setting]
"""The setting with a value of the key."""


def _of_thickness(setting: Setting, thickness: float) -> Setting:
    return with_wall(setting, thinner(setting.case.wall[0], thickness))


def _of_ties(setting: Setting, force: float) -> Setting:
    wall = setting.case.wall[0]
    share = force / tie_force(wall)
    loads = (replace(load, kn_m=share * load.kn_m) if load.is_tie else load for load in wall.load)
    return with_wall(setting, replace(wall, load=tuple(loads)))


def _of_ag(setting: Setting, ag_g: float) -> Setting:
    asked = setting.case.demand
    assert asked is not None
    return with_demand(setting, with_ag(setting.demand, asked, setting.base_dir, ag_g / asked.ag_g))


def _of_height(setting: Setting, height: float) -> Setting:
    return with_wall(setting, replace(setting.case.wall[0], height_m=height))


def _of_loads(setting: Setting, factor: float) -> Setting:
    return with_wall(setting, loaded(setting.case.wall[0], factor))


def tie_force(wall: Wall) -> float:
    """Of its ties together, given by their forces at yield [kN/m]; 0 where a bar gives one, or there is none."""
    ties = [load.kn_m for load in wall.load if load.is_tie]
    return 0.0 if None in ties else math.fsum(force for force in ties if force is not None)


def keys_of(setting: Setting) -> dict[str, float]:
    """What is searched for of a wall -> its value now."""
    wall, demand = setting.case.wall[0], setting.case.demand
    assert demand is not None
    found = {"ag_g": demand.ag_g}
    if wall.thickness is not None and not wall.solid:
        found["thickness_m"] = wall.thickness
    if tie_force(wall) > 0.0:
        found["tie_kn_m"] = tie_force(wall)
    return found


CHANGES: dict[str, Change] = {
    "thickness_m": _of_thickness,
    "height_m": _of_height,
    "tie_kn_m": _of_ties,
    "load_factor": _of_loads,
    "ag_g": _of_ag,
}
"""Key -> the setting with another value of it, in the order they are applied; loads in shares of what they are."""


def moved_keys(setting: Setting) -> dict[str, float]:
    """What can be moved of a wall by hand -> its value now."""
    wall = setting.case.wall[0]
    found = keys_of(setting)
    if wall.height_m is not None and not wall.solid:
        found["height_m"] = wall.height_m
    if any(not load.is_tie for load in wall.load):
        found["load_factor"] = 1.0
    return {key: found[key] for key in CHANGES if key in found}


def with_values(setting: Setting, values: dict[str, float]) -> Setting:
    """The setting with several values at once. Raises InputError where the wall does not stand with them."""
    for key, change in CHANGES.items():
        if key in values:
            setting = change(setting, values[key])
    return setting


def reach_of(
    setting: Setting, key: str, given: float, cancelled: Callable[[], bool] = lambda: False, every: int = EVERY
) -> Reach:
    """The value of a key at which zeta of each check reaches what is required: of a_g the largest, else the smallest.

    given : its value now
    every : as of `zetas`, of the histories
    Raises Cancelled.
    """
    target, known = setting.demand.zeta_target, {}

    def at(value: float, histories: bool) -> Zetas:
        if (value, histories) not in known:
            try:
                moved = CHANGES[key](setting, value)
                known[value, histories] = zetas(moved, every=every if histories else 0, cancelled=cancelled)
            except InputError:
                known[value, histories] = NONE
        return known[value, histories]

    now = at(given, True)
    found: dict[str, float | None] = {}
    throughout = []
    for label in now.by_check:
        dynamic = label == "dynamic"

        def holds(value: float, label: str = label, dynamic: bool = dynamic) -> bool | None:
            there = at(value, dynamic)
            zeta = there.by_check.get(label)
            return None if there is NONE else zeta is not None and zeta >= target - ROUNDING

        if dynamic and key == "ag_g":  # histories go with the ground, in proportion
            zeta = now.by_check[label]
            found[label], everywhere = None if zeta is None else _ag_at(setting, zeta / target), False
        else:
            found[label], everywhere = _search(holds, given, WIDEST[key], falls=key == "ag_g", again=dynamic)
        if dynamic and found[label] is not None:
            found[label] = _confirmed(setting, key, found[label], cancelled)
        throughout += [label] if everywhere else []
    return Reach(key, given, found, tuple(throughout))


def _confirmed(setting: Setting, key: str, value: float | None, cancelled: Callable[[], bool]) -> float | None:
    """The value found on the coarse grid, moved on until the run itself is satisfied there, its spread included; None
    where it is not within TRIES steps."""
    assert value is not None
    step = 1.0 / (1.0 + BEYOND) if key == "ag_g" else 1.0 + BEYOND
    for k in range(TRIES):
        tried = value * step**k
        try:
            if zetas(CHANGES[key](setting, tried), every=1, cancelled=cancelled).sure:
                return tried
        except InputError:
            return None
    return None


def _ag_at(setting: Setting, share: float) -> float | None:
    """The a_g [g] whose a_g S is this share of that of the demand; None where no spectrum has it."""
    asked = setting.case.demand
    assert asked is not None

    def below(ag_g: float) -> bool:
        there = with_ag(setting.demand, asked, setting.base_dir, ag_g / asked.ag_g)
        return there.pga <= share * setting.demand.pga * (1.0 + 1e-12)

    return _search(below, asked.ag_g, 4.0 * WIDEST["ag_g"], falls=True, again=False)[0]


def _search(
    holds: Callable[[float], bool | None], given: float, widest: float, falls: bool, again: bool
) -> tuple[float | None, bool]:
    """(value at which something begins to hold, of what falls with it the last at which it holds, whether it holds at
    all that are accepted); the value is None where it begins nowhere within given times or over widest.

    holds : None for a value that is refused
    again : it must hold a little beyond as well
    """
    step, up = 1.25, not falls

    def fine(value: float) -> bool | None:
        found = holds(value)
        return found and (holds(value * RAISED if up else value / RAISED) if again else True)

    good: float | None = None
    bad: float | None = None
    value, inside, refused = given, bool(fine(given)), True
    last = given / widest if inside == up else given * widest
    while good is None or bad is None:
        found = fine(value)
        if found:
            good = value
        else:
            bad, refused = value, found is None
        if good is None or bad is None:
            if value == last:
                return None, good is not None
            value = max(value / step, last) if inside == up else min(value * step, last)
    while max(good, bad) / min(good, bad) > 1.0 + CLOSE:
        middle = math.sqrt(good * bad)
        found = fine(middle)
        if found:
            good = middle
        else:
            bad, refused = middle, found is None
    return (None, True) if refused else (good, False)
