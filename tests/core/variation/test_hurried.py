"""No way to "verified" for a wall that falls is silent (hurried.py)."""

import pytest

from tests.core.variation.hurried import BASES, FALLS, SILENT, WAYS, Way, said_to

EVERY = 4
"""One of so many ways is in the suite, and none whose histories take seconds."""


def marked(k: int, way: Way):
    slow = way.base == "parapet" or "linearised" in way.name
    return pytest.param(way, id=way.name, marks=[] if k % EVERY == 0 and not slow else [pytest.mark.long])


@pytest.mark.parametrize("base", [base for base in BASES if base != "parapet"])
def test_that_what_the_ways_begin_with_falls(base):
    assert said_to(Way("as it is", base, {}))[0] == FALLS


@pytest.mark.parametrize("way", [marked(k, way) for k, way in enumerate(WAYS)])
def test_that_no_way_to_verified_is_silent(way):
    assert said_to(way)[0] != SILENT
