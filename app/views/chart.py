"""One chart: curves with names and units, values under the cursor, copy, PNG, SVG, PDF, CSV (always light)."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QMenu, QSizePolicy, QToolButton, QVBoxLayout

from app.look import theme
from app.look.charting import pg
from app.look.dialogs import delete_after_use
from app.look.labels import PlainLabel
from app.look.language import current_language, tr
from app.views.axis import LEGEND_LETTERS, SPARE_PLOTS, elide_name, ends_of, number_axes, numbers, plot_widget
from app.views.axis_names import show_names
from app.views.chart_output import ChartOutput
from app.views.edge_marks import EdgeMarks
from core.report.note.parts import Figure
from core.text.sentence import format_number

MAX_POINT_DISTANCE = 0.04
"""How close the cursor must be to a data point to be read there, over the size of the axes."""


AXIS_PADDING = 0.06
"""Beside the data that `Chart.reset` shows, of the length of an axis."""


class Chart(ChartOutput):
    """A plot with axes `x` and `y`. Colours are roles of the theme: an index of its curves, or a name.

    legend : above the axes or, for many curves, beside them: never on the data
    live : as of ChartOutput
    clicked(x, y) : a place of the axes was clicked
    """

    clicked = Signal(float, float)

    def __init__(self, x: str, y: str, name: str, legend: str = "above", live: bool = False):
        super().__init__()
        self.labels, self.name = (x, y), name
        self.setAccessibleName(name)
        self.view = SPARE_PLOTS.pop() if SPARE_PLOTS else plot_widget()
        self.view.setFocusPolicy(Qt.FocusPolicy.NoFocus)  # the keys reach the chart by its menu
        self.plot = self.view.getPlotItem()
        self.plot.showGrid(x=True, y=True, alpha=0.25)
        self.beside, self.live = legend == "beside", live
        self.legend = self.plot.addLegend(labelTextSize=theme.font_points(1.0).split()[1].rstrip(";"))
        self.legend.setParentItem(self.plot)
        self.legend.anchor((1, 0), (1, 0), (0, 8 if self.beside else 0))
        self.ranges: dict[str, tuple[float, float]] = {}
        self.plot.hideButtons()
        self.view.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.view.customContextMenuRequested.connect(self._menu)
        self.found = pg.ScatterPlotItem(size=9, pen=pg.mkPen(None))
        self.found.setZValue(50)
        self.plot.addItem(self.found, ignoreBounds=True)
        self.reason = PlainLabel(parent=self.view)
        self.reason.setWordWrap(True)
        self.reason.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.reason.hide()
        self.items: list[tuple[Any, Any, float, bool, bool]] = []
        self.recolors: list[Callable[[theme.Theme, float], None]] = []
        self.entries: list[str] = []
        self.extents: list[tuple] = []
        self.names: list[str] = []
        self.lines: list[tuple[float, str]] = []
        self.is_figure = False
        self.edges = EdgeMarks(self)
        self.data: list[tuple[str, np.ndarray, np.ndarray]] = []
        self.read = PlainLabel()
        self.read.setMinimumWidth(10)
        self.read.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(self.view, 1)
        layout.addLayout(self._bar())
        self._proxy = pg.SignalProxy(self.plot.scene().sigMouseMoved, rateLimit=30, slot=self._moved)
        self.plot.scene().sigMouseClicked.connect(self._pressed)
        self._apply_theme(theme.current)

    def _bar(self) -> QHBoxLayout:
        bar = QHBoxLayout()
        bar.addWidget(self.read, 1)
        button = QToolButton()
        button.setText("⋯")
        button.setToolTip(tr("What can be done with this chart"))
        button.setAccessibleName(f"{tr('Chart')}, {self.name}")
        button.setAutoRaise(True)
        button.clicked.connect(lambda: self._open_menu(button.mapToGlobal(button.rect().bottomLeft())))
        bar.addWidget(button)
        return bar

    # content

    def clear(self) -> None:
        for item, *_ in self.items:
            self.plot.removeItem(item)
        self.legend.clear()
        self.found.clear()
        self.items, self.data, self.recolors, self.names, self.ranges = [], [], [], [], {}
        self.lines, self.entries, self.extents = [], [], []
        self.edges.clear()
        self.plot.getAxis("bottom").stand_upright(0)
        self.reason.hide()
        number_axes(self.plot, True)

    def say_why(self, reason: str) -> None:
        """Words in the place of an empty chart."""
        self.reason.setText(reason)
        self.reason.setStyleSheet(f"color: {theme.current.quiet};")
        self.reason.setVisible(bool(reason))
        number_axes(self.plot, not reason)
        self._place_legend()

    def curve(self, name, x, y, color=0, width=1.6, dash=False, legend=True, path=False):
        """A line; its data goes into the CSV. path : x may go back and forth."""
        x, y = numbers(x), numbers(y)
        item = pg.PlotDataItem(x, y, name=self._entry(name) if legend else None)
        self.plot.addItem(item)
        self.extents.append((x, y))
        if not path and not self.plot.ctrl.logXCheck.isChecked():
            item.setClipToView(True)
            item.setDownsampling(auto=True, method="peak")
        self._keep(item, color, width, dash, False)
        self.data.append((name, x, y))
        return item

    def show_figure(self, figure: Figure) -> None:
        """Draw a figure as the note has it, what stands out wider."""
        shades = {"accent": 0, "bad": 1, "amber": 2}
        for curve in figure.curves:
            color, x, y = shades.get(curve.color, curve.color), np.asarray(curve.x), np.asarray(curve.y)
            if curve.shape == "points":
                self.points(curve.name, x, y, color)
            elif curve.shape == "bars":
                self.bars(curve.name, x, y, color)
            else:
                self.curve(curve.name, x, y, color, 1.3 * curve.width, dash=curve.shape == "dash", path=True)
        self.set_range(figure.x_range, figure.y_range)

    def bundle(self, names: Sequence[str], lines: Sequence[tuple]) -> None:
        """Lines (x, y) drawn as one item, without entries: items of their own would hold up the hand that types."""
        known = [(numbers(x), numbers(y)) for x, y in lines]
        if known:
            x, y = (np.concatenate([np.append(one[k], np.nan) for one in known]) for k in (0, 1))
            item = pg.PlotDataItem(x, y, connect="finite")
            self.plot.addItem(item)
            self._keep(item, 6, 0.8, False, False)
        self.extents += known
        self.data += [(name, *one) for name, one in zip(names, known, strict=True)]

    def points(self, name: str, x, y, color=0, size=8, legend=True, symbol="o", values=None) -> pg.PlotDataItem:
        """Marks without a line. values : what the CSV holds in the place of y, no number where there is none."""
        x, y = numbers(x), numbers(y)
        label = self._entry(name) if legend else None
        item = pg.PlotDataItem(x, y, pen=None, symbol=symbol, symbolSize=size, name=label)
        self.plot.addItem(item)
        self.extents.append((x, y))
        self._keep(item, color, 1.0, False, True)
        self.data.append((name, x, y if values is None else numbers(values)))
        return item

    def bars(self, name: str, x, heights, color=0, width=0.7, values=None) -> None:
        """Bars; values : as of `points`."""
        x, heights = numbers(x), numbers(heights)
        label = self._entry(name) if x.size else None  # no entry for bars that are not there
        item = pg.BarGraphItem(x=x, height=heights, width=width, name=label)
        self.plot.addItem(item)
        self.extents += [(x - 0.5 * width, heights), (x + 0.5 * width, 0.0 * heights)]
        self._keep(item, color, 1.0, False, True)
        self.data.append((name, x, heights if values is None else numbers(values)))

    def level(self, value: float, label: str = "", color="quiet", vertical=False, place=None):
        """A line across the chart with a label, which stands at the edge where the line lies outside. place : of the
        label along it, 0 to 1"""
        shade = pg.mkColor(theme.current.back)
        shade.setAlpha(210)  # legible where it meets a bar or a curve
        options = {"position": place or (0.92 if vertical else 0.01), "fill": shade}
        if not vertical and place is None:  # it begins right of the axis, however narrow the chart is
            options["anchors"] = [(0, 0), (0, 1)]
        line = pg.InfiniteLine(value, 90 if vertical else 0, label=label or None, labelOpts=options)
        self.plot.addItem(line, ignoreBounds=True)
        self._keep(line, color, 1.2, True, False)
        self.edges.add(line, label)
        return line

    def band(self, x, low, high, color=1) -> None:
        """The area between two curves."""
        shade = pg.mkColor(self._shade(theme.current, color))
        shade.setAlpha(45)
        ends = [pg.PlotDataItem(numbers(x), numbers(edge)) for edge in (low, high)]
        for end, edge in zip(ends, (low, high), strict=True):
            self.plot.addItem(end)
            self.extents.append((numbers(x), numbers(edge)))
            self._keep(end, color, 0.6, True, False)
        area = pg.FillBetweenItem(*ends, brush=shade)
        self.plot.addItem(area)
        self.items.append((area, None, 0, False, False))

    def add(self, item, recolor: Callable[[theme.Theme, float], None] = lambda chosen, scale: None) -> None:
        """Any other item. recolor(theme, scale) : gives it its colours, and lines so many times as wide."""
        self.plot.addItem(item)
        self.recolors.append(recolor)
        recolor(theme.current, 1.0)
        self.items.append((item, None, 0, False, False))

    def entry(self, mark, name: str) -> None:
        """An entry of the legend without an item of the chart."""
        self.legend.addItem(mark, self._entry(name))

    def _entry(self, name: str) -> str:
        self.entries.append(name)
        return name

    def ticks(self, side: str, places: list[tuple[float, str]]) -> None:
        """Labels of an axis at these places."""
        axis = self.plot.getAxis(side)
        axis.setTicks([places])
        if side == "left":  # else as wide as the numbers that were there before
            widest = max((self.fontMetrics().horizontalAdvance(name) for _, name in places), default=0)
            axis.setWidth(widest + 34)

    def names_below(self, names: list[str]) -> None:
        """Names below the places 0, 1, 2 … of the axis, as many of them as its width holds."""
        self.names = names
        show_names(self)

    def names_beside(self, lines: Sequence[tuple[float, str]]) -> None:
        """Names at places of the left axis, as many of them as its height holds."""
        self.lines = list(lines)
        show_names(self)

    def resizeEvent(self, event) -> None:
        super().resizeEvent(event)
        self.fit()

    def fit(self) -> None:
        """Names, legend and words as the width of the view wants them."""
        show_names(self)
        self._place_legend()

    def _place_legend(self) -> None:
        """In as many columns as the width holds, and room for it."""
        self.reason.setGeometry(self.view.rect().adjusted(70, 20, -20, -40))
        count = len(self.legend.items)
        for (_, label), name in zip(self.legend.items, self.entries, strict=True):
            self._cut(label, name)
        if self.beside:
            self.legend.updateSize()
            self.plot.layout.setColumnFixedWidth(3, self.legend.boundingRect().width())
            return
        widest = max((label.width() for _, label in self.legend.items), default=0.0)
        columns = max(1, min(count, int((self.view.width() - 70) / (widest + 40))))
        if count and columns != self.legend.columnCount:
            self.legend.setColumnCount(columns)
        self.legend.updateSize()
        height = self.legend.boundingRect().height() if count else 0.0
        self.plot.layout.setRowFixedHeight(0, height)

    def _cut(self, label: pg.LabelItem, name: str) -> None:
        """A name of the legend, cut only where the chart is not as wide; beside the axes there is no such room."""
        letters = LEGEND_LETTERS
        if not self.beside:
            if label.text != name:
                label.setText(name)
            share = (self.view.width() - 50) / max(label.itemRect().width(), 1.0)
            letters = max(letters, int(share * len(name)))
        if label.text != elide_name(name, letters):
            label.setText(elide_name(name, letters))

    def set_log(self, on: bool) -> None:
        self.plot.setLogMode(on, on)
        for side in ("bottom", "left"):  # the labels of the decades alone, apart from each other
            self.plot.getAxis(side).setStyle(maxTextLevel=0 if on else 2)

    def set_range(self, x: tuple[float, float] | None = None, y: tuple[float, float] | None = None) -> None:
        """Ends of the axes, to which `reset` comes back."""
        for name, ends in (("x", x), ("y", y)):
            if ends is not None:
                self.ranges[name] = ends
        self.reset()

    def reset(self) -> None:
        """Show everything, by the data themselves: an item that is clipped to the view knows only what it shows."""
        self._place_legend()
        log = self.plot.ctrl.logXCheck.isChecked()
        for k, name in enumerate("xy"):
            show = (self.plot.setXRange, self.plot.setYRange)[k]
            if name in self.ranges:
                show(*self.ranges[name], padding=(0.01, 0.0)[k])
            elif (ends := ends_of([extent[k] for extent in self.extents], log)) is not None:
                show(*ends, padding=AXIS_PADDING)

    # colours

    @staticmethod
    def _shade(chosen: theme.Theme, color) -> str:
        return chosen.curves[color % len(chosen.curves)] if isinstance(color, int) else getattr(chosen, color)

    def _keep(self, item, color, width, dash, filled) -> None:
        self.items.append((item, color, width, dash, filled))
        self._paint(item, color, width, dash, filled, theme.current)

    def _paint(self, item, color, width, dash, filled, chosen, scale=1.0) -> None:
        if color is None:
            return
        shade = self._shade(chosen, color)
        pen = pg.mkPen(shade, width=width * scale, style=Qt.PenStyle.DashLine if dash else Qt.PenStyle.SolidLine)
        if isinstance(item, pg.BarGraphItem):
            item.setOpts(brush=shade, pen=pg.mkPen(shade, width=scale))
        elif filled:
            item.setSymbolBrush(shade)
            item.setSymbolPen(pg.mkPen(shade, width=scale))
        else:
            item.setPen(pen)
            if isinstance(item, pg.InfiniteLine) and hasattr(item, "label"):
                item.label.setColor(shade)
                behind = pg.mkColor(chosen.back)
                behind.setAlpha(210)
                item.label.fill = pg.mkBrush(behind)

    def _apply_theme(self, chosen: theme.Theme, scale: float = 1.0) -> None:
        self.view.setBackground(chosen.back)
        for side, label in zip(("bottom", "left"), self.labels, strict=True):
            axis = self.plot.getAxis(side)
            # enableAutoSIPrefix(False) alone keeps the scale of the range of that moment: 0.1 g would read 100
            axis.setSIPrefixEnableRanges(())
            axis.enableAutoSIPrefix(False)
            axis.setPen(chosen.quiet, width=scale)
            axis.setTextPen(chosen.ink)
            self.plot.setLabel(side, label, color=chosen.ink)
        self.legend.setLabelTextColor(chosen.ink)
        for _, label in self.legend.items:
            label.setText(label.text, color=chosen.ink)
        self.found.setBrush(chosen.ink)
        for entry in self.items:
            self._paint(*entry, chosen, scale)
        for recolor in self.recolors:
            recolor(chosen, scale)
        self.edges.paint(chosen)

    def _pressed(self, event) -> None:
        if event.button() == Qt.MouseButton.LeftButton and self.plot.vb.sceneBoundingRect().contains(event.scenePos()):
            point = self.plot.vb.mapSceneToView(event.scenePos())
            self.clicked.emit(point.x(), point.y())

    # values under the cursor

    def _moved(self, event) -> None:
        point = self.plot.vb.mapSceneToView(event[0])
        x, y = point.x(), point.y()
        log = self.plot.ctrl.logXCheck.isChecked()
        near = self._nearest(x, y, log)
        name = ""
        if near is not None:
            name, x, y = near
            self.found.setData([x], [y])
            name += "   "
        else:
            self.found.clear()
        if log:
            x, y = 10.0**x, 10.0**y
        language = current_language()
        words = (self.labels[0], format_number(x, ".4g", language), self.labels[1], format_number(y, ".4g", language))
        self.read.setText("  " + name + "{} {}   {} {}".format(*words))

    def _nearest(self, x: float, y: float, log: bool) -> tuple[str, float, float] | None:
        """(curve, x, y) of the data point close to a place of the axes; None where none is."""
        (left, right), (low, high) = self.plot.viewRange()
        best, nearest = MAX_POINT_DISTANCE, None
        for name, xs, ys in self.data:
            if not xs.size or xs.size != ys.size:
                continue
            with np.errstate(invalid="ignore", divide="ignore"):
                if log:
                    xs, ys = np.log10(xs), np.log10(ys)
                away = np.hypot((xs - x) / (right - left), (ys - y) / (high - low))
            if not np.isfinite(away).any():
                continue
            k = int(np.nanargmin(away))
            if away[k] < best:
                best, nearest = float(away[k]), (name, float(xs[k]), float(ys[k]))
        return nearest

    # menu

    def _menu(self, place) -> None:
        self._open_menu(self.view.mapToGlobal(place))

    def menu_of(self) -> list[tuple]:
        """What can be done with the chart: label and slot of each."""
        return [
            (tr("Show everything"), self.reset),
            (tr("Axis limits…"), self._ask_limits),
            (tr("Copy the picture"), self.copy),
            (tr("Save as a figure for a report: PNG, SVG or PDF"), self._save_figure),
            (tr("Size of the figures…"), self._ask_size),
            (tr("Save the data as CSV"), self._save_data),
            (tr("The data as a table"), self.show_table),
        ]

    def _open_menu(self, place) -> None:
        menu = QMenu(self)
        for label, slot in self.menu_of():
            menu.addAction(label, slot)
        menu.exec(place)
        menu.deleteLater()

    def show_table(self) -> None:
        """The data in a window of their own, for readers of the screen and for copying."""
        from app.views.figure_dialogs import data_table

        with delete_after_use(data_table(self)) as dialog:
            dialog.exec()

    def _ask_size(self) -> None:
        from app.views.figure_dialogs import ask_size

        ask_size(self)

    def _ask_limits(self) -> None:
        from app.views.figure_dialogs import axis_limits

        (left, right), (low, high) = self.plot.viewRange()
        limits = axis_limits(self, self.labels, (left, right, low, high))
        if limits is not None:
            self.plot.setXRange(*limits[:2], padding=0)
            self.plot.setYRange(*limits[2:], padding=0)
