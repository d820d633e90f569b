"""What stands behind the tabs: pages made when first looked at, a veil over stale results."""

from PySide6.QtCore import QCoreApplication, QEvent, Qt
from PySide6.QtGui import QColor, QPainter
from PySide6.QtWidgets import QVBoxLayout, QWidget

from app.look import theme
from app.look.language import number, tr
from app.views.check_tab import verdict_color
from core.report.verdict_words import in_order, sentence_of
from core.text.sentence import word

LISTED = 40
"""Walls whose verdicts are written beside the tabs; all stand on the tab Walls."""


class Veil(QWidget):
    """A grey veil over results that are of an earlier input; clicks go through it."""

    def __init__(self, over: QWidget):
        super().__init__(over)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.hide()

    def paintEvent(self, event) -> None:
        shade = QColor(theme.current.window)
        shade.setAlpha(165)
        QPainter(self).fillRect(self.rect(), shade)

    def cover(self, on: bool) -> None:
        self.setGeometry(self.parentWidget().rect())
        self.setVisible(on)
        self.raise_()


def delete(widget: QWidget) -> None:
    """Delete a widget with all it holds, at once: what only waits to be deleted is kept as long as no loop of events
    comes to it, and may meanwhile be painted though Python has taken it apart."""
    widget.setParent(None)
    widget.deleteLater()
    QCoreApplication.sendPostedEvents(widget, QEvent.Type.DeferredDelete)


class Page(QWidget):
    """A tab that is made when it is first looked at: the start is faster."""

    def __init__(self, maker):
        super().__init__()
        self.maker, self.made = maker, None
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)

    def empty(self) -> None:
        """Forget what was shown; it is made anew when looked at."""
        if self.made is not None:
            self.layout().removeWidget(self.made)
            delete(self.made)
            self.made = None

    @property
    def content(self) -> QWidget:
        if self.made is None:
            self.made = self.maker()
            self.layout().addWidget(self.made)
        return self.made


def card(result, language: str) -> str:
    """The verdicts of a result as rich text."""
    lines = []
    deciding = [wall for wall, decides in in_order(result) if decides]
    for wall in deciding[:LISTED]:
        if wall.assessment is None:
            lines.append(f"<b>{_plain(wall.name)}</b>: q {number(wall.q_set or 0, '.2f')}")
            continue
        verdict = wall.assessment.verdict
        zeta = "–" if verdict.zeta_e is None else f"{number(verdict.zeta_e, '.2f')}"
        lines.append(
            f"<span style='color:{verdict_color(result, wall)}; font-weight:600'>ζ {zeta}, "
            f"{word(verdict.code, language)}</span><br>{_plain(sentence_of(result, wall, language))}"
        )
    if len(deciding) > LISTED:
        lines.append(tr("{n} more walls on the tab Overview", n=len(deciding) - LISTED))
    return "<p>" + "</p><p>".join(lines) + "</p>"


def _plain(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;")
