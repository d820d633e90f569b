"""Rows of the demand on the Check sheet: S, the branches of the spectrum and SI as live formulas."""

from core.codes.target_spectrum import (
    EN_AMPLIFICATION,
    NTC_SOIL,
    NTC_TOPOGRAPHY,
    SI_FROM,
    SI_TO,
    CodeSpectrum,
    shape_integral,
)
from core.report.cells import ACCELERATION, RATIO, Book
from core.report.rows import found_row, input_row, live_row
from core.study.results import StudyResult


def follows_spectrum(result: StudyResult) -> bool:
    """Whether S is that of the spectrum of NTC 2018, which the sheet has as a formula."""
    asked = result.case.demand
    spectrum = asked.spectrum
    return (
        asked.soil_factor is None
        and spectrum is not None
        and spectrum.code == "NTC2018"
        and isinstance(result.demand.target, CodeSpectrum)
    )


def spectrum_rows(book: Book, sheet, result: StudyResult, row: int) -> int:
    """FC and the branches of the spectrum as named cells; for NTC 2018 S and the periods are live."""
    say, demand = book.say, result.demand
    row = input_row(book, sheet, row, "FC", demand.confidence_factor, "–", "demand_fc", RATIO)
    row = input_row(book, sheet, row, say("ζ required"), demand.zeta_target, "–", "zeta_target", RATIO)
    target, asked = demand.target, result.case.demand.spectrum
    if not isinstance(target, CodeSpectrum):
        return row
    if asked.code == "EN1998":
        for label, value, name in (
            ("F0", EN_AMPLIFICATION, "f0"),
            ("T_B", target.t_b, "tb"),
            ("T_C", target.t_c, "tc"),
            ("T_D", target.t_d, "td"),
        ):
            unit = "–" if name == "f0" else "s"
            row = found_row(book, sheet, row, label, value, unit, f"spectrum_{name}", ACCELERATION)
        return row
    a, b, low, high, c, d = NTC_SOIL[asked.soil]
    st = NTC_TOPOGRAPHY[asked.topography]
    row = input_row(book, sheet, row, "F0", asked.f0, "–", "spectrum_f0", ACCELERATION)
    row = input_row(book, sheet, row, "T_C*", asked.tc_star_s, "s", "spectrum_tc_star", ACCELERATION)
    row = live_row(
        book,
        sheet,
        row,
        f"S = S_S S_T ({asked.soil}, {asked.topography})",
        "3.2.3",
        f"=MIN(MAX({a}-{b}*spectrum_f0*demand_ag,{low}),{high})*{st}",
        demand.soil_factor,
        "–",
        "spectrum_s",
    )
    row = live_row(
        book,
        sheet,
        row,
        "T_C = C_C T_C*",
        "3.2.5",
        f"={c}*spectrum_tc_star^({d})*spectrum_tc_star",
        target.t_c,
        "s",
        "spectrum_tc",
    )
    row = live_row(book, sheet, row, "T_B", "3.2.6", "=spectrum_tc/3", target.t_b, "s", "spectrum_tb")
    return live_row(book, sheet, row, "T_D", "3.2.7", "=4*demand_ag+1.6", target.t_d, "s", "spectrum_td")


def intensity_row(book: Book, sheet, row: int, demand, intensity: float | None) -> int:
    """SI of the demand [cm], which follows the other cells where it is of a spectrum or of records scaled to a_g S."""
    label = book.say("SI of the demand")
    if demand.intensity_source == "given":
        return input_row(book, sheet, row, label, intensity, "cm", "demand_si", RATIO)
    follows = "demand_pga/demand_pga_run"
    if isinstance(demand.target, CodeSpectrum) and demand.intensity_source == "spectrum":
        then = shape_integral(demand.target)
        tb, tc, td, f0 = (f"spectrum_{key}" for key in ("tb", "tc", "td", "f0"))
        first, last = f"MIN({SI_FROM},{tb})", f"MIN({td},{SI_TO})"
        now = (
            f"(({tb}^2-{first}^2)/2+({f0}-1)*({tb}^3-{first}^3)/(3*{tb})+{f0}*({tc}^2-MAX({tb},{SI_FROM})^2)/2"
            f"+{f0}*{tc}*({last}-{tc})+{f0}*{tc}*{td}*LN({SI_TO}/{last}))"
        )
        follows += f"*{now}/{then!r}"
    elif demand.intensity_source != "records_scaled":
        return found_row(book, sheet, row, label, intensity, "cm", "demand_si", RATIO)
    formula = f"={intensity!r}*{follows}"
    return live_row(book, sheet, row, label, "Eq. 11", formula, intensity, "cm", "demand_si", RATIO)


def spectrum_shape(t: str, damping: float) -> str:
    """S_e(t) / (a_g S) of a code's spectrum as a formula; t : a named cell; damping [%]."""
    plateau = f"MAX(SQRT(10/(5+{damping:g})),0.55)*spectrum_f0"
    return (
        f"IF({t}<spectrum_tb,{t}/spectrum_tb*{plateau}+1-{t}/spectrum_tb,"
        f"IF({t}<spectrum_tc,{plateau},IF({t}<spectrum_td,{plateau}*spectrum_tc/{t},"
        f"{plateau}*spectrum_tc*spectrum_td/{t}^2)))"
    )
