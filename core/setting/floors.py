"""The floors of the walls above the ground: modes, spectra, motions."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from core.case.site import Building
from core.case.wall import Wall
from core.codes.demand import SeismicDemand
from core.codes.floor_spectrum import FloorSpectrum, estimated_period, first_mode
from core.codes.kinematic import STATE_DAMPING, KinematicAnalysis
from core.ground.floor_motion import Mode, floor_motion
from core.ground.ground_motion import GroundMotion
from core.ground.response_spectrum import pseudo_acceleration_spectrum
from core.text.sentence import Sentence, sentence

DEFAULTS = {"SLD": (1.0, 0.05)}
ULTIMATE = (1.5, 0.10)
"""Period of the damaged building over the elastic one, and its damping: C8.7.1.2.1.4 has 1.5 to 2.0 and 10 to 20 % at
the ultimate limit states."""

LOW_CODE, FAR_BELOW = 0.8, 0.4
"""Share of the records' mean spectrum below which the code's is warned of."""

CORNERS = ((1.5, 0.10), (1.5, 0.20), (2.0, 0.10), (2.0, 0.20))
"""The corners of what the clause allows at the ultimate limit states: zeta is looked at in each."""

MIN_STOREY, MAX_STOREY = 2.5, 5.0
ODD_PERIOD = 3.0
"""Heights of a storey [m], and ratios to the estimated period, outside which a building is questioned."""

CHART_PERIODS = np.geomspace(0.05, 4.0, 60)
"""Periods of the chart of code and records [s]."""


@dataclass(frozen=True)
class Floor:
    """The floor of a building that moves a wall: its spectrum and its motions.

    z : height of the hinge, of a wall held at its top of its middle [m]
    modes : of the building there; estimated : its period was not given
    motions : of the floor under each record; factors : of each at the demand, FC apart
    damping : of the rocking mechanism, C8.7.1.12
    spectrum : by the code, None without a spectrum of the demand
    """

    z: float
    modes: tuple[Mode, ...]
    estimated: bool
    motions: tuple[GroundMotion, ...]
    factors: tuple[float, ...]
    damping: float
    spectrum: FloorSpectrum | None

    @cached_property
    def mean_spectrum(self) -> np.ndarray:
        """Mean pseudo-acceleration spectrum of the floor motions at the demand, FC apart, at CHART_PERIODS [m/s2];
        zeros without records."""
        spectra = [
            factor * pseudo_acceleration_spectrum(m.acceleration, m.time_step, CHART_PERIODS, self.damping)
            for m, factor in zip(self.motions, self.factors, strict=True)
        ]
        return np.mean(spectra, axis=0) if spectra else np.zeros(CHART_PERIODS.size)

    @property
    def code_spectrum(self) -> np.ndarray | None:
        """S_eZ at the same periods [m/s2], None without a spectrum of the demand."""
        if self.spectrum is None:
            return None
        return self.spectrum.acceleration(CHART_PERIODS, self.damping)

    def code_over_records(self, mechanism: KinematicAnalysis) -> float | None:
        """Smallest ratio of S_eZ to the mean of the floor motions at CHART_PERIODS on [T_0, T_SLV]; None without
        either."""
        code = self.code_spectrum
        if code is None or not self.motions or mechanism.period is None:
            return None
        first = mechanism.period_0 or 0.0
        inside = (first <= CHART_PERIODS) & (mechanism.period >= CHART_PERIODS)
        if not inside.any():
            return None
        return float((code[inside] / self.mean_spectrum[inside]).min())


def modes_at(building: Building, z: float, limit_state: str) -> tuple[Mode, ...]:
    """Modes at this height [m] of the building as damaged at a limit state."""
    factor, damping = damaged_period_and_damping(building, limit_state)
    if building.modes:
        return tuple(Mode(factor * mode.period_s, mode.damping, mode.participation) for mode in building.modes)
    period = building.period_s or estimated_period(building.height_m)
    return first_mode(building.storeys, building.height_m, z, factor * period, damping)


def damaged_period_and_damping(building: Building, limit_state: str) -> tuple[float, float]:
    """(period over the elastic one, damping) of the building at a limit state."""
    factor, damping = DEFAULTS.get(limit_state, ULTIMATE)
    return building.period_factor or factor, building.damping or damping


def period_and_damping_bounds(building: Building, limit_state: str) -> tuple[tuple[float, float], ...]:
    """(period over the elastic one, damping) at the corners of what C8.7.1.2.1.4 allows, but for that at which the
    building is; at SLD, where it allows one, that one."""
    ends = (DEFAULTS[limit_state],) if limit_state in DEFAULTS else CORNERS
    factor, damping = damaged_period_and_damping(building, limit_state)
    if building.modes:
        damping = building.modes[0].damping
    return tuple(end for end in ends if end != (factor, damping))


def building_notes(building: Building, limit_state: str) -> list[Sentence]:
    """Notices on what is odd about a building: Sentences of the group "reason"."""
    notes = []
    storey = building.height_m / building.storeys
    if not MIN_STOREY <= storey <= MAX_STOREY:
        notes.append(sentence("reason", "odd_storeys", storey=storey))
    period = building.modes[0].period_s if building.modes else building.period_s
    expected = estimated_period(building.height_m)
    if period is not None and not expected / ODD_PERIOD <= period <= expected * ODD_PERIOD:
        notes.append(sentence("reason", "odd_building_period", period=period, expected=expected))
    factor, damping = damaged_period_and_damping(building, limit_state)
    weaker = factor < ULTIMATE[0] or (damping < ULTIMATE[1] and not building.modes)
    if limit_state not in DEFAULTS and weaker:
        notes.append(sentence("reason", "stiff_building", factor=factor, damping=damping))
    return notes


def make_floor(
    wall: Wall, building: Building | None, demand: SeismicDemand | None, motions: Sequence[GroundMotion]
) -> Floor | None:
    """The floor of a wall above the ground; None on it or without [building]. Without a demand the building is that of
    SLV."""
    z = wall.demand_height_m
    if z is None or not wall.above_ground or building is None:
        return None
    limit_state = demand.limit_state if demand else "SLV"
    height = min(z, building.height_m)
    modes = modes_at(building, height, limit_state)
    estimated = building.period_s is None and not building.modes
    spectrum = FloorSpectrum(demand.target, modes) if demand and demand.target else None
    moved = tuple(floor_motion(motion, modes) for motion in motions)
    mechanism = STATE_DAMPING.get(limit_state, STATE_DAMPING["SLV"])
    factors = tuple(demand.scaling(motion) if demand else 1.0 for motion in moved)
    return Floor(height, modes, estimated, moved, factors, mechanism, spectrum)
