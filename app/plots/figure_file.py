"""A chart as a figure for a report: as wide as asked, light, with a caption below it."""

from dataclasses import dataclass

from PySide6.QtCore import QBuffer, QIODevice, QMarginsF, QRect, QSize, QSizeF, Qt
from PySide6.QtGui import QColor, QFont, QImage, QPageLayout, QPageSize, QPainter, QPdfWriter
from PySide6.QtSvg import QSvgGenerator

from app import theme
from app.language import tr
from core.errors import OutputError

MM_PER_INCH = 25.4
SCREEN = 96
"""Pixels an inch of the layout: text and lines keep the size they have on the screen."""

SHAPE = 0.62
"""Height of the axes over the width."""

LINE = 15
"""Height of a line of the caption [px of the layout]."""


@dataclass(frozen=True)
class FigureSize:
    """width [mm]; dpi of a PNG; caption : whether it stands below"""

    width: float = 160.0
    dpi: int = 300
    caption: bool = True


def figure(chart, end: str, size: FigureSize) -> bytes:
    """The file .png, .svg or .pdf of a chart. Raises OutputError."""
    wide = round(size.width / MM_PER_INCH * SCREEN)
    whole, lines = QSize(wide, round(SHAPE * wide)), []
    if size.caption:
        lines = [f"{chart.name}. {chart.caption}" if chart.caption else chart.name]
    if chart.is_stale:
        lines.append(tr("The input has changed since these results."))
    page = QSize(wide, whole.height() + (LINE * 2 * len(lines) if lines else 0))
    room = QBuffer()
    room.open(QIODevice.OpenModeFlag.WriteOnly)
    old = chart.view.size()
    chart.view.setUpdatesEnabled(False)
    try:
        chart.view.resize(whole)
        chart.fit()
        chart.plot.layout.activate()
        if end == ".png":
            image = _image(chart, page, whole, lines, size.dpi)
            if not image.save(room, "PNG"):
                raise OutputError("picture_not_made")
        elif end == ".svg":
            picture = QSvgGenerator()
            picture.setOutputDevice(room)
            picture.setSize(page)
            picture.setViewBox(QRect(0, 0, page.width(), page.height()))
            picture.setResolution(SCREEN)
            _paint(chart, picture, whole, lines)
        else:
            _paint(chart, _pdf(room, page), whole, lines)
    finally:
        chart.view.resize(old)
        chart.fit()
        chart.view.setUpdatesEnabled(True)
    return bytes(room.data())


def _image(chart, page: QSize, whole: QSize, lines: list[str], dpi: int) -> QImage:
    ratio = dpi / SCREEN
    pixels = QSize(round(page.width() * ratio), round(page.height() * ratio))
    image = QImage(pixels, QImage.Format.Format_RGB32)
    image.setDevicePixelRatio(ratio)
    image.fill(Qt.GlobalColor.white)
    _paint(chart, image, whole, lines)
    image.setDevicePixelRatio(1.0)
    image.setDotsPerMeterX(round(dpi / MM_PER_INCH * 1000.0))
    image.setDotsPerMeterY(round(dpi / MM_PER_INCH * 1000.0))
    return image


def _pdf(room: QBuffer, page: QSize) -> QPdfWriter:
    """One page of the size of the figure."""
    writer = QPdfWriter(room)
    points = QSizeF(page.width() * 72.0 / SCREEN, page.height() * 72.0 / SCREEN)
    writer.setPageLayout(
        QPageLayout(
            QPageSize(points, QPageSize.Unit.Point), QPageLayout.Orientation.Portrait, QMarginsF()
        )
    )
    writer.setResolution(SCREEN)
    return writer


def _paint(chart, device, whole: QSize, lines: list[str]) -> None:
    """The chart, its caption below; one painter, for a file takes no second one."""
    painter = QPainter(device)
    chart.paint_light(painter)
    painter.setPen(QColor(theme.LIGHT.ink))
    font = QFont(chart.font())
    font.setPixelSize(12)
    painter.setFont(font)
    place = QRect(6, whole.height(), whole.width() - 12, 2 * LINE)
    for k, line in enumerate(lines):
        if k and chart.is_stale:
            painter.setPen(QColor(theme.LIGHT.bad))
        painter.drawText(place.translated(0, 2 * LINE * k), Qt.TextFlag.TextWordWrap, line)
    painter.end()
