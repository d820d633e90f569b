"""The force of a tie that brings zeta of the check that decides to the one required."""

from collections.abc import Callable
from dataclasses import dataclass, replace

from core.case.schema import Load, Wall
from core.units import G
from core.wall import wall_loads

COARSE_EVERY = 8
"""Every how many points of the grid zeta of the dynamic check is searched while the force is looked for: by 2 %."""

CLOSE = 0.005
"""Width of the bracket of the force, of the force [-]."""

RAISED = 1.01
"""What the force is raised by where the fine search finds less than the coarse one."""


@dataclass(frozen=True)
class TieDesign:
    """A tie of constant force, horizontal, at the outer face.

    height : above the hinge of the wall [m]
    check : label of the check that decides, without the tie
    force : least one found with which the check is surely satisfied [N/m]; 0 where none is needed, None where none does
        it up to the largest
    zeta : with it, with the largest where force is None
    largest : force up to which the wall still turns about its base [N/m]
    holding : moments of wall, loads and tie about the hinge [N]
    pushing : moment of the masses at a multiplier of 1 [N]
    hinges : of the wall, above which this tie holds it
    governing : force the weakest of them asks [N/m], None where one has none
    """

    height: float
    check: str
    force: float | None
    zeta: float | None
    largest: float
    holding: tuple[float, float, float]
    pushing: float
    hinges: int = 1
    governing: float | None = None

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
    wall: Wall, bare: tuple[float, bool], check: str, judged_with: Callable[[float, int], tuple[float | None, bool]]
) -> TieDesign:
    """The least force by bisection: the moment a tie adds grows with its force, and zeta with the moment. Since whether
    the rule of the dynamic check holds is not monotone, the force found is raised until it does, and a little more.

    bare : zeta without the tie, and whether the check is surely satisfied
    judged_with : the same with this force [N/m], searched at every n-th point of the grid
    """
    largest = _largest(wall)
    if bare[1]:
        return _found(wall, check, 0.0, bare[0], largest)
    zeta, sure = judged_with(largest, COARSE_EVERY) if largest > 0.0 else bare
    while zeta is None and largest > 1.0:  # a free element so stiff that it does not rock has no linear check
        largest *= 0.5
        zeta, sure = judged_with(largest, COARSE_EVERY)
    if not sure:
        return _found(wall, check, None, zeta, largest)
    low, high = 0.0, largest
    while high - low > CLOSE * high:
        middle = 0.5 * (low + high)
        low, high = (low, middle) if judged_with(middle, COARSE_EVERY)[1] else (middle, high)
    while True:
        zeta, sure = judged_with(high, 1)
        more = min(RAISED * high, largest)
        if sure and (more == high or judged_with(more, 1)[1]):
            return _found(wall, check, high, zeta, largest)
        if high >= largest:
            return _found(wall, check, None, zeta, largest)
        high = more


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
    return TieDesign(wall.tie_height_m, check, force, zeta, largest, (weight * bare.centroid[0], loads, tie), pushing)
