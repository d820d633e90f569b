"""The tasks of one wall, in order: search of q, checks, limit states, tie, accuracy; yields tasks, returns results."""

import traceback
from collections.abc import Callable, Iterator
from dataclasses import asdict, replace
from pathlib import Path
from typing import NamedTuple

from core.capacity.accuracy import Accuracy, make_accuracy
from core.capacity.ida import Ida, Run, incremental_dynamic_analyses
from core.case.hinges import best_way
from core.case.hold import Hold
from core.codes.demand import SeismicDemand
from core.codes.outcomes import FAILS, OUTCOMES, way_key
from core.codes.record_compatibility import Compliance
from core.codes.verdict import make_undetermined
from core.errors import Cancelled, InputError
from core.rocking.history import uses_lanes
from core.setting.check_input import CheckInput
from core.setting.plan import Plan
from core.study.check_cache import CheckCache, run_key
from core.study.governing import governing_run
from core.study.journal import Journal, MemoryJournal, dataclass_from_json
from core.study.progress import Progress
from core.study.results import Assessment, WallResult, WallVerdict
from core.study.variants import flag_missing_variant
from core.study.verdict_uncertainty import add_measures, add_uncertainty
from core.study.wall_result import run_result, wall_result
from core.study.wall_verdict import wall_verdicts
from core.text.sentence import Number, sentence
from core.threads import Batch, Work
from core.variation.assessment import assess_evaluation
from core.variation.evaluate import Evaluation, evaluate
from core.variation.limit_states import check_limit_states
from core.variation.measures import Measure

MIN_TASKS, MAX_SAMPLES = 8, 40_000
"""Least tasks for a thread where runs of a wall are searched side by side; most samples of them, for a quick cancel."""


class StudyContext(NamedTuple):
    """Values that the walls of a study have in common.

    plan, base_dir : of the study
    demand : with what the records add; rules : whether they comply with it, None without a spectrum
    by_state : demands of the limit states, of `limit_state_demands`; state_rules : of `limit_state_compliance`
    ag : of `core.study.how_sure.make_ag_function`, None without a hazard
    journal : of finished searches and checks
    progress : told of each task
    on_wall : told of each WallResult that has its checks
    measures : what would make a wall that fails pass is sought
    """

    plan: Plan
    base_dir: Path
    demand: SeismicDemand | None
    rules: Compliance | None
    by_state: dict[str, SeismicDemand]
    state_rules: dict[str, Compliance | None]
    ag: Callable[[float], float] | None
    journal: Journal | MemoryJournal | None
    progress: Progress
    on_wall: Callable[[WallResult], None]
    measures: bool


WallOutcome = tuple[list[WallResult], tuple[WallVerdict, ...]]
"""Results of one wall of the case, and its verdict, whose numbers of results count from 0; no verdict without a
demand."""


def wall_tasks(given: StudyContext, jobs: int, wait_for: Callable[[int], None] | None = None) -> Iterator[Work]:
    """The work of each wall of a case, which returns Finished. wait_for : as `result_of` takes it"""
    plan, known = given.plan, {}
    for run in plan.runs:
        ida = dataclass_from_json(Ida, given.journal.get(search_key(plan, run))) if given.journal else None
        if ida is not None:
            known[run] = ida
    given.progress.known(known)
    most = (len(plan.runs) - len(known)) // (MIN_TASKS * jobs)
    for span in plan.spans:
        if wait_for:
            wait_for(plan.entries[span[0]].part.origin)
        yield _Wall(given, known, most, span, wait_for is not None).work()


def search_key(plan: Plan, one: tuple[int, int, int]) -> str:
    """Key of a search in the journal. one : (entry, record, sign)"""
    k, record, sign = one
    entry = plan.entries[k]
    return run_key(entry.model, entry.felt[record], sign, plan.method, plan.search)


class _Wall:
    """One wall of a case.

    known : Idas of earlier starts by (entry, record, sign)
    most : runs that are searched side by side, where they are lanes
    span : its entries in the plan
    elsewhere : what was found of it elsewhere came into the journal
    """

    def __init__(
        self, given: StudyContext, known: dict[tuple[int, int, int], Ida], most: int, span: list[int], elsewhere: bool
    ):
        self.given, self.known, self.most, self.elsewhere = given, known, most, elsewhere
        self.entries = {k: given.plan.entries[k] for k in span}
        self.kept = {k: CheckCache(given.journal) for k in span}
        self.results: dict[int, WallResult] = {}

    def work(self) -> Work:
        """Returns WallOutcome; of a wall in which something goes wrong that nobody foresaw, its error. Raises
        InputError, and Cancelled as `Threads.run_works`."""
        try:
            return (yield from self._results())
        except (InputError, Cancelled, OSError, MemoryError):  # of the user, of the machine: no wall is at fault
            raise
        except Exception as error:  # the border of a wall: whatever is wrong in one must not end the others
            return self._failed(error)

    def _failed(self, error: Exception) -> WallOutcome:
        """The wall without a number, undetermined, with what went wrong in it."""
        given, results = self.given, []
        why = sentence("reason", "wall_error", error=type(error).__name__)
        lines = "".join(traceback.format_exception(error))
        for entry in self.entries.values():
            own = entry.part, entry.mechanism, entry.model
            wall = wall_result(*own, [], [], given.plan.search, given.demand, entry.floor)
            if given.demand is not None:
                verdict = make_undetermined(given.demand, why)
                wall = replace(wall, assessment=Assessment(None, (), None, None, verdict))
            results.append(replace(wall, error=lines, warnings=(why, *wall.warnings)))
        return results, wall_verdicts(given.plan.case, tuple(results))

    def _results(self) -> Work:
        given, plan = self.given, self.given.plan
        yield from self._searched()
        if given.demand:
            yield from self._assessed(given.demand)
            yield from self._at_limit_states(given.demand)
            self.results = {k: flag_missing_variant(one, plan.variants) for k, one in self.results.items()}
        if plan.case.analysis.accuracy:
            yield from self._with_accuracy()
        results = list(self.results.values())
        verdicts = wall_verdicts(plan.case, tuple(results))
        if given.demand and verdicts and plan.longest is None:  # of a group of walls the rows alone are kept
            beside = plan, given.base_dir, given.demand, given.ag, results, verdicts[0], given.journal, given.progress
            verdicts = ((yield from add_uncertainty(*beside)),)
        sought = plan.case.wall[results[0].part.origin].sought if results else None
        if (given.measures or sought) and given.demand and verdicts:
            verdict = yield from add_measures(plan, given.base_dir, given.demand, results, verdicts[0], given.journal)
            results[verdict.governing] = advise(results[verdict.governing], verdict.measures, sought)
            verdicts = (verdict,)
        return results, verdicts

    def _searched(self) -> Work:
        """Search q under each record, without a check."""
        given, plan = self.given, self.given.plan
        idas = {one: self.known[one] for k in self.entries for one in plan.runs_of(k) if one in self.known}

        def search_of(group: tuple[tuple[int, int, int], ...]):
            entry = self.entries[group[0][0]]
            motions = [(entry.felt[record], sign) for _, record, sign in group]
            runs = [Run(motion.acceleration, motion.time_step, motion.pga, sign) for motion, sign in motions]
            return lambda stop: incremental_dynamic_analyses(runs, entry.model, plan.method, plan.search, stop)

        def keep(group, idas_of_group: list[Ida]) -> None:
            for one, ida in zip(group, idas_of_group, strict=True):
                idas[one] = ida
                if given.journal:
                    given.journal.add(search_key(plan, one), asdict(ida))
                given.progress.done(one)

        if self.elsewhere and given.journal:
            for one in [one for k in self.entries for one in plan.runs_of(k) if one not in idas]:
                if (kept_ida := dataclass_from_json(Ida, given.journal.get(search_key(plan, one)))) is not None:
                    idas[one] = kept_ida
                    given.progress.done(one)
        groups = []
        for k, entry in self.entries.items():
            runs = [one for one in plan.runs_of(k) if one not in idas]
            longest = max((motion.acceleration.size for motion in entry.felt), default=1)
            lanes = uses_lanes(plan.method, entry.model)
            together = max(1, min(self.most, MAX_SAMPLES // longest)) if lanes else 1
            groups += [tuple(runs[n : n + together]) for n in range(0, len(runs), together)]
        yield Batch({group: search_of(group) for group in groups}, keep)
        for k, entry in self.entries.items():
            runs = plan.runs_of(k)
            run_results = [
                run_result(entry.model, entry.felt[record], record, sign, idas[k, record, sign])
                for _, record, sign in runs
            ]
            motions, own = plan.motions if runs else [], (entry.part, entry.mechanism, entry.model)
            self.results[k] = wall_result(*own, run_results, motions, plan.search, given.demand, entry.floor)

    def _scene(self, k: int, demand: SeismicDemand) -> CheckInput:
        """Scene of the checks of an entry, with q of its searches."""
        wall, scene = self.results[k], self.given.plan.scene(k, demand, self.given.rules, self.kept[k])
        return replace(scene, q_slv=(wall.q_slv_safe_set, wall.q_slv_set))

    def _assessed(self, demand: SeismicDemand) -> Work:
        """Make the checks at the demand: first those of every hinge and mechanism, then what those that pass rest on,
        but of a wall that fails."""
        given = self.given

        def evaluate_entry(k: int):
            return lambda stop: evaluate(self._scene(k, demand), cancelled=stop)

        evaluations = yield Batch({k: evaluate_entry(k) for k in self.entries})
        failing = self._find_failing(evaluations)

        def task(k: int):
            elsewhere = self.entries[k].part.origin in failing
            return lambda stop: assess_evaluation(evaluations[k], stop, elsewhere)

        def checked(k: int, assessment: Assessment) -> None:
            self.results[k] = replace(self.results[k], assessment=assessment)
            given.on_wall(self.results[k])
            given.progress.done(("check", k), self.elsewhere or self.kept[k].made > 0)

        yield Batch({k: task(k) for k in self.entries}, checked)

    def _find_failing(self, evaluations: dict[int, Evaluation]) -> set[int]:
        """Numbers of the walls of the case that fail about one of their hinges, in whichever way they are held."""
        walls: dict[int, list[int]] = {}
        for k, entry in self.entries.items():
            walls.setdefault(entry.part.origin, []).append(k)

        def fails(results: list[int]) -> bool:
            def worst(numbers: list[int]) -> tuple:
                found = [evaluations[results[n]] for n in numbers]
                return way_key((check.outcome, check.zeta, check.scene.demand.zeta_target) for check in found)

            parts = [self.entries[k].part for k in results]
            counted = best_way(parts, worst, lambda n: evaluations[results[n]].loses_hold)
            return any(OUTCOMES[evaluations[results[n]].outcome].judgement == FAILS for n in counted)

        return {origin for origin, results in walls.items() if fails(results)}

    def _at_limit_states(self, demand: SeismicDemand) -> Work:
        """Assess the wall at each limit state of the site."""
        given = self.given

        def task(k: int, wall: WallResult):
            scene = self._scene(k, demand)
            return lambda stop: check_limit_states(
                scene, wall.required_assessment, given.by_state, given.state_rules, stop
            )

        states = yield Batch({k: task(k, wall) for k, wall in self.results.items()} if given.by_state else {})
        for k, state_zetas in states.items():
            self._add(k, states=state_zetas)

    def _with_accuracy(self) -> Work:
        """Make the accuracy statement on the governing run."""
        given, plan = self.given, self.given.plan

        def task(wall: WallResult):
            return lambda stop: make_accuracy_statement(wall, plan.motions, plan.method, plan.search, stop)

        statements = yield Batch(
            {k: task(wall) for k, wall in self.results.items()},
            lambda k, one: given.progress.done(("accuracy", k), one is not None),
        )
        for k, wall in self.results.items():
            self.results[k] = replace(wall, accuracy=statements[k])

    def _add(self, k: int, **parts) -> None:
        """Add parts to the assessment of an entry."""
        wall = self.results[k]
        self.results[k] = replace(wall, assessment=replace(wall.required_assessment, **parts))


def advise(wall: WallResult, measures: tuple[Measure, ...] | None, sought: Hold | None) -> WallResult:
    """The result that decides about a wall with what is to be done about it. measures : of a wall that fails; sought :
    the tie that was to be designed"""
    if measures is None:
        return wall
    found = wall.required_assessment
    to_do = tuple(measure.words for measure in measures) or (sentence("reason", "no_measure"),)
    if sought and not any(measure.is_single_tie for measure in measures):
        to_do = (sentence("reason", "no_tie_there", height=Number(sought.h_m, ".4g")), *to_do)
    return replace(wall, assessment=replace(found, verdict=replace(found.verdict, to_do=to_do)))


def make_accuracy_statement(wall: WallResult, motions, method, search, cancelled) -> Accuracy | None:
    """Accuracy statement on the governing run of a wall; None without a q. motions : of the ground."""
    lowest = governing_run(wall)
    if lowest is None:
        return None
    motion = (wall.floor.motions if wall.floor else motions)[lowest.motion]
    other = next((r.ida.q for r in wall.runs if r.motion == lowest.motion and r.polarity != lowest.polarity), None)
    return make_accuracy(motion, lowest.polarity, lowest.ida, other, wall.model, method, search, cancelled)
