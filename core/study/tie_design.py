"""The force a tie must hold, by every check, for all hinges of a wall together.

The tie is a bar at `tie_height_m`: it yields, is slack when the wall comes back, and is gone beyond what it stands. The
force named is the largest of the histories, of the displacement check and of the thrust at rest, and is not known
where one of them is not; that of the linear check with q = 2 leaves most walls beyond the limit state and lets many
overturn (resources/docs/ties.md): it stands beside it, but where neither of the others is made, so that it decides.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from core.case.loads import Load
from core.case.schema import Wall
from core.codes.dynamic_check import DemandCheck
from core.codes.kinematic import ROUNDING, Check, kinematic, linear, nonlinear, sld
from core.errors import InputError
from core.study.zeta_with import Scene, model_of
from core.wall import ties, wall_loads

NAMES = ("dynamic", "nonlinear", "linear_q_slv", "linear_q_code", "linear_q_1", "thrust")
"""Of the forces: of the checks, with q = 1 in place of that of the code, and of the thrust at rest."""

COARSE_EVERY = 8
"""Every how many points of the grid zeta of the histories is searched while the force is looked for: by 2 %."""

CLOSE = 0.005
"""Width of the bracket of a force, of the force [-]."""

RAISED = 1.01
"""What the force is raised by where the fine search finds less than the coarse one."""

MOST = 1e7
"""Largest force that is tried [N/m]."""

ASSUMED_LENGTH = 10.0
"""Length of a bar that nobody describes [m], and the elongation it stands: whatever the displacement check asks."""

CURVE = 13
"""Heights of the curve of forces."""

LEAST_HEIGHT = 0.3
"""Height of the lowest tie of that curve, of the wall [-]."""


@dataclass(frozen=True)
class TieDesign:
    """A tie for the zeta required, of all hinges of the wall below it.

    height : above the base of the wall [m]
    forces : by NAMES [N/m]: the largest that a hinge asks; 0 where none is needed, None where none does it, where a
        hinge at or above the tie fails, where the state has no such check, or where `missing` says so
    missing : why there is none of the histories: "histories" without records, "bar" without a length of the bar, which
        they need, "none" where none does it; "" where there is one
    force, check : the one named, the largest of the deciding ones, and which it is; None where one of these is not
        known or none does it, or beyond `largest`
    asked : the largest of these, also beyond `largest` [N/m]; None where one is not known, or none does it
    at_least : the largest of those that are known [N/m], where one is not
    largest : up to which the wall turns as one block about each of its hinges [N/m]
    elongation : of the bar with the force named, at the largest peak of the histories at the demand, at d_SLV and at
        d_0 of the base hinge [m]
    stands : the elongation of the bar before it is gone [m], None without its length; stands_more : beyond yield
    zeta : with the force named, of each check, the least of all hinges
    hinges : below the tie
    diameter, thread, spacing : smallest of the bars that hold it, their thread [mm], at this spacing [m]; None where
        none is asked or holds it
    curve : (height of the tie [m], force of the displacement check there [N/m], None where none does it)
    """

    height: float
    forces: dict[str, float | None]
    missing: str
    force: float | None
    check: str | None
    asked: float | None
    at_least: float | None
    largest: float
    elongation: dict[str, float | None]
    stands: float | None
    zeta: dict[str, float | None]
    hinges: int
    diameter: int | None = None
    thread: int | None = None
    spacing: float | None = None
    curve: tuple[tuple[float, float | None], ...] = ()
    stands_more: bool = False


@dataclass(frozen=True)
class Hinge:
    """A hinge of a wall with a tie to design.

    height : above the base of the wall [m]; scene : of the part above it, without the tie
    dynamic : its check without the tie, None without histories
    """

    height: float
    scene: Scene
    dynamic: DemandCheck | None

    def raised(self, height: float) -> float:
        """Height of a tie above this hinge [m], of one `height` above the base."""
        return height - self.height


def with_tie(wall: Wall, force: float, height: float) -> Wall:
    """The wall with one more tie of this force at yield [N/m], at this height above its hinge [m]."""
    if force <= 0.0:
        return wall
    length = wall.tie_bar_length_m or ASSUMED_LENGTH
    stands = wall.tie_elongation_m if wall.tie_bar_length_m else ASSUMED_LENGTH
    tie = Load("tie", 1e-3 * force, height, bar_length_m=length, elongation_m=stands)
    return replace(wall, load=(*wall.load, tie), unloaded_confirmed=False)


def tie_design(hinges: Sequence[Hinge], asked: Wall, cancelled: Callable[[], bool] = lambda: False) -> TieDesign:
    """The tie for all hinges of a wall, the base first. asked : the wall of the case. Raises Cancelled."""
    height = asked.tie_height_m
    below = [hinge for hinge in hinges if hinge.scene.wall.tie_height_m is not None]
    above = [hinge for hinge in hinges if hinge.scene.wall.tie_height_m is None]
    largest = min(_largest(hinge, height) for hinge in below)
    forces = {name: _force(name, below, above, height) for name in NAMES[1:]}
    missing = "histories" if any(hinge.dynamic is None for hinge in hinges) else ""
    missing = missing or ("bar" if asked.tie_bar_length_m is None else "")
    forces["dynamic"] = None
    if not missing:
        forces["dynamic"] = _of_histories(below, above, height, largest, forces, cancelled)
        missing = "none" if forces["dynamic"] is None else ""
    named = _deciding(below[0].scene, missing != "histories")
    known = {name: force for name in named if (force := forces[name]) is not None}
    unknown = missing == "bar" and "dynamic" in named
    most = max(known.values()) if len(known) == len(named) else None
    at_least = max(known.values()) if unknown and len(known) == len(named) - 1 else None
    force = most if most is not None and most <= largest else None
    check = None if force is None else next(name for name, value in known.items() if value == force)
    zeta, elongation, bars = {}, dict.fromkeys(("demand", "d_slv", "d_0")), (None, None)
    stands, more = None, False
    if force is not None:
        zeta, elongation = _with(below, height, force, missing, cancelled)
        if asked.tie_spacing_m is not None:
            bars = ties.bars_for(force, asked.tie_spacing_m)
    if asked.tie_bar_length_m is not None:
        tie = ties.tie_of(with_tie(below[0].scene.wall, 1.0, height).load[-1], asked)
        stands, more = tie.bar.stands, tie.stands_more
    curve = tuple((float(h), _at_height(hinges, float(h))) for h in _heights(asked))
    return TieDesign(
        height,
        {name: forces[name] for name in NAMES},
        missing,
        force,
        check,
        most,
        at_least,
        largest,
        elongation,
        stands,
        zeta,
        len(below),
        *bars,
        asked.tie_spacing_m,
        curve,
        more,
    )


def _deciding(scene: Scene, histories: bool) -> list[str]:
    """Names of the forces of which the largest is named: those of the thrust and of the checks that decide about the
    wall. histories : it has some"""
    if scene.demand.limit_state == "SLD":
        return ["linear_q_code", "thrust"]
    made = [name for name, there in (("dynamic", histories), ("nonlinear", _made("nonlinear", scene))) if there]
    return [*(made or ["linear_q_code"]), "thrust"]


def _made(name: str, scene: Scene) -> bool:
    """Whether a check of the clauses can be made of the wall."""
    return _zeta(name, scene, scene.wall) is not None


def _largest(hinge: Hinge, height: float) -> float:
    """Force [N/m] up to which the part above a hinge turns about it as one block."""
    wall, above = hinge.scene.wall, hinge.raised(height)
    high = wall_loads.weight_per_metre(wall) + wall_loads.vertical_loads(wall)
    while high < MOST and wall_loads.carries(with_tie(wall, high, above)):
        high *= 2.0
    low = 0.0
    for _ in range(30):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if wall_loads.carries(with_tie(wall, middle, above)) else (low, middle)
    return low


def _zeta(name: str, scene: Scene, wall: Wall) -> float | None:
    """zeta of a check of the clauses of a wall; None where it cannot be made."""
    floor = scene.floor.spectrum if scene.floor else None
    try:
        found = kinematic(wall, scene.mechanism, scene.demand, floor)
    except InputError:
        return None
    made: Check | None = None
    state = scene.demand.limit_state
    if name == "nonlinear":
        made = nonlinear(found, scene.demand)
    elif state == "SLD":
        made = sld(found, scene.demand)
    elif state == "SLV":
        made = linear(name, found, scene.demand, 1.0 if name == "linear_q_1" else scene.demand.q_code)
    return made.zeta if made else None


def _force(name: str, below: Sequence[Hinge], above: Sequence[Hinge], height: float) -> float | None:
    """Force by a check of the clauses [N/m], or by the thrust at rest; None where none does it."""
    if name == "linear_q_slv":
        return None  # q SLV counts from the uplift of the wall without its ties: no force raises it but by histories
    if name == "thrust":
        return max(_thrust(hinge, height) for hinge in below)
    target = below[0].scene.demand.zeta_target
    if any(not _reaches(_zeta(name, hinge.scene, hinge.scene.wall), target) for hinge in above):
        return None
    found = [_least(name, hinge, hinge.raised(height), target) for hinge in below]
    return None if None in found else max(found)


def _reaches(zeta: float | None, target: float) -> bool:
    return zeta is not None and zeta >= target - ROUNDING


def _thrust(hinge: Hinge, height: float) -> float:
    """Force at rest that balances the thrusts on the part above a hinge [N/m]."""
    wall = hinge.scene.wall
    outward = [wall_loads.as_force(load, wall, 1.0) for load in wall.load if load.kind == "thrust"]
    return max(0.0, -sum(force.horizontal * force.height for force in outward) / hinge.raised(height))


def _least(name: str, hinge: Hinge, above: float, target: float) -> float | None:
    """Least force of a tie at this height above a hinge [m] with which a check of the clauses is satisfied [N/m]."""
    scene = hinge.scene

    def holds(force: float) -> bool:
        return _reaches(_zeta(name, scene, with_tie(scene.wall, force, above)), target)

    if holds(0.0):
        return 0.0
    low, high = 0.0, 1e3
    while not holds(high):
        low, high = high, 2.0 * high
        if high > MOST:
            return None
    while high - low > 1e-4 * high:
        middle = 0.5 * (low + high)
        low, high = (low, middle) if holds(middle) else (middle, high)
    return high


def _dynamic(hinge: Hinge, force: float, height: float, every: int, cancelled) -> DemandCheck:
    """The dynamic check of a hinge with the tie."""
    scene = hinge.scene
    motions = list(scene.floor.motions if scene.floor else scene.ground)
    model = model_of(with_tie(scene.wall, force, hinge.raised(height)), scene.mechanism)
    return scene.dynamic_check(model, motions, scene.polarities, scene.demand, scene.method, every, False, cancelled)


def _satisfied(check: DemandCheck, target: float) -> bool:
    return check.passed and not check.within_spread(target)


def _of_histories(
    below: Sequence[Hinge], above: Sequence[Hinge], height: float, largest: float, others: dict, cancelled
) -> float | None:
    """Least force found with which the dynamic check of every hinge holds [N/m]; None where none does up to the
    largest. Whether its rule holds is not monotone: the force is raised until it does, and does a little beyond.

    others : forces of the other checks, from which the search starts
    """
    target = below[0].scene.demand.zeta_target
    if not all(_satisfied(hinge.dynamic, target) for hinge in above if hinge.dynamic):
        return None

    def holds(force: float, every: int) -> bool:
        return all(_satisfied(_dynamic(hinge, force, height, every, cancelled), target) for hinge in below)

    if all(_satisfied(hinge.dynamic, target) for hinge in below if hinge.dynamic):
        return 0.0
    low, high = 0.0, min(others["linear_q_code"] or 1e4, largest)
    while not holds(high, COARSE_EVERY):
        if high >= largest:
            return None
        low, high = high, min(2.0 * high, largest)
    while high - low > 2.0 * CLOSE * high:
        middle = 0.5 * (low + high)
        low, high = (low, middle) if holds(middle, COARSE_EVERY) else (middle, high)
    while True:
        more = min(RAISED * high, largest)
        if holds(high, 1) and (more == high or holds(more, 1)):
            return high
        if high >= largest:
            return None
        high = more


def _with(below: Sequence[Hinge], height: float, force: float, missing: str, cancelled) -> tuple[dict, dict]:
    """(zeta of each check with a tie of this force, the least of all hinges; elongations of its bar about the base)."""
    zeta: dict[str, float | None] = {}
    held = [(hinge, with_tie(hinge.scene.wall, force, hinge.raised(height))) for hinge in below]
    for name in ("nonlinear", "linear_q_code", "linear_q_1"):
        each = [_zeta(name, hinge.scene, wall) for hinge, wall in held]
        zeta[name] = None if None in each else min(each)
    base, wall = held[0]
    demand, elongation = base.scene.demand, dict.fromkeys(("demand", "d_slv", "d_0"))
    theta_c = model_of(wall, base.scene.mechanism).collapse_rotation
    elongation["d_0"] = height * math.sin(theta_c)
    found = kinematic(wall, base.scene.mechanism, demand, base.scene.floor.spectrum if base.scene.floor else None)
    if found.d_limit is not None:
        elongation["d_slv"] = height * math.sin(found.chain.rotation(found.d_limit))
    if not missing:
        checks = [_dynamic(hinge, force, height, 1, cancelled) for hinge in below]
        each = [check.zeta for check in checks]
        zeta["dynamic"] = None if None in each else min(each)
        peaks = [run.peak_ratio for run in checks[0].runs]
        if None not in peaks:
            elongation["demand"] = height * math.sin(max(peaks) * theta_c)
    return zeta, elongation


def _heights(asked: Wall) -> np.ndarray:
    """Heights of the curve of forces [m]."""
    return np.linspace(LEAST_HEIGHT * asked.height_m, asked.height_m, CURVE)


def _at_height(hinges: Sequence[Hinge], height: float) -> float | None:
    """Force of the displacement check of a tie at another height [N/m]; None where none does it."""
    moved = [replace(hinge.scene.wall, tie_height_m=hinge.raised(height)) for hinge in hinges]
    placed = [replace(hinge, scene=replace(hinge.scene, wall=wall)) for hinge, wall in zip(hinges, moved, strict=True)]
    below = [hinge for hinge in placed if hinge.raised(height) > 0.0]
    return _force("nonlinear", below, [hinge for hinge in placed if hinge not in below], height)
