"""Polygons of a body: what crosses, touches and is shared, by hand."""

import math

import pytest

from core.wall.body import contains_point, crossing, edges_touch, shared_area


@pytest.mark.parametrize(
    ("corners", "edges"),
    [
        ([(0, 0), (4, 0), (4, 3), (0, 3)], None),
        ([(0, 0), (4, 3), (4, 0), (0, 3)], (1, 3)),  # a bow tie
        ([(-3, 0), (-2, 0), (-1, 0), (-1, 2), (-3, 2)], None),  # a corner along a line
        ([(0, 0), (3, 0), (1, 0), (1, 2), (0, 2)], (1, 2)),  # back along its own edge
        ([(0, 0), (0, 3), (0, 1), (2, 1), (2, 0)], (1, 2)),
        ([(0, -3), (0, -2), (0, -1), (2, -1), (2, -3)], None),
        ([(0, 0), (4, 0), (2, 2), (2, 0), (0, 2)], (1, 3)),  # a corner on another edge
        ([(0, 0), (0, 0), (4, 0), (0, 3)], (1, 2)),  # an edge without length
    ],
)
def test_that_the_edges_that_make_a_polygon_none_are_named(corners, edges):
    assert crossing(corners) == edges


@pytest.mark.parametrize("turned", [False, True])
@pytest.mark.parametrize(
    ("one", "other", "answer"),
    [
        (((0, 0), (4, 0)), ((1, -1), (1, 1)), True),  # they cross
        (((0, 0), (4, 0)), ((1, 0), (1, 2)), True),  # an end on the other one
        (((0, 0), (4, 0)), ((4, 0), (6, 3)), True),  # end to end
        (((0, 0), (4, 0)), ((3, 0), (6, 0)), True),  # one along the other
        (((0, 0), (4, 0)), ((5, 0), (6, 0)), False),  # one behind the other
        (((0, 0), (4, 0)), ((5, 0), (5, 2)), False),
        (((0, 0), (4, 0)), ((1, 1), (1, 2)), False),
        (((0, 0), (4, 4)), ((5, 5), (6, 2)), False),  # on the line beyond its end
    ],
)
def test_that_two_edges_meet_where_they_have_a_point_in_common(one, other, answer, turned):
    """Also with s and z changed over, the edges changed over, and each from its other end."""
    if turned:
        one, other = (tuple((z, s) for s, z in edge) for edge in (one, other))
    for first in (one, one[::-1]):
        for second in (other, other[::-1]):
            assert edges_touch(first, second) == edges_touch(second, first) == answer


def test_that_a_polygon_holds_its_edge_and_its_inside_alone():
    gable = [(0, 0), (6, 0), (6, 5), (3, 7), (0, 5)]
    for point in ((3, 1), (0, 2), (6, 5), (3, 7), (1.5, 6), (3, 0)):
        assert contains_point(gable, point), point
    for point in ((-1, 2), (7, 2), (1, 6.5), (3, 7.1), (-1, 5), (3, -0.1)):
        assert not contains_point(gable, point), point


@pytest.mark.parametrize("degrees", range(5, 360, 10))
@pytest.mark.parametrize("place", [(0.0, 0.0), (100.0, 0.0), (-100.0, 0.0), (0.0, 100.0), (0.0, -100.0)])
def test_that_what_two_polygons_share_is_the_same_wherever_they_are_drawn(degrees, place):
    """A square of 2 m and a rectangle of 2.4 m2 across its corner: they share 0.5 x 1.0 m, however turned."""
    cosine, sine = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))

    def drawn(s0, s1, z0, z1):
        corners = ((s0, z0), (s1, z0), (s1, z1), (s0, z1))
        return [(place[0] + s * cosine - z * sine, place[1] + s * sine + z * cosine) for s, z in corners]

    one, other = drawn(0.0, 2.0, 0.0, 2.0), drawn(1.5, 2.7, 1.0, 3.0)
    assert shared_area(one, other) == pytest.approx(0.5, rel=1e-9)
    assert shared_area(other[::-1], one) == pytest.approx(0.5, rel=1e-9)
    assert shared_area(one, drawn(2.0, 3.0, 0.0, 2.0)) == pytest.approx(0.0, abs=1e-9)
