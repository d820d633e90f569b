"""The search of PHYSICS section 5, against its definitions applied by brute force."""

import math

import numpy as np
import pytest

from core.errors import Cancelled
from core.ida import (
    Search,
    collapse_share,
    fragility,
    incremental_dynamic_analysis,
)  # fmt: skip
from core.rocking import COLLAPSED, METHODS, STABLE, history
from core.units import G

TAYLOR = METHODS["taylor"]


@pytest.fixture(scope="module")
def ground(reference):
    return reference("standard")[0]


def search_of(ground, model, search=Search(), sign=1):
    pga = float(np.abs(ground).max())
    return incremental_dynamic_analysis(ground, 0.01, pga, sign, model, TAYLOR, search)


def brute(ground, model, q, sign=1):
    """Outcome and peak ratio at one q, one analysis at a time."""
    scale = sign * q * G * math.tan(model.slenderness) / np.abs(ground).max()
    found = history(ground, 0.01, scale, model)
    return found.outcome, found.peak / model.slenderness


@pytest.mark.parametrize("one_sided", [False, True])
@pytest.mark.parametrize("law", ["rigid", "doherty"])
def test_that_every_number_is_its_definition(ground, make_model, one_sided, law):
    model = make_model(one_sided=one_sided, law=law)
    search = Search(q_step=0.02)
    found = search_of(ground, model, search)
    assert found.status == "collapse_found"
    grid = [found.q_start * 1.02 ** (found.first_index + k) for k in range(len(found.outcomes))]
    known = [brute(ground, model, q) for q in grid]
    assert found.outcomes == "".join(str(outcome) for outcome, _ in known)
    collapsed = np.array([outcome == COLLAPSED for outcome, _ in known])
    first = int(np.argmax(collapsed))
    low, high = found.bracket
    assert found.q == high
    assert grid[first - 1] <= low < high <= grid[first]
    assert high / low - 1 <= 1e-4
    assert brute(ground, model, low)[0] == STABLE
    assert brute(ground, model, high)[0] == COLLAPSED
    assert grid[-1] * 1.02 > 2.0 * found.q or grid[-1] > 2.0 * found.q
    for name, fraction in (("q_slv", 0.40), ("q_slc", 0.60)):
        q = getattr(found, name)
        reached = [outcome == COLLAPSED or peak >= fraction for outcome, peak in known]
        index = reached.index(True)
        assert grid[index - 1] < q <= grid[index]
        outcome, peak = brute(ground, model, q)
        assert outcome == COLLAPSED or peak >= fraction
        outcome, peak = brute(ground, model, q / (1 + 2e-4))
        assert index == 0 or (outcome == STABLE and peak < fraction) or q / 1.0002 < grid[index - 1]
    half = round(0.10 / math.log(1.02))
    shares = [
        sum(collapsed[max(0, k - half) : k + half + 1]) / (2 * half + 1)
        for k in range(len(grid) - half)
    ]
    index = next(k for k, share in enumerate(shares) if share >= 0.16)
    assert found.q_robust == grid[index]
    survivors = np.nonzero(~collapsed)[0]
    assert found.q_last_survival == grid[survivors[-1]]
    if survivors[-1] > first:
        share = (~collapsed[first : survivors[-1] + 1]).mean()
        assert found.survived_fraction == pytest.approx(share)
    inside = sum(sum(1 for q in grid if a <= q <= b) for a, b in found.survival_windows)
    assert inside == sum(survivors > first)


def test_that_q_up_to_one_is_rest_and_costs_no_analysis(ground, make_model):
    found = search_of(ground, make_model())
    assert found.outcomes[0] == str(STABLE)
    assert found.first_index == 0 and found.q_start == 1.0
    assert brute(ground, make_model(), 1.0) == (STABLE, 0.0)


def test_that_the_sign_of_the_record_matters_only_one_sided(ground, make_model):
    assert search_of(ground, make_model(), sign=1) == search_of(ground, make_model(), sign=-1)
    one = make_model(one_sided=True)
    assert search_of(ground, one, sign=1).q != search_of(ground, one, sign=-1).q
    assert search_of(ground, one, sign=-1) == search_of(-ground, one, sign=1)


def test_that_a_wall_that_stands_has_no_number(make_model):
    pulse = np.zeros(200)
    pulse[3] = 1.0
    found = search_of(pulse, make_model(height=50.0), Search(q_limit=3.0))
    assert found.status == "no_collapse_found"
    assert found.q is None and found.bracket is None and found.q_robust is None
    assert set(found.outcomes) == {str(STABLE)}


def test_that_q_scales_with_nothing_but_the_shape_of_the_record(ground, make_model):
    # C multiplies the record: a record half as strong needs twice C, q is the same to rounding
    model = make_model()
    there, half = search_of(ground, model), search_of(0.5 * ground, model)
    assert there == half


def test_that_a_search_can_be_cancelled_between_chunks(ground, make_model):
    calls = []

    def cancelled():
        calls.append(1)
        return len(calls) > 3

    with pytest.raises(Cancelled):
        incremental_dynamic_analysis(
            ground, 0.01, 1.0, 1, make_model(), TAYLOR, Search(), cancelled
        )
    assert len(calls) == 4


def test_that_a_trilinear_map_goes_down_until_a_whole_window_survives(make_model):
    """A square wave of 2 s pumps a small trilinear wall over at a quarter of a_RM, below 0.5."""
    ground = np.where((np.arange(2001) // 100) % 2 == 0, 1.0, -1.0)
    found = search_of(ground, make_model(height=0.6, law="al_shawa"))
    assert found.status == "collapse_found"
    assert found.q < found.q_start
    half = Search().half_window
    assert set(found.outcomes[: 2 * half + 1]) == {str(STABLE)}
    assert found.first_index < -half


def test_that_the_share_counts_missing_points_as_surviving():
    flags = np.array([False, True, True, False, False, True])
    share = collapse_share(flags, 2)
    assert share.tolist() == [2 / 5, 2 / 5, 2 / 5, 3 / 5, 2 / 5, 1 / 5]


def test_that_fragility_is_the_mean_share_of_the_runs(ground, make_model):
    search = Search()
    runs = [search_of(ground, make_model(height=h), search) for h in (5.0, 7.0, 9.0)]
    found = fragility(runs, search)
    assert found.n == 3
    half = search.half_window

    def share(run, k):
        count = 0
        for j in range(k - half, k + half + 1):
            place = j - run.first_index
            if place >= len(run.outcomes) or (place >= 0 and run.outcomes[place] == "1"):
                count += 1
        return count / (2 * half + 1)

    for level, q in ((0.05, found.q_05), (0.16, found.q_16), (0.50, found.q_50)):
        k = round(math.log(q) / math.log1p(0.005))
        assert q == pytest.approx(1.005**k)
        assert np.mean([share(run, k) for run in runs]) >= level
        assert np.mean([share(run, k - 1) for run in runs]) < level
    assert fragility([], search) is None
