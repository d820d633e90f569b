"""What leaves a chart: pictures always light, figures for a report, its data."""

import csv
import io
import math
from pathlib import Path
from typing import Any

import numpy as np
from PySide6.QtCore import QPoint
from PySide6.QtGui import QGuiApplication, QImage, QPainter
from PySide6.QtWidgets import QMessageBox, QWidget

from app.look import theme
from app.look.charting import pg
from app.look.file_dialogs import path_to_write
from app.look.labels import escape_html
from app.look.language import current_language, describe_message, tr
from app.views.table import Table
from core import atomic_write
from core.errors import OutputError
from core.report.plain_cell import plain_cell
from core.text.catalogue import CATALOGUE


def written(value: float, comma: bool) -> str:
    """A number as a spreadsheet of the language reads it; nothing where there is none."""
    if not math.isfinite(value):
        return ""
    return repr(value).replace(".", ",") if comma else repr(value)


class ChartOutput(QWidget):
    """The part of a Chart that writes: pictures, figures, data.

    live : what it shows is of the input as it stands, not of the last result
    caption : of what is shown, for a figure that leaves the program
    column : of its data what stands in the place of y, "" where that is what its axis says
    """

    view: pg.PlotWidget
    items: list[tuple[Any, Any, float, bool, bool]]
    """(item, colour, width, dashed, filled)"""
    data: list[tuple[str, np.ndarray, np.ndarray]]
    names: list[str]
    labels: tuple[str, str]
    name: str

    live = False
    caption = column = ""

    @property
    def is_stale(self) -> bool:
        """Whether what it shows is of an earlier input."""
        return Table.stale and not self.live

    def _apply_theme(self, chosen: theme.Theme, scale: float = 1.0) -> None:
        """scale : pixels of the device to one of the layout; the width of a pen is in those of the device"""
        raise NotImplementedError

    def image(self) -> QImage:
        """The chart as a light picture, twice the size on the screen; of stale results it says so."""
        from app.views.figure_file import picture, stale_line

        return picture(self, self.view.size(), stale_line(self), 2.0)

    def paint_light(self, painter: QPainter) -> None:
        """The view as on the screen, in the light theme, without the pixel caches of the screen. Painted as a widget:
        the marks are placed in pixels of the screen, and a scene painted to another size would leave them there."""
        marks = [item.scatter for item, *_ in self.items if isinstance(item, pg.PlotDataItem)]
        mode = self.view.cacheMode()
        self._apply_theme(theme.LIGHT, painter.device().devicePixelRatioF())
        self.view.setCacheMode(type(mode)(0))
        for mark in marks:
            mark.opts["useCache"] = False
        try:
            QWidget.render(self.view, painter, QPoint())
        finally:
            for mark in marks:
                mark.opts["useCache"] = True
            self.view.setCacheMode(mode)
            self._apply_theme(theme.current)

    def content(self, end: str) -> bytes:
        """The file .png, .svg, .pdf or .csv."""
        from app.views.figure_file import FigureSize, figure

        if end != ".csv":
            return figure(self, end, FigureSize())
        text = io.StringIO(newline="")
        comma = CATALOGUE.comma(current_language())
        writer = csv.writer(text, delimiter=";" if comma else ",")
        if self.is_stale:
            writer.writerow([tr("The input has changed since these results.")])
        writer.writerow(self.columns)
        for name, xs, ys in self.data:
            label = plain_cell(name)
            for x, y in zip(xs.tolist(), ys.tolist(), strict=True):
                place = plain_cell(self.names[int(x)]) if self.names else written(x, comma)
                writer.writerow((label, place, written(y, comma)))
        # a spreadsheet of Italy takes bytes without a mark for those of Windows
        return text.getvalue().encode("utf-8-sig" if comma else "utf-8")

    @property
    def columns(self) -> list[str]:
        """Heads of the columns of its data."""
        return [tr("curve"), self.labels[0], self.column or self.labels[1]]

    def write(self, path: Path) -> None:
        """Write a file of `content` by the end of its name, whole or not at all. Raises OutputError."""
        atomic_write.write({path: self.content(path.suffix.lower())})

    def copy(self) -> None:
        """The picture to the clipboard. Not by a QMimeData of ours: it crashes Qt when the program ends."""
        QGuiApplication.clipboard().setImage(self.image())

    def _save_figure(self) -> None:
        from app.views.figure_dialogs import last_size
        from app.views.figure_file import figure

        title = tr("Save the chart")
        kinds = "PNG (*.png);;SVG (*.svg);;PDF (*.pdf)"
        path = path_to_write(self, title, f"{self.name}.png", kinds, (".png", ".svg", ".pdf"))
        if path is not None:
            self._written(title, lambda: {path: figure(self, path.suffix.lower(), last_size())})

    def _save_data(self) -> None:
        title = tr("Save the chart")
        path = path_to_write(self, title, f"{self.name}.csv", "*.csv", (".csv",))
        if path is not None:
            self._written(title, lambda: {path: self.content(".csv")})

    def _written(self, title: str, files) -> None:
        try:
            atomic_write.write(files())
        except OutputError as error:
            QMessageBox.warning(self, title, escape_html(describe_message(error)))
