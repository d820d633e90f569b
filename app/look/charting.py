"""pyqtgraph, imported with the first chart, without what only takes time: an eighth of the start of the window."""

import contextlib
import sys
import types

import PySide6
from PySide6 import QtCore, QtGui, QtWidgets

from core.known_internals import internals_known


class Mirror(types.ModuleType):
    """pyqtgraph's own copy of a Qt module, each name copied when it is first asked for."""

    def __init__(self, name: str, source: types.ModuleType):
        super().__init__(name)
        self._source = source

    def __getattr__(self, name: str):
        value = getattr(self._source, name)
        setattr(self, name, value)
        return value


def _import_quickly() -> None:
    """pyqtgraph copies each of Qt's thousand classes, and PySide makes each of them for that."""
    if "pyqtgraph" in sys.modules or not internals_known(PySide6):
        return
    with contextlib.ExitStack() as after:
        for source in (QtCore, QtGui, QtWidgets):
            name = source.__name__.replace("PySide6", "pyqtgraph.Qt")
            sys.modules[name] = Mirror(name, source)
            own = source.__dict__.get("__dir__")
            after.callback(*((setattr, source, "__dir__", own) if own else (delattr, source, "__dir__")))
            source.__dict__["__dir__"] = list  # of nothing: what pyqtgraph is to copy
        import pyqtgraph
    if not internals_known(pyqtgraph):  # as it is by itself
        for name in [name for name in sys.modules if name.split(".")[0] == "pyqtgraph"]:
            del sys.modules[name]


_import_quickly()

import pyqtgraph as pg  # noqa: E402

pg.setConfigOptions(antialias=True, exitCleanup=False)
