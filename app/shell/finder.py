"""Find by name: fields, walls, pages, actions (Ctrl+K)."""

from collections.abc import Callable, Iterator
from typing import NamedTuple

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QDialog, QLineEdit, QListWidget, QMenu, QVBoxLayout

from app.input.fields import Field
from app.look.language import tr
from app.look.section import unfold_to

MOST = 60
"""Entries that are listed."""


class Entry(NamedTuple):
    """words : what is listed and looked through; go : goes there"""

    words: str
    go: Callable[[], None]


def every_action(menu: QMenu) -> Iterator[QAction]:
    """The entries of a menu and of those inside it. PySide6 6.10 deletes a menu when what `QAction.menu` returned goes:
    the menus are found as children."""
    menus = {
        one.menuAction(): one for one in menu.findChildren(QMenu, options=Qt.FindChildOption.FindDirectChildrenOnly)
    }
    for action in menu.actions():
        inside = menus.get(action)
        if inside is not None:
            yield from every_action(inside)
        elif not action.isSeparator():
            yield action


def entries_of(window) -> list[Entry]:
    """All that can be found: fields first, then walls and their hinges, pages, actions."""
    found = []
    for field in window.fields:
        section = field.parentWidget()
        words = f"{field.caption.text()}  {field.editor.toolTip().splitlines()[0] if field.editor.toolTip() else ''}"
        if section is not None:
            found.append(Entry(words.strip(), lambda field=field: _point(window, field)))
    for row in window.tree.rows:
        if row.kind in ("wall", "hinge"):
            words = f"{window.session.case.wall[row.wall].title}  {row.text if row.kind == 'hinge' else ''}"
            found.append(Entry(words.strip(), lambda row=row: window.choose_row(row)))
    seen = set()
    for action in every_action(window.header.menu):
        label = action.text().replace("&", "")
        keys = action.shortcut().toString()
        if label and action.isEnabled() and label not in seen:
            seen.add(label)
            found.append(Entry(f"{label}  {keys}".strip(), action.trigger))
    return found


def _point(window, field: Field) -> None:
    window.show_form_of(field)
    unfold_to(field)
    field.show()
    window.forms.currentWidget().ensureWidgetVisible(field)
    field.editor.setFocus()


class Finder(QDialog):
    """A line to type into and what fits it: every word must be there, in any order."""

    def __init__(self, window):
        super().__init__(window)
        self.setWindowTitle(tr("Find"))
        self.entries = entries_of(window)
        self.line, self.list = QLineEdit(), QListWidget()
        self.line.setPlaceholderText(tr("A field, a wall, a page, an action"))
        self.line.setAccessibleName(tr("Find"))
        self.list.setAccessibleName(tr("Found"))
        self.line.textChanged.connect(self._look)
        self.line.returnPressed.connect(self._go)
        self.list.itemActivated.connect(lambda _: self._go())
        layout = QVBoxLayout(self)
        layout.addWidget(self.line)
        layout.addWidget(self.list, 1)
        self.resize(520, 420)
        self.fitting: list[Entry] = []
        self._look("")

    def _look(self, text: str) -> None:
        words = text.lower().split()
        self.fitting = [one for one in self.entries if all(word in one.words.lower() for word in words)][:MOST]
        self.fitting.sort(key=lambda one: not one.words.lower().startswith(text.lower()))
        self.list.clear()
        self.list.addItems([one.words for one in self.fitting])
        if self.fitting:
            self.list.setCurrentRow(0)

    def _go(self) -> None:
        k = self.list.currentRow()
        if 0 <= k < len(self.fitting):
            self.accept()
            self.fitting[k].go()

    def keyPressEvent(self, event) -> None:
        if event.key() in (Qt.Key.Key_Down, Qt.Key.Key_Up):
            step = 1 if event.key() == Qt.Key.Key_Down else -1
            self.list.setCurrentRow(max(0, min(self.list.count() - 1, self.list.currentRow() + step)))
            return
        super().keyPressEvent(event)
