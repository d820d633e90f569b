"""The checks of one wall at the demand, and its verdict."""

from collections.abc import Callable

from core.capacity.ida import Search
from core.codes.demand import DemandResult
from core.codes.dynamic_check import BOUND_STEP, demand_check
from core.codes.kinematic import Kinematic, linear, nonlinear, sld
from core.codes.multiplier_search import STEP
from core.codes.record_compatibility import Compliance
from core.codes.verdict import Circumstances, verdict
from core.ground.ground_motion import GroundMotion
from core.rocking.methods import Method
from core.study.results import Assessment, WallResult
from core.wall.restitution import restitution
from core.wall.rocking_model import rocking_model

EXACT_METHODS = ("auto", "taylor", "taylor_6", "dormand_prince")
"""Methods whose result a verdict may rest on; the others are for comparison."""

BUNDLED = "# Ribalta example motion"
"""How the header of a bundled motion begins."""


def is_bundled(motion: GroundMotion) -> bool:
    """Whether a motion is one of the example's."""
    return any(value.startswith(BUNDLED) for _, value in motion.details)


def _reached(wall: WallResult, demand: DemandResult, search: Search) -> list[float] | None:
    """q of each run at its first peak of the limit, the last q searched where it had none; None if a run
    ended without a number."""
    if any(run.ida.status == "impact_limit" for run in wall.runs):
        return None
    name = "q_slc" if demand.limit_state == "SLC" else "q_slv"
    values = [getattr(run.ida, name) for run in wall.runs]
    # a wall that falls has reached the limit: without that q a midpoint of its bracket is unknown
    if any(q is None and run.ida.q is not None for q, run in zip(values, wall.runs, strict=True)):
        return None
    return [search.q_limit if q is None else q for q in values]


def assess(
    wall: WallResult,
    kinematic: Kinematic | None,
    motions: list[GroundMotion],
    polarities: tuple[int, ...],
    demand: DemandResult,
    compliance: Compliance | None,
    method: Method,
    search: Search,
    cancelled: Callable[[], bool] = lambda: False,
) -> Assessment:
    """Dynamic, kinematic and simplified checks of a wall (Circolare 7/2019 C8.7.1.2.1); above the ground none, since
    the motion of its floor is not known.

    kinematic : its mechanism, None there
    search : of the runs
    Raises Cancelled.
    """
    asked = wall.wall
    strongest = max((demand.scaling(m) * m.pga for m in motions), default=0.0)
    doubtful = Circumstances(
        records=len(motions),
        bundled=any(is_bundled(motion) for motion in motions),
        strongest=strongest,
        both_signs=wall.mechanism == "two_sided" or len(polarities) == 2,
        exact=method.name in EXACT_METHODS,
    )
    if kinematic is None:
        result = verdict(
            asked, wall.mechanism, demand, (), None, None, compliance, doubtful, None
        )  # fmt: skip
        return Assessment(None, (), None, None, result)
    reached = _reached(wall, demand, search)
    dynamic = demand_check(
        wall.model, motions, polarities, demand, method, reached, STEP, True, cancelled
    )
    below = None
    if dynamic and asked.mechanism == "one_sided":
        free = restitution(wall.block, "housner")
        model = rocking_model(wall.block, False, free, wall.law)
        below = demand_check(
            model, motions, (1,), demand, method, None, BOUND_STEP, False, cancelled
        )
    rows = [dynamic.as_check() if dynamic else None, nonlinear(kinematic, demand)]
    if demand.limit_state == "SLD":
        rows.append(sld(kinematic, demand))
    elif demand.limit_state == "SLV":
        if wall.q_slv_set is not None:
            rows.append(linear("linear_q_slv", kinematic, demand, wall.q_slv_set))
        rows.append(linear("linear_q_code", kinematic, demand, demand.q_code))
    checks = tuple(check for check in rows if check is not None)
    lower = below.zeta if below else None
    result = verdict(
        asked, wall.mechanism, demand, checks, dynamic, kinematic, compliance, doubtful, lower
    )
    return Assessment(kinematic, checks, dynamic, below, result)
