"""The files within a calculation note (PDF/A-3): the case it is of, its results, the list of its records."""

import io
from pathlib import Path

from core import atomic_write
from core.errors import InputError
from core.packages import require
from core.regular_file import TooLarge, read_regular

CASE = "case.toml"
NAMES = (CASE, "results.json", "records.csv")
"""Of the files the program puts into a note; others are left alone."""

MOST = 500_000_000
"""Largest note that is read [bytes]."""


def is_note(content: bytes) -> bool:
    """Whether a file is a PDF."""
    return content[:5] == b"%PDF-"


def files_within(path: Path) -> dict[str, bytes]:
    """Name -> content of the files of NAMES within a note. Raises InputError for what is no note of this program."""
    require("report")
    import pypdf

    try:
        reader = pypdf.PdfReader(io.BytesIO(read_regular(path, MOST)))
        found = {name: contents[0] for name, contents in reader.attachments.items() if name in NAMES}
    except FileNotFoundError:
        raise InputError("no_case_file", place=(path,)) from None
    except TooLarge as error:
        raise InputError("case_too_large", mb=error.size / 1e6, place=(path,)) from None
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
