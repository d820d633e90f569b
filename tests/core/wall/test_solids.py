"""The solids of a wall: sections, widths, contact and changes, by hand."""

import math

import numpy as np
import pytest

from core.wall.solids import Part, changes, contact_at, is_dragged, section_area


def box(s0, s1, z0, z1):
    return ((s0, z0), (s1, z0), (s1, z1), (s0, z1))


def elevation(polygon, outer, inner, start=0.0, weight=18e3) -> Part:
    """From x = outer to x = inner, however the plane is placed."""
    return Part(tuple(polygon), (outer - start, inner - start), 0.5 * math.pi, start, weight, "elevation")


def section(polygon, ends, start=0.0) -> Part:
    return Part(tuple((x - start, z) for x, z in polygon), ends, 0.0, start, 18e3, "section")


GABLED = ((0.0, 0.0), (6.0, 0.0), (6.0, 5.0), (3.0, 7.0), (0.0, 5.0))


def test_that_the_width_at_a_corner_is_that_just_above_it():
    for polygon in (GABLED, GABLED[::-1]):
        widths = elevation(polygon, 0.0, 0.5).widths_at(np.array([0.0, 2.5, 5.0, 6.0, 7.0]))
        assert widths.tolist() == pytest.approx([6.0, 6.0, 6.0, 3.0, 0.0], abs=1e-14)


@pytest.mark.parametrize("start", [0.0, 0.3, -0.2])
def test_that_a_section_between_two_faces_does_not_depend_on_where_a_plane_is_placed(start):
    """4 m of a wall of 0.6 m between x = 0.1 and 0.5 m, less a door of 1 m; a return wall of 0.25 m behind it."""
    wall = elevation(box(0.0, 4.0, 0.0, 6.0), 0.0, 0.6, start)
    door = elevation(box(1.0, 2.0, 0.0, 2.0), 0.0, 0.6, start, weight=-18e3)
    behind = section(box(0.6, 3.0, 0.0, 6.0), (0.0, 0.25), start)
    assert section_area((wall,), 1.0) == pytest.approx(4.0 * 0.6, rel=1e-14)
    assert section_area((wall, door), 1.0, 0.1, 0.5) == pytest.approx(3.0 * 0.4, rel=1e-13)
    assert section_area((wall, door), 2.0, 0.1, 0.5) == pytest.approx(4.0 * 0.4, rel=1e-13)
    assert section_area((wall, behind), 1.0, 0.5, 1.0) == pytest.approx(4.0 * 0.1 + 0.25 * 0.4, rel=1e-13)
    assert section_area((wall, behind), 1.0, 3.0) == 0.0


@pytest.mark.parametrize("from_y", [0.0, 2.0])
def test_that_what_reaches_behind_over_less_than_half_of_the_length_is_dragged(from_y):
    """A wall of 5 m: 2.4 m of it, wherever along it, are dragged, 2.5 m carry."""
    wall = elevation(box(0.0, 5.0, 0.0, 6.0), 0.0, 0.5)
    for length, dragged in ((0.8, True), (2.4, True), (2.5, False), (2.6, False)):
        behind = section(box(0.5, 1.5, 0.0, 6.0), (from_y, from_y + length))
        assert is_dragged(behind, (wall, behind), 0.5) == dragged, length
        assert not is_dragged(behind, (wall, behind), 1.5), length
    assert not is_dragged(wall, (wall,), 0.2)


@pytest.mark.parametrize(("high", "recess", "edge"), [(0.51, 0.2, 0.0), (0.49, 0.2, 0.2), (0.49, 0.059, 0.0)])
def test_that_a_foot_below_a_twentieth_of_the_height_is_no_edge_to_turn_about(high, recess, edge):
    """A wall of 10 m on 0.6 m, whose face recedes above its foot by more than a tenth of that, or by less."""
    foot, wall = elevation(box(0.0, 5.0, 0.0, high), 0.0, 0.6), elevation(box(0.0, 5.0, high, 10.0), recess, 0.6)
    assert contact_at((foot, wall), 0.0) == pytest.approx((edge, 0.6), abs=1e-12)


def test_that_a_top_course_shorter_by_a_joint_is_no_change_of_the_wall():
    """0.0075 m2 of 2.5 m2, 3 cm below the top, where it ends; a course shorter by 3 cm is one."""
    wall = elevation(box(0.0, 5.0, 0.0, 8.97), 0.0, 0.5)
    for left, heights in ((0.015, (9.0,)), (0.030, (8.97, 9.0))):
        course = elevation(box(left, 5.0, 8.97, 9.0), 0.0, 0.5)
        assert changes((wall, course)) == heights, left


def test_that_a_wall_changes_where_its_gable_begins():
    assert changes((elevation(GABLED, 0.0, 0.5),)) == (5.0,)
