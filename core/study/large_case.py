"""A case of more walls than a workbook holds: worked in groups, each a study of its own walls with what is said of all
of them, so that its numbers are those of the undivided run (resources/docs/scale.md)."""

import hashlib
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Executor
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

from core.case.many_walls import group_walls
from core.case.schema import Case
from core.case.wall import Wall
from core.codes.demand import complete_with_records
from core.codes.record_compatibility import check_compatibility, period_range
from core.errors import Cancelled
from core.jit import native
from core.setting.plan import FloorCache, Inputs, make_plan, read_inputs, select_case_records
from core.setting.record_selection import Selection
from core.study.executors import TaskContext, files_key, iterate_results, make_remote_plan, make_task_context
from core.study.progress import OnProgress, Progress, StartTime, task_costs
from core.study.results import StudyResult
from core.study.run import run_plan, start_compilation
from core.threads import Threads
from core.variation.limit_states import limit_state_demands, unused_hazard_notices

MAX_GROUP, MAX_SEARCHES = 128, 4096
"""Walls of a group, and searches of one: what is lost when a run is killed, and what stands in memory at a time."""

MAX_CACHED_FLOORS = 16
"""Heights above the ground whose motions are kept from one group to the next."""


class LargeCase(NamedTuple):
    """A case in groups.

    inputs : of `read_inputs`
    groups : indices of the walls of each
    tasks : searches and checks of each group
    longest : period of the mechanisms of all walls [s]
    selection : of [select]
    """

    case: Case
    base_dir: Path
    inputs: Inputs
    groups: list[list[int]]
    tasks: list[int]
    longest: float
    selection: Selection | None = None

    @property
    def key(self) -> str:
        """Key of all that decides the rows of the case beside the program: the case, and what it reads."""
        parts = (self.case.sha256, files_key(self.case, self.base_dir, self.inputs), len(self.groups))
        return hashlib.sha256(repr(parts).encode()).hexdigest()


def prepare_large_case(case: Case, base_dir: Path, cancelled: Callable[[], bool] = lambda: False) -> LargeCase:
    """A case in groups, every wall of which was looked at: what the user can mend is refused before the first analysis.

    base_dir : folder record paths start from
    Raises InputError, Cancelled.
    """
    chosen, selection = select_case_records(case, base_dir, cancelled=cancelled)
    inputs = read_inputs(chosen, base_dir)
    demand, motions, kinds = inputs
    size = max(1, min(MAX_GROUP, MAX_SEARCHES // max(1, 2 * len(motions))))
    groups, floors = group_walls(case.wall, size), FloorCache(MAX_CACHED_FLOORS)
    tasks, longest = [], 0.0
    for group in groups:
        if cancelled():
            raise Cancelled
        plan = _plan(case, inputs, group, 0.0, floors)
        tasks.append(len(task_costs(plan)))
        longest = max(longest, replace(plan, longest=None).longest_period)
    if demand and demand.target and motions:
        period_range(kinds, longest, demand)
    return LargeCase(case, base_dir, inputs, groups, tasks, longest, selection)


def _plan(case: Case, inputs: Inputs, group: list[int], longest: float, floors: FloorCache):
    """The plan of a group of walls. longest : of the mechanisms of all walls [s]"""
    walls = tuple(case.wall[k] for k in group)
    return make_plan(replace(case, wall=walls), inputs, None, longest, floors)


def common_result(large: LargeCase) -> StudyResult:
    """Result that all groups have in common: demand, records, whether these comply with it."""
    case, (demand, motions, kinds) = replace(large.case, wall=()), large.inputs
    plan, rules = make_plan(case, large.inputs, None, large.longest), None
    if demand:
        demand = complete_with_records(demand, motions)
        rules = check_compatibility(motions, kinds, demand, large.longest)
        demand = replace(
            demand,
            warnings=(*demand.warnings, *unused_hazard_notices(demand, limit_state_demands(case, large.base_dir))),
        )
    result = StudyResult(
        case, StartTime().utc, plan.method, plan.search, demand, tuple(motions), tuple(kinds), (), rules
    )
    return replace(result, selection=large.selection)


def group_results(
    large: LargeCase,
    todo: Iterable[int],
    jobs: int = 1,
    on_progress: OnProgress = lambda done, planned, left: None,
    cancelled: Callable[[], bool] = lambda: False,
) -> Iterator[tuple[int, StudyResult]]:
    """(group, its result) of the groups to do, one after the other.

    todo : numbers of the groups
    jobs : threads, which change no result
    on_progress, cancelled : as `run` takes them
    Raises InputError, Cancelled.
    """
    native.ready()
    todo, floors = list(todo), FloorCache(MAX_CACHED_FLOORS)
    progress, threads = _GroupProgress(large, todo, on_progress), Threads(jobs, cancelled)
    for g in todo:
        plan = _plan(large.case, large.inputs, large.groups[g], large.longest, floors)
        if g == todo[0]:
            start_compilation(plan)
        yield g, run_plan(plan, large.base_dir, threads, StartTime(), None, Progress(task_costs(plan), progress.within))
        progress.finished(g)


class _GroupProgress:
    """Counts the tasks of groups, the time left in proportion to their number. todo : groups that are made"""

    def __init__(self, large: LargeCase, todo: list[int], on_progress: OnProgress):
        self._tasks, self._planned, self._on_progress = large.tasks, sum(large.tasks), on_progress
        self._done = self._first = self._planned - sum(large.tasks[g] for g in todo)
        self._begun = time.monotonic()

    def within(self, done: int, of_group: int, left: float | None) -> None:
        """Tell how far the group is that is made now, as `Progress` does."""
        worked = self._done + done - self._first
        left = (time.monotonic() - self._begun) * (self._planned - self._done - done) / worked if worked else None
        self._on_progress(self._done + done, self._planned, left)

    def finished(self, group: int) -> None:
        """Count a group."""
        self._done += self._tasks[group]


Rows = Callable[[StudyResult, Sequence[int]], Any]
"""What is kept of a group, from its result and the numbers of its walls: of `core.report.columns.columns_of`."""


def run_group_task(shared: TaskContext, walls: tuple[Wall, ...], numbers: list[int], rows: Rows) -> Any:
    """Rows of a group of walls: the task of an executor, in a process of its own or on another machine that sees the
    same files. numbers : of its walls in the case. Raises InputError."""
    plan = make_remote_plan(shared, walls)
    start_compilation(plan)
    progress = Progress(task_costs(plan), lambda done, planned, left: None)
    return rows(run_plan(plan, shared.base_dir, Threads(1, lambda: False), StartTime(), None, progress), numbers)


def run_groups_remotely(
    large: LargeCase,
    todo: list[int],
    executor: Executor,
    rows: Rows,
    on_progress: OnProgress = lambda done, planned, left: None,
    cancelled: Callable[[], bool] = lambda: False,
) -> Iterator[tuple[int, Any]]:
    """(group, its rows) of the groups to do as they come back from an executor, in any order, without those that are
    lost with their process. Raises InputError, Cancelled."""
    chosen = large.case
    if large.selection:
        chosen = replace(chosen, select=None, record=large.selection.chosen.records)
    shared = make_task_context(chosen, large.base_dir, large.inputs, large.longest)
    progress = _GroupProgress(large, todo, on_progress)

    def given(group: list[int]) -> tuple:
        return shared, tuple(large.case.wall[k] for k in group), group, rows

    tasks = ((g, given(large.groups[g])) for g in todo)
    for g, group_rows in iterate_results(executor, run_group_task, tasks, cancelled):
        if group_rows is not None:
            yield g, group_rows
            progress.finished(g)
            progress.within(0, 0, None)
