"""A wall about one hinge, by one mechanism, under one demand: all that its checks follow from."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

from core.case.mechanisms.mechanism import Moving
from core.case.mechanisms.registry import how_it_moves
from core.case.schema import Generate
from core.case.site import Building, Demand
from core.case.wall import Wall
from core.codes.demand import SeismicDemand, complete_with_records
from core.codes.dynamic_check import run_dynamic_check
from core.codes.elastic_branch import Branch, branches_of, wants_branch
from core.codes.kinematic import KinematicAnalysis, analyse_mechanism
from core.codes.record_compatibility import Compliance, check_compatibility
from core.codes.vertical_bending import HingeAt, hinges_in_histories
from core.ground.ground_motion import GroundMotion
from core.known import require_value
from core.mechanism.bending_reactions import MovingStrip
from core.mechanism.holds import (
    BASE,
    ENDS,
    FOOT,
    INWARD,
    STUB,
    HoldLimit,
    force_on_top,
    reaction_of_base,
    reaction_of_foot,
)
from core.mechanism.sections import Sections
from core.rocking.methods import Method
from core.setting.demand_input import find_generation_settings, generate_requested_motions
from core.setting.floors import Floor, make_floor
from core.setting.held_histories import HeldHistories
from core.text.sentence import Sentence
from core.wall.kinematics import Kinematics, kinematics
from core.wall.masonry import Masonry
from core.wall.rocking_model import RockingModel


def _reaction(wall: Masonry, moving: MovingStrip, limit: HoldLimit, alpha: float) -> float:
    """What a hold of a wall takes [N/m] under pushes up to alpha [-]. moving : its strip"""
    if limit.hold == ENDS:
        return 0.5 * (alpha + moving.strip.pressed) * moving.strip.weight
    if limit.hold == STUB and (stub := wall.declared.stub) is not None:
        return alpha * stub.factor * stub.weight
    sections = Sections(wall)
    if limit.hold == FOOT:
        return reaction_of_foot(sections, moving, alpha)
    if limit.hold == BASE:
        return reaction_of_base(sections, moving, alpha, limit.side)
    return force_on_top(sections, moving, alpha)


def make_rocking_model(wall: Wall, mechanism: str) -> RockingModel:
    """The rocking model of a wall. Raises InputError."""
    return how_it_moves(wall).motion(wall, mechanism)


def select_polarities(model: RockingModel, asked: str) -> tuple[int, ...]:
    """Signs of the records: one where both do the same to the wall."""
    if model.both_signs_alike or asked == "as_recorded":
        return (1,)
    return (-1,) if asked == "reversed" else (1, -1)


def rescale_records(
    ground: Sequence[GroundMotion], demand: SeismicDemand, there: SeismicDemand
) -> Sequence[GroundMotion]:
    """The records of a demand as they follow another one: where they are used as given, in proportion to a_g S."""
    factor = there.pga / demand.pga if there.record_scaling == "as_given" else 1.0
    if factor == 1.0:
        return ground
    return [replace(motion, acceleration=factor * motion.acceleration) for motion in ground]


@dataclass(frozen=True)
class CheckInput:
    """A wall with its mechanism, its demand and its motions: all that its checks follow from.

    wall : of the case, about its hinge
    demand : with what the records add; asked : of the case
    building : None without [building]; floor : that the wall stands on, None on the ground
    ground : the records; compliance : of them with the spectrum, None without a spectrum
    polarity : of [analysis]
    by_default : the records are generated for want of given ones: they may lower an outcome, never raise it
    histories_off : none are to be made; beside : they stand beside the check of the clauses that decides
    q_slv : of the searches of this very wall, the one its linear check takes and itself; None where none was made
    histories : `run_dynamic_check`, or one that keeps its results
    left_out : of `Circumstances`
    """

    wall: Wall
    mechanism: str
    demand: SeismicDemand
    asked: Demand
    building: Building | None
    floor: Floor | None
    ground: tuple[GroundMotion, ...]
    compliance: Compliance | None
    polarity: str
    method: Method
    by_default: bool
    histories_off: bool
    q_slv: tuple[float | None, float | None] = (None, None)
    histories: Callable[..., Any] = run_dynamic_check
    left_out: tuple[Sentence, ...] = ()
    beside: bool = False

    @property
    def kinematics(self) -> Kinematics:
        """What its mechanism does."""
        return kinematics(self.mechanism)

    @cached_property
    def model(self) -> RockingModel:
        return make_rocking_model(self.wall, self.mechanism)

    @cached_property
    def branches(self) -> tuple[Branch | HingeAt, ...]:
        """What the histories are made with, of which the worst decides: the elastic branches of an element free to
        vibrate, the hinges of a wall held at its top. Empty of another wall. Raises InputError."""
        if self.wall.bends:
            moved = self.kinematic.moved.bending if self.kinematic else None
            return hinges_in_histories(self.model, moved)
        if not wants_branch(self.wall.in_si, self.mechanism) or not self.wall.moment_law().is_rigid:
            return ()
        return branches_of(self.wall.in_si, self.mechanism, self.model)

    @cached_property
    def _moving(self) -> Moving:
        """The walls whose holds may be asked most, to each side."""
        return how_it_moves(self.wall).moving(self.wall)

    def moving_to(self, side: str) -> tuple[Masonry, MovingStrip]:
        """A wall that bends as it moves to a side of a hold limit, its ties that have yielded slack, and its strip."""
        return self._moving[side][0]

    @cached_property
    def held_histories(self) -> HeldHistories:
        """What it hands to its holds along its histories."""
        moved = ((motion, sign * self.demand.scaling(motion)) for motion in self.motions for sign in self.signs)
        return HeldHistories(self.model, tuple(moved), self.method)

    @cached_property
    def hold_limits(self) -> tuple[HoldLimit, ...]:
        """Limits of what holds a wall that bends; none of what has no strength."""
        return how_it_moves(self.wall).hold_limits(self._moving)

    def find_strength(self, limit: HoldLimit, alpha: float) -> float:
        """What a hold stands [N/m] under pushes up to alpha [-]."""
        arch = self.moving_to(limit.side)[0].arch
        return limit.stands if arch is None else arch.under(alpha).held_across

    def find_reaction(self, limit: HoldLimit, alpha: float) -> float:
        """What a hold takes [N/m] under pushes up to alpha [-]."""
        return max(_reaction(wall, moving, limit, alpha) for wall, moving in self._moving[limit.side])

    @property
    def signs(self) -> tuple[int, ...]:
        """Signs each record is taken with, 1 as recorded, -1 reversed."""
        return select_polarities(self.model, self.polarity)

    @property
    def motions(self) -> list[GroundMotion]:
        """The records as they move the wall."""
        return list(self.floor.motions if self.floor else self.ground)

    @property
    def kinematic(self) -> KinematicAnalysis | None:
        """Kinematic checks of the wall, of one that bends to the side on which it fares worse; None above the ground
        where the building is not known. Raises InputError."""
        return self._weaker_side[1]

    @property
    def bends_inward(self) -> bool:
        """Whether the checks of the clauses are of a wall held at its top as it bends inward."""
        return self._weaker_side[0] == INWARD

    @cached_property
    def _weaker_side(self) -> tuple[str, KinematicAnalysis | None]:
        """The side to which a wall moves with the lesser zeta of the displacement check, else alpha_0, and its
        analysis."""
        if self.wall.above_ground and self.floor is None:
            return "outward", None
        spectrum, walls = (
            self.floor.spectrum if self.floor else None,
            how_it_moves(self.wall).walls_of_checks(self.wall),
        )
        found = {side: analyse_mechanism(wall, self.mechanism, self.demand, spectrum) for side, wall in walls.items()}
        compared = [analysis.displacement for analysis in found.values()]
        if None in compared:
            side = min(found, key=lambda name: found[name].alpha0)
        else:
            side = min(found, key=lambda name: require_value(found[name].displacement).ratio)
        return side, found[side]

    def replace_parts(self, **changes: Any) -> "CheckInput":
        """The scene with some of its parts changed: q of the searches goes, and the floor is that of the changed
        building, height and demand. Raises InputError."""
        there = replace(self, **({"q_slv": (None, None)} | changes))
        if "floor" in changes or there._felt == self._felt:
            return there
        return replace(there, floor=make_floor(there.wall, there.building, there.demand, there.ground))

    def with_demand(self, demand: SeismicDemand) -> "CheckInput":
        """The scene under another demand: motions generated for its spectrum are generated for the new one, records
        used as given follow a_g S. Raises InputError."""
        asked = find_generation_settings(self.ground)
        followed = rescale_records(self._given if asked else self.ground, self.demand, demand)
        ground = (*followed, *(generate_requested_motions(asked, demand) if asked else ()))
        return self.replace_parts(demand=complete_with_records(demand, list(ground)), ground=ground)

    def regenerate_motions(self, asked: Generate) -> "CheckInput":
        """The scene under another generated set, beside the records that are given. Raises InputError."""
        made, longest = (
            generate_requested_motions(asked, self.demand),
            self.compliance.longest if self.compliance else 0.0,
        )
        ground = [*self._given, *made]
        demand, kinds = (
            complete_with_records(self.demand, ground),
            ["natural"] * len(self._given) + ["artificial"] * len(made),
        )
        return self.replace_parts(
            ground=tuple(ground), demand=demand, compliance=check_compatibility(ground, kinds, demand, longest)
        )

    @property
    def _given(self) -> list[GroundMotion]:
        """The records that are not generated."""
        return [motion for motion in self.ground if motion.format != "generated"]

    @property
    def _felt(self) -> tuple:
        """Quantities that the motion under the wall follows from."""
        wall, demand = self.wall, self.demand
        place = (wall.above_ground, wall.demand_height_m, wall.bends, self.building)
        return *place, demand.limit_state, demand.pga, id(demand.target), tuple(map(id, self.ground))

    def without_records(self) -> "CheckInput":
        """The scene without its records, for the checks of the clauses alone."""
        return self.replace_parts(ground=()) if self.ground else self
