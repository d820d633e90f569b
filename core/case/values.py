"""The rule of one key and of one section: kind, range and words of what is accepted. Rules between keys: rules.py."""

import datetime
import difflib
import re
from dataclasses import MISSING, fields
from types import SimpleNamespace

from core.case.hinges import BASE, FLOORS
from core.case.schema import MIN_ELASTIC, OWN_FIELDS
from core.case.site import Spectrum
from core.errors import InputError, section
from core.file_names import is_text, name_of
from core.text.sentence import Sentence, sentence
from core.wall.moment_rotation import LAWS

MAX_TEXT, MAX_PATH = 500, 12_000
"""Characters of a text and of a name of a file, each byte of which may take three (`names.key_of`)."""

SHOWN = 100
"""Characters of a value repeated in a sentence."""

PERIOD_LIMITS = (0.02, 10.0)
"""Periods accepted for the check of compatibility [s]."""


def check_value(cls, key: str, value):
    """One value of a key of a section, checked; raises InputError that names what is accepted."""
    return value_of(field_of(cls, key), value)


def field_of(cls, key: str):
    return next(entry for entry in fields(cls) if entry.name == key)


def refuse_unknown(cls, table: dict, name: str, here) -> None:
    """Refuse keys that are not of this section.

    name : of the section
    here : its place
    """
    keys = [entry.name for entry in fields(cls) if entry.name not in OWN_FIELDS]
    for key in table:
        if key not in keys:
            near = difflib.get_close_matches(key, keys, 1)
            if near:
                raise InputError("unknown_key_near", place=(here,), value=repeated(key), near=near[0])
            raise InputError("unknown_key", place=(here,), value=repeated(key), known=tuple(keys))


def section_of(cls, table, name: str, here):
    """A section of a mapping as an object of its class, every value checked. Raises InputError.

    name : of the section
    here : its place
    """
    if not isinstance(table, dict):
        raise InputError("not_a_table_of_keys", name=here, value=repeated(table))
    refuse_unknown(cls, table, name, here)
    values = {}
    for entry in fields(cls):
        if entry.name in table:
            values[entry.name] = value_of(entry, table[entry.name], here)
        elif entry.default is MISSING:
            raise InputError("missing", place=(here,), key=entry.name, accepted=accepted_by(entry))
    return cls(**values)


_QUOTED = re.compile(r"[+-]?\d+([.,]\d+)?")
"""A number as text."""


def are_ends(value) -> bool:
    """Whether this is a law by two numbers."""
    ends = list(value.values()) if isinstance(value, dict) else []
    named = ends and sorted(value) == ["elastic_limit", "plateau_end"]
    return bool(named) and all(type(end) in (int, float) for end in ends)


def accepted_by(entry) -> Sentence:
    """What a key accepts."""
    rule = entry.metadata
    kind = rule["kind"]
    if kind == "choice":
        return sentence("accepted", "one_of", names=tuple(rule["names"]))
    if kind in ("float", "int"):
        code = "whole" if kind == "int" else "above" if rule["exclusive"] else "from"
        unit = f" {rule['unit']}" if rule["unit"] else ""
        return sentence("accepted", code, low=rule["low"], high=rule["high"], unit=unit)
    if kind == "range":
        return sentence("accepted", "periods", low=PERIOD_LIMITS[0], high=PERIOD_LIMITS[1])
    if kind == "law":
        return sentence("accepted", "law", names=tuple(LAWS))
    if kind == "hinges":
        return sentence("accepted", "hinges", floors=FLOORS, base=BASE)
    if kind == "list":
        return sentence("accepted", "list", items=accepted_by(rule["of"]))
    if kind == "tables":
        return sentence("accepted", "tables", name=entry.name)
    if kind == "section":
        return sentence("accepted", "section", of=rule.get("in", "wall"), name=entry.name)
    if kind == "channel":
        return sentence("accepted", "channel_key")
    if kind == "text":
        return sentence("accepted", "text", most=MAX_TEXT)
    return sentence("accepted", {"flag": "flag", "spectrum": "table", "path": "path"}[kind])


def value_of(entry, value, *here):
    """One value checked against its field; raises InputError with place, value, accepted. here : the place."""
    rule = entry.metadata
    kind = rule["kind"]
    if kind in ("float", "int"):
        fits = isinstance(value, (int, float) if kind == "float" else int)
        if fits and not isinstance(value, bool):
            above = value > rule["low"] if rule["exclusive"] else value >= rule["low"]
            if above and value <= rule["high"]:  # NaN is neither
                return float(value) if kind == "float" else value
    elif kind == "choice":
        if isinstance(value, str) and value in rule["names"]:
            return value
    elif kind == "text":
        if isinstance(value, datetime.date):
            value = value.isoformat()
        printable = isinstance(value, str) and len(value) <= MAX_TEXT and is_text(value)
        if printable and (value or entry.default is not MISSING):
            return value
    elif kind == "channel":
        if type(value) is int and 1 <= value <= 999:
            return str(value)
        if isinstance(value, str) and len(value) <= MAX_TEXT and is_text(value):
            return value
    elif kind == "path":
        named = isinstance(value, str) and 0 < len(value) <= MAX_PATH and "\0" not in value
        if named and name_of(value):
            return value
    elif kind == "flag":
        if isinstance(value, bool):
            return value
    elif kind == "range":
        pair = list(value) if isinstance(value, (list, tuple)) else []
        if len(pair) == 2 and all(type(end) in (int, float) for end in pair):
            low, high = float(pair[0]), float(pair[1])
            if PERIOD_LIMITS[0] <= low < high <= PERIOD_LIMITS[1]:
                return (low, high)
    elif kind == "list":
        if isinstance(value, (list, tuple)) and value:
            item = SimpleNamespace(name=entry.name, metadata=rule["of"].metadata, default=MISSING)
            return tuple(value_of(item, part, *here) for part in value)
    elif kind == "tables":
        if isinstance(value, (list, tuple)) and value:
            above = [part for part in here if isinstance(part, Sentence)]
            parts = []
            for k, part in enumerate(value, start=1):
                try:
                    parts.append(section_of(rule["of"], part, entry.name, section(f"[[{entry.name}]] {k}")))
                except InputError as error:
                    raise (error.at(above[0]) if above else error) from None
            return tuple(parts)
    elif kind == "section":
        try:
            return section_of(rule["of"], value, entry.name, section(f"[{rule.get('in', 'wall')}.{entry.name}]"))
        except InputError as error:
            above = [part for part in here if isinstance(part, Sentence)]
            raise (error.at(above[0]) if above else error) from None
    elif kind == "spectrum":
        return section_of(Spectrum, value, "spectrum", section("[demand.spectrum]"))
    elif kind == "hinges":
        if value in (FLOORS, BASE):
            return value
        heights = value if isinstance(value, (list, tuple)) else ()
        if heights and all(type(h) in (int, float) and 0.0 < h < 300.0 for h in heights):
            return tuple(sorted({float(h) for h in heights}))
    elif kind == "law":
        if isinstance(value, str) and value in LAWS:
            return value
        if are_ends(value):
            first, last = value["elastic_limit"], value["plateau_end"]
            if MIN_ELASTIC <= first <= last < 1.0:
                return {"elastic_limit": float(first), "plateau_end": float(last)}
            raise InputError(
                "ends_not_accepted",
                place=here,
                key="law",
                first=repeated(first),
                last=repeated(last),
                least=MIN_ELASTIC,
            )
    shown, accepted = repeated(value), accepted_by(entry)
    if kind in ("float", "int") and isinstance(value, str) and _QUOTED.fullmatch(value.strip()):
        plain = value.strip().replace(",", ".")
        raise InputError("number_in_quotes", place=here, key=entry.name, value=shown, plain=plain)
    raise InputError("not_accepted", place=here, key=entry.name, value=shown, accepted=accepted, found=value)


def repeated(value) -> str:
    """A value in a sentence, not longer than needed to know it."""
    try:
        words = repr(value)
    except (ValueError, RecursionError):  # an integer of thousands of digits
        words = f"{type(value).__name__} …"
    return words if len(words) <= SHOWN else words[:SHOWN] + "…"
