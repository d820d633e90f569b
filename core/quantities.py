"""Units as people write them, in Italian and English, for every heading, head and cell."""

import re
from typing import NamedTuple

from core.units import G


class Unit(NamedTuple):
    """A unit.

    factor : what a number in it is multiplied with to be in N, m, s, rad and 1
    force, length, time, angle : exponents of its dimension
    """

    factor: float
    force: int = 0
    length: int = 0
    time: int = 0
    angle: int = 0


_KG = G
_POUND, _FOOT, _INCH = 0.45359237 * G, 0.3048, 0.0254
_METRES = ("metri", "metro", "metre", "metres", "meter", "meters")
BASES = {
    **dict.fromkeys(("n", "newton"), Unit(1.0, force=1)),
    **dict.fromkeys(("dan",), Unit(10.0, force=1)),
    **dict.fromkeys(("kn", "kilonewton"), Unit(1e3, force=1)),
    **dict.fromkeys(("kg", "kgf", "kgp", "chilogrammi", "chili"), Unit(_KG, force=1)),
    **dict.fromkeys(("q", "ql", "quintali"), Unit(100.0 * _KG, force=1)),
    **dict.fromkeys(("t", "tf", "ton", "tonn", "tonnellate", "tonnes"), Unit(1e3 * _KG, force=1)),
    **dict.fromkeys(("gr", "grammi"), Unit(1e-3 * _KG, force=1)),
    **dict.fromkeys(("lb", "lbs", "lbf"), Unit(_POUND, force=1)),
    **dict.fromkeys(("kip", "kips"), Unit(1e3 * _POUND, force=1)),
    **dict.fromkeys(("m", "mt", "ml", *_METRES), Unit(1.0, length=1)),
    **dict.fromkeys(("dm", "decimetri"), Unit(0.1, length=1)),
    **dict.fromkeys(
        ("cm", "centimetri", "centimetro", "centimetre", "centimetres", "centimeter", "centimeters"),
        Unit(0.01, length=1),
    ),
    **dict.fromkeys(
        ("mm", "millimetri", "millimetro", "millimetre", "millimetres", "millimeter", "millimeters"),
        Unit(1e-3, length=1),
    ),
    **dict.fromkeys(("km", "chilometri"), Unit(1e3, length=1)),
    **dict.fromkeys(("ft", "foot", "feet", "piedi", "piede"), Unit(_FOOT, length=1)),
    **dict.fromkeys(("in", "inch", "inches", "pollici", "pollice"), Unit(_INCH, length=1)),
    **dict.fromkeys(("yd", "yard", "yards", "iarde"), Unit(3.0 * _FOOT, length=1)),
    "um": Unit(1e-6, length=1),
    "nm": Unit(1e-9, length=1),
    "mq": Unit(1.0, length=2),
    "cmq": Unit(1e-4, length=2),
    "mmq": Unit(1e-6, length=2),
    "mc": Unit(1.0, length=3),
    "cmc": Unit(1e-6, length=3),
    **dict.fromkeys(("s", "sec", "secs", "secondo", "secondi", "second", "seconds"), Unit(1.0, time=1)),
    **dict.fromkeys(("ms", "msec", "millisecondo", "millisecondi", "millisecond", "milliseconds"), Unit(1e-3, time=1)),
    **dict.fromkeys(("us", "usec", "microsecondi", "microseconds"), Unit(1e-6, time=1)),
    **dict.fromkeys(("min", "minuti", "minutes"), Unit(60.0, time=1)),
    **dict.fromkeys(("anno", "anni", "year", "years"), Unit(365.25 * 86400.0, time=1)),
    **dict.fromkeys(("hz", "hertz"), Unit(1.0, time=-1)),
    "khz": Unit(1e3, time=-1),
    **dict.fromkeys(("pa", "pascal"), Unit(1.0, force=1, length=-2)),
    "kpa": Unit(1e3, force=1, length=-2),
    "mpa": Unit(1e6, force=1, length=-2),
    "gpa": Unit(1e9, force=1, length=-2),
    "bar": Unit(1e5, force=1, length=-2),
    **dict.fromkeys(("atm",), Unit(101325.0, force=1, length=-2)),
    "psi": Unit(_POUND / _INCH**2, force=1, length=-2),
    "ksi": Unit(1e3 * _POUND / _INCH**2, force=1, length=-2),
    "psf": Unit(_POUND / _FOOT**2, force=1, length=-2),
    "pcf": Unit(_POUND / _FOOT**3, force=1, length=-3),
    "plf": Unit(_POUND / _FOOT, force=1, length=-1),
    **dict.fromkeys(("rad", "radianti", "radians"), Unit(1.0, angle=1)),
    **dict.fromkeys(("mrad",), Unit(1e-3, angle=1)),
    **dict.fromkeys(("deg", "°", "gradi", "degrees", "degree"), Unit(0.017453292519943295, angle=1)),
    **dict.fromkeys(("gon", "gradicentesimali"), Unit(0.015707963267948967, angle=1)),
    **dict.fromkeys(("g", "g's", "gs", "gn"), Unit(G, length=1, time=-2)),
    **dict.fromkeys(("mg", "millig"), Unit(1e-3 * G, length=1, time=-2)),
    **dict.fromkeys(("ug", "microg"), Unit(1e-6 * G, length=1, time=-2)),
    **dict.fromkeys(("%g", "%ofg"), Unit(0.01 * G, length=1, time=-2)),
    **dict.fromkeys(("gal", "gals"), Unit(0.01, length=1, time=-2)),
    **dict.fromkeys(("mgal", "mgals", "milligal", "milligals"), Unit(1e-5, length=1, time=-2)),
    "%": Unit(0.01),
    "‰": Unit(1e-3),
    **dict.fromkeys(("-", "–", "adim"), Unit(1.0)),
}
"""Word -> unit, in small letters. A kilogram is one of force, as loads and unit weights are given in them; g alone is
that of an acceleration. MN, and what small letters would confuse with something else, is in no list."""

UNITS_WRITTEN = {
    "": "-, %",
    "kN/m3": "kN/m3, kg/m3, t/m3",
    "MPa": "MPa, N/mm2, GPa, kg/cm2",
    "kN/m": "kN/m, N/m, daN/m, kg/m, t/m",
    "deg": "deg, rad",
    "m2": "m2, cm2",
    "m": "m, cm, mm, ft",
    "mm": "mm, cm",
}
"""Unit of a key -> units its numbers may have, as a refusal names them; others of its dimension are converted too."""


def words_of(length: int = 0, time: int = 0) -> dict[str, float]:
    """Word -> factor, of the units of a dimension without force."""
    return {word: one.factor for word, one in BASES.items() if one[1:] == (0, length, time, 0)}


_EXPONENTS = str.maketrans("²³⁻¹·×", "23-1**")
_TOKEN = re.compile(r"([a-z°%‰–-]+)\^?(-?[0-9])?")
_LEADING = re.compile(r"^(in|unit|units|unità|u\.m\.|um)\s*:?\s+(?=\S)")


def unit_of(text: str) -> Unit | None:
    """The unit a text names, None where it names none: `kN/m³`, `kg/cmq`, `in cm`, `t per metro`."""
    word = _LEADING.sub("", text.strip().lower().strip("[](){} ")).translate(_EXPONENTS)
    word = re.sub(r"\s+(per|al|alla|a)\s+", "/", word)
    word = re.sub(r"(quadrati|quadrato|quadri|quadro|squared)\b", "2", word)
    word = re.sub(r"(cubi|cubo|cubici|cubed)\b", "3", word).replace("**", "^")
    word = re.sub(r"[\s.]", "", word)
    if not word or len(word) > 40:
        return None
    factor, exponents, sign = 1.0, [0, 0, 0, 0], 1
    for n, part in enumerate(word.split("/")):
        sign = 1 if n == 0 else -1
        for token in part.split("*"):
            base = BASES.get(token)  # whole first: cm2 is no word, mmq and ° are
            power = 1
            if base is None:
                match = _TOKEN.fullmatch(token)
                base = BASES.get(match[1]) if match else None
                if match is None or base is None or match[2] is None:
                    return None
                power = int(match[2])
            power *= sign
            factor *= base.factor**power
            exponents = [have + power * one for have, one in zip(exponents, base[1:], strict=True)]
    return Unit(factor, *exponents)


def factor_to(text: str, unit: str) -> float | None:
    """Factor from a number in the unit of a text to another unit; None where the text names no unit of its dimension.
    unit : as a key of the case has it, empty for a number without one"""
    given, wanted = unit_of(text), unit_of(unit or "-")
    if given is None or wanted is None or given[1:] != wanted[1:]:
        return None
    return given.factor / wanted.factor


_UNBRACKETED_UNIT = re.compile(r"(?<![\w/])(%g|ms|mg|hz|gal|g ?/ ?[0-9]+|c?m ?s-2|[a-z]+/[a-z]+[\^]?[0-9²³]?)(?![\w/])")
_REMARK = re.compile(r"[^\W\d_]+([ '-][^\W\d_]+)*|[0-9.,]+ ?%")


def foreign_unit(head: str, known: tuple[str, ...]) -> str | None:
    """The first unit a head names that is none of those its numbers are taken in, None where there is none: what stands
    in brackets and is no word, and what is written as a unit without them. known : the units as they are written"""
    for text in re.findall(r"[\[(]\s*([^\[\]()]*)", head):
        word = text.strip().lower()
        if word not in known and (unit_of(word) is not None or not _REMARK.fullmatch(word)) and word:
            return text.strip()
    bare = next(
        (one for one in _UNBRACKETED_UNIT.findall(re.sub(r"[\[(].*?[\])]", " ", head.lower())) if one not in known),
        None,
    )
    return bare
