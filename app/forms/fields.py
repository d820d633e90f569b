"""Fields of a form: each knows its key, says its error in words, and speaks the office's unit."""

from collections.abc import Callable
from dataclasses import fields

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QGridLayout,
    QLabel,
    QLineEdit,
    QSizePolicy,
    QWidget,
)

from app import theme
from app.language import tr
from app.sentences import said
from core.case_reader import check_value
from core.errors import InputError
from core.number import parse_number

FIGURES = 12


class Field(QWidget):
    """Label, editor, unit and a line for its error. edited(value) : a value the case accepts."""

    edited = Signal(object)
    judged = Signal()

    def __init__(self, section: type, key: str, label: str, unit: str = "", tip: str = ""):
        super().__init__()
        self.section, self.key = section, key
        self.held = None
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(6)
        grid.setVerticalSpacing(0)
        self.caption = QLabel(label)
        self.caption.setMinimumWidth(116)
        self.caption.setMaximumWidth(190)
        self.caption.setWordWrap(True)
        self.editor = self.make_editor()
        self.editor.setAccessibleName(label)
        self.editor.setToolTip(tip)
        self.setToolTip(tip)
        self.caption.setBuddy(self.editor)
        self.message = QLabel()
        self.message.setWordWrap(True)
        self.message.setStyleSheet(f"color: {theme.current.bad};")
        self.message.hide()
        grid.addWidget(self.caption, 0, 0)
        grid.addWidget(self.editor, 0, 1)
        if unit:
            grid.addWidget(QLabel(unit), 0, 2)
        grid.addWidget(self.message, 1, 0, 1, 3)
        grid.setColumnStretch(1, 1)
        self.setFocusProxy(self.editor)

    def make_editor(self) -> QWidget:
        """The widget that edits: a line of text, where a kind of field has no other."""
        return QLineEdit()

    def show_error(self, sentence: str) -> None:
        """Words below the field, none for a good value."""
        if sentence != self.message.text():
            QTimer.singleShot(0, self, self.judged.emit)
        self.message.setText(sentence)
        self.message.setVisible(bool(sentence))
        self.editor.setStyleSheet(f"border: 1px solid {theme.current.bad};" if sentence else "")

    @property
    def wrong(self) -> bool:
        """Whether what stands in the field is not in the case."""
        return bool(self.message.text()) and not self.isHidden()

    def accepted(self, sentence: str) -> str:
        """What the field accepts, from the sentence of the case."""
        return sentence.split(" is not accepted: ")[-1]

    def offer(self, value) -> None:
        """A value from the editor: into the case if it is accepted, else an error at the field."""
        try:
            value = check_value(self.section, self.key, value) if value is not None else None
        except InputError as error:
            self.show_error(said(self.accepted(str(error))))
            return
        self.show_error("")
        self.held = value
        self.edited.emit(value)

    def keeps(self, value) -> bool:
        """Whether something wrong stands here that the user has yet to mend: it is not taken away without a
        word. A value that came from elsewhere (undo, another file) replaces it."""
        return bool(self.message.text()) and value == self.held

    def forget(self) -> None:
        """Another case or wall: what was wrong in the last one is no more."""
        self.held = None
        self.show_error("")


class NumberField(Field):
    """A number, comma or point. factor : office unit over the unit of the case (100 for cm from m)."""

    def __init__(
        self, section, key, label, unit="", factor=1.0, optional=False, whole=False, tip=""
    ):
        self.factor, self.optional, self.whole = factor, optional, whole
        self.unit = unit
        super().__init__(section, key, label, unit, tip)

    def accepted(self, sentence: str) -> str:
        rule = next(entry for entry in fields(self.section) if entry.name == self.key).metadata
        low, high = (f"{rule[end] * self.factor:g}" for end in ("low", "high"))
        return tr("from {low} to {high} {unit}").format(low=low, high=high, unit=self.unit).strip()

    def make_editor(self) -> QLineEdit:
        editor = QLineEdit()
        editor.setAlignment(Qt.AlignmentFlag.AlignRight)
        editor.setMinimumWidth(64)
        editor.textEdited.connect(self._typed)
        return editor

    def _typed(self, text: str) -> None:
        if not text.strip() and self.optional:
            self.show_error("")
            self.held = None
            self.edited.emit(None)
            return
        if not text.strip():
            self.show_error(tr("a number is needed here"))
            return
        try:
            number = parse_number(text)
        except InputError as error:
            self.show_error(tr("{text}: not a number").format(text=str(error).split(" ")[0]))
            return
        self.offer(int(number) if self.whole and number == int(number) else number / self.factor)

    def show_value(self, value: float | None) -> None:
        """Show a value of the case, unless what stands there already means it."""
        if self.keeps(value):
            return
        self.held = value
        if self.editor.hasFocus() and self._means(value):
            return
        shown = "" if value is None or value == "" else f"{value * self.factor:.{FIGURES}g}"
        if self.editor.text() != shown:
            self.editor.setText(shown)
        self.show_error("")

    def _means(self, value) -> bool:
        text = self.editor.text()
        if not text.strip():
            return value is None
        try:
            number = parse_number(text)
        except InputError:
            return False
        return value is not None and abs(number / self.factor - value) <= 1e-12 * abs(value)


class TextField(Field):
    """A line of text."""

    def make_editor(self) -> QLineEdit:
        editor = QLineEdit()
        editor.textEdited.connect(self.offer)
        return editor

    def show_value(self, value: str) -> None:
        if self.keeps(value):
            return
        self.held = value
        if self.editor.text() != (value or ""):
            self.editor.setText(value or "")
            self.editor.setCursorPosition(0)
        self.show_error("")


class ChoiceField(Field):
    """One of some names; words : name -> what is shown."""

    def __init__(self, section, key, label, words: dict, tip=""):
        self.words = words
        super().__init__(section, key, label, "", tip)

    def make_editor(self) -> QComboBox:
        editor = QComboBox()
        editor.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        for name, shown in self.words.items():
            editor.addItem(shown, name)
        editor.activated.connect(lambda k: self.offer(editor.itemData(k)))
        return editor

    def show_value(self, value) -> None:
        self.editor.setCurrentIndex(max(0, self.editor.findData(value)))
        self.show_error("")


class FlagField(Field):
    """A box to tick."""

    def make_editor(self) -> QCheckBox:
        editor = QCheckBox()
        editor.toggled.connect(self._toggled)
        return editor

    def _toggled(self, on: bool) -> None:
        self.offer(on)

    def show_value(self, value: bool) -> None:
        self.editor.blockSignals(True)
        self.editor.setChecked(bool(value))
        self.editor.blockSignals(False)


def connect(chosen: list[Field], change: Callable[[Field, object], None]) -> None:
    """Send the edits of these fields to `change(field, value)`."""
    for field in chosen:
        field.edited.connect(lambda value, field=field: change(field, value))
