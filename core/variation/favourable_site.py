"""Inputs of the demand and of the building that raise zeta."""

import math
from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from core.case.document import DemandEvidence
from core.case.site import Building, Demand, HazardRow, Spectrum
from core.codes.assumption import DEFAULT, GIVEN, DisplayValue
from core.codes.demand import SeismicDemand
from core.codes.floor_spectrum import estimated_period, first_mode
from core.codes.limits import ORDINARY_LIFE, return_period
from core.codes.national_hazard import national_range
from core.codes.spectrum_codes import CODES, EUROPEAN, NATIONAL
from core.codes.target_spectrum import housner_intensity
from core.errors import InputError
from core.setting.check_input import CheckInput
from core.setting.demand_input import has_hazard_at, hazard_covers, interpolate_hazard, read_target_spectrum, rescale_ag
from core.setting.floors import damaged_period_and_damping, period_and_damping_bounds
from core.text.sentence import Key, Number, Sentence, sentence
from core.units import G
from core.variation.favourable_input import (
    Alternative,
    FavourableInput,
    SceneChange,
    at_period,
    demand_change,
    single_alternative,
    zeta_for_sorting,
    zeta_phrase,
)


def favourable_demand(scene: CheckInput) -> Iterator[FavourableInput]:
    """Inputs that make the demand milder than the code's: a limit state whose a_g nothing shows to be its own, a zeta
    required below 1, a soil factor below 1, a short reference period, a spectrum that is not the code's."""
    demand, asked = scene.demand, scene.asked
    reasons = asked.evidence
    if demand.limit_state == "SLC":
        if demand.return_period is not None and has_hazard_at(asked, demand.return_period):
            reasons += (DemandEvidence("calculation", f"T_R {demand.return_period:.0f}", of="limit_state"),)
        end = Alternative(demand_change(limit_state="SLV"), "SLV")
        yield single_alternative("limit_state", "lift_limit_state", reasons, "SLC", end)
    if demand.zeta_target < 1.0:
        end, target = Alternative(demand_change(zeta_target=1.0), 1.0), demand.zeta_target
        yield single_alternative("zeta_target", "lift_zeta_target", reasons, target, end, target=target)
    if demand.target is None and demand.soil_factor < 1.0:
        end = Alternative(demand_change(soil_factor=1.0, pga=demand.ag), 1.0)
        yield single_alternative(
            "soil_factor", "lift_soil_factor", reasons, demand.soil_factor, end, given=demand.soil_factor
        )
    yield from _of_the_life(scene)
    yield from _of_the_spectrum(scene)


def _of_the_life(scene: CheckInput) -> Iterator[FavourableInput]:
    """A reference period shorter than that of ordinary works of class II, where the hazard says what a_g is then."""
    demand, asked = scene.demand, scene.asked
    life = asked.reference_period
    if life is None or life >= ORDINARY_LIFE * (1.0 - 1e-9) or not demand.hazard:
        return
    years, known = np.log(demand.hazard).T
    ag = math.exp(float(np.interp(math.log(return_period(ORDINARY_LIFE, demand.limit_state)), years, known)))
    there = rescale_ag(demand, asked, Path(), ag / demand.ag)
    reasons, given = asked.evidence, sentence("added", "reference_life", years=life)
    end = Alternative(lambda scene: scene.with_demand(there), sentence("added", "reference_life", years=ORDINARY_LIFE))
    yield single_alternative(
        "nominal_life_years", "lift_life", reasons, given, end, years=life, least=ORDINARY_LIFE, ag=ag / G
    )


def _of_the_spectrum(scene: CheckInput) -> Iterator[FavourableInput]:
    """F_0 and T_C* that no place of Italy has, and another spectrum than that of NTC 2018 which the hazard gives."""
    demand, asked = scene.demand, scene.asked
    reasons, spectrum = asked.evidence, asked.spectrum
    if spectrum is not None and spectrum.code == NATIONAL:
        for key, (least, most) in zip(("f0", "tc_star_s"), national_range(), strict=True):
            given = getattr(spectrum, key)
            if given < least * (1.0 - 1e-3):
                worst: dict[str, Any] = {key: most}
                there = _with_spectrum(demand, asked, replace(spectrum, **worst))
                said = {"name": Key(key), "given": given, "least": least, "most": most}
                yield single_alternative(key, "lift_outside_italy", reasons, given, _under(there, most), **said)
    elif demand.target is not None and (row := _row_of(demand, asked) or _widest_row(asked)) is not None:
        soils = (spectrum.soil,) if spectrum else SOILS
        given = CODES[spectrum.code].name if spectrum else asked.spectrum_file or ""
        ends = []
        for soil in soils:
            there = _with_spectrum(demand, asked, Spectrum(NATIONAL, soil, row.f0, row.tc_star_s, "T1"))
            ends.append(_under(there, sentence("added", "ntc_spectrum", soil=soil)))

        def words(zetas, _):
            k = min(range(len(soils)), key=lambda k: zeta_for_sorting(zetas[k]))
            return sentence("reason", "lift_spectrum", zeta=zeta_phrase(zetas[k]), name=given, soil=soils[k])

        yield FavourableInput("lift_spectrum", "spectrum", reasons, given, tuple(ends), words)
    elif spectrum is not None and not CODES[spectrum.code].seen_in_print:
        ends = [
            _under(
                _with_spectrum(demand, asked, Spectrum(EUROPEAN, spectrum.soil, type=kind)),
                sentence("added", "en1998_spectrum", type=kind, soil=spectrum.soil),
            )
            for kind in (1, 2)
        ]
        name, soil = CODES[spectrum.code].name, spectrum.soil

        def compared(zetas, _):
            return sentence(
                "reason", "lift_annex", zeta=zeta_phrase(min(zetas, key=zeta_for_sorting)), name=name, soil=soil
            )

        yield FavourableInput("lift_annex", "spectrum", reasons, name, tuple(ends), compared)
    elif spectrum is not None and spectrum.type == 2:
        try:
            there = _with_spectrum(demand, asked, replace(spectrum, type=1))
        except InputError:  # an annex may have the other type alone
            return
        types = [sentence("word", "spectrum_type", type=n) for n in (2, 1)]
        yield single_alternative("spectrum", "lift_type", reasons, types[0], _under(there, types[1]))


SOILS = ("A", "B", "C", "D", "E")
"""Soils of NTC 2018 beside which the spectrum of a file stands, whose soil nobody tells."""


def _row_of(demand: SeismicDemand, asked: Demand) -> HazardRow | None:
    """F_0 and T_C* of the hazard at the return period of the demand, None where it has none."""
    years = demand.return_period
    if years is None or not asked.hazard or not hazard_covers(asked.hazard, years):
        return None
    row = interpolate_hazard(asked.hazard, years)
    return None if row.f0 is None or row.tc_star_s is None else row


def _widest_row(given: Demand) -> HazardRow | None:
    """The largest F_0 and T_C* of Italy, beside which the spectrum of a file stands whose place nobody tells; None of
    the spectrum of a code."""
    if given.spectrum is not None or given.spectrum_file is None:
        return None
    (_, f0), (_, tc_star) = national_range()
    return HazardRow(0.0, 0.0, f0, tc_star)


def _with_spectrum(demand: SeismicDemand, asked: Demand, spectrum: Spectrum) -> SeismicDemand:
    """The demand with this spectrum."""
    target = read_target_spectrum(replace(asked, ag_g=demand.ag / G, spectrum=spectrum, spectrum_file=None), Path())
    assert target is not None
    return replace(
        demand,
        target=target,
        intensity=housner_intensity(target),
        soil_factor=target.soil,
        pga=demand.ag * target.soil,
        spectrum_code=spectrum.code,
    )


def _under(there: SeismicDemand, value: DisplayValue) -> Alternative:
    return Alternative(lambda scene: scene.with_demand(there), value)


def _of_building(**values) -> SceneChange:
    def change(scene: CheckInput) -> CheckInput:
        assert scene.building is not None
        return scene.replace_parts(building=replace(scene.building, **values))

    return change


def _building_words(factor: float, damping: float) -> Sentence:
    """The ratio of the period to the elastic one, and the damping of a building, as the table shows them."""
    return sentence("added", "period_and_damping", factor=factor, damping=damping)


def _building_at(factor: float, damping: float) -> SceneChange:
    """The building at this ratio to its elastic period, and with this damping."""

    def change(scene: CheckInput) -> CheckInput:
        building = scene.building
        assert building is not None
        modes = tuple(replace(mode, damping=damping) for mode in building.modes)
        damped = {"modes": modes} if modes else {"damping": damping}
        return scene.replace_parts(building=replace(building, period_factor=factor, **damped))

    return change


def _by_first_mode(share: float) -> SceneChange:
    """The building by its first mode alone, with this participation."""

    def change(scene: CheckInput) -> CheckInput:
        building = scene.building
        assert building is not None
        first = replace(building.modes[0], participation=share)
        return scene.replace_parts(building=replace(building, modes=(first,)))

    return change


def favourable_building(scene: CheckInput, building: Building) -> Iterator[FavourableInput]:
    """Inputs of the building, and of the height at which its motion is taken, that raise zeta."""
    wall, asked, limit_state = scene.wall, scene.asked, scene.demand.limit_state
    base, felt = wall.base_z_m, wall.demand_height_m
    assert base is not None and felt is not None
    given = building.modes[0].period_s if building.modes else building.period_s
    expected = estimated_period(building.height_m)
    if given is not None and abs(expected / given - 1.0) > 0.01:
        end = Alternative(partial(at_period, period=expected), expected)
        yield single_alternative("period_s", "lift_period", asked.evidence, given, end, period=expected)
    if ends := period_and_damping_bounds(building, limit_state):

        def words(zetas, _):
            k = min(range(len(ends)), key=lambda k: zeta_for_sorting(zetas[k]))
            factor, damping = ends[k]
            return sentence("reason", "other_building", factor=factor, damping=damping, zeta=Number(zetas[k]))

        given = bool(building.modes) or (building.period_factor, building.damping) != (None, None)
        there = tuple(Alternative(_building_at(*end), _building_words(*end)) for end in ends)
        value = _building_words(*damaged_period_and_damping(building, limit_state))
        source = GIVEN if given else DEFAULT
        yield FavourableInput("other_building", "building", asked.evidence, value, there, words, source)
    if building.modes:
        _, damping = damaged_period_and_damping(building, limit_state)
        z = min(felt, building.height_m)
        (expected,) = first_mode(building.storeys, building.height_m, z, 1.0, damping)
        given = building.modes[0].participation
        share = max(abs(expected.participation), abs(given))
        if len(building.modes) > 1 or abs(given) < share * (1.0 - 1e-6):  # modes of opposite signs cancel
            code = "lift_modes" if len(building.modes) > 1 else "lift_participation"
            end, reasons = Alternative(_by_first_mode(share), share), asked.evidence
            yield single_alternative("participation", code, reasons, given, end, given=given, expected=share)
