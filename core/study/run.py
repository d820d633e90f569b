"""The one call that makes results: a case in, a frozen StudyResult out. Window, batch, tests use it."""

import datetime
import hashlib
from collections.abc import Callable
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from core.capacity.accuracy import Accuracy, accuracy
from core.capacity.ida import Ida, Search, incremental_dynamic_analysis, multiplier_of, threshold_of
from core.case.hinges import Part, parts
from core.case.schema import Case
from core.codes.demand import DemandResult, with_records
from core.codes.kinematic import Kinematic, kinematic
from core.codes.record_compatibility import compliance, period_range
from core.ground.ground_motion import GroundMotion
from core.jit import cache
from core.rocking.history import history, scan
from core.rocking.methods import AUTO, METHODS, Method, resolve_auto
from core.study import precompile
from core.study.assessment import assess
from core.study.demand_input import demand_of, generated
from core.study.floors import Floor, floor_of
from core.study.governing import lowest_run
from core.study.journal import Journal, Memory, rebuilt
from core.study.kept_checks import KeptChecks
from core.study.limit_states import StateHistories, demands_of, unsaid, zetas
from core.study.progress import STATEMENT, OnProgress, Progress, check_cost, run_cost
from core.study.record_input import joined, read_records
from core.study.results import Assessment, StudyResult, WallResult
from core.study.threads import Threads
from core.study.tie_design import Hinge, tie_design
from core.study.wall_result import run_result, wall_result, with_variants_alone
from core.study.wall_verdict import wall_verdicts
from core.study.zeta_with import Scene, model_of
from core.version import VERSION
from core.wall.rocking_model import RockingModel


class Entry(NamedTuple):
    """One wall of a study about one hinge, by one mechanism.

    signs : each record is taken with, 1 as recorded, -1 reversed
    floor : it stands on, None on the ground
    felt : the records as they move it
    kinematic : its mechanism, None without a demand and above the ground where the building is not known
    """

    part: Part
    mechanism: str
    model: RockingModel
    signs: tuple[int, ...]
    floor: Floor | None
    felt: list[GroundMotion]
    kinematic: Kinematic | None


class Plan(NamedTuple):
    """What a study does, known before its first analysis.

    demand : without what the records add, None where no check is asked for
    motions : of the ground, with those generated; kinds : of each
    entries : the walls
    """

    case: Case
    demand: DemandResult | None
    motions: list[GroundMotion]
    kinds: list[str]
    method: Method
    search: Search
    entries: list[Entry]

    @property
    def runs(self) -> list[tuple[int, int, int]]:
        """(wall, record, sign) of each search."""
        walls = enumerate(self.entries)
        return [(k, record, sign) for k, one in walls for record in range(len(self.motions)) for sign in one.signs]

    @property
    def longest_period(self) -> float:
        """Of the mechanisms [s], 0 without one."""
        return max((one.kinematic.period or 0.0 for one in self.entries if one.kinematic), default=0.0)


def run(
    case: Case,
    *,
    base_dir: Path,
    jobs: int = 1,
    journal: Callable[[str], Journal | Memory] | None = None,
    on_progress: OnProgress = lambda done, planned, left: None,
    cancelled: Callable[[], bool] = lambda: False,
    on_wall: Callable[[WallResult], None] = lambda wall: None,
) -> StudyResult:
    """Run a study.

    base_dir : folder record paths start from
    jobs : threads, which change no result
    journal : makes the Journal of finished runs from the study's key; on_progress(done, planned, left) and cancelled()
        are called from this thread, the latter from the workers as well
    on_wall : called from this thread with each wall that has its verdict, before what is said of several together
    Raises InputError for what the user can mend, Cancelled when cancelled() is true.
    """
    started = datetime.datetime.now(datetime.UTC)
    cache.proven()
    plan = _plan(case, base_dir)
    models = [entry.model for entry in plan.entries]
    _precompile(plan.method, models, [motion for entry in plan.entries for motion in entry.felt])
    book = journal(f"{VERSION} {cache.source_stamp()}") if journal else None
    progress = Progress(_costs(plan), on_progress)
    demand, rules = plan.demand, None
    try:
        threads = Threads(jobs, cancelled)
        threads.run({k: motion.measure for k, motion in enumerate(plan.motions)}, lambda k, _: None)
        found = _run_all(plan, threads, book, progress)
        if demand:
            demand = with_records(demand, plan.motions)
            rules = compliance(plan.motions, plan.kinds, demand, plan.longest_period)
        results = _results(plan, found, demand)
        if demand:
            kept = [KeptChecks(book) for _ in results]
            results = _assessed(plan, results, demand, rules, kept, threads, progress, on_wall)
            by_state = demands_of(case, base_dir)
            results = _at_limit_states(plan, results, demand, by_state, kept, threads)
            demand = replace(demand, warnings=(*demand.warnings, *unsaid(demand, by_state)))
            results = with_variants_alone(_with_ties(plan, results, demand, kept, threads))
        if case.analysis.accuracy:
            results = _with_accuracy(plan, results, threads, progress)
    finally:
        cache.record(cache.folder())
        if book:
            book.close()
    elapsed = (datetime.datetime.now(datetime.UTC) - started).total_seconds()
    return StudyResult(
        case,
        started.isoformat(timespec="seconds"),
        plan.method,
        plan.search,
        demand,
        tuple(plan.motions),
        tuple(plan.kinds),
        tuple(results),
        rules,
        elapsed,
        wall_verdicts(case, tuple(results)),
    )


def _plan(case: Case, base_dir: Path) -> Plan:
    """Demand, records and walls of a case. Raises InputError, also where the records and the demand do not go
    together: before hours of work, not after. base_dir : as `run` takes it"""
    demand = demand_of(case, base_dir)
    motions, kinds = read_records(case, base_dir)
    made = generated(case, demand) if demand else []
    motions, kinds = joined(motions, made), kinds + ["artificial"] * len(made)
    method = METHODS.get(case.analysis.method, AUTO)
    chosen = case.analysis
    search = Search(chosen.q_step, chosen.q_limit, chosen.map_span, chosen.robust_window)
    hinged = parts(case)
    one_at = {part.wall.base_z_m: part.wall for part in hinged}
    at_height = {z: floor_of(wall, case.building, demand, motions) for z, wall in one_at.items()}
    entries = []
    for part in hinged:
        wall, floor = part.wall, at_height[part.wall.base_z_m]
        for mechanism in wall.mechanisms():
            model, found = model_of(wall, mechanism), None
            if demand and (floor or not wall.above_ground):
                found = kinematic(wall, mechanism, demand, floor.spectrum if floor else None)
            signs, felt = polarities_of(model, chosen.polarity), list(floor.motions) if floor else motions
            entries.append(Entry(part, mechanism, model, signs, floor, felt, found))
    plan = Plan(case, demand, motions, kinds, method, search, entries)
    if demand and demand.target and motions:
        period_range(kinds, plan.longest_period, demand)
    return plan


def _costs(plan: Plan) -> dict[Any, float]:
    """Cost of each task, in samples that the bisections of a search go through."""
    search = plan.search
    costs: dict[Any, float] = {
        (k, record, sign): run_cost(plan.entries[k].felt[record], search) for k, record, sign in plan.runs
    }
    for k, entry in enumerate(plan.entries):
        if plan.demand:
            ties = entry.part.wall.tie_height_m is not None
            costs["check", k] = check_cost(entry.felt, len(entry.signs), entry.floor is not None, ties)
        if plan.case.analysis.accuracy:
            costs["accuracy", k] = STATEMENT * max((run_cost(m, search) for m in entry.felt), default=1.0)
    return costs


def _results(plan: Plan, found: dict, demand: DemandResult | None) -> list[WallResult]:
    """The walls with q, without a check. found : Idas by (wall, record, sign)"""
    results = []
    for k, (part, mechanism, model, signs, floor, felt, _) in enumerate(plan.entries):
        runs = [run_result(model, motion, n, s, found[k, n, s]) for n, motion in enumerate(felt) for s in signs]
        results.append(wall_result(part, mechanism, model, runs, plan.motions, plan.search, demand, floor))
    return results


def _assessed(
    plan: Plan, results: list[WallResult], demand: DemandResult, rules, kept, threads: Threads, progress, on_wall
) -> list[WallResult]:
    """The walls with their checks at the demand.

    rules : Compliance of the records, None without a spectrum
    kept : KeptChecks of each wall
    progress, on_wall : told of each
    """

    def task(k: int, entry: Entry):
        return lambda stop: assess(
            results[k],
            entry.kinematic,
            entry.felt,
            entry.signs,
            demand,
            rules,
            plan.method,
            stop,
            plan.case.demand,
            plan.case.building,
            plan.motions,
            kept[k],
        )

    def checked(k: int, found: Assessment) -> None:
        on_wall(replace(results[k], assessment=found))
        progress.done(("check", k), kept[k].made > 0)

    done = threads.run({k: task(k, entry) for k, entry in enumerate(plan.entries)}, checked)
    return [replace(wall, assessment=done[k]) for k, wall in enumerate(results)]


def _at_limit_states(
    plan: Plan, results: list[WallResult], demand: DemandResult, by_state, kept, threads: Threads
) -> list[WallResult]:
    """The walls with zeta at each limit state of the site.

    by_state : of `demands_of`
    kept : KeptChecks of each wall
    """

    def task(k: int, wall: WallResult):
        felt, signs = plan.entries[k].felt, plan.entries[k].signs
        return lambda stop: zetas(
            wall.wall,
            wall.mechanism,
            by_state,
            plan.case.building,
            StateHistories(wall.model, felt, signs, demand, plan.method, kept[k], stop),
            plan.case.demand.limit_states,
        )

    states = threads.run({k: task(k, wall) for k, wall in enumerate(results)}, lambda k, _: None)
    return [replace(wall, assessment=replace(wall.assessment, states=states[k])) for k, wall in enumerate(results)]


def _with_ties(plan: Plan, results: list[WallResult], demand: DemandResult, kept, threads: Threads) -> list[WallResult]:
    """The walls, the base of each that asks for a tie with its design. kept : KeptChecks of each wall"""
    groups: dict[int, list[int]] = {}
    for k, wall in enumerate(results):
        asked = plan.case.wall[wall.part.origin]
        if asked.tie_height_m is not None and wall.mechanism == "one_sided" and wall.assessment.kinematic:
            groups.setdefault(wall.part.origin, []).append(k)
    # a wall one of whose hinges has no check has no design
    whole = {origin: group for origin, group in groups.items() if results[group[0]].part.hinge == 0.0}

    def task(origin: int, group: list[int]):
        hinges = []
        for k in group:
            wall, entry = results[k], plan.entries[k]
            scene = Scene(
                wall.wall,
                wall.mechanism,
                demand,
                plan.case.building,
                tuple(plan.motions),
                entry.signs,
                plan.method,
                None,
                wall.floor,
                kept[k],
            )
            hinges.append(Hinge(wall.part.hinge, scene, wall.assessment.dynamic))
        return lambda stop: tie_design(hinges, plan.case.wall[origin], stop)

    done = threads.run({origin: task(origin, group) for origin, group in whole.items()}, lambda origin, _: None)
    found = list(results)
    for origin, tie in done.items():
        k = whole[origin][0]
        found[k] = replace(found[k], assessment=replace(found[k].assessment, tie=tie))
    return found


def _with_accuracy(plan: Plan, results: list[WallResult], threads: Threads, progress: Progress) -> list[WallResult]:
    """The walls with the statement on their governing runs."""

    def task(wall: WallResult):
        return lambda stop: accuracy_of(wall, plan.motions, plan.method, plan.search, stop)

    done = threads.run(
        {k: task(wall) for k, wall in enumerate(results)},
        lambda k, found: progress.done(("accuracy", k), found is not None),
    )
    return [replace(wall, accuracy=done[k]) for k, wall in enumerate(results)]


def accuracy_of(wall: WallResult, motions, method, search, cancelled) -> Accuracy | None:
    """The statement on the governing run of a wall; None without a q. motions : of the ground."""
    lowest = lowest_run(wall)
    if lowest is None:
        return None
    motion = (wall.floor.motions if wall.floor else motions)[lowest.motion]
    other = next((r.ida.q for r in wall.runs if r.motion == lowest.motion and r.polarity != lowest.polarity), None)
    return accuracy(motion, lowest.polarity, lowest.ida, other, wall.model, method, search, cancelled)


def warm(case: Case, motion: GroundMotion) -> None:
    """Make the kernels of a case ready: a few analyses of its first wall."""
    cache.proven()
    wall = case.wall[0]
    model = model_of(wall, wall.mechanisms()[0])
    method = METHODS.get(case.analysis.method, AUTO)
    _precompile(method, [model], [motion])
    ground, dt = motion.acceleration, motion.time_step
    scales = np.full(16, multiplier_of(1.1, motion.pga, threshold_of(model)))
    scan(method, ground, dt, scales, model, np.zeros(16, np.int64), np.zeros(16))
    history(ground, dt, scales[0], model, method)


def _precompile(method, models, motions) -> None:
    steps = {motion.time_step for motion in motions}
    precompile.start({resolve_auto(method, model, dt).name for model in models for dt in steps})


def run_key(model: RockingModel, motion: GroundMotion, polarity: int, method, search) -> str:
    """Key of a run in the journal: all that decides its result, and nothing else."""
    parts = (tuple(model), motion.samples_sha256, polarity, method, search)
    return hashlib.sha256(repr(parts).encode()).hexdigest()


def polarities_of(model: RockingModel, asked: str) -> tuple[int, ...]:
    """Signs of the records: one where both do the same to the wall."""
    if model.both_signs_alike or asked == "as_recorded":
        return (1,)
    return (-1,) if asked == "reversed" else (1, -1)


def _run_all(plan: Plan, threads: Threads, book, progress: Progress) -> dict[tuple[int, int, int], Ida]:
    """Idas by (wall, record, sign)."""
    searches, todo, keys = {}, {}, {}

    def search_of(model: RockingModel, motion: GroundMotion, sign: int):
        return lambda stop: incremental_dynamic_analysis(
            motion.acceleration, motion.time_step, motion.pga, sign, model, plan.method, plan.search, stop
        )

    for one in plan.runs:
        k, record, sign = one
        model, motion = plan.entries[k].model, plan.entries[k].felt[record]
        keys[one] = run_key(model, motion, sign, plan.method, plan.search)
        known = rebuilt(Ida, book.get(keys[one])) if book else None
        if known:
            searches[one] = known
        else:
            todo[one] = search_of(model, motion, sign)

    def keep(one, ida: Ida) -> None:
        if book:
            book.add(keys[one], asdict(ida))
        progress.done(one)

    progress.known(searches)
    searches.update(threads.run(todo, keep))
    return searches
