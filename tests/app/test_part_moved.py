"""The drawing of an answer shows the part that decides as it moves."""

import pytest

from app.look.drawing import SHOWN_TURNED, part_moved
from core.case.hinges import make_wall_parts
from core.case.rules import parse_case
from core.errors import InputError
from tests.core.variation.random_walls import random_tables

WALL = {"name": "w", "mechanism": "one_sided", "height_m": 6.0, "thickness_m": 0.5, "unit_weight_kn_m3": 18.0}
WALL |= {"base_z_m": 0.0, "unloaded_confirmed": True, "hinge_heights": [3.0]}
WALL |= {"hold": [{"kind": "contact", "to_m": 6.0}]}
DEMAND = {"ag_g": 0.1, "spectrum": {"code": "EN1998", "soil": "B", "type": 1}}


def parts(table):
    case = parse_case(table)
    return make_wall_parts(0, case.wall[0], case.building)


def test_that_a_part_turns_outward_about_its_hinge():
    pytest.importorskip("PySide6.QtWidgets", exc_type=ImportError)
    (upper,) = (part for part in parts({"wall": [WALL], "demand": DEMAND}) if part.hinge == 3.0)
    (corners,) = part_moved(upper)
    hinge = min(corners, key=lambda point: point.y())
    assert (hinge.x(), hinge.y()) == pytest.approx((0.25, 3.0))
    assert max(point.x() for point in corners) == pytest.approx(0.25 + 3.0 * SHOWN_TURNED, abs=0.01)


def test_that_the_outline_of_every_random_part_lies_above_its_foot_and_is_as_high():
    pytest.importorskip("PySide6.QtWidgets", exc_type=ImportError)
    drawn = 0
    for table in random_tables(60, histories=False):
        try:
            found = parts(table)
        except InputError:
            continue
        for part in found:
            points = [point for block in part_moved(part) for point in block]
            if points:
                low, high = min(point.y() for point in points), max(point.y() for point in points)
                height = part.wall.height_m
                assert low == pytest.approx(part.hinge, abs=0.05) and high - low == pytest.approx(height, rel=0.1)
                drawn += 1
    assert drawn > 40
