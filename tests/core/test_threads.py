"""Threads: works side by side, in their order, and what ends them."""

import queue
import threading
from itertools import count

import pytest

from core.errors import Cancelled
from core.threads import TASKS_PER_THREAD, Batch, Threads


def squares(first: int, told: list):
    """A work of two batches, the second of which needs the first; told : keys as their results come"""
    found = yield Batch({k: lambda stop, k=k: k * k for k in range(first, first + 3)}, lambda key, _: told.append(key))
    nothing = yield Batch({})
    assert nothing == {}
    found = yield Batch({"sum": lambda stop: sum(found.values())})
    return first, found["sum"]


@pytest.mark.parametrize("jobs", [1, 2, 5])
def test_that_works_end_in_their_order_with_what_their_tasks_gave(jobs):
    ended, told = [], []
    Threads(jobs, lambda: False).run_works((squares(10 * n, told) for n in range(20)), ended.append)
    assert ended == [(k, k * k + (k + 1) ** 2 + (k + 2) ** 2) for k in range(0, 200, 10)]
    assert sorted(told) == sorted(10 * n + k for n in range(20) for k in range(3))


def test_that_results_are_told_from_the_calling_thread_and_a_work_without_tasks_ends():
    here, seen = threading.get_ident(), []

    def work():
        yield Batch({1: lambda stop: seen.append(threading.get_ident())}, lambda *_: seen.append(threading.get_ident()))

    def idle():
        return "idle"
        yield

    ended = []
    Threads(2, lambda: False).run_works([work(), idle()], ended.append)
    assert ended == [None, "idle"]
    assert seen[0] != here and seen[1] == here


def test_that_the_tasks_of_the_first_works_come_first_and_a_work_begins_when_threads_would_be_idle():
    """One thread: the second batch of a work is done before those works that are not begun yet."""
    begun, done = [], []

    def work(n):
        begun.append(n)
        for part in range(3):
            yield Batch({part: lambda stop, part=part: done.append((n, part))})
        return len(begun)

    ended = []
    Threads(1, lambda: False).run_works((work(n) for n in range(10)), ended.append)
    # no more works are under way than tasks are handed out
    assert all(begun_then - n <= TASKS_PER_THREAD for n, begun_then in enumerate(ended))
    assert sorted(done) == [(n, part) for n in range(10) for part in range(3)]
    assert all(done.index((n, 2)) < done.index((n + TASKS_PER_THREAD, 0)) for n in range(10 - TASKS_PER_THREAD))


@pytest.mark.parametrize("jobs", [1, 3])
def test_that_an_error_of_a_task_or_of_a_work_ends_all_and_no_thread_stays(jobs):
    before = threading.active_count()

    def work(fails):
        yield Batch({1: lambda stop: 1 // (fails != "task"), 2: lambda stop: None})
        if fails == "work":
            raise ZeroDivisionError
        return None

    for fails in ("task", "work"):
        ended = []
        with pytest.raises(ZeroDivisionError):
            Threads(jobs, lambda: False).run_works(
                [work(""), work(fails), *(work("") for _ in range(50))], ended.append
            )
        assert len(ended) < 52
    assert threading.active_count() == before


def test_that_a_cancel_is_seen_by_the_tasks_that_run():
    turns = count()

    def cancelled():
        return next(turns) > 3

    def endless(stop):
        while not stop():
            pass

    with pytest.raises(Cancelled):
        Threads(2, cancelled).run(dict.fromkeys(range(4), endless))


def test_that_an_error_where_a_work_ends_carries_nothing_of_its_results():
    """It is written to a file the user sends."""

    def fails(result):
        raise ValueError

    with pytest.raises(ValueError, match="^$") as found:
        Threads(1, lambda: False).run_works([squares(0, [])], fails)
    assert found.value.__context__ is None


def test_that_a_task_that_finds_a_queue_empty_is_not_lost():
    def empty(stop):
        raise queue.Empty

    with pytest.raises(queue.Empty):
        Threads(2, lambda: False).run({1: empty})


def test_that_works_without_tasks_can_be_cancelled():
    def idle():
        return None
        yield

    ended = []
    with pytest.raises(Cancelled):
        Threads(2, lambda: len(ended) > 2).run_works((idle() for _ in range(1000)), ended.append)
    assert len(ended) == 3
