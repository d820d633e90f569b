"""The search for zeta: where a rule that is not monotone fails at half of the multipliers around."""

import math

import numpy as np
import pytest

from core.codes.multiplier_search import FAILURE_WINDOW, MAX_MULTIPLIER, MULTIPLIER_STEP, Precision, search_zeta


def rule(*fails):
    """Failures within these intervals of the multiplier, and the points asked for."""
    asked = []

    def failures(multipliers):
        asked.extend(multipliers.tolist())
        flags = np.zeros(multipliers.size, bool)
        for low, high in fails:
            flags |= (multipliers >= low) & (multipliers < high)
        return flags, np.zeros(multipliers.size, bool), np.ones(multipliers.size, bool)

    return failures, asked


@pytest.mark.parametrize("limit", [0.3123, 0.9871, 1.0, 1.5557, 7.77])
@pytest.mark.parametrize("target", [1.0, 0.8])
def test_that_a_sharp_limit_is_found_without_bias(limit, target):
    found = search_zeta(rule((limit, math.inf))[0], 0.11, target)
    assert found.half == pytest.approx(limit, rel=1e-4) and found.half >= limit
    assert found.first == found.half
    # 16 % of a window of +-10 % lie beyond the limit where its middle is 6.8 % below, in ln
    assert found.sixteen == pytest.approx(limit * math.exp(-0.68 * FAILURE_WINDOW), rel=1.1 * MULTIPLIER_STEP)
    assert found.spread[0] <= found.half <= found.spread[1]
    assert found.spread[1] / found.spread[0] == pytest.approx(1.0 + 0.2 * FAILURE_WINDOW, abs=3.0 * MULTIPLIER_STEP)
    assert found.holds_at_target == (target < limit)


def test_that_the_share_around_the_target_is_that_of_its_points():
    found = search_zeta(rule((1.02, math.inf))[0], 0.2, 1.0)
    points = 1.0025 ** np.arange(-40, 41)
    assert found.share_at_target == (points >= 1.02).mean()
    assert search_zeta(rule((3.0, math.inf))[0], 0.2, 1.0).share_at_target == 0.0
    assert search_zeta(rule((0.4, math.inf))[0], 0.2, 1.0).share_at_target == 1.0


def test_that_a_narrow_failure_moves_the_first_failure_and_not_zeta():
    found = search_zeta(rule((0.6, 0.615), (1.1, math.inf))[0], 0.2, 1.0)
    assert found.first == pytest.approx(0.6, rel=MULTIPLIER_STEP)
    # another value than that of the limit alone only by the step
    assert found.half == pytest.approx(1.1, rel=MULTIPLIER_STEP)
    assert 0.6 < found.first < 0.63 < found.sixteen < 1.1


def test_that_a_wall_that_survives_beyond_is_not_called_verified_for_it():
    """Failures from 0.8 to 1.0, survival beyond: half of the window around 0.9 fails."""
    found = search_zeta(rule((0.8, 1.0), (1.4, math.inf))[0], 0.2, 1.0)
    assert found.half < 0.85 and found.holds_at_target


def test_that_a_rule_that_never_fails_is_as_far_as_was_looked():
    found = search_zeta(rule()[0], 0.2, 1.0)
    assert found.half == found.sixteen == found.first == MAX_MULTIPLIER and found.holds_at_target


def test_that_an_outcome_without_number_below_gives_none():
    def failures(multipliers):
        flags = multipliers >= 1.2
        unknown = np.abs(multipliers - 1.15) < 0.01
        return flags | unknown, unknown, np.ones(multipliers.size, bool)

    found = search_zeta(failures, 0.2, 1.0)
    assert found.half is None and found.spread is None and found.holds_at_target


def test_that_the_target_is_looked_at_itself():
    for target in (0.8, 1.0, 1.3):
        failures, asked = rule((0.5, math.inf))
        search_zeta(failures, 0.1, target)
        assert target in asked


def test_that_a_failure_at_the_target_itself_is_seen_beside_a_zeta_beyond():
    found = search_zeta(rule((0.995, 1.005), (1.3, math.inf))[0], 0.2, 1.0)
    assert found.half > 1.25 and not found.holds_at_target


@pytest.mark.shows("dynamic.zeta")
@pytest.mark.parametrize("seeds", [range(20), pytest.param(range(200), marks=pytest.mark.long)], ids=len)
@pytest.mark.parametrize("every", [1, 2, 4, 8])
def test_that_what_is_found_is_that_of_all_points_wherever_the_walk_starts(every, seeds):
    """Rules that fail at scattered points, against the definition on every point of the grid."""
    half = round(FAILURE_WINDOW / (every * math.log1p(MULTIPLIER_STEP)))
    for seed in seeds:
        chance = np.random.default_rng(seed)
        share = np.clip(np.linspace(-chance.uniform(0.0, 3.0), 1.2, 1200 // every), 0.0, 1.0) ** 3
        flags = np.append(chance.random(share.size) < share, np.ones(2000, bool))
        flags[:50] = False

        def failures(multipliers, flags=flags):
            k = np.rint(np.log(multipliers / 0.8) / math.log1p(MULTIPLIER_STEP) / every).astype(int) + 100
            fails = np.where(k < 0, False, flags[np.clip(k, 0, flags.size - 1)])
            return fails, np.zeros(k.size, bool), np.ones(k.size, bool)

        def lowest(part, flags=flags):
            counts = np.convolve(flags, np.ones(2 * half + 1), "same")[: 1700 - half]
            return int(np.argmax(counts >= part * (2 * half + 1)))

        def multiplier(k):
            return 0.8 * (1.0 + MULTIPLIER_STEP) ** (every * (k - 100))

        first, middle = int(np.argmax(flags)), lowest(0.5)
        rests = [0.5 * multiplier(0), multiplier(17), multiplier(first - 1), 0.999 * multiplier(first)]
        found = [search_zeta(failures, rest, 0.8, Precision(every)) for rest in rests]
        assert len(set(found)) == 1
        assert found[0].sixteen == pytest.approx(multiplier(lowest(0.16)), rel=1e-12)
        if first == middle:  # a sharp limit is located within its step
            assert multiplier(first - 1) < found[0].first == found[0].half <= multiplier(first)
            continue
        # below the first failure found a whole window has none; one alone, farther below, is not looked for
        seen = round(math.log(found[0].first / multiplier(0)) / (every * math.log1p(MULTIPLIER_STEP)))
        assert flags[seen] and not flags[max(0, seen - 2 * half - 1) : seen].any()
        assert every < 4 or seen == first
        assert found[0].half == pytest.approx(multiplier(middle - 0.5), rel=1e-12)


@pytest.mark.shows("dynamic.grid")
def test_that_points_are_left_out_only_where_no_run_rocks():
    """Between points 4 % apart at which every run hardly rocks nothing is analysed; beside one that rocks those 1 %
    apart are, and all of the window below the first failure."""
    asked = []

    def failures(multipliers):
        asked.extend(multipliers.tolist())
        return multipliers >= 1.0, np.zeros(multipliers.size, bool), multipliers >= 0.7

    search_zeta(failures, 0.2, 1.0)
    quiet = sorted(m for m in asked if m < 0.65)
    assert np.diff(np.log(quiet)) == pytest.approx(16 * math.log1p(MULTIPLIER_STEP), rel=1e-9)
    rocks = sorted(m for m in asked if 0.7 <= m < 0.8)
    assert np.diff(np.log(rocks)) == pytest.approx(4 * math.log1p(MULTIPLIER_STEP), rel=1e-9)
    below = sorted(m for m in asked if 0.82 <= m < 0.996)
    assert np.diff(np.log(below)) == pytest.approx(math.log1p(MULTIPLIER_STEP), rel=1e-9)


def test_that_the_search_begins_where_the_wall_begins_to_move_whatever_the_target():
    for target in (0.5, 1.0, 1.3, 1.9):
        assert search_zeta(rule((0.55, math.inf))[0], 0.5, target).half == pytest.approx(0.55, rel=1e-4)


@pytest.mark.parametrize("unknown", [True, False])
def test_that_the_search_ends_where_every_multiplier_fails_however_small(unknown):
    """A comparison method without a number at any multiplier was followed down for ever."""
    asked = []

    def failures(multipliers):
        asked.append(multipliers.min())
        always = np.ones(multipliers.size, bool)
        return always, always & unknown, always

    found = search_zeta(failures, 0.05, 1.0)
    assert (found.half, found.first, found.spread) == (None, None, None) and min(asked) > 1e-6
