"""Bodies that stand free, in both plan directions and over a corner."""

import math
from pathlib import Path

import numpy as np
import pytest

from core.case.directions import LONGEST
from core.case.hinges import count_wall_parts, make_wall_parts
from core.case.register import find_left_out
from core.case.rules import parse_case
from core.errors import InputError
from core.setting.check_input import make_rocking_model
from core.study.register import make_register
from core.study.run import run
from tests.clauses_alone import parse_case as clauses_alone

PINNACLE = {"name": "pinnacle", "mechanism": "two_sided", "height_m": 2.4, "thickness_m": 0.45, "length_m": 0.6}
PINNACLE |= {"unit_weight_kn_m3": 22.0, "base_z_m": 0.0}
DEMAND = {"ag_g": 0.2, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}}


def walls_of(**changes):
    wall = parse_case({"wall": [{**PINNACLE, **changes}]}).wall[0]
    parts = make_wall_parts(0, wall, None)
    assert len(parts) == count_wall_parts(wall, None)
    return [part.wall for part in parts]


@pytest.mark.shows("bodies.directions")
@pytest.mark.parametrize("seed", range(3))
def test_that_random_prisms_turn_along_their_length_and_over_a_corner_as_their_points_do(seed):
    """M, the centroid, I about the edge and what an impact leaves, from points of the prism in coordinates."""
    rng = np.random.default_rng(seed)
    for _ in range(100):
        t, height = rng.uniform(0.3, 0.75), rng.uniform(2.0, 5.0)
        length = t * rng.uniform(0.2, LONGEST)
        _, along, diagonal = walls_of(thickness_m=t, length_m=length, height_m=height, unloaded_confirmed=True)
        base = math.hypot(t, length)
        # x of a point is its distance along the direction of motion from the corner: sums of three uniform variables
        spread = {"90°": length**2 / 12.0, "": (length**4 + t**4) / (12.0 * base**2)}
        for wall, width, var in ((along, length, spread["90°"]), (diagonal, base, spread[""])):
            block, model = wall.in_si.block, make_rocking_model(wall, "two_sided")
            about_centre = var + height**2 / 12.0
            inertia = about_centre + 0.25 * (width**2 + height**2)
            assert block.slenderness == pytest.approx(math.atan2(width, height), rel=1e-12)
            assert block.p2 == pytest.approx(9.80665 * 0.5 * math.hypot(width, height) / inertia, rel=1e-12)
            kept = (about_centre + 0.25 * (height**2 - width**2)) / inertia
            assert model.ratio_at_rest == pytest.approx(kept, rel=1e-12)
            assert wall.weight == pytest.approx(22e3 * t * length * height, rel=1e-12)


def test_that_a_direction_too_stocky_to_rock_is_left_out():
    """A block longer than it is high does not fall along itself; across it does."""
    (own,) = walls_of(height_m=0.55, length_m=0.85)
    assert own.thickness_m == 0.45


def test_that_a_body_longer_than_twice_its_thickness_falls_across_itself():
    assert len(walls_of(length_m=0.45 * LONGEST)) == 3
    (own,) = walls_of(length_m=0.45 * LONGEST + 0.01)
    assert own.thickness_m == 0.45


def test_that_a_square_has_one_answer_along_both_sides():
    own, along, diagonal = walls_of(length_m=0.45)
    assert along.in_si.block.p2 == own.in_si.block.p2
    assert along.in_si.block.slenderness == pytest.approx(own.in_si.block.slenderness, rel=1e-12)
    assert diagonal.name == "pinnacle (45°)"


def test_that_loads_go_with_the_body_and_crushing_is_that_of_one_edge_or_corner():
    cap = {"kind": "carried_mass", "kn_m": 2.0, "d_m": 0.225, "h_m": 2.5}
    own, along, diagonal = walls_of(load=[cap], compressive_strength_mpa=0.5)
    for wall in (own, along, diagonal):
        assert wall.load[0].kn_m * wall.length_m == pytest.approx(1.2, rel=1e-12)
    force = 22e3 * 0.45 * 0.6 * 2.4 + 1.2e3
    assert own.setback == pytest.approx(2.0 * force / (3.0 * 0.5e6 * 0.6), rel=1e-12)
    assert along.setback == pytest.approx(2.0 * force / (3.0 * 0.5e6 * 0.45), rel=1e-12)
    # stress falls from f at the corner to none at the depth c: N = f area / 3, at c / 2 from the corner
    base = math.hypot(0.45, 0.6)
    depth = 2.0 * diagonal.setback
    area = depth**2 * base**2 / (2.0 * 0.45 * 0.6)
    assert force == pytest.approx(0.5e6 * area / 3.0, rel=1e-12)


def test_that_the_worst_direction_is_the_verdict_and_each_has_its_histories():
    table = {"wall": [PINNACLE | {"unloaded_confirmed": True, "elastic_modulus_mpa": 1000.0}], "demand": DEMAND}
    result = run(clauses_alone(table), base_dir=Path())
    assert [wall.part.aspect for wall in result.walls] == ["", "90°", "53.1°"]
    zetas = [wall.required_assessment.verdict.zeta_e for wall in result.walls]
    (verdict,) = result.verdicts
    assert verdict.zeta_least == min(zetas) and verdict.governing == zetas.index(min(zetas))


@pytest.mark.parametrize(
    "changes",
    [
        {"mechanism": "one_sided"},
        {"length_m": None},
        {"unit_weight_kn_m3": None},
        {"gable_m": 0.5},
        {"load": [{"kind": "carried_mass", "kn_m": 1.0, "d_m": 0.1, "h_m": 2.4}]},
        {"load": [{"kind": "thrust", "kn_m": 0.1, "h_m": 2.4}]},
        {"hold": [{"kind": "tie", "out_kn_m": 0.1, "h_m": 2.4, "bar_length_m": 5.0}]},
    ],
)
def test_that_a_body_that_something_holds_or_known_in_one_direction_alone_has_that_one(changes):
    table = {key: value for key, value in {**PINNACLE, **changes}.items() if value is not None}
    wall = parse_case({"wall": [table]}).wall[0]
    assert [part.aspect for part in make_wall_parts(0, wall, None)] == [""]


@pytest.mark.parametrize(("length", "left_out"), [(0.44, True), (0.46, False)])
def test_that_a_direction_that_falls_sooner_and_is_not_known_is_left_out(length, left_out):
    off = {"kind": "carried_mass", "kn_m": 1.0, "d_m": 0.1, "h_m": 2.4}
    wall = PINNACLE | {"length_m": length, "load": [off], "elastic_modulus_mpa": 1000.0, "mechanism": "two_sided"}
    wall |= {"law": "rigid", "load": [off | {"kind": "vertical", "mass": "none"}]}
    (part,) = make_wall_parts(0, parse_case({"wall": [wall]}).wall[0], None)
    assert ("direction_left_out" in [why.code for why in find_left_out(part, None)]) == left_out


@pytest.mark.parametrize("hold", [{"kind": "anchor", "h_m": 0.05}, {"kind": "contact"}, {"kind": "cross_walls"}])
def test_that_a_hold_that_holds_nothing_takes_no_direction_away(hold):
    """0.90 at 90 degrees; with an anchor at 5 cm, of no strength, 1.80 and verified."""
    wall = PINNACLE | {"height_m": 3.0, "thickness_m": 1.0, "length_m": 0.5, "hold": [hold]}
    (case,) = parse_case({"wall": [wall]}).wall
    assert [part.aspect for part in make_wall_parts(0, case, None)][:2] == ["", "90°"]


def test_that_a_pier_that_is_free_above_its_holds_leaves_its_length_out():
    wall = PINNACLE | {"mechanism": "one_sided", "height_m": 3.4, "thickness_m": 1.0, "length_m": 0.5}
    wall |= {"hold": [{"kind": "contact", "to_m": 0.4}]}
    part = make_wall_parts(0, parse_case({"wall": [wall]}).wall[0], None)[0]
    assert "direction_left_out" in [why.code for why in find_left_out(part, None)]


def test_that_a_wall_without_a_length_is_said_to_be_taken_as_long():
    table = {key: value for key, value in PINNACLE.items() if key != "length_m"}
    table |= {"unloaded_confirmed": True, "elastic_modulus_mpa": 1000.0}
    result = run(clauses_alone({"wall": [table], "demand": DEMAND}), base_dir=Path())
    (row,) = (looked.row for looked in make_register(result, result.verdicts[0]) if looked.row.name == "direction")
    assert row.why.code == "taken_as_long"


def test_that_the_older_flag_is_refused_with_what_is_done_now():
    with pytest.raises(InputError) as refused:
        parse_case({"wall": [PINNACLE | {"all_directions": True}]})
    assert refused.value.code == "directions_by_themselves"


def test_that_no_direction_goes_for_another_reason_than_that_it_does_not_rock():
    """The hinge over a corner moves inward with the root of the setback: too far is refused, not passed by."""
    square = {"thickness_m": 0.5, "length_m": 0.5, "height_m": 2.4}
    assert len(walls_of(**square, hinge_setback_m=0.14)) == 3
    with pytest.raises(InputError) as refused:
        walls_of(**square, hinge_setback_m=0.145)
    assert refused.value.code == "setback_too_large" and "45°" in str(refused.value)


def test_that_thickness_and_length_may_change_places():
    """Above a hinge too: each direction has the hinges of its own wall."""
    load = {"kind": "carried_mass", "h_m": 0.67}
    building = {"height_m": 15.0, "storeys": 5, "period_s": 0.4}
    zetas = []
    for t, length in ((0.42, 0.45), (0.45, 0.42)):
        wall = PINNACLE | {"height_m": 3.79, "thickness_m": t, "length_m": length, "base_z_m": 3.0}
        wall |= {"elastic_modulus_mpa": 1000.0, "load": [load | {"kn_m": 3.26 / length, "d_m": 0.5 * t}]}
        result = run(clauses_alone({"wall": [wall], "building": building, "demand": DEMAND}), base_dir=Path())
        zetas.append(result.verdicts[0].zeta_least)
    assert zetas[0] == pytest.approx(zetas[1], rel=1e-9)
