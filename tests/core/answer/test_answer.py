"""The answer of a run for each wall; that no face chooses one of its own."""

import ast
from pathlib import Path

import pytest

from core.answer.answer import (
    Answer,
    answers_worst_first,
    ordered_runs,
    run_shown_first,
    smallest_zetas,
    worst_so_far,
    zeta_by_check,
    zetas_so_far,
)
from core.codes.outcomes import FAILS, OUTCOMES, PASSES, severity_key
from core.study.run import run
from core.variation import measures
from tests.clauses_alone import parse_case
from tests.conftest import ROOT
from tests.core.variation.random_walls import random_tables


@pytest.fixture(scope="module")
def results():
    kept, measures.MOST = measures.MOST, 0
    yield [run(parse_case(table), base_dir=ROOT) for table in random_tables(12, first=43_000)]
    measures.MOST = kept


@pytest.mark.shows("answer.one")
def test_that_an_answer_names_what_decides_and_what_has_the_lowest_zeta(results):
    apart = 0
    for result in results:
        for answer in answers_worst_first(result):
            decides, least = answer.governing, answer.least
            assert result.walls[decides.result] is answer.decides
            assert (decides.outcome, decides.zeta) == (
                answer.decides.assessment.verdict.code,
                answer.decides.assessment.verdict.zeta_e,
            )
            zetas = [result.walls[k].assessment.verdict.zeta_e for k in answer.verdict.results]
            if None in zetas:
                assert least is None and answer.lower_elsewhere is None and answer.share is None
                continue
            assert least.zeta == min(zetas) == answer.verdict.zeta_least
            assert result.walls[least.result].assessment.verdict.zeta_e == least.zeta
            apart += answer.lower_elsewhere is not None
            assert (answer.lower_elsewhere is None) == (round(least.zeta, 2) >= round(decides.zeta, 2))
    assert apart > 0


def test_that_the_worst_answer_is_first_and_what_is_there_of_a_run_is_in_order(results):
    walls = [wall for result in results for wall in result.walls]
    for result in results:
        orders = [
            severity_key(one.governing.outcome, one.governing.zeta, one.zeta_required)
            for one in answers_worst_first(result)
        ]
        assert orders == sorted(orders)
        smallest = smallest_zetas(result)[""]
        counted = [result.walls[k].assessment.verdict.zeta_e for v in result.verdicts for k in v.results]
        assert smallest == (None if None in counted else min(counted))
        by_check = zeta_by_check(result, 0)
        assert set(by_check) == {
            check.label for v in result.verdicts for k in v.results for check in result.walls[k].assessment.checks
        }
    half = walls[: len(walls) // 2]
    so_far = zetas_so_far(half, {0: len(walls)})
    known = [wall.assessment.verdict.zeta_e for wall in half if wall.assessment.verdict.zeta_e is not None]
    assert so_far == {0: (min(known), False)} and zetas_so_far(half, {0: len(half)})[0][1]
    (worst,) = worst_so_far(half)
    assert worst.assessment.verdict.zeta_e == min(known)


def test_that_runs_stand_in_the_order_of_their_peaks_what_overturns_first(of_seven):
    for wall in of_seven.walls:
        runs = ordered_runs(wall.assessment.dynamic)
        peaks = [float("inf") if run.peak_ratio is None else run.peak_ratio for run in runs]
        assert len(runs) == len(wall.assessment.dynamic.runs) and runs[0].exceeded == any(r.exceeded for r in runs)
        assert [run.peak_ratio for run in runs].count(None) == sum(peak == float("inf") for peak in peaks)
        assert peaks == sorted(peaks, reverse=True) or any(run.exceeded for run in runs)
        first = wall.runs[run_shown_first(wall)]
        assert (first.motion, first.polarity) == (runs[0].motion, runs[0].polarity)
    (answer,) = (one for one in answers_worst_first(of_seven) if one.decides is of_seven.walls[0])
    assert isinstance(answer, Answer) and answer.records == ordered_runs(of_seven.walls[0].assessment.dynamic)


CHOOSING = {"min", "max", "sorted", "sort", "nsmallest", "severity_key", "worst_outcome", "min_if_all_known", "way_key"}
"""What chooses among zetas or outcomes."""

GEOMETRY = {
    "app/views/ladder.py": "length of an axis",
    "app/views/sure_tab.py": "ends of a bar of one input",
    "app/shell/live_answer.py": "length of an axis, bars in the order of their length",
    "core/report/certainty_sheet.py": "ends of a bar of one input",
    "core/report/note/certainty.py": "ends of a bar of one input",
    "core/report/plots.py": "whether an axis is logarithmic",
}
"""Files that draw zetas: what they order or bound is a figure, no answer."""

ANSWERS = {"zeta", "zetas", "zeta_e", "zeta_least", "outcome", "severity", "known_zetas", "peak_ratio"}


def names_in(node: ast.AST) -> set[str]:
    every = ast.walk(node)
    return {n.attr if isinstance(n, ast.Attribute) else n.id for n in every if isinstance(n, ast.Attribute | ast.Name)}


@pytest.mark.shows("answer.one")
def test_that_no_face_chooses_among_zetas_and_outcomes():
    choosing = []
    for folder in ("app", "core/report"):
        for path in sorted(Path(ROOT, folder).rglob("*.py")):
            name = path.relative_to(ROOT).as_posix()
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
                if not isinstance(node, ast.Call) or name in GEOMETRY:
                    continue
                called = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
                inside = set().union(*(names_in(part) for part in (*node.args, *node.keywords)), set())
                if called in CHOOSING and inside & ANSWERS:
                    choosing.append(f"{name}:{node.lineno}")
    assert choosing == []


def fails_and_passes(result) -> int:
    """Compare outcome, zeta and what follows from it of each result and wall; how many were compared."""
    compared = 0
    for answer in answers_worst_first(result):
        for k in answer.verdict.results:
            wall = result.walls[k]
            verdict, risk = wall.assessment.verdict, wall.assessment.risk
            judgement, zeta = OUTCOMES[verdict.code].judgement, verdict.zeta_e
            if zeta is None:
                continue
            compared += 1
            assert judgement != FAILS or zeta <= verdict.zeta_target * (1.0 + 1e-9), wall.name
            assert judgement != PASSES or zeta >= verdict.zeta_target * (1.0 - 1e-9), wall.name
            if risk is not None and result.demand.limit_state == "SLV":
                assert risk.pga == pytest.approx(zeta * result.demand.pga, rel=1e-9)
        fails = OUTCOMES[answer.governing.outcome].judgement == FAILS
        if fails and answer.least is not None:
            assert answer.least.zeta <= answer.zeta_required * (1.0 + 1e-9)
            assert answer.share is None or answer.share <= 1.0 + 1e-9
    return compared


@pytest.mark.shows("answer.one")
def test_that_no_wall_that_fails_shows_a_zeta_above_what_is_required(results):
    assert sum(map(fails_and_passes, results)) > 12


@pytest.mark.long
@pytest.mark.parametrize("seed", range(46_000, 46_060, 10))
def test_that_walls_under_records_show_no_zeta_that_contradicts_their_outcome(seed, monkeypatch):
    monkeypatch.setattr(measures, "MOST", 0)
    cases = (parse_case(table) for table in random_tables(10, histories=True, first=seed))
    assert sum(fails_and_passes(run(case, base_dir=ROOT)) for case in cases) > 10
