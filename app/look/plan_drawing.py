"""The plan of a wall between its transverse walls, small, in a corner of its drawing."""

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF

from app.look import theme
from app.look.language import number
from core.case.spanning import make_spanning_part, spans
from core.case.wall import Wall
from core.codes.bending_outline import outlines, shown_rotation
from core.codes.vertical_bending import Bending, bending
from core.errors import InputError

SHARE, MARGIN = 0.4, 10.0
"""Width of the plan over that of the drawing, and the room around it [px]."""


def plan_of(wall: Wall) -> Bending | None:
    """The mechanism of a wall between its transverse walls; None without them, or where something is missing."""
    try:
        if wall.kinematics.arches:
            return bending(wall.in_si)
        return bending(make_spanning_part(wall).in_si) if spans(wall) else None
    except (InputError, TypeError):
        return None


def paint_plan(painter: QPainter, width: float, mechanism: Bending) -> QRectF:
    """Paint both halves at rest and turned, the transverse walls and L, in the upper left corner. Returns the place."""
    strip = mechanism.strip
    scale = (SHARE * width - 2.0 * MARGIN) / strip.height
    metrics = painter.fontMetrics()
    depth = scale * strip.height * 0.22
    outer = MARGIN + depth + scale * strip.thickness

    def place(x: float, z: float) -> QPointF:
        return QPointF(MARGIN + scale * z, outer - scale * x)

    ink, quiet, shade = QColor(theme.current.ink), QColor(theme.current.quiet), QColor(theme.current.curves[0])
    shade.setAlpha(70)
    painter.setPen(QPen(quiet, 1.2))
    for z in (0.0, strip.height):
        painter.drawLine(place(strip.thickness, z), QPointF(place(0.0, z).x(), MARGIN))
    painter.setPen(QPen(ink, 1.2))
    painter.setBrush(shade)
    for block in outlines(strip, mechanism.h1, 0.0):
        painter.drawPolygon(QPolygonF([place(x, z) for x, z in block]))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(QPen(quiet, 1.0, Qt.PenStyle.DashLine))
    turned = outlines(strip, mechanism.h1, shown_rotation(mechanism))
    for block in turned:
        painter.drawPolyline([place(x, z) for x, z in block])
    lowest = max(place(x, z).y() for block in turned for x, z in block)
    painter.setPen(ink)
    words = QRectF(MARGIN, lowest + 2.0, scale * strip.height, metrics.height())
    painter.drawText(words, Qt.AlignmentFlag.AlignCenter, f"L {number(strip.height, '.2f')} m")
    return QRectF(0.0, 0.0, SHARE * width, words.bottom())
