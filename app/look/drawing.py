"""Drawings of a wall: to scale with its dimensions, rocking, and the pictures of the mechanisms."""

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import NamedTuple

from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QFont, QIcon, QPainter, QPen, QPixmap, QPolygonF
from PySide6.QtWidgets import QWidget

from app.look import theme
from app.look.body_drawing import BodyDrawing, complete, turned
from app.look.hold_drawing import HoldMark, find_hold_marks, find_strength, paint_holds, write_strengths
from app.look.language import number
from app.look.plan_drawing import paint_plan, plan_of
from core.case.detached import make_leaf_wall
from core.case.held_top import mirror_inward
from core.case.hinges import WallPart
from core.case.loads import Load
from core.case.wall import Wall
from core.codes.bending_outline import outlines, shown_rotation
from core.codes.vertical_bending import Bending, bending
from core.errors import InputError
from core.known import require_value
from core.report.load_arrows import MIN_ARROW, arrows
from core.rocking.bar_state import BROKEN, SLACK, YIELDING
from core.wall.bending import HeldTop, Strip, hinges_of, strip_of
from core.wall.kinematics import kinematics


def outline(height: float, thickness: float, setback: float, rotation: float) -> list[QPointF]:
    """Corners of a wall [m], x right, y up, base centred; turned about its hinge by rotation [rad],
    positive to the right."""
    half = 0.5 * thickness
    corners = [(-half, 0.0), (half, 0.0), (half, height), (-half, height)]
    return turned(corners, half - setback, rotation)


class Bent(NamedTuple):
    """Both blocks of a wall held at its top as they turn, and its three hinges at rest, as `outline` gives them."""

    blocks: tuple[list[QPointF], ...] = ()
    hinges: tuple[QPointF, ...] = ()


def bent_blocks(mechanism: Bending) -> Bent:
    """A wall held at its top."""
    strip, half, at = mechanism.strip, 0.5 * mechanism.strip.thickness, hinges_of(mechanism.strip, mechanism.h1)
    blocks = outlines(strip, mechanism.h1, shown_rotation(mechanism))
    hinges = ((at.base, 0.0), (at.between, mechanism.h1), (at.top, strip.height))
    return Bent(
        tuple([QPointF(half - x, z) for x, z in block] for block in blocks),
        tuple(QPointF(half - x, z) for x, z in hinges),
    )


def moving_blocks(held: HeldTop, rotation: float) -> list[list[QPointF]]:
    """Both blocks of a wall held at its top at a rotation of the lower one [rad], inward negative."""
    strip, half = held.outward, 0.5 * held.outward.thickness
    if rotation < 0.0:
        strip = held.inward
    turned_by = min(abs(rotation), 0.9 * held.side(math.copysign(1.0, rotation)).last)
    blocks, side = outlines(strip, held.h1, turned_by), 1.0 if rotation >= 0.0 else -1.0
    return [[QPointF(side * (half - x), z) for x, z in block] for block in blocks]


def part_moved(part: WallPart) -> list[list[QPointF]]:
    """Outlines of the part of a wall that moves, turned, as `outline` gives them; none of a body that is no rectangle,
    nor of what moves in plan or in another direction."""
    wall = part.wall
    if part.aspect or wall.has_shape or None in (wall.height_m, wall.thickness) or wall.kinematics.arches:
        return []
    if wall.kinematics.bends_up:
        side = -1.0 if part.inward else 1.0
        blocks = [[QPointF(side * p.x(), p.y()) for p in block] for block in bent_blocks(bending(wall.in_si)).blocks]
    else:
        blocks = [outline(require_value(wall.height_m), require_value(wall.thickness), wall.setback, SHOWN_TURNED)]
    return [[QPointF(p.x(), p.y() + part.hinge) for p in block] for block in blocks]


class Arrow(NamedTuple):
    """A load as it is drawn.

    load : its place among those of the wall
    points : corners of a line [m], as `core.report.load_arrows.arrows` gives them
    words : its size; "" of one that is still to be given
    """

    load: int
    points: list[tuple[float, float]]
    words: str


def _is_given(load: Load) -> bool:
    """Whether size and place of a load are."""
    try:
        return math.isfinite(load.in_si.force)
    except (InputError, TypeError):
        return False


def _with_loads_given(wall: Wall) -> Wall:
    loads = tuple(filter(_is_given, wall.load))
    holds = tuple(hold for hold in wall.hold if not hold.is_tie or find_strength(wall, hold) is not None)
    same = loads == wall.load and holds == wall.hold
    return wall if same else replace(wall, load=loads, hold=holds)  # the same keeps what is known of its body


def arrows_of(wall: Wall, all_loads: Sequence[Load], height: float, thickness: float) -> list[Arrow]:
    """The loads of a wall; those still to be given at its middle or top, as arrows of no size.

    wall : with the loads that are given
    all_loads : of the wall of the form
    """
    lines, drawn = iter(arrows(wall, height, thickness)), []
    for k, load in enumerate(all_loads):
        if load in wall.load:
            size = f"{number(abs(load.in_si.force) / 1e3, '.3g')} kN/m"
            drawn.append(Arrow(k, next(lines), size))
            continue
        at = load.h_m if isinstance(load.h_m, float) else height
        x = thickness - load.d_m if isinstance(load.d_m, float) else 0.5 * thickness
        size = MIN_ARROW * height
        line = [(x, at + size), (x, at)] if load.is_weight else [(x - size, at), (x, at)]
        drawn.append(Arrow(k, line, ""))
    return drawn


def leaf_lines(wall: Wall) -> list[list[tuple[float, float]]]:
    """The inner face of the outer leaf of a wall, and its connectors: lines of (x outward of the middle, z) [m]."""
    if wall.leaf is None:
        return []
    leaf = make_leaf_wall(wall)
    half, height = 0.5 * require_value(wall.thickness), require_value(wall.height_m)
    face = half - require_value(leaf.thickness)
    rows = [require_value(tie.h_m) for tie in leaf.ties if tie not in wall.ties]
    return [[(face, 0.0), (face, height)], *([(-half, row), (half, row)] for row in rows)]


CLICK_MARGIN = 7.0
"""How close to a mark a click belongs to it [px]."""

MIN_WIDTH_OF_ELEVATION = 420
"""Width from which on the elevation of a body stands beside its section [px]."""

SHOWN_TURNED = 0.12
"""Rotation of the part that decides in a drawing [rad]."""

HEIGHT_STEP = 0.05
"""Heights a load is dragged to are multiples of it [m]."""

DRAGGED = "load", "hold"
"""What can be dragged."""


class WallDrawing(QWidget):
    """A wall to scale; `rotation` turns it. For a general block its equivalent rectangle.

    with_sizes : with its dimensions, and with places to click and to drag
    picked(kind, k) : the k-th load, hold or hinge was clicked, or "height", "thickness"; asked(kind, k, area) : twice,
    to be changed there; moved(kind, k, height) : the k-th load or hold was dragged to this height [m]
    """

    picked = Signal(str, int)
    asked = Signal(str, int, QRectF)
    moved = Signal(str, int, float)

    def __init__(self, with_sizes: bool = True):
        super().__init__()
        self.spots: list[tuple[QRectF, str, int]] = []
        self.dragged: tuple[str, int] | None = None
        self.scale = 1.0
        self.base_y = 0.0
        self.setMouseTracking(with_sizes)
        self.with_sizes = with_sizes
        self.size_of: tuple[float, float, float] | None = None
        self.one_sided = False
        self.bent = Bent()
        self.held: HeldTop | None = None
        self.plan: Bending | None = None
        self.arrows: list[Arrow] = []
        self.holds: list[HoldMark] = []
        self.bars: list[tuple[float, int]] = []
        self.hinges: list[tuple[float, float | None]] = []
        self.decides: tuple[float, str] | None = None
        self.body = BodyDrawing()
        self.rotation = 0.0
        self._shown: tuple[Wall | None, list] = (None, [])
        self.leaf: Sequence = ()
        self.turned_part: list[list[QPointF]] = []
        self.least_extent = (0.0, 0.0)
        """Room [m] that it has at least: of another drawing beside it, so that both have one scale."""
        self.setMinimumSize(QSize(90, 120))

    def show_wall(
        self,
        wall: Wall | None,
        hinges: Sequence[tuple[float, float | None]] = (),
        decides: tuple[float, str] | None = None,
        moves: WallPart | None = None,
    ) -> None:
        """Draw this wall; what is not complete leaves the place empty. hinges : height [m] and zeta of each, where
        it has more than the one at its base; decides : height of what decides, and the tone of its outcome; moves :
        the part that decides, drawn as it moves.
        What is shown already is not painted again."""
        if (wall, [*hinges, decides, moves]) == self._shown:
            return
        self._shown, self.decides = (wall, [*hinges, decides, moves]), decides
        self.turned_part = part_moved(moves) if moves is not None else []
        self.size_of, self.arrows, self.holds, self.bars, self.hinges = None, [], [], [], list(hinges)
        self.body = BodyDrawing()
        self.bent, self.held, self.plan, self.leaf = Bent(), None, None, ()
        if wall is not None:
            try:
                asked = complete(wall)
                wall = _with_loads_given(asked)
                block = wall.block()
                height = wall.height_m or block.height
                thickness = wall.thickness or block.thickness
                self.size_of = (height, thickness, wall.setback if wall.height_m else 0.0)
                self.one_sided = wall.kinematics.one_way
                self.holds = find_hold_marks(asked, height)
                self.body = BodyDrawing(wall, 0.5 * thickness)
                self.arrows = arrows_of(wall, asked.load, height, thickness)
                self.plan = plan_of(wall) if self.with_sizes else None
                self.leaf = leaf_lines(wall) if self.with_sizes else ()
                if wall.kinematics.bends_up:
                    self.bent = bent_blocks(mechanism := bending(wall.in_si))
                    self.held = HeldTop(mechanism.strip, strip_of(mirror_inward(wall).in_si), mechanism.h1)
            except (InputError, TypeError):
                pass
        self.update()

    def set_rotation(self, rotation: float) -> None:
        """Show the wall at this rotation [rad]."""
        self.rotation = rotation
        self.update()

    @property
    def ends(self) -> tuple[float, float]:
        """Left and right end of what is drawn [m], the part that decides as it moves with it."""
        moved = [point.x() for block in self.turned_part for point in block]
        left, right = self.body.ends
        return min([left, *moved]), max([right, *moved])

    @property
    def extent(self) -> tuple[float, float]:
        """Height and width of what is drawn [m]; a wall that rocks may lie down."""
        height, thickness, _ = self.size_of or (0.0, 0.0, 0.0)
        top = max([height, self.body.top, *(y for arrow in self.arrows for _, y in arrow.points)])
        left, right = self.ends
        return top, right - left if self.with_sizes else max(thickness + 1.1 * height, 2.0 * max(right, -left))

    def paintEvent(self, event) -> None:
        """The wall, its ground, what stands behind it, its hinges and sizes."""
        self.spots = []
        if self.size_of is None:
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        height, thickness, setback = self.size_of
        ink, quiet = QColor(theme.current.ink), QColor(theme.current.quiet)
        base, seen = self._fit()
        scale = self.scale

        def place(point: QPointF) -> QPointF:
            return QPointF(base.x() + scale * point.x(), base.y() - scale * point.y())

        painter.setPen(QPen(quiet, 1.5))
        painter.drawLine(QPointF(8, base.y()), QPointF(self.width() - 8, base.y()))
        if not self.body.cracks:
            paint_holds(painter, self.holds, place, height, thickness)
        painter.setPen(QPen(ink, 1.4))
        shade = QColor(theme.current.curves[0])
        shade.setAlpha(70)
        painter.setBrush(shade)
        if self.held is not None and self.rotation != 0.0:
            for block in moving_blocks(self.held, self.rotation):
                painter.drawPolygon(QPolygonF([place(point) for point in block]))
        elif self.body.section:
            self.body.draw_section(painter, place, 0.5 * thickness - setback, self.rotation)
        else:
            corners = [place(point) for point in outline(height, thickness, setback, self.rotation)]
            painter.drawPolygon(QPolygonF(corners))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(QPen(quiet, 1.2, Qt.PenStyle.DashLine))
        for block in self.bent.blocks if self.rotation == 0.0 and self.with_sizes else ():
            painter.drawPolyline([place(point) for point in block])
        self._draw_moved(painter, place)
        for line in self.leaf:
            painter.drawPolyline([place(QPointF(x, y)) for x, y in line])
        painter.setBrush(QColor(theme.current.bad))
        painter.setPen(Qt.PenStyle.NoPen)
        for point in self.bent.hinges:
            painter.drawEllipse(place(point), 3, 3)
        sides = () if self.bent.hinges else (1.0,) if self.one_sided else (-1.0, 1.0)
        for side in sides:
            painter.drawEllipse(place(QPointF(side * (0.5 * thickness - setback), 0.0)), 3, 3)
        for level, _ in self.hinges:
            painter.drawEllipse(place(QPointF(self.body.outer_face(level) - setback, level)), 3, 3)
        self._draw_bars(painter, place)
        if self.rotation == 0.0 and not self.bars:
            self._draw_arrows(painter, place)
        if self.with_sizes:
            write_strengths(painter, self.holds, place, thickness)
            self._zetas(painter, place)
            self._sizes(painter, place, height, thickness, setback)
            self._mark_spots(place, height, thickness, setback)
        if self.plan is not None:
            paint_plan(painter, self.width(), self.plan)
        if seen is not None:
            self.body.draw_elevation(painter, seen, scale, self.hinges)

    def _draw_moved(self, painter: QPainter, place: Callable[[QPointF], QPointF]) -> None:
        """What decides as it moves, in the colour of its outcome."""
        if self.rotation != 0.0 or not self.turned_part:
            return
        shade = QColor(getattr(theme.current, self.decides[1] if self.decides else "", theme.current.quiet))
        fill = QColor(shade)
        fill.setAlpha(40)
        painter.setPen(QPen(shade, 1.2, Qt.PenStyle.DashLine))
        painter.setBrush(fill)
        for block in self.turned_part:
            painter.drawPolygon(QPolygonF([place(point) for point in block]))
        painter.setPen(QPen(QColor(theme.current.quiet), 1.2, Qt.PenStyle.DashLine))
        painter.setBrush(Qt.BrushStyle.NoBrush)

    def _fit(self) -> tuple[QPointF, QPointF | None]:
        """Sets the scale; the middle of the base, and where s and z of the elevation are 0, None without it."""
        sizes = 34 if self.with_sizes else 8
        beside = 30 if self.with_sizes else 0  # room for the height in numbers
        top, reach = map(max, self.extent, self.least_extent)
        first, last = self.body.along if self.has_elevation else (0.0, 0.0)
        room = self.width() - beside - (64 if self.has_elevation else 16)
        high = self.height() - 2 * sizes + (12 if self.with_sizes else -8)
        scale = min(high / top, room / (reach + last - first))
        wide = self.width() - (scale * (last - first) + 32 if self.has_elevation else 0.0)
        middle = 0.5 * sum(self.ends) if self.with_sizes else 0.0
        base = QPointF(0.5 * (wide - beside) + 8 - scale * middle, self.height() - sizes)
        self.scale, self.base_y = scale, base.y()
        return base, QPointF(wide + 8 - scale * first, base.y()) if self.has_elevation else None

    @property
    def has_elevation(self) -> bool:
        """Whether there is room for one beside the section of a body."""
        return self.with_sizes and bool(self.body.elevation) and self.width() >= MIN_WIDTH_OF_ELEVATION

    def _mark_spots(self, place, height, thickness, setback) -> None:
        """Where a click leads to a field: loads first."""

        def around(points, kind: str, k: int = 0) -> None:
            area = QPolygonF([place(QPointF(x, y)) for x, y in points]).boundingRect()
            self.spots.append((area.adjusted(-CLICK_MARGIN, -CLICK_MARGIN, CLICK_MARGIN, CLICK_MARGIN), kind, k))

        half = 0.5 * thickness
        for arrow in self.arrows:
            around([(x - half, y) for x, y in arrow.points], "load", arrow.load)
        for mark in self.holds:
            if mark.hold is not None:
                self.spots.append((mark.area(place, -half).adjusted(-3.0, -3.0, 0.0, 3.0), "hold", mark.hold))
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
            height = HEIGHT_STEP * round((self.base_y - event.position().y()) / self.scale / HEIGHT_STEP)
            self.moved.emit(*self.dragged, round(max(HEIGHT_STEP, min(height, require_value(self.size_of)[0])), 3))
        elif spot is None:
            self.unsetCursor()
        else:
            drags = spot[0] in DRAGGED
            self.setCursor(Qt.CursorShape.SizeVerCursor if drags else Qt.CursorShape.PointingHandCursor)

    def mousePressEvent(self, event) -> None:
        spot = self._spot_at(event.position()) if self.with_sizes else None
        if spot is None:
            return
        self.dragged = spot if spot[0] in DRAGGED else None
        self.picked.emit(*spot)

    def mouseDoubleClickEvent(self, event) -> None:
        at = event.position()
        hit = next((spot for spot in self.spots if spot[0].contains(at)), None) if self.with_sizes else None
        if hit is not None:
            self.dragged = None
            area, kind, k = hit
            self.asked.emit(kind, k, area)

    def mouseReleaseEvent(self, event) -> None:
        self.dragged = None

    def _draw_arrows(self, painter, place) -> None:
        """The loads, each with its size; dashed what is still to be given."""
        half, taken = 0.5 * require_value(self.size_of)[1], []
        painter.setBrush(Qt.BrushStyle.NoBrush)
        for arrow in self.arrows:
            style = Qt.PenStyle.SolidLine if arrow.words else Qt.PenStyle.DashLine
            painter.setPen(QPen(QColor(theme.current.amber), 1.8, style))
            corners = [place(QPointF(x - half, y)) for x, y in arrow.points]
            painter.drawPolyline(corners)
            if self.with_sizes:
                painter.setPen(QColor(theme.current.ink))
                metrics = painter.fontMetrics()
                wide = metrics.horizontalAdvance(arrow.words or "?")
                x = max(2.0, min(corners[0].x() - wide - 6.0, self.width() - wide - 2.0))
                area = QRectF(x, corners[0].y() - 4.0 - metrics.ascent(), wide, metrics.height())
                if not any(area.intersects(other) for other in taken):  # of loads close together the first
                    painter.drawText(QPointF(x, corners[0].y() - 4.0), arrow.words or "?")
                    taken.append(area)

    def _draw_bars(self, painter, place) -> None:
        """The bars that hold a wall as it rocks: taut, slack (dashed), yielding (red, thick); none where one broke."""
        height, thickness, setback = require_value(self.size_of)
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
        """zeta at each hinge, that of the one that decides bold and in the colour of its outcome."""
        font, (place_of, tone) = QFont(self.font()), self.decides or (math.nan, "")
        for level, zeta in self.hinges:
            if zeta is not None:
                decides = level == place_of
                painter.setPen(QColor(getattr(theme.current, tone or "ink") if decides else theme.current.ink))
                font.setBold(decides)
                painter.setFont(font)
                words = f"ζ {number(zeta, '.2f')}"
                at = place(QPointF(self.body.ends[0], level))
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
    """A picture of a mechanism: rocking on both sides, on one side, both studied, held at the top."""
    picture = QPixmap(size, size)
    picture.fill(Qt.GlobalColor.transparent)
    painter = QPainter(picture)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    ink = QColor(theme.current.ink)
    painter.setPen(QPen(ink, 1.2))
    painter.drawLine(4, size - 6, size - 4, size - 6)
    kind = kinematics(name)
    if kind.bends:
        shade = QColor(theme.current.curves[0])
        shade.setAlpha(110)
        painter.setBrush(shade)
    if kind.arches:  # in plan
        for block in outlines(Strip(36.0, 9.0, 0.0, 1.0, ((1.0, 0.0),), lies=True), 18.0, 0.22):
            painter.drawPolygon(QPolygonF([QPointF(size / 2 - 18.0 + z, size - 14 - x) for x, z in block]))
        for x in (size / 2 - 18.0, size / 2 + 18.0):
            painter.drawLine(QPointF(x, size - 14), QPointF(x, 8))
        painter.end()
        return QIcon(picture)
    if kind.bends_up:
        strip, between = Strip(40.0, 9.0, 0.0, 1.0, ((1.0, 4.5),)), 80.0 / 3.0  # where its multiplier is least
        for block in outlines(strip, between, 0.22):
            painter.drawPolygon(QPolygonF([QPointF(size / 2 + 2.0 - x, size - 6 - z) for x, z in block]))
        painter.drawLine(QPointF(size / 2 + 5, 4), QPointF(size / 2 + 5, 12))
        painter.end()
        return QIcon(picture)
    turns = (-0.22, 0.22) if kind.both_ways else (-0.22, 0.25) if kind.rocks_both_ways else (0.25,)
    if kind.turns_one_way:
        painter.fillRect(QRectF(size / 2 - 15, 10, 7, size - 16), QColor(theme.current.quiet))
    for rotation in turns:
        shade = QColor(theme.current.curves[0 if rotation > 0 else 1])
        shade.setAlpha(110)
        painter.setBrush(shade)
        pen = QPen(ink, 1.2)
        if kind.turns_one_way and rotation < 0.0:
            pen.setStyle(Qt.PenStyle.DashLine)
        painter.setPen(pen)
        corners = outline(34.0, 12.0, 0.0, rotation)
        polygon = QPolygonF([QPointF(size / 2 + p.x(), size - 6 - p.y()) for p in corners])
        painter.drawPolygon(polygon)
    painter.end()
    return QIcon(picture)
