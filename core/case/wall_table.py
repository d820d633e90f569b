"""Walls of a table: .xlsx or .csv, one row a wall, a row of units below the heads."""

import csv
import io
import re
import zipfile
import zlib
from pathlib import Path

from core.case.number import parse_number
from core.case.rules import BASE_MISSING, parse_wall
from core.case.schema import Wall
from core.errors import InputError
from core.text.notices import Notice, notice

COLUMNS = {
    "name": ("parete", "wall", "nome"),
    "floor": ("piano", "storey", "story"),
    "base_z_m": ("z", "quota"),
    "height_m": ("h", "altezza", "height"),
    "thickness_m": ("t", "spessore", "thickness"),
    "length_m": ("l", "lunghezza", "length"),
    "unit_weight_kn_m3": ("γ", "peso specifico", "unit weight", "gamma"),
    "hinge_setback_m": ("u", "arretramento", "hinge setback"),
    "mechanism": ("meccanismo",),
    "back_restraint": ("vincolo", "restraint"),
    "notes": ("note",),
    "restitution": ("restituzione",),
    "velocity_ratio": (),
    "slenderness_deg": ("alpha", "α"),
    "height_over_thickness": ("h/t",),
    "law": ("legge",),
    "elastic_modulus_mpa": ("e", "modulo elastico", "elastic modulus"),
    "free_element": ("elemento libero", "libero di vibrare", "free element"),
    "unloaded_confirmed": ("parete scarica", "senza carichi", "no load"),
}
"""Key of a wall -> further heads of its column; the key itself is always one."""

MECHANISMS = {
    "su due lati": "two_sided", "due lati": "two_sided", "two-sided": "two_sided",
    "su un lato": "one_sided", "un lato": "one_sided", "one-sided": "one_sided",
    "entrambi": "both",
}  # fmt: skip
NO_UNIT = {"": 1.0, "-": 1.0, "–": 1.0}
UNITS = {
    "_kn_m3": {"kn/m3": 1.0, "kn/m³": 1.0, **NO_UNIT},
    "_mpa": {"mpa": 1.0, "n/mm2": 1.0, "n/mm²": 1.0, "gpa": 1000.0},
    "_deg": {"deg": 1.0, "°": 1.0, **NO_UNIT},
    "_m": {"m": 1.0, "cm": 0.01, "mm": 0.001},
}
"""End of a key -> units of its column, and what a number is multiplied with."""

OTHER_UNITS = frozenset(
    (
        "m", "cm", "mm", "dm", "km", "in", "ft", "foot", "feet", "inch", "yd", "deg", "°", "rad", "grad", "kpa", "mpa",
        "gpa", "pa", "n/mm2", "n/mm²", "kg/cm2", "psi", "kn/m3", "kn/m³", "kg/m3", "kg/m³", "t/m3", "t/m³", "g/cm3",
        "n/m3", "%", "g",
    )
)  # fmt: skip
"""Units a head may name; another word in brackets is no unit."""

WORDS = ("name", "floor", "mechanism", "back_restraint", "notes", "restitution", "law")
FLAGS = {"sì": True, "si": True, "yes": True, "true": True, "vero": True, "x": True, "1": True,
         "no": False, "false": False, "falso": False, "0": False}  # fmt: skip

MOST_ROWS, MOST_COLUMNS, MOST_BYTES = 2000, 40, 20_000_000


def read_walls(path: Path, with_demand: bool = False) -> list[Wall]:
    """The walls of `read_table`."""
    return read_table(path, with_demand)[0]


def read_table(path: Path, with_demand: bool = False) -> tuple[list[Wall], list[Notice]]:
    """The walls of a table, and what was read and passed over: sheet, hidden rows, other sheets. with_demand :
    the height of the base is needed. Raises InputError in one sentence: file, row, column, what is accepted."""
    try:
        if path.exists() and not path.is_file():
            raise InputError("this is not a file: name a table of walls")
        size = path.stat().st_size
        if size > MOST_BYTES:
            raise InputError(f"{size / 1e6:.0f} MB is no table of walls (up to 20 MB)")
        content, notes = path.read_bytes(), []
        if path.suffix.lower() == ".xlsx":
            rows, notes = _xlsx_rows(content)
        elif path.suffix.lower() in (".csv", ".txt"):
            rows = text_rows(_decoded(content))
        else:
            raise InputError("a table of walls is .xlsx or .csv")
        return walls_of(rows, with_demand), notes
    except FileNotFoundError:
        raise InputError(f"{path}: there is no such table of walls") from None
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    except InputError as error:
        raise InputError(f"{path}: {error}") from None


def _decoded(content: bytes) -> str:
    try:
        if content[:2] in (b"\xff\xfe", b"\xfe\xff"):  # "Unicode text" of Excel
            return content.decode("utf-16")
        if b"\0" in content:
            raise InputError("this is no text: save the table as .xlsx or as CSV UTF-8")
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("cp1252", errors="replace")


def text_rows(text: str) -> list[list[str]]:
    """Cells of a text with `;`, tab or `,` between them, as Excel saves and copies it."""
    head = text.split("\n", 1)[0]
    mark = next((mark for mark in (";", "\t", ",") if mark in head), ";")
    try:
        return [
            [cell.strip() for cell in row] for row in csv.reader(io.StringIO(text), delimiter=mark)
        ]
    except csv.Error as error:
        raise InputError(f"not a table: {error}") from None


def _xlsx_rows(content: bytes) -> tuple[list[list[str]], list[Notice]]:
    """Cells of the first sheet that is shown as text, hidden rows left empty, and what is to be said of it.
    Raises InputError for what a table of walls never holds."""
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as folder:
            if sum(entry.file_size for entry in folder.infolist()) > MOST_BYTES:
                raise InputError("unpacked it is larger than 20 MB: no table of walls")
            sheets = [n for n in folder.namelist() if n.startswith("xl/worksheets/sheet")]
            if any(b"<mergeCell " in folder.read(name) for name in sheets):
                raise InputError("cells are merged: a table of walls has one cell for each value")
        from openpyxl import load_workbook

        book = load_workbook(io.BytesIO(content), read_only=True, keep_links=False)
        shown = [sheet for sheet in book.worksheets if sheet.sheet_state == "visible"]
        if not shown:
            raise InputError("every sheet is hidden: show the one with the walls")
        sheet = shown[0]
        sheet.reset_dimensions()  # the tag that states them can lie
        rows, hidden = [], _hidden_rows(content, book, sheet.title)
        for number, row in enumerate(sheet.iter_rows(max_col=10 * MOST_COLUMNS), start=1):
            if number > MOST_ROWS:
                raise InputError(f"more than {MOST_ROWS} rows")
            if number in hidden:
                rows.append([])
                continue
            for cell in row:
                if cell.data_type == "f":
                    raise InputError(
                        f"row {number}: {cell.coordinate} is a formula: paste it as a value"
                    )
            cells = ["" if cell.value is None else str(cell.value).strip() for cell in row]
            while cells and not cells[-1]:
                cells.pop()
            rows.append(cells)
        notes = [notice("table_sheet", sheet=sheet.title[:31])]
        if hidden & set(range(1, len(rows) + 1)):
            kept = ", ".join(str(k) for k in sorted(hidden)[:20])
            notes.append(notice("hidden_rows", rows=kept))
        others = [other.title[:31] for other in book.worksheets if other is not sheet]
        if others:
            notes.append(notice("other_sheets", names=", ".join(others[:10])))
        return rows, notes
    except InputError:
        raise
    except (zipfile.BadZipFile, KeyError, ValueError, TypeError, IndexError, AttributeError,
            EOFError, NotImplementedError, SyntaxError, RuntimeError, zlib.error) as error:  # fmt: skip
        raise InputError(
            f"not a workbook Excel could have saved ({type(error).__name__})"
        ) from None


def _hidden_rows(content: bytes, book, title: str) -> set[int]:
    """Numbers of the rows of a sheet that are not shown, which the reader of cells does not tell."""
    from defusedxml.ElementTree import iterparse

    with zipfile.ZipFile(io.BytesIO(content)) as folder:
        sheet = folder.read(book[title]._worksheet_path.lstrip("/"))
    found, number, all_hidden = set(), 0, False
    for _, node in iterparse(io.BytesIO(sheet), events=("start",)):
        name = node.tag.rpartition("}")[2]
        if name == "sheetFormatPr":
            all_hidden = node.get("zeroHeight") in ("1", "true")
        if name != "row":
            continue
        number = int(node.get("r") or number + 1)
        flat = node.get("ht") is not None and float(node.get("ht")) == 0.0
        if (
            flat
            or node.get("hidden") in ("1", "true")
            or (all_hidden and node.get("hidden") is None)
        ):
            found.add(number)
    return found


def walls_of(rows: list[list[str]], with_demand: bool = False) -> list[Wall]:
    """Walls of a table's cells: a row of heads, a row of units, one row a wall; empty rows are skipped.
    with_demand : an empty height of the base is an error, never the ground."""
    rows = [(n, row) for n, row in enumerate(rows, start=1) if n == 2 or any(row)]
    if len(rows) < 3:
        raise InputError(
            "a table of walls has a row of heads (Parete; H; t; Meccanismo), a row of units "
            "(; m; cm;) and a row for each wall"
        )
    if len(rows) > MOST_ROWS or len(rows[0][1]) > 4 * MOST_COLUMNS:
        raise InputError(f"more than {MOST_ROWS} rows or {4 * MOST_COLUMNS} columns")
    keys = _heads(rows[0][1])
    factors = _factors(keys, rows[1][1], rows[0][1])
    walls = []
    for number, row in rows[2:]:
        if any(cell for cell in row[len(keys) :]):
            raise InputError(f"row {number}: there is a value beyond the last column")
        table = {}
        for key, factor, cell in zip(keys, factors, row, strict=False):
            if key and cell:
                table[key] = _cell(key, factor, cell, number)
        table.setdefault("name", f"row {number}")
        try:
            if with_demand and "base_z_m" not in table:
                raise InputError(BASE_MISSING)
            walls.append(parse_wall(table))
        except InputError as error:
            raise InputError(f"row {number}: {error}") from None
    return walls


def _heads(cells: list[str]) -> list[str | None]:
    known = {name: key for key, names in COLUMNS.items() for name in (key, *names)}
    while cells and not cells[-1]:
        cells = cells[:-1]
    keys = []
    for cell in cells:
        name = re.sub(r"\s*[\[(].*", "", cell).strip().lower()
        if name not in known:
            raise InputError(
                f"the column {cell[:60]!r} is not known: Parete, Piano, z, H, t, L, peso specifico, u, "
                f"meccanismo, vincolo, note, or a key of [[wall]] ({', '.join(COLUMNS)})"
            )
        if known[name] in keys:
            raise InputError(f"the column {cell[:60]!r} stands there twice")
        keys.append(known[name])
    return keys


_HEAD_UNIT = re.compile(r"[\[(]([^\])]*)[\])]")


def _factors(keys: list, cells: list[str], heads: list[str]) -> list[float]:
    """What each column is multiplied with: its unit to that of its key. A unit in the head itself must be the
    same one."""
    factors = []
    for k, key in enumerate(keys):
        unit = (cells[k] if k < len(cells) else "").strip("[]() ").lower()
        units = next((units for end, units in UNITS.items() if key.endswith(end)), NO_UNIT)
        if unit not in units:
            raise InputError(
                f"the unit {unit[:40]!r} of the column {key} is not accepted: one of "
                f"{', '.join(name or 'empty' for name in units)} in the row below the heads"
            )
        for named in _HEAD_UNIT.findall(heads[k]):
            word = re.sub(r"^(in|unit|unità)\b|[. ]", "", named.strip().lower())
            if units.get(word, None if word in OTHER_UNITS else units[unit]) != units[unit]:
                raise InputError(
                    f"the column {heads[k][:60]!r} names {named[:20]}, the row of units below it {unit or 'none'}: "
                    "correct one of them"
                )
        factors.append(units[unit])
    return factors


def _cell(key: str, factor: float, cell: str, number: int):
    if key == "mechanism":
        return MECHANISMS.get(cell.lower(), cell.lower().replace("-", "_"))
    if key in WORDS:
        return cell
    if key in ("free_element", "unloaded_confirmed"):
        if cell.lower() not in FLAGS:
            raise InputError(
                f"row {number}, {key}: {cell[:60]!r} is not accepted: sì, yes, x or no"
            )
        return FLAGS[cell.lower()]
    try:
        return parse_number(cell) * factor
    except InputError as error:
        raise InputError(f"row {number}, {key}: {error}") from None
