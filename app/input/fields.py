"""Fields of a form: each is made from the description of its key, says its error in words, and speaks the office's
unit."""

import re
from collections.abc import Callable, Sequence
from functools import cached_property
from typing import Any, TypeVar

from PySide6.QtCore import QTimer, Signal
from PySide6.QtWidgets import QCheckBox, QGridLayout, QSizePolicy, QWidget

from app.input.editors import Choice, Line
from app.look import theme
from app.look.labels import PlainLabel, escape_html
from app.look.language import FORM_NAMES, current_language, key_text, tr
from app.look.whole_text import tell_whole
from core.case.hold import Bars, Document
from core.case.keys import unit_in_form
from core.case.loads import ReturnWalls
from core.case.place import Site
from core.case.schema import Analysis, Report
from core.case.site import Building, Demand, Spectrum
from core.case.values import check_value, field_of
from core.case.wall import Wall
from core.errors import InputError
from core.text.sentence import Sentence, choice

SECTION_NAMES = {
    Demand: "[demand]",
    Spectrum: "[demand.spectrum]",
    Building: "[building]",
    Analysis: "[analysis]",
    Report: "[report]",
    Site: "[site]",
}
"""Sections of a case; errors of a wall name the wall."""

WALL_SECTIONS: dict[type, str] = {Wall: "", Bars: ".bar]", ReturnWalls: ".return_walls]", Document: ".evidence]"}
"""Sections of a wall, and how the place of an error inside one ends."""

OF_A_PART = r"\[\[\w+\]\] \d+|\[wall\.\w+\]"
"""Place of an error that is within a table or a section of a wall."""


Kind = TypeVar("Kind", bound="Field")


class Field(QWidget):
    """Label, editor, unit and a line for its error, of a key of a section. edited(value) : a value the case accepts

    inside : of a table of a wall, whether an error of the wall is about this field, as its form has it
    """

    edited = Signal(object)
    judged = Signal()

    def __init__(self, section: type, key: str):
        super().__init__()
        self.section, self.key, self.entry = section, key, field_of(section, key)
        unit, self.factor = unit_in_form(self.entry)
        self.unit = tr("years") if unit == "years" else unit
        label, tip = self.text_of(".caption"), self.text_of(".tip")
        FORM_NAMES.add(self.key_in_errors(), label, SECTION_NAMES.get(section, ""))
        self.value: Any = None
        self.value_before: Any = None
        self.error = self.rule = self.doubt = self.reading = ""
        self._shown = ("", False)
        self.inside: Callable[[InputError], bool] | None = None
        self.tell: Callable[[], None] | None = None
        """Has its words said elsewhere; without it they stand below the field."""
        grid = self.grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(6)
        grid.setVerticalSpacing(0)
        self.caption = PlainLabel(label)
        self.caption.setMinimumWidth(116)
        self.caption.setMaximumWidth(190)
        self.caption.setWordWrap(True)
        self.editor = self.make_editor()
        self.editor.setMinimumHeight(self.editor.sizeHint().height())  # also with the edge of what is wrong
        self.editor.setAccessibleName(label)
        self.editor.setToolTip(escape_html(tip))
        self.setToolTip(escape_html(tip))
        self.caption.setBuddy(self.editor)
        grid.addWidget(self.caption, 0, 0)
        grid.addWidget(self.editor, 0, 1)
        if self.unit:
            grid.addWidget(PlainLabel(self.unit), 0, 2)
        grid.setColumnStretch(1, 1)
        self.setFocusProxy(self.editor)

    @cached_property
    def message(self) -> PlainLabel:
        """The line below the field, made with the first words that stand there."""
        made = PlainLabel()
        made.setWordWrap(True)
        made.hide()
        self.grid.addWidget(made, 1, 0, 1, 3)
        return made

    def text_of(self, part: str) -> str:
        """Its caption or its tip, see `key_text`."""
        return key_text(self.section, self.key, part)

    def key_in_errors(self) -> str:
        """The key by which errors name what it edits."""
        return self.key

    @property
    def optional(self) -> bool:
        """Whether it may be left empty."""
        return self.entry.default is None and not self.entry.metadata.get("filled")

    def make_editor(self) -> QWidget:
        """The widget that edits."""
        raise NotImplementedError

    def show_value(self, value: Any) -> None:
        """Show a value of the case, in the place of anything but a text the user has yet to mend."""
        if self.holds_invalid_text(value):
            return
        if value != self.value:
            self.value_before, self.reading = value, ""
        self.value = value
        self.write(value)
        self.show_error("")

    def write(self, value: Any) -> None:
        """Put a value into the editor, unless what stands there already means it."""
        raise NotImplementedError

    def refuse(self, sentence: str) -> None:
        """Words at the field; the case goes back to the value from before the editing, for the beginning of a
        refused text is not what was meant."""
        self.show_error(sentence)
        if self.value != self.value_before:
            self.value = self.value_before
            self.edited.emit(self.value_before)

    def show_error(self, sentence: str) -> None:
        """Words below the field on what stands in it, none for a good value."""
        if sentence != self.error:
            QTimer.singleShot(0, self, self.judged.emit)
        self.error = sentence
        self._show_words()

    def show_rule(self, sentence: str) -> None:
        """Words below the field on a rule that it breaks together with others, none if all hold. A field that is
        hidden and holds a value shows itself: that may be the one to take away."""
        if sentence and self.isHidden() and self.value not in (None, ""):
            self.show()
        if sentence != self.rule:
            self.rule = sentence
            self._show_words()

    def show_doubt(self, sentence: str) -> None:
        """A question below the field whether a value that is accepted is meant, none where it is usual."""
        if sentence != self.doubt:
            self.doubt = sentence
            self._show_words()

    def _show_words(self) -> None:
        wrong = self.error or self.rule
        words = wrong or "\n".join(filter(None, (self.reading, self.doubt)))
        if self._shown == (words, bool(wrong)):  # a style sheet costs a refresh of 150 fields half of its time
            return
        self._shown = (words, bool(wrong))
        self.message.setText(words)
        self.message.setStyleSheet(f"color: {theme.current.bad if wrong else theme.current.amber};")
        self.message.setVisible(bool(words) and self.tell is None)
        if self.tell is not None:
            self.tell()
        self.editor.setStyleSheet(f"border: 1px solid {theme.current.bad};" if wrong else "")

    @property
    def said(self) -> str:
        """What it has to say of what stands in it; "" where it is not seen."""
        return "" if self.isHidden() else self._shown[0]

    @property
    def is_wrong(self) -> bool:
        """Whether its words are of something wrong."""
        return self._shown[1]

    @property
    def wrong(self) -> bool:
        """Whether what stands in the field is not in the case."""
        return bool(self.error) and not self.isHidden()

    def named_in(self, problem: InputError, wall: str) -> bool:
        """Whether an error of the case is about this field; wall : title of the wall the forms show."""
        if self.inside is not None:
            return problem.wall == wall and self.inside(problem)
        if self.key_in_errors() not in problem.keys:
            return False
        if self.section in WALL_SECTIONS:
            said = [str(dict(part.values).get("name", "")) for part in problem.place if isinstance(part, Sentence)]
            inside = next(
                (end for end in WALL_SECTIONS.values() if end and any(name.endswith(end) for name in said)), ""
            )
            if any(re.fullmatch(OF_A_PART, name) for name in said) and self.section is Wall:
                return False  # of an opening or of the wedges, say, whose keys have the names of the wall's
            if not inside and self.section is not Wall and self.key in Wall.__dataclass_fields__:
                return False  # a thickness, say, of the wall itself
            return problem.wall == wall and inside in ("", WALL_SECTIONS[self.section])
        return problem.section is not None and problem.section == SECTION_NAMES.get(self.section)

    def offer(self, value) -> None:
        """A value from the editor: into the case if it is accepted, else an error at the field."""
        try:
            value = check_value(self.section, self.key, value) if value is not None else None
        except InputError as error:
            self.refuse(error.accepted_text(current_language(), FORM_NAMES))
            return
        self.show_error("")
        self.value = value
        self.edited.emit(value)

    def holds_invalid_text(self, value) -> bool:
        """Whether something wrong stands here that the user has yet to mend: it is not taken away without a
        word. A value that came from elsewhere (undo, another file) replaces it."""
        return bool(self.error) and value == self.value

    @property
    def text(self) -> str:
        """What stands in a line or an area of text."""
        return ""

    def type_again(self, text: str) -> None:
        """A text as if it were typed: what is refused is so again, in the words of the window as it is."""

    @property
    def is_blank(self) -> bool:
        """Whether it is known to show and to hold nothing."""
        return False

    def forget(self) -> None:
        """Another case or wall: what was wrong in the last one is no more."""
        self.value = self.value_before = None
        self.reading = self.doubt = ""
        self.show_error("")


class LineField(Field):
    """Edited in a line of text."""

    editor: Line

    def make_editor(self) -> Line:
        line = Line(lambda: bool(self.error), self.revert)
        line.entered.connect(self._entered)
        line.textEdited.connect(self._typed)
        return line

    def _typed(self, text: str) -> None:
        self.offer(text)

    def _entered(self) -> None:
        """Editing begins: what stands here comes back should the text be refused."""
        self.value_before = self.value

    def revert(self) -> None:
        """The value of the case again, in the place of what was refused."""
        value = self.value
        self.forget()
        self.editor.clear()
        self.show_value(value)

    @property
    def text(self) -> str:
        return self.editor.text()

    @property
    def is_blank(self) -> bool:
        held = self.value, self.value_before, self.error or None, self.reading or None, self.doubt or None
        return not self.editor.text() and held == (None,) * 5

    def type_again(self, text: str) -> None:
        self.editor.setText(text)
        self.editor.textEdited.emit(text)


class TextField(LineField):
    """A line of text."""

    def write(self, value: str) -> None:
        if self.editor.text() != (value or ""):
            self.editor.setText(value or "")
            self.editor.setCursorPosition(0)


class ChoiceField(Field):
    """One of some names. words : name -> what is shown, None : as the catalogue has it"""

    editor: Choice

    def __init__(self, section: type, key: str, words: dict | None = None):
        self.words = words or words_of_choices(section, key)
        FORM_NAMES.captions.update({name: shown for name, shown in self.words.items() if name})
        FORM_NAMES.captions.update({f"{key}={name}": shown for name, shown in self.words.items()})
        super().__init__(section, key)
        tell_whole(self.editor)

    def make_editor(self) -> Choice:
        editor = Choice()
        editor.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        for name, shown in self.words.items():
            editor.addItem(shown, name)
        editor.activated.connect(lambda k: self.offer(editor.itemData(k)))
        return editor

    def show_value(self, value) -> None:
        # a choice that is still to be made shows none
        self.editor.setCurrentIndex(list(self.words).index(value) if value in self.words else -1)
        self.show_error("")


class FlagField(Field):
    """A box to tick."""

    editor: QCheckBox

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


def words_of_choices(section: type, key: str) -> dict:
    """Name -> what a list shows, of a key that takes one of some names; None is that it is not given."""
    entry = field_of(section, key)
    words: dict = {}
    if entry.default is None and not entry.metadata.get("filled"):
        words[None] = key_text(section, key, "=") or "–"
    if entry.metadata["kind"] == "flag":
        return words | {True: tr("yes"), False: tr("no")}
    if entry.metadata["kind"] == "int":
        return words | {n: str(n) for n in range(entry.metadata["low"], entry.metadata["high"] + 1)}
    return words | {
        name: key_text(section, key, f"={name}") or choice(name, current_language()) for name in entry.metadata["names"]
    }


def clear_fields(chosen: Sequence[Field]) -> None:
    """Show nothing in these fields: what they edit is not there."""
    for field in chosen:
        if not field.is_blank:
            field.forget()
            field.show_value(None)


def connect(chosen: Sequence[Kind], change: Callable[[Kind, Any], None]) -> None:
    """Send the edits of these fields to `change(field, value)`."""
    for field in chosen:
        field.edited.connect(lambda value, field=field: change(field, value))
