"""How often a limit state of a wall is exceeded in a year: its fragility under the records, and the hazard of the site.

Beyond the code: the mean annual frequency lambda = integral of F(a) |dH(a)| (Cornell and Krawinkler 2000), F lognormal
by the records, H = 1 / T_R the straight lines in logarithms between the return periods of the hazard (NTC 2018,
Annex A). The confidence factor divides every capacity, as in the checks; without it the rate is shown beside.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from core.ground.provenance import INTERVAL_SHARE, MIN_STATIONS, bootstrap_counts

RATE_STATES = ("SLD", "SLV", "SLC", "collapse")
"""SLD is the first uplift; SLV and SLC the rotations of C8.7.1.2.1.6; collapse that of the first multiplier."""

STATION_DRAWS = 400
"""Sets of stations drawn for the interval."""

MIN_DEVIATION, MAX_DEVIATION = 1e-6, 2.0
"""Bounds of the deviation of ln a_g [-]: records that all give the same are given the lower one, so that they too make
a lognormal; records at the upper one tell nothing."""

STEEP = 15.0
"""Slope of a line of the hazard above which it is a step: rows of nearly one a_g."""

MIN_REPORTED_SHARE = 0.05
"""Share of a rate, and of walls that fail below the hazard, above which it is said."""


@dataclass(frozen=True)
class Lognormal:
    """median : a_g on rock [m/s2]; deviation : of its logarithm; n : records"""

    median: float
    deviation: float
    n: int


@dataclass(frozen=True)
class StateRate:
    """Rate of one limit state. collapse is one of them.

    fragility : of a_g on rock, FC included
    rate : exceedances a year [1/year]; low, high : for INTERVAL_SHARE of the drawn sets of stations
    in_life : probability in the nominal life, None without it
    without_factor : rate without FC
    beyond : share of the rate from motions stronger than the hazard tells by more than one step, F = 1
    weaker : F at a_g one step below the first row, where no motion is counted
    """

    state: str
    fragility: Lognormal
    rate: float
    low: float
    high: float
    in_life: float | None
    without_factor: float
    beyond: float
    weaker: float


def _normal(x: np.ndarray) -> np.ndarray:
    """Standard normal distribution; scipy.special, which would do, is not in the frozen program."""
    return 0.5 * np.array([math.erfc(one) for one in (-math.sqrt(0.5) * x).ravel().tolist()]).reshape(x.shape)


def _between(low: float, high: float, anchor: tuple[float, float], slope: float, median, deviation) -> np.ndarray:
    """Integral of F(a) |dH| from low to high [m/s2], H = h (a / a_h)^-slope: by parts, in closed form.

    anchor : (a_h, h)
    """
    at, frequency = anchor
    ends = np.log(np.array([low, high])[:, None] / median) / deviation
    hazard = [frequency * (a / at) ** -slope for a in (low, high)]
    first, last = _normal(ends) * np.array(hazard)[:, None]
    moved = ends + slope * deviation
    side = np.where(moved[0] > 0.0, -1.0, 1.0)  # of the smaller tail: near 1 the difference would lose its digits
    first_moved, last_moved = side * _normal(side * moved)
    middle = frequency * (median / at) ** -slope * np.exp(0.5 * (slope * deviation) ** 2)
    return middle * (last_moved - first_moved) + first - last


def mean_rate(median, deviation, hazard: Sequence[tuple[float, float]]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(mean annual frequency [1/year], share of it from stronger motions than the hazard tells by more than one step, F
    at the weakest motion that is counted).

    median, deviation : of lognormals of a_g on rock [m/s2], shape (n,)
    hazard : (T_R [years], a_g [m/s2]), both rising, two rows or more
    The first and the last line go on by one step, as far as the two rows are apart. Weaker motions are not counted;
    under stronger ones the wall is taken to fail, F = 1.
    """
    years, ags = np.array(hazard).T
    median, deviation = np.asarray(median), np.minimum(deviation, MAX_DEVIATION)
    slopes = -np.diff(np.log(1.0 / years)) / np.diff(np.log(ags))
    edges = [ags[0] * ags[0] / ags[1], *ags[1:-1], ags[-1] * ags[-1] / ags[-2]]
    total = np.zeros(median.size)
    for k, slope in enumerate(slopes):
        low, high, anchor = edges[k], edges[k + 1], (ags[k], 1.0 / years[k])
        if slope > STEEP:
            steps = [anchor[1] * math.exp(-slope * math.log(edge / anchor[0])) for edge in (low, high)]
            middle = np.log(math.sqrt(low * high) / median) / deviation
            total += _normal(middle) * (steps[0] - steps[1])
        else:
            total += _between(low, high, anchor, slope, median, deviation)
    above = math.exp(-slopes[-1] * math.log(edges[-1] / ags[-1])) / years[-1]
    weaker = _normal(np.log(edges[0] / median) / deviation)
    return total + above, above / (total + above), weaker


def typical_rate(capacities: Sequence[float], hazard: Sequence[tuple[float, float]]) -> float:
    """Mean annual frequency by the lognormal of these capacities [m/s2], without FC and interval."""
    logs = np.log(np.asarray(capacities))
    deviation = max(float(logs.std(ddof=1)), MIN_DEVIATION)
    return float(mean_rate(np.exp(logs.mean(keepdims=True)), np.array([deviation]), hazard)[0][0])


def exceedance_probability(rate: float, years: float) -> float:
    """Probability of one exceedance or more [-]: 1 - exp(-rate years), of a Poisson process."""
    return -math.expm1(-rate * years)


def state_rate(
    state: str,
    capacities: Sequence[float],
    stations: Sequence[str],
    hazard: Sequence[tuple[float, float]],
    confidence: float,
    life: float | None,
) -> StateRate | None:
    """The rate of one limit state; None below MIN_STATIONS stations.

    capacities : a_g on rock at which each record reaches it, without FC [m/s2]
    stations : of each record
    hazard : as `mean_rate` takes it
    confidence : FC; life : nominal, None where not given [years]
    """
    if len(set(stations)) < MIN_STATIONS or not hazard:
        return None
    logs = np.log(np.asarray(capacities) / confidence)
    times = bootstrap_counts(list(stations), STATION_DRAWS)
    n = times.sum(axis=1)
    means = times @ logs / n
    spread = np.sqrt((times * (logs - means[:, None]) ** 2).sum(axis=1) / np.maximum(n - 1, 1))
    medians = np.array([np.exp(logs.mean()), confidence * np.exp(logs.mean()), *np.exp(means)])
    own = logs.std(ddof=1)
    rates, beyond, weaker = mean_rate(medians, np.maximum([own, own, *spread], MIN_DEVIATION), hazard)
    low, high = np.quantile(rates[2:], (0.5 - INTERVAL_SHARE / 2, 0.5 + INTERVAL_SHARE / 2))
    rate = float(rates[0])
    in_life = None if life is None else exceedance_probability(rate, life)
    fragility = Lognormal(float(medians[0]), float(own), logs.size)
    return StateRate(
        state, fragility, rate, float(low), float(high), in_life, float(rates[1]), float(beyond[0]), float(weaker[0])
    )
