"""The checks of one wall at the demand, what raises zeta, and its verdict."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

from core.case.document import PRESENCE, STRENGTH, document_of
from core.case.load_rules import carries
from core.case.wall import Wall
from core.codes.assumption import ARCH, DECLARED, LEFT_OUT, RESTRAINT, Assumption
from core.codes.dynamic_check import DynamicCheck
from core.codes.elastic_branch import Branch
from core.codes.kinematic import SLD_CLAUSE, Check, KinematicAnalysis, zeta_with_and_without_ties
from core.codes.kinematic_chain import sum_chain
from core.codes.limits import ORDINARY_LIFE
from core.codes.risk import Risk, risk_of_mechanism
from core.codes.verdict import Verdict, make_verdict, passes_with_q2
from core.codes.verdict_sentence import restraint_phrase
from core.errors import InputError
from core.ground.record_folder import is_doubtful
from core.known import require_value
from core.mechanism.holds import BASE, ENDS, FOOT, STUB, TOP
from core.setting.check_input import CheckInput
from core.setting.floors import FAR_BELOW, LOW_CODE, building_notes
from core.text.sentence import Key, Number, Sentence, sentence
from core.units import G
from core.variation.assumptions import evaluate_assumptions
from core.variation.changes import has_own_thickness, rescale_thickness
from core.variation.evaluate import Evaluation, check_by_histories, evaluate
from core.variation.hold_check import Reaction, find_open_impulse, find_reactions
from core.variation.second_level import UnaskedRange, find_unasked_range
from core.variation.turning_holds import reactions_of_turning
from core.wall.arch import Arch

TRIAL_THICKNESS_FACTORS = (1.05, 1.1, 1.2, 1.3)
"""Multiples of the thickness at which zeta is looked at as well."""

GENERATED = "generated"
"""Format of the motions of [generate]."""


@dataclass(frozen=True)
class LimitStateCheck:
    """A wall about one hinge at one limit state, evaluated as at that of the demand: by its kinematic checks, linear at
    SLD, displacement and linear with q of the code at SLV, displacement at SLC; by time histories where they are asked
    for.

    return_period : T_R [years]; ag : on rock [m/s2]
    code : of the table of outcomes
    check : label of the one that decides, or would; zeta : of it, None where none could be made
    zeta_target : required
    checks : those that could be made, the most refined first
    """

    state: str
    return_period: float
    ag: float
    code: str
    check: str
    zeta: float | None
    zeta_target: float
    checks: tuple[Check, ...] = ()


@dataclass(frozen=True)
class Assessment:
    """Checks of one wall at the demand.

    kinematic : quantities of the mechanism, None above the ground
    checks : the table of methods, the most refined first
    dynamic : None without records
    lower_bound : the dynamic check of the two-sided wall, should the restraint behind a one-sided one fail
    bound_passes : whether the wall surely passes without what restrains it; None where nothing does
    unasked : the range of zeta over what no clause asks about, None where nothing moves it
    code_over_records : of `Floor.code_over_records`
    risk : of the check that decides, None where it has no zeta
    states : zeta at SLD, SLV and SLC by the hazard of the site, empty without it
    reactions : of what holds a wall that bends, where its strength is known
    loses_hold : what decides is a hold that gives way while the wall is at rest
    beside : time histories where they decide nothing, None where they decide or are not made
    """

    kinematic: KinematicAnalysis | None
    checks: tuple[Check, ...]
    dynamic: DynamicCheck | None
    lower_bound: DynamicCheck | None
    verdict: Verdict
    unasked: UnaskedRange | None = None
    code_over_records: float | None = None
    risk: Risk | None = None
    states: tuple[LimitStateCheck, ...] = ()
    bound_passes: bool | None = None
    reactions: tuple[Reaction, ...] = ()
    loses_hold: bool = False
    beside: DynamicCheck | None = None

    @property
    def shown(self) -> tuple[tuple[Check, bool], ...]:
        """Rows of the table of methods and whether each is a check of the verdict: beside these the dynamic
        check with FC on the other side, and a_g,SLD, below which a_g,SLV of the displacement check is not."""
        rows = []
        for check in self.checks:
            rows.append((check, True))
            other = self.dynamic.zeta_other if self.dynamic else None
            if check.name == "dynamic" and other:
                passed = other.passed if other.zeta is not None else None
                name = f"dynamic_{other.confidence_on}"
                rows.append((replace(check, name=name, demand=None, zeta=other.zeta, passed=passed), False))
            mechanism = self.kinematic
            if check.name == "nonlinear" and mechanism is not None and mechanism.zeta_sld is not None:
                assert mechanism.acceleration_demand is not None
                values = mechanism.a0 / G, mechanism.acceleration_demand / G, mechanism.zeta_sld, None
                rows.append((Check("floor_sld", SLD_CLAUSE, "g", *values), False))
        return tuple(rows)


def assess(scene: CheckInput, cancelled: Callable[[], bool] = lambda: False) -> Assessment:
    """Dynamic, kinematic and simplified checks of a wall (Circolare 7/2019 C8.7.1.2.1); above the ground none where
    the motion of its floor is not known. Raises Cancelled, and InputError where a spectrum ends too early."""
    return assess_evaluation(evaluate(scene, cancelled=cancelled), cancelled)


def assess_evaluation(
    evaluation: Evaluation, cancelled: Callable[[], bool] = lambda: False, fails_elsewhere: bool = False
) -> Assessment:
    """`assess` of a wall whose checks are made. fails_elsewhere : about another hinge or by another mechanism, whatever
    its inputs are: what an outcome here would rest on is not looked at, and it is indicative at the most"""
    scene = evaluation.scene
    kinematic, dynamic, demand = evaluation.kinematic, evaluation.dynamic, scene.demand
    if kinematic is None:
        return Assessment(None, (), None, None, make_verdict(evaluation.evidence, None))
    unlooked = evaluation.satisfied and fails_elsewhere
    passes = evaluation.satisfied and not unlooked
    unheld = _without_restraint(evaluation, cancelled) if passes else None
    raised: tuple[Assumption, ...] = ()
    agrees = not unlooked and passes_with_q2(evaluation.made("linear_q_code"), demand.zeta_target)
    if evaluation.zeta is not None and (passes or agrees):
        raised = evaluate_assumptions(evaluation, cancelled)
    ratio = None
    if scene.floor is not None and scene.building is not None:
        ratio = scene.floor.code_over_records(kinematic)
    unasked = find_unasked_range(evaluation) if evaluation.zeta is not None else None
    limits = [*_limits(evaluation, ratio, unlooked, cancelled), *([unasked.words] if unasked else [])]
    bound, stands = None, None
    if passes:
        free = unheld or _overturning(scene, cancelled)
        bound, stands = (free.zeta, free.satisfied) if free else (None, None)
        if free is not None and dynamic is None and free.satisfied and not scene.wall.kinematics.arches:
            free, stands = None, False  # that it overturns only histories say, which lower zeta of the clauses
        if bound is not None or scene.wall.kinematics.one_way or scene.wall.bends:
            raised = (*raised, _of_the_restraint(evaluation, free))
        if (arch := kinematic.wall.arch) is not None:
            raised = (*raised, _of_the_arch(evaluation, arch))
    why = [limit for limit in limits if _leaves_demand_open(limit, evaluation)]
    limits = [limit for limit in limits if limit not in why]
    why += [sentence("reason", "fails_elsewhere")] if unlooked else []
    verdict = make_verdict(evaluation.evidence, bound, tuple(limits), raised, tuple(why))
    below = unheld.dynamic if unheld else None
    parts = (kinematic, evaluation.checks, dynamic, below, verdict, unasked, ratio, _capacity(evaluation))
    reactions = find_reactions(scene, evaluation.holds, evaluation.zeta, dynamic)
    if not scene.wall.bends:
        reactions = reactions_of_turning(scene, kinematic, dynamic, evaluation.zeta)
    found = Assessment(*parts, bound_passes=stands, reactions=reactions, loses_hold=evaluation.loses_hold)
    return replace(found, beside=evaluation.beside)


def _limits(
    evaluation: Evaluation, ratio: float | None, unlooked: bool, cancelled: Callable[[], bool]
) -> list[Sentence]:
    """Sentences on the checks of a wall and on the floor it stands on. ratio : of `Floor.code_over_records`"""
    scene, kinematic = evaluation.scene, require_value(evaluation.kinematic)
    limits = [remark for remark in (evaluation.lower_q_remark,) if remark is not None]
    if scene.floor is not None and scene.building is not None:
        limits += building_notes(scene.building, scene.demand.limit_state)
    if ratio is not None and ratio < LOW_CODE:
        code = "code_far_below_records" if ratio < FAR_BELOW else "code_below_records"
        limits.append(sentence("reason", code, ratio=ratio))
    if scene.bends_inward:
        outward, inward = (Number(scene.moving_to(side)[1].alpha0, ".3g") for side in ("outward", "inward"))
        limits.append(sentence("reason", "bends_inward_first", outward=outward, inward=inward))
    limits += _of_life_and_records(evaluation)
    limits += _branch_remark(evaluation)
    limits += _hold_remark(evaluation)
    if found := find_open_impulse(scene, evaluation.dynamic):
        limits.append(sentence("reason", "impulse_open", impulse=found[0], stiffness=Number(1e-3 * found[1], ".3g")))
    with_histories = evaluation.dynamic is not None or evaluation.beside is not None
    limits += [*_of_bending(kinematic, scene.wall, with_histories), *_of_ties_not_counted(evaluation)]
    limits += [] if unlooked else _of_ties_that_lower(evaluation, cancelled)
    return [*limits, *_of_a_thicker_wall(evaluation)]


def _leaves_demand_open(limit: Sentence, evaluation: Evaluation) -> bool:
    """Whether a limit says that the demand itself is not known: a short life that no document shows, without the
    hazard; floors that move far less by the code than by the records, where a check by the code decides."""
    if limit.code == "short_life":
        return document_of(evaluation.scene.asked.evidence, "nominal_life_years") is None
    return limit.code == "code_far_below_records" and evaluation.dynamic is None


def _of_life_and_records(evaluation: Evaluation) -> list[Sentence]:
    """Sentences on what a short life without the hazard, motions that are generated, and records that are doubted leave
    open."""
    scene, dynamic, limits = evaluation.scene, evaluation.dynamic, []
    life = scene.asked.reference_period
    if life is not None and life < ORDINARY_LIFE * (1.0 - 1e-9) and not scene.demand.hazard:
        limits.append(sentence("reason", "short_life", years=life, least=ORDINARY_LIFE))
    if dynamic and scene.by_default:
        limits.append(_by_default(evaluation))
    elif dynamic and any(motion.format == GENERATED for motion in scene.ground):
        limits.append(sentence("reason", "generated_motions"))
    if dynamic and (doubted := [motion.name for motion in scene.ground if is_doubtful(motion)]):
        limits.append(sentence("reason", "records_doubted", n=len(doubted), names=", ".join(doubted[:3])))
    return limits


def _by_default(evaluation: Evaluation) -> Sentence:
    """That the motions are generated for want of records, with zeta of histories and displacement check."""
    displacement, dynamic = evaluation.made("nonlinear"), evaluation.dynamic
    zetas = {"nonlinear": Number(displacement.zeta if displacement else None)}
    zetas["dynamic"] = Number(dynamic.zeta if dynamic else None)
    return sentence("reason", "by_default", n=len(evaluation.scene.ground), generate=Key("[generate]"), **zetas)


def _of_the_restraint(evaluation: Evaluation, free: Evaluation | None) -> Assumption:
    """Sentences on what stands behind a wall or holds its top, as it is declared. free : the wall without it, None
    where it does not stand or no check follows it: what is not known turns what passes, but of a wall that stays at
    rest to either side"""
    wall, hold = evaluation.scene.wall, evaluation.scene.wall.held_by
    # what holds a top has to be shown to stand, of what is behind a wall it is enough that it is there
    enough = hold is not None and (not wall.bends or hold.shows_strength or hold.is_bar)
    shown = hold.evidence if hold and enough else None
    code = "top_fails" if wall.bends else "restraint_fails"
    if wall.kinematics.arches:
        code = "ends_fail"
    if free is None:
        unfollowed = evaluation.dynamic is None and (wall.bends or wall.in_si.rocks_both_ways)
        code = "restraint_unfollowed" if unfollowed else "restraint_stands"
        code = "restraint_of_stretch" if wall.is_shared_stretch else code
    zeta = free.zeta if free else None
    alike = not wall.bends and wall.in_si.rocks_both_ways and wall.in_si.sides_are_alike
    stays = free is None and evaluation.outcome == "not_activated" and alike
    unshown = hold is not None and not wall.bends and hold.is_contact and hold.evidence is None
    holds = free is not None and free.satisfied and not (unshown and _is_worse(free, evaluation))
    return Assumption(
        RESTRAINT,
        sentence("reason", code, zeta=Number(zeta), restraint=restraint_phrase(wall.in_si.declared)),
        sentence("word", f"choice_{hold.kind}") if hold else sentence("accepted", "missing"),
        sentence("accepted", "none"),
        DECLARED if hold else LEFT_OUT,
        zeta,
        free.outcome if free else "undetermined",
        turns=not (stays or holds),
        reason=sentence("word", f"evidence_{shown.kind}") if shown else "",
        asks=sentence("reason", "in_hold", kinds=" | ".join(STRENGTH if wall.bends else (*PRESENCE, *STRENGTH))),
    )


def _is_worse(free: Evaluation, evaluation: Evaluation) -> bool:
    """Whether a wall without what restrains it has another outcome, or a lower zeta of two digits, though it passes: of
    a restraint that nobody shows the worse counts."""
    lower = free.zeta is not None and evaluation.zeta is not None and round(free.zeta, 2) < round(evaluation.zeta, 2)
    return lower or free.outcome != evaluation.outcome


def _without_restraint(evaluation: Evaluation, cancelled: Callable[[], bool]) -> Evaluation | None:
    """A one-sided wall with histories as it rocks both ways where what restrains it fails; None of another wall."""
    scene, wall = evaluation.scene, evaluation.scene.wall
    if evaluation.dynamic is None or not wall.kinematics.one_way or not wall.in_si.rocks_both_ways:
        return None
    free = replace(wall, mechanism="two_sided", restitution=None, velocity_ratio=None)
    return evaluate(scene.replace_parts(wall=free, mechanism="two_sided"), other=False, cancelled=cancelled)


def _overturning(scene: CheckInput, cancelled: Callable[[], bool]) -> Evaluation | None:
    """A wall held at its top, were it not: it overturns about its base. None of another wall, where its loads
    would overturn it without an earthquake, and where a spectrum ends before its period; none of a stretch between
    holds, without which it is the whole wall that moves."""
    wall = scene.wall
    if not wall.bends or not carries(wall) or wall.is_shared_stretch:
        return None
    try:
        alone = replace(wall, mechanism="one_sided", hold=tuple(hold.alone for hold in wall.restraints))
        free = scene.replace_parts(wall=alone, mechanism="one_sided")
        return evaluate(free, other=False, cancelled=cancelled)
    except InputError:
        return None


def _of_the_arch(evaluation: Evaluation, arch: Arch) -> Assumption:
    """What the ends of a wall push against: without it nothing holds the wall between its transverse walls."""
    hold = require_value(evaluation.scene.wall.arch)
    value = sentence("added", "thrust_of_ends", thrust=1e-3 * arch.thrust)
    return Assumption(
        ARCH,
        sentence("reason", "arch_fails"),
        value,
        sentence("accepted", "none"),
        DECLARED,
        0.0,
        "not_verified",
        turns=True,
        reason=sentence("word", f"evidence_{require_value(hold.evidence).kind}") if hold.shows_strength else "",
        asks=sentence("reason", "in_hold", kinds=" | ".join(STRENGTH)),
    )


def _of_bending(kinematic: KinematicAnalysis, wall: Wall, with_histories: bool) -> list[Sentence]:
    """Sentences that limit the verdict of a wall that bends: no histories, the force of what holds it, a hinge as high
    as one is looked for."""
    mechanism, arch = kinematic.chain.bending, kinematic.wall.arch
    if mechanism is None:
        return []
    limits = [] if with_histories else [sentence("reason", "no_histories", q=2)]
    if arch is not None:
        by = sentence("word", arch.by)
        limits.append(sentence("reason", "arch_thrust", spacing=arch.spacing, thrust=1e-3 * arch.thrust, by=by))
        moved = kinematic.moved.bending or mechanism
        if kinematic.d_limit is not None and not math.isinf(moved.strip.stands):
            parted = moved.parted(moved.rotation(kinematic.d_limit))
            limits.append(sentence("reason", "arch_parts", mm=1e3 * parted, stands=1e3 * arch.stands))
        return limits
    if kinematic.wall.declared.strength in (None, math.inf):
        limits.append(sentence("reason", "top_force", force=1e-3 * mechanism.top_force))
    moved = kinematic.moved.bending or mechanism
    if mechanism.highest or moved.highest:
        limits.append(sentence("reason", "hinge_highest", height=mechanism.h1))
    return limits


def _branch_remark(evaluation: Evaluation) -> list[Sentence]:
    """The elastic branch that the clause asks for in the histories of an element free to vibrate."""
    branch = evaluation.dynamic.branch if evaluation.dynamic else None
    if not isinstance(branch, Branch):
        return []
    said = {
        "period": Number(branch.period, ".3f"),
        "modulus": 1e-6 * branch.modulus,
        "assumed": sentence("added", "assumed_modulus" if branch.assumed else "nothing"),
        "limit": Number(branch.limit, ".2g"),
        "own": Number(branch.own_period, ".3f"),
    }
    return [sentence("reason", "elastic_branch", **said)]


HOLD_REMARKS = {TOP: "hold_top", BASE: "hold_base", FOOT: "hold_foot", ENDS: "hold_ends", STUB: "hold_stub"}
"""Hold -> code of its sentence."""


def _hold_remark(evaluation: Evaluation) -> list[Sentence]:
    """What the weakest of the holds takes at the demand, what it stands, and from which demand on it gives way."""
    check = evaluation.made("hold")
    if check is None:
        return []
    weakest = evaluation.holds[0]
    values: dict[str, object] = {"asked": check.demand, "stands": check.capacity, "share": check.zeta}
    if weakest.impulse is not None:
        return [sentence("reason", "hold_impulse", impulse=weakest.impulse, **values)]
    if weakest.limit.hold == ENDS:
        values["across"] = Key("out_kn_m")
    if weakest.limit.hold == BASE:
        values["friction"] = evaluation.scene.wall.in_si.friction
    return [sentence("reason", HOLD_REMARKS[weakest.limit.hold], **values)]


def _of_ties_not_counted(evaluation: Evaluation) -> list[Sentence]:
    """Sentences on what the clauses do not count of ties; the other reading of SLD is shown, not taken."""
    wall, kinematic = evaluation.scene.wall, evaluation.kinematic
    if kinematic is None or not wall.ties:
        return []
    if evaluation.scene.demand.limit_state == "SLD" and kinematic.zeta_sld is not None:
        alpha, share, _ = sum_chain(wall.in_si, evaluation.scene.kinematics.both_ways).start
        zeta = kinematic.zeta_sld * (alpha / share) / (kinematic.alpha0 / kinematic.e_star)
        return [sentence("reason", "ties_at_sld", zeta=Number(zeta))]
    if any(tie.slack_mm for tie in wall.ties) and any(check.name != "dynamic" for check in evaluation.checks):
        return [sentence("reason", "slack_not_counted")]
    return []


def _of_ties_that_lower(evaluation: Evaluation, cancelled: Callable[[], bool]) -> list[Sentence]:
    """zeta with the ties of a wall and without them, where a tie ends the displacement check early or lowers zeta: of
    that check the larger counts, histories take the ties as they are."""
    scene, said = evaluation.scene, []
    if evaluation.kinematic is None or not scene.wall.ties:
        return []
    pair = zeta_with_and_without_ties(evaluation.kinematic, scene.demand)
    if pair is not None and (pair[1] > pair[0] or evaluation.kinematic.ends_at_break):
        said.append(sentence("reason", "ties_displacement", tied=Number(pair[0]), bare=Number(pair[1])))
    if evaluation.dynamic is None or evaluation.dynamic.zeta is None:
        return said
    bare = check_by_histories(scene.replace_parts(wall=scene.wall.without_ties()), cancelled=cancelled)
    if bare is not None and bare.zeta is not None and round(bare.zeta, 2) > round(evaluation.dynamic.zeta, 2):
        values = {"tied": Number(evaluation.dynamic.zeta), "bare": Number(bare.zeta)}
        said.append(sentence("reason", "ties_histories", **values))
    return said


def _of_a_thicker_wall(evaluation: Evaluation) -> list[Sentence]:
    """That a thicker wall has the lower zeta by the check of the clauses that decides: what holds it besides its weight
    does not grow with it, a tie breaks before its larger displacement, or it vibrates nearer to the plateau."""
    scene, check = evaluation.scene, evaluation.decides
    thickness = scene.wall.thickness or 0.0
    if check is None or check.zeta is None or check.name == "dynamic" or not has_own_thickness(scene.wall):
        return []
    zetas = {}
    for factor in TRIAL_THICKNESS_FACTORS:
        try:
            there = scene.without_records().replace_parts(wall=rescale_thickness(scene.wall, factor * thickness))
            thicker = evaluate(there).made(check.name)
        except InputError:
            continue
        if thicker is not None and thicker.zeta is not None:
            zetas[factor] = thicker.zeta
    if not zetas or round(min(zetas.values()), 2) >= round(check.zeta, 2):
        return []
    worst = min(zetas, key=lambda factor: zetas[factor])
    values = {"zeta": Number(zetas[worst]), "given": Number(check.zeta)}
    return [sentence("reason", "thicker_less", cm=Number(100.0 * worst * thickness, ".1f"), **values)]


def _capacity(evaluation: Evaluation) -> Risk | None:
    """PGA the wall withstands and its return period, None where zeta_E tells neither."""
    demand, by_histories = (
        evaluation.scene.demand,
        evaluation.decides is not None and evaluation.decides.name == "dynamic",
    )
    # records weaker than the demand tell nothing of a PGA
    if evaluation.zeta is None or (by_histories and demand.weak_share is not None):
        return None
    return risk_of_mechanism(evaluation.zeta, demand, evaluation.low if by_histories else None)
