"""The decorator of every compiled kernel, and where its machine code is kept.

numba's own cache misses changes in other files, depends on the working directory when frozen, and a
damaged file kills the start. Here: one folder per user and per state of the sources, 0700, every file
checked against a hash before numba may load it. RIBALTA_CACHE names another folder.
"""

import atexit
import hashlib
import json
import os
import shutil
import sys
import tempfile
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
    folder = Path(tempfile.mkdtemp(prefix="ribalta-kernels-"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return folder


def _hashes(folder: Path) -> dict[str, str]:
    files = sorted(folder.glob("*.nb[ic]"))
    return {file.name: hashlib.sha256(file.read_bytes()).hexdigest() for file in files}


def drop_damaged(folder: Path) -> None:
    """Delete what is not as this program left it: numba then compiles it again."""
    try:
        known = json.loads((folder / MANIFEST).read_bytes())
    except (OSError, ValueError):
        known = {}
    for name, digest in _hashes(folder).items():
        if not isinstance(known, dict) or known.get(name) != digest:
            (folder / name).unlink(missing_ok=True)


def record(folder: Path) -> None:
    """Write the hashes of the cache's files, atomically."""
    try:
        content = json.dumps(_hashes(folder))
        if not folder.exists() or content == _text(folder / MANIFEST):
            return
        temporary = folder / f"{MANIFEST}.{os.getpid()}"
        temporary.write_text(content)
        os.replace(temporary, folder / MANIFEST)
    except OSError:
        pass


def _text(path: Path) -> str:
    return path.read_text() if path.exists() else ""


STAMP = source_stamp()
FOLDER = prepare(user_folder(), STAMP)
atexit.register(record, FOLDER)

os.environ.setdefault(
    "NUMBA_CACHE_LOCATOR_CLASSES",
    f"{__name__}.Locator,InTreeCacheLocator,UserWideCacheLocator,IPythonCacheLocator",
)

from numba import njit, types  # noqa: E402  (the locator must be named before numba is imported)
from numba.core.caching import _CacheLocator  # noqa: E402
from numba.core.registry import CPUDispatcher  # noqa: E402
from numba.extending import lower_builtin, type_callable  # noqa: E402


class Locator(_CacheLocator):
    """Puts the machine code of this program's kernels into FOLDER, under their module's name."""

    def __init__(self, py_func):
        self._place = f"{py_func.__module__}-{py_func.__code__.co_firstlineno}"

    def get_cache_path(self):
        return str(FOLDER)

    def get_source_stamp(self):
        return STAMP

    def get_disambiguator(self):
        return self._place

    @classmethod
    def from_function(cls, py_func, py_file):
        return cls(py_func) if py_func.__module__.startswith("core.") else None


OPTIONS = {"cache": True, "nogil": True, "error_model": "numpy"}
NO_DOORS = {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}
DOORS = dict.fromkeys(NO_DOORS, False)

kernel = njit(forceinline=False, **DOORS, **OPTIONS)
"""Compiled once per machine; no lock held while it runs; never fastmath, never parallel. An option not set
here would be inherited from the kernel whose compilation asks for this one."""


class Doorless(CPUDispatcher):
    """A kernel for other kernels alone: the doors by which Python calls one take longer to compile than most
    of the code behind them. Called from Python it runs as Python."""

    def __call__(self, *arguments):
        return self.py_func(*arguments)


def _doorless(forceinline: bool):
    def decorate(function):
        made = njit(forceinline=forceinline, **NO_DOORS, **OPTIONS)(function)
        if isinstance(made, CPUDispatcher):  # not so where NUMBA_DISABLE_JIT is set
            made.__class__ = Doorless
        return made

    return decorate


subkernel = _doorless(False)
"""A kernel for other kernels alone, see `Doorless`."""

inner_kernel = _doorless(True)
"""A subkernel that becomes part of its callers, so that their loops can use vector instructions."""


def widest_vectors() -> None:
    """Called in a kernel: its loops use the widest vector registers of the processor. LLVM keeps to half of
    them on some processors, and the bare arithmetic of the lanes then takes nearly twice as long."""


@type_callable(widest_vectors)
def _nothing(context):
    return lambda: types.none


@lower_builtin(widest_vectors)
def _mark_function(context, builder, signature, arguments):
    builder.function.attributes.add("noinline")
    # llvmlite's list of known attributes lacks this one
    set.add(builder.function.attributes, '"prefer-vector-width"="512"')
    return context.get_dummy_value()
