"""Build the frozen program in dist/ribalta and try it: version, a batch, the same results twice.

python3 run.py package
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def results(folder: Path) -> dict:
    """The results of a batch without what names the moment and the build."""
    content = json.loads((folder / "verdict.json").read_text(encoding="utf-8"))
    for key in ("started_utc", "program"):
        del content[key]
    return content


def smoke(program: Path) -> None:
    """Run the frozen program in an empty folder: its batch must give the numbers of the source tree."""
    case = ROOT / "resources" / "cases" / "verdict.toml"
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        variables = dict(os.environ, RIBALTA_CACHE=str(folder / "cache"))
        variables.pop("PYTHONPATH", None)
        output = subprocess.run([program, "--version"], check=True, capture_output=True, text=True,
                              cwd=folder, env=variables)  # fmt: skip
        print(output.stdout.strip())
        for command, place in (
            ([program], "frozen"),
            ([sys.executable, "-P", "-m", "app"], "source"),
        ):
            more = {"PYTHONPATH": str(ROOT)} if place == "source" else {}
            subprocess.run([*command, "--batch", case, "--output", folder / place, "--quiet"], check=True,
                           cwd=folder, env={**variables, **more})  # fmt: skip
        assert results(folder / "frozen") == results(folder / "source"), (
            "other numbers than the source"
        )
    print(f"{program}: batch equal to the source tree's")


def main() -> int:
    shutil.rmtree(ROOT / "dist", ignore_errors=True)
    subprocess.run(
        [sys.executable, "-m", "PyInstaller", "--noconfirm", "--log-level", "WARN", "--distpath",
         ROOT / "dist", "--workpath", ROOT / "build", ROOT / "packaging" / "ribalta.spec"],
        check=True, cwd=ROOT,
    )  # fmt: skip
    smoke(ROOT / "dist" / "ribalta" / ("ribalta.exe" if os.name == "nt" else "ribalta"))
    return 0


if __name__ == "__main__":
    sys.exit(main())
