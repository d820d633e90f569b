"""Write requirements.lock: hash-pinned, no addresses, one section a group. Needs uv on the PATH.

    python packaging/lock.py            the newest of all packages that go together
    python packaging/lock.py --keep     what has a pin keeps it: for a new package

Each section holds what its group adds to the base; run.py installs base and the groups it needs. constraints.txt
holds the pins alone, for who installs the wheel.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
GROUPS = (
    "base",
    "test",
    "gui",
    "accuracy",
    "study",
    "report",
    "parquet",
    "dxf",
    "scheduler",
    "docs",
    "bench",
    "package",
)


def resolved(extras: list[str], constraint: Path | None = None) -> dict[str, str]:
    """Package -> its block of the lock, for all platforms and interpreters at once."""
    command = [
        "uv",
        "pip",
        "compile",
        "--quiet",
        "--universal",
        "--generate-hashes",
        "--no-header",
        "--no-annotate",
        "--no-emit-index-url",
        "--no-emit-find-links",
        "pyproject.toml",
    ]
    for extra in extras:
        command += ["--extra", extra]
    if constraint:
        command += ["--constraint", str(constraint)]
    text = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout
    blocks = re.split(r"\n(?=[A-Za-z0-9])", text.strip())
    return {block.splitlines()[0].rstrip(" \\"): block for block in blocks}


def main() -> None:
    kept = ROOT / "packaging" / "constraints.txt" if "--keep" in sys.argv[1:] else None
    everything = resolved(list(GROUPS[1:]), kept)
    with tempfile.TemporaryDirectory() as folder:
        pins = Path(folder) / "pins.txt"
        pins.write_text("\n".join(everything))
        base = resolved([], pins)
        lines = []
        for group in GROUPS:
            own = base if group == "base" else resolved([group], pins)
            more = [block for pin, block in own.items() if group == "base" or pin not in base]
            lines += [f"# [{group}]", *more]
    text = "\n".join(lines) + "\n"
    (ROOT / "requirements.lock").write_text(text)
    (ROOT / "packaging" / "constraints.txt").write_text(constraints(text))


def constraints(lock: str) -> str:
    """The pins of a lock, each once, without hashes."""
    pins = {line.rstrip(" \\") for line in lock.split("\n") if "==" in line}
    return "".join(f"{pin}\n" for pin in sorted(pins))


if __name__ == "__main__":
    main()
