"""Floors that are shown to hold a wall outward: the stretches between them, what each hold has for them, and the better
of being held and of turning."""

import random
from dataclasses import replace
from itertools import pairwise

import pytest

from core.case.held_stretches import find_held_stretches, find_held_ways
from core.case.held_top import mirror_inward
from core.case.hinges import count_wall_parts, make_wall_parts
from core.case.hold import Hold
from core.case.loads import Load, OwnWeight
from core.codes.outcomes import way_key
from core.codes.vertical_bending import bending, lowest_hinge
from core.errors import InputError
from core.mechanism.bending_reactions import MovingStrip
from core.mechanism.holds import FOOT, TOP, force_on_top, limits_of_bending, reaction_of_foot
from core.mechanism.rest import Reach, simple_reactions
from core.mechanism.sections import Sections
from core.setting.held_shares import share_out
from core.setting.plan import make_plan, read_inputs
from core.study.run import run
from core.study.wall_verdict import counted_walls
from core.variation.favourable_loads import favourable_weights
from core.variation.wall_evaluation import evaluate_wall, make_wall_context
from core.wall.bending import strip_of
from tests.clauses_alone import parse_case
from tests.conftest import ROOT
from tests.core.mechanism.polygon import holds_at_rest
from tests.holds import behind

SPECTRUM = {"code": "NTC2018", "f0": 2.45, "tc_star_s": 0.33, "soil": "C", "topography": "T1"}
BUILDING = {"height_m": 10.2, "storeys": 3, "period_s": 0.30}
FLOOR = {"kind": "vertical", "kn_m": 14.0, "d_m": 0.45, "mass": "none"}
FACADE = {"name": "f", "mechanism": "one_sided", "height_m": 10.2, "thickness_m": 0.65, "length_m": 12.0}
FACADE |= {"base_z_m": 0.0, "masonry": "solid_brick", "unit_weight_kn_m3": 18.0}
FACADE |= {"load": [FLOOR | {"h_m": 3.4}, FLOOR | {"h_m": 6.8}, FLOOR | {"h_m": 10.1, "kn_m": 8.0}]}
SHOWN = {"kind": "calculation", "reference": "A1"}


def anchored(*strengths, heights=(3.4, 6.8, 10.1), shown=SHOWN):
    """Floors with what they stand [kN/m], None of contact alone."""
    pairs = zip(heights, strengths, strict=True)
    return [
        {"kind": "floor", "h_m": h, "evidence": shown} | ({} if stands is None else {"out_kn_m": stands})
        for h, stands in pairs
    ]


def wall_of(hold, **keys):
    wall = FACADE | {"hold": hold} | keys
    return parse_case(
        {"building": BUILDING, "wall": [{key: value for key, value in wall.items() if value != ()}]}
    ).wall[0]


def verdict_of(hold, ag=0.12, **keys):
    demand = {"ag_g": ag, "spectrum": SPECTRUM}
    case = parse_case({"building": BUILDING, "demand": demand, "wall": [FACADE | {"hold": hold} | keys]})
    result = run(case, base_dir=ROOT)
    (verdict,) = result.verdicts
    return result, verdict, result.walls[verdict.governing].assessment.verdict


def moving(stretch):
    strip = strip_of(stretch.in_si)
    return Sections(stretch.in_si), MovingStrip(strip, lowest_hinge(strip))


@pytest.mark.shows("held.anchored")
def test_that_three_floors_make_three_stretches_and_what_each_stands_is_shared_out_whole():
    wall = wall_of(anchored(30.0, 30.0, 15.0))
    stretches = find_held_stretches(wall)
    assert [(stretch.low, stretch.high) for stretch in stretches] == [(0.0, 3.4), (3.4, 6.8), (6.8, 10.1)]
    tops = [stretch.wall.in_si.declared for stretch in stretches]
    assert tops[0].foot_strength is None and tops[2].strength == 15e3
    for lower, upper in pairwise(tops):
        assert lower.strength + upper.foot_strength == pytest.approx(30e3)
    # 10 cm of wall above the roof: 1.17 kN/m, by its lever over the last stretch
    assert tops[2].beside == pytest.approx(1170.0 * 3.35 / 3.3)
    assert tops[0].beside == 0.0


def test_that_at_rest_the_holds_take_what_simple_beams_hand_to_them():
    """Two ways: the stretches each with its own sections, and the whole wall over its holds by statics; what overhangs
    relieves the hold below, which is not counted."""
    wall = wall_of(anchored(30.0, 30.0, 15.0))
    alpha, stretches = 0.05, [stretch.wall for stretch in find_held_stretches(wall)]
    whole = simple_reactions(Sections(wall.in_si), [3.4, 6.8, 10.1], alpha)
    taken = [0.0, 0.0, 0.0]
    for n, stretch in enumerate(stretches):
        sections, strip = moving(stretch)
        taken[n] += force_on_top(sections, strip, alpha)
        if n:
            taken[n - 1] += reaction_of_foot(sections, strip, alpha)
    assert taken == pytest.approx(whole, rel=1e-3) and taken[1] > whole[1]
    assert [taken[0], taken[2]] == pytest.approx([whole[0], whole[2]], rel=1e-9)


@pytest.mark.parametrize("seed", range(3))
def test_that_no_push_the_shares_hold_is_more_than_a_wall_at_rest_can_take(seed):
    """Random walls against the polygons of what each section can carry, which know nothing of shares."""
    draw = random.Random(seed)
    looked = 0
    for _ in range(12):
        thickness = round(draw.uniform(0.35, 0.8), 2)
        storeys, height = draw.choice((2, 3)), round(draw.uniform(2.9, 3.6), 2)
        heights = [round(height * (n + 1), 2) for n in range(storeys)]
        strengths = [round(draw.uniform(2.0, 30.0), 1) for _ in heights]
        loads = [
            FLOOR
            | {"h_m": h, "kn_m": round(draw.uniform(4.0, 25.0), 1), "d_m": round(draw.uniform(0.4, 0.7) * thickness, 3)}
            | {"mass": draw.choice(("none", "horizontal"))}
            for h in heights
        ]
        over = draw.choice((0.0, 0.2))
        keys = {"height_m": heights[-1] + over, "thickness_m": thickness, "load": loads}
        try:
            wall = wall_of(anchored(*strengths, heights=heights), **keys)
        except InputError:
            continue
        stretches = [stretch.wall for stretch in find_held_stretches(wall)]
        pushes = [draw.uniform(0.1, 1.0) for _ in stretches]
        shared = share_out(stretches, pushes)
        sums = [one.in_si.declared for one in shared]
        totals = [a.strength + b.foot_strength for a, b in pairwise(sums)] + [sums[-1].strength]
        assert totals == pytest.approx([1e3 * stands for stands in strengths])
        limits = [limit for one in shared for limit in limits_of_bending(one.in_si, moving(one)[1], "outward")]
        starts = [float(moving(one)[1].multiplier()) for one in shared]
        push = 0.999 * min(*(limit.push for limit in limits), *starts)
        reaches = [Reach(h, 1e3 * stands, 1e9) for h, stands in zip(heights, strengths, strict=True)]
        assert push <= 0.0 or holds_at_rest(Sections(wall.in_si), reaches, push)
        assert {limit.hold for limit in limits} >= {TOP, FOOT}
        looked += 1
    assert looked > 5


def test_that_a_hold_is_shared_out_in_the_proportion_of_what_both_stretches_ask_for():
    stretches = [stretch.wall for stretch in find_held_stretches(wall_of(anchored(30.0, 30.0, 15.0)))]
    shared = share_out(stretches, [0.15, 0.3, 0.9])
    sides = [[one.in_si, mirror_inward(one).in_si] for one in stretches]

    def largest(n, alpha, reaction):
        strips = [(Sections(side), MovingStrip(strip_of(side), lowest_hinge(strip_of(side)))) for side in sides[n]]
        return max(reaction(*strip, alpha) for strip in strips)

    below, above = largest(1, 0.3, force_on_top), largest(2, 0.9, reaction_of_foot)
    assert shared[1].in_si.declared.strength == pytest.approx(30e3 * below / (below + above))


@pytest.mark.shows("held.anchored")
def test_that_a_stronger_hold_never_worsens_an_outcome_and_one_of_nearly_nothing_is_contact():
    _, contact, bare = verdict_of(anchored(None, None, None))
    ways = []
    for factor in (1e-4, 0.3, 1.0, 2.0):
        result, verdict, _ = verdict_of(anchored(30.0 * factor, 30.0 * factor, 15.0 * factor))
        outcomes = [result.walls[k].assessment.verdict for k in verdict.results]
        ways.append(way_key((one.code, one.zeta_e, 1.0) for one in outcomes))
        assert {result.walls[k].part.held for k in verdict.results} == {factor > 0.6}
    assert ways == sorted(ways) and ways[0] == ways[1] < ways[-1]
    assert ways[0][2] == bare.zeta_e == contact.zeta_least


def test_that_strength_has_to_be_shown_at_both_ends_of_a_stretch():
    strong, drawn = anchored(60.0, 60.0, 30.0), {"kind": "drawing", "reference": "A1"}
    _, _, outcome = verdict_of(strong, ag=0.05)
    assert outcome.code in ("verified", "verified_refined", "not_activated"), outcome.limits
    for k in range(3):
        some = [hold | ({"evidence": drawn} if n == k else {}) for n, hold in enumerate(strong)]
        stretches = find_held_stretches(wall_of(some))
        shown = [stretch.wall.held_by.shows_strength for stretch in stretches]
        assert shown == [n not in (k, k + 1) for n in range(3)]


def test_that_a_part_above_the_highest_anchor_is_looked_at_whichever_way_the_wall_is_held():
    for strength in (40.0, 1e-3):
        result, verdict, _ = verdict_of(anchored(strength, strength, heights=(3.4, 6.8)), ag=0.05)
        walls = [result.walls[k] for k in verdict.results]
        above = [wall for wall in walls if wall.part.hinge == 6.8 and wall.part.turns]
        assert [wall.mechanism for wall in above] == ["two_sided"]


@pytest.mark.parametrize(
    ("keys", "code"),
    [
        ({"load": [*FACADE["load"], {"kind": "thrust", "kn_m": -1.0, "h_m": 5.0}]}, "hold_thrust_between"),
        ({"load": [*FACADE["load"], {"kind": "thrust", "kn_m": 9.0, "h_m": 10.1}]}, "thrust_on_hold"),
        ({"thickness_m": 3.6}, "hold_not_counted"),
        (
            {"return_walls": {"number": 2, "thickness_m": 0.3, "brick_height_m": 0.1, "brick_length_m": 0.3}},
            "hold_not_counted",
        ),
        ({"mechanism": "two_sided", "load": (), "unloaded_confirmed": True}, "hold_not_counted"),
    ],
)
def test_that_a_strength_that_cannot_be_counted_is_refused_and_not_passed_over(keys, code):
    with pytest.raises(InputError) as refused:
        wall_of(anchored(30.0, 30.0, 15.0), **keys)
    assert refused.value.code == code and refused.value.key in ("out_kn_m", None)


def test_that_a_thrust_at_a_floor_is_what_its_hold_takes_first_and_a_tie_there_adds_to_it():
    wall = wall_of(anchored(30.0, 30.0, 15.0))
    push, tie = Load("thrust", 4.0, 6.8), Hold("tie", h_m=6.8, out_kn_m=10.0, bar_length_m=9.0)
    ductile = replace(tie, elongation_m=0.3)
    for pushes, ties, stands in (
        ([push], [], 26e3),
        ([], [tie], 35e3),
        ([], [ductile], 40e3),
        ([push], [ductile], 36e3),
        ([], [replace(tie, slack_mm=1.0)], 30e3),
    ):
        more = {"load": (*wall.load, *pushes), "hold": (*wall.hold, *ties)}
        stretches = find_held_stretches(replace(wall, **more))
        lower, upper = (stretch.wall.in_si.declared for stretch in stretches[1:])
        assert lower.strength + upper.foot_strength == pytest.approx(stands)


TIED = [
    {"kind": "tie", "out_kn_m": 20.0, "h_m": height, "bar_length_m": 9.0, "elongation_m": 0.3}
    for height in (3.4, 6.8, 10.0)
]


@pytest.mark.shows("held.anchored")
def test_that_ties_at_several_floors_hold_a_wall_between_them_as_far_as_the_demand_asks():
    """Weak ties give what the wall has by turning, or bending over them; strong ones every stretch of its own."""
    ways = []
    for factor in (0.02, 0.7, 1.0, 3.0):
        found = evaluated([{**tie, "out_kn_m": factor * tie["out_kn_m"]} for tie in TIED])
        ways.append(way_key((hinge.outcome, hinge.zeta, 1.0) for hinge in found.hinges))
    assert ways == sorted(set(ways))
    assert {hinge.scene.wall.name for hinge in found.hinges} == {"f [0–3.4 m]", "f [3.4–6.8 m]", "f [6.8–10 m]"}


def evaluated(ties, **keys):
    """A facade with something behind it and these ties, by the clauses alone."""
    demand = {"ag_g": 0.25, "spectrum": SPECTRUM}
    wall = FACADE | {"hold": [*behind(to_m=10.2), *ties]} | keys
    case = parse_case({"building": BUILDING, "demand": demand, "wall": [wall]})
    return evaluate_wall(make_wall_context(case, 0, ROOT, read_inputs(case, ROOT)), None)


@pytest.mark.shows("held.bars")
def test_that_a_tie_between_two_stretches_goes_on_pulling_once_it_has_yielded():
    """The weaker it is, the nearer the wall is to one that its upper tie alone holds."""
    upper = TIED[2] | {"out_kn_m": 200.0}
    (without,) = [hinge for hinge in evaluated([upper]).hinges if hinge.scene.wall.name == "f (0–10 m)"]
    zetas = [without.zeta]
    for force in (2.0, 5.0, 10.0):
        found = evaluated([TIED[1] | {"out_kn_m": force}, upper])
        names = [hinge.scene.wall.name for hinge in found.hinges]
        assert "f [0–10, ~6.8 m]" in names and "f [0–6.8, ~6.8 m]" in names
        zetas.append(found.hinges[names.index("f [0–10, ~6.8 m]")].zeta)
        brittle = {key: value for key, value in TIED[1].items() if key != "elongation_m"} | {"out_kn_m": force}
        assert evaluated([brittle, upper]).zeta < zetas[-1]
    assert zetas == sorted(set(zetas))


def test_that_a_tie_that_yields_lets_the_wall_bend_up_to_it_and_from_it():
    """Ties of 20 kN/m: over both the wall of 10 m comes to 1.010, but from 6.8 m up to 0.869 whatever they hold."""
    ties = [tie | {"h_m": height} for tie, height in zip(TIED, (3.4, 6.8, 10.0), strict=True)]
    held = find_held_ways(wall_of((*behind(to_m=10.2), *ties)))
    assert [(part.low, part.high, part.within) for part in held[-1]] == [
        (0.0, 10.0, False),
        *((low, high, True) for low, high in ((0.0, 3.4), (0.0, 6.8), (3.4, 6.8), (3.4, 10.0), (6.8, 10.0))),
    ]
    assert [len(part.wall.in_si.yielded) for part in held[-1]] == [2, 0, 1, 0, 1, 0]
    assert evaluated(ties).zeta <= 0.8686


def test_that_a_stub_that_its_own_load_hardly_crushes_is_no_part_that_rocks():
    """0.3 m of a wall of 0.45: with the setback of the whole wall 0.41 m wide, with its own 0.45 m, too stocky."""
    wall = {"height_m": 6.3, "thickness_m": 0.45, "compressive_strength_mpa": 2.0}
    ties = [TIED[0] | {"h_m": 3.0, "out_kn_m": 100.0}, TIED[2] | {"h_m": 6.0, "out_kn_m": 100.0}]
    wall |= {"load": [FLOOR | {"h_m": 3.0, "d_m": 0.2}, FLOOR | {"h_m": 6.0, "d_m": 0.2}]}
    assert evaluated([], hold=[*behind(to_m=6.3), *ties], **wall).zeta > 0.0


def test_that_of_two_holds_between_which_a_wall_cannot_bend_the_higher_one_counts_until_it_gives_way():
    for strengths, ways in (
        ((20.0, 30.0, 9.0), [[3.4, 7.5], [3.4, 6.8]]),
        ((20.0, 30.0, 0.5), [[3.4, 7.5], [3.4, 6.8]]),
        ((20.0, 30.0, 90.0), [[3.4, 7.5], [7.5]]),
    ):
        wall = wall_of(anchored(*strengths, heights=(3.4, 6.8, 7.5)))
        found = [[stretch.high for stretch in way if not stretch.inward] for way in find_held_ways(wall)]
        assert found[: len(ways)] == ways, strengths
    for strengths, lower in (((20.0, 2.0, 30.0), 3.0), ((2.0, 20.0, 30.0), 4.0)):  # else the one that holds longer
        wall = wall_of(anchored(*strengths, heights=(3.0, 4.0, 7.4)))
        assert [stretch.high for stretch in find_held_stretches(wall)] == [lower, 7.4]


def test_that_the_count_of_the_parts_of_a_wall_is_theirs():
    building = parse_case({"building": BUILDING, "wall": [FACADE | {"hold": behind()}]}).building
    for hold in (anchored(30.0, 30.0, 15.0), anchored(None, None, 15.0), anchored(9.0, None, heights=(3.4, 6.8))):
        for mechanism in ("one_sided", "both"):
            loads = {} if mechanism == "one_sided" else {"load": (), "unloaded_confirmed": True}
            wall = wall_of(hold, mechanism=mechanism, **loads)
            parts = make_wall_parts(0, wall, building)
            assert count_wall_parts(wall, building) == sum(len(part.wall.mechanisms()) for part in parts)


@pytest.mark.shows("held.anchored")
def test_that_a_wall_is_held_between_holds_only_where_something_is_behind_it():
    """Anchors and ties stop nothing inward: a wall that leans on less than its highest hold turns."""
    anchors = [hold | {"kind": "anchor"} for hold in anchored(60.0, 60.0, 60.0)]
    with pytest.raises(InputError) as refused:
        wall_of(anchors)
    assert refused.value.code == "hold_nothing_behind"
    assert find_held_stretches(wall_of([*anchors, *behind(to_m=10.2)]))
    assert find_held_stretches(wall_of([*behind(to_m=10.2), *TIED]))
    low = find_held_stretches(wall_of([*behind(to_m=3.4), *TIED]))  # ties above stop nothing and count nothing
    assert [stretch.high for stretch in low] == [3.4]


def test_that_a_stub_above_the_highest_hold_stands_or_no_hold_counts():
    """0.2 m of wall, 2.34 kN/m at 0.325 m: with a thrust at its top it falls without an earthquake."""
    wall = wall_of(anchored(30.0, 30.0, 15.0, heights=(3.4, 6.8, 10.0)), load=FACADE["load"][:2])
    assert find_held_stretches(wall)
    for size, stands in ((2.0, True), (5.0, False)):
        load = (*wall.load, Load("vertical", 30.0, 10.0, 0.3, "none"), Load("thrust", size, 10.2))
        assert bool(find_held_stretches(replace(wall, load=load))) == stands, size
    bent = (*wall.load, Load("vertical", 30.0, 10.0, 0.3, "none"), Load("thrust", 1.5, 10.2))
    last = find_held_stretches(replace(wall, load=bent))[-1].wall
    top = [load for load in last.load if load.h_m >= last.height_m]
    weight = sum(load.kn_m for load in top)
    straight = 30.0 * 0.3 + 0.2 * 0.65 * 18.0 * 0.325
    assert sum(load.kn_m * load.d_m for load in top) == pytest.approx(straight - 1.5 * 0.2) and weight > 32.0


def test_that_what_stands_above_the_highest_hold_is_moved_as_the_floor_there_is():
    """One anchored floor, a free storey above it: its inertia goes to the hold by the motion at its height."""
    demand = {"ag_g": 0.15, "spectrum": SPECTRUM}
    low = FACADE | {"height_m": 6.8, "load": FACADE["load"][:1], "hold": anchored(20.0, heights=(3.4,))}
    case = parse_case({"building": {"height_m": 6.8, "storeys": 2, "period_s": 0.25}, "demand": demand, "wall": [low]})
    inputs = read_inputs(case, ROOT)
    plan = make_plan(case, inputs)
    (held,) = (entry for entry in plan.entries if entry.part.held)
    (above,) = (entry for entry in plan.entries if entry.part.hinge == 3.4)
    ratio = above.floor.spectrum.a_z / held.kinematic.acceleration_demand
    (plain,) = find_held_stretches(case.wall[0])
    assert ratio > 1.1
    assert held.part.wall.in_si.declared.beside == pytest.approx(ratio * plain.wall.in_si.declared.beside)


def test_that_a_tie_is_shown_by_a_document_of_its_strength_alone():
    for kind, is_shown in ((None, False), ("photograph", False), ("drawing", False), ("test", True)):
        document = {} if kind is None else {"evidence": {"kind": kind, "reference": "P-4"}}
        ties = [tie | document for tie in TIED]
        stretches = find_held_stretches(wall_of([*behind(to_m=10.2), *ties]))
        assert {stretch.wall.held_by.shows_strength for stretch in stretches} == {is_shown}


def test_that_what_if_and_run_take_the_same_way():
    """Floors that only a drawing shows hold no wall that passes by turning."""
    demand = {"ag_g": 0.05, "spectrum": SPECTRUM}
    holds = anchored(60.0, 60.0, 60.0, shown={"kind": "drawing", "reference": "A1"})
    case = parse_case({"building": BUILDING, "demand": demand, "wall": [FACADE | {"hold": holds}]})
    result = run(case, base_dir=ROOT)
    found = evaluate_wall(make_wall_context(case, 0, ROOT, read_inputs(case, ROOT)))
    parts = [result.walls[k].part for k in result.verdicts[0].results]
    assert sorted(part.wall.name for part in parts) == sorted(hinge.scene.wall.name for hinge in found.hinges)
    assert counted_walls(result) == [result.walls[k] for k in sorted(result.verdicts[0].results)]


@pytest.mark.shows("held.anchored")
def test_that_anchors_and_ties_between_floors_stop_nothing_inward():
    """It bends inward from its base to its roof whatever pulls it between, as it does without: 0.344 by hand at 4.84 m
    (MECHANISMS 4); a floor in place of the anchor stops it."""
    wall = {"name": "w", "height_m": 6.4, "thickness_m": 0.5, "unit_weight_kn_m3": 18.0, "base_z_m": 0.0}
    wall |= {"mechanism": "one_sided"}
    wall |= {"load": [{"kind": "vertical", "kn_m": 15.0, "d_m": 0.25, "h_m": 6.4, "mass": "none"}]}
    shown = {"out_kn_m": 60.0, "evidence": {"kind": "test", "reference": "x"}}
    roof = {"kind": "roof", "h_m": 6.4} | shown
    for middle, inward in (
        ({"kind": "anchor"}, [(0.0, 6.4)]),
        ({"kind": "tie", "bar_length_m": 8.0}, [(0.0, 6.4)]),
        ({"kind": "floor"}, []),
    ):
        case = parse_case({"wall": [wall | {"hold": [{"h_m": 3.2} | middle | shown, roof]}]})
        way = find_held_ways(case.wall[0])[0]
        spans = [(stretch.low, stretch.high) for stretch in way if stretch.inward]
        assert spans == inward
        for stretch in way[len(way) - len(spans) :]:
            assert bending(stretch.wall.in_si).alpha0 == pytest.approx(0.344, abs=5e-4)
            assert stretch.wall.held_by.shows_strength
    band = {"kind": "contact", "from_m": 6.0, "to_m": 6.4, "evidence": {"kind": "survey"}}
    anchors = [{"kind": "anchor", "h_m": height} | shown for height in (3.2, 6.4)]
    case = parse_case({"wall": [wall | {"hold": [band, *anchors]}]})
    assert [stretch.inward for stretch in find_held_ways(case.wall[0])[0]] == [False, False, True]


@pytest.mark.shows("held.anchored")
def test_that_a_wall_held_by_floors_does_not_bend_between_cross_walls_too():
    floors = [hold for hold in anchored(30.0, 30.0, 15.0) if hold["kind"] != "contact"]
    ends = {"kind": "cross_walls", "spacing_m": 5.0, "out_kn_m": 10.0, "tie_kn_m": 40.0, "tie_bar_length_m": 10.0}
    ends |= {"tie_elongation_m": 0.05}
    shown = {"evidence": {"kind": "calculation", "reference": "z"}}
    result, verdict, _ = verdict_of([*floors, ends | shown], compressive_strength_mpa=2.4)
    assert any(wall.wall.kinematics.arches for wall in result.walls)
    assert not any(result.walls[k].wall.kinematics.arches for k in verdict.results)


@pytest.mark.shows("held.anchored")
def test_that_nobody_asks_where_the_mass_of_a_wall_s_own_upper_part_is():
    """It stands on the stretch below, and its inertia goes to the hold between; a load of a floor is asked about."""
    held = anchored(30.0, 30.0, 15.0)
    for load, asked in ((FACADE["load"], True), ((), False)):
        bare = {key: value for key, value in FACADE.items() if key != "load"}
        keys = {"load": load} if load else {"unloaded_confirmed": True}
        case = parse_case(
            {
                "wall": [bare | {"hold": held} | keys],
                "demand": {"ag_g": 0.15, "spectrum": SPECTRUM},
                "building": BUILDING,
            }
        )
        plan = make_plan(case, read_inputs(case, ROOT))
        scenes = [plan.scene(k, plan.demand) for k, entry in enumerate(plan.entries) if entry.part.held]
        rows = {row.key for scene in scenes for row in favourable_weights(scene)}
        assert any(isinstance(load, OwnWeight) for scene in scenes for load in scene.wall.load)
        assert ("mass" in rows) == asked


@pytest.mark.shows("held.anchored")
def test_that_no_stretch_is_told_as_a_wall_that_overturns_alone_where_its_hold_fails():
    """Without it the whole wall moves: its zeta stands in the register; a photograph of a strength blocks."""
    for kind, passes in (("calculation", True), ("photograph", False)):
        hold = anchored(60.0, 60.0, 30.0, shown={"kind": kind, "reference": "A1"})
        result, verdict, outcome = verdict_of(hold, ag=0.05)
        held = [result.walls[k].assessment for k in verdict.results if result.walls[k].part.held]
        assert held and all(each.verdict.lower_bound is None for each in held)
        rows = [row for each in held for row in each.verdict.assumptions if row.key == "hold"]
        assert rows and {row.words.code for row in rows} == {"restraint_of_stretch"}
        assert {row.open for row in rows} == {not passes}
        assert (outcome.code != "indicative") == passes


PHOTO = {"evidence": {"kind": "photograph", "reference": "P1"}}
LOW, ROOF = {"kind": "floor", "h_m": 3.0}, {"kind": "floor", "h_m": 6.0, "out_kn_m": 60.0, "in_kn_m": 60.0}
ALONG = {"kind": "contact", "from_m": 0.0, "to_m": 6.0}


def bends_inward(*holds):
    """zeta of a wall of 6.2 x 0.4 m whose floors bear near its outer face: 0.786 as it bends inward from base to
    roof."""
    loads = [{"kind": "vertical", "h_m": h, "mass": "none", "kn_m": 20.0, "d_m": 0.05} for h in (3.0, 6.0)]
    wall = {"height_m": 6.2, "thickness_m": 0.4, "length_m": 8.0, "load": loads, "hold": list(holds)}
    return evaluated([], **wall).zeta


@pytest.mark.shows("held.inward")
def test_that_a_floor_stops_a_wall_inward_only_where_it_is_shown_and_has_not_given_way():
    shown, tie = {"evidence": SHOWN}, TIED[0] | {"h_m": 6.0, "out_kn_m": 60.0}
    free = bends_inward(ALONG, tie)
    held = bends_inward(LOW | shown, ALONG | PHOTO | {"from_m": 5.9}, tie)
    assert held > free * 1.1  # a floor that is shown stops it
    for holds in (
        (LOW | {"h_m": 0.06} | PHOTO, ALONG, tie),  # nothing is looked at between 0.06 m and the roof
        (LOW | PHOTO, ALONG, tie),  # behind which nothing is shown
        (LOW | shown | {"out_kn_m": 2.0, "in_kn_m": 2.0}, ROOF | shown),  # it may give way inward
        (LOW | shown | {"out_kn_m": 2.0, "in_kn_m": 4.0}, TIED[0] | {"h_m": 3.0, "out_kn_m": 1.0}, ROOF | shown),
    ):
        assert bends_inward(*holds) <= free * (1.0 + 1e-9)


def test_that_a_stretch_that_ends_at_a_tie_hands_to_the_hold_at_its_foot_too():
    """Floors of 40 kN/m at 3.4 and 10.1 m, a weak tie at 6.8: [3.4, 6.8] and [3.4, 10.1] share one foot."""
    tie = TIED[1] | {"out_kn_m": 1.0}
    wall = FACADE | {"hold": [*anchored(40.0, None, 40.0), tie]}
    case = parse_case({"building": BUILDING, "demand": {"ag_g": 0.25, "spectrum": SPECTRUM}, "wall": [wall]})
    entries = make_plan(case, read_inputs(case, ROOT)).entries
    held = [entry.part for entry in entries if entry.part.gone == (6.8,) and entry.part.hinge == 3.4]
    outward = [part.wall for part in held if not part.inward]
    assert [len(wall.in_si.yielded) for wall in outward] == [1, 0]
    feet = {wall.in_si.declared.foot_strength for wall in outward}
    assert len(feet) == 1 and 0.0 < feet.pop() < 40e3


def test_that_ties_at_one_height_are_one_end_of_a_stretch_and_few_go_on_pulling():
    twice = [TIED[1] | {"out_kn_m": 1.0}, TIED[1] | {"out_kn_m": 1.0, "h_m": 6.83}]
    held = find_held_ways(wall_of((*behind(to_m=10.2), *twice, TIED[2])))
    assert [(part.low, part.high) for part in held[-1]] == [(0.0, 10.0), (0.0, 6.8), (6.8, 10.0)]
    ties = [TIED[0] | {"h_m": height, "out_kn_m": height} for height in (2.0, 4.0, 6.0, 8.0)]
    held = find_held_ways(wall_of((*behind(to_m=10.2), *ties, TIED[2] | {"out_kn_m": 90.0})))
    assert max(len(part.wall.in_si.yielded) for way in held for part in way) == 3
