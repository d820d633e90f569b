"""[site]: the demand of a place, from the national grid of hazard (NTC 2018 3.2)."""

import math
from dataclasses import dataclass, fields, replace
from functools import lru_cache

from core.case.keys import choice_key, number_key, text_key
from core.case.site import Demand, HazardRow, Spectrum
from core.codes.limits import EXCEEDANCE, SAME_PERIOD, return_period
from core.codes.national_hazard import (
    MIN_REFERENCE_PERIOD,
    RETURN_PERIODS,
    USE_CLASSES,
    SiteHazard,
    distance,
    hazard_at,
    municipality,
    reference_life,
)
from core.codes.spectrum_codes import NATIONAL
from core.errors import InputError, section
from core.text.sentence import Key, Sentence, notice

HERE = section("[site]")

MAX_SEAT_DISTANCE = 40.0
"""No place of a municipality is farther from its seat [km]."""

SITE_KEYS = ("ag_g", "nominal_life_years", "use_class_factor", "hazard")
"""Keys of the demand that follow from the place; of a spectrum of NTC 2018 F_0 and T_C* too."""

OF_SPECTRUM = ("f0", "tc_star_s")
"""Keys of a spectrum of NTC 2018 that follow from the place."""


@dataclass(frozen=True)
class Site:
    """[site]: where the building stands. latitude, longitude : of the building; without them the seat of the
    municipality. nominal_life_years : V_N; use_class : C_U (NTC 2018 2.4)"""

    municipality: str = text_key()
    province: str = text_key()
    latitude: float | None = number_key(30.0, 50.0)
    longitude: float | None = number_key(0.0, 25.0)
    nominal_life_years: float = number_key(10.0, 1000.0, 50.0, unit="years")
    use_class: str = choice_key(*USE_CLASSES, default="II")

    @property
    def point(self) -> tuple[float, float]:
        """Latitude and longitude [degrees]. Raises InputError."""
        if self.latitude is not None and self.longitude is not None:
            return self.latitude, self.longitude
        if (self.latitude is None) != (self.longitude is None):
            raise InputError("site_half_a_point", place=(HERE,))
        if not self.municipality:
            raise InputError("site_nowhere", place=(HERE,))
        seat = municipality(self.municipality, self.province)
        return seat.latitude, seat.longitude

    def _check_name(self) -> None:
        """Refuse a point that is not in the municipality it is called by."""
        if not self.municipality or None in (self.latitude, self.longitude):
            return
        try:
            seat = municipality(self.municipality, self.province)
        except InputError:  # a name of the engineer's own
            return
        km = distance(self.point, (seat.latitude, seat.longitude))
        if km > MAX_SEAT_DISTANCE:
            raise InputError("site_elsewhere", place=(HERE,), name=seat.name, km=km, most=MAX_SEAT_DISTANCE)

    @property
    def reference_life(self) -> float:
        """V_R [years]."""
        return reference_life(self.nominal_life_years, self.use_class)

    @property
    def hazard(self) -> SiteHazard:
        """Hazard at the point of the site. Raises InputError."""
        try:
            self._check_name()
            return _hazard(*self.point)
        except InputError as error:
            raise error if error.place else error.at(HERE) from None

    def return_period(self, state: str) -> float:
        """T_R [years] of a limit state, not rounded (NTC 2018 Eq. 3.2.0)."""
        return return_period(self.reference_life, state)


@lru_cache(maxsize=64)
def _hazard(latitude: float, longitude: float) -> SiteHazard:
    return hazard_at(latitude, longitude)


@lru_cache(maxsize=64)
def hazard_rows(site: Site) -> tuple[HazardRow, ...]:
    """The hazard at the return periods of the table, and at those of the limit states, where they are within it."""
    hazard = site.hazard
    states = (site.return_period(state) for state in EXCEEDANCE)
    years = sorted({*RETURN_PERIODS, *(t for t in states if RETURN_PERIODS[0] < t < RETURN_PERIODS[-1])})
    rows = [HazardRow(t, *hazard.at(t)) for t in years]
    kept = rows[:1]
    for row in rows[1:]:
        if row.ag_g > kept[-1].ag_g and row.return_period_years > kept[-1].return_period_years * (1.0 + 1e-9):
            kept.append(row)
    return tuple(kept)


def site_demand_values(site: Site, limit_state: str) -> dict:
    """Values of a demand that follow from the place: DERIVED and OF_SPECTRUM."""
    values = site.hazard.at(site.return_period(limit_state))
    return {
        "ag_g": values.ag_g,
        "nominal_life_years": site.nominal_life_years,
        "use_class_factor": site.reference_life / site.nominal_life_years,
        "hazard": hazard_rows(site),
        "f0": values.f0,
        "tc_star_s": values.tc_star_s,
    }


def fill_from_site(site: Site, demand: dict) -> dict:
    """The mapping of a demand with what the place gives. Raises InputError for another value in it, beyond the digits
    it is printed with, and for what a place makes needless."""
    here, state = section("[demand]"), demand.get("limit_state", "SLV")
    for key in ("site", "coordinates", "hazard_file"):
        if demand.get(key):
            raise InputError("site_gives", place=(here,), key=key, section=Key("[site]"))
    if state not in EXCEEDANCE:
        return demand  # refused with the other keys
    made, derived_values = dict(demand), site_demand_values(site, state)
    years, own = made.pop("return_period_years", None), site.return_period(state)
    if years is not None and not (isinstance(years, (int, float)) and math.isclose(years, own, rel_tol=SAME_PERIOD)):
        raise InputError("site_disagrees", place=(here,), key="return_period_years", given=years, stated=own)
    given = made.pop("hazard", ())
    if not isinstance(given, (list, tuple)) or not all(isinstance(row, dict) for row in given):
        return demand  # refused with the other keys
    for row in given:
        _agree_row(dict(row), site)
    for key in SITE_KEYS:
        _agree(made, key, derived_values[key], "[demand]")
    spectrum = demand.get("spectrum")
    if isinstance(spectrum, dict) and spectrum.get("code") == NATIONAL:
        made["spectrum"] = dict(spectrum)
        for key in OF_SPECTRUM:
            _agree(made["spectrum"], key, derived_values[key], "[demand.spectrum]")
    made["hazard"] = [
        {entry.name: getattr(row, entry.name) for entry in fields(row)} for row in derived_values["hazard"]
    ]
    return made


def _agree_row(row: dict, site: Site) -> None:
    """A row of a hazard that is given is that of the place."""
    years = row.get("return_period_years")
    if isinstance(years, (int, float)) and years > 0.0:
        for key, stated in site.hazard.at(years)._asdict().items():
            _agree(row, key, stated, "[[demand.hazard]]")


def _agree(table: dict, key: str, stated, where: str) -> None:
    """Give a key its value; one that is given must be it, to its own digits."""
    given = table.get(key)
    if given is None:
        table[key] = stated
        return
    digits = len(f"{given:.10g}".partition(".")[2]) if isinstance(given, (int, float)) else 0
    if not isinstance(given, (int, float)) or abs(given - stated) > 0.5 * 10.0 ** -max(2, digits) * (1.0 + 1e-9):
        raise InputError("site_disagrees", place=(section(where),), key=key, given=given, stated=stated)
    table[key] = stated


def apply_site(site: Site | None, demand: Demand | None) -> Demand | None:
    """A demand with what its place gives, as it was where the place gives nothing yet."""
    if site is None or demand is None:
        return demand
    try:
        values = site_demand_values(site, demand.limit_state)
    except (InputError, TypeError):
        return demand
    spectrum = demand.spectrum
    if isinstance(spectrum, Spectrum) and spectrum.code == NATIONAL:
        spectrum = replace(spectrum, **{key: values[key] for key in OF_SPECTRUM})
    return replace(demand, spectrum=spectrum, **{key: values[key] for key in SITE_KEYS})


def drop_site_values(site: Site | None, demand: dict) -> dict:
    """The mapping of a demand as a file has it beside its place."""
    if site is None:
        return demand
    kept = {key: value for key, value in demand.items() if key not in SITE_KEYS}
    if isinstance(kept.get("spectrum"), dict):
        kept["spectrum"] = {key: value for key, value in kept["spectrum"].items() if key not in OF_SPECTRUM}
    return kept


def site_notices(site: Site, limit_state: str) -> list[Sentence]:
    """Notices on the demand of a place."""
    sentences, years = [], site.return_period(limit_state)
    if site.latitude is None:
        sentences.append(notice("site_of_a_seat", name=site.municipality))
    if not RETURN_PERIODS[0] <= years <= RETURN_PERIODS[-1]:
        end = RETURN_PERIODS[0] if years < RETURN_PERIODS[0] else RETURN_PERIODS[-1]
        sentences.append(notice("site_beyond_the_table", years=years, end=end, state=limit_state))
    if site.reference_life == MIN_REFERENCE_PERIOD > site.nominal_life_years * USE_CLASSES[site.use_class]:
        sentences.append(notice("site_least_life", least=MIN_REFERENCE_PERIOD))
    if site.hazard.island:
        sentences.append(notice("site_on_an_island", group=site.hazard.island))
    return sentences
