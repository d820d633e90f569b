"""Journal of finished runs and checks: one line each, handed to the system before the next, so that a killed batch
resumes."""

import contextlib
import errno
import hashlib
import itertools
import json
import os
import shutil
import sys
import threading
import time
from dataclasses import is_dataclass
from pathlib import Path
from types import NoneType, UnionType
from typing import Any, BinaryIO, NamedTuple, get_args, get_origin, get_type_hints

from core.errors import OutputError
from core.jit import stamp
from core.regular_file import refuse_irregular
from core.version import VERSION

SYNC_SECONDS = 1.0
"""Least time between two calls that bring the journal to the disk: they hold up the threads, a tenth of the time of
many walls. A kill loses nothing, a power cut what was found in that second."""


def journal_key() -> str:
    """Key of a journal: the program and the state of its sources."""
    return f"{VERSION} {stamp.source_stamp()}"


class LineSpan(NamedTuple):
    """Where a line of a journal begins, and its length, line end included [bytes]."""

    start: int
    length: int


class Journal:
    """Finished work by key, a line each, of which only the place is kept in memory: searches and checks of a case, rows
    of the groups of a large one.

    path : of the file
    key : of the program's sources and of what they read; another key starts it anew
    resume : go on with what an earlier start finished, which else is set aside
    sync_seconds : least time between two calls that bring lines to the disk; a kill loses nothing, a power cut what
        was written in it
    set_aside : where that went, or None
    dropped : lines that were damaged, by their hash, whose work is done again
    Several threads may add and get. Raises OutputError for a file of somebody else, and while another batch writes it.
    """

    def __init__(self, path: Path, key: str, resume: bool, sync_seconds: float = 0.0):
        self.path, self.dropped = path, 0
        self.places: dict[str, LineSpan] = {}
        self._lock = threading.Lock()
        self._sync_seconds, self._synced = sync_seconds, 0.0
        self.set_aside: Path | None = None
        try:
            self._stream = open(path, "a+b", buffering=0)  # noqa: SIM115  (held to the end of the batch)
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
            lock_file(self._stream)
        except OSError as error:
            if error.errno not in (errno.EAGAIN, errno.EACCES, errno.EWOULDBLOCK, errno.EDEADLK):
                raise
            raise OutputError("batch_running", place=(self.path,)) from None
        if not is_same_file(self._stream, self.path):
            raise OutputError("batch_just_ended", place=(self.path,))
        if not is_journal(self._stream):
            raise OutputError("not_a_journal", place=(self.path,))
        head, end, lines = scan_journal(self._stream)
        self.places = {name: place for name, place in lines if name}
        self.dropped = sum(not name for name, _ in lines)
        mine = end > 0 and parse_line(head) == {HEAD_KEY: key}  # a head without its line end is written again
        if (self.places and not resume) or (lines and not mine):
            self.set_aside, mine = self._copied(), False
        if not mine:
            self.places, self.dropped = {}, 0
            self._stream.truncate(0)
            self._put({HEAD_KEY: key})
        elif self.dropped:
            self._rewrite(head)
        else:
            self._stream.truncate(end)

    def _copied(self) -> Path:
        """Copy what an earlier start left into `<path>.old`, or the first of `.old2`, ... that is not there."""
        for end in itertools.chain([""], map(str, itertools.count(2))):
            place = self.path.with_name(f"{self.path.name}.old{end}")
            with contextlib.suppress(FileExistsError), open(place, "xb") as stream:
                self._stream.seek(0)
                shutil.copyfileobj(self._stream, stream)
                stream.flush()
                os.fsync(stream.fileno())
                break
        return place

    def _rewrite(self, head: bytes) -> None:
        """Put the whole lines in a file of their own, which takes the place of the damaged one."""
        place, places = self.path.with_name(f"{self.path.name}.{os.getpid()}.new"), {}
        with open(place, "xb") as stream:  # nobody else's
            stream.write(head + b"\n")
            for name, (at, length) in self.places.items():
                places[name] = LineSpan(stream.tell(), length)
                self._stream.seek(at)
                stream.write(self._stream.read(length))
            stream.flush()
            os.fsync(stream.fileno())
        damaged, self.places = self._stream, places
        if os.name == "nt":
            damaged.close()
        os.replace(place, self.path)
        self._stream = open(self.path, "a+b", buffering=0)  # noqa: SIM115
        lock_file(self._stream)
        damaged.close()

    def _put(self, entry: dict) -> LineSpan:
        """Append a line, safe from a kill when this returns, from a power cut where the last sync is sync_seconds ago;
        its place. Raises OSError where not all of it could be written."""
        content = json.dumps(entry).encode() + b"\n"
        place = LineSpan(self._stream.seek(0, os.SEEK_END), len(content))
        try:
            while content:
                content = content[self._stream.write(content) :]
        except OSError:
            self._stream.truncate(place.start)  # what was begun would join the next line
            raise
        if time.monotonic() - self._synced >= self._sync_seconds:
            os.fsync(self._stream.fileno())
            self._synced = time.monotonic()
        return place

    def __contains__(self, name: object) -> bool:
        return str(name) in self.places

    def get(self, name: int | str) -> dict | None:
        """What was found under a name, None where nothing was."""
        with self._lock:
            place = self.places.get(str(name))
            return None if place is None else read_line(self._stream, place)

    def add(self, name: int | str, result: dict) -> None:
        """Keep what was found under a name."""
        try:
            with self._lock:
                self.places[str(name)] = self._put(entry_with_hash(str(name), result))
        except OSError as error:
            raise OutputError("journal_not_writable", reason=error.strerror, place=(self.path,)) from None

    def close(self) -> None:
        self._stream.close()

    def remove(self) -> None:
        """The batch is done: where the system can, the file goes while nobody else can hold it, and only while it is
        the one that was opened."""
        mine = is_same_file(self._stream, self.path)
        if os.name == "nt":
            self._stream.close()
        with contextlib.suppress(OSError):
            if mine:
                self.path.unlink(missing_ok=True)
        self._stream.close()


MAX_JOURNAL_LINE = 200_000_000
"""Bytes of a line; what is longer has no end."""


def scan_journal(file: BinaryIO) -> tuple[bytes, int, list[tuple[str, LineSpan]]]:
    """(first line, end of the last whole line, (name, place) of each other line, no name of one that is damaged)."""
    os.lseek(file.fileno(), 0, os.SEEK_SET)
    lines = []
    with open(file.fileno(), "rb", 1 << 20, closefd=False) as stream:
        head = stream.readline(MAX_JOURNAL_LINE)
        place = end = len(head) if head.endswith(b"\n") else 0
        for line in iter(lambda: stream.readline(MAX_JOURNAL_LINE), b""):
            if not line.endswith(b"\n"):  # what a kill cut off
                break
            entry = parse_line(line)
            whole = entry is not None and entry == entry_with_hash(entry.get("run"), entry.get("result"))
            lines.append((str(entry["run"]) if entry and whole else "", LineSpan(place, len(line))))
            place += len(line)
            end = place
    return head.removesuffix(b"\n"), end, lines


def read_line(file: BinaryIO, place: LineSpan) -> dict:
    """What the line at a place of a journal holds."""
    file.seek(place.start)
    return json.loads(file.read(place.length) or b"")["result"]


HEAD_KEY = "Ribalta journal"
"""The key of the first line: no other program's file begins with it."""


def is_journal(stream: BinaryIO) -> bool:
    """Whether a file is a journal, or what a kill left of the first line of one."""
    start = b'{"' + HEAD_KEY.encode() + b'": "'
    stream.seek(0)
    content = stream.read(len(start))
    return content == start[: len(content)]


def is_same_file(stream, path: Path) -> bool:
    """Whether this name still is the file that was opened: another batch may have removed it in between."""
    try:
        return os.path.samestat(os.fstat(stream.fileno()), path.stat())
    except OSError:
        return False


def lock_file(stream) -> None:
    """Hold a file for this process alone, until it is closed; raises OSError where another one does."""
    if sys.platform == "win32":
        import msvcrt

        stream.seek(0)
        msvcrt.locking(stream.fileno(), msvcrt.LK_NBLCK, 1)
    else:
        import fcntl

        fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)


def parse_line(line: bytes) -> dict | None:
    """The entry of a line, None where it is none."""
    try:
        entry = json.loads(line)
    except (ValueError, RecursionError):
        return None
    return entry if isinstance(entry, dict) else None


def entry_with_hash(run: str | None, result: dict | None) -> dict:
    """The entry of a run with the hash of itself."""
    entry = {"run": run, "result": result}
    return {**entry, "hash": entry_hash(entry)}


def entry_hash(entry: dict) -> str:
    """Hash what a line says, whatever hash it states."""
    content = json.dumps([entry.get("run"), entry.get("result")])
    return hashlib.sha256(content.encode()).hexdigest()[:16]


def dataclass_from_json(kind: Any, value: Any) -> Any:
    """What a dataclass declares, from the JSON of its `asdict`: doubles are exact there, tuples are lists. None where
    the value is None or not of this kind."""
    try:
        return _rebuilt(kind, value)
    except (TypeError, ValueError, AttributeError):
        return None


def _rebuilt(kind: Any, value: Any) -> Any:
    inner = get_args(kind)
    if value is None:
        return None
    if is_dataclass(kind):
        kinds = get_type_hints(kind)
        made: Any = kind
        return made(**{name: _rebuilt(kinds.get(name), part) for name, part in value.items()})
    if get_origin(kind) is UnionType:
        return _rebuilt(next(one for one in inner if one is not NoneType), value)
    if get_origin(kind) is tuple:
        kinds_of = (inner[0] for _ in value) if inner[-1] is Ellipsis else inner
        return tuple(_rebuilt(one, part) for one, part in zip(kinds_of, value, strict=True))
    return value


def _room(result: dict) -> int:
    return len(result.get("outcomes") or repr(result))


class MemoryJournal:
    """Finished runs and checks of one process by key, for the studies that follow; as a Journal, but not on disk.

    most : room, of a run the digits of its survival map, of a check the letters of all it holds; the oldest go first
    Several threads may add.
    """

    def __init__(self, most: int = 20_000_000):
        self.most, self.found = most, {}
        self.size = 0
        self._lock = threading.Lock()

    def get(self, run: str) -> dict | None:
        return self.found.get(run)

    def add(self, run: str, result: dict) -> None:
        with self._lock:
            self.found[run] = result
            self.size += _room(result)
            while self.size > self.most:
                self.size -= _room(self.found.pop(next(iter(self.found))))

    def close(self) -> None:
        """Nothing is open."""
