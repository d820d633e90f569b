"""Sets of records by their mean spectrum: the search against every combination, and against spectra made for it."""

import itertools
import math

import numpy as np
import pytest

from core.ground import selection
from core.ground.selection import OWN_FIT, OWN_PGA, Bounds, nearest_sets

NTC = Bounds(0.9, 1.3, 0.0, (1.0, 1.0))
FREE = Bounds(0.9, 1.3, 0.0, (0.5, 2.0))
EN = Bounds(0.9, math.inf, 1.0, (0.5, 2.0))


def ratios_of(count: int, seed: int, periods: int = 60) -> np.ndarray:
    """Spectra over a target as those of records are: smooth in the logarithm of the period, PGA apart."""
    rng = np.random.default_rng(seed)
    knots = np.cumsum(rng.normal(0.0, 0.28, (count, 12)), axis=1)
    knots += rng.normal(0.0, 0.5, (count, 1)) - knots.mean(axis=1, keepdims=True)
    at = np.linspace(0.0, 11.0, periods)
    spectra = np.array([np.interp(at, np.arange(12), row) for row in knots])
    return np.exp(np.column_stack([spectra, rng.normal(0.0, 0.4, count)]))


def alone(count: int) -> np.ndarray:
    return np.arange(count)


def by_hand(ratios, members, bounds: Bounds) -> tuple[float, float]:
    """(miss, deviation) of a set, its factor by a fine grid where it has one; infinite where no factor keeps each
    record within OWN_FIT and its PGA at OWN_PGA."""
    own = ratios[list(members), :-1].mean(axis=1)
    mean = ratios[list(members)].mean(axis=0)
    inner, pga = mean[:-1], mean[-1]
    low = max(bounds.factors[0], OWN_FIT[0] / own.min(), OWN_PGA / ratios[list(members), -1].min())
    high = min(bounds.factors[1], OWN_FIT[1] / own.max())
    if low > high:
        return math.inf, math.inf
    edges = [low, high, bounds.low / inner.min(), bounds.high / inner.max(), inner.sum() / (inner**2).sum()]
    needed, allowed = max(bounds.low / inner.min(), bounds.start / pga), bounds.high / inner.max()
    edges += [needed, math.sqrt(needed * allowed) if allowed < math.inf else needed]
    best = (math.inf, math.inf)
    for factor in (*edges, *np.linspace(low, high, 41)):
        if low <= factor <= high:
            miss = max(needed / factor - 1.0, factor / allowed - 1.0, 0.0)
            best = min(best, (0.0 if miss < 1e-12 else miss, float(np.sqrt(np.mean((factor * inner - 1.0) ** 2)))))
    return best


@pytest.mark.shows("demand.select")
@pytest.mark.parametrize("bounds", [NTC, FREE, EN])
@pytest.mark.parametrize("strong", [0.0, 1.5])
@pytest.mark.parametrize("seed", range(4))
def test_that_every_set_of_a_small_folder_is_compared(seed, strong, bounds):
    """The ten best of all subsets that itertools makes, with the limits of station and event; also of records from a
    hundredth to many times the target."""
    ratios, stations, events = ratios_of(14, seed), np.arange(14) // 2, np.arange(14) // 5
    ratios *= np.exp(np.random.default_rng(seed).normal(0.0, strong, (14, 1)))
    found, every = nearest_sets(ratios, 5, stations, events, (1, 2), bounds)
    allowed = [
        members
        for members in itertools.combinations(range(14), 5)
        if np.bincount(stations[list(members)]).max() <= 1 and np.bincount(events[list(members)]).max() <= 2
    ]
    ranked = sorted((by_hand(ratios, members, bounds), members) for members in allowed)
    ranked = [one for one in ranked if one[0][0] < math.inf]
    assert every and len(found) == min(selection.MAX_SETS_LISTED, len(ranked))
    for one, ((miss, deviation), members) in zip(found, ranked, strict=False):
        assert one.members == members
        assert (one.miss, one.deviation) == (pytest.approx(miss, abs=1e-9), pytest.approx(deviation, abs=1e-9))


@pytest.mark.parametrize("bounds", [NTC, FREE, EN])
@pytest.mark.parametrize(("seed", "strong"), [*((seed, 0.0) for seed in range(8)), (0, 1.2), (1, 1.2), (2, 1.2)])
def test_that_the_search_finds_the_best_set_where_every_one_can_be_compared(seed, strong, bounds, monkeypatch):
    ratios, stations, events = ratios_of(22, seed), np.arange(22) // 2, np.arange(22) // 6
    ratios *= np.exp(np.random.default_rng(seed).normal(0.0, strong, (22, 1)))
    every = nearest_sets(ratios, 6, stations, events, (1, 2), bounds)[0]
    monkeypatch.setattr(selection, "MAX_SETS", 0)
    monkeypatch.setattr(selection, "MAX_STARTS", 1000)
    found, all_compared = nearest_sets(ratios, 6, stations, events, (1, 2), bounds)
    assert not all_compared and found[0] == every[0]


def test_that_the_limits_of_station_and_event_hold(monkeypatch):
    ratios, stations, events = ratios_of(60, 5), np.arange(60) // 2, np.arange(60) // 12
    monkeypatch.setattr(selection, "MAX_STARTS", 50)
    for limits in ((1, 2), (2, 7), (1, 1)):
        for one in nearest_sets(ratios, 5, stations, events, limits, FREE)[0]:
            members = list(one.members)
            assert len(set(members)) == 5
            assert np.bincount(stations[members]).max() <= limits[0]
            assert np.bincount(events[members]).max() <= limits[1]
    assert nearest_sets(ratios, 6, stations, events, (1, 1), FREE)[0] == []  # there are five events


@pytest.mark.parametrize("starts", [4000, pytest.param(selection.MAX_STARTS, marks=pytest.mark.long)])
def test_that_copies_of_the_target_are_found_with_their_factor(monkeypatch, starts):
    """Seven records whose mean is the target but for 0.8, among others."""
    monkeypatch.setattr(selection, "MAX_STARTS", starts)
    ratios, rng = ratios_of(40, 3), np.random.default_rng(1)
    pattern = rng.uniform(0.7, 1.3, (7, ratios.shape[1]))
    hidden = [2, 3, 11, 19, 20, 31, 39]
    ratios[hidden] = 0.8 * pattern / pattern.mean(axis=0)
    (best, *_), _ = nearest_sets(ratios, 7, alone(40), alone(40), (1, 1), FREE)
    assert list(best.members) == hidden
    assert best.factor == pytest.approx(1.25, rel=1e-9) and best.deviation == pytest.approx(0.0, abs=1e-7)


def test_that_a_set_that_cannot_be_met_is_the_nearest_with_what_it_misses():
    """All records half the target: no factor above 1.5 is allowed, so the mean ends a sixth below the bound."""
    ratios = np.full((6, 21), 0.5)
    bounds = Bounds(0.9, 1.3, 0.0, (0.5, 1.5))
    found, every = nearest_sets(ratios, 3, alone(6), alone(6), (1, 1), bounds)
    assert every and len(found) == selection.MAX_SETS_LISTED
    assert found[0].factor == 1.5 and found[0].miss == pytest.approx(0.9 / 0.75 - 1.0)


@pytest.mark.parametrize("bounds", [NTC, FREE])
@pytest.mark.parametrize("most_sets", [0, selection.MAX_SETS])
def test_that_silent_records_do_not_fill_a_set(bounds, most_sets, monkeypatch):
    """Four records of 7/4 of the target have with three silent ones the target as their mean."""
    monkeypatch.setattr(selection, "MAX_SETS", most_sets)
    monkeypatch.setattr(selection, "MAX_STARTS", 30)
    ratios = ratios_of(12, 1)
    ratios[:4] = 1.75
    ratios[4:7] = 1e-3
    found = nearest_sets(ratios, 7, alone(12), alone(12), (1, 1), bounds)[0]
    assert found and not any({4, 5, 6} & set(one.members) for one in found)
    assert nearest_sets(ratios[:7], 7, alone(7), alone(7), (1, 1), bounds)[0] == []


def test_that_a_record_whose_peak_would_not_count_is_in_no_set():
    ratios = np.ones((4, 11))
    ratios[2, -1] = 0.9 * OWN_PGA
    assert [one.members for one in nearest_sets(ratios, 3, alone(4), alone(4), (1, 1), NTC)[0]] == [(0, 1, 3)]


def test_that_records_of_one_factor_fit_with_that_factor():
    """0.12 and 6.0 times the target fit with the factors 2 and 0.5, and with no factor of both."""
    ratios = np.array([[0.12] * 10 + [1.0], [6.0] * 11, [1.0] * 11])
    pairs = nearest_sets(ratios, 2, alone(3), alone(3), (1, 1), FREE)[0]
    assert {pair.members for pair in pairs} == {(0, 2), (1, 2)}
    for pair in pairs:
        assert all(OWN_FIT[0] <= pair.factor * ratios[k, 0] <= OWN_FIT[1] for k in pair.members)


def test_that_the_mean_peak_counts_where_the_code_asks_for_it():
    ratios = np.ones((5, 31))
    ratios[:, -1] = 0.8
    assert nearest_sets(ratios, 3, alone(5), alone(5), (1, 1), NTC)[0][0].factor == 1.0
    assert nearest_sets(ratios, 3, alone(5), alone(5), (1, 1), EN)[0][0].factor == pytest.approx(1.25)


def test_that_a_search_ends_when_it_is_told_to(monkeypatch):
    ratios, seen = ratios_of(60, 5), []
    nearest_sets(ratios, 7, alone(60), alone(60), (1, 1), FREE, lambda share: bool(seen.append(share)) or len(seen) > 3)
    assert len(seen) == 4 and seen == sorted(seen) and seen[0] == 0.0
