"""The runs of a wall in lists: their names, and the one that is shown first."""

import numpy as np

from app.look.language import number, result_word, tr, wall_title
from core.study.results import Run, WallResult

SECONDS_BEFORE_MOTION = 0.5
"""Time at rest that an animation shows before the wall moves [s]."""


def run_name(run: Run) -> str:
    """Record and sign."""
    return f"{run.record} ({'+' if run.polarity > 0 else '−'})"


def title_of(wall: WallResult) -> str:
    """A wall and its mechanism in the caption of a figure; above the ground what moves it is the floor."""
    words = f"{wall_title(wall.name)}, {result_word(wall.mechanism)}"
    return f"{words}, {tr('motion of the floor at {z} m', z=number(wall.floor.z, 'g'))}" if wall.floor else words


def index_of(wall: WallResult, motion: int, polarity: int) -> int | None:
    """Index of the run under this motion of this sign; None where there is none."""
    return next((k for k, run in enumerate(wall.runs) if (run.motion, run.polarity) == (motion, polarity)), None)


def time_before_motion(rotation: np.ndarray, time_step: float) -> float:
    """Shortly before a wall first leaves the ground [s]; the beginning where it never does."""
    moves = np.flatnonzero(rotation)
    return max(0.0, moves[0] * time_step - SECONDS_BEFORE_MOTION) if moves.size else 0.0
