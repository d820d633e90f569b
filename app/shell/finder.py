"""Find by name: fields, walls, pages, actions (Ctrl+K)."""

import re
from collections.abc import Callable, Iterator
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QDialog, QGroupBox, QLineEdit, QListWidget, QMenu, QVBoxLayout

from app.input.place_fields import names_beginning_with
from app.look.language import tr, wall_title
from app.look.section import FoldingSection
from app.shell.pointing import point_at
from core.known import require_value

if TYPE_CHECKING:
    from app.shell.window import MainWindow

MAX_ENTRIES = 60
"""Entries that are listed."""

MAX_PLACES, MIN_LETTERS_TYPED = 3, 3
"""Municipalities that are listed, and letters typed from which they are."""


class Entry(NamedTuple):
    """words : what is listed and looked through; go : goes there; also : looked through and not listed"""

    words: str
    go: Callable[[], None]
    also: str = ""


def every_action(menu: QMenu) -> Iterator[QAction]:
    """The entries of a menu and of those inside it. Not by QAction.menu(), which takes the menus that Python knows away
    from it."""
    inside = [menu, *menu.findChildren(QMenu)]
    heads = {one.menuAction() for one in inside}
    for one in inside:
        for action in one.actions():
            if action not in heads and not action.isSeparator():
                yield action


def synonyms() -> dict[str, str]:
    """Part of an entry -> other words it is looked for by."""
    return {
        tr("Language"): tr("language english italian"),
        tr("Theme"): tr("dark light night colours"),
        tr("&Parametric study…").replace("&", ""): tr("sweep of parameters"),
        tr("Coordinates"): tr("latitude longitude map"),
        tr("Municipality"): tr("town city place"),
        tr("Histories"): tr("animation, the wall rocking"),
        tr("Capacity and fragility"): tr("incremental dynamic analysis (IDA)"),
        tr("For the &client").replace("&", ""): tr("presentation, before and after"),
    }


def entries_of(window: "MainWindow") -> list[Entry]:
    """All that can be found: fields first, then walls and their hinges, pages, actions."""
    entries, others = [], synonyms()
    for field in {(one.section, one.key, type(one)): one for one in window.stages.fields}.values():  # the title once
        section = field.parentWidget()
        words = f"{field.caption.text()}  {field.editor.toolTip().splitlines()[0] if field.editor.toolTip() else ''}"
        if section is not None:
            also = others.get(field.caption.text(), "")
            entries.append(Entry(words.strip(), partial(point_at, window.navigator, field), also))
    for row in window.tree.rows:
        if row.kind in ("wall", "hinge"):
            words = f"{wall_title(window.session.case.wall[row.wall].title)}  {row.text if row.kind == 'hinge' else ''}"
            entries.append(Entry(words.strip(), partial(window.navigator.choose_row, row)))
    for section in window.stages.input.forms.findChildren(FoldingSection):
        words = f"{section.head.title.text()}  {section.head.words}"
        entries.append(Entry(words.strip(), partial(point_at, window.navigator, section.head)))
    for group in window.stages.input.forms.findChildren(QGroupBox):
        if group.isCheckable() and not group.isHidden():
            entries.append(Entry(group.title(), partial(point_at, window.navigator, group)))
    seen = set()
    for action in every_action(window.header.menu):
        label, keys, menu = action.text().replace("&", ""), action.shortcut().toString(), action.parent()
        if isinstance(menu, QMenu) and menu.parent() is not window.header.menu:
            label = f"{menu.title().replace('&', '')}: {label}"
        if label and action.isEnabled() and label not in seen:
            seen.add(label)
            also = " ".join(words for name, words in others.items() if name in label)
            entries.append(Entry(f"{label}  {keys}".strip(), action.trigger, also))
    return entries


def places_of(window: "MainWindow", text: str) -> list[Entry]:
    """Municipalities of these letters: the demand from there, then what else it asks for."""

    place = require_value(window.demand.place)

    def take(name: str) -> None:
        place.take(name)
        point_at(window.navigator, place.municipality)
        window.missing.lead_in("demand")

    names = names_beginning_with(text, MAX_PLACES) if len(text.strip()) >= MIN_LETTERS_TYPED else []
    return [Entry(tr("{name}: the demand from this place", name=name), partial(take, name)) for name in names]


def _plain(words: str) -> str:
    """Words as they are typed: "ag" is meant where a_g stands."""
    return words.lower().replace("_", "")


def _holds(one: Entry, words: list[str]) -> bool:
    return all(word in _plain(f"{one.words} {one.also}") for word in words)


def _rank(one: Entry, text: str, words: list[str]) -> tuple[bool, bool, bool]:
    """What has it as whole words first (of a symbol of two letters the field), then what begins with the text, then
    what has its words, at last what only means the same."""
    listed = _plain(one.words)
    whole = set(re.findall(r"\w+", listed))
    not_whole = not all(word in whole for word in words)
    return not_whole, not listed.startswith(text), not all(word in listed for word in words)


class Finder(QDialog):
    """A line to type into and what fits it: every word must be there, in any order."""

    def __init__(self, window: "MainWindow"):
        super().__init__(window)
        self.setWindowTitle(tr("Find"))
        self.owner, self.entries = window, entries_of(window)
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
        words = _plain(text).split()
        self.fitting = [entry for entry in self.entries if _holds(entry, words)]
        self.fitting.sort(key=lambda one: _rank(one, _plain(text), words))
        del self.fitting[MAX_ENTRIES:]
        self.fitting += places_of(self.owner, text)
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
