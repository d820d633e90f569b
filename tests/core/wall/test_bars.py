"""Tie bars (resources/docs/physics.md, section 18): the force over time, by hand."""

import math

import numpy as np
import pytest

from core.wall.bars import TieBar, forces

BAR = TieBar(height=2.0, strength=6000.0, elongation_at_yield=0.01, slack=0.0, stands=0.4)


@pytest.mark.shows("ties.law")
@pytest.mark.parametrize(
    ("elongation", "residual", "force"),
    [
        (0.0, 0.0, 0.0),
        (0.005, 0.0, 3000.0),
        (0.010, 0.0, 6000.0),
        (0.030, 0.020, 6000.0),  # it has yielded by 20 mm
        (0.025, 0.020, 3000.0),
        (0.015, 0.020, 0.0),  # slack on the way back
        (0.0, -0.004, 2400.0),  # pulled by 0.4 of its yield
        (0.001, -0.004, 3000.0),
        (0.300, math.inf, 0.0),  # gone
    ],
)
def test_that_a_bar_pulls_by_what_it_is_longer_than_its_residual_elongation(elongation, residual, force):
    """k u of 600 kN/m for each metre of wall, up to 6 kN/m. elongation, residual : u = h sin(theta), u_p [m]"""
    rotation = np.array([math.asin(elongation / 2.0)])
    assert forces(BAR, rotation, np.array([residual / 2.0])) == pytest.approx(force, rel=1e-9, abs=1e-9)


@pytest.mark.shows("ties.law")
def test_that_a_pulled_bar_does_nothing_on_a_wall_that_has_turned_inward():
    found = forces(BAR, np.array([-1e-4, 0.0]), np.array([-0.002, -0.002]))
    assert found.tolist() == pytest.approx([0.0, 2400.0], rel=1e-12)
