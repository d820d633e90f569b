"""Eq. 9: the inequality of the code with every q."""

import math

import pytest

from core.codes.eq9 import inequality
from core.units import G
from core.wall.block import Block


@pytest.mark.shows("paper.eq_2", "paper.eq_9")
def test_that_eq_9_by_hand_fails_with_q_2_for_the_wall_of_the_example():
    """7.0 x 0.83 m, a_g 0.26 g, S 1.2, q 2: 0.1186 g against 0.156 g, ratio 0.76."""
    block = Block.rectangle(7.0, math.atan2(0.83, 7.0))
    check = inequality("code", 2.0, block.threshold_acceleration, 0.26 * 1.2 * G)
    assert check.capacity == pytest.approx(0.83 / 7.0 * G)
    assert check.demand == pytest.approx(0.156 * G)
    assert round(check.ratio, 2) == 0.76
    assert not check.passed
    assert inequality("code", 4.0, block.threshold_acceleration, 0.26 * 1.2 * G).passed


@pytest.mark.shows("paper.eq_9")
def test_that_exact_equality_passes_whatever_the_rounding():
    """t/H = 0.1, a_g 0.2, q 2: the ratio is 1 and rounds to 0.9999999999999999."""
    block = Block.rectangle(3.0, math.atan2(0.30, 3.0))
    check = inequality("code", 2.0, block.threshold_acceleration, 0.2 * G)
    assert check.ratio == pytest.approx(1.0, abs=1e-15)
    assert check.passed
