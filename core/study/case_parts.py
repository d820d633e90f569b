"""A case in parts: each a journal of the searches and checks of its walls, made wherever a scheduler starts it; merged,
they are the undivided run, bit for bit (resources/docs/scale.md)."""

import contextlib
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import BinaryIO

from core.case.schema import Case
from core.errors import InputError
from core.regular_file import open_regular
from core.study.journal import (
    HEAD_KEY,
    SYNC_SECONDS,
    Journal,
    LineSpan,
    MemoryJournal,
    is_journal,
    parse_line,
    read_line,
    scan_journal,
)
from core.study.run import UNLIMITED

FINISHED = "finished"
"""Key of the last line of a part."""


def part_path(folder: Path, stem: str, k: int, n: int) -> Path:
    """The journal of the k-th of n parts, k from 1."""
    return folder / f"{stem}.part-{k}-of-{n}.journal"


def part_key(key: str, case: Case, k: int, n: int) -> str:
    """What the first line of a part says: program, part, case. key : of `run.journal_key`"""
    return f"{key} part {k}/{n} of {case.sha256}"


def part_journal(folder: Path, stem: str, case: Case, key: str, k: int, n: int) -> Journal:
    """The journal a part goes on with, a new one where there is none. Raises OutputError."""
    return Journal(part_path(folder, stem, k, n), part_key(key, case, k, n), True, SYNC_SECONDS)


def find_parts(folder: Path, stem: str) -> Iterator[tuple[int, int, Path]]:
    """(k, n, journal) of the parts of a case in a folder. Raises InputError where there is none, where they are of two
    divisions, and at one that is missing."""
    shape = re.compile(re.escape(stem) + r"\.part-(\d+)-of-(\d+)\.journal")
    parts = {(int(m[1]), int(m[2])) for path in folder.iterdir() if (m := shape.fullmatch(path.name))}
    divisions = sorted({n for _, n in parts})
    if not parts:
        raise InputError("no_parts", path=part_path(folder, stem, 1, 2))
    if len(divisions) > 1:
        raise InputError("parts_of_two_divisions", found=tuple(str(n) for n in divisions), path=folder)
    (n,) = divisions
    for k in range(1, n + 1):
        path = part_path(folder, stem, k, n)
        if (k, n) not in parts:
            raise InputError("part_missing", k=k, n=n, path=path)
        yield k, n, path


class MergedParts:
    """What all parts of a case found, read when it is asked for.

    keys(k, n) : what the first line of the k-th of n parts says
    Raises InputError for a part that is missing, not finished, damaged, of another division, or of another case or
    program.
    """

    def __init__(self, folder: Path, stem: str, keys: Callable[[int, int], str]):
        self.streams: list[BinaryIO] = []
        self.places: dict[str, tuple[BinaryIO, LineSpan]] = {}
        with contextlib.ExitStack() as opened:
            opened.callback(self.close)
            for k, n, path in find_parts(folder, stem):
                self._add(path, k, n, keys(k, n))
            opened.pop_all()  # all are there, and stay open

    def _add(self, path: Path, k: int, n: int, key: str) -> None:
        try:
            stream = open_regular(path, buffering=0)
        except OSError as error:
            raise InputError("unreadable", reason=error.strerror, place=(path,)) from None
        self.streams.append(stream)
        head, _, lines = scan_journal(stream) if is_journal(stream) else (b"", 0, [])
        if parse_line(head) != {HEAD_KEY: key}:
            raise InputError("part_of_another", path=path)
        places = {name: (stream, place) for name, place in lines}
        if FINISHED not in places:
            raise InputError("part_not_finished", k=k, n=n, path=path)
        if "" in places:
            raise InputError("part_damaged", k=k, n=n, path=path)
        self.places |= places

    def get(self, name: int | str) -> dict | None:
        """What was found under a name, None where nothing was."""
        place = self.places.get(str(name))
        return None if place is None else read_line(*place)

    def close(self) -> None:
        for stream in self.streams:
            stream.close()


def open_parts(folder: Path, stem: str, case: Case, key: str) -> MemoryJournal:
    """What all parts of a case found. Raises InputError as MergedParts."""
    parts, memory = MergedParts(folder, stem, lambda k, n: part_key(key, case, k, n)), MemoryJournal(UNLIMITED)
    with contextlib.closing(parts):
        memory.found |= {name: result for name in parts.places if name != FINISHED and (result := parts.get(name))}
    return memory
