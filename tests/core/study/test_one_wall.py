"""One wall run alone: what the whole case says of it; its table, row by row."""

from dataclasses import replace

import pytest

from core.case.rules import parse_case
from core.study.journal import MemoryJournal
from core.study.one_wall import run_at_alternatives, run_wall
from core.study.run import run
from tests.conftest import ROOT

WALL = {"mechanism": "one_sided", "base_z_m": 0.0, "unit_weight_kn_m3": 18.0, "hold": [{"kind": "cross_walls"}]}
DEMAND = {"ag_g": 0.15, "spectrum": {"code": "NTC2018", "f0": 2.4, "tc_star_s": 0.33, "soil": "B", "topography": "T1"}}


def case_of(*walls, **sections):
    return parse_case({"wall": [WALL | wall for wall in walls], "demand": DEMAND} | sections)


CASES = [
    case_of(
        {"name": "low", "height_m": 4.0, "thickness_m": 0.5, "velocity_ratio": 0.7},
        {"name": "tall", "height_m": 12.0, "thickness_m": 0.6, "mechanism": "two_sided"},
        {"name": "held", "height_m": 6.0, "thickness_m": 0.45, "mechanism": "vertical_bending"},
        generate={"count": 2},
        analysis={"q_step": 0.05},
    ),
    case_of(
        {
            "name": "both",
            "velocity_ratio": 0.7,
            "height_m": 5.0,
            "thickness_m": 0.6,
            "hinge_heights": [2.0],
            "mechanism": "both",
        },
        {
            "name": "roof",
            "height_m": 5.0,
            "thickness_m": 0.6,
            "load": [{"kind": "vertical", "kn_m": 10.0, "d_m": 0.3, "h_m": 5.0, "mass": "none"}],
        },
    ),
]


@pytest.mark.shows("window.live")
@pytest.mark.parametrize("case", CASES)
def test_that_a_wall_run_alone_is_judged_as_beside_all_others(case):
    whole = run(case, base_dir=ROOT)
    for row, verdict in enumerate(whole.verdicts):
        alone = run_wall(case, row, ROOT, None)
        beside = [whole.walls[k].assessment for k in sorted(verdict.results)]
        judged = [(one.checks, one.verdict) for one in beside]
        if verdict.measures is not None:  # which are sought of a wall that fails in the whole case alone
            place = sorted(verdict.results).index(verdict.governing)
            judged[place] = judged[place][0], replace(judged[place][1], to_do=())
        assert repr([(wall.assessment.checks, wall.assessment.verdict) for wall in alone.walls]) == repr(judged)
        assert alone.verdicts[0].governing == verdict.governing - min(verdict.results)


@pytest.mark.parametrize(("case", "row"), [(CASES[0], 0), (CASES[1], 1)])
def test_that_each_row_turned_has_the_zeta_of_the_table(case, row):
    memory = MemoryJournal()
    result = run_wall(case, row, ROOT, memory)
    rows = result.walls[result.verdicts[0].governing].assessment.verdict.assumptions
    switched = [one for one in rows if one.has_switch]
    assert switched
    for one in switched:
        made = len(memory.found)
        found = run_at_alternatives(result, [one], memory)
        zetas = (None,) if found is None else {check.zeta for check in found.checks}
        assert one.zeta in zetas, one.key
        # of a row that turns the check with q alone the histories were not searched to their end
        by_histories = found is not None and found.decides.name == "dynamic" and not one.check
        assert len(memory.found) == made or not by_histories  # what the table has of the histories was made for it
