"""The checks of a wall as bars on one axis of zeta, with the line of the zeta required."""

from collections.abc import Sequence
from typing import NamedTuple

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.look import theme
from app.look.labels import escape_html
from app.look.language import number, tr


class Rung(NamedTuple):
    """A check: its name and clause, zeta, capacity over demand in words, tone of its bar, whether it decides."""

    name: str
    clause: str
    zeta: float | None
    values: str
    tone: str
    decides: bool


ZETA_AXIS_FACTOR = 1.25
"""Length of the axis over the zeta required or the largest bar."""

MIN_BAR_WIDTH = 60.0
"""Room that bars need beside what is compared [px]."""

MAX_ZETA_OVER_TARGET = 2.5
"""Times the zeta required that the axis shows: beyond it a bar ends at the edge, and its number says more."""


class Ladder(QWidget):
    """Rows of a name, a bar and what is compared."""

    def __init__(self):
        super().__init__()
        self.rungs: list[Rung] = []
        self.target = 1.0
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)

    def show_rungs(self, rungs: Sequence[Rung], target: float) -> None:
        self.rungs, self.target = list(rungs), target
        said = [f"{rung.name} ({rung.clause}) ζ {_zeta_of(rung)}, {rung.values}" for rung in self.rungs]
        self.setAccessibleName("; ".join([tr("Checks, ζ required {zeta:.2f}", zeta=target), *said]))
        self.setToolTip(escape_html("\n".join(said)))
        self.updateGeometry()
        self.update()

    @property
    def row_height(self) -> float:
        return 2.3 * self.fontMetrics().height()

    def sizeHint(self) -> QSize:
        return QSize(480, round(self.row_height * max(1, len(self.rungs)) + 2.0 * self.fontMetrics().height()))

    def minimumSizeHint(self) -> QSize:
        return QSize(300, self.sizeHint().height())

    def _fonts(self) -> tuple[QFont, QFont]:
        """Fonts of clauses, and of what decides."""
        small, bold = QFont(self.font()), QFont(self.font())
        small.setPointSizeF(0.85 * small.pointSizeF())
        bold.setBold(True)
        return small, bold

    def _columns(self) -> tuple[float, float, float]:
        """Widths that names with clauses, numbers behind the bars and values take."""
        small, bold = self._fonts()
        names, zetas, values = 90.0, 0.0, 0.0
        for rung in self.rungs:
            own = QFontMetricsF(bold if rung.decides else self.font())
            clause = QFontMetricsF(small).horizontalAdvance(_clause_of(rung))
            names = max(names, own.horizontalAdvance(rung.name), clause)
            zetas = max(zetas, own.horizontalAdvance(_zeta_of(rung)))
            values = max(values, QFontMetricsF(self.font()).horizontalAdvance(rung.values))
        return min(0.36 * self.width(), names + 10.0), zetas + 12.0, values + 14.0

    def paintEvent(self, event) -> None:
        """A row a check, then the line of the zeta required."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        ink, quiet = QColor(theme.current.ink), QColor(theme.current.quiet)
        metrics = self.fontMetrics()
        small, bold = self._fonts()
        names, zetas, values = self._columns()
        left, right = names + 22.0, self.width() - values - 8.0
        with_values = right - left - zetas >= MIN_BAR_WIDTH
        if not with_values:  # the tip has them
            right = self.width() - 8.0
        known = [rung.zeta for rung in self.rungs if rung.zeta is not None]
        end = ZETA_AXIS_FACTOR * max(self.target, min(max(known, default=0.0), MAX_ZETA_OVER_TARGET * self.target))
        per_zeta = max(right - left - zetas, 10.0) / end
        top, line = 1.6 * metrics.height(), left + self.target * per_zeta
        for k, rung in enumerate(self.rungs):
            y = top + k * self.row_height
            for font, shade, words, below in (
                (bold if rung.decides else self.font(), ink, rung.name, 1),
                (small, quiet, _clause_of(rung), metrics.height()),
            ):
                painter.setFont(font)
                painter.setPen(shade)
                words = painter.fontMetrics().elidedText(words, Qt.TextElideMode.ElideRight, round(names))
                painter.drawText(QPointF(8.0, y + metrics.ascent() + below), words)
            bar = QRectF(
                left, y + 0.25 * metrics.height(), min(rung.zeta or 0.0, end) * per_zeta, 1.3 * metrics.height()
            )
            shade = QColor(getattr(theme.current, rung.tone))
            shade.setAlpha(255 if rung.decides else 115)
            painter.fillRect(bar, shade)
            painter.setFont(bold if rung.decides else self.font())
            painter.setPen(QColor(getattr(theme.current, rung.tone)))
            words = _zeta_of(rung)
            at = QPointF(bar.right() + 6.0, bar.center().y() + 0.35 * metrics.height())
            wide = painter.fontMetrics().horizontalAdvance(words)
            if at.x() - 4.0 < line < at.x() + wide + 4.0:  # beside the line, not on it
                at.setX(line + 5.0)
            painter.drawText(at, words)
            if not with_values:
                continue
            painter.setFont(self.font())
            painter.setPen(quiet)
            place = QRectF(right, bar.top(), values, bar.height())
            painter.drawText(place, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter, rung.values)
        painter.setPen(QPen(ink, 2.0))
        painter.drawLine(QPointF(line, 1.3 * metrics.height()), QPointF(line, self.height() - 4.0))
        painter.setFont(bold)
        words = f"ζ {number(self.target, '.2f')}"
        half = 0.5 * painter.fontMetrics().horizontalAdvance(words)
        painter.drawText(QPointF(line - half, metrics.ascent() + 2.0), words)


def _zeta_of(rung: Rung) -> str:
    return theme.add_tone_mark(rung.tone, number(rung.zeta, ".2f"))


def _clause_of(rung: Rung) -> str:
    return f"{rung.clause}  {tr('decides')}" if rung.decides else rung.clause
