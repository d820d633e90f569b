"""Incremental dynamic analysis: first collapse, survival map, q_robust (Eq. 10).

Collapse is not monotone in the multiplier, so q exists only together with its search: one geometric
grid q_k = q_start (1 + q_step)^k, shared by all runs of a study.
"""

import functools
import math
from collections.abc import Callable, Generator
from dataclasses import dataclass
from typing import Any

import numpy as np

from core.capacity.bisection import all_narrowed, midpoints
from core.capacity.limit_states import LIMIT_FRACTION
from core.errors import Cancelled
from core.rocking.grounds import Grounds
from core.rocking.history import scan_records
from core.rocking.methods import Method
from core.rocking.outcome import COLLAPSED, IMPACT_LIMIT, MAX_GROUND, STABLE
from core.wall.rocking_model import RockingModel

ROBUST_SHARE = 0.16
"""Share of collapsing grid points around q_robust [-]."""

LOWER_SHARE = 0.9
"""Share of the rotation of SLV whose first peak is the lower end of the spread of q_slv [-]
(resources/docs/physics.md, section 11)."""

MIN_SLV_WINDOW = 0.10
"""Least half width of the window of q_slv_robust, in ln q."""

TRILINEAR_START = 0.5
TRILINEAR_FLOOR = 0.05
CHUNK = 128
"""Analyses between two checks of whether the search is cancelled."""

LOWER_SLV = LOWER_SHARE * LIMIT_FRACTION["SLV"]
Steps = Generator[Any, Any, Any]
"""A search that needs analyses: it yields what is to be analysed, is sent what came of it, and returns its result."""


@dataclass(frozen=True)
class Search:
    """Settings of the search. q_step, robust_window (in ln q), map_span [-], q_limit [-]."""

    q_step: float = 0.005
    q_limit: float = 100.0
    map_span: float = 2.0
    robust_window: float = 0.10

    @property
    def half_window(self) -> int:
        """Grid points on either side of the robust window."""
        return round(self.robust_window / math.log1p(self.q_step))

    @property
    def half_slv_window(self) -> int:
        """Grid points on either side of the window of q_slv_robust, which a check takes: never fewer than the usual
        ones, for a narrower window would raise it."""
        return round(max(self.robust_window, MIN_SLV_WINDOW) / math.log1p(self.q_step))


@dataclass(frozen=True)
class Run:
    """A record and the sign it is taken with.

    ground : [m/s2], shape (n,); dt : its time step [s]; pga : of the unscaled record [m/s2]
    sign : 1 as recorded, -1 reversed
    """

    ground: np.ndarray
    dt: float
    pga: float
    sign: int


@dataclass(frozen=True)
class Ida:
    """Result of the search for one wall, record and polarity; a number is None where it has none.

    status : collapse_found, no_collapse_found or impact_limit; q in bracket = (lo, hi), q = hi
    q_slv, q_slc : first peak at 0.40, 0.60 alpha
    q_slv_low : lower end of the spread of q_slv, the grid point below the first peak at LOWER_SHARE of 0.40 alpha
    q_slv_robust : q_robust of peaks of 0.40 alpha in the place of collapses
    q_robust, q_last_survival, survived_fraction, survival_windows : of the map, they depend on q_step
    analyses : integrations made
    impact_limited : grid points of unknown outcome
    clamped : impacts of the map with Eq. 7 held at 0
    q_start, first_index, outcomes : the map, a digit of outcome.py per grid point
    below_floor : a first failure is below the lowest q of the search: what is given for it is its upper limit
    """

    status: str
    q: float | None
    bracket: tuple[float, float] | None
    q_slv: float | None
    q_slc: float | None
    q_slv_low: float | None
    q_slv_robust: float | None
    q_robust: float | None
    q_last_survival: float | None
    survived_fraction: float | None
    survival_windows: tuple[tuple[float, float], ...]
    analyses: int
    impact_limited: int
    clamped: int
    q_start: float
    first_index: int
    outcomes: str
    below_floor: bool = False


@functools.lru_cache(1 << 16)
def grid_point(q_start: float, q_step: float, index: int) -> float:
    """q of a point of the grid; the searches of a study ask for the same ones."""
    return q_start * (1.0 + q_step) ** index


class _Map:
    """Outcomes and peaks on the grid, grown at both ends, and single analyses between its points."""

    def __init__(self, pga, sign, model, search):
        """pga : of the unscaled record [m/s2]
        sign : 1 as recorded, -1 reversed
        model : RockingModel
        search : Search
        """
        self.model, self.search = model, search
        self.rigid = model.plateau_end == 0.0
        self.q_start = 1.0 if self.rigid else TRILINEAR_START
        self.sign, self.pga = sign, pga
        self.first = 0
        self.outcomes = np.empty(0, np.int64)
        self.peaks = np.empty(0)
        self.clamped = np.empty(0, np.int64)
        self.analyses = 0

    def q_of(self, index: int) -> float:
        return grid_point(self.q_start, self.search.q_step, index)

    def index_below(self, q: float) -> int:
        """Largest grid index with q_k <= q."""
        index = math.floor(math.log(q / self.q_start) / math.log1p(self.search.q_step)) + 1
        while self.q_of(index) > q:
            index -= 1
        return index

    @property
    def last(self) -> int:
        return self.first + self.outcomes.size - 1

    def analyse(self, q_values) -> Steps:
        """Outcomes, peaks and clamped ratios at these q, from those at the multipliers yielded; below q = 1 a rigid
        wall rests, exactly."""
        q_values = np.asarray(q_values)
        outcomes = np.full(q_values.size, STABLE)
        peaks, clamped = np.zeros(q_values.size), np.zeros(q_values.size, np.int64)
        moves = q_values > 1.0 if self.rigid else np.full(q_values.size, True)
        scales = self.sign * multiplier_of(q_values[moves], self.pga, threshold_of(self.model))
        outcomes[moves], peaks[moves], clamped[moves] = yield scales
        self.analyses += scales.size
        return outcomes, peaks, clamped

    def grow(self, first: int, last: int) -> Steps:
        """Extend the map to grid points first..last, in chunks between which a cancel is seen."""
        while self.last < last:
            start = self.last + 1
            stop = min(last, start + CHUNK - 1)
            parts = yield from self.analyse([self.q_of(k) for k in range(start, stop + 1)])
            self._join((self.outcomes, self.peaks, self.clamped), parts)
        while self.first > first:
            start = max(first, self.first - CHUNK)
            parts = yield from self.analyse([self.q_of(k) for k in range(start, self.first)])
            self._join(parts, (self.outcomes, self.peaks, self.clamped))
            self.first = start

    def _join(self, low, high) -> None:
        self.outcomes, self.peaks, self.clamped = map(np.concatenate, zip(low, high, strict=True))

    def cut(self, last: int) -> None:
        """Forget what was analysed beyond this grid point, so that no map depends on the chunks."""
        keep = slice(0, last - self.first + 1)
        self.outcomes, self.peaks, self.clamped = (self.outcomes[keep], self.peaks[keep], self.clamped[keep])

    def first_reaching(self, fraction: float) -> int | None:
        """First grid index that collapses or whose peak reaches this fraction of theta_c."""
        hits = self.reaches(self.outcomes, self.peaks, fraction)
        return self.first + int(np.argmax(hits)) if hits.any() else None

    def reaches(self, outcomes, peaks, fraction: float):
        reached = peaks >= fraction * self.model.collapse_rotation
        return (outcomes == COLLAPSED) | ((outcomes == STABLE) & reached)

    def brackets(self, fractions: tuple[float, ...]) -> Steps:
        """Brackets of the first events of these fractions of theta_c; None without one or where a midpoint
        is of unknown outcome; from 0 where the map cannot go lower."""
        firsts = [self.first_reaching(fraction) for fraction in fractions]
        wanted = {k: first for k, first in enumerate(firsts) if first is not None and first != self.first}
        edges: list = [(self.q_of(first - 1), self.q_of(first)) for first in wanted.values()]
        pairs = [None if first is None else (0.0, self.q_of(first)) for first in firsts]
        while points := midpoints(edges):
            middles = [part[1:-1] for part in points]
            outcomes, peaks, _ = yield from self.analyse(np.concatenate(middles))
            cuts = np.cumsum([part.size for part in middles])[:-1]
            by_fraction = zip(wanted, np.split(outcomes, cuts), np.split(peaks, cuts), strict=True)
            flags = [(self.reaches(codes, most, fractions[k]), codes == IMPACT_LIMIT) for k, codes, most in by_fraction]
            edges = all_narrowed(edges, points, flags)
        for k, bracket in zip(wanted, edges, strict=True):
            pairs[k] = bracket
        return pairs


def multiplier_of(q, pga: float, threshold: float):
    """Multiplier C of a record of this PGA at q = C PGA / a_RM (Coccia et al. 2016, Eq. 10) [-].

    q : [-], a number or an array
    pga : of the unscaled record [m/s2]
    threshold : a_RM [m/s2], Eq. 2
    """
    return threshold / pga * q


def threshold_of(model: RockingModel) -> float:
    """a_RM [m/s2] of the rigid law, Eq. 2: the denominator of q under every law."""
    return model.threshold


def incremental_dynamic_analysis(
    ground: np.ndarray,
    dt: float,
    pga: float,
    sign: int,
    model: RockingModel,
    method: Method,
    search: Search,
    cancelled: Callable[[], bool] = lambda: False,
) -> Ida:
    """Search one run (resources/docs/physics.md, section 11).

    ground : [m/s2], shape (n,)
    dt : its time step [s]
    pga : of the unscaled record [m/s2]
    sign : 1 as recorded, -1 reversed
    model : of the wall
    method : how the motion is integrated
    search : settings of the search
    cancelled : asked between two chunks of analyses
    Raises Cancelled where it is true.
    """
    return incremental_dynamic_analyses([Run(ground, dt, pga, sign)], model, method, search, cancelled)[0]


def incremental_dynamic_analyses(
    runs: list[Run], model: RockingModel, method: Method, search: Search, cancelled: Callable[[], bool]
) -> list[Ida]:
    """`incremental_dynamic_analysis` of several runs of a wall side by side: their analyses fill the lanes better.
    Each is what it is alone, bit for bit."""
    records: dict[float, list[np.ndarray]] = {}
    for run in runs:
        if not any(run.ground is known for known in records.setdefault(run.dt, [])):
            records[run.dt].append(run.ground)
    grounds = {dt: Grounds.of(of_step, dt) for dt, of_step in records.items()}
    searches = [_search(run, model, search) for run in runs]
    results: list[Any] = [None] * len(runs)
    asked: dict[int, np.ndarray] = {}

    def go_on(k: int, answer) -> None:
        try:
            asked[k] = searches[k].send(answer)
        except StopIteration as end:
            asked.pop(k, None)
            results[k] = end.value

    for k in range(len(runs)):
        go_on(k, None)
    while asked:
        answers = {}
        for dt in dict.fromkeys(runs[k].dt for k in asked):
            if cancelled():
                raise Cancelled
            here = [k for k in asked if runs[k].dt == dt]
            place = [next(n for n, one in enumerate(records[dt]) if one is runs[k].ground) for k in here]
            which, scales = np.repeat(place, [asked[k].size for k in here]), np.concatenate([asked[k] for k in here])
            codes, peaks = np.empty(scales.size, np.int64), np.empty(scales.size)
            clamped = scan_records(method, grounds[dt], which, scales, model, codes, peaks)
            cuts = np.cumsum([asked[k].size for k in here])[:-1]
            parts = zip(*(np.split(part, cuts) for part in (codes, peaks, clamped)), strict=True)
            answers |= zip(here, parts, strict=True)
        for k, answer in answers.items():
            go_on(k, answer)
    return results


def _search(run: Run, model: RockingModel, search: Search) -> Steps:
    """Search one run for its Ida."""
    grid = _Map(run.pga, run.sign, model, search)
    pga, half = run.pga, search.half_window
    limit = grid.index_below(search.q_limit)
    strongest = multiplier_of(search.q_limit, pga, threshold_of(model)) * np.abs(run.ground).max()
    if not (pga > 0.0 and strongest <= MAX_GROUND):
        return _result(grid, "bad_input", [None] * 3, None)
    yield from grid.grow(0, 0)
    if not grid.rigid:
        yield from _descend(grid, max(half, search.half_slv_window))
    collapse = None
    while collapse is None and grid.last < limit:
        yield from grid.grow(grid.first, min(limit, grid.last + CHUNK))
        collapse = grid.first_reaching(math.inf)
    before = grid.outcomes[: collapse - grid.first] if collapse is not None else grid.outcomes
    unknown = bool((before == IMPACT_LIMIT).any())
    fractions = (math.inf, LIMIT_FRACTION["SLV"], LIMIT_FRACTION["SLC"])
    brackets = [None] * len(fractions) if unknown else (yield from grid.brackets(fractions))
    if collapse is None:
        return _result(grid, "impact_limit" if unknown else "no_collapse_found", brackets, None)
    if brackets[0] is None:
        grid.cut(collapse)
        return _result(grid, "impact_limit", [None] * len(fractions), None)
    end = min(limit, max(collapse, grid.index_below(search.map_span * brackets[0][1])))
    yield from grid.grow(grid.first, end)
    while None in (robust := _robust_index(grid, half), slv := _robust_slv_index(grid)) and grid.last < limit:
        yield from grid.grow(grid.first, min(limit, grid.last + max(half, 1)))
    if robust is not None and slv is not None:
        grid.cut(max(end, robust + half, slv + search.half_slv_window))
    return _result(grid, "collapse_found", brackets, robust)


def _descend(grid: _Map, half: int) -> Steps:
    """Extend a trilinear map downwards until a whole robust window survives below it."""
    floor = grid.index_below(TRILINEAR_FLOOR) + 1
    yield from grid.grow(max(floor, -half), 0)
    width = half + 1
    while grid.first > floor:
        low = slice(0, width)
        if not grid.reaches(grid.outcomes[low], grid.peaks[low], LOWER_SLV).any():
            break
        width = 2 * half + 1
        yield from grid.grow(max(floor, grid.first - half - 1), grid.last)


def collapse_count(collapsed: np.ndarray, half: int) -> np.ndarray:
    """Flagged (collapsing) points within +-half points of each point; beyond the ends there are none."""
    total = np.concatenate([[0], np.cumsum(collapsed)])
    index = np.arange(collapsed.size)
    low = np.maximum(index - half, 0)
    high = np.minimum(index + half, collapsed.size - 1)
    return total[high + 1] - total[low]


def first_with_share(flags: np.ndarray, half: int, share: float) -> int | None:
    """First index whose whole window of +-half points holds at least this share of flags; None without one.
    Before the first point there are none."""
    count = collapse_count(flags, half)[: max(flags.size - half, 0)]
    hits = np.nonzero(count >= share * (2 * half + 1))[0]
    return int(hits[0]) if hits.size else None


def _robust_index(grid: _Map, half: int, fraction: float = math.inf) -> int | None:
    """Smallest grid index whose whole window holds a share >= 0.16 of points that collapse, or whose peak reaches this
    fraction of theta_c."""
    index = first_with_share(grid.reaches(grid.outcomes, grid.peaks, fraction), half, ROBUST_SHARE)
    return None if index is None else grid.first + index


def _robust_slv_index(grid: _Map) -> int | None:
    """Grid index of q_slv_robust."""
    return _robust_index(grid, grid.search.half_slv_window, LIMIT_FRACTION["SLV"])


def _result(grid: _Map, status: str, brackets, robust: int | None) -> Ida:
    """brackets : of q, q_slv, q_slc, each None where it has none."""
    collapses = status == "collapse_found"
    robust_slv = _robust_slv_index(grid) if brackets[1] else None
    q, q_slv, q_slc = (bracket[1] if bracket else None for bracket in brackets)
    lower = grid.first_reaching(LOWER_SLV) if q_slv is not None else None
    windows, last, fraction = [], None, None
    if collapses:
        survives = grid.outcomes == STABLE
        start = int(np.argmax(grid.outcomes == COLLAPSED))
        last_index = int(np.nonzero(survives)[0][-1]) if survives.any() else None
        last = grid.q_of(grid.first + last_index) if last_index is not None else None
        known = grid.outcomes[start : (last_index or 0) + 1]
        known = known[known != IMPACT_LIMIT]
        fraction = float((known == STABLE).mean()) if known.size else 0.0
        windows = [(grid.q_of(grid.first + a), grid.q_of(grid.first + b)) for a, b in _runs(survives) if a > start]
    return Ida(
        status=status,
        q=q,
        bracket=brackets[0],
        q_slv=q_slv,
        q_slc=q_slc,
        q_slv_low=grid.q_of(lower - 1) if lower is not None else None,
        q_slv_robust=grid.q_of(robust_slv) if robust_slv is not None else None,
        q_robust=grid.q_of(robust) if robust is not None else None,
        q_last_survival=last,
        survived_fraction=fraction,
        survival_windows=tuple(windows),
        analyses=grid.analyses,
        impact_limited=int((grid.outcomes == IMPACT_LIMIT).sum()),
        clamped=int(grid.clamped.sum()),
        q_start=grid.q_start,
        first_index=grid.first,
        below_floor=any(bracket is not None and bracket[0] == 0.0 for bracket in brackets),
        outcomes=(grid.outcomes + ord("0")).astype(np.uint8).tobytes().decode(),
    )


def _runs(flags: np.ndarray) -> list[tuple[int, int]]:
    """First and last index of each unbroken run of true flags."""
    edges = np.diff(np.concatenate([[0], flags.astype(int), [0]]))
    starts, stops = np.nonzero(edges == 1)[0], np.nonzero(edges == -1)[0]
    return [(int(a), int(b) - 1) for a, b in zip(starts, stops, strict=True)]
