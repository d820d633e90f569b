"""The count of analyses that a run prints: every multiplier that is integrated, in a search, a check or a history."""

import numpy as np

from core.case.reader import read_case
from core.rocking import lane_scheduler
from core.rocking.analysis_count import MADE, AnalysisCount
from core.rocking.history import integrate_history, scan_multipliers
from core.rocking.methods import METHODS
from core.study.run import run
from core.threads import Threads
from tests.conftest import ROOT


def test_that_each_multiplier_and_each_history_is_one_analysis(make_model):
    model = make_model()
    ground, before = np.sin(np.arange(200) * 0.05), MADE.total
    scan_multipliers(METHODS["taylor"], ground, 0.01, np.ones(7), model, np.zeros(7, np.int64), np.zeros(7))
    integrate_history(ground, 0.01, 1.0, model)
    assert MADE.total - before == 8


def test_that_no_analysis_is_lost_between_threads():
    count = AnalysisCount()
    Threads(8, lambda: False).run({k: lambda _: [count.add(1) for _ in range(1000)] for k in range(8)})
    assert count.total == 8000


def test_that_a_run_counts_the_analyses_of_its_kernels(monkeypatch):
    """The same as counted at the door of the kernels that take many multipliers, single histories beside them."""
    made, real = [], lane_scheduler.scan

    def counted(order, grounds, which, scales, *others):
        made.append(scales.size)
        return real(order, grounds, which, scales, *others)

    monkeypatch.setattr(lane_scheduler, "scan", counted)
    case = read_case(ROOT / "tests" / "cases" / "verdict.toml")
    result = run(case, base_dir=ROOT / "tests" / "cases", jobs=2)
    searches = sum(one.ida.analyses for wall in result.walls for one in wall.runs)
    assert 0 < searches < sum(made) <= result.analyses
