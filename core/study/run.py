"""The one call that makes results: a case in, a frozen StudyResult out. Window, batch, tests use it."""

import datetime
import hashlib
from collections.abc import Callable
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import numpy as np

from core.capacity.accuracy import Accuracy, accuracy
from core.capacity.ida import Ida, Search, incremental_dynamic_analysis, multiplier_of, threshold_of
from core.case.hinges import parts
from core.case.schema import Case, Wall
from core.codes.demand import with_records
from core.codes.kinematic import kinematic
from core.codes.record_compatibility import compliance, period_range
from core.ground.ground_motion import GroundMotion
from core.jit import cache
from core.rocking.history import history, scan
from core.rocking.methods import AUTO, METHODS, resolve_auto
from core.study import precompile
from core.study.assessment import assess
from core.study.demand_input import demand_of, generated
from core.study.floors import floor_of
from core.study.governing import lowest_run
from core.study.journal import Journal, Memory, rebuilt
from core.study.kept_checks import KeptChecks
from core.study.limit_states import StateHistories, demands_of, unsaid, zetas
from core.study.progress import STATEMENT, OnProgress, Progress, check_cost, run_cost
from core.study.record_input import joined, read_records
from core.study.results import Assessment, StudyResult, WallResult
from core.study.threads import Threads
from core.study.wall_result import run_result, wall_result, with_governing_tie, with_variants_alone
from core.study.wall_verdict import wall_verdicts
from core.version import VERSION
from core.wall.rocking_model import RockingModel, rocking_model


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
    demand = demand_of(case, base_dir)
    motions, kinds = read_records(case, base_dir)
    made = generated(case, demand) if demand else []
    motions, kinds = joined(motions, made), kinds + ["artificial"] * len(made)
    method = METHODS.get(case.analysis.method, AUTO)
    chosen = case.analysis
    search = Search(chosen.q_step, chosen.q_limit, chosen.map_span, chosen.robust_window)
    hinged = parts(case)
    entries = [(part, mechanism) for part in hinged for mechanism in part.wall.mechanisms()]
    walls = [(part.wall, mechanism) for part, mechanism in entries]
    models = [_model(wall, mechanism) for wall, mechanism in walls]
    signs = [polarities_of(model, chosen.polarity) for model in models]
    planned = [
        (index, record, polarity)
        for index in range(len(walls))
        for record in range(len(motions))
        for polarity in signs[index]
    ]
    one_at = {wall.base_z_m: wall for wall, _ in walls}
    at_height = {z: floor_of(wall, case.building, demand, motions) for z, wall in one_at.items()}
    floors = [at_height[wall.base_z_m] for wall, _ in walls]
    felt = [list(floor.motions) if floor else motions for floor in floors]
    mechanisms = [
        kinematic(wall, mechanism, demand, floor.spectrum if floor else None)
        if demand and (floor or not wall.above_ground)
        else None
        for (wall, mechanism), floor in zip(walls, floors, strict=True)
    ]
    longest = max((found.period or 0.0 for found in mechanisms if found), default=0.0)
    if demand and demand.target and motions:
        period_range(kinds, longest, demand)  # refused before hours of work, not after
    _precompile(method, models, [motion for moved in felt for motion in moved])
    book = journal(f"{VERSION} {cache.source_stamp()}") if journal else None
    costs: dict[Any, float] = {entry: run_cost(felt[entry[0]][entry[1]], search) for entry in planned}
    for k, (wall, _) in enumerate(walls):
        if demand:
            ties = wall.tie_height_m is not None
            costs["check", k] = check_cost(felt[k], len(signs[k]), floors[k] is not None, ties)
        if chosen.accuracy:
            costs["accuracy", k] = STATEMENT * max((run_cost(m, search) for m in felt[k]), default=1.0)
    progress = Progress(costs, on_progress)
    try:
        threads = Threads(jobs, cancelled)
        threads.run({k: motion.measure for k, motion in enumerate(motions)}, lambda k, _: None)
        found = _run_all(planned, models, felt, method, search, threads, book, progress)
        if demand:
            demand = with_records(demand, motions)
        rules = compliance(motions, kinds, demand, longest) if demand else None
        by_wall: dict[int, list] = {}
        for entry in planned:
            wall, number, polarity = entry
            one = run_result(models[wall], felt[wall][number], number, polarity, found[entry])
            by_wall.setdefault(wall, []).append(one)
        results = [
            wall_result(part, mechanism, models[k], by_wall.get(k, []), motions, search, demand, floors[k])
            for k, (part, mechanism) in enumerate(entries)
        ]
        if demand:
            kept = [KeptChecks(book) for _ in walls]

            def checked(k: int, found: Assessment) -> None:
                on_wall(replace(results[k], assessment=found))
                progress.done(("check", k), kept[k].made > 0)

            checks = {
                k: lambda stop, k=k: assess(
                    results[k],
                    mechanisms[k],
                    felt[k],
                    signs[k],
                    demand,
                    rules,
                    method,
                    stop,
                    case.demand,
                    case.building,
                    motions,
                    kept[k],
                )
                for k in range(len(walls))
            }
            done = threads.run(checks, checked)
            by_state = demands_of(case, base_dir)
            states = {
                k: lambda stop, k=k, wall=wall: zetas(
                    wall.wall,
                    wall.mechanism,
                    by_state,
                    case.building,
                    StateHistories(wall.model, felt[k], signs[k], demand, method, kept[k], stop),
                    case.demand.limit_states,
                )
                for k, wall in enumerate(results)
            }
            outcomes = threads.run(states, lambda k, _: None)
            results = [replace(wall, assessment=replace(done[k], states=outcomes[k])) for k, wall in enumerate(results)]
            demand = replace(demand, warnings=(*demand.warnings, *unsaid(demand, by_state)))
            results = with_variants_alone(with_governing_tie(results))
        if chosen.accuracy:
            statements = {
                k: lambda stop, wall=wall: accuracy_of(wall, motions, method, search, stop)
                for k, wall in enumerate(results)
            }
            done = threads.run(statements, lambda k, found: progress.done(("accuracy", k), found is not None))
            results = [replace(wall, accuracy=done[k]) for k, wall in enumerate(results)]
    finally:
        cache.record(cache.folder())
        if book:
            book.close()
    elapsed = (datetime.datetime.now(datetime.UTC) - started).total_seconds()
    return StudyResult(
        case,
        started.isoformat(timespec="seconds"),
        method,
        search,
        demand,
        tuple(motions),
        tuple(kinds),
        tuple(results),
        rules,
        elapsed,
        wall_verdicts(case, tuple(results)),
    )


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
    model = _model(wall, wall.mechanisms()[0])
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


def _model(wall: Wall, mechanism: str) -> RockingModel:
    one_sided = mechanism == "one_sided"
    return rocking_model(wall.block(), one_sided, wall.restitution_of(mechanism), wall.moment_law(), wall.restoring())


def _run_all(planned, models, felt, method, search, threads, book, progress: Progress):
    """Idas by (wall, record, polarity). felt : motions of each wall."""
    searches, todo, keys = {}, {}, {}

    def search_of(entry):
        wall, record, polarity = entry
        motion = felt[wall][record]
        return lambda stop: incremental_dynamic_analysis(
            motion.acceleration, motion.time_step, motion.pga, polarity, models[wall], method, search, stop
        )

    for entry in planned:
        wall, record, polarity = entry
        keys[entry] = run_key(models[wall], felt[wall][record], polarity, method, search)
        known = rebuilt(Ida, book.get(keys[entry])) if book else None
        if known:
            searches[entry] = known
        else:
            todo[entry] = search_of(entry)

    def keep(entry, ida: Ida) -> None:
        if book:
            book.add(keys[entry], asdict(ida))
        progress.done(entry)

    progress.known(searches)
    searches.update(threads.run(todo, keep))
    return searches
