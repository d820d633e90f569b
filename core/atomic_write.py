"""Files that are whole or not there: temporary file, fsync, replace."""

import contextlib
import errno
import functools
import hashlib
import json
import os
import platform
import re
import shutil
import sys
import tempfile
import time
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import BinaryIO

from core.errors import OutputError

PREFIX, COMMIT = ".ribalta-", ".commit"
"""PREFIX begins the names of temporary files: prefix, machine, number of the process, chance. COMMIT ends that of the
list of moves under way, and of the files that lead to it."""

_NAME = re.compile(re.escape(PREFIX) + r"([0-9a-f]{8})-([0-9]+)-")

OTHERS_AFTER = 86400.0
"""Whether a process of another machine runs cannot be told: what it left is its own for this time [s]."""


Content = bytes | Callable[[BinaryIO], None]
"""What is written into a file: its bytes, or a function that writes them into a stream, for a file larger than the
memory should be."""


@functools.cache
def machine() -> str:
    """Short name of this machine, without the marks of a file's name."""
    return hashlib.sha256(platform.node().encode()).hexdigest()[:8]


def check_folder(folder: Path) -> list[Path]:
    """Create the folder if need be and prove that files can be made there; raises OutputError.

    Returns the folders that were not there before, the deepest first.
    """
    new: list[Path] = []
    try:
        new = [place for place in (folder, *folder.parents) if not place.exists()]
        folder.mkdir(parents=True, exist_ok=True)
        clean(folder)
        _remove(_beside(str(folder / "x"), b"x"))
    except OSError as error:
        for place in new:
            with contextlib.suppress(OSError):
                place.rmdir()
        raise OutputError("folder_not_writable", reason=error.strerror, place=(folder,)) from None
    return new


def write(files: Mapping[Path, Content]) -> None:
    """Write all files, or none, in whatever folders: every one is on disk beside its place before any takes it, and if
    one cannot take its place those before it are put back. A kill between two of them is finished by the next `clean`
    of any of the folders, from a list that is on disk before the first.

    Links are followed, so that the file behind is replaced. Raises OutputError: old files stay, or, where one cannot be
    put back, it says which are new.
    """
    moves: dict[str, str] = {}
    old: dict[str, str | None] = {}
    taken: list[str] = []
    leads: list[str] = []
    path = None
    failed: OSError | None = None
    done = False
    try:
        for path, content in files.items():
            target = os.path.realpath(path)
            clean(Path(target).parent)
            name = _beside(target, content)
            moves[name] = target
            os.chmod(name, _mode(target))
        for target in moves.values():
            path, old[target] = target, None
            if os.path.isfile(target):
                old[target] = _beside(target, functools.partial(_copy, target))
        if len(moves) > 1:
            _list_moves(moves, old, leads)
        for name, target in moves.items():
            path = target
            os.replace(name, target)
            taken.append(target)
        for folder in _folders(moves):
            _sync_folder(folder)
        done = True
    except OSError as error:
        failed = error
    finally:
        if not done:  # a kill from here on must not finish what is taken back
            _remove_all(reversed(leads))
            taken = [target for target in taken if not _put_back(target, old[target])]
        _remove_all((*leads, *old.values(), *moves))
    if failed and taken:
        raise OutputError("files_mixed", reason=failed.strerror, new=", ".join(taken), place=(path,)) from None
    if failed:
        raise OutputError("file_not_writable", reason=failed.strerror, place=(path,)) from None


def _folders(moves: dict[str, str]) -> list[str]:
    return list(dict.fromkeys(os.path.dirname(target) for target in moves.values()))


def _content(path: str | Path) -> bytes:
    with open(path, "rb") as stream:
        return stream.read()


def _copy(path: str, stream: BinaryIO) -> None:
    with open(path, "rb") as source:
        shutil.copyfileobj(source, stream)


def _list_moves(moves: dict[str, str], old: dict[str, str | None], made: list[str]) -> None:
    """Put the list of moves on disk: from then on a kill is finished, before it is undone. In the first folder lies
    the list, in each other one the way to it. made : takes the files in the order they may be missing.

    A name of the list's own folder is bare, whatever that is called later, one of another absolute. With it goes the
    hash of the file that is replaced, so that a late start takes back nothing that was written since.
    """
    first, *others = _folders(moves)
    entries: list[list[str | None]] = [
        [
            *(os.path.basename(part) if os.path.dirname(target) == first else part for part in (name, target)),
            _hash_of(target) if old[target] else None,
        ]
        for name, target in moves.items()
    ]
    unnamed = _beside(os.path.join(first, "x"), json.dumps(entries).encode())
    made.append(unnamed)
    listed = unnamed + COMMIT
    for folder in others:
        made.append(_beside(os.path.join(folder, "x"), json.dumps(listed).encode(), COMMIT))
    for folder in _folders(moves):
        _sync_folder(folder)
    made.append(listed)
    os.replace(unnamed, listed)


def _put_back(target: str, earlier: str | None) -> bool:
    """Whether a file that took its place is as it was again."""
    try:
        if earlier:
            os.chmod(earlier, _mode(target))
            os.replace(earlier, target)
        else:
            os.unlink(target)
    except OSError:
        return False
    return True


def clean(folder: Path) -> None:
    """Finish or remove what a killed process left in a folder."""
    with contextlib.suppress(OSError):
        left = [path for path in folder.glob(f"{PREFIX}*-*") if not _in_use(path)]
        waiting = {_owner(path) for path in left if path.name.endswith(COMMIT) and not _finish(path)}
        for path in left:
            if _owner(path) not in waiting:
                with contextlib.suppress(OSError):
                    path.unlink()


def _owner(path: Path) -> str:
    """Beginning of the name of a temporary file, common to all of its process; "" for any other file."""
    named = _NAME.match(path.name)
    return named[0] if named else ""


def _finish(listed: Path) -> bool:
    """Make the moves of a list that a kill interrupted; only temporary files of the same process, each to a name of
    its own folder. False where another folder cannot be reached now: the files wait for it."""
    with contextlib.suppress(OSError, ValueError, TypeError, AttributeError):
        moves = json.loads(_content(listed))
        if isinstance(moves, str):
            other = Path(moves)
            if not other.is_absolute() or _owner(other) != _owner(listed):
                return True
            if not other.parent.is_dir():
                return False
            listed, moves = other, json.loads(_content(other))
        ahead = []
        for name, target, earlier in moves:
            source, place = listed.parent / name, listed.parent / target
            if not place.parent.is_dir():
                return False
            if _owner(source) == _owner(listed) and source.parent == place.parent and source.is_file():
                ahead.append((source, place, earlier))
        # nothing that was written since by somebody else is replaced
        if all(_hash_of(place) == earlier for _, place, earlier in ahead):
            for source, place, _ in ahead:
                os.replace(source, place)
        listed.unlink()
    return True


def _hash_of(path: str | Path) -> str | None:
    """SHA-256 of what a file holds; None where there is no file."""
    try:
        with open(path, "rb") as stream:
            return hashlib.file_digest(stream, "sha256").hexdigest()
    except FileNotFoundError:
        return None


def _in_use(path: Path) -> bool:
    """Whether the process in the name of a temporary file still runs, as far as can be told; what is no file
    of ours is left alone."""
    named = _NAME.match(path.name)
    if not named or not path.is_file() or path.is_symlink():
        return True
    if named[1] == machine():
        return alive(int(named[2]))
    return abs(time.time() - path.stat().st_mtime) < OTHERS_AFTER


def alive(number: int) -> bool:
    """Whether a process of this number runs."""
    if number == os.getpid():
        return True
    if sys.platform == "win32":
        import ctypes

        handle = ctypes.windll.kernel32.OpenProcess(0x1000, False, number)
        if handle:
            ctypes.windll.kernel32.CloseHandle(handle)
        return bool(handle)
    try:
        os.kill(number, 0)
    except (ProcessLookupError, OverflowError):
        return False
    except PermissionError:
        return True
    return True


def _sync_folder(folder: str) -> None:
    """Put the names of a folder on disk (fsync); some systems cannot, and nothing is done there."""
    if os.name == "nt":
        return
    try:
        handle = os.open(folder, os.O_RDONLY)
    except PermissionError:
        return
    try:
        os.fsync(handle)
    except OSError as error:
        if error.errno not in (errno.EINVAL, errno.ENOTSUP, errno.EACCES):
            raise
    finally:
        os.close(handle)


def _beside(target: str, content: Content, end: str = "") -> str:
    """Write a temporary file in the target's folder, on disk, and return its name; it is deleted if it cannot be
    written whole."""
    handle, name = tempfile.mkstemp(
        dir=os.path.dirname(target), prefix=f"{PREFIX}{machine()}-{os.getpid()}-", suffix=end
    )
    with contextlib.ExitStack() as unfinished:
        unfinished.callback(_remove, name)
        with os.fdopen(handle, "wb") as stream:
            if callable(content):
                content(stream)
            else:
                stream.write(content)
            stream.flush()
            os.fsync(stream.fileno())
        unfinished.pop_all()
    return name


def _remove_all(names: Iterable[str | None]) -> None:
    for name in names:
        if name:
            _remove(name)


def _remove(name: str) -> None:
    """Delete a temporary file; what a passing fault leaves is tried once more, the rest goes with `clean`."""
    for _ in range(2):
        try:
            os.unlink(name)
        except FileNotFoundError:
            return
        except OSError:
            continue
        return


def _mode(target: str) -> int:
    """Permissions of the file that is replaced, else those a new file gets."""
    with contextlib.suppress(OSError):
        return os.stat(target).st_mode & 0o777
    mask = os.umask(0)
    os.umask(mask)
    return 0o666 & ~mask
