"""Labels: plain text, so that no name of a wall is read as markup, and the few that are written as HTML."""

import html

from PySide6 import QtGui
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel, QWidget


def escape_html(text: str) -> str:
    """A text for what shows HTML where it sees some, a message box or a tip: as it is, whatever it holds."""
    return f"<qt>{html.escape(text)}</qt>".replace("\n", "<br>") if QtGui.Qt.mightBeRichText(text) else text


class PlainLabel(QLabel):
    """A label that shows its text as it is."""

    def __init__(self, text: str = "", parent: QWidget | None = None):
        super().__init__(parent)
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setText(text)


class RichLabel(QLabel):
    """A label whose text is HTML: what comes from a case is escaped in it."""

    def __init__(self, text: str = ""):
        super().__init__()
        self.setTextFormat(Qt.TextFormat.RichText)
        self.setText(text)
