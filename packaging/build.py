"""Build the frozen program in dist/ribalta, with machine code, licences and parts list, its archive and installers.

python3 run.py package [--no-smoke]

What packaging/README.md says of each step. The frozen program is then tried by packaging/smoke.py.
"""

import argparse
import hashlib
import json
import os
import platform
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT), str(ROOT / "packaging")]
import icon  # noqa: E402
import licences  # noqa: E402
import smoke  # noqa: E402

from core.jit import cache, shipped  # noqa: E402
from core.version import VERSION, commit  # noqa: E402

DIST, WORK, PARTS = ROOT / "dist", ROOT / "build", ROOT / "build" / "parts"
FOLDER = DIST / "ribalta"
INTERNAL = FOLDER / "_internal"
SIZES = ROOT / "packaging" / "sizes.json"
MACHINE = {"AMD64": "x86_64", "x86_64": "x86_64", "arm64": "arm64", "aarch64": "arm64"}[
    platform.machine()
]
SYSTEM = f"{ {'win32': 'windows', 'darwin': 'macos'}.get(sys.platform, 'linux') }-{MACHINE}"

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


def make_parts() -> None:
    """Icons, the version resource, and what the program knows of its build: commit, stamp of the sources (names the
    folders of machine code) and the numbers of the self-test, computed here by the source tree."""
    PARTS.mkdir(parents=True, exist_ok=True)
    icon.write(PARTS)
    numbers = (*map(int, VERSION.split(".")), 0)
    resource = VERSION_RESOURCE.format(numbers=numbers, version=VERSION)
    (PARTS / "version.txt").write_text(resource, encoding="utf-8")
    from core.study import self_test

    about = {"commit": commit(), "stamp": cache.stamp(), "self_test": self_test.numbers()}
    (PARTS / "build.json").write_text(json.dumps(about), encoding="ascii")


def freeze() -> None:
    shutil.rmtree(DIST, ignore_errors=True)
    subprocess.run(
        [sys.executable, "-m", "PyInstaller", "--noconfirm", "--log-level", "WARN", "--distpath", DIST,
         "--workpath", WORK, ROOT / "packaging" / "ribalta.spec"],
        check=True, cwd=ROOT,
    )  # fmt: skip


LOADS = """import ctypes, sys
for name in sys.argv[1:]:
    try:
        ctypes.CDLL(name)
    except OSError:
        continue
    print(name)
"""


def _loaded(files: list[Path]) -> set[str]:
    """Those libraries that the dynamic linker loads."""
    variables = {**os.environ, "LD_LIBRARY_PATH": str(INTERNAL)}
    command = [sys.executable, "-c", LOADS, *map(str, files)]
    return set(
        subprocess.run(command, capture_output=True, text=True, env=variables).stdout.split("\n")
    )


def strip() -> None:
    """Take the symbols nobody loads by out of the libraries, of Linux; Qt's stay as published (LGPL). One that loads
    no more afterwards is put back."""
    if not sys.platform.startswith("linux") or not shutil.which("strip"):
        return
    libraries = [
        file for file in INTERNAL.rglob("*.so*")
        if file.is_file() and not file.is_symlink() and not {"PySide6", "shiboken6"} & set(file.parts)
    ]  # fmt: skip
    before = _loaded(libraries)
    with tempfile.TemporaryDirectory() as name:
        kept = {file: Path(name) / str(k) for k, file in enumerate(libraries)}
        for file, copy in kept.items():
            shutil.copy2(file, copy)
            subprocess.run(["strip", "--strip-unneeded", file], check=True)
        for kind in ("*.libs/*", "*"):  # first what others of these need
            for broken in map(Path, before - _loaded(libraries)):
                if broken.match(kind):
                    print(f"not stripped: {broken.name}")
                    shutil.copy2(kept[broken], broken)


def refuse_missing_libraries() -> None:
    """Raise FileNotFoundError where a library needs one that is neither packed nor on this machine: the program would
    not start elsewhere either."""
    if not sys.platform.startswith("linux"):
        return
    variables = {**os.environ, "LD_LIBRARY_PATH": str(INTERNAL)}
    for file in INTERNAL.rglob("*.so*"):
        listed = subprocess.run(["ldd", file], capture_output=True, text=True, env=variables).stdout
        missing = [line.split()[0] for line in listed.split("\n") if "not found" in line]
        if missing:
            raise FileNotFoundError(
                f"{file.name} needs {', '.join(missing)}: install it and build again"
            )


def ship_machine_code(program: Path) -> None:
    """For each level of processor this machine can run: what the frozen program itself compiles for the cases of the
    examples, by batch and in the window."""
    from llvmlite.binding import get_host_cpu_features

    has = {name for name, there in get_host_cpu_features().items() if there}
    for level, needed in shipped.LEVELS.items():
        if MACHINE != "x86_64" or not has >= needed:
            print(f"no machine code for {level}: this processor cannot run it")
            continue
        with tempfile.TemporaryDirectory() as name:
            variables = smoke.variables(Path(name), **{shipped.FORCED_LEVEL: level})
            for case in smoke.CASES:
                smoke.batch(program, case, Path(name) / "results", variables)
            smoke.window(program, Path(name), variables)
            made = next(Path(variables["RIBALTA_CACHE"]).glob("kernels-*"))
            target = INTERNAL / "kernels" / level
            target.mkdir(parents=True)
            for file in made.glob("*.nb[ci]"):
                shutil.copy2(file, target)
        hashes = {
            file.name: hashlib.sha256(file.read_bytes()).hexdigest() for file in target.iterdir()
        }
        (target / shipped.MANIFEST).write_text(json.dumps(hashes, indent=0), encoding="ascii")


def size(folder: Path) -> int:
    """Bytes of the files below a folder, of a file its own."""
    files = [folder] if folder.is_file() else folder.rglob("*")
    return sum(file.lstat().st_size for file in files if file.is_file() or file.is_symlink())


def print_sizes(products: list[Path]) -> None:
    """Of the folder, of what costs most in it, and of the products, beside those of the last build."""
    known = json.loads(SIZES.read_text(encoding="ascii")) if SIZES.exists() else {}
    last = known.get(SYSTEM, {})
    inside = {place.name: size(place) for place in INTERNAL.iterdir()}
    great = dict(sorted(inside.items(), key=lambda item: -item[1])[:12])
    now = {"unpacked": size(FOLDER)} | {place.suffix: size(place) for place in products} | great
    for name, count in now.items():
        change = f"{(count - last[name]) / 1e6:+8.1f}" if name in last else "     new"
        print(f"{name:40} {count / 1e6:8.1f} MB {change}")
    SIZES.write_text(json.dumps(known | {SYSTEM: now}, indent=1) + "\n", encoding="ascii")


def archive() -> Path:
    """The folder in one file: .tar.zst where there is zstd, else .zip."""
    name = DIST / f"ribalta-{VERSION}-{SYSTEM}"
    if not shutil.which("zstd"):
        return Path(shutil.make_archive(str(name), "zip", DIST, "ribalta"))
    whole, packed = Path(f"{name}.tar"), Path(f"{name}.tar.zst")
    subprocess.run(
        ["tar", "-C", DIST, "--sort=name", "--owner=0", "--group=0", "-cf", whole, "ribalta"],
        check=True,
    )
    subprocess.run(
        ["zstd", "-q", "--ultra", "-22", "--long=27", "-T0", "--rm", "-f", whole, "-o", packed],
        check=True,
    )
    return packed


CONTROL = """Package: ribalta
Version: {version}
Architecture: {machine}
Maintainer: Ribalta
Installed-Size: {kilobytes}
Depends: {packages}
Section: science
Priority: optional
Description: Out-of-plane overturning of masonry walls
 How strong an earthquake a masonry wall withstands before it overturns out of
 its plane, and how far that is from the "q = 2" of the Italian code.
"""


def _needed_packages() -> str:
    """Debian packages of the libraries that the program takes from the system."""
    inside = {file.name for file in INTERNAL.rglob("*.so*")}
    files = [FOLDER / "ribalta", *INTERNAL.rglob("*.so*")]
    listed = subprocess.run(["ldd", *files], capture_output=True, text=True).stdout.split("\n")
    outside = {Path(line.split("=>")[1].split()[0]) for line in listed if "=> /" in line}
    found = [licences.of_system(file) for file in outside if file.name not in inside]
    names = {part.name for part in found if part.purl.startswith("pkg:deb/")}
    oldest = f"libc6 (>= {platform.libc_ver()[1]})"
    return ", ".join(sorted((names - {"libc6"}) | {oldest}))


def debian_package() -> Path:
    """A package of Debian and Ubuntu: the program below /opt, its command, menu entry, icon and kind of file."""
    target = DIST / f"ribalta_{VERSION}_{SYSTEM.split('-')[1].replace('x86_64', 'amd64')}.deb"
    with tempfile.TemporaryDirectory() as name:
        root = Path(name)
        root.chmod(0o755)
        shutil.copytree(FOLDER, root / "opt" / "ribalta", symlinks=True)
        (root / "usr/bin").mkdir(parents=True)
        (root / "usr/bin/ribalta").symlink_to("/opt/ribalta/ribalta")
        for source, place in (
            (ROOT / "packaging/linux/ribalta.desktop", "usr/share/applications/ribalta.desktop"),
            (ROOT / "packaging/linux/ribalta.xml", "usr/share/mime/packages/ribalta.xml"),
            (icon.PNG, "usr/share/icons/hicolor/256x256/apps/ribalta.png"),
            (icon.PNG, "usr/share/icons/hicolor/256x256/mimetypes/application-x-ribalta-case.png"),
            (ROOT / "LICENSE", "usr/share/doc/ribalta/copyright"),
        ):
            (root / place).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, root / place)
        (root / "DEBIAN").mkdir()
        machine = "amd64" if MACHINE == "x86_64" else MACHINE
        control = CONTROL.format(version=VERSION, machine=machine, kilobytes=size(root) // 1024,
                                 packages=_needed_packages())  # fmt: skip
        (root / "DEBIAN/control").write_text(control, encoding="ascii")
        command = ["dpkg-deb", "--root-owner-group", "-Zxz", "-b", root, target]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return target


def main() -> int:
    words = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    words.add_argument("--no-smoke", action="store_true", help="do not try what was built")
    options = words.parse_args()
    make_parts()
    freeze()
    refuse_missing_libraries()
    strip()
    program = smoke.program_of(FOLDER)
    qt = "_internal/PySide6/Qt/lib" if sys.platform != "win32" else "_internal/PySide6"
    found = licences.gather(WORK / "ribalta", FOLDER / "licences", VERSION, qt)
    print(f"licences of {len(found)} parts, parts list: licences/sbom.cdx.json")
    ship_machine_code(program)
    products = [archive()]
    if sys.platform.startswith("linux") and shutil.which("dpkg-deb"):
        products.append(debian_package())
    print_sizes(products)
    return 0 if options.no_smoke else smoke.main(FOLDER)


if __name__ == "__main__":
    sys.exit(main())
