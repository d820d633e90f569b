"""The fields of a form, made from the description of its keys (core/case/schema.py, core/case/site.py)."""

from collections.abc import Sequence
from dataclasses import fields

from app.input.corners_field import CornersField
from app.input.fields import ChoiceField, Field, FlagField, TextField
from app.input.hinges_field import HingesField
from app.input.number_fields import NumberField, RangeField
from app.input.paragraphs_field import ParagraphsField
from core.case.keys import NESTED
from core.case.values import field_of

FIELD_OF_KIND: dict[str, type[Field]] = {
    "float": NumberField,
    "int": NumberField,
    "range": RangeField,
    "text": TextField,
    "paragraphs": ParagraphsField,
    "choice": ChoiceField,
    "flag": FlagField,
    "hinges": HingesField,
    "polygon": CornersField,
}
"""Kind of a key -> its field."""


def make_field(section: type, key: str) -> Field:
    """The field of a key."""
    entry = field_of(section, key)
    kind = entry.metadata["kind"]
    in_a_list = entry.metadata.get("listed") or (kind == "flag" and entry.default is None)
    return ChoiceField(section, key) if in_a_list else FIELD_OF_KIND[kind](section, key)


def make_fields(section: type, group: str | None = None, first: Sequence[str] = ()) -> list[Field]:
    """Fields of all keys of a section of this group of its form, in the order of the file. first : keys that come
    before the others in the form"""
    keys = [
        entry.name
        for entry in fields(section)
        if entry.metadata.get("form") == group and entry.metadata["kind"] not in NESTED
    ]
    return [make_field(section, key) for key in (*first, *(key for key in keys if key not in first))]
