"""A line of text over a drawing: a value changed where it is drawn, by the field of the form that has it."""

from collections.abc import Callable

from PySide6.QtCore import QRectF, Qt
from PySide6.QtWidgets import QLineEdit, QWidget

from app.look import theme
from app.look.labels import PlainLabel

TEXT_WIDTH = 70
"""Width of its text [px]."""


class InPlaceEditor(QLineEdit):
    """Each letter goes to `typed`, which returns whether it is accepted; Enter or a click elsewhere closes it, Esc
    calls `given_up` before.

    name, unit : of what is changed, which stand within it
    """

    def __init__(self, over: QWidget, area: QRectF, text: str, name: str, unit: str):
        super().__init__(text, over)
        self.setAccessibleName(name)
        self.typed: Callable[[str], bool] = lambda text: True
        self.given_up: Callable[[], None] = lambda: None
        self.is_closed = False
        self.setAlignment(Qt.AlignmentFlag.AlignRight)
        middle, high = area.center().toPoint(), self.sizeHint().height()
        before, behind = PlainLabel(name, self), PlainLabel(unit, self)
        sides = [label.sizeHint().width() + 6 for label in (before, behind)]
        wide = min(sum(sides) + TEXT_WIDTH, over.width())
        self.setTextMargins(sides[0], 0, sides[1], 0)
        left = max(0, min(middle.x() - wide // 2, over.width() - wide))
        top = max(0, min(middle.y() - high // 2, over.height() - high))
        self.setGeometry(left, top, wide, high)
        before.setGeometry(4, 0, sides[0], high)
        behind.setGeometry(wide - sides[1], 0, sides[1], high)
        for label in (before, behind):
            label.setStyleSheet(f"color: {theme.current.quiet};")
        self.textEdited.connect(self._typed)
        self.editingFinished.connect(self.close_it)
        self.show()
        self.selectAll()
        self.setFocus()

    def _typed(self, text: str) -> None:
        accepted = self.typed(text)
        self.setStyleSheet("" if accepted else f"InPlace {{ border: 1px solid {theme.current.bad}; }}")

    def keyPressEvent(self, event) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.given_up()
            self.close_it()
            return
        super().keyPressEvent(event)

    def close_it(self) -> None:
        if not self.is_closed:
            self.is_closed = True
            self.hide()
            self.deleteLater()
