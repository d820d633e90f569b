"""Machine code that the frozen program brings along for common processors, so that its first run compiles nothing.

packaging/build.py makes it with the frozen program itself, in `kernels/<level>` beside the program's modules.
"""

import hashlib
import json
import os
import platform
from pathlib import Path

FOLDER = Path(__file__).resolve().parents[2] / "kernels"

MANIFEST = "manifest.json"

_V3 = {"avx", "avx2", "bmi", "bmi2", "f16c", "fma", "lzcnt", "movbe"}
LEVELS = {
    "x86-64-v4": _V3 | {"avx512f", "avx512bw", "avx512cd", "avx512dq", "avx512vl"},
    "x86-64-v3": _V3,
    "x86-64": set(),
}
"""Levels of the x86-64 psABI as LLVM names them -> what a processor must have, the best first."""

FORCED_LEVEL = "RIBALTA_LEVEL"
"""Variable that names a level to compile for; nothing shipped is used then."""


def level() -> str:
    """The best level of this processor that machine code was shipped for; "" where there is none, as in the source
    tree: numba then compiles for the very processor."""
    if FORCED_LEVEL in os.environ:
        return os.environ[FORCED_LEVEL]
    if platform.machine().lower() not in ("x86_64", "amd64") or not FOLDER.is_dir():
        return ""
    from llvmlite.binding import get_host_cpu_features

    has = {name for name, there in get_host_cpu_features().items() if there}
    shipped = (name for name in LEVELS if (FOLDER / name / MANIFEST).is_file())
    return next((name for name in shipped if has >= LEVELS[name]), "")


def has_wide_vectors() -> bool:
    """Whether kernels are compiled for vector registers of 512 bits, of which there are 32."""
    if level():
        return level() == "x86-64-v4"
    from llvmlite.binding import get_host_cpu_features

    return bool(get_host_cpu_features().get("avx512vl"))


def whole_files(name: str) -> dict[str, bytes]:
    """File name -> content of the machine code shipped for a level; none where one is missing or damaged."""
    folder = FOLDER / name
    if not name or FORCED_LEVEL in os.environ:
        return {}
    try:
        manifest = dict(json.loads((folder / MANIFEST).read_bytes()))
        files = {file: (folder / file).read_bytes() for file in manifest}
    except (OSError, ValueError, TypeError, RecursionError):
        return {}
    same = all(hashlib.sha256(files[file]).hexdigest() == digest for file, digest in manifest.items())
    return files if same else {}
