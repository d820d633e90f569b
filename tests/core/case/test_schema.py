"""What a case means: defaults, geometry, return period."""

from dataclasses import fields, replace

import pytest

from core.case.keys import format_unit, unit_in_form
from core.case.rules import parse_case, parse_wall
from core.case.schema import Analysis, Wall, sections
from core.case.values import field_of
from core.errors import InputError
from tests.core.case.tables import case, without


@pytest.mark.shows("case.ways")
def test_that_defaults_follow_the_mechanism():
    both = parse_case(case({"mechanism": "both"})).wall[0]
    assert both.mechanisms() == ("two_sided", "one_sided")
    assert both.restitution_of("two_sided").model == "housner"
    assert both.restitution_of("one_sided").model == "one_sided_theoretical"
    given = parse_case(case({"velocity_ratio": 0.9})).wall[0]
    assert given.restitution_of("two_sided").ratio_at_rest == 0.9


@pytest.mark.shows("case.ways")
def test_that_three_ways_to_write_a_wall_are_one_block():
    import math

    ways = [
        {"thickness_m": 0.83},
        {"slenderness_deg": math.degrees(math.atan2(0.83, 7.0))},
        {"height_over_thickness": 7.0 / 0.83},
    ]
    blocks = [parse_case({"wall": [{**without("thickness_m")["wall"][0], **way}]}).wall[0].block() for way in ways]
    for block in blocks[1:]:
        assert block.slenderness == pytest.approx(blocks[0].slenderness, rel=1e-14)
        assert block.radius == pytest.approx(blocks[0].radius, rel=1e-14)


GENERAL = {"slenderness_deg": 5.0, "radius_m": 4.0, "inertia_over_mass_m2": 32.0}


def test_that_a_general_block_has_twice_the_inertia_of_its_radius_at_most():
    """I0/m of R = 4 m: 32 m2."""
    wall = {"name": "w", "mechanism": "two_sided", **GENERAL}
    assert parse_case({"wall": [wall]}).wall[0].block().inertia_over_mass == 32.0
    with pytest.raises(InputError) as caught:
        parse_case({"wall": [{**wall, "inertia_over_mass_m2": 32.01}]})
    assert caught.value.code == "inertia_too_large"
    assert caught.value.values == {"given": 32.01, "most": pytest.approx(32.0), "ratio": 2.0}


def test_that_what_gives_the_block_of_a_wall_is_not_to_be_emptied_in_its_form():
    for name in (*GENERAL, "height_m", "thickness_m", "height_over_thickness"):
        assert field_of(Wall, name).metadata["filled"], name


def test_that_the_weight_of_a_wall_needs_its_length_its_thickness_and_its_unit_weight():
    """7.0 x 0.83 x 4 m of 18 kN/m3: 418.3 kN."""
    sizes = {"length_m": 4.0, "unit_weight_kn_m3": 18.0}
    assert parse_case(case(sizes)).wall[0].weight == pytest.approx(418320.0, rel=1e-14)
    for key in sizes:
        left = {name: value for name, value in sizes.items() if name != key}
        assert parse_case(case(left)).wall[0].weight is None
    assert parse_wall({"name": "w", "mechanism": "two_sided", **GENERAL, **sizes}).weight is None


def test_that_the_hinge_is_two_thirds_of_the_weight_over_the_strength_and_the_length_inside():
    """18 x 0.83 x 7 = 104.58 kN/m on 2 MPa: 2 x 104.58 / (3 x 2000) m."""
    wall = parse_case(case({"unit_weight_kn_m3": 18.0, "compressive_strength_mpa": 2.0})).wall[0]
    assert wall.setback == pytest.approx(0.03486, rel=1e-12)


@pytest.mark.parametrize(("masonry", "weight"), [("solid_brick", 18.0), ("regular_soft_stone", None)])
def test_that_a_type_of_masonry_gives_the_unit_weight_where_its_table_has_one(masonry, weight):
    """Table C8.5.I: 18 kN/m3 of solid brick, 13 to 16 kN/m3 of soft stone."""
    assert parse_case(case({"masonry": masonry})).wall[0].unit_weight_kn_m3 == weight
    assert parse_case(case({"masonry": masonry, "unit_weight_kn_m3": 14.0})).wall[0].unit_weight_kn_m3 == 14.0


def test_that_two_cases_of_the_same_keys_are_the_same_wherever_they_were_read():
    one = parse_case(case({}))
    read = {"sha256": "0", "given": frozenset({("wall", 0, "name")}), "table": "walls.csv", "table_notes": (1,)}
    assert replace(one, **read, drawings=(1,), drawn_from=("a.dxf",), source="# a comment") == one
    assert replace(one, title="another") != one


@pytest.mark.shows("demand.return_period")
@pytest.mark.parametrize(
    ("demand", "years"),
    [
        ({"nominal_life_years": 50, "use_class_factor": 1.0}, 474.56),
        ({"nominal_life_years": 50, "use_class_factor": 1.5, "limit_state": "SLC"}, 1462.2),
        ({"nominal_life_years": 50, "use_class_factor": 1.0, "limit_state": "SLD"}, 50.29),
        ({"nominal_life_years": 50, "use_class_factor": 1.0, "return_period_years": 475}, 475.0),
        ({"limit_state": "SLC", "return_period_years": 975}, 975.0),
        (
            {"limit_state": "SLC", "nominal_life_years": 100, "use_class_factor": 1.5, "return_period_years": 2475},
            2475.0,
        ),
        (
            {"limit_state": "SLC", "nominal_life_years": 75, "use_class_factor": 1.3, "return_period_years": 1901},
            1901.0,
        ),
        ({}, None),
    ],
)
def test_that_t_r_follows_from_v_n_and_c_u(demand, years):
    found = parse_case(case(demand={"ag_g": 0.2, **demand})).demand.return_period
    assert found == (None if years is None else pytest.approx(years, rel=1e-4))


def test_that_the_unit_of_a_key_is_the_end_of_its_name():
    entries = [entry for section in sections().values() for entry in fields(section)]
    units = {entry.metadata["unit"] for entry in entries if entry.metadata.get("unit")}
    ends = {"_" + unit.lower().replace("/", "_"): unit for unit in units}
    for entry in entries:
        if entry.metadata["kind"] in ("float", "int", "range"):
            end = max((end for end in ends if f"_{entry.name}".endswith(end)), key=len, default="")
            assert entry.metadata["unit"] == ends.get(end, ""), entry.name


@pytest.mark.parametrize(
    ("section", "key", "unit", "factor"),
    [
        (Wall, "slenderness_deg", "°", 1.0),
        (Wall, "height_m", "m", 1.0),
        (Wall, "thickness_m", "cm", 100.0),
        (Wall, "unit_weight_kn_m3", "kN/m³", 1.0),
        (Wall, "inertia_over_mass_m2", "m²", 1.0),
        (Analysis, "q_step", "%", 100.0),
        (Analysis, "q_limit", "", 1.0),
    ],
)
def test_that_a_field_has_the_unit_a_person_writes(section, key, unit, factor):
    assert unit_in_form(field_of(section, key)) == (unit, factor)


def test_that_powers_of_a_unit_are_raised_and_words_are_not():
    assert [format_unit(unit) for unit in ("deg", "kN/m3", "m2", "m/s2", "kN/m", "years", "")] == [
        "°", "kN/m³", "m²", "m/s²", "kN/m", "years", ""
    ]  # fmt: skip


@pytest.mark.parametrize(("setback", "stands"), [(0.3999, True), (0.4, False), (0.4001, False)])
def test_that_a_hinge_is_set_back_by_less_than_four_tenths_of_the_thickness(setback, stands):
    wall = parse_wall({"name": "w", "mechanism": "one_sided", "height_m": 7.0, "thickness_m": 1.0,
                       "hinge_setback_m": setback})  # fmt: skip
    if stands:
        assert wall.block().slenderness > 0.0
        return
    with pytest.raises(InputError, match=f"hinge setback {setback:.3f} m is not accepted: up to 0.400 m, 40 %"):
        wall.block()


BLOCK = {"name": "w", "mechanism": "two_sided", "radius_m": 3.5, "slenderness_deg": 6.8, "inertia_over_mass_m2": 16.0}


@pytest.mark.parametrize(
    "more",
    [{"slenderness_deg": None}, {"thickness_m": 0.83}, {"height_over_thickness": 8.0}, {"height_m": 7.0}],
    ids=lambda more: " ".join(more),
)
def test_that_a_general_block_has_its_slenderness_and_nothing_of_a_rectangle(more):
    assert parse_wall(BLOCK).block().radius == 3.5
    given = {key: value for key, value in (BLOCK | more).items() if value is not None}
    with pytest.raises(InputError) as refused:
        parse_case({"wall": [given]})
    assert refused.value.code == "general_keys"
