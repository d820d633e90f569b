"""The curves drawn of the nonlinear check: that of the wall, that of the demand, that of the floor."""

from pathlib import Path

import numpy as np
import pytest

from core.case.rules import parse_case, parse_wall
from core.codes.capacity_curve import CURVE_PERIODS, capacity_curve
from core.codes.floor_spectrum import FloorSpectrum, first_mode
from core.codes.kinematic import analyse_mechanism
from core.codes.spectrum_codes import en1998
from core.setting.demand_input import read_demand
from core.units import G

WALL = {"name": "w", "height_m": 1.0, "thickness_m": 0.1, "mechanism": "two_sided", "base_z_m": 0.0}
DEMAND = {"ag_g": 0.2, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}, "confidence_factor": 1.35}


def curve_of(**changes):
    case = parse_case({"wall": [WALL], "demand": {**DEMAND, **changes}})
    demand = read_demand(case, Path())
    return analyse_mechanism(case.wall[0].in_si, "two_sided", demand), demand


def test_that_the_capacity_falls_on_a_line_from_alpha_0_to_d_0():
    """alpha_0 = t/H = 0.1, e* = 1, FC = 1.35; d_0 = alpha_0 H / 2."""
    found, demand = curve_of()
    curve = capacity_curve(found, demand)
    (d0, a0), (d1, a1) = curve.capacity
    assert (d0, a1) == (0.0, 0.0)
    assert a0 == pytest.approx(0.1 * G / 1.35, rel=1e-12)
    assert d1 == found.d0


@pytest.mark.parametrize(("limit_state", "damping"), [("SLV", 0.08), ("SLC", 0.10)])
def test_that_the_demand_is_the_spectrum_up_to_a_quarter_more_than_the_check_needs(limit_state, damping):
    found, demand = curve_of(limit_state=limit_state, ag_g=0.5)
    curve = capacity_curve(found, demand)
    assert curve.damping == damping
    target = en1998(0.5 * G, 1, "B")
    acceleration = target.acceleration(CURVE_PERIODS, damping)
    moved = acceleration * (CURVE_PERIODS / (2.0 * np.pi)) ** 2
    inside = moved <= 1.25 * max(found.d0, found.s_de)
    assert 50 < inside.sum() < CURVE_PERIODS.size - 20  # it ends within the curve
    assert curve.demand_d == pytest.approx(moved[inside], rel=1e-13)
    assert curve.demand_a == pytest.approx(acceleration[inside], rel=1e-13)
    assert curve.floor_d.size == curve.floor_a.size == 0


def test_that_above_the_ground_the_floor_has_its_own_curve():
    _, demand = curve_of()
    wall = parse_wall({**WALL, "base_z_m": 6.0})
    floor = FloorSpectrum(demand.target, first_mode(3, 9.0, 6.0, 0.3, 0.05))
    found = analyse_mechanism(wall.in_si, "two_sided", demand, floor)
    curve = capacity_curve(found, demand)
    felt = found.floor.acceleration(CURVE_PERIODS, curve.damping)
    moved = felt * (CURVE_PERIODS / (2.0 * np.pi)) ** 2
    inside = moved <= 1.25 * max(found.d0, found.s_de)
    assert curve.floor_a == pytest.approx(felt[inside], rel=1e-13) and curve.floor_a.size > 20
    assert curve.floor_d == pytest.approx(moved[inside], rel=1e-13)


def test_that_a_wall_without_the_nonlinear_check_has_no_curve():
    found, demand = curve_of(limit_state="SLD")
    assert found.d_limit is None and capacity_curve(found, demand) is None


def test_that_the_demand_is_drawn_every_hundredth_of_a_second_to_half_a_second_and_every_fiftieth_to_four():
    """The period of a point is 2 pi sqrt(d / a); a wall tall enough for all of them."""
    case = parse_case({"wall": [{**WALL, "height_m": 20.0, "thickness_m": 4.0}], "demand": DEMAND})
    demand = read_demand(case, Path())
    curve = capacity_curve(analyse_mechanism(case.wall[0].in_si, "two_sided", demand), demand)
    periods = 2.0 * np.pi * np.sqrt(curve.demand_d / curve.demand_a)
    expected = [0.01 * k for k in range(51)] + [0.5 + 0.02 * k for k in range(1, 176)]
    assert periods == pytest.approx(expected, abs=1e-12) and periods[-1] == pytest.approx(4.0, rel=1e-12)
