"""What may be packed: the packages of these groups of requirements.lock, whatever else the environment of the build
holds. PyInstaller follows imports that are only tried, and would take along what is installed for tests or peers."""

import importlib.metadata
import re
from collections.abc import Iterable
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PACKED = "base", "gui", "accuracy", "study", "report", "dxf"
"""Groups of the frozen program."""

NOT_PACKED = "numba", "llvmlite"
"""What the kernels are compiled with; the frozen program has their machine code."""

BESIDE = "Python", "pyinstaller"
"""What is packed beside them: the interpreter, and the starter."""


def plain(name: str) -> str:
    """A name of a package as the index has it."""
    return re.sub(r"[-_.]+", "-", name).lower()


def of_groups(lock: str, groups: Iterable[str]) -> set[str]:
    """Names of the packages of some groups of a lock. lock : its text"""
    sections = re.split(r"^# \[(\w+)\]$", lock, flags=re.MULTILINE)[1:]
    texts = dict(zip(sections[::2], sections[1::2], strict=True))
    return {
        plain(name) for group in groups for name in re.findall(r"^([A-Za-z0-9][\w.-]*)==", texts[group], re.MULTILINE)
    }


def allowed() -> set[str]:
    """Names of the packages that may be packed."""
    return of_groups((ROOT / "requirements.lock").read_text(encoding="utf-8"), PACKED) - set(NOT_PACKED)


def foreign_modules() -> list[str]:
    """Top-level modules of what is installed and may not be packed; a name that one of the others has too is none."""
    known, own, others = allowed(), set[str](), set[str]()
    for found in importlib.metadata.distributions():
        modules = own if plain(found.name) in known else others
        for file in found.files or ():
            first = file.parts[0]
            if len(file.parts) > 1 and first.isidentifier():
                modules.add(first)
            elif len(file.parts) == 1 and first.endswith(".py"):
                modules.add(first.removesuffix(".py"))
    return sorted(others - own - {"__pycache__"})


def refuse_foreign(packed: Iterable[str]) -> None:
    """End the build with one sentence where something else was packed. packed : names of the parts of the program"""
    names = {plain(name) for name in packed}
    installed = {plain(found.name) for found in importlib.metadata.distributions()}
    if more := sorted(names & installed - allowed() - {plain(name) for name in BESIDE}):
        raise SystemExit(
            f"packed, and in none of the groups {', '.join(PACKED)} of the lock: {', '.join(more)}; "
            f"leave them out in packaging/ribalta.spec, or build in an environment without them"
        )
