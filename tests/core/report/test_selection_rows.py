"""The choice of records in the workbook, the note and the JSON."""

import pytest

from core.report.note.content import full_note
from core.report.note.parts import Figures, Paragraph, Table
from core.report.selection_words import lines_of
from core.study import run as study
from core.text.sentence import localized
from tests.core.report import whole_workbook
from tests.core.study.folder_of_records import case, write_folder


@pytest.fixture(scope="module")
def chosen(tmp_path_factory):
    base = tmp_path_factory.mktemp("select")
    write_folder(base)
    return study.run(case(demand=None), base_dir=base)


def say(text, **values):
    return localized("report", text, "en", **values)


def test_that_the_lines_say_what_was_looked_at_and_how_near_it_is(chosen):
    lines, best = lines_of(chosen.selection, say, "en"), chosen.selection.chosen
    assert lines[0] == "Chosen from recs: 20 horizontal records of 23 files."
    assert lines[1] == "Every combination was compared."
    assert f"{best.lowest[1]:.2f} at {best.lowest[0]:.2f} s" in lines[2]
    assert "a vertical component" in lines[-1] and "(1)" in lines[-1]
    assert any("No set that was found" in line for line in lines) == (not best.fits)


def test_that_the_note_lists_and_draws_the_chosen(chosen):
    parts = full_note(chosen, "it")
    heads = [part for part in parts if isinstance(part, Table) and "".join(part.heads[:1]) == "Accelerogramma"]
    assert len(heads[-1].rows) == 3
    assert any("Scelti da recs" in part.text for part in parts if isinstance(part, Paragraph))
    figures = [figure for part in parts if isinstance(part, Figures) for figure in part.figures]
    drawn = next(figure for figure in figures if figure.caption.startswith("Spettri al 5 %"))
    assert [curve.name for curve in drawn.curves if curve.name] == ["spettro", "media"]
    assert len(drawn.curves) == 3 + 2 + 2


def test_that_the_sheet_of_the_records_lists_the_sets_and_what_is_left_out(chosen):
    sheet = whole_workbook.build(chosen, []).workbook[localized("report", "Records", "en")]
    cells = [str(cell.value) for row in sheet.iter_rows() for cell in row if cell.value is not None]
    assert sum(" × " in cell for cell in cells) == len(chosen.selection.sets)
    for one in chosen.selection.left_out:
        assert any(cell.startswith(one.file.name) for cell in cells)
