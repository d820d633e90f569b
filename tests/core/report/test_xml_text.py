"""Whatever a text holds, the files it is written into can be opened, and show it."""

import io
import zipfile
from xml.parsers import expat

import numpy as np
import pytest
from openpyxl import Workbook

from app import __main__ as program
from core.lab.research.figures import LINE
from core.lab.research.figures import Figure as StudyFigure
from core.lab.research.figures import Series as StudySeries
from core.lab.research.study_files import figure_files
from core.ooxml.sheet import Limits, read_sheet
from core.report.cells import Book, text
from core.report.note.document import document
from core.report.note.parts import Curve, Figure, Figures, Heading, Paragraph, Table
from core.report.xml_text import escape_for_cell, escape_for_xml

HOSTILE = "a\ufffe\uffff_x0041_\x0b\ud800\U0001ffff è <&>"
SHOWN = "a\\ufffe\\uffff_x0041_"


def parsed(content: bytes) -> str:
    """All text of an XML file, which must be well formed."""
    pieces = []
    parser = expat.ParserCreate()
    parser.CharacterDataHandler = pieces.append
    parser.Parse(content, True)
    return "".join(pieces)


def parts(content: bytes) -> dict[str, str]:
    """The text of every part of a package."""
    with zipfile.ZipFile(io.BytesIO(content)) as folder:
        return {name: parsed(folder.read(name)) for name in folder.namelist() if name.endswith((".xml", ".rels"))}


def test_that_only_what_no_xml_holds_is_escaped():
    assert escape_for_xml(HOSTILE) == "a\\ufffe\\uffff_x0041_\\x0b\\ud800\U0001ffff è <&>"
    assert escape_for_xml("a\tb\nè 😀\ufffd") == "a\tb\nè 😀\ufffd"
    assert escape_for_cell("_x0041_ x_x00e9__x0041_ _x41_") == "_x005F_x0041_ x_x005F_x00e9__x005F_x0041_ _x41_"
    curve = Curve("\uffff", (1.0, 2.0), np.ones(2))
    made = escape_for_xml((Figure("c\ufffe", [curve]), Table(("\uffff",), [["\uffff", "b"]], (1,))))
    assert made[0].caption == "c\\ufffe" and made[0].curves[0].x == (1.0, 2.0)
    assert made[1].rows == [["\\uffff", "b"]] and made[1].heads == ("\\uffff",)


def test_that_a_cell_shows_its_text_as_it_is():
    made = Workbook()
    wanted = ["_x0041_", "_x005F_x0041_", "a_xFFFF_b", "_x41_", "__x0041__"]
    for row, one in enumerate(wanted, start=1):
        text(made.active, row, 1, one)
    text(made.active, 6, 1, HOSTILE)
    room = io.BytesIO()
    made.save(room)
    sheet = read_sheet(room.getvalue(), Limits(9, 9, 9, 10**6), lambda names: 0)
    assert [sheet.texts(row)[0] for row in range(1, 6)] == wanted
    assert sheet.texts(6)[0].startswith(SHOWN)


def test_that_the_value_of_a_formula_is_shown_as_it_is():
    book = Book("en")
    book.formula(book.workbook.active["A1"], '="x"', HOSTILE)
    sheet = read_sheet(book.content(), Limits(9, 9, 9, 10**6), lambda names: 0)
    assert sheet.texts(1)[0].startswith(SHOWN)


def test_that_a_word_document_takes_any_text():
    pytest.importorskip("docx")
    figure = Figure("c" + HOSTILE, [Curve(HOSTILE.replace("\U0001ffff", ""), (0.0, 1.0), (0.0, 1.0))], "x\uffff", "y")
    made = document(
        [Heading(HOSTILE, 1), Paragraph(HOSTILE), Table((HOSTILE,), [[HOSTILE]], (1,)), Figures([figure, figure])], "en"
    )
    assert parts(made)["word/document.xml"].count(SHOWN) == 6


def test_that_a_figure_of_a_study_takes_any_text():
    pytest.importorskip("matplotlib")
    name = HOSTILE.replace("\U0001ffff", "")
    figure = StudyFigure("k", name, "x", "y", (StudySeries(name, (0.0, 1.0), (0.0, 1.0), LINE),))
    assert SHOWN in parsed(figure_files(figure)["k.svg"])


CASE = """
title = "{name} t"
[report]
client = "{name} c"
[[wall]]
name = "{name} w"
height_m = 5.0
thickness_m = 0.5
mechanism = "two_sided"
base_z_m = 0.0
notes = "{name} n"
[[record]]
file = "{name} r.txt"
unit = "m/s2"
time_step_s = 0.01
[analysis]
q_step = 0.05
[demand]
ag_g = 0.2
site = "{name} s"
"""


def test_that_any_text_of_a_case_gives_files_that_open(tmp_path, reference):
    pytest.importorskip("docx")
    name = "a\ufffe\uffff_x0041_"
    ground = reference("standard")[0][:900]
    samples = "\n".join(f"{value:.9e}" for value in ground)
    (tmp_path / f"{name} r.txt").write_text(f"# {name} head\n{samples}\n", encoding="utf-8")
    path = tmp_path / "case.toml"
    path.write_text(CASE.format(name=name), encoding="utf-8")
    note = tmp_path / "note.docx"
    assert program.main(["--batch", str(path), "--quiet", "--report", str(note)]) == 0
    written = parts(note.read_bytes())["word/document.xml"]
    for end in ("t", "c", "w", "r", "s"):
        assert f"{SHOWN} {end}" in written, end
    whole = (tmp_path / "case.xlsx").read_bytes()
    assert "xl/workbook.xml" in parts(whole)
    limits, names, seen = Limits(5000, 200, 200_000, 40_000_000), [], set()
    read_sheet(whole, limits, lambda found: names.extend(found) or 0)
    for number in range(len(names)):
        sheet = read_sheet(whole, limits, lambda found, number=number: number)
        seen |= {cell.text for cells in sheet.rows.values() for cell in cells.values()}
    for end in ("t", "c", "w", "r", "n", "s"):
        assert any(f"{SHOWN} {end}" in one for one in seen), end
