"""The imports of the window, without what only takes time; those of charts are quickened in charting.py."""

import contextlib
import gc

from core.known_internals import internals_known


def quicken() -> None:
    """Before the window is imported.

    Python's collector finds nothing in the imports; `worker.Collector` takes its place. PySide reads the source of
    each module imported after it, to see whether it may ask for Qt's optional names, which no module here
    does.
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
