"""The equation of motion: one file per method, all behind one signature (see `taylor.integrate`)."""

from dataclasses import dataclass

import numpy as np

from core.kernel_cache import kernel
from core.rocking import newmark_paper, taylor
from core.rocking.model import RockingModel, rocking_model
from core.rocking.outcome import COLLAPSED, IMPACT_LIMIT, STABLE

__all__ = [
    "COLLAPSED",
    "IMPACT_LIMIT",
    "METHODS",
    "STABLE",
    "History",
    "Method",
    "RockingModel",
    "history",
    "rocking_model",
    "scan",
]

TAYLOR = 0
NEWMARK_PAPER = 1


@dataclass(frozen=True)
class Method:
    """A method by name, its integer code for `scan`, its option, and its order of convergence."""

    name: str
    code: int
    option: int
    order: int


METHODS = {
    "taylor": Method("taylor", TAYLOR, 8, 8),
    "newmark_paper": Method("newmark_paper", NEWMARK_PAPER, 0, 1),
    "newmark_paper_reset": Method("newmark_paper_reset", NEWMARK_PAPER, 1, 1),
}
"""Methods a user can ask for; option: the order of taylor, the reset of newmark_paper."""


@kernel
def integrate(
    code, ground, dt, scale, model, option, start, rotation, velocity, impact_time, impact_velocity
):
    """`taylor.integrate` or the same of another method, by its integer code."""
    if code == TAYLOR:
        return taylor.integrate(
            ground,
            dt,
            scale,
            model,
            option,
            start,
            rotation,
            velocity,
            impact_time,
            impact_velocity,
        )
    return newmark_paper.integrate(
        ground, dt, scale, model, option, start, rotation, velocity, impact_time, impact_velocity
    )


@kernel
def scan(code, option, ground, dt, scales, model, outcomes, peaks):
    """Analyses of one record at many multipliers; returns the number of clamped velocity ratios.

    ground : [m/s2], shape (n,); scales : multipliers [-], shape (m,), negative reverses the record;
    outcomes : results, codes of outcome.py, int64, shape (m,); peaks : results [rad], shape (m,).
    """
    none = np.empty(0)
    clamped = 0
    for j in range(scales.size):
        outcome, peak, _, clamps, _ = integrate(
            code, ground, dt, scales[j], model, option, (0.0, 0.0), none, none, none, none
        )
        outcomes[j] = outcome
        peaks[j] = peak
        clamped += clamps
    return clamped


@dataclass(frozen=True)
class History:
    """One analysis in full.

    rotation, velocity : at the samples up to the stop [rad], [rad/s]; impact_time [s],
    impact_velocity : just after each impact [rad/s]; outcome : a code of outcome.py;
    peak : largest |rotation|, the free motion after the record included [rad]; clamped : count of
    impacts whose Eq. 7 was held at 0.
    """

    rotation: np.ndarray
    velocity: np.ndarray
    impact_time: np.ndarray
    impact_velocity: np.ndarray
    outcome: int
    peak: float
    clamped: int


def history(
    ground: np.ndarray,
    dt: float,
    scale: float,
    model: RockingModel,
    method: Method = METHODS["taylor"],
    start: tuple[float, float] = (0.0, 0.0),
) -> History:
    """Rocking history of one wall under one scaled record (Eq. 1); units as `taylor.integrate`."""
    rotation = np.zeros(ground.size)
    velocity = np.zeros(ground.size)
    times = np.zeros(4096)
    while True:
        velocities = np.zeros(times.size)
        outcome, peak, impacts, clamped, done = integrate(
            method.code, ground, dt, scale, model, method.option, start,
            rotation, velocity, times, velocities,
        )  # fmt: skip
        if impacts <= times.size:
            break
        times = np.zeros(impacts)
    return History(
        rotation[:done], velocity[:done], times[:impacts], velocities[:impacts],
        outcome, peak, clamped,
    )  # fmt: skip
