"""A ground motion in SI units with its provenance and intensity measures (resources/docs/physics.md, section 12)."""

import hashlib
import math
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from core.errors import RecordError
from core.ground import response_spectrum
from core.units import G

LARGE_PGA = 2.0 * G
SMALL_PGA = 0.001 * G
"""Outside these peaks [m/s2] the unit is probably wrong: warned."""

MIN_PGA = 1e-9
"""Below this peak [m/s2] a record is one of zeros."""

MIN_STEP, MAX_STEP = 1e-5, 0.5
"""Time steps accepted [s]."""


def check_step(time_step: float) -> None:
    """Raise RecordError for a time step [s] that no record has."""
    if not MIN_STEP <= time_step <= MAX_STEP:
        raise RecordError("time_step", step=time_step, low=MIN_STEP, high=MAX_STEP)


@dataclass(frozen=True)
class GroundMotion:
    """An accelerogram, linear between samples.

    name : shown to the user
    acceleration : [m/s2], shape (n,), read-only; time_step [s]
    file, file_sha256, format, unit : where it comes from and the unit it was written in
    details : what the file says of itself
    warnings : Notices
    ground_pga : of a floor motion, PGA of the record it comes from [m/s2]
    scale : factor the samples of the file were read with
    channel : of a file that has several
    lines : of the file above the samples of this channel, of the samples, and others
    Raises RecordError for fewer than 10 samples, a motion of zeros, or samples that are not finite.
    """

    name: str
    acceleration: np.ndarray = field(repr=False)
    time_step: float
    file: str = ""
    file_sha256: str = ""
    format: str = ""
    unit: str = "m/s2"
    details: tuple[tuple[str, str], ...] = ()
    warnings: tuple = ()
    ground_pga: float | None = None
    scale: float = 1.0
    channel: str = ""
    lines: tuple[int, int, int] | None = None

    def __post_init__(self):
        samples = np.ascontiguousarray(self.acceleration, dtype=np.float64).copy()
        samples.flags.writeable = False
        object.__setattr__(self, "acceleration", samples)
        check_step(self.time_step)
        if samples.size < 10:
            raise RecordError("too_few_samples", n=samples.size)
        if not np.isfinite(samples).all():
            raise RecordError("sample_not_a_number", n=int(np.argmin(np.isfinite(samples))) + 1)
        if np.abs(samples).max() < MIN_PGA:
            raise RecordError("all_zero")

    @property
    def samples_sha256(self) -> str:
        """Hash of time step and samples as little-endian doubles."""
        content = np.concatenate([[self.time_step], self.acceleration]).astype("<f8").tobytes()
        return hashlib.sha256(content).hexdigest()

    @property
    def duration(self) -> float:
        """Length [s], first to last sample."""
        return (self.acceleration.size - 1) * self.time_step

    @cached_property
    def pga(self) -> float:
        """Peak ground acceleration [m/s2]."""
        return float(np.abs(self.acceleration).max())

    @cached_property
    def velocity(self) -> np.ndarray:
        """Ground velocity by the trapezoidal rule, no baseline step [m/s]."""
        return _integral(self.acceleration, self.time_step)

    @property
    def pgv(self) -> float:
        """Peak ground velocity [m/s]."""
        return float(np.abs(self.velocity).max())

    @property
    def pgd(self) -> float:
        """Peak ground displacement [m] without a baseline step: no meaning for raw records."""
        return float(np.abs(_integral(self.velocity, self.time_step)).max())

    @cached_property
    def _husid(self) -> np.ndarray:
        return math.pi / (2.0 * G) * _integral(self.acceleration**2, self.time_step)

    @property
    def arias(self) -> float:
        """Arias intensity pi/(2g) integral of a^2 [m/s] by the trapezoid rule on the squares of the samples, as is the
        custom, so that it compares with other programs. Of the motion linear between samples the integral is
        lower: by 1 % or less where a cycle has 20 samples, by 21 % on the coarsest record of the shelf."""
        return float(self._husid[-1])

    @property
    def duration_5_95(self) -> float:
        """Time between 5 and 95 % of the Arias intensity [s]."""
        times = np.interp([0.05, 0.95], self._husid / self._husid[-1], np.arange(self._husid.size))
        return float((times[1] - times[0]) * self.time_step)

    @cached_property
    def housner_intensity(self) -> float:
        """SI [m], Eq. 11."""
        return response_spectrum.housner_intensity(self.acceleration, self.time_step)

    @cached_property
    def velocity_integral(self) -> np.ndarray:
        """As of `response_spectrum.velocity_integral` [m]."""
        return response_spectrum.velocity_integral(self.acceleration, self.time_step)

    def measure(self, cancelled=lambda: False) -> float:
        """Compute the intensity once, so that threads can do it side by side."""
        return self.housner_intensity


def _integral(samples: np.ndarray, dt: float) -> np.ndarray:
    """Cumulative trapezoidal integral from 0, shape of samples."""
    steps = 0.5 * dt * (samples[1:] + samples[:-1])
    return np.concatenate([[0.0], np.cumsum(steps)])
