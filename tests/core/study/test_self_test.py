"""The numbers by which machine code of another machine shows that it is right."""

import math

import pytest

from core.errors import InputError
from core.study import self_test


@pytest.fixture
def trial(monkeypatch):
    """Ends of trials, as the cache is told of them."""
    ends = []
    monkeypatch.setattr(self_test.cache, "on_trial", lambda: not ends)
    monkeypatch.setattr(self_test.cache, "end_trial", ends.append)
    return ends


def test_that_the_numbers_are_the_same_each_time_and_of_walls_that_overturn():
    numbers = self_test.numbers()
    assert numbers == self_test.numbers()
    values = [float.fromhex(number) for number in numbers]
    assert len(values) > 20 and len(set(values)) > 20 and values[1] > 0.5
    assert not math.isnan(values[0])


def test_that_right_numbers_end_the_trial(trial, monkeypatch):
    monkeypatch.setattr(self_test, "build", lambda: {"self_test": self_test.numbers()})
    self_test.try_machine_code()
    assert trial == [True]
    monkeypatch.setattr(self_test, "numbers", lambda: pytest.fail("there is no trial any more"))
    self_test.try_machine_code()


def test_that_a_last_digit_ends_the_program(trial, monkeypatch):
    right = self_test.numbers()
    wrong = [*right[:-1], math.nextafter(float.fromhex(right[-1]), 9.9).hex()]
    monkeypatch.setattr(self_test, "build", lambda: {"self_test": wrong})
    with pytest.raises(InputError, match="machine code"):
        self_test.try_machine_code()
    assert trial == [False]
