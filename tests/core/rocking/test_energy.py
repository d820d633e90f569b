"""The energy of a history over its barrier."""

import itertools
import math

import numpy as np
import pytest

from core.rocking.energy import energy_ratios
from core.rocking.history import integrate_history
from core.rocking.methods import AUTO
from core.wall.block import Block
from core.wall.moment_rotation import LAWS
from core.wall.restitution import restitution
from core.wall.rocking_model import rocking_model

G = 9.80665


def model_of(law: str, elastic: float = 1.0):
    block = Block.rectangle(4.0, math.radians(7.0))
    return rocking_model(block, False, restitution(block, "user", elastic), LAWS[law])


@pytest.mark.parametrize("law", ["rigid", "doherty"])
def test_that_free_motion_keeps_its_energy_and_an_impact_takes_its_share(law):
    model = model_of(law, 0.9)
    pulse = np.concatenate(
        [(1.6 if law == "rigid" else 1.15) * math.tan(math.radians(7.0)) * G * np.ones(30), np.zeros(400)]
    )
    moved = integrate_history(pulse, 0.01, 1.0, model, AUTO)
    ratios = energy_ratios(moved, model)
    times = np.arange(ratios.size) * 0.01
    hits = [time for time in moved.impact_time if time > 0.35]
    assert len(hits) >= 2
    between = [ratios[(times > first + 0.011) & (times < last - 0.011)] for first, last in itertools.pairwise(hits)]
    for part in between:
        assert np.ptp(part) < 1e-11
    assert between[1].mean() / between[0].mean() == pytest.approx(0.81, rel=1e-9)


def test_that_it_is_one_at_the_collapse_rotation_at_rest():
    model = model_of("rigid")
    moved = integrate_history(np.zeros(3), 0.01, 1.0, model, AUTO)
    there = np.array([0.0, model.collapse_rotation, -model.collapse_rotation])
    changed = type(moved)(
        there,
        np.zeros(3),
        *[
            getattr(moved, name)
            for name in ("impact_time", "impact_velocity", "outcome", "peak", "clamped", "residual")
        ],
    )
    assert energy_ratios(changed, model) == pytest.approx([0.0, 1.0, 1.0], abs=1e-14)
