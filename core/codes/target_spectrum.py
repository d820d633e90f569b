"""Elastic spectra of the demand: NTC 2018 3.2.3.2.1, the branches of every code, or a file of two columns."""

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from core.errors import InputError, place
from core.ground.response_spectrum import HOUSNER_PERIODS, SCALED_PERIODS, SPECTRUM_DAMPING, integral_of
from core.units import G

SOILS = ("A", "B", "C", "D", "E")

NTC_SOIL = {
    # S_S = a - b F0 ag/g within [low, high]; C_C = c T_C*^d (NTC 2018 Tab. 3.2.IV)
    "A": (1.00, 0.00, 1.00, 1.00, 1.00, 0.00),
    "B": (1.40, 0.40, 1.00, 1.20, 1.10, -0.20),
    "C": (1.70, 0.60, 1.00, 1.50, 1.05, -0.33),
    "D": (2.40, 1.50, 0.90, 1.80, 1.25, -0.50),
    "E": (2.00, 1.10, 1.00, 1.60, 1.15, -0.40),
}
NTC_TOPOGRAPHY = {"T1": 1.0, "T2": 1.2, "T3": 1.2, "T4": 1.4}
"""S_T at the top of the relief (NTC 2018 Tab. 3.2.V)."""

SI_FROM, SI_TO = float(HOUSNER_PERIODS[0]), float(HOUSNER_PERIODS[-1])
"""Periods of the Housner intensity [s]."""


@dataclass(frozen=True)
class CodeSpectrum:
    """Four branches.

    ag : on rock [m/s2]
    soil : S [-]
    amplification : F0 [-]; t_b, t_c, t_d [s]
    """

    name: str
    ag: float
    soil: float
    amplification: float
    t_b: float
    t_c: float
    t_d: float

    @property
    def pga(self) -> float:
        """a_g S [m/s2]."""
        return self.ag * self.soil

    def acceleration(self, periods, damping: float = SPECTRUM_DAMPING) -> np.ndarray:
        """Elastic S_e [m/s2], shape of periods [s]; eta = sqrt(10 / (5 + xi)) >= 0.55 (NTC 3.2.2, 3.2.4)."""
        t = np.asarray(periods, dtype=float)
        eta = max(math.sqrt(10.0 / (5.0 + 100.0 * damping)), 0.55)
        plateau = eta * self.amplification
        shape = np.where(
            t < self.t_d,
            plateau * self.t_c / np.maximum(t, self.t_c),
            plateau * self.t_c * self.t_d / np.maximum(t, self.t_d) ** 2,
        )
        shape = np.where(t < self.t_c, plateau, shape)
        shape = np.where(t < self.t_b, t / self.t_b * plateau + (1.0 - t / self.t_b), shape)
        return self.pga * shape


@dataclass(frozen=True)
class GivenSpectrum:
    """A 5 % spectrum read from a file, linear between its points. periods [s]; values : S_e [m/s2]."""

    name: str
    ag: float
    soil: float
    periods: tuple[float, ...]
    values: tuple[float, ...]

    @property
    def pga(self) -> float:
        """a_g S of the demand [m/s2]; the file should start there."""
        return self.ag * self.soil

    def acceleration(self, periods, damping: float = SPECTRUM_DAMPING) -> np.ndarray:
        """Elastic S_e [m/s2]; other damping by eta beyond the first point, constant displacement
        beyond the last. Below the first period the line goes to a_g S."""
        t = np.asarray(periods, dtype=float)
        known = np.array(self.periods)
        values = np.array(self.values)
        if known[0] > 0.0:
            known, values = np.insert(known, 0, 0.0), np.insert(values, 0, self.pga)
        eta = max(math.sqrt(10.0 / (5.0 + 100.0 * damping)), 0.55)
        base = np.interp(t, known, values)
        beyond = t > known[-1]
        base = np.where(beyond, values[-1] * (known[-1] / np.maximum(t, known[-1])) ** 2, base)
        first = known[1]
        return base * np.where(t < first, 1.0 + (eta - 1.0) * t / first, eta)


Target = CodeSpectrum | GivenSpectrum

FALL_TO, FALL_SHARE = 2.0, 0.5
"""A spectrum of the elastic motion whose S_De falls below this share of an earlier value within these periods [s] is
doubted: that of every code rises to T_D, 1.2 s and more, and is constant from there."""


def displacement_fall(target: "Target | None") -> tuple[float, float, float] | None:
    """Period at which S_De of a spectrum of a file falls: (period before [s], period [s], share); None where it does
    not, and of a code."""
    if not isinstance(target, GivenSpectrum):
        return None
    periods = np.array([t for t in target.periods if 0.0 < t <= FALL_TO])
    if not periods.size:
        return None
    displacement = target.acceleration(periods) * periods**2
    before = np.maximum.accumulate(displacement)
    k = int(np.argmin(displacement / before))
    share = float(displacement[k] / before[k])
    return (float(periods[np.argmax(displacement[: k + 1])]), float(periods[k]), share) if share < FALL_SHARE else None


def displacement(target: Target, periods, damping: float = SPECTRUM_DAMPING) -> np.ndarray:
    """S_De = S_e (T / 2 pi)^2 [m] (NTC 3.2.10)."""
    t = np.asarray(periods, dtype=float)
    return target.acceleration(t, damping) * (t / (2.0 * math.pi)) ** 2


def largest_displacement(target: Target, low: float, high: float, damping: float) -> float:
    """Largest S_De on the periods [low, high] [s] in m: of a code's spectrum, which never falls, at its end."""
    periods = [low, high]
    if isinstance(target, GivenSpectrum):
        known, values = np.array(target.periods), np.array(target.values)
        slope = np.diff(values) / np.diff(known)
        level = values[:-1] - slope * known[:-1]
        # on a branch level + slope T, T^2 (level + slope T) is largest at T = -2 level / (3 slope)
        with np.errstate(divide="ignore", invalid="ignore"):
            turn = -2.0 * level / (3.0 * slope)
        inside = (turn > known[:-1]) & (turn < known[1:])
        periods = np.concatenate([periods, known, turn[inside]])
        periods = periods[(periods >= low) & (periods <= high)]
    return float(displacement(target, periods, damping).max())


def shape_integral(target: CodeSpectrum) -> float:
    """Integral of S_e T / (a_g S) over the periods of the Housner intensity, exact on each branch of the spectrum."""
    tb, tc, td, f0 = target.t_b, target.t_c, target.t_d, target.amplification
    first, last = min(SI_FROM, tb), min(td, SI_TO)
    rise = (tb**2 - first**2) / 2 + (f0 - 1) * (tb**3 - first**3) / (3 * tb)
    level = f0 * (tc**2 - max(tb, SI_FROM) ** 2) / 2
    return rise + level + f0 * tc * (last - tc) + f0 * tc * td * math.log(SI_TO / last)


def housner_intensity(target: Target) -> float:
    """SI [m] of a target spectrum, Eq. 11 on its pseudo-velocity."""
    velocity = target.acceleration(HOUSNER_PERIODS) * HOUSNER_PERIODS / (2.0 * math.pi)
    return float(np.trapezoid(velocity, HOUSNER_PERIODS))


def velocity_integral(target: Target) -> np.ndarray:
    """Integral of the pseudo-velocity of a target from the first of SCALED_PERIODS to each of them [m]."""
    return integral_of(target.acceleration(SCALED_PERIODS) * SCALED_PERIODS / (2.0 * math.pi))


def ntc2018(ag: float, f0: float, tc_star: float, soil: str, topography: str) -> CodeSpectrum:
    """NTC 2018 3.2.3.2.1, Eq. 3.2.2 to 3.2.7.

    ag : on rigid ground, S apart [m/s2]
    tc_star : T_C* [s]

    Raises InputError where T_B < T_C < T_D does not hold.
    """
    a, b, low, high, c, d = NTC_SOIL[soil]
    factor = min(max(a - b * f0 * ag / G, low), high) * NTC_TOPOGRAPHY[topography]
    t_c = c * tc_star**d * tc_star
    t_d = 4.0 * ag / G + 1.6
    if not t_c < t_d:
        raise InputError("t_c_above_t_d", stated=tc_star, soil=soil, t_c=t_c, t_d=t_d)
    return CodeSpectrum(f"NTC 2018, {soil}, {topography}", ag, factor, f0, t_c / 3.0, t_c, t_d)


LEAST_AMPLIFICATION, MOST_AMPLIFICATION = 2.2, 6.0
"""Largest ordinate of an elastic spectrum over a_g S [-]: F_0 is at least 2.2 (NTC 2018, 3.2.3.2.1)."""

START_AGREES, PLATEAU_AGREES = 0.05, 0.01
"""How near the start of a spectrum comes to a_g S, and its largest ordinate to the least amplification, as printed."""

FLOOR_OF_DESIGN, FLOOR_SPAN = (0.19, 0.21), 1.25
"""S_d of a design spectrum never falls below 0.2 a_g (NTC 2018 3.2.3.5; EN 1998-1, 3.2.2.5): ordinates over a_g that
stay, over periods in this ratio, over which those of an elastic spectrum fall by a fifth at the least."""

Q_IN_HEAD = re.compile(
    r"\bq(?:\s*[=:]\s*|\s+)(\d+(?:[.,]\d+)?)(?!\d|[.,]\d|\s*(?:m\b|m\s*s\.?\s*l|mm|cm|km|kN|kPa|MPa))", re.IGNORECASE
)
DESIGN_IN_HEAD = re.compile(
    r"spettr\w+ di progetto|design spectr|behaviou?r factor|fattore di (?:struttura|comportamento)|\b(?-i:S_?d)\b",
    re.IGNORECASE,
)
"""Words and symbols by which the head of a file calls its spectrum one of design."""


def check_head(head: Sequence[str]) -> None:
    """Raise InputError where a line above the numbers says that they are a design spectrum: a factor q above 1, or,
    with none, its name or symbol."""
    factors = [float(found[1].replace(",", ".")) for line in head for found in Q_IN_HEAD.finditer(line)]
    named = next((line for line in head if DESIGN_IN_HEAD.search(line)), None)
    reduced = next((line for line in head if Q_IN_HEAD.search(line)), None) if max(factors, default=1.0) > 1.0 else None
    words = reduced or (None if factors else named)
    if words is not None:
        raise InputError("spectrum_of_design", words=words.strip()[:60])


def given(name: str, ag: float, soil: float, rows: Sequence[tuple[float, float]]) -> GivenSpectrum:
    """A spectrum of (period [s], S_e [m/s2]) rows. Raises InputError for fewer than 5 rows, periods not rising, values
    not positive, a range that does not hold 0.1 to 2.5 s, and for what is no elastic spectrum of a_g S."""
    periods = tuple(row[0] for row in rows)
    values = tuple(row[1] for row in rows)
    if len(rows) < 5:
        raise InputError("spectrum_too_short", rows=len(rows), place=(name,))
    for k in range(1, len(rows)):
        if not periods[k] > periods[k - 1]:
            raise InputError("spectrum_not_rising", period=periods[k], place=(name, place("row", n=k + 1)))
    if not (periods[0] >= 0.0 and all(0.0 < value < 20.0 * G for value in values)):
        raise InputError("spectrum_values", place=(name,))
    if periods[0] > 0.1 or periods[-1] < 2.5:
        raise InputError("spectrum_range", low=periods[0], high=periods[-1], place=(name,))
    spectrum = GivenSpectrum(name, ag, soil, periods, values)
    if periods[0] <= 0.01 and abs(values[0] / spectrum.pga - 1.0) > START_AGREES:
        raise InputError("spectrum_start", start=values[0] / G, pga=spectrum.pga / G, place=(name,))
    if values[0] < (1.0 - START_AGREES) * spectrum.pga:  # it rises from a_g S to its plateau
        found = {"start": values[0] / G, "pga": spectrum.pga / G, "period": periods[0]}
        raise InputError("spectrum_begins", place=(name,), **found)
    ratio = max(values) / spectrum.pga
    if not LEAST_AMPLIFICATION * (1.0 - PLATEAU_AGREES) <= ratio <= MOST_AMPLIFICATION:
        limits = {"least": LEAST_AMPLIFICATION, "most": MOST_AMPLIFICATION}
        raise InputError("spectrum_largest", largest=max(values) / G, ratio=ratio, place=(name,), **limits)
    if _has_floor(spectrum):
        raise InputError("spectrum_floor", floor=values[-1] / G, ag=ag / G, place=(name,))
    return spectrum


def _has_floor(spectrum: GivenSpectrum) -> bool:
    """Whether a spectrum ends at the floor of a design spectrum."""
    last = spectrum.values[-1]
    flat = [t for t, value in zip(spectrum.periods, spectrum.values, strict=True) if abs(value / last - 1.0) < 1e-3]
    low, high = FLOOR_OF_DESIGN
    return low <= last / spectrum.ag <= high and flat[-1] >= FLOOR_SPAN * flat[0]
