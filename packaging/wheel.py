"""Build the wheel in dist, install it with `uv tool install` and with `pipx install`, and try the command `ribalta`.

python3 packaging/wheel.py     (needs uv on the PATH; pipx, where it is absent, is run by uv)

Both give the program an environment of its own, so that the top-level names `app`, `core` and `resources` of the wheel
meet nobody else's. The batch must give the results of the source tree.
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT), str(ROOT / "packaging")]
import smoke  # noqa: E402

EXTRAS = "gui,study,report"


def main() -> int:
    argparse.ArgumentParser(description=__doc__.split("\n")[0]).parse_args()
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
            assert smoke.batch(program, case, place / "results", mine)[0] == right, "other numbers"
            with smoke.display() as shown:
                started = subprocess.Popen([program], env=mine | smoke.screen(shown))
                try:
                    started.wait(timeout=8)
                    raise AssertionError(f"the window ended with code {started.returncode}")
                except subprocess.TimeoutExpired:
                    started.kill()
                    started.wait()
            print(f"{kind}: the command ribalta gives the results of the source tree, its window opens")
    return 0


if __name__ == "__main__":
    sys.exit(main())
