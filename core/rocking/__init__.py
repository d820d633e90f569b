"""The equation of motion: one file per method, all behind one signature (see `taylor.integrate`)."""

import math
from dataclasses import dataclass

import numpy as np

from core.kernel_cache import kernel
from core.rocking import dormand_prince, newmark_paper, passes, stepped, taylor
from core.rocking.model import RockingModel, rocking_model
from core.rocking.outcome import COLLAPSED, IMPACT_LIMIT, STABLE
from core.rocking.passes import Grounds

__all__ = [
    "AUTO",
    "COLLAPSED",
    "IMPACT_LIMIT",
    "METHODS",
    "STABLE",
    "Grounds",
    "History",
    "Method",
    "RockingModel",
    "concrete",
    "history",
    "rocking_model",
    "scan",
    "scan_records",
]

TAYLOR = 0
NEWMARK_PAPER = 1
NO_TABLE = np.empty(0)


@dataclass(frozen=True)
class Method:
    """A way to integrate the motion.

    name; code : of the kernels; option : order of taylor, reset of newmark_paper, steps a sample of
    newmark_events, rk4 and linearised, -log10 of the tolerance of dormand_prince; order : of
    convergence, 0 where a method does not converge to the truth.
    """

    name: str
    code: int
    option: int
    order: int

    @property
    def table(self) -> np.ndarray:
        """Tableau of dormand_prince and room for its 2 x 12 stages."""
        if self.code != stepped.DORMAND_PRINCE:
            return NO_TABLE
        return np.append(dormand_prince.tableau(), np.zeros(2 * dormand_prince.STAGES))


METHODS = {
    method.name: method
    for method in (
        Method("taylor", TAYLOR, 8, 8),
        Method("taylor_6", TAYLOR, 6, 6),
        Method("newmark_paper", NEWMARK_PAPER, 0, 1),
        Method("newmark_paper_reset", NEWMARK_PAPER, 1, 1),
        Method("newmark_events", stepped.NEWMARK_EVENTS, 1, 2),
        Method("rk4", stepped.RK4, 1, 4),
        Method("dormand_prince", stepped.DORMAND_PRINCE, 12, 8),
        Method("linearised", stepped.LINEARISED, 1, 0),
    )
}
"""Methods a user can ask for by name."""

AUTO = Method("auto", TAYLOR, 0, 0)
"""The cheaper order of the Taylor series, both to the same tolerance, see `concrete`."""

ORDER_SIX_UP_TO = 0.005
"""Growth over a sample, p dt, up to which order 6 meets the tolerance of a step in one piece and is the
cheaper one (measured); beyond it its steps are cut, and order 8 is."""


def concrete(method: Method, model: RockingModel, dt: float) -> Method:
    """The method itself, or what `AUTO` means for this wall and time step [s]: by p dt, where p counts the
    slope of an elastic branch."""
    if method.name != AUTO.name:
        return method
    phi1, phi2 = model.elastic_end, model.plateau_end
    slope = math.sin(model.slenderness - phi2) / phi1 if phi2 > 0.0 else 0.0
    growth = dt * math.sqrt(model.p2 * (1.0 + slope))
    return METHODS["taylor_6" if growth <= ORDER_SIX_UP_TO else "taylor"]


@kernel
def compared(
    code, ground, dt, scale, model, option, start, rotation, velocity, impact_time,
    impact_velocity, table,
):  # fmt: skip
    """`taylor.integrate` of any other method, by its integer code."""
    if code == NEWMARK_PAPER:
        return newmark_paper.integrate(
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
    return stepped.integrate(
        code, ground, dt, scale, model, option, start, rotation, velocity, impact_time,
        impact_velocity, table,
    )  # fmt: skip


@kernel
def scan_compared(code, option, ground, dt, scales, model, outcomes, peaks, clamped, none, table):
    """`scan` by the other methods. none : of no element."""
    for j in range(scales.size):
        outcomes[j], peaks[j], _, clamped[j], _ = compared(
            code, ground, dt, scales[j], model, option, (0.0, 0.0), none, none, none, none, table
        )


def scan(method: Method, ground, dt, scales, model, outcomes, peaks) -> np.ndarray:
    """Analyses of one record at many multipliers; returns the clamped velocity ratios of each, shape (m,).

    ground : [m/s2], shape (n,); scales : multipliers [-], shape (m,), negative reverses the record;
    outcomes : results, codes of outcome.py, int64, shape (m,); peaks : results [rad], shape (m,).
    """
    which = np.zeros(scales.size, np.int64)
    return scan_records(method, Grounds.of([ground], dt), which, scales, model, outcomes, peaks)


def scan_records(
    method: Method, grounds: Grounds, which, scales, model, outcomes, peaks
) -> np.ndarray:
    """`scan` of several records of one time step. which : record of each multiplier, int64, shape (m,)."""
    method = concrete(method, model, grounds.dt)
    if method.code == TAYLOR:
        return passes.scan(method.order, grounds, which, scales, model, outcomes, peaks)
    clamped = np.zeros(scales.size, np.int64)
    for k, (first, last) in enumerate(zip(grounds.first, grounds.last, strict=True)):
        here = np.nonzero(which == k)[0]
        found, reached, clamps = outcomes[here], peaks[here], clamped[here]
        scan_compared(
            method.code, method.option, grounds.ground[first : last + 1], grounds.dt, scales[here],
            model, found, reached, clamps, NO_TABLE, method.table,
        )  # fmt: skip
        outcomes[here], peaks[here], clamped[here] = found, reached, clamps
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
    method = concrete(method, model, dt)
    rotation = np.zeros(ground.size)
    velocity = np.zeros(ground.size)
    times = np.zeros(4096)
    while True:
        velocities = np.zeros(times.size)
        wanted = (start, rotation, velocity, times, velocities)
        if method.code == TAYLOR:
            integrate = taylor.INTEGRATE[method.order]
            outcome, peak, impacts, clamped, done = integrate(ground, dt, scale, model, *wanted)
        else:
            outcome, peak, impacts, clamped, done = compared(
                method.code, ground, dt, scale, model, method.option, *wanted, method.table
            )
        if impacts <= times.size:
            break
        times = np.zeros(impacts)
    return History(
        rotation[:done], velocity[:done], times[:impacts], velocities[:impacts],
        outcome, peak, clamped,
    )  # fmt: skip
