"""The body above a hinge is that of a wall of its own, however it is written (issue BO)."""

from dataclasses import replace

import numpy as np
import pytest

from core.case.above_hinge import cut_above_hinge
from core.case.hinges import default_hinges
from core.case.rules import parse_case, parse_wall
from core.case.site import Building
from core.errors import InputError

BASE = {"name": "w", "mechanism": "one_sided", "base_z_m": 0.0, "height_m": 9.0, "thickness_m": 0.6, "length_m": 5.0}
BASE |= {"unit_weight_kn_m3": 18.0, "hold": [{"kind": "cross_walls", "evidence": {"kind": "drawing"}}]}
BASE |= {"unloaded_confirmed": True}
BUILDING = Building(9.0, 3, period_s=0.2)


def section(*corners: tuple[float, float]) -> dict:
    return {"plane": "section", "polygon_m": [list(corner) for corner in corners], "to_m": 5.0}


def box(outer: float, inner: float, low: float, high: float) -> dict:
    return section((outer, low), (inner, low), (inner, high), (outer, high))


@pytest.mark.shows("bodies.above")
@pytest.mark.parametrize("outer", [-0.10, -0.02, 0.0, 0.05])
def test_that_what_overhangs_turns_about_the_edge_it_rests_on(outer):
    """A wall of 0.8 m that carries one of 0.35 m which overhangs it: above the joint it is the body drawn alone."""
    wall = BASE | {"height_m": 10.0, "thickness_m": 0.8}
    whole = parse_wall(wall | {"solid": [box(0.0, 0.8, 0.0, 6.0), box(outer, 0.35, 6.0, 10.0)]})
    edge = max(outer, 0.0)
    alone = wall | {"height_m": 4.0, "thickness_m": 0.35 - edge, "base_z_m": 6.0}
    alone = parse_wall(alone | {"solid": [box(outer - edge, 0.35 - edge, 0.0, 4.0)]})
    block, expected = cut_above_hinge(whole, 6.0).block(), alone.block()
    assert block.slenderness == pytest.approx(expected.slenderness, rel=1e-12)
    assert block.radius == pytest.approx(expected.radius, rel=1e-12)
    # by hand: the centroid of 0.35 - outer by 4 m about the edge
    assert np.tan(block.slenderness) == pytest.approx((0.5 * (outer + 0.35) - edge) / 2.0, rel=1e-12)


def test_that_a_wall_above_a_recess_is_as_thick_as_what_it_rests_on():
    """The inner face of a wall of 0.6 m that stands on one of 0.4 m: it turns inward about 0.4 m."""
    whole = parse_wall(BASE | {"thickness_m": 0.4, "solid": [box(0.0, 0.4, 0.0, 4.0), box(0.0, 0.6, 4.0, 9.0)]})
    assert cut_above_hinge(whole, 4.0).thickness == pytest.approx(0.4)


def test_that_loads_above_a_hinge_are_measured_from_its_edge():
    load = {"kind": "vertical", "kn_m": 10.0, "d_m": 0.2, "h_m": 9.0, "mass": "none"}
    wall = {key: value for key, value in BASE.items() if key != "unloaded_confirmed"} | {"load": [load]}
    inward = parse_wall(wall | {"solid": [box(0.0, 0.6, 0.0, 5.0), box(0.1, 0.4, 5.0, 9.0)]})
    outward = parse_wall(wall | {"solid": [box(0.0, 0.6, 0.0, 5.0), box(-0.1, 0.4, 5.0, 9.0)]})
    assert cut_above_hinge(inward, 5.0).load[0].d_m == pytest.approx(0.1)
    assert cut_above_hinge(outward, 5.0).load[0].d_m == pytest.approx(0.2)


@pytest.mark.shows("bodies.one")
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
    hinges = [default_hinges(one, BUILDING) for one in written]
    assert all(one == pytest.approx(hinges[0]) for one in hinges)
    assert {first, second} & set(np.round(hinges[0], 6))
    for hinge in (0.0, *hinges[0]):
        blocks = [cut_above_hinge(one, hinge).block() for one in written]
        for block in blocks[1:]:
            assert block.slenderness == pytest.approx(blocks[0].slenderness, rel=1e-9)
            assert block.radius == pytest.approx(blocks[0].radius, rel=1e-9)
            assert block.inertia_over_mass == pytest.approx(blocks[0].inertia_over_mass, rel=1e-9)


def checked(table: dict):
    """A wall with every rule of its shape."""
    return parse_case({"title": "t", "wall": [table]}).wall[0]


def elevation(s0: float, s1: float, z0: float, z1: float, outer: float, inner: float, **more) -> dict:
    corners = [[s0, z0], [s1, z0], [s1, z1], [s0, z1]]
    return {"plane": "elevation", "polygon_m": corners, "from_m": outer, "to_m": inner} | more


@pytest.mark.parametrize(("wide", "edge"), [(0.4, 0.0), (1.2, 0.0), (1.3, -0.3)])
def test_that_pilasters_are_an_edge_where_half_of_the_length_stands_on_them(wide, edge):
    """Two pilasters before a wall of 5 m that recedes above 3 m: they alone remain in front of it."""
    solids = [elevation(0.0, 5.0, 0.0, 3.0, 0.0, 0.6), elevation(0.0, 5.0, 3.0, 9.0, 0.0, 0.5)]
    solids += [elevation(s, s + wide, 0.0, 9.0, -0.3, 0.0) for s in (0.5, 3.0)]
    found = cut_above_hinge(parse_wall(BASE | {"solid": solids}), 3.0)
    assert found.thickness == pytest.approx(0.5 if edge == 0.0 else 0.6)
    assert min(solid.x0_m + solid.from_m for solid in found.solid) == pytest.approx(-0.3 - edge)


def test_that_an_arm_that_overhangs_rests_on_what_is_below_it_alone():
    """Above 4 m the wall goes on along itself and in front of nothing: what it stands on has its face at 0."""
    solids = [elevation(0.0, 5.0, 0.0, 4.0, 0.0, 0.6), elevation(0.0, 5.0, 4.0, 9.0, 0.0, 0.6)]
    solids += [elevation(5.0, 8.0, 4.0, 9.0, -0.25, 0.35), elevation(6.0, 6.5, 0.0, 3.0, -0.6, 0.0)]
    with pytest.raises(InputError) as refused:  # the pier in front stands apart
        checked(BASE | {"length_m": 5.0, "solid": solids})
    assert refused.value.code == "body_in_pieces"
    whole = parse_wall(BASE | {"length_m": 5.0, "solid": solids[:3]})
    part, alone = cut_above_hinge(whole, 4.0), BASE | {"height_m": 5.0, "length_m": 5.0, "base_z_m": 4.0}
    own = [elevation(0.0, 5.0, 0.0, 5.0, 0.0, 0.6), elevation(5.0, 8.0, 0.0, 5.0, -0.25, 0.35)]
    for solid in own:
        solid["polygon_m"] = [[s, z] for s, z in solid["polygon_m"]]
    expected = parse_wall(alone | {"solid": own})
    assert part.block().slenderness == pytest.approx(expected.block().slenderness, rel=1e-12)
    assert part.thickness == pytest.approx(0.6)


def test_that_a_wedge_drawn_as_a_solid_begins_at_the_hinge_as_the_short_form_does():
    wedge = section((0.6, 1.0), (2.6, 9.0), (0.6, 9.0)) | {"to_m": 0.8}
    written = parse_wall(BASE | {"solid": [box(0.0, 0.6, 0.0, 9.0), wedge]})
    lower, upper = section((0.6, 1.0), (1.6, 5.0), (0.6, 5.0)), section((0.6, 5.0), (1.6, 5.0), (2.6, 9.0), (0.6, 9.0))
    cut = parse_wall(BASE | {"solid": [box(0.0, 0.6, 0.0, 9.0), lower | {"to_m": 0.8}, upper | {"to_m": 0.8}]})
    short = BASE | {"return_wedges": {"number": 2, "thickness_m": 0.4, "length_at_top_m": 2.0, "from_z_m": 1.0}}
    for hinge in (0.0, 0.5, 2.0, 5.0):
        first, second = cut_above_hinge(written, hinge).block(), cut_above_hinge(parse_wall(short), hinge).block()
        assert first.slenderness == pytest.approx(second.slenderness, rel=1e-12)
        assert first.radius == pytest.approx(second.radius, rel=1e-12)
        assert cut_above_hinge(cut, hinge).block().slenderness == pytest.approx(first.slenderness, rel=1e-12)


def test_that_a_step_as_thick_as_the_wall_takes_no_wedge_off_it():
    wedges = BASE | {"return_wedges": {"number": 2, "thickness_m": 0.4, "length_at_top_m": 2.0, "from_z_m": 1.0}}
    stepped = checked(wedges | {"steps": [{"from_z_m": 4.0, "thickness_m": 0.6}]})
    assert stepped.block().slenderness == pytest.approx(checked(wedges).block().slenderness, rel=1e-12)


CUT = BASE | {"thickness_m": 0.6}
REFUSED = {
    "a cavity from the foot to the top": (
        "body_of_leaves",
        [elevation(0.0, 5.0, 0.0, 9.0, 0.0, 0.6), elevation(0.2, 4.8, 0.0, 9.0, 0.2, 0.4, opening=True)],
    ),
    "two leaves with ties at their ends": (
        "body_of_leaves",
        [elevation(0.0, 5.0, 0.0, 9.0, 0.0, 0.2), elevation(0.0, 5.0, 0.0, 9.0, 0.4, 0.6)]
        + [elevation(s, s + 0.3, 0.0, 9.0, 0.2, 0.4) for s in (0.0, 4.7)],
    ),
    "leaves apart": (
        "body_in_pieces",
        [elevation(0.0, 5.0, 0.0, 9.0, 0.0, 0.6), elevation(0.0, 5.0, 0.0, 9.0, 0.2, 0.4, opening=True)],
    ),
    "a slot from the foot to the top": (
        "body_in_pieces",
        [elevation(0.0, 5.0, 0.0, 9.0, 0.0, 0.6), elevation(2.0, 2.1, 0.0, 9.0, 0.0, 0.6, opening=True)],
    ),
    "two halves": (
        "body_in_pieces",
        [elevation(0.0, 2.0, 0.0, 9.0, 0.0, 0.6), elevation(2.1, 5.0, 0.0, 9.0, 0.0, 0.6)],
    ),
    "40 m of return walls": (
        "wedges_too_long",
        [elevation(0.0, 5.0, 0.0, 9.0, 0.0, 0.6), section((0.6, 0.0), (2.0, 9.0), (0.6, 9.0)) | {"to_m": 40.0}],
    ),
    "a flat crack": (
        "solid_too_far",
        [elevation(0.0, 5.0, 0.0, 9.0, 0.0, 0.6), section((0.6, 0.0), (12.0, 9.0), (0.6, 9.0)) | {"to_m": 1.0}],
    ),
    "an oblique wall within the wall": (
        "solids_overlap",
        [
            elevation(0.0, 5.0, 0.0, 9.0, 0.0, 0.6),
            {"plane": "oblique", "angle_deg": 45.0, "polygon_m": [[0, 0], [2, 0], [2, 9], [0, 9]], "to_m": 0.4},
        ],
    ),
}


@pytest.mark.shows("bodies.refused")
@pytest.mark.parametrize("name", REFUSED)
def test_that_what_is_no_body_or_weighs_twice_is_refused(name):
    code, solids = REFUSED[name]
    with pytest.raises(InputError) as refused:
        checked(CUT | {"solid": solids})
    assert refused.value.code == code


@pytest.mark.parametrize("front", ["along the wall", "oblique"])
def test_that_a_cavity_that_narrows_to_nothing_makes_leaves_as_one_of_the_same_width(front):
    """Two leaves that meet at one end of the wall alone, 11 degrees between them; either may be the outer one."""
    cosine, sine = np.cos(np.radians(79.0)), np.sin(np.radians(79.0))
    corners = [[0.0, 0.0], [5.0, 0.0], [5.0, 9.0], [0.0, 9.0]]
    leaf = {"plane": "oblique", "polygon_m": corners, "angle_deg": 79.0, "from_m": -0.1, "to_m": 0.0}
    if front == "oblique":
        meeting = 0.1 * sine + 5.0 * cosine
        solids = [leaf | {"x0_m": 0.1 * sine}, elevation(0.0, 5.0, 0.0, 9.0, meeting, meeting + 0.1)]
    else:
        mirrored = {"polygon_m": [[-s, z] for s, z in corners], "angle_deg": -79.0, "x0_m": 0.05 + 5.0 * cosine}
        solids = [elevation(0.0, 5.0, 0.0, 9.0, 0.0, 0.05), leaf | mirrored]
    with pytest.raises(InputError) as refused:
        checked(BASE | {"thickness_m": 1.1, "solid": solids})
    assert refused.value.code == "body_of_leaves"


def test_that_a_flue_a_slot_below_a_lintel_and_a_pair_of_return_walls_are_one_body():
    wall = elevation(0.0, 5.0, 0.0, 9.0, 0.0, 0.6)
    for more in (
        elevation(1.0, 1.3, 0.0, 9.0, 0.2, 0.45, opening=True),
        elevation(2.0, 2.1, 0.0, 8.5, 0.0, 0.6, opening=True),
        section((0.6, 0.0), (2.6, 9.0), (0.6, 9.0)) | {"to_m": 0.8},
        elevation(0.0, 0.5, 0.0, 9.0, 0.6, 3.0),
    ):
        assert checked(CUT | {"solid": [wall, more]}).block().slenderness > 0.0


def test_that_pieces_above_a_hinge_are_walls_of_their_own():
    """Two towers above 4 m: neither overturns with the other."""
    solids = [elevation(0.0, 5.0, 0.0, 4.0, 0.0, 0.6)]
    solids += [elevation(s, s + 1.0, 4.0, 9.0, 0.0, 0.6) for s in (0.0, 4.0)]
    wall = checked(CUT | {"solid": solids})
    with pytest.raises(InputError) as refused:
        cut_above_hinge(wall, 4.0)
    assert refused.value.code == "pieces_above" and "4 m" in str(refused.value)
    cut_above_hinge(wall, 3.0)


@pytest.mark.shows("bodies.above")
def test_that_sills_and_lintels_are_usual_hinges():
    openings = [{"s_m": 1.0, "z_m": 1.0, "width_m": 1.2, "height_m": 1.5}]
    found = default_hinges(parse_wall(BASE | {"openings": openings}), None)
    assert found == pytest.approx((1.0, 2.5))
    window = {"plane": "elevation", "polygon_m": [[1, 1], [3, 1.05], [3, 2], [2, 3], [1, 2]], "to_m": 0.6}
    pointed = checked(BASE | {"solid": [elevation(0.0, 5.0, 0.0, 9.0, 0.0, 0.6), window | {"opening": True}]})
    assert default_hinges(pointed, None) == pytest.approx((1.0, 3.0))
    rose = [{"s_m": 2.5, "z_m": 4.0, "diameter_m": 2.0}]
    assert default_hinges(checked(BASE | {"openings": rose}), None) == pytest.approx((3.0, 5.0), abs=0.01)


# found by an audit


def test_that_a_step_that_slopes_is_a_hinge_as_a_level_one():
    found = []
    for z in (2.0, 2.001, 2.2):
        outline = section((0, 0), (1, 0), (1, 9), (0.3, 9), (0.3, z), (0, 2))
        wall = checked(BASE | {"thickness_m": 1.0, "solid": [outline]})
        found.append((default_hinges(wall, None), cut_above_hinge(wall, z).block().slenderness))
        assert default_hinges(wall, None)[-1] == pytest.approx(z)
    assert found[1][1] == pytest.approx(found[0][1], rel=1e-3)


def test_that_a_pilaster_before_a_plinth_does_not_make_it_a_foot_to_stand_on():
    solids = [elevation(0.0, 10.0, 0.0, 0.09, 0.0, 0.9), elevation(0.0, 10.0, 0.09, 9.0, 0.3, 0.9)]
    solids.append(elevation(4.0, 4.1, 0.09, 9.0, 0.0, 0.3))
    with pytest.raises(InputError) as refused:
        checked(BASE | {"thickness_m": 0.9, "length_m": 10.0, "solid": solids})
    assert refused.value.code == "foot_alone"


def test_that_a_load_just_below_a_step_does_not_take_its_hinge():
    steps = [{"from_z_m": 5.0, "thickness_m": 0.4}]
    wall = {key: value for key, value in BASE.items() if key != "unloaded_confirmed"} | {"thickness_m": 0.8}
    for h in (4.94, 4.97, 5.0, 5.03):
        load = {"kind": "vertical", "kn_m": 10.0, "d_m": 0.2, "h_m": h, "mass": "none"}
        assert 5.0 in default_hinges(checked(wall | {"steps": steps, "load": [load]}), None)


@pytest.mark.parametrize("hinge", [0.0, 3.0, 4.5, 6.0])
def test_that_a_wedge_cut_level_in_two_is_the_wedge(hinge):
    wall = [box(0.0, 1.2, 0.0, 3.0), box(0.6, 1.2, 3.0, 9.0)]
    whole = section((1.2, 0.0), (3.2, 9.0), (1.2, 9.0)) | {"to_m": 0.8}
    cut = [section((1.2, 0.0), (2.2, 4.5), (1.2, 4.5)), section((1.2, 4.5), (2.2, 4.5), (3.2, 9.0), (1.2, 9.0))]
    blocks = [
        cut_above_hinge(checked(BASE | {"thickness_m": 1.2, "solid": [*wall, *more]}), hinge).block()
        for more in ([whole], [one | {"to_m": 0.8} for one in cut])
    ]
    assert blocks[0].slenderness == pytest.approx(blocks[1].slenderness, rel=1e-9)


def test_that_a_wall_that_leans_or_widens_inward_is_no_wedge():
    leaning = section((0, 0), (0.6, 0), (0.9, 9), (0.3, 9))
    part = cut_above_hinge(checked(BASE | {"solid": [leaning]}), 4.0)
    face = 0.3 * 4.0 / 9.0
    own = section((0, 0), (0.6, 0), (0.9 - face, 5.0), (0.3 - face, 5.0))
    alone = checked(BASE | {"height_m": 5.0, "base_z_m": 4.0, "solid": [own]})
    assert part.block().slenderness == pytest.approx(alone.block().slenderness, rel=1e-9)


def test_that_a_corbel_behind_the_wall_that_ends_at_a_hinge_is_cut_away():
    corbel = section((0.6, 3.6), (0.9, 4.0), (0.6, 4.0)) | {"to_m": 1.0}
    wall = checked(BASE | {"solid": [box(0.0, 0.6, 0.0, 9.0), corbel]})
    for hinge in (3.0, 3.8, 4.0, 6.0):
        assert cut_above_hinge(wall, hinge).block().slenderness > 0.0


def test_that_a_raking_gap_parts_a_body_and_a_frame_of_one_polygon_is_one():
    def slab(*corners):
        return {"plane": "elevation", "polygon_m": [list(c) for c in corners], "to_m": 0.6}

    apart = [slab((0, 0), (5, 0), (5, 6), (0, 3)), slab((0, 3.3), (5, 6.3), (5, 9), (0, 9))]
    with pytest.raises(InputError) as refused:
        checked(BASE | {"solid": apart})
    assert refused.value.code == "body_in_pieces"
    frame = slab((0, 0), (0.8, 0), (2.5, 7), (4.2, 0), (5, 0), (3.1, 9), (1.9, 9))
    assert checked(BASE | {"solid": [frame]}).block().slenderness > 0.0


def test_that_storeys_drawn_a_millimetre_apart_have_their_hinge():
    solids = [elevation(0.0, 5.0, 0.0, 4.0, 0.0, 0.6), elevation(0.0, 5.0, 4.0008, 9.0, 0.0, 0.5)]
    wall = checked(BASE | {"solid": solids})
    for hinge in default_hinges(wall, BUILDING):
        assert cut_above_hinge(wall, hinge).block().slenderness > 0.0


def test_that_a_ledge_inside_is_one_body_however_it_is_drawn():
    wall = elevation(0.0, 5.0, 0.0, 9.0, 0.0, 0.6)
    first = checked(BASE | {"solid": [wall, elevation(0.0, 5.0, 4.0, 4.2, 0.6, 0.9)]})
    second = checked(BASE | {"solid": [wall, section((0.6, 4.0), (0.9, 4.0), (0.9, 4.2), (0.6, 4.2))]})
    assert first.block().slenderness == pytest.approx(second.block().slenderness, rel=1e-12)


def test_that_a_foot_inside_of_a_wall_that_rocks_both_ways_is_none_to_stand_on():
    foot = section((0, 0), (0.6, 0), (0.6, 0.2), (0.4, 0.2), (0.4, 9), (0, 9))
    with pytest.raises(InputError) as refused:
        checked(BASE | {"mechanism": "two_sided", "solid": [foot]})
    assert refused.value.code == "inner_foot_alone"
    # the face is at 0.4 of 0.6 m
    assert refused.value.values == {"found": pytest.approx(0.2), "z": pytest.approx(0.45), "most": pytest.approx(0.06)}


def test_that_a_foot_alone_is_told_with_the_face_of_the_wall_behind_it():
    """A plinth of 0.9 m under a wall from 0.3 m on: a wall of 9 m is looked at 0.45 m up."""
    plinth = section((0, 0), (0.9, 0), (0.9, 9), (0.3, 9), (0.3, 0.2), (0, 0.2))
    with pytest.raises(InputError) as refused:
        checked(BASE | {"thickness_m": 0.9, "solid": [plinth]})
    assert refused.value.code == "foot_alone"
    assert refused.value.values == {"found": pytest.approx(0.3), "z": pytest.approx(0.45), "most": pytest.approx(0.09)}


def refused_or_built(solids, code):
    """The values of the refusal by this code; None for a body that is built where no code is expected."""
    if code is None:
        assert checked(BASE | {"solid": solids}).block().slenderness > 0.0
        return None
    with pytest.raises(InputError) as refused:
        checked(BASE | {"solid": solids})
    assert refused.value.code == code
    return refused.value.values


@pytest.mark.parametrize(("middle", "code"), [(2.5, None), (2.49, "foot_short")])
def test_that_the_outer_hinge_carries_half_of_the_base_at_least(middle, code):
    """A wall of 5 m whose second part recedes by 0.3 m."""
    solids = [elevation(0.0, middle, 0.0, 9.0, 0.0, 0.6), elevation(middle, 5.0, 0.0, 9.0, 0.3, 0.6)]
    values = refused_or_built(solids, code)
    assert code is None or values == {"found": pytest.approx(2.49), "whole": pytest.approx(5.0)}


@pytest.mark.parametrize(("start", "code"), [(0.5, "planes_overlap"), (0.6, None)])
def test_that_a_return_wall_drawn_into_the_wall_weighs_twice_and_is_refused(start, code):
    behind = section((0.0, 0.0), (1.0, 0.0), (1.0, 9.0), (0.0, 9.0)) | {"to_m": 0.5, "x0_m": start}
    solids = [elevation(0.0, 5.0, 0.0, 9.0, 0.0, 0.6), behind]
    refused_or_built(solids, code)


@pytest.mark.parametrize(("slot", "gap", "code"), [(0.9, 2.9, None), (1.1, 3.1, "body_in_pieces")])
def test_that_a_joint_drawn_open_by_millimetres_parts_no_wall(slot, gap, code):
    """An opening from the foot to the top wider than 1 mm parts it, two solids drawn farther than 3 mm apart do."""
    whole, beside = elevation(0.0, 5.0, 0.0, 9.0, 0.0, 0.6), elevation(0.0, 2.0, 0.0, 9.0, 0.0, 0.6)
    for solids in (
        [whole, elevation(2.0, 2.0 + 1e-3 * slot, 0.0, 9.0, 0.0, 0.6, opening=True)],
        [beside, elevation(2.0 + 1e-3 * gap, 5.0, 0.0, 9.0, 0.0, 0.6)],
    ):
        if code is None:
            assert checked(BASE | {"solid": solids}).block().slenderness > 0.0
            continue
        with pytest.raises(InputError) as refused:
            checked(BASE | {"solid": solids})
        assert refused.value.code == code


@pytest.mark.parametrize(("cavity", "gap", "code"), [(0.9, 2.9, None), (1.1, 3.1, "body_of_leaves")])
def test_that_a_joint_along_the_wall_open_by_millimetres_makes_no_leaves_of_it(cavity, gap, code):
    """From the foot to the top, closed at its ends: an opening up to 1 mm wide, or two solids up to 3 mm apart."""
    outer, behind = elevation(0.0, 5.0, 0.0, 9.0, 0.0, 0.3), elevation(0.0, 5.0, 0.0, 9.0, 0.3 + 1e-3 * gap, 0.6)
    ties = [elevation(s, s + 0.3, 0.0, 9.0, 0.3, 0.3 + 1e-3 * gap) for s in (0.0, 4.7)]
    slot = elevation(0.3, 4.7, 0.0, 9.0, 0.3, 0.3 + 1e-3 * cavity, opening=True)
    for solids in ([elevation(0.0, 5.0, 0.0, 9.0, 0.0, 0.6), slot], [outer, behind, *ties]):
        refused_or_built(solids, code)


def test_that_a_body_in_the_making_has_no_hinges_and_no_error():
    """Two corners of a polygon, as a form has them: nothing stands yet."""
    from core.wall.solids import Part, changes

    half = Part(((0.0, 0.0), (4.0, 0.0)), (0.0, 0.5), 0.5 * np.pi, 0.0, 18.0, "elevation")
    assert changes((half,)) == ()


def test_that_a_solid_keeps_the_unit_weight_it_states_and_another_that_of_the_wall_above_any_hinge():
    """Another weight of the wall moves all hinges alike: what states its own keeps it, at the base and above."""
    stated = box(0.0, 0.6, 0.0, 9.0) | {"to_m": 2.0, "unit_weight_kn_m3": 18.0}
    left = box(0.0, 0.6, 0.0, 9.0) | {"from_m": 2.0, "to_m": 5.0}
    wall = parse_wall(BASE | {"solid": [stated, left]})
    for hinge in (0.0, 3.0):
        part = cut_above_hinge(wall, hinge)
        lighter = replace(part, unit_weight_kn_m3=13.0)
        high = 9.0 - hinge
        assert part.in_si.weight * 5.0 == pytest.approx(18e3 * 0.6 * 5.0 * high)
        assert lighter.in_si.weight * 5.0 == pytest.approx((18e3 * 2.0 + 13e3 * 3.0) * 0.6 * high)
