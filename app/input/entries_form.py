"""Tables of a wall as a list: openings, steps, solids; the fields of the one that is chosen."""

import re
from collections.abc import Callable, Sequence
from dataclasses import replace

from PySide6.QtCore import QSignalBlocker, Signal
from PySide6.QtWidgets import QHBoxLayout, QListWidget, QMenu, QToolButton, QVBoxLayout

from app.input.fields import Field, clear_fields, connect
from app.input.made_fields import make_fields
from app.input.wall_editor import WallEditor
from app.look.labels import PlainLabel
from app.look.language import current_language, tr
from app.work.session import Session
from core.case.values import field_of
from core.case.wall import Wall
from core.errors import InputError
from core.text.sentence import Sentence, choice


def entry_named(problem: InputError, key: str) -> int | None:
    """Which table of a key of a wall an error is about, from 1, 0 for no one of them; None where it is about another
    key."""
    for part in problem.place:
        values = dict(part.values) if isinstance(part, Sentence) else {}
        if values and part.code == key:
            n = values["n"]
            assert isinstance(n, int)
            return n
        if inside := re.fullmatch(rf"\[\[{key}\]\] (\d+)", str(values.get("name", ""))):
            return int(inside[1])
    return problem.values.get("n", 0) if problem.key == key else None


class EntriesForm(WallEditor):
    """Edits the tables of a key of the wall at `index()`, one at a time.

    made : words of a button -> a new table, its values still to be given
    words : what the list says of a table; is_shown(table, key) : whether it has this key
    first : keys whose fields come first; lead : that of the field at which an error without a key of its own stands
    chosen : another table is; the rules it breaks are to stand at the fields
    owner : section whose tables they are
    """

    chosen = Signal()
    owner: type = Wall

    def __init__(
        self,
        session: Session,
        index: Callable[[], int],
        key: str,
        made: dict[str, Callable],
        words: Callable,
        is_shown: Callable = lambda entry, key: True,
        first: Sequence[str] = (),
        lead: str = "",
    ):
        super().__init__(session, index)
        self.key, self.words, self.is_shown = key, words, is_shown
        self.fields = make_fields(field_of(self.owner, key).metadata["of"], first=first)
        self.lead = lead or self.fields[0].key
        connect(self.fields, self._changed)
        self.list = QListWidget()
        self.list.setMaximumHeight(64)
        self.list.currentRowChanged.connect(lambda _: self._choose())
        self.buttons = QHBoxLayout()
        for label, new in made.items():
            button = QToolButton()
            button.setText(label)
            button.clicked.connect(lambda _=False, new=new: self.append(new(self.wall)) if self.wall else None)
            self.buttons.addWidget(button)
        self.delete_button = QToolButton()
        self.delete_button.setText(tr("Delete"))
        self.delete_button.clicked.connect(self.delete)
        self.buttons.addWidget(self.delete_button)
        self.buttons.addStretch(1)
        column = self.column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addLayout(self.buttons)
        for widget in (self.list, *self.fields):
            column.addWidget(widget)
        for field in self.fields:
            field.inside = lambda problem, field=field: self._names(problem, field)

    def add_menu(self, label: str, kinds: Sequence[str], add: Callable[[str], None]) -> QToolButton:
        """A button before the others with a menu of the kinds of a table. add(kind) : one of this kind"""
        button = QToolButton()
        button.setText(label)
        button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        menu = QMenu(button)
        for kind in kinds:
            menu.addAction(choice(kind, current_language()), lambda kind=kind: add(kind))
        button.setMenu(menu)
        self.buttons.insertWidget(0, button)
        return button

    def set_title(self, title: str) -> None:
        """What it edits, before its buttons and for a reader of the screen."""
        self.buttons.insertWidget(0, PlainLabel(title))
        self.list.setAccessibleName(title)
        for button in self.findChildren(QToolButton):
            button.setAccessibleName(f"{button.text()}: {title}")

    @property
    def entries(self) -> tuple:
        return getattr(self.wall, self.key) if self.wall else ()

    @property
    def entry(self):
        """The one that is chosen."""
        row = self.list.currentRow()
        return self.entries[row] if 0 <= row < len(self.entries) else None

    def show_case(self) -> None:
        """Fill the list and the fields from the wall."""
        row, words = self.list.currentRow(), [self.words(entry) for entry in self.entries]
        with QSignalBlocker(self.list):
            if words != [self.list.item(k).text() for k in range(self.list.count())]:
                self.list.clear()
                self.list.addItems(words)
            self.list.setCurrentRow(min(max(row, 0), len(words) - 1))
        self._show_entry()

    def _choose(self) -> None:
        """Another one: nothing that was typed for the last one stays."""
        for field in self.fields:
            field.forget()
        self._show_entry()
        self.chosen.emit()

    def _show_entry(self) -> None:
        entry = self.entry
        self.list.setVisible(bool(self.entries))
        self.delete_button.setVisible(entry is not None)
        for field in self.fields:
            field.setVisible(entry is not None and self.is_shown(entry, field.key))
            if entry is not None:
                field.show_value(getattr(entry, field.key))
        if entry is None:
            clear_fields(self.fields)

    def _names(self, problem: InputError, field: Field) -> bool:
        """Whether an error of the wall is about this field of the one that is chosen."""
        n = entry_named(problem, self.key)
        if n is None or self.entry is None or n not in (0, self.list.currentRow() + 1):
            return False
        return field.key in problem.keys or (problem.key == self.key and field.key == self.lead)

    def point_at(self, problem: InputError) -> None:
        """Choose what an error is about."""
        if n := entry_named(problem, self.key):
            self.list.setCurrentRow(n - 1)

    def _edit(self, entries: tuple, *place, **values) -> None:
        self.edit(*((self.key, *place) if place else ()), **{self.key: entries}, **values)

    def append(self, entry, **values) -> None:
        """One more, which is then the one that is chosen. values : keys of the wall that change with it"""
        count = len(self.entries)
        self._edit((*self.entries, entry), **values)
        self.list.setCurrentRow(count)

    def delete(self) -> None:
        """Take the one away that is chosen."""
        row = self.list.currentRow()
        if self.entry is not None:
            self._edit(tuple(entry for k, entry in enumerate(self.entries) if k != row))

    def put(self, entry, *place) -> None:
        """Put another in the place of the one that is chosen. place : key by key to what is typed"""
        row = self.list.currentRow()
        self._edit(tuple(entry if k == row else one for k, one in enumerate(self.entries)), row, *place)

    def changed(self, entry, key: str, value):
        """A table with another value of a key."""
        return replace(entry, **{key: value})

    def _changed(self, field: Field, value) -> None:
        if self.entry is not None:
            self.put(self.changed(self.entry, field.key, value), field.key)
