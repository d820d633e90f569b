"""Live formulas of the Circolare's checks on the Check sheet: C8.7.1.2.1.7, .8 and .9."""

from core.kinematic import DAMPING, LIMIT_FRACTION, PERIOD_FACTOR
from core.report.cells import ACCELERATION, BAD, EXACT, GOOD, QUIET, RATIO, Book, style, text
from core.report.rows import heads, input_row, live_row
from core.results import StudyResult, WallResult
from core.target_spectrum import EN_AMPLIFICATION, NTC_SOIL, NTC_TOPOGRAPHY, CodeSpectrum
from core.units import G
from core.words import word


def spectrum_rows(book: Book, sheet, result: StudyResult, row: int) -> int:
    """FC and the branches of the spectrum as named cells; for NTC 2018 S and the periods are live."""
    say, demand = book.say, result.demand
    row = input_row(book, sheet, row, "FC", demand.confidence_factor, "–", "demand_fc", RATIO)
    row = input_row(book, sheet, row, say("ζ required", "ζ richiesto"), demand.zeta_target, "–",
                    "zeta_target", RATIO)  # fmt: skip
    target, asked = demand.target, result.case.demand.spectrum
    if not isinstance(target, CodeSpectrum):
        return row
    if asked.code == "EN1998":
        for label, value, name in (("F0", EN_AMPLIFICATION, "f0"), ("T_B", target.t_b, "tb"),
                                   ("T_C", target.t_c, "tc"), ("T_D", target.t_d, "td")):  # fmt: skip
            unit = "–" if name == "f0" else "s"
            row = input_row(book, sheet, row, label, value, unit, f"spectrum_{name}", ACCELERATION)
        return row
    a, b, low, high, c, d = NTC_SOIL[asked.soil]
    st = NTC_TOPOGRAPHY[asked.topography]
    row = input_row(book, sheet, row, "F0", asked.f0, "–", "spectrum_f0", ACCELERATION)
    row = input_row(
        book, sheet, row, "T_C*", asked.tc_star_s, "s", "spectrum_tc_star", ACCELERATION
    )
    row = live_row(book, sheet, row, f"S = S_S S_T ({asked.soil}, {asked.topography})", "3.2.3",
                   f"=MIN(MAX({a}-{b}*spectrum_f0*demand_ag,{low}),{high})*{st}",
                   demand.soil_factor, "–", "spectrum_s")  # fmt: skip
    row = live_row(book, sheet, row, "T_C = C_C T_C*", "3.2.5",
                   f"={c}*spectrum_tc_star^({d})*spectrum_tc_star", target.t_c, "s", "spectrum_tc")  # fmt: skip
    row = live_row(
        book, sheet, row, "T_B", "3.2.6", "=spectrum_tc/3", target.t_b, "s", "spectrum_tb"
    )
    return live_row(
        book, sheet, row, "T_D", "3.2.7", "=4*demand_ag+1.6", target.t_d, "s", "spectrum_td"
    )


def wall_rows(book: Book, sheet, result: StudyResult, wall: WallResult, name: str, row: int) -> int:
    """Kinematic checks of one wall, linear and nonlinear, beside the program's values."""
    say, found = book.say, wall.assessment.kinematic
    demand = result.demand
    row = heads(book, sheet, row, say("Circolare 7/2019, wall on the ground",
                                      "Circolare 7/2019, parete al suolo"))  # fmt: skip
    row = live_row(book, sheet, row, "α0 = tan α", "C8.7.1.1",
                   f"=TAN(RADIANS({name}_slenderness))", found.alpha0, "–", f"{name}_alpha0")  # fmt: skip
    row = input_row(book, sheet, row, "e* (C8.7.1.5)", found.e_star, "–", f"{name}_e_star", RATIO)
    row = live_row(book, sheet, row, "a0* = α0 g / (e* FC)", "C8.7.1.3",
                   f"={name}_alpha0/({name}_e_star*demand_fc)", found.a0 / G, "g",
                   f"{name}_a0_star")  # fmt: skip
    for check in found_checks(wall, "linear_q_slv", "linear_q_code"):
        q = f"{name}_{check.name}"
        label = word(check.name, book.language)
        row = input_row(book, sheet, row, f"q: {label}", check.q, "–", q, EXACT)
        row = live_row(book, sheet, row, f"ζ: {label}", check.clause,
                       f"={q}*{name}_a0_star/(demand_s*demand_ag)", check.zeta, "–",
                       f"{q}_zeta")  # fmt: skip
        row = _outcome(book, sheet, row, f"{q}_zeta", check)
    for check in found_checks(wall, "nonlinear"):
        row = _displacement(book, sheet, wall, name, demand, check, row)
    for check in found_checks(wall, "dynamic"):
        if check.demand is not None:
            row = input_row(book, sheet, row, say("θmax/α of the set (Dynamic check)",
                            "θmax/α dell'insieme (Verifica dinamica)"), check.demand, "–",
                            f"{name}_peak", EXACT)  # fmt: skip
        row = input_row(book, sheet, row, f"ζ: {word('dynamic', book.language)}", check.zeta, "–",
                        f"{name}_dynamic_zeta", EXACT)  # fmt: skip
    return row


def found_checks(wall: WallResult, *names: str):
    return [check for check in wall.assessment.checks if check.name in names]


def _displacement(book: Book, sheet, wall, name: str, demand, check, row: int) -> int:
    found, state = wall.assessment.kinematic, demand.limit_state
    share = LIMIT_FRACTION[state]
    row = live_row(book, sheet, row, "d0 = R sin α", "C8.7.1.2.1.6",
                   f"={name}_radius*SIN(RADIANS({name}_slenderness))", found.d0, "m", f"{name}_d0")  # fmt: skip
    row = live_row(book, sheet, row, f"d_{state} = {share:.2f} d0", "C8.7.1.2.1.6",
                   f"={share}*{name}_d0", found.d_limit, "m", f"{name}_d_limit")  # fmt: skip
    row = live_row(book, sheet, row, f"a(d_{state})", "C8.7.1.3",
                   f"=(1-{share})*{name}_a0_star*gravity", found.a_limit, "m/s²", f"{name}_a_limit")  # fmt: skip
    equation = "C8.7.1.10" if state == "SLV" else "C8.7.1.11"
    factor = PERIOD_FACTOR[state] / 3.141592653589793
    row = live_row(book, sheet, row, f"T_{state}", equation,
                   f"={factor:.2f}*PI()*SQRT({name}_d_limit/{name}_a_limit)", found.period, "s",
                   f"{name}_period")  # fmt: skip
    damping = 100.0 * DAMPING[state]
    if isinstance(demand.target, CodeSpectrum):
        t, plateau = f"{name}_period", f"MAX(SQRT(10/(5+{damping:g})),0.55)*spectrum_f0"
        shape = (
            f"IF({t}<spectrum_tb,{t}/spectrum_tb*{plateau}+1-{t}/spectrum_tb,"
            f"IF({t}<spectrum_tc,{plateau},IF({t}<spectrum_td,{plateau}*spectrum_tc/{t},"
            f"{plateau}*spectrum_tc*spectrum_td/{t}^2)))"
        )
        formula = f"=demand_pga*gravity*{shape}*({t}/(2*PI()))^2"
        row = live_row(book, sheet, row, f"S_De(T_{state}, {damping:g} %)", "C8.7.1.12", formula,
                       found.s_de, "m", f"{name}_s_de")  # fmt: skip
    else:
        row = input_row(book, sheet, row, f"S_De(T_{state}, {damping:g} %)", found.s_de, "m",
                        f"{name}_s_de")  # fmt: skip
    row = live_row(book, sheet, row, f"ζ: {word('nonlinear', book.language)}", "C8.7.1.12",
                   f"={name}_d_limit/{name}_s_de", check.zeta, "–", f"{name}_nonlinear_zeta")  # fmt: skip
    row = _outcome(book, sheet, row, f"{name}_nonlinear_zeta", check)
    text(sheet, row, 1, book.say(
        f"d_C at the centre of mass; with C8.7.1.4 summed over the height, as e* is: ζ {found.zeta_over_height:.2f}.",
        f"d_C nel baricentro; con la C8.7.1.4 sommata sull'altezza, come e*: ζ {found.zeta_over_height:.2f}."),
        color=QUIET, italic=True)  # fmt: skip
    return row + 1


def _outcome(book: Book, sheet, row: int, zeta: str, check) -> int:
    """A live word in the row of zeta: passed from the zeta required."""
    yes, no = word("passed", book.language), word("not_passed", book.language)
    cell = book.formula(sheet.cell(row - 1, 6), f'=IF({zeta}>=zeta_target-1E-12,"{yes}","{no}")',
                        yes if check.passed else no)  # fmt: skip
    style(cell, bold=True, color=GOOD if check.passed else BAD)
    return row
