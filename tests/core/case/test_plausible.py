"""Values that are seldom right are asked about, and hold nothing back."""

import pytest

from core.case.plausible import plausibility_questions
from core.case.rules import parse_case

WALL = {
    "name": "w",
    "mechanism": "two_sided",
    "height_m": 6.8,
    "thickness_m": 0.65,
    "unit_weight_kn_m3": 19.0,
    "base_z_m": 0.0,
}
LEAFED = WALL | {"mechanism": "one_sided", "hold": [{"kind": "contact", "to_m": 6.8}]}
FLOOR = {"name": "P1", "level_m": 3.4, "from_wall": "w", "from_d_m": 0.4, "span_m": 5.0, "g_kn_m2": 3.0, "mass": "none"}
BUILDING = {"height_m": 6.8, "storeys": 2}


def questions(walls, building=None):
    case = parse_case({"wall": walls} | ({"building": building} if building else {}))
    return [line.code for wall in case.wall for line in plausibility_questions(wall, case.building, case.wall)]


@pytest.mark.shows("verdict.plausible")
def test_that_an_odd_floor_load_leaf_and_a_lean_that_goes_are_asked_about():
    load = {"kind": "vertical", "kn_m": 30.0, "h_m": 6.8, "d_m": 0.3, "mass": "none"}
    assert questions([WALL | {"load": [load]}], BUILDING | {"floors": [FLOOR]}) == []
    assert questions([WALL], BUILDING | {"floors": [FLOOR | {"g_kn_m2": 30.0}]}) == ["odd_floor"]
    assert questions([WALL | {"load": [load | {"kn_m": 300.0}]}]) == ["odd_load"]
    assert questions([WALL | {"load": [load | {"d_m": 0.64}]}]) == ["odd_place"]
    assert questions([WALL | {"thickness_m": 6.5}]) == questions([WALL | {"height_m": 0.68}]) == ["odd_sizes"]
    assert questions([LEAFED | {"leaf": {"thickness_m": 0.64}}]) == ["odd_leaf"]
    assert questions([LEAFED | {"leaf": {"thickness_m": 0.32}}]) == []
    leaning = WALL | {"variant": "stato di fatto", "out_of_plumb_m": 0.05, "length_m": 4.0}
    assert questions([leaning, leaning | {"variant": "progetto", "out_of_plumb_m": 0.01}]) == ["straightened"]
    assert questions([leaning, leaning | {"variant": "progetto"}]) == []
