"""A church facade of L'Aquila by hand: what each check asks of a tie; a verdict that names what fails."""

import pytest

from core.case.reader import read_case
from core.report import json_report
from core.study.run import run
from tests.conftest import ROOT

CASE = ROOT / "tests" / "validation" / "cases" / "church.toml"


@pytest.fixture(scope="module")
def result(kept):
    return kept("church", lambda: run(read_case(CASE), base_dir=CASE.parent, jobs=2))


@pytest.mark.shows("verdict.names_failures")
def test_that_the_verdict_names_every_check_that_fails(result):
    (entry,) = json_report.results(result)["verdicts"]
    assert entry["code"] == "not_verified" and entry["zeta_e"] < 1.0
    for words in ("displacement 0.62", "q = 2 0.28", "FC on the demand", "lower q of the histories"):
        assert words in entry["text_en"]
    assert "spostamento 0,62" in entry["text_it"]
    assert {"weaker_fails", "generated_motions"} <= {one["key"] for one in entry["limits"]}


@pytest.mark.shows("lifts.velocity_ratio")
def test_that_a_velocity_ratio_of_one_s_own_is_shown_with_what_theory_makes_of_it(result):
    """The ratio of a wall that pushes a roof is derived; 0.30 in its place verifies the facade."""
    from dataclasses import replace

    case = read_case(CASE)
    given = replace(case, wall=(replace(case.wall[0].without_sought(), velocity_ratio=0.30),))
    found = run(given, base_dir=CASE.parent, jobs=2).walls[0].assessment
    derived = result.walls[0]
    assert found.verdict.zeta_e > 1.0 > derived.assessment.verdict.zeta_e
    assert found.verdict.code == "indicative"
    said = {limit.code: dict(limit.values) for limit in found.verdict.limits}["lift_velocity_ratio"]
    assert said["theory"] == derived.restitution.ratio_at_rest
    assert said["zeta_theory"].value == pytest.approx(derived.assessment.verdict.zeta_e, rel=0.03)
