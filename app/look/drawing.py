"""Drawings of a wall: to scale with its dimensions, rocking, and the pictures of the mechanisms."""

import math
from collections.abc import Sequence
from dataclasses import fields, replace

from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QFont, QIcon, QPainter, QPainterPath, QPen, QPixmap, QPolygonF
from PySide6.QtWidgets import QWidget

from app.look import theme
from app.look.language import number
from core.case.schema import Wall
from core.case.solids import Opening, Solid
from core.errors import InputError
from core.report.load_arrows import arrows
from core.report.outlines import Outline, in_elevation, in_section
from core.rocking.bar_state import BROKEN, SLACK, YIELDING
from core.wall.wall_body import faces_at, has_shape, parts_of


def outline(height: float, thickness: float, setback: float, rotation: float) -> list[QPointF]:
    """Corners of a wall [m], x right, y up, base centred; turned about its hinge by rotation [rad],
    positive to the right."""
    half = 0.5 * thickness
    corners = [(-half, 0.0), (half, 0.0), (half, height), (-half, height)]
    return turned(corners, half - setback, rotation)


def turned(corners: Sequence[tuple[float, float]], hinge: float, rotation: float) -> list[QPointF]:
    """Points [m] turned by rotation [rad] about the hinge on the side they turn to, `hinge` [m] from the middle."""
    hinge = math.copysign(hinge, rotation)
    c, s = math.cos(rotation), math.sin(rotation)
    return [QPointF(hinge + c * (x - hinge) + s * y, -s * (x - hinge) + c * y) for x, y in corners]


def complete(wall: Wall) -> Wall:
    """A wall without what of its shape is still to be given."""

    def is_given(entry) -> bool:
        values = {one.name: getattr(entry, one.name) for one in fields(entry)}
        if isinstance(entry, Opening) and entry.diameter_m is None:
            return "" not in values.values() and None not in (entry.width_m, entry.height_m)
        if isinstance(entry, Solid) and (
            len(entry.polygon_m) < 3 or (entry.angle_deg is None) == (entry.plane == "oblique")
        ):
            return False
        return "" not in values.values()

    if not has_shape(wall):
        return wall
    kept = {key: tuple(filter(is_given, getattr(wall, key))) for key in ("openings", "steps", "solid")}
    wedges = wall.return_wedges if wall.return_wedges and is_given(wall.return_wedges) else None
    return replace(wall, return_wedges=wedges, unit_weight_kn_m3=wall.unit_weight_kn_m3 or 1.0, **kept)


NEAR = 7.0
"""How close to a mark a click belongs to it [px]."""

BESIDE = 420
"""Width from which on the elevation of a body stands beside its section [px]."""

STEP = 0.05
"""Heights a load is dragged to are multiples of it [m]."""


class WallDrawing(QWidget):
    """A wall to scale; `rotation` turns it. For a general block its equivalent rectangle.

    with_sizes : with its dimensions, and with places to click and to drag
    picked(kind, k) : the k-th load or hinge was clicked, or "height", "thickness"; moved(k, height) : the k-th load was
    dragged to this height [m]
    """

    picked = Signal(str, int)
    moved = Signal(int, float)

    def __init__(self, with_sizes: bool = True):
        super().__init__()
        self.spots: list[tuple[QRectF, str, int]] = []
        self.dragged: int | None = None
        self.scale = 1.0
        self.base_y = 0.0
        self.setMouseTracking(with_sizes)
        self.with_sizes = with_sizes
        self.size_of: tuple[float, float, float] | None = None
        self.one_sided = False
        self.arrows: list[list[tuple[float, float]]] = []
        self.bars: list[tuple[float, int]] = []
        self.hinges: list[tuple[float, float | None]] = []
        self.body: list[Outline] = []
        self.elevation: list[Outline] = []
        self.ends = (0.0, 0.0)
        self.outer: dict[float, float] = {}
        self.rotation = 0.0
        self.setMinimumSize(QSize(90, 120))

    def show_wall(self, wall: Wall | None, hinges: Sequence[tuple[float, float | None]] = ()) -> None:
        """Draw this wall; what is not complete leaves the place empty. hinges : height [m] and zeta of each, where
        it has more than the one at its base."""
        self.size_of, self.arrows, self.bars, self.hinges = None, [], [], list(hinges)
        self.body, self.elevation, self.outer = [], [], {}
        if wall is not None:
            try:
                wall = complete(wall)
                block = wall.block()
                height = wall.height_m or block.height
                thickness = wall.thickness or block.thickness
                self.size_of = (height, thickness, wall.setback if wall.height_m else 0.0)
                self.one_sided = wall.mechanism == "one_sided"
                self.ends = (-0.5 * thickness, 0.5 * thickness)
                self._take_body(wall, 0.5 * thickness)
                self.arrows = arrows(wall, height, thickness)
            except (InputError, TypeError):
                pass
        self.update()

    def _take_body(self, wall: Wall, half: float) -> None:
        """Its outlines, x from the middle of the base to the right; how far they reach; its outer face at hinges."""
        mirrored = [Outline([(half - x, z) for x, z in one.points], one.kind) for one in in_section(wall)]
        self.body, self.elevation = mirrored, [one for one in in_elevation(wall) if one.kind != "wedge"]
        xs = [x for one in mirrored for x, _ in one.points]
        self.ends = (min([-half, *xs]), max([half, *xs]))
        for level, _ in self.hinges if mirrored else ():
            faces = faces_at(parts_of(wall), level)
            self.outer[level] = half - faces[0] if faces else half

    def set_rotation(self, rotation: float) -> None:
        """Show the wall at this rotation [rad]."""
        self.rotation = rotation
        self.update()

    def paintEvent(self, event) -> None:
        """The wall, its ground, what stands behind it, its hinges and sizes."""
        self.spots = []
        if self.size_of is None:
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        height, thickness, setback = self.size_of
        ink, quiet = QColor(theme.current.ink), QColor(theme.current.quiet)
        base, seen = self._fit(height, thickness)
        scale = self.scale

        def place(point: QPointF) -> QPointF:
            return QPointF(base.x() + scale * point.x(), base.y() - scale * point.y())

        painter.setPen(QPen(quiet, 1.5))
        painter.drawLine(QPointF(8, base.y()), QPointF(self.width() - 8, base.y()))
        if self.one_sided and not any(one.kind == "wedge" for one in self.body):
            behind = place(QPointF(-0.5 * thickness, 0.0)).x() - 3
            area = QRectF(behind - 8, base.y() - scale * height, 8, scale * height)
            painter.fillRect(area, QColor(theme.current.grid))
        painter.setPen(QPen(ink, 1.4))
        shade = QColor(theme.current.curves[0])
        shade.setAlpha(70)
        painter.setBrush(shade)
        if self.body:
            self._draw_body(painter, place)
        else:
            corners = [place(point) for point in outline(height, thickness, setback, self.rotation)]
            painter.drawPolygon(QPolygonF(corners))
        painter.setBrush(QColor(theme.current.bad))
        painter.setPen(Qt.PenStyle.NoPen)
        sides = (1.0,) if self.one_sided else (-1.0, 1.0)
        for side in sides:
            painter.drawEllipse(place(QPointF(side * (0.5 * thickness - setback), 0.0)), 3, 3)
        for level, _ in self.hinges:
            painter.drawEllipse(place(QPointF(self.outer.get(level, 0.5 * thickness) - setback, level)), 3, 3)
        self._draw_bars(painter, place)
        if self.rotation == 0.0 and not self.bars:
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.setPen(QPen(QColor(theme.current.amber), 1.8))
            for points in self.arrows:
                painter.drawPolyline([place(QPointF(x - 0.5 * thickness, y)) for x, y in points])
        if self.with_sizes:
            self._zetas(painter, place)
            self._sizes(painter, place, height, thickness, setback)
            self._mark_spots(place, height, thickness, setback)
        if seen is not None:
            self._draw_elevation(painter, seen)

    def _fit(self, height: float, thickness: float) -> tuple[QPointF, QPointF | None]:
        """Sets the scale; the middle of the base, and where s and z of the elevation are 0, None without it."""
        sizes = 34 if self.with_sizes else 8
        drawn = [points for points, _ in self.body]
        top = max([height, *(y for points in (*self.arrows, *drawn) for _, y in points)])
        left, right = self.ends
        reach = right - left if self.with_sizes else max(thickness + 1.1 * height, 2.0 * max(right, -left))
        beside = 30 if self.with_sizes else 0  # room for the height in numbers
        across = [s for one in self.elevation for s, _ in one.points] if self._has_elevation else []
        along = max(across) - min(across) if across else 0.0
        room = self.width() - beside - (64 if across else 16)
        scale = min((self.height() - 2 * sizes + (12 if self.with_sizes else -8)) / top, room / (reach + along))
        wide = self.width() - (scale * along + 32 if across else 0.0)
        middle = 0.5 * (left + right) if self.with_sizes else 0.0
        base = QPointF(0.5 * (wide - beside) + 8 - scale * middle, self.height() - sizes)
        self.scale, self.base_y = scale, base.y()
        return base, QPointF(wide + 8 - scale * min(across), base.y()) if across else None

    @property
    def _has_elevation(self) -> bool:
        return self.with_sizes and bool(self.elevation) and self.width() >= BESIDE

    def _draw_body(self, painter, place) -> None:
        """Its solids and wedges, turned; openings dashed; the crack of the wedges, and the return walls behind it."""
        _, thickness, setback = self.size_of
        cracks = [points[:2] for points, kind in self.body if kind == "wedge"]
        for (x0, z0), (x1, z1) in cracks:
            rest = [(x0, 0.0), (x0, z0), (x1, z1), (x1, 0.0)]
            path = QPainterPath()
            path.addPolygon(QPolygonF([place(QPointF(x, z)) for x, z in rest]))
            painter.fillPath(path, QColor(theme.current.grid))
        for points, kind in sorted(self.body, key=lambda one: one.kind == "opening"):
            painter.save()
            if kind == "opening":
                painter.setBrush(Qt.BrushStyle.NoBrush)
                painter.setPen(QPen(painter.pen().color(), 1.0, Qt.PenStyle.DashLine))
            corners = turned(points, 0.5 * thickness - setback, self.rotation)
            painter.drawPolygon(QPolygonF([place(point) for point in corners]))
            painter.restore()
        painter.save()
        painter.setPen(QPen(QColor(theme.current.bad), 2.0, Qt.PenStyle.DashLine))
        for crack in cracks:
            painter.drawLine(*(place(QPointF(x, z)) for x, z in crack))
        painter.restore()

    def _draw_elevation(self, painter, base: QPointF) -> None:
        """The body seen from outside, to the scale of its section. base : where s and z are 0"""
        painter.setPen(QPen(QColor(theme.current.ink), 1.4))
        shade = QColor(theme.current.curves[0])
        shade.setAlpha(70)
        for points, kind in sorted(self.elevation, key=lambda one: one.kind == "opening"):
            painter.setBrush(QColor(theme.current.back) if kind == "opening" else shade)
            corners = [QPointF(base.x() + self.scale * s, base.y() - self.scale * z) for s, z in points]
            painter.drawPolygon(QPolygonF(corners))
        across = [s for one in self.elevation for s, _ in one.points]
        words = f"L {number(max(across) - min(across), '.2f')} m"
        middle = base.x() + self.scale * 0.5 * (min(across) + max(across))
        painter.drawText(QPointF(middle - 0.5 * painter.fontMetrics().horizontalAdvance(words), base.y() + 16), words)

    def _mark_spots(self, place, height, thickness, setback) -> None:
        """Where a click leads to a field: loads first, for a tie may stand at a hinge."""

        def around(points, kind: str, k: int = 0) -> None:
            area = QPolygonF([place(QPointF(x, y)) for x, y in points]).boundingRect()
            self.spots.append((area.adjusted(-NEAR, -NEAR, NEAR, NEAR), kind, k))

        half = 0.5 * thickness
        for k, points in enumerate(self.arrows):
            around([(x - half, y) for x, y in points], "load", k)
        for k, (level, _) in enumerate(self.hinges or [(0.0, None)]):
            around([(half - setback, level)], "hinge", k)
        edge = self.ends[1]
        around([(edge + 6.0 / self.scale, 0.1 * height), (edge + 20.0 / self.scale, 0.9 * height)], "height")
        around([(-half, -18.0 / self.scale), (half, -6.0 / self.scale)], "thickness")

    def _spot_at(self, point: QPointF) -> tuple[str, int] | None:
        return next(((kind, k) for area, kind, k in self.spots if area.contains(point)), None)

    def mouseMoveEvent(self, event) -> None:
        spot = self._spot_at(event.position())
        if self.dragged is not None and event.buttons() & Qt.MouseButton.LeftButton:
            height = STEP * round((self.base_y - event.position().y()) / self.scale / STEP)
            self.moved.emit(self.dragged, round(max(STEP, min(height, self.size_of[0])), 3))
        elif spot is None:
            self.unsetCursor()
        else:
            load = spot[0] == "load"
            self.setCursor(Qt.CursorShape.SizeVerCursor if load else Qt.CursorShape.PointingHandCursor)

    def mousePressEvent(self, event) -> None:
        spot = self._spot_at(event.position()) if self.with_sizes else None
        if spot is None:
            return
        self.dragged = spot[1] if spot[0] == "load" else None
        self.picked.emit(*spot)

    def mouseReleaseEvent(self, event) -> None:
        self.dragged = None

    def _draw_bars(self, painter, place) -> None:
        """The bars that hold a wall as it rocks: taut, slack (dashed), yielding (red, thick); none where one broke."""
        height, thickness, setback = self.size_of
        half = 0.5 * thickness
        hinge, turned = half - setback, max(self.rotation, 0.0)
        c, s = math.cos(turned), math.sin(turned)
        for at, phase in self.bars:
            if phase == BROKEN:
                continue
            color = theme.current.bad if phase == YIELDING else theme.current.amber
            style = Qt.PenStyle.DashLine if phase == SLACK else Qt.PenStyle.SolidLine
            painter.setPen(QPen(QColor(color), 3.4 if phase == YIELDING else 1.8, style))
            plate = QPointF(hinge + c * setback + s * at, c * at - s * setback)
            painter.drawLine(place(QPointF(-half - 0.15 * height, at)), place(plate))
            painter.setPen(QPen(QColor(color), 3.0))
            reach = 0.02 * height
            ends = (QPointF(plate.x() + way * s * reach, plate.y() + way * c * reach) for way in (1.0, -1.0))
            painter.drawLine(*map(place, ends))

    def _zetas(self, painter, place) -> None:
        """zeta at each hinge, the smallest in red and bold."""
        known, font = [zeta for _, zeta in self.hinges if zeta is not None], QFont(self.font())
        for level, zeta in self.hinges:
            if zeta is not None:
                weakest = zeta == min(known)
                painter.setPen(QColor(theme.current.bad if weakest else theme.current.ink))
                font.setBold(weakest)
                painter.setFont(font)
                words = f"ζ {number(zeta, '.2f')}"
                at = place(QPointF(self.ends[0], level))
                wide = painter.fontMetrics().horizontalAdvance(words)
                painter.drawText(QPointF(max(0.0, at.x() - wide - 14), at.y() - 2), words)

    def _sizes(self, painter, place, height, thickness, setback) -> None:
        painter.setPen(QColor(theme.current.ink))
        font = QFont(self.font())
        font.setPointSizeF(max(7.0, 0.9 * font.pointSizeF()))
        painter.setFont(font)
        low, high = place(QPointF(self.ends[1], 0.0)), place(QPointF(self.ends[1], height))
        x = low.x() + 10
        painter.drawLine(QPointF(x, low.y()), QPointF(x, high.y()))
        for y in (low.y(), high.y()):
            painter.drawLine(QPointF(x - 3, y), QPointF(x + 3, y))
        words = f"H {number(height, '.2f')} m"
        painter.save()
        half = 0.5 * painter.fontMetrics().horizontalAdvance(words)
        painter.translate(x + 14, min(0.5 * (low.y() + high.y()) + half, low.y()))
        painter.rotate(-90.0)
        painter.drawText(QPointF(0.0, 0.0), words)
        painter.restore()
        words = f"t {number(100 * thickness, '.1f')} cm" + (f", u {number(100 * setback, '.1f')} cm" if setback else "")
        width = painter.fontMetrics().horizontalAdvance(words)
        middle = place(QPointF(0.0, 0.0)).x()
        painter.drawText(QPointF(max(2.0, middle - 0.5 * width), low.y() + 16), words)


def mechanism_icon(name: str, size: int = 52) -> QIcon:
    """A picture of a mechanism: rocking on both sides, on one side, both studied."""
    picture = QPixmap(size, size)
    picture.fill(Qt.GlobalColor.transparent)
    painter = QPainter(picture)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    ink = QColor(theme.current.ink)
    painter.setPen(QPen(ink, 1.2))
    painter.drawLine(4, size - 6, size - 4, size - 6)
    turns = {"two_sided": (-0.22, 0.22), "one_sided": (0.25,), "both": (-0.22, 0.25)}[name]
    if name != "two_sided":
        painter.fillRect(QRectF(size / 2 - 15, 10, 7, size - 16), QColor(theme.current.quiet))
    for k, rotation in enumerate(turns):
        shade = QColor(theme.current.curves[0 if rotation > 0 else 1])
        shade.setAlpha(110)
        painter.setBrush(shade)
        pen = QPen(ink, 1.2)
        if name == "both" and k == 0:
            pen.setStyle(Qt.PenStyle.DashLine)
        painter.setPen(pen)
        corners = outline(34.0, 12.0, 0.0, rotation)
        polygon = QPolygonF([QPointF(size / 2 + p.x(), size - 6 - p.y()) for p in corners])
        painter.drawPolygon(polygon)
    painter.end()
    return QIcon(picture)
