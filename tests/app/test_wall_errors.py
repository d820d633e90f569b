"""An error of the program in one wall is that wall's outcome: the others have theirs, and every report is written."""

import importlib
import json
import math

import openpyxl
import pytest

from app.__main__ import main
from core.case.rules import parse_case
from core.errors import InputError
from core.study.run import run

WALL = {"height_m": 5.0, "thickness_m": 0.5, "mechanism": "two_sided", "base_z_m": 0.0, "unit_weight_kn_m3": 18.0}
DEMAND = {"ag_g": 0.2, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}}
CASE = "".join(
    f"""[[wall]]
name = "{name}"
height_m = {height}
thickness_m = 0.5
mechanism = "two_sided"
base_z_m = 0.0
unit_weight_kn_m3 = 18.0
"""
    for name, height in (("a", 5.0), ("b", 5.5), ("c", 6.0))
)
WITH_DEMAND = """[generate]
count = 3
seed = 1
[demand]
ag_g = 0.2
spectrum = { code = "EN1998", type = 1, soil = "B" }
"""

FUNCTIONS = (
    "core.variation.evaluate.check_by_histories",
    "core.variation.assessment.make_verdict",
    "core.study.wall_tasks.run_result",
    "core.variation.evaluate.make_kinematic_checks",
    "core.variation.assessment.find_unasked_range",
    "core.study.wall_tasks.evaluate",
    "core.study.wall_tasks.assess_evaluation",
    "core.study.wall_tasks.incremental_dynamic_analyses",
    "core.study.wall_tasks.add_uncertainty",
    "core.study.wall_tasks.add_measures",
)
"""Functions in which an error is put, of all that a wall goes through."""


WHERE = {"incremental_dynamic_analyses": 1, "add_uncertainty": 5, "add_measures": 4}
"""Function -> number of the argument that tells the wall; else the first."""

SLENDERNESS = f"slenderness={math.atan(0.5 / 5.5)!r}"
"""Of the wall named b, in a model of it."""


def of_second_wall(monkeypatch, name: str, error: Exception) -> None:
    """Make a function raise where it is called for the wall named b, or for a wall of its height."""
    module, _, attribute = name.rpartition(".")
    real = getattr(importlib.import_module(module), attribute)

    def failing(*args, **named):
        of_wall = repr(args[WHERE.get(attribute, 0)])
        if "name='b'" in of_wall or SLENDERNESS in of_wall:
            raise error
        return real(*args, **named)

    monkeypatch.setattr(f"{module}.{attribute}", failing)


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """The verdicts of the case where nothing goes wrong."""
    folder = tmp_path_factory.mktemp("whole")
    (folder / "case.toml").write_text(CASE + WITH_DEMAND)
    assert main(["--batch", str(folder / "case.toml"), "--quiet"]) == 0
    return json.loads((folder / "case.json").read_text())["verdicts"]


@pytest.mark.shows("batch.wall_error")
@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=[] if k < 3 else [pytest.mark.long]) for k, name in enumerate(FUNCTIONS)]
)
def test_that_an_error_in_a_wall_leaves_it_undetermined_and_the_others_as_they_are(
    whole, tmp_path, monkeypatch, capsys, name
):
    (tmp_path / "case.toml").write_text(CASE + WITH_DEMAND)
    of_second_wall(monkeypatch, name, ZeroDivisionError("division by zero"))
    note = tmp_path / "out" / "case.pdf"
    words = ["--batch", str(tmp_path / "case.toml"), "--output", str(note.parent), "--report", str(note), "--quiet"]
    capsys.readouterr()
    assert main(words) == 3
    said = capsys.readouterr().err
    assert "internal error in b" in said and said.count("\n") == 1
    assert "ZeroDivisionError" in (note.parent / "case.error.log").read_text()
    first, second, third = json.loads((note.parent / "case.json").read_text())["verdicts"]
    assert [first, third] == [whole[0], whole[2]] and second["code"] == "undetermined"
    assert second["zeta_e"] is None and "ZeroDivisionError" in second["text_en"]
    assert note.read_bytes().startswith(b"%PDF") and openpyxl.load_workbook(note.with_suffix(".xlsx"))


def test_that_what_the_user_can_mend_still_ends_the_run(tmp_path, monkeypatch):
    of_second_wall(monkeypatch, "core.study.wall_tasks.evaluate", InputError("no_number", place=()))
    case = {"wall": [WALL | {"name": "a"}, WALL | {"name": "b", "height_m": 5.5}], "demand": DEMAND}
    with pytest.raises(InputError):
        run(parse_case(case), base_dir=tmp_path)
