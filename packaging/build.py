"""Build the frozen program in dist/ribalta, with machine code, licences and parts list, its archive and installers.

python3 run.py package [--no-smoke]
python3 run.py package --kernels     the wheel of machine code alone (packaging/kernels.py)

What packaging/README.md says of each step. The frozen program is then tried by packaging/smoke.py.
"""

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT), str(ROOT / "packaging")]
import contents  # noqa: E402
import icon  # noqa: E402
import icu  # noqa: E402
import kernels  # noqa: E402
import libraries  # noqa: E402
import licences  # noqa: E402
import products  # noqa: E402
import second_solver  # noqa: E402
import smoke  # noqa: E402
from products import DIST, FOLDER, INTERNAL, SYSTEM, size  # noqa: E402

from core.jit import stamp  # noqa: E402
from core.version import VERSION, commit  # noqa: E402

WORK, PARTS = ROOT / "build", ROOT / "build" / "parts"
SIZES = ROOT / "packaging" / "sizes.json"

VERSION_RESOURCE = """VSVersionInfo(
  ffi=FixedFileInfo(filevers={numbers}, prodvers={numbers}, mask=0x3F, flags=0x0, OS=0x40004, fileType=0x1),
  kids=[
    StringFileInfo([StringTable("040904B0", [
      StringStruct("FileDescription", "Ribalta: out-of-plane overturning of masonry walls"),
      StringStruct("FileVersion", "{version}"), StringStruct("ProductName", "Ribalta"),
      StringStruct("ProductVersion", "{version}"), StringStruct("OriginalFilename", "ribalta.exe"),
      StringStruct("LegalCopyright", "BSD-3-Clause; parts of others: licences")])]),
    VarFileInfo([VarStruct("Translation", [1033, 1200])])])
"""


def _commit() -> str:
    """Commit of what is built; "uncommitted" where the sources are of none."""
    command = ["git", "status", "--porcelain", "--", ".", f":!{SIZES.relative_to(ROOT).as_posix()}"]
    try:
        changed = subprocess.run(command, cwd=ROOT, capture_output=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError):
        changed = b""
    return "uncommitted" if changed else commit()


def make_parts() -> None:
    """Icons, the version resource, the solver of scipy, and what the program knows of its build: commit, and hashes of
    the sources (that of kernels names the folders of machine code)."""
    PARTS.mkdir(parents=True, exist_ok=True)
    icon.write(PARTS)
    second_solver.write(PARTS / "second_solver")
    numbers = (*map(int, VERSION.split(".")), 0)
    resource = VERSION_RESOURCE.format(numbers=numbers, version=VERSION)
    (PARTS / "version.txt").write_text(resource, encoding="utf-8")
    about = {"commit": _commit(), "kernels": stamp.stamp(), "sources": stamp.source_stamp()}
    (PARTS / "build.json").write_text(json.dumps(about), encoding="ascii")


def freeze() -> None:
    """Let PyInstaller make dist/ribalta, without what an earlier build left."""
    products.remove_former()
    subprocess.run(
        [
            sys.executable,
            "-m",
            "PyInstaller",
            "--noconfirm",
            "--log-level",
            "WARN",
            "--distpath",
            DIST,
            "--workpath",
            WORK,
            ROOT / "packaging" / "ribalta.spec",
        ],
        check=True,
        cwd=ROOT,
    )


def ship_machine_code(library: Path) -> None:
    """The library in a folder, and its wheel in dist."""
    kernels.make(library)
    print(kernels.wheel(library, DIST))


def print_sizes(made: list[Path]) -> None:
    """Of the folder, of what costs most in it, and of the products, beside those of the last build."""
    known = json.loads(SIZES.read_text(encoding="ascii")) if SIZES.exists() else {}
    last = known.get(SYSTEM, {})
    inside = {place.name: size(place) for place in INTERNAL.iterdir()}
    great = dict(sorted(inside.items(), key=lambda item: -item[1])[:12])
    now = {"unpacked": size(FOLDER)} | {place.suffix: size(place) for place in made} | great
    for name, count in now.items():
        change = f"{(count - last[name]) / 1e6:+8.1f}" if name in last else "     new"
        print(f"{name:40} {count / 1e6:8.1f} MB {change}")
    SIZES.write_text(json.dumps(known | {SYSTEM: now}, indent=1) + "\n", encoding="ascii")


def main() -> int:
    words = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    words.add_argument("--no-smoke", action="store_true", help="do not try what was built")
    words.add_argument("--kernels", action="store_true", help="build the wheel of machine code alone")
    options = words.parse_args()
    if options.kernels:
        with tempfile.TemporaryDirectory() as name:
            ship_machine_code(Path(name))
        return 0
    libraries.refuse_missing_tools()
    libraries.refuse_missing_of_qt()
    make_parts()
    freeze()
    libraries.refuse_missing(INTERNAL)
    libraries.strip(INTERNAL)
    icu.shorten_in(INTERNAL)
    qt = "_internal/PySide6/Qt/lib" if sys.platform != "win32" else "_internal/PySide6"
    found = licences.gather(WORK / "ribalta", FOLDER / "licences", VERSION, qt)
    contents.refuse_foreign(part.name for part in found)
    print(f"licences of {len(found)} parts, parts list: licences/sbom.cdx.json")
    ship_machine_code(INTERNAL / "kernels")
    print_sizes(products.make())
    return 0 if options.no_smoke else smoke.main(FOLDER)


if __name__ == "__main__":
    sys.exit(main())
