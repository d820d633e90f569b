"""JSON for people: what fits in a line stands in one, the rest a key or an item a line."""

import json
from typing import Any

WIDTH = 120
"""Characters of a line."""

_line = json.JSONEncoder(allow_nan=False, ensure_ascii=False).encode  # without an indent it is written in C


def readable(value: Any, depth: int = 0) -> str:
    """JSON text of a value that begins behind so many blanks; raises ValueError should a number not be finite."""
    line = _line(value)
    if len(line) + depth <= WIDTH or not isinstance(value, (dict, list, tuple)):
        return line
    ends, parts = "[]", [readable(item, depth + 1) for item in value]
    if isinstance(value, dict):
        ends, parts = "{}", [f"{_line(key)}: {readable(item, depth + 1)}" for key, item in value.items()]
    between = ",\n" + " " * (depth + 1)
    return f"{ends[0]}{between[1:]}{between.join(parts)}\n{' ' * depth}{ends[1]}"
