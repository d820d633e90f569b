"""Sheets of the demand: the dynamic check record by record, and the compatibility of the records."""

import math

from openpyxl.chart import ScatterChart
from openpyxl.chart.legend import LegendEntry

from core.codes.multiplier_search import MULTIPLIER_STEP
from core.known import require_value
from core.report.cells import (
    ACCELERATION,
    ACCENT,
    BAD,
    EXACT,
    GOOD,
    INK,
    QUIET,
    RATIO,
    Book,
    header,
    heighten,
    number,
    paragraph,
    rule,
    style,
    text,
    title,
)
from core.report.plots import DATA_COLUMN, add_series, new_chart
from core.report.record_tables import rules_of_codes
from core.report.sheet_table import write_table
from core.report.uncertainty_text import interval_line, verdict_of
from core.study.results import StudyResult, WallResult
from core.text.sentence import word
from core.units import G

DRAWN_SPECTRA = 30


def dynamic_check(book: Book, result: StudyResult) -> None:
    """C8.7.1.2.1.9, one block a wall: peaks by record and sign, the rule as live formulas."""
    say = book.say
    widths = [34, 12, 12, 12, 13, 13, 14]
    sheet = book.sheet("Dynamic check", widths)
    title(sheet, 1, say("Dynamic check, Circolare 7/2019 C8.7.1.2.1.9"))
    walls = [wall for wall in result.walls if wall.assessment and wall.required_assessment.dynamic]
    if not walls:
        text(sheet, 3, 1, say("Not made: it needs records, a demand at SLV or SLC, and a wall on the ground."))
        return
    row = paragraph(
        sheet,
        2,
        say(
            "The rule: θc is exceeded in no run and the set of the largest rotations, of each "
            "record its worse sign, stays within the limit: mean from 7 stations, else the largest. FC "
            "divides the strength of the wall (clause .3) or multiplies the demand, as said below. "
            "Whether the rule holds is not monotone in the multiplier: ζ_E is the lowest multiplier of "
            "the demand at which half of those within ±10 % of it fail, ζ_16 that at which 16 % do. "
            "Verified: the rule holds at the demand itself and ζ_E reaches what is required. Steps of "
            "{STEP:.2%}; another grid would give a ζ_E within the spread printed.",
            STEP=MULTIPLIER_STEP,
        ),
        7,
        105,
        color=QUIET,
    )
    for wall in book.steps.each(walls):
        row = _wall(book, sheet, wall, wall.required_assessment.dynamic, row + 1)
        verdict = verdict_of(result, wall)
        line = interval_line(say, verdict, book.language) if verdict else ""
        row = paragraph(sheet, row, line, 7, 105, color=QUIET) if line else row


def _wall(book: Book, sheet, wall: WallResult, check, row: int) -> int:
    say = book.say
    label = f"{book.titled(wall.name)} – {word(wall.mechanism, book.language)}"
    header(
        sheet,
        row,
        [label, say("Factor"), "θmax/θc (+)", "θmax/θc (−)", say("worse"), say("program"), say("Status")],
        1,
        32 if len(label) > 30 else 18,
    )
    last = _peaks(book, sheet, check, row)
    row = _rule(book, sheet, check, row + 1, last)
    row = _multipliers(book, sheet, check, row)
    rule(sheet, row, 1, 7)
    return row + 1


def _peaks(book: Book, sheet, check, row: int) -> int:
    """A row for each record below this one, with the peaks of both signs; returns the last."""
    for motion in dict.fromkeys(run.motion for run in check.runs):
        row += 1
        runs = {run.polarity: run for run in check.runs if run.motion == motion}
        record = next(iter(runs.values())).record
        text(sheet, row, 1, record, wrap=True)
        heighten(sheet, row, (record, 34))
        number(sheet, row, 2, next(iter(runs.values())).factor, ACCELERATION)
        for column, sign in ((3, 1), (4, -1)):
            if sign in runs:
                run = runs[sign]
                if run.peak_ratio is None:
                    shown = word(run.status, book.language)
                    text(sheet, row, column, shown, color=BAD, align="right")
                else:
                    number(sheet, row, column, run.peak_ratio, ACCELERATION, color=BAD if run.exceeded else INK)
        peaks = [run.peak_ratio for run in runs.values()]
        if None not in peaks:
            book.formula(sheet.cell(row, 5), f"=MAX(C{row}:D{row})", max(peaks), ACCELERATION)
            number(sheet, row, 6, max(peaks), ACCELERATION, color=QUIET)
        status = next((run.status for run in runs.values() if run.status != "stable"), "stable")
        text(sheet, row, 7, word(status, book.language), color=INK if status == "stable" else BAD, align="center")
        rule(sheet, row, 1, 7)
    return row


def _rule(book: Book, sheet, check, first: int, last: int) -> int:
    """The rule over the peaks in rows first to last, as formulas below them; returns its last row."""
    say, overturns = book.say, word("overturned", book.language)
    row = last + 1
    text(sheet, row, 1, say("runs in which θc is exceeded"))
    area = f"C{first}:D{last}"
    book.formula(
        sheet.cell(row, 5), f'=COUNTIF({area},">1")+COUNTIF({area},"{overturns}")', float(check.n_exceeded), "0"
    )
    number(sheet, row, 6, check.n_exceeded, "0", color=QUIET)
    row += 1
    text(sheet, row, 1, f"{word(check.set_rule, book.language)} θmax/θc")
    if check.peak_ratio is not None:
        formula = "AVERAGE" if check.set_rule == "mean" else "MAX"
        book.formula(sheet.cell(row, 5), f"={formula}(E{first}:E{last})", check.peak_ratio, ACCELERATION)
        number(sheet, row, 6, check.peak_ratio, ACCELERATION, color=QUIET)
    else:
        text(sheet, row, 5, overturns, color=BAD, align="right")
    row += 1
    text(sheet, row, 1, say("limit {limit_state}", limit_state=check.limit_state))
    number(sheet, row, 5, check.limit_ratio, RATIO)
    row += 1
    text(sheet, row, 1, say("rule at the demand"))
    yes, no = word("passed", book.language), word("not_passed", book.language)
    cell = book.formula(
        sheet.cell(row, 5),
        f'=IF(AND(E{row - 3}=0,ISNUMBER(E{row - 2}),N(E{row - 2})<=E{row - 1}),"{yes}","{no}")',
        yes if check.holds else no,
    )
    style(cell, bold=True, color=GOOD if check.holds else BAD, align="right")
    return row


def _multipliers(book: Book, sheet, check, row: int) -> int:
    """Multipliers of the demand at which the rule fails, below this row; returns the last."""
    say = book.say
    on = word(f"confidence_{check.confidence_on}", book.language)
    low, high = check.zeta_spread or (None, None)
    rows = [
        (f"ζ_E, {on}", check.zeta, EXACT),
        (say("spread of ζ_E, from"), low, EXACT),
        (say("spread of ζ_E, to"), high, EXACT),
        ("ζ_16", check.zeta_16, EXACT),
        (say("ζ of the first failure on the grid"), check.zeta_first, EXACT),
        (say("share failing within ±10 % of the demand"), check.share_failing_at_demand, "0%"),
    ]
    if check.zeta_other:
        on = word(f"confidence_{check.zeta_other.confidence_on}", book.language)
        rows.insert(1, (f"ζ_E, {on}", check.zeta_other.zeta, EXACT))
    for n, (label, value, shape) in enumerate(rows):
        row += 1
        text(sheet, row, 1, label, bold=n == 0)
        number(sheet, row, 5, value, shape, bold=n == 0)
    return row


def spectral_compatibility(book: Book, result: StudyResult) -> None:
    """The rules of the codes one by one, and the spectra."""
    say, compliance = book.say, result.compliance
    widths = [40, 30, 13, 13, 8, 15, 12, 12, 12]
    sheet = book.sheet("Spectral compatibility", widths, landscape=True)
    title(sheet, 1, say("Compatibility of the records with the target spectrum"))
    if compliance is None:
        text(sheet, 3, 1, say("Not shown: it needs records and a target spectrum, from a code or a file."))
        return
    target = result.demand_required.target
    name = target.name if target else ""
    verdict = say("The set is compatible") if compliance.compatible else say("The set is not compatible")
    text(sheet, 2, 1, f"{verdict}: {name}", bold=True, color=GOOD if compliance.compatible else BAD)
    row = write_table(book, sheet, 4, rules_of_codes(book), compliance.rules)
    low, high = compliance.period_range
    row = paragraph(
        sheet,
        row + 2,
        say(
            "A rigid block has no period T1: the rules are applied from {low:.2f} to {high:.2f} s, "
            "with natural records up to the longest T_SLV or T_SLC of the walls. Records at the "
            "demand, FC apart. Peaks between samples are seen.",
            low=low,
            high=high,
        ),
        9,
        140,
        color=QUIET,
    )
    chart = _spectra(book, sheet, result)
    sheet.add_chart(chart, f"A{row + 1}")


def _spectra(book: Book, sheet, result: StudyResult) -> ScatterChart:
    compliance, say = require_value(result.compliance), book.say
    text(sheet, 2, DATA_COLUMN, "T [s]", size=8)
    names = [say("target"), say("mean"), *(motion.name for motion in result.motions[:DRAWN_SPECTRA])]
    curves = [compliance.target, compliance.mean, *compliance.spectra[:DRAWN_SPECTRA]]
    for k, label in enumerate(names):
        text(sheet, 2, DATA_COLUMN + 1 + k, label, size=8)
    for n, period in enumerate(compliance.periods):
        sheet.cell(3 + n, DATA_COLUMN, float(period))
        for k, curve in enumerate(curves):
            sheet.cell(3 + n, DATA_COLUMN + 1 + k, float(curve[n]) / G)
    chart = new_chart(say("5 % acceleration spectra"), "T [s]", "S_a [g]", 24.0, 10.0)
    last = 2 + compliance.periods.size
    for k in range(len(curves) - 1, -1, -1):
        color, width = ((BAD, 25000), (ACCENT, 25000))[k] if k < 2 else ("B8C2CC", 6000)
        add_series(chart, sheet, (DATA_COLUMN, DATA_COLUMN + 1 + k), (2, last), color, width=width)
    chart.x_axis.scaling.min, chart.x_axis.scaling.max = (0, math.ceil(2.0 * compliance.periods[-1]) / 2.0)
    chart.y_axis.scaling.min = 0
    records = range(len(curves) - 2)  # drawn first, alike in grey: the legend names mean and target
    chart.legend.legendEntry = [LegendEntry(idx=k, delete=True) for k in records]
    return chart
