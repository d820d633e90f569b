"""Numbers as people type them: decimal comma or point, in every locale."""

import math
import re

from core.errors import InputError

_NUMBER = re.compile(r"[+-]?([0-9]+([.,][0-9]*)?|[.,][0-9]+)([eE][+-]?[0-9]{1,3})?", re.ASCII)


SHOWN = 60
"""Characters of a text repeated in a sentence."""


def parse_number(text: str) -> float:
    """`0.312` and `0,312` both mean 0.312. Raises InputError for both marks at once, for a mark used twice,
    and for anything that is not a finite number."""
    bare = text.strip().replace("−", "-")
    text = bare if len(bare) <= SHOWN else bare[:SHOWN] + "…"
    if "." in bare and "," in bare:
        raise InputError("two_decimal_marks", text=text)
    if not _NUMBER.fullmatch(bare):
        raise InputError("not_a_number", text=text)
    value = float(bare.replace(",", "."))
    if not math.isfinite(value):
        raise InputError("number_too_large", text=text)
    return value
