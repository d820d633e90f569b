"""The solids of a body within the drawing of a wall: in section, turned with it, and in elevation."""

import math
from collections.abc import Callable, Sequence
from dataclasses import fields, replace
from typing import Any

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainterPath, QPen, QPolygonF

from app.look import theme
from app.look.language import number
from core.case.solids import Opening, Solid
from core.case.wall import Wall
from core.report.outlines import Outline, elevation_outlines, section_outlines
from core.wall.solids import faces_at


def turned(corners: Sequence[tuple[float, float]], hinge: float, rotation: float) -> list[QPointF]:
    """Points [m] turned by rotation [rad] about the hinge on the side they turn to, `hinge` [m] from the middle."""
    hinge = math.copysign(hinge, rotation)
    c, s = math.cos(rotation), math.sin(rotation)
    return [QPointF(hinge + c * (x - hinge) + s * y, -s * (x - hinge) + c * y) for x, y in corners]


def complete(wall: Wall) -> Wall:
    """A wall without what of its shape is still to be given."""

    def is_given(entry) -> bool:
        values = [getattr(entry, field.name) for field in fields(entry)]
        if isinstance(entry, Opening) and entry.diameter_m is None and None in (entry.width_m, entry.height_m):
            return False
        if isinstance(entry, Solid) and (
            len(entry.polygon_m) < 3 or (entry.angle_deg is None) == (entry.plane == "oblique")
        ):
            return False
        return "" not in values

    if not wall.has_shape:
        return wall
    kept: dict[str, Any] = {key: tuple(filter(is_given, getattr(wall, key))) for key in ("openings", "steps", "solid")}
    wedges = wall.return_wedges if wall.return_wedges and is_given(wall.return_wedges) else None
    corner = wall.corner if wall.corner and is_given(wall.corner) else None
    return replace(wall, return_wedges=wedges, corner=corner, unit_weight_kn_m3=wall.unit_weight_kn_m3 or 1.0, **kept)


class BodyDrawing:
    """What of a wall is no rectangle; empty of one.

    section : outlines, x [m] from the middle of the base to the right; elevation : outlines (s, z) [m]
    ends : how far to the left and to the right it reaches, `half` of a rectangle [m]; top : how high [m]
    """

    def __init__(self, wall: Wall | None = None, half: float = 0.0):
        outlines = section_outlines(wall) if wall else []
        self.section = [Outline([(half - x, z) for x, z in outline.points], outline.kind) for outline in outlines]
        self.elevation = [one for one in elevation_outlines(wall) if one.kind != "wedge"] if wall else []
        points = [point for one in self.section for point in one.points]
        self.ends = (min([-half, *(x for x, _ in points)]), max([half, *(x for x, _ in points)]))
        self.top = max((z for _, z in points), default=0.0)
        self.parts, self.half = wall.parts if wall else (), half
        self.length = wall.length_m if wall and any(part.plane == "oblique" for part in self.parts) else None

    @property
    def cracks(self) -> list[list[tuple[float, float]]]:
        """Lines of the cracks of its wedges."""
        return [points[:2] for points, kind in self.section if kind == "wedge"]

    @property
    def along(self) -> tuple[float, float]:
        """Ends of its elevation [m]."""
        across = [s for one in self.elevation for s, _ in one.points]
        return (min(across), max(across)) if across else (0.0, 0.0)

    def outer_face(self, level: float) -> float:
        """Where its outer face is at a height, from the middle of the base [m]."""
        faces = faces_at(self.parts, level)
        return self.half - faces[0] if faces else self.half

    def draw_section(self, painter, place: Callable, hinge: float, rotation: float) -> None:
        """Its solids and wedges, turned; openings dashed; the crack of the wedges, and the return walls behind it."""
        for (x0, z0), (x1, z1) in self.cracks:
            rest = [(x0, 0.0), (x0, z0), (x1, z1), (x1, 0.0)]
            path = QPainterPath()
            path.addPolygon(QPolygonF([place(QPointF(x, z)) for x, z in rest]))
            painter.fillPath(path, QColor(theme.current.grid))
        for points, kind in sorted(self.section, key=lambda one: one.kind == "opening"):
            painter.save()
            if kind == "opening":
                painter.setBrush(Qt.BrushStyle.NoBrush)
                painter.setPen(QPen(painter.pen().color(), 1.0, Qt.PenStyle.DashLine))
            painter.drawPolygon(QPolygonF([place(point) for point in turned(points, hinge, rotation)]))
            painter.restore()
        painter.save()
        painter.setPen(QPen(QColor(theme.current.bad), 2.0, Qt.PenStyle.DashLine))
        for crack in self.cracks:
            painter.drawLine(*(place(QPointF(x, z)) for x, z in crack))
        painter.restore()

    def draw_elevation(self, painter, base: QPointF, scale: float, hinges=()) -> None:
        """The body seen from outside, with its hinges. base : where s and z are 0; scale : that of its section;
        hinges : height [m] and zeta of each"""
        painter.setPen(QPen(QColor(theme.current.ink), 1.4))
        shade = QColor(theme.current.curves[0])
        shade.setAlpha(70)
        for points, kind in sorted(self.elevation, key=lambda one: one.kind == "opening"):
            painter.setBrush(QColor(theme.current.back) if kind == "opening" else shade)
            corners = [QPointF(base.x() + scale * s, base.y() - scale * z) for s, z in points]
            painter.drawPolygon(QPolygonF(corners))
        first, last = self.along
        for level, zeta in hinges:
            y = base.y() - scale * level
            painter.setPen(QPen(QColor(theme.current.ink), 1.2, Qt.PenStyle.DashLine))
            painter.drawLine(QPointF(base.x() + scale * first, y), QPointF(base.x() + scale * last, y))
            painter.setPen(QColor(theme.current.ink))
            if zeta is not None:
                painter.drawText(QPointF(base.x() + scale * first + 4.0, y - 3.0), f"ζ {number(zeta, '.2f')}")
        painter.setPen(QColor(theme.current.ink))
        words = f"L {number(self.length or last - first, '.2f')} m"  # oblique solids are seen shortened
        at = base.x() + scale * 0.5 * (first + last) - 0.5 * painter.fontMetrics().horizontalAdvance(words)
        painter.drawText(QPointF(at, base.y() + 16), words)
