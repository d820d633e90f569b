"""What is done and what is left: counts, and time in proportion to cost."""

import pytest

from core.study import progress as module
from core.study.progress import Progress


class Clock:
    now = 0.0

    def __call__(self) -> float:
        return self.now


def test_that_the_time_left_goes_with_the_cost_not_with_the_count():
    """Two short runs of 1 s, one check of 10 s, one long run of 20 s: after the first three 20 s are left."""
    clock, told = Clock(), []
    costs = {"first": 1.0, "short": 1.0, "check": 10.0, "long": 20.0}
    progress = Progress(costs, lambda *state: told.append(state), clock)
    progress.known(())
    for task in costs:
        clock.now += costs[task] + (30.0 if task == "first" else 0.0)  # the compiler's
        progress.done(task)
    assert [state[:2] for state in told] == [(k, 4) for k in range(5)]
    assert [state[2] for state in told] == [None, None, pytest.approx(30.0), pytest.approx(20.0), 0.0]


def test_that_no_time_left_is_said_before_anything_tells_it():
    told = []
    progress = Progress(dict.fromkeys("abc", 1.0), lambda *state: told.append(state), Clock())
    progress.known("a")
    progress.done("b")
    assert told == [(1, 3, None), (2, 3, None)]


def test_that_what_an_earlier_start_did_tells_nothing_of_the_rest():
    """A check that the journal holds takes no time: the next one does."""
    clock, told = Clock(), []
    costs = dict.fromkeys(("run", "another", "kept", "check"), 2.0)
    progress = Progress(costs, lambda *state: told.append(state), clock)
    for task, seconds in (("run", 2.0), ("another", 2.0), ("kept", 0.0)):
        clock.now += seconds
        progress.done(task, seconds > 0.0)
    assert told[-1] == (3, 4, pytest.approx(2.0))


def test_that_a_clock_that_is_set_back_changes_no_elapsed_time(monkeypatch):
    ticks = iter([5.0, 7.5])
    monkeypatch.setattr(module.time, "monotonic", lambda: next(ticks))
    monkeypatch.setattr(module.time, "time", lambda: 0.0)
    assert module.StartTime().elapsed == 2.5
