"""The demand of a case in SI units: a_g, S, spectrum, intensity, and the motions it asks for."""

import re
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from core import target_spectrum
from core.artificial import compatible_motion
from core.case import Case
from core.case import Demand as Asked
from core.errors import InputError
from core.ground_motion import GroundMotion
from core.names import name_of
from core.notices import Notice, notice
from core.number import parse_number
from core.target_spectrum import Target
from core.units import CM, G

WEAK_RECORDS = 0.9
"""Mean PGA of records taken as given over a_g S below which they are warned of."""

LARGE_AG = 0.6 * G
"""a_g on rock beyond that of any place in Italy: questioned."""

LARGE_SCALING = 3.0
"""Scale factors of a record above this one are warned of."""

OTHER_UNITS = re.compile(r"\b(ms|hz|[cm]?m/s\^?2|[cm]?m/s²|gal|%g)(?![a-z])", re.IGNORECASE)
"""Units of a spectrum file that is not in s and g."""


@dataclass(frozen=True)
class DemandResult:
    """Demand in SI units. pga : a_g S [m/s2]; intensity : SI [m] or None; intensity_source : given,
    spectrum, records_scaled or None; target : elastic spectrum or None; asked : the keys of the case."""

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
    asked: Asked
    warnings: tuple[Notice, ...] = ()

    def scaling(self, motion: GroundMotion) -> float:
        """Factor of a record at the demand, FC apart: 1 as given, or PGA to a_g S."""
        return self.pga / motion.pga if self.asked.demand_scaling == "pga" else 1.0


def target_of(asked: Asked, base_dir: Path) -> Target | None:
    """The elastic spectrum of a demand. Raises InputError."""
    ag = asked.ag_g * G
    if asked.spectrum_file:
        path = base_dir / name_of(asked.spectrum_file)
        return target_spectrum.given(asked.spectrum_file, ag, asked.soil_factor or 1.0, _rows(path))
    chosen = asked.spectrum
    if chosen is None:
        return None
    if chosen.code == "EN1998":
        return target_spectrum.en1998(ag, chosen.type, chosen.soil)
    return target_spectrum.ntc2018(ag, chosen.f0, chosen.tc_star_s, chosen.soil, chosen.topography)


def _rows(path: Path) -> list[tuple[float, float]]:
    """(period [s], S_e [m/s2]) of a file: two columns, s and g; a head of words is skipped."""
    try:
        if not path.is_file():
            raise InputError(f"{path}: there is no such spectrum file")
        if path.stat().st_size > 1_000_000:
            raise InputError(f"{path}: larger than 1 MB: no spectrum of two columns")
        lines = path.read_text(encoding="utf-8-sig", errors="replace").splitlines()
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    rows = []
    for k, line in enumerate(lines, start=1):
        parts = line.replace(";", " ").split()
        try:
            period, ordinate = (parse_number(part) for part in parts)
        except (InputError, ValueError):
            wrong = OTHER_UNITS.search(line)
            if wrong and not rows:
                raise InputError(
                    f"{path}: line {k}: the head names {wrong[0]}: periods are read in s and S_e in g, "
                    "convert them"
                ) from None
            if rows and parts:
                raise InputError(
                    f"{path}: line {k}: two numbers expected, period in s and S_e in g, found "
                    f"{line.strip()[:60]!r}"
                ) from None
            continue
        rows.append((period, ordinate * G))
    return rows


def demand_of(case: Case, base_dir: Path) -> DemandResult | None:
    """The demand but for an intensity that only records can give. Raises InputError."""
    asked = case.demand
    if asked is None:
        return None
    target = target_of(asked, base_dir)
    ag = asked.ag_g * G
    soil = target.soil if target else asked.soil_factor or 1.0
    intensity, source = None, None
    if target:
        intensity, source = target_spectrum.housner_intensity(target), "spectrum"
    elif asked.housner_intensity_cm is not None:
        intensity, source = asked.housner_intensity_cm * CM, "given"
    return DemandResult(
        asked.limit_state, ag, soil, ag * soil, intensity, source, asked.q_code,
        asked.confidence_factor, asked.zeta_target, target, asked,
    )  # fmt: skip


def with_records(demand: DemandResult, motions: list[GroundMotion]) -> DemandResult:
    """The demand with what only the records give: an intensity that nothing else states, warnings."""
    found = []
    if demand.ag > LARGE_AG:
        found.append(notice("large_ag", ag=demand.ag / G))
    if not motions:
        return replace(demand, warnings=tuple(found))
    if demand.asked.demand_scaling == "pga":
        found.append(notice("pga_scaling"))
    large = sum(demand.scaling(motion) > LARGE_SCALING for motion in motions)
    if large:
        found.append(notice("large_scaling", n=large))
    share = float(np.mean([motion.pga for motion in motions])) / demand.pga
    if demand.asked.demand_scaling == "as_given" and share < WEAK_RECORDS:
        found.append(notice("weaker_records", share=share))
    if demand.intensity is None:
        intensity = mean_intensity(demand, motions)
        demand = replace(demand, intensity=intensity, intensity_source="records_scaled")
    return replace(demand, warnings=tuple(found))


def mean_intensity(demand: DemandResult, motions: list[GroundMotion]) -> float:
    """Mean SI [m] of the records, each scaled to PGA = a_g S: not independent of them."""
    return float(
        np.mean([motion.housner_intensity * demand.pga / motion.pga for motion in motions])
    )


def generated(case: Case, demand: DemandResult) -> list[GroundMotion]:
    """The motions of [generate], compatible with the demand's spectrum."""
    if case.generate is None:
        return []
    seeds = range(case.generate.seed, case.generate.seed + case.generate.count)
    return [
        GroundMotion(
            name=f"compatible {seed}",
            acceleration=compatible_motion(demand.target, seed),
            time_step=0.01,
            file=f"generated, seed {seed}",
            format="generated",
            details=(("spectrum", demand.target.name), ("seed", str(seed))),
        )
        for seed in seeds
    ]
