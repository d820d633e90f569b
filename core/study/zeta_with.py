"""zeta of a wall with an input other than the one given."""

from collections.abc import Callable
from dataclasses import dataclass, replace

from core.case.schema import Wall
from core.case.site import Building
from core.codes.demand import DemandResult
from core.codes.dynamic_check import demand_check
from core.codes.kinematic import Check, checks_of
from core.codes.kinematic import kinematic as kinematic_of
from core.ground.ground_motion import GroundMotion
from core.rocking.methods import Method
from core.study.floors import Floor, floor_of
from core.wall.rocking_model import RockingModel, rocking_model

EVERY = 1
"""Every how many points of the grid zeta is searched with another input: as the run of that wall searches it."""


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
    blocks, law = (wall.block(), wall.inner_block()), wall.moment_law()
    return rocking_model(blocks[0], one_sided, restitution, law, wall.restoring(), wall.bars(), blocks[1])


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
