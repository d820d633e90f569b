"""Fragility of a wall: the share of its runs that collapse, smoothed over the robust window of the search."""

from dataclasses import dataclass

import numpy as np

from core.capacity.ida import Ida, Search, collapse_count
from core.rocking.outcome import COLLAPSED


@dataclass(frozen=True)
class Fragility:
    """q at which 5, 16 and 50 % of the n runs of a wall collapse within +-robust_window; the
    resolution is 1/n. None where the q lies above q_limit."""

    q_05: float | None
    q_16: float | None
    q_50: float | None
    n: int


def fragility_curve(runs: list[Ida], search: Search) -> tuple[np.ndarray, np.ndarray, int]:
    """(q, collapsing points within the window summed over the runs, runs), the curve of `fragility`."""
    runs = [run for run in runs if run.status != "impact_limit"]
    if not runs:
        return np.empty(0), np.empty(0, np.int64), 0
    half = search.half_window
    first = min(run.first_index for run in runs) - half
    last = max(run.first_index + len(run.outcomes) for run in runs) + half
    count = np.zeros(last - first + 1, np.int64)
    for run in runs:
        collapsed = np.zeros(count.size, np.int64)
        start = run.first_index - first
        stop = start + len(run.outcomes)
        collapsed[start:stop] = [digit == str(COLLAPSED) for digit in run.outcomes]
        collapsed[stop:] = 1
        count += collapse_count(collapsed, half)
    index = np.arange(first, last + 1)
    return runs[0].q_start * (1.0 + search.q_step) ** index, count, len(runs)


def fragility(runs: list[Ida], search: Search) -> Fragility | None:
    """Fragility over the runs of a wall, each sign of a record a run of its own; runs that ended as
    impact_limit have no map and are left out. Above its end a map collapses, below it survives."""
    q, count, n = fragility_curve(runs, search)
    if not n:
        return None
    values = []
    for level in (0.05, 0.16, 0.50):
        # whole counts: 7 of 14 is 0.50, whatever its sum of fractions rounds to
        reached = count >= level * n * (2 * search.half_window + 1) - 1e-6
        first = float(q[int(np.argmax(reached))])
        values.append(first if reached.any() and first <= search.q_limit else None)
    q_05, q_16, q_50 = values
    return Fragility(q_05, q_16, q_50, n)
