"""q_eff, its power law, and the paper's regressions (Coccia et al. 2016, Eq. 12 to 16)."""

import math
from dataclasses import dataclass

import numpy as np

from core.text.sentence import Sentence, notice, sentence
from core.units import G

FITTED_SLENDERNESS = (math.radians(3.1), math.radians(11.3))
FITTED_HEIGHT = (3.0, 11.0)
FITTED_PGA = (0.106 * G, 0.312 * G)
"""Ranges Eq. 15/16 were fitted on [rad], [m], [m/s2]; rigid law, Eq. 4 and Eq. 6, no load."""

COEFFICIENTS = {False: (30.0, 78.0, 90.0, -1.0), True: (23.0, 65.0, 840.0, -0.9)}
"""one_sided -> A1 [1/deg], A2 [1/m], A3, C2 of Eq. 15 and Eq. 16, SI in cm."""


def effective_q(q: float, pga: float) -> float:
    """q_eff = q g / (a_g S) [-], Eq. 12; pga : a_g S, of a record its PGA [m/s2]."""
    return q * G / pga


def closed_form_q_eff(slenderness: float, height: float, intensity: float, one_sided: bool) -> float:
    """q_eff of Eq. 15 (two-sided) or Eq. 16 (one-sided) [-].

    slenderness [rad]; height [m]; intensity : SI [m]. The print sets these equal to q: the factor
    a_g S / g is in `closed_form_q`.
    """
    a1, a2, a3, c2 = COEFFICIENTS[one_sided]
    return (a1 * math.degrees(slenderness) + a2 * height + a3) * (100.0 * intensity) ** c2


def closed_form_q(slenderness, height, intensity, pga, one_sided) -> float:
    """q of Eq. 15 or Eq. 16 [-]; SI [m] and pga = a_g S [m/s2] belong to the same motion."""
    return closed_form_q_eff(slenderness, height, intensity, one_sided) * pga / G


def range_notices(slenderness: float, height: float, pgas: list[tuple[str | Sentence, float]]) -> list[Sentence]:
    """Notices where a wall and its motions lie outside the ranges Eq. 15/16 were fitted on.

    pgas : (where, a name or a Sentence, PGA [m/s2]) of each motion the forms are used with.
    """
    notices = []
    low, high = FITTED_SLENDERNESS
    if not low - 1e-9 <= slenderness <= high + 1e-9:
        notices.append(notice("eq15_slenderness", alpha=math.degrees(slenderness)))
    if not FITTED_HEIGHT[0] - 1e-9 <= height <= FITTED_HEIGHT[1] + 1e-9:
        notices.append(notice("eq15_height", height=height))
    outside: list = [
        sentence("added", "with_pga", where=where, pga=pga / G)
        for where, pga in pgas
        if not FITTED_PGA[0] - 1e-9 <= pga <= FITTED_PGA[1] + 1e-9
    ]
    if outside:
        more = [f"+{len(outside) - 5}"] if len(outside) > 5 else []
        notices.append(notice("eq15_pga", where=(*outside[:5], *more)))
    return notices


@dataclass(frozen=True)
class PowerLaw:
    """q_eff = c1 SI^c2 (Eq. 13), SI in cm; R2 of the logarithms, n points, range of SI [cm]."""

    c1: float
    c2: float
    r_squared: float
    n: int
    si_range_cm: tuple[float, float]

    def q_eff(self, intensity: float) -> float:
        """q_eff at SI [m]."""
        return self.c1 * (100.0 * intensity) ** self.c2


MIN_SPREAD, MAX_LOG = 0.02, 600.0
"""Ratio minus 1 of the largest to the smallest SI below which points give no slope; logarithm of C1 beyond which it is
no number anyone can use (and no double)."""


def fit_power_law(intensities: list[float], q_eff: list[float]) -> PowerLaw | None:
    """Least squares of the logarithms; None below three points or where SI [m] hardly differs between them."""
    if len(intensities) < 3 or max(intensities) <= min(intensities) * (1.0 + MIN_SPREAD):
        return None
    x = np.log(100.0 * np.asarray(intensities))
    y = np.log(np.asarray(q_eff))
    dx, dy = x - x.mean(), y - y.mean()
    c2 = float((dx * dy).sum() / (dx * dx).sum())
    log_c1 = float(y.mean() - c2 * x.mean())
    if not abs(log_c1) < MAX_LOG:
        return None
    spread = float((dy * dy).sum())
    residual = float(((dy - c2 * dx) ** 2).sum())
    return PowerLaw(
        c1=math.exp(log_c1),
        c2=c2,
        r_squared=1.0 - residual / spread if spread > 0.0 else 1.0,
        n=len(intensities),
        si_range_cm=(100.0 * min(intensities), 100.0 * max(intensities)),
    )
