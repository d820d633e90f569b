"""The sheet How sure: what stands beside each verdict, never part of it."""

from openpyxl.chart import BarChart, Reference
from openpyxl.chart.shapes import GraphicalProperties

from core.known import require_value
from core.report import uncertainty_text
from core.report.cells import ACCENT, BAD, QUIET, RATIO, Book, header, heighten, number, paragraph, rule, text, title
from core.report.plots import DATA_COLUMN, rows_below
from core.report.xml_text import escape_for_xml
from core.study.results import StudyResult, WallVerdict

LAST_COLUMN, LINE_LETTERS = 8, 150
"""Columns of a sentence, and the letters they hold."""

MAX_CHARTS = 20
"""Walls whose chart is drawn."""


def certainty(book: Book, result: StudyResult) -> None:
    """Write the sheet: of every wall the interval of its records, the moves of its inputs, the rates of its limit
    states."""
    say = book.say
    sheet = book.sheet("How sure", [24, 32, 14, 32, 14, 12, 12, 14], landscape=True)
    title(sheet, 1, say("How sure each verdict is"))
    row = paragraph(
        sheet,
        2,
        say("Each input is moved on its own, the others stay. Beside the verdict, not part of it."),
        LAST_COLUMN,
        LINE_LETTERS,
        color=QUIET,
    )
    for n, verdict in enumerate(book.steps.each(result.verdicts)):
        row = _wall(book, sheet, result, verdict, n, row + 1)
    sheet.print_area = f"A1:H{row}"


def _wall(book: Book, sheet, result: StudyResult, verdict: WallVerdict, n: int, row: int) -> int:
    say, language = book.say, book.language
    zeta = book.digits(result.walls[verdict.governing].required_assessment.verdict.zeta_e, ".2f")
    title(sheet, row, f"{verdict.title}: ζ_E {zeta}", 12)
    row += 1
    if line := uncertainty_text.interval_line(say, verdict, language):
        row = paragraph(sheet, row, line, LAST_COLUMN, LINE_LETTERS)
    if verdict.sensitivity and verdict.sensitivity.swings:
        row = _moved(book, sheet, result, verdict, n, row)
    if verdict.rates:
        header(
            sheet, row, uncertainty_text.rate_heads(say, require_value(result.case.demand).nominal_life_years), 1, 30
        )
        for rate in verdict.rates:
            row += 1
            for column, cell in enumerate(uncertainty_text.rate_row(say, rate, language), start=1):
                text(sheet, row, column, cell, align="left" if column == 1 else "right")
            rule(sheet, row, 1, LAST_COLUMN)
        row += 1
        for line in uncertainty_text.rate_lines(say, result, verdict.rates):
            row = paragraph(sheet, row, line, LAST_COLUMN, LINE_LETTERS, color=QUIET)
    return row


def _moved(book: Book, sheet, result: StudyResult, verdict: WallVerdict, n: int, row: int) -> int:
    """The moves, the largest first, with their chart; what zeta required asks for."""
    say, language, sensitivity = book.say, book.language, require_value(verdict.sensitivity)
    header(sheet, row, [say("Input"), say("moved to"), "ζ_E", say("moved to"), "ζ_E"], 1, 18)
    first, rows = row + 1, uncertainty_text.moved_rows(sensitivity, language)
    data = DATA_COLUMN + 4 * n
    for column, name in enumerate((say("lowest"), say("highest")), start=1):
        text(sheet, row, data + column, name, size=8)
    for swing, moved in zip(sensitivity.swings, rows, strict=True):
        row += 1
        text(sheet, row, 1, moved.name, vertical="top")
        for k, (said, zeta, sure) in enumerate(moved.ends):
            text(sheet, row, 2 + 2 * k, said, wrap=True)
            number(sheet, row, 3 + 2 * k, zeta, RATIO, vertical="top", **({} if sure else {"color": BAD}))
        heighten(sheet, row, *((said, 42) for said, _, _ in moved.ends))
        rule(sheet, row, 1, 5)
        zetas = [sensitivity.base or 0.0, *(0.0 if end.zeta is None else end.zeta for end in swing.ends)]
        text(sheet, row, data, moved.name, size=8)
        sheet.cell(row, data + 1, min(zetas) - zetas[0])
        sheet.cell(row, data + 2, max(zetas) - zetas[0])
    if n < MAX_CHARTS:
        chart = _chart(sheet, say("Δζ_E of each input moved on its own"), data, first, row)
        sheet.add_chart(chart, f"A{row + 2}")
        row += 2 + rows_below(chart.height)
    for line in uncertainty_text.sensitivity_remarks(say, result, verdict, language):
        row = paragraph(sheet, row + 1, line, LAST_COLUMN, LINE_LETTERS, color=QUIET) - 1
    row += 1
    if labels := uncertainty_text.reach_labels(sensitivity):
        heads = [say("For the ζ required"), say("now"), *uncertainty_text.check_names(result, labels, language)]
        header(sheet, row, heads, 1, 30)
        for one in sensitivity.reach:
            row += 1
            for column, cell in enumerate(uncertainty_text.reach_row(say, one, labels, language), start=1):
                text(sheet, row, column, cell, align="left" if column == 1 else "right")
            rule(sheet, row, 1, 2 + len(labels))
        row += 1
    return row + 1


def _chart(sheet, heading: str, data: int, first: int, last: int) -> BarChart:
    """Bars from zeta as it is, down and up."""
    chart = BarChart()
    chart.type, chart.grouping, chart.overlap, chart.gapWidth = "bar", "clustered", 100, 40
    chart.title = escape_for_xml(heading)
    chart.style, chart.height, chart.width = 10, 2.2 + 0.75 * (last - first + 1), 17.5
    chart.add_data(
        Reference(sheet, min_col=data + 1, max_col=data + 2, min_row=first - 1, max_row=last), titles_from_data=True
    )
    chart.set_categories(Reference(sheet, min_col=data, min_row=first, max_row=last))
    for series, color in zip(chart.series, (BAD, ACCENT), strict=True):
        series.graphicalProperties = GraphicalProperties(solidFill=color)
    chart.x_axis.scaling.orientation = "maxMin"  # the first on top
    chart.x_axis.delete = chart.y_axis.delete = False
    chart.x_axis.tickLblPos = "low"
    chart.y_axis.number_format = "0.00"
    chart.legend.position = "b"
    return chart
