"""What shows a case, part by part: at once, or when the hand that types rests."""

import contextlib
from collections.abc import Callable, Iterable, Iterator

from PySide6.QtCore import QElapsedTimer, QObject, QTimer, Signal
from PySide6.QtWidgets import QWidget

TYPING_PAUSE_MS, MAX_REST_MS = 120, 1000
"""How long no key comes before the parts that wait for it show the case, and how long they wait for that at most."""

_typing = False


@contextlib.contextmanager
def typed_edit() -> Iterator[None]:
    """What changes the case within it is a key typed into a line: the next one may follow at once."""
    global _typing
    before, _typing = _typing, True
    try:
        yield
    finally:
        _typing = before


class CaseViews(QObject):
    """Parts of a window or form that follow the session. Each is a slot of one signal: what it raises goes to the hook
    of errors (app/shell/start.py) and stops none of the others.

    parts : show the case at each of its changes; resting : while keys are typed, only when the hand rests
    """

    _due, _rested = Signal(), Signal()

    def __init__(
        self, owner: QObject, *parts: Callable[[], object], resting: Iterable[Callable[[], object]] = ()
    ) -> None:
        super().__init__(owner)
        self._held = self._wanted = False
        self._rest = QTimer(self, singleShot=True, interval=TYPING_PAUSE_MS)
        self._rest.timeout.connect(self._rested)
        self._typed = QElapsedTimer()
        for part in parts:
            self._due.connect(part)
        for part in resting:
            self._rested.connect(part)

    def show(self) -> None:
        """Have all parts show the case as it is, in their order; after a key those that wait follow."""
        if self._held:
            self._wanted = True
            return
        self._due.emit()
        if _typing:
            if not self._rest.isActive():
                self._typed.start()
            if self._typed.elapsed() < MAX_REST_MS:
                self._rest.start()
        else:
            self._rest.stop()
            self._rested.emit()

    def wait(self) -> bool:
        """Whether keys are being typed."""
        return self._rest.isActive()

    def flush_pending(self) -> None:
        """Have the parts that wait show the case now: what follows acts on what they say."""
        if self.wait():
            self._rest.stop()
            self._rested.emit()

    @contextlib.contextmanager
    def once(self) -> Iterator[None]:
        """Show only the last of all changes made within it, where there is one."""
        self._held, self._wanted = True, self.wait()
        self._rest.stop()
        try:
            yield
        finally:
            self._held = False
            if self._wanted:
                self.show()


class VisibleForm:
    """A form that shows the case at once where it is in sight, when the hand rests where it is not."""

    def __init__(self, form: QWidget, show_case: Callable[[], object]):
        self.form, self.show_case = form, show_case
        self.waits = False

    def at_once(self) -> None:
        """The case has changed."""
        self.waits = not self.form.isVisible()
        if not self.waits:
            self.show_case()

    def at_rest(self) -> None:
        """The hand rests."""
        if self.waits:
            self.waits = False
            self.show_case()
