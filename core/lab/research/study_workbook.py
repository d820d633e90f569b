"""A parametric study as a workbook: claims, tables, figures as native charts on the data beside them."""

from openpyxl.utils import get_column_letter
from openpyxl.worksheet.pagebreak import Break

from core.lab.research.figures import DASHED, LINE_POINTS, POINTS, Figure, StudyReport, Table, marker_of
from core.lab.research.parametric import ParametricResult
from core.lab.research.study_files import PALETTE
from core.report.cells import QUIET, Book, header, heighten, number, paragraph, rule, text, title
from core.report.plots import add_series, new_chart
from core.report.steps import Steps
from core.version import NAME, VERSION, commit

TABLE_STEPS, CHART_STEPS, SAVING_STEPS = 15, 10, 25
"""Hundredths of the writing of a study that these take."""

CHART_ROWS = 22
CHARTS_PER_PAGE = 2
MAX_SERIES = 60
PAGE_ROWS = 40
"""Rows of a table that still fit a page."""
MARKERS = ("circle", "square", "triangle", "diamond")


def content(result: ParametricResult, report: StudyReport, steps: Steps | None = None) -> bytes:
    """The xlsx file of a study."""
    book = Book(result.study.language, steps or Steps())
    book.workbook.remove(book.workbook.active)
    _summary(book, result, report)
    book.steps.take(TABLE_STEPS)
    for table in book.steps.each(report.tables):
        if table.rows:
            _table(book, table)
    book.steps.take(CHART_STEPS)
    _figures(book, report.figures)
    book.steps.take(SAVING_STEPS)
    return book.content()


def _summary(book: Book, result: ParametricResult, report: StudyReport) -> None:
    say = book.say
    sheet = book.sheet("Study", [12, 58, 9, 9, 44], landscape=True)
    title(sheet, 1, report.title)
    row = 3
    for note in report.notes:
        row = paragraph(sheet, row, note, 5, 130)
    analyses = sum(entry.analyses for entry in result.rows)
    counted = say(
        "{runs} runs, {analyses} analyses, {motions} motions, {seconds:.0f} s",
        runs=len(result.rows),
        analyses=analyses,
        motions=len(result.motions),
        seconds=result.elapsed,
    )
    row = paragraph(sheet, row, counted, 5, 130, color=QUIET)
    row = paragraph(sheet, row, f"{NAME} {VERSION} {commit()[:12]}  sha256 {result.sha256}", 5, 130, color=QUIET) + 1
    if report.claims:
        header(sheet, row, [say("Source"), say("Claim of the paper"), say("holds in"), say("of"), say("What is found")])
        for claim in report.claims:
            row += 1
            text(sheet, row, 1, claim.source, wrap=True)
            text(sheet, row, 2, claim.claim, wrap=True)
            number(sheet, row, 3, claim.held, "0")
            number(sheet, row, 4, claim.tried, "0")
            text(sheet, row, 5, claim.found, wrap=True)
            heighten(sheet, row, (claim.claim, 58), (claim.found, 44))
            rule(sheet, row, 1, 5)
    sheet.print_area = f"A1:E{row}"


def _table(book: Book, table: Table) -> None:
    """A sheet for a table; numbers with three significant digits on screen, whole in the cell."""
    widths = [
        max(
            9.0,
            min(
                40.0, 1.15 * max(len(str(row[k])) for row in table.rows) if isinstance(table.rows[0][k], str) else 11.0
            ),
        )
        for k in range(len(table.head))
    ]
    sheet = book.named_sheet(table.key, widths, landscape=True)
    title(sheet, 1, table.title)
    header(sheet, 3, list(table.head), height=45)
    for k, row in enumerate(book.steps.each(table.rows), start=4):
        for column, value in enumerate(row, start=1):
            if value is None or isinstance(value, (int, float)):
                number(sheet, k, column, value, _format(value))
            else:
                text(sheet, k, column, value)
    last = 4 + len(table.rows)
    if table.note:
        paragraph(sheet, last + 1, table.note, len(table.head), int(1.1 * sum(widths)))
    sheet.freeze_panes = "A4"
    if len(table.rows) < PAGE_ROWS:
        sheet.page_setup.fitToHeight = 1
    sheet.print_title_rows = "3:3"
    sheet.print_area = f"A1:{get_column_letter(len(table.head))}{last + 1}"


def _format(value) -> str:
    if value is None or isinstance(value, int) or abs(value) >= 100.0:
        return "0"
    return "0.0" if abs(value) >= 10.0 else "0.00" if abs(value) >= 1.0 else "0.000"


def _figures(book: Book, figures: tuple[Figure, ...]) -> None:
    """The charts on one sheet, what they are drawn from on another."""
    sheet = book.sheet("Figures", [11] * 10)
    data = book.sheet("Figure data", [11] * 20)
    title(sheet, 1, book.say("Figures"))
    data.print_area = "A1:J40"
    row, column = 3, 1
    for index, figure in enumerate(book.steps.each(figures)):
        chart = new_chart(figure.title, figure.x, figure.y, 19.0, 10.2)
        text(data, 1, column, figure.title, color=QUIET)
        for index_of, series in enumerate(figure.series[:MAX_SERIES]):
            header(data, 2, [figure.x, series.name or figure.y], column, 30)
            for k, (x, y) in enumerate(zip(series.x, series.y, strict=True), start=3):
                number(data, k, column, x, "General")
                number(data, k, column + 1, y, "General")
            if series.x:
                _draw(chart, data, series, column, marker_of(figure, index_of))
            column += 2
        for axis, logarithmic in ((chart.x_axis, figure.log_x), (chart.y_axis, figure.log_y)):
            if logarithmic:
                axis.scaling.logBase = 10
        sheet.add_chart(chart, f"A{row}")
        row += CHART_ROWS - 1
        if figure.note:
            text(sheet, row, 1, figure.note, color=QUIET, size=9)
        row += 1
        if index % CHARTS_PER_PAGE == CHARTS_PER_PAGE - 1:
            sheet.row_breaks.append(Break(id=row - 1))
    sheet.print_area = f"A1:J{max(row, 22)}"


def _draw(chart, data, series, column: int, marker: int) -> None:
    """One series in its look; unnamed ones stay out of the legend."""
    color = PALETTE[series.color % len(PALETTE)].lstrip("#")
    rows = (2, 2 + len(series.x))
    dash = "dash" if series.look == DASHED else None
    add_series(chart, data, (column, column + 1), rows, color, series.look == POINTS, dash, 15000)
    drawn = chart.series[-1]
    if series.look in (POINTS, LINE_POINTS):
        drawn.marker.symbol, drawn.marker.size = MARKERS[marker % len(MARKERS)], 5
        drawn.marker.graphicalProperties.solidFill = color
        drawn.marker.graphicalProperties.line.solidFill = color
    if not series.name:
        from openpyxl.chart.legend import LegendEntry

        chart.legend.legendEntry.append(LegendEntry(idx=len(chart.series) - 1, delete=True))
