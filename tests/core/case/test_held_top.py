"""What a wall held at its top refuses, each with a sentence that says what to do."""

from dataclasses import replace

import pytest

from core.case.held_top import move_top_loads
from core.case.hinges import default_hinges, hinges_of
from core.case.rules import parse_case, parse_wall
from core.case.wall_table import parse_wall_rows, text_rows
from core.errors import InputError
from tests.holds import sought
from tests.validation.circolare import case

WALL = {
    "name": "w",
    "mechanism": "vertical_bending",
    "height_m": 3.0,
    "thickness_m": 0.3,
    "unit_weight_kn_m3": 18.0,
    "base_z_m": 0.0,
}
TOP = {"kind": "vertical", "kn_m": 10.0, "d_m": 0.15, "h_m": 3.0, "mass": "none"}
ACROSS = {"number": 2, "thickness_m": 0.4, "brick_height_m": 0.2, "brick_length_m": 0.3}
REFUSED = {
    "restitution": ({"restitution": "housner"}, "bending_no_histories"),
    "velocity ratio": ({"restitution": "user", "velocity_ratio": 0.8}, "bending_no_histories"),
    "law": ({"law": "doherty"}, "bending_no_histories"),
    "hinges": ({"hinge_heights": "base"}, "bending_finds_hinge"),
    "return walls": ({"length_m": 4.0, "return_walls": ACROSS}, "bending_return_walls"),
    "tie to be designed": ({"hold": [sought(2.5)]}, "bending_tie"),
    "no weight": ({"unit_weight_kn_m3": None}, "bending_needs"),
    "stocky": ({"thickness_m": 1.2}, "bending_too_stocky"),
    "tie": ({"hold": [{"kind": "tie", "out_kn_m": 5.0, "h_m": 3.0, "bar_length_m": 8.0}]}, "bending_tie"),
    "thrust": ({"load": [{"kind": "thrust", "kn_m": 5.0, "h_m": 3.0}]}, "bending_load"),
    "carried mass": ({"load": [{"kind": "carried_mass", "kn_m": 5.0, "h_m": 3.0, "d_m": 0.1}]}, "bending_load"),
    "above": ({"load": [TOP | {"h_m": 3.5}]}, "load_outside"),
    "gable": ({"length_m": 4.0, "gable_m": 1.0}, "bending_rectangle"),
    "wedges": (
        {"length_m": 4.0, "return_wedges": {"number": 1, "thickness_m": 0.4, "length_at_top_m": 0.5}},
        "bending_rectangle",
    ),
    "general block": (
        {"height_m": None, "thickness_m": None, "slenderness_deg": 6.0, "radius_m": 1.5, "inertia_over_mass_m2": 3.0},
        "bending_needs",
    ),
}


@pytest.mark.shows("case.loads")
@pytest.mark.parametrize("what", REFUSED)
def test_that_what_does_not_go_with_a_held_top_is_refused(what):
    more, code = REFUSED[what]
    table = {key: value for key, value in {**WALL, **more}.items() if value is not None}
    for read in (parse_wall, lambda wall: parse_case({"wall": [wall]})):
        with pytest.raises(InputError) as error:
            read(table)
        assert error.value.code == code
        assert "{" not in error.value.text("en") + error.value.text("it")


def test_that_a_wall_held_at_its_top_has_no_other_hinge():
    asked = case({**WALL, "height_m": 6.0, "load": [TOP | {"h_m": 6.0}]}, building={"height_m": 9.0, "storeys": 3})
    assert not hinges_of(asked.wall[0], asked.building) and not default_hinges(asked.wall[0], asked.building)


@pytest.mark.parametrize("word", ["flessione verticale", "vertical bending"])
def test_that_a_table_of_walls_takes_it(word):
    text = f"name;mechanism;height_m;thickness_m;unit_weight_kn_m3\n;;m;m;kN/m3\nw;{word};3;0.3;18\n"
    (wall,) = parse_wall_rows(text_rows(text))
    assert wall.bends


@pytest.mark.parametrize("n", [1, 2, 3])
def test_that_the_load_that_is_refused_is_named_by_its_number(n):
    loads = [TOP, TOP, TOP]
    loads[n - 1] = {"kind": "thrust", "kn_m": 5.0, "h_m": 3.0}
    with pytest.raises(InputError) as error:
        parse_wall({**WALL, "load": loads})
    assert error.value.text("en").startswith(f'wall "w": load {n}: ')


def test_that_what_stands_on_the_top_goes_with_it_and_what_stands_below_stays():
    was = parse_wall({**WALL, "load": [TOP, TOP | {"h_m": 1.5}]})
    for height in (2.4, 3.6):
        moved = move_top_loads(was, replace(was, height_m=height))
        assert [load.h_m for load in moved.load] == [height, 1.5]
    assert move_top_loads(was, replace(was, thickness_m=0.4)).load == was.load
