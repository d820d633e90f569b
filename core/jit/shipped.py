"""Machine code that was made before for common processors, so that a first run compiles nothing.

packaging/kernels.py makes it: a library, a folder for each level and an index with the hash of every file. It lies in
`kernels` beside the modules of the frozen program, or in the package `ribalta_kernels` beside llvmlite, where run.py or
pip put its wheel; that one is used only with the sources, packages, Python and system it was made for.
"""

import functools
import hashlib
import json
import os
import platform
import sys
from collections.abc import Collection
from pathlib import Path
from typing import NamedTuple

from core.jit import trial
from core.jit.stamp import stamp

FOLDER = Path(__file__).resolve().parents[2] / "kernels"

PACKAGE = "ribalta_kernels"

INDEX = "index.json"

ROOT = 0
"""Who installs packages for all users of a machine."""

_V3 = {"avx", "avx2", "bmi", "bmi2", "f16c", "fma", "lzcnt", "movbe"}
PROCESSOR_LEVELS = {
    "x86-64-v4": _V3 | {"avx512f", "avx512bw", "avx512cd", "avx512dq", "avx512vl"},
    "znver3": _V3 | {"adx", "aes", "pclmul", "sha", "sse4a", "vaes", "vpclmulqdq"},
    "x86-64-v3": _V3,
    "x86-64": set(),
}
"""What machine code is made for, as LLVM names it -> what a processor must have, the best first: levels of the x86-64
psABI, and Zen 3, the first to have `vaes` beside `sse4a`, which AMD alone has."""

FORCED_LEVEL = "RIBALTA_LEVEL"
"""Variable that names a level to compile for; nothing shipped is used then."""


class Library(NamedTuple):
    """levels : level -> file -> SHA-256; self_test : numbers of core.study.self_test where it was made."""

    folder: Path
    levels: dict[str, dict[str, str]]
    self_test: list[str]


NO_LIBRARY = Library(FOLDER, {}, [])


def only_own(path: Path, *others: int) -> bool:
    """Whether nobody but this user, and these others, can write there: another's file would be run as code."""
    if sys.platform == "win32":
        return True
    state = path.lstat()
    return state.st_uid in (os.getuid(), *others) and not state.st_mode & 0o022


def made_for() -> dict[str, str]:
    """What machine code depends on beside the level: numba's files hold pickles and code of Python."""
    from importlib import metadata  # 40 ms

    versions = {name: metadata.version(name) for name in ("numba", "llvmlite")}
    about = {"kernels": stamp(), "python": str(sys.implementation.cache_tag), "system": sys.platform}
    return about | {"processor": platform.machine().lower()} | versions


def index_of(content: dict) -> bytes:
    """An index, its hash first."""
    text = json.dumps(content, indent=0).encode("ascii")
    return hashlib.sha256(text).hexdigest().encode("ascii") + b"\n" + text


def read(folder: Path) -> tuple[Library, dict[str, str]]:
    """The library of a folder, and what it was made for. Raises OSError, ValueError, LookupError, TypeError."""
    digest, _, text = (folder / INDEX).read_bytes().partition(b"\n")
    if hashlib.sha256(text).hexdigest().encode("ascii") != digest:
        raise ValueError
    known = json.loads(text)
    return Library(folder, dict(known["levels"]), list(known["self_test"])), known["made_for"]


@functools.cache
def library() -> Library:
    """The library of this program: without levels where there is none, or one for something else or damaged, or
    where somebody else can write; and where nothing would try it, as in a process that calls kernels by itself."""
    if not trial.self_test:
        return NO_LIBRARY
    try:
        if FOLDER.is_dir():  # a part of the program
            return read(FOLDER)[0]
        import llvmlite

        folder = Path(llvmlite.__file__).resolve().parents[1] / PACKAGE
        if folder.is_dir() and only_own(folder, ROOT) and only_own(folder / INDEX, ROOT):
            shipped, purpose = read(folder)
            return shipped if purpose == made_for() else NO_LIBRARY
    except (OSError, ValueError, LookupError, TypeError, RecursionError, ImportError):
        pass
    return NO_LIBRARY


def best_of(levels: Collection[str]) -> str:
    """The best of these levels that this processor has; "" where it has none."""
    if platform.machine().lower() not in ("x86_64", "amd64") or not levels:
        return ""
    from llvmlite.binding import get_host_cpu_features

    has = {name for name, there in get_host_cpu_features().items() if there}
    return next((name for name in PROCESSOR_LEVELS if name in levels and has >= PROCESSOR_LEVELS[name]), "")


def level() -> str:
    """The best level of this processor that machine code was shipped for; "" where there is none: numba then compiles
    for the very processor."""
    return os.environ[FORCED_LEVEL] if FORCED_LEVEL in os.environ else best_of(library().levels)


def has_wide_vectors() -> bool:
    """Whether kernels are compiled for vector registers of 512 bits, of which there are 32."""
    if level():
        return level() == "x86-64-v4"
    from llvmlite.binding import get_host_cpu_features

    return bool(get_host_cpu_features().get("avx512vl"))


def whole_files(name: str) -> dict[str, bytes]:
    """File name -> content of the machine code shipped for a level; none where one is missing or damaged, or another
    can write there."""
    shipped, files = library(), {}
    if FORCED_LEVEL in os.environ:
        return {}
    try:
        for file, digest in shipped.levels.get(name, {}).items():
            path = shipped.folder / name / Path(file).name
            content = path.read_bytes()
            own = shipped.folder == FOLDER or (only_own(path.parent, ROOT) and only_own(path, ROOT))
            if not own or hashlib.sha256(content).hexdigest() != digest:
                return {}
            files[path.name] = content
    except (OSError, ValueError, TypeError, AttributeError):
        return {}
    return files
