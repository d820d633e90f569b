"""Random clicks, keys, wheels, drags and sizes: no slot raises, Qt has no complaint, the window never stops."""

import os
import random
import sys
import time
import traceback

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from PySide6.QtCore import QPoint, QPointF, Qt, QTimer, QtMsgType, qInstallMessageHandler
from PySide6.QtGui import QDesktopServices, QKeySequence, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDialog, QFileDialog, QMenu, QMessageBox, QWidget
from shiboken6 import isValid

from app.shell.files import EXAMPLE
from app.shell.finder import every_action
from app.work.session import Session
from app.work.worker import RUNNING_JOBS
from tests.app.driving import settle

SIZES = ((1280, 800), (1920, 1080), (1024, 768), (960, 540))
KEYS = [
    getattr(Qt.Key, f"Key_{name}")
    for name in ["Tab", "Backtab", "Return", "Escape", "Space", "Left", "Right", "Up", "Down", "Delete"]
]
KEYS += [
    getattr(Qt.Key, f"Key_{name}")
    for name in ["Home", "End", "Backspace", "F1", "F5", "F11", "PageUp", "PageDown", "A", "Comma"]
]
CONTROL = Qt.KeyboardModifier.ControlModifier
WITH_CONTROL = [getattr(Qt.Key, f"Key_{letter}") for letter in "ZYKCVANSE12345678"]
FROZEN = 30.0
"""Of one event, with a run on two busy cores [s]: a loop that waits for itself never ends."""


class Hand:
    """Draws events by a seed and sends them."""

    def __init__(self, application, window, folder, seed: int):
        self.application, self.window, self.folder = application, window, folder
        self.draw, self.sent, self.longest = random.Random(seed), [], 0.0

    def widgets(self) -> list[QWidget]:
        """Those of the dialog in front, or of the window."""
        top = QApplication.activeModalWidget() or QApplication.activePopupWidget() or self.window
        if not top.isVisible():
            top = self.window
        return [top, *(one for one in top.findChildren(QWidget) if isValid(one) and one.isVisible())]

    def actions(self) -> list:
        """Those of the menus, but the one that ends the program."""
        end = QKeySequence(QKeySequence.StandardKey.Quit)
        return [one for one in every_action(self.window.header.menu) if one.isEnabled() and one.shortcut() != end]

    def event(self) -> None:
        """One more; what it was stands last in `sent`."""
        draw, one = self.draw, self.draw.choice(self.widgets())
        at = QPoint(draw.randrange(max(1, one.width())), draw.randrange(max(1, one.height())))
        kind = draw.choices(
            ("click", "right", "double", "drag", "key", "text", "control", "wheel", "size", "stage"),
            (30, 3, 4, 8, 16, 12, 8, 8, 3, 8),
        )[0]
        self.sent.append((kind, type(one).__name__, one.accessibleName(), at.toTuple()))
        start = time.monotonic()
        self._send(kind, one, at)
        self.application.processEvents()
        self.longest = max(self.longest, time.monotonic() - start)

    def _send(self, kind: str, one: QWidget, at: QPoint) -> None:
        draw, left = self.draw, Qt.MouseButton.LeftButton
        focus = self.application.focusWidget() or one
        if kind == "click":
            QTest.mouseClick(one, left, pos=at)
        elif kind == "right":
            QTest.mouseClick(one, Qt.MouseButton.RightButton, pos=at)
        elif kind == "double":
            QTest.mouseDClick(one, left, pos=at)
        elif kind == "drag":
            QTest.mousePress(one, left, pos=at)
            for _ in range(3):
                if isValid(one):
                    QTest.mouseMove(one, at + QPoint(draw.randint(-90, 90), draw.randint(-90, 90)))
            if isValid(one):
                QTest.mouseRelease(one, left, pos=at + QPoint(draw.randint(-90, 90), draw.randint(-90, 90)))
        elif kind == "key":
            QTest.keyClick(focus, draw.choice(KEYS))
        elif kind == "text":
            QTest.keyClicks(focus, draw.choice(("1", "0,45", "-", "abc", "1e400", "=A1", "[x]", "12.5")))
        elif kind == "control":
            QTest.keyClick(focus, draw.choice(WITH_CONTROL), CONTROL)
        elif kind == "wheel":
            turn, place = draw.choice((-240, -120, 120, 240)), QPointF(at)
            where = one.mapToGlobal(place)
            none, phase = Qt.MouseButton.NoButton, Qt.ScrollPhase.NoScrollPhase
            wheel = QWheelEvent(place, where, QPoint(), QPoint(0, turn), none, Qt.KeyboardModifier(0), phase, False)
            self.application.sendEvent(one, wheel)
        elif kind == "size":
            self.window.resize(*draw.choice(SIZES))
        else:  # the hand soon loses itself in one form
            draw.choice(
                (
                    lambda: self.window.navigator.show_page(draw.choice(list(self.window.pages))),
                    lambda: self.window.navigator.show_input(draw.choice(list(self.window.stages.input.areas))),
                    lambda: self.window.set_choice("theme", draw.choice(("light", "dark"))),
                    lambda: self.window.set_choice("language", draw.choice(("it", "en"))),
                    self.window.run,
                    self.window.session.undo,
                    lambda: draw.choice(self.actions()).trigger(),
                )
            )()


@pytest.fixture
def answered(monkeypatch, tmp_path):
    """Dialogs answer at random, files are in the folder of the test, no program is started. Yields the draw."""
    draw, button = random.Random(0), QMessageBox.StandardButton
    folder = tmp_path / "given"
    folder.mkdir()
    (folder / "noise.txt").write_text("\n".join(f"{0.1 * ((k * 7) % 13 - 6) / 6:.4f}" for k in range(400)))
    names = [str(folder / "noise.txt"), str(tmp_path / "small.toml"), str(folder / "none.toml"), ""]

    def name(*_, **__):
        return draw.choice(names), ""

    def to_write(*_, **__):
        return draw.choice(("", str(folder / f"out{draw.choice(('.toml', '.xlsx', '.png', '.pdf', '.csv'))}"))), ""

    monkeypatch.setattr(QFileDialog, "getOpenFileName", name)
    monkeypatch.setattr(QFileDialog, "getOpenFileNames", lambda *_, **__: ([one for one in [name()[0]] if one], ""))
    monkeypatch.setattr(QFileDialog, "getSaveFileName", to_write)
    monkeypatch.setattr(QFileDialog, "getExistingDirectory", lambda *_, **__: draw.choice(("", str(folder))))
    monkeypatch.setattr(
        QMessageBox, "question", lambda *_, **__: draw.choice((button.Yes, button.No, button.Discard, button.Cancel))
    )
    for kind in ("information", "warning", "critical", "about"):
        monkeypatch.setattr(QMessageBox, kind, lambda *_, **__: button.Ok)
    monkeypatch.setattr(QDesktopServices, "openUrl", lambda *_: True)
    monkeypatch.setattr(QMessageBox, "exec", lambda box: 0)

    save = Session.save

    def save_here(session, path=None) -> None:  # an example was opened: it is not to be written over
        target = path or session.path
        save(session, target if target.is_relative_to(tmp_path) else folder / target.name)

    monkeypatch.setattr(Session, "save", save_here)

    def shown(dialog) -> QDialog.DialogCode:
        dialog.show()
        QApplication.processEvents()
        for key in draw.choices(KEYS[:10], k=3):
            if isValid(dialog) and dialog.isVisible():
                QTest.keyClick(QApplication.focusWidget() or dialog, key)
        if isValid(dialog):
            dialog.hide()
        return draw.choice((QDialog.DialogCode.Accepted, QDialog.DialogCode.Rejected))

    monkeypatch.setattr(QDialog, "exec", shown)
    monkeypatch.setattr(QMenu, "exec", lambda menu, *_: None)
    return draw


def hurry(application, window, faults, tmp_path, draw, seed: int, count: int) -> Hand:
    """Send so many events, a quarter at each size; fails at the first that leaves a fault."""
    complaints: list[str] = []

    def complain(kind, _, words: str) -> None:
        if kind in (QtMsgType.QtCriticalMsg, QtMsgType.QtFatalMsg) or "QObject::" in words or "QPainter" in words:
            complaints.append(words)
        if kind == QtMsgType.QtFatalMsg:
            print(words, hand.sent[-1], file=sys.__stderr__)  # the process ends here

    def close_popup() -> None:
        popup = QApplication.activePopupWidget()
        if popup is not None:
            popup.close()

    closer = QTimer()  # a menu of a button has a loop of events of its own
    closer.timeout.connect(close_popup)
    closer.start(20)
    draw.seed(seed)
    hand, before = Hand(application, window, tmp_path, seed), qInstallMessageHandler(complain)
    try:
        for k in range(count):
            if k % max(1, count // 4) == 0:
                window.resize(*SIZES[min(3, 4 * k // count)])
            hand.event()
            told = ["".join(traceback.format_exception(fault)) for fault in faults] + complaints
            assert not told, f"event {k} of seed {seed}: {hand.sent[-5:]}: {' '.join(told)}"
            assert hand.longest < FROZEN, f"event {k} of seed {seed}: {hand.sent[-1]} took {hand.longest:.0f} s"
        window.runner.cancel()
        settle(application, lambda: window.runner.job is None and all(job.isFinished() for job in RUNNING_JOBS))
        assert not faults and not complaints
    finally:
        qInstallMessageHandler(before)
        for one in QApplication.topLevelWidgets():
            if isinstance(one, (QMenu, QDialog)):
                one.hide()
        closer.stop()
    return hand


@pytest.mark.parametrize(
    ("seed", "count"), [(4, 80), *(pytest.param(seed, 300, marks=pytest.mark.long) for seed in (1, 2))]
)
def test_that_hundreds_of_random_events_break_nothing(opened, application, faults, tmp_path, answered, seed, count):
    shipped = {path: path.read_bytes() for path in EXAMPLE.parent.glob("*.toml")}
    hand = hurry(application, opened, faults, tmp_path, answered, seed, count)
    assert shipped == {path: path.read_bytes() for path in EXAMPLE.parent.glob("*.toml")}
    assert len(hand.sent) == count and len({kind for kind, *_ in hand.sent}) == 10


@pytest.mark.long
@pytest.mark.parametrize("seed", range(10, 20))
def test_that_ten_thousand_random_events_break_nothing(opened, application, faults, tmp_path, answered, seed):
    assert len(hurry(application, opened, faults, tmp_path, answered, seed, 1000).sent) == 1000
