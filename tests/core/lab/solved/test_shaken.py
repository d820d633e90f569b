"""Tests on a shake table as the last chapter of the solved cases, and what --validate says of them."""

import json

import pytest

from app.__main__ import main
from core.lab.solved import cases
from tests.core.lab.research.test_shake_table import invented


@pytest.mark.shows("batch.validate")
def test_that_the_command_says_and_writes_what_was_found(tmp_path, capsys, monkeypatch):
    """As validation.json and as the last chapter of the solved cases."""
    pypdf = pytest.importorskip("pypdf")
    pytest.importorskip("typst")
    monkeypatch.setattr(cases, "SUBJECTS", (cases.SUBJECTS[0]._replace(cases=cases.SUBJECTS[0].cases[:2]),))
    data, output = tmp_path / "data", tmp_path / "out"
    data.mkdir()
    invented(data, wrong=("10", "50"))
    assert main(["--validate", "--data", str(data), "--output", str(output)]) == 0
    said = capsys.readouterr().out
    assert "body 1: 71 tests" in said and "slenderness fitted: right" in said and "left out: 1 tests" in said
    (body,) = json.loads((output / "validation.json").read_text())["bodies"]
    assert {"name", "tests", "right", "missed", "false", "interval", "fitted"} <= set(body)
    assert body["name"] == "1" and body["tests"] == 71 and 0.9 < body["right"] <= 69.0 / 71.0
    assert body["interval"][0] <= body["right"] <= body["interval"][1] and len(body["fitted"]) == 2
    text = " ".join(pypdf.PdfReader(output / "solved.pdf").pages[-1].extract_text().split())
    score, fitted = f"{100.0 * body['right']:.1f}", ", ".join(map(str, body["fitted"]))
    assert "body 1: 71 tests" in text and f"slenderness fitted {fitted} {score}" in text and "1 tests whose" in text
    before = (data / "tests.csv").read_bytes()
    (data / "validation.json").write_text("{}")
    assert main(["--validate", "--data", str(data), "--output", str(data)]) == 1  # a file of the data
    assert "validation.json" in capsys.readouterr().err and (data / "tests.csv").read_bytes() == before
