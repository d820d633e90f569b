"""Sums of the kinematic chain: friction of return walls, loads of two-sided walls, T_0 with masses."""

import math
from dataclasses import replace

import numpy as np
import pytest

from core.codes.kinematic import elastic_period
from core.codes.kinematic_chain import chain, friction, multipliers_with_friction
from core.units import G
from tests.core.wall.test_wall_loads import ACROSS
from tests.validation.test_loaded_walls import PUSHING, ROOF, case_of


def across(**changes):
    return case_of(return_walls=ACROSS, length_m=5.0, **changes).wall[0]


def test_that_the_friction_is_the_worked_value():
    """n 12, h_b 0.25, l 0.20, t_s 0.5, w 18: 16.202 kN."""
    assert friction(across(), 3.0) == pytest.approx(16202.0, abs=0.6)


def test_that_friction_counts_in_alpha0_alone_and_at_its_least():
    wall = across()
    found, bare = chain(wall, False), chain(replace(wall, return_walls=None), False)
    assert (found.alpha0, found.e_star, found.d0) == (bare.alpha0, bare.e_star, bare.d0)
    values = []
    for h in np.linspace(0.05, 3.0, 5000):
        holding = 8.1 * h * 0.225 + 2.0 * 1e-3 * friction(wall, h) / 5.0 * h / 3.0
        values.append(holding / (0.5 * 8.1 * h * h))
    assert found.alpha0_friction == pytest.approx(min(values), rel=1e-6)
    assert found.alpha0_friction > bare.alpha0
    multipliers, heights = multipliers_with_friction(wall)
    assert multipliers[-1] == pytest.approx(values[-1], rel=1e-9) and heights[-1] == 3.0


def test_that_a_two_sided_wall_takes_its_weaker_side():
    """The load at 0.30 of 0.45 m holds the outer hinge more than the inner one."""
    wall = case_of(ROOF, mechanism="two_sided").wall[0]
    outer, both = chain(wall, False), chain(wall, True)
    assert outer.alpha0 == pytest.approx((24.3 * 0.225 + 10.0 * 0.30) / 36.45, rel=1e-12)
    assert both.alpha0 == pytest.approx((24.3 * 0.225 + 10.0 * 0.15) / 36.45, rel=1e-12)
    assert both.d0 < outer.d0


def test_that_masses_lengthen_the_elastic_period_by_dunkerleys_rule():
    bare = case_of(elastic_modulus_mpa=600.0).wall[0]
    loaded = case_of(PUSHING, elastic_modulus_mpa=600.0).wall[0]
    stiffness = 600e6 * 0.45**3 / 12.0
    mass = 10e3 / G
    added = 4.0 * math.pi**2 * mass * 27.0 / (3.0 * stiffness)
    assert elastic_period(bare) == pytest.approx(0.21688, abs=5e-6)
    assert elastic_period(loaded) == pytest.approx(math.sqrt(0.21688**2 + added), rel=1e-4)
