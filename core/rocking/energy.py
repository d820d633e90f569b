"""The energy of a history over the barrier that overturns the wall."""

import numpy as np

from core.jit.decorators import kernel
from core.rocking import held_top
from core.rocking.history import History
from core.wall.moment_rotation import potential
from core.wall.rocking_model import RockingModel, seen_from


@kernel
def _fill(rotation, velocity, model, ratios):
    """rotation [rad], velocity [rad/s] : shape (n,); model : RockingModel; ratios : results [-], shape (n,)"""
    for i in range(rotation.size):
        side = -1.0 if rotation[i] < 0.0 else 1.0
        seen = seen_from(model, side)
        barrier = potential(seen.slenderness + seen.restoring.lean, seen)
        kinetic = 0.5 * velocity[i] * velocity[i] / seen.p2
        ratios[i] = (kinetic + potential(abs(rotation[i]), seen)) / barrier


def energy_ratios(history: History, model: RockingModel) -> np.ndarray:
    """Kinetic and stored energy at the samples over the energy at theta_c on that side [-], shape (n,): above 1 a wall
    on a ground that rests overturns (PHYSICS 2). The work of ties is not in it."""
    if model.bending is not None:
        return held_top.energy_ratios(history.rotation, history.velocity, model)
    ratios = np.empty(history.rotation.size)
    _fill(history.rotation, history.velocity, model._replace(bars=()), ratios)
    return ratios
