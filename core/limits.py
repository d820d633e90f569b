"""Limit states, the rule of a set of records, and q as a multiplier of a record: each written once."""

import math

LIMIT_FRACTION = {"SLV": 0.40, "SLC": 0.60}
"""Share of the rotation at which nothing holds the wall, and of d_0, that a limit state allows without
ties or supports (Circolare 7/2019 C8.7.1.2.1.6)."""

MEAN_FROM = 7
MINIMUM_FROM = 3
"""Records from which a set takes the mean, and from which the most unfavourable (EN 1998-1 4.3.3.4.3(3))."""

EXCEEDANCE = {"SLO": 0.81, "SLD": 0.63, "SLV": 0.10, "SLC": 0.05}
"""P_VR, probability that a limit state's motion is exceeded in V_R (NTC 2018 Tab. 3.2.I)."""


def multiplier_of(q, pga: float, threshold: float):
    """Multiplier C of a record of this PGA at q = C PGA / a_RM (Coccia et al. 2016, Eq. 10) [-].

    q : [-], a number or an array; pga : of the unscaled record [m/s2]; threshold : a_RM [m/s2], Eq. 2.
    """
    return threshold / pga * q


def return_period(reference_period: float, limit_state: str) -> float:
    """T_R = -V_R / ln(1 - P_VR) [years] (NTC 2018 Eq. 3.2.0); reference_period : V_R = V_N C_U [years]."""
    return -reference_period / math.log1p(-EXCEEDANCE[limit_state])
