"""Words at the edges of a chart for limits that lie outside of what it shows."""

from typing import TYPE_CHECKING

from app.look import theme
from app.look.charting import pg
from app.look.language import current_language
from core.text.sentence import format_number

if TYPE_CHECKING:
    from app.views.chart import Chart

EDGE_ARROWS = {"top": ("↑", 1.0, 1.0), "bottom": ("↓", 1.0, 0.0), "left": ("←", 0.0, 0.5), "right": ("→", 1.0, 0.5)}
"""Arrow of each edge, and where its words stand: shares of width and height of the axes."""


class EdgeMarks:
    """One mark an edge, with the names of the limits beyond it; they follow the range of the axes."""

    def __init__(self, chart: "Chart"):
        self.chart = chart
        self.lines: list[tuple[pg.InfiniteLine, str]] = []
        self.items: dict[str, pg.TextItem] = {}
        chart.plot.vb.sigRangeChanged.connect(lambda *_: self.follow())

    def clear(self) -> None:
        """Forget the limits, and take away the marks."""
        for item in self.items.values():
            self.chart.plot.removeItem(item)
        self.lines, self.items = [], {}

    def add(self, line: pg.InfiniteLine, label: str) -> None:
        """Follow a limit by its line; one without a name has no mark."""
        if label:
            self.lines.append((line, label))
            self.follow()

    def beyond(self) -> dict[str, list[str]]:
        """Names of the limits beyond each edge, with their values where the name has none."""
        (left, right), (low, high) = self.chart.plot.viewRange()
        by_edge: dict[str, list[str]] = {}
        for line, label in self.lines:
            value, upright = line.value(), line.angle % 180 == 90
            first, last = (left, right) if upright else (low, high)
            if first <= value <= last:
                continue
            sides = ("left", "right") if upright else ("bottom", "top")
            by_edge.setdefault(sides[int(value > last)], []).append(self._named(label, value))
        return by_edge

    def _named(self, label: str, value: float) -> str:
        if any(letter.isdigit() for letter in label):
            return label
        log = self.chart.plot.ctrl.logXCheck.isChecked()
        return f"{label} = {format_number(10.0**value if log else value, '.3g', current_language())}"

    def follow(self) -> None:
        """Set the marks at the edges of what is shown now."""
        beyond = self.beyond()
        for side in beyond.keys() - self.items.keys():
            _, across, up = EDGE_ARROWS[side]
            item = self.items[side] = pg.TextItem(anchor=(across, 1.0 - up))
            item.setZValue(60)
            self.chart.plot.addItem(item, ignoreBounds=True)
            self.paint(theme.current)
        (left, right), (low, high) = self.chart.plot.viewRange()
        for side, item in self.items.items():
            arrow, across, up = EDGE_ARROWS[side]
            item.setVisible(side in beyond)
            if side in beyond:
                item.setPlainText(f"{arrow} {', '.join(beyond[side])}")
                item.setPos(left + across * (right - left), low + up * (high - low))

    def paint(self, chosen: theme.Theme) -> None:
        """Give the marks the colours of a theme."""
        behind = pg.mkColor(chosen.back)
        behind.setAlpha(210)
        for item in self.items.values():
            item.setColor(chosen.ink)
            item.fill = pg.mkBrush(behind)
            item.update()
