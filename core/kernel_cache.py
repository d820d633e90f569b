"""The decorators of compiled kernels, and where their machine code is kept.

numba's own cache misses changes in other files, depends on the working directory when frozen, and a
damaged file kills the start. Here: one folder per user and per state of the sources, 0700, every file
checked against a hash before numba may load it. RIBALTA_CACHE names another folder.
"""

import atexit
import functools
import hashlib
import json
import os
import shutil
import sys
import tempfile
import threading
import time
from pathlib import Path

from core.version import VERSION

MANIFEST = "manifest.json"

KEEP_SECONDS = 30 * 86400
"""Caches of other versions are deleted after this time."""


def source_stamp() -> str:
    """Hash of all sources a kernel may come from; of the program file when frozen."""
    digest = hashlib.sha256(VERSION.encode())
    if getattr(sys, "frozen", False):
        state = os.stat(sys.executable)
        digest.update(f"{state.st_size} {state.st_mtime_ns}".encode())
    else:
        for source in sorted(Path(__file__).parent.rglob("*.py")):
            digest.update(source.read_bytes())
    return digest.hexdigest()[:16]


def user_folder() -> Path:
    """Folder of this user's caches, by the custom of the system."""
    if "RIBALTA_CACHE" in os.environ:
        return Path(os.environ["RIBALTA_CACHE"])
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA", Path.home())) / "Ribalta"
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Caches" / "Ribalta"
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "ribalta"


TEMPORARY = "ribalta-kernels-"
"""How the name of a folder begins that goes with its process."""


def private(folder: Path) -> bool:
    """Whether only this user can write there: another's file would be run as code."""
    if sys.platform == "win32":
        return True
    state = folder.lstat()
    return folder.is_dir() and state.st_uid == os.getuid() and not state.st_mode & 0o022


def prepare(base: Path, stamp: str) -> Path:
    """The cache folder, checked; a temporary one where the user's is unwritable or not private."""
    folder = base / f"kernels-{stamp}"
    try:
        folder.mkdir(parents=True, exist_ok=True, mode=0o700)
        if private(folder):
            tempfile.TemporaryFile(dir=folder).close()
            for old in base.glob("kernels-*"):
                unused = time.time() - old.stat().st_mtime > KEEP_SECONDS
                if old != folder and unused and private(old):
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
            shutil.rmtree(odd) if odd.is_dir() and not odd.is_symlink() else odd.unlink()
    for name, digest in _hashes(folder).items():
        if not isinstance(known, dict) or known.get(name) != digest:
            (folder / name).unlink(missing_ok=True)


def record(folder: Path) -> None:
    """Write the hashes of the cache's files, atomically."""
    try:
        content = json.dumps(_hashes(folder)).encode()
        if not folder.exists() or content == _content(folder / MANIFEST):
            return
        temporary = folder / f"{MANIFEST}.{os.getpid()}"
        temporary.write_bytes(content)
        os.replace(temporary, folder / MANIFEST)
    except OSError:
        pass


def _content(path: Path) -> bytes:
    return path.read_bytes() if path.is_file() else b""


BESIDE = "RIBALTA_KERNELS_BESIDE"
"""Names the folder of the process that started this one, see core.compile_beside, which also closes it."""

STAMP = source_stamp()
FOLDER = Path(os.environ[BESIDE]) if BESIDE in os.environ else prepare(user_folder(), STAMP)


@atexit.register
def close() -> None:
    """Before the process ends: what is compiled is kept, but for a folder of this process alone."""
    if BESIDE in os.environ:
        return
    record(FOLDER)
    if FOLDER.name.startswith(TEMPORARY):
        shutil.rmtree(FOLDER, ignore_errors=True)


os.environ.setdefault(
    "NUMBA_CACHE_LOCATOR_CLASSES",
    "core.numba_kernels.Locator,InTreeCacheLocator,UserWideCacheLocator,IPythonCacheLocator",
)
# the code is as fast as with 3 (measured), and is there a sixth sooner
os.environ.setdefault("NUMBA_OPT", "1")

_lock = threading.RLock()


class Kernel:
    """A function that numba compiles, or takes from FOLDER, when it is first called; until then numba need
    not be there: it takes a third of the window's start.

    inlined : becomes part of its callers, so that their loops can use vector instructions; doors : whether
    Python may call the compiled code. Those doors take longer to compile than most kernels; without them a
    call from Python runs the function as Python; awaited : called before it is compiled or loaded.
    """

    def __init__(self, function, inlined: bool, doors: bool, awaited=lambda: None):
        functools.update_wrapper(self, function)
        self.py_func, self.inlined, self.doors = function, inlined, doors
        self._awaited, self._dispatcher = awaited, None

    @property
    def dispatcher(self):
        """numba's object of this kernel; to be called from Python only where there are doors."""
        if self._dispatcher is None:
            self._awaited()
            with _lock:
                from core.numba_kernels import compiled

                if self._dispatcher is None:
                    self._dispatcher = compiled(self.py_func, self.inlined, self.doors)
        return self._dispatcher

    def __call__(self, *arguments):
        return self.dispatcher(*arguments) if self.doors else self.py_func(*arguments)


kernel = functools.partial(Kernel, inlined=False, doors=True)
"""A kernel that Python calls."""

subkernel = functools.partial(Kernel, inlined=False, doors=False)
"""A kernel that kernels call."""

inner_kernel = functools.partial(Kernel, inlined=True, doors=False)
"""A kernel that becomes part of the kernels that call it."""


def widest_vectors() -> None:
    """Called in a kernel: its loops use the widest vector registers of the processor. LLVM keeps to half of
    them on some processors, and the bare arithmetic of the lanes then takes nearly twice as long."""
