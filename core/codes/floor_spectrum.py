"""Floor spectra of the Circolare 7/2019, C7.2.3 (C7.2.5 to C7.2.8, C7.2.10), and the modes of `[building]`.

The print has "xi_k in percentuale", which is true of C7.2.7; in A it is a fraction: with per cent the floor would have
a dip where it resonates. C8.7.1.2.1.5 cites C7.2.11, which is for frames, .7 cites C7.2.8: the latter is taken.
"""

import math
from dataclasses import dataclass

import numpy as np

from core.codes.target_spectrum import Target
from core.ground.floor_motion import Mode

PLATEAU_START, PLATEAU_END = 0.8, 1.1
"""a, b of C7.2.6: the plateau of a mode lies between a T_k and b T_k."""


def first_participation(storeys: int) -> float:
    """gamma_1 = 3 n / (2 n + 1), C7.2.10 [-]."""
    return 3.0 * storeys / (2.0 * storeys + 1.0)


def estimated_period(height: float) -> float:
    """T_1 = 0.05 H^0.75 [s], EN 1998-1 4.3.3.2.2(3) for masonry; height [m]."""
    return 0.05 * height**0.75


@dataclass(frozen=True)
class FloorSpectrum:
    """The floor at height z of a wall. ground : elastic spectrum of the demand; modes : of the building there."""

    ground: Target
    modes: tuple[Mode, ...]

    @property
    def first_period(self) -> float:
        """T_1 [s], the longest."""
        return max(mode.period for mode in self.modes)

    def mode_acceleration(self, mode: Mode) -> float:
        """a_Z,k = S_e(T_k, xi_k) |gamma_k psi_k| sqrt(1 + 4 xi_k^2) [m/s2], C7.2.7."""
        elastic = float(self.ground.acceleration([mode.period], mode.damping)[0])
        return elastic * abs(mode.participation) * math.sqrt(1.0 + 4.0 * mode.damping**2)

    @property
    def a_z(self) -> float:
        """a_Z = sqrt(sum a_Z,k^2) [m/s2], C7.2.8: the largest acceleration of the floor."""
        return math.sqrt(sum(self.mode_acceleration(mode) ** 2 for mode in self.modes))

    def acceleration(self, periods, damping: float) -> np.ndarray:
        """S_eZ(T, xi) [m/s2], C7.2.5, not below S_e(T, xi) beyond T_1; shape of periods [s]."""
        t = np.asarray(periods, dtype=float)
        squares = sum(self._of_mode(mode, t, damping) ** 2 for mode in self.modes)
        ground = self.ground.acceleration(t, damping)
        return np.where(t > self.first_period, np.maximum(np.sqrt(squares), ground), np.sqrt(squares))

    def _of_mode(self, mode: Mode, t: np.ndarray, damping: float) -> np.ndarray:
        """S_eZ,k [m/s2], C7.2.6, A = 1.1 xi_k^-0.5 eta(xi)."""
        eta = max(math.sqrt(10.0 / (5.0 + 100.0 * damping)), 0.55)
        largest = 1.1 / math.sqrt(mode.damping) * eta
        below = np.clip(1.0 - t / (PLATEAU_START * mode.period), 0.0, None) ** 1.6
        beyond = np.clip(t / (PLATEAU_END * mode.period) - 1.0, 0.0, None) ** 1.2
        return largest * self.mode_acceleration(mode) / (1.0 + (largest - 1.0) * (below + beyond))

    def displacement(self, period: float, damping: float) -> float:
        """S_DeZ(T, xi) = S_eZ (T / 2 pi)^2 [m], C8.7.1.12; beyond 1.1 T_1 not below S_eZ(T_1, xi) times
        (1.1 T_1 / 2 pi)^2."""
        at = np.array([period, self.first_period])
        here, first = self.acceleration(at, damping)
        value = here * (period / (2.0 * math.pi)) ** 2
        if period > PLATEAU_END * self.first_period:
            value = max(value, first * (PLATEAU_END * self.first_period / (2.0 * math.pi)) ** 2)
        return float(value)


def first_mode(storeys: int, height: float, z: float, period: float, damping: float) -> tuple[Mode, ...]:
    """The one mode of C7.2.10: psi_1 = z / H. height, z [m]; period : of the damaged building [s]; damping [-]."""
    return (Mode(period, damping, first_participation(storeys) * z / height),)
