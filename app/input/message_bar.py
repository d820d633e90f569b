"""The line below a form that says what its fields have to say: in room of its own, so that nothing moves."""

from collections.abc import Callable, Sequence

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QApplication

from app.input.fields import Field
from app.look import theme
from app.look.labels import PlainLabel, escape_html

LINES_OF_BAR = 2
"""Room that it has; more is in its tip."""


class MessageBar(PlainLabel):
    """Says how the text of the field in hand is read and what is doubted, and what is wrong with one that was left.

    fields() : of the form in front
    """

    def __init__(self, fields: Callable[[], Sequence[Field]]):
        super().__init__()
        self.fields = fields
        self.of: Field | None = None
        self.setWordWrap(True)
        self.setAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop)
        self.setContentsMargins(8, 2, 8, 2)
        self.setFixedHeight(self.sizeHint().height())
        application = QApplication.instance()
        assert isinstance(application, QApplication)
        application.focusChanged.connect(self.follow)

    def sizeHint(self) -> QSize:
        return QSize(200, LINES_OF_BAR * self.fontMetrics().lineSpacing() + 6)

    def follow(self, *_) -> None:
        """Say what there is to say."""
        spoken = [field for field in self.fields() if field.said]
        in_hand = next((field for field in spoken if field.editor.hasFocus()), None)
        left = next((field for field in spoken if field.is_wrong and field is not in_hand), None)
        self.of = in_hand if in_hand is not None and not in_hand.is_wrong else left
        words = f"{self.of.caption.text()}: {self.of.said}" if self.of is not None else ""
        if words == self.text():
            return
        wrong = self.of is not None and self.of.is_wrong
        self.setStyleSheet(f"color: {theme.current.bad if wrong else theme.current.amber};")
        self.setText(words)
        self.setToolTip(escape_html(words))
