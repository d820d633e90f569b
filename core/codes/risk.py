"""Risk of a mechanism: the acceleration and the return period it withstands, and the safety index IS-V.

The ratio of accelerations supposes the shape of the spectrum fixed (S_S of NTC depends on a_g). IS-V is "of this
mechanism": the class of a building asks for a global analysis (D.M. 65/2017, Annex A).
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from core.codes.demand import SeismicDemand
from core.units import G

EXPONENT = 1.0 / 0.41
"""Exponent of T_R,C = T_R,D (PGA_C / PGA_D)^eta for all of Italy."""

EXPONENT_BY_AG = ((0.25 * G, 1.0 / 0.49), (0.15 * G, 1.0 / 0.43), (0.05 * G, 1.0 / 0.356), (0.0, 1.0 / 0.34))
"""Exponent eta by a_g on rock [m/s2]: each holds from its a_g on."""

MIN_RETURN_PERIOD, MAX_RETURN_PERIOD = 30.0, 2475.0
"""Return periods of the hazard of NTC [years]: beyond them the formula is not read."""

CLASSES = ((1.00, "A+"), (0.80, "A"), (0.60, "B"), (0.45, "C"), (0.30, "D"), (0.15, "E"), (0.0, "F"))
"""IS-V from which on a letter holds; A+ above 1.00."""


@dataclass(frozen=True)
class Risk:
    """Capacity of a mechanism at the limit state of the demand.

    pga : PGA_C = zeta a_g S [m/s2]
    return_period : T_R,C [years], by the hazard of the site where it is given, else the shorter of both exponents; None
        without T_R of the demand
    other_return_period : the longer; beside the hazard the shorter
    by_hazard : return_period is of the hazard
    known_years : return periods between which it is read: those of NTC, and of the rows of the hazard
    index, letter : IS-V of this mechanism and its letter; None at other limit states than SLV
    """

    pga: float
    return_period: float | None
    other_return_period: float | None
    index: float | None
    letter: str | None
    by_hazard: bool
    known_years: tuple[float, float]

    @property
    def years(self) -> str | None:
        """T_R,C in whole years; "<" and ">" beyond what is known; None without it."""
        if self.return_period is None:
            return None
        low, high = self.known_years
        if self.return_period < low:
            return f"< {low:.0f}"
        return f"> {high:.0f}" if self.return_period > high else f"{self.return_period:.0f}"


def risk_of_wall(risks: Sequence[Risk | None]) -> Risk | None:
    """The capacity of a wall: the smallest of all its mechanisms, with the worst letter; None where one is unknown."""
    known = [risk for risk in risks if risk is not None]
    if not known or len(known) < len(risks):
        return None
    letters = [letter for _, letter in CLASSES]
    weakest = min(known, key=lambda one: one.pga)
    if weakest.letter is None:
        return weakest
    return replace(weakest, letter=max((one.letter or "" for one in known), key=letters.index))


def exponent_by_ag(ag: float) -> float:
    """eta by a_g on rock [m/s2]."""
    return next(exponent for least, exponent in EXPONENT_BY_AG if ag >= least)


def risk_class(index: float) -> str:
    """Letter of an IS-V (D.M. 65/2017, Annex A): A+ above 1.00, A from 0.80, ..."""
    if index <= 1.0:
        return next(letter for least, letter in CLASSES[1:] if index >= least)
    return CLASSES[0][1]


def return_period_of(ag: float, hazard: tuple[tuple[float, float], ...]) -> float:
    """T_R [years] of an a_g on rock [m/s2] by the hazard of the site, linear in the logarithms of both between its rows
    (NTC 2018, Annex A, Eq. [2]); beyond them along the last two.

    hazard : (T_R [years], a_g [m/s2]), both rising, two rows or more
    """
    known = np.log(np.array(hazard))
    k = int(np.clip(np.searchsorted(known[:, 1], math.log(ag)), 1, len(hazard) - 1))
    (low, at_low), (high, at_high) = known[k - 1], known[k]
    return math.exp(low + (high - low) * (math.log(ag) - at_low) / (at_high - at_low))


def risk_of_mechanism(zeta: float, demand: SeismicDemand, sure: float | None = None) -> Risk:
    """The capacity of a mechanism whose deciding check has this zeta. sure : the lower end of what zeta is known to be,
    which the letter is of."""
    shorter = longer = None
    if demand.return_period is not None:
        exponents = (EXPONENT, exponent_by_ag(demand.ag))
        shorter, longer = sorted(demand.return_period * zeta**eta for eta in exponents)
    if demand.hazard:
        shorter, longer = return_period_of(zeta * demand.ag, demand.hazard), shorter
    slv = demand.limit_state == "SLV"
    return Risk(
        pga=zeta * demand.pga,
        return_period=shorter,
        other_return_period=longer,
        index=zeta if slv else None,
        letter=risk_class(min(zeta, sure or zeta)) if slv else None,
        by_hazard=bool(demand.hazard),
        known_years=(max(MIN_RETURN_PERIOD, demand.hazard[0][0]), min(MAX_RETURN_PERIOD, demand.hazard[-1][0]))
        if demand.hazard
        else (MIN_RETURN_PERIOD, MAX_RETURN_PERIOD),
    )
