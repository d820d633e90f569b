"""What machine code comes from, as a hash: the sources of the kernels."""

import functools
import hashlib
import re
import threading
from pathlib import Path

from core.version import VERSION, build

CORE = Path(__file__).parents[1]

_once = threading.RLock()


def once_for_all(function):
    """Keep for all the result of a function without arguments, made by the first thread that asks."""
    known = []

    @functools.wraps(function)
    def result():
        with _once:
            if not known:
                known.append(function())
        return known[0]

    result.is_made = lambda: bool(known)
    return result


WITHOUT_KERNELS = ("core.text", "core.errors", "core.atomic_write")
_IMPORT = re.compile(r"^[ \t]*from[ \t]+(?:\w+\.)?(core\b[\w.]*)[ \t]+import[ \t]+(\([^)]*\)|[^\n]*)", re.MULTILINE)
"""An import from core, of the installed package too, where core is within it."""

_WITH_KERNELS = re.compile(r"from (?:\w+\.)?core\.jit\.decorators import")


def kernel_sources(core: Path) -> list[Path]:
    """The sources machine code comes from: the modules of kernels, all they import from core, and core/jit. Kernels
    return codes, so that no error and no sentence is part of them.

    core : the folder core
    """
    known = {file: file.read_text(encoding="utf-8") for file in core.rglob("*.py")}
    sources: set[Path] = set()
    new = {file for file, text in known.items() if file.parent.name == "jit" or _WITH_KERNELS.search(text)}
    while new:
        sources |= new
        names = {
            name
            for file in new
            for package, listed in _IMPORT.findall(known[file])
            if not package.startswith(WITHOUT_KERNELS)
            for name in (package, *(f"{package}.{one}" for one in re.findall(r"\w+", listed)))
        }
        places = [core.parent.joinpath(*name.split(".")) for name in names]
        files = {file for place in places for file in (place.with_suffix(".py"), place / "__init__.py")}
        new = (files & set(known)) - sources
    return sorted(sources)


def hash_of(files: list[Path]) -> str:
    """Hash of the version and of what files hold."""
    digest = hashlib.sha256(VERSION.encode())
    for file in files:
        digest.update(file.read_bytes())
    return digest.hexdigest()[:16]


@once_for_all
def stamp() -> str:
    """Hash of the sources machine code comes from, of a frozen program as its build noted it: a changed sentence
    discards no machine code."""
    return build().get("kernels") or hash_of(kernel_sources(CORE))


@once_for_all
def source_stamp() -> str:
    """Hash of all sources of core, which decide a result: of a frozen program as its build noted it."""
    return build().get("sources") or hash_of(sorted(CORE.rglob("*.py")))
