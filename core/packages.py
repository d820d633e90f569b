"""Packages that not every installation has: asked for before the work that needs them, not after."""

import importlib
from pathlib import Path

from core.errors import OutputError
from core.text.sentence import Sentence, sentence
from core.version import build

PACKAGES = {
    "report": {"docx": "python-docx", "typst": "typst", "pypdf": "pypdf"},
    "study": {"matplotlib": "matplotlib"},
    "accuracy": {"scipy": "scipy"},
    "parquet": {"pyarrow": "pyarrow"},
    "dxf": {"ezdxf": "ezdxf"},
    "scheduler": {"distributed": "distributed", "cryptography": "cryptography"},
}
"""Extra -> module asked for and the package it is of."""

MAX_WALLS_IN_WORKBOOK = 10_000
"""Walls about all their hinges beyond which a case needs `parquet`: of each some 60 rows of the sheet Check, of the
million a workbook has."""

NOT_FROZEN = ("parquet", "scheduler")
"""Extras that the program of packaging/build.py does not hold."""


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
                way=way_to_get(" ".join(names), extra in NOT_FROZEN),
            ) from None


def way_to_get(packages: str, not_frozen: bool = False) -> Sentence:
    """How this installation gets packages: a folder of sources, a program of packaging/build.py, a wheel. not_frozen :
    that program never holds them"""
    if build():
        return sentence("word", "way_sources_only" if not_frozen else "way_frozen")
    if (Path(__file__).resolve().parents[1] / "run.py").is_file():
        return sentence("word", "way_sources")
    return sentence("word", "way_wheel", packages=packages)
