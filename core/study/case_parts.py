"""A case in parts: each a journal of the searches and checks of its walls, made wherever a scheduler starts it; merged,
they are the undivided run, bit for bit (resources/docs/scale.md)."""

import re
from collections.abc import Iterator
from pathlib import Path

from core.case.schema import Case
from core.errors import InputError
from core.study.journal import HEAD, SYNC_SECONDS, Journal, Memory, entries_of
from core.study.run import EVERYTHING

FINISHED = "finished"
"""Key of the last line of a part."""


def part_path(folder: Path, stem: str, k: int, n: int) -> Path:
    """The journal of the k-th of n parts, k from 1."""
    return folder / f"{stem}.part-{k}-of-{n}.journal"


def part_key(key: str, case: Case, k: int, n: int) -> str:
    """Content of the first line of a part: program, part, case. key : of `run.journal_key`"""
    return f"{key} part {k}/{n} of {case.sha256}"


def part_journal(folder: Path, stem: str, case: Case, key: str, k: int, n: int) -> Journal:
    """The journal a part goes on with, a new one where there is none. Raises OutputError."""
    return Journal(part_path(folder, stem, k, n), part_key(key, case, k, n), True, SYNC_SECONDS)


def parts_in(folder: Path, stem: str) -> Iterator[tuple[int, int, Path]]:
    """(k, n, journal) of the parts of a case in a folder. Raises InputError where there is none, where they are of two
    divisions, and at one that is missing."""
    shape = re.compile(re.escape(stem) + r"\.part-(\d+)-of-(\d+)\.journal")
    found = {(int(m[1]), int(m[2])) for path in folder.iterdir() if (m := shape.fullmatch(path.name))}
    divisions = sorted({n for _, n in found})
    if not found:
        raise InputError("no_parts", path=part_path(folder, stem, 1, 2))
    if len(divisions) > 1:
        raise InputError("parts_of_two_divisions", found=tuple(str(n) for n in divisions), path=folder)
    (n,) = divisions
    for k in range(1, n + 1):
        path = part_path(folder, stem, k, n)
        if (k, n) not in found:
            raise InputError("part_missing", k=k, n=n, path=path)
        yield k, n, path


def merged(folder: Path, stem: str, case: Case, key: str) -> Memory:
    """Merge what all parts of a case found. Raises InputError for a part that is missing, not finished, of another
    division, damaged, or of another case or program."""
    memory = Memory(EVERYTHING)
    for k, n, path in parts_in(folder, stem):
        head, entries, damaged = entries_of(path)
        if head.get(HEAD) != part_key(key, case, k, n):
            raise InputError("part_of_another", path=path)
        if FINISHED not in entries:
            raise InputError("part_not_finished", k=k, n=n, path=path)
        if damaged:
            raise InputError("part_damaged", k=k, n=n, path=path)
        memory.found |= entries
    del memory.found[FINISHED]
    return memory
