"""A thrust between base and top of a wall that bends: virtual work, equilibrium from coordinates, what it does."""

import random

import numpy as np
import pytest

from core.codes.vertical_bending import lowest_hinge, mechanism, start_multiplier
from core.mechanism.bending_reactions import MovingStrip
from core.wall.bending import Motion, Strip, Thrust, Turning, Weight


def random_strip(draw):
    height, thickness = draw.uniform(3.0, 7.0), draw.uniform(0.3, 0.6)
    weight = 18e3 * height * thickness
    on_top = ((draw.uniform(0.0, 4e4), draw.uniform(0.0, thickness)),)
    below = (Weight(draw.uniform(0.0, 1e4), draw.uniform(0.0, thickness), draw.uniform(0.3, height - 0.3)),)
    thrust = Thrust(draw.uniform(0.0, 800.0), draw.uniform(0.0, thickness), draw.uniform(0.2, height - 0.2))
    return Strip(height, thickness, draw.uniform(0.0, 0.02), weight, on_top, below, thrusts=(thrust,))


@pytest.mark.shows("held.anchored")
@pytest.mark.parametrize("count", [200, pytest.param(2000, marks=pytest.mark.long)])
def test_that_a_thrust_works_as_its_point_moves_and_pulls_at_the_hold_by_its_lever(count):
    draw, stood = random.Random(3), 0
    for _ in range(count):
        strip = random_strip(draw)
        h1, theta = lowest_hinge(strip), draw.uniform(0.0, 0.05)
        moving, turning = MovingStrip(strip, h1), Turning.of(strip, h1)
        alpha0 = start_multiplier(strip, h1)
        assert alpha0 == pytest.approx(float(moving.multiplier()), abs=1e-9)  # as the points of the blocks move
        _, held, pushed = (part[0] for part in Motion(strip, h1).parts(np.array([theta])))
        assert held == pytest.approx(turning.risen(theta), rel=1e-8, abs=1e-6)
        assert float(moving.multiplier(theta)) == pytest.approx(held / pushed, abs=1e-8)
        if alpha0 > 0.0:  # statics of the whole wall about its base
            stood += 1
            assert mechanism(strip, h1).top_force == pytest.approx(moving.starts[0], abs=1e-6 * strip.weight)
            weights = alpha0 * strip.weight + alpha0 * sum(load.force for load in strip.below)
            total = weights + strip.thrusts[0].force
            assert sum(moving.starts) == pytest.approx(total, rel=1e-9)
    assert stood > 0.9 * count


@pytest.mark.shows("held.anchored")
def test_that_a_larger_thrust_never_lets_a_wall_stand_more():
    draw = random.Random(8)
    for _ in range(100):
        strip = random_strip(draw)
        more = strip._replace(thrusts=(strip.thrusts[0]._replace(force=1.5 * strip.thrusts[0].force),))
        first, second = (start_multiplier(each, lowest_hinge(each)) for each in (strip, more))
        assert second <= first + 1e-12
