"""Names at the places of an axis in the place of numbers: of records below bars, of runs beside strips."""

import math

from PySide6.QtCore import QSize

from app.look.language import tr
from app.views.axis import TICK_LETTERS, elide_name

HEIGHT_SHARE, WIDTH_SHARE = 0.6, 0.85
"""Shares of the height and of the width of a view that its axes take."""


def show_names(chart) -> None:
    """As many names as the axes hold; of a figure all of them, upright below where they would touch."""
    if chart.names:
        _show_below(chart)
    if chart.lines:
        room = HEIGHT_SHARE * chart.view.height() / chart.fontMetrics().height()
        step = max(1, math.ceil(len(chart.lines) / max(1.0, room)))
        chart.ticks("left", [(at, elide_name(name, TICK_LETTERS + 4)) for at, name in chart.lines[::step]])


def _show_below(chart) -> None:
    shown, axis = _below(chart), chart.plot.getAxis("bottom")
    room = WIDTH_SHARE * chart.view.width()
    across = room / (_widest(chart, shown) + 12)
    upright = chart.is_figure and len(shown) > across
    step = _step_upright(chart, room) if upright else max(1, math.ceil(len(shown) / max(1.0, across)))
    axis.stand_upright(_widest(chart, shown) if upright else 0)
    places = range(0, len(shown), step)
    chart.ticks("bottom", [(k, shown[k]) for k in places])


def _below(chart) -> list[str]:
    return [elide_name(name, TICK_LETTERS) for name in chart.names]


def _widest(chart, names: list[str]) -> int:
    return max((chart.fontMetrics().horizontalAdvance(name) for name in names), default=0)


def _step_upright(chart, room: float) -> int:
    """Every how many names stand apart: letters without the room between two lines."""
    return max(1, math.ceil(len(_below(chart)) * (chart.fontMetrics().ascent() + 1) / max(room, 1.0)))


def fit_all_names(chart, whole: QSize) -> QSize:
    """The size of a figure, as high as its names want it. whole : without them"""
    height, names = whole.height(), _below(chart)
    if WIDTH_SHARE * whole.width() < len(names) * (_widest(chart, names) + 12):
        height += _widest(chart, names)
    return QSize(whole.width(), max(height, math.ceil(len(chart.lines) * chart.fontMetrics().height() / HEIGHT_SHARE)))


def unnamed_line(chart, whole: QSize) -> list[str]:
    """What stands below a figure that is too narrow for all names, even upright."""
    step = _step_upright(chart, WIDTH_SHARE * whole.width())
    return [tr("Of {n} names one in {step} is shown; the data have all.", n=len(chart.names), step=step)] * (step > 1)
