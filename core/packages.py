"""Packages that not every installation has: asked for before the work that needs them, not after."""

import importlib
from pathlib import Path
from types import ModuleType

from core.errors import OutputError
from core.text.sentence import Sentence, sentence
from core.version import build

PACKAGES = {
    "report": {"docx": "python-docx", "matplotlib": "matplotlib"},
    "study": {"matplotlib": "matplotlib", "scipy": "scipy"},
    "accuracy": {"scipy": "scipy"},
}
"""Extra -> module asked for and the package it is of."""


KNOWN_INTERNALS = {"numba": ("0.62", "0.68"), "PySide6": ("6.8", "6.10"), "pyqtgraph": ("0.14", "0.14")}
"""Packages of which internals are replaced to start quicker -> first and last version whose internals are known. With
another one everything stays as it is: slower, the same results."""


def internals_known(package: ModuleType) -> bool:
    """Whether the internals of an imported package are those its replacements were written for."""
    first, last = KNOWN_INTERNALS[package.__name__]
    return _release(first) <= _release(package.__version__) <= _release(last)


def _release(version: str) -> tuple[int, ...]:
    """Major and minor number."""
    return tuple(int(part) for part in version.split(".")[:2])


def require(extra: str) -> None:
    """Raise OutputError where a package of this extra cannot be imported."""
    for module in PACKAGES[extra]:
        try:
            importlib.import_module(module)
        except ImportError as error:
            names = tuple(PACKAGES[extra].values())
            raise OutputError(
                "packages_missing",
                work=sentence("word", f"work_{extra}"),
                packages=names,
                reason=str(error),
                way=way_to_get(" ".join(names)),
            ) from None


def way_to_get(packages: str) -> Sentence:
    """How this installation gets packages: a folder of sources, a program of packaging/build.py, a wheel."""
    if build():
        return sentence("word", "way_frozen")
    if (Path(__file__).resolve().parents[1] / "run.py").is_file():
        return sentence("word", "way_sources")
    return sentence("word", "way_wheel", packages=packages)
