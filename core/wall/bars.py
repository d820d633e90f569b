"""Tie bars on a rocking wall: elastic, perfectly plastic, in tension only, gone beyond the elongation they stand
(AlShawa, Liberatore, Liberatore, Mollaioli, Sorrentino 2019, doi 10.1080/15583058.2018.1563226;
resources/docs/physics.md, section 18).

A bar at a height h is longer by u = h sin(theta) when the wall has turned outward by theta: elongations are kept as
sines, u / h, and forces as moments, over the weight times the radius of the wall, so that no kernel needs a unit.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from core.jit.decorators import subkernel
from core.wall.moment_rotation import NEVER_REACHED

HEIGHT, STIFFNESS, YIELD, START, BREAK = range(5)
"""Columns of the array of bars: those of `Bar`."""


class Bar(NamedTuple):
    """A bar of one wall, as the kernels take it.

    height : above the hinge [m]
    stiffness : k h^2 over m g R [-]; times an elongation and cos(theta) it is the moment of the bar
    yield_sine : elongation at yield over the height [-]
    start_sine : residual elongation at the start: positive slack, negative for a prestress [-]
    break_sine : elongation beyond which it is gone [-]
    """

    height: float
    stiffness: float
    yield_sine: float
    start_sine: float
    break_sine: float


@dataclass(frozen=True)
class TieBar:
    """A bar for a metre of wall.

    height : above the hinge [m]; strength : force at yield [N/m]; elongation_at_yield : [m]
    slack : positive, or negative for a prestress [m]
    stands : elongation from its unstressed length beyond which it is gone; not below that at yield [m]
    """

    height: float
    strength: float
    elongation_at_yield: float
    slack: float
    stands: float

    @property
    def breaks_at(self) -> float:
        """u = h sin(theta) at which it is gone [m]: a slack bar is counted on no further than one without slack, the
        safe side, but to its yield."""
        return max(self.stands + min(self.slack, 0.0), self.slack + self.elongation_at_yield)

    @property
    def ends(self) -> tuple[float, float, float]:
        """u [m] at which it is taut, yields and breaks, on its first way out."""
        return max(self.slack, 0.0), max(self.slack + self.elongation_at_yield, 0.0), self.breaks_at

    def force_at(self, theta: float) -> float:
        """Force of the bar [N/m] on its first way out to a rotation [rad]; 0 beyond its end."""
        return self.force_stretched(self.height * math.sin(theta))

    def force_stretched(self, u: float) -> float:
        """Force of the bar [N/m] on its first way out to an elongation [m]; 0 beyond its end."""
        if u > self.breaks_at * (1.0 + 1e-12):
            return 0.0
        return self.strength * min(max((u - self.slack) / self.elongation_at_yield, 0.0), 1.0)

    def scaled(self, moment: float) -> Bar:
        """The bar as the kernels take it. moment : m g R of the wall [N m / m]"""
        return Bar(
            self.height,
            self.strength * self.height**2 / (self.elongation_at_yield * moment),
            self.elongation_at_yield / self.height,
            self.slack / self.height,
            self.breaks_at / self.height,
        )


def bar_rows(bars: Sequence[Bar]) -> np.ndarray:
    """The bars as an array, shape (bars, 5)."""
    return np.array(bars, float).reshape(len(bars), len(Bar._fields))


def forces(bar: TieBar, rotation: np.ndarray, residual: np.ndarray) -> np.ndarray:
    """Force of a bar over time [N/m], after its residual elongation over its height; 0 where it has gone.

    rotation : [rad], outward positive; residual : of `taylor_with_bars`, inf where the bar has gone
    """
    stretched = np.sin(rotation) * bar.height - residual * bar.height
    return bar.strength * np.clip(stretched / bar.elongation_at_yield, 0.0, 1.0) * (rotation >= 0.0)


@subkernel
def angle_of(sine):
    """Rotation of this sine [rad]; FAR where no rotation has it."""
    return math.asin(sine) if sine < 1.0 else NEVER_REACHED


@subkernel
def stored(bar, residual, sine):
    """Elastic energy of a bar at this elongation, over I0 p2 [-]. bar : a row; residual, sine : [-]"""
    stretched = min(max(sine - residual, 0.0), bar[YIELD])
    return 0.5 * bar[STIFFNESS] * stretched * stretched


@subkernel
def work_to(bar, residual, sine):
    """Work an intact bar without force takes until this elongation, over I0 p2 [-]: elastic, then plastic, none beyond
    its end. bar : a row; residual, sine : [-]"""
    stretched = min(sine, bar[BREAK]) - residual
    plastic = max(stretched - bar[YIELD], 0.0)
    return stored(bar, residual, residual + stretched) + bar[STIFFNESS] * bar[YIELD] * plastic
