"""Journal of the groups of a large case: a line each, of which only the place is kept in memory."""

import contextlib
import errno
import itertools
import json
import os
import shutil
from pathlib import Path
from typing import BinaryIO

from core.errors import InputError, OutputError
from core.regular_file import open_regular, refuse_irregular
from core.study.case_parts import FINISHED, parts_in
from core.study.journal import HEAD, is_at, lock, ours, parsed, remove_held, valid

LONGEST_LINE = 200_000_000
"""Bytes of the rows of a group; what is longer has no end."""


class GroupJournal:
    """Rows of finished groups, on the disk before the next; started anew where its key is another.

    path : of the file
    key : of the program, the case and what that reads
    resume : go on with what an earlier start finished, which else is set aside
    set_aside : where that went, or None; dropped : lines that were damaged, whose groups are made again
    Raises OutputError for a file of somebody else, and while another batch writes it.
    """

    def __init__(self, path: Path, key: str, resume: bool):
        self.path, self.dropped, self.places = path, 0, {}
        self.set_aside: Path | None = None
        try:
            self._stream = open(path, "a+b")  # noqa: SIM115  (held to the end of the batch)
            try:
                refuse_irregular(self._stream)
                self._begin(key, resume)
            except (OSError, OutputError):
                self._stream.close()
                raise
        except OSError as error:
            raise OutputError("journal_not_writable", reason=error.strerror, place=(path,)) from None

    def _begin(self, key: str, resume: bool) -> None:
        try:
            lock(self._stream)
        except OSError as error:
            if error.errno not in (errno.EAGAIN, errno.EACCES, errno.EWOULDBLOCK, errno.EDEADLK):
                raise
            raise OutputError("batch_running", place=(self.path,)) from None
        if not is_at(self._stream, self.path):
            raise OutputError("batch_just_ended", place=(self.path,))
        head, end, lines = _scanned(self._stream)
        if not ours(head):
            raise OutputError("not_a_journal", place=(self.path,))
        mine = parsed(head) == {HEAD: key}
        for name, place in lines:
            if name:
                self.places[name] = place
            else:
                self.dropped += 1
        if mine and (resume or not self.places):
            self._stream.truncate(end)
            return
        if self.places or (end and not mine):
            self.set_aside = self._copied()
        self.places, self.dropped = {}, 0
        self._stream.truncate(0)
        self._put({HEAD: key})

    def _copied(self) -> Path:
        """The file that now holds what an earlier start left: `<path>.old`, or the first of `.old2`, ..."""
        for end in itertools.chain([""], map(str, itertools.count(2))):
            place = self.path.with_name(f"{self.path.name}.old{end}")
            with contextlib.suppress(FileExistsError), open(place, "xb") as stream:
                self._stream.seek(0)
                shutil.copyfileobj(self._stream, stream)
                stream.flush()
                os.fsync(stream.fileno())
                break
        return place

    def _put(self, entry: dict) -> int:
        """Append a line, on disk when this returns; its place."""
        place = self._stream.seek(0, os.SEEK_END)
        self._stream.write(json.dumps(entry).encode() + b"\n")
        self._stream.flush()
        os.fsync(self._stream.fileno())
        return place

    def __contains__(self, name: object) -> bool:
        return str(name) in self.places

    def get(self, name: int | str) -> dict:
        """The rows of a group that is there."""
        return _read(self._stream, self.places[str(name)])

    def add(self, name: int | str, rows: dict) -> None:
        """The rows of a group, or of FINISHED none."""
        try:
            self.places[str(name)] = self._put(valid(str(name), rows))
        except OSError as error:
            raise OutputError("journal_not_writable", reason=error.strerror, place=(self.path,)) from None

    def close(self) -> None:
        self._stream.close()

    def remove(self) -> None:
        """The batch is done."""
        remove_held(self._stream, self.path)


def _scanned(stream: BinaryIO) -> tuple[bytes, int, list[tuple[str, int]]]:
    """(first line, end of the last whole line, (group, place) of each other line, no group of one that is damaged)."""
    stream.seek(0)
    head, lines = stream.readline(LONGEST_LINE), []
    place = end = len(head) if head.endswith(b"\n") else 0
    for line in iter(lambda: stream.readline(LONGEST_LINE), b""):
        if not line.endswith(b"\n"):
            break
        entry = parsed(line)
        lines.append((entry["run"] if entry and entry == valid(entry.get("run"), entry.get("result")) else "", place))
        place += len(line)
        end = place
    return head.removesuffix(b"\n"), end, lines


def _read(stream: BinaryIO, place: int) -> dict:
    stream.seek(place)
    return json.loads(stream.readline())["result"]


class MergedGroups:
    """The rows of all groups of a large case from its parts, read when they are asked for."""

    def __init__(self, folder: Path, stem: str, keys, groups: int):
        """keys(k, n) : what the first line of the k-th of n parts says; groups : of the case. Raises InputError for a
        part that is missing, not finished, damaged, of another division, or of another case or program."""
        self.streams, self.places = [], []
        with contextlib.ExitStack() as opened:
            opened.callback(self.close)
            for k, n, path in parts_in(folder, stem):
                self._add(path, k, n, keys(k, n))
                if not {str(g) for g in range(k - 1, groups, n)} <= set(self.places[-1]):
                    raise InputError("part_damaged", k=k, n=n, path=path)
            opened.pop_all()  # all are there, and stay open

    def _add(self, path: Path, k: int, n: int, key: str) -> None:
        try:
            self.streams.append(open_regular(path))
        except OSError as error:
            raise InputError("unreadable", reason=error.strerror, place=(path,)) from None
        head, _, lines = _scanned(self.streams[-1])
        if parsed(head) != {HEAD: key}:
            raise InputError("part_of_another", path=path)
        self.places.append({name: place for name, place in lines if name})
        if FINISHED not in self.places[-1]:
            raise InputError("part_not_finished", k=k, n=n, path=path)

    def get(self, name: int) -> dict:
        """The rows of a group."""
        part = name % len(self.streams)
        return _read(self.streams[part], self.places[part][str(name)])

    def close(self) -> None:
        for stream in self.streams:
            stream.close()
