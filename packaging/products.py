"""What goes to the users: the folder as an archive, the Debian package, the application of macOS."""

import platform
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import icon
import licences

from core.version import VERSION

ROOT = Path(__file__).resolve().parents[1]
DIST = ROOT / "dist"
FOLDER = DIST / "ribalta"
INTERNAL = FOLDER / "_internal"
MACHINE = {"AMD64": "x86_64", "x86_64": "x86_64", "arm64": "arm64", "aarch64": "arm64"}[platform.machine()]
SYSTEM = f"{ {'win32': 'windows', 'darwin': 'macos'}.get(sys.platform, 'linux') }-{MACHINE}"


MADE = ("ribalta", "Ribalta.app", *(f"ribalta-*-{SYSTEM}{end}" for end in (".zip", ".tar", ".tar.zst", ".tar.xz")))
"""Patterns of what `make` leaves in dist on this system, beside the Debian package. Wheels, the site and recipes, which
stand there too, are of other commands."""


def remove_former() -> None:
    """Remove from dist what an earlier build made there, of any version, and nothing else."""
    for pattern in (*MADE, debian_name("*")):
        for place in DIST.glob(pattern):
            if place.is_dir() and not place.is_symlink():
                shutil.rmtree(place)
            else:
                place.unlink()


def make() -> list[Path]:
    """All of this system; the files."""
    made = [archive()]
    if sys.platform.startswith("linux") and shutil.which("dpkg-deb"):
        made.append(debian_package())
    return made


def application() -> Path:
    """The .app that PyInstaller made of the folder, with what build.py added to the folder, signed anew for this."""
    app = DIST / "Ribalta.app"
    shutil.copytree(FOLDER / "licences", app / "Contents" / "Resources" / "licences")
    if (INTERNAL / "kernels").exists():
        shutil.copytree(INTERNAL / "kernels", app / "Contents" / "Frameworks" / "kernels")
    subprocess.run(["codesign", "--force", "--deep", "--sign", "-", app], check=True)
    return app


def archive() -> Path:
    """The program in one file: .zip for Windows and macOS, .tar.zst for Linux, .tar.xz where there is no zstd."""
    name = DIST / f"ribalta-{VERSION}-{SYSTEM}"
    if sys.platform == "win32":
        return Path(shutil.make_archive(str(name), "zip", DIST, "ribalta"))
    if sys.platform == "darwin":
        packed = Path(f"{name}.zip")
        subprocess.run(["ditto", "-c", "-k", "--keepParent", application(), packed], check=True)
        return packed
    if not shutil.which("zstd"):
        return Path(shutil.make_archive(str(name), "xztar", DIST, "ribalta"))
    whole, packed = Path(f"{name}.tar"), Path(f"{name}.tar.zst")
    subprocess.run(["tar", "-C", DIST, "--sort=name", "--owner=0", "--group=0", "-cf", whole, "ribalta"], check=True)
    subprocess.run(["zstd", "-q", "--ultra", "-22", "--long=27", "-T0", "--rm", "-f", whole, "-o", packed], check=True)
    return packed


def size(folder: Path) -> int:
    """Bytes of the files below a folder, of a file its own."""
    files = [folder] if folder.is_file() else folder.rglob("*")
    return sum(file.lstat().st_size for file in files if file.is_file() or file.is_symlink())


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


def debian_name(version: str) -> str:
    """Name of the Debian package of a version."""
    return f"ribalta_{version}_{SYSTEM.split('-')[1].replace('x86_64', 'amd64')}.deb"


def debian_package() -> Path:
    """A package of Debian and Ubuntu: the program below /opt, its command, menu entry, icon and kind of file."""
    target = DIST / debian_name(VERSION)
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
        ):
            (root / place).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, root / place)
        about = root / "usr/share/doc/ribalta/copyright"
        about.parent.mkdir(parents=True)
        own = (ROOT / "LICENSE").read_text(encoding="utf-8")
        about.write_text(f"{own}\nParts of others and their licences: /opt/ribalta/licences\n")
        (root / "DEBIAN").mkdir()
        machine = "amd64" if MACHINE == "x86_64" else MACHINE
        control = CONTROL.format(
            version=VERSION, machine=machine, kilobytes=size(root) // 1024, packages=_needed_packages()
        )
        (root / "DEBIAN/control").write_text(control, encoding="ascii")
        command = ["dpkg-deb", "--root-owner-group", "-Zxz", "-b", str(root), str(target)]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return target
