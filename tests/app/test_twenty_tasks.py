"""Twenty tasks of a working day, by clicks and keys alone, each with what it brings: how many actions they take."""

import os

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QGuiApplication, QKeySequence
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QFileDialog, QLineEdit, QStyle, QStyleOptionGroupBox, QToolButton

from app.look import theme
from app.look.in_place import InPlaceEditor
from tests.app.driving import settle
from tests.conftest import SEVEN

MOST = 45
"""Actions of all tasks together; 64 were counted before the answer as one types and values changed in the drawing."""


class Hand:
    """Clicks and types in a window. actions : how often; an action is a click, a key with its modifiers, a text."""

    def __init__(self, window, application):
        self.window, self.application, self.actions = window, application, 0

    def click(self, widget, pos=None) -> None:
        self.actions += 1
        self.application.processEvents()
        QTest.mouseClick(widget, Qt.MouseButton.LeftButton, pos=pos or widget.rect().center())
        self.application.processEvents()

    def key(self, sequence: str) -> None:
        self.actions += 1
        self.window.activateWindow()
        QTest.keySequence(QApplication.focusWidget() or self.window, QKeySequence(sequence))
        self.application.processEvents()

    def type(self, widget, text: str, *, into=None) -> None:
        """A text; the cursor comes by a click that is counted, but where it stands there already (`into`)."""
        if into is None:
            self.click(widget)
            widget.selectAll()
        self.actions += 1
        QTest.keyClicks(widget, text)
        self.application.processEvents()

    def row(self, name: str) -> None:
        """A row of the tree."""
        tree = self.window.tree.tree
        (item, *_) = tree.findItems(name, Qt.MatchFlag.MatchStartsWith | Qt.MatchFlag.MatchRecursive)
        tree.scrollToItem(item)
        self.application.processEvents()
        self.click(tree.viewport(), tree.visualItemRect(item).center())

    def find(self, text: str) -> None:
        """Ctrl+K, a name, Enter."""
        from app.shell.finder import Finder

        def in_dialog() -> None:
            finder = QApplication.activeModalWidget()
            assert isinstance(finder, Finder)
            line = finder.findChild(QLineEdit)
            self.type(line, text, into=line)
            self.actions += 1
            QTest.keyClick(line, Qt.Key.Key_Return)

        QTimer.singleShot(0, in_dialog)
        self.key("Ctrl+K")


def test_that_twenty_tasks_take_no_more_than_forty_five_actions(fresh, application, tmp_path, monkeypatch, request):
    window, hand = fresh, Hand(fresh, application)
    session, navigator, given = window.session, window.navigator, window.stages.input
    done = []

    def done_with(task: str, brought: bool) -> None:
        assert brought, task
        done.append((task, hand.actions - sum(count for _, count in done)))

    session.open(SEVEN)  # in the place of the example, as at a first start
    window.show_first_run()
    hand.click(window.stages.first.buttons["example"])
    settle(application, lambda: window.records.motions and not window.records.pending)
    done_with("open the example", len(session.case.wall) > 1)
    hand.key("F5")
    settle(application, lambda: session.result is not None and window.runner.job is None)
    done_with("run it", navigator.page == "walls")
    table = window.pages["walls"].content.table
    hand.click(table.viewport(), table.visualItemRect(table.item(0, 0)).center())
    done_with("read the answer of the worst wall", navigator.page == "check")
    done_with("what would make it pass", "measure" in window.pages["check"].content.to_do.words.text())
    hand.key("Ctrl+3")
    done_with("see it rock", navigator.page == "histories")
    hand.click(window.pages["histories"].content.walls.play)
    done_with("play it", window.pages["histories"].content.walls.timer.isActive())
    window.pages["histories"].content.walls.play.setChecked(False)
    hand.key("Alt+1")
    done_with("back to its input", window.stages.front == "input")
    live = given.live
    hand.click(live.head)
    settle(application, lambda: live.result is not None)
    done_with("its answer beside the input", bool(live.ladder.rungs))
    drawing, before = window.walls.drawing, session.case
    drawing.grab()
    area = next(area for area, kind, _ in drawing.spots if kind == "thickness")
    hand.actions += 1
    QTest.mouseDClick(drawing, Qt.MouseButton.LeftButton, pos=area.center().toPoint())
    line = drawing.findChildren(InPlaceEditor)[-1]
    hand.type(line, "90", into=line)
    QTest.keyClick(line, Qt.Key.Key_Return)
    done_with("another thickness, in the drawing", session.case.wall[window.walls.current].thickness_m == 0.9)
    hand.key("Ctrl+Z")
    done_with("undo", session.case == before)
    hand.click(next(one for one in window.tree.findChildren(QToolButton) if one.text() == "+ variant"))
    done_with("the same wall as designed", session.case.wall[window.walls.current].variant is not None)
    hand.row("Demand")
    hand.click(window.demand.place.given, window.demand.place.given.rect().topLeft() + _box(window.demand.place.given))
    search = window.demand.place.search
    hand.type(search, "L'Aquila")
    QTest.keyClick(search, Qt.Key.Key_Return)
    settle(application, lambda: session.case.demand.hazard or session.case.site is not None)
    done_with("the demand of a place", session.case.site is not None and session.case.site.municipality == "L'Aquila")
    hand.row("Records")
    application.processEvents()
    done_with("records and their spectra", given.spectra.made is not None or not window.records.motions)
    rows = "Parete\tz\tH\tt\tMeccanismo", "\tm\tm\tcm\t", "nord\t0\t4.5\t45\tone_sided", "sud\t0\t5\t60\tone_sided"
    QGuiApplication.clipboard().setText("\n".join(rows))
    count = len(session.case.wall)
    hand.key("Ctrl+Shift+V")
    done_with("walls from a spreadsheet", len(session.case.wall) == count + 2)
    hand.find("sud")
    done_with("find a wall", session.case.wall[window.walls.current].name == "sud")
    hand.click(next(one for one in window.tree.findChildren(QToolButton) if one.text() == "delete"))
    done_with("delete it", len(session.case.wall) == count + 1)
    hand.key("Ctrl+S")
    path = tmp_path / "day.toml"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(path), ""))
    hand.key("Ctrl+Shift+S")
    hand.actions += 1  # its name
    done_with("save it", path.exists())
    hand.key("Alt+4")
    done_with("the pages of the note", window.stages.front == "report")
    hand.row("Report")
    author = next(field for field in window.analysis.of_report if field.key == "author")
    hand.type(author.editor, "ing. Rossi")
    done_with("its author", session.case.report.author == "ing. Rossi")
    hand.find("dark")
    request.addfinalizer(lambda: theme.set_theme("light"))
    done_with("a dark window", theme.current.name == "dark")
    assert len(done) == 20
    assert hand.actions <= MOST, done


def _box(group):
    """Where the box of a group is, from its corner."""
    option = QStyleOptionGroupBox()
    group.initStyleOption(option)
    area = group.style().subControlRect(
        QStyle.ComplexControl.CC_GroupBox, option, QStyle.SubControl.SC_GroupBoxCheckBox, group
    )
    return area.center()
