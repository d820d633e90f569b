"""The one call that makes results: a case in, a frozen StudyResult out. Window, batch, tests use it."""

import contextlib
import datetime
import sys
from collections.abc import Callable, Iterable
from concurrent.futures import BrokenExecutor, Executor, Future, wait
from dataclasses import asdict, replace
from pathlib import Path

import numpy as np

from core.capacity.accuracy import Accuracy, accuracy
from core.capacity.ida import Ida, Run, incremental_dynamic_analyses, multiplier_of, threshold_of
from core.case.place import notices
from core.case.schema import Case
from core.codes.demand import DemandResult, with_records
from core.codes.record_compatibility import Compliance, compliance
from core.errors import Cancelled, InputError
from core.ground.ground_motion import GroundMotion
from core.jit import cache
from core.rocking.history import history, in_lanes, scan
from core.rocking.methods import AUTO, METHODS, resolve_auto
from core.study import precompile
from core.study.assessment import assess
from core.study.governing import lowest_run
from core.study.how_sure import with_certainty
from core.study.journal import Journal, Memory, rebuilt
from core.study.kept_checks import KeptChecks, run_key
from core.study.limit_states import StateHistories, demands_of, unsaid, zetas
from core.study.plan import Entry, Inputs, Plan, costs_of, plan_of, read_inputs, refuse_large, with_chosen
from core.study.progress import OnProgress, Progress
from core.study.results import Assessment, StudyResult, WallResult, WallVerdict
from core.study.threads import Threads
from core.study.tie_design import Hinge, tie_design
from core.study.wall_result import run_result, wall_result, with_variants_alone
from core.study.wall_verdict import wall_verdicts
from core.study.zeta_with import Scene, model_of
from core.text.sentence import notice
from core.version import VERSION


def run(
    case: Case,
    *,
    base_dir: Path,
    jobs: int = 1,
    journal: Callable[[str], Journal | Memory] | None = None,
    on_progress: OnProgress = lambda done, planned, left: None,
    cancelled: Callable[[], bool] = lambda: False,
    on_wall: Callable[[WallResult], None] = lambda wall: None,
    share: tuple[int, int] | None = None,
    executor: Executor | None = None,
) -> StudyResult:
    """Run a study.

    base_dir : folder record paths start from
    jobs : threads, which change no result
    journal : makes the Journal of finished runs from the study's key; on_progress(done, planned, left) and cancelled()
        are called from this thread, the latter from the workers as well
    on_wall : called from this thread with each wall that has its verdict, before what is said of several together
    share : (k, n): of the walls only those whose number leaves k when divided by n
    executor : does the searches and checks, a wall a task, on other processes or machines (resources/docs/scale.md);
        what one of them loses is made here
    Raises InputError for what the user can mend, Cancelled when cancelled() is true.
    """
    started = datetime.datetime.now(datetime.UTC)
    refuse_large(case)
    cache.proven()
    book: Journal | Memory | None = None
    if executor:
        book = _found_on(executor, case, base_dir, cancelled)
    chosen, selection = with_chosen(case, base_dir, cancelled=cancelled)
    plan = plan_of(case, base_dir, read_inputs(chosen, base_dir), share)
    begin_compiling(plan)
    if journal and not executor:
        book = journal(journal_key())
    progress = Progress(costs_of(plan), on_progress)
    whole = share is None
    result = result_of(plan, base_dir, Threads(jobs, cancelled), started, book, progress, on_wall, whole)
    return replace(result, selection=selection)


def result_of(
    plan: Plan,
    base_dir: Path,
    threads: Threads,
    started: datetime.datetime,
    book: Journal | Memory | None,
    progress: Progress,
    on_wall: Callable[[WallResult], None] = lambda wall: None,
    whole: bool = True,
) -> StudyResult:
    """What a plan results in.

    base_dir, on_wall : as `run` takes them
    started : when
    book : of finished searches and checks, closed at the end
    whole : all hinges of each of its walls are in it, so that walls have verdicts
    Raises as `run` does.
    """
    try:
        demand, rules, results = _worked(plan, base_dir, threads, book, progress, on_wall)
        verdicts = _verdicts(plan, base_dir, demand, results, threads, book, progress)
    finally:
        cache.record(cache.folder())
        if book:
            book.close()
    elapsed = (datetime.datetime.now(datetime.UTC) - started).total_seconds()
    return StudyResult(
        plan.case,
        started.isoformat(timespec="seconds"),
        plan.method,
        plan.search,
        demand,
        tuple(plan.motions),
        tuple(plan.kinds),
        tuple(results),
        rules,
        elapsed,
        verdicts if whole else (),
    )


def _verdicts(plan: Plan, base_dir: Path, demand, results, threads, book, progress) -> tuple[WallVerdict, ...]:
    """Of the walls of a plan, with what is beside them; of a group of walls, whose rows alone are kept, without."""
    found = wall_verdicts(plan.case, tuple(results))
    if plan.longest is not None:
        return found
    return with_certainty(plan, base_dir, demand, results, found, book, threads, progress)


def journal_key() -> str:
    """Key of a journal: the program and the state of its sources."""
    return f"{VERSION} {cache.source_stamp()}"


def _worked(
    plan: Plan, base_dir: Path, threads: Threads, book: Journal | Memory | None, progress: Progress, on_wall
) -> tuple[DemandResult | None, Compliance | None, list[WallResult]]:
    """(demand with what the records add, whether they comply with it, the walls).

    base_dir, on_wall : as `run` takes them
    book : of finished searches and checks
    """
    demand, rules, case = plan.demand, None, plan.case
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
        of_place = notices(case.site, demand.limit_state) if case.site else []
        results = _at_limit_states(plan, results, demand, by_state, kept, threads)
        demand = replace(demand, warnings=(*demand.warnings, *unsaid(demand, by_state), *of_place))
        results = with_variants_alone(_with_ties(plan, results, demand, kept, threads, progress))
    if case.analysis.accuracy:
        results = _with_accuracy(plan, results, threads, progress)
    return demand, rules, results


EVERYTHING = sys.maxsize
"""Room of a Memory that forgets nothing."""

_kept: dict[tuple[str, Path], Inputs] = {}
"""Of a process that works for an executor: what its last case read."""


def wall_alone(case: Case, base_dir: Path, k: int) -> dict[str, dict]:
    """Searches and checks of the k-th wall of a case, as a journal holds them: the task of an executor, in a process of
    its own or on another machine that sees the same files. Raises InputError."""
    place = case.sha256, base_dir
    if place not in _kept:
        _kept.clear()
        _kept[place] = read_inputs(case, base_dir)
    plan, book = plan_of(case, base_dir, _kept[place], (k, len(case.wall))), Memory(EVERYTHING)
    begin_compiling(plan)
    progress = Progress(costs_of(plan), lambda done, planned, left: None)
    threads = Threads(1, lambda: False)
    demand, _, results = _worked(plan, base_dir, threads, book, progress, lambda wall: None)
    _verdicts(plan, base_dir, demand, results, threads, book, progress)
    return book.found


def _found_on(executor: Executor, case: Case, base_dir: Path, cancelled: Callable[[], bool]) -> Memory:
    """What an executor finds of each wall; of one whose process ends, nothing. Raises Cancelled, and InputError."""
    book = Memory(EVERYTHING)
    waiting: list[Future] = []
    with contextlib.suppress(BrokenExecutor):
        for k in range(len(case.wall)):
            waiting.append(executor.submit(wall_alone, case, base_dir, k))
    try:
        for future in waiting:
            while not future.done():
                if cancelled():
                    raise Cancelled
                wait([future], timeout=0.1)
            if isinstance(error := future.exception(), InputError):
                raise error
            if error is None:
                book.found |= future.result()
    finally:
        for future in waiting:
            future.cancel()
    return book


def _results(plan: Plan, found: dict, demand: DemandResult | None) -> list[WallResult]:
    """The walls with q, without a check. found : Idas by (wall, record, sign)"""
    results = []
    for k, (part, mechanism, model, signs, floor, felt, _) in enumerate(plan.entries):
        runs = [run_result(model, motion, n, s, found[k, n, s]) for n, motion in enumerate(felt) for s in signs]
        motions = [] if part.wall.bends else plan.motions
        results.append(wall_result(part, mechanism, model, runs, motions, plan.search, demand, floor))
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


def _with_ties(
    plan: Plan, results: list[WallResult], demand: DemandResult, kept, threads: Threads, progress: Progress
) -> list[WallResult]:
    """The walls, the base of each that asks for a tie with its design. kept : KeptChecks of each wall"""
    groups: dict[int, list[int]] = {}
    for k, wall in enumerate(results):
        asked = plan.case.wall[wall.part.origin]
        if asked.tie_height_m is not None and wall.mechanism == "one_sided":
            groups.setdefault(wall.part.origin, []).append(k)
    # a wall one of whose hinges has no check has no design
    whole = {origin: group for origin, group in groups.items() if all(results[k].assessment.kinematic for k in group)}

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

    counted = {k for k, entry in enumerate(plan.entries) if entry.part.wall.tie_height_m is not None}

    def told(walls: Iterable[int], worked: bool = True) -> None:
        for k in sorted(counted.intersection(walls)):
            progress.done(("tie", k), worked)

    told(counted.difference(*whole.values()), False)
    done = threads.run(
        {origin: task(origin, group) for origin, group in whole.items()}, lambda origin, _: told(whole[origin])
    )
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
    return [
        replace(
            wall,
            accuracy=done[k],
            warnings=(*wall.warnings, notice("bending_no_accuracy")) if wall.wall.bends else wall.warnings,
        )
        for k, wall in enumerate(results)
    ]


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
    model = model_of(case.wall[0], case.wall[0].mechanisms()[0])
    method = METHODS.get(case.analysis.method, AUTO)
    _begin_compiling(method, [model], [motion])
    ground, dt = motion.acceleration, motion.time_step
    scales = np.full(16, multiplier_of(1.1, motion.pga, threshold_of(model)))
    scan(method, ground, dt, scales, model, np.zeros(16, np.int64), np.zeros(16))
    history(ground, dt, scales[0], model, method)


def begin_compiling(plan: Plan) -> None:
    felt = [motion for entry in plan.entries for motion in entry.felt]
    _begin_compiling(plan.method, [entry.model for entry in plan.entries], felt)


def _begin_compiling(method, models, motions) -> None:
    steps = {motion.time_step for motion in motions}
    precompile.start({resolve_auto(method, model, dt).name for model in models for dt in steps})


TASKS, SAMPLES = 8, 40_000
"""Least tasks for a thread where runs of a wall are searched side by side; most samples of them, for a quick cancel."""


def _run_all(plan: Plan, threads: Threads, book, progress: Progress) -> dict[tuple[int, int, int], Ida]:
    """Idas by (wall, record, sign)."""
    searches, keys = {}, {}
    todo: dict[int, list[tuple[int, int, int]]] = {}

    def search_of(group: tuple[tuple[int, int, int], ...]):
        entry = plan.entries[group[0][0]]
        motions = [(entry.felt[record], sign) for _, record, sign in group]
        runs = [Run(motion.acceleration, motion.time_step, motion.pga, sign) for motion, sign in motions]
        return lambda stop: incremental_dynamic_analyses(runs, entry.model, plan.method, plan.search, stop)

    for one in plan.runs:
        k, record, sign = one
        model, motion = plan.entries[k].model, plan.entries[k].felt[record]
        keys[one] = run_key(model, motion, sign, plan.method, plan.search)
        known = rebuilt(Ida, book.get(keys[one])) if book else None
        if known:
            searches[one] = known
        else:
            todo.setdefault(k, []).append(one)

    def keep(group, found: list[Ida]) -> None:
        for one, ida in zip(group, found, strict=True):
            searches[one] = ida
            if book:
                book.add(keys[one], asdict(ida))
            progress.done(one)

    progress.known(searches)
    share, groups = sum(len(runs) for runs in todo.values()) // (TASKS * threads.jobs), []
    for k, runs in todo.items():
        longest = max(motion.acceleration.size for motion in plan.entries[k].felt)
        lanes = in_lanes(plan.method, plan.entries[k].model)
        together = max(1, min(share, SAMPLES // longest)) if lanes else 1
        groups += [tuple(runs[n : n + together]) for n in range(0, len(runs), together)]
    threads.run({group: search_of(group) for group in groups}, keep)
    return searches
