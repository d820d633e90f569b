"""The Pythons and systems Ribalta runs on, as far as the packages of requirements.lock have wheels for them.

run.py refuses the others by this before anything is fetched; documents, launchers, pyproject.toml and workflow say the
same (tests/test_platforms.py). Read by any Python from 3.6 on; standard library only.
"""

import os
import platform
import re
import sys
import sysconfig
from typing import Any

from core.text.start import phrase

PYTHONS: "dict[str, dict[str, Any]]" = {
    "3.11": {"run": True},
    "3.12": {"run": True},
    "3.13": {"run": True},
    "3.14": {"run": False},
    "3.15": {"run": False, "without": {"gui": "PySide6", "bench": "heyoka"}},
}
"""Python -> whether the program was run with it, else all its packages were only resolved; group of packages -> the
package without a wheel for it."""

SYSTEMS: "tuple[dict[str, Any], ...]" = (
    {
        "system": "Linux",
        "processor": "x86_64",
        "name": "Linux x86-64",
        "run": True,
        "least": {"base": "glibc 2.28", "gui": "glibc 2.34"},
        "tag": "manylinux_{}_{}_x86_64",
    },
    {
        "system": "Linux",
        "processor": "aarch64",
        "name": "Linux ARM64",
        "run": False,
        "least": {"base": "glibc 2.28", "gui": "glibc 2.39"},
        "tag": "manylinux_{}_{}_aarch64",
    },
    {
        "system": "Windows",
        "processor": "amd64",
        "name": "Windows x86-64",
        "run": False,
        "without": {"bench": "heyoka"},
        "tag": "win_amd64",
    },
    {
        "system": "Windows",
        "processor": "arm64",
        "name": "Windows ARM64 (Python 3.12 to 3.14)",
        "run": False,
        "pythons": ("3.12", "3.13", "3.14"),
        "without": {"bench": "heyoka", "parquet": "pyarrow"},
        "tag": "win_arm64",
    },
    {
        "system": "macOS",
        "processor": "arm64",
        "name": "macOS ARM64",
        "run": False,
        "least": {"base": "macOS 12.0", "gui": "macOS 13.0"},
        "without": {"bench": "heyoka"},
        "tag": "macosx_{}_{}_arm64",
    },
)
"""What was run, or only resolved: the Pythons if not all, least version for the groups, tag of the wheels."""

WITHOUT_WHEELS = (
    {"system": "macOS", "processor": "x86_64", "name": "macOS with an Intel processor", "tag": "macosx_15_0_x86_64"},
    {"system": "Windows", "processor": "x86", "name": "a Python of 32 bits", "tag": "win32"},
    {"system": "Linux", "processor": "x86_64", "name": "a Linux without glibc", "tag": "musllinux_1_2_x86_64"},
)
"""What cannot be, for want of a wheel of llvmlite."""

ASKED = {"gui": "the window", "bench": "the benchmark of peers", "parquet": "what more than 10 000 walls need"}
NEWEST = {"gui": "PySide6"}
"""Group -> the words of who asks for it; and the package that asks for the newest system, else llvmlite."""

MEGABYTES = {
    "llvmlite": (57, 176),
    "numba": (4, 36),
    "numpy": (17, 73),
    "scipy": (35, 143),
    "openpyxl": (1, 3),
    "pyside6-essentials": (77, 225),
    "pyqtgraph": (2, 10),
    "matplotlib": (9, 35),
    "fonttools": (5, 30),
    "pillow": (7, 23),
    "kiwisolver": (2, 6),
    "lxml": (5, 12),
    "heyoka": (103, 240),
    "jaxlib": (85, 349),
    "jax": (3, 31),
    "pyarrow": (55, 165),
    "ezdxf": (6, 30),
    "dask": (2, 17),
    "distributed": (1, 8),
    "tornado": (1, 6),
    "cryptography": (4, 13),
    "shapely": (3, 9),
    "mypy": (14, 55),
    "ruff": (11, 32),
    "hypothesis": (1, 7),
    "mpmath": (1, 6),
    "grimp": (2, 6),
    "pip": (0, 28),
    "another": (0.3, 1),
}
"""Package -> what is fetched for it, and what it takes on the disk with its machine code of Python (Linux x86-64)."""


def numbers(version):
    """The first two numbers of a version, [0] without one."""
    return [int(part) for part in re.findall("[0-9]+", version)[:2]] or [0]


def span(pythons):
    """Pythons from the first to the last, as a sentence names them."""
    known = sorted(pythons, key=numbers)
    return phrase("Python {first} to {last}", first=known[0], last=known[-1])


def without(row, group):
    """The package of a group that a Python or a system lacks, None where it has all."""
    return row.get("without", {}).get(group)


def megabytes(names):
    """[MB] fetched for packages, and on the disk."""
    return [sum(MEGABYTES.get(name, MEGABYTES["another"])[k] for name in names) for k in (0, 1)]


def this_system():
    """(system, processor, what decides of its version) of the interpreter: ("Linux", "x86_64", "glibc 2.36")."""
    if os.name == "nt":
        kind = sysconfig.get_platform()
        return "Windows", {"win32": "x86"}.get(kind, kind[len("win-") :]), ""
    if sys.platform == "darwin":
        return "macOS", platform.machine(), "macOS " + platform.mac_ver()[0]
    try:
        return "Linux", platform.machine(), os.confstr("CS_GNU_LIBC_VERSION") or "no glibc"
    except (ValueError, OSError):
        return "Linux", platform.machine(), "no glibc"


def tag():
    """The tag of a wheel of machine code made here: for any Python, on the oldest of this system that has wheels of the
    packages."""
    place = this_system()[:2]
    row = next(row for row in SYSTEMS if (row["system"], row["processor"]) == place)
    least = numbers(row.get("least", {}).get("base", ""))
    return "py3-none-" + row["tag"].format(*least)


def refusal(groups):
    """Why this Python or system cannot have these groups of packages, in one sentence; None where it can."""
    version = "{}.{}".format(*sys.version_info[:2])
    kind = None
    if sys.implementation.name != "cpython":
        kind = platform.python_implementation()
    elif version not in PYTHONS:
        kind = "Python " + version
    elif sysconfig.get_config_var("Py_GIL_DISABLED"):
        kind = "free-threaded Python " + version
    if kind:
        text = "Ribalta does not run with {kind}: take {pythons} (python.org)"
        return phrase(text, kind=kind, pythons=span(PYTHONS))
    for group in groups:
        place, package = "Python " + version, without(PYTHONS[version], group)
        instead = span(name for name in PYTHONS if not without(PYTHONS[name], group))
        if not package:
            place, package, instead = of_system(group, version)
        if package:
            text = "{asked} cannot be installed here ({place}): {package} has no wheel for it; take {instead}"
            asked = phrase(ASKED[group]) if group in ASKED else "Ribalta"
            sentence = phrase(text, asked=asked, place=place, package=package, instead=instead)
            more = "; a case runs without a window: --batch CASE"
            return sentence + (phrase(more) if group == "gui" else "")
    return None


def of_system(group, version):
    """(this system as a sentence names it, the package of a group that it lacks or None, what has it)."""
    system, processor, level = this_system()
    place = ", ".join(part for part in (system + " " + processor, level) if part)
    having = ", ".join(row["name"] for row in SYSTEMS if not without(row, group))
    rows = [row for row in SYSTEMS if (row["system"], row["processor"]) == (system, processor)]
    least = rows[0].get("least", {}).get(group, "") if rows else ""
    if not rows or numbers(level) < numbers(least):
        return place, NEWEST.get(group, "llvmlite"), having
    pythons = rows[0].get("pythons", PYTHONS)
    if version not in pythons:
        return place + ", Python " + version, "llvmlite", span(pythons)
    return place, without(rows[0], group), having
