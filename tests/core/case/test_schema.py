"""What a case means: defaults, geometry, return period."""

from dataclasses import fields

import pytest

from core.case.rules import parse_case
from core.case.schema import sections
from tests.core.case.tables import case, without


def test_that_defaults_follow_the_mechanism():
    both = parse_case(case({"mechanism": "both"})).wall[0]
    assert both.mechanisms() == ("two_sided", "one_sided")
    assert both.restitution_of("two_sided").model == "housner"
    assert both.restitution_of("one_sided").model == "one_sided_theoretical"
    given = parse_case(case({"velocity_ratio": 0.9})).wall[0]
    assert given.restitution_of("two_sided").ratio_at_rest == 0.9


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
