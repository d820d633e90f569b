"""Texts of a person in the cells of a CSV."""

import csv
import io

import numpy as np
import pytest

from core.case.study_file import Cell
from core.ground.ground_motion import GroundMotion
from core.lab.research.parametric import ParametricResult, Row, StudyMotion
from core.lab.research.study_files import csv_text
from core.report.plain_cell import plain_cell


@pytest.mark.shows("files.no_formula_of_a_user")
@pytest.mark.parametrize(
    ("text", "cell"),
    [
        ("=1+1", "'=1+1"),
        ("@x", "'@x"),
        ("-A1", "'-A1"),
        ("+cmd", "'+cmd"),
        (" =1", "' =1"),
        ("\t=1", "'\t=1"),
        ("＝1", "'＝1"),
        ("-0,5", "-0,5"),
        ("1e-3", "1e-3"),
        ("wall", "wall"),
        ("", ""),
    ],
)
def test_that_a_cell_never_begins_as_a_formula(text, cell):
    assert plain_cell(text) == cell


def test_that_no_name_of_a_study_begins_a_cell_of_its_runs_as_a_formula():
    motion = GroundMotion("@SUM(1)", np.sin(np.arange(200.0)), 0.01)
    entry = StudyMotion(motion, "=HYPERLINK(1)", "+cmd", 1)
    wall = Cell(5.0, 3.0, "two_sided", "housner", "rigid", "auto", 0.02)
    row = Row(wall, 0, -1, "collapse_found", 2.0, 1.9, 1.5, 1.7, None, 0.1, 9)
    result = ParametricResult(None, "", False, "", (), (entry,), (row,), (), 0, 0.0)
    (read,) = csv.DictReader(io.StringIO(csv_text(result)))
    assert (read["group"], read["spectrum"], read["motion"]) == ("'+cmd", "'=HYPERLINK(1)", "'@SUM(1)")
    assert read["polarity"] == "-1" and read["q_robust"] == ""
