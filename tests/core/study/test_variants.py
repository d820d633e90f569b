"""Walls before and after, line by line."""

from pathlib import Path

import pytest

from core.errors import InputError
from core.report import json_report
from core.study import run as study
from core.study.variants import compare_results
from tests.clauses_alone import parse_case
from tests.validation.test_loaded_walls import DEMAND, ROOF, TIE, WALL

BEFORE = {**WALL, "name": "facade", "variant": "stato di fatto", "load": [ROOF]}
AFTER = {
    **WALL,
    "name": "facade",
    "variant": "progetto",
    "load": [ROOF],
    "hold": [{**TIE, "out_kn_m": 2.0}],
    "thickness_m": 0.40,
}


@pytest.mark.shows("case.variant")
def test_that_two_walls_of_one_name_are_compared_and_what_changed_is_named():
    walls = [BEFORE, AFTER, {**WALL, "name": "other"}, {**BEFORE, "name": "alone"}]
    table = {"wall": walls, "demand": DEMAND}
    result = study.run(parse_case(table), base_dir=Path())
    (pair,) = compare_results(result.walls)
    assert pair.name == "facade" and pair.before.name == "facade (stato di fatto)"
    assert pair.changed == ("thickness_m", "hold")
    alone = study.run(parse_case({**table, "wall": [AFTER]}), base_dir=Path()).walls[0]
    assert pair.after.assessment == alone.assessment
    (written,) = json_report.results(result)["variants"]
    assert written["after"]["zeta_e"] == alone.assessment.verdict.zeta_e
    assert written["before"]["zeta_e"] < written["after"]["zeta_e"]


def test_that_a_variant_without_its_counterpart_is_said():
    result = study.run(parse_case({"wall": [BEFORE, {**AFTER, "name": "x"}], "demand": DEMAND}), base_dir=Path())
    for wall in result.walls:
        assert wall.warnings[0].code == "variant_alone"


def test_that_hinges_are_compared_each_with_its_own():
    walls = [{**one, "hinge_heights": [1.0]} for one in (BEFORE, AFTER)]
    result = study.run(parse_case({"wall": walls, "demand": DEMAND}), base_dir=Path())
    assert [pair.name for pair in compare_results(result.walls)] == ["facade", "facade (+1 m)"]


@pytest.mark.parametrize("walls", [[BEFORE, BEFORE], [BEFORE, {**AFTER, "variant": "after"}]])
def test_that_two_walls_of_one_name_and_variant_are_refused(walls):
    with pytest.raises(InputError):
        parse_case({"wall": walls})
