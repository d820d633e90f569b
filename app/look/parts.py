"""What shows a case, part by part."""

import contextlib
from collections.abc import Callable, Iterator

from PySide6.QtCore import QObject, Signal


class Parts(QObject):
    """Parts of a window or form that follow the session. Each is a slot of one signal: what it raises goes to the hook
    of errors (app/shell/start.py) and stops none of the others."""

    _due = Signal()

    def __init__(self, owner: QObject, *parts: Callable[[], None]):
        super().__init__(owner)
        self._held = self._wanted = False
        for part in parts:
            self._due.connect(part)

    def show(self) -> None:
        """Have all parts show the case as it is, in their order."""
        if self._held:
            self._wanted = True
        else:
            self._due.emit()

    @contextlib.contextmanager
    def once(self) -> Iterator[None]:
        """Show only the last of all changes made within it, where there is one."""
        self._held, self._wanted = True, False
        try:
            yield
        finally:
            self._held = False
            if self._wanted:
                self.show()
