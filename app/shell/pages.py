"""What stands behind the tabs: pages made when first looked at, a veil over stale results."""

import html
from collections.abc import Callable

from PySide6.QtCore import QCoreApplication, QEvent, Qt, Signal
from PySide6.QtGui import QColor, QPainter
from PySide6.QtWidgets import QVBoxLayout, QWidget

from app.look import theme
from app.look.labels import RichLabel


class StaleOverlay(QWidget):
    """A grey veil over results that are of an earlier input; clicks go through it."""

    def __init__(self, over: QWidget):
        super().__init__(over)
        self.over = over
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.hide()

    def paintEvent(self, event) -> None:
        shade = QColor(theme.current.window)
        shade.setAlpha(165)
        QPainter(self).fillRect(self.rect(), shade)

    def cover(self, on: bool) -> None:
        self.setGeometry(self.over.rect())
        self.setVisible(on)
        self.raise_()


def delete(widget: QWidget) -> None:
    """Delete a widget with all it holds, at once: what only waits to be deleted is kept as long as no loop of events
    comes to it, and may meanwhile be painted though Python has taken it apart."""
    widget.setParent(None)
    widget.deleteLater()
    QCoreApplication.sendPostedEvents(widget, QEvent.Type.DeferredDelete)


class LazyPage(QWidget):
    """A tab that is made when it is first looked at: the start is faster. asked : the link of its words"""

    asked = Signal()

    def __init__(self, maker: Callable[[], QWidget]):
        super().__init__()
        self.maker = maker
        self.made: QWidget | None = None
        self.word = RichLabel()
        self.word.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.word.setWordWrap(True)
        self.word.linkActivated.connect(lambda _: self.asked.emit())
        self.word.setTextInteractionFlags(
            Qt.TextInteractionFlag.LinksAccessibleByMouse | Qt.TextInteractionFlag.LinksAccessibleByKeyboard
        )
        self.word.hide()
        self.column = QVBoxLayout(self)
        self.column.setContentsMargins(0, 0, 0, 0)
        self.column.addWidget(self.word)

    def say(self, words: str) -> None:
        """Words in the place of a content that would be empty: axes without curves say nothing."""
        self.empty()
        shown = html.escape(words, quote=False)
        self.word.setText(f"<a href='do' style='color:{theme.current.curves[0]}; text-decoration:none'>{shown} →</a>")
        self.word.show()

    def empty(self) -> None:
        """Forget what was shown; it is made anew when looked at."""
        if self.made is not None:
            self.column.removeWidget(self.made)
            delete(self.made)
            self.made = None

    @property
    def content(self) -> QWidget:
        if self.made is None:
            self.word.hide()
            self.made = self.maker()
            self.column.addWidget(self.made)
        return self.made
