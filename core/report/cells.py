"""Cells of the workbook: styles, safe text, live formulas that also carry their value."""

import math
import re
import zipfile
from collections.abc import Callable, Iterable, Iterator, Sequence
from copy import copy
from dataclasses import dataclass, field
from io import BytesIO
from weakref import WeakKeyDictionary

from openpyxl import Workbook
from openpyxl.cell.cell import ILLEGAL_CHARACTERS_RE, Cell
from openpyxl.drawing.spreadsheet_drawing import SpreadsheetDrawing
from openpyxl.styles import Alignment, Border, Font, PatternFill, Side
from openpyxl.utils import get_column_letter
from openpyxl.workbook.defined_name import DefinedName
from openpyxl.worksheet._writer import WorksheetWriter
from openpyxl.worksheet.cell_range import CellRange
from openpyxl.worksheet.dimensions import SheetDimension
from openpyxl.worksheet.worksheet import Worksheet
from openpyxl.writer.excel import ExcelWriter

from core.file_names import shown
from core.report.sheet_rows import SheetRows
from core.report.steps import Steps
from core.report.xml_text import escape_for_cell
from core.text.sentence import format_number, localized, title_in

INK = "1F2D3D"
ACCENT = "2B5C8A"
GOOD = "1B6E4B"
BAD = "A6192E"
AMBER = "8A5A00"
QUIET = "6B7785"
LINE_COLOR = "C9D1D9"

ROW_HEIGHT = 12.6
"""Height of a row of one line [points]."""

ACCELERATION = "0.000"
RATIO = "0.00"
EXACT = "0.0000"
WHOLE = "0"

_NO_ROWS = re.compile(rb"<sheetData ?/>|<sheetData></sheetData>")


_LOOKS: WeakKeyDictionary[Workbook, dict] = WeakKeyDictionary()
"""Styles already made, by workbook: openpyxl spends a third of a large report on finding them again."""

TEXT_CHUNK = 1 << 18
"""Letters of a sheet handled at a time."""


@dataclass
class Book:
    """A workbook with its language and the values its formula cells carry.

    steps : how far it is
    of_run : names of cells that hold what no changed input moves
    """

    language: str
    steps: Steps = field(default_factory=Steps)
    workbook: Workbook = field(default_factory=Workbook)
    cached: dict[tuple[str, str], object] = field(default_factory=dict)
    of_run: set[str] = field(default_factory=set)
    _rows: dict[str, SheetRows] = field(default_factory=dict)

    def rows_of(self, sheet: Worksheet) -> SheetRows:
        """The rows of a sheet as its file has them."""
        if sheet.title not in self._rows:
            self._rows[sheet.title] = SheetRows(sheet, self.cached)
        return self._rows[sheet.title]

    def say(self, english: str, /, **values) -> str:
        """A text of the group "report" in the workbook's language."""
        return localized("report", english, self.language, **values)

    def titled(self, name: str) -> str:
        """A name of a wall, heights as the language writes them."""
        return title_in(name, self.language)

    def digits(self, value: float | None, form: str) -> str:
        """A number within a text, "–" for None; form : as of format()."""
        return format_number(value, form, self.language)

    def sheet(self, english: str, widths: Sequence[float], landscape=False) -> Worksheet:
        """A new A4 sheet, fitted to the page's width; english : its name, a text of the group "report"."""
        return self.named_sheet(self.say(english), widths, landscape)

    def named_sheet(self, name: str, widths: Sequence[float], landscape=False) -> Worksheet:
        """`sheet` of a name that is the same in every language."""
        sheet = self.workbook.create_sheet(name)
        for k, width in enumerate(widths, start=1):
            sheet.column_dimensions[get_column_letter(k)].width = width
        sheet.sheet_view.showGridLines = False
        sheet.sheet_format.defaultRowHeight, sheet.sheet_format.customHeight = ROW_HEIGHT, True
        sheet.page_setup.paperSize = sheet.PAPERSIZE_A4
        sheet.page_setup.orientation = "landscape" if landscape else "portrait"
        sheet.page_setup.fitToWidth = 1
        sheet.page_setup.fitToHeight = 0
        sheet.sheet_properties.pageSetUpPr.fitToPage = True
        sheet.page_margins.left = sheet.page_margins.right = 0.5
        sheet.page_margins.top, sheet.page_margins.bottom = 0.6, 0.8
        sheet.oddFooter.left.text = "Ribalta  &A"
        sheet.oddFooter.right.text = "&P / &N"
        return sheet

    def name(self, name: str, cell: Cell) -> None:
        """Give a cell a name of the workbook."""
        reference = f"'{cell.parent.title}'!${cell.column_letter}${cell.row}"
        self.workbook.defined_names[name] = DefinedName(name, attr_text=reference)

    def formula(self, cell: Cell, formula: str, value, number_format: str = EXACT) -> Cell:
        """A live formula and the value the program computed for it (number or text)."""
        cell.value = formula
        style(cell, number_format=number_format)
        self.cached[cell.parent.title, cell.coordinate] = value
        return cell

    def content(self) -> bytes:
        """The file. Formula cells get their value, which previewers and Protected View show."""
        self.workbook.calculation.fullCalcOnLoad = True
        plain = BytesIO()
        with zipfile.ZipFile(plain, "w", zipfile.ZIP_DEFLATED) as archive:
            _Writer(self, archive).save()
        return plain.getvalue()


class _Frame(WorksheetWriter):
    """Writes a sheet without its rows."""

    def __init__(self, sheet: Worksheet, area: str):
        super().__init__(sheet)
        self.area = area

    def write_dimensions(self):
        self.xf.send(SheetDimension(self.area).to_tree())

    def rows(self):
        return []


class _Writer(ExcelWriter):
    """Writes a workbook, its formula cells with their values."""

    def __init__(self, book: Book, archive: zipfile.ZipFile):
        super().__init__(book.workbook, archive)
        self.book, self.archive = book, archive
        sizes = [max(1, sheet.max_row) for sheet in book.workbook.worksheets]
        self.sheets = book.steps.each(book.workbook.worksheets, sizes)

    def write_worksheet(self, ws: Worksheet) -> None:
        """A sheet into the file: what openpyxl writes around the rows, and the rows between."""
        next(self.sheets)
        ws._drawing = SpreadsheetDrawing()
        ws._drawing.charts, ws._drawing.images = ws._charts, ws._images
        rows = self.book.rows_of(ws)
        writer = _Frame(ws, rows.area)
        try:
            writer.write()
            with open(writer.out, "rb") as source:
                head, end = _NO_ROWS.split(source.read())
        finally:
            writer.close()
            writer.cleanup()
        with self.archive.open(ws.path[1:], "w", force_zip64=True) as target:
            target.write(head + b"<sheetData>")
            for piece in _joined(rows.texts()):
                self.book.steps.check()
                target.write(piece.encode())
            target.write(b"</sheetData>" + end)
        ws._rels = writer._rels
        self.manifest.append(ws)

    def _write_charts(self) -> None:
        self.book.steps.check()
        super()._write_charts()
        self.book.steps.check()


def _joined(texts: Iterable[str]) -> Iterator[str]:
    """Join texts into pieces of about TEXT_CHUNK letters."""
    held, size = [], 0
    for text in texts:
        held.append(text)
        size += len(text)
        if size >= TEXT_CHUNK:
            yield "".join(held)
            held, size = [], 0
    yield "".join(held)


def cached_style(cell: Cell, key: tuple, apply: Callable[[], None]) -> Cell:
    """Change a cell's style by apply(), or by what that gave for an equal style and key before. Cells of equal
    looks share one style, which only apply may change: a large report has a million cells."""
    known = _LOOKS.setdefault(cell.parent.parent, {})
    key = (tuple(cell._style or ()), key)
    if key not in known:
        cell._style = copy(cell._style)
        apply()
        known[key] = cell._style
    cell._style = known[key]
    return cell


def fill(cell: Cell, color: str) -> Cell:
    """A plain colour behind a cell."""

    def apply() -> None:
        cell.fill = PatternFill("solid", fgColor=color)

    return cached_style(cell, ("fill", color), apply)


def frame(cell: Cell, color: str, *sides: str) -> Cell:
    """Thin lines at these sides of a cell (left, right, top, bottom)."""

    def apply() -> None:
        line = Side(style="thin", color=color)
        cell.border = Border(**dict.fromkeys(sides, line))

    return cached_style(cell, ("frame", color, sides), apply)


def style(
    cell: Cell, bold=False, color=INK, size=10, number_format=None, wrap=False, align=None, italic=False, vertical=None
) -> Cell:
    vertical = vertical or ("top" if wrap else "center")

    def apply() -> None:
        cell.font = Font(name="Calibri", size=size, bold=bold, color=color, italic=italic)
        cell.alignment = Alignment(vertical=vertical, wrap_text=wrap, horizontal=align)
        if number_format:
            cell.number_format = number_format

    return cached_style(cell, (bold, color, size, number_format, wrap, align, italic, vertical), apply)


def text(sheet: Worksheet, row: int, column: int, content, **look) -> Cell:
    """Text that can never become a formula."""
    cell = sheet.cell(row, column)
    cell.value = escape_for_cell(shown(ILLEGAL_CHARACTERS_RE.sub(" ", str(content)))[:32000])
    cell.data_type = "s"
    return style(cell, **look)


def number(sheet: Worksheet, row: int, column: int, value, number_format: str, **look) -> Cell:
    """A number, or a dash where there is none; a non-finite one is a word."""
    if value is None:
        return text(sheet, row, column, "–", align="right", **look)
    if not math.isfinite(value):
        return text(sheet, row, column, "not finite", **look)
    cell = sheet.cell(row, column, value)
    return style(cell, number_format=number_format, **look)


def title(sheet: Worksheet, row: int, content: str, size: int = 14) -> None:
    text(sheet, row, 1, content, bold=True, color=ACCENT, size=size)
    sheet.row_dimensions[row].height = 1.35 * size


def header(sheet: Worksheet, row: int, labels: list[str], column: int = 1, height: int = 30) -> None:
    """A header row of a table."""
    for k, label in enumerate(labels):
        cell = text(
            sheet, row, column + k, label, bold=True, color="FFFFFF", wrap=True, align="center", vertical="center"
        )
        fill(cell, ACCENT)
    sheet.row_dimensions[row].height = height


def rule(sheet: Worksheet, row: int, first: int, last: int) -> None:
    """A thin line below a row of a table."""
    for column in range(first, last + 1):
        frame(sheet.cell(row, column), LINE_COLOR, "bottom")


def heighten(sheet: Worksheet, row: int, *texts: tuple[str, float]) -> None:
    """Give a row the height its wrapped texts need; texts : (content, width of its column)."""
    lines = max(math.ceil(1.15 * len(content) / width) for content, width in texts)
    if lines > 1:
        sheet.row_dimensions[row].height = 14.0 * lines


def merge(sheet: Worksheet, row: int, column: int, last_row: int, last_column: int) -> None:
    """Merge several cells, the first of which alone is written. `Worksheet.merge_cells` compares with every range
    before, 6000 of them in a large report, and makes a cell of each; the ranges of these sheets do not overlap."""
    sheet.merged_cells.ranges.add(CellRange(None, column, row, last_column, last_row))


def paragraph(sheet: Worksheet, row: int, content: str, last: int, characters: int, **look) -> int:
    """Wrapped text over columns 1..last; its height follows from the characters a line holds."""
    merge(sheet, row, 1, row, last)
    text(sheet, row, 1, content, wrap=True, **look)
    lines = sum(max(1, math.ceil(len(part) / characters)) for part in content.split("\n"))
    sheet.row_dimensions[row].height = 13.5 * lines + 2
    return row + 1
