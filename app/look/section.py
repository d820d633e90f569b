"""A part of a form that folds and says its content in its head."""

from collections.abc import Sequence

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QPushButton, QSizePolicy, QVBoxLayout, QWidget

from app.look import theme
from app.look.labels import PlainLabel, escape_html


class SectionHeader(QPushButton):
    """Title and content of a section; a click or the space bar folds it."""

    def __init__(self, title: str):
        super().__init__()
        self.setCheckable(True)
        self.sign, self.title, self.content = PlainLabel("▸"), PlainLabel(title), PlainLabel()
        self.title.setStyleSheet("font-weight: 600;")
        self.content.setStyleSheet(f"color: {theme.current.quiet};")
        self.content.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        self.content.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        row = self.row = QHBoxLayout(self)
        row.setContentsMargins(8, 3, 8, 3)
        for label, stretch in ((self.sign, 0), (self.title, 0), (self.content, 1)):
            label.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
            row.addWidget(label, stretch)
        self.words = ""
        self.setAccessibleName(title)
        edge, back, chosen = theme.current.grid, theme.current.back, theme.current.curves[0]
        self.setStyleSheet(
            f"Head {{ border: 1px solid {edge}; background: {back}; text-align: left; }}"
            f"Head:focus {{ border: 2px solid {chosen}; }}"
        )

    def sizeHint(self) -> QSize:
        return self.row.sizeHint().expandedTo(QSize(60, 26))

    minimumSizeHint = sizeHint

    def say(self, words: str) -> None:
        if words == self.words:
            return
        self.words = words
        self.setAccessibleName(f"{self.title.text()}: {words}" if words else self.title.text())
        self.setToolTip(escape_html(words))
        self._cut()

    def resizeEvent(self, event) -> None:
        super().resizeEvent(event)
        self._cut()

    def _cut(self) -> None:
        room = max(10, self.width() - self.title.sizeHint().width() - self.sign.sizeHint().width() - 30)
        self.content.setText(self.content.fontMetrics().elidedText(self.words, Qt.TextElideMode.ElideRight, room))


class FoldingSection(QFrame):
    """Widgets below a head. turned(on) : it was opened or folded."""

    turned = Signal(bool)

    def __init__(self, title: str, widgets: Sequence[QWidget], open: bool = False):
        super().__init__()
        self.head, self.body = SectionHeader(title), QWidget()
        inside = QVBoxLayout(self.body)
        inside.setContentsMargins(8, 6, 8, 6)
        for widget in widgets:
            inside.addWidget(widget)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(self.head)
        layout.addWidget(self.body)
        self.head.toggled.connect(self._turn)
        self.body.setVisible(open)
        self.head.setChecked(open)

    def _turn(self, on: bool) -> None:
        self.head.sign.setText("▾" if on else "▸")
        self.body.setVisible(on)
        self.turned.emit(on)

    def say(self, words: str = "") -> None:
        """What it holds, in a few words."""
        self.head.say(words)

    def unfold(self) -> None:
        self.head.setChecked(True)


def unfold_to(widget: QWidget) -> None:
    """Open every section a widget is in."""
    parent = widget.parentWidget()
    while parent is not None:
        if isinstance(parent, FoldingSection):
            parent.unfold()
        parent = parent.parentWidget()
