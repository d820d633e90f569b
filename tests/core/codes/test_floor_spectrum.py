"""What a floor spectrum is at its ends and at its modes; worked values are solved cases (core/lab/solved/floors.py)."""

import numpy as np
import pytest

from core.codes.floor_spectrum import FloorSpectrum, estimated_period, first_mode
from core.codes.spectrum_codes import en1998
from core.ground.floor_motion import Mode
from core.units import G

TARGET = en1998(0.26 * G, 1, "B")
PERIOD = 1.5 * estimated_period(9.0)


def floor(z: float) -> FloorSpectrum:
    return FloorSpectrum(TARGET, first_mode(3, 9.0, z, PERIOD, 0.10))


def test_that_the_spectrum_starts_at_the_acceleration_of_the_floor():
    modes = (Mode(0.4, 0.1, 1.2), Mode(0.13, 0.05, -0.3))
    at = FloorSpectrum(TARGET, modes)
    assert at.acceleration([0.0], 0.05)[0] == pytest.approx(at.a_z, rel=1e-12)


def test_that_beyond_the_first_period_the_floor_is_not_below_the_ground():
    """Of the mode alone S_eZ(1.6959 s, 8 %) is 0.19911 g."""
    at = floor(6.0)
    alone = float(at._of_mode(at.modes[0], np.array([1.6959]), 0.08)[0])
    assert alone / G == pytest.approx(0.19911, abs=6e-6)
    assert at.acceleration([1.6959], 0.08) == pytest.approx(TARGET.acceleration([1.6959], 0.08))


@pytest.mark.shows("kinematic.floor_spectrum")
def test_that_the_spectrum_has_a_plateau_at_the_mode_not_a_dip():
    """xi_k in A is a fraction: in per cent A would be below 1."""
    at = floor(6.0)
    assert at.acceleration([PERIOD], 0.05)[0] > 2.0 * at.acceleration([0.0], 0.05)[0]
