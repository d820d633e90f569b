"""What others cite: version, licence and title are those of the project, and the draft cites only what it lists."""

import json
import re
import tomllib

import pytest

from core.version import VERSION
from tests.conftest import ROOT

DRAFT = ROOT / "packaging" / "joss"


def test_that_the_files_name_this_version_and_licence():
    yaml = pytest.importorskip("yaml", reason="comes with myst-parser")
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    cited = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    assert cited["cff-version"] == "1.2.0" and cited["message"] and cited["authors"]
    deposited = json.loads((ROOT / ".zenodo.json").read_text(encoding="utf-8"))
    assert str(cited["version"]) == deposited["version"] == VERSION == project["version"]
    assert cited["license"] == deposited["license"] == project["license"]
    assert cited["title"] == deposited["title"]
    assert deposited["upload_type"] == "software" and deposited["creators"]
    for reference in cited["references"]:
        assert reference["title"] and reference["authors"] and reference["year"] and reference["type"]


def test_that_the_draft_cites_what_it_lists_and_is_of_a_papers_length():
    text, listed = (DRAFT / "paper.md").read_text(encoding="utf-8"), (DRAFT / "paper.bib").read_text(encoding="utf-8")
    body = text.split("---", 2)[2]
    cited = set(re.findall(r"@(\w+)", body))
    assert cited == set(re.findall(r"^@\w+\{(\w+),", listed, re.MULTILINE))
    assert 250 <= len(body.split()) <= 1000
    for section in ("# Summary", "# Statement of need", "# References"):
        assert section in body


def test_that_the_numbers_of_the_draft_are_those_of_the_documents():
    body = " ".join((DRAFT / "paper.md").read_text(encoding="utf-8").split())
    page = (ROOT / "resources" / "docs" / "validation.md").read_text(encoding="utf-8")
    used, first, second = (
        re.search(pattern, page)[1]
        for pattern in (r"(\d+) of use", r"nothing fitted \| ([\d.]+)", r"nothing fitted \| [^|]* \| ([\d.]+)")
    )
    assert f"Against {used} shake-table tests" in body
    assert f"in {round(float(first))} and {round(float(second))} % of the tests" in body
    speed = (ROOT / "resources" / "docs" / "speed.md").read_text(encoding="utf-8")
    ratios = re.search(
        r"heyoka, compiled steps alone, tolerance of a double \| [^|]* \| ([\d.]+), [\d.]+, ([\d.]+) \|", speed
    )
    low, high = map(float, ratios.groups())
    assert round(1.0 / high, 2) == 0.11 and round(1.0 / low, 2) == 0.31
    assert "between a ninth and a third" in body
