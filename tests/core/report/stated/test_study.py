"""The results of the shipped cases, and of walls with what these have not, against the schema of the results."""

import json
import tomllib

import fastjsonschema
import pytest

from core.case.rules import parse_case
from core.report import json_report
from core.report.stated.quantity import schema, walk_quantities
from core.report.stated.study import RESULTS
from core.study.run import run
from tests.holds import sought
from tests.reference_of_results import FOLDER, json_schema, page

CHECK = fastjsonschema.compile(schema(RESULTS))


@pytest.mark.shows("files.schema")
@pytest.mark.parametrize(
    "name", ["verdict", *(pytest.param(name, marks=pytest.mark.long) for name in ("facade", "example", "building"))]
)
def test_that_the_results_of_a_shipped_case_are_as_the_schema_says(name, shipped):
    CHECK(json.loads(json_report.dumps(shipped(name))))


HELD = {"name": "held", "mechanism": "vertical_bending", "height_m": 4.0, "thickness_m": 0.4, "length_m": 4.0}
HELD |= {"unit_weight_kn_m3": 18.0, "base_z_m": 0.0, "hold": [{"kind": "cross_walls"}]}
HELD |= {"load": [{"kind": "vertical", "kn_m": 10.0, "d_m": 0.15, "h_m": 4.0, "mass": "none"}]}
TIED = {"name": "tied", "mechanism": "one_sided", "height_m": 7.0, "thickness_m": 0.6, "length_m": 9.0}
TIED |= {"unit_weight_kn_m3": 18.0, "base_z_m": 0.0}
BARS = {"number": 1, "diameter_mm": 12.0}
TIE = {"kind": "tie", "h_m": 6.5, "bar_length_m": 8.0, "bar": BARS, "elongation_m": 0.16}
TIED |= {"hold": [TIE, sought(6.0, bar_length_m=8.0)]}
HIGH = {"name": "high", "mechanism": "both", "height_m": 1.5, "thickness_m": 0.3, "base_z_m": 9.0, "length_m": 4.0}
HIGH |= {"unit_weight_kn_m3": 18.0, "elastic_modulus_mpa": 900.0}
HIGH |= {"openings": [{"s_m": 1.0, "z_m": 0.5, "width_m": 1.0, "height_m": 0.5}]}


def test_that_walls_that_no_shipped_case_has_are_as_the_schema_says(tmp_path):
    """Held at its top, with bars and a tie to be designed, free above the ground with an opening, before and after."""
    spectrum = {"code": "NTC2018", "f0": 2.4, "tc_star_s": 0.3, "soil": "B", "topography": "T1"}
    pair = [{**HIGH, "name": "pair", "variant": variant} for variant in ("stato di fatto", "progetto")]
    table = {
        "wall": [HELD, TIED, HIGH, *pair],
        "building": {"storeys": 3, "height_m": 9.0},
        "demand": {"ag_g": 0.2, "spectrum": spectrum},
        "analysis": {"histories": False},
    }
    found = json.loads(json_report.dumps(run(parse_case(table), base_dir=tmp_path)))
    CHECK(found)
    keys = {key for wall in found["walls"] for key, value in wall.items() if value is not None}
    assert {"body", "ties", "floor", "kinematic_check"} <= keys and "variants" in found
    assert any((wall["kinematic_check"] or {}).get("bending") for wall in found["walls"])
    assert parse_case(tomllib.loads(found["case_toml"])) == parse_case(table)


def test_that_a_key_that_is_not_described_and_one_that_is_missing_are_refused(of_seven):
    """Both ends of the schema: what is described is there, and nothing else is."""
    found = json.loads(json_report.dumps(of_seven))
    found["walls"][0]["q_of_nobody"] = 2.0
    with pytest.raises(fastjsonschema.JsonSchemaException, match="q_of_nobody"):
        CHECK(found)
    del found["walls"][0]["q_of_nobody"], found["walls"][0]["q_set"]
    with pytest.raises(fastjsonschema.JsonSchemaException, match="q_set"):
        CHECK(found)


@pytest.mark.shows("files.schema")
def test_that_every_number_of_the_results_has_a_unit_and_every_key_a_meaning():
    silent = [
        path
        for path, one in walk_quantities(RESULTS)
        if not one.meaning or (one.kind.startswith("number") and not one.unit)
    ]
    assert silent == []


def test_that_a_unit_in_the_name_of_a_key_is_the_unit_of_its_value():
    ends = {
        "_m": "m",
        "_cm": "cm",
        "_deg": "deg",
        "_rad": "rad",
        "_g": "g",
        "_s": "s",
        "_years": "years",
        "_kn_m": "kN/m",
        "_n_s_m": "N s/m",
    }
    ends |= {
        "_m_s": "m/s",
        "_cm_s": "cm/s",
        "_rad_s": "rad/s",
        "_m_s2": "m/s2",
        "_kn_m3": "kN/m3",
        "_mpa": "MPa",
        "_km": "km",
    }
    wrong = []
    for path, one in walk_quantities(RESULTS):
        if one.kind not in ("number", "numbers"):
            continue
        end = max((end for end in ends if one.key.endswith(end)), key=len, default=None)
        if end and one.unit != ends[end]:
            wrong.append((path, one.unit))
    assert wrong == []


@pytest.mark.shows("files.schema")
def test_that_the_page_and_the_schema_of_the_results_are_those_of_the_program():
    words = "write them anew: .venv/bin/python -m tests.reference_of_results"
    assert (FOLDER / "results.md").read_text(encoding="utf-8") == page(), words
    assert (FOLDER / "results.schema.json").read_text(encoding="utf-8") == json_schema(), words
