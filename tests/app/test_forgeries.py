"""Reports whose cells are as they were and that show something else: `--verify` calls none of them equal."""

import io
import json
import re
import shutil
import zipfile

import pytest

from app.__main__ import main
from core.report.differences import compare_workbooks
from tests.conftest import FACADE

CASE = f"""
title = "Forged"
{FACADE}unit_weight_kn_m3 = 18.0
[generate]
count = 3
seed = 1
[demand]
ag_g = 0.2
spectrum = {{ code = "EN1998", type = 1, soil = "B" }}
"""

SHEET, STYLES, BOOK, CHART = "xl/worksheets/sheet1.xml", "xl/styles.xml", "xl/workbook.xml", "xl/charts/chart1.xml"

FORGERIES = {
    "number formats": (STYLES, r'formatCode="[^"]*"', 'formatCode="&quot;1.25&quot;"'),
    "one number format": (STYLES, r'formatCode="0.000"', 'formatCode="1.25"'),
    "white letters": (STYLES, r'<color rgb="[^"]*"', '<color rgb="00FFFFFF"'),
    "struck letters": (STYLES, r"<font>", "<font><strike/>"),
    "fill": (STYLES, r'<fgColor rgb="[^"]*"', '<fgColor rgb="0000FF00"'),
    "dates for numbers": (STYLES, r'numFmtId="\d+"', 'numFmtId="14"'),
    "hidden row": (SHEET, r'<row r="1"', '<row hidden="1" r="1"'),
    "low row": (SHEET, r'<row (?=[^>]*r="2")', '<row zeroHeight="1" '),
    "hidden column": (SHEET, r"<sheetData>", '<cols><col min="3" max="3" hidden="1"/></cols><sheetData>'),
    "style of a cell": (SHEET, r' s="\d+"', ' s="0"'),
    "conditional format": (
        SHEET,
        r"</sheetData>",
        '</sheetData><conditionalFormatting sqref="A1:Z99"><cfRule type="expression" dxfId="0" priority="1">'
        "<formula>TRUE</formula></cfRule></conditionalFormatting>",
    ),
    "merged cells": (SHEET, r"</sheetData>", '</sheetData><mergeCells count="1"><mergeCell ref="A1:F9"/></mergeCells>'),
    "filter": (SHEET, r"</sheetData>", '</sheetData><autoFilter ref="A1:C9"/>'),
    "zeros not shown": (SHEET, r"<sheetView ", '<sheetView showZeros="0" '),
    "formulas shown": (SHEET, r"<sheetView ", '<sheetView showFormulas="1" '),
    "printed header": (SHEET, r"<oddHeader />", "<oddHeader>&amp;Lverified</oddHeader>"),
    "width of a column": (SHEET, r'<col width="30"', '<col width="0.1"'),
    "hidden sheet": (BOOK, r'state="visible"', 'state="hidden"'),
    "very hidden sheet": (BOOK, r'state="visible"', 'state="veryHidden"'),
    "defined name": (BOOK, r"</sheets>", '</sheets><definedNames><definedName name="z">1</definedName></definedNames>'),
    "precision as displayed": (BOOK, r"<calcPr ", '<calcPr fullPrecision="0" '),
    "not computed": (BOOK, r"<calcPr ", '<calcPr calcMode="manual" '),
    "title of a chart": (CHART, r"<a:t>[^<]*</a:t>", "<a:t>verified</a:t>"),
    "axis of a chart": (CHART, r"<c?:?scaling>", '<scaling><max val="9"/>'),
    "theme": ("xl/theme/theme1.xml", r'lastClr="\w+"', 'lastClr="FFFFFF"'),
}
"""What is written into which part: part, what stands there, what takes its place."""

ADDED = (
    "xl/comments1.xml",
    "xl/media/image9.png",
    "xl/externalLinks/externalLink1.xml",
    "xl/vbaProject.bin",
    "xl/worksheets/_rels/sheet1.xml.rels",
    "customXml/item1.xml",
)
"""Parts that are added."""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A folder with a case and its reports."""
    made = tmp_path_factory.mktemp("forgeries")
    (made / "case.toml").write_text(CASE)
    assert main(["--batch", str(made / "case.toml"), "--quiet"]) == 0
    return made


def parts_of(content: bytes) -> dict[str, bytes]:
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def packed(parts: dict[str, bytes]) -> bytes:
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, part in parts.items():
            archive.writestr(name, part)
    return content.getvalue()


@pytest.mark.shows("batch.forged")
@pytest.mark.parametrize("kind", FORGERIES)
def test_that_a_part_that_shows_something_else_is_named(folder, kind):
    content = (folder / "case.xlsx").read_bytes()
    name, old, new = FORGERIES[kind]
    parts = parts_of(content)
    forged = re.sub(old, lambda _: new, parts[name].decode())
    assert forged.encode() != parts[name], "nothing was forged"
    found = compare_workbooks(packed(parts | {name: forged.encode()}), content)
    assert found.parts == [name] and not found.cells


@pytest.mark.shows("batch.forged")
@pytest.mark.parametrize("name", ADDED)
def test_that_a_part_that_was_added_or_taken_is_named(folder, name):
    content = (folder / "case.xlsx").read_bytes()
    parts = parts_of(content)
    assert name not in parts
    assert compare_workbooks(packed(parts | {name: b"<x/>"}), content).parts == [name]
    assert compare_workbooks(content, packed(parts)).parts == []


@pytest.mark.shows("batch.forged")
def test_that_a_workbook_with_other_formats_is_not_called_equal(folder, tmp_path, capsys):
    """Formats alone turned 0.69, not verified, into 1.25, verified."""
    shutil.copytree(folder, tmp_path / "copied")
    path = tmp_path / "copied" / "case.xlsx"
    parts = parts_of(path.read_bytes())
    shown = 'formatCode="&quot;1.25&quot;;&quot;1.25&quot;;&quot;1.25&quot;;&quot;verified&quot;"'
    parts[STYLES] = re.sub(r'formatCode="[^"]*"', lambda _: shown, parts[STYLES].decode()).encode()
    path.write_bytes(packed(parts))
    capsys.readouterr()
    assert main(["--verify", str(path), "--quiet"]) == 6
    assert STYLES in capsys.readouterr().out


@pytest.mark.shows("batch.forged")
@pytest.mark.parametrize(
    ("old", "new"),
    [
        (r"^\{", '{"verdicts": [],'),  # a key that stands twice: one reader takes the first
        (r'"zeta_e": [^,]*', '"zeta_e": NaN'),
        (r'"zeta_e": [^,]*', '"zeta_e": Infinity'),
        (r'"zeta_e": [^,]*', f'"zeta_e": {"9" * 400}'),
        (r'"zeta_e": [^,]*', '"zeta_e": "1.25"'),
        (r'"code": "not_verified"', '"code": "verified"'),
    ],
)
def test_that_results_that_two_readers_read_differently_are_told(folder, tmp_path, capsys, old, new):
    path = tmp_path / "case.json"
    text = (folder / "case.json").read_text()
    forged = re.sub(old, lambda _: new, text, count=1)
    assert forged != text
    json.loads(forged)
    path.write_text(forged)
    capsys.readouterr()
    assert main(["--verify", str(path), "--quiet"]) in (1, 5, 6)
