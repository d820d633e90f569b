"""Summary: the page an engineer signs, and the overview of all walls."""

import math

from openpyxl.chart import BarChart, LineChart, Reference, ScatterChart, Series
from openpyxl.chart.layout import Layout, ManualLayout

from core.codes.eq9 import LABEL
from core.report.cells import (
    ACCELERATION,
    ACCENT,
    BAD,
    GOOD,
    INK,
    QUIET,
    RATIO,
    Book,
    frame,
    header,
    heighten,
    number,
    paragraph,
    rule,
    style,
    text,
    title,
)  # fmt: skip
from core.study.results import Q_SOURCES, StudyResult, WallResult
from core.text.sentence import localized, word
from core.text.words import ASSUMPTIONS
from core.units import CM, G
from core.version import NAME, VERSION

SUMMARY_WALLS = 8
"""Walls listed on the Summary, which is one page; all are on the Overview."""

WIDTHS = [30, 12, 8, 9, 9, 7, 8, 14, 9, 8, 9, 9, 26]
LAST = len(WIDTHS)
AMBER = "8A5A00"
COLORS = {"verified": GOOD, "not_activated": GOOD, "verified_refined": AMBER, "indicative": AMBER,
          "undetermined": AMBER, "q2_unsafe": BAD, "not_verified": BAD}  # fmt: skip
DATA = 20
"""First column of the data behind the charts, right of what is printed."""


def by_zeta(walls) -> list[WallResult]:
    """Walls without a zeta first, then the lowest."""

    def key(wall: WallResult) -> float:
        zeta = wall.assessment.verdict.zeta_e if wall.assessment else None
        return -math.inf if zeta is None else zeta

    return sorted(walls, key=key)


def verdict_color(result: StudyResult, wall: WallResult) -> str:
    """Green only where nothing is left to read: a warning or a reason turns it amber."""
    if wall.assessment is None:
        return INK
    color = COLORS[wall.assessment.verdict.code]
    return AMBER if color == GOOD and result.left_to_read(wall) else color


def summary(book: Book, result: StudyResult) -> None:
    """One A4 page: title block, demand, walls, the governing wall's checks, verdict, signature."""
    say, report, case = book.say, result.case.report, result.case
    sheet = book.sheet("Summary", WIDTHS, landscape=True)
    sheet.page_setup.fitToHeight = 1
    title(sheet, 1, case.title, 16)
    paragraph(
        sheet,
        2,
        say(
            "Out-of-plane overturning of masonry walls: rocking analysis, force reduction factor q "
            "(Coccia, Di Carlo, Imperatore 2016) and checks of the Circolare 7/2019, C8.7.1.2.1"
        ),
        LAST,
        160,
        color=QUIET,
    )
    row = _title_block(book, sheet, result, report, 3)
    row = _demand_lines(book, sheet, result, row, LAST)
    ordered = by_zeta(result.walls)
    row = _walls_table(book, sheet, result, ordered[:SUMMARY_WALLS], row + 1)
    if len(ordered) > SUMMARY_WALLS:
        row = paragraph(
            sheet,
            row,
            say(
                "The {SUMMARY_WALLS} lowest of {n} walls; all on the sheet Overview.",
                SUMMARY_WALLS=SUMMARY_WALLS,
                n=len(ordered),
            ),
            LAST,
            150,
            color=QUIET,
        )
    if ordered[0].assessment:
        row = _governing(book, sheet, result, ordered[0], row + 1)
    row = _warnings(book, sheet, result, row + 1, LAST)
    _signature(book, sheet, row + 1, all(wall.wall.unloaded_confirmed for wall in result.walls))
    sheet.print_area = f"A1:M{sheet.max_row}"


def overview(book: Book, result: StudyResult) -> None:
    """All walls, the lowest zeta first."""
    sheet = book.sheet("Overview", WIDTHS, landscape=True)
    title(sheet, 1, book.say("Overview of the walls"))
    last = _walls_table(book, sheet, result, by_zeta(result.walls), 3)
    sheet.auto_filter.ref = f"A3:M{last - 1}"
    sheet.freeze_panes = "B4"
    sheet.print_title_rows = "3:3"


def _title_block(book: Book, sheet, result: StudyResult, report, row: int) -> int:
    """Labels and values in two columns."""
    say, asked = book.say, result.case.demand
    started = result.started_utc[:16].replace("T", " ")
    block = [
        (say('Client'), report.client), (say('Site'), report.site),
        (say('Project'), report.project), (say('Author'), report.author),
        (say('Revision'), report.revision), (say('Date'), report.date),
        (say('Program'), f"{NAME} {VERSION}, {started} UTC"),
    ]  # fmt: skip
    if asked:
        life = [
            f"{label} {value:g}" for label, value in (
                ("V_N", asked.nominal_life_years), ("C_U", asked.use_class_factor),
                ("T_R", asked.return_period and round(asked.return_period))) if value is not None
        ]  # fmt: skip
        place = ", ".join(part for part in (asked.site, asked.coordinates, *life) if part)
        block.append((say("Seismic site"), place))
    block = [(label, value) for label, value in block if value]
    for k, (label, value) in enumerate(block):
        column = 1 if k % 2 == 0 else 7
        text(sheet, row + k // 2, column, label, color=QUIET)
        text(sheet, row + k // 2, column + (1 if column == 1 else 2), value)
    return row + (len(block) + 1) // 2 + 1


def _demand_lines(book: Book, sheet, result: StudyResult, row: int, last: int) -> int:
    demand, say = result.demand, book.say
    if demand is None:
        line = say("No demand given: no check.")
        return paragraph(sheet, row, line, last, 150, bold=True)
    line = (
        f"{say('Demand')} {demand.limit_state}: a_g {demand.ag / G:.3f} g "
        f"({say('on rock, S apart')}), S {demand.soil_factor:.3f}, "
        f"S a_g {demand.pga / G:.3f} g, {word(f'confidence_{demand.confidence_on}', book.language)} "
        f"{demand.confidence_factor:.2f}"
    )
    if demand.target:
        line += f", {demand.target.name}"
    if demand.intensity:
        source = {
            "given": say('given'), "spectrum": say('of the spectrum'),
            "records_scaled": say('from the records'),
        }[demand.intensity_source]  # fmt: skip
        line += f", SI {demand.intensity / CM:.1f} cm ({source})"
    return paragraph(sheet, row, line, last, 150, bold=True)


def _walls_table(book: Book, sheet, result: StudyResult, walls: list[WallResult], row: int) -> int:
    say = book.say
    header(sheet, row, [
        say('Wall'), say('Mechanism'), "H [m]", "t [m]", "u [m]", "H/t",
        "α [°]", "a_RM [g]", "W [kN]", "q", say('q robust'), "ζ",
        say('Verdict')])  # fmt: skip
    for wall in walls:
        row += 1
        text(sheet, row, 1, wall.name, wrap=True)
        text(sheet, row, 2, word(wall.mechanism, book.language))
        verdict = wall.assessment.verdict if wall.assessment else None
        label = word(verdict.code, book.language) if verdict else "–"
        heighten(sheet, row, (wall.name, 24), (label, 26))
        weight = wall.wall.weight
        setback = wall.wall.setback if wall.wall.height_m else None
        for column, value, shape in (
            (3, wall.height, RATIO), (4, wall.thickness, RATIO), (5, setback, ACCELERATION),
            (6, wall.height / wall.thickness, "0.0"),
            (7, math.degrees(wall.block.slenderness), RATIO),
            (8, wall.block.threshold_acceleration / G, ACCELERATION),
            (9, weight / 1000.0 if weight else None, "0.0"), (10, wall.q_set, RATIO),
            (11, wall.q_robust_set, RATIO),
        ):  # fmt: skip
            number(sheet, row, column, value, shape)
        color = verdict_color(result, wall)
        number(sheet, row, 12, verdict.zeta_e if verdict else None, RATIO, bold=True, color=color)
        text(sheet, row, 13, label, bold=True, color=color, wrap=True)
        rule(sheet, row, 1, LAST)
    return row + 1


def _governing(book: Book, sheet, result: StudyResult, wall: WallResult, row: int) -> int:
    """The wall with the lowest zeta: table of methods, sketch, peaks, verdict."""
    say, assessment = book.say, wall.assessment
    label = f"{wall.name} – {word(wall.mechanism, book.language)}"
    title(sheet, row, label, 12)
    if assessment.kinematic:
        text(sheet, row, 5, _mechanism_line(book, assessment.kinematic), color=QUIET)
    top = row + 1
    header(sheet, top, [
        say('Method'), say('Clause'), "q", say('Capacity'),
        say('Demand'), say('Unit'), "ζ", say('Outcome')], 1, 18)  # fmt: skip
    row = top
    for check, decides in assessment.shown:
        row += 1
        values = (check.q, check.capacity, check.demand, check.unit, check.zeta, check.passed)
        label = word(check.label, book.language)
        _method_row(
            book, sheet, row, label, check.clause, values, decides, check.name == "floor_sld"
        )
    for source, check in zip(Q_SOURCES, wall.code_check, strict=False):
        if check:
            row += 1
            values = (check.q, check.capacity / G, check.demand / G, "g", check.ratio, check.passed)
            _method_row(book, sheet, row, word(source, book.language), LABEL, values, False)
    if wall.wall.height_m:
        _sketch(book, sheet, wall, f"I{top}")
    if assessment.dynamic:
        _peaks(book, sheet, assessment.dynamic, f"K{top}", 10.4, 6.2)
    row = max(row, top + 11) + 1
    verdict = assessment.verdict
    row = paragraph(sheet, row, verdict.text(book.language), LAST, 120, bold=True, size=12,
                    color=verdict_color(result, wall))  # fmt: skip
    for reason in verdict.reasons:
        row = paragraph(sheet, row, f"• {reason.text(book.language)}", LAST, 150)
    if verdict.lower_bound is not None:
        row = paragraph(
            sheet,
            row,
            say(
                "Should the restraint behind fail, the wall rocks on both sides: zeta {lower_bound:.2f}.",
                lower_bound=verdict.lower_bound,
            ),
            LAST,
            150,
        )
    return row


def _mechanism_line(book: Book, assessment) -> str:
    """Quantities of the mechanism in one line."""
    say = book.say
    parts = [
        f"α0 {assessment.alpha0:.4f}",
        f"e* {assessment.e_star:.0f}",
        f"a0* {assessment.a0 / G:.3f} g",
    ]
    if assessment.m_star is not None:
        parts.append(f"M* {assessment.m_star:.0f} kg/m")
    if assessment.free_element:
        parts.append(say("free to vibrate"))
        if assessment.period_0 is not None:
            parts.append(f"T_0 {assessment.period_0:.3f} s")
    else:
        parts.append(say("restrained by transverse walls"))
    if assessment.zeta_sld is not None:
        parts.append(f"a_g,SLD/a_g {assessment.zeta_sld:.2f}")
    return ", ".join(parts)


def _method_row(
    book: Book, sheet, row: int, label: str, clause: str, values, decides: bool, no_outcome=False
) -> None:
    q, capacity, demand, unit, zeta, passed = values
    color = INK if decides else QUIET
    text(sheet, row, 1, label, color=color)
    text(sheet, row, 2, clause, color=QUIET, size=8)
    for column, value, shape in ((3, q, RATIO), (4, capacity, ACCELERATION), (5, demand, ACCELERATION),
                                 (7, zeta, RATIO)):  # fmt: skip
        number(sheet, row, column, value, shape, color=color, bold=decides and column == 7)
    text(sheet, row, 6, unit, color=QUIET, align="center")
    outcome = "no_number" if passed is None else "passed" if passed else "not_passed"
    if no_outcome:
        outcome = "shown"
    shade = QUIET if passed is None or not decides else GOOD if passed else BAD
    text(
        sheet,
        row,
        8,
        word(outcome, book.language),
        color=shade,
        bold=decides,
        size=9,
        align="center",
    )
    rule(sheet, row, 1, 8)


def _sketch(book: Book, sheet, wall: WallResult, anchor: str) -> None:
    """The wall to scale, its hinge and its ground, as a native chart."""
    h, t, u = wall.height, wall.thickness, wall.wall.setback
    outlines = (
        [(0.0, 0.0), (t, 0.0), (t, h), (0.0, h), (0.0, 0.0)],
        [(t - u, 0.0), (0.5 * t, 0.5 * h)],
        [(-0.35 * h, 0.0), (0.35 * h + t, 0.0)],
    )
    chart = ScatterChart()
    chart.style, chart.legend = 13, None
    chart.width, chart.height = 3.6, 6.2
    chart.title = None
    for k, (points, color) in enumerate(zip(outlines, (ACCENT, BAD, QUIET), strict=True)):
        column = DATA + 2 * k
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
    chart.layout = Layout(ManualLayout(layoutTarget="inner", xMode="edge", yMode="edge",
                                       x=0.05, y=0.05, w=0.9, h=0.9))  # fmt: skip
    tall = 1.06 * h
    wide = tall * (0.9 * chart.width) / (0.9 * chart.height)
    wide = max(wide, 1.2 * t)
    chart.y_axis.scaling.min, chart.y_axis.scaling.max = -0.03 * h, -0.03 * h + tall
    chart.x_axis.scaling.min, chart.x_axis.scaling.max = 0.5 * t - 0.5 * wide, 0.5 * t + 0.5 * wide
    chart.x_axis.delete = chart.y_axis.delete = True
    chart.x_axis.majorGridlines = chart.y_axis.majorGridlines = None
    sheet.add_chart(chart, anchor)


def _peaks(book: Book, sheet, check, anchor: str, width: float, height: float) -> None:
    """Peak rotation over alpha of each record at the demand, with lines at 0.40, 0.60 and 1.00."""
    say = book.say
    column = DATA + 8
    heads = [say("record"), "θmax/α", "0.40", "0.60", "1.00"]
    for k, head in enumerate(heads):
        text(sheet, 1, column + k, head, size=8, color=QUIET)
    for n, run in enumerate(check.runs, start=2):
        sign = (
            "" if len({r.polarity for r in check.runs}) == 1 else " +" if run.polarity > 0 else " −"
        )
        text(sheet, n, column, f"{run.record}{sign}", size=8, color=QUIET)
        # a wall that overturns has no peak: its bar fills the chart
        sheet.cell(n, column + 1, 1.2 if run.peak_ratio is None else min(run.peak_ratio, 1.2))
        for k, level in enumerate((0.40, 0.60, 1.00), start=2):
            sheet.cell(n, column + k, level)
    last = 1 + len(check.runs)
    bars = BarChart()
    bars.type, bars.style, bars.gapWidth = "col", 13, 60
    bars.add_data(
        Reference(sheet, min_col=column + 1, min_row=1, max_row=last), titles_from_data=True
    )
    bars.set_categories(Reference(sheet, min_col=column, min_row=2, max_row=last))
    bars.series[0].graphicalProperties.solidFill = ACCENT
    lines = LineChart()
    for k, color in zip((2, 3, 4), (GOOD, AMBER, BAD), strict=True):
        data = Reference(sheet, min_col=column + k, min_row=1, max_row=last)
        lines.add_data(data, titles_from_data=True)
        series = lines.series[-1]
        series.marker.symbol, series.smooth = "none", False
        series.graphicalProperties.line.solidFill = color
        series.graphicalProperties.line.width = 14000
    bars += lines
    bars.y_axis.scaling.min, bars.y_axis.scaling.max = 0, 1.2
    bars.y_axis.title, bars.x_axis.title = "θmax/α", None
    bars.x_axis.delete = bars.y_axis.delete = False
    bars.y_axis.majorGridlines = None
    bars.legend.position = "r"
    bars.width, bars.height = width, height
    sheet.add_chart(bars, anchor)


def _warnings(book: Book, sheet, result: StudyResult, row: int, last: int, most: int = 7) -> int:
    """Each warning once, with the walls or records it belongs to."""
    owners: dict[str, list[str]] = {}
    for owner in (*result.walls, *result.motions):
        for warning in owner.warnings:
            name = owner.name
            if isinstance(owner, WallResult):
                name += f" ({word(owner.mechanism, book.language)})"
            owners.setdefault(warning.text(book.language), []).append(name)
    for warning in result.demand.warnings if result.demand else ():
        owners.setdefault(warning.text(book.language), []).append(book.say("demand"))
    text(sheet, row, 1, book.say("Warnings"), bold=True)
    row += 1
    if not owners:
        text(sheet, row, 1, book.say("none"))
        row += 1
    for line, names in list(owners.items())[:most]:
        who = ", ".join(names[:4]) + (f" +{len(names) - 4}" if len(names) > 4 else "")
        row = paragraph(sheet, row, f"• {line}  [{who}]", last, 165)
    if len(owners) > most:
        row = paragraph(
            sheet,
            row,
            book.say("{n} more on the sheets Records and Check.", n=len(owners) - most),
            last,
            140,
        )
    return row


def _signature(book: Book, sheet, row: int, unloaded: bool) -> None:
    """Assumptions to tick, the judgement the engineer writes (NTC 2018 10.2), place for a signature.
    unloaded : every wall was confirmed to carry no load."""
    say = book.say
    text(sheet, row, 1, say('Assumptions confirmed by the engineer'),
         bold=True)  # fmt: skip
    text(sheet, row, 7, say('Reasoned judgement on the results (NTC 2018 10.2)'),
         bold=True)  # fmt: skip
    for n, code in enumerate(ASSUMPTIONS, start=1):
        ticked = unloaded and code == "no_load"
        assumption = localized("assumption", code, book.language)
        text(sheet, row + n, 1, f"{'☑' if ticked else '☐'}  {assumption}")
    last = row + len(ASSUMPTIONS)
    sheet.merge_cells(start_row=row + 1, start_column=7, end_row=last, end_column=LAST)
    for r in range(row + 1, last + 1):
        for c in range(7, LAST + 1):
            edges = {"left": c == 7, "right": c == LAST, "top": r == row + 1, "bottom": r == last}
            frame(sheet.cell(r, c), QUIET, *(side for side, here in edges.items() if here))
    style(sheet.cell(row + 1, 7), wrap=True)
    row = last + 2
    text(sheet, row, 1, say("Engineer"), color=QUIET)
    text(sheet, row, 7, say("Place and date"), color=QUIET)
    text(sheet, row, 11, say("Signature and stamp"), color=QUIET)
    for c in (2, 3, 4, 8, 9, 10, 12, 13):
        frame(sheet.cell(row, c), QUIET, "bottom")
