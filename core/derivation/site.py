"""Which quantities the demand of a case has, with the values of the program."""

from core.codes.spectrum_codes import NATIONAL
from core.codes.target_spectrum import NTC_SOIL, NTC_TOPOGRAPHY, CodeSpectrum, shape_integral
from core.derivation import demand as of
from core.derivation.body import GRAVITY
from core.derivation.line import FULL, INPUT, LIVE, RUN, VALUE, Line, Section, Word
from core.known import require_value
from core.study.results import StudyResult
from core.units import CM, G


def follows_spectrum(result: StudyResult) -> bool:
    """Whether S is that of the spectrum of NTC 2018, by its formula."""
    asked = require_value(result.case.demand)
    spectrum = asked.spectrum
    return (
        asked.soil_factor is None
        and spectrum is not None
        and spectrum.code == NATIONAL
        and isinstance(result.demand_required.target, CodeSpectrum)
    )


def demand_section(result: StudyResult) -> Section:
    """Ground, spectrum, SI, confidence."""
    demand, lines = result.demand, [Line(GRAVITY, G, INPUT)]
    if demand is None:
        return Section("Demand", lines)
    constants: dict[str, float] = {}
    lines.append(Line(of.AG, demand.ag / G, INPUT, VALUE, "on rock"))
    if isinstance(demand.target, CodeSpectrum):
        spectrum, of_branches = _spectrum(result, demand.target)
        lines, constants = lines + spectrum, constants | of_branches
    if follows_spectrum(result):
        asked = require_value(require_value(result.case.demand).spectrum)
        words = {"soil": asked.soil, "topography": asked.topography}
        lines.append(Line(of.demand_s, demand.soil_factor, LIVE, VALUE, words=words))
    else:
        lines.append(Line(of.S, demand.soil_factor, INPUT, VALUE))
    lines.append(Line(of.demand_pga, demand.pga / G, LIVE, FULL, run_name="demand_pga_run"))
    intensity = demand.intensity / CM if demand.intensity else None
    lines.append(_intensity(demand, intensity))
    if demand.intensity_source in ("spectrum", "records_scaled"):
        constants |= {"si_run": require_value(intensity), "pga_run": demand.pga / G}
        if isinstance(demand.target, CodeSpectrum):
            constants["area_run"] = shape_integral(demand.target)
    lines.append(Line(of.FC, demand.confidence_factor, INPUT, VALUE, Word(f"confidence_{demand.confidence_on}")))
    lines.append(Line(of.ZETA, demand.zeta_target, INPUT, VALUE, "ζ required"))
    lines.append(Line(of.Q, demand.q_code, INPUT))
    return Section("Demand", lines, constants)


def _spectrum(result: StudyResult, target: CodeSpectrum) -> tuple[list[Line], dict[str, float]]:
    """Branches of the spectrum of a code; for NTC 2018 S and the periods are live."""
    asked = require_value(require_value(result.case.demand).spectrum)
    if asked.code != NATIONAL:
        branches = ((of.F0, target.amplification), (of.T_B, target.t_b), (of.T_C, target.t_c), (of.T_D, target.t_d))
        return [Line(given, value, RUN, VALUE) for given, value in branches], {}
    names = ("soil_a", "soil_b", "soil_low", "soil_high", "soil_c", "soil_d")
    constants = dict(zip(names, NTC_SOIL[asked.soil], strict=True))
    constants["topography"] = NTC_TOPOGRAPHY[require_value(asked.topography)]
    return [
        Line(of.F0, asked.f0, INPUT, VALUE),
        Line(of.TC_STAR, asked.tc_star_s, INPUT),
        Line(of.spectrum_tc, target.t_c, LIVE, VALUE),
        Line(of.spectrum_tb, target.t_b, LIVE, VALUE),
        Line(of.spectrum_td, target.t_d, LIVE, VALUE),
    ], constants


SOURCES = {"given": "given", "spectrum": "of the spectrum", "records_scaled": "from the records"}
"""Where SI comes from, as the note says it."""


def _intensity(demand, intensity: float | None) -> Line:
    """SI of the demand [cm], which follows the other cells where it is of a spectrum or of records scaled to a_g S."""
    source = demand.intensity_source
    note, label = (VALUE, SOURCES[source]) if intensity else ("", "")
    if source == "given":
        return Line(of.SI, intensity, INPUT, note, label)
    if source == "spectrum" and isinstance(demand.target, CodeSpectrum):
        return Line(of.intensity_of_spectrum, intensity, LIVE, note, label)
    if source == "records_scaled":
        return Line(of.intensity_of_records, intensity, LIVE, note, label)
    return Line(of.SI, intensity, RUN, note, label)
