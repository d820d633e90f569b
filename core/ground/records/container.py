"""Files that hold other files: the zips of ESM and ITACA as downloaded, workbooks of Excel."""

import io
import re
import zipfile
import zlib

from core.errors import RecordError
from core.ground.records.channels import is_vertical, refuse_unchosen
from core.ground.records.plain import EMPTY

MAX_UNPACKED = 20_000_000
"""Bytes of one member, or of a workbook, unpacked."""

MAX_MEMBERS, MAX_ROWS, MAX_COLUMNS = 500, 50_000, 100
MAX_CELLS = 150_000

BETWEEN = ": "
"""Between the name of a member and that of a channel in it."""

_ACCELERATION = re.compile(r"\.ACC\.", re.IGNORECASE)
_OTHER = re.compile(
    r"\.(vt2|dt2|v3|pdf|png|jpe?g|gif|xml|html?|json|md|rs|metadata)\Z"
    r"|\.(VEL|DIS|SA|SD|SV|PSA|PSV)\.[^/]*\Z|(?:\A|/)(?:readme|licen[cs]e)[^/.]*(?:\.(txt|pdf|md))?\Z",
    re.IGNORECASE,
)
"""Members that are no accelerogram: velocities, displacements and spectra of ESM by their names, documents."""

_UP = re.compile(r"[-_.](UP|DWN|VER|UD|V)\.\w+\Z", re.IGNORECASE)
_NO_VALUE = re.compile(
    rb"<f[ >][^<]*</f>\s*(?:<v\s*/>|<v></v>|</c>)|<f[^>]*/>\s*(?:<v\s*/>|<v></v>|</c>)"
)
_CONTROL = re.compile(r"[\x00-\x1f\x7f-\x9f\u2028\u2029]")
_STREAM = re.compile(r"\.\w\w([ZENXY123])\.")

BAD_ZIP = (zipfile.BadZipFile, zlib.error, EOFError, NotImplementedError, RuntimeError, OSError,
           ValueError, KeyError, IndexError, AttributeError, TypeError, SyntaxError)  # fmt: skip
"""What a hostile archive or workbook raises."""


def is_zip(content: bytes) -> bool:
    return content[:4] == b"PK\x03\x04"


def is_workbook(content: bytes) -> bool:
    """Whether a zip is a workbook of Excel."""
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as folder:
            return "xl/workbook.xml" in folder.namelist()
    except BAD_ZIP as error:
        raise RecordError("bad_archive", reason=type(error).__name__) from None


def member_of(content: bytes, asked: str | None) -> tuple[str, bytes, str | None, bool]:
    """(name, bytes, the channel asked for within it, whether there are others) of one accelerogram of a zip.

    asked : its name, or its number from 1, and after ": " a channel of it. Raises RecordError naming the members.
    """
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as folder:
            entries = [entry for entry in folder.infolist() if not entry.is_dir()]
            if len(entries) > MAX_MEMBERS:
                raise RecordError("too_many_channels", n=len(entries), most=MAX_MEMBERS)
            entries = [
                entry for entry in entries
                if not _OTHER.search(entry.filename) and not entry.filename.startswith("__MACOSX")
            ]  # fmt: skip
            entries = sorted(entries, key=_order)
            if not entries:
                raise RecordError("no_member")
            names = [_CONTROL.sub("?", entry.filename) for entry in entries]
            member, within = _split(asked, names)
            k = refuse_unchosen(names, [_is_vertical(name) for name in names], member)
            entry = entries[k]
            if entry.file_size > MAX_UNPACKED:
                raise RecordError("unpacked_too_large", mb=entry.file_size / 1e6)
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
        if asked.startswith(name + BETWEEN):
            return name, asked.removeprefix(name + BETWEEN)
    return (names[0], asked) if len(names) == 1 else (asked, None)


def _order(entry: zipfile.ZipInfo) -> tuple:
    """Accelerations by name first, horizontal before vertical, processed (MP) before converted only (CV)."""
    name = entry.filename
    return not _ACCELERATION.search(name), _is_vertical(name), ".CV." in name.upper(), name


def _is_vertical(name: str) -> bool:
    base = name.rpartition("/")[2]
    stream = _STREAM.search(base)
    ending = base.rpartition(".")[2]
    told = bool(stream and stream[1] == "Z") or bool(_UP.search(base))
    return told or is_vertical(ending.rstrip("12"))


def sheet_of(content: bytes, asked: str | None) -> tuple[str, list[str], bool]:
    """(name, lines of cells with tabs between them, whether there are others) of one sheet of a workbook that is shown.
    Raises RecordError."""
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as folder:
            if sum(entry.file_size for entry in folder.infolist()) > 2 * MAX_UNPACKED:
                raise RecordError("unpacked_too_large", mb=2 * MAX_UNPACKED / 1e6)
        from openpyxl import load_workbook

        book = load_workbook(io.BytesIO(content), read_only=True, data_only=True, keep_links=False)
        sheets = [sheet for sheet in book.worksheets if sheet.sheet_state == "visible"]
        if not sheets:
            raise RecordError("no_member")
        names = [_CONTROL.sub("?", sheet.title) for sheet in sheets]
        sheet = sheets[refuse_unchosen(names, [False] * len(names), asked)]
        sheet.reset_dimensions()  # the tag that states them can lie
        _refuse_formulas(content, sheet._worksheet_path)
        lines, cells = [], 0
        for row in sheet.iter_rows(max_col=MAX_COLUMNS, values_only=True):
            cells += len(row)
            if len(lines) >= MAX_ROWS or cells > MAX_CELLS:
                raise RecordError("sheet_too_long", rows=MAX_ROWS)
            lines.append("\t".join(map(_cell, row)).rstrip(f"\t{EMPTY}") or EMPTY)
        while lines and lines[-1] == EMPTY:
            lines.pop()
        return _CONTROL.sub("?", sheet.title), lines, len(sheets) > 1
    except RecordError:
        raise
    except BAD_ZIP as error:
        raise RecordError("bad_archive", reason=type(error).__name__) from None


def _refuse_formulas(content: bytes, part: str) -> None:
    """Raise RecordError where a formula of a sheet has no value: no program has computed it."""
    with zipfile.ZipFile(io.BytesIO(content)) as folder:
        if _NO_VALUE.search(folder.read(part.lstrip("/"))):
            raise RecordError("formula_without_value")


def _cell(value) -> str:
    """A cell as text; a number with every digit it has."""
    if value is None or value == "":
        return EMPTY
    if isinstance(value, float):
        return repr(value)
    return str(value)[:500].replace("\n", " ").replace("\t", " ")
