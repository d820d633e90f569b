"""The field of a text of several lines."""

from PySide6.QtWidgets import QPlainTextEdit

from app.input.fields import Field

LINES_SEEN = 8
"""That are seen at once."""


class ParagraphsField(Field):
    """A text of several lines, under its caption."""

    editor: QPlainTextEdit

    def __init__(self, section: type, key: str):
        super().__init__(section, key)
        for row, part in ((1, self.editor), (2, self.message)):
            self.grid.removeWidget(part)
            self.grid.addWidget(part, row, 0, 1, 3)

    def make_editor(self) -> QPlainTextEdit:
        editor = QPlainTextEdit()
        editor.setTabChangesFocus(True)
        editor.setMinimumHeight(LINES_SEEN * editor.fontMetrics().lineSpacing())
        editor.textChanged.connect(lambda: self.offer(editor.toPlainText()))
        return editor

    @property
    def text(self) -> str:
        return self.editor.toPlainText()

    def type_again(self, text: str) -> None:
        self.editor.setPlainText(text)

    def write(self, value: str) -> None:
        if self.editor.toPlainText() != value:
            self.editor.setPlainText(value)
