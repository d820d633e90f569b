"""Columns of a table of walls: titles of each key in both languages, units, and the wall that a row of cells is."""

import functools
import itertools
import re
from collections.abc import Iterable
from dataclasses import Field, fields
from difflib import get_close_matches
from typing import NamedTuple

from core.case.directions import LONGEST
from core.case.document import PRESENCE, STATED, STRENGTH
from core.case.hinges import BASE, FLOORS
from core.case.hold import HOLD_KINDS, TIE
from core.case.keys import NESTED
from core.case.number import parse_quantity
from core.case.rules import parse_wall
from core.case.set_aside import ROWS
from core.case.tie_rules import OF_A_TIE, OF_AN_OLD_TIE
from core.case.values import field_of
from core.case.wall import Wall
from core.errors import InputError, place
from core.quantities import UNITS_WRITTEN, factor_to, unit_of
from core.text.catalogue import CATALOGUE
from core.text.sentence import LANGUAGES, Key, Sentence

MAX_LOADS = 4

_OF_PARTS = re.compile(r"[0-9]_")
"""In columns of holds, loads, solids and openings, which a sentence leaves out where none of them is near."""


class Column(NamedTuple):
    """What stands in a column: the key, the titles it may have, in small letters, and the words of its choices beside
    those of a case file."""

    entry: Field
    titles: frozenset[str]
    words: dict[str, str] = {}


@functools.cache
def columns() -> dict[str, Column]:
    """Name of a column -> column, of every key of a wall, also of those of its loads and return walls: "load1_kn_m",
    "across_friction", and of what shows a hold. One of these is called by the title of the load and by its own, the
    first by the former alone."""
    by_name = {}
    for entry in fields(Wall):
        if entry.metadata["kind"] not in NESTED:
            titles = (entry.name, *(title for k in range(len(LANGUAGES)) for title in _titles(entry.name, k)))
            by_name[entry.name] = Column(entry, frozenset(titles), WORDS_OF_CHOICE.get(entry.name, {}))
        for n in range(1, MAX_LOADS + 1) if "columns" in entry.metadata else ():
            texts = CATALOGUE["key"]
            titles_of = texts.get(f"{entry.name}.columns") or texts[f"{entry.name}.column"]
            whole = [title.format(n=n) for title in titles_of]
            by_name.update(_columns_of(entry, n, whole))
    return by_name


def _columns_of(entry: Field, n: int, before: list[str]) -> dict[str, Column]:
    """Columns of a section inside another. n : of which, from 1; before : its title in each language"""
    by_name = {}
    inside = [inner for inner in fields(entry.metadata["of"]) if inner.metadata["kind"] not in NESTED]
    for k, inner in enumerate(inside):
        name = entry.metadata["columns"].format(n=n) + inner.name
        titles = {name, *(before if k == 0 else ())}
        for language, title in enumerate(before):
            titles |= {f"{title} {end}" for end in _titles(inner.name, language)}
        by_name[name] = Column(inner, frozenset(titles), WORDS_OF_CHOICE.get(f"{entry.name}.{inner.name}", {}))
    for inner in fields(entry.metadata["of"]):
        if inner.metadata["kind"] == "section":
            both = zip(before, CATALOGUE["key"][f"{inner.name}.column"], strict=True)
            by_name.update(_columns_of(inner, n, [f"{title} {word}" for title, word in both]))
    return by_name


def _titles(key: str, language: int) -> list[str]:
    """What a key is called in a table beside its name, in the language of this number: its `.column` in the catalogue,
    else its word."""
    texts = CATALOGUE["key"]
    return texts.get(f"{key}.column", texts[key])[language].lower().split(", ")


LOAD_KINDS = {
    "verticale": "vertical",
    "spinta": "thrust",
    "massa portata": "carried_mass",
    "vertical": "vertical",
    "thrust": "thrust",
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
    "flessione verticale": "vertical_bending",
    "flessione orizzontale": "horizontal_bending",
    "two-sided": "two_sided",
    "one-sided": "one_sided",
    "both": "both",
    "vertical bending": "vertical_bending",
    "horizontal bending": "horizontal_bending",
}


def _catalogue_words(names: Iterable[str]) -> dict[str, str]:
    """Word of a choice in each language, in small letters, and its name -> its name."""
    shown = CATALOGUE["word"]
    return {word.lower(): name for name in names for word in (*shown[f"choice_{name}"], name)}


WORDS_OF_CHOICE = {
    "mechanism": MECHANISMS,
    "load.kind": LOAD_KINDS,
    "load.mass": LOAD_MASSES,
    "set_aside.mechanism": _catalogue_words(ROWS),
    "hold.kind": _catalogue_words(HOLD_KINDS) | {"tirante": TIE},
    "evidence.kind": _catalogue_words((*PRESENCE, *STRENGTH, *STATED)),
}
"""Key -> its words in a table; another choice is written as in the case file."""

OLD_COLUMNS = {
    **dict.fromkeys(("back_restraint", "restraint", "vincolo"), "hold1_kind"),
    **dict.fromkeys(("restraint_evidence", "evidence of the restraint", "prova del vincolo"), "hold1_evidence_kind"),
    **dict.fromkeys(("restraint_note", "note on the restraint", "nota sul vincolo"), "hold1_evidence_note"),
    **dict.fromkeys(("restraint_kn_m", "hold", "tenuta"), "hold1_out_kn_m"),
}
"""Titles of older tables -> the column that says the same now."""

OLD_STARTS = {
    "arch ": "hold1_spacing_m",
    "arco ": "hold1_spacing_m",
    "arch_": "hold1_spacing_m",
    **dict.fromkeys(("tie_height", "tie height", "quota catena"), "hold1_h_m"),
    **dict.fromkeys(("tie_spacing", "tie spacing", "interasse catene"), "hold1_spacing_m"),
    **dict.fromkeys(("tie_bar", "tie bar length", "lunghezza barra catena"), "hold1_bar_length_m"),
    **dict.fromkeys(("tie_elong", "tie elongation", "allungamento catena"), "hold1_elongation_m"),
}
OLD_STARTS |= {f"load{n}_{key}": f"hold{n}_{key}" for n in range(1, MAX_LOADS + 1) for key in OF_AN_OLD_TIE}
OLD_STARTS |= {f"load{n}_elongation": f"hold{n}_elongation_m" for n in range(1, MAX_LOADS + 1)}
"""How older titles began -> the column that says the same now."""

UNIT_WORDS = ("u.m.", "u.m", "unità", "unita", "unit", "units")
"""What stands above or before a row of units."""

MAY_BE_EMPTY = ("", "kN/m3", "kN/m", "deg", "m2")
"""Units of keys whose column may name none."""

NO_UNIT = ("", "-", "–")

LENGTH_KINDS, WORD_KINDS = ("hinges", "polygon"), ("text", "choice", "flag", "law")
"""Kinds of keys that hold several lengths in metres, and those that hold words."""

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

OF_A_SMALL_UNIT = 0.05
"""Factor of the unit of a column over that of its key below which `1.200` is more likely 1200 than 1.2: the program
asks."""

THOUSANDS = re.compile(r"[+−-]?[1-9]\d{0,2}(\.\d{3})+(\s*[^\W\d].*)?")


class Head(NamedTuple):
    """The titles of a table, the keys of its columns, what each is multiplied with, and whether an empty height of the
    base is an error."""

    heads: list[str]
    keys: list[str]
    factors: list[float]
    with_demand: bool

    @classmethod
    def of(cls, heads: list[str], units: list[str], with_demand: bool) -> "Head":
        """Read the head from the rows of titles and of units. Raises InputError."""
        keys = _heads(heads)
        return cls(heads, keys, _factors(keys, units, heads), with_demand)

    def wall(self, number: int, row: list[str]) -> Wall:
        """The wall of the cells of a row. number : of the row, from 1. Raises InputError."""
        heads, keys = self.heads, self.keys
        if any(cell for cell in row[len(keys) :]):
            raise InputError("value_beyond_columns", place=(place("row", n=number),))
        table = {}
        for key, factor, cell, head in zip(keys, self.factors, row, heads, strict=False):
            if key and cell:
                table[key] = _cell(key, factor, cell, place("cell", n=number, key=head[:60]))
        table.setdefault("name", f"row {number}")
        _gather(table)
        try:
            if self.with_demand and "base_z_m" not in table:
                raise InputError("base_missing", key="base_z_m")
            return parse_wall(Wall.with_mechanism(table) if self.with_demand else table)
        except InputError as error:
            where = _column_of(error, keys)
            here = place("row", n=number)
            if where is not None:
                here = place("cell", n=number, key=heads[where][:60])
            raise error.at(here) from None


def is_units(cells: list[str]) -> bool:
    """Whether this row has nothing but units, or nothing at all."""
    return all(not cell or cell.lower() in UNIT_WORDS or unit_of(cell) is not None for cell in cells)


def _column_of(error: InputError, keys: list) -> int | None:
    """The column an error of a wall is about."""
    key = error.key
    for part in error.place:
        if not isinstance(part, Sentence):
            continue
        values = dict(part.values)
        if part.code in ("load", "solid", "hold"):
            key = f"{part.code}{values['n']}_{key}"
        elif inside := re.fullmatch(r"\[\[(\w+)\]\] (\d+)", str(values.get("name", ""))):
            key = field_of(Wall, inside[1]).metadata["columns"].format(n=inside[2]) + str(key)
    return keys.index(key) if key in keys else None


def _gather(table: dict) -> None:
    """Put the cells of each load, opening, ... of a row together, as [[wall.load]] has them, and those of a section."""
    for entry in fields(Wall):
        if "columns" not in entry.metadata:
            continue
        starts = dict.fromkeys(entry.metadata["columns"].format(n=n) for n in range(1, MAX_LOADS + 1))
        parts = [{key.removeprefix(at): table.pop(key) for key in list(table) if key.startswith(at)} for at in starts]
        sections = [inner for inner in fields(entry.metadata["of"]) if inner.metadata["kind"] == "section"]
        for part, inner in itertools.product(parts, sections):
            own = [own.name for own in fields(inner.metadata["of"]) if f"{inner.name}_{own.name}" in part]
            shown = {name: part.pop(f"{inner.name}_{name}") for name in own}
            part.update({inner.name: shown} if shown else {})
        if given := [part for part in parts if part]:
            table[entry.name] = given if entry.metadata["kind"] == "tables" else given[0]


def _heads(cells: list[str]) -> list[str]:
    known = {title: name for name, column in columns().items() for title in column.titles}
    while cells and not cells[-1]:
        cells = cells[:-1]
    keys = []
    for cell in cells:
        name = re.sub(r"\s*[\[(].*", "", cell).strip().lower()
        if name.replace(" ", "_") in ("variant_of", "variante_di"):
            raise InputError("variant_of_in_table", column=cell[:60])
        if written := _name_of_older(name):
            raise InputError("old_column", column=cell[:60], written=written)
        if name in ("free_element", "free to vibrate", "libero di vibrare", "elemento libero"):
            raise InputError("old_free", key=cell[:60], written="hold1_kind", mechanism=Key("mechanism"))
        if name in ("all_directions", "all directions", "tutte le direzioni"):
            raise InputError("directions_by_themselves", key=cell[:60], most=LONGEST)
        if name not in known:
            near = dict.fromkeys(known[title] for title in get_close_matches(name, known, 5))
            plain = (column for column in columns() if not _OF_PARTS.search(column))
            raise InputError("unknown_column", column=cell[:60], known=", ".join(near or plain))
        if known[name] in keys:
            raise InputError("column_twice", column=cell[:60])
        keys.append(known[name])
    return keys


def _name_of_older(title: str) -> str | None:
    """The column that says now what one of this title said, None of a title that is not older."""
    starts = (written for start, written in OLD_STARTS.items() if title.startswith(start))
    if (written := OLD_COLUMNS.get(title) or next(starts, None)) or not (tie := _OF_A_LOAD.fullmatch(title)):
        return written
    keys = (key for key in OF_A_TIE for language in range(len(LANGUAGES)) if tie[2] in _titles(key, language))
    return next((f"hold{tie[1]}_{key}" for key in keys), None)


OLD_TIE = re.compile(r"load\d_kind (tie|catena|tirante)")
"""Cells that said that a load is a tie."""

_OF_A_LOAD = re.compile(r"(?:carico|load) (\d) (.+)")

_REMARK = re.compile(r"[^\W\d_]+([ '-][^\W\d_]+)*")
_BRACKETS = re.compile(r"[\[(]\s*([^\[\]()]*)")
_LETTER = re.compile(r"[^\W\d_]")
_BRACKET = re.compile(r"[\[(][^\[\]()]*[\])]")


def _factors(keys: list, cells: list[str], heads: list[str]) -> list[float]:
    """Factor of each column: its unit, in the row of units, in brackets in the head or in both, over that of its key.
    What stands in the brackets of a number is a unit of the key, or the table is refused; a word beside the unit is a
    remark, and so is what stands beside a word, unless it is a unit. A title that is the key of a case file has its
    unit."""
    factors = []
    for k, key in enumerate(keys):
        kind, metadata = columns()[key].entry.metadata["kind"], columns()[key].entry.metadata
        unit = "m" if kind in LENGTH_KINDS else metadata.get("unit", "")
        below = (cells[k] if k < len(cells) else "").strip()
        below = "" if below.lower() in UNIT_WORDS else below
        named = [one.strip() for one in (below, *_BRACKETS.findall(heads[k])) if one.strip("[]() ") not in NO_UNIT]
        units = [one for one in named if unit_of(one) is not None]
        if kind in WORD_KINDS or (units and all(_REMARK.fullmatch(one) for one in named if one not in units)):
            named = units
        if beside := _beside_unit(heads[k]):
            raise _unknown_unit(beside, heads[k], unit)
        unit_factors = []
        for text in named:
            factor = factor_to(text, unit)
            if factor is None or (kind in (*WORD_KINDS, "polygon") and factor != 1.0):
                raise _unknown_unit(text, heads[k], unit, kind == "polygon")
            unit_factors.append(factor)
        names_it = heads[k].strip().lower() == key  # a key of a case file ends with its unit
        if not unit_factors and kind not in LENGTH_KINDS and unit not in MAY_BE_EMPTY and not names_it:
            raise _unknown_unit("", heads[k], unit)
        if len(set(unit_factors)) > 1:
            raise InputError("two_units_of_column", column=heads[k][:60], named=named[1][:20], unit=named[0][:20])
        factors.append(unit_factors[0] if unit_factors else 1.0)
    return factors


def _beside_unit(head: str) -> str:
    """What a title says behind its brackets and is no mere word: a factor, another unit; "" where it says nothing."""
    behind = _BRACKET.split(head, maxsplit=1)[1:]
    words = _BRACKET.sub(" ", " ".join(behind)).strip()
    mere = _REMARK.fullmatch(words) and not any(unit_of(word) for word in words.split() if len(word) > 1)
    return "" if mere else words


def _unknown_unit(text: str, head: str, unit: str, alone: bool = False) -> InputError:
    """A text where the unit of a column stands, or should. alone : no other one is taken"""
    known = unit if alone else UNITS_WRITTEN.get(unit, unit)
    return InputError("unknown_unit", unit=text[:40], column=head[:60], known=known)


def _cell(key: str, factor: float, cell: str, here: Sentence):
    """Read the value of a cell; lines of a text are one. here : its place, for an error"""
    cell = " ".join(cell.splitlines())
    entry, words = columns()[key].entry, columns()[key].words
    kind = entry.metadata["kind"]
    if OLD_TIE.fullmatch(f"{key} {cell.lower()}"):
        raise InputError(
            "old_column", column=f"{key} = {cell[:40]}", written=key.replace("load", "hold"), place=(here,)
        )
    if words:
        return _one_of(cell.replace("_", "-") if key == "mechanism" and cell.isascii() else cell, words, here)
    if kind in ("text", "choice", "law", "polygon"):
        return cell
    if kind == "flag":
        if cell.lower() not in FLAGS:
            raise InputError("not_yes_or_no", text=cell[:60], place=(here,))
        return FLAGS[cell.lower()]
    try:
        if kind != "hinges":
            if factor < OF_A_SMALL_UNIT and THOUSANDS.fullmatch(cell):
                raise InputError("thousands_or_point", text=cell)
            value = parse_quantity(cell, entry.metadata.get("unit", ""), factor)
            return int(value) if kind == "int" and value == int(value) else value
        if cell.lower() in (FLOORS, "piani"):
            return FLOORS
        if cell.lower() == BASE:
            return BASE
        parts = re.split(r"\s*;\s*|\s+(?![^\W\d])", cell)
        if len({bool(_LETTER.search(part)) for part in parts}) > 1:  # the unit of one is that of all, or not
            raise InputError("unit_of_number", text=cell[:60], known="m")
        return [parse_quantity(part, "m", factor) for part in parts]
    except InputError as error:
        raise error.at(here) from None


def _one_of(cell: str, words: dict[str, str], here: Sentence) -> str:
    """Code of the word of a list in a cell. Raises InputError for a word that is not in the list."""
    code = words.get(cell.lower())
    if code is None:
        known = ", ".join(word for word in words if word not in words.values() or word.isalpha())
        raise InputError("table_word", text=cell[:60], known=known, place=(here,))
    return code
