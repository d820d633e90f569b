"""The body above a hinge is that of a wall of its own, however it is written (issue BO)."""

import numpy as np
import pytest

from core.case.hinges import above_hinge, usual_hinges
from core.case.rules import parse_wall
from core.case.site import Building

BASE = {"name": "w", "mechanism": "one_sided", "base_z_m": 0.0, "height_m": 9.0, "thickness_m": 0.6, "length_m": 5.0}
BASE |= {"unit_weight_kn_m3": 18.0, "back_restraint": "cross_walls", "restraint_evidence": "drawing"}
BASE |= {"unloaded_confirmed": True}
BUILDING = Building(9.0, 3, period_s=0.2)


def section(*corners: tuple[float, float]) -> dict:
    return {"plane": "section", "polygon_m": [list(corner) for corner in corners], "to_m": 5.0}


def box(outer: float, inner: float, low: float, high: float) -> dict:
    return section((outer, low), (inner, low), (inner, high), (outer, high))


@pytest.mark.parametrize("outer", [-0.10, -0.02, 0.0, 0.05])
def test_that_what_overhangs_turns_about_the_edge_it_rests_on(outer):
    """A wall of 0.8 m that carries one of 0.35 m which overhangs it: above the joint it is the body drawn alone."""
    wall = BASE | {"height_m": 10.0, "thickness_m": 0.8}
    whole = parse_wall(wall | {"solid": [box(0.0, 0.8, 0.0, 6.0), box(outer, 0.35, 6.0, 10.0)]})
    edge = max(outer, 0.0)
    alone = wall | {"height_m": 4.0, "thickness_m": 0.35 - edge, "base_z_m": 6.0}
    alone = parse_wall(alone | {"solid": [box(outer - edge, 0.35 - edge, 0.0, 4.0)]})
    block, expected = above_hinge(whole, 6.0).block(), alone.block()
    assert block.slenderness == pytest.approx(expected.slenderness, rel=1e-12)
    assert block.radius == pytest.approx(expected.radius, rel=1e-12)
    # by hand: the centroid of 0.35 - outer by 4 m about the edge
    assert np.tan(block.slenderness) == pytest.approx((0.5 * (outer + 0.35) - edge) / 2.0, rel=1e-12)


def test_that_a_wall_above_a_recess_is_as_thick_as_what_it_rests_on():
    """The inner face of a wall of 0.6 m that stands on one of 0.4 m: it turns inward about 0.4 m."""
    whole = parse_wall(BASE | {"thickness_m": 0.4, "solid": [box(0.0, 0.4, 0.0, 4.0), box(0.0, 0.6, 4.0, 9.0)]})
    assert above_hinge(whole, 4.0).thickness == pytest.approx(0.4)


def test_that_loads_above_a_hinge_are_measured_from_its_edge():
    load = {"kind": "vertical", "kn_m": 10.0, "d_m": 0.2, "h_m": 9.0, "mass": "none"}
    wall = {key: value for key, value in BASE.items() if key != "unloaded_confirmed"} | {"load": [load]}
    inward = parse_wall(wall | {"solid": [box(0.0, 0.6, 0.0, 5.0), box(0.1, 0.4, 5.0, 9.0)]})
    outward = parse_wall(wall | {"solid": [box(0.0, 0.6, 0.0, 5.0), box(-0.1, 0.4, 5.0, 9.0)]})
    assert above_hinge(inward, 5.0).load[0].d_m == pytest.approx(0.1)
    assert above_hinge(outward, 5.0).load[0].d_m == pytest.approx(0.2)


@pytest.mark.parametrize("seed", range(20))
def test_that_steps_solids_and_one_outline_have_the_same_hinges_and_bodies(seed):
    """A wall that becomes thinner twice, flush with its outer face: by `steps`, solids in any order, one polygon."""
    rng = np.random.default_rng(seed)
    first, second = np.round(np.sort(rng.uniform(1.0, 7.0, 2)), 2).tolist()
    if second - first < 0.2:
        second = round(first + 0.5, 2)
    t, t1, t2 = (round(float(x), 2) for x in np.sort(rng.uniform(0.2, 0.9, 3))[::-1])
    t1, t2 = min(t1, t - 0.02), min(t2, min(t1, t - 0.02) - 0.02)
    wall = BASE | {"thickness_m": t}
    steps = [{"from_z_m": first, "thickness_m": t1}, {"from_z_m": second, "thickness_m": t2}]
    solids = [box(0.0, t, 0.0, first), box(0.0, t1, first, second), box(0.0, t2, second, 9.0)]
    outline = section((0, 0), (t, 0), (t, first), (t1, first), (t1, second), (t2, second), (t2, 9.0), (0, 9.0))
    turned = section(*reversed([tuple(corner) for corner in outline["polygon_m"]]))
    written = [
        parse_wall(wall | more)
        for more in (
            {"steps": steps},
            {"solid": solids},
            {"solid": [solids[k] for k in rng.permutation(3)]},
            {"solid": [outline]},
            {"solid": [turned]},
        )
    ]
    hinges = [usual_hinges(one, BUILDING) for one in written]
    assert all(one == pytest.approx(hinges[0]) for one in hinges)
    assert {first, second} & set(np.round(hinges[0], 6))
    for hinge in (0.0, *hinges[0]):
        blocks = [above_hinge(one, hinge).block() for one in written]
        for block in blocks[1:]:
            assert block.slenderness == pytest.approx(blocks[0].slenderness, rel=1e-9)
            assert block.radius == pytest.approx(blocks[0].radius, rel=1e-9)
            assert block.inertia_over_mass == pytest.approx(blocks[0].inertia_over_mass, rel=1e-9)
