"""What shows a case, part by part."""

from collections.abc import Callable

from PySide6.QtCore import QObject, Signal


class Parts(QObject):
    """Parts of a window or form that follow the session. Each is a slot of one signal: what it raises goes to the hook
    of errors (app/shell/start.py) and stops none of the others."""

    _due = Signal()

    def __init__(self, owner: QObject, *parts: Callable[[], None]):
        super().__init__(owner)
        for part in parts:
            self._due.connect(part)

    def show(self) -> None:
        """Have all parts show the case as it is, in their order."""
        self._due.emit()
