"""zeta of a wall with an input other than the one given: what lifts zeta is shown with the other end of its range."""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import reduce

from core.case.schema import Wall
from core.case.site import FULL_FACTOR, Building, Demand
from core.codes.demand import DemandResult
from core.codes.dynamic_check import demand_check
from core.codes.floor_spectrum import first_mode
from core.codes.kinematic import Check, checks_of
from core.codes.kinematic import kinematic as kinematic_of
from core.codes.verdict import Lift
from core.codes.verdict_sentence import CODE_Q
from core.ground.ground_motion import GroundMotion
from core.rocking.methods import Method
from core.study.floors import Floor, damaged, floor_of, other_ends
from core.text.sentence import Key, Number, Sentence, sentence
from core.wall import ties
from core.wall.restitution import MODELS
from core.wall.rocking_model import RockingModel, rocking_model

EVERY = 8
"""Every how many points of the grid zeta is searched with another input: by 2 %, the digits given are two."""

MORE_RATIO = 0.1
"""What is added to a given velocity ratio: its zeta is shown as well."""


@dataclass(frozen=True)
class Scene:
    """What zeta of a wall follows from.

    wall : of the case, about its hinge; decides : the check whose zeta is asked for
    building : of a wall above the ground, floor : what it makes of the records; ground : the records
    dynamic_check : `demand_check`, or one that keeps its results
    """

    wall: Wall
    mechanism: str
    demand: DemandResult
    building: Building | None
    ground: tuple[GroundMotion, ...]
    polarities: tuple[int, ...]
    method: Method
    decides: Check
    floor: Floor | None = None
    dynamic_check: Callable = demand_check


def model_of(wall: Wall, mechanism: str) -> RockingModel:
    """The rocking model of a wall."""
    one_sided, restitution = mechanism == "one_sided", wall.restitution_of(mechanism)
    return rocking_model(wall.block(), one_sided, restitution, wall.moment_law(), wall.restoring(), wall.bars())


def zeta_with(
    scene: Scene, every: int = EVERY, cancelled: Callable[[], bool] = lambda: False, **changes
) -> tuple[float | None, bool]:
    """(zeta, whether the check is surely satisfied) of the check that decides, with these fields of the scene changed.

    every : zeta of the histories is searched at every n-th point of the grid
    Raises Cancelled.
    """
    changed = replace(scene, **changes)
    wall, demand, decides = changed.wall, changed.demand, changed.decides
    floor = scene.floor
    if (changed.building, wall.base_z_m, demand) != (scene.building, scene.wall.base_z_m, scene.demand):
        floor = floor_of(wall, changed.building, demand, changed.ground)
    if decides.name == "dynamic":
        motions = list(floor.motions if floor else changed.ground)
        dynamic = changed.dynamic_check(
            model_of(wall, changed.mechanism),
            motions,
            changed.polarities,
            demand,
            changed.method,
            every,
            False,
            cancelled,
        )
        return dynamic.zeta, dynamic.passed and not dynamic.within_spread(demand.zeta_target)
    moved = kinematic_of(wall, changed.mechanism, demand, floor.spectrum if floor else None)
    made = checks_of(moved, demand, decides.q)
    check = next((one for one in made if one.name == decides.name), None)
    return (check.zeta, bool(check.passed)) if check else (None, False)


Zeta = tuple[float | None, bool]
"""zeta of a check, and whether it is surely satisfied."""

Change = Callable[[Scene], Scene]


@dataclass(frozen=True)
class Raised:
    """An input that raises zeta.

    key : of the case and of the reasons; reasons : sections of them, or None
    ends : changes to the other ends of its range
    words : from zeta of each end, and its check, the Sentence
    given : the other ends count against the verdict
    histories : the dynamic check knows of it; otherwise its words are of the linear check
    """

    key: str
    reasons: object
    ends: tuple[Change, ...]
    words: Callable[[list[float | None], Check], Sentence]
    given: bool = True
    histories: bool = True

    @property
    def justified(self) -> bool:
        return bool(self.reasons and getattr(self.reasons, self.key))


def _worth(zeta: float | None) -> float:
    """To compare: a number that is missing is the least."""
    return -math.inf if zeta is None else zeta


def lifts(
    scene: Scene, asked: Demand, checks: tuple[Check, ...], cancelled: Callable[[], bool] = lambda: False
) -> tuple[Lift, ...]:
    """The inputs of a wall that raise zeta, each with zeta at the other end of its range; where no one of them turns
    the outcome, all together without a reason may. asked : of the case."""
    q_check = next((check for check in checks if check.name == "linear_q_code"), None)
    decides = scene.decides

    def at(change: Change, check: Check) -> Zeta:
        there = change(scene)
        # the floor of a kinematic check needs no motions
        ground = there.ground if check.name == "dynamic" else ()
        changes = {"wall": there.wall, "demand": there.demand, "building": there.building, "ground": ground}
        return zeta_with(scene, EVERY, cancelled, decides=check, **changes)

    found, worst = [], {}
    for one in _raised(scene, asked, q_check):
        touched = decides.name != "dynamic" or one.histories
        by = {}
        if touched:
            by[decides] = [at(end, decides) for end in one.ends]
        if q_check is not None and q_check is not decides:
            by[q_check] = [at(end, q_check) for end in one.ends]
        if not by:
            continue
        # a wall declared free or not is told by the check that fares worst, whose words name it
        told = decides if one.histories else q_check
        if one.key == "free_element":
            told = min(by, key=lambda check: _worth(by[check][0][0]))
        zetas = [zeta for zeta, _ in by[told]]
        if one.key == "free_element" and scene.wall.free_element and _worth(zetas[0]) >= _worth(told.zeta):
            continue
        lowest = min(range(len(zetas)), key=lambda k: _worth(zetas[k]))
        if one.key in OF_LOADS and _worth(zetas[lowest]) >= _worth(told.zeta):
            continue
        fails = {check: one.given and not all(fine for _, fine in ends) for check, ends in by.items()}
        found.append(
            Lift(
                one.key,
                one.words(zetas, told),
                turns=bool(decides.passed) and fails.get(decides, False),
                justified=one.justified,
                zeta=zetas[lowest],
                turns_q=bool(q_check and q_check.passed) and fails.get(q_check, False),
            )
        )
        if one.given and not one.justified:
            worst[one.key] = one.ends[lowest]
    return _together(found, worst, decides, q_check, at)


def _together(found: list[Lift], worst: dict[str, Change], decides: Check, q_check: Check | None, at) -> tuple:
    """The lifts; where none turns a check alone, and all without a reason do together, each of them does.

    worst : of these the change to the end with the lowest zeta; at(change, check) : zeta there
    """

    def turning(check: Check | None, alone: bool) -> Zeta | None:
        if check is None or not check.passed or alone or len(worst) < 2:
            return None
        there = at(lambda scene: reduce(lambda changed, change: change(changed), worst.values(), scene), check)
        return None if there[1] else there

    open_ones = [lift for lift in found if lift.key in worst]
    joint = turning(decides, any(lift.turns for lift in open_ones))
    joint_q = turning(q_check, any(lift.turns_q for lift in open_ones))
    if joint is not None or joint_q is not None:
        found = [
            replace(lift, turns=lift.turns or joint is not None, turns_q=lift.turns_q or joint_q is not None)
            if lift.key in worst
            else lift
            for lift in found
        ]
    if joint is not None:
        keys = tuple(Key(key) for key in worst)
        found.append(Lift("", sentence("reason", "lifts_together", keys=keys, zeta=Number(joint[0])), zeta=joint[0]))
    return tuple(found)


def _of_wall(**values) -> Change:
    return lambda scene: replace(scene, wall=replace(scene.wall, **values))


def _of_ties(wall: Wall, **values) -> Change:
    """Of its ties."""
    return _of_wall(load=tuple(replace(load, **values) if load.is_tie else load for load in wall.load))


def _of_demand(**values) -> Change:
    return lambda scene: replace(scene, demand=replace(scene.demand, **values))


def _raised(scene: Scene, asked: Demand, q_check: Check | None) -> Iterator[Raised]:
    """What the case gives that raises zeta."""
    wall, demand = scene.wall, scene.demand
    model = wall.restitution_model(scene.mechanism)
    dynamic = scene.decides.name == "dynamic"
    if dynamic and not MODELS[model].by_theory:
        given = wall.restitution_of(scene.mechanism).ratio_at_rest
        more = min(given + MORE_RATIO, 1.0)
        theory = replace(wall, restitution=None, velocity_ratio=None)
        ratio = theory.restitution_of(scene.mechanism).ratio_at_rest
        yield Raised(
            "velocity_ratio" if model == "user" else "restitution",
            wall.justification,
            (_of_wall(restitution=None, velocity_ratio=more), _of_wall(restitution=None, velocity_ratio=None)),
            lambda zetas, _: sentence(
                "reason",
                "lift_velocity_ratio",
                e=given,
                more=more,
                zeta_more=Number(zetas[0]),
                theory=ratio,
                zeta_theory=Number(zetas[1]),
            ),
        )
    if dynamic and not wall.moment_law().is_rigid:
        yield _one("law", "lift_law", wall.justification, _of_wall(law="rigid"))
    if demand.confidence_factor < FULL_FACTOR:
        yield _one(
            "confidence_factor",
            "lift_confidence_factor",
            asked.justification,
            _of_demand(confidence_factor=FULL_FACTOR),
            fc=demand.confidence_factor,
            level=asked.knowledge_level or "",
            investigations=asked.investigations,
        )
    if q_check is not None and q_check.q > CODE_Q:
        end = _of_demand(q_code=CODE_Q)
        yield _one("q_code", "lift_q_code", asked.justification, end, histories=False, q=demand.q_code)
    if wall.return_walls is not None and q_check is not None:
        end = _of_wall(return_walls=None)
        yield _one("return_walls", "lift_return_walls", wall.justification, end, histories=False)
    yield from _of_the_loads(wall, dynamic)
    if wall.free_element is not None and wall.free_element != replace(wall, free_element=None).is_free(scene.mechanism):
        code = "lift_one_sided_free" if wall.free_element else "lift_free_element"
        end = _of_wall(free_element=None)
        yield Raised(
            "free_element",
            wall.justification,
            (end,),
            lambda zetas, check: sentence(
                "reason", code, zeta=Number(zetas[0]), check=sentence("short", check.label, q=Number(check.q, "g"))
            ),
            histories=False,
        )
    if wall.above_ground and scene.building is not None:
        yield from _of_the_building(scene, asked, scene.building)


def _one(key: str, code: str, reasons, end: Change, histories: bool = True, **values) -> Raised:
    """One with one other end, whose words take its zeta."""
    words = lambda zetas, _: sentence("reason", code, zeta=Number(zetas[0]), **values)  # noqa: E731
    return Raised(key, reasons, (end,), words, histories=histories)


def _building_at(factor: float, damping: float) -> Change:
    """The building at this ratio to its elastic period, and with this damping."""

    def change(scene: Scene) -> Scene:
        building = scene.building
        modes = tuple(replace(mode, damping=damping) for mode in building.modes)
        damped = {"modes": modes} if modes else {"damping": damping}
        return replace(scene, building=replace(building, period_factor=factor, **damped))

    return change


OF_LOADS = ("elongation_m", "prestress", "anchorage_kn", "load")
"""Keys of what loads raise, told only where the other end is the lower one."""


def _of_the_loads(wall: Wall, dynamic: bool) -> Iterator[Raised]:
    """What of the ties, and of forces that always pull inward, raises zeta. dynamic : the histories decide"""
    ties_given = [load for load in wall.load if load.is_tie]
    without = _of_wall(load=tuple(load for load in wall.load if not load.is_tie))
    found = ties.ties_of(wall) if ties_given else ()
    if any(tie.stands_more for tie in found):
        end = _of_ties(wall, elongation_m=None, elongation=None)
        yield _one("elongation_m", "lift_elongation", wall.justification, end)
    elif found and not dynamic:  # no clause follows a bar that breaks
        yield _one("elongation_m", "lift_brittle", wall.justification, without)
    if any(load.bar is not None and load.bar.anchorage_kn is None for load in ties_given):
        yield _one("anchorage_kn", "lift_anchorage", wall.justification, without)
    if any(load.prestress for load in ties_given):
        yield _one("prestress", "lift_prestress", wall.justification, _of_ties(wall, prestress=None))
    if any(load.kind == "thrust" and load.kn_m < 0.0 for load in wall.load):
        kept = tuple(load for load in wall.load if load.kind != "thrust" or load.kn_m > 0.0)
        yield _one("load", "lift_inward", wall.justification, _of_wall(load=kept))


def _participating(share: float) -> Change:
    """The first mode of the building with this participation."""

    def change(scene: Scene) -> Scene:
        first, *others = scene.building.modes
        return replace(scene, building=replace(scene.building, modes=(replace(first, participation=share), *others)))

    return change


def _of_the_building(scene: Scene, asked: Demand, building: Building) -> Iterator[Raised]:
    """What of the building, and of the height at which its motion is taken, raises zeta."""
    wall, limit_state = scene.wall, scene.demand.limit_state
    if ends := other_ends(building, limit_state):

        def words(zetas, _):
            k = min(range(len(ends)), key=lambda k: _worth(zetas[k]))
            factor, damping = ends[k]
            return sentence("reason", "other_building", factor=factor, damping=damping, zeta=Number(zetas[k]))

        given = bool(building.modes) or (building.period_factor, building.damping) != (None, None)
        changes = tuple(_building_at(*end) for end in ends)
        yield Raised("building", asked.justification, changes, words, given)
    centroid = min(wall.base_z_m + 0.5 * (wall.height_m or wall.block().height), building.height_m)
    if not building.modes and centroid > wall.base_z_m:
        yield _one("base_z_m", "at_centroid", wall.justification, _of_wall(base_z_m=centroid), z=centroid)
    if building.modes:
        _, damping = damaged(building, limit_state)
        z = min(wall.base_z_m, building.height_m)
        (expected,) = first_mode(building.storeys, building.height_m, z, 1.0, damping)
        share, given_share = expected.participation, building.modes[0].participation
        if abs(given_share) < abs(share):
            yield _one(
                "participation",
                "lift_participation",
                asked.justification,
                _participating(share),
                given=given_share,
                expected=share,
            )
