"""The wheel holds one package: what the repository has as app, core and resources, with the imports of the first two
written as of that package. Its parts are otherwise the files of the repository, byte for byte."""

import ast
import re
import shutil
from pathlib import Path

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

PACKAGE = "ribalta_rocking"
PARTS = "app", "core", "resources"
IMPORT = re.compile(rf"^([ \t]*(?:from|import)[ \t]+)({'|'.join(PARTS[:2])})\b", re.MULTILINE)

HEAD = '''"""Out-of-plane overturning of masonry walls: what may be imported, see `help(ribalta_rocking)` and the page
"Use from Python" of the documents. What is not named here may change."""

from ribalta_rocking.core.api import *  # noqa: F403
from ribalta_rocking.core.api import __all__, __doc__  # noqa: F401
from ribalta_rocking.core.version import VERSION as __version__  # noqa: F401
'''
OF_SOURCES = '''"""The package of an editable installation: the sources themselves, under their names there."""

from core.api import *  # noqa: F403
from core.api import __all__, __doc__  # noqa: F401
from core.version import VERSION as __version__  # noqa: F401

__path__ = [{root!r}]
'''
MAIN = '''"""python -m ribalta_rocking"""

import sys

from ribalta_rocking.app.__main__ import main

sys.exit(main())
'''


def moved(text: str) -> str:
    """A source of app or core as it is within the package."""
    return IMPORT.sub(rf"\1{PACKAGE}.\2", text)


def outside(text: str) -> list[str]:
    """Names of modules that a source imports from app or core as if they were no part of the package."""
    names: list[str] = []
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            names += [name.name for name in node.names]
        elif isinstance(node, ast.ImportFrom) and not node.level:
            names.append(node.module or "")
    return [name for name in names if name.split(".")[0] in PARTS]


def make(root: Path, folder: Path) -> Path:
    """Write the package of the sources below `root` into a folder; returns its place."""
    place = folder / PACKAGE
    for part in PARTS:
        shutil.copytree(root / part, place / part, ignore=shutil.ignore_patterns("__pycache__", "*.pyc"))
    for source in [*(place / "app").rglob("*.py"), *(place / "core").rglob("*.py")]:
        text = moved(source.read_bytes().decode())
        if left := outside(text):
            raise RuntimeError(f"{source}: still imports {', '.join(left)}")
        source.write_bytes(text.encode())
    (place / "__init__.py").write_text(HEAD, encoding="utf-8")
    (place / "__main__.py").write_text(MAIN, encoding="utf-8")
    (place / "py.typed").write_text("")
    return place


class Build(BuildHookInterface):
    """What hatchling asks before it packs a wheel; the archive of the sources is that of the repository."""

    def initialize(self, version: str, build_data: dict) -> None:
        """Make the package, and have it packed in place of the folders."""
        if self.target_name != "wheel":
            return
        folder = Path(self.directory) / "one_package"
        shutil.rmtree(folder, ignore_errors=True)
        if version == "editable":
            folder.mkdir(parents=True)
            (folder / "__init__.py").write_text(OF_SOURCES.format(root=self.root), encoding="utf-8")
            build_data["force_include_editable"][str(folder / "__init__.py")] = f"{PACKAGE}/__init__.py"
            return
        build_data["force_include"][str(make(Path(self.root), folder))] = PACKAGE

    def finalize(self, version: str, build_data: dict, artifact_path: str) -> None:
        """Take away what was made for the wheel."""
        shutil.rmtree(Path(self.directory) / "one_package", ignore_errors=True)
