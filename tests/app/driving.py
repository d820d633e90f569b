"""How tests drive the window."""

import threading
import time

from PySide6.QtCore import QEventLoop
from PySide6.QtTest import QTest


def settle(application, ready, seconds=120.0) -> None:
    end = time.monotonic() + seconds
    while not ready():
        assert time.monotonic() < end, "nothing came within the time"
        application.processEvents(QEventLoop.ProcessEventsFlag.WaitForMoreEvents, 5)
    application.processEvents()


def run(application, made) -> None:
    made.run()
    settle(application, lambda: made.job is None)


def type_into(field, text: str) -> None:
    field.editor.setFocus()
    field.editor.selectAll()
    QTest.keyClicks(field.editor, text)


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
