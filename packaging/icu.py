"""Of the data of ICU, 32 MB, what Qt reads in the frozen program of Linux: the order of words, by which its file dialog
lists names. Qt asks ICU for code pages and names of time zones besides; this program reads files by Python and shows no
time zone. Qt on Windows and macOS comes without ICU.

ICU finds an item by its name in a table of contents at the beginning of its data: those left out are "not there", for
which ICU and Qt have their codes.
"""

import fnmatch
import re
import struct
import subprocess
import tempfile
from pathlib import Path

KEPT = "coll/*", "root.res", "res_index.res", "pool.res", "cnvalias.icu"
"""Patterns of names of items: collation of all languages, and what ICU opens before any."""

START = b"\xda\x27"
"""After two bytes of its size, the beginning of the header of ICU's data."""

PACKAGE = b"CmnD"
"""Name of the format: many items in one."""

LIBRARY = """ .section .note.GNU-stack,"",%progbits
 .section .rodata
 .balign 16
 .globl {symbol}
 .type {symbol}, %object
 .size {symbol}, {size}
{symbol}:
 .incbin "{file}"
"""


def read(content: bytes) -> tuple[bytes, dict[str, bytes]]:
    """The header and the items of ICU's data, by their names; of little-endian data. Raises ValueError."""
    size, magic, kind = struct.unpack_from("<H2s8x4s", content)
    if magic != START or kind != PACKAGE:
        raise ValueError("no data of ICU")
    header, body = content[:size], content[size:]
    (count,) = struct.unpack_from("<I", body)
    places = [struct.unpack_from("<II", body, 4 + 8 * k) for k in range(count)]
    ends = [*(begin for _, begin in places[1:]), len(body)]
    return header, {
        body[name : body.index(b"\0", name)].decode("ascii"): body[begin:end]
        for (name, begin), end in zip(places, ends, strict=True)
    }


def written(header: bytes, items: dict[str, bytes]) -> bytes:
    """ICU's data of these items, each at a multiple of 16 bytes."""
    names = sorted(items)  # ICU halves the table to find one
    place = 4 + 8 * len(names)
    spelled = [name.encode("ascii") + b"\0" for name in names]
    begin = place + sum(map(len, spelled))
    table, data = [struct.pack("<I", len(names))], list[bytes]()
    for name, word in zip(names, spelled, strict=True):
        data.append(bytes(-begin % 16))
        begin += len(data[-1])
        table.append(struct.pack("<II", place, begin))
        data.append(items[name])
        place, begin = place + len(word), begin + len(items[name])
    return b"".join([header, *table, *spelled, *data])


def kept(items: dict[str, bytes]) -> dict[str, bytes]:
    """Those that the program reads."""
    return {
        name: item
        for name, item in items.items()
        if any(fnmatch.fnmatchcase(name.partition("/")[2], pattern) for pattern in KEPT)
    }


def symbol_of(file: Path) -> tuple[str, int, int]:
    """The one symbol of a library of ICU's data, its place in the file and its size. Raises ValueError."""
    listed = subprocess.run(["objdump", "-T", file], capture_output=True, text=True, check=True).stdout
    found = re.findall(r"^([0-9a-f]+) g +DO \.rodata\s+([0-9a-f]+) .*\b(icudt\d+_dat)$", listed, re.MULTILINE)
    sections = subprocess.run(["objdump", "-h", file], capture_output=True, text=True, check=True).stdout
    rodata = re.search(r"\.rodata +[0-9a-f]+ +([0-9a-f]+) +[0-9a-f]+ +([0-9a-f]+)", sections)
    if len(found) != 1 or rodata is None:
        raise ValueError(f"{file.name} has not the one symbol of ICU's data")
    address, size, name = found[0]
    return name, int(address, 16) - int(rodata[1], 16) + int(rodata[2], 16), int(size, 16)


def shorten(file: Path) -> None:
    """Write a library of ICU's data anew, with the items the program reads, by the assembler and the linker of
    binutils."""
    symbol, begin, size = symbol_of(file)
    header, items = read(file.read_bytes()[begin : begin + size])
    content = written(header, kept(items))
    with tempfile.TemporaryDirectory() as name:
        place = Path(name)
        (place / "data").write_bytes(content)
        text = LIBRARY.format(symbol=symbol, size=len(content), file="data")
        (place / "data.s").write_text(text, encoding="ascii")
        subprocess.run(["as", "-o", "data.o", "data.s"], check=True, cwd=place)
        link = ["ld", "-shared", "--hash-style=gnu", "-soname", file.name, "-o", "library", "data.o"]
        subprocess.run(link, check=True, cwd=place)
        file.write_bytes((place / "library").read_bytes())


def shorten_in(folder: Path) -> None:
    """Shorten the data of ICU below a folder of the frozen program; a link to them stays one."""
    for file in folder.rglob("libicudata.so*"):
        if not file.is_symlink():
            shorten(file)
