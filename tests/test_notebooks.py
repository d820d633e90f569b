"""The notebooks run, and the names of the package are those its page lists."""

import inspect
import json
import re

import pytest

import core.api
from tests.conftest import ROOT

NOTEBOOKS = sorted((ROOT / "resources" / "notebooks").glob("*.ipynb"))


@pytest.mark.shows("batch.script")
@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_that_a_notebook_runs(path, capsys, monkeypatch):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    book, names = json.loads(path.read_text(encoding="utf-8")), {}
    assert (book["nbformat"], book["nbformat_minor"]) == (4, 5)
    assert len({cell["id"] for cell in book["cells"]}) == len(book["cells"])
    for cell in book["cells"]:
        if cell["cell_type"] == "code":
            assert cell["outputs"] == [] and cell["execution_count"] is None
            exec(compile("".join(cell["source"]), path.name, "exec"), names)
    drawn = [line for axes in names["figure"].axes for line in axes.get_lines()]
    assert drawn and all(len(line.get_xdata()) for line in drawn)
    names["plt"].close("all")


def test_that_every_name_has_its_types_units_and_a_row_in_the_page():
    page = (ROOT / "resources" / "docs" / "python.md").read_text(encoding="utf-8")
    listed = set(re.findall(r"`(\w+)(?:\(|`)", page[: page.index("## ")]))
    names = set(core.api.__all__) - {"GroundMotion", "History"}
    assert names <= listed
    for name in core.api.__all__:
        of = getattr(core.api, name)
        assert inspect.getdoc(of)
        if inspect.isfunction(of):
            signature = inspect.signature(of)
            assert signature.return_annotation is not inspect.Signature.empty, name
            for parameter in signature.parameters.values():
                assert parameter.annotation is not inspect.Parameter.empty, (name, parameter)
