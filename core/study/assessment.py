"""The checks of one wall at the demand, and its verdict."""

from collections.abc import Callable

from core.case.site import Building
from core.codes.demand import DemandResult
from core.codes.dynamic_check import BOUND_EVERY, demand_check
from core.codes.kinematic import Check, Kinematic, linear, nonlinear, sld
from core.codes.kinematic import kinematic as kinematic_of
from core.codes.record_compatibility import Compliance
from core.codes.risk import risk
from core.codes.verdict import Circumstances, governing_check, verdict
from core.ground.ground_motion import GroundMotion
from core.ground.provenance import stations
from core.rocking.methods import Method
from core.study.floors import LOW_CODE, building_notes, floor_of, other_end
from core.study.results import Assessment, WallResult
from core.study.tie_design import tie_design, with_tie
from core.text.sentence import Number, Sentence, sentence
from core.wall.restitution import restitution
from core.wall.rocking_model import rocking_model
from core.wall.wall_loads import rocks_both_ways

EXACT_METHODS = ("auto", "taylor", "taylor_6", "dormand_prince")
"""Methods whose result a verdict may rest on; the others are for comparison."""

SENSITIVITY_EVERY = 8
"""Every how many points of the grid zeta is searched for another building and another height: by 2 %, the digits given
are two."""

BUNDLED = "# Ribalta example motion"
"""How the header of a bundled motion begins."""


def is_bundled(motion: GroundMotion) -> bool:
    """Whether a motion is one of the example's."""
    return any(value.startswith(BUNDLED) for _, value in motion.details)


def assess(
    wall: WallResult,
    kinematic: Kinematic | None,
    motions: list[GroundMotion],
    polarities: tuple[int, ...],
    demand: DemandResult,
    compliance: Compliance | None,
    method: Method,
    cancelled: Callable[[], bool] = lambda: False,
    building: Building | None = None,
    ground: list[GroundMotion] | None = None,
    dynamic_check: Callable = demand_check,
) -> Assessment:
    """Dynamic, kinematic and simplified checks of a wall (Circolare 7/2019 C8.7.1.2.1); above the ground none where
    the motion of its floor is not known.

    kinematic : its mechanism, None there
    motions : of the ground, or of the floor of the wall
    building, ground : of a wall above the ground, what carries it and the records
    dynamic_check : `demand_check`, or one that keeps its results
    Raises Cancelled.
    """
    asked = wall.wall
    strongest = max((demand.scaling(m) * m.pga for m in motions), default=0.0)
    doubtful = Circumstances(
        stations=len(stations(motions)),
        bundled=any(is_bundled(motion) for motion in motions),
        strongest=strongest,
        both_signs=wall.model.both_signs_alike or len(polarities) == 2,
        period_estimated=wall.floor is not None and wall.floor.estimated,
        exact=method.name in EXACT_METHODS,
    )
    if kinematic is None:
        result = verdict(
            asked, wall.mechanism, demand, (), None, None, compliance, doubtful, None
        )  # fmt: skip
        return Assessment(None, (), None, None, result)
    dynamic = dynamic_check(wall.model, motions, polarities, demand, method, cancelled=cancelled)
    below = None
    if dynamic and asked.mechanism == "one_sided" and rocks_both_ways(asked):
        free = restitution(wall.block, "housner")
        model = rocking_model(wall.block, False, free, wall.law, asked.restoring())
        signs = (1,) if model.both_signs_alike else (1, -1)
        below = dynamic_check(model, motions, signs, demand, method, BOUND_EVERY, False, cancelled)
    notes: list[Sentence] = []
    rows = [dynamic.as_check() if dynamic else None, nonlinear(kinematic, demand)]
    if demand.limit_state == "SLD":
        rows.append(sld(kinematic, demand))
    elif demand.limit_state == "SLV":
        if wall.q_slv_low_set is not None:
            # our q is counted from uplift at alpha_0 g: a0*, which e* raises, must not count it twice; and of the wall
            # without the friction of return walls, which must not raise what the histories lead to
            counted = kinematic.e_star
            if kinematic.alpha0 > kinematic.chain.alpha0:
                counted *= kinematic.chain.alpha0 / kinematic.alpha0
            own, upper = (
                linear("linear_q_slv", kinematic, demand, q * counted)
                for q in (wall.q_slv_low_set, wall.q_slv_set)
            )
            rows.append(own)
            if own and upper.passed and not own.passed:
                notes.append(
                    sentence("reason", "lower_q_slv", low=wall.q_slv_low_set, q=wall.q_slv_set)
                )
        rows.append(linear("linear_q_code", kinematic, demand, demand.q_code))
    checks = tuple(check for check in rows if check is not None)
    lower = below.zeta if below else None
    sensitivity, ratio = {}, None
    if wall.floor is not None:
        decides = governing_check(checks)
        if decides is not None and decides.zeta is not None:
            sensitivity = _sensitivity(
                wall, decides, building, ground or [], polarities, demand, method, cancelled, dynamic_check,
            )  # fmt: skip
        ratio = wall.floor.code_over_records(kinematic)
        notes += _floor_notes(wall, building, demand, ratio, sensitivity)
    result = verdict(
        asked,
        wall.mechanism,
        demand,
        checks,
        dynamic,
        kinematic,
        compliance,
        doubtful,
        lower,
        tuple(notes),
    )
    unknown = result.zeta_e is None
    if (
        dynamic and result.governing == "dynamic"
    ):  # records weaker than the demand tell nothing of a PGA
        unknown = unknown or demand.weak_share is not None
    least = (
        dynamic.zeta_spread[0]
        if dynamic and result.governing == "dynamic" and dynamic.zeta_spread
        else None
    )
    capacity = None if unknown else risk(result.zeta_e, demand, least)
    tie = None
    if (
        asked.tie_height_m is not None
        and wall.mechanism == "one_sided"
        and result.zeta_e is not None
    ):
        decides = governing_check(checks)

        def judged_with(force: float, every: int) -> tuple[float | None, bool]:
            held = with_tie(asked, force)
            model = rocking_model(held.block(), True, wall.restitution, wall.law, held.restoring())
            return judged(
                decides, held, wall.mechanism, model, kinematic.floor, motions, polarities, demand,
                method, every, cancelled, dynamic_check,
            )  # fmt: skip

        sure = decides.passed and not (dynamic and decides.name == "dynamic"
                                       and dynamic.within_spread(demand.zeta_target))  # fmt: skip
        tie = tie_design(asked, (result.zeta_e, bool(sure)), decides.label, judged_with)
    return Assessment(kinematic, checks, dynamic, below, result, sensitivity, ratio, capacity, tie)


def _sensitivity(
    wall: WallResult,
    decides: Check,
    building,
    ground,
    polarities,
    demand,
    method,
    cancelled,
    dynamic_check,
) -> dict[str, float | None]:
    """zeta of the check that decides with the building at the other end of what C8.7.1.2.1.4 allows, and with
    the motion at the height of the wall's centroid."""
    cases: dict[str, dict] = {}
    if (other := other_end(building, demand.limit_state)) is not None:
        cases["other_building"] = {"other": other}
    z = _centroid(wall, building)
    if (
        not building.modes and z > wall.wall.base_z_m
    ):  # the participation of given modes is that at the wall
        cases["at_centroid"] = {"z": z}
    found = {}
    for name, change in cases.items():
        floor = floor_of(wall.wall, building, demand, ground, **change)
        found[name], _ = judged(
            decides, wall.wall, wall.mechanism, wall.model, floor.spectrum, list(floor.motions),
            polarities, demand, method, SENSITIVITY_EVERY, cancelled, dynamic_check,
        )  # fmt: skip
    return found


def judged(
    decides: Check, wall, mechanism, model, spectrum, motions, polarities, demand, method, every,
    cancelled, dynamic_check,
) -> tuple[float | None, bool]:  # fmt: skip
    """(zeta of the check that decides for another wall, model, floor or motions, whether it is surely satisfied).
    spectrum : of the floor, None on the ground; every : of the search of the dynamic check."""
    if decides.name == "dynamic":
        dynamic = dynamic_check(model, motions, polarities, demand, method, every, False, cancelled)
        return dynamic.zeta, dynamic.passed and not dynamic.within_spread(demand.zeta_target)
    moved = kinematic_of(wall, mechanism, demand, spectrum)
    if decides.name == "nonlinear":
        check = nonlinear(moved, demand)
    elif demand.limit_state == "SLD":
        check = sld(moved, demand)
    else:
        check = linear(decides.name, moved, demand, decides.q)
    return (check.zeta, bool(check.passed)) if check else (None, False)


def _centroid(wall: WallResult, building: Building) -> float:
    """Height of the centroid of a wall [m], at most that of the building."""
    return min(wall.wall.base_z_m + 0.5 * wall.height, building.height_m)


def _floor_notes(wall, building, demand, ratio: float | None, sensitivity) -> list[Sentence]:
    """What is said of the floor beside the verdict. ratio : of `Floor.code_over_records`."""
    notes = building_notes(building, demand.limit_state)

    def words(name: str) -> Number:
        return Number(sensitivity[name])

    if "other_building" in sensitivity:
        factor, damping = other_end(building, demand.limit_state)
        notes.append(
            sentence("reason", "other_building", factor=factor, damping=damping, zeta=words("other_building"))
        )  # fmt: skip
    if "at_centroid" in sensitivity:
        z = _centroid(wall, building)
        notes.append(sentence("reason", "at_centroid", z=z, zeta=words("at_centroid")))
    if ratio is not None and ratio < LOW_CODE:
        notes.append(sentence("reason", "code_below_records", ratio=ratio))
    return notes
