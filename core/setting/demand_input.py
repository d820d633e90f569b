"""The demand of a case, and the motions generated for it."""

import functools
import math
import re
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import numpy as np

from core.capacity.limit_states import LIMIT_FRACTION
from core.case.coordinates import parse_coordinates
from core.case.hazard_table import read_hazard
from core.case.number_rows import read_number_rows
from core.case.schema import Case, Generate
from core.case.site import Demand, HazardRow
from core.codes import target_spectrum
from core.codes.demand import SeismicDemand
from core.codes.limits import SAME_PERIOD, USUAL_LIVES, return_period
from core.codes.national_hazard import RETURN_PERIODS, SiteHazard, hazard_at
from core.codes.record_compatibility import PERIOD_RANGE
from core.codes.spectrum_codes import CODES, NATIONAL
from core.codes.target_spectrum import Target
from core.decoding import NoText, decode_text
from core.errors import InputError, place, section
from core.file_names import name_of
from core.ground.artificial import compatible_motion
from core.ground.ground_motion import GroundMotion
from core.ground.scattered import TIME_STEP, scattered_set
from core.quantities import foreign_unit
from core.regular_file import TooLarge, read_regular
from core.text.sentence import Key, Sentence, notice
from core.units import CM, G

MAX_SPECTRUM_BYTES = 1_000_000
"""Bytes of the file of a spectrum."""

SPECTRUM_UNITS = ("t", "se/g", "sa/g", "s", "sec", "secondi", "seconds", "g", "-", "–", "m/m")
"""Units of a spectrum file, as they are written."""


def read_target_spectrum(asked: Demand, base_dir: Path) -> Target | None:
    """The elastic spectrum of a demand. Raises InputError, and KeyError of a draft some of whose values are still to be
    given."""
    ag = asked.ag_g * G
    if asked.spectrum_file:
        path = base_dir / name_of(asked.spectrum_file)
        head, rows = _read_spectrum(path)
        try:
            target_spectrum.check_head(head)
        except InputError as error:
            raise error.at(path) from None
        return target_spectrum.given(asked.spectrum_file, ag, asked.soil_factor or 1.0, rows)
    chosen = asked.spectrum
    if chosen is None:
        return None
    code = CODES[chosen.code]
    values = [getattr(chosen, key) for key in code.keys]
    if None in values:
        raise KeyError(code.keys[values.index(None)])
    try:
        return code.make(ag, chosen.soil, *values)
    except InputError as error:
        raise error.at(section("[demand.spectrum]")) from None


def _read_spectrum(path: Path) -> tuple[list[str], list[tuple[float, float]]]:
    """The lines of words above the numbers of a file, and its (period [s], S_e [m/s2]): two columns, s and g."""
    try:
        if not path.is_file():
            raise InputError("no_spectrum_file", place=(path,))
        table = read_number_rows(decode_text(read_regular(path, MAX_SPECTRUM_BYTES)))
    except TooLarge:
        raise InputError("spectrum_too_large", place=(path,)) from None
    except NoText:
        raise InputError("spectrum_line", text="", place=(path, place("line", n=1))) from None
    except OSError as error:
        raise InputError("unreadable", reason=error.strerror, place=(path,)) from None
    for number, line in table.head:
        here, wrong = (path, place("line", n=number)), foreign_unit(line, SPECTRUM_UNITS)
        if re.search(r"\bfreq", line.lower()):
            raise InputError("spectrum_units", unit="Hz", place=here)
        if wrong:
            raise InputError("spectrum_units", unit=wrong[:40], place=here)
    others = [(row.number, row.text) for row in table.rows if len(row.values) != 2]
    if table.wrong is not None or others:
        number, line = min([*others, *([table.wrong] if table.wrong else [])])
        raise InputError("spectrum_line", text=line.strip()[:60], place=(path, place("line", n=number)))
    return [line for _, line in table.head], [(row.values[0], row.values[1] * G) for row in table.rows]


def read_demand(case: Case, base_dir: Path) -> SeismicDemand | None:
    """The demand of a case, None without one. Raises InputError."""
    return None if case.demand is None else read_stated_demand(case.demand, base_dir)


def read_stated_demand(asked: Demand, base_dir: Path) -> SeismicDemand:
    """The demand but for an intensity that only records can give. Raises InputError."""
    hazard = read_hazard_rows(asked, base_dir)
    check_hazard(asked, hazard)
    check_coordinates(asked)
    target = read_target_spectrum(asked, base_dir)
    ag = asked.ag_g * G
    soil = target.soil if target else asked.soil_factor or 1.0
    intensity, source = None, None
    if target:
        intensity, source = target_spectrum.housner_intensity(target), "spectrum"
    elif asked.housner_intensity_cm is not None:
        intensity, source = asked.housner_intensity_cm * CM, "given"
    return SeismicDemand(
        limit_state=asked.limit_state,
        ag=ag,
        soil_factor=soil,
        pga=ag * soil,
        intensity=intensity,
        intensity_source=source,
        q_code=asked.q_code,
        confidence_factor=asked.confidence_factor,
        zeta_target=asked.zeta_target,
        target=target,
        spectrum_code=asked.spectrum.code if asked.spectrum else None,
        confidence_on=asked.confidence_on,
        record_scaling=asked.demand_scaling,
        period_range=asked.period_range_s,
        soil_factor_stated=target is not None or asked.soil_factor is not None,
        return_period=asked.return_period,
        hazard=tuple((row.return_period_years, row.ag_g * G) for row in hazard),
    )


def rescale_ag(demand: SeismicDemand, asked: Demand, base_dir: Path, factor: float) -> SeismicDemand:
    """A demand with another a_g: that of the demand times this factor; S_S of NTC follows it, a spectrum of a file is
    scaled. asked : of the case. Raises InputError."""
    ag, target = factor * demand.ag, demand.target
    if isinstance(target, target_spectrum.GivenSpectrum):
        target = replace(target, ag=ag, values=tuple(factor * value for value in target.values))
    elif target:
        target = read_target_spectrum(replace(asked, ag_g=ag / G), base_dir)
    soil = target.soil if target else demand.soil_factor
    intensity = target_spectrum.housner_intensity(target) if target else demand.intensity
    return replace(demand, ag=ag, soil_factor=soil, pga=ag * soil, target=target, intensity=intensity)


def rescaled_pga(demand: SeismicDemand, asked: Demand, base_dir: Path, factor: float) -> float:
    """PGA of `rescale_ag` alone [m/s2], without the spectrum and its intensity. Raises InputError."""
    ag, target = factor * demand.ag, demand.target
    if target and not isinstance(target, target_spectrum.GivenSpectrum):
        target = read_target_spectrum(replace(asked, ag_g=ag / G), base_dir)
    return ag * (target.soil if target else demand.soil_factor)


def read_hazard_rows(asked: Demand, base_dir: Path) -> tuple[HazardRow, ...]:
    """The hazard of the site, of the case or of its file. Raises InputError."""
    if asked.hazard_file:
        return read_hazard(base_dir / name_of(asked.hazard_file))
    return asked.hazard


def interpolate_hazard(hazard: tuple[HazardRow, ...], years: float) -> HazardRow:
    """The hazard at this return period [years] within its rows: a_g, F_0 and T_C* each linear in the logarithms between
    the rows beside it (NTC 2018, Annex A, Eq. [2])."""
    known = np.log([row.return_period_years for row in hazard])
    at = math.log(years)

    def between(values: list[float]) -> float:
        return math.exp(float(np.interp(at, known, np.log(values))))

    def between_known(values: list[float | None]) -> float | None:
        given = [value for value in values if value is not None]
        return between(given) if len(given) == len(values) else None

    f0, tc_star = between_known([row.f0 for row in hazard]), between_known([row.tc_star_s for row in hazard])
    return HazardRow(years, between([row.ag_g for row in hazard]), f0, tc_star)


def check_hazard(asked: Demand, hazard: tuple[HazardRow, ...]) -> None:
    """Raise InputError where a_g, F_0 or T_C* is not that of the case's own hazard at the return period of the demand,
    beyond the digits both are printed with; without a return period, where a_g is below that of the shortest one of
    the limit state. Outside the rows nothing is compared."""
    years, life = asked.return_period, USUAL_LIVES[0]
    shortest = years is None
    if years is None:
        years = return_period(life, asked.limit_state)
    if not hazard or not hazard_covers(hazard, years):
        return
    row, spectrum = interpolate_hazard(hazard, years), asked.spectrum
    pairs = [("ag_g", asked.ag_g, row.ag_g)]
    if spectrum is not None and not shortest:
        pairs += [(key, getattr(spectrum, key), getattr(row, key)) for key in ("f0", "tc_star_s")]
    for key, given, stated in pairs:
        if given is None or stated is None:
            continue
        rows = max(_decimals(getattr(row, key)) for row in hazard)
        digits = 0.5 * 10.0 ** -_decimals(given) + 0.5 * 10.0**-rows + SAME_PERIOD * stated / 2.0
        values = {"key": key, "given": given, "stated": stated, "years": years, "state": asked.limit_state}
        if shortest and given < stated - digits:
            raise InputError("hazard_above", place=(section("[demand]"),), life=life, **values)
        if not shortest and abs(given - stated) > digits:
            raise InputError("hazard_disagrees", place=(section("[demand]"),), **values)


AT_COORDINATES = 0.05
"""How far a_g, F_0 and T_C* may lie below those of the national grid at the coordinates of a demand [-]: coordinates
are typed with few digits, and other programs take other ellipsoids."""


def has_hazard_at(demand: Demand, years: float) -> bool:
    """Whether a_g was compared with a hazard at this return period [years]: of the case, or of the national grid at its
    coordinates."""
    if demand.hazard and hazard_covers(demand.hazard, years):
        return True
    return bool(demand.coordinates.strip()) and _find_hazard(*parse_coordinates(demand.coordinates)) is not None


def check_coordinates(asked: Demand) -> None:
    """Raise InputError where the demand is below that of the national grid at its coordinates, where these are no
    coordinates, and where they are of the grid in the other order. a_g is compared at the return period, without one
    at the shortest of the limit state, and there F_0 and T_C* of NTC 2018 with the least from it on. Of a place
    outside the grid nothing is compared."""
    if not asked.coordinates.strip():
        return
    try:
        latitude, longitude = parse_coordinates(asked.coordinates)
    except InputError as error:
        raise error.at(section("[demand]")) from None
    here = _find_hazard(latitude, longitude)
    if here is None:
        if _find_hazard(longitude, latitude):
            values = {"given": asked.coordinates.strip()[:60]}
            raise InputError("coordinates_swapped", key="coordinates", place=(section("[demand]"),), **values)
        return
    spectrum, years = asked.spectrum, asked.return_period or return_period(USUAL_LIVES[0], asked.limit_state)
    stated = here.at(years)
    pairs: list[tuple[str, float | None, float]] = [("ag_g", asked.ag_g, stated.ag_g)]
    if spectrum is not None and spectrum.code == NATIONAL:
        longer = [] if asked.return_period else [here.at(each) for each in RETURN_PERIODS if each > years]
        least = [min(values) for values in zip(stated, *longer, strict=True)]
        pairs += [("f0", spectrum.f0, least[1]), ("tc_star_s", spectrum.tc_star_s, least[2])]
    for key, typed, least_value in pairs:
        if typed is not None and typed < (1.0 - AT_COORDINATES) * least_value:
            values = {"given": typed, "stated": least_value, "years": years, "state": asked.limit_state}
            raise InputError("elsewhere", key=key, place=(section("[demand]"),), section=Key("[site]"), **values)


def demand_notices(case: Case) -> list[Sentence]:
    """Notices on what of a demand was not compared, and on histories that are made though none were asked for."""
    notices: list[Sentence] = []
    where = case.demand.coordinates.strip() if case.demand else ""
    if where and _find_hazard(*parse_coordinates(where)) is None:
        notices.append(notice("coordinates_outside"))
    return notices


def _find_hazard(latitude: float, longitude: float) -> SiteHazard | None:
    """The hazard of a point [degrees] by the national grid, None outside it."""
    try:
        return hazard_at(latitude, longitude)
    except InputError:
        return None


def hazard_covers(hazard: tuple[HazardRow, ...], years: float) -> bool:
    """Whether the rows of a hazard hold this return period [years]."""
    low, high = hazard[0].return_period_years, hazard[-1].return_period_years
    return (1.0 - SAME_PERIOD) * low <= years <= (1.0 + SAME_PERIOD) * high


def _decimals(value: float) -> int:
    """Decimals a number of a case was printed with, as far as can be told: a trailing zero is lost, so 2 at least."""
    return max(2, len(f"{value:.10g}".partition(".")[2]))


DEFAULT_SET = Generate()
"""Set generated where no records are given."""


def generate_motions(case: Case, demand: SeismicDemand) -> list[GroundMotion]:
    """The motions of [generate], in their mean compatible with the demand's spectrum; those of DEFAULT_SET where no
    records are given and nothing forbids histories."""
    asked = DEFAULT_SET if case.default_histories and demand.limit_state in LIMIT_FRACTION else case.generate
    return [] if asked is None else generate_requested_motions(asked, demand)


def default_motions(demand: SeismicDemand) -> list[GroundMotion]:
    """The motions of DEFAULT_SET for a demand with a spectrum."""
    return generate_requested_motions(DEFAULT_SET, demand)


def generate_requested_motions(asked: Generate, demand: SeismicDemand) -> list[GroundMotion]:
    """The motions that are asked for a demand with a spectrum."""
    assert demand.target is not None
    return list(_set(demand.target, asked, demand.period_range or PERIOD_RANGE))


def find_generation_settings(motions: Sequence[GroundMotion]) -> Generate | None:
    """[generate] by which those of these motions were made that are generated; None without any, and of several
    sets."""
    said = [dict(motion.details) for motion in motions if motion.format == "generated"]
    scatters = {one.get("scatter") for one in said}
    if len(scatters) != 1 or None in scatters:
        return None
    return Generate(len(said), min(int(one["seed"]) for one in said), float(said[0]["scatter"]))


@functools.lru_cache(maxsize=16)
def _set(target: Target, asked: Generate, band: tuple[float, float]) -> tuple[GroundMotion, ...]:
    """Kept: the window shows the motions before each run with them. band : periods of the rules [s]"""
    seeds = range(asked.seed, asked.seed + asked.count)
    if asked.scatter > 0.0:
        motions = scattered_set(target, asked.count, asked.seed, asked.scatter, band)
    else:
        with ThreadPoolExecutor() as pool:  # the kernel, most of the time, holds no lock
            motions = list(pool.map(functools.partial(compatible_motion, target), seeds))
    return tuple(
        GroundMotion(
            name=f"compatible {seed}",
            acceleration=motion,
            time_step=TIME_STEP,
            file=f"generated, seed {seed}",
            format="generated",
            details=(("spectrum", target.name), ("seed", str(seed)), ("scatter", f"{asked.scatter:g}")),
        )
        for seed, motion in zip(seeds, motions, strict=True)
    )
