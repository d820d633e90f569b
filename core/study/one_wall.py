"""One wall of a case run alone, as the whole case finds it, and with inputs of its table at their other ends."""

from collections.abc import Callable, Iterable
from dataclasses import replace
from pathlib import Path

from core.case.schema import Case
from core.codes.assumption import Assumption
from core.jit import cache
from core.known import known
from core.setting.plan import longest_of, plan_of, read_inputs
from core.study.journal import Journal, Memory
from core.study.kept_checks import KeptChecks
from core.study.progress import Progress, Started, costs_of
from core.study.results import StudyResult
from core.study.run import result_of
from core.threads import Threads
from core.variation.assumptions import at_other_ends
from core.variation.evaluate import Evaluation, evaluate


def alone(case: Case, row: int) -> Case:
    """The case with one of its walls, without what is made beside a verdict."""
    return replace(case, wall=(case.wall[row],), sensitivity=None, analysis=replace(case.analysis, accuracy=False))


def run_wall(
    case: Case,
    row: int,
    base_dir: Path,
    journal: Journal | Memory | None,
    jobs: int = 1,
    cancelled: Callable[[], bool] = lambda: False,
) -> StudyResult:
    """One wall of a case with a demand, judged beside all its walls: the records are compatible over the periods of
    all. Without the interval of zeta for other samples.

    base_dir, journal, jobs, cancelled : as `run` takes them
    Raises InputError, Cancelled.
    """
    started = Started()
    cache.proven()
    inputs = read_inputs(case, base_dir)
    longest = longest_of(case, known(inputs[0]))
    plan = plan_of(alone(case, row), inputs, longest=longest, walls=len(case.wall))
    progress = Progress(costs_of(plan), lambda done, planned, left: None)
    return result_of(plan, base_dir, Threads(jobs, cancelled), started, journal, progress)


def turned(
    result: StudyResult,
    rows: Iterable[Assumption],
    journal: Journal | Memory | None,
    cancelled: Callable[[], bool] = lambda: False,
) -> Evaluation | None:
    """The hinge that decides about the wall of a result of `run_wall`, with these rows at their other ends; None where
    it does not stand there.

    rows : of the table of that hinge, that have a switch
    journal : of the checks of that run, which are not made again
    Raises Cancelled.
    """
    k, demand = result.verdicts[0].governing, known(result.demand)
    wall = result.walls[k]
    plan = plan_of(result.case, (demand, list(result.motions), list(result.kinds)))
    scene = plan.scene(k, demand, result.compliance, KeptChecks(journal))
    scene = replace(scene, q_slv=(wall.q_slv_low_set, wall.q_slv_set))
    return at_other_ends(evaluate(scene, cancelled=cancelled), rows, cancelled)
