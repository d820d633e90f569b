"""Whether a picture can be set: its head and its end are looked at before a run, so that what sets the page is never
given one that is cut, or larger than memory."""

import struct
import xml.parsers.expat
import zlib

MOST_PIXELS, MOST_SIDE = 40_000_000, 20_000
"""Of a picture; a sheet of letter paper at 600 dpi has 34 million."""

SIDES = 1e-2, 1e6
"""Of a drawing (SVG), in its units."""

MOST_RATIO = 200.0
"""Its longer side over its shorter one."""


def fault_of(content: bytes) -> str:
    """What is wrong with a picture: "cut", "large" or "kind"; "" where it can be set. content : PNG, JPEG, GIF, SVG"""
    if content.startswith(b"\x89PNG\r\n\x1a\n"):
        return _of_png(content)
    if content.startswith(b"\xff\xd8\xff"):
        return _of_jpeg(content)
    if content.startswith(b"GIF8"):
        return _size(*struct.unpack("<HH", content[6:10])) if len(content) > 13 and b";" in content[-4:] else "cut"
    if content.lstrip().startswith((b"<svg", b"<?xml")):
        return _of_svg(content)
    return "kind"


def _size(width: int, height: int) -> str:
    whole = 0 < width <= MOST_SIDE and 0 < height <= MOST_SIDE and width * height <= MOST_PIXELS
    return "" if whole else "large"


def _of_png(content: bytes) -> str:
    """Its parts carry sums of themselves; the first gives the size, the last is empty."""
    at, first = 8, ""
    while at + 12 <= len(content):
        (length,) = struct.unpack(">I", content[at : at + 4])
        name, end = content[at + 4 : at + 8], at + 8 + length
        if content[end : end + 4] != struct.pack(">I", zlib.crc32(content[at + 4 : end])):
            return "cut"
        if name == b"IHDR" and length == 13 and at == 8:
            first = _size(*struct.unpack(">II", content[at + 8 : at + 16])) or "whole"
        if name == b"IEND":
            return {"whole": "", "": "cut"}.get(first, first)
        at = end + 4
    return "cut"


def _of_jpeg(content: bytes) -> str:
    """The size stands in the first frame."""
    at = 2
    while at + 9 < len(content) and content[at] == 0xFF:
        kind = content[at + 1]
        if kind == 0xFF:
            at += 1
            continue
        (length,) = struct.unpack(">H", content[at + 2 : at + 4])
        if 0xC0 <= kind <= 0xCF and kind not in (0xC4, 0xC8, 0xCC):
            height, width = struct.unpack(">HH", content[at + 5 : at + 9])
            return _size(width, height) if b"\xff\xd9" in content[-64:] else "cut"
        at += 2 + length
    return "cut"


def _of_svg(content: bytes) -> str:
    """Its root, and whether its elements are closed."""
    roots: list[tuple[str, dict[str, str]]] = []
    parser = xml.parsers.expat.ParserCreate()
    parser.StartElementHandler = lambda name, attributes: roots.append((name, attributes)) if not roots else None

    def refuse(*_):
        raise ValueError

    parser.EntityDeclHandler = refuse  # one may stand for a thousand of another
    try:
        parser.Parse(content, True)
    except (xml.parsers.expat.ExpatError, ValueError):
        return "cut"
    name, attributes = roots[0]
    if name.rpartition(":")[2] != "svg":
        return "kind"
    box = [_number(part) for part in attributes.get("viewBox", "").replace(",", " ").split()]
    sides = [_number(attributes[key]) for key in ("width", "height") if "%" not in attributes.get(key, "%")]
    for pair in (sides, box[2:]):
        known = [side for side in pair if side is not None]
        if any(not SIDES[0] <= side <= SIDES[1] for side in known):
            return "large"
        if len(known) == 2 and max(known) > MOST_RATIO * min(known):
            return "large"
    return ""


def _number(text: str) -> float | None:
    """The number a length begins with, None of none."""
    digits = text.strip().rstrip("abcdefghijklmnopqrstuvwxyz%")
    try:
        return float(digits)
    except ValueError:
        return None
