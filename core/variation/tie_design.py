"""The force a tie must hold, by every check, for all hinges of a wall together.

The tie is a bar at the height of the hold that is to be designed: it yields, is slack when the wall comes back, and is
gone beyond what it stands. The force named is the largest of the histories, of the displacement check and of the thrust
at rest, and is not known where one of them is not; that of the linear check with q = 2 leaves most walls beyond the
limit state and lets many overturn (resources/docs/ties.md): it stands beside it, but where neither of the others is
made, so that it decides.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from core.boundary import find_boundary, written_up
from core.case.held_stretches import find_held_stretches
from core.case.hold import TIE, Hold
from core.case.load_rules import carries
from core.case.spans_between_ties import cut_span, find_bending_spans
from core.case.wall import Wall
from core.codes.dynamic_check import DynamicCheck
from core.codes.kinematic import ZETA_ROUNDING
from core.codes.outcomes import min_if_all_known
from core.errors import InputError
from core.known import require_value
from core.setting.check_input import CheckInput, make_rocking_model
from core.variation.evaluate import COARSE_PRECISION, FULL_PRECISION, Evaluation, Precision, evaluate
from core.wall import ties
from core.wall.masonry import load_to_force

AT_REST = "thrust"
"""Name of the force that balances the thrusts of a wall at rest."""

FORCE_NAMES = ("dynamic", "nonlinear", "linear_q_slv", "linear_q_code", "linear_q_1", AT_REST)
"""Names of the forces of a tie: those of the checks, with q = 1 in place of that of the code, and of the thrust at
rest."""

FORCE_TOLERANCE, FORCE_TOLERANCE_BY_HISTORIES = 1e-4, 0.01
"""Width of the bracket of a force, of the force [-]."""

FORCE_MARGIN = 1.01
"""More of the force at which histories must hold as well: their rule is not monotone."""

FORCE_DIGIT = 10.0
"""Last digit a force is written with [N/m]: it is rounded up."""

MAX_FORCE = 1e7
"""Largest force that is tried [N/m]."""

ASSUMED_LENGTH = 10.0
"""Length of a bar that nobody describes [m], and the elongation it stands: whatever the displacement check asks."""

STRENGTH_CURVE = 13
"""Heights of the curve of forces."""

MIN_TIE_HEIGHT = 0.3
"""Height of the lowest tie of that curve, of the wall [-]."""


@dataclass(frozen=True)
class TieDesign:
    """A tie for the zeta required, of all hinges of the wall below it.

    height : above the base of the wall [m]
    forces : by FORCE_NAMES [N/m]: the largest that a hinge asks; 0 where none is needed, None where none does it, where
        a hinge at or above the tie fails, where the state has no such check, or where `missing` says so
    missing : why there is none of the histories: "histories" without records, "bar" without a length of the bar, which
        they need, "none" where none does it; "" where there is one
    force, check : the one named, the largest of the deciding ones, and which it is; None where one of these is not
        known or none does it, or beyond `largest` where the wall does not hold as it bends
    asked : the largest of these, also beyond `largest` [N/m]; None where one is not known, or none does it
    at_least : the largest of those that are known [N/m], where one is not
    largest : up to which the wall turns as one block about each of its hinges [N/m]
    bending : the lowest zeta of the wall as it bends between its base and a tie beyond that; None where it does not
        reach the one required, or cannot be known
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
    bending: float | None = None


@dataclass(frozen=True)
class Hinge:
    """A hinge of a wall with a tie to design.

    height : above the base of the wall [m]; scene : of the part above it, without the tie
    dynamic : its check without the tie, None without histories
    """

    height: float
    scene: CheckInput
    dynamic: DynamicCheck | None

    @property
    def satisfied(self) -> bool:
        """Whether its histories surely are."""
        return self.dynamic is not None and self.dynamic.satisfied(self.scene.demand.zeta_target)

    def raised(self, height: float) -> float:
        """Height of a tie above this hinge [m], of one `height` above the base."""
        return height - self.height


def add_tie(wall: Wall, force: float, height: float) -> Wall:
    """The wall with one more tie of this force at yield [N/m], at this height above its hinge [m]."""
    if force <= 0.0:
        return wall
    sought = wall.sought
    length = sought.bar_length_m if sought else None
    stands = sought.elongation_m if sought and length else ASSUMED_LENGTH
    tie = Hold(TIE, h_m=height, out_kn_m=1e-3 * force, bar_length_m=length or ASSUMED_LENGTH, elongation_m=stands)
    return replace(wall, hold=(*wall.hold, tie))


def design_tie(hinges: Sequence[Hinge], asked: Wall, cancelled: Callable[[], bool] = lambda: False) -> TieDesign:
    """The tie for all hinges of a wall, the base first. asked : the wall of the case. Raises Cancelled."""
    sought, top = require_value(asked.sought), require_value(asked.height_m)
    height, length, spacing = require_value(sought.h_m), sought.bar_length_m, sought.spacing_m
    below = [hinge for hinge in hinges if hinge.scene.wall.sought is not None]
    above = [hinge for hinge in hinges if hinge.scene.wall.sought is None]
    largest = min(_largest(hinge, height) for hinge in below)
    holds, bending = _bending(below[0], MAX_FORCE, height, cancelled)
    strongest = MAX_FORCE if holds else largest
    forces = _forces(below, above, height, cancelled)
    missing = "histories" if any(hinge.dynamic is None for hinge in hinges) else ""
    missing = missing or ("bar" if length is None else "")
    forces["dynamic"] = None
    if not missing:
        forces["dynamic"] = _of_histories(below, above, height, strongest, forces, cancelled)
        missing = "none" if forces["dynamic"] is None else ""
    named = _deciding(below[0].scene, missing != "histories")
    known = {name: force for name in named if (force := forces[name]) is not None}
    unknown = missing == "bar" and "dynamic" in named
    most = max(known.values()) if len(known) == len(named) else None
    at_least = max(known.values()) if unknown and len(known) == len(named) - 1 else None
    force = check = None
    largest, strongest = _as_it_bends(below[0], most, height, (largest, strongest), cancelled)
    if most is not None and most <= strongest:
        force, check = written_up(most, FORCE_DIGIT), max(known, key=lambda name: known[name])
    zeta, elongation, bars = {}, dict.fromkeys(("demand", "d_slv", "d_0")), (None, None)
    stands, more = None, False
    if force is not None:
        zeta, elongation = _with(below, height, force, missing, cancelled)
        if spacing is not None:
            bars = ties.bars_for(force, spacing)
    if length is not None:
        tie = add_tie(below[0].scene.wall, 1.0, height).hold[-1].tie(asked.length_m)
        stands, more = tie.bar.stands, tie.stands_more
    curve = tuple(
        (float(h), _at_height(hinges, float(h))) for h in np.linspace(MIN_TIE_HEIGHT * top, top, STRENGTH_CURVE)
    )
    return TieDesign(
        height,
        {name: forces[name] for name in FORCE_NAMES},
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
        spacing,
        curve,
        more,
        bending,
    )


def _forces(
    below: Sequence[Hinge], above: Sequence[Hinge], height: float, cancelled: Callable[[], bool]
) -> dict[str, float | None]:
    """Forces by the checks of the clauses and the thrust [N/m]; none of a wall that fails as it bends below the ties it
    has: no further one mends that. Raises Cancelled."""
    if _bending(below[0], 0.0, height, cancelled)[0] is False:
        return dict.fromkeys(FORCE_NAMES)
    return {name: _force(name, below, above, height) for name in FORCE_NAMES[1:]}


def _as_it_bends(
    base: Hinge, force: float | None, height: float, most: tuple[float, float], cancelled: Callable[[], bool]
) -> tuple[float, float]:
    """(force up to which the wall turns as one block, force that may be named) [N/m], both below a force with which it
    fails as it bends. Raises Cancelled."""
    if force is None or force > most[0] or _bending(base, force, height, cancelled)[0] is not False:
        return most
    return force - FORCE_DIGIT, force - FORCE_DIGIT


def _bending(base: Hinge, force: float, height: float, cancelled: Callable[[], bool]) -> tuple[bool | None, Any]:
    """(whether the wall holds as it bends below its ties and one of this force, its lowest zeta there); None where it
    does not bend, or what moves it there is not known. Raises Cancelled."""
    if base.height > 0.0:
        return None, None
    tied = add_tie(base.scene.wall, force, height)
    below = _holds_as_it_bends(base, [cut_span(tied, *span) for span in find_bending_spans(tied)], cancelled)
    if below[0] is not False:
        return below
    between = _holds_as_it_bends(base, [stretch.wall for stretch in find_held_stretches(tied)], cancelled)
    return below if between[0] is None else between


def _holds_as_it_bends(
    base: Hinge, parts: list[Wall], cancelled: Callable[[], bool]
) -> tuple[bool | None, float | None]:
    """`_bending` of some stretches."""
    zetas = []
    for part in parts:
        try:
            evaluation = evaluate(
                base.scene.replace_parts(wall=part, mechanism=part.mechanism), other=False, cancelled=cancelled
            )
        except InputError:
            return False, None
        if evaluation.kinematic is None or evaluation.decides is None:
            return None, None
        if not evaluation.satisfied:
            return False, evaluation.zeta
        zetas.append(evaluation.zeta)
    return (True, min_if_all_known(zetas)) if zetas else (None, None)


def _deciding(scene: CheckInput, histories: bool) -> list[str]:
    """Names of the forces of which the largest is named: those of the thrust and of the checks that decide about the
    wall. histories : it has some"""
    if scene.demand.limit_state == "SLD":
        return ["linear_q_code", "thrust"]
    made = [name for name, there in (("dynamic", histories), ("nonlinear", _made("nonlinear", scene))) if there]
    return [*(made or ["linear_q_code"]), "thrust"]


def _made(name: str, scene: CheckInput) -> bool:
    """Whether a check of the clauses can be made of the wall."""
    return _zeta(name, scene, scene.wall) is not None


def _largest(hinge: Hinge, height: float) -> float:
    """Force [N/m] up to which the part above a hinge turns about it as one block."""
    wall, above = hinge.scene.wall, hinge.raised(height)
    weight = wall.in_si.weight + wall.in_si.vertical_loads
    limit = find_boundary(
        lambda force: carries(add_tie(wall, force, above)), weight, (FORCE_DIGIT, MAX_FORCE), False, 2.0, 1e-9
    )
    return limit.good or 0.0


def _zeta(name: str, scene: CheckInput, wall: Wall) -> float | None:
    """zeta of a check of the clauses of a wall; None where it cannot be made."""
    demand = replace(scene.demand, q_code=1.0) if name == "linear_q_1" else scene.demand
    try:
        evaluation = evaluate(scene.without_records().replace_parts(wall=wall, demand=demand))
    except InputError:
        return None
    check = evaluation.made("nonlinear" if name == "nonlinear" else "linear_q_code")
    return check.zeta if check else None


def _force(name: str, below: Sequence[Hinge], above: Sequence[Hinge], height: float) -> float | None:
    """Force by a check of the clauses [N/m], or by the thrust at rest; None where none does it."""
    if name == "linear_q_slv":
        return None  # q SLV counts from the uplift of the wall without its ties: no force raises it but by histories
    if name == AT_REST:
        return max(_thrust(hinge, height) for hinge in below)
    target = below[0].scene.demand.zeta_target
    if any(not _reaches(_zeta(name, hinge.scene, hinge.scene.wall), target) for hinge in above):
        return None
    forces = [_least(name, hinge, hinge.raised(height), target) for hinge in below]
    known = [force for force in forces if force is not None]
    return max(known) if len(known) == len(forces) else None


def _reaches(zeta: float | None, target: float) -> bool:
    return zeta is not None and zeta >= target - ZETA_ROUNDING


def _thrust(hinge: Hinge, height: float) -> float:
    """Force at rest that balances the thrusts on the part above a hinge [N/m]."""
    wall = hinge.scene.wall
    outward = [load_to_force(load, wall.in_si, 1.0) for load in wall.in_si.loads if load.is_thrust]
    return max(0.0, -sum(force.horizontal * force.height for force in outward) / hinge.raised(height))


def _least(name: str, hinge: Hinge, above: float, target: float) -> float | None:
    """Least force of a tie at this height above a hinge [m] with which a check of the clauses is satisfied [N/m]."""
    scene = hinge.scene

    def holds(force: float) -> bool:
        return _reaches(_zeta(name, scene, add_tie(scene.wall, force, above)), target)

    if holds(0.0):
        return 0.0
    return find_boundary(holds, 1e3, (FORCE_DIGIT, MAX_FORCE), True, 2.0, FORCE_TOLERANCE).good


def _held(hinge: Hinge, force: float, height: float, precision: Precision, cancelled) -> Evaluation:
    """Checks of a hinge with the tie."""
    wall = add_tie(hinge.scene.wall, force, hinge.raised(height))
    return evaluate(hinge.scene.replace_parts(wall=wall), precision, other=False, cancelled=cancelled)


def _of_histories(
    below: Sequence[Hinge], above: Sequence[Hinge], height: float, largest: float, others: dict, cancelled
) -> float | None:
    """Least force found with which the dynamic check of every hinge holds [N/m]; None where none does up to the
    largest. Whether its rule holds is not monotone: near what a glance finds the force is raised until a run holds, and
    does a little beyond.

    others : forces of the other checks, from which the search starts
    """
    if not all(hinge.satisfied for hinge in above):
        return None
    if all(hinge.satisfied for hinge in below):
        return 0.0

    def holds(force: float, precision: Precision = COARSE_PRECISION) -> bool:
        return all(_held(hinge, force, height, precision, cancelled).satisfied for hinge in below)

    start = min(others["linear_q_code"] or 1e4, largest)
    candidate = find_boundary(holds, start, (FORCE_DIGIT, largest), True, 2.0, FORCE_TOLERANCE_BY_HISTORIES).good
    while candidate is not None:
        candidate = written_up(candidate, FORCE_DIGIT)
        more = written_up(FORCE_MARGIN * candidate, FORCE_DIGIT)
        if candidate > largest:
            return None
        if holds(candidate, FULL_PRECISION) and (more > largest or holds(more, FULL_PRECISION)):
            return candidate
        candidate = more
    return None


def _with(
    below: Sequence[Hinge], height: float, force: float, missing: str, cancelled
) -> tuple[dict[str, float | None], dict[str, float | None]]:
    """(zeta of each check with a tie of this force, the least of all hinges; elongations of its bar about the base)."""
    names = ("nonlinear", "linear_q_code", "linear_q_1")
    walls = [(hinge.scene, add_tie(hinge.scene.wall, force, hinge.raised(height))) for hinge in below]
    zeta = {name: min_if_all_known(_zeta(name, scene, wall) for scene, wall in walls) for name in names}
    base, wall = walls[0]
    elongation: dict[str, float | None] = dict.fromkeys(("demand", "d_slv", "d_0"))
    theta_c = make_rocking_model(wall, base.mechanism).collapse_rotation
    elongation["d_0"] = height * math.sin(theta_c)
    kinematic = base.without_records().replace_parts(wall=wall).kinematic
    if kinematic is not None and kinematic.d_limit is not None:
        elongation["d_slv"] = height * math.sin(kinematic.chain.rotation(kinematic.d_limit))
    if not missing:
        held = [_held(hinge, force, height, FULL_PRECISION, cancelled).dynamic for hinge in below]
        zeta["dynamic"] = min_if_all_known(check.zeta if check else None for check in held)
        if held[0] is not None and held[0].max_peak_ratio is not None:
            elongation["demand"] = height * math.sin(held[0].max_peak_ratio * theta_c)
    return zeta, elongation


def _at_height(hinges: Sequence[Hinge], height: float) -> float | None:
    """Force of the displacement check of a tie at another height [N/m]; None where none does it."""
    walls, sought = [hinge.scene.wall.without_sought() for hinge in hinges], require_value(hinges[0].scene.wall.sought)
    placed = [replace(sought, h_m=hinge.raised(height)) for hinge in hinges]
    moved = [replace(wall, hold=(*wall.hold, tie)) for wall, tie in zip(walls, placed, strict=True)]
    all_hinges = [
        replace(hinge, scene=replace(hinge.scene, wall=wall)) for hinge, wall in zip(hinges, moved, strict=True)
    ]
    below = [hinge for hinge in all_hinges if hinge.raised(height) > 0.0]
    return _force("nonlinear", below, [hinge for hinge in all_hinges if hinge not in below], height)
