"""Files that are whole or not there: temporary file, fsync, replace."""

import contextlib
import os
import tempfile
from pathlib import Path

from core.errors import OutputError


def check_folder(folder: Path) -> list[Path]:
    """Create the folder if need be and prove that files can be made there; raises OutputError.

    Returns the folders that were not there before, the deepest first.
    """
    new = [place for place in (folder, *folder.parents) if not place.exists()]
    try:
        folder.mkdir(parents=True, exist_ok=True)
        tempfile.TemporaryFile(dir=folder).close()
    except OSError as error:
        raise OutputError(
            f"{folder}: the output folder cannot be written ({error.strerror}): "
            "name another with --output"
        ) from None
    return new


def write(files: dict[Path, bytes]) -> None:
    """Write all files, or none: every one is on disk beside its place before any takes it, and if one
    cannot take its place those before it are put back.

    Links are followed, so that the file behind is replaced. Raises OutputError; old files stay.
    """
    temporary: list[tuple[str, str]] = []
    replaced: list[tuple[str | None, str]] = []
    path = None
    try:
        for path, content in files.items():
            target = os.path.realpath(path)
            name = _beside(target, content)
            temporary.append((name, target))
            os.chmod(name, _mode(target))
        for name, target in temporary:
            path, old = target, None
            if os.path.isfile(target):
                with open(target, "rb") as stream:
                    old = _beside(target, stream.read())
            replaced.append((old, target))
            os.replace(name, target)
        replaced = [(old, "") for old, _ in replaced]
    except OSError as error:
        raise OutputError(
            f"{path}: cannot be written ({error.strerror}): close it if it is open elsewhere, free "
            "some space, or name another folder with --output; earlier results are untouched, the "
            "finished runs are kept for --resume"
        ) from None
    finally:
        for old, target in replaced:
            with contextlib.suppress(OSError):
                if target and old:
                    os.chmod(old, _mode(target))
                    os.replace(old, target)
                elif target and os.path.isfile(target):
                    os.unlink(target)
                elif old:
                    os.unlink(old)
        for name, _ in temporary:
            with contextlib.suppress(OSError):
                os.unlink(name)


def _beside(target: str, content: bytes) -> str:
    """A temporary file in the target's folder, on disk; deleted if it cannot be written whole."""
    handle, name = tempfile.mkstemp(dir=os.path.dirname(target), prefix=".ribalta-")
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(content)
            stream.flush()
            os.fsync(stream.fileno())
    except OSError:
        os.unlink(name)
        raise
    return name


def _mode(target: str) -> int:
    """Permissions of the file that is replaced, else those a new file gets."""
    with contextlib.suppress(OSError):
        return os.stat(target).st_mode & 0o777
    mask = os.umask(0)
    os.umask(mask)
    return 0o666 & ~mask
