"""Ways by which a hurried engineer got a wall to pass, or an assurance that was none, found by a reader of 0.33."""

from dataclasses import replace

import pytest

from core.case.hold import Hold
from core.case.rules import parse_case
from core.errors import InputError
from core.report.note.brief import note
from core.report.note.content import set_aside_lines
from core.report.note.parts import Table
from core.report.words import Words
from core.study.run import run
from core.variation.measures import hold_floors
from tests.conftest import ROOT

CONTACT = [{"kind": "contact", "to_m": 7.0, "evidence": {"kind": "survey"}}]
WALL = {"name": "w", "mechanism": "one_sided", "height_m": 7.0, "base_z_m": 0.0, "unit_weight_kn_m3": 18.0}
WALL |= {"hold": CONTACT, "unloaded_confirmed": True}
DEMAND = {"ag_g": 0.26, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}}
NTC = {"code": "NTC2018", "soil": "B", "topography": "T1", "f0": 2.4, "tc_star_s": 0.33}
OFF = {"analysis": {"histories": False}}


def decided(wall, demand=DEMAND, **sections):
    wall = {key: value for key, value in (WALL | wall).items() if value is not None}
    result = run(parse_case({"wall": [wall], "demand": demand} | sections), base_dir=ROOT)
    (verdict,) = result.verdicts
    return result, result.walls[verdict.governing].assessment


def test_that_a_floor_that_is_connected_again_is_as_stiff_and_as_ductile_as_it_was():
    wall = parse_case({"wall": [WALL | {"thickness_m": 0.65}], "demand": DEMAND}).wall[0]
    floor = Hold("floor", h_m=3.4, out_kn_m=30.0, stiffness_kn_m2=5000.0)
    roof = Hold("roof", h_m=6.9, out_kn_m=30.0, elongation_m=0.02)
    held = hold_floors(replace(wall, hold=(floor, roof)), 50.0, (3.4, 6.9)).hold
    assert [(hold.out_kn_m, hold.stiffness_kn_m2, hold.elongation_m) for hold in held] == [
        (50.0, 5000.0, None),
        (50.0, None, 0.02),
    ]


def test_that_a_short_life_without_the_hazard_leaves_the_demand_open_unless_a_document_shows_it():
    demand = {"ag_g": 0.08, "spectrum": NTC, "use_class_factor": 0.7, "nominal_life_years": 10.0}
    shown = [{"of": "nominal_life_years", "kind": "act", "reference": "determina 3/2026"}]
    wall = {"thickness_m": 0.75}
    codes = []
    for extra in ({}, {"evidence": shown}, {"nominal_life_years": 100.0}):
        _, assessment = decided(wall, demand | extra, **OFF)
        codes.append((assessment.verdict.code, "short_life" in {limit.code for limit in assessment.verdict.limits}))
    assert codes[0] == ("indicative", True) and codes[1][1] and codes[1][0] == codes[2][0] != "indicative"
    with pytest.raises(InputError, match="use_class_factor"):
        parse_case({"wall": [WALL | wall], "demand": demand | {"use_class_factor": 0.1}})


def test_that_floors_that_hardly_move_by_the_code_carry_no_outcome():
    """A building typed too tall: its first mode takes no part at the height of the wall."""
    wall = {"mechanism": "two_sided", "height_m": 1.2, "thickness_m": 0.25, "base_z_m": 9.0, "hold": None}
    found = {}
    for height, storeys in ((60.0, 20), (9.0, 3)):
        building = {"height_m": height, "storeys": storeys}
        _, assessment = decided(wall, DEMAND | {"ag_g": 0.11}, building=building, generate={"count": 4}, **OFF)
        found[storeys] = assessment
    assert found[20].verdict.code == "indicative" and found[3].verdict.code == "not_verified"
    assert "code_far_below_records" in {limit.code for limit in found[20].verdict.limits}


def test_that_no_clause_permits_a_hinge_about_which_a_leaning_wall_does_not_stand():
    for lean, permitted in ((0.1, True), (0.65, False)):
        wall = {"thickness_m": 0.75, "length_m": 5.0, "out_of_plumb_m": lean}
        _, assessment = decided(wall, DEMAND | {"ag_g": 0.03}, **OFF)
        rows = [row for row in assessment.verdict.assumptions if row.key == "hinge_setback_m" and row.turns]
        assert all(row.permitted == permitted for row in rows) and (permitted or rows)
        assert (assessment.verdict.code == "indicative") != permitted


def test_that_what_is_set_aside_though_it_is_looked_at_is_said_to_have_no_effect():
    aside = [{"mechanism": "overturning", "evidence": {"kind": "calculation", "reference": "rel. 3"}}]
    for heights, effect in (({}, False), ({"hinge_heights": "base"}, True)):
        wall = {"thickness_m": 0.9, "length_m": 5.0, "set_aside": aside}
        wall |= {"steps": [{"from_z_m": 4.0, "thickness_m": 0.5, "flush": "inner"}]}
        result, _ = decided(wall | heights, building={"height_m": 7.0, "storeys": 2}, **OFF)
        (line,) = set_aside_lines(result, Words("en"))
        assert ("no effect" in line) != effect, line


def test_that_what_is_set_aside_is_evaluated_by_the_clauses_and_its_zeta_stands_beside_the_outcome():
    aside = [{"mechanism": "overturning", "from_m": 0.5, "evidence": {"kind": "calculation", "reference": "rel. 3"}}]
    wall = {"thickness_m": 0.9, "length_m": 5.0}
    wall |= {"steps": [{"from_z_m": 4.0, "thickness_m": 0.35, "flush": "inner"}]}
    building = {"height_m": 7.0, "storeys": 2}
    whole, _ = decided(wall, building=building, **OFF)
    result, assessment = decided(wall | {"set_aside": aside, "hinge_heights": "base"}, building=building, **OFF)
    assert assessment.verdict.zeta_e > 1.0 > whole.verdicts[0].zeta_least
    (told,) = (limit for limit in result.verdicts[0].extra if limit.code == "set_aside_has")
    assert dict(told.values)["zeta"].value == pytest.approx(whole.verdicts[0].zeta_least, rel=0.05)


def test_that_the_first_page_tells_the_histories_that_stand_beside_the_check():
    result, assessment = decided(
        {"thickness_m": 0.9}, generate={"count": 4}, analysis={"histories": "beside"}, report={"extent": "brief"}
    )
    assert assessment.dynamic is None and assessment.beside is not None
    first = next(part for part in note(result, "en") if isinstance(part, Table) and "ζ_E" in part.heads)
    assert any(f"time histories ζ {assessment.beside.zeta:.2f}" in cell for cell in first.rows[0])


def test_that_what_other_records_would_give_stands_only_where_histories_decide():
    result, assessment = decided({"thickness_m": 0.9}, generate={"count": 7})
    (verdict,) = result.verdicts
    assert assessment.verdict.governing == "dynamic" or verdict.interval is None
    result, _ = decided({"thickness_m": 0.9}, generate={"count": 7}, analysis={"histories": "beside"})
    assert result.verdicts[0].interval is None


def test_that_a_brittle_hold_of_unknown_stiffness_is_said_to_take_an_impulse_that_nothing_is_compared_with():
    shown = {"kind": "calculation", "reference": "rel. 4"}
    holds = [{"kind": "floor", "h_m": 3.4}, {"kind": "roof", "h_m": 6.9}]
    weight = {"kind": "vertical", "kn_m": 12.0, "d_m": 0.4, "h_m": 3.4, "mass": "none"}
    base = {"thickness_m": 0.65, "load": [weight, weight | {"kn_m": 8.0, "h_m": 6.9}], "unloaded_confirmed": None}
    told = {}
    for stiffness in (None, 5000.0):
        extra = {"stiffness_kn_m2": stiffness} if stiffness else {}
        wall = base | {"hold": [hold | {"out_kn_m": 40.5, "evidence": shown} | extra for hold in holds]}
        result, _ = decided(wall, building={"height_m": 7.0, "storeys": 2}, generate={"count": 4})
        limits = [limit for each in result.walls for limit in each.required_assessment.verdict.limits]
        told[stiffness] = [dict(limit.values) for limit in limits if limit.code == "impulse_open"]
    assert told[None] and not told[5000.0]
    assert all(values["impulse"] > 0.0 and values["stiffness"].value > 0.0 for values in told[None])


def test_that_the_first_page_has_the_words_of_the_documents_that_an_outcome_rests_on():
    pull = {"kind": "thrust", "kn_m": -1.5, "h_m": 6.5}
    shown = [{"of": "inward", "kind": "test", "reference": "not made"}]
    wall = {"thickness_m": 0.75, "load": [pull], "unloaded_confirmed": None, "evidence": shown}
    result, assessment = decided(wall, **OFF)
    assert assessment.verdict.code in ("verified", "verified_refined")
    cells = [cell for part in note(result, "en") if isinstance(part, Table) for row in part.rows for cell in row]
    assert any(cell.endswith("by a test: not made") and "✓" in cell for cell in cells)


def test_that_a_name_of_blanks_is_none():
    with pytest.raises(InputError) as refused:
        parse_case({"wall": [WALL | {"name": " ", "thickness_m": 0.5}], "demand": DEMAND})
    assert refused.value.code == "blank_name"
