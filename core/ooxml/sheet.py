"""A sheet of a workbook (ECMA-376-1, 18.3): the contents of its cells, and what a person who sees them is not shown.

What is read and what is looked for come from one pass over the file, so that they cannot disagree.
"""

import datetime
import math
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import NamedTuple

from core.errors import InputError
from core.ooxml.package import DAMAGED, Package, local_name
from core.text.sentence import Sentence, notice, sentence

MAX_SPOKEN = 12
"""Cells, rows or columns that a sentence names; more are only counted."""

MAX_NAME = 31
"""Characters of the name of a sheet."""

MAX_ROW_OF_SHEET, MAX_COLUMN_OF_SHEET = 1_048_576, 16_384
"""Last row and column of a sheet of Excel, from 1."""

MAX_AREAS = 20_000
"""Merged areas of a sheet, and groups of its columns."""

_CELL = re.compile(r"([A-Z]{1,3})([0-9]{1,7})")
_NUMBER = re.compile(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([Ee][+-]?[0-9]+)?")
_ESCAPE = re.compile(r"_x([0-9A-Fa-f]{4})_")
_YES = ("1", "true")

_DATE_FORMATS = {*range(14, 23), *range(27, 37), *range(45, 48), *range(50, 59)}
"""Built-in number formats that show a number as a date or a time (18.8.30)."""

_LITERAL = re.compile(r'"[^"]*"|\\.|_.|\*.|\[(?!(?:h+|m+|s+)\])[^\]]*\]', re.IGNORECASE)
"""Parts of a number format that are shown as they are: quoted texts, escaped letters, colours, languages,
conditions."""


_BEHIND = re.compile(r'[0#?]\s*"([^"]{1,20})"(?:;|\Z)')
"""A text that a number format writes behind the number."""


Formats = list[tuple[bool, str]]
"""(whether it is a date or a time, text behind the number) of each number format, see `_number_formats`."""


class Limits(NamedTuple):
    """Rows, columns and cells with a content, and bytes unpacked, beyond which a sheet is refused."""

    rows: int
    columns: int
    cells: int
    size: int


class Cell(NamedTuple):
    """A content that is not empty.

    text : as it is written in a text file; numbers with every digit and a decimal point
    is_number : and not a date, which is a number in another format
    shown : what its format writes behind the number
    """

    text: str
    is_number: bool
    shown: str = ""


@dataclass
class Sheet:
    """A sheet that was read.

    rows : contents by row and column, both from 1
    merged : (first row, first column, last row, last column)
    formulas, uncomputed, errors : (row, column) of cells with a formula, with one that has no value, with an error
    hidden_rows, hidden_columns : up to the last that has a content, rising
    other_sheets, hidden_sheets : names of all the others, and of those that are not shown
    """

    name: str
    rows: dict[int, dict[int, Cell]] = field(default_factory=dict)
    merged: list[tuple[int, int, int, int]] = field(default_factory=list)
    formulas: list[tuple[int, int]] = field(default_factory=list)
    uncomputed: list[tuple[int, int]] = field(default_factory=list)
    errors: list[tuple[int, int]] = field(default_factory=list)
    hidden_rows: list[int] = field(default_factory=list)
    hidden_columns: list[int] = field(default_factory=list)
    other_sheets: list[str] = field(default_factory=list)
    hidden_sheets: list[str] = field(default_factory=list)

    @property
    def last_row(self) -> int:
        return max(self.rows, default=0)

    @property
    def last_column(self) -> int:
        return max((max(cells, default=0) for cells in self.rows.values()), default=0)

    def texts(self, row: int, empty: str = "") -> list[str]:
        """The contents of a row from its first column to the last that has one."""
        cells = self.rows.get(row, {})
        return [cells[k].text if k in cells else empty for k in range(1, max(cells, default=0) + 1)]

    def as_shown(self) -> "Sheet":
        """The sheet without its hidden contents, its columns side by side."""
        rows, columns = set(self.hidden_rows), set(self.hidden_columns)
        shown = [k for k in range(1, self.last_column + 1) if k not in columns]
        place = {column: k for k, column in enumerate(shown, start=1)}

        def seen(cells):
            return [cell for cell in cells if cell[0] not in rows and cell[1] not in columns]

        return replace(
            self,
            rows={
                row: {place[column]: cell for column, cell in cells.items() if column in place}
                for row, cells in self.rows.items()
                if row not in rows
            },
            formulas=seen(self.formulas),
            uncomputed=seen(self.uncomputed),
            errors=seen(self.errors),
        )


def read_sheet(content: bytes, limits: Limits, choose: Callable[[list[str]], int]) -> Sheet:
    """Read one sheet of a workbook. choose(names) : number from 0 of one of the sheets that are shown, which may raise.
    Raises InputError."""
    try:
        package = Package(content, limits.size)
        book = package.one("", "officeDocument")
        if book is None:
            raise ValueError("workbook")
        related = package.related(book)
        listed, since_1904 = _listed(package, book)
        sheets = [
            (name, related[key][1], shown) for name, key, shown in listed if related.get(key, ("",))[0] == "worksheet"
        ]
        shown = [(name, part) for name, part, is_shown in sheets if is_shown]
        if not shown:
            raise InputError("sheets_hidden")
        chosen = choose([name for name, _ in shown])
        name, part = shown[chosen]
        texts, formats = [], []
        for kind, target in related.values():
            if kind == "sharedStrings":
                texts = _texts(package, target)
            elif kind == "styles":
                formats = _number_formats(package, target)
        sheet = _Reader(package, limits, texts, formats, since_1904).read(part, name)
        sheet.other_sheets = [one for one, other, _ in sheets if other != part]
        sheet.hidden_sheets = [one for one, _, is_shown in sheets if not is_shown]
        return sheet
    except InputError:
        raise
    except DAMAGED as error:
        raise InputError("not_a_workbook", reason=type(error).__name__) from None


def _listed(package: Package, book: str) -> tuple[list[tuple[str, str, bool]], bool]:
    """(name, id of its relation, whether it is shown) of each sheet, and whether dates count from 1904."""
    sheets, since_1904 = [], []

    def start(parent: str, name: str, attributes: dict[str, str]) -> None:
        if (parent, name) == ("sheets", "sheet"):
            given = {local_name(full): value for full, value in attributes.items()}
            shown = given.get("state", "visible") == "visible"
            sheets.append((given["name"], given["id"], shown))
        elif name == "workbookPr":
            since_1904.append(attributes.get("date1904") in _YES)

    package.parse(book, start)
    return sheets, any(since_1904)


def _texts(package: Package, part: str) -> list[str]:
    """The shared texts, without the readings of their signs (18.4.6)."""
    texts: list[list[str]] = []

    def start(parent: str, name: str, attributes: dict[str, str]) -> None:
        if (parent, name) == ("sst", "si"):
            texts.append([])

    def end(parent: str, name: str, text: str) -> None:
        if name == "t" and parent in ("si", "r"):
            texts[-1].append(text)

    package.parse(part, start, end)
    return [_unescaped("".join(pieces)) for pieces in texts]


def _unescaped(text: str) -> str:
    """A text whose letters are written `_x0041_` (22.9.2.19): what no XML may hold, and `_x005F_` for `_`."""
    if not _ESCAPE.search(text):
        return text
    text = _ESCAPE.sub(lambda match: chr(int(match[1], 16)), text)
    return text.encode("utf-16-le", "surrogatepass").decode("utf-16-le", "replace")


def _number_formats(package: Package, part: str) -> Formats:
    """For each format, whether its cells show their number as a date or a time, and what they write behind it."""
    own: dict[str, tuple[bool, str]] = {}
    formats: list[str] = []

    def start(parent: str, name: str, attributes: dict[str, str]) -> None:
        if (parent, name) == ("numFmts", "numFmt"):
            bare = _LITERAL.sub("", attributes["formatCode"])
            behind = _BEHIND.search(attributes["formatCode"])
            shown = behind[1].strip() if behind else ""
            own[attributes["numFmtId"]] = bool(re.search("[dmyhs]", bare, re.IGNORECASE)), shown
        elif (parent, name) == ("cellXfs", "xf"):
            formats.append(attributes.get("numFmtId", "0"))

    package.parse(part, start)
    return [own.get(one) or (int(one) in _DATE_FORMATS, "") for one in formats]


class _Reader:
    """Takes the elements of a sheet as they come."""

    def __init__(self, package: Package, limits: Limits, texts: list[str], formats: Formats, since_1904: bool):
        self.package, self.limits = package, limits
        self.shared, self.formats = texts, formats
        self.epoch = datetime.datetime(1904, 1, 1) if since_1904 else datetime.datetime(1899, 12, 30)
        self.row = self.column = self.count = 0
        self.rows_hidden, self.all_hidden = set(), False
        self.columns_hidden: list[range] = []
        self.cell: dict[str, str] = {}
        self.value: str | None = None
        self.formula = False
        self.pieces: list[str] = []

    def read(self, part: str, name: str) -> Sheet:
        self.sheet = Sheet(name)
        self.package.parse(part, self.start, self.end)
        sheet = self.sheet
        columns = range(1, sheet.last_column + 1)
        sheet.hidden_columns = [k for k in columns if any(k in span for span in self.columns_hidden)]
        sheet.hidden_rows = sorted(row for row in self.rows_hidden if row <= sheet.last_row)
        return sheet

    def start(self, parent: str, name: str, attributes: dict[str, str]) -> None:
        if name == "c" and parent == "row":
            self._open_cell(attributes)
        elif name == "f" and parent == "c":
            self.formula = True
        elif name == "row" and parent == "sheetData":
            self.row, self.column = int(attributes.get("r") or self.row + 1), 0
            if not 0 < self.row <= MAX_ROW_OF_SHEET:
                raise ValueError("row")
            if _is_hidden(attributes, "ht", self.all_hidden):
                self.rows_hidden.add(self.row)
        elif name == "col" and parent == "cols":
            if _is_hidden(attributes, "width", False):
                first, last = int(attributes["min"]), int(attributes["max"])
                self.columns_hidden.append(range(first, last + 1))
        elif name == "sheetFormatPr":
            self.all_hidden = attributes.get("zeroHeight") in _YES
        elif name == "mergeCell" and parent == "mergeCells":
            first, _, last = attributes["ref"].partition(":")
            self.sheet.merged.append((*_place(first), *_place(last or first)))
        if len(self.sheet.merged) + len(self.columns_hidden) > MAX_AREAS:
            raise InputError("workbook_too_large")

    def end(self, parent: str, name: str, text: str) -> None:
        if name == "v" and parent == "c":
            self.value = text
        elif name == "c" and parent == "row":
            self._close_cell()
        elif name == "t" and parent in ("is", "r"):
            self.pieces.append(text)

    def _open_cell(self, attributes: dict[str, str]) -> None:
        self.cell, self.value, self.formula, self.pieces = attributes, None, False, []
        if "r" in attributes:
            row, column = _place(attributes["r"])
            if row != self.row or column <= self.column:
                raise ValueError("cell")
            self.column = column
        else:
            self.column += 1

    def _close_cell(self) -> None:
        kind, here = self.cell.get("t", "n"), (self.row, self.column)
        if self.formula:
            self.sheet.formulas.append(here)
            if self.value is None or (self.value == "" and kind != "str"):
                self.sheet.uncomputed.append(here)
        content = self._content(kind)
        if kind == "e":
            self.sheet.errors.append(here)
        if content is None:
            return
        self.count += 1
        rows, columns, cells, _ = self.limits
        if self.row > rows or self.column > columns or self.count > cells:
            raise InputError("sheet_too_large", rows=rows, columns=columns, cells=cells)
        row = self.sheet.rows.setdefault(self.row, {})
        if row.setdefault(self.column, content) is not content:
            raise ValueError("cell")

    def _content(self, kind: str) -> Cell | None:
        if kind == "inlineStr":
            text = _unescaped("".join(self.pieces))
        elif not self.value:
            return None
        elif kind == "s":
            text = self.shared[_index(self.value)]
        elif kind == "b":
            text = str(self.value in _YES)
        elif kind == "n":
            return self._number(self.value.strip())
        else:  # str, e, d
            text = _unescaped(self.value)
        return Cell(text, False) if text else None

    def _number(self, digits: str) -> Cell:
        if not _NUMBER.fullmatch(digits) or not math.isfinite(float(digits)):
            raise ValueError("number")
        style = _index(self.cell.get("s", "0"))
        is_date, shown = self.formats[style] if style < len(self.formats) else (False, "")
        if is_date:
            try:
                day = self.epoch + datetime.timedelta(days=float(digits))
            except OverflowError:
                return Cell(f"{digits} d", False)
            return Cell(day.isoformat(" ", "seconds"), False)
        whole = digits.lstrip("+-").isdecimal()
        return Cell(str(int(digits)) if whole else repr(float(digits)), True, shown)


def _index(digits: str) -> int:
    """A count from 0 of a file."""
    index = int(digits)
    if index < 0:
        raise IndexError(digits)
    return index


def _is_hidden(attributes: dict[str, str], size: str, by_default: bool) -> bool:
    """Whether a row or column is not shown: by its own word, that of all rows, or a size of 0."""
    own = attributes.get("hidden")
    return own in _YES or (by_default and own is None) or float(attributes.get(size) or 1.0) == 0.0


def _place(reference: str) -> tuple[int, int]:
    """(row, column), from 1, of "AB12"."""
    match = _CELL.fullmatch(reference)
    if not match:
        raise ValueError("cell")
    column = 0
    for letter in match[1]:
        column = 26 * column + ord(letter) - 64
    if not (0 < int(match[2]) <= MAX_ROW_OF_SHEET and column <= MAX_COLUMN_OF_SHEET):
        raise ValueError("cell")
    return int(match[2]), column


def letters(column: int) -> str:
    """ "AB" of 28."""
    name = ""
    while column:
        column, rest = divmod(column - 1, 26)
        name = chr(65 + rest) + name
    return name


def spoken(items: Sequence) -> str:
    """Cells (row, column), merged areas, rows, or names in a sentence."""

    def one(item) -> str:
        if isinstance(item, tuple):
            ends = [f"{letters(item[k + 1])}{item[k]}" for k in range(0, len(item), 2)]
            return ":".join(ends)
        return str(item)

    named = ", ".join(one(item) for item in items[:MAX_SPOKEN])
    return named if len(items) <= MAX_SPOKEN else f"{named}, … ({len(items)})"


def refuse_cells(cells_by_kind: dict[str, Sequence]) -> None:
    """Raise InputError that names all cells which hold no value of their own, if there are any. cells_by_kind : the
    kind is a code of what is accepted"""
    kinds = tuple(sentence("accepted", kind, cells=spoken(cells)) for kind, cells in cells_by_kind.items() if cells)
    if kinds:
        raise InputError("cells_without_value", cells=kinds)


def hidden_notes(sheet: Sheet, are_read: bool) -> list[Sentence]:
    """Rows and columns with contents that are not shown, each kind in a notice. are_read : as those that are"""
    heads = sheet.rows.get(1, {})
    filled = {column for cells in sheet.rows.values() for column in cells}
    columns = [
        f"{letters(column)} ({heads[column].text[:40]})" if column in heads else letters(column)
        for column in sheet.hidden_columns
        if column in filled
    ]
    rows = [row for row in sheet.hidden_rows if row in sheet.rows]
    notes = []
    if rows:
        code = "hidden_rows_read" if are_read else "hidden_rows"
        notes.append(notice(code, rows=spoken(rows)))
    if columns:
        code = "hidden_columns_read" if are_read else "hidden_columns"
        notes.append(notice(code, columns=spoken(columns)))
    return notes
