"""Pictures for the head of a note: what can be set is, whatever else comes is named before the run and takes nothing
along."""

import base64
import random
import struct
import zlib

import pytest

pytest.importorskip("typst")

from core.report.note.pdf import STANDARDS
from core.report.note.picture import TOO_MUCH, fault_of


def png(width: int, height: int, rows: bytes | None = None) -> bytes:
    def part(name: bytes, content: bytes) -> bytes:
        return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))

    head = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    rows = b"".join(b"\0" + b"\x80" * width for _ in range(height)) if rows is None else rows
    return b"\x89PNG\r\n\x1a\n" + part(b"IHDR", head) + part(b"IDAT", zlib.compress(rows)) + part(b"IEND", b"")


SVG = (
    b'<svg xmlns="http://www.w3.org/2000/svg" width="40" height="20" viewBox="0 0 40 20">'
    b'<rect width="9" height="9"/></svg>'
)


def fault(content: bytes, standard: str = "a-3a") -> str:
    return fault_of(content, tuple(STANDARDS[standard]))


NAMESPACE = b'<!DOCTYPE svg [ <!ENTITY ns "http://www.w3.org/2000/svg"> ]>'
GOOD = {
    "a png": png(30, 20),
    "a drawing": SVG,
    "a drawing of another program": NAMESPACE + SVG.replace(b"http://www.w3.org/2000/svg", b"&ns;"),
    "a mark of its letters first": b"\xef\xbb\xbf" + SVG,
    "a remark first": b"<!-- made by hand -->" + SVG,
}


@pytest.mark.parametrize("kind", GOOD)
def test_that_pictures_as_programs_write_them_are_set(kind):
    assert fault(GOOD[kind]) == ""


def of_head(width: int, height: int) -> bytes:
    """A drawing that holds a picture of this size, of which there is the head alone."""
    data = base64.b64encode(png(width, height, b"")).decode()
    return SVG.replace(b"<rect", f'<image href="data:image/png;base64,{data}" width="9" height="9"/><rect'.encode())


@pytest.mark.shows("doors.bombs")
def test_that_whatever_cannot_be_set_is_named_and_ends_no_program():
    chance = random.Random(3)
    whole = png(30, 20)
    assert all(fault(whole[: chance.randrange(1, len(whole) - 12)]) for _ in range(3))
    for content in (png(60_000, 60_000, b""), of_head(60_000, 60_000), b"", b"\xff\xd8\xff\xe0\0\x10JFIF", b"<html/>"):
        assert fault(content), content[:40]
    assert fault(of_head(60_000, 60_000)) == TOO_MUCH
