"""Loads a wall cannot have or carry are refused in one sentence."""

import numpy as np
import pytest

from core.case.rules import parse_case
from core.errors import InputError
from core.wall.wall_loads import hinge_inside, largest_tie_share
from tests.validation.test_loaded_walls import PUSHING, ROOF, THRUST, TIE, WALL, case_of

ACROSS = {"number": 2, "thickness_m": 0.5, "brick_height_m": 0.25, "brick_length_m": 0.2}

REFUSED = [
    ("loads_need_weight", (ROOF,), {"unit_weight_kn_m3": None}),
    ("loads_contradict", (ROOF,), {"unloaded_confirmed": True}),
    ("load_mass_missing", ({**ROOF, "mass": None},), {}),
    ("load_mass_refused", ({**TIE, "mass": "moving"},), {}),
    ("load_mass_refused", ({"kind": "carried_mass", "kn_m": 1.0, "d_m": 0.2, "h_m": 3.0, "mass": "none"},), {}),
    ("load_distance_missing", ({**ROOF, "d_m": None},), {}),
    ("load_outside", ({**ROOF, "d_m": 0.46},), {}),
    ("load_outside", ({**ROOF, "h_m": 3.01},), {}),
    ("load_outside", (ROOF,), {"tie_height_m": 3.5}),
    ("unstable_under_loads", ({**THRUST, "kn_m": 6.0},), {}),
    ("moving_mass_off_centre", (PUSHING,), {"mechanism": "two_sided"}),
    ("two_sided_loads_rigid", (ROOF,), {"mechanism": "two_sided", "law": "doherty"}),
    ("tie_too_strong", (ROOF, {**TIE, "kn_m": 12.0}), {}),
    ("collapse_too_far", ({**TIE, "kn_m": 40.0},), {}),
    ("return_walls_need_length", (), {"return_walls": ACROSS}),
    ("holds_one_side", (), {"return_walls": ACROSS, "length_m": 5.0, "mechanism": "two_sided"}),
    ("return_walls_too_many", (), {"return_walls": {**ACROSS, "number": 11}, "length_m": 5.0}),
    ("holds_one_side", (TIE,), {"mechanism": "both"}),
    ("holds_one_side", (), {"tie_height_m": 2.0, "mechanism": "two_sided"}),
]  # fmt: skip


@pytest.mark.parametrize(("code", "loads", "changes"), REFUSED)
def test_that_loads_a_wall_cannot_have_are_refused(code, loads, changes):
    wall = {**WALL, **changes}
    wall = {key: value for key, value in wall.items() if value is not None}
    table = [{key: part for key, part in load.items() if part is not None} for load in loads]
    with pytest.raises(InputError) as caught:
        parse_case({"wall": [wall | ({"load": table} if table else {})]})
    error = caught.value
    assert error.code == code
    for language in ("en", "it"):
        text = error.text(language)
        assert '"w"' in text and "\n" not in text and "{" not in text


@pytest.mark.parametrize("bad", [
    {"kind": "wind", "kn_m": 1.0, "h_m": 1.0}, {"kind": "tie", "kn_m": 0.0, "h_m": 1.0},
    {"kind": "tie", "kn_m": float("nan"), "h_m": 1.0}, {"kind": "tie", "h_m": 1.0},
    {"kind": "tie", "kn_m": 1.0, "h_m": 0.0}, {"kind": "tie", "kn_m": 1.0, "h_m": 1.0, "height": 2.0},
    "roof", 3,
])  # fmt: skip
def test_that_a_load_that_is_none_is_refused(bad):
    with pytest.raises(InputError):
        parse_case({"wall": [{**WALL, "load": [bad]}]})


def test_that_the_largest_tie_is_where_the_resultant_of_a_section_leaves_the_wall():
    """At the multiplier lambda that uplifts the wall the moment of the part above y about the middle of the wall is
    lambda w t (H - y)^2 / 2 - F (h - y) - N (d - t/2), its weight w t (H - y) + N: beyond N' t/2 it hinges there."""
    strong = case_of(ROOF, {**TIE, "kn_m": 8.69}).wall[0]
    assert hinge_inside(strong) is None
    force, weight = 8.7, 24.3
    push = (weight * 0.225 + 10.0 * 0.30 + force * 2.8) / (weight * 1.5)
    worst = 0.0
    for k in range(1, 3000):
        y = 0.001 * k
        part = weight * (1.0 - y / 3.0)
        moment = 0.5 * push * part * (3.0 - y) - 10.0 * (0.30 - 0.225)
        if y < 2.8:
            moment -= force * (2.8 - y)
        worst = max(worst, abs(moment) / ((part + 10.0) * 0.225))
    assert worst == pytest.approx(1.0, abs=0.002)
    with pytest.raises(InputError) as caught:
        case_of(ROOF, {**TIE, "kn_m": 9.0})
    assert caught.value.values["most"] == pytest.approx(8.696, abs=0.01)
    assert largest_tie_share(strong) > 0.999


def test_that_a_tie_does_not_push_a_wall_inward():
    """Without the restraint behind, a tie slackens when the wall turns inward."""
    _, bare = case_of(ROOF).wall[0].restoring()
    _, tied = case_of(ROOF, TIE).wall[0].restoring()
    assert tied == bare


def test_that_sides_alike_but_for_rounding_are_alike():
    random = np.random.default_rng(3)
    for d in random.uniform(0.0, 0.45, 200):
        pair = (
            {**ROOF, "d_m": float(d), "kn_m": 3.0},
            {**ROOF, "d_m": float(0.45 - d), "kn_m": 3.0},
        )
        outward, inward = case_of(*pair, mechanism="two_sided", law="doherty").wall[0].restoring()
        assert outward == inward


def test_that_the_strength_of_the_masonry_moves_hinge_and_largest_tie():
    """u = 2 N / (3 f) with the loads in N."""
    wall = case_of(ROOF, hinge_setback_m=0.0, compressive_strength_mpa=1.0).wall[0]
    assert wall.setback == pytest.approx(2.0 * 34.3e3 / 3e6, rel=1e-12)
    with pytest.raises(InputError) as caught:
        case_of(ROOF, {**TIE, "kn_m": 9.0}, compressive_strength_mpa=1.0)
    assert caught.value.values["most"] < 8.69


def test_that_a_wall_that_pushes_a_roof_is_asked_for_no_velocity_ratio():
    wall = {key: value for key, value in WALL.items() if key != "velocity_ratio"}
    case = parse_case({"wall": [{**wall, "load": [PUSHING]}]})
    pushed = case.wall[0]
    alone = parse_case({"wall": [wall]}).wall[0]
    found = pushed.restitution_of("one_sided")
    assert found.model == "one_sided_theoretical"
    assert 0.0 < found.ratio_at_rest < 1.0
    assert found.ratio_at_rest != alone.restitution_of("one_sided").ratio_at_rest
