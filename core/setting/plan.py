"""Plan of a study, known before its first analysis: its demand, its motions, and its walls about every hinge."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import groupby
from pathlib import Path

from core.capacity.ida import Search
from core.case.hinges import WallPart, count_wall_parts, make_wall_parts, variant_key
from core.case.register import find_left_out
from core.case.schema import BESIDE, NO_HISTORIES, Case
from core.case.site import Building
from core.case.wall import Wall
from core.codes.demand import SeismicDemand
from core.codes.dynamic_check import run_dynamic_check
from core.codes.floor_spectrum import FloorSpectrum
from core.codes.kinematic import KinematicAnalysis, acceleration_at_rest, analyse_mechanism
from core.codes.record_compatibility import Compliance, period_range
from core.errors import InputError
from core.ground.ground_motion import GroundMotion
from core.known import require_value
from core.packages import MAX_WALLS_IN_WORKBOOK
from core.rocking.methods import AUTO, METHODS, Method
from core.setting.check_input import CheckInput, make_rocking_model, select_polarities
from core.setting.demand_input import generate_motions, read_demand
from core.setting.floors import Floor, make_floor
from core.setting.held_shares import copy_strength, scale_beside, share_out
from core.setting.record_input import join_motions, read_records
from core.setting.record_selection import Selection, select_records
from core.units import G
from core.wall.kinematics import Kinematics, kinematics
from core.wall.rocking_model import RockingModel


@dataclass(frozen=True)
class PlannedWall:
    """One wall of a study about one hinge, by one mechanism.

    signs : each record is taken with, 1 as recorded, -1 reversed
    floor : it stands on, None on the ground
    felt : the records as they move it
    demand : of the case, None without one
    """

    part: WallPart
    mechanism: str
    model: RockingModel
    signs: tuple[int, ...]
    floor: Floor | None
    felt: list[GroundMotion]
    demand: SeismicDemand | None

    @property
    def kinematics(self) -> Kinematics:
        """What its mechanism does."""
        return kinematics(self.mechanism)

    @property
    def _floor_spectrum(self) -> FloorSpectrum | None:
        return self.floor.spectrum if self.floor else None

    @cached_property
    def kinematic(self) -> KinematicAnalysis | None:
        """Its mechanism; None without a demand and above the ground where the building is not known. Raises
        InputError."""
        wall = self.part.wall
        if not self.demand or (wall.above_ground and not self.floor):
            return None
        return analyse_mechanism(wall.in_si, self.mechanism, self.demand, self._floor_spectrum)

    @property
    def push(self) -> float | None:
        """alpha of the demand on what does not vibrate before it moves [-]: the largest push of the clauses and of the
        motions, never divided by q; None where none is known."""
        demand = require_value(self.demand)
        own = acceleration_at_rest(self.part.wall.in_si, demand, self._floor_spectrum)
        pushes = [demand.scaling(motion) * motion.pga for motion in self.felt]
        pushes += [] if own is None else [own]
        return max(pushes) / G if pushes else None


@dataclass(frozen=True)
class Plan:
    """Plan of a study, known before its first analysis.

    demand : without what the records add, None where no check is asked for
    motions : of the ground, with those generated; kinds : of each
    entries : the walls
    longest : period of the mechanisms of all walls [s], where these are a group of more; None else
    """

    case: Case
    demand: SeismicDemand | None
    motions: list[GroundMotion]
    kinds: list[str]
    method: Method
    search: Search
    entries: list[PlannedWall]
    longest: float | None = None

    def scene(
        self,
        k: int,
        demand: SeismicDemand,
        compliance: Compliance | None = None,
        histories: Callable = run_dynamic_check,
    ) -> CheckInput:
        """Scene of the checks of an entry. demand : with what the records add; histories : as of a Scene"""
        entry, asked = self.entries[k], self.case.demand
        assert asked is not None
        return CheckInput(
            entry.part.wall,
            entry.mechanism,
            demand,
            asked,
            self.case.building,
            entry.floor,
            tuple(self.motions),
            compliance,
            self.case.analysis.polarity,
            self.method,
            by_default=self.case.default_histories,
            histories_off=self.case.analysis.histories == NO_HISTORIES,
            beside=self.case.analysis.histories == BESIDE,
            histories=histories,
            left_out=find_left_out(entry.part, self.case.building),
        )

    @property
    def runs(self) -> list[tuple[int, int, int]]:
        """(entry, record, sign) of each search."""
        return [one for k in range(len(self.entries)) for one in self.runs_of(k)]

    def runs_of(self, k: int) -> list[tuple[int, int, int]]:
        """`runs` of one entry; none of motions by default, which are for the check at the demand, nor of
        a wall between transverse walls, whose ends do not push back alike as it returns."""
        if self.case.default_histories:
            return []
        entry = self.entries[k]
        if entry.part.wall.kinematics.arches:
            return []
        return [(k, record, sign) for record in range(len(entry.felt)) for sign in entry.signs]

    @cached_property
    def spans(self) -> list[list[int]]:
        """The entries of each wall of the case, which stand side by side."""
        groups = groupby(range(len(self.entries)), lambda k: self.entries[k].part.origin)
        return [list(group) for _, group in groups]

    @cached_property
    def variants(self) -> set[tuple[tuple[str, float, str], str | None]]:
        """(what it shares with its other variant, which of both it is) of each entry."""
        return {(variant_key(entry.part, entry.mechanism), entry.part.wall.variant) for entry in self.entries}

    @property
    def longest_period(self) -> float:
        """Longest period of the mechanisms [s], 0 without one."""
        if self.longest is not None:
            return self.longest
        counted = (entry for entry in self.entries if not entry.part.wall.kinematics.arches)  # those have no histories
        return max((one.kinematic.period or 0.0 for one in counted if one.kinematic), default=0.0)


Inputs = tuple[SeismicDemand | None, list[GroundMotion], list[str]]
"""Demand, motions and the kind of each."""


def read_inputs(case: Case, base_dir: Path) -> Inputs:
    """Read the demand, the motions and their kinds that a case names. Raises InputError."""
    case, _ = select_case_records(case, base_dir)
    demand = read_demand(case, base_dir)
    motions, kinds = read_records(case, base_dir)
    made = generate_motions(case, demand) if demand else []
    return demand, join_motions(motions, made), kinds + ["artificial"] * len(made)


def select_case_records(
    case: Case,
    base_dir: Path,
    told: Callable[[int, int], None] = lambda done, planned: None,
    cancelled: Callable[[], bool] = lambda: False,
) -> tuple[Case, Selection | None]:
    """The case with the records of its [select] as [[record]], and what was found; itself without a [select].

    told, cancelled : as of `select_records`
    Raises InputError, Cancelled.
    """
    if case.select is None:
        return case, None
    demand = read_demand(case, base_dir)
    assert demand is not None
    selection = select_records(case.select, base_dir, demand, longest_mechanism_period(case, demand), told, cancelled)
    return replace(case, select=None, record=selection.chosen.records), selection


GROUP_SIZE = 128
"""Walls whose mechanisms are looked at together."""


def longest_mechanism_period(case: Case, demand: SeismicDemand) -> float:
    """Longest period of the mechanisms of a case [s], known before its records. Raises InputError."""
    floors, longest = FloorCache(16), 0.0
    for first in range(0, len(case.wall), GROUP_SIZE):
        walls = tuple(case.wall[k] for k in range(first, min(first + GROUP_SIZE, len(case.wall))))
        plan = make_plan(replace(case, wall=walls), (demand, [], []), floors=floors)
        longest = max(longest, plan.longest_period)
    return longest


class FloorCache:
    """The floors that walls at some heights stand on, those asked for last. most : heights kept at a time; None, all"""

    def __init__(self, most: int | None = None):
        self.most, self._known = most, {}

    def of(self, wall: Wall, building: Building | None, demand: SeismicDemand | None, motions) -> Floor | None:
        """The floor of a wall, None on the ground. Raises InputError."""
        z = wall.demand_height_m, wall.bends
        if z not in self._known:
            self._known[z] = make_floor(wall, building, demand, motions)
            if self.most is not None and len(self._known) > self.most:
                del self._known[next(iter(self._known))]
        return self._known[z]


def make_plan(
    case: Case,
    inputs: Inputs,
    share: tuple[int, int] | None = None,
    longest: float | None = None,
    floors: FloorCache | None = None,
    complete: bool = True,
) -> Plan:
    """The walls of a case. Raises InputError where the records and the demand do not go together: before hours of work,
    not after.

    inputs : of `read_inputs`
    share : of the walls only some, as `run` takes it
    longest : of the mechanisms of all walls [s], where the case is a group of more
    floors : where the floors of a building are kept for the next group
    complete : whether the checks of the clauses are made of each wall
    """
    demand, motions, kinds = inputs
    method = METHODS.get(case.analysis.method, AUTO)
    chosen = case.analysis
    search = Search(chosen.q_step, chosen.q_limit, chosen.map_span, chosen.robust_window)
    if share is not None:  # what is said beside the checks is made where the parts come together
        case = replace(case, sensitivity=None, analysis=replace(case.analysis, accuracy=False))
    mine = [k for k in range(len(case.wall)) if share is None or k % share[1] == share[0]]
    hinged = [part for k in mine for part in make_wall_parts(k, case.wall[k], case.building)]
    at_height = FloorCache() if floors is None else floors
    entries = []
    for part in hinged:
        wall, floor = part.wall, at_height.of(part.wall, case.building, demand, motions)
        for mechanism in wall.mechanisms():
            model = make_rocking_model(wall, mechanism)
            signs, felt = select_polarities(model, chosen.polarity), list(floor.motions) if floor else motions
            entries.append(PlannedWall(part, mechanism, model, signs, floor, felt, demand))
    for entry in entries if complete else ():
        entry.kinematic  # noqa: B018 : what it refuses is refused before hours of work
    if demand:
        entries = _share_out_holds(entries, demand, lambda wall: at_height.of(wall, case.building, demand, motions))
    plan = Plan(case, demand, motions, kinds, method, search, entries, longest)
    if demand and demand.target and motions:
        period_range(kinds, plan.longest_period, demand)
    return plan


def _share_out_holds(
    entries: list[PlannedWall], demand: SeismicDemand, floor_of: Callable[[Wall], Floor | None]
) -> list[PlannedWall]:
    """The walls of a study with the holds between two stretches shared out as the demand asks for it; what goes to a
    hold beside the wall below it is moved as the floor at its height is."""
    shared = list(entries)
    for (_, way), group in groupby(range(len(entries)), lambda k: (entries[k].part.origin, entries[k].part.held)):
        outward = [k for k in group if not entries[k].part.inward]
        pushes = {k: push for k in outward if (push := entries[k].push) is not None}
        if not way or len(pushes) < len(outward):
            continue
        stretches = {
            k: scale_beside(entries[k].part.wall, _push_at_hold(entries[k], demand, floor_of) / push)
            for k, push in pushes.items()
        }
        held = [k for k in outward if not entries[k].part.within]
        walls = share_out([stretches[k] for k in held], [pushes[k] for k in held])
        tops = {entries[k].part.top: wall.hold[-1] for k, wall in zip(held, walls, strict=True)}
        feet = {
            entries[k].part.hinge: wall.hold[0] for k, wall in zip(held, walls, strict=True) if wall.hold[0].h_m == 0
        }
        stretches |= dict(zip(held, walls, strict=True))
        for k, wall in stretches.items():
            part = entries[k].part
            if part.within:
                wall = copy_strength(wall, feet.get(part.hinge), tops.get(part.top))
            shared[k] = replace(entries[k], part=replace(part, wall=wall))
    return shared


def _push_at_hold(entry: PlannedWall, demand: SeismicDemand, floor_of: Callable[[Wall], Floor | None]) -> float:
    """alpha of the demand at the hold above a stretch [-], at least that of the stretch."""
    least, base = require_value(entry.push), entry.part.body.base_z_m
    if base is None:
        return least
    floor = floor_of(replace(entry.part.body, base_z_m=base + require_value(entry.part.top)))
    if floor is None:
        return least
    pushes = [floor.spectrum.a_z] if floor.spectrum is not None else []
    pushes += [demand.scaling(motion) * motion.pga for motion in floor.motions]
    return max(least, *(push / G for push in pushes))


def count_results_by_wall(case: Case) -> Iterator[int]:
    """Number of results of each wall of a case: about each hinge, by each mechanism."""
    return (count_wall_parts(wall, case.building) for wall in case.wall)


def count_results(case: Case) -> int:
    """Number of results of a case."""
    return sum(count_results_by_wall(case))


def is_large(case: Case) -> bool:
    """Whether a case has more results than a workbook holds."""
    return count_results(case) > MAX_WALLS_IN_WORKBOOK


def refuse_large(case: Case) -> None:
    """Raise InputError for a case no workbook holds."""
    if is_large(case):
        raise InputError("too_many_walls", found=count_results(case), most=MAX_WALLS_IN_WORKBOOK)
