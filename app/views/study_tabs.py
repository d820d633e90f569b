"""Figures, tables and claims of a parametric study as widgets."""

from PySide6.QtWidgets import QVBoxLayout, QWidget

from app.look.labels import PlainLabel
from app.look.language import number, tr
from app.views.chart import Chart
from app.views.table import Table
from core.lab.research.figures import DASHED, LINE_POINTS, POINTS, Claim, Figure, marker_of
from core.lab.research.figures import Table as StudyTable

SYMBOLS = ("o", "s", "t", "d")
MIN_SERIES_BESIDE = 7
"""Named series from which the legend stands beside the chart."""


def figure_chart(figure: Figure) -> QWidget:
    """A figure as a chart, its note below."""
    many = sum(bool(series.name) for series in figure.series) >= MIN_SERIES_BESIDE
    chart = Chart(figure.x, figure.y, figure.title, "beside" if many else "above", live=True)
    chart.plot.setLogMode(figure.log_x, figure.log_y)
    for k, series in enumerate(figure.series):
        named = bool(series.name)
        if series.look != POINTS:
            chart.curve(
                series.name,
                series.x,
                series.y,
                series.color,
                1.8,
                dash=series.look == DASHED,
                legend=named and series.look != LINE_POINTS,
                path=True,
            )
        if series.look in (POINTS, LINE_POINTS):
            symbol = SYMBOLS[marker_of(figure, k) % len(SYMBOLS)]
            chart.points(series.name, series.x, series.y, series.color, 7, legend=named, symbol=symbol)
            if series.look == LINE_POINTS:
                chart.data.pop()  # its line has them
    chart.reset()
    return _with_note(chart, figure.note)


def format_value(value) -> str:
    """A value of a table with three significant digits."""
    if value is None:
        return "–"
    if isinstance(value, float):
        return f"{number(value, '.0f')}" if abs(value) >= 100.0 else f"{number(value, '.3g')}"
    return str(value)


def table_view(table: StudyTable) -> QWidget:
    """A table whose cells copy into Excel, its note below."""
    view = Table(table.title, list(table.head))
    view.live = True
    view.show_rows([[format_value(value) for value in row] for row in table.rows])
    return _with_note(view, table.note)


def claims_table(claims: tuple[Claim, ...]) -> Table:
    """What the paper claims and in how many cases it holds."""
    heads = [tr("Source"), tr("Claim of the paper"), tr("holds in"), tr("of"), tr("What is found")]
    view = Table(tr("Claims"), heads)
    view.live = True
    view.show_rows(
        [
            [claim.source, claim.claim, format_value(claim.held), format_value(claim.tried), claim.found]
            for claim in claims
        ]
    )
    return view


def _with_note(content: QWidget, note: str) -> QWidget:
    page = QWidget()
    layout = QVBoxLayout(page)
    layout.setContentsMargins(0, 0, 0, 0)
    layout.addWidget(content, 1)
    if note:
        words = PlainLabel(note)
        words.setWordWrap(True)
        layout.addWidget(words)
    return page
