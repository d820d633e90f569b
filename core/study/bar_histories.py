"""The ties of a wall over a history: force, elongation, what each does, and the energy they and the impacts took."""

from dataclasses import dataclass

import numpy as np

from core.case.wall import Wall
from core.rocking.bar_state import BROKEN, SLACK, TAUT, YIELDING
from core.rocking.history import History
from core.wall.bars import TieBar, forces
from core.wall.rocking_model import RockingModel


@dataclass(frozen=True)
class BarHistory:
    """A bar at the samples of a history.

    bar : TieBar
    force : [N/m]; elongation, residual : u and u_p [m], u_p not a number where the bar has gone
    phase : SLACK, TAUT, YIELDING or BROKEN of `bar_state`
    work : it took by yielding, and by breaking what it stored [N]
    """

    bar: TieBar
    force: np.ndarray
    elongation: np.ndarray
    residual: np.ndarray
    phase: np.ndarray
    work: float


def bar_histories(wall: Wall, history: History, strength_factor: float = 1.0) -> list[BarHistory]:
    """Histories of the bar of each tie of a wall. strength_factor : FC, where the history has it on the strength:
    forces are over it"""
    histories = []
    for tie, sines in zip(wall.in_si.ties, history.residual, strict=True):
        bar, gone = tie.bar, np.isinf(sines)
        force = forces(bar, history.rotation, sines)
        elongation = bar.height * np.sin(np.maximum(history.rotation, 0.0))
        residual = np.where(gone, np.nan, bar.height * sines)
        phase = np.where(force >= bar.strength * (1.0 - 1e-9), YIELDING, np.where(force > 0.0, TAUT, SLACK))
        phase = np.where(gone, BROKEN, phase)
        start = bar.slack
        if gone.any():
            plastic = max(0.0, bar.breaks_at - bar.elongation_at_yield - start)
            stored = 0.5 * bar.strength * min(bar.elongation_at_yield, bar.breaks_at - start)
        else:
            plastic, stored = bar.height * sines[-1] - start, 0.0
        work = (bar.strength * plastic + stored) / strength_factor
        histories.append(BarHistory(bar, force / strength_factor, elongation, residual, phase, work))
    return histories


def work_of_impacts(wall: Wall, model: RockingModel, history: History) -> float | None:
    """Energy that the impacts of a history took, for a metre of wall [N]; None where the velocity ratio falls with the
    speed (Eq. 7), or is 0. model : of the wall, without FC
    model : of the wall, without FC"""
    ratio = model.ratio_at_rest
    if model.ratio_drop or not ratio:
        return None
    inertia = wall.in_si.moment_of_weight / model.p2
    return float(0.5 * inertia * (1.0 / ratio**2 - 1.0) * np.sum(history.impact_velocity**2))
