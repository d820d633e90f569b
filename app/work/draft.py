"""A case of which a file can hold everything: the last guard of an unsaved edit."""

from dataclasses import MISSING, fields, is_dataclass, replace
from typing import Any

from core.case.keys import is_required
from core.case.schema import Case
from core.case.values import are_ends, parse_corners, parse_value
from core.errors import InputError

TO_BE_GIVEN: Any = ""
"""The value of a key that has none yet, whatever its type: only a draft holds it."""


def make_savable(case: Case) -> tuple[Case, list[InputError]]:
    """The case without the values that a case file is refused for, each empty or its default, and why each is left out:
    one such value must not keep all the others from being written. A value that a file gives back as another, as
    heights that do not rise, is the one it gives back."""
    left_out: list[InputError] = []
    return _readable(case, left_out), left_out


def _readable(section: Any, left_out: list[InputError]) -> Any:
    changed = {}
    for entry in fields(section):
        value = getattr(section, entry.name)
        if is_dataclass(value):
            changed[entry.name] = _readable(value, left_out)
        elif isinstance(value, tuple) and value and all(map(is_dataclass, value)):
            changed[entry.name] = tuple(_readable(part, left_out) for part in value)
        elif "kind" in entry.metadata and value not in (None, "", entry.default):
            try:
                changed[entry.name] = _read(entry, value)
            except InputError as error:
                left_out.append(error)
                empty = "" if is_required(entry) or entry.default is MISSING else entry.default
                changed[entry.name] = empty
    return replace(section, **changed)


def _read(entry: Any, value: Any) -> Any:
    """A value as `parse_draft` reads it, for which corners and ends of a law may be work in progress. Raises InputError
    where it is refused."""
    kind = entry.metadata["kind"]
    in_progress = (kind == "polygon" and parse_corners(value) is not None) or (kind == "law" and are_ends(value))
    return value if in_progress else parse_value(entry, value)
