"""A wall in SI: its blocks, moments and forces by hand."""

import math
from dataclasses import replace

import numpy as np
import pytest

from core.case.rules import parse_case
from core.case.wall import Wall
from core.study import run as study
from core.units import G
from core.wall.block import Block
from core.wall.loads import UNLOADED, RestoringMoment
from core.wall.masonry import Masonry, is_stable, load_to_force, period_share
from core.wall.solids import Part
from tests.validation.test_loaded_walls import PUSHING, ROOF, THRUST, TIE, WALL, case_of


def wall_of(*loads, **changes):
    """The wall of 3.0 x 0.45 m and 18 kN/m3, 24.3 kN/m."""
    return case_of(*loads, **changes).wall[0]


def test_that_a_tie_of_a_wall_that_turns_both_ways_holds_its_outward_side_alone():
    wall = case_of({**TIE, "out_kn_m": 2.0}, mechanism="two_sided").wall[0]
    wall = wall.in_si
    (tie,) = wall.loads
    assert load_to_force(tie, wall, 1.0).horizontal == 2e3 and load_to_force(tie, wall, -1.0).horizontal == 0.0
    assert wall.restoring == (UNLOADED, UNLOADED) and len(wall.bars) == 1


@pytest.mark.shows("kinematic.d_slv")
def test_that_theta_c_is_of_the_wall_without_its_ties():
    assert case_of(ROOF, TIE).wall[0].in_si.restoring == case_of(ROOF).wall[0].in_si.restoring


def test_that_sides_alike_but_for_rounding_are_alike():
    random = np.random.default_rng(3)
    for d in random.uniform(0.0, 0.45, 200):
        pair = ({**ROOF, "d_m": float(d), "kn_m": 3.0}, {**ROOF, "d_m": float(0.45 - d), "kn_m": 3.0})
        outward, inward = case_of(*pair, mechanism="two_sided", law="doherty").wall[0].in_si.restoring
        assert outward == inward


def test_that_sides_that_differ_by_more_than_rounding_differ():
    """A roof off the middle by x: c of both sides differs by 2 N x cos(alpha) / (W R), told apart from 1e-9 on."""
    moment = 24.3 * 0.5 * math.hypot(3.0, 0.45)
    off = 1e-9 * moment / (2.0 * 10.0 * math.cos(math.atan(0.15)))
    for share, alike in ((0.999, True), (1.001, False)):
        roof = {**ROOF, "d_m": 0.225 + share * off}
        outward, inward = case_of(roof, mechanism="two_sided").wall[0].in_si.restoring
        assert (outward == inward) == alike
        if not alike:
            assert outward.cosine - inward.cosine == pytest.approx(1.001e-9, rel=1e-5)


def test_that_each_hinge_has_its_block_and_its_moment():
    wall = wall_of(PUSHING, {**ROOF, "kn_m": 3.0, "d_m": 0.2}, mechanism="two_sided").in_si
    outward, inward = wall.restoring
    assert outward != inward and wall.inner_block is not None
    assert wall.sides == [(wall.block, outward), (wall.inner_block, inward)]
    bare = wall_of(mechanism="two_sided").in_si
    assert bare.sides == [(bare.block, UNLOADED), (bare.block, UNLOADED)]


def leaf(thickness: float, low: float, high: float) -> Part:
    corners = ((0.0, low), (4.0, low), (4.0, high), (0.0, high))
    return Part(corners, (0.0, thickness), 0.5 * math.pi, 0.0, 18e3, "elevation")


@pytest.mark.parametrize(
    ("parts", "share"),
    [
        ((leaf(0.6, 0.0, 8.0),), 1.0),
        ((leaf(0.6, 0.0, 2.0), leaf(0.6, 2.0, 8.0)), 1.0),
        ((leaf(0.6, 0.0, 4.0), leaf(0.3, 4.0, 8.0)), 0.5275973),
    ],
)
def test_that_the_period_of_a_wall_that_becomes_thinner_is_by_the_mass_that_its_deflection_moves(parts, share):
    """eta^2 (6 - 4 eta + eta^2) / 3 squared is (36 eta^4 - 48 eta^5 + 28 eta^6 - 8 eta^7 + eta^8) / 9: 104/405 over the
    height, 0.0141734 over its lower half, so that half of the mass above gives 0.5 + 0.5 x 0.0141734 x 405 / 104."""
    bare = Block.with_setback(8.0, 0.6, 0.0)
    wall = Masonry("w", "one_sided", bare, 8.0, 0.6, length=4.0, unit_weight=18e3, parts=parts)
    assert period_share(wall) == pytest.approx(share, rel=1e-6)


def test_that_weights_are_forces_and_masses_are_weights_over_g():
    wall = wall_of(PUSHING, {**ROOF, "kn_m": 3.0}, TIE)
    assert wall.in_si.weight == pytest.approx(24300.0, rel=1e-14)
    assert wall.in_si.vertical_loads == pytest.approx(13000.0, rel=1e-14)
    (mass,) = wall.in_si.masses
    assert mass.mass * G == pytest.approx(10000.0, rel=1e-14)
    assert (mass.distance, mass.height) == (0.30, 3.0)
    assert wall_of(PUSHING, hinge_setback_m=0.05).in_si.masses[0].distance == pytest.approx(0.25)


def test_that_a_block_with_its_masses_has_their_centroid_and_inertia():
    wall = wall_of(PUSHING)
    block = wall.in_si.block
    assert block.centroid[0] == pytest.approx((24.3 * 0.225 + 10.0 * 0.30) / 34.3, rel=1e-13)
    assert block.centroid[1] == pytest.approx((24.3 * 1.5 + 10.0 * 3.0) / 34.3, rel=1e-13)
    inertia = 24.3 * (3.0**2 + 0.45**2) / 3.0 + 10.0 * (0.30**2 + 3.0**2)
    assert block.inertia_over_mass == pytest.approx(inertia / 34.3, rel=1e-13)
    other = wall_of(ROOF).in_si
    assert other.block is other.bare


def test_that_a_load_is_a_force_at_its_place_seen_from_either_hinge():
    wall = wall_of(ROOF, TIE, THRUST, hinge_setback_m=0.05).in_si
    roof, thrust, tie = wall.loads
    assert tuple(vars(load_to_force(roof, wall, 1.0)).values()) == pytest.approx((10e3, 0.0, 0.25, 3.0))
    assert tuple(vars(load_to_force(roof, wall, -1.0)).values()) == pytest.approx((10e3, 0.0, 0.10, 3.0))
    assert tuple(vars(load_to_force(tie, wall, 1.0)).values()) == pytest.approx((0.0, 5e3, -0.05, 2.8))
    assert tuple(vars(load_to_force(thrust, wall, 1.0)).values()) == pytest.approx((0.0, -2e3, -0.05, 2.5))
    assert tuple(vars(load_to_force(thrust, wall, -1.0)).values()) == pytest.approx((0.0, 2e3, 0.40, 2.5))
    assert load_to_force(tie, wall, -1.0).horizontal == 0.0
    inward = replace(thrust, force=-2e3)
    assert tuple(vars(load_to_force(inward, wall, 1.0)).values()) == pytest.approx((0.0, 2e3, -0.05, 2.5))


def test_that_a_and_c_count_the_weight_of_the_masses_that_move():
    """One that moves is in the block; of what is held the moment is over the weight of wall and masses, 34.3 kN/m."""
    wall = wall_of(PUSHING, {**ROOF, "kn_m": 3.0, "d_m": 0.2}).in_si
    block, (outward, inward) = wall.block, wall.restoring
    at_rest = outward.sine * math.sin(block.slenderness) + outward.cosine * math.cos(block.slenderness)
    assert 34.3 * block.radius * at_rest == pytest.approx(34.3 * block.centroid[0] + 3.0 * 0.2, rel=1e-13)
    other = wall.inner_block
    at_rest = inward.sine * math.sin(other.slenderness) + inward.cosine * math.cos(other.slenderness)
    assert other.centroid[0] == pytest.approx(0.45 - block.centroid[0], rel=1e-13)
    assert 34.3 * other.radius * at_rest == pytest.approx(34.3 * other.centroid[0] + 3.0 * 0.25, rel=1e-13)
    assert wall_of(PUSHING).in_si.restoring == (UNLOADED, UNLOADED)


def test_that_a_wall_is_stable_while_something_holds_it_at_rest():
    block = wall_of().block()
    tangent = math.tan(block.slenderness)
    assert is_stable(block, RestoringMoment(1.0, -0.999 * tangent))
    assert not is_stable(block, RestoringMoment(1.0, -tangent))
    assert not is_stable(block, RestoringMoment(1.0, -1.001 * tangent))
    assert not is_stable(block, RestoringMoment(0.0, 1.0))
    assert not is_stable(block, RestoringMoment(-0.1, 1.0))


def test_that_masses_in_the_middle_leave_one_block_for_both_hinges():
    middle = {**PUSHING, "d_m": 0.225}
    assert wall_of(middle).in_si.is_centred
    assert wall_of().in_si.is_centred
    for d, centred in ((0.22500005, True), (0.225005, False), (0.224995, False)):
        wall = wall_of({**PUSHING, "d_m": d})
        assert wall.in_si.is_centred == centred, d


@pytest.mark.parametrize(
    ("loads", "changes", "answer"),
    [
        ((), {}, True),
        ((ROOF,), {}, True),
        ((ROOF,), {"law": "doherty"}, False),  # its sides differ
        (({**ROOF, "d_m": 0.225},), {"law": "doherty"}, True),
        ((PUSHING,), {}, True),  # another body about each hinge
        ((PUSHING,), {"law": "doherty"}, False),
        (({**PUSHING, "d_m": 0.225},), {}, True),
        (({**TIE, "out_kn_m": 1.0}, {"kind": "thrust", "kn_m": 0.5, "h_m": 2.0}), {}, True),
    ],
)
def test_that_a_wall_without_its_restraint_is_two_sided_only_where_the_model_has_it(loads, changes, answer):
    assert wall_of(*loads, **changes).in_si.rocks_both_ways == answer


def test_that_the_block_of_a_wall_is_built_once_for_all_that_ask_for_it(monkeypatch, tmp_path):
    """Two walls from the reading of their keys to the verdict: before there was one object they were 1 171."""
    built = []
    one = Wall.bare_block
    monkeypatch.setattr(Wall, "bare_block", lambda wall: built.append(wall) or one(wall))
    walls = [{**WALL, "name": name, "base_z_m": 0.0, "mechanism": name} for name in ("one_sided", "two_sided")]
    demand = {
        "ag_g": 0.1,
        "spectrum": {"code": "NTC2018", "f0": 2.4, "tc_star_s": 0.3, "soil": "A", "topography": "T1"},
    }
    study.run(parse_case({"wall": walls, "demand": demand, "analysis": {"histories": False}}), base_dir=tmp_path)
    assert len({id(wall) for wall in built}) >= 2 and len(built) <= 60
