"""Each move of an input is the run of the case with that input changed by hand."""

import copy
import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from core.case.sensitivity import Ranges
from core.case.writer import table_of
from core.codes.dynamic_check import run_dynamic_check
from core.codes.record_sample import RecordPeaks
from core.errors import InputError
from core.rocking.methods import AUTO
from core.setting.plan import FloorCache, make_plan, read_inputs
from core.study.run import run
from core.variation.sensitivity import (
    InputMove,
    evaluate_move,
    leave_one_out_moves,
    list_input_moves,
    summarise_sensitivity,
)
from core.variation.swings import Sensitivity, Swing, SwingEnd, describe_swing_end
from core.variation.wall_evaluation import make_wall_context
from tests.clauses_alone import parse_case
from tests.conftest import ROOT
from tests.holds import shown

CASES = ROOT / "resources" / "cases"
SPECTRUM = {"code": "NTC2018", "f0": 2.4, "tc_star_s": 0.33, "soil": "B", "topography": "T1"}
LOADED = {
    "name": "facade",
    "mechanism": "one_sided",
    "height_m": 6.0,
    "thickness_m": 0.5,
    "unit_weight_kn_m3": 18.0,
    "length_m": 4.0,
    "base_z_m": 0.0,
    "hold": [{"kind": "cross_walls"}],
    "law": "rigid",
    "elastic_modulus_mpa": 1500.0,
    "load": [{"kind": "vertical", "kn_m": 12.0, "d_m": 0.35, "h_m": 5.8, "mass": "horizontal"}],
}
PARAPET = {
    "name": "parapet",
    "mechanism": "two_sided",
    "height_m": 1.5,
    "thickness_m": 0.3,
    "unit_weight_kn_m3": 18.0,
    "elastic_modulus_mpa": 900.0,
    "law": "rigid",
    "base_z_m": 9.0,
    "unloaded_confirmed": True,
}


def case_of(wall, **sections):
    demand = {"ag_g": 0.12, "spectrum": SPECTRUM, **sections.pop("demand", {})}
    return {"wall": [wall], "demand": demand, **sections}


def zeta_of(table):
    return run(parse_case(table), base_dir=CASES).verdicts[0].zeta_least


def moved(table, path, value):
    """The table with one value changed. path : keys and indices"""
    table = copy.deepcopy(table)
    *outer, last = path
    place = table
    for key in outer:
        place = place[key]
    place[last] = value
    return table


def sensitivity(table, **ranges):
    result = run(parse_case({**table, "sensitivity": ranges}), base_dir=CASES)
    return result.verdicts[0], result


def ends(found, key):
    swing = next(one for one in found.sensitivity.swings if one.key == key)
    return {end.value: end.zeta for end in swing.ends}


@pytest.mark.shows("verdict.written_is_run", "search.moves")
def test_that_each_move_of_a_loaded_wall_is_the_run_of_the_changed_case():
    table = case_of(LOADED)
    found, _ = sensitivity(table)
    wall, load = ("wall", 0), ("wall", 0, "load", 0)
    assert found.sensitivity.base == pytest.approx(zeta_of(table), rel=1e-12)
    by_hand = {
        "thickness_factor": moved(moved(table, (*wall, "thickness_m"), 0.475), (*load, "d_m"), 0.3325),
        "unit_weight_factor": moved(table, (*wall, "unit_weight_kn_m3"), 16.2),
        "load_factor": moved(table, (*load, "kn_m"), 9.6),
        "setback_m": moved(table, (*wall, "hinge_setback_m"), 0.03),
        "modulus_factor": moved(table, (*wall, "elastic_modulus_mpa"), 750.0),
        "ag_factor": moved(table, ("demand", "ag_g"), 0.108),
    }
    still = set(found.sensitivity.still)
    for key, changed in by_hand.items():
        zeta = found.sensitivity.base if key in still else next(iter(ends(found, key).values()))
        assert zeta == pytest.approx(zeta_of(changed), rel=1e-12), key
    assert {"thickness_factor", "load_factor", "ag_factor", "setback_m"}.isdisjoint(still)


@pytest.mark.shows("search.moves")
def test_that_each_move_of_the_building_is_the_run_of_the_changed_case():
    table = case_of(PARAPET, building={"height_m": 10.0, "storeys": 3, "period_s": 0.3})
    found, _ = sensitivity(table)
    periods, dampings = ends(found, "building_period_factor"), ends(found, "building_damping_factor")
    assert list(periods) == pytest.approx([0.24, 0.36]) and list(dampings) == pytest.approx([0.05, 0.20])
    for period, zeta in periods.items():
        assert zeta == pytest.approx(zeta_of(moved(table, ("building", "period_s"), period)), rel=1e-12)
    for damping, zeta in dampings.items():
        assert zeta == pytest.approx(zeta_of(moved(table, ("building", "damping"), damping)), rel=1e-12)


@pytest.mark.long
def test_that_each_move_with_records_is_the_run_of_the_changed_case(tmp_path):
    """The motions as files, so that they follow a_g by the factor of their entries."""
    wall = {key: value for key, value in LOADED.items() if key not in ("load", "elastic_modulus_mpa")}
    table = case_of(wall | {"unloaded_confirmed": True}, demand={"ag_g": 0.15}, generate={"scatter": 0.0, "count": 4})
    table["analysis"] = {"q_step": 0.05}
    motions = read_inputs(parse_case(table), CASES)[1]
    del table["generate"]
    table["record"] = []
    for k, motion in enumerate(motions):
        lines = [f"{value:.12e}" for value in motion.acceleration]
        (tmp_path / f"{k}.txt").write_text("\n".join([*lines, ""]))
        entry = {"file": str(tmp_path / f"{k}.txt"), "unit": "m/s2", "time_step_s": motion.time_step, "scale": 1.0}
        table["record"].append(entry)
    found, result = sensitivity(table)
    assert found.sensitivity.base == zeta_of(table)
    (thinner,) = ends(found, "thickness_factor").values()
    assert thinner == zeta_of(moved(table, ("wall", 0, "thickness_m"), 0.475))
    ratio = 0.9 * result.walls[0].restitution.ratio_at_rest
    assert ends(found, "velocity_ratio_factor")[0.9] == zeta_of(moved(table, ("wall", 0, "velocity_ratio"), ratio))
    weaker = moved(table, ("demand", "ag_g"), 0.135)
    share = run(parse_case(weaker), base_dir=CASES).demand.pga / result.demand.pga
    weaker["record"] = [{**entry, "scale": share} for entry in table["record"]]
    assert ends(found, "ag_factor")[0.135] == pytest.approx(zeta_of(weaker), rel=1e-9)
    (lost,) = ends(found, "restraint_lost").values()
    assert lost == result.walls[0].assessment.verdict.lower_bound
    free = moved(table, ("wall", 0, "mechanism"), "two_sided")
    assert lost == zeta_of(free)
    names = [motion.name for motion in result.motions]
    (swing,) = [one for one in found.sensitivity.swings if one.key == "record_left_out"]
    for end in swing.ends:
        fewer = {**table, "record": [e for k, e in enumerate(table["record"]) if names[k] != end.name]}
        assert end.zeta == zeta_of(fewer)


@pytest.mark.shows("search.moves")
def test_that_what_turns_a_satisfied_verdict_is_said_and_the_verdict_stays():
    wall = {**LOADED, "thickness_m": 0.6}
    table = case_of(wall)
    zeta = zeta_of(table)
    table["demand"]["zeta_target"] = round(0.97 * zeta, 6)
    plain = run(parse_case(table), base_dir=CASES)
    found, result = sensitivity(table)
    assert result.walls[0].assessment.verdict == plain.walls[0].assessment.verdict
    assert "thickness_factor" in found.sensitivity.turning
    (said,) = [one for one in found.extra if one.code == "turned"]
    assert "57 cm instead of 60" in said.text("en") and "57 cm invece di 60" in said.text("it")
    table["demand"]["zeta_target"] = round(0.5 * zeta, 6)
    found, _ = sensitivity(table, restraint_lost=False)
    assert found.sensitivity.turning == () and not [one for one in found.extra if one.code == "turned"]


def test_that_a_wall_that_no_longer_stands_has_no_zeta_and_turns():
    """Thrust at rest: a tenth of the thickness less, and it falls without an earthquake."""
    wall = {**LOADED, "load": [{"kind": "thrust", "kn_m": 1.8, "h_m": 5.0, "mass": "none"}]}
    found, _ = sensitivity(case_of(wall, demand={"ag_g": 0.02}), thickness_factor=[0.5, 1.0])
    (end,) = next(swing for swing in found.sensitivity.swings if swing.key == "thickness_factor").ends
    assert end.zeta is None and not end.sure
    assert found.sensitivity.swings[0].key == "thickness_factor"  # as wide as any


def test_that_moves_are_asked_for_and_are_accepted_only_with_a_demand():
    found, _ = sensitivity(case_of(LOADED), ag_factor=[0.5, 1.0], load_factor=[1.0, 1.0], restraint_lost=False)
    assert list(ends(found, "ag_factor")) == pytest.approx([0.06])
    assert {"load_factor", "restraint_lost"}.isdisjoint(one.key for one in found.sensitivity.swings)
    case = parse_case({**case_of(LOADED), "sensitivity": {"ag_factor": [0.5, 1.0]}})
    assert parse_case(table_of(case)) == case
    without = {key: value for key, value in case_of(LOADED).items() if key != "demand"}
    with pytest.raises(InputError, match="demand"):
        parse_case({**without, "sensitivity": {}})
    for wrong in ([1.2, 0.8], [0.0, 1.0], [0.9], [0.9, float("nan")], 0.9, [1.0, 20.0]):
        with pytest.raises(InputError, match="two factors"):
            parse_case({**case_of(LOADED), "sensitivity": {"thickness_factor": wrong}})
    swing = found.sensitivity.swings[0]
    assert describe_swing_end(swing, swing.ends[0]).text("en")


def test_that_the_building_is_moved_where_a_hinge_alone_is_above_the_ground():
    """The wall stands on the ground; the hinge at its second floor decides."""
    wall = {**LOADED, "height_m": 9.0, "load": [{**LOADED["load"][0], "h_m": 8.8}], "hinge_heights": [6.0]}
    table = case_of(wall, building={"height_m": 9.0, "storeys": 3, "period_s": 0.3}, demand={"ag_g": 0.05})
    found, _ = sensitivity(table)
    periods = ends(found, "building_period_factor")
    for period, zeta in periods.items():
        assert zeta == pytest.approx(zeta_of(moved(table, ("building", "period_s"), period)), rel=1e-12)
    assert len(set(periods.values())) == 2


def test_that_a_tested_strength_is_moved_with_its_fc_and_its_steps_with_the_wall():
    demand = {
        "confidence_factor": 1.2,
        "knowledge_level": "LC2",
        "evidence": shown(confidence_factor="flat jacks on two walls"),
    }
    wall = {**LOADED, "compressive_strength_mpa": 2.0}
    table = case_of(wall, demand={"ag_g": 0.05, **demand})
    found, result = sensitivity(table)
    (zeta,) = ends(found, "setback_m").values()
    setback = result.walls[0].wall.setback
    stronger = moved(table, ("wall", 0, "compressive_strength_mpa"), 2.0 * setback / (setback + 0.03))
    assert zeta == pytest.approx(zeta_of(stronger), rel=1e-12) and "setback_m" not in dict(found.sensitivity.refused)
    bare = {key: value for key, value in LOADED.items() if key != "load"}
    stepped = bare | {"unloaded_confirmed": True, "steps": [{"from_z_m": 3.0, "thickness_m": 0.35}]}
    table = case_of(stepped)
    found, _ = sensitivity(table)
    (zeta,) = ends(found, "thickness_factor").values()
    thinner = moved(moved(table, ("wall", 0, "thickness_m"), 0.475), ("wall", 0, "steps", 0, "thickness_m"), 0.3325)
    assert zeta == pytest.approx(zeta_of(thinner), rel=1e-12)


def test_that_what_is_refused_is_named_and_turns_nothing():
    """A wall held at its top may not be thicker than a third of its height."""
    wall = {
        "name": "w",
        "mechanism": "vertical_bending",
        "height_m": 3.0,
        "thickness_m": 0.98,
        "unit_weight_kn_m3": 18.0,
        "length_m": 4.0,
        "base_z_m": 0.0,
        "hold": [{"kind": "contact"}],
        "unloaded_confirmed": True,
    }
    building = {"height_m": 6.0, "storeys": 2, "period_s": 0.2}
    found, _ = sensitivity(case_of(wall, demand={"ag_g": 0.02}, building=building), thickness_factor=[1.0, 1.05])
    assert "thickness_factor" in dict(found.sensitivity.refused)
    assert "thickness_factor" not in {swing.key for swing in found.sensitivity.swings}
    assert not found.extra or "thickness" not in found.extra[0].text("en")


def test_that_a_severe_record_left_out_raises_zeta_and_turns_nothing():
    """Of eight stations one is as strong as three: without it zeta is beyond what is looked at, and is no failure."""
    table = case_of(PARAPET | {"base_z_m": 0.0}, demand={"ag_g": 0.1}, generate={"scatter": 0.0, "count": 8})
    case = parse_case({**table, "sensitivity": {}, "analysis": {"q_step": 0.05}})
    from core.setting import plan

    read = plan.read_inputs(case, CASES)
    strong = [replace(m, acceleration=(9.0 if k == 0 else 0.5) * m.acceleration) for k, m in enumerate(read[1])]
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("core.study.run.read_inputs", lambda *_: (read[0], strong, read[2]))
        result = run(case, base_dir=CASES)
    (verdict,) = result.verdicts
    (swing,) = [one for one in verdict.sensitivity.swings if one.key == "record_left_out"]
    best = max(swing.ends, key=lambda end: end.zeta)
    assert best.name == strong[0].name and best.zeta > 1.3 * verdict.sensitivity.base
    assert best.sure == (best.zeta >= 1.0) and "record_left_out" not in verdict.sensitivity.turning


def test_that_a_wall_without_zeta_has_no_moves():
    wall = {key: value for key, value in PARAPET.items() if key not in ("elastic_modulus_mpa",)} | {"base_z_m": 4.0}
    found, _ = sensitivity(case_of(wall))  # no building
    assert found.sensitivity.base is None and found.sensitivity.swings == () == found.sensitivity.still


def test_that_each_move_of_a_building_with_modes_is_the_run_of_the_changed_case():
    """All periods and all dampings by the same factor, dampings within 1 to 30 %."""
    modes = [
        {"period_s": 0.35, "damping": 0.08, "participation": 1.1},
        {"period_s": 0.12, "damping": 0.016, "participation": -0.2},
    ]
    table = case_of(PARAPET, building={"height_m": 10.0, "storeys": 3, "modes": modes})
    found, _ = sensitivity(table, building_damping_factor=[0.5, 5.0])
    periods, dampings = ends(found, "building_period_factor"), ends(found, "building_damping_factor")
    assert list(periods) == pytest.approx([0.28, 0.42]) and list(dampings) == pytest.approx([0.04, 0.30])

    def changed(key, values):
        return zeta_of(moved(table, ("building", "modes"), [m | {key: v} for m, v in zip(modes, values, strict=True)]))

    assert list(periods.values()) == pytest.approx(
        [changed("period_s", (0.28, 0.096)), changed("period_s", (0.42, 0.144))], rel=1e-9
    )
    assert list(dampings.values()) == pytest.approx(
        [changed("damping", (0.04, 0.01)), changed("damping", (0.30, 0.06))], rel=1e-9
    )


def test_that_what_does_not_act_is_not_moved_or_is_still():
    found, _ = sensitivity(case_of(LOADED))
    keys = {swing.key for swing in found.sensitivity.swings} | set(found.sensitivity.still)
    assert "velocity_ratio_factor" not in keys  # no records
    assert "modulus_factor" in found.sensitivity.still  # on the ground nothing asks for T_0
    (loads,) = [swing for swing in found.sensitivity.swings if swing.key == "load_factor"]
    assert loads.given == 1.0 and [end.value for end in loads.ends] == [0.8, 1.2]
    table = case_of(LOADED, demand={"ag_g": 0.3})
    assert zeta_of(table) < 1.0
    found, _ = sensitivity(table, thickness_factor=[0.9, 3.0])
    assert found.sensitivity.turning == ()  # was not satisfied before


def test_that_what_was_not_surely_satisfied_is_turned_by_nothing_and_without_zeta_nothing_moves():
    setting = SimpleNamespace(inputs=(None, [], []), demand=SimpleNamespace(zeta_target=1.0))
    ranges = Ranges()

    def hinge(code, zeta):
        verdict = SimpleNamespace(code=code, zeta_e=zeta, lower_bound=None)
        return SimpleNamespace(verdict=verdict, lower_bound=None)

    made = [InputMove("thickness_factor", 0.5, 0.475, lambda now: now)]
    thinner = SimpleNamespace(zeta=0.9, sure=False)
    for code, turning in (("verified", ("thickness_factor",)), ("at_limit", ()), ("not_verified", ())):
        assert summarise_sensitivity(setting, ranges, made, [thinner], [hinge(code, 1.3)]).turning == turning
    same = SimpleNamespace(zeta=1.3, sure=True)
    assert summarise_sensitivity(setting, ranges, made, [same], [hinge("verified", 1.3)]).still == ("thickness_factor",)
    both = [hinge("verified", 1.3), hinge("undetermined", None)]
    assert summarise_sensitivity(setting, ranges, made, [same], both) == Sensitivity(None, (), (), ())


def test_that_the_record_left_out_is_the_one_whose_loss_moves_zeta_most_and_its_zeta_that_of_the_others(fine):
    """Record 3 overturns from the multiplier 70 on, 4 from 110: without 3 zeta is highest, without 0 as low as any."""
    multipliers, peaks = 0.4 * 1.01 ** np.arange(160), np.full((7, 160), 0.1)
    peaks[3, 70:], peaks[4, 110:] = np.inf, np.inf
    wall = {key: value for key, value in LOADED.items() if key not in ("load", "elastic_modulus_mpa")}
    table = case_of(wall | {"unloaded_confirmed": True}, demand={"ag_g": 0.2}, generate={"scatter": 0.0, "count": 7})
    case = parse_case(table)
    setting = make_wall_context(case, 0, CASES, read_inputs(case, CASES))
    made = leave_one_out_moves([RecordPeaks(multipliers, peaks, 0.4, True)])
    assert {move.value for move in made} >= {3.0} and len(made) == 2
    demand, motions, _ = setting.inputs
    (entry,) = make_plan(setting.case, setting.inputs).entries
    for move in made:
        others = [motion for k, motion in enumerate(motions) if k != int(move.value)]
        there = run_dynamic_check(entry.model, others, entry.signs, demand, AUTO, other=False)
        assert evaluate_move(setting, move, FloorCache(), lambda: False).zeta == there.zeta


def test_that_a_move_finds_the_floors_of_its_own_demand_and_building():
    """Whatever was moved before it: floors that are kept are those of the wall as it is."""
    table = case_of(PARAPET | {"base_z_m": 6.0}, building={"height_m": 9.0, "storeys": 3, "period_s": 0.26})
    case = parse_case(table)
    setting, kept = make_wall_context(case, 0, CASES, read_inputs(case, CASES)), FloorCache()
    made = list_input_moves(setting, Ranges())
    assert {move.key for move in made} >= {"ag_factor", "building_period_factor", "thickness_factor"}
    for move in [*made, *made[::-1]]:
        shared, own = (evaluate_move(setting, move, floors, lambda: False).zeta for floors in (kept, FloorCache()))
        assert shared == own, move.key


def test_that_a_set_that_fails_nowhere_reaches_the_last_multiplier_and_moves_zeta_farther_than_one_that_fails_there():
    """The first record never matters; without the second the set fails nowhere, with it at the last multiplier."""
    multipliers = 0.4 * 1.01 ** np.arange(160)
    mild, severe = np.full(160, 0.1), np.full(160, 0.1)
    severe[-1] = np.inf
    peaks = RecordPeaks(multipliers, np.array([mild, severe]), 0.4, False)
    assert [move.value for move in leave_one_out_moves([peaks])] == [0.0, 1.0]
    # about another hinge, where each fails alone, the first lowers zeta more when it is gone
    early = np.array([np.where(np.arange(160) < 60, 0.1, np.inf), np.where(np.arange(160) < 50, 0.1, np.inf)])
    other = RecordPeaks(multipliers, early, 0.4, False)
    assert [move.value for move in leave_one_out_moves([peaks, other])] == [0.0, 1.0]
    assert [move.value for move in leave_one_out_moves([peaks, replace(other, peaks=early[::-1])])] == [1.0, 0.0]
    assert [move.key for move in leave_one_out_moves([peaks])] == ["record_left_out"] * 2


@pytest.mark.parametrize(
    "key, given, value, words",
    [
        ("thickness_factor", 0.83, 0.788, "thickness 78.8 cm instead of 83"),
        ("unit_weight_factor", 18.0, 16.2, "unit weight 16.2 kN/m³ instead of 18"),
        ("load_factor", 1.0, 0.8, "loads at 80 %"),
        ("setback_m", 0.02, 0.035, "hinge setback 3.5 cm instead of 2"),
        ("velocity_ratio_factor", None, 0.9, "velocity ratio 0.90 of the theoretical"),
        ("modulus_factor", 1500.0, 750.0, "elastic modulus 750 MPa instead of 1500"),
        ("building_period_factor", 0.3, 0.24, "period of the building 0.24 s instead of 0.30"),
        ("building_damping_factor", 0.1, 0.05, "damping of the building 5 % instead of 10"),
        ("ag_factor", 0.12, 0.108, "a_g 0.108 g instead of 0.120"),
    ],
)
def test_that_a_move_is_said_in_the_unit_of_its_words(key, given, value, words):
    end = SwingEnd(value, 0.9, False)
    assert describe_swing_end(Swing(key, given, (end,)), end).text("en") == words


def test_that_a_swing_reaches_from_the_lowest_zeta_to_the_highest():
    ends = SwingEnd(0.9, 0.8, False), SwingEnd(1.1, 1.3, True)
    swing = Swing("ag_factor", 1.0, ends)
    assert swing.width(1.0) == pytest.approx(0.5) and swing.width(1.5) == pytest.approx(0.7)
    assert swing.lowest is ends[0] and Swing("ag_factor", 1.0, ends[::-1]).lowest is ends[0]
    fallen = SwingEnd(0.5, None, False)
    assert Swing("ag_factor", 1.0, (ends[0], fallen)).lowest is fallen
    assert Swing("ag_factor", 1.0, (ends[0], fallen)).width(1.0) == swing.width(None) == math.inf
