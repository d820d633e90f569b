"""The mechanisms are files of one registry: each part moves by one of them, and one more is known to every face."""

import json

import pytest

from core.case.hinges import make_wall_parts
from core.case.mechanisms.mechanism import NotLookedAt
from core.case.mechanisms.registry import REGISTER, how_it_moves
from core.case.mechanisms.turning import TurningBody
from core.case.rules import parse_case
from core.case.set_aside import ROWS
from core.codes.outcomes import OUTCOMES
from core.errors import InputError
from core.report import json_report
from core.report.register_words import describe_rows, not_possible
from core.study.run import run
from core.text.catalogue import CATALOGUE
from core.text.sentence import sentence
from tests.conftest import ROOT
from tests.core.variation.random_walls import random_tables

WALL = {"name": "w", "mechanism": "two_sided", "height_m": 2.0, "thickness_m": 0.6, "unit_weight_kn_m3": 18.0}
CASE = {"wall": [WALL | {"base_z_m": 0.0, "unloaded_confirmed": True}], "analysis": {"histories": False}}
CASE |= {"demand": {"ag_g": 0.02, "spectrum": {"code": "EN1998", "soil": "B", "type": 1}}}


class Sliding(TurningBody):
    """A mechanism of this test alone."""

    name = "sliding"

    def __init__(self, left):
        self.left = left

    def covers(self, part, way):
        return False

    def left_out(self, wall, building, aspect):
        return (NotLookedAt(sentence("mechanism", "one_leaf")),) if self.left else ()

    def why_not(self, wall):
        return "no_corner"


def test_that_the_register_has_a_file_for_each_name_of_a_case():
    assert tuple(mechanism.name for mechanism in REGISTER) == ROWS


def test_that_every_part_of_random_walls_moves_by_one_mechanism_as_its_wall_does():
    seen, parts = set(), 0
    for table in random_tables(120, histories=False):
        try:
            case = parse_case(table)
            found = make_wall_parts(0, case.wall[0], case.building)
        except InputError:
            continue
        for part in found:
            for way in part.wall.mechanisms():
                (moves,) = (mechanism for mechanism in REGISTER if mechanism.covers(part, way))
                assert isinstance(moves, TurningBody) or moves is how_it_moves(part.wall)
                assert (moves.hinge(part) is None) == part.wall.bends
                seen.add(moves.name)
                parts += 1
    assert parts > 150 and {"overturning", "vertical_bending", "part_above"} <= seen


@pytest.fixture(params=[False, True], ids=["not possible", "left out"])
def sliding(request, monkeypatch):
    monkeypatch.setitem(CATALOGUE["mechanism"], "sliding", ("sliding", "scorrimento"))
    REGISTER.append(Sliding(request.param))
    yield request.param
    del REGISTER[-1]


def test_that_a_mechanism_of_a_test_has_its_row_in_every_face_and_blocks_what_passes(sliding):
    result = run(parse_case(CASE), base_dir=ROOT)
    (verdict,) = result.verdicts
    outcome = result.walls[verdict.governing].assessment.verdict
    assert (outcome.code == "verified_refined") != sliding and outcome.code in OUTCOMES
    rows = {row["name"]: row["status"] for row in json.loads(json_report.dumps(result))["verdicts"][0]["mechanisms"]}
    assert rows["sliding"] == ("not_looked_at" if sliding else "not_possible")
    cells = describe_rows(result, verdict, lambda words, **values: words.format(**values), "it")
    words = [cell for line in cells for cell in line] if sliding else [not_possible(result, verdict, "it")]
    assert any("scorrimento" in cell.lower() for cell in words)
