"""Ribalta's law: q of a wall from its velocity ratio and Lambda (`scaled_intensity`) alone. A research output, never
part of a verdict (resources/docs/paper.md, section 3)."""

import math
from dataclasses import dataclass

import numpy as np

from core.capacity.regression import least_squares_of
from core.ground.response_spectrum import SCALED_PERIODS
from core.wall.block import Block
from core.wall.impact import Restitution
from core.wall.moment_rotation import LAWS, MomentLaw
from core.wall.restitution import overturning_velocity

Coefficients = tuple[float, float, float, float]


@dataclass(frozen=True)
class ScaleFreeLaw:
    """q = limit + exp(a0 + a1 s) Lambda^-(b0 + b1 s), s = sqrt(1 - e): fitted on means of ten generated motions.

    coefficients : a0, a1, b0, b1
    limit : q of a motion much longer than the wall's own time, 1 of the rigid law, the plateau of a trilinear one
    scatter_set, scatter_record : standard deviation of ln(law / q), of the mean of a set of a shape left out of the
        fit and of a single motion
    scaled_range, loss_range : of Lambda and of s in the fit
    record : ln(q / law) that one natural record in twenty is below, one in six (16 %) is below, and one in twenty is
        above, each event alike; None where none were run
    """

    coefficients: Coefficients
    limit: float
    scatter_set: float
    scatter_record: float
    scaled_range: tuple[float, float]
    loss_range: tuple[float, float]
    record: tuple[float, float, float] | None = None

    def q(self, scaled, velocity_ratio):
        """q [-] at Lambda and e [-], numbers or arrays."""
        return law_value(self.coefficients, self.limit, scaled, np.sqrt(1.0 - np.asarray(velocity_ratio)))

    def interval(self, scaled: float, velocity_ratio: float) -> tuple[float, float]:
        """Range of q that holds the mean of a set of compatible motions in nine cases of ten, and single natural
        records less often (resources/docs/paper.md, section 3). Under the rigid law not
        below 1."""
        q = float(self.q(scaled, velocity_ratio))
        factor = math.exp(1.645 * self.scatter_set)
        return max(q / factor, self.limit if self.limit == 1.0 else 0.0), q * factor

    def record_values(self, scaled: float, velocity_ratio: float) -> tuple[float, float, float] | None:
        """q that one natural record in twenty, and one in six, stay below, and that one in twenty exceeds; None where
        none were run."""
        if self.record is None:
            return None
        q, least = float(self.q(scaled, velocity_ratio)), self.limit if self.limit == 1.0 else 0.0
        low, sixth, high = (max(q * math.exp(end), least) for end in self.record)
        return low, sixth, high

    def holds(self, scaled: float, velocity_ratio: float) -> bool:
        """Whether this is within the range of the fit."""
        loss = math.sqrt(1.0 - velocity_ratio)
        low, high = self.loss_range
        return self.scaled_range[0] <= scaled <= self.scaled_range[1] and low <= loss <= high


@dataclass(frozen=True)
class Estimate:
    """q of the law for one wall and motion. quantity : "q" or "q_slv"; low, high : nine sets of ten lie between;
    within : inside the range of the fit; record_low, record_high : nine natural records of ten lie between, one in
        twenty below; record_sixth : one in six is below. Of q_slv these two are its design values."""

    quantity: str
    q: float
    low: float
    high: float
    scaled: float
    within: bool
    record_low: float | None = None
    record_sixth: float | None = None
    record_high: float | None = None


def estimates(
    block: Block, restitution: Restitution, law: MomentLaw, one_sided: bool, integral: np.ndarray, pga: float
) -> tuple[Estimate, ...]:
    """q and q_slv of the law; none for a moment law it was not fitted on. integral : of the pseudo-velocity up to each
    of SCALED_PERIODS [m]; pga [m/s2]."""
    mechanism = "one_sided" if one_sided else "two_sided"
    scaled, ratio = scaled_intensity(block.p2, integral, pga, mechanism), loss_ratio(block, restitution)
    estimated: list[Estimate] = []
    of_q: tuple[float, float, float] | None = None
    for quantity in ("q", "q_slv"):
        fitted = law_of(one_sided, law, quantity)
        if fitted is not None:
            beyond = BANDS[mechanism][1] / math.sqrt(block.p2) > SCALED_PERIODS[-1]
            within = fitted.holds(scaled, ratio) and not beyond
            q, (low, high) = float(fitted.q(scaled, ratio)), fitted.interval(scaled, ratio)
            for one in estimated:  # q_slv: the two fits may cross by 2 %, the quantities cannot, nor those of a record
                q, low, high = min(q, one.q), min(low, one.low), min(high, one.high)
            ends = fitted.record_values(scaled, ratio)
            of_q = (of_q and ends and (min(of_q[0], ends[0]), min(of_q[1], ends[1]), min(of_q[2], ends[2]))) or ends
            estimated.append(Estimate(quantity, q, low, high, scaled, within, *(of_q or (None, None, None))))
    return tuple(estimated)


def law_value(coefficients, limit: float, scaled, loss):
    """limit + exp(a0 + a1 s) x^-(b0 + b1 s), x = Lambda, of a rival another number."""
    a0, a1, b0, b1 = coefficients
    return limit + np.exp(a0 + a1 * loss - (b0 + b1 * loss) * np.log(scaled))


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

    p2 : [1/s2]; integral : `velocity_integral` of the motion [m]; pga [m/s2]; mechanism : whose band is taken, up to
        the last of SCALED_PERIODS: of walls of some 30 m and more a part of it is missing
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


def fit_law(scaled, loss, q, limit: float) -> Coefficients:
    """Coefficients by least squares of ln(law / q). scaled, loss, q : [-], shape (n,)."""

    def residual(coefficients):
        return np.log(law_value(coefficients, limit, scaled, loss) / q)

    a0, a1, b0, b1 = map(float, least_squares_of(residual, (0.0,) * 4))
    return a0, a1, b0, b1


def law_of(one_sided: bool, law: MomentLaw, quantity: str) -> ScaleFreeLaw | None:
    """The fitted law of a mechanism, a named moment law and "q" or "q_slv"; None for another moment law."""
    name = next((name for name, known in LAWS.items() if known == law), None)
    return None if name is None else FITTED.get(("one_sided" if one_sided else "two_sided", name, quantity))


TWO_SIDED, ONE_SIDED = (0.22, 8.5), (0.20, 4.4)
TWO_SIDED_TRI = (0.22, 3.8)
TWO, ONE = (0.042, 0.466), (0.042, 0.919)
TWO_TRI, ONE_TRI = (0.042, 0.419), (0.709, 0.883)
"""Ranges of Lambda and of s in which the fits hold; two-sided trilinear ones fail beyond 3.8, where q may be below the
plateau."""

FITTED: dict[tuple[str, str, str], ScaleFreeLaw] = {
    ("two_sided", "rigid", "q"): ScaleFreeLaw(
        (0.755, 3.167, 1.733, -0.869), 1.0, 0.119, 0.182, TWO_SIDED, TWO, (-0.318, -0.172, 0.508)
    ),
    ("two_sided", "rigid", "q_slv"): ScaleFreeLaw(
        (-0.173, 3.722, 1.744, -1.176), 1.0, 0.083, 0.146, TWO_SIDED, TWO, (-0.169, -0.058, 0.653)
    ),
    ("two_sided", "doherty", "q"): ScaleFreeLaw(
        (1.056, 2.922, 1.974, -1.217), 0.72, 0.291, 0.352, TWO_SIDED_TRI, TWO_TRI
    ),
    ("two_sided", "doherty", "q_slv"): ScaleFreeLaw(
        (0.148, 3.189, 2.119, -1.852), 0.72, 0.309, 0.368, TWO_SIDED_TRI, TWO_TRI
    ),
    ("two_sided", "al_shawa", "q"): ScaleFreeLaw(
        (0.988, 3.037, 1.952, -1.214), 0.72, 0.277, 0.332, TWO_SIDED_TRI, TWO_TRI
    ),
    ("two_sided", "al_shawa", "q_slv"): ScaleFreeLaw(
        (0.017, 3.516, 2.12, -1.955), 0.72, 0.297, 0.345, TWO_SIDED_TRI, TWO_TRI
    ),
    ("one_sided", "rigid", "q"): ScaleFreeLaw(
        (-0.54, 2.787, 0.918, -0.204), 1.0, 0.085, 0.114, ONE_SIDED, ONE, (-0.318, -0.211, 0.172)
    ),
    ("one_sided", "rigid", "q_slv"): ScaleFreeLaw(
        (-0.751, 2.696, 0.684, 0.057), 1.0, 0.107, 0.127, ONE_SIDED, ONE, (-0.273, -0.177, 0.233)
    ),
    ("one_sided", "doherty", "q"): ScaleFreeLaw((-0.329, 2.301, 0.505, 0.386), 0.72, 0.077, 0.111, ONE_SIDED, ONE_TRI),
    ("one_sided", "doherty", "q_slv"): ScaleFreeLaw(
        (-0.302, 1.864, 0.355, 0.614), 0.72, 0.092, 0.123, ONE_SIDED, ONE_TRI
    ),
    ("one_sided", "al_shawa", "q"): ScaleFreeLaw((-0.275, 2.302, 0.432, 0.437), 0.72, 0.075, 0.109, ONE_SIDED, ONE_TRI),
    ("one_sided", "al_shawa", "q_slv"): ScaleFreeLaw(
        (-0.246, 1.902, 0.204, 0.736), 0.72, 0.089, 0.118, ONE_SIDED, ONE_TRI
    ),
}
"""(mechanism, moment law, quantity) -> the fits of `--study law` (resources/docs/paper.md, section 3)."""
