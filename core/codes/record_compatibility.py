"""Are the records compatible with the target spectrum? NTC 2018 3.2.3.6 and EN 1998-1 3.2.3.1.2."""

import functools
import hashlib
import math
from dataclasses import dataclass, field

import numpy as np

from core.codes.demand import SeismicDemand
from core.codes.limits import MIN_STATIONS_FOR_MINIMUM, counted_stations
from core.codes.target_spectrum import GivenSpectrum
from core.errors import InputError, section
from core.ground.ground_motion import GroundMotion
from core.ground.provenance import unnamed
from core.ground.response_spectrum import HOUSNER_PERIODS, pseudo_acceleration_spectrum
from core.units import G

PERIOD_RANGE = (0.15, 2.0)
"""Periods of the rules [s]: a rigid block has no period T that could narrow them. With natural records, whose
range of interest is that of the structure, they go on to the longest T_SLV or T_SLC of the walls."""

PERIOD_STEP = 0.01
"""Ratio less 1 between neighbouring periods at which the mean is compared with the target; both ends of the range are
among them. A step of 0.001 moves no extreme of sets of the shelf by 0.5 % of the target (test_record_compatibility)."""

LOWER_BOUND = {"artificial": -0.10, "simulated": -0.20, "natural": -0.10}
UPPER = {"natural": 0.30}
"""Mean 5 % spectrum against the target (NTC 2018 3.2.3.6)."""

STRONG_PART, WHOLE_LENGTH = 10.0, 25.0
"""Pseudo-stationary part and total duration of artificial motions [s]."""


@dataclass(frozen=True)
class CompatibilityRule:
    """One rule: code (NTC, EN or shown), clause, name, value, limit, passed (None: shown only); unit of
    both: %, g, s or empty."""

    code: str
    clause: str
    name: str
    value: float
    limit: float | None
    unit: str
    passed: bool | None


@dataclass(frozen=True)
class Compliance:
    """The set against its target.

    periods : [s], shape (periods,)
    spectra : S_a of each record at the demand [m/s2], FC apart, shape (records, periods)
    mean, target : [m/s2], shape (periods,)
    stations : counted once each, by a record that counts
    compatible : by the code of the spectrum
    period_range : of the rules [s]
    unnamed : files that name no station
    full_range : the periods that matter, where no range is asked [s]
    longest : T_SLV or T_SLC of the walls [s]
    """

    periods: np.ndarray
    spectra: np.ndarray
    mean: np.ndarray
    target: np.ndarray
    rules: tuple[CompatibilityRule, ...]
    stations: int
    compatible: bool
    period_range: tuple[float, float] = PERIOD_RANGE
    unnamed: int = 0
    full_range: tuple[float, float] = PERIOD_RANGE
    longest: float = 0.0

    @property
    def narrow(self) -> bool:
        """Whether the range asked leaves out periods that matter."""
        low, high = self.period_range
        return low > self.full_range[0] + 1e-9 or high < self.full_range[1] - 1e-9


def strong_duration(motion: GroundMotion) -> float:
    """Time [s] the power of a motion, smoothed over 2 s, is at least a fifth of its largest."""
    size = max(1, round(2.0 / motion.time_step))
    power = np.convolve(motion.acceleration**2, np.full(size, 1.0 / size), "same")
    return float(np.count_nonzero(power >= 0.2 * power.max()) * motion.time_step)


def full_range(kinds: list[str], longest: float) -> tuple[float, float]:
    """Periods that matter [s]: `PERIOD_RANGE`, with natural records up to the longest T_SLV or T_SLC of the walls."""
    return PERIOD_RANGE[0], max(PERIOD_RANGE[1], longest) if "natural" in kinds else PERIOD_RANGE[1]


def period_range(kinds: list[str], longest: float, demand: SeismicDemand) -> tuple[float, float]:
    """Periods of the rules [s]: as asked, else all that matter. Raises InputError beyond the spectrum of a file."""
    low, high = full_range(kinds, longest)
    if demand.period_range is not None:
        low, high = demand.period_range
    target = demand.target
    if isinstance(target, GivenSpectrum) and high > target.periods[-1]:
        raise InputError(
            "period_range_beyond", high=high, name=target.name, end=target.periods[-1], place=(section("[demand]"),)
        )
    return low, high


def compared_periods(asked_range: tuple[float, float], longest: float) -> tuple[tuple[float, float], np.ndarray]:
    """(the periods shown, all at which records are compared) [s]. asked_range : of the rules"""
    shown = (float(HOUSNER_PERIODS[0]), max(float(HOUSNER_PERIODS[-1]), longest))
    ends = (min(shown[0], asked_range[0]), max(shown[1], asked_range[1]))
    count = math.ceil(math.log(ends[1] / ends[0]) / math.log1p(PERIOD_STEP)) + 1
    steps = np.geomspace(ends[0], ends[1], count)
    return shown, np.unique(np.round([*steps, ends[1], *shown, *asked_range], 9))


def period_mask(periods: np.ndarray, ends: tuple[float, float]) -> np.ndarray:
    """Which periods [s] are between two, with both."""
    return (ends[0] - 1e-9 <= periods) & (ends[1] + 1e-9 >= periods)


def deciding_codes(demand: SeismicDemand) -> set[str]:
    """Codes whose rules decide: of a spectrum of a file, which names no code, both."""
    code = demand.spectrum_code
    return {code[: code.index("1998" if code.startswith("EN") else "2018")]} if code else {"EN", "NTC"}


def natural_bounds(demand: SeismicDemand) -> tuple[float, float, float]:
    """(least, most mean spectrum over the target, least mean PGA over a_g S) of natural records [-]; inf and 0 where
    the code asks for nothing."""
    codes = deciding_codes(demand)
    return 1.0 + LOWER_BOUND["natural"], 1.0 + UPPER["natural"] if "NTC" in codes else math.inf, float("EN" in codes)


def common_factor(motions: list[GroundMotion], demand: SeismicDemand) -> float:
    """The one factor of all records for which their mean 5 % spectrum is nearest to the target, by the mean of the
    logarithms of their ratio over the periods of the rules."""
    assert demand.target is not None
    low, high = demand.period_range or PERIOD_RANGE
    count = math.ceil(math.log(high / low) / math.log1p(PERIOD_STEP)) + 1
    periods = np.geomspace(low, high, count)
    spectra = [demand.scaling(m) * cached_spectrum(m.acceleration, m.time_step, periods) for m in motions]
    ratio = demand.target.acceleration(periods) / np.mean(spectra, axis=0)
    return float(np.exp(np.log(ratio).mean()))


CACHED_SPECTRA = 128
"""Spectra that are kept: those of a generated set serve all walls of a case, and all that is changed in them."""


@dataclass(frozen=True)
class _Samples:
    """Samples [m/s2], told apart by their hash."""

    digest: bytes
    time_step: float
    acceleration: np.ndarray = field(compare=False)


def cached_spectrum(ground: np.ndarray, dt: float, periods: np.ndarray) -> np.ndarray:
    """`pseudo_acceleration_spectrum` [m/s2] of 5 % damping; of the last CACHED_SPECTRA motions and periods it is not
    made again, and none may change it. ground [m/s2], dt, periods [s]"""
    samples = np.ascontiguousarray(ground)
    key = _Samples(hashlib.blake2b(samples.tobytes(), digest_size=20).digest(), dt, samples)
    return _spectrum(key, tuple(periods.tolist()))


@functools.lru_cache(CACHED_SPECTRA)
def _spectrum(samples: _Samples, periods: tuple[float, ...]) -> np.ndarray:
    spectrum = pseudo_acceleration_spectrum(samples.acceleration, samples.time_step, np.array(periods))
    spectrum.flags.writeable = False
    return spectrum


def check_compatibility(
    motions: list[GroundMotion], kinds: list[str], demand: SeismicDemand, longest: float = 0.0
) -> Compliance | None:
    """The rules one by one; None without records or without a target spectrum. longest : T_SLV or T_SLC of
    the walls [s]."""
    if not motions or demand.target is None:
        return None
    asked_range = period_range(kinds, longest, demand)
    shown, periods = compared_periods(asked_range, longest)
    factors = [demand.scaling(motion) for motion in motions]
    spectra = np.array(
        [
            factor * cached_spectrum(m.acceleration, m.time_step, periods)
            for m, factor in zip(motions, factors, strict=True)
        ]
    )
    mean = spectra.mean(axis=0)
    target = demand.target.acceleration(periods)
    difference = mean / target - 1.0

    def extremes(ends) -> tuple[float, float]:
        inside = difference[period_mask(periods, ends)]
        return float(inside.min()), float(inside.max())

    low, high = extremes(asked_range)
    count = float(len(counted_stations(motions, demand)))
    pga = float(np.mean([f * m.pga for m, f in zip(motions, factors, strict=True)]))
    lower = max(LOWER_BOUND[kind] for kind in kinds)
    upper = UPPER["natural"] if "natural" in kinds else None
    ntc = "NTC 2018 3.2.3.6"
    en = "EN 1998-1 3.2.3.1.2"
    rules = [
        CompatibilityRule("NTC", ntc, "mean_lower", low, lower, "%", low >= lower),
        CompatibilityRule("NTC", ntc, "mean_upper", high, upper, "%", None if upper is None else high <= upper),
        CompatibilityRule(
            "EN", en + "(4)a", "records", count, MIN_STATIONS_FOR_MINIMUM, "", count >= MIN_STATIONS_FOR_MINIMUM
        ),
        CompatibilityRule(
            "EN", en + "(4)b", "mean_pga", pga / G, demand.pga / G, "g", pga >= demand.pga * (1.0 - 1e-6)
        ),
        CompatibilityRule("EN", en + "(4)c", "mean_lower", low, -0.10, "%", low >= -0.10),
    ]
    made = [m for m, kind in zip(motions, kinds, strict=True) if kind == "artificial"]
    if made:
        strong = min(strong_duration(motion) for motion in made)
        whole = min(motion.duration for motion in made)
        rules += [
            CompatibilityRule(
                "both", f"{ntc}, {en}(3)", "strong_part", strong, STRONG_PART, "s", strong >= STRONG_PART - 1e-6
            ),
            CompatibilityRule("NTC", ntc, "duration", whole, WHOLE_LENGTH, "s", whole >= WHOLE_LENGTH - 1e-6),
        ]
    least, most = extremes(shown)
    rules += [
        CompatibilityRule("shown", f"{shown[0]:.1f}-{shown[1]:.1f} s", name, value, None, "%", None)
        for name, value in (("mean_lower", least), ("mean_upper", most))
    ]
    decides = [rule.passed for rule in rules if rule.code in (*deciding_codes(demand), "both")]
    return Compliance(
        periods,
        spectra,
        mean,
        target,
        tuple(rules),
        int(count),
        all(passed is not False for passed in decides),
        asked_range,
        unnamed(motions),
        full_range(kinds, longest),
        longest,
    )
