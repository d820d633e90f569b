"""A map of a_g over Italy, drawn from the grid itself, with the point of the building."""

import math

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QColor, QImage, QLinearGradient, QPainter, QPen, QPixmap, QPolygonF
from PySide6.QtWidgets import QWidget

from app.look import theme
from app.look.language import number, tr

SOUTH, NORTH, WEST, EAST = 36.4, 47.2, 6.4, 18.7
"""Degrees that the map shows."""

SQUEEZE = math.cos(math.radians(42.0))
"""A degree of longitude over one of latitude."""

CELL = 0.052
"""Size of a node on the map [degrees of latitude]."""

OF_475 = 6
"""Place of 475 years among the return periods of the grid."""

MAP_HEIGHT = 300
"""Height that the map keeps, which a layout cannot take from it [px]."""

MIN_OPACITY, MAX_AG = 0.06, 0.28
"""Shade of the weakest place, and a_g of the strongest shade [g]."""

SARDINIA = (
    *((41.25, 9.20), (40.90, 9.60), (40.50, 9.80), (40.10, 9.70), (39.50, 9.65), (39.10, 9.55), (39.20, 9.10)),
    *((38.90, 8.65), (39.00, 8.40), (39.50, 8.40), (39.90, 8.40), (40.35, 8.40), (40.60, 8.15), (40.95, 8.20)),
    *((40.85, 8.60), (41.10, 9.00)),
)
"""Outline of the island, which the grid leaves out: Table 2 gives it one hazard (latitude, longitude)."""

SCALE_BOX = (4.0, 90.0, 10.0)
"""Left edge, width and height of the scale of shades [px]."""

KEY_STEP = 0.01
"""Degrees an arrow key moves the point."""


class PlaceMap(QWidget):
    """The map. chosen(latitude, longitude) : the point was put or dragged there"""

    chosen = Signal(float, float)

    def __init__(self):
        super().__init__()
        self.point: tuple[float, float] | None = None
        self.picture: QPixmap | None = None
        self.setMinimumWidth(180)
        self.setFixedHeight(MAP_HEIGHT)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAccessibleName(tr("Map of a_g, 475 years; arrows move the point"))

    def show_point(self, point: tuple[float, float] | None) -> None:
        self.point = point
        self.update()

    def resizeEvent(self, event) -> None:
        super().resizeEvent(event)
        self.picture = None

    def _frame(self) -> tuple[float, float, float]:
        """(pixels a degree of latitude, left, top)."""
        scale = min(self.height() / (NORTH - SOUTH), self.width() / ((EAST - WEST) * SQUEEZE))
        left = 0.5 * (self.width() - scale * (EAST - WEST) * SQUEEZE)
        return scale, left, 0.5 * (self.height() - scale * (NORTH - SOUTH))

    def _at(self, latitude: float, longitude: float) -> QPointF:
        scale, left, top = self._frame()
        return QPointF(left + scale * (longitude - WEST) * SQUEEZE, top + scale * (NORTH - latitude))

    def _draw(self) -> QPixmap:
        """Every node as a small square, the darker the stronger."""
        from core.codes.national_hazard import ISLANDS, grid

        ratio = self.devicePixelRatioF()
        image = QImage(self.size() * ratio, QImage.Format.Format_ARGB32_Premultiplied)
        image.setDevicePixelRatio(ratio)
        image.fill(Qt.GlobalColor.transparent)
        known, painter = grid(), QPainter(image)
        painter.setPen(Qt.PenStyle.NoPen)
        size = max(1.5, CELL * self._frame()[0])
        strength = np.clip(known.values[:, OF_475, 0] / (10.0 * MAX_AG), MIN_OPACITY, 1.0)
        color = QColor(theme.current.curves[1])
        for (latitude, longitude), share in zip(known.nodes.tolist(), strength.tolist(), strict=True):
            color.setAlphaF(share)
            at = self._at(latitude, longitude)
            painter.fillRect(QRectF(at.x() - 0.5 * size, at.y() - 0.5 * size, size, size), color)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        color.setAlphaF(ISLANDS[0].ag[OF_475] / (10.0 * MAX_AG))
        painter.setBrush(color)
        painter.drawPolygon(QPolygonF([self._at(*corner) for corner in SARDINIA]))
        self._draw_scale(painter)
        painter.end()
        return QPixmap.fromImage(image)

    def _draw_scale(self, painter: QPainter) -> None:
        """What the shades mean, below the south-west, where only sea is."""
        left, width, height = SCALE_BOX
        bottom = self.height() - 6.0 - height
        shades = QLinearGradient(left, 0.0, left + width, 0.0)
        for place, share in ((0.0, MIN_OPACITY), (1.0, 1.0)):
            color = QColor(theme.current.curves[1])
            color.setAlphaF(share)
            shades.setColorAt(place, color)
        painter.fillRect(QRectF(left, bottom, width, height), shades)
        painter.setPen(QColor(theme.current.ink))
        ends = number(MIN_OPACITY * MAX_AG, ".2f"), f"{number(MAX_AG, '.2f')} g"
        painter.drawText(QPointF(left, bottom - 4.0), ends[0])
        room = painter.fontMetrics().horizontalAdvance(ends[1])
        painter.drawText(QPointF(left + width - room, bottom - 4.0), ends[1])

    def paintEvent(self, event) -> None:
        painter = QPainter(self)
        if self.picture is None:
            self.picture = self._draw()
        painter.drawPixmap(0, 0, self.picture)
        if self.point is not None:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            at = self._at(*self.point)
            painter.setPen(QPen(QColor(theme.current.back), 4.0))
            painter.drawEllipse(at, 5.0, 5.0)
            painter.setPen(QPen(QColor(theme.current.ink), 2.0))
            painter.drawEllipse(at, 5.0, 5.0)
        if self.hasFocus():
            painter.setPen(QPen(QColor(theme.current.curves[0]), 2.0))
            painter.drawRect(self.rect().adjusted(1, 1, -2, -2))

    def _put(self, position: QPointF) -> None:
        scale, left, top = self._frame()
        latitude = NORTH - (position.y() - top) / scale
        longitude = WEST + (position.x() - left) / (scale * SQUEEZE)
        self._choose(latitude, longitude)

    def _choose(self, latitude: float, longitude: float) -> None:
        self.chosen.emit(round(min(max(latitude, SOUTH), NORTH), 4), round(min(max(longitude, WEST), EAST), 4))

    def mousePressEvent(self, event) -> None:
        self._put(event.position())

    def mouseMoveEvent(self, event) -> None:
        if event.buttons() & Qt.MouseButton.LeftButton:
            self._put(event.position())

    def keyPressEvent(self, event) -> None:
        ways = {Qt.Key.Key_Up: (1, 0), Qt.Key.Key_Down: (-1, 0), Qt.Key.Key_Left: (0, -1), Qt.Key.Key_Right: (0, 1)}
        way = ways.get(Qt.Key(event.key()))
        if way is None or self.point is None:
            super().keyPressEvent(event)
            return
        self._choose(self.point[0] + KEY_STEP * way[0], self.point[1] + KEY_STEP * way[1])
