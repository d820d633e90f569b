"""Check sheet: Eq. 2, 9, 10, 12, 13, 15, 16 as live formulas beside the program's own values."""

import math

from core.capacity.closed_forms import COEFFICIENTS
from core.codes.eq9 import TITLE
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
from core.report.circolare import wall_rows
from core.report.load_rows import geometry_rows, impact_formulas
from core.report.rows import changed_cell, close_inputs, found_row, heads, input_row, live_row
from core.report.sheets import rule_word
from core.report.spectrum_rows import follows_spectrum, intensity_row, spectrum_rows
from core.study.results import Q_SOURCES, PerRecord, StudyResult, WallResult
from core.text.sentence import word
from core.units import CM, G
from core.wall import wall_loads
from core.wall.restitution import MODELS


def check(book: Book, result: StudyResult) -> None:
    """One block a wall: geometry, records, set, power law, closed forms, Eq. 9."""
    say = book.say
    widths = [34, 13, 13, 13, 12, 11, 12, 16, 11, 11, 11, 11, 12]
    sheet = book.sheet("Check", widths)
    title(sheet, 1, say("Check of the equations"))
    paragraph(
        sheet,
        2,
        say(
            "Column C is a live formula of this sheet, column D the value of the program: they must "
            "agree. In the tables of records each pair stands side by side. Yellow cells may be changed."
        ),
        len(widths),
        150,
        color=QUIET,
    )
    changed_cell(book, sheet, 3, 1)
    row = _demand(book, sheet, result, 4)
    for index, wall in enumerate(book.steps.each(result.walls), start=1):
        row = _wall(book, sheet, result, wall, f"wall{index}", row + 1)
    sheet.freeze_panes = "A4"
    sheet.print_area = f"A1:M{sheet.max_row}"
    close_inputs(book, sheet)


def _demand(book: Book, sheet, result: StudyResult, row: int) -> int:
    say, demand = book.say, result.demand
    row = heads(book, sheet, row, say("Demand"))
    row = input_row(book, sheet, row, "g", G, "m/s²", "gravity", "0.00000")
    if demand is None:
        text(sheet, row, 1, say("No demand given: no check."))
        return row + 1
    row = input_row(book, sheet, row, say("a_g on rock"), demand.ag / G, "g", "demand_ag", ACCELERATION)
    if follows_spectrum(result):
        row = live_row(book, sheet, row, "S", "3.2.3", "=spectrum_s", demand.soil_factor, "–", "demand_s", RATIO)
    else:
        row = input_row(book, sheet, row, "S", demand.soil_factor, "–", "demand_s", RATIO)
    row = live_row(
        book,
        sheet,
        row,
        "S a_g",
        "",
        "=demand_ag*demand_s",
        demand.pga / G,
        "g",
        "demand_pga",
        ACCELERATION,
        "demand_pga_run",
    )
    si = demand.intensity / CM if demand.intensity else None
    row = spectrum_rows(book, sheet, result, row)
    row = intensity_row(book, sheet, row, demand, si)
    return input_row(book, sheet, row, say("q of the code"), demand.q_code, "–", "code_q", RATIO)


def _wall(book: Book, sheet, result: StudyResult, wall: WallResult, name: str, row: int) -> int:
    label = f"{wall.name} – {word(wall.mechanism, book.language)}"
    row = heads(book, sheet, row, label)
    row = _geometry(book, sheet, wall, name, row)
    if wall.per_record:
        row = _records(book, sheet, wall, name, row + 1)
    row = _closed(book, sheet, result, wall, name, row)
    if wall.code_check:
        row = _inequality(book, sheet, result, wall, name, row + 1)
    if wall.assessment and wall.assessment.kinematic:
        row = wall_rows(book, sheet, result, wall, name, row + 1)
    for warning in wall.warnings:
        row = paragraph(sheet, row, f"• {warning.text(book.language)}", 13, 150)
    return row + 1


def _geometry(book: Book, sheet, wall: WallResult, name: str, row: int) -> int:
    say, block = book.say, wall.block
    if wall.wall.load:
        row = geometry_rows(book, sheet, wall, name, row)
        return _ratio_row(book, sheet, wall, name, row)
    degrees = math.degrees(block.slenderness)
    rectangle, setback = block.is_rectangle, wall.wall.setback if wall.wall.height_m else 0.0
    equivalent = f"H = 2 R_eq cos α ({say('equivalent')})"
    if rectangle or setback:
        row = input_row(book, sheet, row, "H", wall.height, "m", f"{name}_height", RATIO)
    if setback:
        row = input_row(book, sheet, row, "t", wall.thickness, "m", f"{name}_thickness", "0.000")
        setback_row = found_row if wall.wall.compressive_strength_mpa else input_row
        row = setback_row(book, sheet, row, say("hinge setback u"), setback, "m", f"{name}_setback")
        row = live_row(
            book,
            sheet,
            row,
            "α = arctan((t − 2u)/H)",
            "Fig. 1",
            f"=DEGREES(ATAN(({name}_thickness-2*{name}_setback)/{name}_height))",
            degrees,
            "°",
            f"{name}_slenderness",
        )
        row = live_row(
            book,
            sheet,
            row,
            "R",
            "Fig. 1",
            f"=SQRT({name}_height^2+({name}_thickness-2*{name}_setback)^2)/2",
            block.radius,
            "m",
            f"{name}_radius",
        )
        row = live_row(
            book,
            sheet,
            row,
            "I0/m",
            "Fig. 1",
            f"=({name}_height^2+{name}_thickness^2)/12+{name}_radius^2",
            block.inertia_over_mass,
            "m²",
            f"{name}_inertia",
        )
        p = f"=SQRT(gravity*{name}_radius/{name}_inertia)"
    elif rectangle:
        if wall.wall.slenderness_deg is None:
            row = input_row(book, sheet, row, "t", wall.thickness, "m", f"{name}_thickness", "0.000")
            row = live_row(
                book,
                sheet,
                row,
                "α = arctan(t/H)",
                "Fig. 1",
                f"=DEGREES(ATAN({name}_thickness/{name}_height))",
                degrees,
                "°",
                f"{name}_slenderness",
            )
        else:
            row = input_row(book, sheet, row, "α", degrees, "°", f"{name}_slenderness")
        row = live_row(
            book,
            sheet,
            row,
            "R = H / (2 cos α)",
            "Fig. 1",
            f"={name}_height/(2*COS(RADIANS({name}_slenderness)))",
            block.radius,
            "m",
            f"{name}_radius",
        )
        p = f"=SQRT(3*gravity/(4*{name}_radius))"
    else:
        row = input_row(book, sheet, row, "α", degrees, "°", f"{name}_slenderness")
        row = input_row(book, sheet, row, "R", block.radius, "m", f"{name}_radius")
        row = input_row(book, sheet, row, "I0/m", block.inertia_over_mass, "m²", f"{name}_inertia")
        p = f"=SQRT(gravity*{name}_radius/{name}_inertia)"
    if not rectangle:
        row = live_row(
            book,
            sheet,
            row,
            equivalent,
            "Eq. 15, 16",
            f"=1.5*{name}_inertia/{name}_radius*COS(RADIANS({name}_slenderness))",
            block.height,
            "m",
            f"{name}_equivalent_height",
        )
    row = live_row(book, sheet, row, "p", "Eq. 1", p, block.frequency_parameter, "rad/s", f"{name}_p")
    row = live_row(
        book,
        sheet,
        row,
        "a_RM / g = tan α",
        "Eq. 2",
        f"=TAN(RADIANS({name}_slenderness))",
        block.threshold_acceleration / G,
        "g",
        f"{name}_a_rm",
        ACCELERATION,
        f"{name}_a_rm_run",
    )
    return _ratio_row(book, sheet, wall, name, row)


def _ratio_row(book: Book, sheet, wall: WallResult, name: str, row: int) -> int:
    say, block = book.say, wall.block
    ratio = wall.restitution
    label = say("velocity ratio e") + f" ({MODELS[ratio.model]})"
    factor = f"(2*{name}_radius^2/{name}_inertia)" if not block.is_rectangle else "1.5"
    eq4 = f"(1-{factor}*SIN(RADIANS({name}_slenderness))^2)"
    top = f"ABS(1-{factor}*COS(RADIANS({name}_slenderness))^2)"
    if wall_loads.contact_of(wall.wall):
        eq4, top = impact_formulas(name)
    eq6 = f"{eq4}^2*{top}"
    formulas = {
        "housner": ("Eq. 4", eq4),
        "sorrentino_experimental": ("Eq. 5", f"0.95*{eq4}"),
        "one_sided_theoretical": ("Eq. 6", eq6),
        "one_sided_experimental": ("Eq. 7, v = 0", f"1.18*{eq6}"),
    }
    if ratio.model in formulas:
        equation, formula = formulas[ratio.model]
        return live_row(
            book, sheet, row, label, equation, f"={formula}", ratio.ratio_at_rest, "–", f"{name}_velocity_ratio"
        )
    ratio_row = input_row if ratio.model == "user" else found_row
    return ratio_row(book, sheet, row, label, ratio.ratio_at_rest, "–", f"{name}_velocity_ratio")


def _records(book: Book, sheet, wall: WallResult, name: str, row: int) -> int:
    """The governing run of each record: Eq. 10, 12 and 15/16, live and of the program."""
    say = book.say
    form = "Eq. 16" if wall.mechanism == "one_sided" else "Eq. 15"
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
    scale = {(run.motion, run.polarity): run.scale for run in wall.runs}
    for entry in wall.per_record:
        row += 1
        _record_row(book, sheet, wall, entry, scale.get((entry.motion, entry.polarity)), name, row)
    last = row
    row += 1
    formula = "AVERAGE" if wall.set_rule == "mean" else "MIN"
    label = f"q ({rule_word(book, wall.set_rule)})"
    row = live_row(book, sheet, row, label, "", f"={formula}(E{first}:E{last})", wall.q_set, "–", f"{name}_q_set")
    book.of_run.add(f"{name}_q_set")
    law = wall.power_law
    if law and all(entry.q is not None for entry in wall.per_record):
        xs, ys = f"I{first}:I{last}", f"J{first}:J{last}"
        row = live_row(book, sheet, row, "C2", "Eq. 13", f"=SLOPE({ys},{xs})", law.c2, "–", f"{name}_c2")
        row = live_row(
            book, sheet, row, "C1", "Eq. 13", f"=EXP(INTERCEPT({ys},{xs}))", law.c1, "–", f"{name}_c1", "0.000E+00"
        )
        row = live_row(book, sheet, row, "R²", "Eq. 13", f"=RSQ({ys},{xs})", law.r_squared, "–")
    return row


def _record_row(book: Book, sheet, wall, entry: PerRecord, scale, name: str, row: int) -> None:
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
        ln_si, ln_q = math.log(entry.intensity / CM), math.log(entry.q_eff)
        book.formula(sheet.cell(row, 5), f"=D{row}*C{row}/{name}_a_rm_run", entry.q, RATIO)
        number(sheet, row, 6, entry.q, RATIO, color=QUIET)
        book.formula(sheet.cell(row, 7), f"=E{row}/C{row}", entry.q_eff, RATIO)
        number(sheet, row, 8, entry.q_eff, RATIO, color=QUIET)
        book.formula(sheet.cell(row, 9), f"=LN(B{row})", ln_si, RATIO)
        book.formula(sheet.cell(row, 10), f"=LN(G{row})", ln_q, RATIO)
    if entry.closed_form_q is not None:
        formula = _closed_formula(wall, name, f"B{row}")
        book.formula(sheet.cell(row, 11), f"={formula}", entry.closed_form_q_eff, RATIO)
        book.formula(sheet.cell(row, 12), f"=K{row}*C{row}", entry.closed_form_q, RATIO)
        number(sheet, row, 13, entry.closed_form_q, RATIO, color=QUIET)
    rule(sheet, row, 1, 13)


def _closed_formula(wall: WallResult, name: str, intensity: str) -> str:
    a1, a2, a3, c2 = COEFFICIENTS[wall.mechanism == "one_sided"]
    height = "height" if wall.block.is_rectangle else "equivalent_height"
    return f"({a1:g}*{name}_slenderness+{a2:g}*{name}_{height}+{a3:g})*{intensity}^({c2:g})"


def _closed(book: Book, sheet, result: StudyResult, wall: WallResult, name: str, row: int) -> int:
    if wall.closed_form_q is None:
        return row
    form = "Eq. 16" if wall.mechanism == "one_sided" else "Eq. 15"
    formula = _closed_formula(wall, name, "demand_si")
    label = book.say("of the demand")
    row = live_row(
        book,
        sheet,
        row,
        f"q_eff {label}",
        form,
        f"={formula}",
        wall.closed_form_q_eff,
        "–",
        f"{name}_q_eff_closed",
        RATIO,
    )
    return live_row(
        book,
        sheet,
        row,
        f"q = q_eff S a_g / g {label}",
        form,
        f"={name}_q_eff_closed*demand_pga",
        wall.closed_form_q,
        "–",
        f"{name}_q_closed",
        RATIO,
    )


def _inequality(book: Book, sheet, result: StudyResult, wall: WallResult, name: str, row: int) -> int:
    """Eq. 9 with the q of every source."""
    say = book.say
    words = {
        "code": (say("q of the code"), "code_q"),
        "closed_form": (say("q of Eq. 15/16"), f"{name}_q_closed"),
        "time_histories": (say("q of the time histories, collapse"), f"{name}_q_set"),
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
            book.formula(sheet.cell(row, 3), f"={name}_a_rm", capacity, ACCELERATION)
            book.formula(sheet.cell(row, 4), f"=demand_pga/B{row}", demand, ACCELERATION)
            number(sheet, row, 5, demand, ACCELERATION, color=QUIET)
            book.formula(sheet.cell(row, 6), f"=C{row}/D{row}", inequality.ratio, RATIO)
            number(sheet, row, 7, inequality.ratio, RATIO, color=QUIET)
            yes, no = say("passed"), say("not passed")
            formula = f'IF(F{row}>=1-1E-12,"{yes}","{no}")'
            if source.startswith("time_histories"):  # that q is of the wall and the demand of the run
                formula = f'IF(inputs_changed>0,"{say("run again")}",{formula})'
            cell = book.formula(sheet.cell(row, 8), f"={formula}", yes if inequality.passed else no)
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
        book.formula(sheet.cell(row, 3), f"={name}_a_rm", wall.block.threshold_acceleration / G, ACCELERATION)
        demand = result.demand.pga / G / estimate.q
        book.formula(sheet.cell(row, 4), f"=demand_pga/B{row}", demand, ACCELERATION)
        book.formula(sheet.cell(row, 6), f"=C{row}/D{row}", wall.block.threshold_acceleration / G / demand, RATIO)
        words = f"{book.digits(estimate.low, '.2f')} – {book.digits(estimate.high, '.2f')}"
        if not estimate.within:
            words += " " + say("outside its range")
        text(sheet, row, 8, words, color=QUIET, align="center")
        rule(sheet, row, 1, 8)
    return row + 2
