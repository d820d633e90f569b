"""Kinds of keys. What is to be known of a key stands beside it, as metadata of its field: reader, form, table of walls,
sheet Input and the page of the case take it from there; its words are in resources/translations/key.json."""

from dataclasses import MISSING, field

NESTED = ("section", "tables", "spectrum")
"""Kinds of keys whose values are sections: the keys of those have the fields and the columns."""

FACTORS = {("m", "cm"): 100.0, ("", "%"): 100.0}
"""Unit of a key, unit of its field in a form -> what a value is multiplied with."""


def key(kind: str, default=None, **rule):
    """Declare a key of a section: a dataclass field with its kind and its rules as metadata.

    form : group of the fields of its form; without it the form of its section says by hand where it stands
    filled : the form shows its field where it is given only, and does not let it be emptied
    listed : of a whole number, its field is a list
    required : also where an optional key stands before it
    columns : of a section or of tables, how the names of their columns in a table of walls begin
    """
    return field(default=default, metadata={"kind": kind, **rule})


def is_required(entry) -> bool:
    """Whether a section must have this key."""
    return entry.default is MISSING or entry.metadata.get("required", False)


def number_key(low, high, default=None, unit="", exclusive=False, whole=False, **rule):
    """A number in [low, high] (low excluded if exclusive), NaN and infinity refused. form_unit : that of its field"""
    kind = "int" if whole else "float"
    return key(kind, default, low=low, high=high, unit=unit, exclusive=exclusive, **rule)


def channel_key():
    """The channel of a file of several: its name, or its number from 1 as a number or as text."""
    return key("channel", "")


def text_key(default="", **rule):
    return key("text", default, **rule)


def paragraphs_key(**rule):
    """Text of several lines."""
    return key("paragraphs", "", **rule)


def path_key(default):
    """A name of a file: longer than other text, and with any letter the system allows."""
    return key("path", default)


def flag_key(default=False, **rule):
    return key("flag", default, **rule)


def choice_key(*names, default=MISSING, **rule):
    return key("choice", default, names=names, **rule)


def unit_in_form(entry) -> tuple[str, float]:
    """Unit of the field of a key, and what a value of the case is multiplied with for it."""
    unit = entry.metadata.get("unit", "")
    shown = entry.metadata.get("form_unit", unit)
    return format_unit(shown), FACTORS.get((unit, shown), 1.0)


def format_unit(unit: str) -> str:
    """A unit as a person writes it: kN/m³, °."""
    return "°" if unit == "deg" else unit.replace("2", "²").replace("3", "³")


def section_to_dict(value):
    """A section as a mapping of its keys, with those inside it; any other value as it is. `dataclasses.asdict` copies
    each number, which took a third of a key typed beside 200 walls."""
    if isinstance(value, tuple):
        return tuple(map(section_to_dict, value))
    if isinstance(value, dict):
        return dict(value)
    keys = getattr(value, "__dataclass_fields__", None)
    return value if keys is None else {key: section_to_dict(getattr(value, key)) for key in keys}
