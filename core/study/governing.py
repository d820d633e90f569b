"""The governing run of a wall: the one with the lowest q."""

from collections.abc import Iterable

from core.capacity.ida import multiplier_of, threshold_of
from core.rocking.history import integrate_history
from core.study.results import CollapseHistories, Run, StudyResult, WallResult


def governing_run(wall: WallResult) -> Run | None:
    """The run with the lowest q of a wall; None without a collapse."""
    return run_with_lowest_q(wall.runs)


def run_with_lowest_q(runs: Iterable[Run]) -> Run | None:
    """The run with the lowest q; None without a collapse."""
    with_q = [(q, run) for run in runs if (q := run.ida.q) is not None]
    return min(with_q, key=lambda pair: pair[0])[1] if with_q else None


def collapse_histories(result: StudyResult, wall: WallResult) -> CollapseHistories | None:
    """Integrate the governing record of a wall again on both sides of its first collapse; None
    without a collapse. The governing record is the one with the lowest q."""
    lowest = governing_run(wall)
    if lowest is None or lowest.ida.bracket is None:
        return None
    motion = result.motion_of(wall, lowest.motion)
    low, high = (lowest.polarity * multiplier_of(q, motion.pga, threshold_of(wall.model)) for q in lowest.ida.bracket)
    survived, collapsed = (
        integrate_history(motion.acceleration, motion.time_step, scale, wall.model, result.method)
        for scale in (low, high)
    )
    return CollapseHistories(wall, motion, lowest.polarity, (low, high), (survived, collapsed))
