"""A frame around the control that has the focus: some styles draw none, or one that is hardly seen."""

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QColor, QPainter, QPen
from PySide6.QtWidgets import QApplication, QWidget
from shiboken6 import isValid

from app.look import theme
from app.look.application import application


class Frame(QWidget):
    """Two lines inside the edge of a control, one of which stands out from whatever it is painted on."""

    def __init__(self, control: QWidget):
        super().__init__(control)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setGeometry(control.rect())
        control.installEventFilter(self)
        self.show()
        self.raise_()

    def eventFilter(self, control: QObject, event: QEvent) -> bool:
        if isinstance(control, QWidget) and event.type() == QEvent.Type.Resize:
            self.setGeometry(control.rect())
        return False

    def paintEvent(self, event) -> None:
        painter = QPainter(self)
        for shade, width in ((theme.current.back, 4.0), (theme.current.ink, 2.0)):
            painter.setPen(QPen(QColor(shade), width))
            painter.drawRect(self.rect().adjusted(1, 1, -1, -1))


class FocusFrame(QObject):
    """Has the frame follow the focus, in a window and in its dialogs; a click of the mouse needs none."""

    def __init__(self, window: QWidget):
        super().__init__(window)
        self.frame: Frame | None = None
        application().focusChanged.connect(self._follow)

    def _follow(self, _, now: QWidget | None) -> None:
        if self.frame is not None and isValid(self.frame):
            self.frame.hide()
            self.frame.deleteLater()
        self.frame = None
        by_mouse = QApplication.mouseButtons() != Qt.MouseButton.NoButton
        if now is not None and isValid(now) and not by_mouse and now is not now.window():
            self.frame = Frame(now)
