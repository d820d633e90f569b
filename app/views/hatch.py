"""An area of slanted lines. Lines, not a pattern of a brush: an SVG has none of those."""

import numpy as np
from PySide6.QtCore import QLineF, QPointF, QRectF
from PySide6.QtGui import QPainterPath, QPen

from app.look.charting import pg

SPACING = 8.0
"""Between two lines, along the axis [px]."""


class Hatch(pg.GraphicsObject):
    """A rectangle of the axes filled with lines that rise to the right."""

    def __init__(self, area: QRectF):
        super().__init__()
        self.area, self.pen = area, pg.mkPen(None)

    def set_pen(self, pen: QPen) -> None:
        """Colour and width of the lines."""
        self.pen = pen
        self.update()

    def boundingRect(self) -> QRectF:
        return self.area

    def paint(self, painter, option, widget) -> None:
        """Lines of equal distance in pixels, cut at the edges of what is in view."""
        seen = self.area.intersected(self.viewRect())
        x, y = self.pixelLength(pg.Point(1, 0)), self.pixelLength(pg.Point(0, 1))
        if seen.isEmpty() or not x or not y:
            return
        wide, high = seen.width() / x, seen.height() / y

        def place(right: float, up: float) -> QPointF:
            return QPointF(seen.left() + x * right, seen.top() + y * up)

        painter.setPen(self.pen)
        painter.drawLines(
            [
                QLineF(
                    place(max(0.0, at - high), max(0.0, high - at)), place(min(wide, at), min(high, high - at + wide))
                )
                for at in np.arange(SPACING, wide + high, SPACING).tolist()
            ]
        )


def hatched_square() -> QPainterPath:
    """The symbol of such an area in a legend, of size 1."""
    path = QPainterPath()
    path.addRect(-0.5, -0.5, 1.0, 1.0)
    for shift in (-0.5, 0.0, 0.5):
        path.moveTo(max(-0.5, shift - 0.5), min(0.5, shift + 0.5))
        path.lineTo(min(0.5, shift + 0.5), max(-0.5, shift - 0.5))
    return path
