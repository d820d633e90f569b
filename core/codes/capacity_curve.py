"""The capacity curve of a wall over the demand, displacement against acceleration (Circolare 7/2019 C8.7.1.3)."""

from dataclasses import dataclass

import numpy as np

from core.codes.demand import SeismicDemand
from core.codes.kinematic import STATE_DAMPING, KinematicAnalysis, capacity_acceleration
from core.codes.target_spectrum import displacement

CURVE_PERIODS = np.concatenate([np.linspace(0.0, 0.5, 51), np.linspace(0.52, 4.0, 175)])
"""Periods of the curve of the demand [s]."""

CAPACITY_POINTS = 41
"""Points of the curve of a wall held at its top, which is not straight."""

CURVE_END_FACTOR = 1.25
"""How far the curve of the demand is drawn: times the largest displacement of the check."""


@dataclass(frozen=True)
class CapacityCurve:
    """Curves of d [m] and a [m/s2] of the equivalent oscillator.

    capacity : a(d) = alpha(d) g / (e* FC), from d = 0 to d_0, the ends of its straight parts: ((d, a), ...), twice the
        same d where a tie breaks
    demand_d, demand_a : S_De and S_e at the damping of the check, by period; above the ground of the ground
    floor_d, floor_a : the same of the floor, empty on the ground
    damping : of both [-]
    """

    capacity: tuple[tuple[float, float], ...]
    demand_d: np.ndarray
    demand_a: np.ndarray
    floor_d: np.ndarray
    floor_a: np.ndarray
    damping: float


def capacity_curve(mechanism: KinematicAnalysis, demand: SeismicDemand) -> CapacityCurve | None:
    """The curves of the nonlinear check of C8.7.1.2.1.8; None where that is not made."""
    target = demand.target
    if mechanism.d_limit is None or mechanism.s_de is None or target is None:
        return None
    damping = STATE_DAMPING[demand.limit_state]
    most = CURVE_END_FACTOR * max(mechanism.d0, mechanism.s_de)

    def shown(d, a) -> tuple[np.ndarray, np.ndarray]:
        inside = d <= most
        return d[inside], a[inside]

    ground = shown(displacement(target, CURVE_PERIODS, damping), target.acceleration(CURVE_PERIODS, damping))
    floor = np.zeros(0), np.zeros(0)
    if mechanism.floor is not None:
        felt = mechanism.floor.acceleration(CURVE_PERIODS, damping)
        floor = shown(felt * (CURVE_PERIODS / (2.0 * np.pi)) ** 2, felt)
    # the friction of return walls is lost over a slip: none of it in the curve
    sums, confidence = mechanism.moved, demand.confidence_factor
    inside = [end for end in sums.ends_of_ties() if 0.0 < end < sums.d0]
    ends = [0.0, *(d for end in inside for d in (end, end * (1.0 + 1e-9))), sums.d0]
    if sums.bending is not None:
        ends = np.linspace(0.0, sums.d0, CAPACITY_POINTS).tolist()
    line = tuple((float(d), capacity_acceleration(sums, d, confidence)) for d in ends)
    return CapacityCurve(line, ground[0], ground[1], floor[0], floor[1], damping)
