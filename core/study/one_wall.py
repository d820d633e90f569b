"""One wall of a case run alone, as the whole case finds it, and with inputs of its table at their other ends."""

from collections.abc import Callable, Iterable
from dataclasses import replace
from pathlib import Path

from core.case.schema import Case
from core.codes.assumption import Assumption
from core.codes.outcomes import worst_outcome
from core.jit import native
from core.known import require_value
from core.setting.plan import longest_mechanism_period, make_plan, read_inputs
from core.study.check_cache import CheckCache
from core.study.journal import Journal, MemoryJournal
from core.study.progress import Progress, StartTime, task_costs
from core.study.results import StudyResult
from core.study.run import run_plan
from core.threads import Threads
from core.variation.assumptions import evaluate_at_alternatives
from core.variation.evaluate import Evaluation, evaluate


def single_wall_case(case: Case, row: int) -> Case:
    """The case with one of its walls, without what is made beside a verdict."""
    return replace(case, wall=(case.wall[row],), sensitivity=None, analysis=replace(case.analysis, accuracy=False))


def run_wall(
    case: Case,
    row: int,
    base_dir: Path,
    journal: Journal | MemoryJournal | None,
    jobs: int = 1,
    cancelled: Callable[[], bool] = lambda: False,
) -> StudyResult:
    """One wall of a case with a demand, judged beside all its walls: the records are compatible over the periods of
    all. Without the interval of zeta for other samples.

    base_dir, journal, jobs, cancelled : as `run` takes them
    Raises InputError, Cancelled.
    """
    started = StartTime()
    native.ready()
    inputs = read_inputs(case, base_dir)
    longest = longest_mechanism_period(case, require_value(inputs[0]))
    plan = make_plan(single_wall_case(case, row), inputs, longest=longest)
    progress = Progress(task_costs(plan), lambda done, planned, left: None)
    return run_plan(plan, base_dir, Threads(jobs, cancelled), started, journal, progress)


def run_at_alternatives(
    result: StudyResult,
    rows: Iterable[Assumption],
    journal: Journal | MemoryJournal | None,
    cancelled: Callable[[], bool] = lambda: False,
) -> Evaluation | None:
    """The hinge of the wall of a result of `run_wall` that decides with these rows at their other ends, each hinge at
    the ends of its own table; None where it does not stand there.

    rows : of the table of the wall, that have a switch
    journal : of the checks of that run, which are not made again
    Raises Cancelled.
    """
    demand, keys = require_value(result.demand), {row.key for row in rows}
    plan = make_plan(result.case, (demand, list(result.motions), list(result.kinds)))
    evaluations = []
    for k, wall in enumerate(result.walls):
        scene = plan.scene(k, demand, result.compliance, CheckCache(journal))
        as_it_is = evaluate(replace(scene, q_slv=(wall.q_slv_safe_set, wall.q_slv_set)), cancelled=cancelled)
        own = [row for row in wall.required_assessment.verdict.assumptions if row.key in keys and row.has_switch]
        there = evaluate_at_alternatives(as_it_is, own, cancelled) if own else as_it_is
        if there is None:
            return None
        evaluations.append(there)
    return worst_outcome(evaluations, lambda evaluation: (evaluation.outcome, evaluation.zeta, demand.zeta_target))
