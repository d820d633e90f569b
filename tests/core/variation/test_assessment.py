"""The checks of one wall at the demand with what limits them: ties, restraint, floor, records, a thicker wall."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.case.rules import parse_case
from core.codes.dynamic_check import AlternativeConfidence
from core.errors import InputError
from core.ground.ground_motion import GroundMotion
from core.setting.floors import Floor
from core.study.run import run
from core.text.sentence import notice
from core.variation import assessment
from core.variation.assessment import assess
from core.variation.evaluate import evaluate
from tests.core.variation.one_evaluation import BARE, MOTION, NTC, SOIL, WALL, history, scene_of, with_histories
from tests.holds import BOUND, behind, carries

TIE = {"kind": "tie", "out_kn_m": 1.0, "h_m": 4.0, "bar_length_m": 6.0}
SPECTRUM = {"ag_g": 0.1, "spectrum": NTC}
HELD = {"name": "v", "height_m": 3.5, "thickness_m": 0.15, "mechanism": "vertical_bending", "base_z_m": 0.0}
HELD |= {"unit_weight_kn_m3": 18.0, "hold": [{"kind": "contact", "evidence": {"kind": "drawing"}}]}
FLOOR = {"kind": "vertical", "kn_m": 60.0, "h_m": 3.5, "d_m": 0.075, "mass": "none"}
BUILDING = {"height_m": 9.0, "storeys": 3, "period_s": 0.26}


def limits(found):
    """Code of a limit -> what it says."""
    return {limit.code: dict(limit.values) for limit in found.verdict.limits}


def judged(zeta, wall=WALL, demand=SOIL, **values):
    """The scene of a wall whose histories say this."""
    return with_histories(scene_of(wall, demand), lambda *_: history(zeta, **values))


# the table of methods


@pytest.mark.shows("kinematic.sld_shown", "dynamic.fc")
def test_that_beside_the_checks_stand_the_histories_with_fc_on_the_other_side_and_a_g_of_sld():
    """a_0* = 0.05 g / 1.35; S of soil B at a_g 0.1 is 1.2: zeta_SLD = 0.05 / (1.35 x 0.12)."""
    for other in (AlternativeConfidence("demand", 1.1, True), AlternativeConfidence("demand", None, False)):
        rows = assess(judged(1.5, demand=SPECTRUM, zeta_other=other)).shown
        names = [(check.name, made) for check, made in rows]
        assert names == [
            *(("dynamic", True), ("dynamic_demand", False)),
            *(("nonlinear", True), ("floor_sld", False), ("linear_q_code", True)),
        ]
        beside, sld = rows[1][0], rows[3][0]
        assert (beside.zeta, beside.passed, beside.demand) == (other.zeta, None if other.zeta is None else True, None)
        assert (sld.clause, sld.unit, sld.passed) == ("C8.7.1.2.1.5", "g", None)
        assert (sld.capacity, sld.demand) == pytest.approx((0.05 / 1.35, 0.12))
        assert sld.zeta == pytest.approx(0.05 / (1.35 * 0.12))
    assert [check.name for check, _ in assess(judged(1.5)).shown] == ["dynamic", "linear_q_code"]
    without_other = assess(judged(1.5, demand=SPECTRUM)).shown
    assert [check.name for check, _ in without_other] == ["dynamic", "nonlinear", "floor_sld", "linear_q_code"]


def test_that_a_wall_above_the_ground_without_its_building_has_no_checks_and_is_undetermined():
    found = assess(scene_of(WALL | {"base_z_m": 3.0}))
    assert (found.kinematic, found.checks, found.shown, found.risk) == (None, (), (), None)
    assert found.verdict.code == "undetermined" and found.verdict.zeta_e is None


# a thicker wall


@pytest.fixture
def thicker(monkeypatch):
    """The assessment of a wall of 0.4 m whose zeta is 0.74, and with factors of the thickness another."""

    def found(zetas, scene=None, refused=(), without=()):
        def stated(scene, *parts, **named):
            factor = round(scene.wall.thickness / 0.4, 6)
            if factor in refused:
                raise InputError("unstable_under_loads", threshold=0.0)
            made = evaluate(scene, *parts, **named)
            checks = [replace(check, zeta=zetas.get(factor, check.zeta)) for check in made.checks]
            return replace(made, checks=() if factor in without else tuple(checks))

        monkeypatch.setattr(assessment, "evaluate", stated)
        return limits(assess(scene or scene_of())).get("thicker_less")

    return found


@pytest.mark.parametrize("worst, cm", [(1.05, 42.0), (1.1, 44.0), (1.2, 48.0), (1.3, 52.0)])
def test_that_of_walls_thicker_by_5_10_20_and_30_percent_the_one_with_the_lowest_zeta_is_named(thicker, worst, cm):
    zetas = {1.05: 0.71, 1.1: 0.72, 1.2: 0.73, 1.3: 0.715} | {worst: 0.70}
    said = thicker(zetas)
    assert (said["cm"].value, said["zeta"].value) == (pytest.approx(cm), 0.70)
    assert said["given"].value == pytest.approx(2.0 * 0.05 / (1.35 * 0.1))


def test_that_a_thicker_wall_is_named_where_its_zeta_is_lower_in_two_digits(thicker):
    """zeta is 0.741."""
    assert thicker({1.1: 0.736}) is None
    assert thicker({1.1: 0.734})["zeta"].value == 0.734


def test_that_a_thicker_wall_that_is_refused_or_has_no_number_is_passed_over(thicker):
    assert thicker({1.2: 0.7}, refused=(1.05, 1.1), without=(1.3,))["cm"].value == pytest.approx(48.0)
    assert thicker({1.1: 0.6, 1.2: 0.7}, without=(1.1,))["zeta"].value == 0.7
    assert thicker({1.1: None, 1.2: 0.7})["zeta"].value == 0.7
    assert thicker({}, refused=(1.05, 1.1, 1.2, 1.3)) is None
    assert thicker({1.0: None, 1.1: 0.7}) is None


def test_that_of_histories_no_thicker_wall_is_asked(thicker):
    assert thicker({1.1: 0.6}, judged(1.2)) is None


def test_that_a_real_wall_grows_with_its_thickness():
    assert "thicker_less" not in limits(assess(scene_of()))


# ties


@pytest.mark.parametrize(
    "tied, bare, said",
    [(1.20, 1.21, True), (1.20, 1.204, False), (1.196, 1.204, False), (1.20, 1.1, False), (1.2, None, False)],
)
def test_that_histories_say_zeta_without_the_ties_where_it_is_larger_in_two_digits(monkeypatch, tied, bare, said):
    scene = with_histories(scene_of(carries(TIE, **BARE)), lambda *_: history(tied))
    asked = []

    def without(scene, **_):
        asked.append(scene.wall.ties)
        return history(bare)

    monkeypatch.setattr(assessment, "check_by_histories", without)
    words = limits(assess(scene)).get("ties_histories")
    assert asked == [()] and (words is not None) == said
    if said:
        assert (words["tied"].value, words["bare"].value) == (tied, bare)


def test_that_no_zeta_without_ties_is_asked_of_a_wall_without_ties_or_whose_histories_have_no_number(monkeypatch):
    monkeypatch.setattr(assessment, "check_by_histories", lambda *_, **__: pytest.fail("asked"))
    assert "ties_histories" not in limits(assess(judged(1.2)))
    assert "ties_histories" not in limits(assess(judged(None, carries(TIE, **BARE), passed=False)))
    assert "ties_histories" not in limits(assess(scene_of(carries(TIE, **BARE))))
    monkeypatch.setattr(assessment, "check_by_histories", lambda *_, **__: None)
    assert "ties_histories" not in limits(assess(judged(1.2, carries(TIE, **BARE))))


def test_that_a_tie_that_breaks_early_is_said_with_both_zeta_of_the_displacement_check():
    found = assess(scene_of(carries(TIE, **BARE), SPECTRUM))
    said = limits(found)["ties_displacement"]
    bare = assess(scene_of(WALL, SPECTRUM)).checks[0]
    assert said["bare"].value == pytest.approx(bare.zeta) and said["tied"].value < bare.zeta
    long = TIE | {"elongation_m": 1.0}
    held = assess(scene_of(carries(long, **BARE), SPECTRUM))
    assert held.checks[0].zeta > bare.zeta and "ties_displacement" not in limits(held)
    assert "ties_displacement" not in limits(assess(scene_of(WALL, SPECTRUM)))


def test_that_a_tie_with_slack_is_said_not_to_be_counted_by_the_checks_of_the_clauses():
    for tie, said in ((TIE | {"slack_mm": 5.0}, True), (TIE | {"slack_mm": 0.0}, False), (TIE, False)):
        for demand in (SOIL, SPECTRUM):
            assert ("slack_not_counted" in limits(assess(scene_of(carries(tie, **BARE), demand)))) == said
    slack = carries(TIE | {"slack_mm": 5.0}, **BARE)
    # at SLC without a spectrum the histories stand alone
    alone = judged(1.5, slack, SOIL | {"limit_state": "SLC"})
    assert [check.name for check in assess(alone).checks] == ["dynamic"]
    assert "slack_not_counted" not in limits(assess(alone))
    assert "slack_not_counted" in limits(assess(judged(1.5, slack)))


@pytest.mark.shows("kinematic.ties_at_sld")
def test_that_at_sld_the_zeta_with_the_ties_is_shown_beside_the_one_without():
    """By hand, W 28.8 kN/m, a tie of 0.5 kN/m at 3.6 m within its yield: alpha = (2.88 + 1.8) / 57.6."""
    tie = TIE | {"out_kn_m": 0.5, "h_m": 3.6}
    found = assess(scene_of(carries(tie, **BARE), SOIL | {"limit_state": "SLD"}))
    assert found.checks[0].zeta == pytest.approx(0.05 / (1.35 * 0.1))
    said = limits(found)
    assert said["ties_at_sld"]["zeta"].value == pytest.approx((2.88 + 1.8) / 57.6 / (1.35 * 0.1))
    mass = {"kind": "vertical", "kn_m": 9.0, "d_m": 0.2, "h_m": 4.0, "mass": "horizontal"}
    both = assess(scene_of(carries(tie, mass, **BARE), SOIL | {"limit_state": "SLD"}))
    # (28.8 + 9) x 0.1 + 1.8 over 28.8 x 2 + 9 x 4; e* = 93.6^2 / (37.8 x (28.8 x 4 + 9 x 16))
    alpha, share = (3.78 + 1.8) / 93.6, 93.6**2 / (37.8 * 259.2)
    assert limits(both)["ties_at_sld"]["zeta"].value == pytest.approx(alpha / share / (1.35 * 0.1))
    assert "ties_at_sld" not in limits(assess(scene_of(WALL, SOIL | {"limit_state": "SLD"})))
    assert "ties_at_sld" not in limits(assess(scene_of(carries(tie, **BARE))))


# life and records


@pytest.mark.parametrize("years, said", [(49.9, True), (35.0, True), (50.0, False), (75.0, False)])
def test_that_a_reference_period_below_50_years_is_a_limit_where_no_hazard_says_a_g(years, said):
    demand = SOIL | {"nominal_life_years": years, "use_class_factor": 1.0}
    words = limits(assess(scene_of(demand=demand))).get("short_life")
    assert (words == {"years": years, "least": 50.0}) if said else words is None
    hazard = [{"return_period_years": t, "ag_g": ag} for t, ag in ((30.0, 0.0999), (2475.0, 0.1001))]
    assert "short_life" not in limits(assess(scene_of(demand=demand | {"hazard": hazard})))


@pytest.mark.parametrize("format, said", [("generated", True), ("plain", False)])
def test_that_generated_motions_are_a_limit_and_those_by_default_are_said_with_both_zeta(format, said):
    motion = replace(MOTION, format=format)
    scene = with_histories(scene_of(demand=SPECTRUM), lambda *_: history(1.5), (MOTION, motion))
    assert ("generated_motions" in limits(assess(scene))) == said
    by_default = limits(assess(replace(scene, by_default=True)))
    assert "generated_motions" not in by_default
    words = by_default["by_default"]
    assert (words["n"], words["dynamic"].value) == (2, 1.5)
    assert words["nonlinear"].value == pytest.approx(evaluate(scene_of(demand=SPECTRUM)).zeta)
    assert "by_default" not in limits(assess(scene))
    none = assess(replace(scene, histories=lambda *_: None, by_default=True))
    assert not {"by_default", "generated_motions"} & set(limits(none))


def test_that_doubted_records_are_counted_and_the_first_three_named():
    def record(name, code):
        values = {} if code is None else {"value": 1.0}
        warnings = () if code is None else (notice(code, **values),)
        return GroundMotion(name, np.sin(np.arange(200) / 10.0), 0.01, warnings=warnings)

    codes = {"a": None, "b": "offset", "c": "borehole", "d": "jump", "e": "unprocessed", "f": "in_structure"}
    ground = tuple(record(*item) for item in codes.items())
    said = limits(assess(with_histories(scene_of(), lambda *_: history(1.5), ground)))["records_doubted"]
    assert said == {"n": 4, "names": "b, c, d"}
    sound = tuple(motion for motion in ground if motion.name in "ae")
    assert "records_doubted" not in limits(assess(with_histories(scene_of(), lambda *_: history(1.5), sound)))


@pytest.mark.parametrize(("doubted", "said"), [(0, False), (1, False), (2, True), (8, True)])
def test_that_a_set_that_is_one_by_its_doubted_records_alone_is_indicative(doubted, said):
    """Fourteen vertical components made a mean."""
    warned = (notice("vertical"),)
    ground = tuple(
        GroundMotion(f"r{k}", np.sin(np.arange(200) / 10.0) * (1.0 + 0.01 * k), 0.01, warnings=warned * (k < doubted))
        for k in range(8)
    )
    found = assess(with_histories(scene_of(demand=SPECTRUM), lambda *_: history(1.5), ground))
    assert ("few_sound_records" in limits(found)) == said


# what holds the wall


def by_restraint(held, free, wall=WALL, demand=SOIL):
    """A one-sided wall with these histories (zeta, passed), and others without what stands behind it."""

    def said(model, *_):
        return history(*(held if model.one_sided else free))

    return assess(with_histories(scene_of(wall, demand), said))


@pytest.mark.parametrize(
    "held, free, turns",
    [((1.5, True), (0.8, False), True), ((1.5, True), (1.2, True), False), ((1.5, True), (1.2, False), True)],
)
def test_that_a_restraint_turns_the_outcome_where_the_wall_fails_without_it(held, free, turns):
    found = by_restraint(held, free)
    assert found.lower_bound.zeta == found.verdict.lower_bound == free[0] and found.bound_passes == free[1]
    rows = [row for row in found.verdict.assumptions if row.key == "hold"]
    assert len(rows) == turns  # a restraint that turns nothing is no row
    if not turns:
        return
    (row,) = rows
    assert (row.turns, row.zeta, row.source, row.raises) == (turns, free[0], "declared", True)
    assert "opening" in row.reason.text("en") and "saggio" in row.reason.text("it")
    assert row.words.code == "restraint_fails" and row.value.code == "choice_contact"


def test_that_a_restraint_left_out_or_without_evidence_has_no_reason():
    bare = {key: value for key, value in WALL.items() if key != "hold"}
    for wall, source in ((bare, "left_out"), (bare | {"hold": [{"kind": "cross_walls"}]}, "declared")):
        rows = by_restraint((1.5, True), (0.8, False), wall).verdict.assumptions
        (row,) = (row for row in rows if row.key == "hold")
        assert (row.source, row.reason) == (source, "")


def test_that_a_restraint_without_which_the_wall_was_not_followed_turns_what_passes_until_it_is_shown():
    """Without histories nothing says what holds a wall that is free; 60 kN/m at its inner face would overturn it."""
    held, bare = WALL | {"hold": behind("opening", to_m=4.0)}, WALL | {"hold": behind("", to_m=4.0)}
    falls = {"load": [FLOOR | {"h_m": 4.0, "d_m": 0.4}], "unloaded_confirmed": False}
    for scene, code in ((scene_of, "restraint_unfollowed"), (None, "restraint_stands")):
        for wall, shown in ((bare, False), (held, True)):
            if scene:
                found = assess(scene(wall, {"ag_g": 0.02, "soil_factor": 1.2, "zeta_target": 1.0}))
            else:
                found = by_restraint((1.5, True), (0.8, False), wall | falls)
            assert found.lower_bound is None and found.verdict.lower_bound is None and found.bound_passes is None
            rows = [row for row in found.verdict.assumptions if row.key == "hold"]
            rests = scene is not None  # it does not lift, to either side
            assert bool(rows) == (not rests)
            assert all((row.zeta, row.words.code, bool(row.reason)) == (None, code, shown) for row in rows)
            assert (found.verdict.code == "indicative") == (not rests)


def test_that_a_wall_of_both_mechanisms_has_the_other_beside_it_and_no_row_of_its_restraint():
    found = by_restraint((1.5, True), (0.8, False), WALL | {"mechanism": "both"})
    assert "hold" not in {row.key for row in found.verdict.assumptions}


def test_that_a_wall_that_rocks_both_ways_needs_no_restraint():
    two_sided = {key: value for key, value in WALL.items() if key != "hold"}
    found = by_restraint((1.5, True), (0.8, False), two_sided | {"mechanism": "two_sided"} | BOUND)
    assert found.lower_bound is None and "hold" not in {row.key for row in found.verdict.assumptions}


def test_that_the_wall_without_its_restraint_rocks_by_the_theory():
    """A velocity ratio that is given is that of the one-sided wall."""
    seen = []

    def said(model, *_):
        seen.append(model)
        return history(1.2)

    assess(with_histories(scene_of(WALL | {"velocity_ratio": 0.2}), said))
    theory = scene_of({key: value for key, value in WALL.items() if key != "hold"} | {"mechanism": "two_sided"})
    free = {model.ratio_at_rest for model in seen if not model.one_sided}
    assert free == {theory.model.ratio_at_rest} and theory.model.ratio_at_rest > 0.9


def test_that_a_wall_held_at_its_top_is_shown_overturning_about_its_base(monkeypatch):
    light = HELD | {"load": [FLOOR | {"kn_m": 0.5}]}
    weak = SPECTRUM | {"ag_g": 0.06}
    found = assess(scene_of(light, weak, building=BUILDING))
    free = {key: value for key, value in light.items() if key != "hold"}
    alone = assess(scene_of(free | {"mechanism": "one_sided"}, weak, building=BUILDING))
    assert found.verdict.lower_bound == pytest.approx(alone.verdict.zeta_e) and found.bound_passes is False
    (row,) = (row for row in found.verdict.assumptions if row.key == "hold")
    assert row.words.code == "top_fails" and row.outcome == "not_verified"
    monkeypatch.setattr(assessment, "carries", lambda wall: False)
    fallen = assess(scene_of(light, weak, building=BUILDING)).verdict
    assert fallen.lower_bound is None and fallen.zeta_e == found.verdict.zeta_e


def test_that_a_wall_held_at_its_top_has_no_histories_and_its_top_takes_a_force():
    found = assess(scene_of(HELD | {"load": [FLOOR]}, SPECTRUM, building=BUILDING))
    said, bending = limits(found), found.kinematic.chain.bending
    assert said["no_histories"] == {"q": 2} and said["top_force"] == {"force": pytest.approx(1e-3 * bending.top_force)}
    assert "hinge_highest" not in said and not bending.highest


@pytest.mark.parametrize("highest", [(True, False), (False, True), (False, False)])
def test_that_a_hinge_as_high_as_one_is_looked_for_is_a_limit(monkeypatch, highest):
    """highest : of the mechanism that starts, of the displacement check"""
    from core.codes.vertical_bending import Bending

    scene = scene_of(HELD | {"load": [FLOOR | {"kn_m": 0.5}]}, SPECTRUM, building=BUILDING)
    found = evaluate(scene).kinematic
    start, moved = found.chain.bending, found.moved.bending
    assert start != moved
    monkeypatch.setattr(Bending, "highest", property(lambda self: highest[self == moved]))
    words = limits(assess(scene)).get("hinge_highest")
    assert (words == {"height": start.h1}) if any(highest) else words is None


# floor, number, many walls


@pytest.mark.parametrize("ratio, said", [(0.79, True), (0.8, False), (None, False)])
def test_that_the_floor_spectrum_of_the_code_below_80_percent_of_the_records_is_a_limit(monkeypatch, ratio, said):
    monkeypatch.setattr(Floor, "code_over_records", lambda self, mechanism: ratio)
    found = assess(scene_of(WALL | {"base_z_m": 3.0}, SPECTRUM, building=BUILDING))
    assert found.code_over_records == ratio
    assert limits(found).get("code_below_records") == ({"ratio": ratio} if said else None)
    assert assess(scene_of(demand=SPECTRUM)).code_over_records is None


def test_that_a_building_of_odd_storeys_is_a_limit_of_a_wall_in_it_alone():
    odd = BUILDING | {"storeys": 1}
    assert "odd_storeys" in limits(assess(scene_of(WALL | {"base_z_m": 3.0}, SPECTRUM, building=odd)))
    assert "odd_storeys" not in limits(assess(scene_of(WALL, SPECTRUM, building=odd)))


def test_that_records_weaker_than_the_demand_tell_no_pga_and_the_clauses_do():
    scene = judged(1.5)
    assert assess(scene).risk.pga == pytest.approx(1.5 * 0.1 * 9.80665)
    weak = scene.replace_parts(demand=replace(scene.demand, weak_share=0.7))
    clauses = scene_of()
    of_clauses = assess(clauses.replace_parts(demand=replace(clauses.demand, weak_share=0.7))).risk
    assert of_clauses.pga == pytest.approx(2.0 * 0.05 / 1.35 * 9.80665)
    assert assess(weak).risk == of_clauses and assess(weak).checks[-1].zeta == 1.5
    assert assess(judged(None, passed=False)).risk is None


def test_that_the_safety_index_is_of_the_low_end_of_the_spread_of_histories():
    found = assess(judged(0.7, passed=False, zeta_spread=(0.5, 0.9), holds_at_target=False)).risk
    clauses = assess(scene_of()).risk
    assert (found.letter, clauses.index) == ("C", pytest.approx(2.0 * 0.05 / (1.35 * 0.1)))


@pytest.mark.shows("verdict.table")
@pytest.mark.parametrize("ag, q, fails", [(0.1, 2.0, True), (0.1, 3.0, False), (0.05, 2.0, False)])
def test_that_a_wall_that_fails_has_no_table(monkeypatch, ag, q, fails):
    """zeta with q = 2 is 0.0741 / a_g: 0.74, 1.11 and 1.48."""
    seen = []
    monkeypatch.setattr(assessment, "evaluate_assumptions", lambda found, _: seen.append(found) or ())
    found = assess(scene_of(demand={"ag_g": ag, "soil_factor": 1.0, "q_code": q}))
    assert found.checks[0].passed != fails and bool(seen) != fails and found.lower_bound is None


@pytest.mark.shows("verdict.table")
def test_that_a_wall_that_fails_but_passes_with_q_2_is_asked_whether_that_is_owed_to_an_input_without_histories():
    """By histories it fails; q = 2 passes, and its rows tell whether that is owed to one of them."""
    runs = []

    def said(model, motions, there):
        runs.append(there)
        return history(0.9, False)

    scene = with_histories(scene_of(demand=SOIL | {"ag_g": 0.05}), said)
    found = assess(scene)
    assert found.checks[1].passed and found.verdict.code == "q2_unsafe" and len(runs) == 1
    assert not found.verdict.assumptions


@pytest.mark.shows("verdict.reason")
def test_that_contact_nobody_shows_is_asked_for_where_the_wall_without_it_is_worse():
    """Without its contact the wall has another zeta: nothing is called verified on a contact that may not be there."""
    wall = {"name": "w", "mechanism": "one_sided", "height_m": 5.0, "thickness_m": 0.6, "unit_weight_kn_m3": 18.0}
    wall |= {"base_z_m": 0.0, "unloaded_confirmed": True}
    case = {
        "demand": {"ag_g": 0.08, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}},
        "generate": {"count": 7, "seed": 1},
    }
    outcomes = {}
    for shown in (True, False):
        hold = {"kind": "contact", "to_m": 5.0} | ({"evidence": {"kind": "survey"}} if shown else {})
        found = run(parse_case(case | {"wall": [wall | {"hold": [hold]}]}), base_dir=Path()).walls[0].assessment
        outcomes[shown] = found
    (row,) = [row for row in outcomes[True].verdict.assumptions if row.key == "hold"] or [None]
    bound = outcomes[True].verdict.lower_bound
    assert bound is not None and round(bound, 2) < round(outcomes[True].verdict.zeta_e, 2)
    assert outcomes[True].verdict.code in ("verified", "verified_refined")
    assert outcomes[False].verdict.code == "indicative" and row is None
    (action,) = [one for one in outcomes[False].verdict.to_do if one.code == "to_evidence"]
    assert "[[wall.hold]]: kind = drawing | opening" in action.text("en")
