"""A chart as a figure for a report: as wide as asked, light, with a caption below it."""

import re
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from PySide6.QtCore import QBuffer, QIODevice, QMarginsF, QPoint, QRect, QSize, QSizeF, Qt
from PySide6.QtGui import QColor, QFont, QImage, QImageWriter, QPageLayout, QPageSize, QPainter, QPdfWriter
from PySide6.QtSvg import QSvgGenerator
from shiboken6 import isValid

from app.look import theme
from app.look.charting import pg
from app.look.language import tr
from app.views.axis_names import fit_all_names, unnamed_line
from app.views.page_units import convert_to_page_units
from core.errors import OutputError
from core.report.xml_text import escape_for_xml

MM_PER_INCH = 25.4
SCREEN, NARROW = 96, 120.0
"""Pixels an inch of the layout: text and lines keep the size they have on the screen; in figures below that width [mm]
they shrink with it."""

AXES_ASPECT = 0.62
"""Height of the axes over the width."""

CAPTION_LINE_HEIGHT = 15
"""Height of a line of the caption [px of the layout]."""

STRIP_CURVE_LENGTH, MIN_STRIP_HEIGHT = 2000.0, 4
"""Length of the curves in a strip of a figure painted at once, and least height of a strip [px of the layout]: at
300 dpi 1000 px of a curve take some 5 ms, a strip without a curve 4 ms."""


@dataclass(frozen=True)
class FigureSize:
    """width [mm]; dpi of a PNG; caption : whether it stands below"""

    width: float = 160.0
    dpi: int = 300
    caption: bool = True


def figure(chart, end: str, size: FigureSize) -> bytes:
    """The file .png, .svg or .pdf of a chart. Raises OutputError."""
    if end == ".png":
        *_, image = raster(chart, size)
        return png(image)
    with _laid_out(chart, size) as (whole, lines, density):
        page = _page(whole, lines)
        room = QBuffer()
        room.open(QIODevice.OpenModeFlag.WriteOnly)
        if end == ".svg":
            drawing = QSvgGenerator(QSvgGenerator.SvgVersion.Svg11)
            drawing.setOutputDevice(room)
            drawing.setSize(page)
            drawing.setViewBox(QRect(0, 0, page.width(), page.height()))
            drawing.setResolution(SCREEN)  # that of the layout: letters of so many points keep their room
            _paint(chart, drawing, whole, lines)
            # Qt writes whatever a text holds
            text = _of_width(escape_for_xml(bytes(room.data().data())).decode(), page, density)
            return convert_to_page_units(text).encode()
        _paint(chart, _pdf(room, page, density), whole, lines)
        return bytes(room.data().data())


def raster(chart, size: FigureSize) -> Iterator[QImage]:
    """The figure in pixels, for `png`: strip by strip, whole with the last one; events may pass between them."""
    with _laid_out(chart, size) as (whole, lines, density):
        image = _blank(_page(whole, lines), size.dpi / density)
        image.setDotsPerMeterX(round(size.dpi / MM_PER_INCH * 1000.0))
        image.setDotsPerMeterY(round(size.dpi / MM_PER_INCH * 1000.0))
        yield image
        for strip in _strips(chart, _page(whole, lines)):
            image.setDevicePixelRatio(size.dpi / density)
            _paint(chart, image, whole, lines, strip)
            image.setDevicePixelRatio(1.0)
            yield image


def _strips(chart, page: QSize) -> list[QRect]:
    """A page from above to below: in none are curves longer than STRIP_CURVE_LENGTH: they take the time."""
    rows, above = np.arange(0, page.height(), MIN_STRIP_HEIGHT), 0.0
    box = chart.plot.vb
    (across, up), low, bottom = box.viewPixelSize(), box.viewRange()[1][0], box.sceneBoundingRect().bottom()
    for item, _, _, dash, _ in chart.items:
        x, y = item.curve.getData() if isinstance(item, pg.PlotDataItem) and item.curve.isVisible() else (None, None)
        if x is None or y is None:
            continue
        if dash:  # its dashes would not meet those of the next strip
            return [QRect(QPoint(), page)]
        lengths = np.hypot(np.diff(x) / across, np.diff(y) / up)
        at = bottom - (y - low) / up
        first, last = np.minimum(at[1:], at[:-1]), np.maximum(at[1:], at[:-1])
        shares = np.clip((rows[:, None] - first) / np.maximum(last - first, 1.0), 0.0, 1.0)
        above = above + np.nansum(shares * lengths, axis=1)
    cuts = rows[np.flatnonzero(np.diff(above // STRIP_CURVE_LENGTH)) + 1] if np.ndim(above) else ()
    edges = [0, *(int(row) for row in cuts), page.height()]
    return [QRect(0, top, page.width(), end - top) for top, end in pairwise(edges)]


def png(image: QImage) -> bytes:
    """Its file, in any thread. Raises OutputError."""
    room = QBuffer()
    room.open(QIODevice.OpenModeFlag.WriteOnly)
    if not QImageWriter(room, b"PNG").write(image):
        raise OutputError("picture_not_made")
    return bytes(room.data().data())


@contextmanager
def _laid_out(chart, size: FigureSize) -> Iterator[tuple[QSize, list[str], float]]:
    """The chart in the size of a figure, and back: size of its view, lines below it, pixels an inch of the layout."""
    density = SCREEN * max(1.0, NARROW / size.width)
    wide = round(size.width / MM_PER_INCH * density)
    whole, lines = fit_all_names(chart, QSize(wide, round(AXES_ASPECT * wide))), []
    if size.caption:
        lines = [f"{chart.name}. {chart.caption}" if chart.caption else chart.name]
    lines += [*unnamed_line(chart, whole), *stale_line(chart)]
    old, around, ranges, box = chart.view.size(), chart.size(), chart.plot.viewRange(), chart.plot.vb
    left, bottom = (chart.plot.getAxis(side) for side in ("left", "bottom"))
    fixed = left.fixedWidth, bottom.fixedHeight
    box.blockLink(True)  # a linked chart of another width would move the axis
    chart.layout().setEnabled(False)  # behind another tab, painting would give the view its old size
    chart.is_figure = True
    try:
        chart.view.resize(whole)
        chart.fit()
        chart.plot.layout.activate()
        box.setRange(xRange=ranges[0], yRange=ranges[1], padding=0)
        left.setWidth(left.width())  # painted, they want the room of their numbers: the next strip would be moved
        bottom.setHeight(bottom.height())
        yield whole, lines, density
    finally:
        if isValid(chart):  # its page may go between two strips
            chart.is_figure = False
            bottom.stand_upright(0)
            left.setWidth(fixed[0])
            bottom.setHeight(fixed[1])
            chart.view.resize(old)
            chart.fit()
            box.setRange(xRange=ranges[0], yRange=ranges[1], padding=0)
            box.blockLink(False)
            chart.layout().setEnabled(True)
            if chart.size() != around:
                chart.layout().invalidate()


def _of_width(drawing: str, page: QSize, density: float) -> str:
    """An SVG of the size of its page on paper. density : pixels an inch"""
    wide, high = (f'"{MM_PER_INCH * side / density:g}mm"' for side in (page.width(), page.height()))
    return re.sub(r'width="[^"]*mm" height="[^"]*mm"', f"width={wide} height={high}", drawing, count=1)


def stale_line(chart) -> list[str]:
    """What stands below a chart of an earlier input."""
    return [tr("The input has changed since these results.")] if chart.is_stale else []


def _page(whole: QSize, lines: list[str]) -> QSize:
    """Size of a view with these lines below it [px of the layout]."""
    return QSize(whole.width(), whole.height() + 2 * CAPTION_LINE_HEIGHT * len(lines))


def picture(chart, whole: QSize, lines: list[str], ratio: float) -> QImage:
    """A chart with lines of text below it. whole : size of its view; ratio : pixels to one of the layout"""
    image = _blank(_page(whole, lines), ratio)
    _paint(chart, image, whole, lines)
    image.setDevicePixelRatio(1.0)
    return image


def _blank(page: QSize, ratio: float) -> QImage:
    image = QImage(round(page.width() * ratio), round(page.height() * ratio), QImage.Format.Format_RGB32)
    image.setDevicePixelRatio(ratio)
    image.fill(Qt.GlobalColor.white)
    return image


def _pdf(room: QBuffer, page: QSize, density: float) -> QPdfWriter:
    """One page of the size of the figure."""
    writer = QPdfWriter(room)
    points = QSizeF(page.width() * 72.0 / density, page.height() * 72.0 / density)
    writer.setPageLayout(
        QPageLayout(QPageSize(points, QPageSize.Unit.Point), QPageLayout.Orientation.Portrait, QMarginsF())
    )
    writer.setResolution(round(density))
    return writer


def _paint(chart, device, whole: QSize, lines: list[str], part: QRect | None = None) -> None:
    """The chart, its caption below; one painter, for a file takes no second one. part : of the page, else all of it"""
    painter = QPainter(device)
    if part is not None:
        painter.setClipRect(part)
    chart.paint_light(painter)
    painter.setPen(QColor(theme.LIGHT.ink))
    font = QFont(chart.font())
    font.setPixelSize(12)
    painter.setFont(font)
    place = QRect(6, whole.height(), whole.width() - 12, 2 * CAPTION_LINE_HEIGHT)
    for k, line in enumerate(lines):
        if line in stale_line(chart):
            painter.setPen(QColor(theme.LIGHT.bad))
        painter.drawText(place.translated(0, 2 * CAPTION_LINE_HEIGHT * k), Qt.TextFlag.TextWordWrap, line)
    painter.end()
