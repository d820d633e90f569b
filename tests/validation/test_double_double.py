"""The double-double solver against 30 digits of another one, and for ties against small steps of Runge and Kutta."""

import itertools
import math

import mpmath as mp
import numpy as np
import pytest

from tests.benchmarks.noise_promise import KINDS, STIFF, TIES, case_of
from tests.validation import double_double as dd
from tests.validation import double_double_walls, high_precision
from tests.validation.test_tied_walls import drawn, of_both

SAMPLES = 40

CUT = 16
"""Parts of a sample in which a peak is looked for."""


def exact(value) -> mp.mpf:
    """The number a double-double stands for."""
    return mp.mpf(float(value[0])) + mp.mpf(float(value[1]))


@pytest.mark.parametrize("seed", range(20))
def test_that_sums_products_quotients_sines_and_cosines_have_thirty_digits(seed):
    rng = np.random.default_rng(seed)
    with mp.workdps(50):
        x, y = (mp.mpf(rng.uniform(-1.5, 1.5)) * (1 + mp.mpf(rng.uniform()) / 2**60) for _ in range(2))
        a, b = double_double_walls.split(x), double_double_walls.split(y)
        x, y = exact(a), exact(b)
        for found, expected in (
            (dd.add(a, b), x + y),
            (dd.mul(a, b), x * y),
            (dd.div(a, b), x / y),
            (dd.sine_or_cosine(a, 1), mp.sin(x)),
            (dd.sine_or_cosine(a, 0), mp.cos(x)),
        ):
            assert abs(exact(found) - expected) < mp.mpf(10) ** -30 * (1 + abs(expected))


SLOW = 4
"""Kind whose histories take mpmath the longest."""


@pytest.mark.parametrize(
    "seed",
    [
        pytest.param(kind + len(KINDS) * turn, marks=[pytest.mark.long] if turn or kind == SLOW else [])
        for turn in range(4)
        for kind in range(TIES)
    ],
)
def test_that_a_history_is_that_of_thirty_digits(seed):
    """Without ties, the samples cut into eighths where an elastic branch is stiff: the other's steps are whole."""
    model, dt, ground = case_of(seed)
    ground = ground[:SAMPLES]
    cut = 8 if seed % len(KINDS) == STIFF else 1
    kinks = (model.elastic_end, model.plateau_end) if model.plateau_end else None
    (a, c, *_), (b, d, *_) = model.restoring, model.mirrored
    with mp.workdps(30):
        fine = [mp.mpf(ground[0])]
        for first, last in itertools.pairwise(ground):
            fine += [first + (mp.mpf(last) - first) * (k + 1) / cut for k in range(cut)]
        truth, impacts = high_precision.history(
            fine,
            mp.mpf(dt) / cut,
            model.slenderness,
            model.p2,
            model.one_sided != 0.0,
            lambda speed: max(0, model.ratio_at_rest - model.ratio_drop * speed * speed),
            kinks,
            loads=((a, c), (b, d)),
        )
    found = double_double_walls.history(ground, dt, model)
    stands = found.rotation.size == ground.size
    truth = np.array([float(phi) for phi in truth[::cut]])[: found.rotation.size]
    inside = np.abs(truth) < 0.5 * math.pi
    # rounding to doubles; chatter amplifies what 30 digits leave
    assert np.abs(found.rotation - truth)[inside].max() <= 1e-15 * model.slenderness
    assert found.impacts == len(impacts) or not stands


@pytest.mark.parametrize("count", [pytest.param(count, marks=pytest.mark.long) for count in (8, 40)])
def test_that_a_tied_wall_turns_back_where_small_steps_say(count):
    """The residual elongations hold every turn of a yielding bar; the record is followed by four seconds of rest."""
    rng, yielded, broken = np.random.default_rng(17), 0, 0
    for _ in range(count):
        case = drawn(rng)
        ground, dt, _, _, bars, *_ = case
        model, _, (_, both, residuals, gone, _, fallen) = of_both(case, after=4.0)
        still = np.concatenate([ground, np.zeros(int(4.0 / dt) - 1)])
        still = np.interp(np.arange(CUT * (still.size - 1) + 1) / CUT, np.arange(still.size), still)
        found = double_double_walls.history(still, dt / CUT, model)
        assert (found.rotation.size < still.size) == fallen
        if fallen:
            continue
        assert list(found.broken) == list(gone)
        for k, bar in enumerate(bars):
            if not gone[k]:
                assert found.residual[k] * bar.height == pytest.approx(residuals[k], abs=1e-6 * bar.height)
                yielded += residuals[k] > bar.slack
        broken += int(gone.sum())
        assert 0.9 * both <= np.abs(found.rotation).max() <= both + 1e-6 * model.slenderness
    assert yielded > count // 8 and broken > count // 8
