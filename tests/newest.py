"""The tests under the newest numba, numpy, PySide6, pyqtgraph and openpyxl, which the lock forbids: what breaks?

    python3 run.py test --newest [...]     arguments of pytest behind it

The packages go into an environment of their own, .venv.newest, made anew each time; the tests decide, nothing is kept.
"""

import os
import re
import shutil
import subprocess
import sys
import tomllib
import venv
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / ".venv.newest"
FREE = ("numba", "numpy", "pyside6-essentials", "pyqtgraph", "openpyxl")
"""Packages whose newest version is taken."""

GROUPS = ("gui", "test", "accuracy", "study", "report", "parquet", "dxf")


def wanted() -> list[str]:
    """What pyproject.toml asks, the free packages without limits."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    asked = [*project["dependencies"], *(line for group in GROUPS for line in project["optional-dependencies"][group])]
    names = {line: re.match(r"[\w.-]+", line)[0].lower() for line in asked}
    return sorted({names[line] if names[line] in FREE else line for line in asked})


def main(arguments: list[str]) -> int:
    shutil.rmtree(FOLDER, ignore_errors=True)
    venv.create(FOLDER, with_pip=True)
    python = FOLDER / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    install = [python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--only-binary", ":all:"]
    subprocess.run([*install, *wanted()], check=True)
    subprocess.run([python, "-m", "pip", "freeze", "--disable-pip-version-check"], check=True)
    command = [python, "-P", "-m", "pytest", "-q", "-W", "default", *(arguments or ["-n", "auto"])]
    environment = dict(os.environ, PYTHONPATH=str(ROOT), QT_QPA_PLATFORM="offscreen")
    return subprocess.run(command, cwd=ROOT, env=environment, check=False).returncode


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
