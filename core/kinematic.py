"""Kinematic checks of the Circolare 7/2019, C8.7.1.2.1.7 (with q) and C8.7.1.2.1.8 (displacement).

For a wall on the ground. Formulas read in a public transcription of the Circolare (CODES).
"""

import math
from dataclasses import dataclass

from core import target_spectrum
from core.block import Block
from core.demand import DemandResult
from core.units import G

LIMIT_FRACTION = {"SLV": 0.40, "SLC": 0.60}
"""d_SLV, d_SLC over d_0 without ties or supports (C8.7.1.2.1.6)."""

PERIOD_FACTOR = {"SLV": 1.68 * math.pi, "SLC": 1.56 * math.pi}
DAMPING = {"SLV": 0.08, "SLC": 0.10}
"""C8.7.1.10, C8.7.1.11 and the damping of C8.7.1.12."""

WALL_MASS_FRACTION = 0.75
"""e* of a wall turning about its base, C8.7.1.5 over its height: (1/2)^2 / (1/3)."""


@dataclass(frozen=True)
class Check:
    """One row of the table of methods. name : dynamic, nonlinear, linear_q_slv, linear_q_code; clause;
    capacity, demand : in `unit`, None where the row has none; zeta : capacity over demand; passed iff
    zeta >= zeta_target; q : of the row."""

    name: str
    clause: str
    unit: str
    capacity: float | None
    demand: float | None
    zeta: float | None
    passed: bool | None
    q: float | None = None


@dataclass(frozen=True)
class Kinematic:
    """Quantities of the mechanism. alpha0 : multiplier that starts it (C8.7.1.1) [-]; e_star [-];
    a0 : spectral acceleration with FC (C8.7.1.3) [m/s2]; d0 : displacement of the centre of mass at
    which nothing holds the wall [m]; d_limit : 0.40 or 0.60 of it; a_limit : capacity there [m/s2];
    period : T_SLV or T_SLC [s]; s_de : demand there [m]; zeta_over_height : of the displacement check with
    C8.7.1.4 summed over the height as e* is, d = d_C / e*, the less cautious reading, shown beside the
    check. The last five are None without a spectrum."""

    alpha0: float
    e_star: float
    a0: float
    d0: float
    d_limit: float | None = None
    a_limit: float | None = None
    period: float | None = None
    s_de: float | None = None
    zeta_over_height: float | None = None


def kinematic(block: Block, demand: DemandResult, wall_like: bool) -> Kinematic:
    """The mechanism of a wall. wall_like : a wall of constant thickness; else e* = 1, on the safe side.

    d_C is taken at the centre of mass, where the weight acts, and not enlarged by C8.7.1.4: the cautious
    reading of a sum over one body.
    """
    alpha0 = math.tan(block.slenderness)
    e_star = WALL_MASS_FRACTION if wall_like else 1.0
    a0 = alpha0 * G / (e_star * demand.confidence_factor)
    d0 = block.radius * math.sin(block.slenderness)
    if demand.target is None or demand.limit_state not in LIMIT_FRACTION:
        return Kinematic(alpha0, e_star, a0, d0)
    share = LIMIT_FRACTION[demand.limit_state]
    d_limit, a_limit = share * d0, (1.0 - share) * a0
    period = PERIOD_FACTOR[demand.limit_state] * math.sqrt(d_limit / a_limit)
    longer = period / math.sqrt(e_star)
    damping = DAMPING[demand.limit_state]
    s_de, s_longer = target_spectrum.displacement(demand.target, [period, longer], damping).tolist()
    over_height = d_limit / e_star / s_longer
    return Kinematic(alpha0, e_star, a0, d0, d_limit, a_limit, period, s_de, over_height)


def linear(name: str, found: Kinematic, demand: DemandResult, q: float) -> Check:
    """a_g,SLV = q a_g,SLD >= a_g, a_g,SLD = a0 / S on the ground (C8.7.1.2.1.7)."""
    capacity = q * found.a0 / demand.soil_factor
    zeta = capacity / demand.ag
    passed = zeta >= demand.zeta_target - 1e-12
    return Check(name, "C8.7.1.2.1.7", "g", capacity / G, demand.ag / G, zeta, passed, q)


def nonlinear(found: Kinematic, demand: DemandResult) -> Check | None:
    """d_SLV >= S_De(T_SLV) (C8.7.1.12 on the ground); None without a spectrum."""
    if found.d_limit is None:
        return None
    zeta = found.d_limit / found.s_de
    passed = zeta >= demand.zeta_target - 1e-12
    return Check("nonlinear", "C8.7.1.2.1.8", "m", found.d_limit, found.s_de, zeta, passed)
