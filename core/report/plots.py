"""Sheets with native charts: q against SI, histories at collapse, survival map."""

import math

import numpy as np
from openpyxl.chart import Reference, ScatterChart, Series
from openpyxl.chart.shapes import GraphicalProperties
from openpyxl.chart.text import RichText, Text
from openpyxl.chart.title import Title
from openpyxl.drawing.line import LineProperties
from openpyxl.drawing.text import CharacterProperties, Paragraph, ParagraphProperties, RegularTextRun
from openpyxl.formatting.rule import ColorScaleRule
from openpyxl.utils import get_column_letter

from core.capacity.closed_forms import closed_form_q_eff, effective_q
from core.capacity.scale_free_law import law_of, loss_ratio, within
from core.report.cells import (
    ACCENT,
    BAD,
    GOOD,
    QUIET,
    RATIO,
    ROW_HEIGHT,
    Book,
    header,
    merge,
    number,
    paragraph,
    text,
    title,
)
from core.report.xml_text import escape_for_xml
from core.study.results import CollapseHistories, StudyResult, WallResult
from core.text.sentence import word
from core.units import CM

CM_PER_POINT = 2.54 / 72.0
CHART_WALLS = 20
ABREAST_FROM = 4
"""Charts from which two stand side by side."""
SINGLE_CHART, DOUBLE_CHART = (17.5, 9.0), (9.4, 6.3)
"""Sizes of a chart alone and beside another [cm]."""
CURVE_POINTS = 25
WIDE_SPREAD = 8.0
"""Ratio of the largest to the smallest q_eff from which a chart has logarithmic axes."""
HISTORY_POINTS = 1500
MAP_ROWS = 200
MAP_BIN = 0.02
"""Width of a column of the survival map in ln q."""

DATA_COLUMN = 16
"""First column of the data behind the charts, right of what is printed."""


def new_chart(heading: str, x: str, y: str, width=24.0, height=9.5) -> ScatterChart:
    """An empty scatter chart in the report's style; width, height [cm]."""
    heading, x, y = map(escape_for_xml, (heading, x, y))
    chart = ScatterChart()
    chart.style = 13
    font = CharacterProperties(sz=1100, b=True)
    chart.title = Title(
        tx=Text(
            rich=RichText(p=[Paragraph(pPr=ParagraphProperties(defRPr=font), r=[RegularTextRun(rPr=font, t=heading)])])
        ),
        overlay=False,
    )
    chart.x_axis.title, chart.y_axis.title = x, y
    chart.x_axis.delete = chart.y_axis.delete = False
    chart.x_axis.majorGridlines = None
    chart.y_axis.majorGridlines.spPr = GraphicalProperties(ln=LineProperties(solidFill="DDE3E8"))
    chart.x_axis.number_format = chart.y_axis.number_format = "General"
    chart.width, chart.height = width, height
    chart.legend.position = "b"
    return chart


def rows_below(height: float) -> int:
    """Rows that a chart of this height [cm] covers, and one of air."""
    return math.ceil(height / (ROW_HEIGHT * CM_PER_POINT)) + 1


def _placed(sheet, chart, index: int, count: int, row: int) -> int:
    """Put the chart of this index, of so many, onto the sheet; returns the row of the next."""
    if count < ABREAST_FROM:
        sheet.add_chart(chart, f"A{row}")
        return row + rows_below(chart.height)
    sheet.add_chart(chart, f"{'AF'[index % 2]}{row}")
    if index % 2 == 0 and index < count - 1:
        return row
    return row + rows_below(chart.height)


def add_series(chart, sheet, columns, rows, color, points=False, dash=None, width=19000) -> None:
    """Add one curve; columns (x, y), rows (first with the header of y, last)."""
    x = Reference(sheet, min_col=columns[0], min_row=rows[0] + 1, max_row=rows[1])
    y = Reference(sheet, min_col=columns[1], min_row=rows[0], max_row=rows[1])
    series = Series(y, x, title_from_data=True)
    series.smooth = False
    if points:
        series.marker.symbol, series.marker.size = "circle", 7
        series.marker.graphicalProperties.solidFill = color
        series.graphicalProperties.line.noFill = True
    else:
        series.marker.symbol = "none"
        series.graphicalProperties.line.solidFill = color
        series.graphicalProperties.line.width = width
        if dash:
            series.graphicalProperties.line.dashStyle = dash
    chart.series.append(series)


def q_against_si(book: Book, result: StudyResult) -> None:
    """q_eff against SI: points, fitted power law, Eq. 15/16 with +-20 %, one chart a wall."""
    say = book.say
    sheet = book.sheet("q against SI", [10] * 14)
    title(sheet, 1, say("Effective q against Housner intensity"))
    row = 3
    with_q = [wall for wall in result.walls if any(entry.q for entry in wall.per_record)]
    walls = [wall for wall in with_q if wall.wall.has_closed_forms]
    if len(walls) < len(with_q):
        note = say("Not drawn above the ground and with loads, where Eq. 15 and 16 do not hold.")
        row = paragraph(sheet, row, note, 10, 90, color=QUIET)
    if not with_q:
        text(sheet, row, 1, say("No run with a number of q."))
    drawn = walls[:CHART_WALLS]
    abreast = len(drawn) >= ABREAST_FROM
    for index, wall in enumerate(book.steps.each(drawn)):
        column = DATA_COLUMN + 8 * index
        last_point, last_curve = _si_data(book, sheet, wall, column)
        label = f"{book.titled(wall.name)} – {word(wall.mechanism, book.language)}"
        chart = new_chart(label, "SI [cm]", "q_eff [-]", *(DOUBLE_CHART if abreast else SINGLE_CHART))
        add_series(chart, sheet, (column, column + 1), (2, last_point), ACCENT, points=True)
        if wall.power_law:
            add_series(chart, sheet, (column + 2, column + 3), (2, last_curve), ACCENT)
        add_series(chart, sheet, (column + 2, column + 4), (2, last_curve), BAD)
        if wall.per_record and law_of(wall.kinematics.one_way, wall.law, "q"):
            add_series(chart, sheet, (column, column + 7), (2, last_point), GOOD, points=True)
            chart.series[-1].marker.symbol = "diamond"
        for k in (5, 6):
            add_series(chart, sheet, (column + 2, column + k), (2, last_curve), BAD, dash="dash", width=9500)
        known = [entry.q_eff for entry in wall.per_record if entry.q_eff]
        for axis in (chart.x_axis, chart.y_axis):
            if max(known) > WIDE_SPREAD * min(known):
                axis.scaling.logBase = 10
            else:
                axis.scaling.min = 0
        row = _placed(sheet, chart, index, len(drawn), row)
    if len(walls) > CHART_WALLS:
        names = ", ".join(book.titled(wall.name) for wall in walls[CHART_WALLS:])
        row = paragraph(sheet, row, say("Not drawn: ") + names, 10, 90)


def _si_data(book: Book, sheet, wall: WallResult, column: int) -> tuple[int, int]:
    """Points and curves behind one chart; returns their last rows."""
    form = "Eq. 16" if wall.kinematics.one_way else "Eq. 15"
    law = wall.power_law
    fit = f"C1 SI^C2 (R² {book.digits(law.r_squared, '.2f')})" if law else "–"
    text(sheet, 1, column, f"{book.titled(wall.name)} {word(wall.mechanism, book.language)}", color=QUIET)
    header(
        sheet,
        2,
        [
            "SI [cm]",
            book.say("time histories"),
            "SI [cm]",
            fit,
            form,
            f"{form} +20 %",
            f"{form} −20 %",
            book.say("Ribalta's law"),
        ],
        column,
        30,
    )
    scale_free = law_of(wall.kinematics.one_way, wall.law, "q")
    row = 2
    points = [entry for entry in wall.per_record if entry.q is not None]
    for entry in points:
        row += 1
        number(sheet, row, column, entry.intensity / CM, RATIO)
        number(sheet, row, column + 1, entry.q_eff, RATIO)
        ratio = loss_ratio(wall.block, wall.restitution)
        at = entry.scaled
        if scale_free and at is not None and within(scale_free, wall.mechanism, wall.block.p2, at, ratio):
            q = scale_free.q(at, ratio)
            number(sheet, row, column + 7, effective_q(float(q), entry.pga), RATIO)
    # the power law is drawn where the records are, no further
    first = min(entry.intensity for entry in points)
    last = max(entry.intensity for entry in points)
    places = np.geomspace(0.8 * first, 1.25 * last, CURVE_POINTS - 2)
    for k, si in enumerate(np.sort([*places, first, last])):
        q_eff = closed_form_q_eff(wall.block.slenderness, wall.block.height, float(si), wall.kinematics.one_way)
        number(sheet, 3 + k, column + 2, float(si) / CM, RATIO)
        if law and first <= si <= last:
            number(sheet, 3 + k, column + 3, law.q_eff(float(si)), RATIO)
        for m, factor in enumerate((1.0, 1.2, 0.8)):
            number(sheet, 3 + k, column + 4 + m, factor * q_eff, RATIO)
    return row, 2 + CURVE_POINTS


def histories(book: Book, result: StudyResult, drawn: list[CollapseHistories]) -> None:
    """theta/alpha of the governing record just below and just above first collapse."""
    say = book.say
    sheet = book.sheet("Histories", [10] * 14)
    title(sheet, 1, say("Rotation at first collapse"))
    row = 3
    abreast = len(drawn) >= ABREAST_FROM
    for index, entry in enumerate(book.steps.each(drawn[:CHART_WALLS])):
        column = DATA_COLUMN + 5 * index
        last = _history_data(book, sheet, entry, column)
        sign = "+" if entry.polarity > 0 else "−"
        kind = word(entry.wall.mechanism, book.language)
        label = f"{book.titled(entry.wall.name)} – {kind}: {entry.motion.name} ({sign})"
        chart = new_chart(label, "t [s]", "θ/θc [-]", *(DOUBLE_CHART if abreast else SINGLE_CHART))
        add_series(chart, sheet, (column, column + 1), (2, last[0]), GOOD, width=12000)
        add_series(chart, sheet, (column + 2, column + 3), (2, last[1]), BAD, width=12000)
        one_sided = entry.wall.kinematics.one_way
        chart.y_axis.scaling.min = -0.25 if one_sided else -1.5
        chart.y_axis.scaling.max = 1.5
        chart.x_axis.scaling.min = 0
        chart.x_axis.scaling.max = math.ceil(entry.motion.duration)
        chart.x_axis.tickLblPos = "low"
        row = _placed(sheet, chart, index, len(drawn[:CHART_WALLS]), row)
    shown = {id(entry.wall) for entry in drawn[:CHART_WALLS]}
    rest = [wall for wall in result.walls if id(wall) not in shown]
    if rest:
        names = ", ".join(f"{book.titled(wall.name)} ({word(wall.mechanism, book.language)})" for wall in rest)
        paragraph(sheet, row, say("Not drawn: ") + names, 10, 90)
        row += 2


def _history_data(book: Book, sheet, entry: CollapseHistories, column: int) -> tuple[int, int]:
    words = (book.say("survives"), book.say("collapses"))
    text(sheet, 1, column, book.titled(entry.wall.name), color=QUIET)
    last = []
    for k, (history, scale) in enumerate(zip(entry.histories, entry.scales, strict=True)):
        header(sheet, 2, ["t [s]", f"C = {book.digits(abs(scale), '.4f')} {words[k]}"], column + 2 * k, 30)
        ratio = history.rotation / entry.wall.model.collapse_rotation
        row = 2
        for sample in thinned(ratio, HISTORY_POINTS):
            row += 1
            sheet.cell(row, column + 2 * k, round(sample * entry.motion.time_step, 6))
            sheet.cell(row, column + 2 * k + 1, float(ratio[sample]))
        last.append(row)
    return last[0], last[1]


def thinned(values: np.ndarray, most: int) -> list[int]:
    """Samples to draw: at most this many, each the largest in modulus of its piece, and the last."""
    size = max(1, math.ceil(values.size / most))
    pieces = range(0, values.size, size)
    chosen = [start + int(np.argmax(np.abs(values[start : start + size]))) for start in pieces]
    return chosen if chosen[-1] == values.size - 1 else [*chosen, values.size - 1]


def survival_map(book: Book, result: StudyResult) -> None:
    """A row a run, a column 0.02 of ln q: share of collapsing grid points, white to red."""
    say = book.say
    sheet = book.sheet("Survival map", [20, 11, 22, 5], landscape=True)
    title(sheet, 1, say("Survival map"))
    paragraph(
        sheet,
        2,
        say(
            "White: the wall survives. Red: it collapses. Shades between: both occur within a column of 2 % in q. "
            "Grey: not analysed. A white field to the right of a red one is a wall that survives a stronger motion."
        ),
        60,
        170,
        color=QUIET,
    )
    runs = [(wall, run) for wall in result.walls for run in wall.runs]
    if not runs:
        text(sheet, 4, 1, say("No records."))
        return
    shares = [_binned(run.ida, result.search.q_step) for _, run in runs[:MAP_ROWS]]
    first = min(min(share) for share in shares)
    last = max(max(share) for share in shares)
    header(sheet, 4, [say("Wall"), say("Mechanism"), say("Record"), ""], 1, 18)
    for k in range(first, last + 1):
        sheet.column_dimensions[get_column_letter(5 + k - first)].width = 0.9
    for k in range(first, last + 1, 10):
        # the label stands over its ten columns
        merge(sheet, 4, 5 + k - first, 4, 14 + k - first)
        label = book.digits(math.exp(MAP_BIN * k), ".2f")
        text(sheet, 4, 5 + k - first, label, size=8, color=QUIET)
    rows = book.steps.each(zip(runs, shares, strict=False))
    for row, ((wall, run), share) in enumerate(rows, start=5):
        text(sheet, row, 1, book.titled(wall.name), size=7)
        text(sheet, row, 2, word(wall.mechanism, book.language), size=7)
        text(sheet, row, 3, run.record, size=7)
        text(sheet, row, 4, "+" if run.polarity > 0 else "−", align="center", size=7)
        sheet.row_dimensions[row].height = 8.8
        for k in range(first, last + 1):
            number(sheet, row, 5 + k - first, share.get(k, -1.0), ";;;")
    area = f"E5:{get_column_letter(5 + last - first)}{4 + len(shares)}"
    sheet.conditional_formatting.add(
        area,
        ColorScaleRule(
            start_type="num",
            start_value=-1,
            start_color="C9D1D9",
            mid_type="num",
            mid_value=0,
            mid_color="FFFFFF",
            end_type="num",
            end_value=1,
            end_color=BAD,
        ),
    )
    if len(runs) > MAP_ROWS:
        text(sheet, 6 + len(shares), 1, say("{n} more runs are in the JSON.", n=len(runs) - MAP_ROWS))
    sheet.freeze_panes = "E5"
    sheet.print_title_rows = "4:4"


def _binned(ida, q_step: float) -> dict[int, float]:
    """Share of collapsing points of a map by bin of ln q."""
    bins: dict[int, list[bool]] = {}
    start = math.log(ida.q_start)
    for k, digit in enumerate(ida.outcomes):
        log_q = start + (ida.first_index + k) * math.log1p(q_step)
        bins.setdefault(math.floor(log_q / MAP_BIN + 1e-9), []).append(digit == "1")
    return {k: sum(values) / len(values) for k, values in bins.items()}
