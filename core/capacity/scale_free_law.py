"""Ribalta's law: q of a wall from its velocity ratio and Lambda (`scaled_intensity`) alone. A research output, never
part of a verdict (resources/docs/paper.md, section 3)."""

import functools
import json
import math
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from core.capacity.regression import least_squares_of
from core.ground.response_spectrum import SCALED_PERIODS
from core.text.sentence import Number, Sentence, sentence
from core.wall.block import Block
from core.wall.impact import Restitution
from core.wall.kinematics import kinematics
from core.wall.moment_rotation import LAWS, MomentLaw
from core.wall.restitution import overturning_velocity

Coefficients = tuple[float, float, float, float]


@dataclass(frozen=True)
class Ends:
    """Shares of ln(q / law) about the law, rising: what holds at a Lambda, and at a velocity ratio, is told apart.

    scaled, loss : Lambda and s = sqrt(1 - e) at which they were counted, rising
    by_scaled, by_loss : ln(q / law) there, a row each: the values that growing shares of the cases are below
    """

    scaled: tuple[float, ...]
    by_scaled: tuple[tuple[float, ...], ...]
    loss: tuple[float, ...]
    by_loss: tuple[tuple[float, ...], ...]

    def at(self, scaled: float, loss: float) -> tuple[float, ...]:
        """The shares at Lambda and s, linear in ln Lambda and in s: of both countings the lower one, of the last the
        upper one."""
        x, nodes = math.log(scaled), np.log(self.scaled)
        one = [float(np.interp(x, nodes, column)) for column in zip(*self.by_scaled, strict=True)]
        other = [float(np.interp(loss, self.loss, column)) for column in zip(*self.by_loss, strict=True)]
        *low, high = zip(one, other, strict=True)
        return *map(min, low), max(high)


@dataclass(frozen=True)
class ScaleFreeLaw:
    """q = limit + exp(a0 + a1 s) Lambda^-(b0 + b1 s), s = sqrt(1 - e): fitted on means of ten generated motions.

    coefficients : a0, a1, b0, b1
    limit : q of a motion much longer than the wall's own time, 1 of the rigid law, the plateau of a trilinear one
    scaled_range, loss_range : of Lambda and of s in the fit
    sets : of the means of sets of a shape left out, 5 and 95 %
    record : of natural records, each event alike, 5, 16 and 95 %; None where none were run
    record_loss : range of s in which the shares of natural records hold
    """

    coefficients: Coefficients
    limit: float
    scaled_range: tuple[float, float]
    loss_range: tuple[float, float]
    sets: Ends
    record: Ends | None = None
    record_loss: tuple[float, float] = (0.0, 1.0)

    def q(self, scaled, velocity_ratio):
        """q [-] at Lambda and e [-], numbers or arrays."""
        return law_value(self.coefficients, self.limit, scaled, np.sqrt(1.0 - np.asarray(velocity_ratio)))

    def _about(self, ends: Ends, scaled: float, velocity_ratio: float) -> tuple[float, ...]:
        """q at some ends; under the rigid law not below 1."""
        q, least = float(self.q(scaled, velocity_ratio)), self.limit if self.limit == 1.0 else 0.0
        return tuple(max(q * math.exp(end), least) for end in ends.at(scaled, math.sqrt(1.0 - velocity_ratio)))

    def interval(self, scaled: float, velocity_ratio: float) -> tuple[float, float]:
        """Range of q that holds the mean of a set of compatible motions in nine cases of ten, and single natural
        records less often (resources/docs/paper.md, section 3)."""
        low, high = self._about(self.sets, scaled, velocity_ratio)
        return low, high

    def record_values(self, scaled: float, velocity_ratio: float) -> tuple[float, float, float] | None:
        """q that one natural record in twenty, and one in six, stay below, and that one in twenty exceeds; None where
        none were run."""
        low, high = self.record_loss
        if self.record is None or not low <= math.sqrt(1.0 - velocity_ratio) <= high:
            return None
        least, sixth, most = self._about(self.record, scaled, velocity_ratio)
        return least, sixth, most

    def holds(self, scaled: float, velocity_ratio: float) -> bool:
        """Whether this is within the range of the fit."""
        loss = math.sqrt(1.0 - velocity_ratio)
        low, high = self.loss_range
        return self.scaled_range[0] <= scaled <= self.scaled_range[1] and low <= loss <= high


@dataclass(frozen=True)
class Estimate:
    """q of the law for one wall and motion. quantity : "q" or "q_slv"; both_signs : of each motion it is the lower of
    both; low, high : nine sets of ten lie between;
    within : inside the range of the fit; record_low, record_high : nine natural records of ten lie between, one in
        twenty below; record_sixth : one in six is below. Of q_slv these two are its design values."""

    quantity: str
    q: float
    low: float
    high: float
    scaled: float
    within: bool
    both_signs: bool
    record_low: float | None = None
    record_sixth: float | None = None
    record_high: float | None = None

    @property
    def ranges(self) -> list[Sentence]:
        """Which interval is which, in words; a design value rounded down, as no other is safe."""
        said = [sentence("added", "law_of_a_set", low=_down(self.low), high=Number(self.high))]
        if self.record_low is not None and self.record_sixth is not None and self.record_high is not None:
            low, sixth = _down(self.record_low), _down(self.record_sixth)
            said.append(sentence("added", "law_of_one_record", low=low, high=Number(self.record_high)))
            if self.quantity == "q_slv" and self.within:
                said.append(sentence("added", "law_design", low=low, sixth=sixth))
        if self.both_signs:
            said.append(sentence("added", "law_both_signs"))
        return said if self.within else [*said, sentence("added", "law_outside")]


def _down(value: float) -> Number:
    return Number(math.floor(100.0 * value + 1e-9) / 100.0)


def within(law: ScaleFreeLaw, mechanism: str, p2: float, scaled: float, velocity_ratio: float) -> bool:
    """Whether a wall is within the range of a fit, the band of Lambda of a tall one within its periods."""
    return law.holds(scaled, velocity_ratio) and BANDS[mechanism][1] / math.sqrt(p2) <= float(SCALED_PERIODS[-1])


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
        law_of_q = law_of(one_sided, law, quantity)
        if law_of_q is not None:
            inside = within(law_of_q, mechanism, block.p2, scaled, ratio)
            q, (low, high) = float(law_of_q.q(scaled, ratio)), law_of_q.interval(scaled, ratio)
            for one in estimated:  # q_slv: the two fits may cross by 2 %, the quantities cannot, nor those of a record
                q, low, high = min(q, one.q), min(low, one.low), min(high, one.high)
            ends = law_of_q.record_values(scaled, ratio)
            of_q = (of_q and ends and (min(of_q[0], ends[0]), min(of_q[1], ends[1]), min(of_q[2], ends[2]))) or ends
            estimated.append(Estimate(quantity, q, low, high, scaled, inside, one_sided, *(of_q or (None, None, None))))
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
    return None if name is None else fitted().get(("one_sided" if one_sided else "two_sided", name, quantity))


RESULTS = Path(__file__).resolve().parents[2] / "resources" / "studies" / "law.results.json"
"""What `--study law` found (core/lab/research/page.py keeps it)."""

TRILINEAR_TO = 3.8
"""Lambda beyond which the fits of trilinear walls that rock to both sides fail: q may be below the plateau."""


def law_from(stored: dict[str, Any]) -> ScaleFreeLaw:
    """A law as the study stores it, its ranges in three digits: they hold up to half of the last one."""

    def wide(name: str) -> tuple[float, float]:
        low, high = stored[name]
        return low - 0.5e-3, high + 0.5e-3

    def ends(kept: dict[str, Any]) -> Ends:
        rows = (tuple(tuple(row) for row in kept[name]) for name in ("by_scaled", "by_loss"))
        by_scaled, by_loss = rows
        return Ends(tuple(kept["scaled"]), by_scaled, tuple(kept["loss"]), by_loss)

    return ScaleFreeLaw(
        tuple(stored["coefficients"]),
        stored["limit"],
        wide("scaled_range"),
        wide("loss_range"),
        ends(stored["sets"]),
        ends(stored["record"]) if stored["record"] else None,
        wide("record_loss"),
    )


@functools.cache
def fitted() -> dict[tuple[str, str, str], ScaleFreeLaw]:
    """(mechanism, moment law, quantity) -> the fits of `--study law` (resources/docs/paper.md, section 3)."""
    laws = {}
    for name, stored in json.loads(RESULTS.read_text(encoding="utf-8"))["fits"].items():
        mechanism, moment, quantity = name.split()
        law = law_from(stored)
        if kinematics(mechanism).both_ways and moment != "rigid":
            law = replace(law, scaled_range=(law.scaled_range[0], min(TRILINEAR_TO, law.scaled_range[1])))
        if quantity in ("q", "q_slv"):
            laws[mechanism, moment, quantity] = law
    return laws
