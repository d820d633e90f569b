"""How tests drive the window."""

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
