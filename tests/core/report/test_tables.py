"""A table is one description: sheet, note and window show the same rows."""

import math

import pytest

from core.report.cells import Book
from core.report.note.parts import table_of_rows
from core.report.record_tables import origin_of_records, records_as_read, rows_of_records, rules_of_codes
from core.report.sheet_table import write_table
from core.report.tables import NOTE, SHEET, WINDOW, DataColumn, DataTable
from core.report.wall_tables import checks_of_wall, modes_of_floor, numbered_modes, rows_of_checks, variants_of_walls
from core.report.words import Words
from core.study.run import run
from core.study.variants import compare_walls
from tests.clauses_alone import parse_case
from tests.conftest import ROOT

TABLE = DataTable(
    (
        DataColumn("name", lambda row: row[0], width=20),
        DataColumn("share", lambda row: row[1], ".1%", tone=lambda row: "bad" if row[1] and row[1] > 0.5 else ""),
        DataColumn("empty", lambda row: None),
        DataColumn("file", lambda row: "f", only=(SHEET,)),
    ),
    folds=True,
)
ROWS = [("one", 0.257), ("two", None), ("three", 0.75)]
SPECTRUM = {"code": "NTC2018", "f0": 2.45, "tc_star_s": 0.33, "soil": "B", "topography": "T1"}
WALL = {"name": "a", "mechanism": "one_sided", "height_m": 3.0, "thickness_m": 0.5, "unit_weight_kn_m3": 18.0}
WALL |= {"base_z_m": 6.0, "unloaded_confirmed": True, "hold": [{"kind": "contact", "to_m": 3.0}], "length_m": 5.0}
CASE = {
    "demand": {"ag_g": 0.1, "spectrum": SPECTRUM},
    "building": {"height_m": 9.0, "storeys": 3, "period_s": 0.3},
    "generate": {"count": 3},
    "wall": [WALL | {"variant": "stato di fatto"}, WALL | {"variant": "progetto", "thickness_m": 0.6}],
}


@pytest.fixture(scope="module")
def result():
    return run(parse_case(CASE), base_dir=ROOT)


def sheet_cells(table, rows, language="it"):
    book = Book(language)
    sheet = book.sheet("Records", [20.0] * len(table.columns))
    last = write_table(book, sheet, 1, table, rows)
    head, *values = sheet.iter_rows(min_row=1, max_row=last, values_only=True)
    return list(head), [list(row) for row in values]


def test_that_faces_show_their_columns_and_the_note_none_that_is_empty():
    head, values = sheet_cells(TABLE, ROWS)
    assert head == ["name", "share", "empty", "file"]
    assert values[0] == ["one", 0.257, "–", "f"] and values[1][1] == "–"
    note = table_of_rows(TABLE, ROWS, Words("it").number)
    assert list(note.heads) == ["name", "share"] and note.rows[0] == ["one", "25,7 %"] and note.rows[1][1] == "–"
    assert note.tones == {(2, 1): "bad"} and TABLE.folded(NOTE, ROWS) == ["empty"]
    assert TABLE.words(WINDOW, ROWS, Words("en").number)[2] == ["three", "75.0 %"]


def tables(result):
    book, wall = Words("it"), result.walls[0]
    yield records_as_read(book), rows_of_records(result)
    yield origin_of_records(book), rows_of_records(result)
    yield rules_of_codes(book), result.compliance.rules
    yield checks_of_wall(book), list(rows_of_checks(wall, "it"))
    yield variants_of_walls(book, result), compare_walls(result.verdicts)
    yield modes_of_floor(book), numbered_modes(wall.floor)


def test_that_every_table_of_a_result_has_the_same_cells_on_sheet_and_in_words(result):
    compared, number = 0, Words("it").number
    for table, rows in tables(result):
        assert rows
        columns, (_, values) = table.shown(SHEET, rows), sheet_cells(table, rows)
        for row, cells in zip(rows, values, strict=True):
            for column, cell in zip(columns, cells, strict=True):
                (words,) = DataTable((column,)).words(column.only[0] if column.only else WINDOW, [row], number)[0]
                if isinstance(cell, float):
                    scale = 100.0 if words.endswith("%") else 1.0
                    read = float(words.rstrip(" %").replace(",", ".").replace("−", "-"))
                    assert math.isclose(read, scale * cell, rel_tol=1e-4, abs_tol=0.5), (column.head, words, cell)
                else:
                    assert str(cell) in (words, "0"), (column.head, words, cell)
                compared += 1
    assert compared > 60
