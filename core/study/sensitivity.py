"""What zeta of a wall becomes when each input moves by its own uncertainty, one at a time."""

import functools
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from core.case.hinges import parts_of
from core.case.schema import Wall
from core.case.sensitivity import Ranges
from core.case.site import Building
from core.codes.floor_spectrum import estimated_period
from core.codes.kinematic import ROUNDING
from core.codes.record_sample import RecordPeaks, one_left_out, zeta_of_sets
from core.codes.verdict import Verdict
from core.errors import InputError
from core.study.demand_input import with_ag
from core.study.floors import damaged
from core.study.plan import Floors
from core.study.results import WallResult
from core.study.swings import End, Sensitivity, Swing
from core.study.what_if import NONE, Setting, Zetas, lowest, with_demand, with_wall, zetas

DAMPINGS = (0.01, 0.30)
"""Dampings of a building that a case accepts."""

FALLS = "unstable_under_loads"
"""Error of a wall that falls without an earthquake: it has no zeta. What is refused for another reason is not moved."""

Task = Callable[[Callable[[], bool]], Zetas | InputError]
"""Of a move: its zeta, or why there is none. Takes what tells it to stop."""


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
        def found(stop: Callable[[], bool]) -> Zetas | InputError:
            try:
                moved = change(setting)
                same = moved.case.building == setting.case.building and moved.inputs is setting.inputs
                return zetas(moved, of_theory=of_theory, floors=known if same else None, cancelled=stop)
            except InputError as error:
                return NONE if error.code == FALLS else error

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
    """A wall of another thickness [m]; its loads keep their share of it, and so do its steps."""
    assert wall.thickness is not None
    share = thickness / wall.thickness
    steps = tuple(replace(step, thickness_m=share * step.thickness_m) for step in wall.steps)
    loads = tuple(load if load.d_m is None else replace(load, d_m=share * load.d_m) for load in wall.load)
    return replace(
        wall, thickness_m=thickness, slenderness_deg=None, height_over_thickness=None, load=loads, steps=steps
    )


def loaded(wall: Wall, factor: float) -> Wall:
    """A wall whose loads but ties are so many times as large."""
    loads = (load if load.is_tie or load.kn_m is None else replace(load, kn_m=factor * load.kn_m) for load in wall.load)
    return replace(wall, load=tuple(loads))


def set_back(wall: Wall, setback: float) -> Wall:
    """A wall with another hinge setback [m]; where a strength gives it, with the strength that gives this one, so that
    it follows the weight above each hinge."""
    if wall.compressive_strength_mpa is None:
        return replace(wall, hinge_setback_m=setback)
    return replace(wall, compressive_strength_mpa=wall.compressive_strength_mpa * wall.setback / setback)


def _of_building(setting: Setting, ranges: Ranges) -> Iterator[tuple[str, float | None, Ends]]:
    """The same of the building under a wall: its period and its damping."""
    building, wall = setting.case.building, setting.case.wall[0]
    if building is None or not any(part.wall.above_ground for part in parts_of(0, wall, building)):
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
    found: Mapping[int, Zetas | InputError],
    hinges: Sequence[WallResult],
    peaks: Sequence[RecordPeaks],
) -> Sensitivity:
    """The sensitivity of one wall. Its base is zeta of the run; the ends, found on a coarser grid, are in proportion.

    made : of `moves`; found : what the task of each, by its place, gave
    hinges : results of all its hinges and mechanisms
    peaks : of those with histories, for the records left out
    """
    target, coarse = setting.demand.zeta_target, found[0]
    assert isinstance(coarse, Zetas)
    base = lowest([_verdict(one).zeta_e for one in hinges])
    if base is None or coarse.zeta is None:
        return Sensitivity(None, (), (), ())
    share = base / coarse.zeta

    def end(value: float | None, there: Zetas, name: str = "") -> End:
        zeta = None if there.zeta is None else share * there.zeta
        return End(value, zeta, there.sure and zeta is not None and zeta >= target - ROUNDING, name)

    swings: dict[str, Swing] = {}
    refused: dict[str, InputError] = {}
    for k, (key, given, value, _) in enumerate(made):
        there = found[k]
        if isinstance(there, InputError):
            refused.setdefault(key, there)
        elif key:
            known = swings.setdefault(key, Swing(key, given, ()))
            swings[key] = replace(known, ends=(*known.ends, end(value, there)))
    swings["ag_factor"] = _of_ag(setting, ranges, base, coarse, end)
    if ranges.restraint_lost and (lost := _restraint_lost(hinges, target)) is not None:
        swings["restraint_lost"] = Swing("restraint_lost", None, (lost,))
    names = [motion.name for motion in setting.inputs[1]]
    if ranges.record_left_out and len(peaks) == len(hinges) and len(names) > 1:
        swings["record_left_out"] = Swing("record_left_out", None, _left_out(peaks, names, base, target))
    moving = [one for one in swings.values() if any(_differs(e.zeta, base) for e in one.ends)]
    satisfied = all(_satisfied(one) for one in hinges)
    return Sensitivity(
        base,
        tuple(sorted(moving, key=lambda one: -one.width(base))),
        tuple(key for key, one in swings.items() if one not in moving),
        tuple(one.key for one in moving if satisfied and not all(e.sure for e in one.ends)),
        refused=tuple(refused.items()),
    )


def _verdict(hinge: WallResult) -> Verdict:
    assert hinge.assessment is not None
    return hinge.assessment.verdict


def _of_ag(
    setting: Setting, ranges: Ranges, base: float, coarse: Zetas, end: Callable[[float | None, Zetas], End]
) -> Swing:
    """a_g moves the histories in proportion; the checks of the clauses follow the spectrum. end : of what is found"""
    asked, demand = setting.case.demand, setting.demand
    assert asked is not None
    ends = []
    for factor in _others(ranges.ag_factor):
        there = with_ag(demand, asked, setting.base_dir, factor)
        share = demand.pga / there.pga
        if setting.has_histories:
            low = None if coarse.low is None else share * coarse.low
            sure = low is not None and low >= demand.zeta_target - ROUNDING
            ends.append(End(factor * asked.ag_g, share * base, sure and share * base >= demand.zeta_target - ROUNDING))
        else:
            ends.append(end(factor * asked.ag_g, zetas(with_demand(setting, there))))
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


def _left_out(peaks: Sequence[RecordPeaks], names: Sequence[str], base: float, target: float) -> tuple[End, ...]:
    """Without the record that lowers zeta most, and without the one that raises it most; in proportion to the base, of
    the whole set. Where the rule holds at every multiplier known it is the last of them."""
    every = np.array([zeta_of_sets(one, np.ones((1, len(names)), np.int64))[0] for one in peaks])
    top = np.array([one.multipliers[-1] for one in peaks])
    without = np.array([np.minimum(one_left_out(one), last) for one, last in zip(peaks, top, strict=True)]).min(axis=0)
    whole = float(np.minimum(every, top).min())
    ends = []
    for k in dict.fromkeys((int(without.argmin()), int(without.argmax()))):
        zeta = base * float(without[k]) / whole
        ends.append(End(None, zeta, zeta >= target - ROUNDING, names[k]))
    return tuple(ends)
