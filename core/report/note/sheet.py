"""The calculation note as a sheet of the workbook: its numbers are those of the sheet Check, live, its figures native
charts."""

import math

from openpyxl.chart import BarChart, LineChart, Reference, ScatterChart, Series
from openpyxl.chart.label import DataLabelList
from openpyxl.chart.layout import Layout, ManualLayout
from openpyxl.utils import get_column_letter
from openpyxl.worksheet.pagebreak import Break

from core.derivation.faces import Shown
from core.report.cells import (
    ACCENT,
    AMBER,
    BAD,
    GOOD,
    INK,
    QUIET,
    ROW_HEIGHT,
    Book,
    fill,
    frame,
    merge,
    rule,
    style,
    text,
)
from core.report.note.content import note
from core.report.note.parts import Blanks, Box, Derivation, Figure, Figures, Heading, Paragraph, Part, Step, Table
from core.report.plots import new_chart, rows_below
from core.report.rows import changed_cell
from core.study.results import StudyResult

GRID, COLUMN = 12, 7.9
"""Columns of the sheet and their width in characters; tables span them."""

LINE = 13.5
"""Height of a line [points]."""

FIGURE_CM = (9.0, 6.9)
"""Size of a figure."""

PAGE = 740.0
"""Height of the rows of a page, A4 within its margins and fitted to its width [points]."""

DATA = GRID + 4
"""First column of the data behind the charts, right of what is printed."""

COLORS = {
    "": INK,
    "ink": INK,
    "quiet": QUIET,
    "strong": INK,
    "accent": ACCENT,
    "good": GOOD,
    "amber": AMBER,
    "bad": BAD,
}
BOLD = ("strong", "good", "amber", "bad")


def note_sheet(book: Book, result: StudyResult) -> None:
    """The sheet of the note; that of the sheet Check is made before, whose cells it shows."""
    sheet = book.sheet("Calculation note", [COLUMN] * GRID)
    _Writer(book, sheet).write(note(result, book.language))


class _Writer:
    """Puts parts onto a sheet, row below row."""

    def __init__(self, book: Book, sheet):
        self.book, self.sheet = book, sheet
        self.row, self.data, self.figures = 1, DATA, 0

    def write(self, parts: list[Part]) -> None:
        changed_cell(self.book, self.sheet, 1, 1)
        style(self.sheet.cell(1, 1), bold=True, color=BAD, wrap=True)
        self._merge(1, 1, GRID)
        self.sheet.row_dimensions[1].height = 2.0 * LINE
        self.row = 2
        for part in self.book.steps.each(parts):
            self._add(part)
        self.sheet.print_area = f"A1:{get_column_letter(GRID)}{self.row}"

    def _add(self, part: Part) -> None:
        if isinstance(part, Heading):
            self._heading(part)
        elif isinstance(part, Paragraph):
            self._wrapped(self.row, 1, GRID, part.text, part.tone)
            self.row += 1
        elif isinstance(part, Table):
            self._table(part)
        elif isinstance(part, Derivation):
            for step in part.steps:
                self._step(step)
        elif isinstance(part, Figures):
            self._figures(part.figures)
        elif isinstance(part, Box):
            self._box(part.lines)
        elif isinstance(part, Blanks):
            self._blanks(part.labels)

    def _merge(self, row: int, first: int, last: int) -> None:
        if last > first:
            merge(self.sheet, row, first, row, last)

    def _wrapped(self, row: int, first: int, last: int, content: str, tone="", size=10, **look) -> None:
        """Text over several columns, the row as high as it needs."""
        self._merge(row, first, last)
        text(self.sheet, row, first, content, wrap=True, color=COLORS[tone], bold=tone in BOLD, size=size, **look)
        room = COLUMN * (last - first + 1) * 10.0 / size
        lines = max(1, math.ceil(0.94 * len(content) / room))
        known = self.sheet.row_dimensions[row].height or LINE
        self.sheet.row_dimensions[row].height = max(known, lines * LINE * size / 10.0 + 1.5)

    def _heading(self, part: Heading) -> None:
        if part.new_page:
            self.sheet.row_breaks.append(Break(id=self.row - 1))
        elif part.level == 2:
            self.row += 1
        size = {1: 16, 2: 13, 3: 10}[part.level]
        self._wrapped(self.row, 1, GRID, part.text, size=size, vertical="center")
        text(self.sheet, self.row, 1, part.text, bold=True, color=ACCENT, size=size, wrap=True)
        if part.level == 3:
            rule(self.sheet, self.row, 1, GRID)
        self.row += 1

    def _spans(self, widths) -> list[tuple[int, int]]:
        """First and last column of each column of a table, at least one each."""
        ends, whole, done = [], sum(widths), 0.0
        for width in widths:
            done += width
            ends.append(round(GRID * done / whole))
        for k in range(len(ends)):
            ends[k] = max(ends[k], (ends[k - 1] if k else 0) + 1)
        for k in range(len(ends) - 1, -1, -1):
            ends[k] = min(ends[k], GRID - (len(ends) - 1 - k))
        firsts = [1, *(end + 1 for end in ends[:-1])]
        return list(zip(firsts, ends, strict=True))

    def _table(self, part: Table) -> None:
        spans = self._spans(part.widths)
        if part.heads:
            for (first, last), head in zip(spans, part.heads, strict=True):
                self._wrapped(self.row, first, last, head, size=9, vertical="center")
                for column in range(first, last + 1):
                    fill(self.sheet.cell(self.row, column), ACCENT)
                text(self.sheet, self.row, first, head, bold=True, color="FFFFFF", size=9, wrap=True, vertical="center")
            self.row += 1
        for n, row in enumerate(part.rows):
            for k, ((first, last), content) in enumerate(zip(spans, row, strict=True)):
                tone = part.tones.get((n, k), "quiet" if not part.heads and k == 0 else "")
                self._wrapped(self.row, first, last, content, tone, 9)
            if part.heads:
                rule(self.sheet, self.row, 1, GRID)
            self.row += 1

    def _step(self, step: Step) -> None:
        """Formula with its numbers, value, unit, what it is, clause; live where the sheet Check has the cells."""
        language, cells = self.book.language, self.book.workbook.defined_names
        written = step.written(language)
        self._wrapped(self.row, 1, 6, written)
        names = [piece.cell for piece in step.numbers if isinstance(piece, Shown) and piece.cell]
        if step.numbers and all(name in cells for name in names):
            live = self.book.formula(self.sheet.cell(self.row, 1), self._live_text(step), written, "General")
            style(live, wrap=True)
        value = self.sheet.cell(self.row, 7)
        shape = _shape(step.form)
        if step.cell in cells and isinstance(step.result, float):
            self.book.formula(value, f"={step.cell}", step.result, shape)
        elif isinstance(step.result, (int, float)):
            value.value = float(step.result)
            style(value, number_format=shape)
        else:
            text(self.sheet, self.row, 7, step.result_written(language), align="right")
        text(self.sheet, self.row, 8, step.unit, color=QUIET)
        if step.label:
            self._wrapped(self.row, 9, 11, step.label, "quiet", 8)
        text(self.sheet, self.row, 12, step.clause, color=QUIET, size=7, align="right")
        self.row += 1

    def _live_text(self, step: Step) -> str:
        """The line of a step as a formula."""
        # whatever mark the spreadsheet's own language has
        marks = '".",","' if self.book.language == "it" else '",","."'
        pieces: list = [f"{step.symbol} = " + (f"{step.formula} = " if step.formula else "")]
        joined = []
        for piece in [*pieces, *step.numbers]:
            if isinstance(piece, Shown):
                number = f"SUBSTITUTE(FIXED({piece.cell or repr(piece.value)},{piece.digits},TRUE),{marks})"
                joined += ['"("', number, '")"'] if piece.value < 0.0 else [number]
            elif joined and joined[-1].startswith('"'):
                joined[-1] = joined[-1][:-1] + piece.replace('"', '""') + '"'
            else:
                joined.append('"' + piece.replace('"', '""') + '"')
        return "=" + "&".join(joined)

    def _box(self, lines: int) -> None:
        first, last = self.row, self.row + lines - 1
        merge(self.sheet, first, 1, last, GRID)
        for r in range(first, last + 1):
            for c in range(1, GRID + 1):
                edges = {"left": c == 1, "right": c == GRID, "top": r == first, "bottom": r == last}
                frame(self.sheet.cell(r, c), QUIET, *(side for side, here in edges.items() if here))
        self.row = last + 2

    def _blanks(self, labels) -> None:
        self.row += 1
        size = GRID // len(labels)
        for k, label in enumerate(labels):
            text(self.sheet, self.row, 1 + k * size, label, color=QUIET, size=9)
            for column in range(2 + k * size, (k + 1) * size):
                frame(self.sheet.cell(self.row, column + (1 if size > 4 else 0)), QUIET, "bottom")
        self.row += 2

    # figures

    def _figures(self, figures) -> None:
        half, lines = GRID // 2, rows_below(FIGURE_CM[1])
        if self._filled() + lines * ROW_HEIGHT + 2.0 * LINE > PAGE:  # no page ends within a figure
            self.sheet.row_breaks.append(Break(id=self.row - 1))
        for k, figure in enumerate(figures):
            self.figures += 1
            chart = self._drawing(figure) if figure.is_drawing else self._chart(figure)
            self.sheet.add_chart(chart, f"{get_column_letter(1 + k * half)}{self.row}")
        below = self.row + lines
        for k, figure in enumerate(figures):
            number = self.figures - len(figures) + k + 1
            self._wrapped(below, 1 + k * half, (k + 1) * half, f"Fig. {number}. {figure.caption}", "quiet", 8)
        self.row = below + 1

    def _filled(self) -> float:
        """Height of the rows since the last page that was begun [points]."""
        first = self.sheet.row_breaks.brk[-1].id + 1 if self.sheet.row_breaks.brk else 1
        known = self.sheet.row_dimensions
        heights = (known[row].height if row in known else None for row in range(first, self.row))
        return sum(height or ROW_HEIGHT for height in heights)

    def _columns(self, xs, ys, head: str) -> tuple[Reference, Reference]:
        """Data of a curve in two new columns, its name above them."""
        x, y = self.data, self.data + 1
        self.data += 2
        text(self.sheet, 1, y, head, size=8, color=QUIET)
        for n, (a, b) in enumerate(zip(xs, ys, strict=True), start=2):
            self.sheet.cell(n, x, float(a))
            if b is not None:
                self.sheet.cell(n, y, float(b))
        last = 1 + len(xs)
        return (
            Reference(self.sheet, min_col=x, min_row=2, max_row=last),
            Reference(self.sheet, min_col=y, min_row=1, max_row=last),
        )

    def _series(self, chart, curve) -> None:
        xs, ys = self._columns(curve.x, curve.y, curve.name or "–")
        series = Series(ys, xs, title_from_data=True)
        series.smooth = False
        line = series.graphicalProperties.line
        if curve.shape == "points":
            series.marker.symbol, series.marker.size = "circle", 6
            series.marker.graphicalProperties.solidFill = COLORS[curve.color]
            line.noFill = True
        else:
            series.marker.symbol = "none"
            line.solidFill, line.width = COLORS[curve.color], int(11000 * curve.width)
            if curve.shape == "dash":
                line.dashStyle = "dash"
        chart.series.append(series)

    def _chart(self, figure: Figure):
        """A native chart with axes."""
        if figure.names:
            return self._bars(figure)
        chart = new_chart("", figure.x, figure.y, *FIGURE_CM)
        chart.title = None
        for curve in figure.curves:
            self._series(chart, curve)
        self._legend(chart, figure.curves)
        for axis, ends in ((chart.x_axis, figure.x_range), (chart.y_axis, figure.y_range)):
            if ends:
                axis.scaling.min, axis.scaling.max = ends[0], _rounded(ends[1])
        if figure.y_range and figure.y_range[0] < 0.0:
            chart.y_axis.scaling.min = -_rounded(-figure.y_range[0])
        chart.x_axis.tickLblPos = "low"
        return chart

    def _legend(self, chart, curves) -> None:
        """No entry for a curve without a name."""
        from openpyxl.chart.legend import LegendEntry

        chart.legend.position = "t"
        chart.legend.legendEntry = [LegendEntry(idx=k, delete=True) for k, curve in enumerate(curves) if not curve.name]

    def _bars(self, figure: Figure):
        """Bars by name, with the lines across them."""
        count = len(figure.names)
        column = self.data
        self.data += 1
        for n, name in enumerate(figure.names, start=2):
            text(self.sheet, n, column, name, size=8, color=QUIET)
        names = Reference(self.sheet, min_col=column, min_row=2, max_row=1 + count)
        bars, lines = BarChart(), LineChart()
        bars.type, bars.style, bars.gapWidth, bars.overlap = "col", 13, 50, 100
        for curve in figure.curves:
            if curve.shape == "bars":
                heights = dict(zip(curve.x, curve.y, strict=True))
                values = [heights.get(k) for k in range(count)]
            else:
                values = [curve.y[0]] * count
            _, ys = self._columns(range(count), values, curve.name)
            chart = bars if curve.shape == "bars" else lines
            chart.add_data(ys, titles_from_data=True)
            look = chart.series[-1].graphicalProperties
            if curve.shape == "bars":
                look.solidFill = COLORS[curve.color]
            else:
                chart.series[-1].marker.symbol, chart.series[-1].smooth = "none", False
                look.line.solidFill, look.line.width = COLORS[curve.color], 16000
        bars.set_categories(names)
        bars += lines
        bars.title = None
        bars.x_axis.delete = bars.y_axis.delete = False
        bars.y_axis.title, bars.x_axis.title = figure.y, None
        bars.y_axis.majorGridlines = None
        bars.y_axis.scaling.min, bars.y_axis.scaling.max = figure.y_range
        bars.legend.position = "t"
        bars.width, bars.height = FIGURE_CM
        return bars

    def _drawing(self, figure: Figure):
        """A chart to scale, without axes; words as labels of points."""
        chart = ScatterChart()
        chart.style, chart.legend, chart.title = 13, None, None
        chart.width, chart.height = FIGURE_CM
        for curve in figure.curves:
            self._series(chart, curve)
        for label in figure.labels:
            xs, ys = self._columns((label.x,), (label.y,), label.text)
            series = Series(ys, xs, title_from_data=True)
            series.marker.symbol, series.smooth = "none", False
            series.graphicalProperties.line.noFill = True
            series.dLbls = DataLabelList()
            series.dLbls.showSerName, series.dLbls.position = True, "ctr"
            series.dLbls.showVal = series.dLbls.showCatName = series.dLbls.showLegendKey = False
            chart.series.append(series)
        chart.layout = Layout(
            ManualLayout(layoutTarget="inner", xMode="edge", yMode="edge", x=0.02, y=0.02, w=0.96, h=0.96)
        )
        (low, high), (left, right) = figure.y_range, figure.x_range
        per_cm = max((high - low) / FIGURE_CM[1], (right - left) / FIGURE_CM[0])
        for axis, middle, size in (
            (chart.x_axis, 0.5 * (left + right), FIGURE_CM[0]),
            (chart.y_axis, 0.5 * (low + high), FIGURE_CM[1]),
        ):
            axis.scaling.min, axis.scaling.max = (middle - 0.5 * per_cm * size, middle + 0.5 * per_cm * size)
            axis.delete, axis.majorGridlines = True, None
        return chart


def _shape(form: str) -> str:
    """The number format of a cell for ".3f", "g" or ""."""
    if form.endswith("f"):
        digits = int(form.strip(".f"))
        return "0." + "0" * digits if digits else "0"
    return "General"


def _rounded(value: float) -> float:
    """An end of an axis with two figures, not below the value."""
    if value <= 0.0:
        return value
    size = 10.0 ** math.floor(math.log10(value) - 1.0)
    return math.ceil(value / size) * size
