"""The imports of the window, without what only takes time: a third of its start."""

import contextlib
import gc
import sys
import types

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


def quicken() -> None:
    """Before the window is imported.

    Python's collector finds nothing in the imports; `worker.Collector` takes its place. PySide reads the source of
    each module imported after it, to see whether it may ask for Qt's optional names, which no module here
    does. pyqtgraph copies each of Qt's thousand classes, and PySide makes each of them for that.
    """
    gc.disable()
    import PySide6
    import shiboken6  # noqa: F401

    if not internals_known(PySide6):
        return
    with contextlib.suppress(ImportError, AttributeError):
        from shibokensupport import feature

        if callable(feature._mod_uses_pyside):
            feature._mod_uses_pyside = lambda module: True
    if "pyqtgraph" in sys.modules:
        return
    from PySide6 import QtCore, QtGui, QtWidgets

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
