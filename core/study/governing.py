"""The governing run of a wall: the one with the lowest q."""

from core.capacity.ida import multiplier_of, threshold_of
from core.rocking.history import history
from core.study.results import CollapseHistories, Run, StudyResult, WallResult


def lowest_run(wall: WallResult) -> Run | None:
    """The run with the lowest q of a wall; None without a collapse."""
    runs = [run for run in wall.runs if run.ida.q is not None]
    return min(runs, key=lambda run: run.ida.q) if runs else None


def collapse_histories(result: StudyResult, wall: WallResult) -> CollapseHistories | None:
    """Integrate the governing record of a wall again on both sides of its first collapse; None
    without a collapse. The governing record is the one with the lowest q."""
    lowest = lowest_run(wall)
    if lowest is None:
        return None
    motion = result.motion_of(wall, lowest.motion)
    low, high = (lowest.polarity * multiplier_of(q, motion.pga, threshold_of(wall.model)) for q in lowest.ida.bracket)
    survived, collapsed = (
        history(motion.acceleration, motion.time_step, scale, wall.model, result.method) for scale in (low, high)
    )
    return CollapseHistories(wall, motion, lowest.polarity, (low, high), (survived, collapsed))
