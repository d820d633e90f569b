"""A fifth of a second of hostile input for each reader, of the same seed; `python3 run.py fuzz` goes on for hours."""

import os

import pytest

from tests.fuzz.fuzz import TARGETS, attack

SECONDS = float(os.environ.get("RIBALTA_FUZZ_SECONDS", "0.2"))


@pytest.mark.shows("doors.fuzz")
@pytest.mark.parametrize("name", TARGETS)
def test_that_whatever_comes_is_read_or_refused_in_one_sentence(name):
    count, found = attack(name, SECONDS, 1)
    assert found is None and count > 0
