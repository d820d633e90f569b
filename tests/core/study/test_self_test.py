"""The numbers by which machine code of another machine shows that it is right."""

import math

from core.study import self_test


def test_that_the_numbers_are_the_same_each_time_and_of_walls_that_overturn():
    numbers = self_test.numbers()
    assert numbers == self_test.numbers()
    values = [float.fromhex(number) for number in numbers]
    assert len(values) > 20 and len(set(values)) > 20 and values[1] > 0.5
    assert not math.isnan(values[0])


def test_that_the_last_digit_of_one_tells_right_from_wrong(monkeypatch):
    right = self_test.numbers()
    wrong = [*right[:-1], math.nextafter(float.fromhex(right[-1]), 9.9).hex()]
    for known, expected in ((right, True), (wrong, False), (None, False)):
        monkeypatch.setattr(self_test, "build", lambda known=known: {"self_test": known})
        assert self_test.numbers_are_right() is expected
