"""The verdict of a wall: one code, its reasons, one sentence in each language."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from core.capacity.bisection import BRACKET
from core.codes.assumption import (
    DECLARED,
    KEYS_WITHOUT_LIMIT,
    RESTRAINT,
    SHOWN_ALONE,
    TOGETHER,
    WORDLESS,
    Assumption,
    table,
)
from core.codes.demand import DemandResult
from core.codes.dynamic_check import DemandCheck
from core.codes.kinematic import ZETA_ROUNDING, Check, Kinematic
from core.codes.kinematic_chain import at_rest
from core.codes.limits import MEAN_FROM, MIN_PGA_SHARE, MINIMUM_FROM
from core.codes.outcomes import OUTCOMES, PASSES
from core.codes.record_compatibility import Compliance
from core.codes.target_spectrum import displacement_fall
from core.codes.verdict_sentence import CODE_Q, measured, outcome
from core.codes.vertical_bending import bending, uplift_multiplier
from core.text.sentence import FILE_NAMES, FormNames, Key, Number, Sentence, sentence
from core.units import G
from core.wall.masonry import Masonry

STOCKY_DEG = 20.0

TO_MEND = {
    "no_restraint": Sentence("reason", "to_no_restraint", (("key", Key("back_restraint")),)),
    "no_top_restraint": Sentence(
        "reason", "to_no_top_restraint", (("key", Key("back_restraint")), ("one_sided", Sentence("word", "one_sided")))
    ),
    "no_end_restraint": Sentence("reason", "to_no_restraint", (("key", Key("back_restraint")),)),
    "no_hold_strength": Sentence("reason", "to_no_hold_strength", (("key", Key("restraint_kn_m")),)),
    "no_arch": Sentence("reason", "to_no_arch", (("arch", Key("[wall.arch]")),)),
    "no_spectrum": Sentence("reason", "to_no_spectrum"),
    "not_compatible": Sentence("reason", "to_not_compatible"),
    "few_records": Sentence("reason", "to_few_records"),
    "too_weak": Sentence("reason", "to_too_weak"),
    "weaker_records": Sentence("reason", "to_weaker_records"),
    "bundled": Sentence("reason", "to_bundled"),
    "one_sign": Sentence("reason", "to_one_sign", (("key", Key("polarity")),)),
    "no_soil_factor": Sentence("reason", "to_no_soil_factor"),
    "period_estimated": Sentence("reason", "to_period_estimated", (("key", Key("period_s")),)),
    "upper_floor": Sentence("reason", "to_building", (("building", Key("[building]")),)),
    "upper_top": Sentence("reason", "to_building", (("building", Key("[building]")),)),
    "upper_middle": Sentence("reason", "to_building", (("building", Key("[building]")),)),
    "no_check": Sentence("reason", "to_no_check"),
}
"""What makes a verdict indicative, or is missing, and the designer can mend -> what to do; the first two are said."""


TAKEN = ("no_soil_factor", "period_estimated")
"""Reasons for which the motion itself rests on a value that was left out: no wall is said to stay at rest under it."""


@dataclass(frozen=True)
class Circumstances:
    """What limits a verdict beside its checks: how the records were chosen, taken and integrated.

    stations : of the records, two components of one count once
    bundled : some are the example's
    strongest : largest PGA at the demand, FC apart [m/s2]
    both_signs : a one-sided wall was given each record with both
    period_estimated : the period of the building that carries the wall was not given
    exact : the integrator is not one for comparison
    unbranched : code of the reason why histories have not the elastic branch the clause asks for, empty where they have
    """

    stations: int
    bundled: bool = False
    strongest: float = 0.0
    both_signs: bool = True
    period_estimated: bool = False
    exact: bool = True
    unbranched: str = ""


@dataclass(frozen=True)
class Verdict:
    """The verdict of a wall about one hinge.

    code : of the group "verdict"
    governing : name of the check that decides, or None
    way, values : the sentence of the group "verdict" and what it says; `text` adds where
    decides : the check that decides with what it compares, or what is missing
    to_do : what the designer does next, two at most
    limits : what limits the verdict, first what makes it indicative, of which there are `blocking`
    notes : what a reader may pass over
    lower_bound : zeta of the two-sided motion where the restraint behind a one-sided wall fails, or None
    assumptions : what raises zeta and is not measured, in the order of their table
    """

    code: str
    governing: str | None
    zeta_e: float | None
    zeta_target: float
    way: str
    values: tuple[tuple[str, object], ...]
    decides: Sentence | None = None
    to_do: tuple[Sentence, ...] = ()
    limits: tuple[Sentence, ...] = ()
    notes: tuple[Sentence, ...] = ()
    lower_bound: float | None = None
    blocking: int = 0
    assumptions: tuple[Assumption, ...] = ()

    @property
    def reasons(self) -> tuple[Sentence, ...]:
        """Sentences that follow that of the verdict, in the order they are read."""
        return (*self.to_do, *self.limits, *self.notes)

    def text(self, language: str, subject: str = "", where: Sentence | str = "", form: FormNames = FILE_NAMES) -> str:
        """The sentence in "en" or "it". subject : name of the wall; where : of `at_hinge`; form : words of the keys"""
        words = sentence("verdict", self.way, where=where, **dict(self.values)).text(language, form)
        return f"{subject}: {words}" if subject else words[:1].upper() + words[1:]


def governing_check(checks: tuple[Check, ...]) -> Check | None:
    """The check that decides: the first, for the most refined of those made comes first."""
    return checks[0] if checks else None


def _reason(code: str, /, **values) -> Sentence:
    return sentence("reason", code, **values)


def passes_with_q2(check: Check | None, target: float) -> bool:
    """Whether the check with q of the code is satisfied with q = 2 as well, where a larger q was given."""
    if check is None or check.zeta is None:
        return False
    return check.zeta * min(1.0, CODE_Q / (check.q or CODE_Q)) >= target - ZETA_ROUNDING


class Evidence(NamedTuple):
    """What a verdict is judged by.

    mechanism : two_sided, one_sided or vertical_bending
    demand : what is required
    checks : those that were made, the most refined first
    dynamic : the check by histories, None where there is none
    kinematic : None above the ground where the building is not known
    compliance : of the records with the spectrum, None without a spectrum
    circumstances : what else it must know
    """

    wall: Masonry
    mechanism: str
    demand: DemandResult
    checks: tuple[Check, ...]
    dynamic: DemandCheck | None
    kinematic: Kinematic | None
    compliance: Compliance | None
    circumstances: Circumstances

    @property
    def governing(self) -> Check | None:
        """The check that decides."""
        return governing_check(self.checks)

    @property
    def zeta(self) -> float | None:
        """zeta of the check that decides [-]."""
        return self.governing.zeta if self.governing else None

    def made(self, name: str) -> Check | None:
        """The check of this name, None where it was not made."""
        return next((check for check in self.checks if check.name == name), None)


def outcome_of(seen: Evidence, unfounded: Sequence[Sentence] = (), q_unfounded: bool = False) -> str:
    """Outcome of a wall, a code of the table of outcomes.

    unfounded : inputs without a reason that raise zeta and turn the outcome; q_unfounded : one turns the check with q
        of the code alone
    """
    if _missing(seen) is not None:
        return "undetermined"
    taken = any(words.code in TAKEN for words in _limits(seen))
    if not unfounded and not taken and not _activated(seen, _threshold(seen)):
        return "not_activated"
    agrees = not q_unfounded and passes_with_q2(seen.made("linear_q_code"), seen.demand.zeta_target)
    return _code(seen, bool(unfounded or _limits(seen) or _unconfirmed(seen)), agrees)


def _threshold(seen: Evidence) -> float:
    """a_RM [m/s2], of a wall between transverse walls that of what holds it before its ties have to stretch."""
    if seen.wall.arch is not None:
        return G * at_rest(seen.wall, bending(seen.wall))
    return G * uplift_multiplier(seen.wall, seen.mechanism)


def verdict(
    seen: Evidence,
    lower_bound: float | None,
    own_limits: tuple[Sentence, ...] = (),
    assumed: tuple[Assumption, ...] = (),
) -> Verdict:
    """The verdict from the checks of a wall, the most refined first.

    lower_bound : zeta of the two-sided motion where the restraint behind a one-sided wall fails, of the overturning
        of a wall no longer held at its top [-], or None
    own_limits : Sentences on the checks and on the floor of a wall above the ground
    assumed : what raises zeta and is not measured
    """
    wall, demand, dynamic = seen.wall, seen.demand, seen.dynamic
    missing, threshold = _missing(seen), _threshold(seen)
    unfounded = [row.words for row in assumed if (row.turns and row.open) or (row.turns and row.key == TOGETHER)]
    blocking = [*_limits(seen), *unfounded, *_unconfirmed(seen)]
    agrees = passes_with_q2(seen.made("linear_q_code"), demand.zeta_target)
    rests_on = [Key(row.key) for row in assumed if row.turns_q and row.open] if agrees else []
    code = outcome_of(seen, unfounded, bool(rests_on))
    limits = [*blocking, *own_limits]
    quiet = [row for row in assumed if row.key == TOGETHER or (row.key in SHOWN_ALONE and not row.turns)]
    quiet += [row for row in assumed if row.key in KEYS_WITHOUT_LIMIT and not row.raises]
    limits += [row.words for row in assumed if row.words not in limits and row not in quiet]
    if rests_on:
        limits.append(_reason("q_rests_on", q=Number(CODE_Q, "g"), keys=tuple(rests_on)))
    limits += _limits_of_the_number(seen, code)
    governing, by = seen.governing, sentence("added", "nothing")
    if governing and governing.zeta is not None:
        by = measured(governing, dynamic, demand)
    largest = demand.pga
    if wall.above_ground and code == "not_activated":
        largest = _strongest(seen)
    carried = tuple(row for row in assumed if row.turns and row.permitted), _reasoned(assumed)
    way, values = outcome(
        code, missing, threshold, demand, governing, seen.checks, dynamic, by, largest, wall, *carried
    )
    decides = missing
    if missing is None and governing:
        decides = sentence("added", "decides", by=by, clause=governing.clause)
    return Verdict(
        code,
        governing.name if governing else None,
        seen.zeta,
        demand.zeta_target,
        way,
        tuple(values.items()),
        decides,
        tuple(_to_do(code, [*blocking, *([missing] if missing else [])], assumed)[:2]),
        tuple(limits),
        tuple(_notes(seen, code)),
        lower_bound,
        len(blocking),
        table(assumed),
    )


def _reasoned(assumed: Iterable[Assumption]) -> tuple[Key, ...]:
    """Keys whose other ends would turn the outcome, but for the engineer's reason."""
    founded = [row.key for row in assumed if row.turns and row.reason and not row.permitted and row.key != RESTRAINT]
    return tuple(map(Key, dict.fromkeys(founded)))


def _code(seen: Evidence, blocked: bool, agrees: bool) -> str:
    """Code of the verdict of a wall the motion lifts, by the check that decides.

    blocked : something makes it indicative
    agrees : the check with q = 2 is satisfied
    """
    assert seen.governing is not None
    by_histories = seen.governing.name == "dynamic"
    if seen.dynamic and by_histories and seen.dynamic.within_spread(seen.demand.zeta_target):
        return "at_limit"
    if not seen.governing.passed:  # whatever is missing: it would pass no better with it
        return "q2_unsafe" if agrees else "not_verified"
    if blocked:
        return "indicative"
    return "verified_refined" if seen.demand.limit_state == "SLV" and not agrees else "verified"


def _limits_of_the_number(seen: Evidence, code: str) -> list[Sentence]:
    """Sentences that limit the verdict: zeta is to be read with them."""
    limits = _of_the_histories(seen) if code != "undetermined" else []
    if seen.kinematic and seen.kinematic.missing:
        keys = tuple(sentence("missing", key) for key in seen.kinematic.missing)
        limits.append(_reason("no_period", missing=keys))
    if seen.demand.target is None and not seen.dynamic and OUTCOMES[code].judgement == PASSES:
        limits.append(_reason("linear_alone"))
    if OUTCOMES[code].judgement == PASSES and _rests_on(seen.wall) and seen.kinematic and seen.kinematic.d_limit:
        limits.append(_reason("supports", d=seen.kinematic.d_limit, state=seen.demand.limit_state))
    if not seen.wall.bends and seen.wall.leans_inward:
        limits.append(_reason("leans_inward"))
    if fall := displacement_fall(seen.demand.target):
        earlier, later, share = fall
        limits.append(_reason("spectrum_falls", earlier=earlier, later=later, share=share))
    return limits + _weaker(seen, code, True)


def _rests_on(wall: Masonry) -> bool:
    """Whether a check counts on weights that must stay where they are."""
    return bool(wall.vertical_loads) and wall.arch is None


def _notes(seen: Evidence, code: str) -> list[Sentence]:
    """Sentences a reader may pass over."""
    notes = _weaker(seen, code, False)
    if seen.kinematic and seen.kinematic.chain.friction_height is not None:
        notes.append(_reason("friction_hinge", height=seen.kinematic.chain.friction_height))
    compliance = seen.compliance
    if seen.dynamic and compliance and code != "not_activated":
        if compliance.unnamed:
            notes.append(_reason("no_station", n=compliance.unnamed))
        if compliance.stations <= MEAN_FROM:
            notes.append(_reason("more_records", n=compliance.stations))
    return notes


def _upper(wall: Masonry) -> str:
    """Code of the sentence that asks for the building of a wall above the ground."""
    if wall.arch is not None:
        return "upper_top"
    return "upper_middle" if wall.bends else "upper_floor"


def _missing(seen: Evidence) -> Sentence | None:
    """Sentence on what is missing where no verdict can be given, with the keys that give it; None where nothing is."""
    if seen.wall.above_ground and seen.kinematic is None:
        keys = {"height": "height_m", "storeys": "storeys", "period": "period_s", "building": "[building]"}
        keys = {name: Key(key) for name, key in keys.items()}
        return _reason(_upper(seen.wall), z=seen.wall.felt, **keys)
    if seen.governing is None:
        keys = {"spectrum": "spectrum", "modulus": "elastic_modulus_mpa", "weight": "unit_weight_kn_m3"}
        return _reason("no_check", **{name: Key(key) for name, key in keys.items()})
    unknown = seen.zeta is None and seen.governing.passed is not False  # what is known to fail needs no number
    if unknown and seen.demand.weak_share is not None:
        return _reason("weaker_records", share=seen.demand.weak_share)
    return _reason("no_number") if unknown else None


def _unconfirmed(seen: Evidence) -> list[Sentence]:
    """That neither the displacement check nor FC on the other side confirms what the histories say."""
    if seen.dynamic is None or not seen.dynamic.passed:
        return []
    displacement, other = seen.made("nonlinear"), seen.dynamic.zeta_other
    refuted = displacement is not None and displacement.passed is False
    return [_reason("alone")] if refuted and other is not None and not other.passed else []


def _weaker(seen: Evidence, code: str, below: bool) -> list[Sentence]:
    """A motion weaker than zeta_E that fails the rule: said whenever one does. below : what is required, or not"""
    dynamic = seen.dynamic
    if code == "undetermined" or dynamic is None or dynamic.zeta is None or dynamic.zeta_first is None:
        return []
    first = dynamic.zeta_first
    if first >= dynamic.zeta * (1.0 - BRACKET) or (first < seen.demand.zeta_target) != below:
        return []
    return [_reason("weaker_fails", first=first, zeta_16=Number(dynamic.zeta_16))]


def _of_the_histories(seen: Evidence) -> list[Sentence]:
    """Sentences on what the histories say beside the check: of the demand, and of weaker motions."""
    dynamic, zeta, target = seen.dynamic, seen.zeta, seen.demand.zeta_target
    if dynamic is None or zeta is None or seen.governing is None or seen.governing.name != "dynamic":
        return []
    said = []
    at = sentence("added", "at_demand")
    if target != 1.0:
        at = sentence("added", "at_share", target=target)
    if zeta >= target and not dynamic.holds_at_target:
        said.append(_reason("demand_fails", at=at))
    if dynamic.passed and target < 1.0 <= zeta and not dynamic.holds:
        said.append(_reason("whole_demand_fails", target=target))
    if dynamic.passed and dynamic.zeta_16 is not None and dynamic.zeta_16 < target:
        said.append(_reason("share", share=dynamic.share_failing_at_demand, target=target))
    return said


def _to_do(code: str, blocking: list[Sentence], assumed: tuple[Assumption, ...]) -> list[Sentence]:
    """Sentences on what the designer does next, the most urgent first. blocking : with what is missing"""
    actions = []
    codes = {words.code for words in blocking}
    mends = [to_do for why, to_do in TO_MEND.items() if why in codes]
    if code == "undetermined":
        return [one for one in mends if one.code in ("to_building", "to_no_check", "to_weaker_records")]
    if code == "indicative":
        for row in assumed:
            if row.words in blocking and row.key == RESTRAINT and row.source == DECLARED:
                actions.append(_reason("to_evidence", key=Key("restraint_evidence")))
            elif row.words in blocking and row.key in WORDLESS:
                actions.append(_reason("to_usual", key=Key(row.key)))
            elif row.words in blocking and row.key not in (TOGETHER, RESTRAINT):
                actions.append(_reason("give_reason", key=Key(row.key), reasons=Key("justification")))
        actions += mends
        if "alone" in codes:
            actions.append(_reason("justify"))
    elif code == "verified_refined":
        actions.append(_reason("justify"))
    elif code in ("not_verified", "q2_unsafe", "at_limit"):
        actions.append(_reason("strengthen", variant=Key("variant=progetto")))
    return actions


def _activated(seen: Evidence, threshold: float) -> bool:
    """Whether the motion can lift the wall at all, or a check fails all the same. An element free to vibrate is
    lifted by S_e(T_0) (C8.7.1.9): where T_0 is not known, neither is that it stays at rest. threshold : a_RM [m/s2]"""
    kinematic, demand = seen.kinematic, seen.demand
    lifted = None if kinematic is None else kinematic.zeta_sld
    if kinematic and kinematic.free_element and (lifted is None or lifted < max(1.0, demand.zeta_target)):
        return True
    strongest = _strongest(seen) * max(1.0, demand.zeta_target)
    at_rest = demand.confidence_factor * strongest <= threshold
    rigid = seen.wall.law.is_rigid
    declared = seen.wall.declared
    held = declared.restraint and (seen.wall.arch is not None or declared.strength is not None)
    unheld = seen.wall.bends and not held  # what is not held at its top overturns before
    return unheld or not rigid or not at_rest or any(check.passed is False for check in seen.checks)


def _strongest(seen: Evidence) -> float:
    """Largest acceleration under the wall at the demand, FC apart [m/s2]."""
    demand, kinematic = seen.demand, seen.kinematic
    first = float(demand.target.acceleration([0.0])[0]) if demand.target else demand.pga
    if kinematic and kinematic.floor:
        first = max(first, kinematic.floor.a_z)
    return max(demand.pga, first, seen.circumstances.strongest)


ENDS = "cross_walls", "buttress", "other"
"""What can hold the ends of a wall between transverse walls."""


def _of_what_holds(seen: Evidence) -> list[Sentence]:
    """What is not known of what restrains a wall: behind it, between its cross walls, or at its top."""
    wall, declared = seen.wall, seen.wall.declared
    if seen.mechanism == "one_sided":
        if not declared.restraint:
            return [_reason("no_restraint")]
        return [_reason("no_arch", arch=Key("[wall.arch]"))] if declared.only_there else []
    if not wall.bends:
        return []
    if wall.arch is not None:
        return [] if declared.restraint in ENDS else [_reason("no_end_restraint")]
    if declared.restraint in (None, "cross_walls"):
        return [_reason("no_top_restraint")]
    return [_reason("no_hold_strength", key=Key("restraint_kn_m"))] if declared.strength is None else []


def _limits(seen: Evidence) -> list[Sentence]:
    """Reasons for which the checks are indicative only."""
    demand, compliance, circumstances = seen.demand, seen.compliance, seen.circumstances
    reasons = []
    if seen.dynamic:
        if compliance is None:
            reasons.append(_reason("no_spectrum"))
        elif not compliance.compatible:
            reasons.append(_reason("not_compatible"))
        elif compliance.narrow:
            (low, high), (least, most) = compliance.period_range, compliance.full_range
            reasons.append(_reason("narrow_range", low=low, high=high, least=least, most=most))
        if demand.record_scaling == "pga":
            reasons.append(_reason("pga_scaling"))
        if demand.weak_share is not None and seen.checks[0].passed is not None:  # else it is what is missing
            reasons.append(_reason("weaker_records", share=demand.weak_share))
        stations = compliance.stations if compliance else circumstances.stations
        if stations < MINIMUM_FROM:
            reasons.append(_reason("few_records", n=stations))
        if weak := seen.dynamic.not_counted:
            reasons.append(_reason("too_weak", n=len(weak), names=weak[:3], share=MIN_PGA_SHARE))
        if circumstances.bundled:
            reasons.append(_reason("bundled"))
        if not circumstances.both_signs:
            reasons.append(_reason("one_sign"))
        if not circumstances.exact:
            reasons.append(_reason("comparison_method"))
        if circumstances.unbranched and seen.governing is not None and seen.governing.name == "dynamic":
            reasons.append(_reason(circumstances.unbranched))
    if circumstances.period_estimated:
        reasons.append(_reason("period_estimated"))
    reasons += _of_what_holds(seen)
    if not demand.soil_factor_stated:
        reasons.append(_reason("no_soil_factor"))
    alpha = 0.0 if seen.wall.arch else math.degrees(seen.wall.block.slenderness)
    if alpha > STOCKY_DEG:
        reasons.append(_reason("stocky", alpha=alpha))
    return reasons
