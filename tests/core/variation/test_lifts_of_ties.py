"""What of ties lifts zeta, and what the clauses do not count of them: a wall of 3.0 x 0.25 m with a tie 2.9 m up."""

import pytest

from core.errors import InputError
from tests.clauses_alone import parse_case
from tests.conftest import ROOT
from tests.core.variation.test_assumptions import asked_of, lift
from tests.holds import carries

WALL = {
    "name": "w",
    "height_m": 3.0,
    "thickness_m": 0.25,
    "length_m": 8.0,
    "mechanism": "one_sided",
    "base_z_m": 0.0,
    "unit_weight_kn_m3": 18.0,
    "hold": [{"kind": "contact", "to_m": 3.0, "evidence": {"kind": "drawing"}}],
    "hinge_heights": "base",
}
DEMAND = {"ag_g": 0.14, "spectrum": {"code": "NTC2018", "f0": 2.4, "tc_star_s": 0.35, "soil": "B", "topography": "T1"}}
TIE = {"kind": "tie", "h_m": 2.9, "out_kn_m": 0.9, "bar_length_m": 6.0}
LONG = {**TIE, "elongation_m": 0.3}
BAR = {"number": 1, "diameter_mm": 6.0, "thread_mm": 8.0}


def found_of(*loads, records=False, demand=None, **wall):
    own = carries(*loads, **WALL | wall)
    table = {"wall": [own], "demand": {**DEMAND, **(demand or {})}, "analysis": {"q_step": 0.05}}
    if records:
        table["generate"] = {"scatter": 0.0, "count": 3, "seed": 1}
    return asked_of(parse_case(table))


def zeta(found, name="nonlinear"):
    return next(check.zeta for check in found.checks if check.name == name)


SHOWN = {"evidence": {"kind": "calculation", "reference": "R.7"}}
"""What shows that a tie holds, its anchorage and its elongation."""


BARE = pytest.fixture(scope="module")(lambda: found_of())


def test_that_a_tie_with_slack_counts_nothing_in_a_check_of_the_clauses(BARE):
    """A tenth of a millimetre of slack, or as much as the limit of displacement allows."""
    assert BARE.verdict.code == "not_verified" and found_of(LONG).verdict.zeta_e > 1.0
    for slack in (0.1, 15.0, 40.0):
        found = found_of({**LONG, "slack_mm": slack, **SHOWN})
        for one, bare in zip(found.checks, BARE.checks, strict=True):
            assert one.zeta == pytest.approx(bare.zeta, rel=1e-12)
        assert lift(found, "slack_not_counted") == {} and found.verdict.code == "not_verified"


@pytest.mark.shows("lifts.slack")
def test_that_slack_that_lifts_zeta_of_the_histories_is_shown_without_it_and_without_the_tie():
    found = found_of({**LONG, "slack_mm": 3.0, **SHOWN}, records=True, demand={"ag_g": 0.12})
    bare = found_of(records=True, demand={"ag_g": 0.12})
    said = lift(found, "lift_slack")
    assert said["zeta"].value == pytest.approx(bare.verdict.zeta_e, rel=0.04) and said["zeta"].value < zeta(
        found, "dynamic"
    )
    taut = found_of({**LONG, **SHOWN}, records=True, demand={"ag_g": 0.12})
    assert said["zeta_taut"].value == pytest.approx(zeta(taut, "dynamic"), rel=0.04)
    assert lift(taut, "lift_slack") is None


@pytest.mark.parametrize("slack", [0.1, 20.0])
def test_that_slack_makes_no_tie_weaker_than_the_wall_can_take(slack):
    strong = {**LONG, "out_kn_m": 500.0, "slack_mm": slack}
    with pytest.raises(InputError) as refused:
        found_of(strong)
    assert refused.value.code == "tie_too_strong"


@pytest.mark.shows("lifts.brittle")
@pytest.mark.parametrize("more", [{}, {"elongation_m": 0.0069}, {"elongation_m": 0.01}])
def test_that_a_tie_that_breaks_before_the_displacement_counted_on_is_named(BARE, more):
    """It yields at 6.88 mm; 0.40 theta_c stretches it by 96 mm. A further tie that holds out changes nothing."""
    for others in ((), ({**LONG, "out_kn_m": 0.01},)):
        found = found_of({**TIE, **more}, *others)
        q = next(check for check in found.checks if check.name == "linear_q_code")
        assert lift(found, "lift_brittle")["zeta"].value < q.zeta
        if not others:
            # it turns the check with q alone, and is told by that
            assert lift(found, "lift_brittle")["zeta"].value == pytest.approx(zeta(BARE, "linear_q_code"))
        assert found.verdict.code in ("indicative", "not_verified")
    assert lift(found_of(LONG), "lift_brittle") is None


@pytest.mark.shows("verdict.q_2_alone")
def test_that_a_tie_that_breaks_does_not_make_q_2_agree_with_the_histories():
    tie, demand = {**TIE, "out_kn_m": 0.9}, {"ag_g": 0.12}
    found, bare = found_of(tie, records=True, demand=demand), found_of(records=True, demand=demand)
    assert zeta(found, "linear_q_code") > 1.0 > zeta(bare, "linear_q_code")
    assert lift(found, "lift_brittle")["zeta"].value == pytest.approx(zeta(bare, "linear_q_code"))
    assert found.verdict.code != "verified"


def test_that_alpha_0_counts_ties_where_they_act_together():
    """One tie is gone before the other pulls: alpha_0 is that of the stronger alone."""
    early, late = {**TIE, "out_kn_m": 0.4, "bar_length_m": 1.0}, {**TIE, "out_kn_m": 0.4, "bar_length_m": 30.0}
    alone = [found_of(tie).kinematic.alpha0 for tie in (early, late)]
    both = found_of(early, late).kinematic.alpha0
    added = sum(alone) - found_of().kinematic.alpha0
    assert max(alone) < both < added
    # 1.146 mm of the early one are 0.033 of what the late one yields at
    held = 0.4e3 * 2.9 * (1.0 + 1.0 / 30.0)
    assert both == pytest.approx((13.5e3 * 0.125 + held) / (13.5e3 * 1.5), rel=1e-12)


@pytest.mark.shows("kinematic.ties_at_sld")
def test_that_no_tie_is_counted_at_sld_and_the_other_reading_is_shown(BARE):
    demand = {"ag_g": 0.09, "limit_state": "SLD"}
    found, bare = found_of({**LONG, "prestress": 0.3}, demand=demand), found_of(demand=demand)
    assert zeta(found, "linear_q_code") == zeta(bare, "linear_q_code")
    tied = found_of({**LONG, "prestress": 0.3}, demand={"ag_g": 0.09}).kinematic
    other = zeta(bare, "linear_q_code") * tied.alpha0 / bare.kinematic.alpha0
    assert lift(found, "ties_at_sld")["zeta"].value == pytest.approx(other)
    assert lift(bare, "ties_at_sld") is None


@pytest.mark.shows("lifts.anchorage")
def test_that_the_anchorage_of_a_tie_is_named_until_something_shows_that_it_holds(BARE):
    by_bar = {"kind": "tie", "h_m": 2.9, "bar_length_m": 6.0, "elongation_m": 0.3}
    found = found_of(LONG)
    assert lift(found, "lift_anchorage")["zeta"].value == pytest.approx(zeta(BARE))
    assert found.verdict.code == "indicative" and found.verdict.zeta_e > 1.0
    # bars without an anchorage fail at yield: the linear check alone counts them
    found = found_of({**by_bar, "bar": BAR})
    assert lift(found, "lift_anchorage")["zeta"].value == pytest.approx(zeta(BARE, "linear_q_code"))
    assert lift(found, "lift_anchorage")["check"].code == "linear_q_code" and found.verdict.code == "not_verified"
    held = found_of({**by_bar, "bar": {**BAR, "anchorage_kn": 11.0}})
    assert lift(held, "lift_anchorage") is None and held.verdict.zeta_e > 1.0
    shown = found_of({**LONG, **SHOWN})
    assert shown.verdict.zeta_e > 1.0 and shown.verdict.code == "verified"


def test_that_two_reasons_of_the_loads_change_the_wall_together():
    """Each alone leaves it satisfied, both together do not: no change undoes another."""
    from core.rocking.methods import AUTO
    from core.setting.check_input import CheckInput
    from core.setting.demand_input import read_demand
    from core.variation.favourable_loads import _drop_ties, _of_ties

    wall = parse_case({"wall": [carries(LONG, {**TIE, "out_kn_m": 0.05}, **WALL)], "demand": DEMAND}).wall[0]
    demand = read_demand(parse_case({"wall": [WALL | {"unloaded_confirmed": True}], "demand": DEMAND}), ROOT)
    scene = CheckInput(wall, "one_sided", demand, None, None, None, (), None, "both", AUTO, False, False)
    both = _of_ties(elongation_m=None)(_drop_ties(lambda tie: tie.out_kn_m == 0.05)(scene)).wall
    assert [(tie.out_kn_m, tie.elongation_m) for tie in both.ties] == [(0.9, None)]
    assert both.restraints == wall.restraints


@pytest.mark.long
def test_that_every_reason_reads_in_both_languages(fine):
    by_bar = {"kind": "tie", "h_m": 2.9, "bar_length_m": 6.0, "elongation_m": 0.3, "bar": BAR}
    slack, drawn = {**LONG, "out_kn_m": 0.1, "slack_mm": 2.0}, {**TIE, "out_kn_m": 0.1, "prestress": 0.5}
    loads = by_bar, slack, drawn, {"kind": "thrust", "h_m": 2.0, "kn_m": -0.1}
    said = set()
    for records, state in ((False, "SLV"), (True, "SLV"), (False, "SLD")):
        found = found_of(*loads, records=records, demand={"ag_g": 0.1, "limit_state": state})
        said |= found.said.keys()
        for reason in found.verdict.reasons:
            assert all("{" not in reason.text(language) for language in ("en", "it"))
    of_ties = {"lift_brittle", "lift_slack", "lift_anchorage", "lift_prestress", "lift_inward", "slack_not_counted"}
    assert of_ties | {"ties_at_sld"} <= said


def test_that_a_thread_far_beyond_its_bar_is_refused():
    by_bar = {"kind": "tie", "h_m": 2.9, "bar_length_m": 6.0}
    with pytest.raises(InputError) as refused:
        found_of({**by_bar, "bar": {**BAR, "thread_mm": 9.1}})
    assert refused.value.code == "tie_thread_too_large"
    found_of({**by_bar, "bar": {**BAR, "thread_mm": 9.0}})
