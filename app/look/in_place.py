"""A line of text over a drawing: a value changed where it is drawn, by the field of the form that has it."""

from collections.abc import Callable

from PySide6.QtCore import QRectF, Qt
from PySide6.QtWidgets import QLineEdit, QWidget

from app.look import theme

WIDTH = 90
"""Of the line [px]."""


class InPlace(QLineEdit):
    """Each letter goes to `typed`, which returns whether it is accepted; Enter or a click elsewhere closes it, Esc
    calls `given_up` where what stands there is refused."""

    def __init__(self, over: QWidget, area: QRectF, text: str, name: str):
        super().__init__(text, over)
        self.setAccessibleName(name)
        self.typed: Callable[[str], bool] = lambda text: True
        self.given_up: Callable[[], None] = lambda: None
        self.setAlignment(Qt.AlignmentFlag.AlignRight)
        middle = area.center().toPoint()
        high = self.sizeHint().height()
        left = max(0, min(middle.x() - WIDTH // 2, over.width() - WIDTH))
        top = max(0, min(middle.y() - high // 2, over.height() - high))
        self.setGeometry(left, top, WIDTH, high)
        self.textEdited.connect(self._typed)
        self.editingFinished.connect(self.close_it)
        self.show()
        self.selectAll()
        self.setFocus()

    def _typed(self, text: str) -> None:
        accepted = self.typed(text)
        self.setStyleSheet("" if accepted else f"border: 1px solid {theme.current.bad};")

    def keyPressEvent(self, event) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.given_up()
            self.close_it()
            return
        super().keyPressEvent(event)

    def close_it(self) -> None:
        self.editingFinished.disconnect(self.close_it)
        self.hide()
        self.deleteLater()
