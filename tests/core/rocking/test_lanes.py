"""Multipliers in lockstep are single analyses, bit for bit."""

import math

import numpy as np
import pytest

from core.capacity.ida import Search, incremental_dynamic_analysis
from core.ground.records import read
from core.rocking.grounds import Grounds
from core.rocking.history import integrate_history, scan_multipliers, scan_records
from core.rocking.lane_state import MAX_LANES
from core.rocking.methods import METHODS
from core.rocking.outcome import BAD_INPUT, COLLAPSED, IMPACT_LIMIT
from core.units import G
from core.wall.bars import Bar
from core.wall.loads import UNLOADED, RestoringMoment
from core.wall.rocking_model import OtherSide, RockingModel
from tests.core.rocking.lanes_and_histories import assert_lanes_are_histories


@pytest.mark.shows("mechanics.lanes")
@pytest.mark.parametrize("name", ["standard", "hard"])
@pytest.mark.parametrize("one_sided", [False, True])
@pytest.mark.parametrize("law", ["rigid", "doherty"])
@pytest.mark.parametrize("size", [1, 7, 8, 32, 33, 70])
def test_that_lanes_equal_single_analyses_on_the_references(reference, make_model, name, one_sided, law, size):
    ground = reference(name)[0]
    scales = np.linspace(0.5, 6.0, size) * (-1.0) ** np.arange(size)
    for restitution in ("housner", "one_sided_experimental") if one_sided else ("housner",):
        model = make_model(one_sided=one_sided, model=restitution, law=law)
        for method in ("taylor", "taylor_6"):
            outcomes = assert_lanes_are_histories(ground, 0.01, scales, model, method)
    assert len(set(outcomes)) == 2 or size < 7


@pytest.mark.shows("mechanics.lanes")
def test_that_lanes_equal_single_analyses_on_random_walls_and_grounds():
    rng = np.random.default_rng(11)
    seen = set()
    for _ in range(150):
        alpha = math.radians(rng.uniform(0.5, 40.0))
        p2 = 10.0 ** rng.uniform(-0.5, 2.0)
        one_sided = float(rng.integers(2))
        drop = rng.choice([0.0, 5.0])
        law = rng.choice([0.0, alpha]) * np.array([0.05, 0.3])
        model = RockingModel(alpha, p2, one_sided, rng.uniform(0.0, 1.0), drop, *law)
        dt = 10.0 ** rng.uniform(-3.5, -1.3)
        ground = G * math.tan(alpha) * rng.normal(size=300)
        ground[100:130] = 0.0
        scales = rng.uniform(0.2, 8.0, 16)
        name = rng.choice(["taylor", "taylor_6"])
        seen |= set(assert_lanes_are_histories(ground, dt, scales, model, name))
    assert seen >= {0, 1}


def unlike_hinges(rng: np.random.Generator) -> RockingModel:
    """A body of another alpha, p, velocity ratio and load about each hinge."""
    alphas, sides = rng.uniform(0.01, 0.5, 2), [UNLOADED, UNLOADED]
    for k in range(2):
        if rng.uniform() < 0.5:
            sine = 1.0 + rng.uniform(0.0, 1.5)
            cosine = sine * math.tan(alphas.min()) * rng.uniform(-0.5, 0.8)
            sides[k] = RestoringMoment(sine, cosine, math.hypot(sine, cosine), math.atan2(cosine, sine))
    other = OtherSide.of(float(alphas[1]), 10.0 ** rng.uniform(-0.5, 2.0), rng.uniform())
    lean = min(alpha + side.lean for alpha, side in zip(alphas, sides, strict=True)) - alphas[0]
    values = float(alphas[0]), 10.0 ** rng.uniform(-0.5, 2.0), 0.0, rng.uniform(), 0.0, 0.0, 0.0
    return RockingModel(*values, *sides, lean, min(side.amplitude for side in sides), (), other)


@pytest.mark.shows("mechanics.lanes")
@pytest.mark.parametrize("seeds", [range(40), pytest.param(range(40, 1000), marks=pytest.mark.long)], ids=str)
def test_that_lanes_equal_single_analyses_of_bodies_of_unlike_hinges(seeds):
    seen = set()
    for seed in seeds:
        rng = np.random.default_rng(seed)
        model, dt = unlike_hinges(rng), 10.0 ** rng.uniform(-3.0, -1.3)
        walk = np.cumsum(rng.normal(size=300))
        ground = model.threshold * (rng.normal(size=300) if rng.uniform() < 0.5 else walk / np.abs(walk).max())
        ground[100:130] = 0.0
        scales = rng.uniform(0.2, 8.0, 24) * rng.choice([-1.0, 1.0], 24)
        seen |= set(assert_lanes_are_histories(ground, dt, scales, model, rng.choice(["taylor", "rk4"])))
    assert seen >= {0, 1}


def loaded(rng: np.random.Generator, slenderness: float) -> RestoringMoment:
    """A wall as it is, or with a load that leaves it standing."""
    if rng.uniform() < 0.6:
        return UNLOADED
    sine = 1.0 + rng.uniform(0.0, 1.0)
    cosine = sine * math.tan(slenderness) * rng.uniform(-0.5, 0.8)
    return RestoringMoment(sine, cosine, math.hypot(sine, cosine), math.atan2(cosine, sine))


def held_by_bars(rng: np.random.Generator) -> RockingModel:
    """A wall of the rigid law, one- or two-sided, with none to three bars: slack, neither, or prestressed; of all
    strengths and stiffnesses, some of which break."""
    alpha, p2, one_sided = rng.uniform(0.02, 0.25), 10.0 ** rng.uniform(0.0, 1.3), rng.uniform() < 0.6
    sides = [loaded(rng, alpha) for _ in range(1 if one_sided else 2)]
    weaker = min(sides, key=lambda side: side.lean)
    bars = []
    for _ in range(rng.integers(0, 4)):
        at_yield = alpha * 10.0 ** rng.uniform(-2.5, -0.3)
        stiffness = alpha * 10.0 ** rng.uniform(-1.3, 0.7) / at_yield
        slack = at_yield * rng.choice([0.0, rng.uniform(0.0, 3.0), -rng.uniform(0.0, 1.0)])
        stands = at_yield * rng.choice([1.0, 10.0 ** rng.uniform(0.0, 2.0), 1e3])
        breaks = max(stands + min(slack, 0.0), slack + at_yield)
        bars.append(Bar(1.0, stiffness, at_yield, slack, breaks))
    drop = rng.choice([0.0, 0.0, 0.0, 5.0])
    values = alpha, p2, float(one_sided), rng.choice([rng.uniform(), 1.0]), drop, 0.0, 0.0
    return RockingModel(*values, sides[0], sides[-1], weaker.lean, weaker.amplitude, tuple(bars))


def shaken(rng: np.random.Generator, model: RockingModel, motions: list[np.ndarray]) -> np.ndarray:
    """A ground [m/s2] that lifts a wall: noise, a walk, a ground near what lifts it, or a piece of one of the motions,
    with a quiet piece."""
    kind, samples = rng.integers(4), 300
    ground = rng.normal(size=samples)
    if kind == 1:
        ground = np.cumsum(ground) / 5.0
    elif kind == 2:
        ground = np.repeat(rng.uniform(0.9, 1.05, samples // 10), 10) * rng.choice([-1.0, 1.0])
    elif kind == 3:
        motion = motions[rng.integers(len(motions))]
        first = rng.integers(max(1, motion.size - 600))
        ground = motion[first : first + 600] / np.abs(motion).max() * 3.0
    ground[100:130] = 0.0
    return np.ascontiguousarray(model.threshold * ground)


@pytest.mark.shows("mechanics.lanes")
@pytest.mark.parametrize("seeds", [range(25), pytest.param(range(25, 3000), marks=pytest.mark.long)], ids=str)
def test_that_lanes_equal_single_analyses_of_walls_held_by_bars(reference, seeds):
    """Bars that are taut, yield, unload, slacken and break in lanes of their own clocks."""
    motions = [reference(name)[0] for name in ("standard", "hard")]
    seen, yielded, broke = set(), 0, 0
    for seed in seeds:
        rng = np.random.default_rng(seed)
        model, dt = held_by_bars(rng), 10.0 ** rng.uniform(-3.0, -1.5)
        ground = shaken(rng, model, motions)
        scales = rng.uniform(0.3, 8.0, 24) * rng.choice([-1.0, 1.0], 24)
        seen |= set(assert_lanes_are_histories(ground, dt, scales, model))
        residual = integrate_history(ground, dt, scales[0], model).residual
        broke += int(np.isinf(residual).any())
        kept = residual[np.isfinite(residual).all(axis=1)]
        yielded += int((kept > kept[:, :1]).any())
    assert seen >= {0, 1} and min(yielded, broke) >= 0.1 * len(seeds)


@pytest.mark.shows("mechanics.lanes")
@pytest.mark.parametrize("seeds", [range(5), pytest.param(range(5, 300), marks=pytest.mark.long)], ids=str)
def test_that_lanes_equal_single_analyses_of_walls_held_by_bars_under_real_records(shelf, seeds):
    names = "A-ELC180.AT2", "ALH360.AT2", "CPM000.AT2", "IELC180.AT2", "NIS090.AT2"
    records = [read(shelf / "PEER_AT2" / name) for name in names]
    for seed in seeds:
        rng = np.random.default_rng(seed)
        model, record = held_by_bars(rng), records[rng.integers(len(records))]
        ground = np.ascontiguousarray(model.threshold / record.pga * record.acceleration)
        assert_lanes_are_histories(ground, record.time_step, rng.uniform(1.0, 6.0, 16) * rng.choice([-1, 1], 16), model)


@pytest.mark.parametrize("height, dt", [(0.4, 0.02), (1.0, 0.05), (0.3, 0.1)])
def test_that_lanes_take_long_steps_in_the_parts_of_single_analyses(reference, make_model, height, dt):
    """Where the series has not converged within a sample, by vector instructions down to a sixteenth of it."""
    ground = reference("standard")[0][::2]
    for law in ("rigid", "al_shawa"):
        for one_sided in (False, True):
            model = make_model(height=height, one_sided=one_sided, law=law)
            scales = np.linspace(0.2, 3.0, 64)
            for method in ("taylor", "taylor_6"):
                assert_lanes_are_histories(ground, dt, scales, model, method)


@pytest.mark.shows("mechanics.bad_input")
def test_that_a_ground_that_is_no_number_ends_at_once_with_its_code(make_model):
    """It hung `history` and `scan` for ever, where no signal reached them."""
    sound = 3.0 * np.sin(np.arange(300) * 0.1)
    for wrong in (np.nan, np.inf, -np.inf, 1e200):
        for place in (0, 150, 299):
            ground = sound.copy()
            ground[place] = wrong
            for one_sided, law in ((False, "rigid"), (True, "doherty")):
                model = make_model(one_sided=one_sided, law=law)
                for method in METHODS.values():
                    if method.name == "linearised" and law != "rigid":
                        continue
                    found = integrate_history(ground, 0.01, 1.0, model, method)
                    assert found.outcome == BAD_INPUT and found.rotation.size == 0
                    outcomes, peaks = np.zeros(3, np.int64), np.zeros(3)
                    scan_multipliers(method, ground, 0.01, np.array([0.5, -1.0, 2.0]), model, outcomes, peaks)
                    assert (outcomes == BAD_INPUT).all()
                    which, scales = np.array([0, 1, 1, 0]), np.array([1.0, 1.0, np.nan, 2.0])
                    both, some = Grounds.of([sound, ground], 0.01), np.zeros(4, np.int64)
                    scan_records(method, both, which, scales, model, some, np.zeros(4))
                    alone = np.zeros(2, np.int64)
                    scan_multipliers(method, sound, 0.01, scales[[0, 3]], model, alone, np.zeros(2))
                    assert some.tolist() == [alone[0], BAD_INPUT, BAD_INPUT, alone[1]]
    assert integrate_history(sound, 0.01, 1.0, model, start=(np.nan, 0.0)).outcome == BAD_INPUT
    assert integrate_history(sound, 0.01, np.inf, model).outcome == BAD_INPUT
    search = incremental_dynamic_analysis(ground, 0.01, 1.0, 1, model, METHODS["taylor"], Search())
    assert search.status == "bad_input" and search.q is None


@pytest.mark.shows("mechanics.impact_limit")
@pytest.mark.parametrize("walls", [15, pytest.param(40, marks=pytest.mark.long)])
def test_that_nearly_elastic_impacts_reach_their_limit_in_lanes_as_in_histories(walls):
    """A spike barely above a_RM lifts the wall, which then bounces 10 000 times within a sample."""
    rng = np.random.default_rng(1)
    seen = set()
    for _ in range(walls):
        alpha, p2 = math.radians(rng.uniform(2.0, 20.0)), 10.0 ** rng.uniform(0.0, 2.0)
        model = RockingModel(alpha, p2, float(rng.integers(2)), 0.9999, 0.0, 0.0, 0.0)
        ground = np.zeros(400)
        ground[3] = G * math.tan(alpha) * (1.0 + 10.0 ** rng.uniform(-6.0, -2.0))
        seen |= set(assert_lanes_are_histories(ground, 0.02, np.array([1.0, 1.02]), model, "taylor"))
    assert IMPACT_LIMIT in seen


@pytest.mark.shows("mechanics.lanes")
def test_that_lanes_of_several_records_run_together(reference, make_model):
    """More analyses than lanes, of records of different length, one after another in the same pass."""
    grounds = [reference("standard")[0], 1.4 * reference("hard")[0][:700], np.zeros(5)]
    model, rng = make_model(one_sided=True), np.random.default_rng(4)
    which = rng.integers(0, 3, 3 * MAX_LANES + 5)
    scales = rng.uniform(-4.0, 4.0, which.size)
    for name in ("taylor", "rk4"):
        found = np.zeros(which.size, np.int64), np.zeros(which.size)
        alone = np.zeros(which.size, np.int64), np.zeros(which.size)
        method = METHODS[name]
        scan_records(method, Grounds.of(grounds, 0.01), which, scales, model, *found)
        for k in range(which.size):
            one = slice(k, k + 1)
            scan_multipliers(method, grounds[which[k]], 0.01, scales[one], model, alone[0][one], alone[1][one])
        stable = found[0] != COLLAPSED
        assert np.array_equal(found[0], alone[0]) and 0 < stable.sum() < which.size
        assert np.array_equal(found[1][stable], alone[1][stable])
