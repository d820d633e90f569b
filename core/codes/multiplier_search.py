"""Search of zeta_E: where a rule that is not monotone in the multiplier of the demand fails.

A wall can survive a stronger motion than one that overturned it, so that the first failure found on a grid moves
with the grid. zeta_E is the lowest multiplier at which half of the multipliers within +-10 % of it (in ln) fail,
zeta_16 the lowest at which 16 % do.

Every search is on points of one grid, target (1 + MULTIPLIER_STEP)^k, all of them or every n-th one. All points are
analysed from a whole window without a failure on; the first failure is looked for at points 4 % apart where every run
hardly rocks, 1 % apart elsewhere.
"""

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from core.capacity.bisection import bisect_brackets
from core.capacity.ida import ROBUST_SHARE, first_with_share

MULTIPLIER_STEP = 0.0025
"""Step of the grid of multipliers, which holds the target itself [-]."""

FAILURE_WINDOW = 0.10
"""Half width in ln of the neighbourhood of a multiplier."""

HALF_FAIL = 0.5
"""Share of failing multipliers around zeta_E."""

SHARE_ERROR = 0.05
"""What the share of failing points can differ by on another grid: zeta_E on a grid 20 times finer lies between
the multipliers at which 45 % and 55 % fail (`run.py bench --zeta`)."""

SPARSE = 16
"""Points of the grid from one to the next that are analysed first. Those between are left out where the peaks at both
ends stay below ROCKING_PEAK_RATIO: no zeta of 130 sets, searched point by point at 8 places of the grid, is another
with one up to 0.30."""

SPARSE_ROCKING = 4
"""Points of the grid from one to the next that are analysed first beside one at which a run rocks."""

ROCKING_PEAK_RATIO = 0.20
"""Largest rotation over theta_c from which a wall may overturn at a multiplier close by."""

POINTS_PER_SEARCH = 128
"""Points of the grid searched before the next check for a failure."""

MAX_MULTIPLIER = 100.0
"""Multiplier of the demand up to which zeta is searched."""

MIN_MULTIPLIER_SHARE = 1e-3
"""Share of the multiplier from which the search starts below which no run without a number is followed down."""


class Precision(NamedTuple):
    """How finely zeta is searched: every how many points of its grid; enough : multiple of what is required beyond
    which it need not be known, None where it always is."""

    every: int = 1
    enough: float | None = None


RUN = Precision()
"""All points, zeta known wherever it is: as it is written."""


@dataclass(frozen=True)
class ZetaSearchResult:
    """zeta_E, zeta_16, zeta_first, and the spread of zeta_E (None where a run has no number), the share failing
    around the target, whether the rule holds at the target itself, and whether it fails there by runs with a number;
    beyond : zeta_E is at least this, as far as was looked; limited : it is what is required, above which more was
    found."""

    half: float | None
    sixteen: float | None
    first: float | None
    spread: tuple[float, float] | None
    share_at_target: float
    holds_at_target: bool
    fails_at_target: bool
    beyond: bool = False
    limited: bool = False


class _Grid:
    """Points target (1 + MULTIPLIER_STEP)^(every k) judged so far: where the rule fails, where that is for want of
    a number, and where a run rocks."""

    def __init__(self, failures, target: float, every: int):
        self.failures, self.target, self.every = failures, target, every
        self.step = (1.0 + MULTIPLIER_STEP) ** every - 1.0
        self.known: dict[int, tuple[bool, bool, bool]] = {}

    def multiplier(self, k: int) -> float:
        return self.target * (1.0 + MULTIPLIER_STEP) ** (self.every * k)

    def index(self, multiplier: float) -> int:
        """Largest k whose multiplier is not above this one."""
        return math.floor(math.log(multiplier / self.target) / math.log1p(self.step))

    def at(self, indices) -> np.ndarray:
        """Flags of failure, of unknown outcome and of rocking at these points, shape (3, points)."""
        new = [k for k in indices if k not in self.known]
        if new:
            flags = self.failures(np.array([self.multiplier(k) for k in new]))
            pairs = zip(*(part.tolist() for part in flags), strict=True)
            self.known |= zip(new, pairs, strict=True)
        return np.array([self.known[k] for k in indices], bool).reshape(-1, 3).T

    def fails_at(self, indices) -> np.ndarray:
        """Whether the rule fails at these points."""
        return self.at(indices)[0]

    def first_failure(self, start: int, top: int) -> int | None:
        """Lowest point at which the rule fails, of those looked at from start to top; None without one."""
        sparse, close = max(1, SPARSE // self.every), max(1, SPARSE_ROCKING // self.every)
        together = max(1, POINTS_PER_SEARCH // self.every)
        for low in range(start // sparse * sparse, top + 1, together):
            ends = range(low, low + together + 1, sparse)
            fails, _, rocks = self.at(ends)
            asked = []
            for k in range(len(ends) - 1):
                asked += range(ends[k], ends[k + 1], close) if rocks[k] or rocks[k + 1] else [ends[k]]
                if fails[k + 1]:
                    asked.append(ends[k + 1])
                    break
            failing = self.fails_at(asked)
            if failing.any():
                return asked[int(np.argmax(failing))]
        return None


def search_zeta(failures, rest: float, target: float, precision: Precision = RUN) -> ZetaSearchResult:
    """Search zeta_E, at which a rule fails.

    failures(multipliers) : flags of failure, of unknown outcome, and of a peak of ROCKING_PEAK_RATIO or more at each
    rest : below this multiplier the rule holds
    target : a multiplier of the grid, target (1 + MULTIPLIER_STEP)^k
    precision : which of its points are looked at, and up to where
    Where the rule never fails up to MAX_MULTIPLIER, or to what is enough, that. From a whole window of points without a
    failure below the first one on, all points are analysed.
    """
    grid = _Grid(failures, target, precision.every)
    half = round(FAILURE_WINDOW / math.log1p(grid.step))
    window, top = 2 * half + 1, grid.index(MAX_MULTIPLIER)
    most = MAX_MULTIPLIER if precision.enough is None else precision.enough * target
    last_looked = grid.index(most)
    edge = grid.first_failure(grid.index(rest), last_looked)
    failing, unknown, _ = grid.at([0])[:, 0]
    at_target = not failing, bool(failing and not unknown)
    if edge is None or edge > last_looked:
        return ZetaSearchResult(most, most, most, (most, most), 0.0, *at_target, precision.enough is not None)
    while (below := grid.fails_at(range(edge - window, edge))).any():
        edge += int(np.argmax(below)) - window
        if (
            grid.multiplier(edge) < MIN_MULTIPLIER_SHARE * rest
        ):  # runs that never have a number, however weak the motion
            return ZetaSearchResult(None, None, None, None, float(below.mean()), *at_target)
    low = edge - window
    fails, last = below, None
    while last is None and low + fails.size <= top + half:
        first = low + fails.size
        fails = np.append(fails, grid.fails_at(range(first, first + max(half // 2, 1))))
        last = first_with_share(fails, half, HALF_FAIL + SHARE_ERROR)
    around = grid.fails_at(range(max(-half, low), half + 1))
    share = float(around.sum()) / window
    end = fails.size if last is None else last + half + 1
    if grid.at(range(low, low + end))[1].any():
        return ZetaSearchResult(None, None, None, None, share, *at_target)
    shares = (HALF_FAIL, ROBUST_SHARE, HALF_FAIL - SHARE_ERROR, HALF_FAIL + SHARE_ERROR)
    places = [*(first_with_share(fails, half, part) for part in shares), window]
    zeta, sixteen, least, most, first = (
        MAX_MULTIPLIER if k is None else min(grid.multiplier(low + k), MAX_MULTIPLIER) for k in places
    )
    if places[0] == places[-1]:  # a sharp limit is located
        edges = (grid.multiplier(edge - 1), first)
        (bracket,) = bisect_brackets([edges], lambda points: [failures(points[0])[:2]])
        zeta = first = bracket[1] if bracket else first
    elif places[0] is not None:  # the point stands for the step that ends in it
        zeta /= math.sqrt(1.0 + grid.step)
    return ZetaSearchResult(zeta, sixteen, first, (least, most), share, *at_target)
