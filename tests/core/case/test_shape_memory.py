"""A shape is judged once; what is found is said of each wall that has it."""

from dataclasses import fields, replace

import pytest

from core.case import shape_memory
from core.case.shape_memory import WITHOUT_SHAPE, check_known_shape
from core.case.solids import Solid
from core.case.wall import Wall
from core.errors import InputError

CORNERS = ((0.0, 0.0), (4.0, 0.0), (4.0, 6.0), (0.0, 6.0))
WALL = Wall(
    "a",
    "two_sided",
    height_m=6.0,
    thickness_m=0.5,
    length_m=4.0,
    unit_weight_kn_m3=18.0,
    solid=(Solid("elevation", CORNERS, 0.5),),
)


def test_that_another_wall_of_the_same_shape_is_not_judged_again(monkeypatch):
    judged = []
    monkeypatch.setattr(shape_memory, "check_shape", judged.append)
    shape_memory._found.cache_clear()
    for wall in (WALL, replace(WALL, name="b"), replace(WALL, notes="c", base_z_m=3.0)):
        check_known_shape(wall)
    assert len(judged) == 1
    check_known_shape(replace(WALL, height_m=5.0))
    assert len(judged) == 2
    shape_memory._found.cache_clear()


def test_that_an_error_that_is_known_names_the_wall_that_has_it():
    crossed = replace(WALL, solid=(replace(WALL.solid[0], polygon_m=(CORNERS[0], CORNERS[2], *CORNERS[1::2])),))
    for name in ("a", "b", "a"):
        with pytest.raises(InputError) as refused:
            check_known_shape(replace(crossed, name=name))
        assert (refused.value.code, refused.value.wall, refused.value.key) == ("polygon_crosses", name, "polygon_m")


def test_that_what_stands_beside_a_shape_are_keys_of_a_wall():
    assert set(WITHOUT_SHAPE) <= {entry.name for entry in fields(Wall)}
