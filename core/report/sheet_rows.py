"""Rows of a sheet as text: openpyxl makes an element of every cell, which is half of the time of a large workbook."""

import zlib
from collections.abc import Iterable, Iterator
from typing import Any
from xml.etree.ElementTree import Element, tostring
from xml.sax.saxutils import escape

from openpyxl.cell._writer import etree_write_cell
from openpyxl.compat import safe_string
from openpyxl.utils import get_column_letter
from openpyxl.worksheet.worksheet import Worksheet

from core.report.xml_text import escape_for_cell

PACKED_ROWS = 400
"""Rows of a piece that is kept packed."""


class _Element:
    """Takes the element that openpyxl makes of a cell."""

    text = ""

    def write(self, element: Element) -> None:
        self.text = tostring(element, "unicode")


class SheetRows:
    """The rows of one sheet, those that will not change any more packed: a cell takes some hundred bytes, its text in a
    packed piece five.

    cached : values of the formulas of the workbook, by sheet and cell
    """

    def __init__(self, sheet: Worksheet, cached: dict[tuple[str, str], object]):
        self.sheet, self.cached = sheet, cached
        self._pieces: list[bytes] = []
        self._styles: dict[int, tuple[object, str]] = {}
        self._ends: tuple[int, int] | None = None
        self._columns = [10**6, 0]

    def pack(self, first: int, end: int) -> None:
        """Pack the rows from the first, or from those packed before, up to the one before the end. The last row of the
        sheet stays, for what asks how long it is."""
        if self._ends is not None:
            first = self._ends[1]
        if end - first < PACKED_ROWS:
            return
        end = min(end, self.sheet.max_row)
        cells = {place: cell for place, cell in self.sheet._cells.items() if first <= place[0] < end}
        if not cells:
            return
        columns = [column for _, column in cells]
        self._columns = [min(self._columns[0], *columns), max(self._columns[1], *columns)]
        text = "".join(self._texts(cells, first, end))
        self._pieces.append(zlib.compress(text.encode(), 1))
        for place, cell in cells.items():
            del self.sheet._cells[place]
            self.cached.pop((self.sheet.title, cell.coordinate), None)
        for row in [row for row in self.sheet.row_dimensions if first <= row < end]:
            del self.sheet.row_dimensions[row]
        self._ends = (self._ends[0] if self._ends else first, end)

    @property
    def area(self) -> str:
        """All cells of the sheet, as its file names them."""
        sheet, (low, high) = self.sheet, self._columns
        if not high:
            return sheet.calculate_dimension()
        low, high = min(low, sheet.min_column), max(high, sheet.max_column)
        return f"{get_column_letter(low)}{sheet.min_row}:{get_column_letter(high)}{sheet.max_row}"

    def texts(self) -> Iterator[str]:
        """The rows in their order, in pieces."""
        cells = dict(sorted(self.sheet._cells.items()))
        if self._ends is None:
            yield from self._texts(cells, 0, 10**9)
            return
        first, end = self._ends
        yield from self._texts({place: cell for place, cell in cells.items() if place[0] < first}, 0, first)
        for piece in self._pieces:
            yield zlib.decompress(piece).decode()
        yield from self._texts({place: cell for place, cell in cells.items() if place[0] >= end}, end, 10**9)

    def _texts(self, cells: dict, first: int, end: int) -> Iterator[str]:
        """Rows of these cells, and of those between the first and the end that have a height alone."""
        rows: dict[int, list] = {row: [] for row in self.sheet.row_dimensions if first <= row < end}
        for (row, column), cell in cells.items():
            rows.setdefault(row, []).append((column, cell))
        for row in sorted(rows):
            kept = self.sheet.row_dimensions.get(row, ())
            attributes = "".join(
                f' {key}="{escape(str(value))}"' for key, value in ({"r": str(row)} | dict(kept)).items()
            )
            inside = "".join(self._cells(row, sorted(rows[row], key=lambda entry: entry[0])))
            yield f"<row{attributes}>{inside}</row>"

    def _cells(self, row: int, cells: Iterable[tuple[int, Any]]) -> Iterator[str]:
        for column, cell in cells:
            if cell._value is not None or cell.has_style or getattr(cell, "_comment", None):
                yield self._cell(f"{get_column_letter(column)}{row}", cell)

    def _cell(self, place: str, cell: Any) -> str:
        """A cell as openpyxl writes it; a formula with its value."""
        value: Any = cell._value
        kind = cell.data_type
        plain = isinstance(value, (int, float, str, type(None))) and cell.hyperlink is None
        if kind not in ("n", "s", "f") or not plain:
            sink = _Element()
            etree_write_cell(sink, self.sheet, cell, cell.has_style)
            return sink.text
        start = f'<c r="{place}"{self._style(cell)}'
        if kind == "f":
            known: Any = self.cached[self.sheet.title, place]
            if isinstance(known, str):
                return f'{start} t="str"><f>{escape(value[1:])}</f><v>{escape(escape_for_cell(known))}</v></c>'
            return f"{start}><f>{escape(value[1:])}</f><v>{float(known)!r}</v></c>"
        start += ' t="inlineStr"' if kind == "s" else ' t="n"'
        if value is None or value == "":
            return f"{start}/>"
        if kind == "n":
            return f"{start}><v>{safe_string(value)}</v></c>"
        space = ' xml:space="preserve"' if value.strip() not in ("", value) else ""
        return f"{start}><is><t{space}>{escape(value)}</t></is></c>"

    def _style(self, cell: Any) -> str:
        """The attribute of a cell's style; cells of equal looks share one object, see `cached_style`."""
        if not cell.has_style:
            return ""
        style = cell._style
        if id(style) not in self._styles:
            self._styles[id(style)] = style, f' s="{cell.style_id}"'
        return self._styles[id(style)][1]
