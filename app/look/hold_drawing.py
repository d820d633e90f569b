"""What holds a wall, drawn where it is: dashed while nothing says how much it stands outward."""

from collections.abc import Callable
from typing import Any, NamedTuple

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen

from app.look import theme
from app.look.language import number
from core.case.hold import Hold
from core.case.wall import Wall
from core.errors import InputError

REACH, DEPTH, STRIP = 26.0, 7.0, 8.0
"""Length and depth of a floor, and breadth of what stands behind a wall over a height [px]."""

PLATE = 0.02
"""Half of the plate of an anchor [of the height of the wall]."""


class HoldMark(NamedTuple):
    """A hold as it is drawn.

    hold : its place among those of the wall, None where nothing is said to stand behind it
    low, high : heights [m], the same of a floor; words : what it stands, "" of contact
    bar : a tie, which goes through the wall
    """

    hold: int | None
    low: float
    high: float
    words: str = ""
    bar: bool = False

    def area(self, place: Callable[[QPointF], QPointF], face: float) -> QRectF:
        """Where it is drawn [px]. face : x of the inner face of the wall [m]"""
        low, high = place(QPointF(face, self.low)), place(QPointF(face, self.high))
        if self.low == self.high:
            return QRectF(low.x() - REACH, low.y() - 0.5 * DEPTH, REACH, DEPTH)
        return QRectF(low.x() - 3.0 - STRIP, high.y(), STRIP, low.y() - high.y())


def find_hold_marks(wall: Wall, height: float) -> list[HoldMark]:
    """The ties of a wall, and what a wall leans on; what is still to be given is its top, or its base."""
    marks, leans = [], wall.leans or wall.bends
    for k, hold in enumerate(wall.hold):
        if not leans and not hold.is_bar:
            continue
        strength = find_strength(wall, hold)
        words = "" if strength is None else f"{number(strength, '.3g')} kN/m"
        if hold.has_height:
            at = _given(hold.h_m, height)
            marks.append(HoldMark(k, at, at, words, hold.is_bar))
        else:
            marks.append(HoldMark(k, _given(hold.from_m, 0.0), min(height, _given(hold.to_m, height)), words))
    behind = any(hold.is_contact for hold in wall.hold)
    return marks if behind or not wall.leans else [*marks, HoldMark(None, 0.0, height)]


def find_strength(wall: Wall, hold: Hold) -> float | None:
    """What a hold stands outward [kN/m]; None where it is not given, or is contact."""
    if hold.bar is None:
        return _given(hold.out_kn_m)
    try:
        return 1e-3 * hold.tie(wall.length_m).bar.strength
    except (InputError, TypeError):  # of a bar that is still to be given
        return None


def _given(value: Any, otherwise: Any = None) -> Any:
    """A number as it is; of what is still to be given another one."""
    return value if isinstance(value, float | int) else otherwise


def paint_holds(
    painter: QPainter, marks: list[HoldMark], place: Callable[[QPointF], QPointF], height: float, thickness: float
) -> None:
    """Floors behind the wall with the plates of their anchors before it, and what stands behind it over a height."""
    ink, quiet, half = QColor(theme.current.ink), QColor(theme.current.quiet), 0.5 * thickness
    for mark in marks:
        area = mark.area(place, -half)
        painter.setPen(
            QPen(ink if mark.words else quiet, 1.0, Qt.PenStyle.SolidLine if mark.words else Qt.PenStyle.DashLine)
        )
        painter.setBrush(QColor(theme.current.grid) if mark.hold is not None else Qt.BrushStyle.NoBrush)
        if mark.bar:
            middle = area.center().y()
            painter.drawLine(QPointF(area.left(), middle), QPointF(area.right(), middle))
        else:
            painter.drawRect(area)
        if mark.words and mark.low == mark.high:
            painter.drawLine(place(QPointF(-half, mark.low)), place(QPointF(half, mark.low)))
            painter.setPen(QPen(ink, 3.0))
            ends = (QPointF(half, mark.low + way * PLATE * height) for way in (-1.0, 1.0))
            painter.drawLine(*map(place, ends))
    painter.setBrush(Qt.BrushStyle.NoBrush)


def write_strengths(
    painter: QPainter, marks: list[HoldMark], place: Callable[[QPointF], QPointF], thickness: float
) -> None:
    """What each hold stands outward, below it."""
    painter.setPen(QColor(theme.current.ink))
    metrics = painter.fontMetrics()
    for mark in marks:
        area = mark.area(place, -0.5 * thickness)
        x = max(2.0, area.right() - metrics.horizontalAdvance(mark.words) - 2.0)
        painter.drawText(QPointF(x, area.bottom() + metrics.ascent()), mark.words)
