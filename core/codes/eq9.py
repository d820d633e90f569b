"""The inequality of the code with every q (Coccia et al. 2016, Eq. 9)."""

from dataclasses import dataclass

LABEL = "Eq. 9"
TITLE = "Eq. 9, without e* and FC"
"""Title of the check: Eq. 9 compares a collapse q with a code value meant for life safety, and is never the only
verdict."""

RATIO_ROUNDING = 1e-12
"""What a ratio may miss of 1 by rounding alone [-]."""


@dataclass(frozen=True)
class Inequality:
    """a_RM >= S a_g / q. capacity and demand [m/s2]; ratio = capacity / demand; passed iff >= 1."""

    q_source: str
    q: float
    capacity: float
    demand: float

    @property
    def ratio(self) -> float:
        return self.capacity / self.demand

    @property
    def passed(self) -> bool:
        """Equality passes, also where the rounding of a_RM leaves it a last digit short."""
        return self.ratio >= 1.0 - RATIO_ROUNDING


def inequality(q_source: str, q: float, threshold: float, pga: float) -> Inequality:
    """Eq. 9 with one q [-].

    threshold : a_RM [m/s2]
    pga : S a_g of the demand [m/s2]
    """
    return Inequality(q_source, q, threshold, pga / q)
