"""How tests drive the window."""

import threading
import time

from PySide6.QtCore import QEventLoop, QTimer
from PySide6.QtTest import QTest


def settle(application, ready, seconds=120.0) -> None:
    """Handle events until it is so. What is awaited of a thread may come without an event: it is asked every 5 ms."""
    end, beat = time.monotonic() + seconds, QTimer()
    beat.start(5)
    while not ready():
        assert time.monotonic() < end, "nothing came within the time"
        # with a time limit Qt does not wait: a loop of it takes the processor from the thread it waits for
        application.processEvents(QEventLoop.ProcessEventsFlag.WaitForMoreEvents)
    application.processEvents()


def run(application, made) -> None:
    made.run()
    settle(application, lambda: made.runner.job is None)


def type_into(field, text: str) -> None:
    """Type in the place of what a field holds, then rest."""
    field.editor.setFocus()
    field.editor.selectAll()
    QTest.keyClicks(field.editor, text)
    rest(field)


def rest(field) -> None:
    """Let the hand rest: what waits for it follows."""
    if parts := getattr(field.window(), "parts", None):
        parts.flush_pending()


class Held:
    """A function of a module that waits until it is let go, in whatever thread it is called.

    instead : called in its place then; the function itself where none is given.
    """

    def __init__(self, monkeypatch, module, name: str, instead=None):
        self.reached, self.free = threading.Event(), threading.Event()
        real = instead or getattr(module, name)

        def waiting(*arguments):
            self.reached.set()
            self.free.wait(60)
            return real(*arguments)

        monkeypatch.setattr(module, name, waiting)

    def await_call(self) -> None:
        assert self.reached.wait(60), "it was not called"

    def let_go(self) -> None:
        self.free.set()
