"""How far a work is: parts within parts, told in hundredths, asked at every item."""

import pytest

from core.errors import Cancelled
from core.report.steps import Steps


def test_that_parts_within_parts_rise_from_nothing_to_the_whole():
    told, asked = [], []
    steps = Steps(lambda: asked.append(1), lambda done, planned: told.append((done, planned)), 200)
    steps.take(50)
    for _ in steps.each("ab", [3, 1]):
        assert list(steps.each(range(10))) == list(range(10))
    steps.take(150)
    for row in steps.each(range(1000)):
        assert row < 1000
    done = [at for at, _ in told]
    assert {planned for _, planned in told} == {200}
    assert done == sorted(set(done)) and done[0] == 0 and done[-1] == 199
    assert 37 in done and 50 in done  # three quarters of the first part, and its end
    assert len(asked) == 2 + 2 + 20 + 1000


def test_that_a_work_ends_at_the_next_item_when_it_is_cancelled():
    wanted = [True] * 3

    def check():
        if not wanted:
            raise Cancelled

    steps, seen = Steps(check), []
    steps.take(100)
    with pytest.raises(Cancelled):
        for item in steps.each(range(9)):
            seen.append(item)
            wanted.pop()
    assert seen == [0, 1, 2]


def test_that_a_part_without_items_is_passed():
    steps = Steps()
    steps.take(10)
    assert list(steps.each([])) == []
    assert list(steps.each([5], [0])) == [5]
