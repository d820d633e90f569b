"""[select]: the records of a folder whose mean spectrum is nearest to that of the demand, within its rule."""

import math
import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from core.case.schema import Record
from core.case.select import Select
from core.codes.demand import SeismicDemand
from core.codes.limits import MIN_STATIONS_FOR_MINIMUM
from core.codes.record_compatibility import compared_periods, natural_bounds, period_mask, period_range
from core.errors import Cancelled, InputError, RecordError, section
from core.file_names import key_of, name_of
from core.ground.record_folder import Candidate, ExcludedRecord, Limits, drop_duplicate_records, files_in, read_file
from core.ground.selection import OWN_FIT, OWN_PGA, Bounds, RankedSet, nearest_sets, own_factors
from core.setting.record_input import case_relative_path
from core.text.sentence import Sentence
from core.threads import Threads

MAX_CANDIDATES = 3000
"""Records that a search takes: it keeps the product of each two of them."""

BOUND_MARGIN = 1e-9
"""Margin by which the bounds of the search are within those of the code: a set on its bound is judged the same
twice."""

FACTOR_DECIMALS = 4
"""Decimals of a factor."""


@dataclass(frozen=True)
class ChosenSet:
    """A set of records, with what the code asks of it.

    records : with their factors, as [[record]] has them
    deviation : root mean square of mean over target less 1 [-], over the periods compared
    lowest, highest : of mean over target, (period [s], ratio)
    pga_ratio : mean PGA over a_g S
    miss : 0 where the code's bounds hold; else the factor less 1 that brings the worst ordinate to them
    mean : spectrum at the periods of the selection [m/s2]
    stations : of how many it is; least_stations : the code asks for
    """

    records: tuple[Record, ...]
    deviation: float
    lowest: tuple[float, float]
    highest: tuple[float, float]
    pga_ratio: float
    miss: float
    mean: tuple[float, ...]
    stations: int
    least_stations: int

    @property
    def fits(self) -> bool:
        return self.miss == 0.0 and self.stations >= self.least_stations


@dataclass(frozen=True)
class Selection:
    """Sets that [select] found.

    files : looked at; candidates : records among which the sets were searched
    left_out : files and channels that are no candidates
    sets : the best first; the first is taken
    every : every combination was looked at
    period_range : compared [s]
    bounds : least and most mean over target, least mean PGA over a_g S
    periods, target : [s], [m/s2]
    """

    folder: str
    files: int
    candidates: int
    left_out: tuple[ExcludedRecord, ...]
    sets: tuple[ChosenSet, ...]
    every: bool
    period_range: tuple[float, float]
    bounds: tuple[float, float, float]
    periods: tuple[float, ...]
    target: tuple[float, ...]

    @property
    def chosen(self) -> ChosenSet:
        return self.sets[0]

    @property
    def reasons(self) -> list[tuple[Sentence, int]]:
        """Why files are left out, and how many for each, the most frequent first."""
        counts: dict[str, list] = {}
        for one in self.left_out:
            counts.setdefault(one.reason.code, [one.reason, 0])[1] += 1
        return sorted(((reason, n) for reason, n in counts.values()), key=lambda entry: -entry[1])


def select_records(
    asked: Select,
    base_dir: Path,
    demand: SeismicDemand,
    longest: float,
    told: Callable[[int, int], None] = lambda done, planned: None,
    cancelled: Callable[[], bool] = lambda: False,
) -> Selection:
    """The sets nearest to the spectrum of a demand.

    base_dir : the folder starts from there
    longest : T_SLV or T_SLC of the walls [s]
    told : called from this thread with the hundredths done and 100
    Raises InputError where there is no set, Cancelled.
    """
    here = section("[select]")
    assert demand.target is not None
    asked_range = period_range(["natural"], longest, demand)
    periods = compared_periods(asked_range, longest)[1]
    periods = periods[period_mask(periods, asked_range)]
    files = files_in(base_dir / name_of(asked.folder))
    candidates, left = _candidates(files, asked, periods, told, cancelled)
    target = demand.target.acceleration(periods)
    far = _far(candidates, target, demand.pga, asked)
    left += far
    gone = {(one.file, one.channel) for one in far}
    candidates = [candidate for candidate in candidates if (candidate.file, candidate.channel) not in gone]
    if len(candidates) < asked.count:
        why = tuple({one.reason.code: one.reason for one in left}.values())[:3]
        stated = {"found": len(candidates), "count": asked.count, "files": len(files)}
        if not why:
            raise InputError("select_few_files", place=(here,), **stated)
        raise InputError("select_too_few", place=(here,), why=why, **stated)
    if len(candidates) > MAX_CANDIDATES:
        raise InputError("select_too_many", place=(here,), found=len(candidates), most=MAX_CANDIDATES)
    pga = np.array([candidate.pga for candidate in candidates]) / demand.pga
    ratios = np.column_stack([np.array([candidate.spectrum for candidate in candidates]) / target, pga])
    factors, common = _factors(ratios[:, :-1], asked)
    bounds = natural_bounds(demand)
    low, high, start = bounds
    asked_bounds = Bounds(low * (1.0 + BOUND_MARGIN), high * (1.0 - BOUND_MARGIN), start, common)

    def searched(share: float) -> bool:
        told(50 + int(50 * share), 100)
        if cancelled():
            raise Cancelled
        return False

    stations, events = (
        _numbered([candidate.station for candidate in candidates]),
        _numbered([candidate.event for candidate in candidates]),
    )
    limits = (asked.per_station, asked.per_event)
    scaled = ratios * factors[:, None]
    sets, every = nearest_sets(scaled, asked.count, stations, events, limits, asked_bounds, searched)
    if not sets:
        stated = {"of_station": asked.per_station, "of_event": asked.per_event}
        raise InputError("select_no_set", place=(here,), found=len(candidates), count=asked.count, **stated)

    def name(path: Path) -> str:
        return case_relative_path(path, base_dir, asked.folder)

    made = [_set_of(one, candidates, factors, scaled, periods, target, asked_bounds, name) for one in sets]
    return Selection(
        asked.folder,
        len(files),
        len(candidates),
        tuple(left),
        tuple(sorted(made, key=lambda one: (one.miss, one.deviation))),
        every,
        asked_range,
        bounds,
        tuple(periods.tolist()),
        tuple(target.tolist()),
    )


def _candidates(
    files: list[Path], asked: Select, periods: np.ndarray, told, cancelled
) -> tuple[list[Candidate], list[ExcludedRecord]]:
    """(records, what is left out), in an order that does not depend on that of the files. told, cancelled : as of
    `select_records`"""
    limits = Limits(asked.magnitude, asked.distance_km, asked.soil)
    done = iter(range(1, len(files) + 1))

    def task(path: Path):
        return lambda stop: [] if stop() else read_file(path, periods, limits)

    threads = Threads(os.cpu_count() or 1, cancelled)
    tasks = {k: task(path) for k, path in enumerate(files)}
    read = threads.run(tasks, lambda k, _: told(50 * next(done) // len(files), 100))
    parts = [part for k in range(len(files)) for part in read[k]]
    kept, copies = drop_duplicate_records([part for part in parts if isinstance(part, Candidate)])
    return kept, [part for part in parts if isinstance(part, ExcludedRecord)] + copies


def _factors(ratios: np.ndarray, asked: Select) -> tuple[np.ndarray, tuple[float, float]]:
    """(factor of each record, least and most of the one factor of all). ratios : spectra over the target"""
    if asked.scaling == "individual":
        fitted = np.exp(-np.log(ratios).mean(axis=1))
        return np.round(np.clip(fitted, *asked.scale_limits), FACTOR_DECIMALS), (1.0, 1.0)
    return np.ones(len(ratios)), asked.scale_limits if asked.scaling == "common" else (1.0, 1.0)


def _far(candidates: list[Candidate], target: np.ndarray, pga: float, asked: Select) -> list[ExcludedRecord]:
    """The candidates that no allowed factor brings within `OWN_FIT` of the target and to `OWN_PGA` of its PGA.
    target, pga : [m/s2]"""
    ratios = np.array([candidate.spectrum for candidate in candidates]).reshape(-1, target.size) / target
    factors, common = _factors(ratios, asked)
    means = factors * ratios.mean(axis=1)
    peaks = factors * np.array([candidate.pga for candidate in candidates]) / pga
    least, most = own_factors(means, peaks, common).T
    limits = {"low": OWN_FIT[0], "high": OWN_FIT[1], "least": OWN_PGA}
    far = []
    for k in np.flatnonzero(least > most):
        error = RecordError("selected_far", ratio=float(means[k]), pga=float(peaks[k]), **limits)
        far.append(ExcludedRecord(candidates[k].file, candidates[k].channel, error.without_place))
    return far


def _numbered(names: list[str]) -> np.ndarray:
    return np.unique(names, return_inverse=True)[1].astype(np.int64)


def _set_of(
    one: RankedSet,
    candidates: list[Candidate],
    factors: np.ndarray,
    ratios: np.ndarray,
    periods: np.ndarray,
    target: np.ndarray,
    bounds: Bounds,
    name: Callable[[Path], str],
) -> ChosenSet:
    """A set with its factor of `FACTOR_DECIMALS` decimals: the nearest one that keeps the bounds.

    one : as found
    candidates : the records of the folder that may be taken
    factors : of each
    ratios : of each, scaled by them, as `nearest_sets` takes them
    periods, target : [s], [m/s2]
    bounds : of the search
    name : of a file in the case
    """
    members = list(one.members)
    mean = ratios[members].mean(axis=0)
    step = 10.0**-FACTOR_DECIMALS
    tried = [
        round(one.factor, FACTOR_DECIMALS),
        math.ceil(one.factor / step) * step,
        math.floor(one.factor / step) * step,
    ]
    allowed = [round(min(max(factor, bounds.factors[0]), bounds.factors[1]), FACTOR_DECIMALS) for factor in tried]
    factor = min(allowed, key=lambda factor: _miss(factor * mean, bounds))
    mean = factor * mean
    inner = mean[:-1]
    low, high = int(np.argmin(inner)), int(np.argmax(inner))
    records = tuple(
        Record(
            file=key_of(name(candidates[k].file)),
            channel=candidates[k].channel,
            scale=round(float(factor * factors[k]), FACTOR_DECIMALS),
        )
        for k in members
    )
    return ChosenSet(
        records,
        float(np.sqrt(np.mean((inner - 1.0) ** 2))),
        (float(periods[low]), float(inner[low])),
        (float(periods[high]), float(inner[high])),
        float(mean[-1]),
        _miss(mean, bounds),
        tuple((inner * target).tolist()),
        len({(candidates[k].event, candidates[k].station) if candidates[k].said.station else k for k in members}),
        MIN_STATIONS_FOR_MINIMUM if bounds.start else 0,
    )


def _miss(mean: np.ndarray, bounds: Bounds) -> float:
    """As `Found` has it, of a mean over its target, its PGA last."""
    needed = max(bounds.low / mean[:-1].min(), bounds.start / mean[-1])
    return max(float(max(needed, mean[:-1].max() / bounds.high) - 1.0), 0.0)
