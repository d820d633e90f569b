"""The checks of one wall at the demand, and its verdict."""

from collections.abc import Callable

from core.case.site import Building, Demand
from core.codes.demand import DemandResult
from core.codes.dynamic_check import BOUND_EVERY, DemandCheck, demand_check
from core.codes.kinematic import Check, Kinematic, checks_of, linear, with_and_without_ties
from core.codes.kinematic_chain import chain
from core.codes.limits import counted_stations
from core.codes.record_compatibility import Compliance
from core.codes.risk import Risk, risk
from core.codes.verdict import Circumstances, Verdict, governing_check, verdict
from core.ground.ground_motion import GroundMotion
from core.rocking.methods import Method
from core.study.floors import LOW_CODE, building_notes
from core.study.held_top import limits_of_bending, overturning_zeta
from core.study.lifts import lifts
from core.study.results import Assessment, WallResult
from core.study.zeta_with import Scene, model_of
from core.text.sentence import Number, Sentence, sentence
from core.wall.restitution import restitution
from core.wall.rocking_model import RockingModel, rocking_model
from core.wall.wall_loads import contact_of, rocks_both_ways, without_ties

EXACT_METHODS = ("auto", "taylor", "taylor_6", "dormand_prince")
"""Methods whose result a verdict may rest on; the others are for comparison."""

OF_THE_FLOOR = ("other_building", "at_centroid")
"""Codes of what lifts zeta above the ground."""

GENERATED = "generated"
"""Format of the motions of [generate]."""

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
    asked: Demand | None = None,
    building: Building | None = None,
    ground: list[GroundMotion] | None = None,
    dynamic_check: Callable = demand_check,
) -> Assessment:
    """Dynamic, kinematic and simplified checks of a wall (Circolare 7/2019 C8.7.1.2.1); above the ground none where
    the motion of its floor is not known.

    wall : with its q
    kinematic : its mechanism, None there
    motions : of the ground, or of the floor of the wall
    polarities : signs each is taken with, 1 as recorded, -1 reversed
    demand : what is required
    compliance : of the records with the spectrum, None without a spectrum
    method : how the motion is integrated
    cancelled : asked between two chunks of analyses
    asked : demand of the case
    building, ground : of a wall above the ground, what carries it and the records
    dynamic_check : `demand_check`, or one that keeps its results
    Raises Cancelled.
    """
    own = wall.wall
    doubtful = _circumstances(wall, motions, polarities, demand, method)
    if kinematic is None:
        result = verdict(own, wall.mechanism, demand, (), None, None, compliance, doubtful, None)
        return Assessment(None, (), None, None, result)
    dynamic = dynamic_check(wall.model, motions, polarities, demand, method, cancelled=cancelled)
    below = None
    if dynamic and own.mechanism == "one_sided" and rocks_both_ways(own):
        model, signs = _without_restraint(wall)
        below = dynamic_check(model, motions, signs, demand, method, BOUND_EVERY, False, cancelled)
    checks, limits = _checks(wall, kinematic, demand, dynamic)
    decides = governing_check(checks)
    known = decides is not None and decides.zeta is not None
    grounds = tuple(ground or motions)
    scene = Scene(
        own, wall.mechanism, demand, building, grounds, polarities, method, decides, wall.floor, dynamic_check
    )
    raised = lifts(scene, asked, checks, cancelled) if known and asked else ()
    ratio = wall.floor.code_over_records(kinematic) if wall.floor is not None else None
    if wall.floor is not None:
        limits += building_notes(building, demand.limit_state)
    if ratio is not None and ratio < LOW_CODE:
        limits.append(sentence("reason", "code_below_records", ratio=ratio))
    if dynamic and any(motion.format == GENERATED for motion in grounds):
        limits.append(sentence("reason", "generated_motions"))
    limits += limits_of_bending(kinematic)
    limits += _of_ties_not_counted(own, wall.mechanism == "two_sided", kinematic, demand, checks)
    if any(load.is_tie for load in own.load):
        bare = model_of(without_ties(own), wall.mechanism)
        free = dynamic and dynamic_check(bare, motions, polarities, demand, method, 1, False, cancelled)
        limits += _of_ties_that_lower(kinematic, demand, dynamic, free)
    result = verdict(
        own,
        wall.mechanism,
        demand,
        checks,
        dynamic,
        kinematic,
        compliance,
        doubtful,
        below.zeta if below else overturning_zeta(own, demand, building),
        tuple(limits),
        raised,
    )
    capacity = _capacity(result, demand, dynamic)
    sensitivity = {lift.words.code: lift.zeta for lift in raised if lift.words.code in OF_THE_FLOOR}
    return Assessment(kinematic, checks, dynamic, below, result, sensitivity, ratio, capacity)


def _of_ties_not_counted(
    wall, two_sided: bool, kinematic: Kinematic, demand: DemandResult, checks: tuple[Check, ...]
) -> list[Sentence]:
    """What the clauses do not count of ties; the other reading of SLD is shown, not taken."""
    if not any(load.is_tie for load in wall.load):
        return []
    if demand.limit_state == "SLD" and kinematic.zeta_sld is not None:
        alpha, share, _ = chain(wall, two_sided).start
        zeta = kinematic.zeta_sld * (alpha / share) / (kinematic.alpha0 / kinematic.e_star)
        return [sentence("reason", "ties_at_sld", zeta=Number(zeta))]
    if any(load.slack_mm for load in wall.load) and any(check.name != "dynamic" for check in checks):
        return [sentence("reason", "slack_not_counted")]
    return []


def _of_ties_that_lower(
    kinematic: Kinematic, demand: DemandResult, dynamic: DemandCheck | None, free: DemandCheck | None
) -> list[Sentence]:
    """zeta with the ties of a wall and without them. free : the dynamic check without them"""
    said = []
    if pair := with_and_without_ties(kinematic, demand):
        said.append(sentence("reason", "ties_displacement", tied=Number(pair[0]), bare=Number(pair[1])))
    tied, bare = dynamic and dynamic.zeta, free and free.zeta
    if tied is not None and bare is not None and round(bare, 2) > round(tied, 2):
        said.append(sentence("reason", "ties_histories", tied=Number(tied), bare=Number(bare)))
    return said


def _circumstances(wall: WallResult, motions, polarities, demand: DemandResult, method: Method) -> Circumstances:
    """What the verdict must know beside the checks. motions, polarities : as `assess` takes them"""
    return Circumstances(
        stations=len(counted_stations(motions, demand)),
        bundled=any(is_bundled(motion) for motion in motions),
        strongest=max((demand.scaling(m) * m.pga for m in motions), default=0.0),
        both_signs=wall.model.both_signs_alike or len(polarities) == 2,
        period_estimated=wall.floor is not None and wall.floor.estimated,
        exact=method.name in EXACT_METHODS,
    )


def _without_restraint(wall: WallResult) -> tuple[RockingModel, tuple[int, ...]]:
    """A one-sided wall as it rocks both ways where what restrains it fails, and the signs of its records."""
    free = restitution(wall.block, "housner", contact=contact_of(wall.wall))
    loads, bars, inner = wall.wall.restoring(), wall.wall.bars(), wall.wall.inner_block()
    model = rocking_model(wall.block, False, free, wall.law, loads, bars, inner)
    return model, (1,) if model.both_signs_alike else (1, -1)


def _checks(
    wall: WallResult, kinematic: Kinematic, demand: DemandResult, dynamic: DemandCheck | None
) -> tuple[tuple[Check, ...], list[Sentence]]:
    """(the checks that can be made, what the linear one with the wall's own q is to be read with)."""
    # our q is counted from uplift at alpha_0 g: a0*, which e* raises, must not count it twice; and of the wall without
    # its ties, which do not hold it at rest, and without the friction of return walls
    counted, bare = kinematic.e_star, kinematic.chain.alpha0_bare
    if kinematic.alpha0 > bare:
        counted *= bare / kinematic.alpha0
    low, high = (None if q is None else q * counted for q in (wall.q_slv_low_set, wall.q_slv_set))
    made, limits = checks_of(kinematic, demand, low), []
    lower = next((check for check in made if check.name == "linear_q_slv"), None)
    if lower and not lower.passed and linear("linear_q_slv", kinematic, demand, high).passed:
        limits.append(sentence("reason", "lower_q_slv", low=wall.q_slv_low_set, q=wall.q_slv_set))
    return ((dynamic.as_check(),) if dynamic else ()) + made, limits


def _capacity(result: Verdict, demand: DemandResult, dynamic: DemandCheck | None) -> Risk | None:
    """PGA the wall withstands and its return period, None where zeta_E tells neither."""
    histories = dynamic if result.governing == "dynamic" else None
    # records weaker than the demand tell nothing of a PGA
    if result.zeta_e is None or (histories and demand.weak_share is not None):
        return None
    least = histories.zeta_spread[0] if histories and histories.zeta_spread else None
    return risk(result.zeta_e, demand, least)
