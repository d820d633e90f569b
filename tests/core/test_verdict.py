"""The verdict: every code, its order, its words."""

import pytest

from core import study
from core.case_reader import parse_case
from core.compliance import Compliance
from core.demand import demand_of
from core.demand_check import DemandCheck
from core.kinematic import Check
from core.verdict import SENTENCES, Circumstances, verdict

SPECTRUM = {"code": "EN1998", "soil": "B", "type": 1}


def case(ag=0.26, wall=None, **demand):
    return parse_case(
        {
            "wall": [{"name": "w", "height_m": 7.0, "thickness_m": 0.83, "mechanism": "two_sided",
                      **(wall or {})}],
            "demand": {"ag_g": ag, "spectrum": SPECTRUM, **demand},
        }
    )  # fmt: skip


def said(dynamic=None, nonlinear=None, q2=None, compatible=True, records=7, bundled=False, ag=0.26,
         wall=None, circumstances=None, **demand):  # fmt: skip
    """The verdict of checks with these zeta."""
    circumstances = circumstances or {}
    asked = case(ag, wall, **demand)
    target = asked.demand.zeta_target
    found = []
    for name, zeta in (("dynamic", dynamic), ("nonlinear", nonlinear), ("linear_q_code", q2)):
        if zeta is not None:
            found.append(Check(name, "", "-", None, None, zeta, zeta >= target))
    check = None
    if dynamic is not None:
        holds = dynamic >= 1.0
        check = DemandCheck("SLV", (), 0, 0.1, 0.1, "mean", 0.4, dynamic, holds, dynamic >= target)
    rules = Compliance(None, None, None, None, (), records, compatible)
    return verdict(
        asked.wall[0], asked.wall[0].block(), demand_of(asked, None), tuple(found), check,
        rules if compatible is not None else None, Circumstances(records, bundled, **circumstances), None,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("wanted", "given"),
    [
        ("verified", {"dynamic": 1.2, "nonlinear": 0.9, "q2": 1.1}),
        ("verified_refined", {"dynamic": 1.2, "nonlinear": 1.1, "q2": 0.8}),
        ("q2_unsafe", {"dynamic": 0.8, "nonlinear": 1.2, "q2": 1.1}),
        ("not_verified", {"dynamic": 0.8, "nonlinear": 1.2, "q2": 0.9}),
        ("verified_refined", {"nonlinear": 1.2, "q2": 0.9}),
        ("q2_unsafe", {"nonlinear": 0.9, "q2": 1.2}),
        ("verified", {"q2": 1.2}),
        ("not_verified", {"q2": 0.7}),
        ("indicative", {"dynamic": 1.2, "q2": 1.1, "compatible": False}),
        ("indicative", {"dynamic": 0.7, "q2": 0.6, "compatible": None}),
        ("indicative", {"dynamic": 1.2, "q2": 1.1, "records": 2}),
        ("indicative", {"dynamic": 1.2, "q2": 1.1, "bundled": True}),
        ("indicative", {"dynamic": 1.2, "q2": 1.1, "demand_scaling": "pga"}),
        ("indicative", {"nonlinear": 1.2, "q2": 1.1, "wall": {"thickness_m": 3.0}, "ag": 0.9}),
        ("undetermined", {"dynamic": 1.015, "q2": 0.9}),
        ("verified_refined", {"dynamic": 1.03, "q2": 0.9}),
        ("verified_refined", {"nonlinear": 1.015, "q2": 0.9}),
        ("undetermined", {"dynamic": 1.2, "q2": 1.1, "wall": {"base_z_m": 4.0}}),
        ("not_activated", {"dynamic": 3.0, "q2": 3.0, "ag": 0.05}),
        ("not_activated", {"dynamic": 3.0, "q2": 3.0, "ag": 0.05, "compatible": False}),
        ("indicative", {"dynamic": 1.2, "q2": 1.1, "circumstances": {"both_signs": False}}),
        ("indicative", {"dynamic": 1.2, "q2": 1.1, "circumstances": {"exact": False}}),
        ("verified", {"dynamic": 1.2, "q2": 1.1, "ag": 0.05, "circumstances": {"strongest": 1.0}}),
        ("not_verified", {"dynamic": 0.6, "ag": 0.05}),
        ("verified", {"dynamic": 0.85, "q2": 0.9, "zeta_target": 0.8}),
    ],
)
def test_that_the_checks_give_this_verdict(wanted, given):
    found = said(**given)
    assert found.code == wanted
    if wanted in ("indicative", "undetermined"):
        assert found.reasons


def test_that_an_outcome_without_number_leaves_the_wall_undetermined():
    asked = case()
    check = DemandCheck("SLV", (), 0, None, None, "mean", 0.4, None, False, False)
    found = verdict(
        asked.wall[0], asked.wall[0].block(), demand_of(asked, None),
        (Check("dynamic", "", "-", None, None, None, None),), check,
        Compliance(None, None, None, None, (), 7, True), Circumstances(7), None,
    )  # fmt: skip
    assert found.code == "undetermined" and "without a number" in found.reasons[0][0]


def test_that_the_rule_failing_at_a_weaker_motion_is_not_verified_in_silence():
    asked = case()
    check = DemandCheck("SLV", (), 0, 0.1, 0.1, "mean", 0.4, 0.7, True, False)
    found = verdict(
        asked.wall[0], asked.wall[0].block(), demand_of(asked, None),
        (Check("dynamic", "", "-", None, None, 0.7, False),), check,
        Compliance(None, None, None, None, (), 7, True), Circumstances(7), None,
    )  # fmt: skip
    assert found.code == "undetermined" and "weaker motion" in found.reasons[0][0]


def test_that_a_check_that_disagrees_is_named():
    found = said(dynamic=1.2, nonlinear=0.9, q2=1.1)
    assert len(found.reasons) == 1 and "zeta 0.90: not passed" in found.reasons[0][0]
    assert said(dynamic=1.2, nonlinear=1.3, q2=1.1).reasons == ()


def test_that_a_soil_factor_nobody_gave_is_said(tmp_path):
    table = {"wall": [{"name": "w", "height_m": 5.0, "thickness_m": 0.9, "mechanism": "two_sided"}]}
    result = study.run(parse_case({**table, "demand": {"ag_g": 0.17}}), base_dir=tmp_path)
    verdict_ = result.walls[0].assessment.verdict
    assert verdict_.code == "indicative" and "taken as 1" in verdict_.reasons[0][0]
    given = study.run(
        parse_case({**table, "demand": {"ag_g": 0.17, "soil_factor": 1.0}}), base_dir=tmp_path
    )
    assert given.walls[0].assessment.verdict.code != "indicative"


def test_that_no_sentence_says_safe():
    for english, italian in SENTENCES.values():
        assert "safe" not in english.lower()
        assert "sicura" not in italian.lower()


def test_that_a_wall_above_the_ground_gets_no_check_at_all(tmp_path):
    asked = case(wall={"base_z_m": 3.5})
    result = study.run(asked, base_dir=tmp_path)
    wall = result.walls[0]
    assert wall.assessment.checks == () and wall.code_check == ()
    assert wall.assessment.verdict.code == "undetermined"
    assert "ground motion alone" in wall.assessment.verdict.reasons[0][0]


def test_that_sld_is_checked_without_q(tmp_path):
    result = study.run(case(limit_state="SLD"), base_dir=tmp_path)
    (check,) = result.walls[0].assessment.checks
    assert check.q == 1.0
