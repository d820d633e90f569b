"""The one call that makes results: a case in, a frozen StudyResult out. Window, batch, tests use it."""

import contextlib
import sys
from collections.abc import Callable
from concurrent.futures import BrokenExecutor, Executor, Future, wait
from dataclasses import replace
from pathlib import Path

import numpy as np

from core.capacity.ida import multiplier_of, threshold_of
from core.case.place import notices
from core.case.schema import Case
from core.codes.demand import DemandResult, with_records
from core.codes.record_compatibility import compliance
from core.errors import Cancelled, InputError
from core.ground.ground_motion import GroundMotion
from core.jit import cache
from core.rocking.history import history, scan
from core.rocking.methods import AUTO, METHODS, resolve_auto
from core.setting.plan import Inputs, Plan, plan_of, read_inputs, refuse_large, with_chosen
from core.setting.record_selection import Selection
from core.setting.scene import model_of
from core.study import precompile
from core.study.how_sure import ag_of
from core.study.journal import Journal, Memory
from core.study.progress import OnProgress, Progress, Started, costs_of
from core.study.results import StudyResult, WallResult, WallVerdict
from core.study.self_test import order_of
from core.study.wall_work import Finished, Given, works
from core.threads import Threads
from core.variation.limit_states import demands_of, rules_of, unsaid
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
    executor : does the searches and checks, a wall a task, on other processes or machines (resources/docs/scale.md);
        what one of them loses is made here
    Raises InputError for what the user can mend, Cancelled when cancelled() is true.
    """
    started = Started()
    refuse_large(case)
    cache.proven()
    finished: Journal | Memory | None = None
    if executor:
        finished = _found_on(executor, case, base_dir, cancelled)
    chosen, selection = with_chosen(case, base_dir, cancelled=cancelled)
    plan = plan_of(case, read_inputs(chosen, base_dir), share)
    begin_compiling(plan)
    if journal and not executor:
        finished = journal(journal_key())
    progress = Progress(costs_of(plan), on_progress)
    threads = Threads(jobs, cancelled)
    return result_of(
        plan, base_dir, threads, started, finished, progress, on_wall, on_finished, selection, share is None
    )


def result_of(
    plan: Plan,
    base_dir: Path,
    threads: Threads,
    started: Started,
    journal: Journal | Memory | None,
    progress: Progress,
    on_wall: Callable[[WallResult], None] = lambda wall: None,
    on_finished: Callable[[StudyResult], None] = lambda wall: None,
    selection: Selection | None = None,
    whole: bool = True,
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
    Raises as `run` does.
    """
    results: list[WallResult] = []
    verdicts: list[WallVerdict] = []
    try:
        threads.run({k: motion.measure for k, motion in enumerate(plan.motions)})
        demand, by_state = _demand(plan, base_dir)
        rules = compliance(plan.motions, plan.kinds, demand, plan.longest_period) if demand else None
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

        def ended(wall: Finished) -> None:
            walls, found = wall
            first = len(results)
            results.extend(walls)
            verdicts.extend(one.moved(first) for one in found)
            on_finished(head.of_wall(walls, found, first))

        # of a group of walls the rows alone are kept, without what is beside the verdict
        rated = demand is not None and demand.hazard and plan.longest is None
        ag = ag_of(demand, plan.case.demand, base_dir) if demand and rated else None
        state_rules = rules_of(plan, demand, by_state) if demand else {}
        given = Given(plan, base_dir, demand, rules, by_state, state_rules, ag, journal, progress, on_wall)
        threads.run_works(works(given, threads.jobs), ended)
    finally:
        cache.record(cache.folder())
    return replace(head, walls=tuple(results), verdicts=tuple(verdicts) if whole else (), elapsed=started.elapsed)


def _demand(plan: Plan, base_dir: Path) -> tuple[DemandResult | None, dict[str, DemandResult]]:
    """(demand with what the records add, demands of the limit states). base_dir : as `run` takes it"""
    if plan.demand is None:
        return None, {}
    demand, by_state = with_records(plan.demand, plan.motions), demands_of(plan.case, base_dir)
    of_place = notices(plan.case.site, demand.limit_state) if plan.case.site else []
    return replace(demand, warnings=(*demand.warnings, *unsaid(demand, by_state), *of_place)), by_state


def journal_key() -> str:
    """Key of a journal: the program and the state of its sources."""
    return f"{VERSION} {cache.source_stamp()}"


EVERYTHING = sys.maxsize
"""Room of a Memory that forgets nothing."""

_kept: dict[tuple[str, Path], Inputs] = {}
"""Inputs of the last case that a process working for an executor read."""


def wall_alone(case: Case, base_dir: Path, k: int) -> dict[str, dict]:
    """Searches and checks of the k-th wall of a case, as a journal holds them: the task of an executor, in a process of
    its own or on another machine that sees the same files. Raises InputError."""
    place = case.sha256, base_dir
    if place not in _kept:
        _kept.clear()
        _kept[place] = read_inputs(case, base_dir)
    plan, memory = plan_of(case, _kept[place], (k, len(case.wall))), Memory(EVERYTHING)
    begin_compiling(plan)
    progress = Progress(costs_of(plan), lambda done, planned, left: None)
    result_of(plan, base_dir, Threads(1, lambda: False), Started(), memory, progress)
    return memory.found


def _found_on(executor: Executor, case: Case, base_dir: Path, cancelled: Callable[[], bool]) -> Memory:
    """Collect what an executor finds of each wall; of one whose process ends, nothing. Raises Cancelled, and
    InputError."""
    memory = Memory(EVERYTHING)
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
                memory.found |= future.result()
    finally:
        for future in waiting:
            future.cancel()
    return memory


def warm(case: Case, motion: GroundMotion) -> tuple[str, ...]:
    """Make the kernels of a case ready: a few analyses of its first wall; returns the methods whose self-test needs no
    others."""
    cache.proven()
    model = model_of(case.wall[0], case.wall[0].mechanisms()[0])
    method = METHODS.get(case.analysis.method, AUTO)
    _begin_compiling(method, [model], [motion])
    ground, dt = motion.acceleration, motion.time_step
    scales = np.full(16, multiplier_of(1.1, motion.pga, threshold_of(model)))
    scan(method, ground, dt, scales, model, np.zeros(16, np.int64), np.zeros(16))
    history(ground, dt, scales[0], model, method)
    return order_of(method, model, dt)


def begin_compiling(plan: Plan) -> None:
    felt = [motion for entry in plan.entries for motion in entry.felt]
    _begin_compiling(plan.method, [entry.model for entry in plan.entries], felt)


def _begin_compiling(method, models, motions) -> None:
    steps = {motion.time_step for motion in motions}
    precompile.start({resolve_auto(method, model, dt).name for model in models for dt in steps})
