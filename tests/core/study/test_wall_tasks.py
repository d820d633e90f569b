"""Each wall of a study is worked to its end and told of, before the walls after it have begun."""

from dataclasses import replace

import openpyxl
import pytest

from app.terminal import export
from core.case.reader import read_case
from core.report import json_report
from core.study import run as study
from core.study.results import StudyResult
from tests.conftest import ROOT
from tests.core.study.cases import case

CASES = ROOT / "resources" / "cases"


def many(count: int):
    """Walls of different heights."""
    wall = {"thickness_m": 0.5, "base_z_m": 0.0, "mechanism": "both"}
    return case(wall=[{**wall, "name": f"w{k}", "height_m": 4.0 + 0.1 * k} for k in range(count)])


@pytest.mark.parametrize("jobs", [1, 2])
def test_that_walls_are_told_of_in_their_order_as_they_are_in_the_result(folder, jobs):
    told: list[StudyResult] = []
    result = study.run(many(6), base_dir=folder, jobs=jobs, on_finished=told.append)
    assert [[wall.name for wall in one.walls] for one in told] == [[f"w{k}"] * 2 for k in range(6)]
    assert told == list(result.split_by_wall())
    assert [one.first for one in told] == [0, 2, 4, 6, 8, 10]
    for one in told:
        (verdict,) = one.verdicts
        assert sorted(verdict.results) == [0, 1] and verdict.governing in (0, 1)
        assert [one.numbers[id(wall)] for wall in one.walls] == [result.numbers[id(wall)] for wall in one.walls]


def test_that_the_first_walls_end_before_the_last_begin(folder):
    """What is made of a wall then is made while others are searched."""
    left, planned = [], []
    asked, state = many(12), {"done": 0}

    def on_progress(done, of, seconds):
        state["done"] = done
        planned.append(of)

    study.run(
        asked,
        base_dir=folder,
        jobs=2,
        on_progress=on_progress,
        on_finished=lambda wall: left.append(state["done"] / planned[-1]),
    )
    assert left[0] < 0.5 and left[5] < 0.9 and left[-1] == 1.0


def test_that_files_made_while_walls_finish_are_those_of_the_whole_result(tmp_path):
    """A table of walls; every cell and name of the workbook."""
    path = ROOT / "tests" / "cases" / "verdict.toml"
    asked = read_case(path)
    asked = replace(asked, wall=tuple(asked.wall))
    report = export.Report(asked)
    result = study.run(asked, base_dir=path.parent, jobs=2, on_finished=report.add)
    report.write(result, tmp_path, "streamed")
    export.write(result, tmp_path, "whole")
    assert (tmp_path / "streamed.json").read_bytes() == (tmp_path / "whole.json").read_bytes()
    found, expected = (openpyxl.load_workbook(tmp_path / f"{stem}.xlsx") for stem in ("streamed", "whole"))
    assert found.sheetnames == expected.sheetnames
    for sheet in expected:
        cells = [[cell.value for cell in row] for row in sheet.iter_rows()]
        assert [[cell.value for cell in row] for row in found[sheet.title].iter_rows()] == cells, sheet.title
    assert {n: d.attr_text for n, d in found.defined_names.items()} == {
        n: d.attr_text for n, d in expected.defined_names.items()
    }


def test_that_the_text_of_the_json_is_its_mapping(folder):
    import json

    result = study.run(case(), base_dir=folder)
    assert json.loads(json_report.dumps(result)) == json.loads(json.dumps(json_report.results(result)))
    assert json_report.dumps(result) == json.dumps(json_report.results(result), indent=1, ensure_ascii=False) + "\n"


def test_that_a_block_of_the_sheet_check_needs_its_own_wall_alone(folder):
    """Variants, hinges and the sentence of a verdict among them: made of the whole result it is the same."""
    from core.report.cells import Book
    from core.report.check_sheet import CheckSheet

    result = study.run(many(3), base_dir=folder)
    sheets = []
    for parts in ([result], list(result.split_by_wall())):
        check = CheckSheet(Book("en"), result)
        for part in parts:
            check.add(part)
        sheets.append([[cell.value for cell in row] for row in check.close().iter_rows()])
    assert sheets[0] == sheets[1]
