"""A train that overturned in 1906 at Point Reyes Station: Anooshehpoor, Heaton, Shi and Brune (1999), BSSA 89(4).

Their block of 3.76 x 0.914 m needs full sines of 0.35, 0.50 and 1.05 g at 1, 1.5 and 2 Hz. With no loss at impacts the
exact history needs what they print but for a tenth, with Housner's it needs more: the printed values are a test of the
motion, and not of the restitution.
"""

import math

import numpy as np
import pytest

from core.rocking.history import scan
from core.rocking.methods import METHODS
from core.rocking.outcome import STABLE
from core.units import G
from core.wall.block import Block
from core.wall.moment_rotation import RIGID
from core.wall.restitution import restitution
from core.wall.rocking_model import rocking_model

BLOCK = Block.rectangle(3.76, math.atan2(0.914, 3.76))
PRINTED = {1.0: 0.35, 1.5: 0.50, 2.0: 1.05}


def needed(frequency: float, ratio: float) -> float:
    """Least amplitude [g] of a full sine that overturns the block. ratio : of velocities at an impact"""
    time = np.arange(0.0, 15.0, 0.002)
    sine = np.where(time < 1.0 / frequency, G * np.sin(2.0 * np.pi * frequency * time), 0.0)
    scales = np.arange(0.25, 1.8, 0.005)
    outcomes, peaks = np.zeros(scales.size, np.int64), np.zeros(scales.size)
    model = rocking_model(BLOCK, False, restitution(BLOCK, "user", ratio), RIGID)
    scan(METHODS["taylor"], sine, 0.002, scales, model, outcomes, peaks)
    return float(scales[np.flatnonzero(outcomes != STABLE)[0]])


@pytest.mark.parametrize("frequency", PRINTED)
def test_that_the_sines_that_overturn_the_train_are_those_printed(frequency):
    assert needed(frequency, 1.0) == pytest.approx(PRINTED[frequency], rel=0.10)


def test_that_the_loss_of_impacts_is_what_the_faster_sines_are_held_by():
    """At 1 Hz it matters little, at 2 Hz by a third."""
    housner = restitution(BLOCK, "housner").ratio_at_rest
    assert housner == pytest.approx(0.9163, abs=1e-4)
    assert needed(1.0, housner) == pytest.approx(needed(1.0, 1.0), rel=0.05)
    assert needed(2.0, housner) == pytest.approx(1.32, abs=0.01)
