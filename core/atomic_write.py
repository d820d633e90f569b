"""Files that are whole or not there: temporary file, fsync, replace."""

import contextlib
import errno
import json
import os
import sys
import tempfile
from pathlib import Path

from core.errors import OutputError

PREFIX, COMMIT = ".ribalta-", ".commit"
"""Names of temporary files: prefix, number of the process, chance; and of the list of moves under way."""


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


def write(files: dict[Path, bytes]) -> None:
    """Write all files, or none: every one is on disk beside its place before any takes it, and if one
    cannot take its place those before it are put back. A kill between two of them is finished by the next
    `clean` of the folder, from a list that is on disk before the first.

    Links are followed, so that the file behind is replaced. Raises OutputError; old files stay.
    """
    moves: dict[str, str] = {}
    old: dict[str, str | None] = {}
    path = listed = None
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
                with open(target, "rb") as stream:
                    old[target] = _beside(target, stream.read())
        if len(moves) > 1 and len({os.path.dirname(target) for target in moves.values()}) == 1:
            # bare names: of this folder, whatever it is called later
            names = {os.path.basename(name): os.path.basename(to) for name, to in moves.items()}
            listed = _beside(next(iter(moves.values())), json.dumps(names).encode(), COMMIT)
        for name, target in moves.items():
            path = target
            os.replace(name, target)
        for folder in {os.path.dirname(target) for target in moves.values()}:
            _sync_folder(folder)
        done = True
    except OSError as error:
        raise OutputError("file_not_writable", reason=error.strerror, place=(path,)) from None
    finally:
        if not done and listed:
            _remove(listed)  # first of all: a kill from here on must not finish what is taken back
        for name, target in moves.items():
            if done or os.path.exists(name) or target not in old:
                continue
            with contextlib.suppress(OSError):  # it took its place, and another could not
                if old[target]:
                    os.chmod(old[target], _mode(target))
                    os.replace(old[target], target)
                else:
                    os.unlink(target)
        for name in (listed, *old.values(), *moves):
            if name:
                _remove(name)


def clean(folder: Path) -> None:
    """Finish or remove what a killed process left in a folder."""
    with contextlib.suppress(OSError):
        left = [path for path in folder.glob(f"{PREFIX}*-*") if not _in_use(path)]
        for path in left:
            if path.name.endswith(COMMIT):
                _finish(path)
        for path in left:
            with contextlib.suppress(OSError):
                path.unlink()


def _finish(listed: Path) -> None:
    """Make the moves of a list that a kill interrupted: temporary files of the same process, in this folder."""
    own = listed.name.split("-")[1]
    with contextlib.suppress(OSError, ValueError, AttributeError, TypeError):
        moves = json.loads(listed.read_bytes())
        for name, target in moves.items():
            bare = name == os.path.basename(name) and target == os.path.basename(target)
            source = listed.with_name(name)
            if bare and target and name.startswith(f"{PREFIX}{own}-") and source.is_file():
                os.replace(source, listed.with_name(target))


def _in_use(path: Path) -> bool:
    """Whether the process in the name of a temporary file still runs, as far as can be told; what is no file
    of ours is left alone."""
    number = path.name.removeprefix(PREFIX).split("-")[0]
    if not number.isdigit() or not path.is_file() or path.is_symlink():
        return True
    return alive(int(number))


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
    """The names of a folder on disk; not every system can."""
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


def _beside(target: str, content: bytes, end: str = "") -> str:
    """A temporary file in the target's folder, on disk; deleted if it cannot be written whole."""
    handle, name = tempfile.mkstemp(
        dir=os.path.dirname(target), prefix=f"{PREFIX}{os.getpid()}-", suffix=end
    )
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(content)
            stream.flush()
            os.fsync(stream.fileno())
    except OSError:
        _remove(name)
        raise
    return name


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
