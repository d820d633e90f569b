"""Hinges of a wall of several storeys: the walls above them, and the one that governs."""

import pytest

from core.case.hinges import parts
from core.case.rules import parse_case
from core.errors import InputError
from core.study.run import run
from tests.conftest import ROOT
from tests.holds import sought

WALL = {
    "name": "facade",
    "height_m": 9.0,
    "thickness_m": 0.6,
    "mechanism": "one_sided",
    "base_z_m": 0.0,
    "hold": [{"kind": "cross_walls"}],
}
BUILDING = {"height_m": 9.0, "storeys": 3, "period_s": 0.26}


def case(hinges, building=BUILDING, **wall):
    return parse_case(
        {
            "wall": [{k: v for k, v in {**WALL, "hinge_heights": hinges, **wall}.items() if v is not None}],
            **({"building": building} if building else {}),
            "record": [{"file": "tests/motions/noise_1.txt"}],
            "analysis": {"q_step": 0.02},
            "demand": {"ag_g": 0.2, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}},
        }
    )


def walls_of(asked):
    return [part.wall for part in parts(asked)]


def test_that_the_floors_are_those_between_base_and_top():
    found = [(w.name, w.base_z_m, w.height_m, w.thickness) for w in walls_of(case("floors"))]
    assert found == [("facade", 0.0, 9.0, 0.6), ("facade (+3 m)", 3.0, 6.0, 0.6), ("facade (+6 m)", 6.0, 3.0, 0.6)]
    upper = walls_of(case("floors", base_z_m=3.0, height_m=7.0))
    assert [wall.base_z_m for wall in upper] == [3.0, 6.0, 9.0]


def test_that_a_tie_that_is_designed_stands_at_its_height_above_each_hinge_below_it():
    keys = {"unit_weight_kn_m3": 18.0}
    found = walls_of(case([3.0, 6.0], **keys, hold=[*WALL["hold"], sought(5.5)]))
    assert [wall.sought and wall.sought.h_m for wall in found] == [5.5, 2.5, None]
    bar = {"bar_length_m": 8.0, "elongation_m": 0.3, "spacing_m": 1.5}
    described = walls_of(case([3.0, 6.0], **keys, hold=[*WALL["hold"], sought(5.5, **bar)]))
    assert [wall.sought and wall.sought.h_m for wall in described] == [5.5, 2.5, None]
    for tie in (wall.sought for wall in described[:2]):
        assert (tie.bar_length_m, tie.elongation_m, tie.spacing_m) == (8.0, 0.3, 1.5)


def test_that_given_heights_are_taken_in_order_and_once():
    found = walls_of(case([4.5, 1.0, 4.5], slenderness_deg=4.0, thickness_m=None))
    assert [wall.height_m for wall in found] == [9.0, 8.0, 4.5]
    assert len({wall.thickness for wall in found}) == 1


@pytest.mark.shows("verdict.hinges")
def test_that_the_part_above_a_hinge_is_the_wall_one_would_write():
    part = walls_of(case([6.0]))[1]
    alone = case(None, name="top", base_z_m=6.0, height_m=3.0).wall[0]
    assert part.block() == alone.block()
    both = run(case([6.0]), base_dir=ROOT).walls
    single = run(case(None, name="top", base_z_m=6.0, height_m=3.0), base_dir=ROOT).walls[0]
    assert both[1].runs == single.runs
    first, second = both[1].assessment.verdict, single.assessment.verdict
    assert first.limits == tuple(limit for limit in second.limits if limit.code != "no_arch")  # said of the whole wall
    assert (first.code, first.zeta_e, first.assumptions) == (second.code, second.zeta_e, second.assumptions)


@pytest.mark.shows("verdict.hinges")
def test_that_without_a_word_a_hinge_is_where_a_load_or_a_storey_is_and_three_times_t_is_above():
    """A wall of 9.0 x 0.60 m, three storeys of 3 m: above 7.2 m its top is stockier than 3."""
    roof = {"kind": "vertical", "kn_m": 8.0, "d_m": 0.4, "h_m": 8.8, "mass": "none"}
    floor = {**roof, "h_m": 4.5}
    tie = {"kind": "tie", "out_kn_m": 1.0, "h_m": 7.19, "bar_length_m": 8.0}
    changes = {"unit_weight_kn_m3": 18.0, "load": [roof, floor], "hold": [*WALL["hold"], tie], "thickness_m": 0.6}
    found = [part.hinge for part in parts(case(None, BUILDING, **changes))]
    assert found == pytest.approx([0.0, 3.0, 4.5, 6.0, 7.19])
    assert [part.hinge for part in parts(case("base", BUILDING, **changes))] == [0.0]
    assert [part.hinge for part in parts(case(None, None, **changes))] == [0.0]
    assert [part.hinge for part in parts(case("floors", BUILDING, **changes))] == pytest.approx([0, 3, 6])


@pytest.mark.parametrize(("height", "hinges"), [(0.1, [0.0, 0.1]), (0.09, [0.0])])
def test_that_a_load_ten_centimetres_above_the_base_is_the_lowest_hinge(height, hinges):
    shelf = {"kind": "vertical", "kn_m": 1.0, "d_m": 0.3, "h_m": height, "mass": "none"}
    building = {**BUILDING, "storeys": 1}
    assert [part.hinge for part in parts(case(None, building, unit_weight_kn_m3=18.0, load=[shelf]))] == hinges


@pytest.mark.parametrize(
    "hinges, building, wall, code",
    [
        ("floors", None, {}, "hinges_need_building"),
        ([8.95], BUILDING, {}, "hinge_above_wall"),
        ([0.0], BUILDING, {}, "not_accepted"),
        ([float("nan")], BUILDING, {}, "not_accepted"),
        ([], BUILDING, {}, "not_accepted"),
        ("storeys", BUILDING, {}, "not_accepted"),
        ([True], BUILDING, {}, "not_accepted"),
        (
            [1.0],
            BUILDING,
            {
                "height_m": None,
                "thickness_m": None,
                "radius_m": 4.0,
                "slenderness_deg": 5.0,
                "inertia_over_mass_m2": 21.0,
            },
            "hinges_need_rectangle",
        ),
    ],
)
def test_that_wrong_hinges_are_refused(hinges, building, wall, code):
    wall = {key: value for key, value in {**WALL, **wall}.items() if value is not None}
    with pytest.raises(InputError) as caught:
        parse_case({"wall": [{**wall, "hinge_heights": hinges}]} | ({"building": building} if building else {}))
    assert caught.value.code == code


def test_that_a_name_that_stands_twice_is_refused():
    walls = [{**WALL, "hinge_heights": [3.0]}, {**WALL, "name": "facade (+3 m)"}]
    with pytest.raises(InputError) as caught:
        parse_case({"wall": walls})
    assert caught.value.code == "same_name"


@pytest.mark.parametrize(("height", "above"), [(3.1, pytest.approx(0.1)), (3.09, None)])
def test_that_a_tie_to_be_designed_is_of_the_part_above_a_hinge_from_a_tenth_of_a_metre_on(height, above):
    found = walls_of(case([3.0], unit_weight_kn_m3=18.0, hold=[*WALL["hold"], sought(height)]))
    assert (found[1].sought and found[1].sought.h_m) == above
