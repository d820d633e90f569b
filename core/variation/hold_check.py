"""What holds a wall that bends, compared with what the wall hands to it: by the clauses at their acceleration, by
histories along the motions. A reaction is never divided by q."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from core.boundary import narrowed
from core.codes.demand import SeismicDemand
from core.codes.dynamic_check import DynamicCheck
from core.codes.kinematic import HOLD_CLAUSE, ZETA_ROUNDING, Check, KinematicAnalysis
from core.mechanism.bending_reactions import spring_force
from core.mechanism.holds import FOOT, TOP, HoldLimit, force_beside
from core.setting.check_input import CheckInput
from core.units import G

BY_CLAUSES, BY_HISTORIES = "kinematic", "dynamic"
"""Whose push asks a hold: that of the clauses, linear and displacement check alike, or that of the histories."""

STEP, IMPULSE_STEP = 0.01, 0.05
"""Steps of the shares of the demand at which histories are followed to where a hold gives way [of the share]."""

NEAR = 1e-4
"""How near a share is narrowed [of it]."""

BEYOND_BOUND = 1.3
"""Multiple of the share up to which a hold stands by the bound to which its histories are followed."""


class HoldState(NamedTuple):
    """A hold under the demand, by the clauses or by histories.

    share : of the demand up to which it holds [-], inf where it does as far as was looked; alpha : largest push of the
        demand [-]
    asked, stands : at the demand [N/m]
    impulse : with which the wall pulls at it as it comes back from inward, at the demand [N s/m]; None where what holds
        has neither an elongation nor a stiffness, which has to take it
    """

    limit: HoldLimit
    check: str
    share: float
    alpha: float
    asked: float
    stands: float
    impulse: float | None = None


class Reaction(NamedTuple):
    """What a hold of a wall takes.

    hold : HoldLimit.hold; direction : of the motion that asks most of it, "outward" or "inward"
    check : of `HoldState`
    at_demand, at_zeta : at the demand and at zeta of the check that decides [N/m]; stands : at the demand [N/m], None
        of what stands behind a wall that turns, which is printed as asked
    gives_way : share of the demand up to which it holds [-], None of what is not compared
    impulse : of `HoldState`; on what stands behind a wall that turns at most
    """

    hold: str
    direction: str
    check: str
    at_demand: float
    at_zeta: float | None
    stands: float | None
    gives_way: float | None
    impulse: float | None


def look_at_holds(
    scene: CheckInput, kinematic: KinematicAnalysis, dynamic: DynamicCheck | None
) -> tuple[HoldState, ...]:
    """The holds of a wall that bends, what gives way first at the head; none of a wall whose holds have no strength,
    and none where no push is known."""
    if not scene.hold_limits:
        return ()
    states: list[HoldState] = []
    if kinematic.acceleration_demand is not None:
        alpha = kinematic.acceleration_demand / G
        states += [_state(scene, limit, BY_CLAUSES, alpha, limit.share(alpha)) for limit in scene.hold_limits]
    if dynamic is not None and scene.motions:
        states += _Followed(scene, dynamic).states()
    return tuple(sorted(states, key=lambda state: state.share))


def _state(scene: CheckInput, limit: HoldLimit, check: str, alpha: float, share: float) -> HoldState:
    asked, stands = scene.find_reaction(limit, alpha), scene.find_strength(limit, alpha)
    if share < 1.0:  # it was asked for all that it stands at rest, before the mechanism that the demand makes move
        asked = max(asked, stands)
    return HoldState(limit, check, share, alpha, asked, stands)


@dataclass(frozen=True)
class _Followed:
    """The holds of a wall along its histories: by the bound of what moves, and, where that says that a hold gives way
    below what is required, by the histories themselves."""

    scene: CheckInput
    dynamic: DynamicCheck

    def states(self) -> list[HoldState]:
        """Those of each hold, and of the impulses on what holds the top."""
        alpha, target = find_motion_push(self.scene.demand, self.scene), self.scene.demand.zeta_target
        found = []
        for limit in self.scene.hold_limits:
            share = limit.share(alpha)
            if share < target - ZETA_ROUNDING and self._is_moved(limit):
                share = self._share_in_histories(limit, share)
            found.append(_state(self.scene, limit, BY_HISTORIES, alpha, share))
        return [*found, *self._impulse_states(alpha)]

    def _is_moved(self, limit: HoldLimit) -> bool:
        """Whether histories say what a hold takes: of one that a wall at rest overcomes, and of ends, the push does."""
        wall, moving = self.scene.moving_to(limit.side)
        return limit.hold in (TOP, FOOT) and wall.arch is None and limit.push > moving.alpha0

    def _share_in_histories(self, limit: HoldLimit, least: float) -> float:
        """Share of the demand up to which a hold stands what the histories hand to it, from the one on up to which the
        bound says it does."""
        share = least
        while share < BEYOND_BOUND * least:
            later = share * (1.0 + STEP)
            if reaction_in_histories(self.scene, limit, later) > limit.stands:
                break
            share = later
        else:
            return share
        return narrowed(
            lambda part: reaction_in_histories(self.scene, limit, part) <= limit.stands, share, later, NEAR
        )[0]

    def _impulse_states(self, alpha: float) -> list[HoldState]:
        """The impulses on what holds the top, where it has a stiffness or yields."""
        limit = next((limit for limit in self.scene.hold_limits if limit.hold == TOP and not limit.presses), None)
        if limit is None:
            return []
        wall, _ = self.scene.moving_to(limit.side)
        declared, histories = wall.declared, self.scene.held_histories
        if declared.elongation is None and declared.stiffness is None:
            return []

        def asked(share: float) -> float:
            """Strength with which the impulses are taken [N/m]: a hold that yields stays stretched from one to the
            next."""
            largest, together = histories.impulses(share)
            if declared.elongation is not None:
                return together**2 / (2.0 * histories.top_mass * declared.elongation)
            return spring_force(largest, declared.stiffness or 0.0, histories.top_mass)

        before, share = histories.starts_at, math.inf  # of what is looked at nothing gives way
        for place in self._shares_looked_at(histories.starts_at):
            if asked(place) > limit.stands:
                share = before
                break
            before = place
        state = HoldState(limit, BY_HISTORIES, share, alpha, asked(1.0), limit.stands)
        return [state._replace(impulse=histories.impulses(1.0)[0])]

    def _shares_looked_at(self, least: float) -> list[float]:
        """Shares of the demand at which impulses are followed: up to zeta of the histories, the demand and what is
        required among them. least : below which the wall does not move"""
        most = self.dynamic.zeta or 0.0
        count = math.ceil(math.log(most / least) / math.log1p(IMPULSE_STEP)) if most > least > 0.0 else 0
        places = [least * (1.0 + IMPULSE_STEP) ** k for k in range(count)]
        return sorted({*places, *(share for share in (1.0, self.scene.demand.zeta_target) if least < share <= most)})


def find_motion_push(demand: SeismicDemand, scene: CheckInput) -> float:
    """Largest push of the motions at the demand [-]."""
    return max(demand.scaling(motion) * motion.pga for motion in scene.motions) / G


def reaction_in_histories(scene: CheckInput, limit: HoldLimit, share: float) -> float:
    """Largest force [N/m] on a hold along the histories at a share of the demand, with what goes to it beside the wall.
    What presses a floor inward pulls nothing: its strength outward is compared with what pulls."""
    wall, _ = scene.moving_to(limit.side)
    pulled, pushed = scene.held_histories.largest(share, at_base=limit.hold == FOOT)
    alpha = share * find_motion_push(scene.demand, scene)
    beside = force_beside(wall, alpha) if limit.hold == TOP else 0.0
    return (pushed if limit.presses else pulled) + beside


def check_of_holds(states: Sequence[HoldState], demand: SeismicDemand) -> Check | None:
    """The check of what holds a wall: of all that hold it the one that gives way first. None without one."""
    if not states or not math.isfinite(states[0].share):
        return None
    first = states[0]
    passed = first.share >= demand.zeta_target - ZETA_ROUNDING
    return Check("hold", HOLD_CLAUSE, "kN/m", 1e-3 * first.stands, 1e-3 * first.asked, first.share, passed)


def find_open_impulse(scene: CheckInput, dynamic: DynamicCheck | None) -> tuple[float, float] | None:
    """(the largest impulse [N s/m] at the demand on a hold at the top of which nobody says how stiff or ductile it is,
    the stiffness [N/m2] up to which it stands it); None where there is none."""
    limit = next((limit for limit in scene.hold_limits if limit.hold == TOP and not limit.presses), None)
    if limit is None or dynamic is None or not scene.motions or not math.isfinite(limit.stands):
        return None
    declared, histories = scene.moving_to(limit.side)[0].declared, scene.held_histories
    if declared.elongation is not None or declared.stiffness is not None:
        return None
    largest = histories.impulses(1.0)[0]
    return (largest, histories.top_mass * (limit.stands / largest) ** 2) if largest > 0.0 else None


def find_reactions(
    scene: CheckInput, states: Sequence[HoldState], zeta: float | None, dynamic: DynamicCheck | None
) -> tuple[Reaction, ...]:
    """Reactions of the holds of a wall, along its histories those of the histories. zeta : of the check that decides"""

    def taken(state: HoldState, share: float) -> float:
        moved = state.check == BY_HISTORIES and state.limit.hold in (TOP, FOOT)
        followed = dynamic is not None and dynamic.zeta is not None and share <= max(1.0, dynamic.zeta)
        if moved and followed and share * state.alpha > _start(scene, state):
            return reaction_in_histories(scene, state.limit, share)
        return scene.find_reaction(state.limit, share * state.alpha)

    known = zeta is not None and math.isfinite(zeta)
    return tuple(
        Reaction(
            state.limit.hold,
            state.limit.side,
            state.check,
            state.asked if state.impulse is not None else taken(state, 1.0),
            taken(state, zeta) if known and zeta is not None and state.impulse is None else None,
            state.stands,
            state.share if math.isfinite(state.share) else None,
            state.impulse,
        )
        for state in states
    )


def _start(scene: CheckInput, state: HoldState) -> float:
    """alpha_0 of a wall to the side of a hold [-]."""
    return scene.moving_to(state.limit.side)[1].alpha0
