"""The demand in SI units: a_g, S, spectrum, intensity."""

from dataclasses import dataclass, replace

import numpy as np

from core.codes.target_spectrum import Target
from core.ground.ground_motion import GroundMotion
from core.text.sentence import Sentence, notice
from core.units import G

WEAK_RECORDS = 0.9
"""Mean PGA of records taken as given over a_g S below which they are warned of."""

LARGE_AG = 0.6 * G
"""a_g on rock beyond that of any place in Italy, where it ends below 0.3 g at 475 years and at about 0.6 g at 2475:
questioned."""

LARGE_SCALING = 3.0
"""Scale factors of a record above this one are warned of."""

MIN_SHARE_OF_DEMAND = 1.0 / LARGE_SCALING
"""Share of a_g S below which records as given tell nothing of how much more than them a wall bears: the factor they
lack is one that is warned of."""


@dataclass(frozen=True)
class SeismicDemand:
    """The motion asked of a wall.

    ag, pga : a_g on rock and a_g S [m/s2]
    soil_factor : S [-]
    intensity : SI [m] or None
    intensity_source : given, spectrum, records_scaled or None
    target : elastic spectrum or None
    spectrum_code : NTC2018, EN1998 or an annex of it, the code of the target; None for a spectrum of a file or none
    confidence_on : capacity or demand
    record_scaling : as_given or pga
    period_range : asked for the check of compatibility [s], None where none is
    soil_factor_stated : S is given or follows from the spectrum
    return_period : T_R [years] or None
    hazard : (T_R [years], a_g on rock [m/s2]) of the site, rising; empty where it is not given
    weak_share : mean PGA of the records as given over a_g S where they are weaker than the demand, else None
    """

    limit_state: str
    ag: float
    soil_factor: float
    pga: float
    intensity: float | None
    intensity_source: str | None
    q_code: float
    confidence_factor: float
    zeta_target: float
    target: Target | None
    spectrum_code: str | None = None
    confidence_on: str = "capacity"
    record_scaling: str = "as_given"
    period_range: tuple[float, float] | None = None
    soil_factor_stated: bool = True
    return_period: float | None = None
    hazard: tuple[tuple[float, float], ...] = ()
    weak_share: float | None = None
    warnings: tuple[Sentence, ...] = ()

    def scaling(self, motion: GroundMotion) -> float:
        """Factor of a record at the demand, FC apart: 1 as given, or PGA to a_g S."""
        return self.pga / (motion.ground_pga or motion.pga) if self.record_scaling == "pga" else 1.0


def unusual_ag_notices(ag: float) -> list[Sentence]:
    """An a_g on rock [m/s2] few engineers mean: accepted, and questioned with the likely slip of unit."""
    return [notice("large_ag", ag=ag / G, meant=ag / G**2)] if ag > LARGE_AG else []


def complete_with_records(demand: SeismicDemand, motions: list[GroundMotion]) -> SeismicDemand:
    """The demand with what only the records give: an intensity that nothing else states, warnings."""
    notices = unusual_ag_notices(demand.ag)
    if not motions:
        return replace(demand, warnings=tuple(notices))
    if demand.record_scaling == "pga":
        notices.append(notice("pga_scaling"))
    large = sum(demand.scaling(motion) > LARGE_SCALING for motion in motions)
    if large:
        notices.append(notice("large_scaling", n=large))
    share = float(np.mean([motion.pga for motion in motions])) / demand.pga
    if demand.record_scaling == "as_given" and share < WEAK_RECORDS:
        notices.append(notice("weaker_records", share=share))
        demand = replace(demand, weak_share=share)
    if demand.intensity is None:
        intensity = mean_intensity(demand, motions)
        demand = replace(demand, intensity=intensity, intensity_source="records_scaled")
    return replace(demand, warnings=tuple(notices))


def mean_intensity(demand: SeismicDemand, motions: list[GroundMotion]) -> float:
    """Mean SI [m] of the records, each scaled to PGA = a_g S: not independent of them."""
    return float(np.mean([motion.housner_intensity * demand.pga / motion.pga for motion in motions]))
