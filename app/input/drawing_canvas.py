"""The shapes of a drawing to scale: a click says what a shape is, the hinge line is dragged."""

from collections.abc import Sequence

from PySide6.QtCore import QPointF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF
from PySide6.QtWidgets import QWidget

from app.look import theme
from app.look.language import tr
from core.case.drawing_file import Shape, Sheet
from core.case.drawing_outlines import Gap, Point
from core.wall.body import contains_point, polygon_sums

BODY, OPENING, NO_PART = "body", "opening", "nothing"
ROLES = (BODY, OPENING, NO_PART)
"""What a shape can be, in the order of clicks."""

CLICK_TOLERANCE = 6.0
"""Pixels from the hinge line, and of a movement that is still a click."""

DRAWING_MARGIN = 18.0
"""Around the drawing [pixels]."""


class DrawingCanvas(QWidget):
    """Draws shapes, open outlines and the hinge line. The keys have the list and the fields of the dialog instead.

    clicked(k) : a shape; asked_around(x, y) : a place without one; hinge_moved(y) : where the line was dragged, in the
        unit of the drawing
    """

    clicked = Signal(int)
    asked_around = Signal(float, float)
    hinge_moved = Signal(float)

    def __init__(self):
        super().__init__()
        self.shapes: Sequence[Shape] = ()
        self.gaps: Sequence[Gap] = ()
        self.lines: Sequence[tuple[str, Sequence[Point]]] = ()
        self.roles: list[str] = []
        self.chosen: set[int] = set()
        self.hinge: float | None = None
        self.extent = _extent((), ())
        self.zoom, self.shift = 1.0, QPointF()
        self.press: QPointF | None = None
        self.drags_hinge = False
        self.setMinimumSize(QSize(320, 260))
        self.setMouseTracking(True)
        self.setAccessibleName(tr("Shapes of the drawing"))
        self.setToolTip(
            tr(
                "Click a shape: body, opening, nothing. Click between lines: the outline around it. "
                "Drag the dashed line: the hinge. Wheel: nearer, farther."
            )
        )

    def show_sheet(self, sheet: Sheet) -> None:
        """The shapes, lines and gaps of a drawing."""
        self.lines = sheet.lines
        self.zoom, self.shift = 1.0, QPointF()
        self.show_shapes(sheet)

    def show_shapes(self, sheet: Sheet) -> None:
        """Its shapes and gaps, of the drawing that is shown."""
        self.shapes, self.gaps = sheet.shapes, sheet.gaps
        self.extent = _extent(self.shapes, self.lines)  # once: each point that is painted asks for it
        self.update()

    def show_roles(self, roles: list[str], chosen: set[int], hinge: float | None) -> None:
        """What each shape is, which are marked in the list, y of the hinge line."""
        self.roles, self.chosen, self.hinge = roles, chosen, hinge
        self.update()

    def sizeHint(self) -> QSize:
        return QSize(560, 460)

    def _frame(self) -> tuple[float, float, float]:
        """(pixels a unit of the drawing, x and y of the drawing in the middle of the widget)."""
        low_x, low_y, high_x, high_y = self.extent
        room_x, room_y = self.width() - 2 * DRAWING_MARGIN, self.height() - 2 * DRAWING_MARGIN
        scale = min(room_x / max(high_x - low_x, 1e-9), room_y / max(high_y - low_y, 1e-9))
        return scale * self.zoom, 0.5 * (low_x + high_x), 0.5 * (low_y + high_y)

    def at(self, x: float, y: float) -> QPointF:
        """Where a point of the drawing is in the widget."""
        scale, middle_x, middle_y = self._frame()
        return QPointF(
            0.5 * self.width() + scale * (x - middle_x) + self.shift.x(),
            0.5 * self.height() - scale * (y - middle_y) + self.shift.y(),
        )

    def _point(self, position: QPointF) -> tuple[float, float]:
        """The point of the drawing at a place of the widget."""
        scale, middle_x, middle_y = self._frame()
        x = middle_x + (position.x() - 0.5 * self.width() - self.shift.x()) / scale
        return x, middle_y - (position.y() - 0.5 * self.height() - self.shift.y()) / scale

    def paintEvent(self, event) -> None:
        """Lines below shapes, the body below its openings, crosses at gaps, the hinge line above all."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.fillRect(self.rect(), QColor(theme.current.back))
        shade, back, quiet = (QColor(c) for c in (theme.current.curves[0], theme.current.back, theme.current.quiet))
        shade.setAlphaF(0.3)
        painter.setPen(QPen(quiet, 0.8))
        for _, line in self.lines:
            painter.drawPolyline(QPolygonF([self.at(x, y) for x, y in line]))
        order = {BODY: 0, OPENING: 1, NO_PART: 2}
        for k in sorted(range(len(self.roles)), key=lambda k: order[self.roles[k]]):
            role = self.roles[k]
            edge = QColor(theme.current.ink) if role != NO_PART else quiet
            style = Qt.PenStyle.DotLine if role == NO_PART else Qt.PenStyle.SolidLine
            painter.setPen(QPen(edge, 3.0 if k in self.chosen else 1.2, style))
            fill = {BODY: shade, OPENING: back}.get(role, Qt.BrushStyle.NoBrush)
            painter.setBrush(fill)
            painter.drawPolygon(QPolygonF([self.at(x, y) for x, y in self.shapes[k].corners]))
        painter.setPen(QPen(QColor(theme.current.bad), 2.0))
        for gap in self.gaps:
            at = self.at(*gap.at)
            for way in (QPointF(4, 4), QPointF(4, -4)):
                painter.drawLine(at - way, at + way)
        if self.hinge is not None:
            painter.setPen(QPen(QColor(theme.current.curves[1]), 2.0, Qt.PenStyle.DashLine))
            level = self.at(0.0, self.hinge).y()
            painter.drawLine(QPointF(0.0, level), QPointF(self.width(), level))

    def _on_hinge(self, position: QPointF) -> bool:
        return self.hinge is not None and abs(self.at(0.0, self.hinge).y() - position.y()) <= CLICK_TOLERANCE

    def shape_at(self, position: QPointF) -> int | None:
        """The smallest shape at a place of the widget."""
        point = self._point(position)
        hits = [k for k, shape in enumerate(self.shapes) if contains_point(shape.corners, point)]
        return min(hits, key=lambda k: polygon_sums(self.shapes[k].corners).area, default=None)

    def mousePressEvent(self, event) -> None:
        self.press, self.drags_hinge = event.position(), self._on_hinge(event.position())

    def mouseMoveEvent(self, event) -> None:
        if not event.buttons() & Qt.MouseButton.LeftButton or self.press is None:
            over = self._on_hinge(event.position())
            self.setCursor(Qt.CursorShape.SplitVCursor if over else Qt.CursorShape.PointingHandCursor)
        elif self.drags_hinge:
            self.hinge_moved.emit(self._point(event.position())[1])

    def mouseReleaseEvent(self, event) -> None:
        press, self.press = self.press, None
        if press is None or self.drags_hinge:
            return
        way = event.position() - press
        if way.manhattanLength() > CLICK_TOLERANCE:
            self.shift += way
            self.update()
        elif (k := self.shape_at(press)) is not None:
            self.clicked.emit(k)
        else:
            self.asked_around.emit(*self._point(press))

    def wheelEvent(self, event) -> None:
        before = self._point(event.position())
        self.zoom = min(max(self.zoom * 1.0015 ** event.angleDelta().y(), 0.5), 50.0)
        self.shift += event.position() - self.at(*before)
        self.update()


def _extent(shapes: Sequence[Shape], lines: Sequence[tuple[str, Sequence[Point]]]) -> tuple[float, float, float, float]:
    """Smallest x and y, largest x and y of all shapes and lines; of a unit where there are none."""
    extents = [shape.extent for shape in shapes]
    extents += [(min(xs), min(ys), max(xs), max(ys)) for xs, ys in (zip(*line, strict=True) for _, line in lines)]
    low_x, low_y, high_x, high_y = zip(*(extents or [(0.0, 0.0, 1.0, 1.0)]), strict=True)
    return min(low_x), min(low_y), max(high_x), max(high_y)
