"""The ways to integrate the motion, by name."""

import math
from dataclasses import dataclass

import numpy as np

from core.rocking.compared import comparison, dormand_prince, stepped
from core.wall.rocking_model import RockingModel

TAYLOR = 0
NO_TABLE = np.empty(0)


@dataclass(frozen=True)
class Method:
    """A way to integrate the motion.

    name
    code : of the kernels
    option : order of taylor, reset of newmark_paper, steps a sample of newmark_events, rk4 and linearised, -log10 of
        the tolerance of dormand_prince
    order : of convergence, 0 where a method does not converge to the truth
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
        Method("newmark_paper", comparison.NEWMARK_PAPER, 0, 1),
        Method("newmark_paper_reset", comparison.NEWMARK_PAPER, 1, 1),
        Method("newmark_events", stepped.NEWMARK_EVENTS, 1, 2),
        Method("rk4", stepped.RK4, 1, 4),
        Method("dormand_prince", stepped.DORMAND_PRINCE, 12, 8),
        Method("linearised", stepped.LINEARISED, 1, 0),
    )
}
"""Methods a user can ask for by name."""

AUTO = Method("auto", TAYLOR, 0, 0)
"""The cheaper order of the Taylor series, both to the same tolerance, see `resolve_auto`."""

ORDER_SIX_UP_TO = 0.005
"""Growth over a sample, p dt, up to which order 6 meets the tolerance of a step in one piece and is the
cheaper one (measured); beyond it its steps are cut, and order 8 is."""


def resolve_auto(method: Method, model: RockingModel, dt: float) -> Method:
    """The method itself, or what `AUTO` means for this wall and time step [s]: by p dt, where p counts the
    slope of an elastic branch."""
    if method.name != AUTO.name:
        return method
    phi1, phi2 = model.elastic_end, model.plateau_end
    amplitude = max(model.restoring.amplitude, model.mirrored.amplitude)
    slope = math.sin(model.collapse_rotation - phi2) / phi1 if phi2 > 0.0 and model.driven is None else 0.0
    growth = dt * math.sqrt(model.p2 * amplitude * (1.0 + slope))
    return METHODS["taylor_6" if growth <= ORDER_SIX_UP_TO else "taylor"]
