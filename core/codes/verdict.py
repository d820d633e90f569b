"""The verdict of a wall: one code, its reasons, one sentence in each language."""

import math
from dataclasses import dataclass

from core.codes.demand import DemandResult
from core.codes.dynamic_check import DemandCheck
from core.codes.kinematic import Check, Kinematic
from core.codes.limits import MEAN_FROM, MINIMUM_FROM
from core.codes.record_compatibility import Compliance
from core.text.sentence import Key, Number, Sentence, apart, localized, sentence
from core.units import G

ORDER = ("dynamic", "nonlinear", "linear_q_slv", "linear_q_code")
"""The check that governs is the first of these that could be made."""

STOCKY_DEG = 20.0


@dataclass(frozen=True)
class Circumstances:
    """What a verdict must know beside the checks.

    stations : of the records, two components of one count once
    bundled : some are the example's
    strongest : largest PGA at the demand, FC apart [m/s2]
    both_signs : a one-sided wall was given each record with both
    period_estimated : the period of the building that carries the wall was not given
    exact : the integrator is not one for comparison
    """

    stations: int
    bundled: bool = False
    strongest: float = 0.0
    both_signs: bool = True
    period_estimated: bool = False
    exact: bool = True


@dataclass(frozen=True)
class Verdict:
    """The verdict of a wall.

    code : of the group "verdict"
    governing : name of the check that decides, or None
    reasons : Sentences of the group "reason"
    parts : of its sentence
    if_unloaded : it holds only if the wall carries no load
    lower_bound : zeta of the two-sided motion where the restraint behind a one-sided wall fails, or None
    """

    code: str
    governing: str | None
    zeta_e: float | None
    zeta_target: float
    reasons: tuple[Sentence, ...]
    parts: tuple[Sentence, ...]
    if_unloaded: bool
    lower_bound: float | None = None

    def text(self, language: str) -> str:
        """The sentence in "en" or "it"."""
        words = "".join(part.text(language) for part in self.parts)
        if self.if_unloaded:
            words = words.removesuffix(".") + localized("added", "unloaded", language)
        return words


def governing_check(checks: tuple[Check, ...]) -> Check | None:
    """The check that decides: the most refined of those made."""
    made = {check.name: check for check in checks}
    return next((made[name] for name in ORDER if name in made), None)


def _reason(code: str, /, **values) -> Sentence:
    return sentence("reason", code, **values)


def verdict(
    wall,
    mechanism: str,
    demand: DemandResult,
    checks: tuple[Check, ...],
    dynamic: DemandCheck | None,
    kinematic: Kinematic | None,
    compliance: Compliance | None,
    circumstances: Circumstances,
    lower_bound: float | None,
    own_notes: tuple[Sentence, ...] = (),
) -> Verdict:
    """The verdict from the checks of a wall, the most refined first.

    checks : those that were made
    own_notes : Sentences on the checks and on the floor of a wall above the ground
    kinematic : None above the ground where the building is not known
    """
    block = wall.block()
    threshold = G * wall.uplift_multiplier(mechanism)
    made = {check.name: check for check in checks}
    governing = governing_check(checks)
    q_code = made.get("linear_q_code")
    zeta = governing.zeta if governing else None
    target = demand.zeta_target
    activated = _activated(wall, threshold, demand, checks, kinematic, circumstances)
    doubts = []
    if wall.above_ground and kinematic is None:
        missing = {
            "height": "height_m",
            "storeys": "storeys",
            "period": "period_s",
            "building": "[building]",
        }
        keys = {name: Key(key) for name, key in missing.items()}
        doubts.append(_reason("upper_floor", z=wall.base_z_m, **keys))
    elif governing is None:
        doubts.append(_reason("no_check"))
    elif zeta is None:
        doubts.append(_reason("no_number"))
    elif activated and dynamic and dynamic.within_spread(target):
        low, high = dynamic.zeta_spread
        doubts.append(_reason("within_spread", zeta=zeta, target=target, low=low, high=high))
    notes = list(own_notes)
    if kinematic and kinematic.chain.friction_height is not None:
        notes.append(_reason("friction_hinge", height=kinematic.chain.friction_height))
    if kinematic and kinematic.missing:
        missing = tuple(sentence("missing", key) for key in kinematic.missing)
        notes.append(_reason("no_period", missing=missing))
    at = sentence("added", "at_demand")
    if target != 1.0:
        at = sentence("added", "at_share", target=target)
    if dynamic and zeta is not None:
        if zeta < target and dynamic.holds_at_target:
            notes.append(_reason("weaker_fails", zeta=zeta, at=at))
        if zeta >= target and not dynamic.holds_at_target:
            notes.append(_reason("demand_fails", at=at))
        if dynamic.passed and target < 1.0 <= zeta and not dynamic.holds:
            notes.append(_reason("whole_demand_fails", target=target))
        if kinematic and kinematic.free_element and wall.moment_law().is_rigid:
            notes.append(_reason("rigid_free"))
    limits = _limits(wall, mechanism, block, demand, dynamic, compliance, circumstances)
    if zeta is None or (wall.above_ground and kinematic is None):
        code = "undetermined"
    elif not activated:
        code = "not_activated"
    elif doubts:
        code = "undetermined"
    elif limits:
        code = "indicative"
    elif governing.passed:
        refined = demand.limit_state == "SLV" and not (q_code and q_code.passed)
        code = "verified_refined" if refined else "verified"
    else:
        code = "q2_unsafe" if q_code and q_code.passed else "not_verified"
    notes += [
        _reason(
            "disagrees",
            method=sentence("started_method", other.label),
            zeta=apart(other.zeta, target),
            outcome=sentence("word", "passed" if other.passed else "not_passed"),
        )
        for other in checks
        if governing
        and other is not governing
        and other.passed is not None
        and other.passed != governing.passed
    ]
    if dynamic and compliance and code != "not_activated":
        if compliance.unnamed:
            notes.append(_reason("no_station", n=compliance.unnamed))
        if compliance.stations <= MEAN_FROM:
            notes.append(_reason("more_records", n=compliance.stations))
    largest = demand.pga
    if wall.above_ground and code == "not_activated":
        largest = _strongest(demand, kinematic, circumstances)
    parts = _sentence(
        code, threshold, demand, governing, q_code, dynamic, wall.above_ground, largest
    )
    if_unloaded = code != "undetermined" and not (wall.unloaded_confirmed or wall.load)
    reasons = (*doubts, *limits, *notes)
    return Verdict(
        code,
        governing.name if governing else None,
        zeta,
        target,
        reasons,
        parts,
        if_unloaded,
        lower_bound,
    )


def _activated(
    wall, threshold: float, demand: DemandResult, checks, kinematic, circumstances
) -> bool:
    """Whether the motion can lift the wall at all, or a check fails all the same. An element free to vibrate is
    lifted by S_e(T_0) (C8.7.1.9): where T_0 is not known, neither is that it stays at rest."""
    lifted = None if kinematic is None else kinematic.zeta_sld
    if (
        kinematic
        and kinematic.free_element
        and (lifted is None or lifted < max(1.0, demand.zeta_target))
    ):
        return True
    strongest = _strongest(demand, kinematic, circumstances) * max(1.0, demand.zeta_target)
    at_rest = demand.confidence_factor * strongest <= threshold
    rigid = wall.moment_law().is_rigid
    return not rigid or not at_rest or any(check.passed is False for check in checks)


def _strongest(demand: DemandResult, kinematic, circumstances) -> float:
    """Largest acceleration under the wall at the demand, FC apart [m/s2]."""
    first = float(demand.target.acceleration([0.0])[0]) if demand.target else demand.pga
    if kinematic and kinematic.floor:
        first = max(first, kinematic.floor.a_z)
    return max(demand.pga, first, circumstances.strongest)


def _limits(
    wall, mechanism: str, block, demand, dynamic, compliance, circumstances: Circumstances
) -> list[Sentence]:
    """Reasons for which the checks are indicative only."""
    reasons = []
    if dynamic:
        if compliance is None:
            reasons.append(_reason("no_spectrum"))
        elif not compliance.compatible:
            reasons.append(_reason("not_compatible"))
        elif compliance.narrow:
            (low, high), (least, most) = compliance.period_range, compliance.full_range
            reasons.append(_reason("narrow_range", low=low, high=high, least=least, most=most))
        if demand.record_scaling == "pga":
            reasons.append(_reason("pga_scaling"))
        if demand.weak_share is not None:
            reasons.append(_reason("weaker_records", share=demand.weak_share))
        stations = compliance.stations if compliance else circumstances.stations
        if stations < MINIMUM_FROM:
            reasons.append(_reason("few_records", n=stations))
        if circumstances.bundled:
            reasons.append(_reason("bundled"))
        if not circumstances.both_signs:
            reasons.append(_reason("one_sign"))
        if not circumstances.exact:
            reasons.append(_reason("comparison_method"))
    if circumstances.period_estimated:
        reasons.append(_reason("period_estimated"))
    if mechanism == "one_sided" and not wall.back_restraint:
        reasons.append(_reason("no_restraint"))
    if not demand.soil_factor_stated:
        reasons.append(_reason("no_soil_factor"))
    alpha = math.degrees(block.slenderness)
    if alpha > STOCKY_DEG:
        reasons.append(_reason("stocky", alpha=alpha))
    return reasons


def _sentence(
    code: str,
    threshold: float,
    demand,
    governing,
    q_code,
    dynamic,
    above_ground: bool,
    largest: float,
) -> tuple[Sentence, ...]:
    """The parts of the sentence of a verdict. threshold : a_RM; largest : under the wall, FC apart [m/s2]."""
    way = code
    if code == "not_activated" and above_ground:
        way = "not_activated_floor"
    if code == "verified" and governing.name == "linear_q_code":
        way = "verified_simply" if demand.limit_state == "SLV" else "verified_plainly"
    elif code == "verified" and q_code is None:
        way = "verified_plainly"
    elif code == "verified_refined" and q_code is None:
        way = "verified_alone"
    zeta = apart(governing.zeta if governing else None, demand.zeta_target)
    if demand.zeta_target != 1.0:
        zeta = sentence("added", "required", zeta=zeta, target=demand.zeta_target)
    method = sentence("method", governing.label) if governing else ""
    lifting = demand.confidence_factor * largest / G
    parts = [
        sentence(
            "verdict", way, state=demand.limit_state, q=demand.q_code, zeta=zeta, method=method, demand=lifting,
            a_rm=threshold / G,
        )
    ]  # fmt: skip
    if code not in ("undetermined", "not_activated") and dynamic:
        parts += _dynamic_parts(dynamic, demand.zeta_target)
    return tuple(parts)


def _dynamic_parts(dynamic: DemandCheck, target: float) -> list[Sentence]:
    """How many multipliers around a demand that is met fail, and whether FC on the other side decides
    differently."""
    parts, other = [], dynamic.zeta_other
    if dynamic.passed and dynamic.zeta_16 is not None and dynamic.zeta_16 < target:
        share = dynamic.share_failing_at_demand
        if target == 1.0:
            parts.append(sentence("added", "share", share=share))
        else:
            parts.append(sentence("added", "share_of_target", share=share, target=target))
    if other and other.passed != dynamic.passed:
        zeta = Number(other.zeta)
        if not other.passed and other.zeta is not None and other.zeta >= target:
            zeta = sentence("added", "fails_at_demand", zeta=zeta)
        negation = sentence("added", "nothing" if other.passed else "not")
        parts.append(
            sentence("added", f"confidence_{other.confidence_on}", negation=negation, zeta=zeta)
        )
    return parts
