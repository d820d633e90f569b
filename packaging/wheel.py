"""Build the wheel in dist, install it with `uv tool install`, with `pipx install` and with `pip` into an environment
others share, and try the command `ribalta`, `python -m` and the import.

python3 packaging/wheel.py     (needs uv on the PATH; pipx, where it is absent, is run by uv)

The wheel holds one package (one_package.py), so that its names meet nobody else's. The batch must give the results of
the source tree.
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT), str(ROOT / "packaging")]
import smoke  # noqa: E402

from core.version import VERSION  # noqa: E402

EXTRAS = "gui,study,report"
PACKAGE = "ribalta_rocking"


def main() -> int:
    argparse.ArgumentParser(description=__doc__.split("\n")[0]).parse_args()
    if not shutil.which("uv"):
        raise SystemExit("the wheel is tried by uv, which is not on the PATH: install it (pip install uv) first")
    shutil.rmtree(ROOT / "dist" / "wheel", ignore_errors=True)
    subprocess.run(["uv", "build", "--quiet", "--wheel", "--out-dir", ROOT / "dist" / "wheel", ROOT], check=True)
    wheel = next((ROOT / "dist" / "wheel").glob("*.whl"))
    pins = ROOT / "packaging" / "constraints.txt"
    pipx = ["pipx"] if shutil.which("pipx") else ["uvx", "--quiet", "pipx"]
    case = next(case for case in smoke.CASES if case.stem == "verdict")
    with tempfile.TemporaryDirectory(prefix="ribalta-wheel-") as name:
        folder = Path(name)
        theirs = smoke.variables(folder)
        source = [sys.executable, ROOT / "run.py"]
        right = smoke.batch(source, case, folder / "source", theirs)[0]
        for kind, command, places in (
            (
                "uv tool install",
                ["uv", "tool", "install", "--quiet", "--python", sys.executable, "--constraints", pins],
                {"UV_TOOL_DIR": "tools", "UV_TOOL_BIN_DIR": "bin"},
            ),
            (
                "pipx install",
                [*pipx, "install", "--quiet", "--python", sys.executable, f"--pip-args=--constraint {pins}"],
                {"PIPX_HOME": "tools", "PIPX_BIN_DIR": "bin"},
            ),
        ):
            place = folder / kind.split()[0]
            places = {key: str(place / value) for key, value in places.items()}
            subprocess.run([*command, f"{wheel}[{EXTRAS}]"], check=True, env=os.environ | places)
            program = place / "bin" / ("ribalta.exe" if os.name == "nt" else "ribalta")
            mine = smoke.variables(place)
            subprocess.run([program, "--version"], check=True, env=mine, cwd=place)
            _refuse_other(smoke.batch(program, case, place / "results", mine)[0], right, kind)
            with smoke.display() as shown:
                started = subprocess.Popen([program], env=mine | smoke.screen(shown))
                try:
                    started.wait(timeout=8)
                    raise AssertionError(f"the window ended with code {started.returncode}")
                except subprocess.TimeoutExpired:
                    started.kill()
                    started.wait()
            print(f"{kind}: the command ribalta gives the results of the source tree, its window opens")
        _in_shared(wheel, folder / "shared", pins, case, right)
    return 0


def _refuse_other(own: dict, right: dict, kind: str) -> None:
    """End the trial with a sentence where results are not those of the source tree. kind : of installation"""
    smoke.refuse(own != right, f"the wheel by {kind} has {smoke.first_difference(own, right)}")


def names_of(wheel: Path) -> set[str]:
    """Names a wheel puts beside other packages."""
    with zipfile.ZipFile(wheel) as packed:
        return {name.split("/")[0] for name in packed.namelist()}


def _in_shared(wheel: Path, place: Path, pins: Path, case: Path, right: dict) -> None:
    """Try the wheel in an environment with a package `core` and a package `app` of somebody else."""
    found = names_of(wheel)
    if found != {PACKAGE, f"{PACKAGE}-{VERSION}.dist-info"}:
        raise SystemExit(f"the wheel puts {sorted(found)} beside other packages: one package alone, see one_package.py")
    subprocess.run(["uv", "venv", "--quiet", "--python", sys.executable, place / "env"], check=True)
    python = place / "env" / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    install: list = ["uv", "pip", "install", "--quiet", "--python", python, "--constraints", pins]
    subprocess.run([*install, f"{wheel}[report]"], check=True)
    libraries = subprocess.run(
        [python, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))"],
        check=True,
        capture_output=True,
        text=True,
    ).stdout.strip()
    for other in ("core", "app", "resources"):
        (Path(libraries) / other).mkdir()
        (Path(libraries) / other / "__init__.py").write_text("raise ImportError('of somebody else')\n")
    mine = smoke.variables(place)
    wall = "r.wall(mechanism='two_sided', height_m=3.0, thickness_m=0.3)"
    said = f"import {PACKAGE} as r; print(r.__version__, {wall}.in_si.block.p2)"
    subprocess.run([python, "-c", said], check=True, env=mine, cwd=place)
    own = smoke.batch([python, "-P", "-m", PACKAGE], case, place / "results", mine)[0]
    _refuse_other(own, right, "pip install beside others")
    print("pip install beside others: python -m and the import give the results of the source tree")


if __name__ == "__main__":
    sys.exit(main())
