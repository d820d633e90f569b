"""A wall, a limit state, a tie are judged by one rule: the worst outcome, what is unknown never better than known."""

import copy
import io
from dataclasses import replace
from pathlib import Path

import pytest
from openpyxl import load_workbook

from core.codes.dynamic_check import DynamicCheck
from core.codes.kinematic import zeta_with_and_without_ties
from core.codes.outcomes import OUTCOMES, PASSES, min_if_all_known, severity_key
from core.errors import InputError
from core.report.large_report import NAMED, Tally
from core.report.steps import Steps
from core.report.workbook import WorkbookReport
from core.study.run import run
from tests.clauses_alone import parse_case
from tests.core.variation.random_walls import random_tables
from tests.holds import behind, sought

CASES = Path(__file__).parent


def ties_of(wall):
    """The ties of a wall among its holds, those that are sought too."""
    return [hold for hold in wall.get("hold", ()) if hold["kind"] == "tie"]


def made(table):
    """The result of a table, None of a wall that a rule refuses once its loads are known; what holds a wall but its
    ties is shown, without which no hinge passes by clauses alone."""
    for wall in table["wall"]:
        if wall["mechanism"] != "two_sided":
            wall |= {"hold": [*behind("drawing"), *ties_of(wall)]}
    try:
        return run(parse_case(table), base_dir=CASES)
    except InputError:
        return None


def rank(code):
    return list(OUTCOMES).index(code)


@pytest.mark.shows("verdict.worst", "verdict.zeta_least")
@pytest.mark.parametrize("walls", [12, pytest.param(40, marks=pytest.mark.long)])
def test_that_a_wall_has_the_worst_outcome_of_its_hinges_and_the_least_zeta(walls):
    milder = 0
    for table in random_tables(walls):
        result = made(table)
        if result is None:
            continue
        (wall,) = result.verdicts
        hinges = [result.walls[k].assessment.verdict for k in wall.results]
        code = result.walls[wall.governing].assessment.verdict.code
        assert rank(code) == min(rank(hinge.code) for hinge in hinges)
        alike = [hinge.zeta_e for hinge in hinges if hinge.code == code]
        assert None in alike or hinges[0].zeta_e == min(alike)
        assert wall.zeta_least == min_if_all_known(hinge.zeta_e for hinge in hinges)
        milder += any(
            hinge.zeta_e is not None and hinges[0].zeta_e and hinge.zeta_e < hinges[0].zeta_e for hinge in hinges
        )
        if wall.risk is not None:
            assert wall.risk.pga == pytest.approx(wall.zeta_least * result.demand.pga)
    assert milder >= walls // 40  # the hinge with the lowest zeta is not always the one that decides


def test_that_a_hinge_of_worse_outcome_decides_though_another_has_the_lower_zeta():
    wall = {"name": "w", "height_m": 8.0, "thickness_m": 0.4, "mechanism": "one_sided", "base_z_m": 0.0}
    wall |= {"unit_weight_kn_m3": 18.0, "hold": behind(), "unloaded_confirmed": True}
    spectrum = {"code": "NTC2018", "f0": 2.45, "tc_star_s": 0.33, "soil": "B", "topography": "T1"}
    building = {"height_m": 9.0, "storeys": 3, "period_s": 0.6}
    result = made({"wall": [wall], "building": building, "demand": {"ag_g": 0.1, "spectrum": spectrum}})
    base, _, upper = (one.assessment.verdict for one in result.walls)
    assert base.code == "verified_refined" and upper.code == "not_activated" and upper.zeta_e < base.zeta_e
    assert result.verdicts[0].governing == 0


LEFT_OUT = ("hold", "unloaded_confirmed", "elastic_modulus_mpa", "length_m")


def check_left_out(table) -> int:
    """A wall with each of LEFT_OUT left out, of its holds all but its ties. How many were compared."""
    compared, whole = 0, made(table)
    if whole is None:
        return 0
    before = whole.walls[whole.verdicts[0].governing].assessment.verdict
    for key in LEFT_OUT:
        changed = copy.deepcopy(table)
        wall = changed["wall"][0]
        left = {"hold": ties_of(wall)} if key == "hold" and ties_of(wall) else {}
        if wall.pop(key, None) is None:
            continue
        wall |= left
        if (bare := made(changed)) is None:
            continue
        after = bare.walls[bare.verdicts[0].governing].assessment.verdict
        compared += 1
        if after.zeta_e == before.zeta_e:
            assert rank(after.code) <= rank(before.code) or before.code == "undetermined", (table, key)
        if OUTCOMES[before.code].judgement != PASSES and after.zeta_e == before.zeta_e:
            assert after.code == before.code
    return compared


@pytest.mark.shows("verdict.left_out")
def test_that_leaving_a_key_out_never_makes_an_outcome_milder():
    assert sum(map(check_left_out, random_tables(8, first=500))) > 5


@pytest.mark.long
def test_that_leaving_a_key_out_makes_no_outcome_of_three_hundred_walls_milder():
    assert sum(map(check_left_out, random_tables(300, first=500))) > 250


@pytest.mark.shows("verdict.zeta_least")
def test_that_among_equal_outcomes_a_missing_zeta_comes_first():
    rows = [("verified", 1.2, 1.0), ("undetermined", None, 1.0), ("undetermined", 0.3, 1.0), ("verified", 1.1, 0.8)]
    ordered = sorted(rows, key=lambda row: severity_key(*row))
    assert ordered == [rows[1], rows[2], rows[0], rows[3]]
    assert (
        min_if_all_known([1.0, None]) is None and min_if_all_known([]) is None and min_if_all_known([2.0, 1.5]) == 1.5
    )


SITE = {
    "ag_g": 0.26,
    "zeta_target": 0.91,
    "nominal_life_years": 50.0,
    "use_class_factor": 1.0,
    "limit_states": ["SLC"],
    "hazard": [
        {"return_period_years": 30.0, "ag_g": 0.08, "f0": 2.40, "tc_star_s": 0.28},
        {"return_period_years": 475.0, "ag_g": 0.26, "f0": 2.36, "tc_star_s": 0.35},
        {"return_period_years": 2475.0, "ag_g": 0.45, "f0": 2.42, "tc_star_s": 0.37},
    ],
    "spectrum": {"code": "NTC2018", "soil": "C", "topography": "T1", "f0": 2.36, "tc_star_s": 0.35},
}


def test_that_a_limit_state_is_what_its_check_says_and_not_what_zeta_says():
    """By histories the rule fails at the demand and holds again above it: the wall is not verified there, and its zeta
    is no more than what is required."""
    wall = {"name": "w", "height_m": 6.0, "thickness_m": 0.6, "mechanism": "one_sided", "base_z_m": 0.0}
    wall |= {"hold": [{"kind": "contact"}], "unloaded_confirmed": True, "unit_weight_kn_m3": 18.0}
    table = {
        "wall": [wall],
        "demand": SITE,
        "generate": {"scatter": 0.0, "count": 3, "seed": 14},
        "analysis": {"q_step": 0.05},
    }
    result = made(table)
    state = next(one for one in result.walls[0].assessment.states if one.state == "SLC")
    assert state.check == "dynamic" and state.zeta == state.zeta_target and not state.checks[0].passed
    assert state.code == result.verdicts[0].states["SLC"].code == "not_verified"
    said = next(one for one in result.verdicts[0].extra if dict(one.values).get("state") == "SLC")
    assert "fails at the demand itself" in said.text("en")


FREE = {
    "name": "w",
    "height_m": 12.5,
    "thickness_m": 1.0,
    "mechanism": "one_sided",
    "base_z_m": 0.0,
    "hold": [{"kind": "contact"}],
    "unit_weight_kn_m3": 19.9,
    "length_m": 6.85,
    "unloaded_confirmed": True,
}
TIED = FREE | {"hold": [*FREE["hold"], sought(11.7)]}


def test_that_a_tie_that_breaks_early_does_not_lower_the_displacement_check():
    spectrum = {**SITE["spectrum"], "soil": "B"}
    wall = FREE | {"height_m": 3.0, "thickness_m": 0.25}
    lowered = 0
    for force in (0.3, 0.5, 0.6, 0.79, 0.9):
        tie = {"kind": "tie", "h_m": 2.9, "out_kn_m": force, "bar_length_m": 6.0}
        table = {"wall": [wall | {"hold": [tie]}], "demand": {"ag_g": 0.14, "spectrum": spectrum}}
        found = made(table)
        if found is None:  # it bends between tie and base
            continue
        assessment = found.walls[0].assessment
        tied, bare = zeta_with_and_without_ties(assessment.kinematic, found.demand)
        check = next(one for one in assessment.checks if one.name == "nonlinear")
        assert check.zeta == max(tied, bare)
        said = [limit.text("en") for limit in assessment.verdict.limits if limit.code == "ties_displacement"]
        assert len(said) == 1 if tied < bare else len(said) <= 1
        assert all(f"{tied:.2f}" in one and f"{bare:.2f}" in one for one in said)
        lowered += tied < bare
    assert lowered > 1


def test_that_a_wall_rests_under_no_motion_whose_soil_was_left_out():
    """With S = 1.5 it fails; without S, taken as 1, it was said not to be lifted."""
    wall = {"name": "w", "height_m": 6.0, "thickness_m": 0.5, "mechanism": "one_sided", "base_z_m": 0.0}
    wall |= {"hold": [{"kind": "contact"}], "unloaded_confirmed": True, "unit_weight_kn_m3": 18.0}
    demand = {"ag_g": 0.05, "limit_state": "SLD", "soil_factor": 1.5}
    assert made({"wall": [wall], "demand": demand}).walls[0].assessment.verdict.code == "not_verified"
    del demand["soil_factor"]
    assert made({"wall": [wall], "demand": demand}).walls[0].assessment.verdict.code == "indicative"


def test_that_a_rule_known_to_fail_needs_no_zeta():
    check = DynamicCheck("SLV", (), 1, None, None, "mean", 0.4, None, False, False, holds_at_target=False)
    assert check.as_check(1.0).passed is None
    assert replace(check, fails_at_target=True).as_check(1.0).passed is False


def test_that_the_sheet_risk_has_each_state_in_its_own_column():
    """SLD lies outside the rows of the hazard."""
    rows = ((201.0, 0.13, 2.4, 0.33), (475.0, 0.2, 2.36, 0.35), (2475.0, 0.34, 2.42, 0.37))
    keys = ("return_period_years", "ag_g", "f0", "tc_star_s")
    demand = {"ag_g": 0.2, "spectrum": {**SITE["spectrum"], "soil": "B"}, "return_period_years": 475.0}
    demand |= {"hazard": [dict(zip(keys, row, strict=True)) for row in rows]}
    demand |= {"nominal_life_years": 50.0, "use_class_factor": 1.0}
    result = made({"wall": [FREE | {"height_m": 6.0, "thickness_m": 0.5}], "demand": demand})
    zetas = {state.state: state.zeta for state in result.walls[0].assessment.states}
    assert list(zetas) == ["SLV", "SLC"]
    sheet = load_workbook(io.BytesIO(workbook_bytes(result)))["Risk"]
    heads = next(row for row in sheet.iter_rows(values_only=True) if row and "ζ SLD" in row)
    columns = {state: heads.index(f"ζ {state}") for state in ("SLD", "SLV", "SLC")}
    (row,) = [row for row in sheet.iter_rows(values_only=True) if row[0] == "w"]
    assert row[columns["SLD"]] in (None, "–")
    assert (row[columns["SLV"]], row[columns["SLC"]]) == pytest.approx((zetas["SLV"], zetas["SLC"]))


def workbook_bytes(result):
    """The workbook of a result."""
    report = WorkbookReport("en")
    for wall in result.split_by_wall():
        report.add(wall)
    return report.content(result, [], Steps())


def test_that_the_worst_of_many_walls_are_the_worst_outcomes():
    rows = [("undetermined", None), ("not_verified", 1.06), ("at_limit", 1.01), ("verified", 1.0), ("verified", 1.05)]
    tally = Tally()
    for k, (code, zeta) in enumerate(rows):
        row = dict.fromkeys(NAMED, None) | {"verdict": code, "zeta_e": zeta, "zeta_target": 1.0, "wall": k}
        row |= {"hinge_m": 0.0, "decides": True, "analyses": 1, "runs_without_q": 0, "warnings": None}
        tally.add({name: [value] for name, value in row.items()})
    worst = [row["verdict"] for row in tally.worst]
    assert worst == ["not_verified", "at_limit", "undetermined", "verified", "verified"]


def test_that_histories_take_a_tie_as_it_is_and_say_where_zeta_is_lower_with_it():
    """A bar that yields early brings the wall back harder: the lower zeta stands, the one without the tie is said."""
    tie = {"kind": "tie", "out_kn_m": 3.0, "h_m": 6.5, "bar_length_m": 8.0, "elongation_m": 0.05}
    wall = FREE | {"height_m": 7.0, "thickness_m": 0.5, "unit_weight_kn_m3": 18.0}
    spectrum = {**SITE["spectrum"], "soil": "B", "f0": 2.4}
    table = {
        "demand": {"ag_g": 0.3, "spectrum": spectrum},
        "generate": {"scatter": 0.0, "count": 3},
        "analysis": {"q_step": 0.1},
    }
    tied = made({**table, "wall": [wall | {"hold": [tie]}]}).walls[0].assessment
    bare = made({**table, "wall": [wall]}).walls[0].assessment
    assert tied.verdict.zeta_e == tied.dynamic.zeta < bare.dynamic.zeta
    (said,) = [dict(limit.values) for limit in tied.verdict.limits if limit.code == "ties_histories"]
    assert (said["tied"].value, said["bare"].value) == (tied.dynamic.zeta, bare.dynamic.zeta)
