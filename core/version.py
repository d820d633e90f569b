"""Version of the program and, in a checkout, its commit."""

from pathlib import Path

VERSION = "0.7.0"
NAME = "Ribalta"


def commit() -> str:
    """Commit of the source tree, "" where there is none."""
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
