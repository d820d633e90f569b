"""Multipliers in lockstep are single analyses, bit for bit."""

import math

import numpy as np
import pytest

from core.rocking import METHODS, STABLE, history, lanes, scan, scan_taylor
from core.rocking.model import RockingModel
from core.units import G


def both(ground, dt, scales, model, name="taylor"):
    outcomes, peaks = np.zeros(scales.size, np.int64), np.zeros(scales.size)
    one_outcomes, one_peaks = outcomes.copy(), peaks.copy()
    method = METHODS[name]
    together = scan(method, ground, dt, scales, model, outcomes, peaks)
    alone = scan_taylor(method.order, ground, dt, scales, model, one_outcomes, one_peaks)
    return (outcomes, peaks, together), (one_outcomes, one_peaks, alone)


def same(together, alone) -> bool:
    return (
        np.array_equal(together[0], alone[0])
        and np.array_equal(together[1], alone[1])
        and np.array_equal(together[2], alone[2])
    )


@pytest.mark.parametrize("name", ["standard", "hard"])
@pytest.mark.parametrize("one_sided", [False, True])
@pytest.mark.parametrize("law", ["rigid", "doherty"])
@pytest.mark.parametrize("size", [1, 7, 8, 32, 33, 70])
def test_that_lanes_equal_single_analyses_on_the_references(
    reference, make_model, name, one_sided, law, size
):
    ground = reference(name)[0]
    scales = np.linspace(0.5, 6.0, size) * (-1.0) ** np.arange(size)
    for restitution in ("housner", "one_sided_experimental") if one_sided else ("housner",):
        model = make_model(one_sided=one_sided, model=restitution, law=law)
        for method in ("taylor", "taylor_6"):
            together, alone = both(ground, 0.01, scales, model, method)
            assert same(together, alone)
    assert len(set(alone[0])) == 2 or size < 7


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
        together, alone = both(ground, dt, scales, model, rng.choice(["taylor", "taylor_6"]))
        assert same(together, alone)
        seen |= set(together[0])
    assert seen >= {0, 1}


def test_that_a_pass_takes_no_more_lanes_than_its_width(reference, make_model, monkeypatch):
    sizes = []
    real = lanes.scan

    def watched(ground, dt, scales, *rest):
        sizes.append(scales.size)
        return real(ground, dt, scales, *rest)

    monkeypatch.setattr(lanes, "scan", watched)
    both(reference("standard")[0], 0.01, np.linspace(1, 2, 37), make_model())
    assert sizes == [32, 5]


def test_that_what_is_settled_is_what_integrating_on_would_say(reference, make_model):
    """Analyses that stop early give outcome and peak of the whole history, bit for bit."""
    ground = np.concatenate([reference("standard")[0], 0.02 * reference("hard")[0]])
    for one_sided in (False, True):
        for law in ("rigid", "doherty"):
            model = make_model(one_sided=one_sided, law=law)
            scales = np.linspace(0.4, 2.5, 40)
            outcomes, peaks = np.zeros(40, np.int64), np.zeros(40)
            scan(METHODS["taylor"], ground, 0.01, scales, model, outcomes, peaks)
            for k, scale in enumerate(scales):
                whole = history(ground, 0.01, scale, model)
                assert outcomes[k] == whole.outcome
                if whole.outcome == STABLE:
                    assert peaks[k] == whole.peak
                else:  # given up where no ground of the record can bring it back
                    assert model.slenderness < peaks[k] <= whole.peak
