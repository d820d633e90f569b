"""The files that a case names beside its records, as they were read: what verifies a report where they are not."""

import hashlib
import json
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

from core.errors import InputError
from core.file_names import name_of
from core.regular_file import read_regular
from core.text.sentence import Sentence, notice

MAX_FILE_BYTES = 500_000_000
"""Largest file of which a hash is made; each reader has its own, smaller bound."""

MAX_ROW_LETTERS = 30_000
"""Longest row as JSON that is kept: a cell of a workbook holds 32 767 letters."""


class CaseFile(NamedTuple):
    """A file that a case names.

    role : the key that names it: walls, hazard_file, spectrum_file, drawing
    file : as the case names it
    sha256 : of its bytes
    notices : what was said of it when it was read
    rows : the cells of a table of walls; None of a file that is not held, which has to be there to be read again
    """

    role: str
    file: str
    sha256: str
    notices: tuple[Sentence, ...] = ()
    rows: tuple[tuple[str, ...], ...] | None = None


def hash_file(path: Path) -> str:
    """SHA-256 of a file. Raises OSError."""
    return hashlib.sha256(read_regular(path, MAX_FILE_BYTES)).hexdigest()


def hold_rows(rows: Iterable[list[str]]) -> tuple[tuple[str, ...], ...] | None:
    """The rows of a table as a report holds them, None if there are none or one is too long for a workbook."""
    held = tuple(map(tuple, rows))
    return held if held and all(len(json.dumps(row)) <= MAX_ROW_LETTERS for row in held) else None


def as_lines(files: Iterable[CaseFile]) -> Iterator[str]:
    """Write files as lines of JSON: an object for each, then an array for each row it holds."""
    for file in files:
        yield json.dumps(as_dict(file) | {"rows": file.rows is not None})
        yield from (json.dumps(row, ensure_ascii=False) for row in file.rows or ())


def as_dict(file: CaseFile) -> dict[str, Any]:
    """Write a file as the results have it."""
    notices = [{"code": said.code, **dict(said.values)} for said in file.notices]
    return {"role": file.role, "file": file.file, "sha256": file.sha256, "notices": notices, "rows": file.rows}


def parse_lines(lines: Iterable[str]) -> tuple[CaseFile, ...]:
    """Read what `as_lines` writes. Raises ValueError for anything else."""
    entries: list[dict[str, Any]] = []
    for line in lines:
        content = json.loads(line)
        if isinstance(content, dict):
            entries.append(content | {"rows": [] if content.get("rows") is True else None})
        elif entries and entries[-1]["rows"] is not None:
            entries[-1]["rows"].append(content)
        else:
            raise ValueError("a row of no file")
    return parse_entries(entries)


def parse_entries(entries: Any) -> tuple[CaseFile, ...]:
    """Read what `as_dict` writes of each file. Raises ValueError for anything else."""
    files = []
    try:
        for entry in entries:
            texts = [entry["role"], entry["file"], entry["sha256"]]
            notices = tuple(notice(said.pop("code"), **said) for said in map(dict, entry["notices"]))
            values = [value for said in notices for _, value in said.values]
            rows = None if entry["rows"] is None else tuple(map(tuple, entry["rows"]))
            cells = [cell for row in rows or () for cell in row]
            if not all(isinstance(value, str) for value in (*texts, *values, *cells)):
                raise ValueError("not a text")
            role, file, sha256 = texts
            files.append(CaseFile(role, file, sha256, notices, rows))
    except (AttributeError, KeyError, TypeError) as error:
        raise ValueError("not a file of a case") from error
    return tuple(files)


def choose_held(files: Iterable[CaseFile], folder: Path) -> list[CaseFile]:
    """Choose the files that are taken from a report, because they are not there or are others now.

    folder : of the case
    Raises InputError for one of these that the report does not hold.
    """
    held = []
    for file in files:
        path = folder / name_of(file.file)
        try:
            if hash_file(path) == file.sha256:
                continue
            error = InputError("file_changed", place=(path,))
        except OSError as reason:
            error = InputError("file_not_held", place=(path,), reason=reason.strerror)
        if file.rows is None:
            raise error
        held.append(file)
    return held
