"""A language more is a folder of texts: one made of marked English, from the case to the workbook and the note."""

import json
import os
import re
import subprocess
import sys

import openpyxl
import pytest

from core.text.catalogue import CATALOGUE, FOLDER, Catalogue
from tests.conftest import ROOT

CASE = """
[report]
language = "xx"
[demand]
ag_g = 0.1
[demand.spectrum]
code = "EN1998"
type = 1
soil = "B"
[[wall]]
name = "w"
mechanism = "two_sided"
height_m = 3.0
thickness_m = 0.4
base_z_m = 0.0
"""

PROGRAM = """
import sys
from pathlib import Path
from core.text import catalogue
catalogue.CATALOGUE.__init__(Path(sys.argv.pop(1)))
from app.__main__ import main
sys.exit(main())
"""


@pytest.fixture
def folder(tmp_path):
    """The catalogue with a language more, of the English texts between marks."""
    place = tmp_path / "translations"
    own = place / "xx"
    own.mkdir(parents=True)
    (own / "language.json").write_text('{"name": "Marked", "decimal_comma": true}')
    for path in FOLDER.glob("*.json"):
        (place / path.name).write_bytes(path.read_bytes())
        texts = {code: f"«{english}»" for code, (english, _) in CATALOGUE[path.stem].items() if english}
        (own / path.name).write_text(json.dumps(texts))
    return place


@pytest.mark.parametrize(
    ("name", "content", "taken"),
    [
        ("language.json", b'\xef\xbb\xbf{"name": "Marked", "decimal_comma": true}', True),  # of an editor of Windows
        ("language.json", b'{"name": "Marked", "decimal_comma": "false"}', False),
        ("language.json", b'{"name": "Marked"', False),
        ("language.json", b'["Marked"]', False),
        ("window.json", b"\xff\xfe", False),
    ],
)
def test_that_a_language_that_cannot_be_used_hinders_no_other(folder, tmp_path, name, content, taken):
    (folder / "xx" / name).write_bytes(content)
    (tmp_path / "case.toml").write_text(CASE)
    (tmp_path / "english.toml").write_text(CASE.replace('"xx"', '"en"'))
    assert ("xx" in Catalogue(folder).languages) == taken
    for case, code in (("english", 0), ("case", 0 if taken else 1)):
        told = ["--batch", tmp_path / f"{case}.toml", "--output", tmp_path / "out", "--quiet", "--force"]
        found = subprocess.run(
            [sys.executable, "-c", PROGRAM, folder, *map(str, told)], capture_output=True, text=True, cwd=ROOT
        )
        assert found.returncode == code, found.stderr
        assert code == 0 or ("xx" in found.stderr and found.stderr.count("\n") == 1)


def test_that_a_text_it_lacks_is_the_english_one(folder):
    (folder / "xx" / "word.json").write_text('{"passed": "passé"}')
    (folder / "xx" / "window.json").unlink()
    texts = Catalogue(folder)
    assert texts.text("word", "passed", "xx") == "passé"
    assert texts.text("word", "not_passed", "xx") == CATALOGUE["word"]["not_passed"][0]
    assert texts.text("window", "Language", "xx") == "Language"
    assert texts.text("window", "Language", "it") == CATALOGUE["window"]["Language"][1]


@pytest.mark.parametrize("text", [["a", "list"], "{", "{stranger}", 5, None])
def test_that_a_text_that_cannot_stand_for_the_english_one_does_not(folder, text):
    """Else an error would end in another while it is told."""
    (folder / "xx" / "error.json").write_text(json.dumps({"no_case_file": text}))
    assert Catalogue(folder).text("error", "no_case_file", "xx") == CATALOGUE["error"]["no_case_file"][0]


@pytest.mark.parametrize(
    ("place", "content"),
    [("it", '{"name": "a", "decimal_comma": true}'), ("xx", "{"), ("xx", "[]"), ("xx", '{"name": "a"}')],
)
def test_that_a_folder_that_is_no_language_is_a_fault_of_it(folder, place, content):
    (folder / place).mkdir(exist_ok=True)
    (folder / place / "language.json").write_text(content)
    made = Catalogue(folder)
    assert set(made.faults) == {place} and set(made.languages) == {"en", "it", "xx"} - {*made.faults} | {"it"}


@pytest.mark.shows("window.language")
def test_that_the_whole_way_to_the_report_is_in_it(folder, tmp_path):
    (tmp_path / "case.toml").write_text(CASE)
    words = [tmp_path / "case.toml", "--output", tmp_path / "out", "--report", tmp_path / "note.docx"]
    found = subprocess.run(
        [sys.executable, "-c", PROGRAM, folder, "--quiet", "--batch", *words],
        capture_output=True, text=True, cwd=ROOT, env=dict(os.environ, LC_ALL="C.UTF-8"),
    )  # fmt: skip
    assert (found.returncode, found.stderr) == (0, ""), found.stderr
    (made,) = (tmp_path / "out").glob("*.xlsx")
    book = openpyxl.load_workbook(made)
    unmarked = [
        cell.value
        for sheet in book
        for row in sheet.iter_rows()
        for cell in row
        if isinstance(cell.value, str) and "«" not in cell.value
        and re.match(r"[^=].*[a-z]{3,} [a-z]{3,}", cell.value, re.DOTALL)
    ]  # fmt: skip
    assert not unmarked
    assert any("«" in name for name in book.sheetnames)
