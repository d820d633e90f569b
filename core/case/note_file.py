"""The files within a calculation note (PDF/A-3): the case it is of, its results, the list of its records."""

import io
from collections.abc import Collection
from pathlib import Path
from typing import Any

from core import atomic_write
from core.child import Refused, bounded
from core.errors import InputError
from core.packages import require
from core.regular_file import TooLarge, read_regular

CASE = "case.toml"
NOTE_FILES = (CASE, "results.json", "records.csv")
"""Names of the files the program puts into a note; others are left alone."""

SECONDS, MEGABYTES = 20.0, 2000
"""That a note may take: one of 70 MB takes half a second."""

MAX_NOTE_BYTES = 100_000_000
"""Largest note that is read [bytes]."""


def is_note(content: bytes) -> bool:
    """Whether a file is a PDF."""
    return content.startswith(b"%PDF-")


def files_within(path: Path, names: Collection[str] = NOTE_FILES) -> dict[str, bytes]:
    """Name -> content of these files within a note, none but them decoded. Raises InputError for what is no note of
    this program."""
    require("report")
    try:
        content = read_regular(path, MAX_NOTE_BYTES)
        files = bounded(unpacked, content, tuple(names), seconds=SECONDS, megabytes=MEGABYTES)
    except FileNotFoundError:
        raise InputError("no_case_file", place=(path,)) from None
    except TooLarge as error:
        raise InputError("case_too_large", mb=error.size / 1e6, most=MAX_NOTE_BYTES / 1e6, place=(path,)) from None
    except OSError as error:
        raise InputError("unreadable", reason=error.strerror, place=(path,)) from None
    except Refused as error:
        if not error.reason:
            raise InputError("note_too_much", seconds=SECONDS, gb=1e-3 * MEGABYTES, place=(path,)) from None
        raise InputError("not_a_note", reason=error.reason[:100], place=(path,)) from None
    if CASE not in files:
        raise InputError("note_without_case", place=(path,))
    return files


def unpacked(content: bytes, names: Collection[str]) -> dict[str, bytes]:
    """`files_within` of the bytes of a note. Raises what pypdf raises of a damaged file, ValueError of another's."""
    import pypdf

    if b"%%EOF" not in content[-1024:]:
        raise ValueError("cut off")
    # strict: of a damaged file pypdf would search all bytes for what is left, for minutes
    reader = pypdf.PdfReader(io.BytesIO(content), strict=True)
    if reader.is_encrypted:
        raise ValueError("encrypted")
    contents: dict[str, bytes] = {}
    files: Any = reader.attachment_list
    for file in files:
        if file.name in contents:
            raise ValueError(f"two files {file.name}")
        if file.name in names:
            contents[file.name] = file.content
            if file.size is not None and file.size != len(contents[file.name]):  # pypdf takes what is left of it
                raise ValueError(f"{file.name} is damaged")
    return contents


def extract(path: Path, folder: Path) -> list[Path]:
    """Write the files within a note into a folder, all or none; returns their paths. Raises InputError where one of
    them is there already."""
    files = {folder / name: content for name, content in files_within(path).items()}
    for target in files:
        if target.exists():
            raise InputError("extract_overwrites", path=target, place=(path,))
    atomic_write.check_folder(folder)
    atomic_write.write(files)
    return list(files)
