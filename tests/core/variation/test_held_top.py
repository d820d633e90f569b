"""A study of a wall held at its top: checks at mid-height, histories at the worst hinge, and a verdict that says so."""

import json
from dataclasses import replace
from pathlib import Path

import pytest

from core.codes.dynamic_check import run_dynamic_check
from core.codes.floor_spectrum import FloorSpectrum
from core.codes.multiplier_search import Precision
from core.codes.vertical_bending import bending, hinges_in_histories
from core.errors import InputError
from core.report.json_report import dumps
from core.setting.floors import modes_at
from core.study.run import run
from core.study.variants import compare_results
from core.units import G
from tests.clauses_alone import parse_case
from tests.conftest import COARSE
from tests.core.variation.one_evaluation import looked_at
from tests.holds import at_top, behind, shown
from tests.validation.circolare import EN_B

TOP = {"kind": "vertical", "kn_m": 10.0, "d_m": 0.15, "h_m": 3.0, "mass": "none"}
WALL = {
    "name": "storey",
    "mechanism": "vertical_bending",
    "height_m": 3.0,
    "thickness_m": 0.3,
    "unit_weight_kn_m3": 18.0,
    "base_z_m": 3.0,
    "hold": at_top(3.0, 60.0, evidence=""),
    "load": [TOP],
}
BUILDING = {"height_m": 9.0, "storeys": 3, "period_s": 0.26}
DEMAND = {"ag_g": 0.35, "spectrum": EN_B}


def study(*walls, base_dir=Path(), **more):
    walls = [{key: value for key, value in wall.items() if value is not None} for wall in walls]
    table = {"wall": walls, "building": BUILDING, "demand": DEMAND, **more}
    return run(parse_case({key: value for key, value in table.items() if value is not None}), base_dir=base_dir)


def codes(wall):
    return [limit.code for limit in wall.assessment.verdict.limits]


@pytest.mark.shows("held.demand")
def test_that_the_demand_is_that_of_the_floor_spectrum_at_mid_height():
    result = study(WALL)
    (wall,) = result.walls
    asked = result.case
    floor = FloorSpectrum(result.demand.target, modes_at(asked.building, 4.5, "SLV"))
    assert wall.floor.z == 4.5 and wall.assessment.kinematic.floor == floor
    found = wall.assessment.kinematic
    assert found.acceleration_demand == max(floor.a_z, result.demand.pga)
    assert found.a0 == pytest.approx(0.66779 * G / 1.35, rel=1e-5)
    assert found.zeta_sld == pytest.approx(found.a0 / found.acceleration_demand, rel=1e-14)
    assert found.d_limit == pytest.approx(0.4 * found.moved.d0) and not found.free_element
    assert found.moved.d0 < bending(wall.wall.in_si).d0  # its own hinge, where zeta is least


@pytest.mark.shows("held.demand")
def test_that_low_in_a_building_the_demand_is_not_below_that_of_the_ground():
    (wall,) = study(
        WALL | {"base_z_m": 0.0, "height_m": 2.0, "load": [TOP | {"h_m": 2.0}], "hold": at_top(2.0, 60.0)}
    ).walls
    assert wall.floor.spectrum.a_z < wall.assessment.kinematic.acceleration_demand == pytest.approx(1.2 * 0.35 * G)


def test_that_without_the_building_there_is_no_verdict_even_for_a_base_on_the_ground():
    (wall,) = study(WALL | {"base_z_m": 0.0}, building=None).walls
    verdict = wall.assessment.verdict
    assert verdict.code == "undetermined" and "1.5 m above the ground" in verdict.text("en")


@pytest.mark.shows("held.no_histories")
def test_that_the_verdict_rests_on_the_kinematic_checks_and_says_so():
    (wall,) = study(WALL).walls
    verdict = wall.assessment.verdict
    assert verdict.governing == "nonlinear" and codes(wall)[:2] == ["hold_top", "no_histories"]
    assert [check.name for check in wall.assessment.checks] == ["nonlinear", "linear_q_code", "hold"]
    assert wall.q_set is None and wall.runs == () and wall.per_record == () and wall.code_check == ()
    keys = json.loads(dumps(study(WALL)))["walls"][0]
    assert keys["runs"] == keys["per_record"] == [] and keys["restitution"] == "momentum"
    assert keys["velocity_ratio"] == pytest.approx(0.82442, abs=2e-5) and keys["radius_m"] is None
    assert keys["frequency_parameter_rad_s"] ** 2 == pytest.approx(6.38315, abs=1e-3)
    assert all(keys[name] is None for name in keys if name.startswith("q_"))
    check = keys["kinematic_check"]
    assert check["alpha0"] == pytest.approx(0.66779, abs=5e-6)
    assert check["bending"]["hinge_m"] == pytest.approx(2.088, abs=5e-4)
    assert check["d0_m"] == pytest.approx(0.5 * check["bending"]["d_c0_m"])


@pytest.mark.shows("held.restraint")
def test_that_a_top_nobody_names_gives_no_verification_however_strong_the_wall_is():
    strong = {"thickness_m": 0.9, "load": [TOP | {"kn_m": 200.0, "d_m": 0.45}]}
    holds = at_top(3.0, 200.0), behind()  # what stands behind a wall holds no top
    named, unnamed = (study(WALL | strong | {"hold": hold}).walls[0] for hold in holds)
    assert named.assessment.verdict.code == "not_activated"
    word = study(WALL | strong | {"hold": at_top(3.0)}).walls[0]  # how much it stands, nobody says
    assert word.assessment.verdict.code == "indicative" and "no_hold_strength" in codes(word)
    verdict = unnamed.assessment.verdict
    assert verdict.code == "indicative" and "no_top_restraint" in codes(unnamed)
    assert verdict.to_do[0].code == "to_no_top_restraint"


@pytest.mark.shows("held.restraint")
def test_that_zeta_of_the_overturning_stands_beside_it():
    """The same wall, no longer held: it is that of a one-sided wall by the same checks."""
    weak = {"demand": DEMAND | {"ag_g": 0.2}}
    (wall,) = study(WALL, **weak).walls
    (alone,) = study(WALL | {"mechanism": "one_sided", "hold": at_top(3.0), "hinge_heights": "base"}, **weak).walls
    assert wall.assessment.verdict.lower_bound == pytest.approx(alone.assessment.verdict.zeta_e, rel=1e-12)
    assert wall.assessment.verdict.lower_bound < wall.assessment.verdict.zeta_e and "top_fails" in codes(wall)


@pytest.mark.shows("held.inward")
def test_that_the_clauses_look_at_the_side_to_which_a_wall_bends_first():
    """Its load stands near the outer face: the checks are those of the wall mirrored, whose load stands near its inner
    one; with something behind it all along it cannot bend inward."""
    near, far = (WALL | {"load": [TOP | {"d_m": d, "kn_m": 30.0}]} for d in (0.02, WALL["thickness_m"] - 0.02))
    for demand in (DEMAND, DEMAND | {"ag_g": 0.45}):
        (first,), (second,) = (study(wall, demand=demand).walls for wall in (near, far))
        assert "bends_inward_first" in codes(first) and "bends_inward_first" not in codes(second)
        inward, outward = first.assessment.kinematic, second.assessment.kinematic
        assert inward.alpha0 == pytest.approx(outward.alpha0, rel=1e-9)
        assert inward.d_limit == pytest.approx(outward.d_limit, rel=1e-9)
    held = at_top(3.0, 60.0)
    backed = {"kind": "contact", "evidence": {"kind": "survey", "reference": "S1"}}
    (unshown,) = study(near | {"hold": [*held, {"kind": "contact"}]}).walls
    assert "bends_inward_first" in codes(unshown)  # a contact that nobody shows keeps it from nothing
    (leans,) = study(near | {"hold": [*held, backed]}).walls
    assert "bends_inward_first" not in codes(leans)
    assert leans.assessment.kinematic.alpha0 > 1.2 * inward.alpha0


def test_that_the_highest_hinge_is_said():
    bare = {key: value for key, value in WALL.items() if key != "load"}
    (wall,) = study(bare | {"unloaded_confirmed": True}).walls
    assert "hinge_highest" in codes(wall)


@pytest.mark.shows("held.histories")
def test_that_it_has_histories_as_other_walls_have(folder):
    """Each record with both signs, for its loads make the sides differ, at the hinge that fares worst."""
    other = {"name": "rocks", "height_m": 3.0, "thickness_m": 0.5, "base_z_m": 0.0, "mechanism": "two_sided"}
    records = [{"file": "r*.txt", "unit": "m/s2", "time_step_s": 0.01}]
    analysis = {"q_step": 0.02, "accuracy": True}
    result = study(WALL, other, base_dir=folder, record=records, analysis=analysis)
    bends, rocks = result.walls
    assert len(bends.per_record) == len(rocks.per_record) == 3 and bends.q_set > 0.0
    stated = bends.accuracy
    assert stated.points == () and stated.q_reference is None and stated.q == min(run.ida.q for run in bends.runs)
    assert stated.history_bound >= 1e-9 and stated.noise_effect < 1e-9 and rocks.accuracy.points
    assert stated.spread(0, stated.rounded) < 0.05 and stated.held and not rocks.accuracy.held
    dynamic = bends.assessment.dynamic
    made = {check.name for check in bends.assessment.checks}  # of records weaker than the demand the clauses decide
    assert "dynamic" in made and "no_histories" not in codes(bends)
    motions = list(bends.floor.motions)
    worst = min(
        run_dynamic_check(branch.of(bends.model), motions, (1,), result.demand, result.method, Precision(COARSE)).zeta
        for branch in hinges_in_histories(bends.model, bends.assessment.kinematic.moved.bending)
    )
    assert dynamic.zeta == worst and bends.governing_model.bending.h1 == dynamic.branch.h1


def test_that_without_a_demand_it_is_read_and_shown():
    result = study({key: value for key, value in WALL.items() if key != "base_z_m"}, demand=None)
    assert result.walls[0].threshold == pytest.approx(0.66779 * G, rel=1e-5) and result.walls[0].warnings == ()


def test_that_a_larger_period_of_the_building_and_fc_are_among_what_lifts_it():
    known = {"confidence_factor": 1.2, "knowledge_level": "LC2", "evidence": shown(confidence_factor="flat jacks")}
    result = study(WALL | {"compressive_strength_mpa": 2.0}, demand=DEMAND | known)
    assert {"lift_confidence_factor", "other_building"} <= set(looked_at(result))


def test_that_every_limit_state_has_its_zeta():
    hazard = [{"return_period_years": years, "ag_g": ag} for years, ag in ((30, 0.08), (475, 0.26), (2475, 0.45))]
    demand = DEMAND | {"ag_g": 0.26, "nominal_life_years": 50, "use_class_factor": 1.0, "hazard": hazard}
    (wall,) = study(WALL, demand=demand).walls
    assert [state.state for state in wall.assessment.states] == ["SLD", "SLV", "SLC"]
    assert [state.check for state in wall.assessment.states] == ["linear_sld", "nonlinear", "nonlinear"]
    assert replace(wall).assessment.risk is not None


def test_that_a_wall_to_be_held_at_its_top_is_compared_with_the_wall_that_overturns():
    as_is = WALL | {
        "mechanism": "one_sided",
        "hold": at_top(3.0, evidence=""),
        "hinge_heights": "base",
        "variant": "stato di fatto",
    }
    result = study(as_is, WALL | {"variant": "progetto"}, demand=DEMAND | {"ag_g": 0.2})
    (one,) = compare_results(result.walls)
    assert (one.before.mechanism, one.after.mechanism) == ("one_sided", "vertical_bending")
    assert one.after.assessment.verdict.lower_bound == pytest.approx(one.before.assessment.verdict.zeta_e)
    assert all("variant_alone" not in [warning.code for warning in wall.warnings] for wall in result.walls)


def test_that_a_spectrum_too_short_for_the_overturning_leaves_the_wall_its_verdict(tmp_path):
    """T_SLV of the overturning is beyond the end of the file, that of the bending is not."""
    tall = WALL | {
        "height_m": 12.0,
        "thickness_m": 1.0,
        "load": [TOP | {"kn_m": 60.0, "h_m": 12.0, "d_m": 0.5}],
        "hold": at_top(12.0, 300.0, evidence=""),
        "base_z_m": 0.0,
    }
    rows = ["0 0.42", "0.15 1.05", "0.5 1.05", "1.0 0.525", "2.5 0.21"]
    (tmp_path / "s.txt").write_text("T[s] Se[g]\n" + "\n".join(rows))
    demand = {"ag_g": 0.35, "soil_factor": 1.2, "spectrum_file": "s.txt"}
    (wall,) = study(tall, demand=demand, base_dir=tmp_path).walls
    assert wall.assessment.kinematic.period < 2.5 and wall.assessment.verdict.zeta_e is not None
    assert wall.assessment.verdict.lower_bound is None
    with pytest.raises(InputError, match="T_SLV"):
        study(
            tall | {"mechanism": "one_sided", "hold": at_top(12.0), "hinge_heights": "base"},
            demand=demand,
            base_dir=tmp_path,
        )


@pytest.mark.shows("held.strength")
def test_that_what_holds_the_top_is_a_strength_and_no_word():
    """Without a number a wall that passes is indicative; a hold is compared with what it takes at the demand."""
    small = {"demand": {"ag_g": 0.1, "spectrum": EN_B}}
    table = WALL | {"hold": at_top(3.0, 60.0, "test"), "unloaded_confirmed": False}
    table |= {"evidence": shown(load="survey of 2024", mass="sheet 4"), "compressive_strength_mpa": None}
    table = {key: value for key, value in table.items() if value is not None}
    with_strength = study(table, **small).walls[0].assessment.verdict
    word = table | {"hold": at_top(3.0, None, "test")}
    without = study(word, **small).walls[0].assessment.verdict
    assert "no_hold_strength" not in [limit.code for limit in with_strength.limits]
    assert without.code == "indicative" and without.limits[0].code == "no_hold_strength"
    assert without.to_do[0].code == "to_no_hold_strength" and "out_kn_m" in without.to_do[0].text("en")
    assert with_strength.zeta_e == without.zeta_e  # the number changes what may be said, not what was counted
    checks = {check.name: check for check in study(table, **small).walls[0].assessment.checks}
    asked = checks["hold"].demand
    start = 1e-3 * bending(parse_case({"wall": [WALL]}).wall[0].in_si).top_force
    assert 0.0 < asked < 0.5 * start  # of a wall at rest, far less than as it starts to bend
    enough = study(table | {"hold": at_top(3.0, 1.02 * asked, "test")}, **small).walls[0].assessment
    assert enough.verdict.code == with_strength.code and enough.verdict.governing == "hold"
    assert enough.verdict.zeta_e == pytest.approx(1.02, abs=2e-3)
    weak = study(table | {"hold": at_top(3.0, 0.98 * asked, "test")}, **small).walls[0].assessment.verdict
    assert weak.code in ("not_verified", "q2_unsafe") and weak.zeta_e < 1.0 and weak.governing == "hold"
    assert "hold_top" in [limit.code for limit in weak.limits]
    leaning = study(WALL | {"mechanism": "one_sided"})  # held at its top, it bends below it all the same
    assert [wall.wall.mechanism for wall in leaning.walls] == ["one_sided", "vertical_bending"]


@pytest.mark.shows("held.strength")
def test_that_a_heavier_wall_asks_more_of_what_holds_it():
    pushes = 1e-3 * bending(parse_case({"wall": [WALL]}).wall[0].in_si).top_force
    small = {"demand": {"ag_g": 0.1, "spectrum": EN_B}, "sensitivity": {"unit_weight_factor": [0.9, 1.1]}}
    found = study(WALL | {"hold": at_top(3.0, 0.2 * pushes)}, **small).verdicts[0].sensitivity
    (heavy,) = [swing for swing in found.swings if swing.key == "unit_weight_factor"]
    zetas = {end.value: end.zeta for end in heavy.ends}
    assert None not in zetas.values() and zetas[19.8] < zetas[16.2]
    assert "unit_weight_factor" not in dict(found.refused)
