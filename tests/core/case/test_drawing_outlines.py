"""Lines of a drawing joined to outlines: what closes, at which distance, among how many ends; what is above a line."""

import itertools
import random

import pytest

from core.case.drawing_outlines import CROWD, drop_duplicates, join_lines, parts_above
from core.wall.body import polygon_sums

JOIN = 0.5
"""Of which every half is a number of two digits: ends are exactly as far apart as they are written."""


@pytest.mark.parametrize(("open_by", "closes"), [(0.25, True), (JOIN, True), (JOIN + 1e-15, False)])
@pytest.mark.parametrize("pieces", [1, 2, 3])
def test_that_an_outline_closes_that_is_open_by_no_more_than_the_tolerance(pieces, open_by, closes):
    corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (0.0, open_by)]
    cuts = {1: (0, 4), 2: (0, 2, 4), 3: (0, 1, 3, 4)}[pieces]
    lines = [corners[first : last + 1] for first, last in itertools.pairwise(cuts)]
    closed, loose = join_lines(lines, JOIN)
    assert (len(closed), len(loose)) == ((1, 0) if closes else (0, 1))


@pytest.mark.parametrize(("across", "up"), [one for one in itertools.product((-1, 0, 1), repeat=2) if any(one)])
def test_that_two_ends_meet_in_whatever_direction_one_is_from_the_other(across, up):
    """Ends in two cells of the grid they are sought in, a little apart on either side of its lines."""
    tip = tuple(0.05 if step < 0 else 0.45 for step in (across, up))
    other = tuple(at + 0.1 * step for at, step in zip(tip, (across, up), strict=True))
    lines = [[(90.0, 10.0), tip], [other, (-90.0, -10.0)]]
    closed, loose = join_lines(lines, JOIN)
    assert closed == [] and len(loose) == 1
    assert {loose[0][0], loose[0][-1]} == {(90.0, 10.0), (-90.0, -10.0)}


def test_that_sides_drawn_in_many_pieces_close_to_one_outline():
    """In metres, where a tolerance is a thousandth: no end is near another one for being at its height."""
    side = [0.1 * k for k in range(51)]
    corners = [*((x, 0.0) for x in side), *((5.0, y) for y in side[1:])]
    corners += [*((5.0 - x, 5.0) for x in side[1:]), *((0.0, 5.0 - y) for y in side[1:])]
    closed, loose = join_lines([list(pair) for pair in itertools.pairwise(corners)], 1e-3)
    assert loose == [] and len(closed) == 1
    assert abs(polygon_sums(closed[0]).area) == pytest.approx(25.0, rel=1e-12)


@pytest.mark.parametrize(("ends", "lines"), [(CROWD, 1), (CROWD + 1, 2)])
def test_that_a_line_goes_on_among_32_ends_and_among_no_more(ends, lines):
    """Two of them meet, the others are near by."""
    assert CROWD == 32
    near = [[(-0.45, -0.45), (-50.0, -50.0 - k)] for k in range(ends - 2)]
    closed, loose = join_lines([[(90.0, 0.0), (0.25, 0.25)], [(0.25, 0.25), (90.0, 9.0)], *near], JOIN)
    whole = [line for line in loose if (90.0, 0.0) in (line[0], line[-1]) or (90.0, 9.0) in (line[0], line[-1])]
    assert closed == [] and len(whole) == lines


@pytest.mark.parametrize("open_by", [0.0, 1e-3])
def test_that_what_is_closed_stays_closed_where_others_begin_at_its_corner(open_by):
    """Also one that is open by the whole tolerance: its ends are none for lines that meet there."""
    square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, open_by)]
    beside = [(-x, -y) for x, y in square]
    closed, loose = join_lines([square, beside, [(0.0, 0.0), (-3.0, 3.0)]], 1e-3)
    assert closed == [square[:-1], beside[:-1]] and loose == [[(0.0, 0.0), (-3.0, 3.0)]]
    closed, loose = join_lines([square, [(3.0, -3.0), (0.0, 0.0)], [(0.0, 0.0), (-3.0, 3.0)]], 1e-3)
    assert closed == [square[:-1]] and len(loose) == 1 and len(loose[0]) == 3


def test_that_a_line_drawn_twice_is_open_and_one_there_and_back_has_two_corners():
    line = [(0.0, 0.0), (3.0, 0.0)]
    closed, loose = join_lines([line, list(line)], 1e-3)
    assert closed == [] and len(loose) == 1
    closed, loose = join_lines([[*line, line[0]]], 1e-3)
    assert closed == [line] and loose == []


@pytest.mark.parametrize("seed", range(20))
def test_that_lines_drawn_over_and_lines_of_no_length_change_no_outline(seed):
    """A polygon around the origin, cut into lines that are drawn up to three times in either direction, and points."""
    draw = random.Random(seed)
    corners = [
        (draw.uniform(1.0, 3.0) * x, draw.uniform(1.0, 3.0) * y) for x, y in ((1, 0), (1, 1), (0, 1), (-1, 0), (0, -1))
    ]
    lines = [list(pair) for pair in itertools.pairwise((*corners, corners[0]))]
    over = [line[:: draw.choice((1, -1))] for line in lines for _ in range(draw.randint(1, 3))]
    over += [[corner, corner] for corner in corners]
    draw.shuffle(over)
    closed, loose = join_lines(drop_duplicates(over), 1e-3)
    assert loose == [] and len(closed) == 1
    assert sorted(closed[0]) == sorted(corners)


def test_that_legs_are_told_apart_by_where_the_line_cuts_them_not_by_where_they_lead():
    """A leg that leans over a short one beside it; the short one is above y = 1 a triangle from (3.8333, 1) to
    (5.75, 1) and (5.5, 2)."""
    polygon = [(0.0, 0.0), (6.0, 0.0), (5.5, 2.0), (3.0, 0.5), (12.0, 10.0), (0.0, 10.0)]
    short, long = sorted(parts_above(polygon, 1.0), key=lambda part: polygon_sums(part).area)
    assert sorted(short) == [pytest.approx(at) for at in [(23.0 / 6.0, 1.0), (5.5, 2.0), (5.75, 1.0)]]
    # from (0, 1) to (3.4737, 1) where the leaning side is cut, up to y = 10
    assert polygon_sums(long).area == pytest.approx(0.5 * (3.0 + 9.0 / 19.0 + 12.0) * 9.0)
