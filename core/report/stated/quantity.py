"""A quantity of the results: what the JSON, the columns of many walls, the sheets and the page of the results share."""

from collections.abc import Callable, Iterator, Sequence
from operator import attrgetter
from typing import Any, NamedTuple

Read = Callable[[Any], Any] | str | None
"""How a value is read: a function of its source, the name of an attribute, None of the attribute named as the key."""


class Quantity(NamedTuple):
    """One key of the results.

    kind : text, whole, number, flag; texts, wholes, numbers are lists; one is an object of `group`, many a list of
        them, named a mapping of names to them; free is an object whose keys are names, frees a list of them; any is a
        number, a text or an object of the case; pairs is a list of two numbers each, rows one of lists of texts
    unit : "" of what has none
    group : the quantities of an object
    left_out : the key is not written where there is nothing
    line : name of its line in the sheet Check and in the note (core/derivation), "" of what they do not derive
    """

    key: str
    kind: str
    meaning: str
    of: Callable[[Any], Any]
    unit: str = ""
    group: tuple["Quantity", ...] = ()
    left_out: bool = False
    line: str = ""

    def optional(self) -> "Quantity":
        return self._replace(left_out=True)


def _made(kind: str, key: str, meaning: str, of: Read, unit: str = "", group: Sequence[Quantity] = ()) -> Quantity:
    return Quantity(key, kind, meaning, of if callable(of) else attrgetter(of or key), unit, tuple(group))


def text(key: str, meaning: str, of: Read = None) -> Quantity:
    return _made("text", key, meaning, of)


def texts(key: str, meaning: str, of: Read = None) -> Quantity:
    return _made("texts", key, meaning, of)


def flag(key: str, meaning: str, of: Read = None) -> Quantity:
    return _made("flag", key, meaning, of)


def whole(key: str, meaning: str, of: Read = None) -> Quantity:
    return _made("whole", key, meaning, of)


def number(key: str, unit: str, meaning: str, of: Read = None, line: str = "") -> Quantity:
    return _made("number", key, meaning, of, unit)._replace(line=line)


def numbers(key: str, unit: str, meaning: str, of: Read = None) -> Quantity:
    return _made("numbers", key, meaning, of, unit)


def untyped_quantity(key: str, meaning: str, of: Read = None) -> Quantity:
    return _made("free", key, meaning, of)


def object_quantity(key: str, meaning: str, group: Sequence[Quantity], of: Read = None) -> Quantity:
    return _made("one", key, meaning, of, group=group)


def list_quantity(key: str, meaning: str, group: Sequence[Quantity], of: Read = None) -> Quantity:
    return _made("many", key, meaning, of, group=group)


def mapping_quantity(key: str, meaning: str, group: Sequence[Quantity], of: Read = None) -> Quantity:
    return _made("named", key, meaning, of, group=group)


def identity(source: Any) -> Any:
    """Read an object from the source of what holds it."""
    return source


def scaled_reader(divisor: float, attribute: str) -> Callable[[Any], float | None]:
    """An attribute in another unit, None where it is."""
    read = attrgetter(attribute)

    def value(source: Any) -> float | None:
        raw = read(source)
        return None if raw is None else raw / divisor

    return value


def rebase_group(source: Callable[[Any], Any], group: Sequence[Quantity]) -> list[Quantity]:
    """Quantities of a group read from another source, None where that is."""

    def read(of: Callable[[Any], Any]) -> Callable[[Any], Any]:
        return lambda outer: None if (inner := source(outer)) is None else of(inner)

    return [quantity._replace(of=read(quantity.of)) for quantity in group]


def select_quantities(group: Sequence[Quantity], *keys: str) -> list[Quantity]:
    """Quantities of a group by their keys."""
    by_key = {quantity.key: quantity for quantity in group}
    return [by_key[key] for key in keys]


def serialize(group: Sequence[Quantity], source: Any) -> dict[str, Any]:
    """The keys of a group as the results have them."""
    values = {}
    for quantity in group:
        value = quantity.of(source)
        if value is None and quantity.left_out:
            continue
        if value is not None and quantity.group:
            if quantity.kind == "one":
                value = serialize(quantity.group, value)
            elif quantity.kind == "many":
                value = [serialize(quantity.group, item) for item in value]
            else:
                value = {name: serialize(quantity.group, item) for name, item in value.items()}
        elif value is not None and quantity.kind in ("texts", "numbers", "wholes"):
            value = list(value)
        elif value is not None and quantity.kind == "rows":
            value = list(map(list, value))
        values[quantity.key] = value
    return values


def schema(group: Sequence[Quantity]) -> dict[str, Any]:
    """JSON Schema of an object of these quantities."""
    return {
        "type": "object",
        "additionalProperties": False,
        "required": [quantity.key for quantity in group if not quantity.left_out],
        "properties": {quantity.key: _schema_of(quantity) for quantity in group},
    }


SCALARS = {"text": "string", "whole": "integer", "number": "number", "flag": "boolean", "free": "object"}


def _schema_of(quantity: Quantity) -> dict[str, Any]:
    words = quantity.meaning + (f" [{quantity.unit}]" if quantity.unit else "")
    if quantity.kind in SCALARS:
        return {"description": words, "type": [SCALARS[quantity.kind], "null"]}
    if quantity.kind == "one":
        return {"description": words, "anyOf": [schema(quantity.group), {"type": "null"}]}
    if quantity.kind == "named":
        return {"description": words, "type": ["object", "null"], "additionalProperties": schema(quantity.group)}
    if quantity.kind == "any":
        return {"description": words}
    if quantity.kind == "pairs":
        pair = {"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2}
        return {"description": words, "type": "array", "items": pair}
    if quantity.kind == "rows":
        row = {"type": "array", "items": {"type": "string"}}
        return {"description": words, "type": ["array", "null"], "items": row}
    item = schema(quantity.group) if quantity.kind == "many" else {"type": [SCALARS[quantity.kind[:-1]], "null"]}
    return {"description": words, "type": ["array", "null"], "items": item}


def walk_quantities(group: Sequence[Quantity], above: str = "") -> Iterator[tuple[str, Quantity]]:
    """(path, quantity) of all quantities of a group and of what it holds, in their order."""
    for quantity in group:
        path = above + quantity.key
        yield path, quantity
        yield from walk_quantities(
            quantity.group, path + {"one": ".", "many": "[].", "named": ".*."}.get(quantity.kind, "")
        )
