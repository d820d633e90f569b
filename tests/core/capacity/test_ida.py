"""The search (resources/docs/physics.md, section 11) against its definitions applied by brute force."""

import math
from dataclasses import replace

import numpy as np
import pytest

from core.capacity import bisection, ida
from core.capacity.bisection import BRACKET, bisect_brackets
from core.capacity.fragility import fragility
from core.capacity.ida import (
    TRILINEAR_FLOOR,
    Run,
    Search,
    collapse_count,
    first_with_share,
    incremental_dynamic_analyses,
    incremental_dynamic_analysis,
)
from core.errors import Cancelled
from core.rocking.history import integrate_history
from core.rocking.methods import METHODS
from core.rocking.outcome import COLLAPSED, IMPACT_LIMIT, STABLE
from core.units import G
from core.wall.block import Block
from core.wall.moment_rotation import LAWS
from core.wall.restitution import restitution
from core.wall.rocking_model import rocking_model
from tests.core.capacity.searches import TAYLOR, scripted, search_of


def brute(ground, model, q, sign=1):
    """Outcome and peak ratio at one q, one analysis at a time."""
    scale = sign * q * G * math.tan(model.slenderness) / np.abs(ground).max()
    found = integrate_history(ground, 0.01, scale, model)
    return found.outcome, found.peak / model.slenderness


@pytest.mark.shows("search.definition")
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
    assert grid[-1] * 1.02 > 2.0 * found.q
    for name, fraction in (("q_slv", 0.40), ("q_slc", 0.60)):
        q = getattr(found, name)
        reached = [outcome == COLLAPSED or peak >= fraction for outcome, peak in known]
        index = reached.index(True)
        assert grid[index - 1] < q <= grid[index]
        outcome, peak = brute(ground, model, q)
        assert outcome == COLLAPSED or peak >= fraction
        outcome, peak = brute(ground, model, q / (1 + 2e-4))
        assert index == 0 or (outcome == STABLE and peak < fraction) or q / 1.0002 < grid[index - 1]
    near = [outcome == COLLAPSED or peak >= 0.36 for outcome, peak in known].index(True)
    assert found.q_slv_low == found.q_start * 1.02 ** (found.first_index + near - 1) < found.q_slv
    half = round(0.10 / math.log(1.02))
    damaged = np.array([outcome == COLLAPSED or peak >= 0.40 for outcome, peak in known])
    for q, flags in ((found.q_robust, collapsed), (found.q_slv_robust, damaged)):
        shares = [sum(flags[max(0, k - half) : k + half + 1]) / (2 * half + 1) for k in range(len(grid) - half)]
        assert q == grid[next(k for k, share in enumerate(shares) if share >= 0.16)]
    survivors = np.nonzero(~collapsed)[0]
    assert found.q_last_survival == grid[survivors[-1]]
    if survivors[-1] > first:
        share = (~collapsed[first : survivors[-1] + 1]).mean()
        assert found.survived_fraction == pytest.approx(share)
    inside = sum(sum(1 for q in grid if a <= q <= b) for a, b in found.survival_windows)
    assert inside == sum(survivors > first)


@pytest.mark.shows("kinematic.q_slv")
@pytest.mark.parametrize("law", ["rigid", "doherty"])
def test_that_no_window_raises_the_q_slv_that_a_check_takes(ground, make_model, law):
    for alpha in (5.0, 9.0):
        model = make_model(alpha_deg=alpha, law=law)
        usual = search_of(ground, model, Search(q_step=0.02))
        for window in (0.02, 0.05):
            narrow = search_of(ground, model, Search(q_step=0.02, robust_window=window))
            assert narrow.q_slv_robust == usual.q_slv_robust and narrow.q_slv_low == usual.q_slv_low
        wide = search_of(ground, model, Search(q_step=0.02, robust_window=0.3))
        assert wide.q_slv_robust is not None


def test_that_the_map_does_not_depend_on_how_many_points_run_at_once(ground, make_model, monkeypatch):
    for search in (Search(), Search(q_step=0.05), Search(q_step=0.02, map_span=1.0)):
        whole = search_of(ground, make_model(), search)
        with monkeypatch.context() as patched:
            patched.setattr(ida, "CHUNK", 5)
            parts = search_of(ground, make_model(), search)
        assert replace(parts, analyses=0) == replace(whole, analyses=0)


def test_that_searches_side_by_side_are_those_of_each_run_alone(ground, make_model):
    """Records of two lengths and time steps, both signs, one too strong to be taken, under three laws."""
    weak, short = 0.5 * ground, ground[: ground.size // 2]
    runs = [
        Run(motion, dt, float(np.abs(motion).max()), sign)
        for motion, dt in ((ground, 0.01), (short, 0.02), (weak, 0.01), (1e9 * ground, 0.01))
        for sign in (1, -1)
    ]
    runs[-2:] = [replace(run, pga=1e-3) for run in runs[-2:]]
    for model in (make_model(), make_model(one_sided=True, ratio=0.5), make_model(law="doherty")):
        found = incremental_dynamic_analyses(runs, model, TAYLOR, Search(), lambda: False)
        alone = [
            incremental_dynamic_analysis(run.ground, run.dt, run.pga, run.sign, model, TAYLOR, Search()) for run in runs
        ]
        assert found == alone
        assert [one.status for one in found] == 6 * ["collapse_found"] + 2 * ["bad_input"]


def test_that_midpoints_at_once_give_the_bracket_of_one_after_the_other():
    rng = np.random.default_rng(4)
    brackets, functions, expected = [], [], []
    for _ in range(200):
        low = rng.uniform(0.5, 5.0)
        high = low * (1.0 + 10.0 ** rng.uniform(-5.0, -0.5))
        edges = np.sort(rng.uniform(low, high, 5))

        def fails(q, edges=edges, high=high):
            return np.searchsorted(edges, q) % 2 == 1 or q == high

        a, b = low, high
        while b / a - 1.0 > BRACKET:
            middle = 0.5 * (a + b)
            a, b = (a, middle) if fails(middle) else (middle, b)
        brackets.append((low, high))
        functions.append(fails)
        expected.append((a, b))

    def flags(points):
        return [
            (np.array([f(x) for x in q], bool), np.zeros(q.size, bool)) for f, q in zip(functions, points, strict=True)
        ]

    assert bisect_brackets(brackets, flags) == expected


def test_that_an_unknown_midpoint_ends_its_own_bisection_only():
    def flags(points):
        return [(q > 1.02, unknown(q)) for q, unknown in zip(points, (np.isnan, any_of), strict=True)]

    def any_of(q):
        return q > 0.0

    first, second = bisect_brackets([(1.0, 1.1), (1.0, 1.1)], flags)
    assert first[0] <= 1.02 <= first[1] <= first[0] * (1.0 + BRACKET)
    assert second is None


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
        incremental_dynamic_analysis(ground, 0.01, 1.0, 1, make_model(), TAYLOR, Search(), cancelled)
    assert len(calls) == 4


@pytest.mark.shows("search.definition")
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
    share = collapse_count(flags, 2)
    assert share.tolist() == [2, 2, 2, 3, 2, 1]


@pytest.mark.shows("search.unknown")
def test_that_an_unknown_outcome_before_collapse_leaves_no_number(make_model, monkeypatch):
    scripted(monkeypatch, lambda q: IMPACT_LIMIT if 1.5 < q < 1.52 else int(q > 2.0))
    found = search_of(np.ones(5), make_model())
    assert found.status == "impact_limit"
    assert found.q is None and found.q_slv is None and found.q_robust is None
    assert found.impact_limited >= 2
    assert fragility([found], Search()) is None


def test_that_an_unknown_midpoint_of_the_bisection_leaves_no_number(make_model, monkeypatch):
    edge = 1.005**140
    scripted(monkeypatch, lambda q: IMPACT_LIMIT if edge * 1.001 < q < edge * 1.004 else int(q > edge * 1.0001))
    assert search_of(np.ones(5), make_model()).status == "impact_limit"


@pytest.mark.parametrize("at", ["collapse", "SLV"])
def test_that_an_unknown_midpoint_takes_the_number_it_belongs_to(make_model, monkeypatch, at):
    """Without q nothing is known; without the first peak of SLV q still is."""
    slv, collapse = 1.005**100, 1.005**160
    edge = collapse if at == "collapse" else slv

    def scan(method, grounds, which, scales, model, outcomes, peaks):
        q = np.abs(scales) / (G * math.tan(model.slenderness))
        outcomes[:] = np.where(q > 1.0001 * collapse, COLLAPSED, STABLE)
        outcomes[(q > 1.001 * edge) & (q < 1.004 * edge)] = IMPACT_LIMIT
        peaks[:] = np.where(q > 1.0001 * slv, 0.5, 0.1) * model.slenderness
        return np.zeros(scales.size, np.int64)

    monkeypatch.setattr(ida, "scan_records", scan)
    found = search_of(np.ones(5), make_model())
    assert found.q_slv is None
    if at == "collapse":
        assert (found.status, found.q, found.q_slc) == ("impact_limit", None, None)
    else:
        assert found.status == "collapse_found" and found.q == pytest.approx(1.0001 * collapse, rel=1e-4)
        assert found.q_slc == found.q and found.q_robust is not None


@pytest.mark.shows("search.unknown")
def test_that_unknown_points_above_collapse_are_counted_and_left_out(make_model, monkeypatch):
    def outcome(q):
        if 2.0 < q < 2.2:
            return COLLAPSED
        if 2.2 <= q < 2.3:
            return IMPACT_LIMIT
        return STABLE if q < 2.5 else COLLAPSED

    scripted(monkeypatch, outcome)
    found = search_of(np.ones(5), make_model())
    grid = [1.005**k for k in range(len(found.outcomes))]
    known = [q for q in grid if 2.0 < q < 2.2 or 2.3 <= q < 2.5]
    assert found.status == "collapse_found"
    assert found.impact_limited == sum(2.2 <= q < 2.3 for q in grid)
    share = sum(q >= 2.3 for q in known) / len(known)
    assert found.survived_fraction == pytest.approx(share, abs=0.01)
    assert len(found.survival_windows) == 1


@pytest.mark.parametrize("span", [1.5, 3.0])
def test_that_the_map_goes_as_far_as_asked(make_model, monkeypatch, span):
    scripted(monkeypatch, lambda q: int(q > 2.0))
    found = search_of(np.ones(5), make_model(), Search(map_span=span))
    last = 1.005 ** (len(found.outcomes) - 1)
    assert last <= span * found.q < last * 1.005


@pytest.mark.shows("mechanics.impact_limit")
def test_that_a_real_wall_can_reach_the_impact_limit(make_model):
    """Elastic impacts pressed down by a steady ground: hops without end within a sample."""
    model = make_model(30.7, 1.747, one_sided=True, ratio=1.0)
    ground = np.full(3, -19.56)
    found = integrate_history(ground, 0.00986, 1.0, model, start=(0.0, 2.62e-6))
    assert found.outcome == IMPACT_LIMIT


def test_that_a_share_met_exactly_is_met():
    """16 % of 25 points are 4: `q_robust` and zeta_16 are where the share is reached, not passed."""
    flags = np.zeros(60, bool)
    flags[40:44] = True
    assert first_with_share(flags, 12, 0.16) == 31  # 31 + 12 = 43: the fourth point comes into the window
    assert first_with_share(flags[:43], 12, 0.16) is None  # only whole windows count
    assert first_with_share(np.ones(5, bool), 12, 0.16) is None


def test_that_a_wall_may_fall_just_above_its_threshold():
    """A push that lasts: whatever exceeds a_RM overturns, so q is within a step of 1."""
    block = Block.rectangle(4.0, math.radians(6.0))
    model = rocking_model(block, True, restitution(block, "one_sided_theoretical"), LAWS["rigid"])
    ground = np.concatenate([np.full(3000, 1.0), np.zeros(10)])
    found = incremental_dynamic_analysis(ground, 0.01, 1.0, 1, model, METHODS["taylor"], Search())
    assert 1.0 < found.q < 1.01 and found.outcomes[0] == "0"


def test_that_only_a_midpoint_a_bisection_needs_must_be_known():
    def failures(unknown_at):
        return lambda points: [(points[0] > 1.7, np.abs(points[0] - unknown_at) < 1e-9)]

    assert bisect_brackets([(1.0, 2.0)], failures(1.5)) == [None]
    assert bisect_brackets([(1.0, 2.0)], failures(1.625)) == [None]
    ((low, high),) = bisect_brackets([(1.0, 2.0)], failures(1.25))  # 1.5 holds: 1.25 is not asked for
    assert low <= 1.7 <= high and high / low - 1.0 <= 1e-4


@pytest.mark.parametrize(
    ("fails", "unknown", "found"),
    [
        # edges 1, 2, 3, 4, 5: their midpoints 2, 3, 4 are asked from the middle one
        ([False, True, True], [False, False, False], (2.0, 3.0)),
        ([False, False, False], [False, False, False], (4.0, 5.0)),
        ([True, True, True], [False, False, False], (1.0, 2.0)),
        ([False, True, True], [False, True, False], None),
        ([False, True, True], [True, False, False], None),
        ([False, True, True], [False, False, True], (2.0, 3.0)),  # never asked for
        ([False, False, True], [True, False, False], (3.0, 4.0)),
    ],
)
def test_that_a_bisection_stops_only_at_a_midpoint_it_asks_for(fails, unknown, found):
    assert bisection._narrowed(np.arange(1.0, 6.0), np.array(fails), np.array(unknown)) == found


def test_that_a_failure_below_the_lowest_q_of_a_trilinear_search_is_said(make_model, monkeypatch):
    """First failures from 0.012 on: what is given is an upper limit, with a bracket from 0."""
    scripted(monkeypatch, lambda q: int(q > 0.012))
    model = make_model(law="doherty")
    found = search_of(np.ones(5), model)
    assert found.below_floor and found.bracket[0] == 0.0
    assert TRILINEAR_FLOOR <= found.q <= 1.005 * TRILINEAR_FLOOR
    scripted(monkeypatch, lambda q: int(q > 0.06))
    assert not search_of(np.ones(5), model).below_floor


@pytest.mark.shows("search.q_slv_low")
@pytest.mark.parametrize("seed", [0, 2])
def test_that_copies_of_a_record_as_alike_as_1e_9_share_the_lower_end_of_q_slv(ground, make_model, seed):
    """Between two copies q_slv jumps somewhere: bisection finds where, to 1e-9 of PGA, and q_slv_low stays."""
    model = make_model(alpha_deg=8.0, height=4.0)
    noise = np.random.default_rng(seed).uniform(-1.0, 1.0, ground.size) * np.abs(ground).max()

    def searched(share: float):
        return search_of(ground + share * noise, model, Search(map_span=1.0))

    low, high = 0.0, 1e-3
    first, second = searched(low), searched(high)
    while high - low > 1e-9:
        middle = 0.5 * (low + high)
        between = searched(middle)
        if abs(between.q_slv - first.q_slv) > abs(second.q_slv - between.q_slv):
            high, second = middle, between
        else:
            low, first = middle, between
    assert abs(first.q_slv / second.q_slv - 1.0) > 0.03
    assert first.q_slv_low == second.q_slv_low < min(first.q_slv, second.q_slv)
