"""Limits of a shape and what its refusal says. Bodies that stand are in tests/validation/test_bodies.py."""

import math

import pytest

from core.case.rules import parse_case
from core.errors import InputError

WALL = {"name": "w", "mechanism": "one_sided", "height_m": 9.0, "thickness_m": 0.6, "length_m": 5.0}
WALL |= {"unit_weight_kn_m3": 18.0}


def box(s0: float, s1: float, z0: float, z1: float, inner: float = 0.6, **more) -> dict:
    corners = [[s0, z0], [s1, z0], [s1, z1], [s0, z1]]
    return {"plane": "elevation", "polygon_m": corners, "to_m": inner} | more


def wall_of(*solids: dict, **more):
    return parse_case({"wall": [WALL | {"solid": list(solids)} | more]}).wall[0]


@pytest.mark.parametrize(("beyond", "code"), [(1e-9, None), (3e-9, "opening_outside")])
def test_that_an_opening_is_through_a_wall_but_for_the_rounding_of_its_sizes(beyond, code):
    solids = box(0.0, 5.0, 0.0, 9.0), box(1.0, 2.0, 1.0, 2.0, inner=0.6 + beyond, opening=True)
    if code is None:
        assert wall_of(*solids).block().slenderness > 0.0
        return
    with pytest.raises(InputError) as refused:
        wall_of(*solids)
    assert refused.value.code == code and refused.value.values == {"s": 1.0, "z": 1.0}


@pytest.mark.parametrize(("beyond", "code"), [(4e-6, None), (6e-6, "opening_outside")])
def test_that_an_opening_leaves_its_wall_by_a_micron_of_its_width_and_height_at_most(beyond, code):
    """Of 4 x 1 m by 5e-6 m2: an end 1 m high may be 5e-6 m outside."""
    solids = box(0.0, 5.0, 0.0, 9.0), box(1.0 + beyond, 5.0 + beyond, 4.0, 5.0, opening=True)
    if code is None:
        assert wall_of(*solids).block().slenderness > 0.0
        return
    with pytest.raises(InputError) as refused:
        wall_of(*solids)
    assert refused.value.code == code


def oblique(angle: float, **more) -> dict:
    """A wedge of a wall 0.3 m thick: 1 m long at its foot, 10 m at its top."""
    corners = [[0, 0], [1, 0], [10, 9], [0, 9]]
    return {"plane": "oblique", "angle_deg": angle, "polygon_m": corners, "to_m": 0.3} | more


@pytest.mark.parametrize("angle", [3.0, 30.0])
def test_that_the_inner_hinge_of_a_corner_is_within_the_thickness_of_its_walls_along_the_motion(angle):
    """0.3 m at this angle from the motion is 0.3 / sin long there: 5.73 m at 3 degrees, and 0.6 m at 30 where the foot
    reaches farther in."""
    foot = math.cos(math.radians(angle)) + 0.3 * math.sin(math.radians(angle))
    most = max(foot, 0.3 / math.sin(math.radians(angle)))
    with pytest.raises(InputError) as refused:
        wall_of(oblique(angle), thickness_m=most + 0.01, length_m=0.5)
    assert refused.value.code == "base_beyond_body"
    assert refused.value.values == {"found": most + 0.01, "most": pytest.approx(most)}
    assert wall_of(oblique(angle), thickness_m=most - 0.01, length_m=0.5).block().slenderness > 0.0


def test_that_a_section_beside_an_oblique_wall_reaches_as_far_in_as_it_is():
    """1.5 m of a section along the motion, its foot 1 m: the inner hinge is not beyond 1.5 m."""
    corners = [[0, 0], [1, 0], [1.5, 9], [0, 9]]
    section = {"plane": "section", "polygon_m": corners, "from_m": -0.5, "to_m": 0.0}
    short = oblique(30.0) | {"polygon_m": [[0, 0], [1, 0], [1, 9], [0, 9]]}
    with pytest.raises(InputError) as refused:
        wall_of(section, short, thickness_m=1.51, length_m=0.5)
    assert refused.value.code == "base_beyond_body"
    assert refused.value.values["most"] == pytest.approx(1.5)


def test_that_a_step_to_the_same_thickness_leaves_the_face_its_wedges_hang_on():
    wedges = {"number": 2, "thickness_m": 0.4, "length_at_top_m": 2.0}
    wall = WALL | {"return_wedges": wedges, "steps": [{"from_z_m": 3.0, "thickness_m": 0.6}]}
    assert parse_case({"wall": [wall]}).wall[0].block().slenderness > 0.0
