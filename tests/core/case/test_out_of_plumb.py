"""A wall out of plumb: worked values, the solids it writes, its limits, what it refuses."""

import math

import pytest

from core.case.rules import parse_case
from core.errors import InputError
from core.setting.check_input import make_rocking_model


def wall_of(height=7.0, thickness=0.83, mechanism="both", **more):
    table = {"name": "w", "mechanism": mechanism, "height_m": height, "thickness_m": thickness, "length_m": 4.0}
    return parse_case({"wall": [table | {"unit_weight_kn_m3": 18.0} | more]}).wall[0]


@pytest.mark.shows("bodies.plumb")
@pytest.mark.parametrize(
    ("sizes", "outer", "inner", "ratio"),
    [
        ((7.0, 0.83, 0.10), (5.9536, 2.08834), (7.5678, 2.08486), 0.45338),
        ((3.0, 0.45, 0.06), (7.4069, 4.85525), (9.6480, 4.84103), 0.42638),
        ((11.0, 0.90, 0.15), (3.9005, 1.33343), (5.4526, 1.33196), 0.47602),
    ],
)
def test_that_a_wall_out_of_plumb_has_the_worked_values(sizes, outer, inner, ratio):
    height, thickness, lean = sizes
    wall = wall_of(height, thickness, out_of_plumb_m=lean)
    model = make_rocking_model(wall, "two_sided")
    for side, (angle, p2) in ((model, outer), (model.other, inner)):
        assert math.degrees(side.slenderness) == pytest.approx(angle, abs=5e-5)
        assert side.p2 == pytest.approx(p2, abs=5e-6)
    assert math.tan(model.slenderness) == pytest.approx((thickness - lean) / height, rel=1e-12)
    assert wall.restitution_of("one_sided").ratio_at_rest == pytest.approx(ratio, abs=5e-6)


def test_that_it_is_the_body_of_its_solids_with_steps_and_the_rectangle_where_it_is_plumb():
    lean, steps = 0.12, [{"from_z_m": 4.0, "thickness_m": 0.6, "flush": "inner"}]
    short = wall_of(out_of_plumb_m=lean, steps=steps)

    def layer(first, last, low, high):
        corners = [(first, low), (last, low), (last, high), (first, high)]
        return {"plane": "section", "to_m": 4.0, "polygon_m": [[x - lean * z / 7.0, z] for x, z in corners]}

    written = wall_of(solid=[layer(0.0, 0.83, 0.0, 4.0), layer(0.23, 0.83, 4.0, 7.0)])
    assert tuple(short.in_si.body) == pytest.approx(tuple(written.in_si.body), rel=1e-14)
    plumb = wall_of(out_of_plumb_m=0.0)
    assert plumb.parts == () and make_rocking_model(plumb, "two_sided") == make_rocking_model(wall_of(), "two_sided")


def test_that_to_lean_outward_never_helps_and_above_a_hinge_the_wall_leans_as_it_did():
    angles = [make_rocking_model(wall_of(out_of_plumb_m=f), "one_sided").slenderness for f in (0.0, 0.05, 0.1, 0.2)]
    assert angles == sorted(angles, reverse=True)
    from core.case.above_hinge import cut_above_hinge

    upper = cut_above_hinge(wall_of(mechanism="one_sided", out_of_plumb_m=0.14), 3.5)
    assert upper.out_of_plumb_m is None
    assert math.tan(make_rocking_model(upper, "one_sided").slenderness) == pytest.approx((0.83 - 0.07) / 3.5, rel=1e-12)


@pytest.mark.parametrize(
    ("more", "code"),
    [
        ({"gable_m": 1.0}, "plumb_refuses"),
        ({"openings": [{"s_m": 1.0, "z_m": 1.0, "width_m": 1.0, "height_m": 1.0}]}, "plumb_refuses"),
        ({"return_wedges": {"number": 2, "thickness_m": 0.4, "length_at_top_m": 1.0}}, "plumb_refuses"),
        ({"mechanism": "vertical_bending"}, "bending_rectangle"),
        ({"out_of_plumb_m": 0.9}, "body_falls"),
        ({"out_of_plumb_m": -0.05}, "not_accepted"),  # what leans inward counts as plumb: it would lift zeta
    ],
)
def test_that_what_it_does_not_go_with_is_a_sentence(more, code):
    with pytest.raises(InputError) as refused:
        wall_of(**({"mechanism": "one_sided", "out_of_plumb_m": 0.1} | more))
    assert refused.value.code == code


def test_that_the_length_and_the_weight_it_needs_are_asked_for():
    table = {"name": "w", "mechanism": "one_sided", "height_m": 7.0, "thickness_m": 0.8, "out_of_plumb_m": 0.1}
    with pytest.raises(InputError) as refused:
        parse_case({"wall": [table]})
    assert refused.value.code == "solids_need"
