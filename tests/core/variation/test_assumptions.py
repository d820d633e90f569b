"""What lifts zeta is named with zeta at the other end of its range."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from core.case.document import Document
from core.codes.kinematic import CHECKS
from core.errors import InputError
from core.study.run import run
from core.text.sentence import sentence
from core.variation import assumptions as assumption_table
from core.variation.evaluate import evaluate
from core.variation.favourable_input import Alternative, FavourableInput
from core.wall.restitution import MODELS
from tests.clauses_alone import parse_case
from tests.conftest import ROOT
from tests.core.variation.one_evaluation import NTC, history, looked_at, with_histories
from tests.core.variation.one_evaluation import WALL as QUICK
from tests.core.variation.one_evaluation import scene_of as quick_scene
from tests.holds import behind, shown

# the table of any inputs

LINEAR = 0.1 / 1.35
"""zeta a_g [g] of the wall of one_evaluation.py with q = 2."""


def weaker(factor):
    """A demand so many times as large: zeta goes down by it."""

    def change(scene):
        demand = scene.demand
        return scene.replace_parts(demand=replace(demand, ag=factor * demand.ag, pga=factor * demand.pga))

    return change


def falling(scene):
    raise InputError("unstable_under_loads", threshold=0.0)


def one(key, *changes, reasons=None, histories=True, permitted=False):
    ends = tuple(
        Alternative(weaker(change) if isinstance(change, float) else change, k) for k, change in enumerate(changes)
    )
    words = lambda zetas, check: sentence("reason", "lift_mass", zeta=zetas[0], end="", check=check.name)  # noqa: E731
    return FavourableInput("lift_mass", key, reasons, 0.0, ends, words, "given", histories, permitted)


@pytest.fixture
def table(monkeypatch):
    """The rows of inputs of a wall with this zeta by q = 2, and by histories where one is given."""

    def rows(*inputs, zeta=1.2, dynamic=None, spread=None, wall=None, by_default=False, demand=None):
        ag = LINEAR / zeta
        asked = {"ag_g": ag, "soil_factor": 1.0} | (demand or {})
        leans = {"hold": behind("opening", to_m=4.0)}
        scene = quick_scene(
            QUICK | leans | (wall or {}), {key: value for key, value in asked.items() if value is not None}
        )
        if dynamic is not None:

            def said(model, motions, there):
                value = dynamic * scene.demand.ag / there.ag
                return history(value, value >= 1.0, zeta_spread=spread and tuple(value * share for share in spread))

            scene = with_histories(scene, said, by_default=by_default)
        monkeypatch.setattr(assumption_table, "favourable_inputs", lambda found: iter(inputs))
        return assumption_table.evaluate_assumptions(evaluate(scene))

    return rows


def test_that_inputs_have_a_last_row_only_where_they_turn_the_outcome_together_alone(table):
    rows = table(one("fc", 1.1), one("soil", 1.15))
    assert [row.key for row in rows] == ["fc", "soil", "together"]
    assert [row.zeta for row in rows] == pytest.approx([1.2 / 1.1, 1.2 / 1.15, 1.2 / 1.265])
    assert [row.outcome for row in rows] == ["verified", "verified", "not_verified"]
    assert [row.key for row in table(one("fc", 1.1))] == ["fc"] and table() == ()
    assert [row.key for row in table(one("fc", 1.05), one("soil", 1.1))] == ["fc", "soil"]
    three = table(one("fc", 1.07), one("soil", 1.08), one("fc", 1.06))
    assert three[-1].zeta == pytest.approx(1.2 / (1.07 * 1.08 * 1.06))
    keys = dict(three[-1].words.values)["keys"]
    assert keys == ("fc", "soil") and dict(three[-1].words.values)["zeta"].value == three[-1].zeta
    assert three[-1].zeta <= min(row.zeta for row in three[:-1])


def test_that_the_last_row_is_of_histories_where_they_decide(table):
    rows = table(one("fc", 1.5), one("soil", 1.5), dynamic=2.0)
    assert [row.zeta for row in rows] == pytest.approx([2.0 / 1.5, 2.0 / 1.5, 2.0 / 2.25]) and rows[-1].turns


def test_that_an_input_turns_what_is_satisfied_and_no_wall_that_fails(table):
    """Beyond 1.2 times the demand the check fails."""
    for factor, turns in ((1.19, False), (1.21, True)):
        (row,) = table(one("fc", factor))
        assert (row.turns, row.turns_q, row.raises) == (turns, turns, True)
        assert row.outcome == ("not_verified" if turns else "verified")
    assert table(one("fc", 1.5), zeta=0.9) == ()


def test_that_of_histories_that_pass_the_check_with_q_alone_may_turn_and_the_other_way_round(table):
    (row,) = table(one("fc", 1.3), dynamic=2.0)
    assert (row.turns, row.turns_q, row.zeta) == (False, True, pytest.approx(1.2 / 1.3))  # of the check it turns
    assert row.check == "linear_q_code"
    (row,) = table(one("fc", 1.3), zeta=2.0, dynamic=1.2)
    assert (row.turns, row.turns_q, row.zeta) == (True, False, pytest.approx(1.2 / 1.3))
    (row,) = table(one("fc", 1.3), zeta=0.9, dynamic=1.5)
    assert (row.turns, row.turns_q) == (False, False)
    (row,) = table(one("fc", 1.3), zeta=1.2, dynamic=0.9)
    assert (row.turns, row.turns_q) == (False, True)


def test_that_an_input_of_the_linear_check_alone_says_its_zeta_and_turns_that_one_alone(table):
    """The histories know nothing of it: they decide as they do; the outcome is that with the linear check there."""
    (row,) = table(one("q_code", 1.3, histories=False), dynamic=2.0)
    assert (row.turns, row.turns_q, row.zeta) == (False, True, pytest.approx(1.2 / 1.3))
    assert dict(row.words.values)["check"] == "linear_q_code" and row.outcome == "indicative"
    (row,) = table(one("q_code", 1.3, histories=False), zeta=1.2, dynamic=0.9)
    assert (row.outcome, row.turns, row.turns_q) == ("not_verified", False, True)  # q = 2 agrees no more
    assert table(one("q_code", 1.1, histories=False), zeta=1.2, dynamic=0.9) == ()
    (row,) = table(one("q_code", 1.3, histories=False))
    assert (row.turns, row.turns_q) == (True, True)  # where no histories are it decides
    # at SLC there is no such check
    assert table(one("q_code", 1.3, histories=False), dynamic=2.0, demand={"limit_state": "SLC"}) == ()


def test_that_the_end_with_the_lowest_zeta_is_shown_and_any_end_turns(table):
    for ends, lowest in (((1.1, 1.15), 1), ((1.15, 1.1), 0), ((1.1, 1.3), 1), ((1.3, 1.1), 0)):
        (row,) = table(one("fc", *ends))
        assert (row.other_end, row.zeta) == (lowest, pytest.approx(1.2 / max(ends)))
        assert row.turns == (max(ends) > 1.2)


def test_that_an_input_whose_end_is_no_worse_raises_nothing_and_is_left_out_of_the_last_row(table):
    rows = table(one("fc", 0.9), one("soil", 1.0), one("ag", 1.1))
    assert [row.raises for row in rows] == [False, False, True] and [row.key for row in rows] == ["fc", "soil", "ag"]


def test_that_a_wall_that_falls_at_an_end_is_not_verified_there_and_no_last_row_has_a_number(table):
    rows = table(one("fc", falling), one("soil", 1.1))
    assert [(row.key, row.zeta, row.outcome, row.turns) for row in rows[:1]] == [("fc", None, "not_verified", True)]
    assert [row.key for row in rows] == ["fc", "soil"]
    (row,) = table(one("fc", 1.1, falling))
    assert (row.other_end, row.zeta, row.turns) == (1, None, True)


def test_that_inputs_without_a_reason_that_turn_together_alone_each_do(table):
    rows = table(one("fc", 1.1), one("soil", 1.15))
    assert [(row.key, row.turns, row.turns_q) for row in rows[:2]] == [("fc", True, True), ("soil", True, True)]
    assert (rows[2].key, rows[2].turns, rows[2].zeta) == ("together", True, pytest.approx(1.2 / 1.265))
    mild = table(one("fc", 1.05), one("soil", 1.1))
    assert not any(row.turns or row.turns_q for row in mild)
    failing = table(one("fc", 1.1), one("soil", 1.15), zeta=0.9)
    assert not any(row.turns or row.turns_q for row in failing)


@pytest.mark.parametrize("founded", [{"permitted": True}, {"reasons": Document("test", "report 3/2024")}])
def test_that_an_input_with_a_reason_or_permitted_turns_with_no_other(table, founded):
    rows = table(one("fc", 1.1, **founded), one("soil", 1.15))
    assert not any(row.turns or row.turns_q for row in rows)
    three = table(one("fc", 1.1, **founded), one("soil", 1.15), one("ag", 1.06))
    assert [row.turns for row in three] == [False, True, True, True]
    assert dict(three[-1].words.values)["keys"] == ("soil", "ag") and three[-1].zeta == pytest.approx(1.2 / 1.219)


def test_that_one_that_turns_alone_leaves_the_others_as_they_are(table):
    rows = table(one("fc", 1.3), one("soil", 1.05))
    assert [(row.turns, row.turns_q) for row in rows] == [(True, True), (False, False)]


def test_that_two_inputs_turn_the_check_with_q_together_where_histories_pass(table):
    rows = table(one("fc", 1.1), one("soil", 1.15), dynamic=2.0)
    assert [(row.turns, row.turns_q) for row in rows] == [(False, True), (False, True)]
    alone = table(one("fc", 1.1, histories=False), one("soil", 1.15, histories=False), dynamic=2.0)
    assert [(row.turns, row.turns_q) for row in alone[:2]] == [(False, True), (False, True)]
    one_alone = table(one("fc", 1.3), one("soil", 1.05), dynamic=2.0)
    assert [row.turns_q for row in one_alone] == [True, False]


def test_that_histories_at_their_limit_there_turn(table):
    (row,) = table(one("fc", 1.1), zeta=3.0, dynamic=1.2, spread=(0.91, 1.1))
    assert row.turns and row.outcome == "at_limit"
    (row,) = table(one("fc", 1.1), zeta=3.0, dynamic=1.2, spread=(0.93, 1.1))
    assert not row.turns


def test_that_of_loads_the_first_check_they_raise_is_told_and_none_where_they_raise_none(table):
    def linear_alone(scene):
        """As where a load acts on the check of the clauses alone."""
        demand = scene.demand
        return scene.replace_parts(demand=replace(demand, pga=1.1 * demand.pga))

    (row,) = table(one("load", linear_alone), dynamic=2.0)
    assert dict(row.words.values)["check"] == "linear_q_code" and row.zeta == pytest.approx(1.2 / 1.1)
    (row,) = table(one("load", 1.1), dynamic=2.0)
    assert dict(row.words.values)["check"] == "dynamic" and row.zeta == pytest.approx(2.0 / 1.1)
    assert table(one("load", 0.9), dynamic=2.0) == () and table(one("load", 1.0)) == ()


def test_that_where_records_are_there_by_default_the_check_that_decides_at_the_end_is_told(table):
    """Histories of 1.2 decide over a displacement check of more; at the end the displacement check may."""
    spectrum = {"ag_g": 0.05, "spectrum": NTC, "soil_factor": None}

    def histories_alone(scene):
        return replace(scene, histories=lambda *_: history(5.0))

    (row,) = table(one("fc", histories_alone), dynamic=1.2, by_default=True, demand=spectrum)
    displacement = evaluate(quick_scene(QUICK, {"ag_g": 0.05, "spectrum": NTC})).zeta
    assert 1.2 < displacement < 5.0 and row.zeta == pytest.approx(displacement)
    (row,) = table(one("fc", histories_alone), dynamic=1.2, demand=spectrum)
    assert row.zeta == 5.0
    (row,) = table(one("q_code", 1.3, histories=False), dynamic=1.2, by_default=True, demand=spectrum)
    linear = evaluate(quick_scene(QUICK, {"ag_g": 0.05, "spectrum": NTC})).made("linear_q_code").zeta
    assert row.zeta == pytest.approx(linear / 1.3)


# inputs of a case

WALL = {
    "name": "w",
    "height_m": 6.0,
    "thickness_m": 0.6,
    "mechanism": "one_sided",
    "base_z_m": 0.0,
    "unit_weight_kn_m3": 18.0,
    "hold": behind(to_m=6.0),
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
    return asked_of(parse_case(table))


def asked_of(case):
    """The assessment of the first wall of a case, with the words of every input that a clause asks about."""
    result = run(case, base_dir=ROOT)
    found = result.walls[0].assessment
    limits = {limit.code: dict(limit.values) for limit in found.verdict.limits}
    rows = {code: dict(row.words.values) for code, row in looked_at(result).items()}
    return SimpleNamespace(verdict=found.verdict, checks=found.checks, kinematic=found.kinematic, said=rows | limits)


def lift(found, code):
    return found.said.get(code)


@pytest.mark.shows("lifts.velocity_ratio")
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


@pytest.mark.shows("lifts.velocity_ratio")
@pytest.mark.parametrize("model", [name for name, model in MODELS.items() if not model.by_theory and name != "user"])
def test_that_a_model_of_experiments_is_shown_by_theory_too(model):
    assert lift(made({"restitution": model}), "lift_velocity_ratio") is not None


def test_that_with_nothing_changed_every_check_has_its_own_zeta(monkeypatch):
    seen = []
    monkeypatch.setattr("core.variation.assessment.evaluate_assumptions", lambda found, _: seen.append(found) or ())
    made()
    (found,) = seen
    assert {check.name for check in found.checks} == set(CHECKS) - {"hold"}
    again = evaluate(found.scene.replace_parts(wall=replace(found.scene.wall)), other=False)
    own = [check for check in found.checks if check.name != "linear_q_slv"]  # it asks for a search of q
    assert [(check.name, check.zeta) for check in again.checks] == [(check.name, check.zeta) for check in own]


@pytest.mark.shows("lifts.confidence")
def test_that_an_fc_below_1_35_is_shown_with_1_35():
    tested = {"confidence_factor": 1.2, "knowledge_level": "LC2", "evidence": shown(confidence_factor="flat jacks")}
    found = made({"compressive_strength_mpa": 2.0}, tested)
    said = lift(found, "lift_confidence_factor")
    full = made({"compressive_strength_mpa": 2.0})
    assert said["zeta"].value == full.verdict.zeta_e
    assert said["zeta"].value < found.verdict.zeta_e


@pytest.mark.shows("verdict.reason", "lifts.q_code")
def test_that_another_q_than_2_is_shown_with_2_and_turns_what_rests_on_it():
    case = {"wall": [WALL], "demand": {"ag_g": 0.2, "soil_factor": 1.2, "q_code": 5.0}}
    found = asked_of(parse_case(case))
    check = next(one for one in found.checks if one.name == "linear_q_code")
    assert check is found.checks[0] and check.passed and check.q == 5.0
    assert lift(found, "lift_q_code")["zeta"].value == pytest.approx(0.4 * check.zeta)
    assert found.verdict.code == "indicative" and found.verdict.to_do[0].code == "give_reason"
    case["demand"]["evidence"] = shown(q_code="tests on specimens of this masonry")
    justified = asked_of(parse_case(case))
    assert justified.verdict.code == "verified_refined"
    assert lift(justified, "lift_q_code") is not None


@pytest.mark.shows("lifts.return_walls")
def test_that_the_friction_of_return_walls_is_shown_without_it():
    across = {"number": 2, "thickness_m": 0.5, "brick_height_m": 0.25, "brick_length_m": 0.2}
    case = {"wall": [{**WALL, "return_walls": across, "length_m": 4.0}], "demand": {"ag_g": 0.2, "soil_factor": 1.2}}
    found = asked_of(parse_case(case))
    bare = {"wall": [WALL], "demand": case["demand"]}
    without = asked_of(parse_case(bare))
    assert lift(found, "lift_return_walls")["zeta"].value == pytest.approx(without.verdict.zeta_e)


@pytest.mark.shows("lifts.participation")
def test_that_a_participation_below_that_of_the_clause_is_shown_with_it():
    """C7.2.10: gamma psi = 9/7 z/H_b."""
    modes = [{"period_s": 0.26, "damping": 0.10, "participation": 0.3}]
    wall = {"base_z_m": 6.0, "height_m": 3.0, "thickness_m": 0.45, "hold": behind(to_m=3.0)}
    found = made(wall, building={"height_m": 9.0, "storeys": 3, "modes": modes}, records=False)
    said = lift(found, "lift_participation")
    assert said["expected"] == pytest.approx(9.0 / 7.0 * 6.0 / 9.0)
    whole = [{**modes[0], "participation": 9.0 / 7.0 * 6.0 / 9.0}]
    other = made(wall, building={"height_m": 9.0, "storeys": 3, "modes": whole}, records=False)
    linear = next(check for check in other.checks if check.name == "linear_q_code")  # that it turns alone
    assert said["zeta"].value == pytest.approx(linear.zeta)
    assert lift(other, "lift_participation") is None


@pytest.mark.shows("kinematic.damaged_building")
def test_that_the_worst_corner_of_the_damaged_building_stands_beside_a_wall_at_height():
    wall = {"base_z_m": 6.0, "height_m": 3.0, "thickness_m": 0.45, "mechanism": "two_sided", "hold": None}
    found = made(wall, building=BUILDING, records=False)
    corners = [(1.5, 0.2), (2.0, 0.1), (2.0, 0.2)]
    zetas = [
        made(wall, building={**BUILDING, "period_factor": factor, "damping": damping}, records=False).verdict.zeta_e
        for factor, damping in corners
    ]
    said = lift(found, "other_building")
    assert said["zeta"].value == pytest.approx(min(zetas))
    assert (said["factor"], said["damping"]) == corners[int(np.argmin(zetas))] == (2.0, 0.1)


@pytest.mark.shows("lifts.generated")
def test_that_generated_motions_are_named_and_natural_ones_are_not():
    assert lift(made(), "generated_motions") == {}
    natural = {"record": [{"file": "tests/motions/noise_*.txt"}]}
    assert lift(made(records=False, **natural), "generated_motions") is None


def test_that_the_friction_of_return_walls_does_not_make_q_2_agree_with_the_histories():
    """The histories know no friction: where q = 2 passes by it alone, they stand alone until it is justified."""
    across = {"number": 4, "thickness_m": 0.6, "brick_height_m": 0.25, "brick_length_m": 0.2}
    wall = {"return_walls": across, "length_m": 4.0, "thickness_m": 0.75, "hold": behind("opening", to_m=6.0)}
    demand = {"ag_g": 0.17}
    found = made(wall, demand)
    checks = {check.name: check for check in found.checks}
    without = {check.name: check for check in made({"thickness_m": 0.75}, demand).checks}
    assert checks["linear_q_code"].passed and not without["linear_q_code"].passed
    assert checks["dynamic"].passed and checks["dynamic"].zeta == without["dynamic"].zeta
    assert found.verdict.code == "verified_refined"
    other = lift(found, "lift_return_walls")["zeta"].value
    assert other == pytest.approx(without["linear_q_code"].zeta)
    reason = {"evidence": shown(return_walls="toothed, seen on site")}
    assert made({**wall, **reason}, demand).verdict.code == "verified"


def test_that_a_larger_q_is_not_said_of_a_check_that_takes_none():
    """At SLD the linear check takes no q."""
    demand = {"ag_g": 0.05, "soil_factor": 1.2, "q_code": 5.0, "limit_state": "SLD"}
    found = asked_of(parse_case({"wall": [WALL], "demand": demand}))
    assert lift(found, "lift_q_code") is None


ABOVE = {"base_z_m": 6.0, "height_m": 3.0, "thickness_m": 0.35, "hold": behind(to_m=3.0)}
TESTED = {"confidence_factor": 1.0, "knowledge_level": "LC3", "evidence": shown(confidence_factor="flat jacks")}


def test_that_a_building_damped_beyond_the_clause_is_indicative_at_sld_until_it_is_justified():
    demand = {"ag_g": 0.05, "limit_state": "SLD"}
    as_is = made(ABOVE, demand, records=False, building=BUILDING)
    damped = {**BUILDING, "damping": 0.3, "period_factor": 2.5}
    found = made(ABOVE, demand, records=False, building=damped)
    assert as_is.verdict.code == "not_verified" and found.verdict.code == "indicative"
    assert lift(found, "other_building")["zeta"].value == pytest.approx(as_is.verdict.zeta_e)
    reason = {"evidence": shown(building="dampers are installed")}
    assert made(ABOVE, {**demand, **reason}, records=False, building=damped).verdict.code == "not_activated"


@pytest.mark.shows("verdict.reason")
def test_that_inputs_that_turn_the_outcome_together_alone_are_indicative():
    """At S 0.9 and q 2.1 the wall passes, with either alone at its other end too, not with both."""
    wall, demand = {}, {"ag_g": round(2.1 * 0.1 / (1.35 * 0.9 * 1.14), 4), "soil_factor": 0.9, "q_code": 2.1}
    found = made(wall, demand, records=False)
    bare = made(wall, demand | {"soil_factor": 1.0, "q_code": 2.0}, records=False)
    assert all(lift(found, code)["zeta"].value > 1.0 for code in ("lift_q_code", "lift_soil_factor"))
    assert lift(found, "lifts_together")["zeta"].value == pytest.approx(bare.verdict.zeta_e)
    assert bare.verdict.code == "not_verified" and found.verdict.code == "indicative"
    assert [one.code for one in found.verdict.to_do] == ["give_reason", "give_reason"]
    # with a reason for one of them the other alone turns nothing
    demand["evidence"] = shown(q_code="tests on specimens of this masonry")
    assert made(wall, demand, records=False).verdict.code == "verified"


@pytest.mark.shows("verdict.q_2_alone")
def test_that_q_2_agrees_by_an_fc_below_1_35_whose_investigations_are_shown():
    wall = {"compressive_strength_mpa": 10.0}
    found, full = (made(wall, {"ag_g": 0.13, **more}, records=False) for more in (TESTED, {}))
    (q_found,), (q_full,) = (
        [check for check in each.checks if check.name == "linear_q_code"] for each in (found, full)
    )
    assert q_found.passed and not q_full.passed
    assert (found.verdict.code, full.verdict.code) == ("verified", "verified_refined")
    assert lift(found, "q_rests_on") is None


@pytest.mark.shows("lifts.law")
def test_that_a_trilinear_law_is_shown_with_the_rigid_one():
    wall = {"mechanism": "two_sided", "hold": None, "thickness_m": 0.5, "law": "rigid"}
    law = {"law": {"elastic_limit": 0.3, "plateau_end": 0.301}}
    found, rigid = made({**wall, **law}, {"ag_g": 0.1}), made(wall, {"ag_g": 0.1})
    assert rigid.verdict.zeta_e < 1.0 < found.verdict.zeta_e and found.verdict.code == "indicative"
    assert lift(found, "lift_law")["zeta"].value == rigid.verdict.zeta_e
