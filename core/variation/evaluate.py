"""The only way from a wall to its checks: what each says, and the outcome they come to."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

from core.codes.demand import MIN_SHARE_OF_DEMAND
from core.codes.dynamic_check import DynamicCheck
from core.codes.elastic_branch import can_have_branch, wants_branch
from core.codes.evidence import Circumstances, Evidence, governing_check
from core.codes.kinematic import Check, KinematicAnalysis, check_linear, make_kinematic_checks
from core.codes.limits import counted_stations
from core.codes.multiplier_search import MULTIPLIER_STEP, RUN, SPARSE, Precision
from core.codes.outcomes import FAILS, OPEN, PASSES, severity_key
from core.codes.verdict import find_outcome
from core.codes.vertical_bending import uplift_multiplier
from core.errors import InputError
from core.ground.record_folder import is_doubtful
from core.known import require_value
from core.mechanism.holds import FOOT, TOP
from core.setting.check_input import CheckInput
from core.text.sentence import Sentence, sentence
from core.variation.hold_check import HoldState, check_of_holds, look_at_holds
from core.wall.rocking_model import RockingModel

EXACT_METHODS = ("auto", "taylor", "taylor_6", "dormand_prince")
"""Methods whose result a verdict may rest on; the others are for comparison."""

BUNDLED_HEADER = "# Ribalta example motion"
"""How the header of a bundled motion begins."""

AT_LIMIT = "at_limit"
"""Code of a check by histories whose rule holds at what is required, but whose spread contains it: it counts as
failed."""


FULL_PRECISION, COARSE_PRECISION, DECISION = RUN, Precision(every=4), Precision(enough=1.05)
"""How zeta of histories is searched: as it is written; as it is shown under the hand, two digits with "about"; as far
as tells whether a wall passes, not by how much."""

FINEST = 1
"""Every how many points of its grid zeta is searched at the least."""


@dataclass(frozen=True)
class Evaluation:
    """The checks of a scene.

    kinematic : None above the ground where the building is not known
    dynamic : the check by histories, None without records and of a limit state that has none
    checks : those that could be made, the one that decides first, then the most refined
    beside : the check by histories where it decides nothing, which is not among them
    precision : of the histories
    holds : what holds a wall that bends, what gives way first at the head
    """

    scene: CheckInput
    kinematic: KinematicAnalysis | None
    dynamic: DynamicCheck | None
    checks: tuple[Check, ...]
    precision: Precision = FULL_PRECISION
    beside: DynamicCheck | None = None
    holds: tuple[HoldState, ...] = ()

    @property
    def decides(self) -> Check | None:
        """The check that decides."""
        return governing_check(self.checks)

    @property
    def zeta(self) -> float | None:
        """zeta of the check that decides [-]; None without one."""
        return self.decides.zeta if self.decides else None

    @property
    def beyond(self) -> bool:
        """Whether zeta is at least what is said: more of the histories, which decide, was not asked for."""
        return (
            self.dynamic is not None
            and self.dynamic.beyond
            and self.decides is not None
            and self.decides.name == "dynamic"
        )

    @property
    def low(self) -> float | None:
        """The lowest end of what zeta is known to be."""
        return self.dynamic.zeta_spread[0] if self.dynamic and self.dynamic.zeta_spread else self.zeta

    @property
    def loses_hold(self) -> bool:
        """Whether what decides is a hold that gives way while the wall is at rest."""
        if self.decides is None or self.decides.name != "hold" or not self.holds:
            return False
        first = self.holds[0]
        start = self.scene.moving_to(first.limit.side)[1].alpha0
        if first.limit.presses:  # what fails inward no longer stops the wall there, which each other way needs
            return False
        return first.limit.hold in (TOP, FOOT) and first.share * first.alpha <= start * (1.0 + 1e-9)

    def made(self, name: str) -> Check | None:
        """The check of this name, None where it was not made."""
        return next((check for check in self.checks if check.name == name), None)

    def judgement(self, check: Check | None) -> str:
        """FAILS, AT_LIMIT, OPEN or PASSES: what one of its checks says; a check that was not made says nothing."""
        if check is None or check.passed is None:
            return OPEN
        if check.name == "dynamic" and self.dynamic and self.dynamic.within_spread(self.scene.demand.zeta_target):
            return AT_LIMIT
        return PASSES if check.passed else FAILS

    @property
    def evidence(self) -> Evidence:
        """Evidence the verdict is judged by."""
        scene = self.scene
        motions, demand = scene.motions, scene.demand
        circumstances = Circumstances(
            stations=len(counted_stations(motions, demand)),
            bundled=any(value.startswith(BUNDLED_HEADER) for motion in motions for _, value in motion.details),
            strongest=max((demand.scaling(motion) * motion.pga for motion in motions), default=0.0),
            both_signs=scene.model.both_signs_alike or len(scene.signs) == 2,
            histories_off=scene.histories_off,
            beside=self._zeta_beside(),
            exact=scene.method.name in EXACT_METHODS,
            unbranched=self._unbranched(),
            sound=len(counted_stations([motion for motion in motions if not is_doubtful(motion)], demand)),
            left_out=scene.left_out,
        )
        parts = (self.checks, self.dynamic, self.kinematic, scene.compliance, circumstances)
        wall = scene.wall.in_si
        if wall.arch is not None and scene.kinematic is not None:  # as the demand pushes what its ends push against
            wall = scene.kinematic.wall
        return Evidence(wall, scene.mechanism, demand, *parts)

    def _zeta_beside(self) -> float | None:
        """zeta of the histories that decide nothing, or of what gives way along them before [-]."""
        if self.beside is None or self.beside.zeta is None or self.kinematic is None:
            return None
        holds = look_at_holds(self.scene, self.kinematic, self.beside)
        hold = check_of_holds(holds, self.scene.demand)
        return self.beside.zeta if hold is None or hold.zeta is None else min(self.beside.zeta, hold.zeta)

    def _unbranched(self) -> str:
        """Code of the reason why the histories have not the elastic branch the clause asks for."""
        scene = self.scene
        if scene.branches or not wants_branch(scene.wall.in_si, scene.mechanism):
            return ""
        return "does_not_rock" if can_have_branch(scene.wall.in_si, scene.mechanism) else "rigid_free"

    @cached_property
    def outcome(self) -> str:
        """Code of the table of outcomes, before what raises zeta is looked at; "undetermined" at a glance, which says
        none."""
        return find_outcome(self.evidence) if self.precision.every == RUN.every else "undetermined"

    @property
    def satisfied(self) -> bool:
        """Whether the check that decides surely is, its spread included."""
        return self.judgement(self.decides) == PASSES

    @property
    def lower_q_remark(self) -> Sentence | None:
        """That the linear check with q SLV passes with q SLV and not with the q it takes."""
        low, high = (_counted(self.kinematic, q) if self.kinematic else None for q in self.scene.q_slv)
        check, demand = self.made("linear_q_slv"), self.scene.demand
        if check is None or check.passed or high is None or self.kinematic is None:
            return None
        beyond = check_linear("linear_q_slv", self.kinematic, demand, high)
        if low is None or beyond is None or not beyond.passed:
            return None
        return sentence("reason", "lower_q_slv", low=self.scene.q_slv[0], q=self.scene.q_slv[1])


def evaluate(
    scene: CheckInput,
    precision: Precision = FULL_PRECISION,
    other: bool = True,
    cancelled: Callable[[], bool] = lambda: False,
) -> Evaluation:
    """The checks of a scene.

    other : with FC on the other side too, which decides whether an outcome that passes is more than indicative
    cancelled : asked between two chunks of analyses
    Raises InputError where a check cannot be made of the wall, and Cancelled.
    """
    if (threshold := uplift_multiplier(scene.wall.in_si, scene.mechanism)) <= 0.0:  # of no case, but of a value moved
        raise InputError("unstable_under_loads", threshold=threshold)
    kinematic = scene.kinematic
    if kinematic is None:
        return Evaluation(scene, None, None, (), precision)
    dynamic = check_by_histories(scene, precision, other, cancelled)
    made = make_kinematic_checks(kinematic, scene.demand, _counted(kinematic, scene.q_slv[0]))
    beside = None
    if scene.beside and made:
        dynamic, beside = None, dynamic
    checks = _with_histories(made, dynamic, scene)
    evaluation = Evaluation(scene, kinematic, dynamic, checks, precision, beside)
    if scene.by_default:
        evaluation = replace(evaluation, checks=_worse_first(evaluation))
    holds = look_at_holds(scene, kinematic, dynamic)
    return replace(evaluation, holds=holds, checks=_place_hold(evaluation, check_of_holds(holds, scene.demand)))


def _place_hold(evaluation: Evaluation, hold: Check | None) -> tuple[Check, ...]:
    """The checks with that of the holds: it decides where it is the worse of itself and of the one that would, by what
    each says, among alike by zeta. A hold that stands never covers a wall that falls."""
    checks, first = evaluation.checks, evaluation.decides
    if hold is None:
        return checks

    def place(check: Check) -> tuple[int, float]:
        rank = (FAILS, AT_LIMIT, OPEN, PASSES).index(evaluation.judgement(check))
        return rank, math.inf if check.zeta is None else check.zeta

    return (hold, *checks) if first is None or place(hold) < place(first) else (*checks, hold)


def _with_histories(made: tuple[Check, ...], dynamic: DynamicCheck | None, scene: CheckInput) -> tuple[Check, ...]:
    """The checks with that by histories, which decides: under records as given that are weaker than the demand a wall
    may fail, and how much more it bears is not known; then the others decide, where they are made. Of records that no
    usual factor brings to the demand zeta says nothing."""
    if dynamic is None:
        return made
    check, share = dynamic.as_check(scene.demand.zeta_target), scene.demand.weak_share
    near = share is None or share >= MIN_SHARE_OF_DEMAND
    if share is None or check.passed is False or (near and not made):
        return (check, *made)
    return (*made, check if near else replace(check, zeta=None, passed=None))


def _worse_first(evaluation: Evaluation) -> tuple[Check, ...]:
    """The checks where records are there by default: the worse of histories and displacement check decides."""
    pair = [check for check in (evaluation.made("dynamic"), evaluation.made("nonlinear")) if check is not None]
    others = tuple(check for check in evaluation.checks if check not in pair)
    target = evaluation.scene.demand.zeta_target

    def place(check: Check) -> tuple:
        said = evaluation.judgement(check)
        return (FAILS, AT_LIMIT, OPEN, PASSES).index(said), *severity_key("verified", check.zeta, target)

    return (*sorted(pair, key=place), *others)


def check_by_histories(
    scene: CheckInput,
    precision: Precision = FULL_PRECISION,
    other: bool = False,
    cancelled: Callable[[], bool] = lambda: False,
) -> DynamicCheck | None:
    """The check of a scene by time histories alone; the parameters are those of `evaluate`."""
    if not (motions := scene.motions) or scene.histories_off or scene.wall.kinematics.arches:
        return None
    precision = precision._replace(every=max(precision.every, FINEST))
    parts, target = (motions, scene.signs, scene.demand, scene.method), scene.demand.zeta_target

    def check(model: RockingModel, looked: Precision, both_sides: bool = other) -> DynamicCheck | None:
        return scene.histories(model, *parts, looked, both_sides, cancelled)

    worst: DynamicCheck | None = None
    for branch in scene.branches:
        if branch.assumed and worst and not worst.satisfied(target):
            break  # the softest masonry fails already
        model = branch.of(scene.model)
        made = check(model, up_to(worst.zeta, precision, target), False) if worst else check(model, precision)
        if made is None or (worst and _worth(made) >= _worth(worst)):
            continue
        if worst and other:
            made = require_value(check(model, precision))
        worst = replace(made, branch=branch)
    return worst or check(scene.model, precision)


def up_to(zeta: float | None, precision: Precision, target: float) -> Precision:
    """The precision of a search of which only a zeta below this one counts; None: no other is known."""
    if zeta is None:
        return precision
    enough = zeta / target * (1.0 + MULTIPLIER_STEP) ** SPARSE  # a failure is first seen as far above it
    return precision if precision.enough and precision.enough <= enough else precision._replace(enough=enough)


def _worth(check: DynamicCheck) -> tuple:
    """The worse of two checks of one wall comes first: what fails, at last by zeta."""
    return check.passed, check.zeta is not None, check.zeta or 0.0


def _counted(kinematic: KinematicAnalysis, q: float | None) -> float | None:
    """q of the searches counted from a0*, which e* raises and must not count twice; of the wall without its ties, which
    do not hold it at rest, and without the friction of return walls."""
    if q is None:
        return None
    bare = kinematic.chain.alpha0_bare
    return q * kinematic.e_star * (bare / kinematic.alpha0 if kinematic.alpha0 > bare else 1.0)
