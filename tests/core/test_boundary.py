"""The one search of a boundary: both sides of it, as close as asked, on the side that holds."""

import random

import pytest

from core.boundary import Boundary, find_boundary, narrowed, written_up


def test_that_a_bracket_is_narrowed_from_both_sides_as_closely_as_asked():
    draw = random.Random(3)
    for _ in range(200):
        limit = 10.0 ** draw.uniform(-3.0, 4.0)
        good, bad = 2.0 * limit, 0.3 * limit
        found = narrowed(lambda value: value >= limit, good, bad, 1e-6)  # noqa: B023
        assert found.good >= limit > found.bad and found.good - found.bad <= 1e-6 * found.good
        exact = narrowed(lambda value: value >= limit, good, bad)  # noqa: B023
        assert exact.good == limit or exact.good <= limit * (1.0 + 1e-15)


@pytest.mark.parametrize("rises", [True, False])
def test_that_the_nearest_boundary_is_found_wherever_the_search_starts(rises):
    draw = random.Random(4)
    for _ in range(200):
        start, limit = 10.0 ** draw.uniform(-2.0, 2.0), 10.0 ** draw.uniform(-2.0, 2.0)
        found = find_boundary(lambda value: (value >= limit) == rises, start, (1e-3, 1e3), rises, 1.5, 1e-3)  # noqa: B023
        assert (found.good >= limit) == rises and (found.bad >= limit) != rises and not found.refused
        assert abs(found.good / found.bad - 1.0) <= 1.1e-3


def test_that_what_holds_everywhere_or_nowhere_has_one_side():
    assert find_boundary(lambda value: True, 1.0, (0.1, 10.0), True, 2.0, 1e-3) == Boundary(0.1, None)
    assert find_boundary(lambda value: True, 1.0, (0.1, 10.0), False, 2.0, 1e-3) == Boundary(10.0, None)
    assert find_boundary(lambda value: False, 1.0, (0.1, 10.0), True, 2.0, 1e-3) == Boundary(None, 10.0)
    assert find_boundary(lambda value: None, 1.0, (0.1, 10.0), False, 2.0, 1e-3) == Boundary(None, 0.1)


def test_that_a_value_that_is_refused_is_told_from_one_that_fails():
    def holds(value):
        return None if value < 0.6 else value >= 0.5

    assert find_boundary(holds, 1.0, (0.1, 10.0), True, 1.25, 1e-4).refused
    assert not find_boundary(
        lambda value: None if value < 0.6 else value >= 0.8, 1.0, (0.1, 10.0), True, 1.25, 1e-4
    ).refused


def test_that_a_value_is_written_up_and_never_down():
    draw = random.Random(5)
    for _ in range(200):
        value, unit = draw.uniform(0.0, 5e4), draw.choice((0.01, 1.0, 10.0))
        written = written_up(value, unit)
        assert value <= written * (1.0 + 1e-12) + 1e-9 * unit and written < value + unit * (1.0 + 1e-9)
    assert written_up(20.0, 10.0) == 20.0 and written_up(0.0, 10.0) == 0.0
