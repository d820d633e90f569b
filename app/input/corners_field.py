"""The field of the corners of a polygon."""

import re

from PySide6.QtCore import QSignalBlocker
from PySide6.QtWidgets import QPlainTextEdit

from app.input.number_fields import SIGNIFICANT_DIGITS
from app.input.paragraphs_field import ParagraphsField
from app.look.language import number, tr
from core.case.number import parse_number
from core.case.values import parse_corners


class CornersField(ParagraphsField):
    """A corner a line, s and z with a tab, a semicolon or spaces between them, as two columns of a spreadsheet are
    pasted. Corners are in the case as soon as they are typed, also too few: its rules say so."""

    def make_editor(self) -> QPlainTextEdit:
        editor = super().make_editor()
        editor.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
        editor.setTabStopDistance(9.0 * editor.fontMetrics().horizontalAdvance("0"))
        editor.setPlaceholderText(tr("s z, a corner a line; Ctrl+V pastes two columns"))
        return editor

    def offer(self, value: str) -> None:
        """Corners as text into the case; a line that is none is named, and the corners before it stay."""
        points = []
        for n, line in enumerate(value.splitlines(), start=1):
            parts = re.split(r"[\s;]+", line.strip(" \t;"))
            try:
                if line.strip():
                    s, z = map(parse_number, parts)
                    points.append((s, z))
            except ValueError:  # an InputError too
                self.show_error(tr("line {n}: not s and z", n=n))
                return
        corners = parse_corners(points)
        if corners is None:
            self.show_error(tr("too many corners"))
            return
        self.show_error("")
        self.value = corners
        self.edited.emit(corners)

    def show_value(self, value) -> None:
        """Show corners of the case, unless they stand there."""
        corners = tuple(value or ())
        if self.holds_invalid_text(corners):
            return
        if corners != self.value or not self.editor.hasFocus():
            lines = ("\t".join(number(one, f".{SIGNIFICANT_DIGITS}g") for one in corner) for corner in corners)
            with QSignalBlocker(self.editor):
                self.editor.setPlainText("\n".join(lines))
        self.value = corners
        self.show_error("")
