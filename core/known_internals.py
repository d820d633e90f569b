"""Packages of which internals are replaced to start quicker, and the versions whose internals are known. With another
version everything stays as it is: slower, the same results."""

from types import ModuleType

KNOWN = {"numba": ("0.62", "0.68"), "PySide6": ("6.8", "6.10"), "pyqtgraph": ("0.14", "0.14")}
"""Package -> first and last version, major and minor number."""


def internals_known(package: ModuleType) -> bool:
    """Whether the internals of an imported package are those its replacements were written for."""
    first, last = KNOWN[package.__name__]
    return _release(first) <= _release(package.__version__) <= _release(last)


def _release(version: str) -> tuple[int, ...]:
    return tuple(int(part) for part in version.split(".")[:2])
