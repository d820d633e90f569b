"""What lifts zeta is named with zeta at the other end of its range."""

from dataclasses import replace

import pytest

from core.codes.kinematic import CHECKS
from core.study.run import run
from core.variation.evaluate import evaluate
from core.wall.restitution import MODELS
from tests.clauses_alone import parse_case
from tests.conftest import ROOT

WALL = {
    "name": "w",
    "height_m": 6.0,
    "thickness_m": 0.6,
    "mechanism": "one_sided",
    "base_z_m": 0.0,
    "unit_weight_kn_m3": 18.0,
    "back_restraint": "cross walls",
    "unloaded_confirmed": True,
}
SPECTRUM = {"code": "EN1998", "type": 1, "soil": "B"}
BUILDING = {"height_m": 9.0, "storeys": 3, "period_s": 0.26}


def made(wall=None, demand=None, records=True, building=None, **rest):
    own = {key: value for key, value in {**WALL, **(wall or {})}.items() if value is not None}
    table = {
        "wall": [own],
        "demand": {
            "ag_g": 0.15,
            **({} if demand and "soil_factor" in demand else {"spectrum": SPECTRUM}),
            **(demand or {}),
        },
        **rest,
        "analysis": {"q_step": 0.05},
    }
    if records:
        table["generate"] = {"scatter": 0.0, "count": 3, "seed": 1}
    if building:
        table["building"] = building
    return run(parse_case(table), base_dir=ROOT).walls[0].assessment


def lift(found, code):
    said = {one.code: dict(one.values) for one in found.verdict.limits}
    return said.get(code)


def test_that_a_given_velocity_ratio_is_shown_with_more_and_by_theory():
    found = made({"velocity_ratio": 0.0})
    said = lift(found, "lift_velocity_ratio")
    assert said["e"] == 0.0 and said["more"] == pytest.approx(0.1)
    theory = made()
    assert said["theory"] == pytest.approx(theory.verdict.zeta_e and 0.475, abs=0.02)
    # by theory it is the check of the wall without the key
    assert said["zeta_theory"].value == theory.verdict.zeta_e
    assert said["zeta_theory"].value < found.verdict.zeta_e
    assert lift(theory, "lift_velocity_ratio") is None


@pytest.mark.parametrize("model", [name for name, model in MODELS.items() if not model.by_theory and name != "user"])
def test_that_a_model_of_experiments_is_shown_by_theory_too(model):
    assert lift(made({"restitution": model}), "lift_velocity_ratio") is not None


def test_that_with_nothing_changed_every_check_has_its_own_zeta(monkeypatch):
    seen = []
    monkeypatch.setattr("core.variation.assessment.assumptions", lambda found, _: seen.append(found) or ())
    made()
    (found,) = seen
    assert {check.name for check in found.checks} == set(CHECKS)
    again = evaluate(found.scene.but(wall=replace(found.scene.wall)), other=False)
    own = [check for check in found.checks if check.name != "linear_q_slv"]  # it asks for a search of q
    assert [(check.name, check.zeta) for check in again.checks] == [(check.name, check.zeta) for check in own]


def test_that_an_fc_below_1_35_is_shown_with_1_35():
    tested = {"confidence_factor": 1.2, "knowledge_level": "LC2", "investigations": "flat jacks"}
    found = made({"compressive_strength_mpa": 2.0}, tested)
    said = lift(found, "lift_confidence_factor")
    full = made({"compressive_strength_mpa": 2.0})
    assert said["zeta"].value == full.verdict.zeta_e
    assert said["zeta"].value < found.verdict.zeta_e and said["investigations"] == "flat jacks"


def test_that_another_q_than_2_is_shown_with_2_and_turns_what_rests_on_it():
    case = {"wall": [WALL], "demand": {"ag_g": 0.2, "soil_factor": 1.2, "q_code": 5.0}}
    found = run(parse_case(case), base_dir=ROOT).walls[0].assessment
    check = next(one for one in found.checks if one.name == "linear_q_code")
    assert check is found.checks[0] and check.passed and check.q == 5.0
    assert lift(found, "lift_q_code")["zeta"].value == pytest.approx(0.4 * check.zeta)
    assert found.verdict.code == "indicative" and found.verdict.to_do[0].code == "give_reason"
    case["demand"]["justification"] = {"q_code": "tests on specimens of this masonry"}
    justified = run(parse_case(case), base_dir=ROOT).walls[0].assessment
    assert justified.verdict.code == "verified_refined"
    assert lift(justified, "lift_q_code") is not None


def test_that_the_friction_of_return_walls_is_shown_without_it():
    across = {"number": 2, "thickness_m": 0.5, "brick_height_m": 0.25, "brick_length_m": 0.2}
    case = {"wall": [{**WALL, "return_walls": across, "length_m": 4.0}], "demand": {"ag_g": 0.2, "soil_factor": 1.2}}
    found = run(parse_case(case), base_dir=ROOT).walls[0].assessment
    bare = {"wall": [WALL], "demand": case["demand"]}
    without = run(parse_case(bare), base_dir=ROOT).walls[0].assessment
    assert lift(found, "lift_return_walls")["zeta"].value == pytest.approx(without.verdict.zeta_e)


def test_that_a_two_sided_wall_declared_held_is_shown_as_a_free_element():
    wall = {"mechanism": "two_sided", "back_restraint": None, "free_element": False, "elastic_modulus_mpa": 600.0}
    found = made(wall, records=False)
    free = made({**wall, "free_element": True}, records=False)
    linear = next(check for check in free.checks if check.name == "linear_q_code")
    assert lift(found, "lift_free_element")["zeta"].value == pytest.approx(linear.zeta)


def test_that_a_participation_below_that_of_the_clause_is_shown_with_it():
    """C7.2.10: gamma psi = 9/7 z/H_b."""
    modes = [{"period_s": 0.26, "damping": 0.10, "participation": 0.3}]
    wall = {"base_z_m": 6.0, "height_m": 3.0, "thickness_m": 0.45}
    found = made(wall, building={"height_m": 9.0, "storeys": 3, "modes": modes}, records=False)
    said = lift(found, "lift_participation")
    assert said["expected"] == pytest.approx(9.0 / 7.0 * 6.0 / 9.0)
    whole = [{**modes[0], "participation": 9.0 / 7.0 * 6.0 / 9.0}]
    other = made(wall, building={"height_m": 9.0, "storeys": 3, "modes": whole}, records=False)
    assert said["zeta"].value == pytest.approx(other.verdict.zeta_e)
    assert lift(other, "lift_participation") is None


def test_that_the_other_building_and_the_centroid_stand_beside_a_wall_at_height():
    wall = {"base_z_m": 6.0, "height_m": 3.0, "thickness_m": 0.45, "mechanism": "two_sided", "back_restraint": None}
    found = made(wall, building=BUILDING, records=False)
    other = made(wall, building={**BUILDING, "period_factor": 2.0, "damping": 0.2}, records=False)
    assert lift(found, "other_building")["zeta"].value == pytest.approx(other.verdict.zeta_e)
    higher = made({**wall, "base_z_m": 7.5}, building=BUILDING, records=False)
    assert lift(found, "at_centroid")["zeta"].value == pytest.approx(higher.verdict.zeta_e)
    assert found.sensitivity == {
        "other_building": lift(found, "other_building")["zeta"].value,
        "at_centroid": lift(found, "at_centroid")["zeta"].value,
    }


def test_that_generated_motions_are_named_and_natural_ones_are_not():
    assert lift(made(), "generated_motions") == {}
    natural = {"record": [{"file": "tests/motions/noise_*.txt"}]}
    assert lift(made(records=False, **natural), "generated_motions") is None


def test_that_the_friction_of_return_walls_does_not_make_q_2_agree_with_the_histories():
    """The histories know no friction: where q = 2 passes by it alone, they stand alone until it is justified."""
    across = {"number": 4, "thickness_m": 0.6, "brick_height_m": 0.25, "brick_length_m": 0.2}
    wall = {"return_walls": across, "length_m": 4.0, "thickness_m": 0.75, "restraint_evidence": "opening"}
    demand = {"ag_g": 0.17}
    found = made(wall, demand)
    checks = {check.name: check for check in found.checks}
    without = {check.name: check for check in made({"thickness_m": 0.75}, demand).checks}
    assert checks["linear_q_code"].passed and not without["linear_q_code"].passed
    assert checks["dynamic"].passed and checks["dynamic"].zeta == without["dynamic"].zeta
    assert found.verdict.code == "verified_refined"
    other = lift(found, "lift_return_walls")["zeta"].value
    assert other == pytest.approx(without["linear_q_code"].zeta)
    reason = {"justification": {"return_walls": "toothed, seen on site"}}
    assert made({**wall, **reason}, demand).verdict.code == "verified"


def test_that_a_larger_q_is_not_said_of_a_check_that_takes_none():
    """At SLD the linear check takes no q."""
    demand = {"ag_g": 0.05, "soil_factor": 1.2, "q_code": 5.0, "limit_state": "SLD"}
    found = run(parse_case({"wall": [WALL], "demand": demand}), base_dir=ROOT).walls[0].assessment
    assert lift(found, "lift_q_code") is None


ABOVE = {"base_z_m": 6.0, "height_m": 3.0, "thickness_m": 0.35}
TESTED = {"confidence_factor": 1.0, "knowledge_level": "LC3", "investigations": "flat jacks"}


def test_that_a_wall_at_rest_by_an_input_that_raises_zeta_is_indicative():
    """A chimney declared held lies still under a_g S; S_e(T_0) lifts it, and the displacement check fails."""
    wall = {"mechanism": "two_sided", "back_restraint": None, "height_m": 0.6, "thickness_m": 0.2}
    wall |= {"elastic_modulus_mpa": 600.0}
    found = made({**wall, "free_element": False}, {"ag_g": 0.18}, records=False)
    free = made(wall, {"ag_g": 0.18}, records=False)
    assert free.verdict.zeta_e < 1.0 < found.verdict.zeta_e and found.verdict.code == "indicative"
    assert lift(found, "lift_free_element")["zeta"].value == pytest.approx(free.verdict.zeta_e)


def test_that_a_wall_declared_held_is_named_where_no_linear_check_is_made():
    wall = {"mechanism": "two_sided", "back_restraint": None, "free_element": False, "elastic_modulus_mpa": 600.0}
    found = made(wall, {"limit_state": "SLC"}, records=False)
    assert lift(found, "lift_free_element")["zeta"].value == pytest.approx(found.verdict.zeta_e)


def test_that_a_one_sided_wall_declared_free_is_shown_held_where_that_is_less():
    """T_0 of a slender wall of small E lies beyond the plateau: S_e(T_0) is less than a_g S."""
    wall = {"height_m": 7.0, "thickness_m": 0.45, "elastic_modulus_mpa": 250.0}
    found = made({**wall, "free_element": True}, {"ag_g": 0.07}, records=False)
    held = next(one for one in made(wall, {"ag_g": 0.07}, records=False).checks if one.name == "linear_q_code")
    assert lift(found, "lift_one_sided_free")["zeta"].value == pytest.approx(held.zeta)
    stiff = made({**wall, "free_element": True, "elastic_modulus_mpa": 2000.0}, {"ag_g": 0.07}, records=False)
    assert lift(stiff, "lift_one_sided_free") is None


def test_that_a_building_damped_beyond_the_clause_is_indicative_at_sld_until_it_is_justified():
    demand = {"ag_g": 0.05, "limit_state": "SLD"}
    as_is = made(ABOVE, demand, records=False, building=BUILDING)
    damped = {**BUILDING, "damping": 0.3, "period_factor": 2.5}
    found = made(ABOVE, demand, records=False, building=damped)
    assert as_is.verdict.code == "not_verified" and found.verdict.code == "indicative"
    assert lift(found, "other_building")["zeta"].value == pytest.approx(as_is.verdict.zeta_e)
    reason = {"justification": {"building": "dampers are installed", "period_s": "measured with them"}}
    assert made(ABOVE, {**demand, **reason}, records=False, building=damped).verdict.code == "not_activated"


def test_that_inputs_that_turn_the_outcome_together_alone_are_indicative():
    wall, demand = {"compressive_strength_mpa": 10.0}, {"ag_g": 0.13, "soil_factor": 1.2}
    demand |= {"q_code": 3.0, **TESTED}
    found = made(wall, demand, records=False)
    assert all(lift(found, code)["zeta"].value > 1.0 for code in ("lift_q_code", "lift_confidence_factor"))
    bare = made(wall, {"ag_g": 0.13, "soil_factor": 1.2}, records=False)
    assert lift(found, "lifts_together")["zeta"].value == pytest.approx(bare.verdict.zeta_e)
    assert bare.verdict.code == "not_verified" and found.verdict.code == "indicative"
    assert [one.code for one in found.verdict.to_do] == ["give_reason", "give_reason"]
    # with a reason for one of them the other alone turns nothing
    demand["justification"] = {"q_code": "tests on specimens of this masonry"}
    assert made(wall, demand, records=False).verdict.code == "verified"


def test_that_q_2_does_not_agree_by_an_fc_below_1_35_alone():
    wall = {"compressive_strength_mpa": 10.0}
    found, full = (made(wall, {"ag_g": 0.13, **more}, records=False) for more in (TESTED, {}))
    (q_found,), (q_full,) = ([one for one in each.checks if one.name == "linear_q_code"] for each in (found, full))
    assert q_found.passed and not q_full.passed
    assert found.verdict.code == full.verdict.code == "verified_refined"
    assert lift(found, "q_rests_on") is not None and lift(full, "q_rests_on") is None


def test_that_a_trilinear_law_is_shown_with_the_rigid_one():
    wall = {"mechanism": "two_sided", "back_restraint": None, "thickness_m": 0.5, "law": "rigid"}
    law = {"law": {"elastic_limit": 0.3, "plateau_end": 0.301}}
    found, rigid = made({**wall, **law}, {"ag_g": 0.1}), made(wall, {"ag_g": 0.1})
    assert rigid.verdict.zeta_e < 1.0 < found.verdict.zeta_e and found.verdict.code == "indicative"
    assert lift(found, "lift_law")["zeta"].value == rigid.verdict.zeta_e
