"""The checks of a changed wall are those of its run."""

import pytest

from core.case.rules import parse_case
from core.errors import InputError
from core.study.plan import read_inputs
from core.study.run import run
from core.study.what_if import setting_of, with_wall, zetas
from tests.conftest import ROOT
from tests.core.study.test_sensitivity import CASES, LOADED, case_of


def test_that_zeta_of_all_hinges_is_that_of_the_run():
    table = case_of(LOADED, building={"height_m": 6.0, "storeys": 3, "period_s": 0.3})
    result = run(parse_case(table), base_dir=CASES)
    case = parse_case(table)
    found = zetas(setting_of(case, 0, CASES, read_inputs(case, CASES)))
    assert len(result.walls) > 1
    for label, zeta in found.by_check.items():
        each = [check.zeta for wall in result.walls for check in wall.assessment.checks if check.label == label]
        assert zeta == min(each), label
    verdict = result.walls[result.verdicts[0].governing].assessment.verdict
    assert found.zeta == verdict.zeta_e and found.sure == (verdict.zeta_e >= 1.0)


def test_that_every_point_of_the_grid_gives_zeta_of_the_run():
    from core.case.reader import read_case

    case = read_case(ROOT / "resources" / "cases" / "example.toml")
    inputs = read_inputs(case, CASES)
    result = run(case, base_dir=CASES)
    for k, verdict in enumerate(result.verdicts):
        found = zetas(setting_of(case, k, CASES, inputs), every=1)
        assert found.by_check["dynamic"] == result.walls[verdict.governing].assessment.dynamic.zeta
        kinematic = zetas(setting_of(case, k, CASES, inputs), every=0)
        assert "dynamic" not in kinematic.by_check and set(kinematic.by_check) < set(found.by_check)


def test_that_a_wall_that_breaks_a_rule_is_refused():
    from dataclasses import replace

    case = parse_case(case_of(LOADED))
    here = setting_of(case, 0, CASES, read_inputs(case, CASES))
    with pytest.raises(InputError):
        with_wall(here, replace(here.case.wall[0], hinge_setback_m=0.4))
