"""Sensitivity of zeta of a wall: each input moves by its own uncertainty, one at a time."""

import functools
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from core.case.hinges import make_wall_parts
from core.case.sensitivity import Ranges
from core.case.site import Building
from core.case.wall import Wall
from core.codes.floor_spectrum import estimated_period
from core.codes.outcomes import OUTCOMES, PASSES, min_if_all_known
from core.codes.record_sample import RecordPeaks, leave_one_out_zetas
from core.errors import InputError
from core.known import require_value
from core.setting.demand_input import rescale_ag
from core.setting.floors import damaged_period_and_damping
from core.setting.plan import FloorCache
from core.variation.assessment import Assessment
from core.variation.changes import replace_setback, rescale_thickness, scale_loads, scale_theory_ratio
from core.variation.swings import Sensitivity, Swing, SwingEnd
from core.variation.wall_evaluation import (
    NO_EVALUATION,
    WallContext,
    WallEvaluation,
    drop_record,
    evaluate_wall,
    replace_demand,
    replace_wall,
)

DAMPINGS = (0.01, 0.30)
"""Dampings of a building that a case accepts."""

DEFAULT_HEIGHT = 3.0
"""Height [m] for which the default of [sensitivity] leans by 2 cm."""

FALLS_AT_REST = "unstable_under_loads", "arch_unstable", "bending_unstable"
"""Errors of a wall that falls without an earthquake, or pushes away what holds it: it has no zeta. What is refused for
another reason is not moved."""

Change = Callable[[WallContext], WallContext]


class InputMove(NamedTuple):
    """An input at one end. key : of the ranges; given, value : of the input, in its unit; change : to that end"""

    key: str
    given: float | None
    value: float
    change: Change


def evaluate_move(
    setting: WallContext, move: InputMove, floors: FloorCache, stop: Callable[[], bool]
) -> WallEvaluation | InputError:
    """The wall at the end of a move, as the run of the moved case says, or why there is none.

    floors : of the setting, kept for the next move; stop : tells it to
    """
    try:
        there = move.change(setting)
        same = there.case.building == setting.case.building and there.inputs is setting.inputs
        return evaluate_wall(there, floors=floors if same else None, cancelled=stop)
    except InputError as error:
        return NO_EVALUATION if error.code in FALLS_AT_REST else error


def list_input_moves(setting: WallContext, ranges: Ranges) -> list[InputMove]:
    """Moves of the inputs of a wall. setting : of `make_wall_context`"""
    moved = (*_of_wall(setting, ranges), *_of_building(setting, ranges), *_of_demand(setting, ranges))
    return [InputMove(key, given, value, change) for key, given, ends in moved for value, change in ends]


def leave_one_out_moves(peaks: Sequence[RecordPeaks]) -> list[InputMove]:
    """The wall without the record that lowers zeta most, and without the one that raises it most: their places are the
    values. peaks : of all its hinges"""
    top = [peak.multipliers[-1] for peak in peaks]
    without = np.array([np.minimum(leave_one_out_zetas(one), last) for one, last in zip(peaks, top, strict=True)]).min(
        axis=0
    )

    def change(k: int) -> Change:
        return lambda now: drop_record(now, k)

    places = dict.fromkeys((int(without.argmin()), int(without.argmax())))
    return [InputMove("record_left_out", None, float(k), change(k)) for k in places]


Ends = list[tuple[float, Change]]
"""(value of an input there, what changes the setting) of each end."""


def _of_wall(setting: WallContext, ranges: Ranges) -> Iterator[tuple[str, float | None, Ends]]:
    """(key, value given, ends) of the inputs of a wall."""
    wall = setting.case.wall[0]

    def ends(values: Sequence[float], change: Callable[[float], Wall]) -> Ends:
        return [(value, functools.partial(_with, change(value))) for value in values]

    if (given := wall.thickness) is not None and not wall.solid:
        values = [factor * given for factor in _others(ranges.thickness_factor)]
        yield "thickness_factor", given, ends(values, lambda value: rescale_thickness(wall, value))
    if (given := wall.unit_weight_kn_m3) is not None:
        values = [factor * given for factor in _others(ranges.unit_weight_factor)]
        yield "unit_weight_factor", given, ends(values, lambda value: replace(wall, unit_weight_kn_m3=value))
    if wall.load:
        yield "load_factor", 1.0, ends(_others(ranges.load_factor), lambda factor: scale_loads(wall, factor))
    if wall.thickness is not None:
        values = [wall.setback + added for added in ranges.setback_m if added]
        yield "setback_m", wall.setback, ends(values, lambda value: replace_setback(wall, value))
    if _may_lean(wall):
        given, storeys = wall.out_of_plumb_m or 0.0, max(1.0, require_value(wall.height_m) / DEFAULT_HEIGHT)
        values = [given + storeys * added for added in ranges.out_of_plumb_m if added]
        yield "out_of_plumb_m", given, ends(values, lambda value: replace(wall, out_of_plumb_m=value))
    if (given := wall.elastic_modulus_mpa) is not None:
        values = [factor * given for factor in _others(ranges.modulus_factor)]
        yield "modulus_factor", given, ends(values, lambda value: replace(wall, elastic_modulus_mpa=value))
    if setting.has_histories:
        factors = list(ranges.velocity_ratio_factor)
        yield "velocity_ratio_factor", None, ends(factors, lambda factor: scale_theory_ratio(wall, factor))


def _may_lean(wall: Wall) -> bool:
    """Whether a wall may be moved out of plumb: of a body by its solids, and of one held at its top, none is known."""
    sizes = wall.height_m, wall.thickness, wall.length_m, wall.unit_weight_kn_m3
    shaped = wall.solid or wall.gable_m or wall.openings or wall.return_wedges or wall.corner or wall.return_walls
    return not (shaped or wall.bends or None in sizes)


def _with(wall: Wall, setting: WallContext) -> WallContext:
    return replace_wall(setting, wall)


def _on(building: Building, setting: WallContext) -> WallContext:
    return replace(setting, case=replace(setting.case, building=building))


def _others(factors: tuple[float, float]) -> list[float]:
    """The ends that are not the value itself."""
    return [factor for factor in factors if factor != 1.0]


def _of_building(setting: WallContext, ranges: Ranges) -> Iterator[tuple[str, float | None, Ends]]:
    """Moves of the building under a wall, as `_of_wall`: of its period and its damping."""
    building, wall = setting.case.building, setting.case.wall[0]
    if building is None or not any(part.wall.above_ground for part in make_wall_parts(0, wall, building)):
        return
    first = building.modes[0].period_s if building.modes else building.period_s or estimated_period(building.height_m)
    damping = (
        building.modes[0].damping
        if building.modes
        else damaged_period_and_damping(building, setting.demand.limit_state)[1]
    )

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


def _of_demand(setting: WallContext, ranges: Ranges) -> Iterator[tuple[str, float | None, Ends]]:
    """Moves of a_g on rock, as `_of_wall`: records that are used as given follow it, and so does S."""
    asked, demand = setting.case.demand, setting.demand
    assert asked is not None

    def scaled_by(factor: float) -> Change:
        return lambda now: replace_demand(now, rescale_ag(demand, asked, now.base_dir, factor))

    yield "ag_factor", asked.ag_g, [(factor * asked.ag_g, scaled_by(factor)) for factor in _others(ranges.ag_factor)]


def summarise_sensitivity(
    setting: WallContext,
    ranges: Ranges,
    made: Sequence[InputMove],
    walls: Sequence[WallEvaluation | InputError],
    hinges: Sequence[Assessment],
) -> Sensitivity:
    """The sensitivity of one wall.

    made : of `list_input_moves` and `leave_one_out_moves`; walls : what the task of each gave
    hinges : of all its hinges and mechanisms
    """
    base = min_if_all_known(hinge.verdict.zeta_e for hinge in hinges)
    if base is None:
        return Sensitivity(None, (), (), ())
    names = [motion.name for motion in setting.inputs[1]]
    swings: dict[str, Swing] = {}
    refused: dict[str, InputError] = {}
    for move, there in zip(made, walls, strict=True):
        if isinstance(there, InputError):
            refused.setdefault(move.key, there)
            continue
        left_out = move.key == "record_left_out"
        name = names[int(move.value)] if left_out else ""
        end = SwingEnd(None if left_out else move.value, there.zeta, there.sure, name)
        known = swings.setdefault(move.key, Swing(move.key, move.given, ()))
        swings[move.key] = replace(known, ends=(*known.ends, end))
    if ranges.restraint_lost and (lost := _restraint_lost(hinges)) is not None:
        swings["restraint_lost"] = Swing("restraint_lost", None, (lost,))
    moving = [swing for swing in swings.values() if any(_differs(e.zeta, base) for e in swing.ends)]
    satisfied = all(OUTCOMES[hinge.verdict.code].judgement == PASSES for hinge in hinges)
    return Sensitivity(
        base,
        tuple(sorted(moving, key=lambda one: -one.width(base))),
        tuple(key for key, one in swings.items() if one not in moving),
        tuple(one.key for one in moving if satisfied and not all(e.sure for e in one.ends)),
        refused=tuple(refused.items()),
    )


def _differs(zeta: float | None, base: float | None) -> bool:
    if zeta is None or base is None:
        return zeta is not base
    return not math.isclose(zeta, base, rel_tol=1e-9)


def _restraint_lost(hinges: Sequence[Assessment]) -> SwingEnd | None:
    """The wall where nothing holds it from behind, or at its top; None where nothing does now."""
    if all(hinge.verdict.lower_bound is None for hinge in hinges):
        return None
    zeta = min_if_all_known(
        hinge.verdict.zeta_e if (bound := hinge.verdict.lower_bound) is None else bound for hinge in hinges
    )
    passing = [
        OUTCOMES[hinge.verdict.code].judgement == PASSES if hinge.bound_passes is None else hinge.bound_passes
        for hinge in hinges
    ]
    return SwingEnd(None, zeta, all(passing))
