"""Check sheet: Eq. 2, 9, 10, 12, 13, 15, 16 as live formulas beside the program's own values."""

import math

from openpyxl.worksheet.worksheet import Worksheet

from core.codes.eq9 import TITLE
from core.derivation import closed_forms as eq
from core.derivation import wall as of_wall
from core.derivation.closed_forms import closed
from core.derivation.faces import formula
from core.derivation.geometry import geometry
from core.derivation.site import demand_section
from core.known import require_value
from core.report.cells import (
    ACCELERATION,
    BAD,
    GOOD,
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
from core.report.derived import Rows, cell_prefix
from core.report.place_lines import place_of, states_of
from core.report.rows import changed_cell, close_inputs, formula_row, heads
from core.report.sheet_table import write_table
from core.report.sheets import rule_word
from core.report.tie_words import tie_lines
from core.report.verdict_words import lines_of, sentence_of
from core.report.wall_tables import limit_states_of_site
from core.study.results import Q_SOURCES, RecordResult, StudyResult, WallResult
from core.text.sentence import word
from core.units import CM, G


class CheckSheet:
    """The sheet, made while the walls of a study finish: one block a wall, with its geometry, records, set, power law,
    closed forms, Eq. 9.

    result : of the study, whose walls need not be there
    """

    def __init__(self, book: Book, result: StudyResult):
        say, widths = book.say, [34, 13, 13, 13, 12, 11, 12, 16, 11, 11, 11, 11, 12]
        self.book, self.sheet = book, book.sheet("Check", widths)
        title(self.sheet, 1, say("Check of the equations"))
        paragraph(
            self.sheet,
            2,
            say(
                "Column C is a live formula of this sheet, column D the value of the program: they must "
                "agree. In the tables of records each pair stands side by side. Yellow cells may be changed."
            ),
            len(widths),
            150,
            color=QUIET,
        )
        changed_cell(book, self.sheet, 3, 1)
        self._demand, self._row = _demand(book, self.sheet, result, 4)
        self._first = self._row

    def add(self, result: StudyResult) -> None:
        """The next wall, see `StudyResult.by_wall`."""
        for wall in result.walls:
            self.book.steps.check()
            self._row = _wall(self.book, self.sheet, result, wall, self._demand, self._row + 1)
            self.book.rows_of(self.sheet).pack(self._first, self._row)

    def close(self) -> Worksheet:
        """The sheet, once all walls are there."""
        self.sheet.freeze_panes = "A4"
        close_inputs(self.book, self.sheet)
        return self.sheet


def _demand(book: Book, sheet, result: StudyResult, row: int) -> tuple[Rows, int]:
    row = heads(book, sheet, row, book.say("Demand"))
    rows = Rows(book, sheet, result)
    row = rows.write(demand_section(result), row)
    if result.demand is None:
        text(sheet, row, 1, book.say("No demand given: no check."))
        row += 1
    return rows, _place(book, sheet, result, row)


def _place(book: Book, sheet, result: StudyResult, row: int) -> int:
    """Write where the building stands, and the values of the limit states there; returns the next row."""
    site = result.case.site
    if site is None:
        return row
    for label, words in place_of(site, book.language):
        text(sheet, row, 1, label)
        text(sheet, row, 3, words)
        row += 1
    return write_table(book, sheet, row, limit_states_of_site(book), states_of(site)) + 1


def _wall(book: Book, sheet, result: StudyResult, wall: WallResult, demand: Rows, row: int) -> int:
    """Write the block of one wall: the body, q of the records and of the closed form, Eq. 9, the checks of the
    Circolare."""
    say, assessment = book.say, wall.assessment
    row = heads(book, sheet, row, f"{book.titled(wall.name)} – {word(wall.mechanism, book.language)}")
    if assessment is not None:
        row = paragraph(sheet, row, sentence_of(wall, book.language), 13, 150)
        for line in (*lines_of(result, wall, book.language), *tie_lines(wall, book.language)):
            row = paragraph(sheet, row, f"• {line}", 13, 150, color=QUIET)
    rows = Rows(book, sheet, result, cell_prefix(result, wall), demand)
    row = rows.write(geometry(wall), row)
    if wall.per_record:
        row = _records(rows, wall, row + 1)
    row = rows.write(closed(wall), row)
    if wall.code_check:
        row = _inequality(rows, result, wall, row + 1)
    if assessment and assessment.kinematic:
        free = assessment.kinematic.free_element
        kind = say("element free to vibrate") if free else say("not free to vibrate")
        label = say("Circolare 7/2019, wall on the ground, {kind}", kind=kind)
        if assessment.kinematic.floor:
            label = say("Circolare 7/2019, wall at {z:g} m, {kind}", z=wall.wall.demand_height_m, kind=kind)
        row = heads(book, sheet, row + 1, label)
        for section in of_wall.checks_of(result, wall):
            row = rows.write(section, row)
        if assessment.kinematic.zeta_sld is None:
            words = say("No linear check: T_0 is not known (see the verdict).")
            text(sheet, row, 1, words, color=QUIET, italic=True)
            row += 1
    for warning in wall.warnings:
        row = paragraph(sheet, row, f"• {warning.text(book.language)}", 13, 150)
    return row + 1


def _records(rows: Rows, wall: WallResult, row: int) -> int:
    """The governing run of each record: Eq. 10, 12 and 15/16, live and of the program."""
    book, sheet, name, say = rows.book, rows.sheet, rows.prefix, rows.book.say
    form = "Eq. 16" if wall.kinematics.one_way else "Eq. 15"
    header(
        sheet,
        row,
        [
            say("Record (governing sign)"),
            "SI [cm]",
            "PFA [g]" if wall.floor else "PGA [g]",
            say("Scale C"),
            "q, Eq. 10",
            say("program"),
            "q_eff, Eq. 12",
            say("program"),
            "ln SI",
            "ln q_eff",
            *([f"q_eff, {form}", f"q, {form}", say("program")] if wall.wall.has_closed_forms else []),
        ],
        1,
        32,
    )
    first = row + 1
    scale: dict[tuple[int, int | None], float | None] = {(run.motion, run.polarity): run.scale for run in wall.runs}
    for entry in wall.per_record:
        row += 1
        _record_row(rows, wall, entry, scale.get((entry.motion, entry.polarity)), row)
    last = row
    row += 1
    of_set = "AVERAGE" if wall.set_rule == "mean" else "MIN"
    label = f"q ({rule_word(book, wall.set_rule)})"
    row = formula_row(book, sheet, row, label, "", f"={of_set}(E{first}:E{last})", wall.q_set, "–", f"{name}q_set")
    book.of_run.add(f"{name}q_set")
    law = wall.power_law
    if law and all(entry.q is not None for entry in wall.per_record):
        xs, ys = f"I{first}:I{last}", f"J{first}:J{last}"
        row = formula_row(book, sheet, row, "C2", "Eq. 13", f"=SLOPE({ys},{xs})", law.c2, "–", f"{name}c2")
        row = formula_row(
            book, sheet, row, "C1", "Eq. 13", f"=EXP(INTERCEPT({ys},{xs}))", law.c1, "–", f"{name}c1", "0.000E+00"
        )
        row = formula_row(book, sheet, row, "R²", "Eq. 13", f"=RSQ({ys},{xs})", law.r_squared, "–")
    return row


def _record_row(rows: Rows, wall, entry: RecordResult, scale, row: int) -> None:
    book, sheet = rows.book, rows.sheet
    cells = rows.cells | {"collapse_scale": f"D{row}", "pga": f"C{row}", "q": f"E{row}", "demand_si": f"B{row}"}
    sign = {1: " (+)", -1: " (−)", None: ""}[entry.polarity]
    text(sheet, row, 1, entry.record + sign, wrap=True)
    heighten(sheet, row, (entry.record + sign, 34))
    number(sheet, row, 2, entry.intensity / CM, RATIO)
    number(sheet, row, 3, entry.pga / G, ACCELERATION)
    number(sheet, row, 4, abs(scale) if scale is not None else None, ACCELERATION)
    if entry.q is None:
        words = book.say("no number")
        text(sheet, row, 5, words, color=BAD)
    else:
        ln_si, ln_q = math.log(entry.intensity / CM), math.log(require_value(entry.q_eff))
        book.formula(sheet.cell(row, 5), formula(eq.q, cells), entry.q, RATIO)
        number(sheet, row, 6, entry.q, RATIO, color=QUIET)
        book.formula(sheet.cell(row, 7), formula(eq.q_eff, cells), entry.q_eff, RATIO)
        number(sheet, row, 8, entry.q_eff, RATIO, color=QUIET)
        book.formula(sheet.cell(row, 9), f"=LN(B{row})", ln_si, RATIO)
        book.formula(sheet.cell(row, 10), f"=LN(G{row})", ln_q, RATIO)
    if entry.closed_form_q is not None:
        cells |= {name: f"{value!r}" for name, value in eq.constants(wall).items()}
        book.formula(sheet.cell(row, 11), formula(eq.closed_q_eff(wall), cells), entry.closed_form_q_eff, RATIO)
        book.formula(
            sheet.cell(row, 12),
            formula(eq.q_closed, {"q_eff_closed": f"K{row}", "demand_pga": f"C{row}"}),
            entry.closed_form_q,
            RATIO,
        )
        number(sheet, row, 13, entry.closed_form_q, RATIO, color=QUIET)
    rule(sheet, row, 1, 13)


def _inequality(rows: Rows, result: StudyResult, wall: WallResult, row: int) -> int:
    """Eq. 9 with the q of every source."""
    book, sheet, name, say = rows.book, rows.sheet, rows.prefix, rows.book.say
    words = {
        "code": (say("q of the code"), "code_q"),
        "closed_form": (say("q of Eq. 15/16"), f"{name}q_closed"),
        "time_histories": (say("q of the time histories, collapse"), f"{name}q_set"),
        "time_histories_slv": (say("q of the time histories, SLV"), None),
        "time_histories_robust": (say("q of the time histories, robust"), None),
    }
    label = say(TITLE)
    header(
        sheet,
        row,
        [label, "q", "a_RM [g]", "S a_g / q [g]", say("program"), say("ratio"), say("program"), say("outcome")],
        1,
        32,
    )
    for source, inequality in zip(Q_SOURCES, wall.code_check, strict=True):
        row += 1
        label, reference = words[source]
        text(sheet, row, 1, label)
        if inequality is None:
            text(sheet, row, 2, say("no number"), color=QUIET)
        else:
            if reference:
                book.formula(sheet.cell(row, 2), f"={reference}", inequality.q, RATIO)
            else:
                number(sheet, row, 2, inequality.q, RATIO)
            capacity, demand = inequality.capacity / G, inequality.demand / G
            book.formula(sheet.cell(row, 3), f"={name}a_rm", capacity, ACCELERATION)
            book.formula(
                sheet.cell(row, 4), formula(eq.demand_over_q, rows.cells | {"q": f"B{row}"}), demand, ACCELERATION
            )
            number(sheet, row, 5, demand, ACCELERATION, color=QUIET)
            book.formula(
                sheet.cell(row, 6),
                formula(eq.capacity_over_demand, {"a_rm": f"C{row}", "demand_over_q": f"D{row}"}),
                inequality.ratio,
                RATIO,
            )
            number(sheet, row, 7, inequality.ratio, RATIO, color=QUIET)
            yes, no = say("passed"), say("not passed")
            outcome = f'IF(F{row}>=1-1E-12,"{yes}","{no}")'
            if source.startswith("time_histories"):  # that q is of the wall and the demand of the run
                outcome = f'IF(inputs_changed>0,"{say("run again")}",{outcome})'
            cell = book.formula(sheet.cell(row, 8), f"={outcome}", yes if inequality.passed else no)
            color = GOOD if inequality.passed else BAD
            style(cell, bold=True, color=color, align="center")
        rule(sheet, row, 1, 8)
    for estimate in wall.estimates:
        row += 1
        text(
            sheet,
            row,
            1,
            say("{quantity} of Ribalta's law, a research output", quantity=estimate.quantity),
            color=QUIET,
        )
        number(sheet, row, 2, estimate.q, RATIO, color=QUIET)
        book.formula(sheet.cell(row, 3), f"={name}a_rm", wall.block.threshold_acceleration / G, ACCELERATION)
        demand = result.demand_required.pga / G / estimate.q
        book.formula(sheet.cell(row, 4), formula(eq.demand_over_q, rows.cells | {"q": f"B{row}"}), demand, ACCELERATION)
        book.formula(
            sheet.cell(row, 6),
            formula(eq.capacity_over_demand, {"a_rm": f"C{row}", "demand_over_q": f"D{row}"}),
            wall.block.threshold_acceleration / G / demand,
            RATIO,
        )
        words = ", ".join(said.text(book.language) for said in estimate.ranges)
        text(sheet, row, 9, words, color=QUIET, size=8)  # beside the table, as long as it is
        rule(sheet, row, 1, 8)
    return row + 2
