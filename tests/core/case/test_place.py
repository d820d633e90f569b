"""[site]: the demand of a place, what agrees with it and what is refused, and that it is written as it was read."""

import math
import tomllib
from dataclasses import replace

import pytest

from core.case.place import Site, apply_site, hazard_rows
from core.case.rules import parse_case, parse_draft
from core.case.writer import dumps, table_of
from core.errors import InputError
from core.report import json_report
from core.report.place_lines import place_of, states_of
from core.study.run import run
from tests.conftest import ROOT

WALL = {"name": "w", "mechanism": "one_sided", "height_m": 5.0, "thickness_m": 0.5, "base_z_m": 0.0}
SITE = {"municipality": "L'Aquila", "latitude": 42.3498, "longitude": 13.3995, "use_class": "III"}
SPECTRUM = {"code": "NTC2018", "soil": "B", "topography": "T1"}


def case_of(place=None, **demand):
    return {"site": {**SITE, **(place or {})}, "demand": {"spectrum": SPECTRUM, **demand}, "wall": [WALL]}


@pytest.mark.shows("demand.place")
def test_that_a_place_gives_the_demand():
    case = parse_case(case_of())
    demand = case.demand
    assert demand.return_period == pytest.approx(711.84, abs=0.005)
    assert round(demand.ag_g, 4) == 0.2998 and round(demand.spectrum.f0, 4) == 2.3839
    assert demand.hazard[6].return_period_years == 140.0 and len(demand.hazard) == 13
    assert parse_case(case_of(limit_state="SLC")).demand.ag_g > demand.ag_g
    en = {"code": "EN1998", "type": 1, "soil": "B"}
    assert parse_case(case_of(spectrum=en)).demand.ag_g == demand.ag_g


@pytest.mark.shows("demand.place")
@pytest.mark.parametrize(
    ("given", "code"),
    [
        ({"ag_g": 0.25}, "site_disagrees"),
        ({"ag_g": 0.2999}, "site_disagrees"),
        ({"nominal_life_years": 75.0}, "site_disagrees"),
        ({"use_class_factor": 1.0}, "site_disagrees"),
        ({"return_period_years": 475.0}, "site_disagrees"),
        ({"hazard": [{"return_period_years": 475.0, "ag_g": 0.27}]}, "site_disagrees"),
        ({"spectrum": {**SPECTRUM, "f0": 2.5}}, "site_disagrees"),
        ({"site": "here"}, "site_gives"),
        ({"coordinates": "42 13"}, "site_gives"),
        ({"hazard_file": "x.csv"}, "site_gives"),
    ],
)
def test_that_what_contradicts_the_place_is_refused_with_both_numbers(given, code):
    with pytest.raises(InputError) as refused:
        parse_case(case_of(**given))
    assert refused.value.code == code
    if code == "site_disagrees" and "ag_g" in given:
        assert str(given["ag_g"]) in refused.value.text("en") and "0.29975" in refused.value.text("en")


@pytest.mark.parametrize(
    "given",
    [
        {"ag_g": 0.3},
        {"ag_g": 0.2998, "nominal_life_years": 50.0, "use_class_factor": 1.5},
        {"return_period_years": 712.0},
        {"hazard": [{"return_period_years": 475.0, "ag_g": 0.261, "f0": 2.364, "tc_star_s": 0.347}]},
        {"spectrum": {**SPECTRUM, "f0": 2.384, "tc_star_s": 0.356}},
    ],
)
def test_that_what_agrees_to_its_own_digits_is_taken_as_the_place_has_it(given):
    assert parse_case(case_of(**given)) == parse_case(case_of())


@pytest.mark.parametrize(
    ("site", "code"),
    [
        ({"municipality": "", "latitude": None, "longitude": None}, "site_nowhere"),
        ({"longitude": None}, "site_half_a_point"),
        ({"latitude": 48.8, "longitude": 2.3}, "site_elsewhere"),
        ({"municipality": "", "latitude": 48.8, "longitude": 2.3}, "outside_the_grid"),
        ({"municipality": "Castro", "latitude": None, "longitude": None}, "municipality_of_two"),
        ({"municipality": "Nowhere", "latitude": None, "longitude": None}, "municipality_unknown"),
        ({"use_class": "V"}, "not_accepted"),
        ({"latitude": 95.0}, "not_accepted"),
    ],
)
def test_that_a_place_that_is_none_is_refused(site, code):
    table = case_of()
    table["site"] = {key: value for key, value in {**SITE, **site}.items() if value is not None}
    with pytest.raises(InputError) as refused:
        parse_case(table)
    assert refused.value.code == code


def test_that_a_case_is_written_without_what_its_place_gives_and_reads_back_equal():
    case = parse_case(case_of())
    text = dumps(case)
    assert "ag_g" not in text and "hazard" not in text and "f0" not in text and "[site]" in text
    assert parse_case(tomllib.loads(text)) == case
    assert parse_draft(table_of(case)).demand == case.demand


def test_that_another_limit_state_or_place_gives_another_demand_in_a_draft():
    case = parse_case(case_of())
    slc = apply_site(case.site, replace(case.demand, limit_state="SLC"))
    assert slc == parse_case(case_of(limit_state="SLC")).demand
    modena = replace(case.site, municipality="Modena", latitude=44.6471, longitude=10.9252)
    assert round(apply_site(modena, case.demand).ag_g, 4) == 0.1900
    nowhere = replace(case.site, latitude=None)
    assert apply_site(nowhere, case.demand) == case.demand


def test_that_the_result_says_place_states_and_what_is_to_be_known():
    site = {"nominal_life_years": 100.0, "use_class": "IV"}
    table = case_of(site, limit_state="SLC")
    del table["site"]["latitude"], table["site"]["longitude"]
    result = run(parse_case(table), base_dir=ROOT)
    said = {warning.code for warning in result.demand.warnings}
    assert {"site_of_a_seat", "site_beyond_the_table"} <= said
    found = json_report.results(result)["demand"]["site"]
    assert found["nodes"] == [26305, 26306, 26528, 26527] and len(found["hazard"]) == 9
    assert found["reference_life_years"] == 200.0 and list(found["states"]) == ["SLO", "SLD", "SLV", "SLC"]
    assert found["states"]["SLC"]["ag_g"] == found["hazard"][-1]["ag_g"]
    lines = dict(place_of(result.case.site, "it"))
    assert "26305" in lines["Nodi del reticolo"] and len(states_of(result.case.site)) == 4


def test_that_a_short_life_is_taken_as_35_years_and_an_island_is_named():
    site = {"municipality": "Cagliari", "latitude": 39.2238, "longitude": 9.1217, "nominal_life_years": 10.0}
    result = run(parse_case(case_of({**site, "use_class": "I"})), base_dir=ROOT)
    assert {"site_least_life", "site_on_an_island"} <= {warning.code for warning in result.demand.warnings}
    assert result.case.site.reference_life == 35.0
    assert result.demand.return_period == pytest.approx(332.2, abs=0.05)


def test_that_a_return_period_of_the_table_but_for_its_rounding_has_no_row_of_its_own():
    """V_R whose SLV (10 %) is at 475 years and a ten-thousand-millionth of it."""
    life = -475.0 * (1.0 + 1e-10) * math.log(1.0 - 0.10)
    site = Site("L'Aquila", latitude=42.3498, longitude=13.3995, nominal_life_years=life)
    assert site.return_period("SLV") - 475.0 == pytest.approx(4.75e-8, rel=1e-3)
    years = [row.return_period_years for row in hazard_rows(site)]
    table = [30.0, 50.0, 72.0, 101.0, 140.0, 201.0, 475.0, 975.0, 2475.0]
    states = [-life / math.log(1.0 - share) for share in (0.81, 0.63, 0.05)]
    assert years == pytest.approx(sorted(table + states), rel=1e-12)
