"""Walls of a table: .xlsx or .csv, one row a wall; units in a row below the column titles, or in the titles."""

import csv
import hashlib
import io
import re
from pathlib import Path
from typing import NamedTuple

from core.case.many_walls import LazyWalls
from core.case.wall import Wall
from core.case.wall_columns import THOUSANDS, Head, is_units
from core.decoding import NoText, decode_text
from core.errors import InputError, place
from core.ooxml.sheet import MAX_NAME, Limits, Sheet, hidden_notes, read_sheet, refuse_cells, spoken
from core.quantities import unit_of
from core.regular_file import TooLarge, read_regular
from core.text.sentence import Sentence, notice

MAX_ROWS, MAX_COLUMNS, MAX_BYTES = 2000, 40, 20_000_000
MAX_CELLS = MAX_ROWS * 4 * MAX_COLUMNS
MANY_ROWS, MANY_BYTES = 2_000_000, 500_000_000
"""Limits of a text whose walls are read one after the other."""


class WallTable(NamedTuple):
    """A table of walls as it was read.

    notices : sheet, hidden rows and other sheets that were passed over
    rows : the cells that `parse_wall_rows` takes; none of ManyWalls
    sha256 : of the file
    """

    walls: list[Wall] | LazyWalls
    notices: list[Sentence]
    rows: list[list[str]]
    sha256: str


def read_walls(path: Path, with_demand: bool = False) -> list[Wall]:
    """The walls of `read_table`."""
    return list(read_table(path, with_demand).walls)


def read_table(path: Path, with_demand: bool = False, many: bool = False) -> WallTable:
    """Read a table of walls.

    with_demand : the height of the base is needed
    many : of a text of more than MAX_ROWS rows the walls are ManyWalls, else it is refused
    Raises InputError in one sentence: file, row, column, what is accepted.
    """
    try:
        if path.exists() and not path.is_file():
            raise InputError("table_not_a_file")
        is_text, notes = path.suffix.lower() in (".csv", ".txt"), []
        content = read_regular(path, MANY_BYTES if many and is_text else MAX_BYTES)
        digest = hashlib.sha256(content).hexdigest()
        if path.suffix.lower() == ".xlsx":
            rows, notes = _xlsx_rows(content)
            try:
                return WallTable(parse_wall_rows(rows, with_demand), notes, rows, digest)
            except InputError as error:
                title = dict(notes[0].values)["sheet"]
                raise error.at(place("sheet", name=title)) from None
        if not is_text:
            raise InputError("table_kind")
        text = _decoded(content)
        if text.rstrip(" \t") and text[-1] not in "\r\n":
            last = text.rstrip().rsplit("\n", 1)[-1]
            notes.append(notice("table_not_ended", cell=re.split(r"[;,\t]", last)[-1].strip()[-40:] or last[-40:]))
        if many and text.count("\n") >= MAX_ROWS:
            return WallTable(_many_walls(text, with_demand), notes, [], digest)
        rows = text_rows(text)
        return WallTable(parse_wall_rows(rows, with_demand), notes, rows, digest)
    except FileNotFoundError:
        raise InputError("no_table", place=(path,)) from None
    except TooLarge as error:
        raise InputError("table_too_many_mb", mb=error.size / 1e6, place=(path,)) from None
    except OSError as error:
        raise InputError("unreadable", reason=error.strerror, place=(path,)) from None
    except InputError as error:
        raise error.at(path) from None


def _decoded(content: bytes) -> str:
    try:
        return decode_text(content)
    except NoText:
        raise InputError("table_no_text") from None


def _mark(text: str) -> str:
    """Mark that stands between the cells of a text."""
    head = text.split("\n", 1)[0]
    return next((mark for mark in (";", "\t", ",") if mark in head), ";")


_SEPARATOR = re.compile(r"\s*sep=([;,\t])[;,\t]*\r?\n", re.IGNORECASE)
_DIGIT = re.compile(r"\d")
_COMMA = re.compile(r"[+−-]?\d+,\d+(?!\d|,).*")


def text_cells(text: str) -> list[list[str]]:
    """Cells of a text with `;`, tab or `,` between them, as Excel saves and copies it; a line `sep=;` on top says
    which. Raises InputError."""
    if said := _SEPARATOR.match(text):
        text, mark = "\n" + text[said.end() :], said[1]
    else:
        mark = _mark(text)
    if text.count(mark) + text.count("\n") > MAX_CELLS:  # before each becomes a text of its own
        raise InputError("table_too_large", rows=MAX_ROWS, columns=4 * MAX_COLUMNS)
    try:
        table = csv.reader(io.StringIO(text), delimiter=mark, strict=True)
        return [[cell.strip() for cell in row] for row in table]
    except csv.Error as error:
        raise InputError("not_a_table", reason=error) from None


def text_rows(text: str) -> list[list[str]]:
    """Rows of a table of walls. A row that begins with # is a comment where no other cell has a digit."""
    rows = text_cells(text)
    rows = [[] if _is_comment(row) else row for row in rows]
    heads = next((row for row in rows if any(row)), [])
    for n, row in enumerate(rows, start=1):
        _refuse_cut(heads, n, row)
    _refuse_thousands(rows)
    while rows and not any(rows[0]):  # the titles come first
        rows = rows[1:]
    return rows


def _is_comment(row: list[str]) -> bool:
    """Whether a row begins with # and no other cell of it has a digit: nothing of a wall is lost with it."""
    return bool(row) and row[0].startswith("#") and not any(map(_DIGIT.search, row[1:]))


def _refuse_thousands(rows: list[list[str]]) -> None:
    """Refuse `1.250` in a table with decimal commas: thousands, or a decimal point?"""
    if not any(_COMMA.fullmatch(cell) for row in rows for cell in row):
        return
    for n, row in enumerate(rows, start=1):
        for cell in row:
            if THOUSANDS.fullmatch(cell):
                raise InputError("thousands_or_decimals", text=cell, place=(place("row", n=n),))


def _refuse_cut(heads: list[str], n: int, row: list[str]) -> None:
    """Refuse a row of a text with fewer cells than the titles: what writes tables gives all their marks. n : from 1"""
    width = max((k for k, head in enumerate(heads, start=1) if head.strip()), default=0)
    if any(cell.strip() for cell in row) and len(row) < width and not (n == 2 and is_units(row)):
        raise InputError("row_cut", given=len(row), titles=width, place=(place("row", n=n),))


def _xlsx_rows(content: bytes) -> tuple[list[list[str]], list[Sentence]]:
    """Cells as text of the first sheet that is shown, what is hidden in it left empty, and what is to be said of it.
    Raises InputError for what a table of walls never holds."""
    limits = Limits(MAX_ROWS, 4 * MAX_COLUMNS, MAX_CELLS, MAX_BYTES)
    whole = read_sheet(content, limits, lambda names: 0)
    name, sheet = whole.name[:MAX_NAME], whole.as_shown()
    try:
        refused_cells = {"formula_cells": sheet.formulas, "error_cells": sheet.errors}
        refuse_cells({"merged_cells": sheet.merged, **refused_cells})
    except InputError as error:
        raise error.at(place("sheet", name=name)) from None
    rows = [_shown_cells(sheet, row) for row in range(1, sheet.last_row + 1)]
    written = (sheet.rows.get(row, {}).values() for row in range(1, sheet.last_row + 1))
    _refuse_thousands([[cell.text.strip() for cell in cells if not cell.is_number] for cells in written])
    rows = [[] if _is_comment(row) else row for row in rows]
    notes = [notice("table_sheet", sheet=name), *hidden_notes(whole, are_read=False)]
    if sheet.other_sheets:
        names = [other[:MAX_NAME] for other in sheet.other_sheets]
        notes.append(notice("other_sheets", names=spoken(names)))
    return rows, notes


def _shown_cells(sheet: Sheet, row: int) -> list[str]:
    """The cells of a row as texts, with the unit that the format of a number shows behind it."""
    units = {k: cell.shown for k, cell in sheet.rows.get(row, {}).items() if unit_of(cell.shown) is not None}
    return [f"{text} {units.get(k, '')}".strip() for k, text in enumerate(sheet.texts(row), start=1)]


def parse_wall_rows(rows: list[list[str]], with_demand: bool = False) -> list[Wall]:
    """Walls of a table's cells: a row of column titles, a row of units, one row a wall; empty rows are skipped.
    with_demand : an empty height of the base is an error, never the ground."""
    rows = [(n, row) for n, row in enumerate(rows, start=1) if n == 2 or any(row)]
    if len(rows) >= 2 and rows[1][0] == 2 and not is_units(rows[1][1]):
        rows.insert(1, (0, []))  # the titles name their units
    if len(rows) < 3:
        raise InputError("table_rows")
    if len(rows) > MAX_ROWS or len(rows[0][1]) > 4 * MAX_COLUMNS:
        raise InputError("table_too_large", rows=MAX_ROWS, columns=4 * MAX_COLUMNS)
    head = Head.of(rows[0][1], rows[1][1], with_demand)
    return [head.wall(number, row) for number, row in rows[2:]]


def _many_walls(text: str, with_demand: bool) -> LazyWalls:
    """The walls of `text_rows` of a text, each read when it is asked for. Raises InputError for its titles."""
    first: list[tuple[int, list[str]]] = []
    said = _SEPARATOR.match(text)
    walls = LazyWalls("\n" + text[said.end() :], said[1]) if said else LazyWalls(text, _mark(text))
    commas, thousands, place_of = False, (0, ""), 0  # of a row from the first with something in it, as `_walls` counts
    try:
        for number, row in walls.scan():
            row = [cell.strip() for cell in row]
            if _is_comment(row):
                continue
            place_of += bool(place_of or any(row))
            commas = commas or any(map(_COMMA.fullmatch, row))
            if not thousands[0] and (cell := next(filter(THOUSANDS.fullmatch, row), "")):
                thousands = number, cell
            if len(first) < 2 and (place_of == 2 or any(row)):
                first.append((number, row))
                if len(first) == 1 or place_of != 2 or is_units(row):
                    continue
                first[1] = (0, [])  # the titles name their units
            if any(row):
                _refuse_cut(first[0][1], number, row)
                walls.keep(number)
                if len(walls) > MANY_ROWS:
                    raise InputError("table_too_large", rows=MANY_ROWS, columns=4 * MAX_COLUMNS)
    except csv.Error as error:
        raise InputError("not_a_table", reason=error) from None
    if commas and thousands[0]:
        raise InputError("thousands_or_decimals", text=thousands[1], place=(place("row", n=thousands[0]),))
    if len(first) < 2 or not len(walls):
        raise InputError("table_rows")
    if len(first[0][1]) > 4 * MAX_COLUMNS:
        raise InputError("table_too_large", rows=MANY_ROWS, columns=4 * MAX_COLUMNS)
    walls.wall_of = Head.of(first[0][1], first[1][1], with_demand).wall
    return walls
