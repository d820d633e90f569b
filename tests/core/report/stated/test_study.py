"""The results of the shipped cases, and of walls with what these have not, against the schema of the results."""

import json

import fastjsonschema
import pytest

from core.report import json_report
from core.report.stated.quantity import listed, schema
from core.report.stated.study import RESULTS
from tests.reference_of_results import FOLDER, json_schema, page

CHECK = fastjsonschema.compile(schema(RESULTS))


@pytest.mark.parametrize("name", ["verdict", "facade", "example", "building"])
def test_that_the_results_of_a_shipped_case_are_as_the_schema_says(name, shipped):
    CHECK(json.loads(json_report.dumps(shipped(name))))


def test_that_a_key_that_is_not_described_and_one_that_is_missing_are_refused(shipped):
    """Both ends of the schema: what is described is there, and nothing else is."""
    found = json.loads(json_report.dumps(shipped("verdict")))
    found["walls"][0]["q_of_nobody"] = 2.0
    with pytest.raises(fastjsonschema.JsonSchemaException, match="q_of_nobody"):
        CHECK(found)
    del found["walls"][0]["q_of_nobody"], found["walls"][0]["q_set"]
    with pytest.raises(fastjsonschema.JsonSchemaException, match="q_set"):
        CHECK(found)


def test_that_every_number_of_the_results_has_a_unit_and_every_key_a_meaning():
    silent = [
        path for path, one in listed(RESULTS) if not one.meaning or (one.kind.startswith("number") and not one.unit)
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
    for path, one in listed(RESULTS):
        if one.kind not in ("number", "numbers"):
            continue
        end = max((end for end in ends if one.key.endswith(end)), key=len, default=None)
        if end and one.unit != ends[end]:
            wrong.append((path, one.unit))
    assert wrong == []


def test_that_the_page_and_the_schema_of_the_results_are_those_of_the_program():
    words = "write them anew: .venv/bin/python -m tests.reference_of_results"
    assert (FOLDER / "results.md").read_text(encoding="utf-8") == page(), words
    assert (FOLDER / "results.schema.json").read_text(encoding="utf-8") == json_schema(), words
