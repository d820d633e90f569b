"""Eq. 2 and Fig. 1: the rigid block."""

import math

import pytest

from core.errors import InputError
from core.wall.block import Block


@pytest.mark.parametrize(
    "alpha, radius, inertia", [(0.0, 1, 2), (2.0, 1, 2), (0.1, 0, 2), (0.1, 1, 1), (0.1, math.nan, 2), (math.nan, 1, 2)]
)
def test_that_an_impossible_block_is_refused(alpha, radius, inertia):
    with pytest.raises(InputError):
        Block(alpha, radius, inertia)
