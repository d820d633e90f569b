"""Search of the sets of records whose mean spectrum is nearest to a target within bounds. Numbers only; what a record
is, and what a code asks of the mean, is known above."""

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from core.jit.decorators import kernel, subkernel

MAX_SETS_LISTED = 10
"""Sets that are told."""

MAX_SETS = 10_000_000
"""Combinations up to which every one is looked at."""

RECORDS_REDRAWN, UNIMPROVED = 3, 200
"""Records of the best set that a new start draws anew; starts without a better one after which all are."""

MAX_STARTS, MAX_WORK, EXCHANGE, SPECTRUM = 20_000, 3_000_000_000, 4, 200
"""Starts of the search beyond, and its work: an exchange of one record counts as so many for each record of a set, a
mean spectrum as so many. A count, not a time, decides when it ends, so that the same records give the same sets on
every computer."""


OWN_FIT = (0.2, 5.0)
"""Mean over the periods of the spectrum of one record, with its factor, over the target, least and most [-]: a record
far below the others would add to the number of stations and to nothing else, and leave the mean to the others."""


OWN_PGA = 0.3
"""Least PGA of one record, with its factor, over that of the target [-]: below a fifth of the mean PGA of the set,
which is up to about 1.4 of the target, it would not count for the rule of the set (core/codes/limits.py)."""


class Bounds(NamedTuple):
    """Bounds on the mean spectrum over the target.

    low, high : of it at every period [-]; high may be inf
    start : of the mean PGA over that of the target [-], 0 where nothing is asked of it
    factors : of the one factor of all records; (1, 1) where there is none
    """

    low: float
    high: float
    start: float
    factors: tuple[float, float]


class RankedSet(NamedTuple):
    """A set of records that was found.

    members : indices of its records, rising
    factor : of all of them [-]
    miss : how far the mean is beyond its bounds, as the factor less 1 that would bring its worst ordinate to them [-];
        0 where it is within
    deviation : root mean square of mean over target less 1 [-]
    """

    members: tuple[int, ...]
    factor: float
    miss: float
    deviation: float


@subkernel
def score_set(total, size, low, high, start, least, most):
    """(miss, deviation, factor) of a set, as `Found` has them.

    total : sums of the ratios of its records at each period and of their PGA, shape (periods + 1,)
    size : records
    low, high, start : as of `Bounds`
    least, most : the factors allowed

    With the factor c the deviation is mean((c r - 1)^2), smallest at c = sum(r) / sum(r^2); within the bounds c lies
    between low / min(r) and high / max(r). Where these leave no c, that of the smallest miss is their geometric mean.
    """
    periods = total.size - 1
    first = 0.0
    second = 0.0
    smallest = total[0]
    largest = total[0]
    for k in range(periods):
        value = total[k]
        first += value
        second += value * value
        smallest = min(smallest, value)
        largest = max(largest, value)
    needed = low * size / smallest
    if start > 0.0:
        needed = max(needed, start * size / total[periods])
    allowed = high * size / largest
    if needed <= allowed:
        factor = min(max(first * size / second, needed), allowed)
    else:
        factor = math.sqrt(needed * allowed)
    factor = min(max(factor, least), most)
    miss = max(max(needed / factor, factor / allowed) - 1.0, 0.0)
    if miss < 1e-12:  # the factor is one of the bounds
        miss = 0.0
    scale = factor / size
    square = 1.0 - 2.0 * scale * first / periods + scale * scale * second / periods
    return miss, math.sqrt(max(square, 0.0)), factor


@subkernel
def least_deviation(first, second, size, least, most):
    """Below it no set of these sums comes, whatever its bounds [-]. first, second : mean over the periods of the sum of
    its ratios, and of its square; least, most : the factors allowed"""
    scale = min(max(first * size / second, least), most) / size
    return math.sqrt(max(1.0 - 2.0 * scale * first + scale * scale * second, 0.0))


@subkernel
def better(miss, deviation, other_miss, other_deviation):
    """Whether a set comes before another: within the bounds first, then by its deviation."""
    return miss < other_miss or (miss == other_miss and deviation < other_deviation)


@subkernel
def within_limits(members, count, one, stations, events, per_station, per_event):
    """Whether one more record keeps to the limits of a set.

    members, count : the set, and how many of its places count
    one : the record
    stations, events : number of the station and of the event of each record
    per_station, per_event : most records of one
    """
    same_station = 0
    same_event = 0
    for k in range(count):
        other = members[k]
        if other == one:
            return False
        same_station += stations[other] == stations[one]
        same_event += events[other] == events[one]
    return same_station < per_station and same_event < per_event


@subkernel
def common_span(members, count, spans):
    """Least and most factor that all of the first `count` members have. spans : of each record, shape (records, 2)"""
    least, most = 0.0, math.inf
    for k in range(count):
        least = max(least, spans[members[k], 0])
        most = min(most, spans[members[k], 1])
    return least, most


@subkernel
def allowed_beside(members, count, one, stations, events, spans, per_station, per_event):
    """`within_limits`, and whether one more record has a factor in common with the set.
    members, count, one, stations, events, spans, per_station, per_event : as of the two functions above"""
    least, most = common_span(members, count, spans)
    meets = max(least, spans[one, 0]) <= min(most, spans[one, 1])
    return meets and within_limits(members, count, one, stations, events, per_station, per_event)


@subkernel
def add_up(members, rows, total):
    """Add up the rows of the members, in their order, into total, shape (columns,)."""
    for k in range(total.size):
        value = 0.0
        for i in range(members.size):
            value += rows[members[i], k]
        total[k] = value


@kernel
def every_set(ratios, products, means, stations, events, spans, limits, bounds, members, totals, best, values):
    """Look at every set, in lexicographic order; returns how many keep to the limits of station and event.

    ratios : spectrum over target of each record, its PGA over that of the target last, shape (records, periods + 1)
    products : mean over the periods of the product of the ratios of two records, shape (records, records)
    means : mean over the periods of the ratios of each record
    stations, events : number of the station and of the event of each record
    spans : least and most factor of each record, shape (records, 2)
    limits : most records of a station and of an event
    bounds : low, high, start, least and most factor
    members : room of a set, -1 at first, shape (size,)
    totals : room, zeros at first, shape (size + 1, columns of the ratios + 2)
    best : the best sets found, the best first, shape (sets, size), filled
    values : miss and deviation of each, shape (sets, 2), inf at first
    """
    n, width = ratios.shape
    low, high, start, least, most = bounds
    size = members.size
    looked = 0
    depth = 0
    while depth >= 0:
        members[depth] += 1
        one = members[depth]
        if one > n - size + depth:
            depth -= 1
            continue
        if not allowed_beside(members, depth, one, stations, events, spans, limits[0], limits[1]):
            continue
        cross = 0.0
        for k in range(depth):
            cross += products[members[k], one]
        totals[depth + 1, width] = totals[depth, width] + means[one]
        totals[depth + 1, width + 1] = totals[depth, width + 1] + 2.0 * cross + products[one, one]
        if depth + 1 < size:
            for k in range(width):
                totals[depth + 1, k] = totals[depth, k] + ratios[one, k]
            members[depth + 1] = one
            depth += 1
            continue
        looked += 1
        bound = least_deviation(totals[size, width], totals[size, width + 1], size, least, most)
        if values[-1, 0] == 0.0 and bound > values[-1, 1] + 1e-9:
            continue
        for k in range(width):
            totals[size, k] = totals[depth, k] + ratios[one, k]
        lowest, highest = common_span(members, size, spans)
        miss, deviation, _ = score_set(totals[size, :width], size, low, high, start, lowest, highest)
        place = values.shape[0]
        while place > 0 and better(miss, deviation, values[place - 1, 0], values[place - 1, 1]):
            place -= 1
        if place < values.shape[0]:
            for k in range(values.shape[0] - 1, place, -1):
                values[k, 0] = values[k - 1, 0]
                values[k, 1] = values[k - 1, 1]
                for i in range(size):
                    best[k, i] = best[k - 1, i]
            values[place, 0] = miss
            values[place, 1] = deviation
            for i in range(size):
                best[place, i] = members[i]
    return looked


@kernel
def descend(ratios, products, means, members, known, stations, events, spans, limits, bounds, total, trial):
    """Complete a set record by record, then exchange one record while that makes it better; returns the work
    done, 0 where no record completes it. The best exchange of each sweep is made.

    ratios, products, means : as of `every_set`
    members : the set, its first `known` places given; the rest is filled
    known : places given
    stations, events, spans, limits, bounds : as of `every_set`
    total, trial : room, shape (columns of the ratios,)
    """
    n, width = ratios.shape
    size = members.size
    low, high, start, least, most = bounds
    first = 0.0
    second = 0.0
    for k in range(known):
        first += means[members[k]]
        for i in range(known):
            second += products[members[k], members[i]]
    for count in range(known, size):
        chosen = -1
        lowest = math.inf
        for one in range(n):
            if allowed_beside(members, count, one, stations, events, spans, limits[0], limits[1]):
                cross = products[one, one]
                for k in range(count):
                    cross += 2.0 * products[members[k], one]
                value = least_deviation(first + means[one], second + cross, count + 1, least, most)
                if value < lowest:
                    chosen, lowest = one, value
        if chosen < 0:
            return 0
        first += means[chosen]
        second += products[chosen, chosen]
        for k in range(count):
            second += 2.0 * products[members[k], chosen]
        members[count] = chosen
    add_up(members, ratios, total)
    lowest, highest = common_span(members, size, spans)
    miss, deviation, _ = score_set(total, size, low, high, start, lowest, highest)
    looked = 0
    while True:
        out, into = -1, -1
        for place in range(size):
            gone = members[place]
            members[place] = members[size - 1]
            lowest, highest = common_span(members, size - 1, spans)
            for one in range(n):
                bottom, top = max(lowest, spans[one, 0]), min(highest, spans[one, 1])
                if one == gone or bottom > top:
                    continue
                if not within_limits(members, size - 1, one, stations, events, limits[0], limits[1]):
                    continue
                looked += EXCHANGE * size
                if miss == 0.0:
                    cross = products[one, one] - products[gone, gone]
                    for k in range(size - 1):
                        cross += 2.0 * (products[members[k], one] - products[members[k], gone])
                    bound = least_deviation(first + means[one] - means[gone], second + cross, size, least, most)
                    if bound > deviation + 1e-9:
                        continue
                looked += SPECTRUM
                for k in range(width):
                    trial[k] = total[k] - ratios[gone, k] + ratios[one, k]
                new_miss, new_deviation, _ = score_set(trial, size, low, high, start, bottom, top)
                if better(new_miss, new_deviation, miss, deviation - 1e-12 * (new_miss == miss)):
                    miss, deviation, out, into = new_miss, new_deviation, place, one
            members[size - 1] = members[place]
            members[place] = gone
        if out < 0:
            return looked
        gone = members[out]
        members[out] = into
        first = 0.0
        second = 0.0
        add_up(members, ratios, total)
        for k in range(size):
            first += means[members[k]]
            for i in range(size):
                second += products[members[k], members[i]]


@kernel
def score_sets(ratios, sets, spans, bounds, total, values):
    """Miss, deviation and factor of each of many sets, shape (sets, 3); sets : records of each, rising, shape
    (sets, size); spans : as of `every_set`; total : room, shape (columns of the ratios,)"""
    low, high, start, _, _ = bounds
    for row in range(sets.shape[0]):
        add_up(sets[row], ratios, total)
        least, most = common_span(sets[row], sets.shape[1], spans)
        values[row, 0], values[row, 1], values[row, 2] = score_set(total, sets.shape[1], low, high, start, least, most)


def own_factors(means: np.ndarray, pga: np.ndarray, factors: tuple[float, float]) -> np.ndarray:
    """Least and most factor with which each record keeps `OWN_FIT` and `OWN_PGA`, shape (records, 2); least above most
    where it has none. means : of the ratios of each record over the periods; pga : over that of the target; factors :
    allowed"""
    least = np.maximum(OWN_FIT[0] / means, OWN_PGA / pga)
    return np.column_stack([np.maximum(factors[0], least), np.minimum(factors[1], OWN_FIT[1] / means)])


def nearest_sets(
    ratios: np.ndarray,
    size: int,
    stations: np.ndarray,
    events: np.ndarray,
    limits: tuple[int, int],
    bounds: Bounds,
    told: Callable[[float], bool] = lambda share: False,
) -> tuple[list[RankedSet], bool]:
    """(the nearest sets, the best first; whether every combination was looked at).

    ratios : spectrum over target of each record, its PGA over that of the target last, shape (records, periods + 1)
    size : records of a set
    stations, events : number of the station and of the event of each record
    limits : most records of a station and of an event
    bounds : what is asked of the mean, and the factors, with which each record of a set keeps `OWN_FIT` and `OWN_PGA`
    told : called with the share done; true ends the search with what was found

    The same ratios in the same order give the same sets. Up to `MAX_SETS` combinations every one is looked at. Beyond,
    sets begun by records drawn from a fixed seed, two or the most of the best set so far, are completed by the record
    that brings the mean nearest, and improved by the best exchange of one record until there is none (iterated local
    search, many starts); then every exchange of the best ones is looked at once more, for the sets beside them.
    """
    n, width = ratios.shape
    ratios = np.ascontiguousarray(ratios, dtype=np.float64)
    inner = ratios[:, : width - 1]
    products, means = inner @ inner.T / (width - 1), inner.mean(axis=1)
    spans = own_factors(means, ratios[:, -1], bounds.factors)
    asked = (bounds.low, bounds.high, bounds.start, *bounds.factors)
    if n < size:
        return [], True
    if math.comb(n, size) <= MAX_SETS:
        best, values = np.zeros((MAX_SETS_LISTED, size), np.int64), np.full((MAX_SETS_LISTED, 2), np.inf)
        members, totals = np.full(size, -1), np.zeros((size + 1, width + 2))
        every_set(ratios, products, means, stations, events, spans, limits, asked, members, totals, best, values)
        return _ordered(ratios, best[np.isfinite(values[:, 0])], spans, asked), True
    random, nearest, work = np.random.Generator(np.random.PCG64(1)), set(), 0
    total, trial, values = np.empty(width), np.empty(width), np.empty((1, 3))
    best, last, unimproved = (), (math.inf, math.inf), 0
    for start in range(MAX_STARTS):
        if work > MAX_WORK or told(max(start / MAX_STARTS, work / MAX_WORK)):
            break
        kept = random.choice(best, size - RECORDS_REDRAWN, replace=False) if best and size > RECORDS_REDRAWN else ()
        members, known = np.full(size, -1), 0
        for one in (*kept, *random.choice(n, 1 if best else min(2, size - 1), replace=False)):
            if allowed_beside(members, known, one, stations, events, spans, *limits):
                members[known], known = one, known + 1
        done = descend(ratios, products, means, members, known, stations, events, spans, limits, asked, total, trial)
        work += done
        if done:
            members.sort()
            nearest.add(tuple(members.tolist()))
            score_sets(ratios, members[None, :], spans, asked, total, values)
            reached, unimproved = (float(values[0, 0]), float(values[0, 1])), unimproved + 1
            if reached < last:
                best, last, unimproved = tuple(members.tolist()), reached, 0
        if unimproved == UNIMPROVED:
            best, last, unimproved = (), (math.inf, math.inf), 0
    ends = _ordered(ratios, np.array(sorted(nearest), np.int64).reshape(-1, size), spans, asked)
    for one in ends:
        nearest |= set(_beside(one.members, n, stations, events, spans, limits))
    return _ordered(ratios, np.array(sorted(nearest), np.int64).reshape(-1, size), spans, asked), False


def _beside(members, n: int, stations, events, spans, limits):
    """Sets that differ from a set in one record, within the limits."""
    for place in range(len(members)):
        rest = np.array([one for k, one in enumerate(members) if k != place], np.int64)
        per_station = np.count_nonzero(stations[rest][:, None] == stations[None, :], axis=0)
        per_event = np.count_nonzero(events[rest][:, None] == events[None, :], axis=0)
        fits = (per_station < limits[0]) & (per_event < limits[1])
        fits &= np.maximum(spans[:, 0], spans[rest, 0].max()) <= np.minimum(spans[:, 1], spans[rest, 1].min())
        fits[rest] = False
        for one in np.flatnonzero(fits):
            yield tuple(sorted([*rest.tolist(), int(one)]))


def _ordered(ratios: np.ndarray, sets: np.ndarray, spans: np.ndarray, asked) -> list[RankedSet]:
    """Judge some sets and return the best, the best first; of two alike that of the lower indices."""
    values = np.empty((len(sets), 3))
    score_sets(ratios, sets, spans, asked, np.empty(ratios.shape[1]), values)
    order = np.lexsort((*sets.T[::-1], values[:, 1], values[:, 0]))[:MAX_SETS_LISTED]
    return [
        RankedSet(tuple(sets[k].tolist()), float(values[k, 2]), float(values[k, 0]), float(values[k, 1])) for k in order
    ]
