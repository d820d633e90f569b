"""Fragility over the runs of a wall."""

import math

import numpy as np
import pytest

from core.capacity.fragility import fragility, fragility_curve
from core.capacity.ida import Search
from tests.core.capacity.searches import scripted, search_of


@pytest.mark.shows("search.fragility")
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


def test_that_half_of_an_even_number_of_runs_is_a_half(make_model, monkeypatch):
    """Seven of fourteen runs collapsed around a point are F = 0.50 there, not 0.4999..."""
    runs = []
    for k in range(14):
        scripted(monkeypatch, lambda q, top=2.0 if k < 7 else 4.0: int(q > top))
        runs.append(search_of(np.ones(5), make_model()))
    search = Search()
    found = fragility(runs, search)
    k = round(math.log(found.q_50) / math.log1p(0.005))
    first = next(j for j, digit in enumerate(runs[0].outcomes) if digit == "1")
    assert k == first + search.half_window


def test_that_the_curve_goes_on_half_a_window_beyond_both_ends_of_the_map(make_model, monkeypatch):
    """Below its map the wall stands, above it falls: at the first point no neighbour collapses, at the last all of
    those from it down to its own half window."""
    scripted(monkeypatch, lambda q: int(q > 2.0))
    search, run = Search(), search_of(np.ones(5), make_model())
    half = search.half_window
    q, count, n = fragility_curve([run], search)
    assert q.shape == count.shape and n == 1
    assert q[0] == pytest.approx(1.005 ** (run.first_index - half), rel=1e-12) and count[0] == 0
    assert q[-1] == pytest.approx(1.005 ** (run.first_index + len(run.outcomes) + half), rel=1e-12)
    assert count[-1] == half + 1
