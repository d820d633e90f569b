"""How many runs and checks of a study are done, and the time left in proportion to what they cost."""

import datetime
import math
import time
from collections.abc import Callable, Hashable, Iterable, Mapping
from typing import Any

from core.capacity.ida import Search
from core.ground.ground_motion import GroundMotion
from core.setting.plan import Plan


class StartTime:
    """When work began: utc by the clock of the system, which may be set meanwhile, elapsed by one that only runs."""

    def __init__(self) -> None:
        self.utc = datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds")
        self._ticks = time.monotonic()

    @property
    def elapsed(self) -> float:
        """Time since then [s]."""
        return time.monotonic() - self._ticks


OnProgress = Callable[[int, int, float | None], None]
"""Called with what is done, what is planned, and the time left [s], None while nothing tells it."""

GRID_COST = 0.007
"""Cost of the grid of a run, whose count of points goes with 1 / q_step, over that of its bisections."""

CHECK_COST = 12.0
"""Cost of the checks of a wall at the demand and of their table of assumptions over the bisections of its runs: 6 to 14
measured (30 walls, the shipped cases)."""

FLOOR_COST, STATEMENT_COST, SENSITIVITY_COST = 2.0, 20.0, 0.4
"""A wall above the ground is checked for another building and height too; the moves of the inputs are coarse ones; the
accuracy statement makes as many searches of one run."""


def run_cost(motion: GroundMotion, search: Search) -> float:
    """Cost of one search, in samples that its bisections go through."""
    return motion.acceleration.size * (1.0 + GRID_COST / search.q_step)


def check_cost(motions: Iterable[GroundMotion], signs: int, floor: bool) -> float:
    """Cost of the check of a wall at the demand, in the same samples; 1 without records, where there are only closed
    forms."""
    samples = sum(motion.acceleration.size for motion in motions)
    return 1.0 + CHECK_COST * signs * samples * (FLOOR_COST if floor else 1.0)


def task_costs(plan: Plan) -> dict[Any, float]:
    """Cost of each task, in samples that the bisections of a search go through."""
    search = plan.search
    costs: dict[Any, float] = {
        (k, record, sign): run_cost(plan.entries[k].felt[record], search) for k, record, sign in plan.runs
    }
    for k, entry in enumerate(plan.entries):
        if plan.demand:
            costs["check", k] = check_cost(entry.felt, len(entry.signs), entry.floor is not None)
            if plan.case.sensitivity:
                cost = SENSITIVITY_COST * costs["check", k]
                costs["sensitivity", entry.part.origin] = costs.get(("sensitivity", entry.part.origin), 0.0) + cost
        if plan.case.analysis.accuracy:
            costs["accuracy", k] = STATEMENT_COST * max((run_cost(m, search) for m in entry.felt), default=1.0)
    return costs


class Progress:
    """Counts the tasks of a study.

    costs : of each task, in any one unit
    clock : seconds
    """

    def __init__(
        self, costs: Mapping[Any, float], on_progress: OnProgress, clock: Callable[[], float] = time.monotonic
    ):
        self._left, self._planned = dict(costs), len(costs)
        self._ahead = math.fsum(costs.values())
        self._on_progress, self._clock = on_progress, clock
        self._since: float | None = None
        self._paid = 0.0

    def known(self, tasks: Iterable[Hashable]) -> None:
        """Count these as done by an earlier start."""
        for task in tasks:
            self._ahead -= self._left.pop(task)
        self._tell()

    def done(self, task: Hashable, worked: bool = True) -> None:
        """Count a task as done. worked : False where an earlier start did it, so that its time tells nothing of the
        others"""
        cost = self._left.pop(task)
        self._ahead -= cost
        if worked and self._since is None:
            self._since = self._clock()  # the time of the first is that of the compiler too
        elif worked:
            self._paid += cost
        self._tell()

    def _tell(self) -> None:
        left = 0.0 if not self._left else None
        if self._left and self._paid and self._since is not None:
            left = self._ahead * (self._clock() - self._since) / self._paid
        self._on_progress(self._planned - len(self._left), self._planned, left)
