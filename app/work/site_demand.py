"""The demand of a case as its place comes, changes and goes."""

from dataclasses import replace

from app.work.draft import TO_BE_GIVEN
from core.case.place import OF_SPECTRUM, SITE_KEYS, apply_site, site_demand_values
from core.case.schema import Case
from core.case.site import Demand, HazardRow, Spectrum
from core.codes.spectrum_codes import NATIONAL
from core.errors import InputError

DEMAND_DECIMALS = 3
"""Decimals of a_g [g], F_0 and T_C* [s] that stay where a place goes."""


def update_demand(before: Case, case: Case) -> Demand | None:
    """The demand of a case that takes the place of another: as its place gives it, with a_g still to be given where the
    place gives nothing yet, and rounded where the place has just gone."""
    demand = case.demand
    if demand is None:
        return None
    if case.site is None:
        return released(demand) if before.site is not None else demand
    try:
        site_demand_values(case.site, demand.limit_state)
    except (InputError, TypeError):  # no point, no V_N
        return replace(demand, ag_g=TO_BE_GIVEN, hazard=())
    return apply_site(case.site, demand)


def released(demand: Demand) -> Demand:
    """A demand that follows from a place no more, with the digits a person would write."""
    rows: list[HazardRow] = []
    for row in demand.hazard:
        years = round(row.return_period_years, DEMAND_DECIMALS)
        made = HazardRow(years, *(_rounded(value) for value in (row.ag_g, row.f0, row.tc_star_s)))
        if not rows or (made.ag_g > rows[-1].ag_g and years > rows[-1].return_period_years):
            rows.append(made)
    spectrum = demand.spectrum
    if isinstance(spectrum, Spectrum) and spectrum.code == NATIONAL:
        spectrum = replace(spectrum, **{key: _rounded(getattr(spectrum, key)) for key in OF_SPECTRUM})
    return replace(demand, ag_g=_rounded(demand.ag_g), spectrum=spectrum, hazard=tuple(rows))


def restored(demand: Demand, before: Demand) -> Demand:
    """A demand whose place gave nothing, with the values from before that place."""
    spectrum = demand.spectrum
    former = before.spectrum
    if isinstance(spectrum, Spectrum) and isinstance(former, Spectrum) and spectrum.code == former.code == NATIONAL:
        spectrum = replace(spectrum, **{key: getattr(former, key) for key in OF_SPECTRUM})
    return replace(demand, spectrum=spectrum, **{key: getattr(before, key) for key in SITE_KEYS})


def _rounded(value):
    return round(value, DEMAND_DECIMALS) if isinstance(value, float) else value
