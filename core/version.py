"""Version of the program and the commit it is of."""

import functools
import json
from pathlib import Path

VERSION = "0.33.0"
NAME = "Ribalta"


@functools.cache
def build() -> dict[str, str]:
    """What packaging/build.py noted of a frozen program: `commit`, hashes of its sources. Nothing in a source tree."""
    try:
        return json.loads((Path(__file__).resolve().parents[1] / "build.json").read_bytes())
    except (OSError, ValueError):
        return {}


def commit() -> str:
    """Commit of the source tree or of the build, "" where there is none."""
    if build():
        return build()["commit"]
    git = Path(__file__).resolve().parents[1] / ".git"
    try:
        head = (git / "HEAD").read_text().strip()
        if not head.startswith("ref: "):
            return head
        reference = git / head[5:]
        if reference.exists():
            return reference.read_text().strip()
        packed = (git / "packed-refs").read_text().splitlines()
        return next(line.split()[0] for line in packed if line.endswith(head[5:]))
    except (OSError, StopIteration):
        return ""


def line() -> str:
    """Name, version and the start of the commit."""
    return f"{NAME} {VERSION} {commit()[:12]}".strip()
