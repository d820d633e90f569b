"""Coordinates as maps give them: decimal degrees, degrees and minutes, degrees, minutes and seconds."""

import re

from core.errors import InputError

_NUMBER = r"""
    (?P<sign>[-−+])?\s*
    (?P<degrees>\d+(?:[.,]\d+)?)\s*[°º]?\s*
    (?:(?P<minutes>\d+(?:[.,]\d+)?)\s*['′’](?!')\s*)?
    (?:(?P<seconds>\d+(?:[.,]\d+)?)\s*(?:["″”]|''|′′)\s*)?
"""
_LETTER = r"(?P<letter>[NSEWO])?\s*"
_LETTER_FIRST = re.compile(_LETTER + _NUMBER, re.VERBOSE | re.IGNORECASE)
_LETTER_LAST = re.compile(_NUMBER + _LETTER, re.VERBOSE | re.IGNORECASE)
"""One coordinate with its letter before it or after it; O is the Italian west."""

_WITHOUT_SIGNS = re.compile(
    r"(?<![\d.,])(\d+)\s+(\d+(?:[.,]\d+)?)(?:\s+(\d+(?:[.,]\d+)?))?(?=\s*[NSEWO]\b)", re.IGNORECASE
)
"""Degrees, minutes and seconds before a letter, with no sign between them."""


def parse_coordinates(text: str) -> tuple[float, float]:
    """(latitude, longitude) [degrees] of a text such as 42.3498 N 13.3995 E; 42°20'59" 13°23'58"; 42,3498; 13,3995.
    Latitude first, unless letters say otherwise. Raises InputError."""
    # a comma between two numbers with points, or followed by a space, is none of a number
    plain = re.sub(r"(?<=\d\.)(\d+),", r"\1 ", text.strip().replace(";", " "))
    plain = re.sub(r",\s", " ", plain)
    if plain.startswith("(") and plain.endswith(")"):
        plain = plain[1:-1].strip()
    plain = _WITHOUT_SIGNS.sub(lambda part: f"{part[1]}°{part[2]}'" + (f'{part[3]}"' if part[3] else ""), plain)
    pattern = _LETTER_FIRST if plain[:1].isalpha() else _LETTER_LAST
    parts, rest = list(pattern.finditer(plain)), pattern.sub(" ", plain).strip()
    if len(parts) != 2 or rest:
        raise InputError("coordinates_unread", text=text.strip()[:60])
    values, axes = [], []
    for part in parts:
        degrees, minutes, seconds = (
            float((part[key] or "0").replace(",", ".")) for key in ("degrees", "minutes", "seconds")
        )
        letter = (part["letter"] or "").upper()
        if minutes >= 60.0 or seconds >= 60.0:
            raise InputError("coordinates_unread", text=text.strip()[:60])
        value = degrees + minutes / 60.0 + seconds / 3600.0
        values.append(-value if (part["sign"] in ("-", "−")) != (letter in ("S", "W", "O")) else value)
        axes.append("latitude" if letter in ("N", "S") else "longitude" if letter else "")
    if axes[0] == "longitude" or axes[1] == "latitude":
        values, axes = values[::-1], axes[::-1]
    if (
        axes[0] == "longitude"
        or axes[1] == "latitude"
        or not (-90.0 <= values[0] <= 90.0 and -180.0 <= values[1] <= 180.0)
    ):
        raise InputError("coordinates_unread", text=text.strip()[:60])
    return values[0], values[1]
