"""What a wall that bends hands to its holds along its histories: the largest of all motions and signs."""

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from core.codes.vertical_bending import lowest_hinge, model_of_bending
from core.ground.ground_motion import GroundMotion
from core.known import require_value
from core.mechanism.bending_reactions import MovingStrip, impulse, kept_rate, reactions_of_history, speeds_at_return
from core.rocking.history import History, integrate_history
from core.rocking.methods import Method
from core.rocking.outcome import STABLE
from core.units import G
from core.wall.rocking_model import RockingModel


@dataclass(frozen=True)
class HeldHistories:
    """Histories of a wall that bends, at multiples of the demand. No confidence factor weakens it: a stronger wall
    pushes harder.

    model : of the wall; moved : each motion and sign with its scale at the demand
    """

    model: RockingModel
    moved: tuple[tuple[GroundMotion, float], ...]
    method: Method

    @cached_property
    def _hinged(self) -> RockingModel:
        """The wall with the hinge with which it begins to move outward."""
        held = require_value(self.model.bending)
        return model_of_bending(held.outward, held.inward, lowest_hinge(held.outward))

    @cached_property
    def _sides(self) -> tuple[MovingStrip, MovingStrip]:
        """Its strips to both sides."""
        held = require_value(self._hinged.bending)
        return MovingStrip(held.outward, held.h1), MovingStrip(held.inward, held.h1)

    @cached_property
    def _least(self) -> float:
        """Multiplier below which it stays at rest [-]."""
        return min(side.alpha0 for side in self._sides)

    @cached_property
    def _strongest_first(self) -> list[tuple[float, GroundMotion, float]]:
        """(largest push at the demand [-], motion, signed scale)."""
        rows = [(abs(scale) * motion.pga / G, motion, scale) for motion, scale in self.moved]
        return sorted(rows, key=lambda row: -row[0])

    def _follow(self, motion: GroundMotion, scale: float) -> History:
        return integrate_history(motion.acceleration, motion.time_step, scale, self._hinged, self.method)

    def largest(self, share: float, at_base: bool = False) -> tuple[float, float]:
        """Largest reactions [N/m] of the hold at the top, or of the base, at a share of the demand, outward-holding and
        inward-holding. A motion whose bound is below what another one reached is not followed."""
        pulled = pushed = 0.0
        bounded = not self._sides[0].strip.bars  # the bound is of a wall on its holds alone
        for push, motion, scale in self._strongest_first:
            alpha = share * push
            if alpha <= self._least or (bounded and self._most(alpha, at_base) <= min(pulled, pushed)):
                break
            history, ground = self._follow(motion, share * scale), share * scale * motion.acceleration / G
            if history.outcome != STABLE:  # a wall that falls pulls without bound, and its check says that it falls
                continue
            both = reactions_of_history(*self._sides, history, ground, motion.time_step, at_base)
            pulled, pushed = max(pulled, both[0]), max(pushed, both[1])
        return pulled, pushed

    def _most(self, alpha: float, at_base: bool) -> float:
        """Bound of the reactions under pushes up to alpha [-] [N/m]."""
        return max(side.bound(alpha, at_base) for side in self._sides)

    def impulses(self, share: float) -> tuple[float, float]:
        """What a wall that comes back from inward gives to the hold at its top at a share of the demand: the largest
        impulse [N s/m], and the largest root of the sum of the squares of those of one motion, whose work a hold that
        yields has to take."""
        outward, inward = self._sides
        back, largest, together = kept_rate(inward, outward), 0.0, 0.0
        for push, motion, scale in self._strongest_first:
            if share * push <= self._least:
                break
            history = self._follow(motion, share * scale)
            if history.outcome != STABLE:
                continue
            speeds = speeds_at_return(history, motion.time_step, back)
            largest = max(largest, impulse(inward, outward, float(speeds.max(initial=0.0))))
            together = max(together, impulse(inward, outward, math.sqrt(float(np.sum(speeds**2)))))
        return largest, together

    @property
    def starts_at(self) -> float:
        """Share of the demand below which no motion makes the wall move [-]."""
        return self._least / max(self._strongest_first[0][0], 1e-12)

    @property
    def top_mass(self) -> float:
        """m_T [kg/m]."""
        return self._sides[0].top_mass
