"""A wall in SI: its blocks, moments and forces by hand."""

import math
from dataclasses import replace

import numpy as np
import pytest

from core.case.rules import parse_case
from core.case.wall import Wall
from core.study import run as study
from core.units import G
from core.wall.loads import BARE, RestoringMoment
from core.wall.masonry import as_force, is_stable
from tests.validation.test_loaded_walls import PUSHING, ROOF, THRUST, TIE, WALL, case_of


def wall_of(*loads, **changes):
    """The wall of 3.0 x 0.45 m and 18 kN/m3, 24.3 kN/m."""
    return case_of(*loads, **changes).wall[0]


def test_that_a_tie_of_a_wall_that_turns_both_ways_holds_its_outward_side_alone():
    wall = case_of({**TIE, "kn_m": 2.0}, mechanism="two_sided").wall[0]
    wall = wall.in_si
    (tie,) = wall.loads
    assert as_force(tie, wall, 1.0).horizontal == 2e3 and as_force(tie, wall, -1.0).horizontal == 0.0
    assert wall.restoring == (BARE, BARE) and len(wall.bars) == 1


def test_that_theta_c_is_of_the_wall_without_its_ties():
    assert case_of(ROOF, TIE).wall[0].in_si.restoring == case_of(ROOF).wall[0].in_si.restoring


def test_that_sides_alike_but_for_rounding_are_alike():
    random = np.random.default_rng(3)
    for d in random.uniform(0.0, 0.45, 200):
        pair = ({**ROOF, "d_m": float(d), "kn_m": 3.0}, {**ROOF, "d_m": float(0.45 - d), "kn_m": 3.0})
        outward, inward = case_of(*pair, mechanism="two_sided", law="doherty").wall[0].in_si.restoring
        assert outward == inward


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
    roof, tie, thrust = wall.loads
    assert tuple(vars(as_force(roof, wall, 1.0)).values()) == pytest.approx((10e3, 0.0, 0.25, 3.0))
    assert tuple(vars(as_force(roof, wall, -1.0)).values()) == pytest.approx((10e3, 0.0, 0.10, 3.0))
    assert tuple(vars(as_force(tie, wall, 1.0)).values()) == pytest.approx((0.0, 5e3, -0.05, 2.8))
    assert tuple(vars(as_force(thrust, wall, 1.0)).values()) == pytest.approx((0.0, -2e3, -0.05, 2.5))
    assert tuple(vars(as_force(thrust, wall, -1.0)).values()) == pytest.approx((0.0, 2e3, 0.40, 2.5))
    assert as_force(tie, wall, -1.0).horizontal == 0.0
    inward = replace(thrust, force=-2e3)
    assert tuple(vars(as_force(inward, wall, 1.0)).values()) == pytest.approx((0.0, 2e3, -0.05, 2.5))


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
    assert wall_of(PUSHING).in_si.restoring == (BARE, BARE)


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
        (({**TIE, "kn_m": 1.0}, {"kind": "thrust", "kn_m": 0.5, "h_m": 2.0}), {}, True),
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
