"""Files that hold other files: the zips of ESM and ITACA as downloaded, the tars of K-NET, workbooks of Excel."""

import gzip
import io
import re
import tarfile
import zipfile
import zlib

from core.errors import InputError, RecordError
from core.ground.records.channels import is_vertical, refuse_unchosen
from core.ground.records.grammar import EMPTY_CELL
from core.ooxml.package import MEMBER
from core.ooxml.sheet import Limits, hidden_notes, read_sheet, refuse_cells, spoken
from core.text.sentence import Sentence, notice

MAX_UNPACKED = 20_000_000
"""Bytes of one member, or of a workbook, unpacked."""

MAX_MEMBERS = 500
SHEET_LIMITS = Limits(rows=50_000, columns=100, cells=150_000, size=2 * MAX_UNPACKED)

MEMBER_SEPARATOR = ": "
"""Mark between the name of a member and that of a channel in it."""

_ACCELERATION = re.compile(r"\.ACC\.", re.IGNORECASE)
_OTHER_FILE = re.compile(
    r"\.(vt2|dt2|v3|pdf|png|jpe?g|gif|xml|html?|json|md|rs|metadata)\Z"
    r"|\.(VEL|DIS|SA|SD|SV|PSA|PSV)\.[^/]*\Z|(?:\A|/)(?:readme|licen[cs]e)[^/.]*(?:\.(txt|pdf|md))?\Z",
    re.IGNORECASE,
)
"""Members that are no accelerogram: velocities, displacements and spectra of ESM by their names, documents."""

_UP = re.compile(r"[-_.](UP|DWN|VER|UD|V)\.\w+\Z", re.IGNORECASE)
_CONTROL = re.compile(r"[\x00-\x1f\x7f-\x9f\u2028\u2029]")
_STREAM = re.compile(r"[A-Z0-9]{1,2}\.[A-Z0-9]{1,6}\.(?:[A-Z0-9]{0,2}\.)?[A-Z]{2}([A-Z0-9])\.", re.IGNORECASE)
"""Names of ESM and ITACA: network, station, location if any, channel, whose third letter is the direction."""

_KNET = re.compile(r"UD[12]?", re.IGNORECASE)
"""Endings of K-NET and KiK-net."""


BAD_ZIP = (
    zipfile.BadZipFile,
    zlib.error,
    EOFError,
    NotImplementedError,
    RuntimeError,
    OSError,
    ValueError,
    KeyError,
    IndexError,
    AttributeError,
    TypeError,
    SyntaxError,
)
"""Errors that a hostile archive or workbook raises."""


def is_zip(content: bytes) -> bool:
    return content[:4] == b"PK\x03\x04"


TAR_MARK, TAR_PLACE, GZIP = b"ustar", 257, b"\x1f\x8b"
"""How an archive of tar says what it is, and where; how one packed by gzip begins."""

MAX_TAR = 5 * MAX_UNPACKED
"""Bytes of an archive of tar, unpacked by gzip."""


def tar_as_zip(content: bytes) -> bytes | None:
    """The files of an archive of tar, packed by gzip or not (.tar, .tar.gz, as K-NET sends them), as a zip that packs
    nothing; None of another file. Raises RecordError for one that cannot be read."""
    if content[:2] == GZIP:
        content = _gunzipped(content)
    if content[TAR_PLACE : TAR_PLACE + len(TAR_MARK)] != TAR_MARK:
        return None
    try:
        made = io.BytesIO()
        with tarfile.open(fileobj=io.BytesIO(content)) as tar, zipfile.ZipFile(made, "w") as folder:
            for n, member in enumerate(tar):
                if n > 10 * MAX_MEMBERS:
                    raise RecordError("too_many_channels", n=n, most=MAX_MEMBERS)
                stream = tar.extractfile(member) if member.isfile() else None
                if stream is not None:
                    folder.writestr(member.name, stream.read(MAX_UNPACKED + 1))
    except (*BAD_ZIP, tarfile.TarError) as error:
        if isinstance(error, RecordError):
            raise
        raise RecordError("bad_archive", reason=type(error).__name__) from None
    return made.getvalue()


def _gunzipped(content: bytes) -> bytes:
    """What gzip packed, if that is an archive of tar: empty of another file. Raises RecordError."""
    try:
        with gzip.GzipFile(fileobj=io.BytesIO(content)) as stream:
            begins = stream.read(TAR_PLACE + len(TAR_MARK))
            if begins[TAR_PLACE:] != TAR_MARK:
                return b""
            body = begins + stream.read(MAX_TAR)
    except BAD_ZIP:
        return b""
    if len(body) > MAX_TAR:
        raise RecordError("unpacked_too_large", mb=len(body) / 1e6)
    return body


def member_of(content: bytes, asked: str | None) -> tuple[str, bytes, str | None, bool]:
    """(name, bytes, the channel asked for within it, whether there are others) of one accelerogram of a zip.

    asked : its name, or its number from 1, and after ": " a channel of it. Raises RecordError naming the members.
    """
    listed = content.count(MEMBER)
    if listed > 10 * MAX_MEMBERS:  # those of archives within it, and folders, count as well
        raise RecordError("too_many_channels", n=listed, most=MAX_MEMBERS)
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as folder:
            entries = [entry for entry in folder.infolist() if not entry.is_dir()]
            if len(entries) > MAX_MEMBERS:
                raise RecordError("too_many_channels", n=len(entries), most=MAX_MEMBERS)
            entries = [
                entry
                for entry in entries
                if not _OTHER_FILE.search(entry.filename) and not entry.filename.startswith("__MACOSX")
            ]
            entries = sorted(entries, key=_order)
            if not entries:
                raise RecordError("no_member")
            names = [_printable(entry.filename) for entry in entries]
            member, within = _split(asked, names)
            k = refuse_unchosen(names, [names_vertical(name) for name in names], member)
            entry = entries[k]
            if entry.file_size > MAX_UNPACKED:
                raise RecordError("unpacked_too_large", mb=entry.file_size / 1e6)
            if entry.compress_type == zipfile.ZIP_LZMA:  # raises errors of its own
                raise RecordError("bad_archive", reason="LZMA")
            with folder.open(entry) as stream:
                body = stream.read(MAX_UNPACKED + 1)
    except BAD_ZIP as error:
        if isinstance(error, RecordError):
            raise
        raise RecordError("bad_archive", reason=type(error).__name__) from None
    if len(body) > MAX_UNPACKED:  # the size it states can lie
        raise RecordError("unpacked_too_large", mb=len(body) / 1e6)
    if is_zip(body):
        raise RecordError("nested_archive")
    return names[k], body, within, len(entries) > 1


def _split(asked: str | None, names: list[str]) -> tuple[str | None, str | None]:
    """(member, channel within it) of what is asked for; of the only member it is the channel."""
    if asked is None or asked in names:
        return asked, None
    for name in names:
        if asked.startswith(name + MEMBER_SEPARATOR):
            return name, asked.removeprefix(name + MEMBER_SEPARATOR)
    return (names[0], asked) if len(names) == 1 else (asked, None)


def _order(entry: zipfile.ZipInfo) -> tuple:
    """Accelerations by name first, horizontal before vertical, processed (MP) before converted only (CV)."""
    name = entry.filename
    return not _ACCELERATION.search(name), names_vertical(name), ".CV." in name.upper(), name


def names_vertical(name: str) -> bool:
    """Whether the name of a file says that it holds a vertical component."""
    base = name.rpartition("/")[2]
    if stream := _STREAM.match(base):
        return stream[1].upper() == "Z"
    ending = base.rpartition(".")[2]
    return bool(_UP.search(base) or _KNET.fullmatch(ending)) or is_vertical(ending)


def sheet_of(content: bytes, asked: str | None) -> tuple[str, list[str], bool, list[Sentence]]:
    """(name, lines of cells with tabs between them, whether there are others, what is to be said of it) of one sheet of
    a workbook that is shown. Raises RecordError."""

    def choose(names: list[str]) -> int:
        return refuse_unchosen([_printable(name) for name in names], [False] * len(names), asked)

    try:
        sheet = read_sheet(content, SHEET_LIMITS, choose)
        numbers = {
            (row, column) for row, cells in sheet.rows.items() for column, cell in cells.items() if cell.is_number
        }
        # a title over several columns is none of the samples
        merged = [area for area in sheet.merged if area[0] < area[2] and area[:2] in numbers]
        refused_cells = {"uncomputed_cells": sheet.uncomputed, "error_cells": sheet.errors}
        refuse_cells({"merged_cells": merged, **refused_cells})
    except RecordError:
        raise
    except InputError as error:
        raise RecordError(error.code, **error.values) from None
    notes = hidden_notes(sheet, are_read=True)
    if sheet.formulas:
        cells = spoken(sheet.formulas)
        notes.append(notice("formulas_read", cells=cells))
    if sheet.hidden_sheets:
        names = [_printable(name) for name in sheet.hidden_sheets]
        notes.append(notice("hidden_sheets", names=spoken(names)))
    lines = [_line(sheet.texts(row, EMPTY_CELL)) for row in range(1, sheet.last_row + 1)]
    others = len(sheet.other_sheets) > len(sheet.hidden_sheets)
    return _printable(sheet.name), lines, others, notes


def _printable(name: str) -> str:
    return _CONTROL.sub("?", name)


def _line(texts: list[str]) -> str:
    """A row as a line of text."""
    return "\t".join(text[:500].replace("\n", " ").replace("\t", " ") for text in texts) or EMPTY_CELL
