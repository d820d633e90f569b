"""The files within a calculation note (PDF/A-3): the case it is of, its results, the list of its records."""

import io
import logging
from collections.abc import Collection
from pathlib import Path
from typing import Any

from core import atomic_write
from core.errors import InputError
from core.packages import require
from core.regular_file import TooLarge, read_regular

CASE = "case.toml"
NAMES = (CASE, "results.json", "records.csv")
"""Of the files the program puts into a note; others are left alone."""

PACKED = (None, "/FlateDecode", ["/FlateDecode"])
"""Filters of a file within a note: of others, which no note has, pypdf unpacks a megabyte in a second."""

MOST = 100_000_000
"""Largest note that is read [bytes]."""


def is_note(content: bytes) -> bool:
    """Whether a file is a PDF."""
    return content[:5] == b"%PDF-"


def files_within(path: Path, names: Collection[str] = NAMES) -> dict[str, bytes]:
    """Name -> content of these files within a note, none but them decoded. Raises InputError for what is no note of
    this program."""
    require("report")
    import pypdf

    logging.getLogger("pypdf").addHandler(logging.NullHandler())  # else it writes to the terminal
    try:
        content = read_regular(path, MOST)
        if b"%%EOF" not in content[-1024:]:
            raise ValueError("cut off")
        # strict: of a damaged file pypdf would search all bytes for what is left, for minutes, and warn on stderr
        reader = pypdf.PdfReader(io.BytesIO(content), strict=True)
        found = {}
        files: Any = reader.attachment_list
        for file in files:
            if file.name in names and file.name not in found:
                packed = file.pdf_object["/EF"]["/F"].get_object().get("/Filter")
                if packed not in PACKED:
                    raise ValueError(f"{file.name}: {packed}")
                found[file.name] = file.content
    except FileNotFoundError:
        raise InputError("no_case_file", place=(path,)) from None
    except TooLarge as error:
        raise InputError("case_too_large", mb=error.size / 1e6, most=MOST / 1e6, place=(path,)) from None
    except OSError as error:
        raise InputError("unreadable", reason=error.strerror, place=(path,)) from None
    except InputError:
        raise
    except Exception as error:  # pypdf raises whatever a damaged file makes it raise
        raise InputError("not_a_note", reason=str(error)[:100] or type(error).__name__, place=(path,)) from None
    if CASE not in found:
        raise InputError("note_without_case", place=(path,))
    return found


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
