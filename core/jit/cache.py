"""Cache folder of the machine code of compiled kernels.

numba's own cache misses changes in other files, depends on the working directory when frozen, and a
damaged file kills the start. Here: one folder per user and per state of the sources, 0700, every file
checked against a hash before numba may load it. RIBALTA_CACHE names another folder.
"""

import atexit
import hashlib
import json
import os
import re
import shutil
import sys
import tempfile
import time
from pathlib import Path

from core.jit import shipped, trial
from core.jit.stamp import once_for_all, stamp

MANIFEST = "manifest.json"

KEEP_SECONDS = 30 * 86400
"""Caches of other versions are deleted after this time."""


def user_folder() -> Path:
    """Folder of this user's caches, by the custom of the system."""
    if os.environ.get("RIBALTA_CACHE"):
        return Path(os.environ["RIBALTA_CACHE"])
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA", Path.home())) / "Ribalta"
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Caches" / "Ribalta"
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "ribalta"


TEMPORARY = "ribalta-kernels-"
"""How the name of a folder begins that goes with its process."""


def private(folder: Path) -> bool:
    """Whether only this user can write in a folder."""
    return folder.is_dir() and shipped.only_own(folder)


def _left_by_this_program(folder: Path) -> bool:
    """Whether a folder is of a version long unused, and nothing else, by its name, its files and its time."""
    # with a level until 0.30
    named = re.fullmatch(r"kernels-[0-9a-f]{16}(-x86-64(-v[34])?|-znver3)?(-own)?", folder.name)
    unused = time.time() - folder.lstat().st_mtime > KEEP_SECONDS
    return bool(named and unused and private(folder)) and all(
        file.suffix in (".nbi", ".nbc") or file.name.startswith((MANIFEST, "trial", trial.PASSED, trial.WRONG))
        for file in folder.iterdir()
    )


def prepare(base: Path | None, name: str) -> Path:
    """The cache folder of this name, checked; a temporary one where the user's is unwritable or not private, or the
    user has none."""
    try:
        if base is None:
            raise OSError
        folder = base / f"kernels-{name}"
        folder.mkdir(parents=True, exist_ok=True, mode=0o700)
        if private(folder):
            tempfile.TemporaryFile(dir=folder).close()
            for old in base.glob("kernels-*"):
                if old != folder and _left_by_this_program(old):
                    shutil.rmtree(old, ignore_errors=True)
            drop_damaged(folder)
            return folder
    except OSError:
        pass
    return Path(tempfile.mkdtemp(prefix=TEMPORARY))


def _hashes(folder: Path) -> dict[str, str]:
    files = sorted(file for file in folder.glob("*.nb[ic]") if file.is_file())
    return {file.name: hashlib.sha256(file.read_bytes()).hexdigest() for file in files}


def drop_damaged(folder: Path) -> None:
    """Delete what is not as this program left it: numba then compiles it again."""
    try:
        known = json.loads(_content(folder / MANIFEST))
    except (ValueError, RecursionError):
        known = {}
    for odd in folder.iterdir():
        if not odd.is_file():  # a pipe or a folder, at which a program could wait for ever
            if odd.is_dir() and not odd.is_symlink():
                shutil.rmtree(odd, ignore_errors=True)
            else:
                odd.unlink(missing_ok=True)
    for name, digest in _hashes(folder).items():
        if not isinstance(known, dict) or known.get(name) != digest:
            (folder / name).unlink(missing_ok=True)


_recorded: dict[Path, int] = {}
"""Folder -> its time when its hashes were found written: a file that comes to it changes that."""


def record(folder: Path) -> None:
    """Write the hashes of the cache's files, atomically."""
    try:
        changed = folder.stat().st_mtime_ns if folder.exists() else None
        if changed is None or _recorded.get(folder) == changed:
            return
        content = json.dumps(_hashes(folder)).encode()
        if content == _content(folder / MANIFEST):
            _recorded[folder] = changed
            return
        temporary = folder / f"{MANIFEST}.{os.getpid()}"
        temporary.write_bytes(content)
        os.replace(temporary, folder / MANIFEST)
    except OSError:
        pass


def _content(path: Path) -> bytes:
    return path.read_bytes() if path.is_file() else b""


SECOND_PROCESS = "RIBALTA_SECOND_PROCESS"
"""Variable of the process that core.study.precompile starts; it names the folder of the process that started it,
which also closes the folder."""


@once_for_all
def folder() -> Path:
    """The folder of this process, made and checked with the first kernel that is needed."""
    if SECOND_PROCESS in os.environ:
        return Path(os.environ[SECOND_PROCESS])
    atexit.register(close)
    try:
        base = user_folder()
    except RuntimeError:  # no home
        base = None
    return prepare(base, stamp())


def close() -> None:
    """Before the process ends: keep what was compiled, and delete a folder of this process alone."""
    if SECOND_PROCESS in os.environ or not folder.is_made():
        return
    record(folder())
    trial.withdraw()
    if folder().name.startswith(TEMPORARY):
        shutil.rmtree(folder(), ignore_errors=True)


_owned = [False]


def own_process() -> None:
    """Set up numba for this whole process, before it is imported: by the program, whose process it is, and never by the
    library, whose process is somebody else's. It optimises at level 2: at level 1 a processor with vectors of 256 bits
    takes longer for the loops of the lanes, at 3 a cold start is longer (resources/docs/speed.md)."""
    _owned[0] = True
    os.environ.setdefault("NUMBA_OPT", "2")
    if shipped.FORCED_LEVEL in os.environ:
        os.environ.setdefault("NUMBA_CPU_NAME", os.environ[shipped.FORCED_LEVEL])
        os.environ.setdefault("NUMBA_CPU_FEATURES", "")


def owns_process() -> bool:
    """Whether this process is the program's."""
    return _owned[0]
