"""What zeta of a wall becomes when each input moves by its own uncertainty, one at a time."""

import functools
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from core.case.schema import Wall
from core.case.sensitivity import Ranges
from core.case.site import Building
from core.codes.floor_spectrum import estimated_period
from core.codes.kinematic import ROUNDING
from core.codes.record_sample import RecordPeaks, one_left_out
from core.errors import InputError
from core.study.demand_input import with_ag
from core.study.floors import damaged
from core.study.plan import Floors
from core.study.results import WallResult
from core.study.swings import End, Sensitivity, Swing
from core.study.what_if import NONE, Setting, Zetas, with_demand, with_wall, zetas

DAMPINGS = (0.01, 0.30)
"""Dampings of a building that a case accepts."""

Task = Callable[[Callable[[], bool]], Zetas]
"""Of a move: its zeta. Takes what tells it to stop."""


class Move(NamedTuple):
    """An input at one end. key : of the ranges; given, value : of the input, in its unit; task : zeta there"""

    key: str
    given: float | None
    value: float
    task: Task


def moves(setting: Setting, ranges: Ranges) -> list[Move]:
    """What is moved of a wall; the first is the wall as it is. setting : of `setting_of`"""
    known = Floors()

    def task(change: Callable[[Setting], Setting], of_theory: float | None = None) -> Task:
        def found(stop: Callable[[], bool]) -> Zetas:
            try:
                moved = change(setting)
                same = moved.case.building == setting.case.building and moved.inputs is setting.inputs
                return zetas(moved, of_theory=of_theory, floors=known if same else None, cancelled=stop)
            except InputError:  # it does not stand, or its spectrum ends before its period
                return NONE

        return found

    found = [Move("", None, 0.0, task(lambda now: now))]
    for key, given, ends in (*_of_wall(setting, ranges), *_of_building(setting, ranges)):
        found += [Move(key, given, value, task(change)) for value, change in ends]
    if setting.inputs[1] and not setting.case.wall[0].bends:
        key = "velocity_ratio_factor"
        found += [Move(key, None, factor, task(lambda now: now, factor)) for factor in ranges.velocity_ratio_factor]
    return found


Ends = list[tuple[float, Callable[[Setting], Setting]]]
"""(value of an input there, what changes the setting) of each end."""


def _of_wall(setting: Setting, ranges: Ranges) -> Iterator[tuple[str, float | None, Ends]]:
    """(key, value given, ends) of the inputs of a wall."""
    wall = setting.case.wall[0]

    def ends(values: Sequence[float], change: Callable[[float], Wall]) -> Ends:
        return [(value, functools.partial(_with, change(value))) for value in values]

    if (given := wall.thickness) is not None and not wall.solid:
        values = [factor * given for factor in _others(ranges.thickness_factor)]
        yield "thickness_factor", given, ends(values, lambda value: thinner(wall, value))
    if (given := wall.unit_weight_kn_m3) is not None:
        values = [factor * given for factor in _others(ranges.unit_weight_factor)]
        yield "unit_weight_factor", given, ends(values, lambda value: replace(wall, unit_weight_kn_m3=value))
    if any(not load.is_tie for load in wall.load):
        yield "load_factor", 1.0, ends(_others(ranges.load_factor), lambda factor: loaded(wall, factor))
    if wall.thickness is not None:
        values = [wall.setback + share * wall.thickness for share in ranges.setback_shares if share]
        yield "setback_shares", wall.setback, ends(values, lambda value: set_back(wall, value))
    if (given := wall.elastic_modulus_mpa) is not None:
        values = [factor * given for factor in _others(ranges.modulus_factor)]
        yield "modulus_factor", given, ends(values, lambda value: replace(wall, elastic_modulus_mpa=value))


def _with(wall: Wall, setting: Setting) -> Setting:
    return with_wall(setting, wall)


def _on(building: Building, setting: Setting) -> Setting:
    return replace(setting, case=replace(setting.case, building=building))


def _others(factors: tuple[float, float]) -> list[float]:
    """The ends that are not the value itself."""
    return [factor for factor in factors if factor != 1.0]


def thinner(wall: Wall, thickness: float) -> Wall:
    """A wall of another thickness [m]; its loads keep their share of it."""
    assert wall.thickness is not None
    share = thickness / wall.thickness
    loads = tuple(load if load.d_m is None else replace(load, d_m=share * load.d_m) for load in wall.load)
    return replace(wall, thickness_m=thickness, slenderness_deg=None, height_over_thickness=None, load=loads)


def loaded(wall: Wall, factor: float) -> Wall:
    """A wall whose loads but ties are so many times as large."""
    loads = (load if load.is_tie or load.kn_m is None else replace(load, kn_m=factor * load.kn_m) for load in wall.load)
    return replace(wall, load=tuple(loads))


def set_back(wall: Wall, setback: float) -> Wall:
    """A wall with another hinge setback [m], whatever gave it."""
    return replace(wall, hinge_setback_m=setback, compressive_strength_mpa=None)


def _of_building(setting: Setting, ranges: Ranges) -> Iterator[tuple[str, float | None, Ends]]:
    """The same of the building under a wall: its period and its damping."""
    building = setting.case.building
    if building is None or not setting.case.wall[0].above_ground:
        return
    first = building.modes[0].period_s if building.modes else building.period_s or estimated_period(building.height_m)
    damping = building.modes[0].damping if building.modes else damaged(building, setting.demand.limit_state)[1]

    def ends(values: Sequence[float], change: Callable[[float], Building]) -> Ends:
        return [(value, functools.partial(_on, change(value))) for value in values]

    def slower(period: float) -> Building:
        if not building.modes:
            return replace(building, period_s=period)
        return replace(building, modes=tuple(replace(m, period_s=m.period_s * period / first) for m in building.modes))

    def damped(value: float) -> Building:
        if not building.modes:
            return replace(building, damping=value)
        moved = (replace(m, damping=float(np.clip(m.damping * value / damping, *DAMPINGS))) for m in building.modes)
        return replace(building, modes=tuple(moved))

    periods = [factor * first for factor in _others(ranges.building_period_factor)]
    yield "building_period_factor", first, ends(periods, slower)
    dampings = [float(np.clip(factor * damping, *DAMPINGS)) for factor in _others(ranges.building_damping_factor)]
    yield "building_damping_factor", damping, ends([value for value in dampings if value != damping], damped)


def sensitivity_of(
    setting: Setting,
    ranges: Ranges,
    made: Sequence[Move],
    found: Mapping[int, Zetas],
    hinges: Sequence[WallResult],
    peaks: Sequence[RecordPeaks],
) -> Sensitivity:
    """The sensitivity of one wall.

    made : of `moves`; found : what the task of each, by its place, gave
    hinges : results of all its hinges and mechanisms
    peaks : of those with histories, for the records left out
    """
    target, base = setting.demand.zeta_target, found[0]
    swings: dict[str, Swing] = {}
    for k, (key, given, value, _) in enumerate(made):
        if key:
            known = swings.setdefault(key, Swing(key, given, ()))
            swings[key] = replace(known, ends=(*known.ends, End(value, found[k].zeta, found[k].sure)))
    swings["ag_factor"] = _of_ag(setting, ranges, base)
    if ranges.restraint_lost and (lost := _restraint_lost(hinges, target)) is not None:
        swings["restraint_lost"] = Swing("restraint_lost", None, (lost,))
    if ranges.record_left_out and peaks:
        names = [motion.name for motion in setting.inputs[1]]
        swings["record_left_out"] = Swing("record_left_out", None, _left_out(peaks, names, target))
    moving = [one for one in swings.values() if any(_differs(end.zeta, base.zeta) for end in one.ends)]
    satisfied = all(_satisfied(one) for one in hinges)
    return Sensitivity(
        base.zeta,
        tuple(sorted(moving, key=lambda one: -one.width(base.zeta))),
        tuple(key for key, one in swings.items() if one not in moving),
        tuple(one.key for one in moving if satisfied and not all(end.sure for end in one.ends)),
    )


def _of_ag(setting: Setting, ranges: Ranges, base: Zetas) -> Swing:
    """a_g moves the histories in proportion; the checks of the clauses follow the spectrum."""
    asked, demand = setting.case.demand, setting.demand
    assert asked is not None
    ends = []
    for factor in _others(ranges.ag_factor):
        there = with_ag(demand, asked, setting.base_dir, factor)
        share = there.pga / demand.pga
        if setting.has_histories:
            zeta = None if base.zeta is None else base.zeta / share
            sure = base.low is not None and base.low / share >= demand.zeta_target - ROUNDING
        else:
            moved = zetas(with_demand(setting, there))
            zeta, sure = moved.zeta, moved.sure
        ends.append(End(factor * asked.ag_g, zeta, sure))
    return Swing("ag_factor", asked.ag_g, tuple(ends))


def _satisfied(hinge: WallResult) -> bool:
    """Whether the check that decides about a hinge is surely satisfied."""
    found = hinge.assessment
    assert found is not None
    target = found.verdict.zeta_target
    if found.dynamic is not None:
        return found.dynamic.passed and not found.dynamic.within_spread(target)
    return found.verdict.zeta_e is not None and found.verdict.zeta_e >= target - ROUNDING


def _differs(zeta: float | None, base: float | None) -> bool:
    if zeta is None or base is None:
        return zeta is not base
    return not math.isclose(zeta, base, rel_tol=1e-9)


def _restraint_lost(hinges: Sequence[WallResult], target: float) -> End | None:
    """The wall where nothing holds it from behind, or at its top; None where nothing does now."""
    found, sure = [], True
    for one in hinges:
        known = one.assessment
        assert known is not None
        bound = known.verdict.lower_bound
        found.append(known.verdict.zeta_e if bound is None else bound)
        sure &= known.lower_bound is None or known.lower_bound.passed
    if all(one.assessment.verdict.lower_bound is None for one in hinges if one.assessment):
        return None
    zeta = None if None in found else min(found)
    return End(None, zeta, sure and zeta is not None and zeta >= target - ROUNDING)


def _left_out(peaks: Sequence[RecordPeaks], names: Sequence[str], target: float) -> tuple[End, ...]:
    """Without the record that lowers zeta most, and without the one that raises it most."""
    without = np.min([one_left_out(one) for one in peaks], axis=0)
    ends = []
    for k in dict.fromkeys((int(without.argmin()), int(without.argmax()))):
        zeta = float(without[k]) if math.isfinite(without[k]) else None
        ends.append(End(None, zeta, zeta is not None and zeta >= target - ROUNDING, names[k]))
    return tuple(ends)
