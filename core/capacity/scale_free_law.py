"""Ribalta's law: q of a wall from its velocity ratio and Pi = p^2 SI / PGA alone. A research output, never part of a
verdict (resources/docs/paper.md, section 3)."""

import math
from dataclasses import dataclass

import numpy as np

from core.ground.response_spectrum import SCALED_PERIODS
from core.wall.block import Block
from core.wall.impact import Restitution
from core.wall.moment_rotation import LAWS, MomentLaw
from core.wall.restitution import overturning_velocity

Coefficients = tuple[float, float, float, float]


@dataclass(frozen=True)
class ScaleFreeLaw:
    """q = limit + exp(a0 + a1 s) Pi^-(b0 + b1 s), s = sqrt(1 - e): fitted on means of ten generated motions.

    coefficients : a0, a1, b0, b1
    limit : q of a motion much longer than the wall's own time, 1 of the rigid law, the plateau of a trilinear one
    scatter_set, scatter_record : standard deviation of ln(law / q), of the mean of a set of a shape left out of the
        fit and of a single motion
    pi_range, loss_range : of Pi and of s in the fit
    """

    coefficients: Coefficients
    limit: float
    scatter_set: float
    scatter_record: float
    pi_range: tuple[float, float]
    loss_range: tuple[float, float]

    def q(self, pi, velocity_ratio):
        """q [-] at Pi and e [-], numbers or arrays."""
        return law_value(self.coefficients, self.limit, pi, np.sqrt(1.0 - np.asarray(velocity_ratio)))

    def interval(self, pi: float, velocity_ratio: float) -> tuple[float, float]:
        """Range of q that holds the mean of a set of compatible motions in nine cases of ten; in three of four below
        Pi 0.3, and single natural records less often (resources/docs/paper.md, section 3). Under the rigid law not
        below 1."""
        q = float(self.q(pi, velocity_ratio))
        factor = math.exp(1.645 * self.scatter_set)
        return max(q / factor, self.limit if self.limit == 1.0 else 0.0), q * factor

    def holds(self, pi: float, velocity_ratio: float) -> bool:
        """Whether this is within the range of the fit."""
        loss = math.sqrt(1.0 - velocity_ratio)
        low, high = self.loss_range
        return self.pi_range[0] <= pi <= self.pi_range[1] and low <= loss <= high


@dataclass(frozen=True)
class Estimate:
    """q of the law for one wall and motion. quantity : "q" or "q_slv"; low, high : nine sets of ten lie between;
    within : inside the range of the fit."""

    quantity: str
    q: float
    low: float
    high: float
    pi: float
    within: bool


def estimates(
    block: Block, restitution: Restitution, law: MomentLaw, one_sided: bool, intensity: float, pga: float
) -> tuple[Estimate, ...]:
    """q and q_slv of the law; none for a moment law it was not fitted on. intensity : SI [m]; pga [m/s2]."""
    pi, ratio = dimensionless_intensity(block.p2, intensity, pga), loss_ratio(block, restitution)
    estimated: list[Estimate] = []
    for quantity in ("q", "q_slv"):
        fitted = law_of(one_sided, law, quantity)
        if fitted is not None:
            within = fitted.holds(pi, ratio)
            q, (low, high) = float(fitted.q(pi, ratio)), fitted.interval(pi, ratio)
            for one in estimated:  # q_slv: the two fits may cross by 2 %, the quantities cannot
                q, low, high = min(q, one.q), min(low, one.low), min(high, one.high)
            estimated.append(Estimate(quantity, q, low, high, pi, within))
    return tuple(estimated)


def law_value(coefficients, limit: float, pi, loss):
    """limit + exp(a0 + a1 s) Pi^-(b0 + b1 s)."""
    a0, a1, b0, b1 = coefficients
    return limit + np.exp(a0 + a1 * loss - (b0 + b1 * loss) * np.log(pi))


def dimensionless_intensity(p2: float, intensity: float, pga: float) -> float:
    """Pi = p^2 SI / PGA [-]; p2 [1/s2], SI [m], PGA [m/s2]: free of the scale of the motion and of units. Not of time:
    SI is of the fixed periods from 0.1 to 2.5 s, so that motion and wall stretched together, which leave q as it is,
    change Pi (resources/docs/paper.md, section 3)."""
    return p2 * intensity / pga


BANDS = {"two_sided": (0.2, 8.0), "one_sided": (0.2, 5.0)}
"""Mechanism -> ends of the band of periods over 1/p of the intensity that is free of time. Chosen on the generated
shapes and one half of the events of natural records, before the other half was looked at."""


def scaled_intensity(p2: float, integral: np.ndarray, pga: float, mechanism: str) -> float:
    """Lambda = p^2 / PGA times the integral of the pseudo-velocity from a/p to b/p [-]: free of the scale of the motion
    and of time and wall stretched together, as q is.

    p2 : [1/s2]; integral : `velocity_integral` of the motion [m]; pga [m/s2]; mechanism : whose band is taken
    """
    ends = np.array(BANDS[mechanism]) / math.sqrt(p2)
    low, high = np.interp(ends, SCALED_PERIODS, integral)
    return float(p2 * (high - low) / pga)


def loss_ratio(block: Block, restitution: Restitution) -> float:
    """The velocity ratio the law takes: of Eq. 7, which falls with the speed, the one at the overturning velocity."""
    speed = overturning_velocity(block)
    return max(0.0, restitution.ratio_at_rest - restitution.ratio_drop * speed * speed)


def limit_of(law: MomentLaw) -> float:
    """q of a motion that acts like a constant acceleration: 1, or the plateau 1 - D2 (small alpha)."""
    return 1.0 if law.is_rigid else 1.0 - law.plateau_end


def fit_law(pi, loss, q, limit: float) -> Coefficients:
    """Coefficients by least squares of ln(law / q). pi, loss, q : [-], shape (n,)."""
    from scipy.optimize import least_squares

    def residual(coefficients):
        return np.log(law_value(coefficients, limit, pi, loss) / q)

    a0, a1, b0, b1 = map(float, least_squares(residual, np.zeros(4)).x)
    return a0, a1, b0, b1


def law_of(one_sided: bool, law: MomentLaw, quantity: str) -> ScaleFreeLaw | None:
    """The fitted law of a mechanism, a named moment law and "q" or "q_slv"; None for another moment law."""
    name = next((name for name, known in LAWS.items() if known == law), None)
    return None if name is None else FITTED.get(("one_sided" if one_sided else "two_sided", name, quantity))


PI_RANGE = (0.13, 10.5)
PI_TRI = (0.13, 2.5)
TWO, ONE = (0.042, 0.466), (0.042, 0.919)
TWO_TRI, ONE_TRI = (0.042, 0.419), (0.709, 0.883)
"""Ranges of Pi and of s in which the fits hold; two-sided trilinear ones fail beyond 2.5, where q may be below the
plateau."""

FITTED: dict[tuple[str, str, str], ScaleFreeLaw] = {
    ("two_sided", "rigid", "q"): ScaleFreeLaw((-0.092, 3.777, 1.589, -1.087), 1.0, 0.131, 0.194, PI_RANGE, TWO),
    ("two_sided", "rigid", "q_slv"): ScaleFreeLaw((-1.105, 4.629, 1.679, -1.513), 1.0, 0.155, 0.192, PI_RANGE, TWO),
    ("two_sided", "doherty", "q"): ScaleFreeLaw((0.147, 3.601, 1.748, -1.299), 0.72, 0.238, 0.319, PI_TRI, TWO_TRI),
    ("two_sided", "doherty", "q_slv"): ScaleFreeLaw(
        (-0.877, 4.247, 1.937, -1.979), 0.72, 0.301, 0.362, PI_TRI, TWO_TRI
    ),
    ("two_sided", "al_shawa", "q"): ScaleFreeLaw((0.087, 3.719, 1.733, -1.31), 0.72, 0.225, 0.298, PI_TRI, TWO_TRI),
    ("two_sided", "al_shawa", "q_slv"): ScaleFreeLaw(
        (-1.019, 4.65, 1.954, -2.109), 0.72, 0.286, 0.336, PI_TRI, TWO_TRI
    ),
    ("one_sided", "rigid", "q"): ScaleFreeLaw((-0.659, 2.826, 0.652, -0.197), 1.0, 0.138, 0.154, PI_RANGE, ONE),
    ("one_sided", "rigid", "q_slv"): ScaleFreeLaw((-0.832, 2.691, 0.463, 0.018), 1.0, 0.147, 0.16, PI_RANGE, ONE),
    ("one_sided", "doherty", "q"): ScaleFreeLaw((-0.386, 2.253, 0.277, 0.319), 0.72, 0.15, 0.166, PI_RANGE, ONE_TRI),
    ("one_sided", "doherty", "q_slv"): ScaleFreeLaw(
        (-0.336, 1.781, 0.179, 0.475), 0.72, 0.154, 0.171, PI_RANGE, ONE_TRI
    ),
    ("one_sided", "al_shawa", "q"): ScaleFreeLaw((-0.323, 2.249, 0.223, 0.356), 0.72, 0.149, 0.164, PI_RANGE, ONE_TRI),
    ("one_sided", "al_shawa", "q_slv"): ScaleFreeLaw(
        (-0.262, 1.806, 0.075, 0.557), 0.72, 0.15, 0.165, PI_RANGE, ONE_TRI
    ),
}
"""(mechanism, moment law, quantity) -> the fits of `--study law` (resources/docs/paper.md, section 3)."""
