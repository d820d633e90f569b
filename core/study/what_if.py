"""zeta of a wall, were one of its inputs another: every check about every hinge, without the search of q."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path

from core.capacity.limit_states import LIMIT_FRACTION
from core.case.rules import with_walls
from core.case.schema import Case, Wall
from core.case.site import FULL_FACTOR
from core.codes.demand import DemandResult
from core.codes.dynamic_check import demand_check
from core.codes.kinematic import ROUNDING, checks_of
from core.rocking.methods import AUTO, METHODS
from core.study.plan import Entry, Floors, Inputs, plan_of
from core.wall.restitution import restitution
from core.wall.rocking_model import RockingModel, rocking_model
from core.wall.wall_loads import contact_of

EVERY = 4
"""Every how many points of the grid zeta is searched: by 1 %."""


@dataclass(frozen=True)
class Zetas:
    """A wall with its checks, of each the worst hinge and mechanism.

    by_check : label -> zeta, None where one of them has none; the linear check with the wall's own q is not made
    zeta : of the check that decides, of the worst hinge; None without a number
    low : the lowest end of its spread
    sure : every hinge's check that decides is satisfied, its spread included
    satisfied : label -> whether the check is satisfied about every hinge; None where its spread contains what is
        required
    """

    by_check: dict[str, float | None]
    zeta: float | None
    low: float | None
    sure: bool
    satisfied: dict[str, bool | None] = field(default_factory=dict)


NONE = Zetas({}, None, None, False)
"""Of a wall that does not stand."""


@dataclass(frozen=True)
class Setting:
    """What stays the same while inputs of a wall move.

    case : with that wall alone; inputs : of `read_inputs`; book : `demand_check`, or one that keeps its results
    """

    case: Case
    base_dir: Path
    inputs: Inputs
    book: Callable = demand_check

    @property
    def demand(self) -> DemandResult:
        """Of the case, given."""
        demand = self.inputs[0]
        assert demand is not None
        return demand

    @property
    def has_histories(self) -> bool:
        """Whether time histories decide."""
        return bool(self.inputs[1]) and not self.case.wall[0].bends and self.demand.limit_state in LIMIT_FRACTION


def setting_of(case: Case, k: int, base_dir: Path, inputs: Inputs, book: Callable = demand_check) -> Setting:
    """For the k-th wall of a case with a demand; no tie is sought."""
    wall = replace(case.wall[k], tie_height_m=None, tie_bar_length_m=None, tie_elongation_m=None, tie_spacing_m=None)
    # whether an FC below 1.35 is founded was judged; a strength that is moved is no tested one
    demand = replace(case.demand, confidence_factor=FULL_FACTOR) if case.demand else None
    analysis = replace(case.analysis, accuracy=False)
    alone = replace(case, wall=(wall,), demand=demand, sensitivity=None, analysis=analysis)
    return Setting(alone, base_dir, inputs, book)


def with_wall(setting: Setting, wall: Wall) -> Setting:
    """With another wall. Raises InputError where it breaks a rule, or does not stand."""
    return replace(setting, case=with_walls(setting.case, [wall]))


def with_demand(setting: Setting, demand: DemandResult) -> Setting:
    """With another demand; records that are used as given follow its a_g S."""
    _, motions, kinds = setting.inputs
    factor = demand.pga / setting.demand.pga if demand.record_scaling == "as_given" else 1.0
    if factor != 1.0:
        motions = [replace(motion, acceleration=factor * motion.acceleration) for motion in motions]
    return replace(setting, inputs=(demand, motions, kinds))


def zetas(
    setting: Setting,
    *,
    every: int = EVERY,
    of_theory: float | None = None,
    floors: Floors | None = None,
    cancelled: Callable[[], bool] = lambda: False,
) -> Zetas:
    """zeta of the wall of a setting.

    every : zeta of the histories is searched at every n-th point of the grid; 0 makes no histories
    of_theory : its velocity ratio over that of Eq. 4 or 6, None as it is
    floors : of the building, kept for the next call with the same demand and building
    Raises InputError, Cancelled.
    """
    plan = plan_of(setting.case, setting.base_dir, setting.inputs, floors=floors)
    demand, target = setting.demand, setting.demand.zeta_target
    method = METHODS.get(setting.case.analysis.method, AUTO)
    by_check: dict[str, float | None] = {}
    satisfied: dict[str, bool | None] = {}
    found: list[float | None] = []
    lows: list[float | None] = []
    sure = True
    for entry in plan.entries:
        dynamic = None
        if every and entry.felt:
            model = entry.model if of_theory is None else model_of_theory(entry, of_theory)
            dynamic = setting.book(model, entry.felt, entry.signs, demand, method, every, False, cancelled)
        checks = ((dynamic.as_check(),) if dynamic else ()) + (
            checks_of(entry.kinematic, demand) if entry.kinematic else ()
        )
        for check in checks:
            by_check[check.label] = lowest([check.zeta, by_check.get(check.label, check.zeta)])
            spread = dynamic is not None and check.label == "dynamic" and dynamic.within_spread(target)
            satisfied[check.label] = _both(satisfied.get(check.label, True), None if spread else check.passed)
        zeta = checks[0].zeta if checks else None
        found.append(zeta)
        lows.append(dynamic.zeta_spread[0] if dynamic and dynamic.zeta_spread else zeta)
        reached = zeta is not None and zeta >= target - ROUNDING
        sure &= dynamic.passed and not dynamic.within_spread(target) if dynamic else reached
    return Zetas(by_check, lowest(found), lowest(lows), sure, satisfied)


def _both(one: bool | None, other: bool | None) -> bool | None:
    """Whether both hold: not where one does not, None where one is not known."""
    return False if False in (one, other) else None if None in (one, other) else True


def lowest(found: list[float | None]) -> float | None:
    """The lowest of all; None where one is missing."""
    known = [zeta for zeta in found if zeta is not None]
    return min(known) if known and len(known) == len(found) else None


def model_of_theory(entry: Entry, factor: float) -> RockingModel:
    """The model of a wall whose velocity ratio is that of Eq. 4 or 6 times a factor, at most 1."""
    wall, one_sided = entry.part.wall, entry.mechanism == "one_sided"
    block, inner = wall.block(), wall.inner_block()
    theory = restitution(block, "one_sided_theoretical" if one_sided else "housner", contact=contact_of(wall))
    inward = theory.ratio_inward
    moved = replace(
        theory,
        ratio_at_rest=min(1.0, factor * theory.ratio_at_rest),
        ratio_inward=None if inward is None else min(1.0, factor * inward),
    )
    return rocking_model(block, one_sided, moved, wall.moment_law(), wall.restoring(), wall.bars(), inner)
