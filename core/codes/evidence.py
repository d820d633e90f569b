"""What a verdict is judged by: the checks with their circumstances, and what limits what they say."""

import math
from dataclasses import dataclass
from typing import NamedTuple

from core.capacity.bisection import BRACKET
from core.codes.demand import SeismicDemand
from core.codes.dynamic_check import DynamicCheck
from core.codes.kinematic import Check, KinematicAnalysis
from core.codes.limits import MIN_PGA_SHARE, MIN_STATIONS_FOR_MEAN, MIN_STATIONS_FOR_MINIMUM
from core.codes.outcomes import OUTCOMES, PASSES
from core.codes.record_compatibility import Compliance
from core.codes.spectrum_codes import CODES
from core.codes.target_spectrum import displacement_fall
from core.text.sentence import Key, Number, Sentence, sentence
from core.wall.kinematics import Kinematics, kinematics
from core.wall.masonry import Masonry

STOCKY_DEG = 20.0


@dataclass(frozen=True)
class Circumstances:
    """What limits a verdict beside its checks: how the records were chosen, taken and integrated.

    stations : of the records, two components of one count once
    bundled : some are the example's
    strongest : largest PGA at the demand, FC apart [m/s2]
    both_signs : a one-sided wall was given each record with both
    histories_off : none were to be made; beside : zeta of those that decide nothing [-]
    exact : the integrator is not one for comparison
    unbranched : code of the reason why histories have not the elastic branch the clause asks for, empty where they have
    sound : stations of records that nothing doubts, -1 where nobody looked
    left_out : sentences on the mechanisms that nobody looks at
    """

    stations: int
    bundled: bool = False
    strongest: float = 0.0
    both_signs: bool = True
    histories_off: bool = False
    beside: float | None = None
    exact: bool = True
    unbranched: str = ""
    sound: int = -1
    left_out: tuple[Sentence, ...] = ()


def governing_check(checks: tuple[Check, ...]) -> Check | None:
    """The check that decides: the first, for the most refined of those made comes first."""
    return checks[0] if checks else None


def reason(code: str, /, **values) -> Sentence:
    return sentence("reason", code, **values)


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
    demand: SeismicDemand
    checks: tuple[Check, ...]
    dynamic: DynamicCheck | None
    kinematic: KinematicAnalysis | None
    compliance: Compliance | None
    circumstances: Circumstances

    @property
    def kinematics(self) -> Kinematics:
        """What its mechanism does."""
        return kinematics(self.mechanism)

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


def zeta_limitations(seen: Evidence, code: str) -> list[Sentence]:
    """Sentences that limit the verdict: zeta is to be read with them."""
    limits = _of_the_histories(seen) if code != "undetermined" else []
    if seen.kinematic and seen.kinematic.missing:
        keys = tuple(sentence("missing", key) for key in seen.kinematic.missing)
        limits.append(reason("no_period", missing=keys))
    if seen.demand.target is None and not seen.dynamic and OUTCOMES[code].judgement == PASSES:
        limits.append(reason("linear_alone"))
    if OUTCOMES[code].judgement == PASSES and _rests_on(seen.wall) and seen.kinematic and seen.kinematic.d_limit:
        limits.append(reason("supports", d=seen.kinematic.d_limit, state=seen.demand.limit_state))
    if not seen.wall.bends and seen.wall.leans_inward:
        limits.append(reason("leans_inward"))
    if fall := displacement_fall(seen.demand.target):
        earlier, later, share = fall
        limits.append(reason("spectrum_falls", earlier=earlier, later=later, share=share))
    return limits + _weaker(seen, code, True)


def _rests_on(wall: Masonry) -> bool:
    """Whether a check counts on weights that must stay where they are."""
    return bool(wall.vertical_loads) and wall.arch is None


def optional_remarks(seen: Evidence, code: str) -> list[Sentence]:
    """Sentences a reader may pass over."""
    notes = _weaker(seen, code, False)
    kinematic = seen.kinematic
    if kinematic and kinematic.chain.friction_height is not None:
        notes.append(reason("friction_hinge", height=kinematic.chain.friction_height))
    wall, compliance = seen.wall, seen.compliance
    alpha = 0.0 if wall.arch else math.degrees(wall.block.slenderness)
    if alpha > STOCKY_DEG:
        notes.append(reason("stocky", alpha=alpha))
    if seen.dynamic and compliance and code != "not_activated":
        if compliance.unnamed:
            notes.append(reason("no_station", n=compliance.unnamed))
        if compliance.stations <= MIN_STATIONS_FOR_MEAN:
            notes.append(reason("more_records", n=compliance.stations))
    return notes


def _upper(wall: Masonry) -> str:
    """Code of the sentence that asks for the building of a wall above the ground."""
    if wall.arch is not None:
        return "upper_top"
    return "upper_middle" if wall.bends else "upper_floor"


def missing_input_remark(seen: Evidence) -> Sentence | None:
    """Sentence on what is missing where no verdict can be given, with the keys that give it; None where nothing is."""
    if seen.wall.above_ground and seen.kinematic is None:
        keys = {"height": "height_m", "storeys": "storeys", "period": "period_s", "building": "[building]"}
        keys = {name: Key(key) for name, key in keys.items()}
        return reason(_upper(seen.wall), z=seen.wall.felt, **keys)
    if seen.governing is None:
        keys = {"spectrum": "spectrum", "modulus": "elastic_modulus_mpa", "weight": "unit_weight_kn_m3"}
        return reason("no_check", **{name: Key(key) for name, key in keys.items()})
    unknown = seen.zeta is None and seen.governing.passed is not False  # what is known to fail needs no number
    if unknown and seen.demand.weak_share is not None:
        return reason("weaker_records", share=seen.demand.weak_share)
    return reason("no_number") if unknown else None


def unconfirmed_remark(seen: Evidence) -> list[Sentence]:
    """That neither the displacement check nor FC on the other side confirms what the histories say."""
    if seen.dynamic is None or not seen.dynamic.passed:
        return []
    displacement, other = seen.made("nonlinear"), seen.dynamic.zeta_other
    refuted = displacement is not None and displacement.passed is False
    return [reason("alone")] if refuted and other is not None and not other.passed else []


def _weaker(seen: Evidence, code: str, below: bool) -> list[Sentence]:
    """A motion weaker than zeta_E that fails the rule: said whenever one does. below : what is required, or not"""
    dynamic = seen.dynamic
    if code == "undetermined" or dynamic is None or dynamic.zeta is None or dynamic.zeta_first is None:
        return []
    first = dynamic.zeta_first
    if first >= dynamic.zeta * (1.0 - BRACKET) or (first < seen.demand.zeta_target) != below:
        return []
    return [reason("weaker_fails", first=first, zeta_16=Number(dynamic.zeta_16))]


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
        said.append(reason("demand_fails", at=at))
    if dynamic.passed and target < 1.0 <= zeta and not dynamic.holds:
        said.append(reason("whole_demand_fails", target=target))
    if dynamic.passed and dynamic.zeta_16 is not None and dynamic.zeta_16 < target:
        said.append(reason("share", share=dynamic.share_failing_at_demand, target=target))
    return said


def _of_what_holds(seen: Evidence) -> list[Sentence]:
    """What is not known of what restrains a wall: behind it, between its cross walls, or at its top."""
    wall, declared = seen.wall, seen.wall.declared
    if seen.kinematics.one_way:
        return [] if declared.restraint else [reason("no_restraint")]
    if not wall.bends:
        return []
    if wall.arch is not None:
        return []
    if declared.restraint is None:
        return [reason("no_top_restraint")]
    return [reason("no_hold_strength", key=Key("out_kn_m"))] if declared.strength is None else []


def _of_the_stations(seen: Evidence) -> list[Sentence]:
    """Too few stations for a set, or for its rule without those whose records are doubted."""
    stations, sound = seen.circumstances.stations, seen.circumstances.sound
    if seen.compliance:
        stations = seen.compliance.stations
    if stations < MIN_STATIONS_FOR_MINIMUM:
        return [reason("few_records", n=stations)]
    rests_on = MIN_STATIONS_FOR_MEAN if stations >= MIN_STATIONS_FOR_MEAN else MIN_STATIONS_FOR_MINIMUM
    return [reason("few_sound_records", n=stations - sound, of=stations)] if 0 <= sound < rests_on else []


def indicative_reasons(seen: Evidence) -> list[Sentence]:
    """Reasons for which the checks are indicative only."""
    demand, compliance, circumstances = seen.demand, seen.compliance, seen.circumstances
    reasons = [*circumstances.left_out]
    if seen.dynamic:
        if compliance is None:
            reasons.append(reason("no_spectrum"))
        elif not compliance.compatible:
            reasons.append(reason("not_compatible"))
        elif compliance.narrow:
            (low, high), (least, most) = compliance.period_range, compliance.full_range
            reasons.append(reason("narrow_range", low=low, high=high, least=least, most=most))
        if demand.record_scaling == "pga":
            reasons.append(reason("pga_scaling"))
        if demand.weak_share is not None and seen.checks[0].passed is not None:  # else it is what is missing
            reasons.append(reason("weaker_records", share=demand.weak_share))
        reasons += _of_the_stations(seen)
        if weak := seen.dynamic.not_counted:
            reasons.append(reason("too_weak", n=len(weak), names=weak[:3], share=MIN_PGA_SHARE))
        if circumstances.bundled:
            reasons.append(reason("bundled"))
        if not circumstances.both_signs:
            reasons.append(reason("one_sign"))
        if not circumstances.exact:
            reasons.append(reason("comparison_method"))
        if circumstances.unbranched and seen.governing is not None and seen.governing.name == "dynamic":
            reasons.append(reason(circumstances.unbranched))
    reasons += _of_what_holds(seen)
    if not demand.soil_factor_stated:
        reasons.append(reason("no_soil_factor"))
    code = CODES[demand.spectrum_code] if demand.spectrum_code else None
    if code and not code.seen_in_print:
        reasons.append(reason("annex_unseen", name=code.name))
    return reasons
