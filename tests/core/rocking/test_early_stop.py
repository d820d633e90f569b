"""An analysis that ends early ends as it would have ended."""

import math

import numpy as np
import pytest

from core.rocking.early_stop import LOOKAHEAD, lookahead_bounds
from tests.core.rocking.lanes_and_histories import assert_lanes_are_histories


@pytest.mark.shows("mechanics.early_end")
def test_that_what_is_settled_or_chatters_to_rest_is_what_integrating_on_would_say(reference, make_model):
    """Analyses that stop early, and chatter not followed to its end, change no bit of what is reported."""
    ground = np.concatenate([reference("standard")[0], 0.02 * reference("hard")[0]])
    for one_sided in (False, True):
        for law in ("rigid", "doherty"):
            model = make_model(one_sided=one_sided, law=law)
            assert_lanes_are_histories(ground, 0.01, np.linspace(0.4, 2.5, 40), model)


@pytest.mark.shows("mechanics.early_end")
@pytest.mark.parametrize("ratio", [0.0, 0.3, 0.9, 0.99, 0.999, 1.0])
def test_that_chatter_under_a_nearly_lifting_ground_is_followed(make_model, ratio):
    """The ground stays a hair below what lifts the block, or goes beyond it, while the bounces die down."""
    rng = np.random.default_rng(5)
    for one_sided in (False, True):
        model = make_model(one_sided=one_sided, ratio=ratio)
        threshold = 9.80665 * math.tan(model.slenderness)
        for _ in range(12):
            ground = threshold * np.repeat(rng.uniform(0.95, 1.02, 20), rng.integers(1, 12, 20))
            ground[:4] = 1.3 * threshold
            ground *= rng.choice([-1.0, 1.0], ground.size) if rng.random() < 0.3 else 1.0
            assert_lanes_are_histories(ground, 0.01, np.linspace(0.9, 1.1, 16), model)


@pytest.mark.shows("mechanics.early_end")
def test_that_what_lies_ahead_is_what_a_plain_loop_finds():
    rng = np.random.default_rng(3)
    ground, dt = rng.normal(size=50), 0.02
    ahead = lookahead_bounds(ground, dt)
    still = np.concatenate([ground, np.zeros(LOOKAHEAD + 1)])
    for i in range(50):
        window = still[i : i + LOOKAHEAD]
        assert ahead[0, i] == window.max() and ahead[1, i] == window.min()
        assert ahead[2, i] == np.abs(np.diff(still[i : i + LOOKAHEAD + 1])).max()
        assert ahead[3, i] == pytest.approx(np.trapezoid(np.abs(still[i:]), dx=dt), rel=1e-12)
