"""Single samples against the same sample cut into 64: peaks next to a turn, terms no bound may forget."""

import math

import numpy as np
import pytest

from core.jit.decorators import kernel
from core.rocking import taylor
from core.rocking.events import BlockState
from core.rocking.taylor_series import wall_constants
from core.wall.rocking_model import RockingModel


@kernel
def samples(model, grounds, dt, order, state):
    """State after the samples between these ground accelerations [m/s2]."""
    constants = wall_constants(model, dt)
    for i in range(grounds.size - 1):
        time = 0.0
        while time < 1.0:
            _, time, _, state = taylor.through_sample(
                grounds[i], grounds[i + 1], dt, model, constants, order, 1e9, state, time
            )
    return state


def through(model, grounds, dt, order, phi, speed, peak):
    """(phi, speed, peak, impacts) after these samples."""
    zone = 2 if model.plateau_end == 0.0 or phi >= model.plateau_end else 1
    start = BlockState(1.0, phi, speed, True, zone, peak, 0, 0)
    state = samples(model, grounds, dt, order, start)
    return state[1], state[2], state[5], state[6]


def whole_and_cut(model, first, second, dt, order, phi, speed, peak=0.0):
    whole = through(model, np.array([first, second]), dt, order, phi, speed, peak)
    cut = through(model, np.linspace(first, second, 65), dt / 64.0, 8, phi, speed, peak)
    return whole, cut


@pytest.mark.shows("mechanics.double_crossing")
@pytest.mark.parametrize(
    "alpha, p2, dt, first, second, phi, speed",
    [
        # turns down and up again within the sample, the first speed inward
        (0.02703, 1.116, 0.0230246, 2.40346, -1.17715, 1.76107e-5, -0.00119388),
        # no curvature at its end, where Newton for the interior_maximum starts
        (0.02168, 1.99, 0.0431843, 0.0543336, 0.271313, 0.00753425, 4.23105e-5),
    ],
)
def test_that_a_peak_next_to_a_turn_is_found(alpha, p2, dt, first, second, phi, speed):
    model = RockingModel(alpha, p2, 0.0, 0.9, 0.0, 0.0, 0.0)
    whole, cut = whole_and_cut(model, first, second, dt, 8, phi, speed, phi)
    assert whole[3] == cut[3]
    assert whole[2] == pytest.approx(cut[2], abs=1e-11 * alpha)


@pytest.mark.parametrize("order", [6, 8])
@pytest.mark.parametrize("one_sided", [0.0, 1.0])
@pytest.mark.parametrize("dt", [0.005, 0.02, 0.1])
@pytest.mark.parametrize(
    "first, second, share", [(2.0, -6.0, 0.0), (1.2, -0.9, 0.0), (1.01, -50.0, 0.0), (1.5, -8.0, 0.2)]
)
def test_that_a_peak_of_the_first_step_from_a_standing_start_is_found(first, second, share, dt, one_sided, order):
    """Lifted by the ground at its beginning, or let go leaning, and down again within the sample."""
    alpha = 0.12
    model = RockingModel(alpha, 2.1, one_sided, 0.9, 0.0, 0.0, 0.0)
    lift = 9.80665 * math.tan(alpha)
    whole, cut = whole_and_cut(model, first * lift, second * lift, dt, order, share * alpha, 0.0, share * alpha)
    assert whole[2] > 0.0
    assert whole[2] == pytest.approx(cut[2], rel=1e-9)


def test_that_order_six_sees_the_products_of_a_strong_ground():
    """What it leaves out comes from v1 v2 and v2^2, not from its last terms alone."""
    alpha, p2 = 0.179145, 7.83972
    model = RockingModel(alpha, p2, 0.0, 0.9, 0.0, 3.88e-4, 0.065076)
    whole, cut = whole_and_cut(model, 27.69996, -17.75823, 0.00258121, 6, 0.17856723, 0.022322867)
    assert abs(whole[0] - cut[0]) <= 1e-15
    assert abs(whole[1] - cut[1]) <= 1e-13 * math.sqrt(p2) * alpha


def test_that_chatter_is_that_of_the_sample_cut(make_model):
    """Small bounces while the ground takes the weight away: their series must know where it ends."""
    rng = np.random.default_rng(8)
    for _ in range(300):
        model = make_model(
            alpha_deg=rng.uniform(1.0, 12.0), one_sided=bool(rng.integers(2)), ratio=rng.uniform(0.3, 0.97)
        )
        threshold = 9.80665 * math.tan(model.slenderness)
        first = threshold * rng.uniform(0.5, 0.999)
        second = threshold * rng.uniform(-0.5, 0.999)
        dt = 10.0 ** rng.uniform(-3.0, -1.7)
        speed = 10.0 ** rng.uniform(-4.5, -2.5) * math.sqrt(model.p2) * model.slenderness
        whole, cut = whole_and_cut(model, first, second, dt, 8, 0.0, speed)
        scale = speed * dt
        assert abs(whole[0] - cut[0]) <= 1e-9 * scale
