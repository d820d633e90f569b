"""The one call that makes results: a case in, a frozen StudyResult out. Window, batch, tests use it."""

import contextlib
import hashlib
import sys
from collections.abc import Callable, Generator
from concurrent.futures import Executor
from dataclasses import replace
from pathlib import Path

import numpy as np

from core.capacity.ida import multiplier_of, threshold_of
from core.case.place import site_notices
from core.case.schema import Case
from core.case.wall import Wall
from core.codes.demand import SeismicDemand, complete_with_records
from core.codes.record_compatibility import check_compatibility
from core.ground.ground_motion import GroundMotion
from core.jit import cache, native
from core.rocking.analysis_count import MADE
from core.rocking.history import integrate_history, scan_multipliers
from core.rocking.methods import AUTO, METHODS, resolve_auto
from core.setting.check_input import make_rocking_model
from core.setting.demand_input import demand_notices
from core.setting.plan import Plan, make_plan, read_inputs, refuse_large, select_case_records
from core.setting.record_selection import Selection
from core.study import precompile
from core.study.executors import TaskContext, iterate_results, make_remote_plan, make_task_context, make_waiter
from core.study.journal import Journal, MemoryJournal, journal_key
from core.study.progress import OnProgress, Progress, StartTime, task_costs
from core.study.results import StudyResult, WallResult, WallVerdict
from core.study.self_test import find_kernel_order
from core.study.verdict_uncertainty import make_ag_function
from core.study.wall_tasks import StudyContext, WallOutcome, search_key, wall_tasks
from core.threads import Threads
from core.variation.limit_states import limit_state_compliance, limit_state_demands, unused_hazard_notices


def run(
    case: Case,
    *,
    base_dir: Path,
    jobs: int = 1,
    journal: Callable[[str], Journal | MemoryJournal] | None = None,
    on_progress: OnProgress = lambda done, planned, left: None,
    cancelled: Callable[[], bool] = lambda: False,
    on_wall: Callable[[WallResult], None] = lambda wall: None,
    on_finished: Callable[[StudyResult], None] = lambda wall: None,
    share: tuple[int, int] | None = None,
    executor: Executor | None = None,
) -> StudyResult:
    """Run a study.

    base_dir : folder record paths start from
    jobs : threads, which change no result
    journal : makes the Journal of finished runs from the study's key, which stays open: until its results are
        written no other batch may begin
    on_progress(done, planned, left), cancelled() : called from this thread, the latter from the workers as well
    on_wall : called from this thread with each hinge and mechanism that has its checks
    on_finished : called from this thread with the results of each wall of the case alone, in its order, once nothing is
        added to them
    share : (k, n): of the walls only those whose number leaves k when divided by n
    executor : does the searches and checks that are not in the journal, a wall a task, on other processes or machines
        (resources/docs/scale.md); what one of them loses is made here
    Raises InputError for what the user can mend, Cancelled when cancelled() is true.
    """
    started, made_before = StartTime(), MADE.total
    refuse_large(case)
    native.ready()
    chosen, selection = select_case_records(case, base_dir, cancelled=cancelled)
    inputs = read_inputs(chosen, base_dir)
    plan = make_plan(case, inputs, share)
    start_compilation(plan)
    finished = journal(journal_key()) if journal else MemoryJournal(UNLIMITED) if executor else None
    progress, threads = Progress(task_costs(plan), on_progress), Threads(jobs, cancelled)
    alone = share is None
    how = (on_wall, on_finished, selection, alone, alone and len(case.wall) <= MAX_WALLS_WITH_MEASURES)
    if executor is None or finished is None:
        result = run_plan(plan, base_dir, threads, started, finished, progress, *how)
        return replace(result, analyses=MADE.total - made_before)
    # what is said beside the checks is made here, where the walls come together
    bare = replace(chosen, sensitivity=None, analysis=replace(chosen.analysis, accuracy=False))
    shared = make_task_context(bare, base_dir, inputs, None)
    with contextlib.closing(_walls_elsewhere(executor, shared, plan, finished, cancelled)) as arrivals:
        result = run_plan(plan, base_dir, threads, started, finished, progress, *how, make_waiter(arrivals))
    return replace(result, analyses=MADE.total - made_before)


def run_plan(
    plan: Plan,
    base_dir: Path,
    threads: Threads,
    started: StartTime,
    journal: Journal | MemoryJournal | None,
    progress: Progress,
    on_wall: Callable[[WallResult], None] = lambda wall: None,
    on_finished: Callable[[StudyResult], None] = lambda wall: None,
    selection: Selection | None = None,
    whole: bool = True,
    measures: bool = False,
    wait_for: Callable[[int], None] | None = None,
) -> StudyResult:
    """Result of a plan.

    plan : of the case
    base_dir, on_wall, on_finished : as `run` takes them
    threads : that do the tasks
    started : when
    progress : told of each task
    journal : of finished searches and checks
    selection : of [select]
    whole : all walls of the case are in it, so that they have verdicts
    measures : what would make a wall that fails pass is sought
    wait_for : returns once what was found elsewhere of a wall, by its number in the case, is in the journal
    Raises as `run` does.
    """
    results: list[WallResult] = []
    verdicts: list[WallVerdict] = []
    try:
        threads.run({k: motion.measure for k, motion in enumerate(plan.motions)})
        demand, by_state = _demand(plan, base_dir)
        rules = check_compatibility(plan.motions, plan.kinds, demand, plan.longest_period) if demand else None
        head = StudyResult(
            plan.case,
            started.utc,
            plan.method,
            plan.search,
            demand,
            tuple(plan.motions),
            tuple(plan.kinds),
            (),
            rules,
            selection=selection,
        )

        def ended(wall: WallOutcome) -> None:
            walls, own_verdicts = wall
            first = len(results)
            results.extend(walls)
            verdicts.extend(verdict.moved(first) for verdict in own_verdicts)
            on_finished(head.of_wall(walls, own_verdicts, first))

        # of a group of walls the rows alone are kept, without what is beside the verdict
        rated = demand is not None and demand.hazard and plan.longest is None
        ag = make_ag_function(demand, plan.case.demand, base_dir) if demand and rated else None
        state_rules = limit_state_compliance(plan, demand, by_state) if demand else {}
        given = StudyContext(
            plan, base_dir, demand, rules, by_state, state_rules, ag, journal, progress, on_wall, measures
        )
        threads.run_works(wall_tasks(given, threads.jobs, wait_for), ended)
    finally:
        cache.record(cache.folder())
    return replace(head, walls=tuple(results), verdicts=tuple(verdicts) if whole else (), elapsed=started.elapsed)


def _demand(plan: Plan, base_dir: Path) -> tuple[SeismicDemand | None, dict[str, SeismicDemand]]:
    """(demand with what the records add, demands of the limit states). base_dir : as `run` takes it"""
    if plan.demand is None:
        return None, {}
    demand, by_state = complete_with_records(plan.demand, plan.motions), limit_state_demands(plan.case, base_dir)
    of_place = site_notices(plan.case.site, demand.limit_state) if plan.case.site else []
    of_place += demand_notices(plan.case)
    return replace(demand, warnings=(*demand.warnings, *unused_hazard_notices(demand, by_state), *of_place)), by_state


MAX_WALLS_WITH_MEASURES = 50
"""Walls of a case up to which what would make one that fails pass is sought: some seconds a wall."""

UNLIMITED = sys.maxsize
"""Room of a Memory that forgets nothing."""


def run_wall_task(shared: TaskContext, wall: Wall, known: dict[str, dict]) -> tuple[dict[str, dict], int]:
    """Searches and checks of a wall beside the known ones, as a journal holds them, and the analyses made for them: the
    task of an executor, in a process of its own or on another machine that sees the same files. Raises InputError."""
    made_before = MADE.total
    plan, memory = make_remote_plan(shared, (wall,)), MemoryJournal(UNLIMITED)
    memory.found |= known
    start_compilation(plan)
    progress = Progress(task_costs(plan), lambda done, planned, left: None)
    run_plan(plan, shared.base_dir, Threads(1, lambda: False), StartTime(), memory, progress)
    found = {name: result for name, result in memory.found.items() if name not in known}
    return found, MADE.total - made_before


def _walls_elsewhere(
    executor: Executor, shared: TaskContext, plan: Plan, journal: Journal | MemoryJournal, cancelled: Callable[[], bool]
) -> Generator[int]:
    """Numbers of the walls in a plan as their searches and checks come into the journal, in any order; those of a wall
    that is lost with its process do not. Raises Cancelled, and InputError."""
    spans = {plan.entries[span[0]].part.origin: span for span in plan.spans}
    common = repr((shared.case.as_dict(), shared.files))
    names = {k: "wall " + hashlib.sha256((common + repr(plan.case.wall[k])).encode()).hexdigest() for k in spans}
    todo = [k for k in spans if journal.get(names[k]) is None]
    yield from set(spans) - set(todo)

    def given(k: int) -> tuple:
        keys = [search_key(plan, one) for entry in spans[k] for one in plan.runs_of(entry)]
        known = {key: stored for key in keys if (stored := journal.get(key)) is not None}
        return shared, plan.case.wall[k], known

    tasks = ((k, given(k)) for k in todo)
    for k, arrived in iterate_results(executor, run_wall_task, tasks, cancelled):
        if arrived is not None:
            found, analyses = arrived
            MADE.add(analyses)
            for name, result in found.items():
                journal.add(name, result)
            journal.add(names[k], {})  # it has come whole
        yield k


def warm_kernels(case: Case, motion: GroundMotion) -> tuple[str, ...]:
    """Make the kernels of a case ready: a few analyses of its first wall; returns the methods whose self-test needs no
    others."""
    native.ready()
    model = make_rocking_model(case.wall[0], case.wall[0].mechanisms()[0])
    method = METHODS.get(case.analysis.method, AUTO)
    _begin_compiling(method, [model], [motion])
    ground, dt = motion.acceleration, motion.time_step
    scales = np.full(16, multiplier_of(1.1, motion.pga, threshold_of(model)))
    scan_multipliers(method, ground, dt, scales, model, np.zeros(16, np.int64), np.zeros(16))
    integrate_history(ground, dt, scales[0], model, method)
    return find_kernel_order(method, model, dt)


def start_compilation(plan: Plan) -> None:
    felt = [motion for entry in plan.entries for motion in entry.felt]
    _begin_compiling(plan.method, [entry.model for entry in plan.entries], felt)


def _begin_compiling(method, models, motions) -> None:
    steps = {motion.time_step for motion in motions}
    precompile.start({resolve_auto(method, model, dt).name for model in models for dt in steps})
