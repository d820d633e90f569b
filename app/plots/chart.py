"""One chart: curves with names and units, values under the cursor, copy, PNG, SVG, CSV (always light)."""

import csv
import io
import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QBuffer, QIODevice, QRect, Qt
from PySide6.QtGui import QGuiApplication, QImage
from PySide6.QtSvg import QSvgGenerator
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLabel,
    QMessageBox,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app import theme
from app.files import path_to_write
from app.language import current_language, described, tr
from app.plots.table import plain_cell
from core import atomic_write
from core.errors import OutputError


def numbers(values) -> np.ndarray:
    """A contiguous float64 array of one dimension: anything else can crash the drawing."""
    return np.ascontiguousarray(np.asarray(values, dtype=np.float64).ravel())


def written(value: float, comma: bool) -> str:
    """A number as a spreadsheet of the language reads it; nothing where there is none."""
    if not math.isfinite(value):
        return ""
    return repr(value).replace(".", ",") if comma else repr(value)


class Chart(QWidget):
    """A plot with axes `x` and `y`. Colours are roles of the theme: an index of its curves, or a name.
    legend : the corner it stands in, of top or bottom and left or right, or beside for many curves."""

    def __init__(self, x: str, y: str, name: str, legend: str = "top right"):
        super().__init__()
        self.labels, self.name = (x, y), name
        self.setAccessibleName(name)
        self.view = pg.PlotWidget()
        self.plot = self.view.getPlotItem()
        self.plot.showGrid(x=True, y=True, alpha=0.25)
        self.beside = legend == "beside"
        corner = (8 if "left" in legend else -8, -8 if "bottom" in legend else 8)
        self.legend = self.plot.addLegend(offset=corner, labelTextSize="9pt")
        if self.beside:
            self.legend.setParentItem(self.plot)
            self.legend.anchor((1, 0), (1, 0), (0, 8))
        self.items: list[tuple] = []
        self.recolors: list[Callable[[theme.Theme], None]] = []
        self.names: list[str] = []
        self.data: list[tuple[str, np.ndarray, np.ndarray]] = []
        self.read = QLabel()
        self.read.setMinimumWidth(10)
        self.read.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(self.view, 1)
        layout.addLayout(self._bar())
        self._proxy = pg.SignalProxy(
            self.plot.scene().sigMouseMoved, rateLimit=30, slot=self._moved
        )
        self._apply_theme(theme.current)

    def _bar(self) -> QHBoxLayout:
        bar = QHBoxLayout()
        bar.addWidget(self.read, 1)
        for label, tip, slot in (
            (tr("Reset"), tr("Show everything"), self.reset), (tr("Copy"), tr("Copy the picture"), self.copy),
            ("PNG", tr("Save as PNG"), lambda: self._save("png")),
            ("SVG", tr("Save as SVG"), lambda: self._save("svg")),
            ("CSV", tr("Save the data as CSV"), lambda: self._save("csv")),
        ):  # fmt: skip
            button = QToolButton()
            button.setText(label)
            button.setToolTip(tip)
            button.setAccessibleName(f"{label}, {self.name}")
            button.setAutoRaise(True)
            button.clicked.connect(slot)
            bar.addWidget(button)
        return bar

    # content

    def clear(self) -> None:
        for item, *_ in self.items:
            self.plot.removeItem(item)
        self.legend.clear()
        self.items, self.data, self.recolors, self.names = [], [], [], []

    def curve(self, name, x, y, color=0, width=1.6, dash=False, legend=True, path=False):
        """A line; its data goes into the CSV. path : x may go back and forth."""
        x, y = numbers(x), numbers(y)
        item = pg.PlotDataItem(x, y, name=name if legend else None)
        self.plot.addItem(item)
        if not path and not self.plot.ctrl.logXCheck.isChecked():
            item.setClipToView(True)
            item.setDownsampling(auto=True, method="peak")
        self._keep(item, color, width, dash, False)
        self.data.append((name, x, y))
        return item

    def points(
        self, name: str, x, y, color=0, size=8, legend=True, symbol="o", values=None
    ) -> pg.PlotDataItem:
        """Marks without a line. values : what the CSV holds in the place of y, no number where there is none."""
        x, y = numbers(x), numbers(y)
        item = pg.PlotDataItem(
            x, y, pen=None, symbol=symbol, symbolSize=size, name=name if legend else None
        )
        self.plot.addItem(item)
        self._keep(item, color, 1.0, False, True)
        self.data.append((name, x, y if values is None else numbers(values)))
        return item

    def bars(self, name: str, x, heights, color=0, width=0.7, values=None) -> None:
        """Bars; values : as of `points`."""
        item = pg.BarGraphItem(x=numbers(x), height=numbers(heights), width=width)
        self.plot.addItem(item)
        self._keep(item, color, 1.0, False, True)
        self.data.append((name, numbers(x), numbers(heights if values is None else values)))

    def level(self, value: float, label: str = "", color="quiet", vertical=False, place=None):
        """A line across the chart with a label; place : of the label along it, 0 to 1."""
        options = {"position": place or (0.92 if vertical else 0.01), "fill": None}
        if (
            not vertical and place is None
        ):  # it begins right of the axis, however narrow the chart is
            options["anchors"] = [(0, 0), (0, 1)]
        line = pg.InfiniteLine(
            value,
            90 if vertical else 0,
            label=label or None,
            labelOpts=options,
        )
        self.plot.addItem(line, ignoreBounds=True)
        self._keep(line, color, 1.2, True, False)
        return line

    def band(self, x, low, high, color=1) -> None:
        """The area between two curves."""
        shade = pg.mkColor(self._shade(theme.current, color))
        shade.setAlpha(45)
        ends = [pg.PlotDataItem(numbers(x), numbers(edge)) for edge in (low, high)]
        for end in ends:
            self.plot.addItem(end)
            self._keep(end, color, 0.6, True, False)
        area = pg.FillBetweenItem(*ends, brush=shade)
        self.plot.addItem(area)
        self.items.append((area, None, 0, False, False))

    def add(self, item, recolor: Callable[[theme.Theme], None] = lambda chosen: None) -> None:
        """Any other item. recolor(theme) : gives it its colours."""
        self.plot.addItem(item)
        self.recolors.append(recolor)
        recolor(theme.current)
        self.items.append((item, None, 0, False, False))

    def ticks(self, side: str, places: list[tuple[float, str]]) -> None:
        """Labels of an axis at these places."""
        self.plot.getAxis(side).setTicks([places])

    def names_below(self, names: list[str]) -> None:
        """Names below the places 0, 1, 2 … of the axis, as many of them as its width holds."""
        self.names = names
        widest = max((self.fontMetrics().horizontalAdvance(name) for name in names), default=0)
        room = 0.85 * self.view.width() / (widest + 12)
        step = max(1, math.ceil(len(names) / max(1.0, room)))
        self.ticks("bottom", [(k, names[k]) for k in range(0, len(names), step)])

    def resizeEvent(self, event) -> None:
        super().resizeEvent(event)
        if self.names:
            self.names_below(self.names)

    def set_log(self, on: bool) -> None:
        self.plot.setLogMode(on, on)

    def reset(self) -> None:
        if self.beside:
            self.plot.layout.setColumnFixedWidth(3, self.legend.boundingRect().width())
        self.plot.autoRange()

    # colours

    @staticmethod
    def _shade(chosen: theme.Theme, color) -> str:
        return (
            chosen.curves[color % len(chosen.curves)]
            if isinstance(color, int)
            else getattr(chosen, color)
        )

    def _keep(self, item, color, width, dash, filled) -> None:
        self.items.append((item, color, width, dash, filled))
        self._paint(item, color, width, dash, filled, theme.current)

    def _paint(self, item, color, width, dash, filled, chosen) -> None:
        if color is None:
            return
        shade = self._shade(chosen, color)
        pen = pg.mkPen(
            shade, width=width, style=Qt.PenStyle.DashLine if dash else Qt.PenStyle.SolidLine
        )
        if isinstance(item, pg.BarGraphItem):
            item.setOpts(brush=shade, pen=shade)
        elif filled:
            item.setSymbolBrush(shade)
            item.setSymbolPen(shade)
        else:
            item.setPen(pen)
            if isinstance(item, pg.InfiniteLine) and hasattr(item, "label"):
                item.label.setColor(shade)

    def _apply_theme(self, chosen: theme.Theme) -> None:
        self.view.setBackground(chosen.back)
        for side, label in zip(("bottom", "left"), self.labels, strict=True):
            axis = self.plot.getAxis(side)
            # enableAutoSIPrefix(False) alone keeps the scale of the range of that moment: 0.1 g would read 100
            axis.setSIPrefixEnableRanges(())
            axis.enableAutoSIPrefix(False)
            axis.setPen(chosen.quiet)
            axis.setTextPen(chosen.ink)
            self.plot.setLabel(side, label, color=chosen.ink)
        self.legend.setLabelTextColor(chosen.ink)
        for _, label in self.legend.items:
            label.setText(label.text, color=chosen.ink)
        for entry in self.items:
            self._paint(*entry, chosen)
        for recolor in self.recolors:
            recolor(chosen)

    # values under the cursor

    def _moved(self, event) -> None:
        point = self.plot.vb.mapSceneToView(event[0])
        x, y = point.x(), point.y()
        if self.plot.ctrl.logXCheck.isChecked():
            x, y = 10.0**x, 10.0**y
        self.read.setText(f"  {self.labels[0]} {x:.4g}   {self.labels[1]} {y:.4g}")

    # out

    def image(self) -> QImage:
        """The chart as a light picture, twice the size on the screen. Painted as a widget: the marks are placed in
        pixels of the screen, and a scene painted to another size would leave them there."""
        image = QImage(2 * self.view.size(), QImage.Format.Format_RGB32)
        image.setDevicePixelRatio(2.0)
        image.fill(Qt.GlobalColor.white)
        self._paint_light(image)
        image.setDevicePixelRatio(1.0)
        return image

    def _paint_light(self, device) -> None:
        """The view as on the screen, in the light theme, without the pixel caches of the screen."""
        marks = [item.scatter for item, *_ in self.items if isinstance(item, pg.PlotDataItem)]
        mode = self.view.cacheMode()
        self._apply_theme(theme.LIGHT)
        self.view.setCacheMode(type(mode)(0))
        for mark in marks:
            mark.opts["useCache"] = False
        try:
            QWidget.render(self.view, device)
        finally:
            for mark in marks:
                mark.opts["useCache"] = True
            self.view.setCacheMode(mode)
            self._apply_theme(theme.current)

    def content(self, end: str) -> bytes:
        """The file .png, .svg or .csv."""
        if end == ".csv":
            text = io.StringIO(newline="")
            italian = current_language() == "it"
            writer = csv.writer(text, delimiter=";" if italian else ",")
            writer.writerow([tr("curve"), *self.labels])
            for name, xs, ys in self.data:
                label = plain_cell(name)
                for x, y in zip(xs.tolist(), ys.tolist(), strict=True):
                    place = plain_cell(self.names[int(x)]) if self.names else written(x, italian)
                    writer.writerow((label, place, written(y, italian)))
            # a spreadsheet of Italy takes bytes without a mark for those of Windows
            return text.getvalue().encode("utf-8-sig" if italian else "utf-8")
        room = QBuffer()
        room.open(QIODevice.OpenModeFlag.WriteOnly)
        if end == ".svg":
            picture = QSvgGenerator()
            picture.setOutputDevice(room)
            size = self.view.size()
            picture.setSize(size)
            picture.setViewBox(QRect(0, 0, size.width(), size.height()))
            picture.setResolution(self.view.logicalDpiX())
            self._paint_light(picture)
        elif not self.image().save(room, "PNG"):
            raise OutputError("picture_not_made")
        return bytes(room.data())

    def write(self, path: Path) -> None:
        """Write .png, .svg or .csv by the end of the name, whole or not at all. Raises OutputError."""
        atomic_write.write({path: self.content(path.suffix.lower())})

    def copy(self) -> None:
        """The picture to the clipboard. Not by a QMimeData of ours: it crashes Qt when the program ends."""
        QGuiApplication.clipboard().setImage(self.image())

    def _save(self, end: str) -> None:
        title = tr("Save the chart")
        path = path_to_write(self, title, f"{self.name}.{end}", f"*.{end}", f".{end}")
        if path is None:
            return
        try:
            self.write(path)
        except OutputError as error:
            QMessageBox.warning(self, title, described(error))
