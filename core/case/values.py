"""The rule of one key and of one section: kind, range and words of what is accepted. Rules between keys: rules.py."""

import datetime
import difflib
import re
from collections.abc import Callable
from dataclasses import MISSING, fields
from types import SimpleNamespace

from core.case.document import PRESENCE, STATED, STRENGTH
from core.case.hinges import BASE, FLOORS
from core.case.hold_rules import refuse_old_keys, refuse_old_reasons
from core.case.keys import is_required
from core.case.number import parse_number
from core.case.schema import OWN_FIELDS
from core.case.sensitivity import MAX_ADDED, MAX_FACTOR, MIN_FACTOR
from core.case.site import Demand
from core.case.wall import MIN_ELASTIC, Wall
from core.errors import InputError, section
from core.file_names import is_text, name_of, shown
from core.text.sentence import Key, Sentence, sentence
from core.wall.moment_rotation import LAWS, WITH_BRANCH

MAX_TEXT, MAX_PARAGRAPHS, MAX_PATH = 500, 4_000, 12_000
"""Characters of a text, of one of several lines and of a name of a file, each byte of which may take three
(`names.key_of`)."""

MAX_CORNERS = 2000
"""Corners of a polygon, at most."""

MAX_VALUE_SHOWN = 100
"""Characters of a value repeated in a sentence."""

PERIOD_LIMITS = (0.02, 10.0)
"""Periods accepted for the check of compatibility [s]."""


def check_value(cls, key: str, value):
    """Check one value of a key of a section; raises InputError that names what is accepted."""
    return parse_value(field_of(cls, key), value)


def field_of(cls, key: str):
    return cls.__dataclass_fields__[key]


def refuse_unknown(cls, table: dict, here) -> None:
    """Refuse keys that are not of this section. here : its place"""
    keys = [entry.name for entry in fields(cls) if entry.name not in OWN_FIELDS]
    if cls is Wall:
        refuse_old_keys(table, here)
    if cls is Demand:
        refuse_old_reasons(table, (here,))
    for key in table:
        if key == "evidence" and key not in keys:
            raise InputError("evidence_elsewhere", place=(here,), key=key, kinds=(*PRESENCE, *STRENGTH, *STATED))
        if key not in keys:
            near = [name for name in keys if name.endswith(f"_{key}")] or difflib.get_close_matches(key, keys, 1)
            if near:
                raise InputError("unknown_key_near", place=(here,), value=quote_value(key), near=near[0])
            raise InputError("unknown_key", place=(here,), value=quote_value(key), known=tuple(keys))


def parse_section(cls, table, name: str, here):
    """Build the object of a section from its mapping, every value checked. Raises InputError.

    name : of the section
    here : its place
    """
    if not isinstance(table, dict):
        raise InputError("not_a_table_of_keys", name=here, value=quote_value(table))
    refuse_unknown(cls, table, here)
    table = getattr(cls, "upgrade_keys", lambda keys: keys)(table)
    values = {}
    for entry in fields(cls):
        if entry.name in table:
            values[entry.name] = parse_value(entry, table[entry.name], here)
        elif is_required(entry):
            raise InputError("missing", place=(here,), key=entry.name, accepted=accepted_by(entry))
    return cls(**values)


_QUOTED = re.compile(r"[+-]?\d+([.,]\d+)?")
"""A number as text."""


def are_ends(value) -> bool:
    """Whether this is a law by two numbers."""
    ends = list(value.values()) if isinstance(value, dict) else []
    named = ends and sorted(value) == ["elastic_limit", "plateau_end"]
    return bool(named) and _are_numbers(ends)


def _number(entry, value, here):
    rule = entry.metadata
    whole = rule["kind"] == "int"
    if isinstance(value, str) and _QUOTED.fullmatch(value.strip()):
        plain = value.strip().replace(",", ".")
        raise InputError("number_in_quotes", place=here, key=entry.name, value=quote_value(value), plain=plain)
    if isinstance(value, bool) or not isinstance(value, int if whole else (int, float)):
        return None
    above = value > rule["low"] if rule["exclusive"] else value >= rule["low"]
    if not (above and value <= rule["high"]):  # NaN is neither
        return None
    return value if whole else float(value)


def _range_of(entry) -> Sentence:
    rule = entry.metadata
    code = "whole" if rule["kind"] == "int" else "above" if rule["exclusive"] else "from"
    unit = f" {rule['unit']}" if rule["unit"] else ""
    return sentence("accepted", code, low=rule["low"], high=rule["high"], unit=unit)


def _choice(entry, value, here):
    return value if isinstance(value, str) and value in entry.metadata["names"] else None


def _is_short_text(value) -> bool:
    return isinstance(value, str) and len(value) <= MAX_TEXT and is_text(value)


def _text(entry, value, here):
    if isinstance(value, datetime.date):
        value = value.isoformat()
    return value if _is_short_text(value) and (value or entry.default is not MISSING) else None


def _paragraphs(entry, value, here):
    short = isinstance(value, str) and len(value) <= MAX_PARAGRAPHS and is_text(value.replace("\n", " "))
    return value if short else None


def _channel(entry, value, here):
    if type(value) is int and 1 <= value <= 999:
        return str(value)
    return value if _is_short_text(value) else None


_WRITTEN_ESCAPE = re.compile("[\x07\b\t\n\x0b\f\r\x1b]")
"""What \\t, \\n and the like of a path between double quotes are read as."""


def _path(entry, value, here):
    if isinstance(value, str) and _WRITTEN_ESCAPE.search(value):
        raise InputError("path_escaped", place=(here,), key=entry.name, found=shown(value[:MAX_PATH]))
    named = isinstance(value, str) and 0 < len(value) <= MAX_PATH and "\0" not in value
    return value if named and name_of(value) else None


def _flag(entry, value, here):
    return value if isinstance(value, bool) else None


def _are_numbers(values) -> bool:
    return all(type(value) in (int, float) for value in values)


def _pair(value, least: float, most: float) -> tuple[float, float] | None:
    """Read two numbers between least and most, the lower first; None for anything else."""
    if not isinstance(value, (list, tuple)) or len(value) != 2 or not _are_numbers(value):
        return None
    low, high = float(value[0]), float(value[1])
    return (low, high) if least <= low <= high <= most else None


def _range(entry, value, here):
    pair = _pair(value, *PERIOD_LIMITS)
    return pair if pair and pair[0] < pair[1] else None


def _factors(entry, value, here):
    return _pair(value, MIN_FACTOR, MAX_FACTOR)


def _setbacks(entry, value, here):
    return _pair(value, 0.0, MAX_ADDED)


def _list(entry, value, here):
    if not isinstance(value, (list, tuple)) or not value:
        return None
    item = SimpleNamespace(name=entry.name, metadata=entry.metadata["of"].metadata, default=MISSING)
    return tuple(parse_value(item, part, *here) for part in value)


def _texts(entry, value, here):
    """Read one text or several as a tuple; None for anything else."""
    texts = [value] if isinstance(value, str) else value
    fits = isinstance(texts, (list, tuple)) and all(_is_short_text(text) and text for text in texts)
    return tuple(texts) if fits and (texts or entry.default == ()) else None


def _tables(entry, value, here):
    if not isinstance(value, (list, tuple)) or not value:
        return None
    return tuple(_inner(entry, part, f"[[{entry.name}]] {k}", here) for k, part in enumerate(value, start=1))


def _section(entry, value, here):
    return _inner(entry, value, f"[{entry.metadata.get('section', 'wall')}.{entry.name}]", here)


def _inner(entry, value, name: str, here):
    """A section inside another, whose place is said first. name : as in the file"""
    try:
        return parse_section(entry.metadata["of"], value, entry.name, section(name))
    except InputError as error:
        above = [part for part in here if isinstance(part, Sentence)]
        raise (error.at(above[0]) if above else error) from None


def _spectrum(entry, value, here):
    return parse_section(entry.metadata["of"], value, "spectrum", section("[demand.spectrum]"))


def _hinges(entry, value, here):
    if value in (FLOORS, BASE):
        return value
    heights = value if isinstance(value, (list, tuple)) else ()
    fits = heights and _are_numbers(heights) and all(0.0 < h < 300.0 for h in heights)
    return tuple(sorted({float(h) for h in heights})) if fits else None


def parse_corners(value) -> tuple[tuple[float, float], ...] | None:
    """Corners of a polygon in the making, of any count: [[s, z], ...], or text "s z; s z; ..." of a table; None for
    what are none."""
    if isinstance(value, str):
        try:
            value = [[parse_number(part) for part in corner.split()] for corner in value.split(";") if corner.strip()]
        except InputError:
            return None
    if not isinstance(value, (list, tuple)) or len(value) > MAX_CORNERS:
        return None
    fits = all(isinstance(c, (list, tuple)) and len(c) == 2 and _are_numbers(c) for c in value)
    return tuple((float(s), float(z)) for s, z in value) if fits else None


def _polygon(entry, value, here):
    corners = parse_corners(value)
    if corners is None or len(corners) < 3:
        return None
    return corners if all(abs(number) <= 300.0 for corner in corners for number in corner) else None


def _law(entry, value, here):
    if not are_ends(value):
        return value if isinstance(value, str) and value in (*WITH_BRANCH, *LAWS) else None
    first, last = value["elastic_limit"], value["plateau_end"]
    if MIN_ELASTIC <= first <= last < 1.0:
        return {"elastic_limit": float(first), "plateau_end": float(last)}
    ends = {"first": quote_value(first), "last": quote_value(last), "least": MIN_ELASTIC}
    raise InputError("ends_not_accepted", place=here, key="law", **ends)


def _limits(entry, value, here):
    if not isinstance(value, (list, tuple)) or len(value) != 2 or not _are_numbers(value):
        return None
    low, high = float(value[0]), float(value[1])
    return (low, high) if entry.metadata["low"] <= low < high <= entry.metadata["high"] else None


def _said_of_limits(entry) -> Sentence:
    return sentence("accepted", "two_numbers", low=entry.metadata["low"], high=entry.metadata["high"])


def _said(code: str, /, **values) -> Callable:
    return lambda entry: sentence("accepted", code, **values)


def choices_of_key(entry) -> tuple[Key, ...]:
    """The choices of a key; the window says each in its words, see `FormNames.of`."""
    return tuple(Key(f"{entry.name}={name}") for name in entry.metadata["names"])


KINDS: dict[str, tuple[Callable, Callable]] = {
    "float": (_number, _range_of),
    "int": (_number, _range_of),
    "choice": (_choice, lambda entry: sentence("accepted", "one_of", names=choices_of_key(entry))),
    "text": (_text, _said("text", most=MAX_TEXT)),
    "paragraphs": (_paragraphs, _said("paragraphs", most=MAX_PARAGRAPHS)),
    "channel": (_channel, _said("channel_key")),
    "path": (_path, _said("path")),
    "flag": (_flag, _said("flag")),
    "range": (_range, _said("periods", low=PERIOD_LIMITS[0], high=PERIOD_LIMITS[1])),
    "factors": (_factors, _said("factors", low=MIN_FACTOR, high=MAX_FACTOR)),
    "setbacks": (_setbacks, _said("setbacks", high=MAX_ADDED)),
    "limits": (_limits, _said_of_limits),
    "list": (_list, lambda entry: sentence("accepted", "list", items=accepted_by(entry.metadata["of"]))),
    "texts": (_texts, _said("texts", most=MAX_TEXT)),
    "tables": (_tables, lambda entry: sentence("accepted", "tables", name=entry.name)),
    "section": (
        _section,
        lambda entry: sentence("accepted", "section", of=entry.metadata.get("section", "wall"), name=entry.name),
    ),
    "spectrum": (_spectrum, _said("table")),
    "hinges": (_hinges, _said("hinges", floors=FLOORS, base=BASE)),
    "polygon": (_polygon, _said("polygon", most=MAX_CORNERS)),
    "law": (_law, _said("law", names=(*WITH_BRANCH, *LAWS))),
}
"""Kind of a key -> what reads its value (field, value, place), None where it is not accepted, and its words."""


def accepted_by(entry) -> Sentence:
    """Sentence that says what a key accepts."""
    return KINDS[entry.metadata["kind"]][1](entry)


def parse_value(entry, value, *here):
    """Check one value against its field; raises InputError with place, value, accepted. here : the place."""
    read, accepted = KINDS[entry.metadata["kind"]]
    converted = read(entry, value, here)
    if converted is None:
        shown = quote_value(value)
        raise InputError("not_accepted", place=here, key=entry.name, value=shown, accepted=accepted(entry), found=value)
    return converted


def quote_value(value) -> str:
    """Repeat a value in a sentence, cut to the length that identifies it."""
    try:
        words = repr(value)
    except (ValueError, RecursionError):  # an integer of thousands of digits
        words = f"{type(value).__name__} …"
    return words if len(words) <= MAX_VALUE_SHOWN else words[:MAX_VALUE_SHOWN] + "…"
