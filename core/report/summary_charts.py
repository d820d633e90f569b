"""Charts of the Summary: the wall to scale, the peaks at the demand."""

from openpyxl.chart import BarChart, LineChart, Reference, ScatterChart, Series
from openpyxl.chart.layout import Layout, ManualLayout

from core.report.cells import ACCENT, AMBER, BAD, GOOD, QUIET, Book, text
from core.report.load_arrows import arrows
from core.study.results import WallResult

DATA = 20
"""First column of the data behind the charts, right of what is printed."""


def sketch(book: Book, sheet, wall: WallResult, anchor: str, size: tuple[float, float]) -> None:
    """The wall to scale, its hinge and its ground, as a native chart. size : width and height [cm]"""
    h, t, u = wall.height, wall.thickness, wall.wall.setback
    outlines = (
        [(0.0, 0.0), (t, 0.0), (t, h), (0.0, h), (0.0, 0.0)],
        [(t - u, 0.0), (0.5 * t, 0.5 * h)],
        [(-0.35 * h, 0.0), (0.35 * h + t, 0.0)],
    )
    chart = ScatterChart()
    chart.style, chart.legend = 13, None
    chart.width, chart.height = size
    chart.title = None
    drawn = [*zip(outlines, (ACCENT, BAD, QUIET), strict=True)]
    drawn += [(points, AMBER) for points in arrows(wall.wall, h, t)]
    for k, (points, color) in enumerate(drawn):
        column = DATA + 16 + 2 * k
        for n, (x, y) in enumerate(points):
            sheet.cell(1 + n, column, x)
            sheet.cell(1 + n, column + 1, y)
        xs = Reference(sheet, min_col=column, min_row=1, max_row=len(points))
        ys = Reference(sheet, min_col=column + 1, min_row=1, max_row=len(points))
        series = Series(ys, xs)
        series.marker.symbol, series.smooth = "none", False
        series.graphicalProperties.line.solidFill = color
        series.graphicalProperties.line.width = 15000
        chart.series.append(series)
    chart.layout = Layout(ManualLayout(layoutTarget="inner", xMode="edge", yMode="edge", x=0.05, y=0.05, w=0.9, h=0.9))
    tall = 1.06 * max([h, *(y for points in arrows(wall.wall, h, t) for _, y in points)])
    wide = tall * (0.9 * chart.width) / (0.9 * chart.height)
    wide = max(wide, 1.2 * t)
    chart.y_axis.scaling.min, chart.y_axis.scaling.max = -0.03 * h, -0.03 * h + tall
    chart.x_axis.scaling.min, chart.x_axis.scaling.max = 0.5 * t - 0.5 * wide, 0.5 * t + 0.5 * wide
    chart.x_axis.delete = chart.y_axis.delete = True
    chart.x_axis.majorGridlines = chart.y_axis.majorGridlines = None
    sheet.add_chart(chart, anchor)


TOP = 1.2
"""Of the axis of the peaks, which the mark of an overturned run fills."""


def peaks(book: Book, sheet, check, anchor: str, width: float, height: float) -> None:
    """Peak rotation over theta_c of each record at the demand, with lines at 0.40, 0.60 and 1.00."""
    say = book.say
    column = DATA + 8
    heads = [say("record"), "θmax/θc", "0.40", "0.60", "1.00", say("exceeds θc or overturns")]
    for k, head in enumerate(heads):
        text(sheet, 1, column + k, head, size=8, color=QUIET)
    for n, run in enumerate(check.runs, start=2):
        sign = "" if len({r.polarity for r in check.runs}) == 1 else " +" if run.polarity > 0 else " −"
        text(sheet, n, column, f"{run.record[-14:]}{sign}", size=8, color=QUIET)
        # a wall that overturns has no peak: the mark of its own series fills the chart
        exceeded = run.peak_ratio is None or run.exceeded
        sheet.cell(n, column + (5 if exceeded else 1), TOP if exceeded else run.peak_ratio)
        for k, level in enumerate((0.40, 0.60, 1.00), start=2):
            sheet.cell(n, column + k, level)
    last = 1 + len(check.runs)
    bars = BarChart()
    bars.type, bars.style, bars.gapWidth = "col", 13, 60
    bars.overlap = 100
    for k, color in ((1, ACCENT), (5, BAD)):
        data = Reference(sheet, min_col=column + k, min_row=1, max_row=last)
        bars.add_data(data, titles_from_data=True)
        bars.series[-1].graphicalProperties.solidFill = color
    bars.set_categories(Reference(sheet, min_col=column, min_row=2, max_row=last))
    lines = LineChart()
    for k, color in zip((2, 3, 4), (GOOD, AMBER, BAD), strict=True):
        data = Reference(sheet, min_col=column + k, min_row=1, max_row=last)
        lines.add_data(data, titles_from_data=True)
        series = lines.series[-1]
        series.marker.symbol, series.smooth = "none", False
        series.graphicalProperties.line.solidFill = color
        series.graphicalProperties.line.width = 14000
    bars += lines
    bars.y_axis.scaling.min, bars.y_axis.scaling.max = 0, TOP
    bars.y_axis.title, bars.x_axis.title = "θmax/θc", None
    bars.x_axis.delete = bars.y_axis.delete = False
    bars.y_axis.majorGridlines = None
    bars.legend.position = "r"
    bars.width, bars.height = width, height
    sheet.add_chart(bars, anchor)
