"""Rows as text: what openpyxl reads back is what was put in, packed or not."""

import datetime
from io import BytesIO

import pytest
from openpyxl import load_workbook

from core.report import sheet_rows
from core.report.cells import Book, fill, merge, number, text


def made(book: Book, packed: bool):
    """A sheet of texts, numbers, formulas, merged and empty cells, some rows of which have a height."""
    sheet = book.sheet("Check", [10, 20])
    text(sheet, 1, 1, "head")
    for row in range(3, 40):
        text(sheet, row, 1, f" <{row}> & è ", bold=row % 2 == 0)
        fill(number(sheet, row, 2, row / 3.0, "0.00"), "FF00FF")
        book.formula(sheet.cell(row, 4), f'=IF(B{row}<5,"&",B{row}*2)', "&" if row % 3 else row * 2.0)
        sheet.cell(row, 6)
        if row % 5 == 0:
            merge(sheet, row, 7, row, 9)
            sheet.row_dimensions[row].height = 20.0 + row
        if packed and row % 4 == 0:
            book.rows_of(sheet).pack(2, row)
    sheet.cell(41, 2).value = datetime.date(2026, 11, 25)
    sheet.cell(42, 2).value = True
    sheet.row_dimensions[45].height = 50.0
    book.workbook.remove(book.workbook.worksheets[0])
    return book


@pytest.mark.parametrize("values", [False, True])
def test_that_packed_rows_are_those_that_are_not(monkeypatch, values):
    monkeypatch.setattr(sheet_rows, "PACKED_ROWS", 6)
    packed, plain = (made(Book("en"), one) for one in (True, False))
    held = len(packed.workbook.worksheets[0]._cells)
    assert held < 0.3 * len(plain.workbook.worksheets[0]._cells)
    one, other = (load_workbook(BytesIO(book.content()), data_only=values).worksheets[0] for book in (packed, plain))
    assert one.dimensions == other.dimensions and set(one._cells) == set(other._cells)
    for place, cell in one._cells.items():
        twin = other._cells[place]
        assert (getattr(cell, "value", None), cell.number_format) == (getattr(twin, "value", None), twin.number_format)
        assert repr((cell.font, cell.fill, cell.alignment)) == repr((twin.font, twin.fill, twin.alignment)), place
    assert sorted(map(str, one.merged_cells.ranges)) == sorted(map(str, other.merged_cells.ranges))
    heights = [{k: row.height for k, row in sheet.row_dimensions.items() if row.height} for sheet in (one, other)]
    assert heights[0] == heights[1] and heights[0][45] == 50.0
    assert one["B41"].value == datetime.datetime(2026, 11, 25) and one["B42"].value is True
    assert one["A3"].value == " <3> & è " and one["B3"].value == pytest.approx(1.0, rel=1e-15)
    assert one["D6"].value == (12.0 if values else '=IF(B6<5,"&",B6*2)')
