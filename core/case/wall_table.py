"""Walls of a table: .xlsx or .csv, one row a wall; units in a row below the heads, or in the heads."""

import csv
import io
import re
from pathlib import Path

from core.case.hinges import BASE, FLOORS
from core.case.number import parse_number
from core.case.rules import parse_wall
from core.case.schema import Wall
from core.errors import InputError, place
from core.ooxml.sheet import MAX_NAME, Limits, hidden_notes, read_sheet, refuse_cells, spoken
from core.text.sentence import Sentence, notice

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
    "hinge_heights": ("cerniere", "hinges"),
    "tie_height_m": ("quota catena", "tie height"),
    "variant": ("variante",),
    "radius_m": ("r", "raggio", "radius"),
    "inertia_over_mass_m2": ("i0/m", "inerzia"),
    "compressive_strength_mpa": ("f", "resistenza a compressione", "compressive strength"),
    "across_number": ("muri ortogonali", "return walls"),
    "across_thickness_m": ("muri ortogonali t", "return walls t"),
    "across_brick_height_m": ("muri ortogonali hb", "return walls hb"),
    "across_brick_length_m": ("muri ortogonali l", "return walls l"),
    "across_friction": ("muri ortogonali mu", "return walls mu"),
}
"""Key of a wall -> further heads of its column; the key itself is always one."""

MOST_LOADS = 4
LOAD_COLUMNS = {
    "kind": ("carico {n}", "load {n}"),
    "kn_m": ("carico {n} p", "load {n} p"),
    "d_m": ("carico {n} d", "load {n} d"),
    "h_m": ("carico {n} h", "load {n} h"),
    "mass": ("carico {n} massa", "load {n} mass"),
}
"""Key of a load -> heads of its column, the n-th load of a wall; load1_kind, ... are always ones."""

COLUMNS |= {
    f"load{n}_{key}": tuple(name.format(n=n) for name in names)
    for n in range(1, MOST_LOADS + 1)
    for key, names in LOAD_COLUMNS.items()
}

LOAD_KINDS = {
    "verticale": "vertical",
    "spinta": "thrust",
    "catena": "tie",
    "tirante": "tie",
    "massa portata": "carried_mass",
    "vertical": "vertical",
    "thrust": "thrust",
    "tie": "tie",
    "carried mass": "carried_mass",
    "carried_mass": "carried_mass",
}
LOAD_MASSES = {
    "nessuna": "none",
    "orizzontale": "horizontal",
    "solidale": "moving",
    "none": "none",
    "horizontal": "horizontal",
    "moving": "moving",
}

MECHANISMS = {
    "su due lati": "two_sided",
    "due lati": "two_sided",
    "su un lato": "one_sided",
    "un lato": "one_sided",
    "entrambi": "both",
    "two-sided": "two_sided",
    "one-sided": "one_sided",
    "both": "both",
}
NO_UNIT = {"": 1.0, "-": 1.0, "–": 1.0}
UNITS = {
    "_kn_m3": {"kn/m3": 1.0, "kn/m³": 1.0, **NO_UNIT},
    "_mpa": {"mpa": 1.0, "n/mm2": 1.0, "n/mm²": 1.0, "gpa": 1000.0},
    "_kn_m": {"kn/m": 1.0, **NO_UNIT},
    "_deg": {"deg": 1.0, "°": 1.0, **NO_UNIT},
    "_m2": {"m2": 1.0, "m²": 1.0, **NO_UNIT},
    "_m": {"m": 1.0, "cm": 0.01, "mm": 0.001},
}
"""End of a key -> units of its column, and what a number is multiplied with; the first end that fits."""

OTHER_UNITS = frozenset(
    (
        "m",
        "cm",
        "mm",
        "dm",
        "km",
        "in",
        "ft",
        "foot",
        "feet",
        "inch",
        "yd",
        "deg",
        "°",
        "rad",
        "grad",
        "kpa",
        "mpa",
        "gpa",
        "pa",
        "n/mm2",
        "n/mm²",
        "kg/cm2",
        "psi",
        "kn/m3",
        "kn/m³",
        "kg/m3",
        "kg/m³",
        "t/m3",
        "t/m³",
        "g/cm3",
        "n/m3",
        "%",
        "g",
    )
)
"""Units a head may name; another word in brackets is no unit."""

WORDS = ("name", "floor", "mechanism", "back_restraint", "notes", "restitution", "law", "variant")
FLAGS = {
    "sì": True,
    "si": True,
    "yes": True,
    "true": True,
    "vero": True,
    "x": True,
    "1": True,
    "no": False,
    "false": False,
    "falso": False,
    "0": False,
}

MAX_ROWS, MAX_COLUMNS, MAX_BYTES = 2000, 40, 20_000_000
MAX_CELLS = MAX_ROWS * 4 * MAX_COLUMNS


def read_walls(path: Path, with_demand: bool = False) -> list[Wall]:
    """The walls of `read_table`."""
    return read_table(path, with_demand)[0]


def read_table(path: Path, with_demand: bool = False) -> tuple[list[Wall], list[Sentence]]:
    """The walls of a table, and what was read and passed over: sheet, hidden rows, other sheets. with_demand :
    the height of the base is needed. Raises InputError in one sentence: file, row, column, what is accepted."""
    try:
        if path.exists() and not path.is_file():
            raise InputError("table_not_a_file")
        size = path.stat().st_size
        if size > MAX_BYTES:
            raise InputError("table_too_many_mb", mb=size / 1e6)
        content, notes = path.read_bytes(), []
        if path.suffix.lower() == ".xlsx":
            rows, notes = _xlsx_rows(content)
            try:
                return walls_of(rows, with_demand), notes
            except InputError as error:
                title = dict(notes[0].values)["sheet"]
                raise error.at(place("sheet", name=title)) from None
        elif path.suffix.lower() in (".csv", ".txt"):
            rows = text_rows(_decoded(content))
        else:
            raise InputError("table_kind")
        return walls_of(rows, with_demand), notes
    except FileNotFoundError:
        raise InputError("no_table", place=(path,)) from None
    except OSError as error:
        raise InputError("unreadable", reason=error.strerror, place=(path,)) from None
    except InputError as error:
        raise error.at(path) from None


def _decoded(content: bytes) -> str:
    try:
        if content[:2] in (b"\xff\xfe", b"\xfe\xff"):  # "Unicode text" of Excel
            return content.decode("utf-16")
        if b"\0" in content:
            raise InputError("table_no_text")
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("cp1252", errors="replace")


def text_rows(text: str) -> list[list[str]]:
    """Cells of a text with `;`, tab or `,` between them, as Excel saves and copies it."""
    head = text.split("\n", 1)[0]
    mark = next((mark for mark in (";", "\t", ",") if mark in head), ";")
    if text.count(mark) + text.count("\n") > MAX_CELLS:  # before each becomes a text of its own
        raise InputError("table_too_large", rows=MAX_ROWS, columns=4 * MAX_COLUMNS)
    try:
        return [[cell.strip() for cell in row] for row in csv.reader(io.StringIO(text), delimiter=mark)]
    except csv.Error as error:
        raise InputError("not_a_table", reason=error) from None


def _xlsx_rows(content: bytes) -> tuple[list[list[str]], list[Sentence]]:
    """Cells as text of the first sheet that is shown, what is hidden in it left empty, and what is to be said of it.
    Raises InputError for what a table of walls never holds."""
    limits = Limits(MAX_ROWS, 4 * MAX_COLUMNS, MAX_CELLS, MAX_BYTES)
    whole = read_sheet(content, limits, lambda names: 0)
    name, sheet = whole.name[:MAX_NAME], whole.as_shown()
    try:
        found = {"formula_cells": sheet.formulas, "error_cells": sheet.errors}
        refuse_cells({"merged_cells": sheet.merged, **found})
    except InputError as error:
        raise error.at(place("sheet", name=name)) from None
    rows = [[text.strip() for text in sheet.texts(row)] for row in range(1, sheet.last_row + 1)]
    notes = [notice("table_sheet", sheet=name), *hidden_notes(whole, are_read=False)]
    if sheet.other_sheets:
        names = [other[:MAX_NAME] for other in sheet.other_sheets]
        notes.append(notice("other_sheets", names=spoken(names)))
    return rows, notes


def walls_of(rows: list[list[str]], with_demand: bool = False) -> list[Wall]:
    """Walls of a table's cells: a row of heads, a row of units, one row a wall; empty rows are skipped.
    with_demand : an empty height of the base is an error, never the ground."""
    rows = [(n, row) for n, row in enumerate(rows, start=1) if n == 2 or any(row)]
    if len(rows) >= 2 and rows[1][0] == 2 and not _is_units(rows[1][1]):
        rows.insert(1, (0, []))  # the heads name their units
    if len(rows) < 3:
        raise InputError("table_rows")
    if len(rows) > MAX_ROWS or len(rows[0][1]) > 4 * MAX_COLUMNS:
        raise InputError("table_too_large", rows=MAX_ROWS, columns=4 * MAX_COLUMNS)
    heads, keys = rows[0][1], _heads(rows[0][1])
    factors = _factors(keys, rows[1][1], heads)
    walls = []
    for number, row in rows[2:]:
        if any(cell for cell in row[len(keys) :]):
            raise InputError("value_beyond_columns", place=(place("row", n=number),))
        table = {}
        for key, factor, cell, head in zip(keys, factors, row, heads, strict=False):
            if key and cell:
                table[key] = _cell(key, factor, cell, place("cell", n=number, key=head[:60]))
        table.setdefault("name", f"row {number}")
        _gather_loads(table)
        try:
            if with_demand and "base_z_m" not in table:
                raise InputError("base_missing", key="base_z_m")
            walls.append(parse_wall(table))
        except InputError as error:
            where = _column_of(error, keys)
            here = place("row", n=number)
            if where is not None:
                here = place("cell", n=number, key=heads[where][:60])
            raise error.at(here) from None
    return walls


def _is_units(cells: list[str]) -> bool:
    """Whether this row has nothing but units, or nothing at all."""
    known = {name for units in UNITS.values() for name in units} | OTHER_UNITS | set(NO_UNIT)
    return all(cell.strip("[]() ").lower() in known for cell in cells)


def _column_of(error: InputError, keys: list) -> int | None:
    """The column an error of a wall is about."""
    key = error.key
    for part in error.place:
        if isinstance(part, Sentence) and part.code == "load":
            key = f"load{dict(part.values)['n']}_{key}"
    return keys.index(key) if key in keys else None


def _gather_loads(table: dict) -> None:
    """Put the cells of each load of a row together, as [[wall.load]] has them."""
    loads: dict[str, dict] = {}
    for key in [key for key in table if key.startswith("load")]:
        number, _, own = key.partition("_")
        loads.setdefault(number, {})[own] = table.pop(key)
    if loads:
        table["load"] = [loads[number] for number in sorted(loads)]
    across = {key.removeprefix("across_"): table.pop(key) for key in list(table) if key.startswith("across_")}
    if across:
        table["return_walls"] = across


def _heads(cells: list[str]) -> list[str | None]:
    known = {name: key for key, names in COLUMNS.items() for name in (key, *names)}
    while cells and not cells[-1]:
        cells = cells[:-1]
    keys = []
    for cell in cells:
        name = re.sub(r"\s*[\[(].*", "", cell).strip().lower()
        if name not in known:
            raise InputError("unknown_column", column=cell[:60], known=", ".join(COLUMNS))
        if known[name] in keys:
            raise InputError("column_twice", column=cell[:60])
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
        if not unit:  # the unit of the head, where it names one
            words = [re.sub(r"[. ]", "", name.strip().lower()) for name in _HEAD_UNIT.findall(heads[k])]
            unit = next((word for word in words if word in units), "")
        if unit not in units:
            raise InputError(
                "unknown_unit", unit=unit[:40], column=heads[k][:60], known=", ".join(name or "empty" for name in units)
            )
        for named in _HEAD_UNIT.findall(heads[k]):
            word = re.sub(r"^(in|unit|unità)\b|[. ]", "", named.strip().lower())
            if units.get(word, None if word in OTHER_UNITS else units[unit]) != units[unit]:
                raise InputError("two_units_of_column", column=heads[k][:60], named=named[:20], unit=unit or "none")
        factors.append(units[unit])
    return factors


def _cell(key: str, factor: float, cell: str, here: Sentence):
    """The value of a cell. here : its place, for an error"""
    if key == "mechanism":
        return _one_of(cell.replace("_", "-") if cell.isascii() else cell, MECHANISMS, here)
    if key in WORDS:
        return cell
    if key == "hinge_heights":
        if cell.lower() in (FLOORS, "piani"):
            return FLOORS
        if cell.lower() == BASE:
            return BASE
        try:
            return [parse_number(part) for part in re.split(r"[\s;]+", cell)]
        except InputError as error:
            raise error.at(here) from None
    if key.startswith("load") and key.endswith(("_kind", "_mass")):
        return _one_of(cell, LOAD_MASSES if key.endswith("_mass") else LOAD_KINDS, here)
    if key in ("free_element", "unloaded_confirmed"):
        if cell.lower() not in FLAGS:
            raise InputError("not_yes_or_no", text=cell[:60], place=(here,))
        return FLAGS[cell.lower()]
    try:
        value = parse_number(cell) * factor
    except InputError as error:
        raise error.at(here) from None
    return int(value) if key == "across_number" and value == int(value) else value


def _one_of(cell: str, words: dict[str, str], here: Sentence) -> str:
    """The code of a word of a list that a cell chooses from."""
    code = words.get(cell.lower())
    if code is None:
        known = ", ".join(word for word in words if word not in words.values() or word.isalpha())
        raise InputError("table_word", text=cell[:60], known=known, place=(here,))
    return code
