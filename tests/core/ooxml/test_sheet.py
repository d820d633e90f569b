"""A sheet is read the same whoever wrote it, and what is not seen in it is named."""

import datetime
import io
import random

import openpyxl
import pytest

from core.errors import InputError
from core.ooxml.sheet import MAX_AREAS, Limits, hidden_notes, letters, read_sheet, refuse_cells, spoken
from tests.core.ooxml.writers import WRITERS, Day, Fault, Formula, Writer, packed, unpacked, workbook

LIMITS = Limits(rows=100, columns=30, cells=500, size=5_000_000)
ROWS = [
    ["t [s]", None, "a & b <g>", "è"],
    [0, 0.1, -1.5e-05, True],
    [],
    [83.00000000000001, Formula("A2*2", 0.25), Formula("1/3"), Fault("#DIV/0!"), Day(45413)],
]
SHEET = "xl/worksheets/sheet1.xml"


def read(content, chosen=0, limits=LIMITS):
    return read_sheet(content, limits, lambda names: chosen)


def with_part(part: str, old: str, new: str, content=None) -> bytes:
    """A workbook with a piece of one part exchanged."""
    parts = unpacked(content or workbook(Writer(), ROWS))
    assert old.encode() in parts[part]
    return packed({**parts, part: parts[part].replace(old.encode(), new.encode(), 1)})


@pytest.mark.parametrize("writer", WRITERS.values(), ids=WRITERS)
def test_that_every_writer_gives_the_same_cells_and_findings(writer):
    content = workbook(
        writer,
        ROWS,
        merged=("A1:B1", "C2:C4"),
        hidden_rows=(2, 3),
        hidden_columns=(1, 2),
        others=[("Vecchio", [["x"]])],
    )
    sheet = read(content)
    assert sheet.name == "Foglio 1"
    assert [sheet.texts(row, "-") for row in range(1, 5)] == [
        ["t [s]", "-", "a & b <g>", "è"],
        ["0", "0.1", "-1.5e-05", "True"],
        [],
        ["83.00000000000001", "0.25", "-", "#DIV/0!", "2024-05-01 00:00:00"],
    ]
    assert [cell.is_number for cell in sheet.rows[4].values()] == [True, True, False, False]
    assert sheet.merged == [(1, 1, 1, 2), (2, 3, 4, 3)]
    assert sheet.formulas == [(4, 2), (4, 3)] and sheet.uncomputed == [(4, 3)]
    assert sheet.errors == [(4, 4)]
    assert (sheet.hidden_rows, sheet.hidden_columns) == ([2, 3], [1, 2])
    assert sheet.other_sheets == sheet.hidden_sheets == ["Vecchio"]


def test_that_what_openpyxl_writes_and_reads_is_read_alike():
    chance, made = random.Random(3), openpyxl.Workbook()
    kinds = (
        lambda: chance.uniform(-1, 1),
        lambda: chance.randrange(10**6),
        lambda: f"è & <{chance.random()}>",
        lambda: None,
        lambda: chance.uniform(-1, 1) * 10.0 ** chance.randrange(-300, 300),
        lambda: True,
    )
    for _ in range(60):
        made.active.append([chance.choice(kinds)() for _ in range(7)])
    room = io.BytesIO()
    made.save(room)
    sheet = read(room.getvalue())
    back = openpyxl.load_workbook(room).active
    for row in range(1, 61):
        cells = [back.cell(row, k).value for k in range(1, 8)]
        texts = sheet.texts(row) + [""] * 7
        assert texts[:7] == ["" if value is None else str(value) for value in cells]


@pytest.mark.parametrize(
    ("code", "is_date"),
    [
        ("General", False),
        ("0.00", False),
        ('0.00" days"', False),
        (r"0.0\s", False),
        ("[Red]0.0;[<1]0", False),
        ("[$-410]#,##0.00", False),
        ("yyyy", True),
        ("mm:ss.000", True),
        ("[h]:mm", True),
        ("d/m/yy", True),
    ],
)
def test_that_a_number_shown_as_a_date_is_no_number(code, is_date):
    content = with_part(
        "xl/styles.xml",
        "[$-410]dd/mm/yyyy",
        code.replace('"', "&quot;").replace("<", "&lt;"),
        workbook(Writer(), [[Day(2.5)]]),
    )
    cell = read(content).rows[1][1]
    assert cell.is_number is not is_date
    assert cell.text == (str(datetime.datetime(1900, 1, 1, 12)) if is_date else "2.5")


def test_that_dates_count_from_1904_where_the_workbook_says_so():
    content = workbook(Writer(), [[Day(1.0)]])
    content = with_part("xl/workbook.xml", "<sheets>", '<workbookPr date1904="1"/><sheets>', content)
    assert read(content).texts(1) == ["1904-01-02 00:00:00"]
    assert read(workbook(Writer(), [[Day(1e300)]])).texts(1) == ["1e+300 d"]


@pytest.mark.parametrize("writer", WRITERS.values(), ids=WRITERS)
def test_that_letters_written_as_codes_are_read_as_letters(writer):
    rows = [["_x0041_b_x000D_", "_x005F_x0041_", "x_y_x00_", "_xD83D__xDE00_", "_xD83D_"]]
    assert read(workbook(writer, rows)).texts(1) == ["Ab\r", "_x0041_", "x_y_x00_", "😀", "�"]


def test_that_rich_texts_are_joined_without_the_readings_of_their_signs():
    parts = "<r><rPr><b/></rPr><t>Muri</t></r><r><t xml:space='preserve'> di spina</t></r><rPh><t>x</t></rPh>"
    rich = with_part("xl/sharedStrings.xml", "<t xml:space='preserve'>a</t>", parts, workbook(Writer(), [["a", "b"]]))
    assert read(rich).texts(1) == ["Muri di spina", "b"]


def test_that_the_sheet_that_is_asked_for_is_read():
    content = workbook(Writer(), [["a"]], others=[("Due", [["b"]]), ("Tre", [["c"]])])
    content = with_part("xl/workbook.xml", 'state="hidden"', 'state="visible"', content)
    sheet = read(content, 1)
    assert sheet.texts(1) == ["b"] and sheet.other_sheets == ["Foglio 1", "Tre"]
    assert sheet.hidden_sheets == ["Tre"]
    with pytest.raises(InputError, match="every sheet is hidden"):
        read(workbook(Writer(), [["a"]], state="veryHidden"))


def test_that_what_is_shown_is_left_without_hidden_rows_and_columns():
    rows = [["Parete", "B", "H"], ["a", Formula("1", 1), 3], ["b", Fault("#N/A"), 4], ["c", None, 5]]
    whole = read(workbook(Writer(), rows, hidden_rows=(3, 9), hidden_columns=(2, 4)))
    seen = whole.as_shown()
    assert [seen.texts(row) for row in range(1, 5)] == [["Parete", "H"], ["a", "3"], [], ["c", "5"]]
    assert seen.formulas == seen.errors == [] and whole.formulas and whole.errors
    notes = [note.text() for note in hidden_notes(whole, are_read=False)]
    assert notes == [
        "Hidden rows of the table of walls were not read: 3.",
        "Hidden columns of the table of walls were not read: B (B).",
    ]
    assert [note.code for note in hidden_notes(whole, True)] == ["hidden_rows_read", "hidden_columns_read"]
    assert hidden_notes(read(workbook(Writer(), [[1], [], [2]], hidden_rows=(2,))), True) == []


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ('hidden="1"', "hidden='true'"),
        ('width="9" hidden="1"', 'width="0" customWidth="1"'),
        ('min="2" max="2"', 'min="2" max="16384"'),
    ],
)
def test_that_a_column_is_hidden_however_a_workbook_says_it(old, new):
    content = workbook(Writer(), [["a", "b"]], hidden_columns=(2,))
    assert read(with_part(SHEET, old, new, content)).hidden_columns == [2]


@pytest.mark.parametrize(
    ("rows", "words"),
    [
        ([[1.0]] * 101, "beyond row 100"),
        ([[None] * 30 + [1.0]], "column 30"),
        ([[1.0] * 26] * 20, "more than 500"),
        ([[1.0]] * 100, None),
        ([[None] * 29 + [1.0]], None),
        ([[1.0] * 25] * 20, None),
    ],
)
def test_that_a_value_beyond_the_limits_is_refused_and_never_left_out(rows, words):
    content = workbook(Writer(), rows)
    if words is None:
        read(content)
        return
    with pytest.raises(InputError, match=words):
        read(content)


def test_that_empty_cells_beyond_the_limits_are_none():
    far = '<row r="1048576"><c r="XFD1048576" s="1"/></row></sheetData>'
    assert read(with_part(SHEET, "</sheetData>", far)).last_row == 4


def test_that_elements_of_the_same_names_elsewhere_are_no_cells():
    other = '<e:ext xmlns:e="u"><f/><c r="?"><f/><v>1</v></c><row r="?"/><mergeCell ref="?"/><col min="?" width="0"/>'
    found = read(with_part(SHEET, "</worksheet>", other + "<t>x</t></e:ext></worksheet>"))
    assert found == read(workbook(Writer(), ROWS))


def test_that_areas_are_bounded():
    areas = "<mergeCells>" + '<mergeCell ref="A1:XFD1048576"/>' * (MAX_AREAS + 1) + "</mergeCells>"
    with pytest.raises(InputError, match="more parts"):
        read(with_part(SHEET, "</worksheet>", areas + "</worksheet>"))


@pytest.mark.parametrize(
    ("part", "old", "new"),
    [
        (SHEET, 'r="A2"', 'r="A3"'),
        (SHEET, 'r="B2"', 'r="A2"'),
        (SHEET, 'r="A1"', 'r="A0"'),
        (SHEET, 'r="A1"', 'r="1A"'),
        (SHEET, 'r="A1"', 'r="ZZZ1"'),
        (SHEET, '<row r="4"', '<row r="2"'),
        (SHEET, '<row r="4"', '<row r="-4"'),
        (SHEET, "<v>0.1</v>", "<v>0,1</v>"),
        (SHEET, "<v>0.1</v>", "<v>1E999</v>"),
        (SHEET, "<v>0.1</v>", "<v>NaN</v>"),
        (SHEET, "<v>0</v>", "<v>-1</v>"),
        (SHEET, "<v>0</v>", "<v>99</v>"),
        (SHEET, "</row>", ""),
        (SHEET, "<worksheet ", "<w:worksheet "),
        ("xl/workbook.xml", "<sheets>", "<sheets"),
        (SHEET, 'encoding="utf-8"', 'encoding="utf-1e8"'),
        ("xl/styles.xml", 'numFmtId="0"', 'numFmtId="x"'),
        ("_rels/.rels", 'officeDocument"', 'thumbnail"'),
    ],
)
def test_that_a_damaged_workbook_is_refused_in_one_sentence(part, old, new):
    with pytest.raises(InputError, match="not a workbook Excel could have saved"):
        read(with_part(part, old, new))


def test_that_cells_are_named_up_to_a_dozen():
    assert [letters(k) for k in (1, 26, 27, 702, 703, 16384)] == ["A", "Z", "AA", "ZZ", "AAA", "XFD"]
    assert spoken([(3, 2), (1, 1, 4, 28), 7, "x"]) == "B3, A1:AB4, 7, x"
    assert spoken(range(1, 30)).endswith("11, 12, … (29)")
    refuse_cells({"merged_cells": [], "error_cells": []})
    with pytest.raises(InputError) as caught:
        refuse_cells({"merged_cells": [(1, 1, 2, 1)], "formula_cells": [], "error_cells": [(3, 2)]})
    assert str(caught.value).startswith("merged cells A1:A2, errors B3: each cell")
    assert caught.value.text("it").startswith("celle unite A1:A2, errori B3: ogni cella")
