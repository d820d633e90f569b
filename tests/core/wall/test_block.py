"""Eq. 2 and Fig. 1: the rigid block."""

import math

import pytest

from core.errors import InputError
from core.wall.block import Block


@pytest.mark.shows("mechanics.block")
@pytest.mark.parametrize(
    "alpha, radius, inertia", [(0.0, 1, 2), (2.0, 1, 2), (0.1, 0, 2), (0.1, 1, 1), (0.1, math.nan, 2), (math.nan, 1, 2)]
)
def test_that_an_impossible_block_is_refused(alpha, radius, inertia):
    with pytest.raises(InputError):
        Block(alpha, radius, inertia)


@pytest.mark.shows("mechanics.block")
def test_that_a_rectangle_has_its_diagonal_and_its_inertia_about_a_corner():
    """4 x 3 m: half of the diagonal of 5 m, (4^2 + 3^2) / 3."""
    for block in (Block.rectangle(4.0, math.atan(0.75)), Block.with_setback(4.0, 3.0, 0.0)):
        assert block.radius == pytest.approx(2.5, rel=1e-14)
        assert block.inertia_over_mass == pytest.approx(25.0 / 3.0, rel=1e-14)
        assert block.slenderness == pytest.approx(math.atan2(3.0, 4.0), rel=1e-14)


@pytest.mark.shows("mechanics.block")
def test_that_a_hinge_inside_the_edge_is_nearer_to_the_centre_of_the_whole_wall():
    """4.0 x 3.2 m about a line 0.1 m inside: tan(alpha) = 3 / 4, R 2.5 m, I of the 3.2 m that are there."""
    block = Block.with_setback(4.0, 3.2, 0.1)
    assert block.slenderness == pytest.approx(math.atan2(3.0, 4.0), rel=1e-14)
    assert block.radius == pytest.approx(2.5, rel=1e-14)
    assert block.inertia_over_mass == pytest.approx((16.0 + 3.2 * 3.2) / 12.0 + 6.25, rel=1e-14)
    assert not block.is_rectangle
