"""Licences of every part of the frozen program, and its parts list (SBOM, CycloneDX 1.5).

The parts are found from what PyInstaller put in, not from a list by hand: Python modules and libraries of a wheel
belong to its distribution, libraries of the system to their Debian package, the rest to Python itself.
"""

import ast
import csv
import importlib.metadata
import json
import os
import platform
import re
import shutil
import subprocess
import sys
import sysconfig
import uuid
from dataclasses import dataclass, field
from pathlib import Path

import second_solver

TEXTS = Path(__file__).with_name("licence_texts")

NAMES = re.compile(r"(licen[cs]e|copying|notice|authors)", re.IGNORECASE)

QT = """Exchanging Qt
=============
Ribalta uses Qt {qt} and PySide6 {qt} under the GNU Lesser General Public License, version 3 (LGPL-3.0.txt, with
GPL-3.0.txt which it refers to). Both are linked dynamically and are the files of the wheels PySide6-Essentials and
shiboken6 {qt} of the Python Package Index, unchanged; of ICU, which is not part of Qt, the data (libicudata) hold the
order of words alone.

To use a Qt of your own, build it (its sources: download.qt.io, those of PySide6: code.qt.io/pyside/pyside-setup) with
the same major and minor version and put its libraries in the place of those in {place}; no part of Ribalta has to be
made again, and none checks them. Nothing in the terms of Ribalta forbids to modify these libraries for
your own use or to reverse engineer for debugging such modifications.

The other libraries of Linux are those of their Debian packages and wheels, without their symbols.

What Qt itself contains of others, with its licences: doc.qt.io/qt-6/licenses-used-in-qt.html
"""


COMMON = Path("/usr/share/common-licenses")
"""Texts that copyright files of Debian refer to."""


@dataclass
class Part:
    """What was packed of one project: licence as it states it, files of licence texts; `inside`, (name, version,
    licence) of what its files contain of others' libraries, beside what their texts say of it."""

    name: str
    version: str
    purl: str
    licence: str
    texts: list[Path] = field(default_factory=list)
    inside: list[tuple[str, str, str]] = field(default_factory=list)


def _inside(name: str, version: str) -> list[tuple[str, str, str]]:
    if name == "numpy":
        built = importlib.import_module("numpy.__config__").CONFIG["Build Dependencies"]["blas"]
        return [("OpenBLAS", built["version"], "BSD-3-Clause")]
    if name == "llvmlite":
        from llvmlite.binding import llvm_version_info

        return [("LLVM", ".".join(map(str, llvm_version_info)), "Apache-2.0 WITH LLVM-exception")]
    if name == "PySide6_Essentials":
        files = [file.name for file in importlib.metadata.files(name) or ()]
        icu = [file.rsplit(".", 1)[1] for file in files if "icudata.so." in file]
        unicode = [("ICU", number, "Unicode-DFS-2016") for number in icu]
        return [("Qt", version, "LGPL-3.0-only"), *unicode]
    return []


def _of_distribution(name: str) -> Part:
    found = importlib.metadata.distribution(name)
    about = found.metadata
    expressions = (about.get_all("License-Expression") or []) + (about.get_all("License") or [])
    stated = next(filter(None, expressions), "")
    if not stated or len(stated) > 100:  # a whole text in the field of the name
        kinds = [line for line in about.get_all("Classifier") or () if line.startswith("License ::")]
        stated = "; ".join(line.rsplit(" :: ", 1)[-1] for line in kinds)
    texts = [
        Path(str(found.locate_file(file)))
        for file in found.files or ()
        if re.search(r"\.dist-info/(licenses|sboms)/", file.as_posix())
        or (".dist-info/" in file.as_posix() and NAMES.search(file.name))
    ]
    name = about["Name"]
    if re.match("(?i)pyside6|shiboken6", name):
        texts += sorted(TEXTS.glob("*.txt"))
    return Part(
        name,
        found.version,
        f"pkg:pypi/{name.lower().replace('_', '-')}@{found.version}",
        stated,
        texts,
        _inside(name, found.version),
    )


def _stated(text: str) -> str:
    """The licences that a copyright file of Debian names, in its machine-readable form."""
    names = re.findall(r"^License: *(\S.*)$", text, re.MULTILINE)
    return "; ".join(dict.fromkeys(names)) or "see its text"


def of_system(file: Path) -> Part:
    """The Debian package of a library; the bare file where there is no such package."""
    for place in (file, file.resolve()):
        owner = (
            shutil.which("dpkg") and subprocess.run(["dpkg", "-S", str(place)], capture_output=True, text=True).stdout
        )
        if owner:
            name = owner.split(":")[0]
            version = subprocess.run(
                ["dpkg-query", "-W", "-f", "${Version}", name], check=True, capture_output=True, text=True
            ).stdout
            text = Path("/usr/share/doc") / name / "copyright"
            purl = f"pkg:deb/debian/{name}@{version}"
            if not text.exists():
                return Part(name, version, purl, "")
            return Part(name, version, purl, _stated(text.read_text(encoding="utf-8")), [text])
    return Part(file.name, "", f"pkg:generic/{file.name}", "")


def _of_python() -> Part:
    version = platform.python_version()
    texts = [Path(sysconfig.get_path("stdlib")) / "LICENSE.txt"]
    texts = [text for text in texts if text.exists()]
    return Part("Python", version, f"pkg:generic/python@{version}", "PSF-2.0", texts)


def _listed(file: Path) -> list[tuple]:
    """Entries (name, source, kind) of a list that PyInstaller made."""
    return next(part for part in ast.literal_eval(file.read_text(encoding="utf-8")) if isinstance(part, list))


def parts(work: Path) -> list[Part]:
    """What PyInstaller packed. work : its folder of work, with the lists it made"""
    owners = {
        os.path.normpath(os.path.join(str(found.locate_file("")), row[0])): name
        for found in importlib.metadata.distributions()
        for name in [found.name]
        for row in csv.reader((found.read_text("RECORD") or "").splitlines())
    }
    python = Path(sys.base_prefix).resolve()
    distributions, system = {"pyinstaller"}, {}  # its starter is the program's first code
    for name in ("PYZ-00.toc", "COLLECT-00.toc"):
        for _, source, kind in _listed(work / name):
            file = Path(os.path.normpath(source))
            if second_solver.__name__ in file.parts:  # its copies of files of scipy
                distributions.add("scipy")
            elif str(file) in owners:
                distributions.add(owners[str(file)])
            elif kind == "BINARY" and not file.resolve().is_relative_to(python):
                part = of_system(file)
                system[part.name] = part
    found = [_of_python(), *map(_of_distribution, distributions), *system.values()]
    return sorted(found, key=lambda part: part.name.lower())


def _component(part: Part) -> dict:
    def about(name: str, version: str, licence: str) -> dict:
        return {
            "type": "library",
            "name": name,
            "version": version,
            "licenses": [{"license": {"name": licence or "see its text"}}],
        }

    inside = [about(*other) for other in part.inside]
    component = about(part.name, part.version, part.licence) | {"purl": part.purl}
    return component | ({"components": inside} if inside else {})


def _copy_common(text: Path, target: Path) -> None:
    """Copy the texts that a copyright file of Debian refers to."""
    content = text.read_text(encoding="utf-8")
    for name in re.findall(rf"{COMMON}/([A-Za-z0-9]+(?:-\d+(?:\.\d+)?)?)", content):
        if (COMMON / name).exists():
            target.mkdir(exist_ok=True)
            shutil.copyfile(COMMON / name, target / name)


def gather(work: Path, target: Path, version: str, qt_place: str) -> list[Part]:
    """Write the texts of all parts, how to exchange Qt, and the parts list. Raises ValueError where a part has neither
    a text nor a licence that it states."""
    found = parts(work)
    nameless = [part.name for part in found if not part.texts and not part.licence]
    if nameless:
        raise ValueError(f"no licence found of {', '.join(nameless)}")
    for part in found:
        folder = target / f"{part.name}-{part.version}".rstrip("-").replace(":", "_")
        folder.mkdir(parents=True)
        for text in part.texts:
            place = folder / text.name
            if place.exists():  # several of one name, in folders of their own
                place = folder / f"{text.parent.name}-{text.name}"
            shutil.copyfile(text, place)
            if part.purl.startswith("pkg:deb/"):
                _copy_common(text, target / COMMON.name)
        if not part.texts:
            (folder / "LICENCE.txt").write_text(f"{part.name} states: {part.licence}\n")
    qt = importlib.metadata.version("PySide6-Essentials")
    (target / "QT.txt").write_text(QT.format(qt=qt, place=qt_place), encoding="utf-8")
    listing = {
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        "serialNumber": f"urn:uuid:{uuid.uuid4()}",
        "version": 1,
        "metadata": {
            "component": {
                "type": "application",
                "name": "Ribalta",
                "version": version,
                "licenses": [{"license": {"id": "BSD-3-Clause"}}],
            }
        },
        "components": [_component(part) for part in found],
    }
    (target / "sbom.cdx.json").write_text(json.dumps(listing, indent=1), encoding="utf-8")
    return found
