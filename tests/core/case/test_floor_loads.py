"""What the rest of a building brings to a wall: floors that bear on it, arches that push its corner."""

import math
import tomllib
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.case.floor_loads import add_floor_loads, infer_floor_supports, isolate_wall
from core.case.hinges import count_wall_parts, make_wall_parts
from core.case.reader import read_case
from core.case.rules import parse_case, replace_walls
from core.case.site import FloorLoad
from core.case.wall import Wall
from core.case.writer import dumps
from core.codes.kinematic_chain import sum_chain
from core.errors import InputError
from core.study.run import run
from core.study.sweep import SweepKey, set_swept_value
from tests.holds import between

NORTH = {"name": "north", "mechanism": "one_sided", "height_m": 7.0, "thickness_m": 0.5, "length_m": 8.0}
NORTH |= {"unit_weight_kn_m3": 18.0, "base_z_m": 0.0, "hold": [{"kind": "contact"}]}
SOUTH = NORTH | {"name": "south", "thickness_m": 0.6}
FIRST = {"name": "first", "level_m": 3.5, "span_m": 5.0, "g_kn_m2": 4.0, "q_kn_m2": 2.0, "psi_2": 0.3, "mass": "none"}
FIRST |= {"from_wall": "north", "from_d_m": 0.35, "to_wall": "south", "to_d_m": 0.4}
ROOF = {"name": "roof", "level_m": 7.0, "span_m": 5.0, "g_kn_m2": 1.5, "mass": "horizontal"}
ROOF |= {"from_wall": "south", "from_d_m": 0.3}
BUILDING = {"height_m": 7.0, "storeys": 2, "period_s": 0.25, "floors": [FIRST, ROOF]}
BARE = {key: value for key, value in BUILDING.items() if key != "floors"}
DEMAND = {"ag_g": 0.15, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}}


def case_of(*walls, building=BUILDING, **changes):
    return parse_case({"wall": list(walls or (NORTH, SOUTH)), "building": building, **changes})


@pytest.mark.shows("bodies.floors")
def test_that_each_wall_bears_half_of_the_span_as_if_the_loads_were_written_on_it():
    case = case_of(demand=DEMAND)
    half = {"kind": "vertical", "g_kn_m": 10.0, "q_kn_m": 5.0, "psi_2": 0.3, "h_m": 3.5, "mass": "none"}
    roof = {"kind": "vertical", "g_kn_m": 3.75, "h_m": 7.0, "d_m": 0.3, "mass": "horizontal"}
    north, south = NORTH | {"load": [half | {"d_m": 0.35}]}, SOUTH | {"load": [half | {"d_m": 0.4}, roof]}
    written = case_of(north, south, building=BARE, demand=DEMAND)
    for k in (0, 1):
        made, asked = (make_wall_parts(k, one.wall[k], one.building) for one in (case, written))
        assert [part.wall for part in made] == [part.wall for part in asked]
        assert len(made) == count_wall_parts(case.wall[k], case.building)
    one, other = (run(clauses_alone_of(each), base_dir=Path()) for each in (case, written))
    assert [w.required_assessment.verdict.zeta_e for w in one.walls] == [
        w.required_assessment.verdict.zeta_e for w in other.walls
    ]


def clauses_alone_of(case):
    return replace(case, analysis=replace(case.analysis, histories="none"))


def test_that_floors_bear_where_a_slider_moved_them():
    """What if, Take it: the loads of floors follow the thickness, and the case kept where they bore before."""
    own = {"kind": "thrust", "kn_m": 0.1, "h_m": 3.0}
    case = case_of(NORTH, SOUTH | {"load": [own]})
    wall = case.wall[1]
    loaded = add_floor_loads(wall, case.building)
    moved = replace(loaded, load=tuple(replace(load, d_m=load.d_m and load.d_m + 0.05) for load in loaded.load))
    building = infer_floor_supports(case.building, wall, moved)
    assert add_floor_loads(wall, building).load == moved.load
    assert add_floor_loads(case.wall[0], building) == add_floor_loads(case.wall[0], case.building)
    assert infer_floor_supports(None, wall, moved) is None


@pytest.mark.parametrize(
    ("floors", "code"),
    [
        ([FIRST, FIRST], "floor_twice"),
        ([FIRST, ROOF, FIRST | {"name": "once more"}], "floor_twice"),
        ([FIRST | {"to_wall": "north"}], "floor_on_itself"),
    ],
)
def test_that_a_floor_does_not_bear_twice(floors, code):
    """A row pasted twice doubled what holds the wall."""
    with pytest.raises(InputError) as refused:
        case_of(building=BUILDING | {"floors": floors})
    assert refused.value.code == code


@pytest.mark.parametrize("name", ["north", "nowhere"])
def test_that_floors_bear_on_walls_of_a_table(name, tmp_path):
    heads = "name;height_m [m];thickness_m [m];length_m [m];unit_weight_kn_m3 [kN/m3];base_z_m [m];mechanism"
    plan = "plan_x1_m [m];plan_y1_m [m];plan_x2_m [m];plan_y2_m [m]"
    (tmp_path / "walls.csv").write_text(f"{heads};{plan}\n{name};7;0.5;8;18;0;one_sided;0;0;8;0\n")
    floors = "\n".join(f"{key} = {value!r}" for key, value in FIRST.items() if not key.startswith("to_"))
    building = "[building]\nheight_m = 7.0\nstoreys = 2\n[[building.floors]]\n" + floors.replace("'", '"')
    (tmp_path / "case.toml").write_text('walls = "walls.csv"\n' + building)
    if name == "nowhere":
        with pytest.raises(InputError) as refused:
            read_case(tmp_path / "case.toml")
        assert refused.value.code == "wall_not_there"
        return
    case = read_case(tmp_path / "case.toml")
    (load,) = make_wall_parts(0, case.wall[0], case.building)[0].wall.load
    assert load.kn_m == pytest.approx(2.5 * (4.0 + 0.6)) and case.wall[0].plan.length == 8.0


def test_that_a_floor_that_weighs_nothing_changes_no_number():
    light = FIRST | {"g_kn_m2": 1e-9, "q_kn_m2": 0.0}
    with_floor, without = case_of(building=BUILDING | {"floors": [light]}), case_of(building=BARE)
    one, other = (make_wall_parts(0, case.wall[0], case.building)[0].wall for case in (with_floor, without))
    assert sum_chain(one.in_si, False).start[0] == pytest.approx(sum_chain(other.in_si, False).start[0], rel=1e-9)


def test_that_a_case_with_floors_is_written_as_it_is_read():
    case = case_of()
    assert parse_case(tomllib.loads(dumps(case))) == case


@pytest.mark.parametrize(
    ("change", "code"),
    [
        ({"from_wall": "nord"}, "wall_not_there"),
        ({"level_m": 7.5}, "floor_off_wall"),
        ({"from_d_m": 0.51}, "floor_off_face"),
        ({"to_d_m": 0.61}, "floor_off_face"),
        ({"to_d_m": None}, "floor_to"),
        ({"to_wall": None}, "floor_to"),
        ({"psi_2": None}, "combined_share"),
        ({"span_m": None}, "missing"),
    ],
)
def test_that_a_floor_that_bears_nowhere_is_refused(change, code):
    floor = {key: value for key, value in {**FIRST, **change}.items() if value is not None}
    with pytest.raises(InputError) as refused:
        case_of(building=BUILDING | {"floors": [floor]})
    assert refused.value.code == code
    assert "first" in str(refused.value) or code == "missing"


CORNER = NORTH | {"name": "NE", "thickness_m": 0.6, "length_m": round(4.8 / math.sqrt(2.0), 3)}
CORNER |= {"corner": {"length_1_m": 2.4, "length_2_m": 2.4, "thickness_2_m": 0.6}, "height_m": 6.0}
ARCH = {"spacing": 5.0, "shoulder_length_m": 0.6, "shoulder_thickness_m": 0.4, "corner_wall": "NE"}
ARCH |= {"corner_side": 2}
SPANS = NORTH | {"name": "spans", "hold": between(**ARCH), "compressive_strength_mpa": 2.0}


def multiplier_of(corner: dict, length: float, **keys) -> float:
    """alpha_0 of a corner that is pushed, about its base."""
    table = CORNER | {"corner": corner, "length_m": length, "hinge_heights": "base"} | keys
    wall = case_of(table, building=BARE).wall[0]
    return sum_chain(make_wall_parts(0, wall, None)[0].wall.in_si, False).start[0]


@pytest.mark.shows("bodies.corner")
def test_that_a_corner_is_pushed_by_what_spans_to_it_over_its_height():
    """alpha_0 by moments about the base: what pushes it acts in the middle of the height, along its wall and across
    it."""
    rng = np.random.default_rng(4)
    for _ in range(20):
        pushes, angle = rng.uniform(0.0, 0.3, 4), rng.uniform(30.0, 60.0)
        keys = ("thrust_1_kn_m", "across_1_kn_m", "thrust_2_kn_m", "across_2_kn_m")
        corner = CORNER["corner"] | {"angle_deg": angle} | dict(zip(keys, map(float, pushes), strict=True))
        length = 2.4 * (math.sin(math.radians(angle)) + math.cos(math.radians(angle)))
        body = case_of(CORNER | {"corner": corner, "length_m": length}, building=BARE).wall[0].in_si.body
        first = np.array([math.cos(math.radians(angle)), math.sin(math.radians(angle))])  # along it and across it
        moment = 1e3 * (pushes[:2] @ first + pushes[2:] @ first[::-1]) * 6.0 * 3.0
        x, z = body.centroid
        weight = 9.80665 * body.mass
        assert multiplier_of(corner, length) == pytest.approx((weight * x - moment) / (weight * z), rel=1e-9)


NARROW = {"length_1_m": 3.0, "length_2_m": 3.0, "thickness_2_m": 0.5, "angle_deg": 15.0}
"""A corner of 6 m, 0.5 m thick, that turns nearly along its first wall."""


@pytest.mark.parametrize(
    ("push", "found"),
    [({}, 0.205153), ({"thrust_1_kn_m": 6.606471}, 0.002838), ({"thrust_2_kn_m": 6.606471}, 0.150943)],
)
def test_that_it_matters_which_wall_of_a_corner_pushes(push, found):
    """Computed twice, by formula and by quadrature."""
    length = 3.0 * math.sqrt(1.5)
    assert multiplier_of(NARROW | push, length, thickness_m=0.5) == pytest.approx(found, abs=6e-7)


@pytest.mark.parametrize(("walls", "found"), [((1,), 0.136989), ((2,), 0.096983), ((1, 2), 0.078514)])
def test_a_corner_beside_walls_that_span_and_are_at_rest(walls, found):
    """Under alpha along the motion each wall of 5 m, 45 kN and b = 0.495596 m is pushed across by its share of alpha,
    and hands on H = alpha W L/(8 b) along and alpha W/2 across it: the multiplier is the alpha that gives itself."""
    share = {1: math.sin(math.radians(15.0)), 2: math.cos(math.radians(15.0))}
    push = {}
    for side in walls:
        push[f"thrust_{side}_kn_m"] = found * share[side] * 45.0 * 5.0 / (8.0 * 0.495596)
        push[f"across_{side}_kn_m"] = 0.5 * found * share[side] * 45.0
    assert multiplier_of(NARROW | push, 3.0 * math.sqrt(1.5), thickness_m=0.5) == pytest.approx(found, abs=2e-6)


def needed(*walls, corner=None) -> dict[str, float]:
    """What a corner must be checked with for these walls, as the refusals say."""
    found: dict[str, float] = {}
    for _ in range(5):
        try:
            case_of(*walls, CORNER | {"corner": CORNER["corner"] | (corner or {}) | found}, building=BARE)
        except InputError as refused:
            assert refused.code == "corner_thrust"
            said = refused.values
            found |= {said["one"]: said["thrust"], said["other"]: said["across"]}
        else:
            return found
    raise AssertionError(found)


def test_that_what_the_ends_push_with_is_in_the_verdict_of_the_corner():
    """Along the wall they go on from, and across it what holds them: 0.4 of their thrust and what is said to."""
    found = needed(SPANS)
    assert set(found) == {"thrust_2_kn_m", "across_2_kn_m"}
    assert found["across_2_kn_m"] == pytest.approx(0.4 * found["thrust_2_kn_m"])
    more = needed(SPANS | {"hold": between(**(ARCH | {"out_kn_m": 0.2}))})
    assert more["across_2_kn_m"] == pytest.approx(found["across_2_kn_m"] + 0.2)
    other = needed(SPANS | {"hold": between(**(ARCH | {"corner_side": 1}))}, corner=found)
    assert sorted(other.values()) == pytest.approx(sorted(found.values())) and "thrust_1_kn_m" in other
    with pytest.raises(InputError) as refused:
        case_of(SPANS, CORNER | {"name": "SE"}, building=BARE)
    assert refused.value.code == "corner_not_there"


@pytest.mark.parametrize("missing", ["corner_side", "corner_wall"])
def test_that_a_wall_that_spans_to_a_corner_says_which_of_its_walls_it_goes_on_from(missing):
    arch = {key: value for key, value in ARCH.items() if key != missing}
    with pytest.raises(InputError) as refused:
        case_of(SPANS | {"hold": between(**arch)}, CORNER, building=BARE)
    assert refused.value.code == "arch_pair" and "corner_side" in str(refused.value)


def test_that_a_corner_that_does_not_stand_the_thrust_says_so():
    wide = ARCH | {"shoulder_length_m": 2.4, "shoulder_thickness_m": 0.6}
    corner = CORNER | {"corner": CORNER["corner"] | {"thrust_2_kn_m": 50.0}}
    with pytest.raises(InputError) as refused:
        case_of(SPANS | {"hold": between(**wide)}, corner, building=BARE)
    assert refused.value.code == "corner_pushed_over"


def test_that_a_tie_along_the_wall_takes_what_a_corner_then_does_not_but_no_thrust_of_the_masonry_beyond():
    """Before the ends have parted, and after the tie breaks, the masonry beyond carries the arch."""
    alone = {key: value for key, value in ARCH.items() if not key.startswith("shoulder")}
    tie = {"tie_kn_m": 40.0, "tie_bar_length_m": 5.0, "tie_elongation_m": 0.1}
    assert not needed(SPANS | {"hold": between(**(alone | tie))})
    assert not needed(SPANS | {"hold": between(**(alone | tie | {"tie_kn_m": 3000.0}))})  # hinges are crushed
    assert needed(SPANS | {"hold": between(**(ARCH | tie))}) == pytest.approx(needed(SPANS))


def test_that_two_walls_that_span_to_a_corner_both_push_it_in_every_variant():
    other, one = SPANS | {"name": "other"}, needed(SPANS)
    assert needed(SPANS, other) == pytest.approx({key: 2.0 * value for key, value in one.items()})
    apart = needed(SPANS, other | {"hold": between(**(ARCH | {"corner_side": 1}))})
    assert apart == pytest.approx(one | {key.replace("2", "1"): value for key, value in one.items()})
    pushed = {"corner": CORNER["corner"] | one}
    variants = [CORNER | {"variant": "stato di fatto"}, CORNER | pushed | {"variant": "progetto"}]
    for before, after in (variants, variants[::-1]):
        with pytest.raises(InputError) as refused:
            case_of(SPANS, before, after, building=BARE)
        assert refused.value.code == "corner_thrust"


ON_TOP = {"name": "roof", "level_m": 6.0, "span_m": 6.0, "g_kn_m2": 2.0, "mass": "none"}


@pytest.mark.parametrize(
    ("wall", "floor", "load"),
    [
        (
            NORTH | {"height_m": 6.0, "hinge_heights": "base", "steps": [{"from_z_m": 3.0, "thickness_m": 0.3}]},
            ON_TOP | {"from_d_m": 0.5},
            {"kn_m": 6.0, "d_m": 0.5, "h_m": 6.0},
        ),
        (
            {key: value for key, value in NORTH.items() if key != "unit_weight_kn_m3"} | {"height_m": 6.0},
            ON_TOP | {"from_d_m": 0.3},
            {"kn_m": 6.0, "d_m": 0.3, "h_m": 6.0},
        ),
    ],
    ids=["body", "weight"],
)
def test_that_a_floor_is_refused_where_its_load_written_by_hand_is(wall, floor, load):
    with pytest.raises(InputError) as by_hand:
        case_of(wall | {"load": [{"kind": "vertical", "mass": "none", **load}]}, building=BARE)
    with pytest.raises(InputError) as of_floor:
        case_of(wall, building=BUILDING | {"floors": [floor | {"from_wall": wall["name"]}]})
    codes = by_hand.value.code, of_floor.value.code
    assert codes[0] == codes[1] or codes == ("loads_need_weight", "floor_needs")
    assert "load 1" not in str(of_floor.value)


def test_that_a_floor_on_a_wall_that_says_it_bears_nothing_is_refused():
    with pytest.raises(InputError) as refused:
        case_of(NORTH | {"unloaded_confirmed": True}, SOUTH)
    assert refused.value.code == "floor_on_unloaded"


def test_that_one_wall_alone_has_its_floors_as_its_own_loads():
    """For sensitivities and sweeps: the other walls of its floors are not there."""
    case = case_of(demand=DEMAND)
    for k in (0, 1):
        alone = isolate_wall(case, k)
        assert not alone.building.floors and alone.wall == (make_wall_parts(k, case.wall[k], case.building)[0].body,)
        replace_walls(alone, list(alone.wall))
        assert [part.wall for part in make_wall_parts(0, alone.wall[0], alone.building)] == [
            part.wall for part in make_wall_parts(k, case.wall[k], case.building)
        ]
    swept = set_swept_value(case, 0, SweepKey(Wall, "thickness_m", None), 0.7)
    assert swept.wall[0].thickness == 0.7 and len(swept.wall[0].load) == 1


def test_that_what_was_accepted_is_looked_at_again_where_a_floor_comes_to_bear_on_it():
    kept = {}
    wall = NORTH | {"hinge_heights": "base", "hinge_setback_m": 0.1}
    case = replace_walls(case_of(wall, building=BARE), list((bare := case_of(wall, building=BARE)).wall), kept)
    heavy = FloorLoad("roof", 7.0, "north", 0.0, 40.0, 100.0, "none")
    with pytest.raises(InputError) as refused:
        replace_walls(replace(case, building=replace(bare.building, floors=(heavy,))), list(bare.wall), kept)
    assert refused.value.code == "unstable_under_loads"
