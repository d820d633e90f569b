"""The outline around a point of a drawing of lines, against shapely."""

import math

import numpy as np
import pytest

from core.case.outline_inside import find_enclosing_outline
from core.errors import InputError

shapely = pytest.importorskip("shapely", reason="no wheel of shapely")

from shapely.geometry import LineString, Point, Polygon  # noqa: E402
from shapely.ops import polygonize, unary_union  # noqa: E402

CLOSE, SAME = 0.02, 1e-3


def found(lines, point):
    return find_enclosing_outline([("L", line) for line in lines], point, CLOSE, SAME)


@pytest.mark.parametrize("seed", range(40))
def test_that_a_face_of_random_lines_is_that_of_shapely(seed):
    rng = np.random.default_rng(seed)
    lines = [[tuple(map(float, p)) for p in rng.uniform(0.0, 10.0, (2, 2))] for _ in range(14)]
    lines += [[(float(x), float(y)), (float(x) + 0.7, float(y)), (float(x), float(y) + 0.5), (float(x), float(y))]
              for x, y in rng.uniform(1.0, 9.0, (3, 2))]  # fmt: skip
    faces = list(polygonize(unary_union([LineString(line) for line in lines])))
    checked = 0
    for point in rng.uniform(0.0, 10.0, (30, 2)):
        inside = [face for face in faces if face.contains(Point(*point))]
        if inside and min(inside[0].boundary.distance(Point(*point)), inside[0].area) < 0.1:
            continue
        if not inside:
            if all(LineString(line).distance(Point(*point)) > 0.1 for line in lines) and not _may_close(lines):
                with pytest.raises(InputError):
                    found(lines, tuple(point))
            continue
        if _may_close(lines):
            continue
        checked += 1
        own = found(lines, tuple(map(float, point)))
        assert Polygon(own.outline, own.holes).area == pytest.approx(inside[0].area, rel=1e-3)
    assert checked >= 0


def _may_close(lines) -> bool:
    """Whether a loose end is so near to a line that it is joined to it."""
    shapes = [LineString(line) for line in lines]
    return any(
        0.0 < shapes[n].distance(Point(line[end])) < 1.5 * CLOSE
        for k, line in enumerate(lines)
        for end in (0, -1)
        for n in range(len(lines))
        if n != k
    )


FACADE = [
    [(0.0, 0.0), (9.0, 0.005)],  # the ground, open by 5 mm at the right
    [(9.0, -1.0), (9.0, 8.0), (4.5, 11.0), (-0.5, 7.6666666)],
    [(0.0, -1.0), (0.0, 7.99)],  # ends 10 mm below the roof
    [(3.0, 2.0), (4.0, 2.0), (4.0, 4.0), (3.0, 4.0), (3.0, 2.0)],  # a window
    [(3.1, 2.1), (3.9, 2.1), (3.9, 3.9), (3.1, 3.9), (3.1, 2.1)],  # and its frame
    [(6.0, 3.0), (7.0, 3.0)],  # a line that leads nowhere
    [(4.0, 3.0), (5.0, 3.0), (5.0, 3.5), (4.5, 3.5), (4.5, 3.0)],  # one that leads to something
]


def test_that_a_facade_of_lines_with_gaps_is_found_with_its_windows_and_its_gaps():
    own = found(FACADE, (8.0, 5.0))
    whole = 9.0 * 8.0 + 0.5 * 9.0 * 3.0
    assert Polygon(own.outline).area == pytest.approx(whole, rel=2e-3)
    assert sorted(Polygon(hole).area for hole in own.holes) == pytest.approx([2.25], abs=0.02)
    assert own.closed and all(0.0 < gap.size <= CLOSE for gap in own.closed)
    assert Polygon(found(FACADE, (3.5, 3.0)).outline).area == pytest.approx(0.8 * 1.8, rel=1e-3)
    with pytest.raises(InputError) as refused:
        found(FACADE, (20.0, 5.0))
    assert refused.value.code == "drawing_not_enclosed"


def test_that_a_gap_wider_than_it_may_be_leaves_no_outline():
    lines = [[(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0), (0.0, 0.05)]]
    with pytest.raises(InputError):
        found(lines, (1.0, 1.0))
    assert math.isclose(Polygon(found([[*lines[0][:-1], (0.0, 0.015)]], (1.0, 1.0)).outline).area, 12.0, rel_tol=1e-3)


def closed_room(left: float, bottom: float) -> list:
    """A room of 2 m by 3 m in two lines, open by 12 mm at its lower left corner and at its upper right one."""
    right, top = left + 2.0, bottom + 3.0
    return [
        [(left, bottom), (right, bottom), (right, top - 0.012)],
        [(right, top), (left, top), (left, bottom + 0.012)],
    ]


@pytest.mark.parametrize("room", [(20.0, 50.0), (50.0, 20.0)])
def test_that_the_gaps_of_an_outline_are_its_own_each_once(room):
    """Neither those of rooms beside it, nor of those above and below."""
    left, bottom = room
    around_it = [(left + 5.0, bottom), (left - 5.0, bottom), (left, bottom + 5.0), (left, bottom - 5.0)]
    lines = [line for corner in (room, *around_it) for line in closed_room(*corner)]
    own = found(lines, (left + 1.0, bottom + 1.0))
    assert Polygon(own.outline).area == pytest.approx(6.0, rel=1e-3)
    assert [gap.size for gap in own.closed] == pytest.approx([0.012, 0.012])
    for gap, corner in zip(
        sorted(own.closed, key=lambda gap: gap.at[0]), (room, (left + 2.0, bottom + 3.0)), strict=True
    ):
        assert math.dist(gap.at, corner) <= 0.012 + 1e-9


@pytest.mark.parametrize(
    "bottom",
    [
        [[(0.0, 0.0), (2.0, 0.0), (4.0, 0.0), (10.0, 0.0)]],
        [[(0.0, 0.0), (6.0, 0.0)], [(10.0, 0.0), (4.0, 0.0)]],
        [[(0.0, 0.0), (10.0, 0.0)], [(3.0, 0.0), (7.0, 0.0)]],
    ],
    ids=["corners on a straight side", "lines that overlap", "a line on another one"],
)
def test_that_a_straight_side_may_be_drawn_in_parts(bottom):
    own = found([*bottom, [(10.0, 0.0), (10.0, 3.0), (0.0, 3.0), (0.0, 0.0)]], (5.0, 1.0))
    assert Polygon(own.outline).area == pytest.approx(30.0, rel=1e-12) and own.closed == () and own.holes == ()
    drawn = {corner for line in bottom for corner in line} | {(10.0, 0.0), (10.0, 3.0), (0.0, 3.0)}
    assert set(own.outline) == drawn
