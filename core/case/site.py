"""The sections of the site: the demand with its spectrum and hazard, the building."""

from dataclasses import MISSING, dataclass

from core.case.document import DemandEvidence
from core.case.keys import choice_key, key, number_key, path_key, text_key
from core.codes.limits import return_period
from core.codes.spectrum_codes import CODES
from core.codes.target_spectrum import NTC_TOPOGRAPHY, SOILS
from core.known import require_value


@dataclass(frozen=True)
class Spectrum:
    """[demand.spectrum]: the elastic spectrum of a code, which says which of the keys it needs; S follows from it."""

    code: str = choice_key(*CODES)
    soil: str = choice_key(*SOILS, form="code")
    f0: float | None = number_key(2.0, 4.0, form="code", filled=True)
    tc_star_s: float | None = number_key(0.05, 1.0, unit="s", form="code", filled=True)
    topography: str | None = choice_key(*NTC_TOPOGRAPHY, default=None, form="code", filled=True)
    type: int | None = number_key(1, 2, whole=True, form="code", filled=True, listed=True)
    vs30_m_s: float | None = number_key(50.0, 3000.0, unit="m/s", form="code", filled=True)
    contribution_k: float | None = number_key(0.5, 3.0, form="code", filled=True)


@dataclass(frozen=True)
class HazardRow:
    """[[demand.hazard]]: a row of the hazard of the site (NTC 2018, Annex A), return periods rising."""

    return_period_years: float = number_key(1.0, 100000.0, MISSING, unit="years")
    ag_g: float = number_key(0.001, 5.0, MISSING, unit="g")
    f0: float | None = number_key(2.0, 4.0)
    tc_star_s: float | None = number_key(0.05, 1.0, unit="s")


FULL_FACTOR = 1.35
"""FC of LC1, and where the compressive strength is not in alpha (Circolare 7/2019 C8.7.1.2.1)."""

KNOWLEDGE = {"LC2": 1.20, "LC3": 1.00}
"""Levels of knowledge above LC1 -> least FC (Circolare 7/2019 Tab. C8.5.IV)."""


def least_factor(level: str | None) -> float:
    """Least FC of a level of knowledge."""
    return KNOWLEDGE.get(level or "", FULL_FACTOR)


@dataclass(frozen=True)
class Demand:
    """[demand]: the motion asked of the wall; ag_g on rock ("su suolo rigido"), without S."""

    ag_g: float = number_key(0.001, 5.0, MISSING, unit="g")
    limit_state: str = choice_key("SLV", "SLC", "SLD", default="SLV")
    soil_factor: float | None = number_key(0.9, 5.0)
    spectrum: Spectrum | None = key("spectrum", of=Spectrum)
    spectrum_file: str | None = path_key(None)
    housner_intensity_cm: float | None = number_key(0.1, 5000.0, unit="cm")
    q_code: float = number_key(1.0, 10.0, 2.0, form="check")
    confidence_factor: float = number_key(1.0, 1.35, 1.35, form="knowledge")
    knowledge_level: str | None = choice_key("LC1", *KNOWLEDGE, default=None, form="knowledge")
    confidence_on: str = choice_key("capacity", "demand", default="capacity", form="knowledge")
    period_range_s: tuple[float, float] | None = key("range", unit="s", form="check")
    demand_scaling: str = choice_key("as_given", "pga", default="as_given", form="check")
    zeta_target: float = number_key(0.1, 2.0, 1.0, form="check")
    site: str = text_key(form="site")
    coordinates: str = text_key(form="site")
    nominal_life_years: float | None = number_key(1.0, 1000.0, unit="years", form="site")
    use_class_factor: float | None = number_key(0.7, 5.0, form="site")
    return_period_years: float | None = number_key(1.0, 100000.0, unit="years", form="site")
    hazard: tuple[HazardRow, ...] = key("tables", (), of=HazardRow)
    hazard_file: str | None = path_key(None)
    limit_states: tuple[str, ...] = key("list", (), of=choice_key("SLD", "SLV", "SLC"))
    evidence: tuple[DemandEvidence, ...] = key("tables", (), of=DemandEvidence)

    @property
    def reference_period(self) -> float | None:
        """V_R = V_N C_U [years] (NTC 2018 Eq. 2.4.1); None without either."""
        if self.nominal_life_years is None or self.use_class_factor is None:
            return None
        return self.nominal_life_years * self.use_class_factor

    @property
    def return_period(self) -> float | None:
        """T_R [years] as given, else of V_R (NTC 2018 Eq. 3.2.0); None without either."""
        if self.return_period_years is not None or self.reference_period is None:
            return self.return_period_years
        return return_period(self.reference_period, self.limit_state)


@dataclass(frozen=True)
class BuildingMode:
    """[[building.modes]]: a mode of the building; participation is gamma psi at the walls."""

    period_s: float = number_key(0.02, 5.0, MISSING, unit="s")
    damping: float = number_key(0.01, 0.3, MISSING)
    participation: float = number_key(-5.0, 5.0, MISSING)


@dataclass(frozen=True)
class FloorLoad:
    """[[building.floors]]: a floor or a roof that spans from one wall to another, and bears on each with half of its
    span.

    level_m : above the ground, where it bears; g_kn_m2, q_kn_m2, psi_2 : permanent and variable, of which psi_2 counts
    from_d_m, to_d_m : from the outer face of each wall inward to where it bears
    mass : held elsewhere, or pushing the walls horizontally
    """

    name: str = text_key(MISSING)
    level_m: float = number_key(0.0, 300.0, MISSING, unit="m", exclusive=True)
    from_wall: str = text_key(MISSING)
    from_d_m: float = number_key(0.0, 20.0, MISSING, unit="m")
    span_m: float = number_key(0.5, 50.0, MISSING, unit="m")
    g_kn_m2: float = number_key(0.0, 100.0, MISSING, unit="kN/m2", exclusive=True)
    mass: str = choice_key("none", "horizontal")
    to_wall: str = text_key()
    to_d_m: float | None = number_key(0.0, 20.0, unit="m")
    q_kn_m2: float | None = number_key(0.0, 100.0, unit="kN/m2")
    psi_2: float | None = number_key(0.0, 1.0)

    def bears_on(self, wall: str) -> list[float]:
        """Distances from the outer face of a wall at which it bears on it [m]: none of another wall."""
        ends = (self.from_wall, self.from_d_m), (self.to_wall, self.to_d_m)
        return [require_value(d) for name, d in ends if name == wall]


@dataclass(frozen=True)
class Building:
    """[building]: what carries the walls above the ground (Circolare 7/2019 C7.2.3, C8.7.1.2.1.4).

    period_s : elastic T_1; without it and without modes 0.05 height^0.75, said to be an estimate
    period_factor, damping : of the damaged building; at the ultimate limit states 1.5 and 0.10, at SLD 1.0 and 0.05
    """

    height_m: float = number_key(2.0, 300.0, MISSING, unit="m")
    storeys: int = number_key(1, 60, MISSING, whole=True)
    period_s: float | None = number_key(0.02, 5.0, unit="s")
    modes: tuple[BuildingMode, ...] = key("tables", (), of=BuildingMode)
    period_factor: float | None = number_key(1.0, 2.5)
    damping: float | None = number_key(0.01, 0.3, form_unit="%")
    floors: tuple[FloorLoad, ...] = key("tables", (), of=FloorLoad)
