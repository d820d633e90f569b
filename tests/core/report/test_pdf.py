"""The note as a PDF: what the file is made of, what lies within it, what it shows of any text."""

import io
import json
import random
import re
import unicodedata
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from app import __main__ as program
from core.case import note_file
from core.case.reader import read_case
from core.errors import InputError
from core.report.note import figure_geometry
from core.report.note.archive import note_as_pdf, note_attachments, note_of
from core.report.note.parts import Curve, Figure, Heading, Item, Paragraph, Table
from core.report.note.pdf import NO_DATE, Note, day_of, legible, picture
from core.report.words import Words
from tests.conftest import ROOT

pypdf = pytest.importorskip("pypdf")
NameObject, NumberObject = pypdf.generic.NameObject, pypdf.generic.NumberObject
pytest.importorskip("typst")

ALPHABET = (
    "abc XYZ 0123 àèìòù É ñ ß §°²³ ζθαξ #$\\{}[]()<>@*_~`'\"|&%;:,.!?+-=/^ “”’…–— "
    "שלום مرحبا 漢字 😀🏛️ \u202e\u200b\u2028 \t \u0301 \ue000 \x01\x7f \U000e0041 ℝ√∑ Ω Я"
)


@pytest.fixture(scope="module")
def content(whole_building):
    return note_as_pdf(whole_building, Path())


@pytest.fixture(scope="module")
def file(content):
    return pypdf.PdfReader(io.BytesIO(content))


def objects(reader):
    """All dictionaries of a file, also those of streams."""
    for number in range(len(reader.xref_objStm) + sum(map(len, reader.xref.values())) + 1):
        found = reader.get_object(pypdf.generic.IndirectObject(number, 0, reader)) if number else None
        if isinstance(found, dict):
            yield found


def structure(reader):
    """Elements of the structure tree."""
    open_ones = [reader.trailer["/Root"]["/StructTreeRoot"]]
    while open_ones:
        element = open_ones.pop().get_object()
        if not isinstance(element, dict):
            continue
        if "/S" in element:
            yield element
        kids = element.get("/K", [])
        open_ones += kids if isinstance(kids, list) else [kids]


@pytest.mark.shows("note.standards")
def test_that_the_file_says_it_is_pdf_a_3a_and_pdf_ua_1(file):
    root = file.trailer["/Root"]
    said = root["/Metadata"].get_object().get_data().decode()
    assert re.search(r"pdfaid:part>3<", said) and re.search(r"pdfaid:conformance>A<", said)
    assert re.search(r"pdfuaid:part>1<", said)
    assert root["/MarkInfo"]["/Marked"] == True and root["/Lang"] == "en"  # noqa: E712
    assert root["/OutputIntents"][0].get_object()["/S"] == "/GTS_PDFA1"
    assert root["/ViewerPreferences"]["/DisplayDocTitle"] == True  # noqa: E712
    assert file.metadata.title.startswith("Three-storey building") and not file.is_encrypted


@pytest.mark.shows("note.standards")
def test_that_every_font_is_within_the_file_and_nothing_leads_out_of_it(file):
    fonts = [one for one in objects(file) if one.get("/Type") == "/FontDescriptor"]
    assert fonts and all(set(font) & {"/FontFile", "/FontFile2", "/FontFile3"} for font in fonts)
    for one in objects(file):
        action = one.get("/S")
        assert action not in ("/URI", "/Launch", "/GoToR", "/JavaScript", "/SubmitForm", "/ImportData")
        assert one.get("/Type") != "/Filespec" or "/EF" in one


def test_that_figures_and_formulas_have_words_and_headings_follow_one_another(file):
    found = list(structure(file))
    kinds = {element["/S"] for element in found}
    assert {"/Document", "/H1", "/H2", "/H3", "/P", "/Table", "/TH", "/TD", "/Figure", "/Formula"} <= kinds
    for element in found:
        if element["/S"] in ("/Figure", "/Formula"):
            assert str(element.get("/Alt", "")).strip(), element["/S"]
    words = [str(element["/Alt"]) for element in found if element["/S"] == "/Formula"]
    assert any(re.match(r"a_0\* = α0/\(e\* FC\) = [\d.]+/\([\d.]+ · 1.35\) = [\d.]+ g$", word) for word in words)


@pytest.mark.shows("note.standards")
def test_that_a_checker_of_pdf_ua_finds_nothing(content, tmp_path):
    """pdfua, by others: a part of the conditions of PDF/UA-1 that a machine can judge."""
    pdfua = pytest.importorskip("pdfua")
    (tmp_path / "n.pdf").write_bytes(content)
    report = pdfua.validate(tmp_path / "n.pdf")
    assert [f"{finding.rule_id}: {finding.message}" for finding in report.findings] == []


@pytest.mark.shows("note.walls")
@pytest.mark.parametrize("extent", ["brief", "full"])
def test_that_each_wall_begins_a_page_and_has_two_at_most_in_the_full_note_each_hinge_three(whole_building, extent):
    report = replace(whole_building.case.report, extent=extent)
    result = replace(whole_building, case=replace(whole_building.case, report=report))
    note = note_of(result, Path())
    pages = pypdf.PdfReader(io.BytesIO(note.pdf())).pages
    begun = [one["page"] for one in note.places() if "wall" in one and one["y"] < 80.0]
    written, most = (result.verdicts, 2) if extent == "brief" else (result.walls, 3)
    assert len(begun) == len(written) and len(set(begun)) == len(begun)
    after = next(k for k, page in enumerate(pages, 1) if k > begun[-1] and "Site and demand" in _plain(page))
    ends = [*begun[1:], after]
    assert all(end - first <= most for first, end in zip(begun, ends, strict=True))
    for page in begun:
        assert _plain(pages[page - 1]).splitlines()[0].startswith("Three-storey")


@pytest.mark.shows("note.brief")
def test_that_the_first_page_of_a_brief_note_has_every_wall_and_the_signature(whole_building, file):
    """Ten pages at most, two of them a wall; the outcome, zeta and what is to be done of each wall on the first."""
    first, words = _plain(file.pages[0]), " ".join(_plain(page) for page in file.pages).split()
    assert len(file.pages) <= 10 and len(words) <= 4200
    for verdict in whole_building.verdicts:
        said = whole_building.walls[verdict.governing].assessment.verdict
        assert verdict.title in first and f"{said.zeta_e:.2f}" in first
        assert f"{verdict.zeta_least:.2f}" in first
    assert "Signature and stamp" in first


def _plain(page) -> str:
    return page.extract_text()


@pytest.mark.shows("batch.extract", "note.holds_case")
def test_that_the_case_its_results_and_the_list_of_records_lie_within(whole_building, content, tmp_path):
    path = tmp_path / "note.pdf"
    path.write_bytes(content)
    written = note_file.extract(path, tmp_path / "x")
    assert sorted(one.name for one in written) == ["case.toml", "records.csv", "results.json"]
    table = json.loads((tmp_path / "x" / "results.json").read_text())
    assert "started_utc" not in table and '"seconds"' not in (tmp_path / "x" / "results.json").read_text()
    zetas = [wall["verdict"]["zeta_e"] for wall in table["walls"]]
    assert zetas == [wall.assessment.verdict.zeta_e for wall in whole_building.walls]
    rows = (tmp_path / "x" / "records.csv").read_text().splitlines()
    assert len(rows) == 1 + len(whole_building.motions) and whole_building.motions[0].samples_sha256 in rows[1]
    assert read_case(path) == read_case(tmp_path / "x" / "case.toml") == replace(whole_building.case, walls=None)
    with pytest.raises(InputError) as refused:
        note_file.extract(path, tmp_path / "x")
    assert refused.value.code == "extract_overwrites"


def test_that_a_case_is_attached_as_it_was_written_with_its_comments(verdict, whole_building):
    source = "# a comment\n" + (ROOT / "resources" / "cases" / "example.toml").read_text()
    one = replace(verdict, case=read_case(ROOT / "resources" / "cases" / "example.toml"))
    assert note_attachments(replace(one, case=replace(one.case, source=source)))[0].content == source
    # the walls of a table stand in the case itself
    assert note_attachments(verdict)[0].content.count("[[wall]]") == len(verdict.case.wall)


@pytest.mark.shows("note.same_bytes")
def test_that_the_same_result_gives_the_same_bytes_on_any_day(verdict):
    other = replace(verdict, started_utc="2031-01-01T00:00:00Z")
    assert note_as_pdf(other, Path()) == note_as_pdf(verdict, Path())
    dated = replace(verdict.case.report, date="25/11/2026")
    dated = note_as_pdf(replace(other, case=replace(other.case, report=dated)), Path())
    assert pypdf.PdfReader(io.BytesIO(dated)).metadata.creation_date.date().isoformat() == "2026-11-25"
    assert day_of("in autumn") == NO_DATE and day_of("2026-02-30") == NO_DATE


@pytest.mark.shows("note.standards")
def test_that_a_note_of_pdf_a_1b_has_no_files_within(verdict, tmp_path):
    asked = replace(verdict.case.report, pdf_standard="a-1b")
    path = tmp_path / "n.pdf"
    path.write_bytes(note_as_pdf(replace(verdict, case=replace(verdict.case, report=asked)), Path()))
    said = pypdf.PdfReader(path).trailer["/Root"]["/Metadata"].get_object().get_data().decode()
    assert "pdfaid:part>1<" in said and "pdfaid:conformance>B<" in said
    with pytest.raises(InputError) as refused:
        read_case(path)
    assert refused.value.code == "note_without_case"


def test_that_a_file_that_is_no_note_is_refused_in_one_sentence(tmp_path, capsys):
    path = tmp_path / "n.pdf"
    packed = with_file(b"\x78\x9c\x00", NameObject("/FlateDecode"), size=9)
    for damaged in (b"%PDF-1.7\n", b"%PDF-1.7\n" + b"\x00\xff" * 500, b"hello", packed, packed[:-300] + b"%%EOF"):
        path.write_bytes(damaged)
        assert program.main(["--extract", str(path), "--output", str(tmp_path / "x")]) == 1
        said = capsys.readouterr().err
        assert said.startswith("error:") and said.count("\n") == 1 and "Traceback" not in said
    assert not (tmp_path / "x").exists()
    assert program.main(["--extract", str(tmp_path / "none.pdf")]) == 1


def with_file(data: bytes, packing, name: str = note_file.CASE, size: int | None = None) -> bytes:
    """A PDF with a file within."""
    writer = pypdf.PdfWriter()
    writer.add_blank_page(100, 100)
    file = writer.add_attachment(name, data).pdf_object["/EF"]["/F"].get_object()
    file[NameObject("/Filter")] = packing
    if size is not None:
        file[NameObject("/Params")] = pypdf.generic.DictionaryObject({NameObject("/Size"): NumberObject(size)})
    stream = io.BytesIO()
    writer.write(stream)
    return stream.getvalue()


def test_that_files_of_others_within_a_note_are_not_unpacked(tmp_path, monkeypatch):
    path = tmp_path / "n.pdf"
    path.write_bytes(with_file(b"41" * 1000 + b">", NameObject("/ASCIIHexDecode"), "photographs.zip"))
    monkeypatch.setattr("pypdf.filters.ASCIIHexDecode.decode", lambda *_, **__: pytest.fail("unpacked"))
    assert note_file.unpacked(path.read_bytes(), note_file.NOTE_FILES) == {}


@pytest.mark.shows("doors.bombs")
def test_that_what_unpacks_without_an_end_is_refused_after_its_time(tmp_path, monkeypatch):
    monkeypatch.setattr(note_file, "SECONDS", 1.0)
    path = tmp_path / "n.pdf"
    path.write_bytes(with_file(b"z" * 30_000_000 + b"~>", NameObject("/ASCII85Decode")))
    with pytest.raises(InputError) as refused:
        note_file.files_within(path)
    assert refused.value.code == "note_too_much"


@pytest.mark.shows("batch.extract")
def test_that_a_note_gives_its_files_to_the_command_line(content, tmp_path, capsys):
    path = tmp_path / "note.pdf"
    path.write_bytes(content)
    assert program.main(["--extract", str(path), "--output", str(tmp_path / "x")]) == 0
    assert sorted(one.name for one in (tmp_path / "x").iterdir()) == ["case.toml", "records.csv", "results.json"]
    assert "case.toml" in capsys.readouterr().out


@pytest.mark.shows("note.holds_case")
def test_that_a_note_is_a_case_for_the_batch(verdict, tmp_path, capsys):
    path = tmp_path / "n.pdf"
    one = replace(verdict, case=replace(verdict.case, record=(), wall=verdict.case.wall[:1]))
    path.write_bytes(note_as_pdf(one, Path()))
    assert program.main(["--batch", str(path), "--output", str(tmp_path), "--quiet"]) in (0, 3)
    assert (tmp_path / "n.xlsx").exists()


@pytest.mark.shows("note.office")
def test_that_logo_letterhead_and_font_are_of_the_office_or_refused(verdict, tmp_path):
    def set_with(**report):
        asked = replace(verdict.case.report, **report)
        return note_as_pdf(replace(verdict, case=replace(verdict.case, report=asked)), tmp_path)

    (tmp_path / "logo.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><rect width="9" height="9"/></svg>'
    )
    found = pypdf.PdfReader(io.BytesIO(set_with(letterhead="Studio Rossi | via Roma 1", logo="logo.svg")))
    assert "Studio Rossi\nvia Roma 1" in _plain(found.pages[0]) and "Studio" not in _plain(found.pages[1])
    (tmp_path / "text.png").write_text("no picture")
    (tmp_path / "broken.png").write_bytes(b"\x89PNG\r\n\x1a\n" + b"\x00" * 40)
    for report, code in (
        ({"logo": "none.png"}, "logo_unreadable"),
        ({"logo": "text.png"}, "logo_not_set"),
        ({"logo": "broken.png"}, "logo_not_set"),
        ({"font": "No Such Font"}, "no_font"),
    ):
        with pytest.raises(InputError) as refused:
            set_with(**report)
        assert refused.value.code == code and refused.value.text("it").count("\n") == 0


def shown(text: str) -> str:
    """A text as a reader sees it: without spaces, what no font shows as its code."""
    plain = unicodedata.normalize("NFKC", re.sub(r"\s|[\u200b-\u200f\u2028-\u202e\ufe0f]", "", text))
    return "".join(plain.split())


def texts(count: int, seed: int):
    draw = random.Random(seed)
    for _ in range(count):
        yield "".join(draw.choice(ALPHABET) for _ in range(draw.choice((1, 5, 40, 200))))


def typed(parts) -> str:
    return "".join(page.extract_text() for page in pypdf.PdfReader(io.BytesIO(Note(parts, "it").pdf())).pages)


@pytest.mark.shows("doors.markup")
def test_that_texts_of_a_user_are_text_and_no_code():
    code = [
        '#panic("x")',
        "$ sum_1 $",
        "= H",
        "- a",
        "/ b: c",
        "*b* _i_ `r`",
        "@x <y>",
        "\\u{41}",
        "#set page(width: 1pt)",
        '")#x("',
    ]
    said = shown(
        typed(
            [Heading("#title $x$ \\", 1), *map(Paragraph, code), Table(code[:2], [code[2:4]], (1, 1)), *map(Item, code)]
        )
    )
    for one in ["#title $x$ \\", *code]:
        assert shown(one) in said, one


@pytest.mark.parametrize("count", [300, pytest.param(100_000, marks=pytest.mark.long)])
def test_that_any_text_is_set_and_said(count):
    """Letters of every kind, control characters, right to left; what no font of this machine has is its code."""
    drawn = list(texts(count, 7))
    for k in range(0, count, 1000):
        some = drawn[k : k + 1000]
        Note([Heading(some[0], 1), *map(Paragraph, some)], "it").pdf()
        for text in some:
            assert not any(unicodedata.category(letter) == "Cc" and letter not in "\n\t" for letter in legible(text))
    latin = [re.sub("[^\u0020-\u007e\u00a1-\u017f]", "", text) for text in drawn[:300]]
    said = shown(typed(list(map(Paragraph, latin))))
    assert all(shown(text) in said for text in latin)
    Note([Paragraph("x#" * 5000), Paragraph("#" * 10_000)], "en").pdf()


def test_that_a_figure_is_laid_out_to_scale_with_round_marks():
    assert figure_geometry.ticks(0.0, 1.2) == pytest.approx([0.0, 0.25, 0.5, 0.75, 1.0])
    assert figure_geometry.ticks(-3.0, 41.0) == [0.0, 10.0, 20.0, 30.0, 40.0]
    square = [Curve("", [0.0, 2.0, 2.0, 0.0], [0.0, 0.0, 2.0, 2.0], "ink")]
    points = np.array(figure_geometry.laid_out(Figure("c", square), Words("en"))["marks"][0]["points"])
    assert np.ptp(points[:, 0]) == pytest.approx(np.ptp(points[:, 1]), abs=2e-3)
    line = Figure("c", [Curve("one", [0.0, 1.0], [0.0, 10.0], "bad")], "t [s]", "d [cm]", (0.0, 1.0), (0.0, 10.0))
    laid = figure_geometry.laid_out(line, Words("it"))
    wide, high = laid["area"][2:]
    assert np.allclose(laid["marks"][0]["points"], [[0.0, high], [wide, 0.0]], atol=1e-3)
    assert [mark[1] for mark in laid["x_ticks"]] == ["0", "0,2", "0,4", "0,6", "0,8", "1"]
    assert picture(line, Words("it"))[:8] == b"\x89PNG\r\n\x1a\n"
