"""Recipes for winget, Homebrew and conda-forge, of what a release holds.

    python3 packaging/recipes.py --address URL INSTALLER SOURCES

INSTALLER: of Windows; SOURCES: the archive of the sources. The hashes are those of the files; the dependencies of the
package of conda are those of pyproject.toml. They go to dist/recipes.
"""

import argparse
import hashlib
import re
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from core.version import VERSION  # noqa: E402

IDENTIFIER = "Ribalta.Ribalta"
ABOUT = "Out-of-plane overturning of masonry walls: rocking analysis and code checks"
WINGET = "1.6.0"
"""Version of the schema of the manifests."""

OF_WINGET = {
    "version": ("PackageIdentifier", "PackageVersion", "DefaultLocale"),
    "installer": ("PackageIdentifier", "PackageVersion", "InstallerType", "Installers"),
    "defaultLocale": (
        *("PackageIdentifier", "PackageVersion", "PackageLocale", "Publisher", "PackageName", "License"),
        "ShortDescription",
    ),
}
"""Kind of a manifest of winget -> the keys that its schema requires beside ManifestType and ManifestVersion."""


def sha256(path: Path) -> str:
    """SHA-256 of a file."""
    return hashlib.sha256(path.read_bytes()).hexdigest()


def winget(address: str, installer: Path) -> dict[str, str]:
    """The three manifests of winget, by their names."""
    head = f"PackageIdentifier: {IDENTIFIER}\nPackageVersion: {VERSION}\n"
    foot = f"ManifestVersion: {WINGET}\n"
    texts = {
        "version": "DefaultLocale: en-US\n",
        "installer": "InstallerType: inno\nScope: user\nInstallers:\n- Architecture: x64\n"
        f"  InstallerUrl: {address}/{installer.name}\n  InstallerSha256: {sha256(installer).upper()}\n",
        "defaultLocale": "PackageLocale: en-US\nPublisher: The Ribalta authors\nPackageName: Ribalta\n"
        f'License: BSD-3-Clause\nShortDescription: "{ABOUT}"\n',
    }
    ends = {"version": "", "installer": ".installer", "defaultLocale": ".locale.en-US"}
    return {
        f"winget/{IDENTIFIER}{ends[kind]}.yaml": f"{head}{text}ManifestType: {kind}\n{foot}"
        for kind, text in texts.items()
    }


def homebrew(address: str, sources: Path) -> dict[str, str]:
    """The formula of Homebrew: the program in an environment of its own."""
    lines = [
        "class Ribalta < Formula",
        "  include Language::Python::Virtualenv",
        f'  desc "{ABOUT}"',
        f'  homepage "{address}"',
        f'  url "{address}/{sources.name}"',
        f'  sha256 "{sha256(sources)}"',
        '  license "BSD-3-Clause"',
        '  depends_on "python@3.13"',
        "",
        "  def install",
        '    virtualenv_create(libexec, "python3.13")',
        '    system libexec/"bin/python", "-m", "pip", "install", "#{buildpath}[gui,study,report]"',
        '    bin.install_symlink libexec/"bin/ribalta"',
        "  end",
        "",
        "  test do",
        f'    assert_match "{VERSION}", shell_output("#{{bin}}/ribalta --version")',
        "  end",
        "end",
    ]
    return {"homebrew/ribalta.rb": "\n".join(lines) + "\n"}


def of_conda(requirement: str) -> str:
    """A requirement of pyproject.toml as conda writes it."""
    name, bounds = re.fullmatch(r"([\w.-]+)\s*([^;]*)(?:;.*)?", requirement).groups()  # type: ignore[union-attr]
    known = {"pyside6-essentials": "pyside6"}
    return f"{known.get(name.lower(), name.lower())} {bounds.strip()}".strip()


def conda(address: str, sources: Path) -> dict[str, str]:
    """The recipe of conda-forge (schema version 1)."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    extras = project["optional-dependencies"]
    asked = [*project["dependencies"], *(one for group in ("gui", "study", "report") for one in extras[group])]
    runs = "".join(f"    - {one}\n" for one in dict.fromkeys(map(of_conda, asked)))
    text = (
        f'schema_version: 1\n\ncontext:\n  version: "{VERSION}"\n\npackage:\n  name: {project["name"]}\n'
        "  version: ${{ version }}\n\n"
        f"source:\n  url: {address}/{sources.name}\n  sha256: {sha256(sources)}\n\n"
        "build:\n  number: 0\n  noarch: python\n"
        "  script: ${{ PYTHON }} -m pip install . --no-deps --no-build-isolation\n"
        f"  python:\n    entry_points:\n    - ribalta = {project['scripts']['ribalta']}\n\n"
        f"requirements:\n  host:\n    - python {project['requires-python'].split(',')[0]}\n    - hatchling\n    - pip\n"
        f"  run:\n    - python {project['requires-python']}\n{runs}\n"
        "tests:\n- python:\n    imports:\n    - ribalta_rocking\n- script:\n  - ribalta --version\n\n"
        f'about:\n  summary: "{ABOUT}"\n  license: BSD-3-Clause\n  license_file: LICENSE\n'
    )
    return {"conda-forge/recipe.yaml": text}


def main() -> int:
    words = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    words.add_argument("--address", required=True, help="below which the files of the release are served")
    words.add_argument("--output", type=Path, default=ROOT / "dist" / "recipes")
    words.add_argument("installer", type=Path, help="of Windows")
    words.add_argument("sources", type=Path, help="archive of the sources")
    options = words.parse_args()
    address = options.address.rstrip("/")
    made = winget(address, options.installer) | homebrew(address, options.sources) | conda(address, options.sources)
    for name, text in made.items():
        path = options.output / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        print(path)
    return 0


if __name__ == "__main__":
    sys.exit(main())
