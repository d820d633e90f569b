"""Journal of finished runs and checks: one line each, handed to the system before the next, so that a killed batch
resumes."""

import contextlib
import errno
import hashlib
import itertools
import json
import os
import sys
import threading
import time
from dataclasses import is_dataclass
from pathlib import Path
from types import NoneType, UnionType
from typing import Any, get_args, get_origin, get_type_hints

from core.errors import InputError, OutputError
from core.regular_file import open_regular, refuse_irregular

SYNC_SECONDS = 1.0
"""Least time between two calls that bring the journal to the disk: they hold up the threads, a tenth of the time of
many walls. A kill loses nothing, a power cut what was found in that second."""


class Journal:
    """Finished runs and checks by key. key : of the program's sources; another key starts it anew.

    Each line carries a hash of itself: one that is damaged is dropped, and its run is made again.

    set_aside : where the finished runs of an earlier start went that is not resumed, or None
    dropped : lines that were damaged
    sync_seconds : least time between two calls that bring lines to the disk; a kill loses nothing, a power cut what
        was written in it
    Raises OutputError for a file of somebody else, and while another batch writes it.
    """

    def __init__(self, path: Path, key: str, resume: bool, sync_seconds: float = 0.0):
        self.path, self.found, self.dropped = path, {}, 0
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
            lock(self._stream)
        except OSError as error:
            if error.errno not in (errno.EAGAIN, errno.EACCES, errno.EWOULDBLOCK, errno.EDEADLK):
                raise
            raise OutputError("batch_running", place=(self.path,)) from None
        if not is_at(self._stream, self.path):
            raise OutputError("batch_just_ended", place=(self.path,))
        self._stream.seek(0)
        if not ours(self._stream.read(HEAD_BYTES)) or os.fstat(self._stream.fileno()).st_size > MOST_BYTES:
            raise OutputError("not_a_journal", place=(self.path,))
        self._stream.seek(0)
        content = self._stream.readall()
        head, *lines = content.split(b"\n")
        mine = parsed(head) == {HEAD: key}
        good, kept = [], 0
        # what a kill cut off has no line end
        for line in lines[:-1] if mine else []:
            entry = parsed(line)
            if entry and entry.get("hash") == hash_of(entry):
                self.found[entry["run"]] = entry["result"]
                good.append(line)
            else:
                self.dropped += 1
            if not self.dropped:
                kept += len(line) + 1
        if (self.found and not resume) or (lines[:-1] and not mine):
            self.set_aside = _set_aside(self.path, content)
            self.found, self.dropped, good, mine = {}, 0, [], False
        if not mine:
            self._stream.truncate(0)
            self._put(json.dumps({HEAD: key}).encode() + b"\n")
        elif not self.dropped:
            self._stream.truncate(len(head) + 1 + kept)
        else:
            self._rewrite(b"\n".join([head, *good, b""]))

    def _rewrite(self, content: bytes) -> None:
        """The whole lines in a file of their own, which takes the place of the damaged one."""
        place = self.path.with_name(f"{self.path.name}.{os.getpid()}.new")
        with open(place, "xb") as stream:  # nobody else's
            stream.write(content)
            stream.flush()
            os.fsync(stream.fileno())
        damaged = self._stream
        if os.name == "nt":
            damaged.close()
        os.replace(place, self.path)
        self._stream = open(self.path, "a+b", buffering=0)  # noqa: SIM115
        lock(self._stream)
        damaged.close()

    def _put(self, content: bytes) -> None:
        """Append, safe from a kill when this returns, from a power cut where the last sync is sync_seconds ago; raises
        OSError where not all of it could be written."""
        while content:
            content = content[self._stream.write(content) :]
        if time.monotonic() - self._synced >= self._sync_seconds:
            os.fsync(self._stream.fileno())
            self._synced = time.monotonic()

    def get(self, run: str) -> dict | None:
        return self.found.get(run)

    def add(self, run: str, result: dict) -> None:
        """Several threads may add."""
        line = json.dumps(valid(run, result)).encode() + b"\n"
        try:
            with self._lock:
                self._put(line)
        except OSError as error:
            raise OutputError("journal_not_writable", reason=error.strerror, place=(self.path,)) from None

    def close(self) -> None:
        self._stream.close()

    def remove(self) -> None:
        """The batch is done: where the system can, the file goes while nobody else can hold it, and only while it is
        the one that was opened."""
        remove_held(self._stream, self.path)


def remove_held(stream, path: Path) -> None:
    """Remove a file that is held open, unless another one has its name, and let it go."""
    mine = is_at(stream, path)
    if os.name == "nt":
        stream.close()
    with contextlib.suppress(OSError):
        if mine:
            path.unlink(missing_ok=True)
    stream.close()


def entries_of(path: Path) -> tuple[dict, dict[str, dict], int]:
    """(first line, results by key, count of damaged lines) of a journal that nobody writes any more. Raises InputError
    for a file that cannot be read or is no journal."""
    try:
        with open_regular(path) as stream:
            own = ours(stream.read(HEAD_BYTES)) and os.fstat(stream.fileno()).st_size <= MOST_BYTES
            stream.seek(0)
            content = stream.read() if own else b""
    except OSError as error:
        raise InputError("unreadable", reason=error.strerror, place=(path,)) from None
    if not own:
        raise InputError("part_of_another", path=path)
    head, *lines = map(parsed, content.removesuffix(b"\n").split(b"\n"))
    good = [line for line in lines if line and line.get("hash") == hash_of(line)]
    return head or {}, {line["run"]: line["result"] for line in good}, len(lines) - len(good)


HEAD_BYTES, MOST_BYTES = 200, 1_000_000_000
"""HEAD_BYTES: bytes looked at first of what should be a journal. MOST_BYTES: those of the largest, of the walls of a
case that is held at once."""

HEAD = "Ribalta journal"
"""The key of the first line: no other program's file begins with it."""


def ours(content: bytes) -> bool:
    """Whether a file is a journal, or what a kill left of the first line of one."""
    start = b'{"' + HEAD.encode() + b'": "'
    return content[: len(start)] == start[: len(content)]


def is_at(stream, path: Path) -> bool:
    """Whether this name still is the file that was opened: another batch may have removed it in between."""
    try:
        return os.path.samestat(os.fstat(stream.fileno()), path.stat())
    except OSError:
        return False


def _set_aside(path: Path, content: bytes) -> Path:
    """The file that now holds this: `<path>.old`, or the first of `.old2`, `.old3`, ... that is not there."""
    for end in itertools.chain([""], map(str, itertools.count(2))):
        place = path.with_name(f"{path.name}.old{end}")
        try:
            stream = open(place, "xb")  # noqa: SIM115
        except FileExistsError:
            continue
        with stream:
            stream.write(content)
            stream.flush()
            os.fsync(stream.fileno())
        break
    return place


def lock(stream) -> None:
    """Hold a file for this process alone, until it is closed; raises OSError where another one does."""
    if sys.platform == "win32":
        import msvcrt

        stream.seek(0)
        msvcrt.locking(stream.fileno(), msvcrt.LK_NBLCK, 1)
    else:
        import fcntl

        fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)


def parsed(line: bytes) -> dict | None:
    """Read the entry of a line; None where it is none."""
    try:
        entry = json.loads(line)
    except (ValueError, RecursionError):
        return None
    return entry if isinstance(entry, dict) else None


def valid(run: str | None, result: dict | None) -> dict:
    """Entry of a run, with the hash of its own content."""
    entry = {"run": run, "result": result}
    return {**entry, "hash": hash_of(entry)}


def hash_of(entry: dict) -> str:
    """Hash of the run and the result of a line."""
    content = json.dumps([entry.get("run"), entry.get("result")])
    return hashlib.sha256(content.encode()).hexdigest()[:16]


def rebuilt(kind: Any, value: Any) -> Any:
    """Rebuild a dataclass from the JSON of its `asdict`: doubles are exact there, tuples are lists. None where the
    value is None or not of this kind."""
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


class Memory:
    """Finished runs and checks of one process by key, for the studies that follow; as a Journal, but not on disk.

    most : room, of a run the digits of its survival map, of a check the letters of all it holds; the oldest go first
    analyses : made by all runs added so far
    Several threads may add.
    """

    def __init__(self, most: int = 20_000_000):
        self.most, self.found = most, {}
        self.size = self.analyses = 0
        self._lock = threading.Lock()

    def get(self, run: str) -> dict | None:
        return self.found.get(run)

    def add(self, run: str, result: dict) -> None:
        with self._lock:
            self.found[run] = result
            self.analyses += result.get("analyses", 0)
            self.size += _room(result)
            while self.size > self.most:
                self.size -= _room(self.found.pop(next(iter(self.found))))

    def close(self) -> None:
        """Nothing is open."""
