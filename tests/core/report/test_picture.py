"""Pictures for the head of a note: whole ones are set, cut or endless ones named before the run."""

import random
import struct
import zlib

import pytest

from core.report.note.picture import fault_of


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


def test_that_whole_pictures_are_set_and_cut_ones_named():
    chance = random.Random(3)
    whole = png(30, 20)
    assert fault_of(whole) == fault_of(SVG) == ""
    for content in (whole, SVG):
        for _ in range(60):
            assert fault_of(content[: chance.randrange(10, len(content) - 8)]) in ("cut", "kind")
    for _ in range(60):
        damaged = bytearray(whole)
        damaged[chance.randrange(16, len(whole))] ^= 1 << chance.randrange(8)
        assert fault_of(bytes(damaged)) == "cut"


@pytest.mark.parametrize(
    "content",
    [
        png(60_000, 60_000, b""),
        SVG.replace(b'width="40"', b'width="1e30"').replace(b'height="20"', b'height="1e-30"'),
        SVG.replace(b"0 0 40 20", b"0 0 1e30 1e-30"),
        SVG.replace(b'width="40"', b'width="100000"'),
        b"GIF89a" + struct.pack("<HH", 60_000, 60_000) + b"\0" * 20 + b";",
    ],
)
def test_that_a_picture_larger_than_memory_is_refused_by_its_head(content):
    assert fault_of(content) == "large"


def test_that_entities_and_other_documents_are_no_pictures():
    bomb = b'<?xml version="1.0"?><!DOCTYPE svg [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;">]><svg>&b;</svg>'
    assert fault_of(bomb) == "cut" and fault_of(b'<?xml version="1.0"?><html/>') == "kind"
    assert fault_of(b"\xff\xd8\xff\xe0\0\x10JFIF") == "cut"
    frame = b"\xff\xd8\xff\xc0\0\x11\x08" + struct.pack(">HH", 50, 60) + b"\3" + b"\0" * 30 + b"\xff\xd9"
    assert fault_of(frame) == ""
