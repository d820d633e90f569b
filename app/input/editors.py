"""What edits in a field: a line of text whose undo is that of the case, a list that the mouse wheel passes by.

A line tells when the wheel, or an arrow, is turned with Ctrl."""

from collections.abc import Callable

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QComboBox, QDialog, QLineEdit

from app.look.case_views import typed_edit


class Choice(QComboBox):
    """A list to choose from that the mouse wheel passes by, unless it has the focus."""

    def __init__(self):
        super().__init__()
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

    def wheelEvent(self, event) -> None:
        if self.hasFocus():
            super().wheelEvent(event)
        else:
            event.ignore()


class Line(QLineEdit):
    """A line of text whose Ctrl+Z and Ctrl+Y are those of the case, but in a dialog; a text that is not in the case is
    taken back first.

    refused() : whether there is one
    revert() : what to do then
    """

    entered = Signal()
    stepped = Signal(int)

    def __init__(self, refused: Callable[[], bool], revert: Callable[[], None]):
        super().__init__()
        self.refused, self.revert = refused, revert
        self._clicked_into = False

    def focusInEvent(self, event) -> None:
        """However the cursor came here, what is typed takes the place of what stands there, as after Tab."""
        self.entered.emit()
        super().focusInEvent(event)
        if event.reason() == Qt.FocusReason.OtherFocusReason:
            self.selectAll()
        self._clicked_into = event.reason() == Qt.FocusReason.MouseFocusReason

    def mouseReleaseEvent(self, event) -> None:
        """The click that came into the line selects all of it; one that drew over a part of it, that part."""
        super().mouseReleaseEvent(event)
        if self._clicked_into and not self.hasSelectedText():
            self.selectAll()
        self._clicked_into = False

    def wheelEvent(self, event) -> None:
        """With Ctrl the wheel changes the number; without, the page goes by."""
        if event.modifiers() & Qt.KeyboardModifier.ControlModifier and self.hasFocus() and event.angleDelta().y():
            self.stepped.emit(1 if event.angleDelta().y() > 0 else -1)
            event.accept()
        else:
            super().wheelEvent(event)

    def keyPressEvent(self, event) -> None:
        """Ctrl with an arrow up or down is a turn of the wheel."""
        steps = {Qt.Key.Key_Up: 1, Qt.Key.Key_Down: -1}
        if event.modifiers() & Qt.KeyboardModifier.ControlModifier and event.key() in steps:
            self.stepped.emit(steps[event.key()])
        elif event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            super().keyPressEvent(event)
        else:
            with typed_edit():
                super().keyPressEvent(event)

    def event(self, event) -> bool:
        if event.type() in (QEvent.Type.ShortcutOverride, QEvent.Type.KeyPress):
            undo = event.matches(QKeySequence.StandardKey.Undo)
            of_case = not isinstance(self.window(), QDialog)
            if of_case and (undo or event.matches(QKeySequence.StandardKey.Redo)):
                if not (undo and self.refused()):
                    event.ignore()
                    return False
                if event.type() == QEvent.Type.KeyPress:
                    self.revert()
                event.accept()
                return True
        return super().event(event)

    def contextMenuEvent(self, event) -> None:
        """The usual menu without an undo that the case knows nothing of."""
        menu = self.createStandardContextMenu()
        for action in menu.actions():
            if action.objectName() in ("edit-undo", "edit-redo"):
                menu.removeAction(action)
        menu.exec(event.globalPos())
        menu.deleteLater()
