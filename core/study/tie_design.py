"""The force of a tie that brings zeta of the check that decides to the one required."""

from collections.abc import Callable
from dataclasses import dataclass, replace

from core.case.schema import Load, Wall
from core.codes.multiplier_search import STEP
from core.units import G
from core.wall import wall_loads

COARSE_STEP = 0.02
"""Step of the search for zeta of the dynamic check while the force is looked for [-]."""

CLOSE = 0.005
"""Width of the bracket of the force, of the force [-]."""

RAISED = 1.01
"""What the force is raised by where the fine search finds less than the coarse one."""


@dataclass(frozen=True)
class TieDesign:
    """A tie of constant force, horizontal, at the outer face.

    height : above the hinge of the wall [m]
    check : label of the check that decides, without the tie
    force : least one that reaches the zeta required [N/m]; 0 where none is needed, None where the largest does not
    zeta : with it, with the largest where force is None
    largest : force up to which the wall still turns about its base [N/m]
    holding : moments of wall, loads and tie about the hinge [N]
    pushing : moment of the masses at a multiplier of 1 [N]
    """

    height: float
    check: str
    force: float | None
    zeta: float | None
    largest: float
    holding: tuple[float, float, float]
    pushing: float

    @property
    def alpha0(self) -> float:
        """The hand check: alpha_0 with the tie, the moments that hold over those that push [-] (C8.7.1.1)."""
        return sum(self.holding) / self.pushing


def with_tie(wall: Wall, force: float) -> Wall:
    """The wall with one more tie of this force [N/m] at its `tie_height_m`."""
    if force <= 0.0:
        return wall
    tie = Load("tie", 1e-3 * force, wall.tie_height_m, 0.0)
    return replace(wall, load=(*wall.load, tie), unloaded_confirmed=False)


def tie_design(
    wall: Wall,
    zeta: float,
    target: float,
    check: str,
    zeta_with: Callable[[float, float], float | None],
) -> TieDesign:
    """The least force by bisection: the moment a tie adds grows with its force, and zeta with the moment.

    zeta : without the tie
    zeta_with : zeta of the check that decides with this force [N/m], at this step of its search
    """
    largest = _largest(wall)
    if zeta >= target:
        return _found(wall, check, 0.0, zeta, largest)
    reached = zeta_with(largest, COARSE_STEP) if largest > 0.0 else zeta
    if reached is None or reached < target:
        return _found(wall, check, None, reached, largest)
    low, high = 0.0, largest
    while high - low > CLOSE * high:
        middle = 0.5 * (low + high)
        found = zeta_with(middle, COARSE_STEP)
        low, high = (low, middle) if found is not None and found >= target else (middle, high)
    while True:
        reached = zeta_with(high, STEP)
        if reached is not None and reached >= target:
            return _found(wall, check, high, reached, largest)
        if high >= largest:
            return _found(wall, check, None, reached, largest)
        high = min(RAISED * high, largest)


def _largest(wall: Wall) -> float:
    """Force [N/m] up to which the wall with this tie is one that this program takes."""
    high = 1e3 * wall.unit_weight_kn_m3 * wall.thickness * wall.height_m
    high += wall_loads.vertical_loads(wall)
    while wall_loads.carries(with_tie(wall, high)):
        high *= 2.0
    low = 0.0
    for _ in range(30):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if wall_loads.carries(with_tie(wall, middle)) else (low, middle)
    return low


def _found(wall, check, force, zeta, largest) -> TieDesign:
    weight, bare = wall_loads.weight_per_metre(wall), wall.bare_block()
    forces = [wall_loads.as_force(load, wall, 1.0) for load in wall.load]
    loads = sum(f.vertical * f.distance + f.horizontal * f.height for f in forces)
    tie = (largest if force is None else force) * wall.tie_height_m
    pushing = weight * bare.centroid[1]
    pushing += sum(mass.mass * G * mass.height for mass in wall_loads.masses(wall))
    return TieDesign(
        wall.tie_height_m,
        check,
        force,
        zeta,
        largest,
        (weight * bare.centroid[0], loads, tie),
        pushing,
    )
