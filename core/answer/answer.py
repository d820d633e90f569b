"""The answer of a run for each wall: what decides about it, its lowest zeta, its runs and rows. Window, drawing, tree,
note, workbook, JSON and terminal read it and choose nothing."""

import heapq
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

from core.case.plausible import QUESTIONS
from core.case.register import row_of_part
from core.case.wall import Wall
from core.codes.assumption import Assumption
from core.codes.dynamic_check import DemandRun, DynamicCheck
from core.codes.outcomes import FAILS, OUTCOMES, min_if_all_known, severity_key
from core.study.governing import governing_run
from core.study.results import StudyResult, WallResult, WallVerdict
from core.study.wall_verdict import counted_walls, sort_by_severity
from core.text.sentence import Sentence
from core.variation.measures import Measure


class Decision(NamedTuple):
    """A zeta of a wall, and whose it is.

    result : its number in the study; mechanism : name of the register; hinge : above the base of the wall [m], of a
    wall that bends where it begins to; outcome, check : codes
    """

    result: int
    mechanism: str
    hinge: float
    outcome: str
    check: str | None
    zeta: float | None


@dataclass(frozen=True)
class Answer:
    """What a run says of a wall of its case."""

    result: StudyResult
    verdict: WallVerdict

    @property
    def wall(self) -> Wall:
        """The wall of the case."""
        return self.verdict.wall

    @cached_property
    def governing(self) -> Decision:
        """What decides."""
        return self._decision(self.verdict.governing)

    @cached_property
    def least(self) -> Decision | None:
        """What has the lowest zeta; None where one is not known."""
        decisions = [self._decision(k) for k in self.verdict.results]
        if any(decision.zeta is None for decision in decisions):
            return None
        return min(decisions, key=lambda decision: decision.zeta or 0.0)

    @property
    def lower_elsewhere(self) -> Decision | None:
        """What has a zeta that is lower than that of what decides, as both are shown; None where nothing has."""
        least, zeta = self.least, self.governing.zeta
        if least is None or least.zeta is None or zeta is None:
            return None
        return least if round(least.zeta, 2) < round(zeta, 2) else None

    @property
    def zeta_required(self) -> float:
        return self.decides.required_assessment.verdict.zeta_target

    @property
    def decides(self) -> WallResult:
        """The result that decides."""
        return self.result.walls[self.verdict.governing]

    @property
    def share(self) -> float | None:
        """Lowest zeta over the one required; None of motions that are not at the demand, whose zeta is no share."""
        checks = {self._decision(k).check for k in self.verdict.results}
        apart = "dynamic" in checks and not self.result.motions_at_demand
        if self.least is None or self.least.zeta is None or apart:
            return None
        return self.least.zeta / self.zeta_required

    @cached_property
    def records(self) -> tuple[DemandRun, ...]:
        """The runs at the demand of what decides, by the model that decided: what overturns and the largest first."""
        return ordered_runs(self.decides.required_assessment.dynamic)

    @cached_property
    def hangs_on(self) -> Measure | Assumption | None:
        """Choose what its outcome hangs on: of a wall that fails the first measure that makes it pass, of another one
        the input that costs most at its other end; None where there is none."""
        if OUTCOMES[self.governing.outcome].judgement == FAILS:
            return next(iter(self.verdict.measures or ()), None)
        return costliest(self.decides.required_assessment.verdict.assumptions)

    def _decision(self, k: int) -> Decision:
        wall = self.result.walls[k]
        verdict, row = wall.required_assessment.verdict, row_of_part(wall.part, wall.mechanism)
        return Decision(k, row.name, wall.part.hinge, verdict.code, verdict.governing, verdict.zeta_e)


def costliest(rows: Iterable[Assumption]) -> Assumption | None:
    """The row of an outcome that costs most at its other end: they are sorted by that."""
    return next((row for row in rows if row.has_switch and row.zeta is not None), None)


def answers_worst_first(result: StudyResult) -> list[Answer]:
    """The answers of a run, the worst first; none without a demand."""
    return [Answer(result, verdict) for verdict in sort_by_severity(result.verdicts, result.walls)]


def worst_row(result: StudyResult, rows: Iterable[int]) -> int | None:
    """Row of the case whose wall has the worst answer, of some rows; None without a demand."""
    rows = set(rows)
    origins = (answer.decides.part.origin for answer in answers_worst_first(result))
    return next((origin for origin in origins if origin in rows), None)


def ordered_runs(dynamic: DynamicCheck | None) -> tuple[DemandRun, ...]:
    """The runs of a check by histories at the demand: what overturns and the largest first; none without a check."""
    runs = dynamic.runs if dynamic is not None else ()
    return tuple(sorted(runs, key=lambda run: (run.peak_ratio is not None, not run.exceeded, -(run.peak_ratio or 0.0))))


def run_shown_first(wall: WallResult) -> int:
    """Index of the run of a result that turns it most at the demand, without a check by histories of the one with the
    lowest q; 0 where none has a number."""
    ordered = ordered_runs(wall.assessment.dynamic if wall.assessment else None)
    first = ordered[0] if ordered else governing_run(wall)
    if first is None:
        return 0
    places = (k for k, run in enumerate(wall.runs) if (run.motion, run.polarity) == (first.motion, first.polarity))
    return next(places, 0)


def collect_actions(result: StudyResult, ordered: Iterable[WallVerdict]) -> dict[Sentence, list[WallVerdict]]:
    """What is to be done, each sentence once with the walls it is of: of a wall that of all that decides as it does."""
    walls: dict[Sentence, list[WallVerdict]] = {}
    for verdict in ordered:
        decides = result.walls[verdict.governing].assessment
        found = [assessment.verdict for k in verdict.results if (assessment := result.walls[k].assessment) is not None]
        same = [each for each in found if decides is not None and each.code == decides.verdict.code]
        actions = [*(line for each in same for line in each.to_do), *find_questions(result, verdict)]
        for action in dict.fromkeys(actions):
            walls.setdefault(action, []).append(verdict)
    return walls


def find_questions(result: StudyResult, verdict: WallVerdict) -> tuple[Sentence, ...]:
    """What is asked of the values of a wall that are seldom so, whatever its outcome."""
    assessment = result.walls[verdict.governing].assessment
    lines = (*(assessment.verdict.limits if assessment else ()), *verdict.extra)
    return tuple(dict.fromkeys(line for line in lines if line.code in QUESTIONS))


def zeta_range(walls: Iterable[WallResult]) -> tuple[float | None, float | None]:
    """Least and largest zeta of some results that are known; (None, None) of none."""
    zetas = [wall.required_assessment.verdict.zeta_e for wall in walls]
    known = [zeta for zeta in zetas if zeta is not None]
    return min(known, default=None), max(known, default=None)


def zeta_by_check(result: StudyResult, origin: int) -> dict[str, float | None]:
    """Label of a check -> its lowest zeta of all that counts about a wall of the case, None where one is not known."""
    zetas: dict[str, list[float | None]] = {}
    for wall in counted_walls(result):
        if wall.part.origin == origin and wall.assessment:
            for check in wall.assessment.checks:
                zetas.setdefault(check.label, []).append(check.zeta)
    return {label: min_if_all_known(each) for label, each in zetas.items()}


def smallest_zetas(result: StudyResult) -> dict[str, float | None]:
    """ "" and limit state -> the lowest zeta of all walls, at the limit state of the demand and at the others; None
    where one is not known."""
    assessments = [wall.assessment for wall in counted_walls(result) if wall.assessment]
    zetas: dict[str, list[float | None]] = {"": [assessment.verdict.zeta_e for assessment in assessments]}
    for assessment in assessments:
        for state in assessment.states:
            zetas.setdefault(state.state, []).append(state.zeta)
    return {state: min_if_all_known(each) for state, each in zetas.items()}


def zetas_so_far(walls: Sequence[WallResult], planned: Mapping[int, int]) -> dict[int, tuple[float | None, bool]]:
    """Row of a wall of a run that is under way -> (the smallest zeta of its results that are there, whether these are
    all). planned : row -> number of its results"""
    of_row: dict[int, list[float | None]] = {}
    for wall in walls:
        of_row.setdefault(wall.part.origin, []).append(wall.assessment.verdict.zeta_e if wall.assessment else None)
    return {
        row: (min((zeta for zeta in zetas if zeta is not None), default=None), len(zetas) >= planned[row])
        for row, zetas in of_row.items()
    }


def worst_so_far(walls: Sequence[WallResult]) -> list[WallResult]:
    """Choose of each wall of a run that is under way the result with the smallest zeta, the smallest first."""

    def place(wall: WallResult) -> tuple[bool, float]:
        zeta = wall.assessment.verdict.zeta_e if wall.assessment else None
        return zeta is None, zeta or 0.0

    first: dict[int, WallResult] = {}
    for wall in sorted(walls, key=place):
        first.setdefault(wall.part.origin, wall)
    return list(first.values())


class Worst:
    """The worst of very many rows of walls: by the table of outcomes, without a demand by q."""

    def __init__(self, count: int):
        self.count = count
        self._kept: list[tuple[tuple, dict[str, Any]]] = []

    def add(self, rows: Iterable[dict[str, Any]]) -> None:
        """Place rows among the worst, by their columns of the table of a large case."""
        placed = [(self._place(row), row) for row in rows]
        self._kept = heapq.nsmallest(self.count, self._kept + placed, key=lambda entry: entry[0])

    @property
    def rows(self) -> list[dict[str, Any]]:
        """The worst rows, the worst first."""
        return [row for _, row in self._kept]

    @staticmethod
    def _place(row: dict[str, Any]) -> tuple:
        if row["verdict"] is not None:
            order: tuple = severity_key(row["verdict"], row["zeta_e"], row["zeta_target"])
        else:
            order = (0, row["q_set"] is None, row["q_set"] or 0.0)
        return *order, row["wall"], row["hinge_m"]
