"""Sums of the kinematic chain: friction of return walls, loads of two-sided walls, T_0 with masses."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.case.rules import parse_case
from core.codes.kinematic import analyse_mechanism, check_displacement, elastic_period
from core.codes.kinematic_chain import multipliers_with_friction, return_wall_friction, sum_chain
from core.report.json_report import results
from core.setting.demand_input import read_demand
from core.study import run as study
from core.units import G
from tests.core.case.test_load_rules import ACROSS
from tests.validation.test_loaded_walls import DEMAND, PUSHING, ROOF, THRUST, TIE, WALL, case_of


def across(**changes):
    return case_of(return_walls=ACROSS, length_m=5.0, **changes).wall[0]


@pytest.mark.shows("kinematic.friction")
def test_that_friction_counts_in_alpha0_alone_and_at_its_least():
    wall = across()
    found, bare = sum_chain(wall.in_si, False), sum_chain(replace(wall, return_walls=None).in_si, False)
    assert (found.alpha0, found.e_star, found.d0) == (bare.alpha0, bare.e_star, bare.d0)
    values = []
    for h in np.linspace(0.05, 3.0, 5000):
        holding = 8.1 * h * 0.225 + 2.0 * 1e-3 * return_wall_friction(wall.in_si, h) / 5.0 * h / 3.0
        values.append(holding / (0.5 * 8.1 * h * h))
    assert found.alpha0_friction == pytest.approx(min(values), rel=1e-6)
    assert found.alpha0_friction > bare.alpha0
    multipliers, shares, masses, heights = multipliers_with_friction(wall.in_si)
    assert multipliers[-1] == pytest.approx(values[-1], rel=1e-9) and heights[-1] == 3.0
    assert masses[-1] == pytest.approx(24.3e3 / G, rel=1e-12)
    assert np.abs(shares - 1.0).max() < 1e-14
    # a wall that turns inward is not held: nothing of it for a two-sided one
    assert sum_chain(wall.in_si, True).alpha0_friction is None


def test_that_friction_takes_the_part_whose_a0_is_least_with_its_own_e_star():
    """a0* = alpha_0 g / (e* FC), both of the upper part of height h."""
    wall = case_of({**PUSHING, "kn_m": 50.0}, return_walls={**ACROSS, "number": 4}, length_m=5.0).wall[0]
    found = sum_chain(wall.in_si, False)
    least = math.inf
    for h in np.linspace(0.01, 3.0, 3000):
        weight = 8.1 * h
        holding = weight * 0.225 + 50.0 * 0.30 + 4e-3 * return_wall_friction(wall.in_si, h) / 5.0 * h / 3.0
        first, second = weight * 0.5 * h + 50.0 * h, weight * 0.25 * h * h + 50.0 * h * h
        e_star = first**2 / ((weight + 50.0) * second)
        least = min(least, holding / first / e_star)
    assert found.alpha0_friction / found.e_star_friction == pytest.approx(least, rel=1e-3)


FRICTION = (
    (),
    (ROOF,),
    (PUSHING, THRUST),
    ({**PUSHING, "kn_m": 50.0},),
    ({**PUSHING, "kn_m": 2.0}, {**THRUST, "kn_m": 1.0}),
)
"""Loads of walls whose upper part turns, held by return walls."""


@pytest.mark.shows("kinematic.sums", "kinematic.a0")
@pytest.mark.parametrize("loads", FRICTION)
def test_that_the_numbers_of_a_mechanism_are_of_one_body(loads):
    """a0* = alpha_0 g / (e* FC), M* = e* of the mass of the same body, in the results and in the JSON; beside them
    those of the whole wall without the friction, none of which a check is above."""
    case = case_of(*loads, return_walls=ACROSS, length_m=5.0)
    (wall,) = study.run(case, base_dir=Path()).walls
    found, bare = wall.assessment.kinematic, replace(case.wall[0], return_walls=None)
    part = found.chain.friction_height
    pushing = [load for load in case.wall[0].load if load.pushes and load.h_m > 3.0 - part]
    mass = 1e3 * (8.1 * part + sum(load.kn_m for load in pushing)) / G
    assert found.a0 == pytest.approx(found.alpha0 * G / (found.e_star * 1.35), rel=1e-12)
    assert found.m_star == pytest.approx(found.e_star * mass, rel=1e-12)
    assert found.zeta_floor <= found.zeta_sld
    whole = analyse_mechanism(bare.in_si, "one_sided", read_demand(case, Path()))
    check = results(study.run(case, base_dir=Path()))["walls"][0]["kinematic_check"]
    for numbers, body in ((check, found), (check["without_friction"], whole)):
        assert numbers["a0_star_g"] == pytest.approx(numbers["alpha0"] / (numbers["e_star"] * 1.35), rel=1e-12)
        assert numbers["a0_star_g"] == pytest.approx(body.a0 / G, rel=1e-12)
        assert numbers["m_star"] == pytest.approx(body.m_star, rel=1e-12)
    assert check["friction_height_m"] == part
    alone = results(study.run(replace(case, wall=(bare,)), base_dir=Path()))["walls"][0]
    assert alone["kinematic_check"]["without_friction"] is None


def test_that_the_friction_does_not_raise_what_the_histories_lead_to(tmp_path):
    """The histories know no friction: q_slv alpha_0 g over a_g S, alpha_0 without it."""
    table = {
        "wall": [{**WALL, "return_walls": ACROSS, "length_m": 5.0}],
        "demand": DEMAND,
        "generate": {"scatter": 0.0, "count": 3},
        "analysis": {"q_step": 0.02},
    }
    (wall,) = study.run(parse_case(table), base_dir=tmp_path).walls
    row = next(check for check in wall.assessment.checks if check.name == "linear_q_slv")
    assert wall.assessment.kinematic.alpha0 > 1.2 * wall.assessment.kinematic.chain.alpha0
    assert row.zeta == pytest.approx(wall.q_slv_safe_set * 0.15 / (1.35 * 0.312), rel=1e-9)


@pytest.mark.shows("kinematic.friction")
def test_that_the_displacement_check_does_not_count_the_friction():
    case = case_of(return_walls=ACROSS, length_m=5.0)
    demand = read_demand(case, Path())
    with_it = analyse_mechanism(case.wall[0].in_si, "one_sided", demand)
    without = analyse_mechanism(replace(case.wall[0], return_walls=None).in_si, "one_sided", demand)
    assert check_displacement(with_it, demand) == check_displacement(without, demand)
    assert with_it.zeta_sld > without.zeta_sld


@pytest.mark.shows("kinematic.d0")
def test_that_a_two_sided_wall_takes_its_weaker_side():
    """The load at 0.30 of 0.45 m holds the outer hinge more than the inner one."""
    wall = case_of(ROOF, mechanism="two_sided").wall[0]
    outer, both = sum_chain(wall.in_si, False), sum_chain(wall.in_si, True)
    assert outer.alpha0 == pytest.approx((24.3 * 0.225 + 10.0 * 0.30) / 36.45, rel=1e-12)
    assert both.alpha0 == pytest.approx((24.3 * 0.225 + 10.0 * 0.15) / 36.45, rel=1e-12)
    # theta_c where W R sin(alpha - theta) + N (d cos(theta) - h sin(theta)) = 0; d_0 of the centroid of the wall
    for found, d in ((outer, 0.30), (both, 0.15)):
        collapse = math.atan2(24.3 * 0.225 + 10.0 * d, 24.3 * 1.5 + 10.0 * 3.0)
        alpha, radius = math.atan(0.15), math.hypot(0.225, 1.5)
        d0 = radius * (math.sin(alpha) - math.sin(alpha - collapse))
        assert found.d0 == pytest.approx(d0, rel=1e-12)


def test_that_friction_holds_a_part_with_the_loads_above_its_hinge():
    wall = case_of(ROOF, TIE, return_walls=ACROSS, length_m=5.0).wall[0]
    multipliers, _, _, heights = multipliers_with_friction(wall.in_si)
    for h, tied in ((3.0, True), (0.21, True), (0.19, False), (0.1, False)):
        k = int(np.argmin(np.abs(heights - h)))
        h = heights[k]
        holding = 8.1 * h * 0.225 + 10.0 * 0.30 + 2e-3 * return_wall_friction(wall.in_si, h) / 5.0 * h / 3.0
        holding += 5.0 * (2.8 - (3.0 - h)) if tied else 0.0
        assert multipliers[k] == pytest.approx(holding / (0.5 * 8.1 * h * h), rel=1e-9), h


def test_that_masses_lengthen_the_elastic_period_by_dunkerleys_rule():
    bare = case_of(elastic_modulus_mpa=600.0).wall[0]
    loaded = case_of(PUSHING, elastic_modulus_mpa=600.0).wall[0]
    stiffness = 600e6 * 0.45**3 / 12.0
    mass = 10e3 / G
    added = 4.0 * math.pi**2 * mass * 27.0 / (3.0 * stiffness)
    assert elastic_period(bare.in_si) == pytest.approx(0.21688, abs=5e-6)
    assert elastic_period(loaded.in_si) == pytest.approx(math.sqrt(0.21688**2 + added), rel=1e-4)
