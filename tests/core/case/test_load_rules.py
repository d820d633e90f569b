"""Loads a wall cannot have or carry are refused in one sentence."""

from dataclasses import replace

import pytest

from core.case.above_hinge import loads_above
from core.case.hinges import make_wall_parts
from core.case.load_rules import carries
from core.case.loads import Load
from core.case.rules import parse_case
from core.case.values import field_of
from core.errors import InputError
from tests.holds import carries as carried
from tests.holds import sought
from tests.validation.test_loaded_walls import INWARD, PUSHING, ROOF, THRUST, TIE, WALL, case_of

ACROSS = {"number": 2, "thickness_m": 0.5, "brick_height_m": 0.25, "brick_length_m": 0.2}

REFUSED = [
    ("loads_need_weight", (ROOF,), {"unit_weight_kn_m3": None}),
    ("loads_contradict", (ROOF,), {"unloaded_confirmed": True}),
    ("load_size_missing", ({**ROOF, "kn_m": None},), {}),
    ("load_size_missing", ({**ROOF, "kn_m": None},), {"compressive_strength_mpa": 2.0}),
    ("load_mass_missing", ({**ROOF, "mass": None},), {}),
    ("load_mass_refused", ({**THRUST, "mass": "moving"},), {}),
    ("load_mass_refused", ({"kind": "carried_mass", "kn_m": 1.0, "d_m": 0.2, "h_m": 3.0, "mass": "none"},), {}),
    ("load_distance_missing", ({**ROOF, "d_m": None},), {}),
    ("load_outside", ({**ROOF, "d_m": 0.46},), {}),
    ("load_outside", ({**ROOF, "h_m": 3.01},), {}),
    ("unstable_under_loads", ({**THRUST, "kn_m": 6.0},), {}),
    (
        "moving_mass_off_centre",
        ({**PUSHING, "kn_m": 100.0, "h_m": 3.0, "d_m": 0.45},),
        {"mechanism": "two_sided", "hinge_setback_m": 0.1},
    ),
    ("two_sided_loads_rigid", (ROOF,), {"mechanism": "two_sided", "law": "doherty"}),
    ("tie_too_strong", (ROOF, {**TIE, "out_kn_m": 12.0, "slack_mm": 1.0}), {}),
    ("collapse_too_far", ({**INWARD, "kn_m": -40.0},), {}),
    ("unknown_key", ({**THRUST, "bar_length_m": 8.0},), {}),
    ("load_size", ({**THRUST, "kn_m": 0.0},), {}),
    ("return_walls_need_length", (), {"return_walls": ACROSS}),
    ("holds_one_side", (), {"return_walls": ACROSS, "length_m": 5.0, "mechanism": "two_sided"}),
    ("return_walls_too_many", (), {"return_walls": {**ACROSS, "number": 11}, "length_m": 5.0}),
]


def wall_of(*loads, **changes):
    """The wall of 3.0 x 0.45 m and 18 kN/m3, 24.3 kN/m."""
    return case_of(*loads, **changes).wall[0]


@pytest.mark.shows("case.loads")
@pytest.mark.parametrize(("code", "loads", "changes"), REFUSED)
def test_that_loads_a_wall_cannot_have_are_refused(code, loads, changes):
    wall = {key: value for key, value in {**WALL, **changes}.items() if value is not None}
    table = [{key: part for key, part in load.items() if part is not None} for load in loads]
    with pytest.raises(InputError) as caught:
        parse_case({"wall": [carried(*table, **wall) if table else wall]})
    error = caught.value
    assert error.code == code
    for language in ("en", "it"):
        text = error.text(language)
        assert '"w"' in text and "\n" not in text and "{" not in text


KINDS = field_of(Load, "kind").metadata["names"]


@pytest.mark.parametrize("kind", KINDS)
def test_that_every_kind_of_load_is_a_weight_or_a_force_and_moves_no_other_mass(kind):
    """A kind that is neither would be a load that does nothing; a force has no mass."""
    load = Load(kind, 1.0, 1.0)
    assert load.is_weight == (kind != "thrust")
    if load.is_weight:
        return
    for mass in ("horizontal", "moving"):
        with pytest.raises(InputError) as caught:
            case_of({"kind": kind, "d_m": 0.2, "kn_m": 0.1, "h_m": 2.0, "mass": mass})
        assert caught.value.code == "load_mass_refused"


@pytest.mark.shows("ties.too_strong")
@pytest.mark.parametrize(
    ("load", "key", "sign", "where"),
    [({**TIE, "slack_mm": 1.0}, "out_kn_m", 1.0, "hold 1"), (INWARD, "kn_m", -1.0, "load 2")],
)
def test_that_neither_a_tie_nor_a_load_holds_more_than_one_rigid_block_can_take(load, key, sign, where):
    case_of(ROOF, {**load, key: 8.6 * sign})
    with pytest.raises(InputError) as caught:
        case_of(ROOF, {**load, key: 9.0 * sign})
    assert (caught.value.code, caught.value.key) == ("tie_too_strong", key) and where in caught.value.text("en")


@pytest.mark.shows("held.between")
def test_that_a_tie_that_is_stronger_makes_the_wall_bend_below_it():
    """Somewhat before turning needs more than one block takes."""
    walls = [wall_of(ROOF, {**TIE, "out_kn_m": force}) for force in (5.0, 8.0, 9.0)]
    assert [len(make_wall_parts(0, wall, None)) for wall in walls] == [1, 2, 2]


@pytest.mark.parametrize(
    "bad",
    [
        {"kind": "wind", "kn_m": 1.0, "h_m": 1.0},
        {"kind": "thrust", "kn_m": 0.0, "h_m": 1.0},
        {"kind": "vertical", "kn_m": -1.0, "h_m": 1.0, "d_m": 0.2, "mass": "none"},
        {"kind": "thrust", "kn_m": float("nan"), "h_m": 1.0},
        {"kind": "thrust", "h_m": 1.0},
        {"kind": "thrust", "kn_m": 1.0, "h_m": 0.0},
        {"kind": "thrust", "kn_m": 1.0, "h_m": 1.0, "height": 2.0},
        {"kind": "thrust", "kn_m": 1.0, "h_m": 1.0, "bar_length_m": 8.0},
        {"kind": "tie", "kn_m": 1.0, "h_m": 1.0, "bar_length_m": 8.0},
        "roof",
        3,
    ],
)
def test_that_a_load_that_is_none_is_refused(bad):
    with pytest.raises(InputError):
        parse_case({"wall": [{**WALL, "load": [bad]}]})


def test_that_loads_and_ties_above_a_hinge_are_counted_from_it():
    wall = wall_of(ROOF, TIE, THRUST)
    assert [load.h_m for load in loads_above(wall, 0.0, 0.0)] == [3.0, 2.5]
    assert [load.h_m for load in loads_above(wall, 2.5, 0.0)] == pytest.approx([0.5])
    assert loads_above(wall, 3.0, 0.0) == ()
    (tie,) = wall.ties
    assert tie.above(0.0) == tie and tie.above(2.5).h_m == pytest.approx(0.3) and tie.above(2.8) is None


def test_that_a_wall_carries_what_check_loads_takes():
    assert carries(wall_of(ROOF)) and carries(wall_of())
    (strong,) = wall_of(THRUST).load
    assert not carries(replace(wall_of(THRUST), load=(replace(strong, kn_m=6.0),)))


def test_that_limits_of_places_are_taken():
    """At the edge of the wall and on its top; a carried mass up to twice as high."""
    assert wall_of({**ROOF, "d_m": 0.45, "h_m": 3.0}) and wall_of({**ROOF, "d_m": 0.0})
    carried = {"kind": "carried_mass", "kn_m": 1.0, "d_m": 0.2, "h_m": 6.0}
    assert wall_of(carried)
    with pytest.raises(InputError) as caught:
        wall_of({**carried, "h_m": 6.01})
    assert caught.value.values["most"] == pytest.approx(6.0)
    with pytest.raises(InputError) as caught:
        wall_of({**ROOF, "h_m": 3.01})
    assert caught.value.values["most"] == pytest.approx(3.0)
    full = {**ACROSS, "number": 10}
    assert wall_of(return_walls=full, length_m=5.0)
    assert wall_of(sought(3.0))


def test_that_a_slack_tie_is_too_strong_by_its_force_at_yield():
    """The wall opens a hinge once the tie has taken up its slack."""
    assert wall_of(ROOF, {**TIE, "out_kn_m": 8.6, "slack_mm": 2.0}).ties
    with pytest.raises(InputError) as caught:
        wall_of(ROOF, {**TIE, "out_kn_m": 9.0, "slack_mm": 2.0})
    assert caught.value.code == "tie_too_strong" and caught.value.values["found"] == pytest.approx(9.0)


def test_that_a_weight_rests_on_the_masonry_at_its_height_up_to_its_faces():
    """Above 2 m the wall is there from 0.15 m to 0.45 m alone."""
    shaped = {"length_m": 4.0, "steps": [{"from_z_m": 2.0, "thickness_m": 0.3, "flush": "inner"}]}
    for d in (0.15, 0.3, 0.45):
        assert wall_of({**ROOF, "d_m": d, "kn_m": 1.0}, **shaped).load[0].d_m == d
    assert wall_of({**ROOF, "d_m": 0.14, "h_m": 1.9, "kn_m": 1.0}, **shaped).load
    with pytest.raises(InputError) as caught:
        wall_of({**ROOF, "d_m": 0.14, "kn_m": 1.0}, **shaped)
    assert caught.value.code == "load_off_body"
    assert caught.value.values == {"found": 0.14, "low": pytest.approx(0.15), "high": pytest.approx(0.45)}


def test_that_what_is_refused_says_by_how_much():
    with pytest.raises(InputError) as caught:
        wall_of({**THRUST, "kn_m": 6.0})
    # (24.3 x 0.225 - 6 x 2.5) / (24.3 x 1.5)
    assert caught.value.values["threshold"] == pytest.approx(-0.26152, abs=1e-5)
    with pytest.raises(InputError) as caught:
        wall_of({**INWARD, "kn_m": -40.0})
    assert caught.value.values["most"] == pytest.approx(60.0)
    assert 60.0 < caught.value.values["found"] < 90.0
    with pytest.raises(InputError) as caught:
        wall_of(return_walls={**ACROSS, "number": 11}, length_m=5.0)
    assert caught.value.values["found"] == pytest.approx(5.5)


def test_that_a_wall_that_pushes_a_roof_is_asked_for_no_velocity_ratio():
    wall = {key: value for key, value in WALL.items() if key != "velocity_ratio"}
    case = parse_case({"wall": [{**wall, "load": [PUSHING]}]})
    pushed = case.wall[0]
    alone = parse_case({"wall": [wall]}).wall[0]
    found = pushed.restitution_of("one_sided")
    assert found.model == "one_sided_theoretical"
    assert 0.0 < found.ratio_at_rest < 1.0
    assert found.ratio_at_rest != alone.restitution_of("one_sided").ratio_at_rest


# a weight by its parts (NTC 2018 2.5.3)

WALLED = {"name": "w", "height_m": 4.0, "thickness_m": 0.4, "mechanism": "two_sided", "unit_weight_kn_m3": 18.0}


def of_weight(**parts):
    weight = {"kind": "vertical", "h_m": 3.0, "d_m": 0.2, "mass": "none"} | parts
    return parse_case({"wall": [WALLED | {"load": [weight]}]}).wall[0].load[0]


@pytest.mark.shows("demand.psi")
def test_that_the_variable_load_counts_by_its_share():
    """8 kN/m of a floor and 2.5 kN/m of dwellings, psi_2 0.3: 8.75 kN/m."""
    assert of_weight(g_kn_m=8.0, q_kn_m=2.5, psi_2=0.3).kn_m == pytest.approx(8.75)
    assert of_weight(g_kn_m=8.0).kn_m == 8.0 and of_weight(q_kn_m=2.0, psi_2=0.6).kn_m == pytest.approx(1.2)
    assert of_weight(g_kn_m=8.0, q_kn_m=2.5, psi_2=0.3, kn_m=8.75).kn_m == 8.75


@pytest.mark.parametrize(
    ("parts", "code"),
    [
        ({"g_kn_m": 8.0, "q_kn_m": 2.5}, "combined_share"),
        ({"g_kn_m": 8.0, "psi_2": 0.3}, "combined_share"),
        ({"g_kn_m": 8.0, "q_kn_m": 2.5, "psi_2": 0.3, "kn_m": 10.5}, "combined_sum"),
        ({"kind": "thrust", "mass": None, "g_kn_m": 1.0}, "combined_weight"),
        ({"g_kn_m": 0.0}, "load_size"),
    ],
)
def test_that_parts_that_do_not_make_a_weight_are_refused(parts, code):
    given = {key: value for key, value in parts.items() if value is not None}
    with pytest.raises(InputError) as caught:
        of_weight(**given) if "mass" not in parts else of_thrust(**given)
    assert caught.value.code == code


def of_thrust(**parts):
    return parse_case({"wall": [WALLED | {"load": [{"h_m": 3.0} | parts]}]})


def test_that_a_weight_by_its_parts_is_the_weight_itself():
    parts, whole = of_weight(g_kn_m=8.0, q_kn_m=2.5, psi_2=0.3), of_weight(kn_m=8.75)
    assert parts == replace(whole, g_kn_m=8.0, q_kn_m=2.5, psi_2=0.3)
