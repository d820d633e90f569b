"""Numbers as people type them: decimal comma or point, in every locale, with or without their unit; in a form sums and
products too."""

import math
import re

from core.errors import InputError
from core.quantities import UNITS_WRITTEN, factor_to

_NUMBER = re.compile(r"[+-]?([0-9]+([.,][0-9]*)?|[.,][0-9]+)([eE][+-]?[0-9]{1,3})?", re.ASCII)


MAX_TEXT_SHOWN = 60
"""Characters of a text repeated in a sentence."""


def parse_number(text: str) -> float:
    """`0.312` and `0,312` both mean 0.312. Raises InputError for both marks at once, for a mark used twice,
    and for anything that is not a finite number."""
    bare = text.strip().replace("−", "-")
    text = bare if len(bare) <= MAX_TEXT_SHOWN else bare[:MAX_TEXT_SHOWN] + "…"
    if "." in bare and "," in bare:
        raise InputError("two_decimal_marks", text=text)
    if not _NUMBER.fullmatch(bare):
        raise InputError("not_a_number", text=text)
    value = float(bare.replace(",", "."))
    if not math.isfinite(value):
        raise InputError("number_too_large", text=text)
    return value


_WITH_UNIT = re.compile(r"([+−-]?[0-9.,]+(?:[eE][+-]?[0-9]{1,3})?)\s*([^\s0-9.,+−-].*)", re.ASCII)


def parse_quantity(text: str, unit: str, bare: float = 1.0) -> float:
    """A number in the unit of its key: `50 cm` of a length is 0.5. Raises InputError as `parse_number`, and for a word
    behind it that names no unit of the key's dimension.

    unit : of the key, empty for a number without one; bare : what a number without a unit is multiplied with
    """
    match = None if _NUMBER.fullmatch(text.strip()) else _WITH_UNIT.fullmatch(text.strip())  # 6E-1 has no unit E-1
    if match is None:
        return parse_number(text) * bare
    value, factor = parse_number(match[1]), factor_to(match[2], unit)
    if factor is None:
        raise InputError("unit_of_number", text=text.strip()[:MAX_TEXT_SHOWN], known=UNITS_WRITTEN.get(unit, unit))
    return value * factor


_TOKEN = re.compile(r"\s*([0-9.,]+(?:[eE][+-]?[0-9]{1,3}(?![0-9A-Za-z]))?|[-+*/()])", re.ASCII)
_MARKS = str.maketrans({"−": "-", "×": "*", "·": "*", "÷": "/"})
MAX_TOKENS = 40


def parse_formula(text: str, unit: str, bare: float = 1.0) -> float:
    """A sum or product of numbers as one types it into a form, with brackets, a unit at its end: `(30+40)/2 cm`. Raises
    InputError as `parse_quantity`. unit, bare : as there"""
    rest, tokens = text.strip().translate(_MARKS), []
    while (match := _TOKEN.match(rest)) and len(tokens) <= MAX_TOKENS:
        tokens.append(match[1])
        rest = rest[match.end() :]
    wrong = InputError("not_a_number", text=text.strip()[:MAX_TEXT_SHOWN])
    if not 1 < len(tokens) <= MAX_TOKENS:
        raise wrong
    factor = factor_to(rest, unit) if rest.strip() else bare
    if factor is None:
        raise InputError("unit_of_number", text=text.strip()[:MAX_TEXT_SHOWN], known=UNITS_WRITTEN.get(unit, unit))
    tokens.reverse()
    try:
        value = _sum_of(tokens)
    except (IndexError, ZeroDivisionError):
        raise wrong from None
    if tokens or not math.isfinite(value):
        raise wrong
    return value * factor


def _sum_of(tokens: list[str]) -> float:
    """Take a sum off the end of the tokens, which are reversed."""
    value = _product_of(tokens)
    while tokens and tokens[-1] in "+-":
        sign = 1.0 if tokens.pop() == "+" else -1.0
        value += sign * _product_of(tokens)
    return value


def _product_of(tokens: list[str]) -> float:
    value = _factor_of(tokens)
    while tokens and tokens[-1] in "*/":
        divides, other = tokens.pop() == "/", _factor_of(tokens)
        value = value / other if divides else value * other
    return value


def _factor_of(tokens: list[str]) -> float:
    token = tokens.pop()
    if token == "-":
        return -_factor_of(tokens)
    if token != "(":
        return parse_number(token)
    value = _sum_of(tokens)
    if tokens.pop() != ")":
        raise IndexError(token)
    return value
