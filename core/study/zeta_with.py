"""zeta of a wall with an input other than the one given: what lifts zeta is shown with the other end of its range."""

from collections.abc import Callable
from dataclasses import dataclass, replace

from core.case.schema import Wall
from core.case.site import FULL_FACTOR, Building, Demand
from core.codes.demand import DemandResult
from core.codes.dynamic_check import demand_check
from core.codes.floor_spectrum import first_mode
from core.codes.kinematic import ROUNDING, Check, linear, nonlinear, sld
from core.codes.kinematic import kinematic as kinematic_of
from core.codes.verdict import Lift
from core.codes.verdict_sentence import CODE_Q
from core.ground.ground_motion import GroundMotion
from core.rocking.methods import Method
from core.study.floors import Floor, damaged, floor_of, other_end
from core.text.sentence import Number, sentence
from core.wall.rocking_model import RockingModel, rocking_model

EVERY = 8
"""Every how many points of the grid zeta is searched with another input: by 2 %, the digits given are two."""

MORE_RATIO = 0.1
"""What is added to a given velocity ratio: its zeta is shown as well."""

MEASURED = ("sorrentino_experimental", "costa_upper", "one_sided_experimental")
"""Restitution models that rest on experiments."""


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
    return rocking_model(
        wall.block(), mechanism == "one_sided", wall.restitution_of(mechanism), wall.moment_law(), wall.restoring()
    )


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
    if decides.name == "nonlinear":
        check = nonlinear(moved, demand)
    elif demand.limit_state == "SLD":
        check = sld(moved, demand)
    else:
        check = linear(decides.name, moved, demand, decides.q)
    return (check.zeta, bool(check.passed)) if check else (None, False)


def lifts(
    scene: Scene, asked: Demand, checks: tuple[Check, ...], cancelled: Callable[[], bool] = lambda: False
) -> tuple[Lift, ...]:
    """The inputs of a wall that raise zeta, each with zeta at the other end of its range. asked : of the case."""
    found: list[Lift] = []
    passed = bool(scene.decides.passed)
    wall, demand = scene.wall, scene.demand
    of_wall = wall.justification
    of_demand = asked.justification
    q_check = next((check for check in checks if check.name == "linear_q_code"), None)

    def add(key: str, code: str, others: list[bool], reasons, zeta=None, of_q=(), **values) -> None:
        values = {"zeta": Number(zeta), **values}
        found.append(
            Lift(
                key,
                sentence("reason", code, **values),
                turns=passed and not all(others),
                justified=bool(reasons and getattr(reasons, key)),
                zeta=zeta,
                turns_q=bool(q_check and q_check.passed) and not all(of_q),
            )
        )

    def zeta(**changes) -> tuple[float | None, bool]:
        return zeta_with(scene, EVERY, cancelled, **changes)

    model = wall.restitution_model(scene.mechanism)
    if scene.decides.name == "dynamic" and (model == "user" or model in MEASURED):
        given = wall.restitution_of(scene.mechanism).ratio_at_rest
        more = min(given + MORE_RATIO, 1.0)
        theory = replace(wall, restitution=None, velocity_ratio=None)
        ratio = theory.restitution_of(scene.mechanism).ratio_at_rest
        high = zeta(wall=replace(wall, restitution=None, velocity_ratio=more))
        by_theory = zeta(wall=theory)
        key = "velocity_ratio" if model == "user" else "restitution"
        add(
            key,
            "lift_velocity_ratio",
            [high[1], by_theory[1]],
            of_wall,
            e=given,
            more=more,
            zeta_more=Number(high[0]),
            theory=ratio,
            zeta_theory=Number(by_theory[0]),
        )
    if demand.confidence_factor < FULL_FACTOR:
        full = zeta(demand=replace(demand, confidence_factor=FULL_FACTOR))
        add(
            "confidence_factor",
            "lift_confidence_factor",
            [full[1]],
            of_demand,
            fc=demand.confidence_factor,
            level=asked.knowledge_level or "",
            investigations=asked.investigations,
            zeta=full[0],
        )
    if q_check is not None and q_check.q > CODE_Q:
        lower = q_check.zeta * CODE_Q / q_check.q
        fine = lower >= demand.zeta_target - ROUNDING
        others = [fine] if scene.decides is q_check else []
        add("q_code", "lift_q_code", others, of_demand, q=demand.q_code, zeta=lower)
    if wall.return_walls is not None and q_check is not None:
        linear_one = scene.decides if scene.decides.name.startswith("linear") else q_check
        bare = zeta_with(replace(scene, decides=linear_one), wall=replace(wall, return_walls=None))
        others = [bare[1]] if linear_one is scene.decides else []
        add("return_walls", "lift_return_walls", others, of_wall, zeta=bare[0], of_q=[bare[1]])
    if wall.free_element is False and scene.mechanism == "two_sided" and q_check is not None:
        as_free = zeta_with(replace(scene, decides=q_check), wall=replace(wall, free_element=True))
        others = [as_free[1]] if scene.decides is q_check else []
        add("free_element", "lift_free_element", others, of_wall, zeta=as_free[0], of_q=[as_free[1]])
    if wall.above_ground and scene.building is not None:
        _of_the_building(scene, demand, add, zeta, of_wall, of_demand)
    return tuple(found)


def _of_the_building(scene: Scene, demand, add, zeta, of_wall, of_demand) -> None:
    """What of the building, and of the height at which its motion is taken, raises zeta."""
    wall, building = scene.wall, scene.building
    if (other := other_end(building, demand.limit_state)) is not None:
        factor, damping = other
        modes = tuple(replace(mode, damping=damping) for mode in building.modes)
        change = {"modes": modes} if modes else {"damping": damping}
        found = zeta(building=replace(building, period_factor=factor, **change))
        given = building.modes or (building.period_factor, building.damping) != (None, None)
        others = [found[1]] if given else []
        add("building", "other_building", others, of_demand, factor=factor, damping=damping, zeta=found[0])
    centroid = min(wall.base_z_m + 0.5 * (wall.height_m or wall.block().height), building.height_m)
    if not building.modes and centroid > wall.base_z_m:
        found = zeta(wall=replace(wall, base_z_m=centroid))
        add("base_z_m", "at_centroid", [found[1]], of_wall, z=centroid, zeta=found[0])
    if building.modes:
        factor, damping = damaged(building, demand.limit_state)
        (expected,) = first_mode(
            building.storeys, building.height_m, min(wall.base_z_m, building.height_m), 1.0, damping
        )
        given = building.modes[0].participation
        if abs(given) < abs(expected.participation):
            modes = (replace(building.modes[0], participation=expected.participation), *building.modes[1:])
            found = zeta(building=replace(building, modes=modes))
            add(
                "participation",
                "lift_participation",
                [found[1]],
                of_demand,
                given=given,
                expected=expected.participation,
                zeta=found[0],
            )
