"""What stands at the axes of a chart: numbers, names as long as there is room for."""

import numpy as np
from PySide6.QtCore import QRectF, Qt

from app.look.charting import pg
from app.look.language import current_language


def numbers(values) -> np.ndarray:
    """A contiguous float64 array of one dimension: anything else can crash the drawing."""
    return np.ascontiguousarray(np.asarray(values, dtype=np.float64).ravel())


MIN_TICK_DISTANCE = 26
"""Room [px] below which the labels of neighbouring ticks of a bottom axis touch."""


UPRIGHT = 8.0
"""Between an axis and a name that stands below it [px]."""

LEGEND_LETTERS, TICK_LETTERS = 22, 16
"""Letters of a name in a legend beside the axes or in a narrow chart, and beside an axis; the data have all of it."""


def elide_name(name: str, most: int = LEGEND_LETTERS) -> str:
    """A name as a chart has room for it: its beginning and its end, where channel and sign stand."""
    if len(name) <= most:
        return name
    end = most - most // 3 - 1
    return f"{name[: most // 3]}…{name[-end:]}"


def ends_of(values: list[np.ndarray], log: bool) -> tuple[float, float] | None:
    """Least and largest place of an axis among these values, None where there is no number. log : whether places are
    their logarithms"""
    places = np.concatenate([np.empty(0), *values])
    if log:
        places = np.log10(places[places > 0.0])
    places = places[np.isfinite(places)]
    if not places.size:
        return None
    low, high = float(places.min()), float(places.max())
    half = 0.0 if high > low else 0.5 * abs(low) or 0.5
    return low - half, high + half


class Axis(pg.AxisItem):
    """Numbers with the decimal mark of the language, apart from each other; names below it upright, where they would
    touch side by side."""

    upright = 0
    """Length of the longest name that stands upright [px], 0 where names lie."""

    def stand_upright(self, length: int) -> None:
        """Let names stand, and lie again for a length of 0."""
        if length != self.upright:
            self.upright = length
            self.setHeight(length + round(UPRIGHT + self.label.boundingRect().height()) if length else None)

    def drawPicture(self, p, axisSpec, tickSpecs, textSpecs):
        super().drawPicture(p, axisSpec, tickSpecs, [] if self.upright else textSpecs)
        if not self.upright:
            return
        bounds, (low, high) = self.mapRectFromParent(self.geometry()), self.range
        p.setPen(self.textPen())
        for place, name in (self._tickLevels or [[]])[0]:
            across = bounds.left() + (place - low) / (high - low) * bounds.width()
            if bounds.left() <= across <= bounds.right():
                p.save()
                p.translate(across, bounds.top() + UPRIGHT)
                p.rotate(-90.0)
                area = QRectF(-self.upright - 2.0, -10.0, self.upright + 2.0, 20.0)
                p.drawText(area, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter, name)
                p.restore()

    def tickSpacing(self, minVal, maxVal, size):
        levels = super().tickSpacing(minVal, maxVal, size)
        span = abs(maxVal - minVal)
        if self.orientation != "bottom" or not span:
            return levels
        return [level for level in levels if level[0] * size >= MIN_TICK_DISTANCE * span] or levels[:1]

    def tickStrings(self, values, scale, spacing):
        words = super().tickStrings(values, scale, spacing)
        if current_language() == "en":
            return words
        return [word.replace(".", ",") for word in words]


def number_axes(plot, on: bool) -> None:
    """Numbers beside the axes of a plot; none where nothing is drawn, for they would be invented."""
    for side in ("bottom", "left"):
        plot.getAxis(side).setStyle(showValues=on)


SPARE_PLOTS: list[pg.PlotWidget] = []
"""Made ahead for the charts to come."""


def plot_widget() -> pg.PlotWidget:
    """With axes of ours; the menu of pyqtgraph, which no one sees, would take a third of the time."""
    return pg.PlotWidget(axisItems={side: Axis(side) for side in ("bottom", "left")}, enableMenu=False)
