"""Every word of the workbook and of the document is seen on its page: none lies under a drawing or is cut off."""

import shutil
import subprocess
from dataclasses import replace

import pytest

from app.terminal import export
from core.report.assumption_table import tabled
from core.report.verdict_words import lines_of, sentence_of, sort_results
from core.study.governing import collapse_histories
from core.study.run import run
from tests.conftest import ROOT
from tests.core.report import whole_workbook
from tests.core.report.ink import words_of, words_without_ink


def printed(path, folder):
    """A workbook or document as LibreOffice prints it."""
    office = shutil.which("soffice") or shutil.which("libreoffice")
    if not office:
        pytest.skip("LibreOffice is not installed: nothing is printed")
    subprocess.run(
        [
            office,
            "--headless",
            f"-env:UserInstallation=file://{folder}/profile",
            "--convert-to",
            "pdf",
            "--outdir",
            folder,
            path,
        ],
        check=True,
        capture_output=True,
        timeout=240,
    )
    return path.with_suffix(".pdf")


def assert_seen(pdf, result):
    """All words, and those of the verdicts among them."""
    assert words_without_ink(pdf) == []
    words = {word for page in words_of(pdf) for word, _ in page}
    language = result.case.report.language
    for wall, decides in sort_results(result):
        if decides:
            rows = tabled(wall, language)
            lines = [line for line in lines_of(result, wall, language) if line not in rows]
            said = (sentence_of(wall, language), *lines)
            assert set(" ".join(said).split()) <= words


@pytest.fixture(scope="module")
def one_wall(verdict):
    case = replace(verdict.case, wall=verdict.case.wall[:1])
    return run(case, base_dir=ROOT / "resources" / "cases")


@pytest.mark.long
@pytest.mark.parametrize("which", ["one_wall", "verdict", "whole_building"])
def test_that_no_word_of_the_workbook_is_hidden(which, request, tmp_path):
    result = request.getfixturevalue(which)
    drawn = [found for wall in result.walls if (found := collapse_histories(result, wall))]
    path = tmp_path / "book.xlsx"
    path.write_bytes(whole_workbook.content(result, drawn))
    assert_seen(printed(path, tmp_path), result)


@pytest.mark.long
@pytest.mark.parametrize("which", ["verdict", "whole_building"])
def test_that_no_word_of_the_document_is_hidden(which, request, tmp_path):
    pytest.importorskip("docx")
    result = request.getfixturevalue(which)
    path = tmp_path / "note.docx"
    path.write_bytes(export.note_content(result, path, None))
    assert_seen(printed(path, tmp_path), result)


@pytest.mark.shows("note.hidden")
@pytest.mark.parametrize("which", ["verdict", pytest.param("whole_building", marks=pytest.mark.long)])
def test_that_no_word_of_the_pdf_is_hidden(which, request, tmp_path):
    pytest.importorskip("typst")
    result = request.getfixturevalue(which)
    path = tmp_path / "note.pdf"
    path.write_bytes(export.note_content(result, path, None))
    assert words_without_ink(path) == []
