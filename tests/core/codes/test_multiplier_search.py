"""The search for zeta: where a rule that is not monotone fails at half of the multipliers around."""

import math

import numpy as np
import pytest

from core.codes.multiplier_search import MAX_MULTIPLIER, STEP, WINDOW, search_zeta


def rule(*fails):
    """Failures within these intervals of the multiplier, and the points asked for."""
    asked = []

    def failures(multipliers):
        asked.extend(multipliers.tolist())
        flags = np.zeros(multipliers.size, bool)
        for low, high in fails:
            flags |= (multipliers >= low) & (multipliers < high)
        return flags, np.zeros(multipliers.size, bool)

    return failures, asked


@pytest.mark.parametrize("limit", [0.3123, 0.9871, 1.0, 1.5557, 7.77])
@pytest.mark.parametrize("target", [1.0, 0.8])
def test_that_a_sharp_limit_is_found_without_bias(limit, target):
    found = search_zeta(rule((limit, math.inf))[0], 0.11, target)
    assert found.half == pytest.approx(limit, rel=1e-4) and found.half >= limit
    assert found.first == found.half
    # 16 % of a window of +-10 % lie beyond the limit where its middle is 6.8 % below, in ln
    assert found.sixteen == pytest.approx(limit * math.exp(-0.68 * WINDOW), rel=1.1 * STEP)
    assert found.spread[0] <= found.half <= found.spread[1]
    assert found.spread[1] / found.spread[0] == pytest.approx(1.0 + 0.2 * WINDOW, abs=3.0 * STEP)
    assert found.holds_at_target == (target < limit)


def test_that_the_share_around_the_target_is_that_of_its_points():
    found = search_zeta(rule((1.02, math.inf))[0], 0.2, 1.0)
    points = 1.0025 ** np.arange(-40, 41)
    assert found.share_at_target == (points >= 1.02).mean()
    assert search_zeta(rule((3.0, math.inf))[0], 0.2, 1.0).share_at_target == 0.0
    assert search_zeta(rule((0.4, math.inf))[0], 0.2, 1.0).share_at_target == 1.0


def test_that_a_narrow_failure_moves_the_first_failure_and_not_zeta():
    found = search_zeta(rule((0.6, 0.615), (1.1, math.inf))[0], 0.2, 1.0)
    assert found.first == pytest.approx(0.6, rel=STEP)
    # another value than that of the limit alone only by the step
    assert found.half == pytest.approx(1.1, rel=STEP)
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
        return flags | (np.abs(multipliers - 1.15) < 0.01), np.abs(multipliers - 1.15) < 0.01

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


def test_that_the_search_begins_where_the_wall_begins_to_move_whatever_the_target():
    for target in (0.5, 1.0, 1.3, 1.9):
        assert search_zeta(rule((0.55, math.inf))[0], 0.5, target).half == pytest.approx(
            0.55, rel=1e-4
        )
