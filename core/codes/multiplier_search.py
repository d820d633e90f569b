"""Where a rule that is not monotone in the multiplier of the demand fails: zeta_E.

A wall can survive a stronger motion than one that overturned it, so that the first failure found on a grid moves
with the grid. zeta_E is the lowest multiplier at which half of the multipliers within +-10 % of it (in ln) fail,
zeta_16 the lowest at which 16 % do.
"""

import math
from dataclasses import dataclass

import numpy as np

from core.capacity.ida import ROBUST_SHARE, bisections, first_with_share

STEP = 0.0025
"""Step of the grid of multipliers, which holds the target itself [-]."""

WINDOW = 0.10
"""Half width in ln of the neighbourhood of a multiplier."""

HALF_FAIL = 0.5
"""Share of failing multipliers around zeta_E."""

SHARE_ERROR = 0.05
"""What the share of failing points can differ by on another grid: zeta_E on a grid 20 times finer lies between
the multipliers at which 45 % and 55 % fail (`run.py bench --zeta`)."""

AT_ONCE = 16
"""Points of the grid analysed before the next check for a failure."""

COARSE, SPARSE = 0.02, 0.04
"""Distance [-] of the points analysed where no failure has been found yet, and where none is expected."""

MAX_MULTIPLIER = 100.0
"""Multiplier of the demand up to which zeta is searched."""


@dataclass(frozen=True)
class Zeta:
    """zeta_E, zeta_16, zeta_first, and the spread of zeta_E (None where a run has no number), the share failing
    around the target, and whether the rule holds at the target itself."""

    half: float | None
    sixteen: float | None
    first: float | None
    spread: tuple[float, float] | None
    share_at_target: float
    holds_at_target: bool


class _Grid:
    """What is known of the points target (1 + step)^k: where the rule fails, and for want of a number."""

    def __init__(self, failures, target: float, step: float):
        self.failures, self.target, self.step = failures, target, step
        self.known: dict[int, tuple[bool, bool]] = {}

    def multiplier(self, k: int) -> float:
        return self.target * (1.0 + self.step) ** k

    def index(self, multiplier: float) -> int:
        """Largest k whose multiplier is not above this one."""
        return math.floor(math.log(multiplier / self.target) / math.log1p(self.step))

    def fails_at(self, indices) -> np.ndarray:
        """Whether the rule fails at these points."""
        new = [k for k in indices if k not in self.known]
        if new:
            flags = self.failures(np.array([self.multiplier(k) for k in new]))
            pairs = zip(*(part.tolist() for part in flags), strict=True)
            self.known |= zip(new, pairs, strict=True)
        return np.array([self.known[k][0] for k in indices], bool)


def search_zeta(
    failures, rest: float, target: float, expected: float = 0.0, step: float = STEP
) -> Zeta:
    """Where a rule fails, on the grid target (1 + step)^k.

    failures(multipliers) : flags of failure and of unknown outcome at each
    rest : below this multiplier the rule holds
    target : a multiplier of the grid
    expected : failures are not expected below
    Where the rule never fails up to MAX_MULTIPLIER, that. Until a failure is found points at COARSE distance are
    analysed, below `expected` at SPARSE; from a window below it on all.
    """
    grid, half = _Grid(failures, target, step), round(WINDOW / math.log1p(step))
    start, top = grid.index(rest), grid.index(MAX_MULTIPLIER)
    coarse, sparse = (max(1, round(distance / step)) for distance in (COARSE, SPARSE))
    at = start
    while at <= top:
        stride = sparse if grid.multiplier(at + AT_ONCE * sparse) < expected else coarse
        failing = grid.fails_at(range(at, at + AT_ONCE * stride, stride))
        if failing.any():
            break
        at += AT_ONCE * stride
    holds = not grid.fails_at([0])[0]
    if at > top:
        most = MAX_MULTIPLIER
        return Zeta(most, most, most, (most, most), 0.0, holds)
    # the window below the first failure found at every second point, each standing for the next as well
    edge = at + stride * (int(np.argmax(failing)) - 1) + 1
    low = edge - 2 * (half // 2)
    fails, last = np.repeat(grid.fails_at(range(low, edge, 2)), 2), None
    while last is None and low + fails.size <= top + half:
        first = low + fails.size
        fails = np.append(fails, grid.fails_at(range(first, first + AT_ONCE)))
        last = first_with_share(fails, half, HALF_FAIL + SHARE_ERROR)
    around = grid.fails_at(range(max(-half, low), half + 1))
    share = float(around.sum()) / (2 * half + 1)
    end = fails.size if last is None else last + half + 1
    if any(grid.known.get(low + k, (False, False))[1] for k in range(end)):
        return Zeta(None, None, None, None, share, holds)
    shares = (HALF_FAIL, ROBUST_SHARE, HALF_FAIL - SHARE_ERROR, HALF_FAIL + SHARE_ERROR)
    places = [*(first_with_share(fails, half, part) for part in shares), int(np.argmax(fails))]
    zeta, sixteen, least, most, first = (
        MAX_MULTIPLIER if k is None else min(grid.multiplier(low + k), MAX_MULTIPLIER)
        for k in places
    )
    if places[0] == places[-1]:  # a sharp limit is located
        edges = (grid.multiplier(low + places[0] - 1), first)
        (bracket,) = bisections([edges], lambda points: [failures(points[0])])
        zeta = first = bracket[1] if bracket else first
    elif places[0] is not None:  # the point stands for the step that ends in it
        zeta /= math.sqrt(1.0 + step)
    return Zeta(zeta, sixteen, first, (least, most), share, holds)
