"""Machine code that was made before for common processors, so that a run compiles nothing.

packaging/kernels.py makes it: a shared library for each level, and an index with their hashes and what each kernel
is called in them. It lies in `kernels` beside the modules of the frozen program, or in the package `ribalta_kernels`
beside numpy, where run.py or pip put its wheel; that one is used only with the sources and the system it was made for.
"""

import ctypes
import functools
import hashlib
import json
import os
import platform
import re
import sys
from collections.abc import Collection
from pathlib import Path
from typing import NamedTuple

import numpy as np

from core.jit import trial
from core.jit.stamp import stamp

FOLDER = Path(__file__).resolve().parents[2] / "kernels"

PACKAGE = "ribalta_kernels"

INDEX = "index.json"

ROOT = 0
"""Who installs packages for all users of a machine."""

_V3 = {"avx", "avx2", "bmi", "bmi2", "f16c", "fma", "lzcnt", "movbe"}
PROCESSOR_LEVELS: dict[str, set[str]] = {
    "x86-64-v4": _V3 | {"avx512f", "avx512bw", "avx512cd", "avx512dq", "avx512vl"},
    "znver3": _V3 | {"adx", "aes", "pclmul", "sha", "sse4a", "vaes", "vpclmulqdq"},
    "x86-64-v3": _V3,
    "x86-64": set(),
}
"""What machine code is made for, as LLVM names it -> what a processor must have, the best first: levels of the x86-64
psABI, and Zen 3, the first to have `vaes` beside `sse4a`, which AMD alone has."""

OF_ARM = "generic"
"""The level of the other processors."""

_FLAGS = {"abm": "lzcnt", "bmi1": "bmi", "pclmulqdq": "pclmul", "sha_ni": "sha"}
"""Flags of a processor as Linux names them -> as LLVM does, where these differ."""

FORCED_LEVEL = "RIBALTA_LEVEL"
"""Variable that names a level to compile for; nothing shipped is used then."""


class Library(NamedTuple):
    """levels : level -> SHA-256 of its file, the best first; self_test : numbers of core.study.self_test where it was
    made; kernels : name -> types of its arguments -> its name in the files, the letters of its result, and of each
    array "r" or "w": whether it is written."""

    folder: Path
    levels: dict[str, str]
    self_test: list[str]
    kernels: dict[str, dict[str, list[str]]]


NO_LIBRARY = Library(FOLDER, {}, [], {})


def only_own(path: Path, *others: int) -> bool:
    """Whether nobody but this user, and these others, can write there: another's file would be run as code."""
    if sys.platform == "win32":
        return True
    state = path.lstat()
    return state.st_uid in (os.getuid(), *others) and not state.st_mode & 0o022


def made_for() -> dict[str, str]:
    """What machine code depends on beside the level."""
    return {"kernels": stamp(), "system": sys.platform, "processor": platform.machine().lower()}


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
    made = Library(folder, dict(known["levels"]), list(known["self_test"]), dict(known["kernels"]))
    return made, known["made_for"]


@functools.cache
def library() -> Library:
    """The library of this program: without levels where there is none, or one for something else or damaged, or
    where somebody else can write; and where nothing would try it, as in a process that calls kernels by itself."""
    if not trial.self_test:
        return NO_LIBRARY
    try:
        folder = FOLDER if FOLDER.is_dir() else Path(np.__file__).resolve().parents[1] / PACKAGE
        own = folder == FOLDER or (only_own(folder, ROOT) and only_own(folder / INDEX, ROOT))
        if folder.is_dir() and own:
            shipped, purpose = read(folder)
            return shipped if purpose == made_for() else NO_LIBRARY
    except (OSError, ValueError, LookupError, TypeError, RecursionError, ImportError):
        pass
    return NO_LIBRARY


def features() -> set[str]:
    """What this processor has of what the levels ask, as LLVM names it."""
    if sys.platform == "win32":  # of single instructions Windows tells these two
        told = ctypes.windll.kernel32.IsProcessorFeaturePresent
        return (_V3 if told(40) else set()) | ({"avx512f", "avx512vl"} if told(41) else set())
    try:
        text = Path("/proc/cpuinfo").read_text(encoding="ascii", errors="replace")
    except OSError:
        return set()
    flags = re.search(r"^flags\s*:(.*)$", text, re.MULTILINE)
    return {_FLAGS.get(flag, flag) for flag in flags[1].split()} if flags else set()


def levels_of(names: Collection[str]) -> list[str]:
    """Those of these levels that this processor has, the best first."""
    if platform.machine().lower() not in ("x86_64", "amd64"):
        return [OF_ARM] if OF_ARM in names else []
    has = features()
    return [name for name in PROCESSOR_LEVELS if name in names and has >= PROCESSOR_LEVELS[name]]


def levels() -> list[str]:
    """The levels shipped for this processor, the best first; none where kernels are compiled for a level by force."""
    return [] if FORCED_LEVEL in os.environ else levels_of(library().levels)


def has_wide_vectors() -> bool:
    """Whether kernels are compiled for vector registers of 512 bits, of which there are 32."""
    forced = os.environ.get(FORCED_LEVEL)
    return forced == "x86-64-v4" if forced else "avx512vl" in features()


def file_name(level: str) -> str:
    """Name of the file of a level."""
    return level + {"win32": ".dll", "darwin": ".dylib"}.get(sys.platform, ".so")


def whole_file(level: str) -> Path | None:
    """The file shipped for a level; None where it is missing or damaged, or another can write there."""
    shipped = library()
    path = shipped.folder / file_name(level)
    try:
        own = shipped.folder == FOLDER or only_own(path, ROOT)
        content = path.read_bytes()
    except OSError:
        return None
    return path if own and hashlib.sha256(content).hexdigest() == shipped.levels[level] else None
