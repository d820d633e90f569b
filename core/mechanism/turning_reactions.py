"""What a wall that turns about its base hands to its ties and to what stands behind it."""

import numpy as np

from core.mechanism.sections import Sections
from core.rocking.history import History
from core.wall.bars import TieBar
from core.wall.ties import Tie

RUN_INTO = 2.0
"""Share of its static force that a tie may take which stands no elongation: the wall runs into it. Of 15 918 random
histories 0.2 % ask more, nearly all with e above 0.8 (median 1.26)."""


def tie_forces(sections: Sections, ties: tuple[Tie, ...], alpha: float) -> list[float]:
    """Forces [N/m] of the ties of a wall under an outward push alpha [-]: (alpha S - M_o)/h of one, of several as they
    are stretched, twice that of a brittle one; at most that at yield."""
    moment = max(0.0, sections.at(0.0).least_moment(alpha))
    levers = sum(tie.bar.height**2 for tie in ties)
    forces = (moment * tie.bar.height / levers * (1.0 if tie.stands_more else RUN_INTO) for tie in ties)
    return [min(force, tie.bar.strength) for force, tie in zip(forces, ties, strict=True)]


def largest_forces(bars: tuple[TieBar, ...], history: History) -> list[float]:
    """Largest forces [N/m] of the ties of a wall along a history: F = k (h sin(theta) - u_p), at most F_y."""
    forces = []
    for bar, residual in zip(bars, history.residual, strict=True):
        pulled = bar.height * (np.sin(np.maximum(history.rotation, 0.0)) - residual)
        forces.append(
            float(np.clip(bar.strength / bar.elongation_at_yield * pulled, 0.0, bar.strength).max(initial=0.0))
        )
    return forces


def force_behind(sections: Sections, height: float, alpha: float) -> float:
    """Largest force [N/m] of a wall at rest on what stands behind it up to a height [m], under an inward push alpha
    [-]: as of a stiff hold there."""
    return alpha * sections.at(0.0).push / height


def impulse_behind(inertia: float, speed: float, kept: float, height: float) -> float:
    """Impulse [N s/m] at most of a wall that comes back, on what stands behind it up to a height [m]: I_O omega (1 +
    e)/H_r, the moments about the base; a contact model without gravity finds 0.975 to 0.984 of it.

    inertia : I_O [kg m]; speed : omega before the impact [rad/s]; kept : e [-]
    """
    return inertia * speed * (1.0 + max(0.0, kept)) / height


def speed_before(history: History, kept: float) -> float:
    """Largest abs(theta') [rad/s] of a wall just before an impact. kept : e [-]; of 0 from the samples"""
    speeds = np.abs(history.impact_velocity) / kept if kept > 0.0 else np.abs(history.velocity)
    return float(speeds.max(initial=0.0)) if history.impact_time.size else 0.0
