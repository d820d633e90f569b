"""What holds a wall gives way, or does not: the demand decides, not the start of the mechanism."""

import itertools
import math
import random
from dataclasses import replace

import pytest

from core.case.held_stretches import find_held_stretches
from core.case.held_top import mirror_inward
from core.case.reader import case_of_text
from core.case.rules import parse_case
from core.case.spans_between_ties import cut_span
from core.codes.kinematic import Check
from core.codes.vertical_bending import lowest_hinge
from core.errors import InputError
from core.mechanism.bending_reactions import MovingStrip
from core.mechanism.holds import BASE, ENDS, TOP, limit_of_ends, limits_of_bending, reaction_of_top
from core.mechanism.sections import Sections
from core.study.run import run
from core.variation.evaluate import Evaluation, _place_hold
from core.wall.bending import strip_of
from tests.conftest import ROOT
from tests.holds import at_top

HELD = {
    "name": "held",
    "mechanism": "vertical_bending",
    "height_m": 3.0,
    "thickness_m": 0.8,
    "length_m": 4.0,
    "unit_weight_kn_m3": 18.0,
    "base_z_m": 0.0,
    "hinge_setback_m": 0.0,
    "hold": at_top(3.0, 30.0),
    "load": [{"kind": "vertical", "kn_m": 20.0, "d_m": 0.30, "h_m": 3.0, "mass": "none"}],
}


def limits(**keys):
    """Limits of a wall to both sides, by hold and side."""
    wall = parse_case({"wall": [HELD | keys]}).wall[0]
    made = {}
    for side, there in (("outward", wall), ("inward", mirror_inward(wall))):
        strip = strip_of(there.in_si)
        moving = MovingStrip(strip, lowest_hinge(strip))
        made |= {(limit.hold, limit.side): limit for limit in limits_of_bending(there.in_si, moving, side)}
    return made


def test_that_a_hold_of_30_kn_is_overcome_where_the_worked_wall_reaches_it():
    """By the bound at 0.946 of motions of 2.0093 g; the wall's own histories reach 30 at 0.954."""
    assert limits()[TOP, "outward"].share(2.0093143) == pytest.approx(0.946, abs=5e-4)


def of_histories(**hold):
    """Reactions of the worked wall along its histories, the weakest first."""
    spectrum = {"code": "NTC2018", "f0": 2.45, "tc_star_s": 0.35, "soil": "C", "topography": "T1"}
    table = {"demand": {"ag_g": 0.9, "confidence_factor": 1.35, "spectrum": spectrum}, "generate": {"seed": 1}}
    table["building"] = {"height_m": 9.0, "storeys": 3, "period_s": 0.26}
    case = parse_case(table | {"wall": [HELD | {"hold": [at_top(3.0, 30.0)[0] | hold]}]})
    found = run(case, base_dir=ROOT).walls[0].assessment
    return {(row.hold, row.direction, row.impulse is None): row for row in found.reactions if row.check == "dynamic"}


@pytest.mark.shows("held.reaction")
def test_that_a_hold_is_followed_along_the_histories_where_their_bound_says_that_it_gives_way():
    """Worked value 6: 30.764012 kN/m at the demand, 30 reached at 0.954 where the bound says 0.946."""
    reaction = of_histories()[TOP, "outward", True]
    assert reaction.at_demand == pytest.approx(30764.012, abs=0.01)
    assert reaction.gives_way == pytest.approx(0.954, abs=5e-4)


@pytest.mark.shows("held.impulse")
def test_that_a_hold_with_a_stiffness_or_an_elongation_has_to_take_the_impulses():
    """Worked value 9: 731.482 N s/m as the wall returns from inward, 48.4022 kN/m at 3.2712e6 N/m; a hold that yields
    takes all of one motion by its elongation, the sum of J^2/(2 m_T F)."""
    stiff = of_histories(stiffness_kn_m2=3271.2)[TOP, "outward", False]
    assert stiff.impulse == pytest.approx(731.482, abs=1e-3)
    assert stiff.at_demand == pytest.approx(48402.2, rel=1e-5) and 0.5 < stiff.gives_way < 1.0
    yields, more = (of_histories(elongation_m=stretch)[TOP, "outward", False] for stretch in (0.01, 0.02))
    # it stays stretched from one to the next: 7.17 mm at 60 kN/m, the largest alone 5.97
    assert yields.at_demand * 0.01 == pytest.approx(7.17e-3 * 60e3, abs=0.3)
    assert yields.at_demand * 0.01 > 1.19 * 731.482**2 / (2.0 * 747.105)
    assert yields.gives_way < 1.0 <= more.gives_way
    with pytest.raises(InputError):
        parse_case({"wall": [HELD | {"hold": [{"kind": "floor", "h_m": 3.0, "stiffness_kn_m2": 3000.0}]}]})


@pytest.mark.shows("held.yields")
def test_that_a_hold_that_yields_is_asked_for_the_least_and_is_never_worse():
    """2 kN/m at a ground floor that a stiff hold asks 2.8 of (worked value 1), which needs none to stay at rest; random
    walls: what it holds with an elongation is no less, and alike once it moves."""
    ground = {"height_m": 3.4, "thickness_m": 0.5, "unit_weight_kn_m3": 21.0}
    ground["load"] = [{"kind": "vertical", "kn_m": 42.4, "d_m": 0.25, "h_m": 3.4, "mass": "none"}]
    brittle, ductile = ([hold] for hold in (at_top(3.4, 2.0)[0], at_top(3.4, 2.0)[0] | {"elongation_m": 0.01}))
    assert limits(**ground, hold=brittle)[TOP, "outward"].share(0.157010) < 1.0
    assert limits(**ground, hold=ductile)[TOP, "outward"].share(0.157010) > 1.0
    draw = random.Random(9)
    for _ in range(20):
        keys = {"thickness_m": draw.uniform(0.25, 0.8), "height_m": draw.uniform(2.5, 4.0)}
        load = {"kind": "vertical", "kn_m": draw.uniform(2.0, 60.0), "d_m": 0.4 * keys["thickness_m"], "mass": "none"}
        keys["load"] = [load | {"h_m": keys["height_m"]}]
        hold = at_top(keys["height_m"], draw.uniform(0.5, 40.0))[0]
        stiff, yielding = (limits(**keys, hold=[hold | more]) for more in ({}, {"elongation_m": 0.02}))
        for key, limit in stiff.items():
            assert yielding[key].push >= limit.push * (1.0 - 1e-9), key


@pytest.mark.parametrize(
    "hold",
    [
        {"kind": "floor", "h_m": 3.0},
        {"kind": "cross_walls", "spacing_m": 5.0},
        {"kind": "floor", "h_m": 3.0, "out_kn_m": 5.0, "elongation_m": 0.0},
        {"kind": "floor", "h_m": 3.0, "out_kn_m": 5.0, "elongation_m": 1e-6},
    ],
)
def test_that_an_elongation_without_a_strength_at_a_height_or_of_nothing_is_refused(hold):
    """A hurried one of nothing would take a brittle hold for one that yields."""
    with pytest.raises(InputError) as refused:
        parse_case({"wall": [HELD | {"hold": [{"elongation_m": 0.01} | hold]}]})
    assert refused.value.key == "elongation_m"


def test_that_the_base_of_a_stocky_wall_is_a_hold():
    found = limits()
    assert found[BASE, "outward"].push == pytest.approx(1.137492, rel=1e-6)
    assert found[BASE, "inward"].push == pytest.approx(1.026870, rel=1e-6)
    slender = limits(thickness_m=0.25, load=[HELD["load"][0] | {"d_m": 0.1}])
    assert BASE not in {hold for hold, _ in slender}


def test_that_no_strength_is_asked_for_that_the_demand_does_not_need():
    """Far below its start a wall at rest asks of its hold a tenth of what it does as it starts."""
    wall = parse_case({"wall": [HELD]}).wall[0].in_si
    strip = strip_of(wall)
    moving = MovingStrip(strip, lowest_hinge(strip))
    asked = reaction_of_top(Sections(wall), moving, 0.1)
    assert 0.0 < asked < 0.15 * moving.starts[0]
    assert limits(hold=at_top(3.0, 1.001e-3 * asked))[TOP, "outward"].push == pytest.approx(0.1, rel=0.02)


def test_that_a_stronger_hold_never_holds_less_and_a_larger_push_never_asks_less():
    draw = random.Random(5)
    for _ in range(25):
        keys = {"height_m": draw.uniform(2.5, 5.0), "thickness_m": draw.uniform(0.25, 0.7)}
        load = HELD["load"][0] | {"kn_m": draw.uniform(0.0, 40.0), "h_m": keys["height_m"]}
        keys["load"] = [load | {"d_m": draw.uniform(0.2, 0.8) * keys["thickness_m"]}]
        strengths = sorted(draw.uniform(0.5, 60.0) for _ in "abc")
        pushes = [
            limits(**keys, hold=at_top(keys["height_m"], strength))[TOP, "outward"].push for strength in strengths
        ]
        assert pushes == sorted(pushes)
        wall = parse_case({"wall": [HELD | keys | {"hold": at_top(keys["height_m"])}]}).wall[0].in_si
        strip = strip_of(wall)
        moving, sections = MovingStrip(strip, lowest_hinge(strip)), Sections(wall)
        alphas = [0.1 * k * float(moving.multiplier()) for k in range(1, 16)]
        asked = [reaction_of_top(sections, moving, alpha) for alpha in alphas]
        assert all(more >= less * (1.0 - 1e-6) for less, more in itertools.pairwise(asked))


SPANNING = """
[building]
height_m = 7.0
storeys = 2
period_s = 0.22
[analysis]
histories = false
[demand]
ag_g = 0.15
spectrum = { code = "NTC2018", f0 = 2.45, tc_star_s = 0.33, soil = "C", topography = "T1" }
[[wall]]
name = "w"
height_m = 3.5
thickness_m = 0.45
mechanism = "horizontal_bending"
base_z_m = 0.0
unit_weight_kn_m3 = 18.0
unloaded_confirmed = true
compressive_strength_mpa = 2.0
masonry = "solid_brick"
[[wall.hold]]
kind = "cross_walls"
evidence = { kind = "test", reference = "PT-04" }
spacing_m = 2.5
shoulder_length_m = 2.0
shoulder_thickness_m = 0.45
"""


@pytest.mark.shows("held.reaction")
def test_that_the_ends_of_an_arch_slip_where_friction_no_longer_holds_them():
    """V = alpha W/2 across each end against mu H: 0.256 of the worked arch, which starts at 0.456."""
    case = case_of_text(SPANNING, ROOT / "spanning.toml")
    masonry = case.wall[0].in_si
    strip = strip_of(masonry)
    moving = MovingStrip(strip, lowest_hinge(strip))
    limit = limit_of_ends(masonry, moving)
    assert limit.hold == ENDS and limit.push == pytest.approx(0.214765, abs=6e-7)
    still = replace(masonry, arch=masonry.arch._replace(beyond=0.0))  # the masonry beyond has no inertia
    assert limit_of_ends(still, moving).push == pytest.approx(0.256000, abs=6e-7)
    (wall,) = run(case, base_dir=ROOT).walls
    check = next(check for check in wall.assessment.checks if check.name == "hold")
    assert check.demand == pytest.approx(2.7504, rel=1e-3) and check.capacity == pytest.approx(2.0639, rel=1e-3)
    assert wall.assessment.verdict.governing == "hold" and wall.assessment.verdict.zeta_e == pytest.approx(
        0.7906, abs=1e-3
    )
    assert wall.assessment.verdict.code in ("not_verified", "q2_unsafe")
    (reaction,) = wall.assessment.reactions
    assert (reaction.hold, reaction.direction, reaction.gives_way) == (ENDS, "outward", check.zeta)
    assert reaction.at_demand == pytest.approx(2750.361, abs=1e-2) and reaction.stands == pytest.approx(
        2063.93, abs=0.1
    )
    assert reaction.at_zeta == pytest.approx(0.5 * 45.0 * 0.45 * 0.214765 * 1e3, rel=1e-3)  # W/2 alpha


def test_that_what_holds_the_ends_across_is_added_to_their_friction():
    table = SPANNING.replace("shoulder_thickness_m = 0.45", "shoulder_thickness_m = 0.45\nout_kn_m = 1.0")
    (wall,) = run(case_of_text(table, ROOT / "spanning.toml"), base_dir=ROOT).walls
    check = next(check for check in wall.assessment.checks if check.name == "hold")
    assert check.capacity == pytest.approx(3.0639, rel=1e-3) and check.passed


@pytest.mark.shows("held.reaction")
def test_that_a_wall_is_verified_to_where_its_hold_gives_way_and_no_further():
    table = {"demand": {"ag_g": 0.3, "soil_factor": 1.0}, "analysis": {"histories": False}, "building": None}
    table = {key: value for key, value in table.items() if value is not None}
    table["building"] = {"height_m": 9.0, "storeys": 3, "period_s": 0.26}
    spectrum = {"code": "NTC2018", "f0": 2.45, "tc_star_s": 0.35, "soil": "C", "topography": "T1"}
    table["demand"] = {"ag_g": 0.3, "spectrum": spectrum}
    zetas = []
    for strength in (2000.0, 10.0, 5.0, 2.0):
        case = parse_case(table | {"wall": [HELD | {"thickness_m": 0.4, "hold": at_top(3.0, strength)}]})
        (wall,) = run(case, base_dir=ROOT).walls
        zetas.append(wall.assessment.verdict.zeta_e)
        hold = next(check for check in wall.assessment.checks if check.name == "hold")
        assert hold.passed == (hold.demand <= hold.capacity) or math.isclose(hold.demand, hold.capacity, rel_tol=0.02)
        assert wall.assessment.verdict.zeta_e <= hold.zeta
        weakest, *others = wall.assessment.reactions
        assert (1e-3 * weakest.at_demand, weakest.gives_way) == (hold.demand, hold.zeta)
        assert all(other.gives_way >= weakest.gives_way for other in others)
    assert zetas == sorted(zetas, reverse=True) and zetas[-1] < zetas[0]
    bare = parse_case(table | {"wall": [HELD | {"thickness_m": 0.4, "hold": at_top(3.0)}]}).wall[0]
    assert bare.in_si.declared.strength is None


@pytest.mark.shows("held.reaction")
@pytest.mark.parametrize(
    ("first", "hold", "decides"),
    [
        ((1.2, True), (1.1, True), "hold"),
        ((1.2, True), (0.9, False), "hold"),
        ((1.2, False), (1.1, True), "nonlinear"),  # it falls at the demand itself, above which it stands
        ((0.8, False), (0.9, False), "nonlinear"),
        ((0.8, False), (0.7, False), "hold"),
        ((None, None), (1.1, True), "nonlinear"),
        ((None, None), (0.9, False), "hold"),
    ],
)
def test_that_a_hold_that_stands_never_covers_a_wall_that_falls(first, hold, decides):
    checks = [Check(name, "", "", 1.0, 1.0, *said) for name, said in (("nonlinear", first), ("hold", hold))]
    evaluation = Evaluation(None, None, None, (checks[0],))
    assert _place_hold(evaluation, checks[1])[0].name == decides


LOADED_HELD = {"name": "h", "height_m": 3.0, "thickness_m": 0.3, "base_z_m": 0.0, "unit_weight_kn_m3": 18.0}
LOADED_HELD |= {"mechanism": "vertical_bending"}
ON_TOP = {"kind": "vertical", "kn_m": 10.0, "d_m": 0.10, "h_m": 3.0, "mass": "none"}


def held_by(ag=0.3, **strengths):
    """The check of the holds of a wall held at its top, its load near the outer face, and its reactions."""
    hold = {"kind": "floor", "h_m": 3.0, "evidence": {"kind": "test", "reference": "PT-04"}} | strengths
    hold = {key: value for key, value in hold.items() if value is not None}
    demand = {"ag_g": ag, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}}
    table = {"wall": [LOADED_HELD | {"load": [ON_TOP], "hold": [hold]}], "demand": demand}
    table |= {"analysis": {"histories": False}, "building": {"height_m": 6.0, "storeys": 2}}
    (wall,) = run(parse_case(table), base_dir=ROOT).walls
    return next(check for check in wall.assessment.checks if check.name == "hold"), wall.assessment.reactions


@pytest.mark.shows("held.reaction")
def test_that_what_a_hold_stands_inward_is_compared_with_what_the_wall_presses_on_it():
    """Without it nothing is compared; a hold that is strong outward and weak inward gives way as the wall bends in."""
    bare, reactions = held_by(out_kn_m=40.0)
    strong, _ = held_by(out_kn_m=40.0, in_kn_m=40.0)
    assert strong == bare
    inward = next(one for one in reactions if (one.hold, one.direction) == (TOP, "inward"))
    half = 0.5e-3 * inward.at_demand
    weak, (first, *_) = held_by(out_kn_m=40.0, in_kn_m=half)
    assert (first.hold, first.direction, first.stands) == (TOP, "inward", pytest.approx(1e3 * half))
    assert weak.zeta < 1.0 < bare.zeta and not weak.passed and weak.capacity == pytest.approx(half)
    zetas = [held_by(out_kn_m=40.0, in_kn_m=share * half)[0].zeta for share in (0.5, 1.0, 1.5, 4.0)]
    assert zetas == sorted(zetas)
    for other in ({"kind": "contact", "h_m": None, "to_m": 3.0}, {"out_kn_m": None}):
        with pytest.raises(InputError) as refused:
            held_by(**({"out_kn_m": 40.0, "in_kn_m": 5.0} | other))
        assert refused.value.code in ("hold_inward", "hold_key")


@pytest.mark.shows("held.reaction")
def test_that_a_tie_and_an_anchor_of_one_force_at_one_height_hold_alike():
    """A slender wall between base and hold bends; its base, pressed by all of it, takes 10.8 kN/m of 25.9 as it does,
    and does not slide."""
    contact = {"kind": "contact", "to_m": 6.0, "evidence": {"kind": "survey", "reference": "tav. 4"}}
    shown = {"h_m": 6.0, "out_kn_m": 30.0, "evidence": {"kind": "test", "reference": "PT-2"}}
    wall = {"name": "w", "height_m": 6.0, "thickness_m": 0.6, "length_m": 5.0, "unit_weight_kn_m3": 18.0}
    wall |= {"base_z_m": 0.0, "unloaded_confirmed": True}
    spectrum = {"code": "NTC2018", "f0": 2.45, "tc_star_s": 0.35, "soil": "B", "topography": "T1"}
    shares = []
    for hold in ({"kind": "anchor"}, {"kind": "tie", "bar_length_m": 8.0, "elongation_m": 0.4}):
        case = parse_case(
            {
                "wall": [wall | {"hold": [contact, shown | hold]}],
                "demand": {"ag_g": 0.18, "spectrum": spectrum},
                "building": {"height_m": 6.0, "storeys": 2},
                "analysis": {"histories": False},
            }
        )
        (found,) = [one.assessment for one in run(case, base_dir=ROOT).walls if one.part.top is not None]
        assert "base" not in {row.hold for row in found.reactions} and found.verdict.code == "verified"
        shares.append(found.verdict.zeta_e)
    assert shares[0] == pytest.approx(shares[1], rel=1e-12) and shares[0] > 1.0


@pytest.mark.shows("held.reaction")
def test_that_a_base_of_less_friction_slides_earlier_and_a_stretch_above_keeps_its_own():
    pushes = [limits(base_friction=value)[BASE, "outward"].push for value in (0.4, 0.3, 0.2)]
    assert pushes[0] == limits()[BASE, "outward"].push and pushes == sorted(pushes, reverse=True)
    assert pushes[2] < 0.7 * pushes[0]
    with pytest.raises(InputError, match="base_friction"):
        limits(base_friction=0.6)
    tall = parse_case({"wall": [HELD | {"height_m": 6.0, "base_friction": 0.2, "hold": at_top(6.0, 30.0)}]}).wall[0]
    assert cut_span(tall, 3.0, 6.0).in_si.friction == 0.4 and cut_span(tall, 0.0, 3.0).in_si.friction == 0.2


SITE = {"code": "NTC2018", "f0": 2.4, "tc_star_s": 0.33, "soil": "B", "topography": "T1"}
SHOWN = {"evidence": {"kind": "calculation", "reference": "A1"}}


def found_of(wall, ag, **building):
    """The verdict of a wall by the clauses alone, and its results by name."""
    table = {"demand": {"ag_g": ag, "spectrum": SITE}, "analysis": {"histories": False}}
    table["building"] = {"height_m": 7.0, "storeys": 2, "period_s": 0.25} | building
    wall = {"name": "w", "length_m": 8.0, "unit_weight_kn_m3": 18.0, "base_z_m": 0.0} | wall
    result = run(parse_case(table | {"wall": [wall]}), base_dir=ROOT)
    (verdict,) = result.verdicts
    return result.walls[verdict.governing].assessment.verdict, result, verdict


def floor_load(height, kn_m, depth):
    return {"kind": "vertical", "kn_m": kn_m, "d_m": depth, "h_m": height, "mass": "none"}


@pytest.mark.shows("held.reaction")
def test_that_a_wall_whose_holds_stand_is_not_judged_as_if_they_were_absent():
    """Holds of 200 kN/m that no demand overcomes: it bends between them at 0.98, and does not turn about its base at
    1.06; a larger demand never raises zeta."""
    holds = [{"kind": kind, "h_m": h, "out_kn_m": 200.0} | SHOWN for kind, h in (("floor", 4.5), ("roof", 8.9))]
    wall = {"height_m": 9.0, "thickness_m": 0.6, "hold": holds, "load": [floor_load(4.5, 15.0, 0.3)]}
    zetas = []
    for ag in (0.16, 0.168, 0.173, 0.2):
        found, result, verdict = found_of(wall, ag, height_m=9.2, period_s=0.35)
        assert all(result.walls[k].part.held or result.walls[k].part.hinge >= 8.9 for k in verdict.results)
        zetas.append(found.zeta_e)
    assert zetas[2] == pytest.approx(0.98, abs=5e-3) and zetas == sorted(zetas, reverse=True)


@pytest.mark.shows("held.reaction")
def test_that_top_and_base_are_looked_at_together():
    """alpha W exceeds what both stand, 5 + 0.05 x 50.6 kN/m, at 0.849 of the demand; each alone against a partner
    without a limit says 1.13 and 1.16."""
    wall = {"mechanism": "vertical_bending", "height_m": 3.4, "thickness_m": 0.5, "base_friction": 0.05}
    wall["load"] = [floor_load(3.4, 20.0, 0.25)]
    shares = []
    for more in ({}, {"elongation_m": 0.05}):
        hold = {"kind": "roof", "h_m": 3.4, "out_kn_m": 5.0} | SHOWN | more
        found, _, _ = found_of(wall | {"hold": [hold]}, 0.25)
        shares.append(found.zeta_e)
    assert shares == pytest.approx([0.849, 0.849], abs=2e-3)
    free = {"name": "w", "mechanism": "two_sided", "height_m": 3.0, "thickness_m": 0.4, "base_friction": 0.2}
    with pytest.raises(InputError, match="base_friction"):
        parse_case({"wall": [free]})


@pytest.mark.shows("held.reaction")
def test_that_no_section_near_the_top_opens_and_is_called_a_base_that_slides():
    """3.4 x 0.6 without a load: at alpha_0 0.353 the base takes 9.7 kN/m of the 14.7 of its friction."""
    wall = {"mechanism": "vertical_bending", "height_m": 3.4, "thickness_m": 0.6, "unloaded_confirmed": True}
    hold = {"kind": "roof", "h_m": 3.4, "out_kn_m": 20.0} | SHOWN
    found, result, _ = found_of(wall | {"hold": [hold]}, 0.33, period_s=0.12)
    assert "base" not in {row.hold for row in result.walls[0].assessment.reactions}
    assert found.governing == "nonlinear" and found.zeta_e == pytest.approx(1.006, abs=2e-3)


@pytest.mark.shows("held.reaction")
def test_that_an_added_hold_or_a_weak_one_in_place_of_contact_never_worsens_a_wall():
    """A weak one gives way first and leaves the wall to the others, which hold it up to a larger push."""
    floor, roof = ({"kind": kind, "h_m": h} | SHOWN for kind, h in (("floor", 3.4), ("roof", 6.7)))
    loads = [floor_load(3.4, 12.0, 0.33), floor_load(6.7, 8.0, 0.33)]
    wall = {"height_m": 6.8, "thickness_m": 0.5, "load": loads}
    weak = {"kind": "anchor", "h_m": 5.0, "out_kn_m": 3.0} | SHOWN
    strong = [floor | {"out_kn_m": 12.0}, roof | {"out_kn_m": 12.0}]
    plain, more = (found_of(wall | {"hold": holds}, 0.2)[0] for holds in (strong, [*strong, weak]))
    assert (more.code, more.zeta_e) == (plain.code, plain.zeta_e) and plain.zeta_e > 1.1
    halves = [[floor | given, roof | {"out_kn_m": 12.0}] for given in ({}, {"out_kn_m": 0.5})]
    contact, small = (found_of(wall | {"hold": holds}, 0.2)[0] for holds in halves)
    assert small.zeta_e == contact.zeta_e


def test_that_a_stretch_keeps_what_its_holds_give_way_by():
    holds = [{"kind": "floor", "h_m": h, "out_kn_m": 20.0, "stiffness_kn_m2": 4000.0} | SHOWN for h in (3.4, 6.8)]
    wall = {"name": "w", "height_m": 6.8, "thickness_m": 0.5, "unit_weight_kn_m3": 18.0, "base_z_m": 0.0}
    for elongations in ((0.02, 0.03), (0.02, None)):
        given = [hold | ({"elongation_m": u} if u else {}) for hold, u in zip(holds, elongations, strict=True)]
        case = parse_case({"wall": [wall | {"mechanism": "one_sided", "hold": given}]})
        stretches = [stretch.wall.in_si.declared for stretch in find_held_stretches(case.wall[0])]
        assert tuple(one.elongation for one in stretches) == elongations
        assert [one.stiffness / one.strength for one in stretches] == pytest.approx([200.0, 200.0])
