"""The verdict of a wall: one code, its reasons, one sentence in each language."""

import math
from dataclasses import dataclass

from core.codes.demand import DemandResult
from core.codes.dynamic_check import DemandCheck
from core.codes.kinematic import Check, Kinematic
from core.codes.limits import MEAN_FROM, MINIMUM_FROM
from core.codes.record_compatibility import Compliance
from core.text.verdicts import ADDED, METHOD_WORDS, MISSING_WORDS, REASONS, SENTENCES
from core.units import G

ORDER = ("dynamic", "nonlinear", "linear_q_slv", "linear_q_code")
"""The check that governs is the first of these that could be made."""

STOCKY_DEG = 20.0


@dataclass(frozen=True)
class Circumstances:
    """What a verdict must know beside the checks. records : files; bundled : some are the example's;
    strongest : largest PGA at the demand, FC apart [m/s2]; both_signs : a one-sided wall was given each
    record with both; exact : the integrator is not one for comparison."""

    records: int
    bundled: bool = False
    strongest: float = 0.0
    both_signs: bool = True
    exact: bool = True


@dataclass(frozen=True)
class Verdict:
    """code : of SENTENCES; governing : name of the check that decides, or None; reasons : pairs (English,
    Italian); text_en, text_it : the sentence; lower_bound : zeta of the two-sided motion where the
    restraint behind a one-sided wall fails, or None."""

    code: str
    governing: str | None
    zeta_e: float | None
    zeta_target: float
    reasons: tuple[tuple[str, str], ...]
    text_en: str
    text_it: str
    lower_bound: float | None = None

    def text(self, language: str) -> str:
        return self.text_it if language == "it" else self.text_en


def _started(words: str) -> str:
    return words[0].upper() + words[1:]


def _reason(name: str, **values) -> tuple[str, str]:
    english, italian = REASONS[name]
    return english.format(**values), italian.format(**values)


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
) -> Verdict:
    """The verdict from the checks of a wall, the most refined first. checks : those that were made;
    kinematic : None above the ground."""
    block = wall.block()
    made = {check.name: check for check in checks}
    found = next((made[name] for name in ORDER if name in made), None)
    q_code = made.get("linear_q_code")
    zeta = found.zeta if found else None
    target = demand.zeta_target
    activated = _activated(wall, block, demand, checks, kinematic, circumstances)
    doubts = []
    if wall.above_ground:
        doubts.append(_reason("upper_floor", z=wall.base_z_m))
    elif found is None:
        doubts.append(_reason("no_check"))
    elif zeta is None:
        doubts.append(_reason("no_number"))
    elif activated and dynamic and dynamic.within_spread(target):
        low, high = dynamic.zeta_spread
        doubts.append(_reason("within_spread", zeta=zeta, target=target, low=low, high=high))
    notes = []
    if kinematic and kinematic.missing:
        words = [MISSING_WORDS[key] for key in kinematic.missing]
        english, italian = REASONS["no_period"]
        notes.append((english.format(missing=", ".join(word[0] for word in words)),
                      italian.format(missing=", ".join(word[1] for word in words))))  # fmt: skip
    at = {"at_en": "the demand", "at_it": "alla domanda"}
    if target != 1.0:
        at = {"at_en": f"{target:g} of the demand", "at_it": f"allo {target:g} della domanda"}
    if dynamic and zeta is not None:
        if zeta < target and dynamic.holds_at_target:
            notes.append(_reason("weaker_fails", zeta=zeta, **at))
        if zeta >= target and not dynamic.holds_at_target:
            notes.append(_reason("demand_fails", **at))
        if dynamic.passed and target < 1.0 <= zeta and not dynamic.holds:
            notes.append(_reason("whole_demand_fails", target=target))
        if kinematic and kinematic.free_element and wall.moment_law().is_rigid:
            notes.append(_reason("rigid_free"))
    limits = _limits(wall, mechanism, block, demand, dynamic, compliance, circumstances)
    if wall.above_ground or zeta is None:
        code = "undetermined"
    elif not activated:
        code = "not_activated"
    elif doubts:
        code = "undetermined"
    elif limits:
        code = "indicative"
    elif found.passed:
        refined = demand.limit_state == "SLV" and not (q_code and q_code.passed)
        code = "verified_refined" if refined else "verified"
    else:
        code = "q2_unsafe" if q_code and q_code.passed else "not_verified"
    notes += [
        tuple(
            REASONS["disagrees"][k].format(
                method=_started(METHOD_WORDS[other.label][k]), zeta=other.zeta,
                outcome=(("passed", "soddisfatta") if other.passed else ("not passed", "non soddisfatta"))[k],
            )
            for k in (0, 1)
        )
        for other in checks
        if found and other is not found and other.passed is not None and other.passed != found.passed
    ]  # fmt: skip
    if dynamic and compliance and code != "not_activated":
        if compliance.unnamed:
            notes.append(_reason("no_station", n=compliance.unnamed))
        if compliance.stations <= MEAN_FROM:
            notes.append(_reason("more_records", n=compliance.stations))
    english, italian = (
        _sentence(k, code, wall, block, demand, found, q_code, dynamic) for k in (0, 1)
    )
    return Verdict(
        code, found.name if found else None, zeta, target, (*doubts, *limits, *notes), english, italian,
        lower_bound,
    )  # fmt: skip


def _activated(wall, block, demand: DemandResult, checks, kinematic, circumstances) -> bool:
    """Whether the motion can lift the wall at all, or a check fails all the same. An element free to vibrate is
    lifted by S_e(T_0) (C8.7.1.9): where T_0 is not known, neither is that it stays at rest."""
    lifted = None if kinematic is None else kinematic.zeta_sld
    if (
        kinematic
        and kinematic.free_element
        and (lifted is None or lifted < max(1.0, demand.zeta_target))
    ):
        return True
    first = float(demand.target.acceleration([0.0])[0]) if demand.target else demand.pga
    strongest = max(demand.pga, first, circumstances.strongest) * max(1.0, demand.zeta_target)
    at_rest = demand.confidence_factor * strongest <= block.threshold_acceleration
    rigid = wall.moment_law().is_rigid
    return not rigid or not at_rest or any(check.passed is False for check in checks)


def _limits(
    wall, mechanism: str, block, demand, dynamic, compliance, circumstances: Circumstances
) -> list[tuple[str, str]]:
    """Reasons for which the checks are indicative only."""
    found = []
    if dynamic:
        if compliance is None:
            found.append(_reason("no_spectrum"))
        elif not compliance.compatible:
            found.append(_reason("not_compatible"))
        elif compliance.narrow:
            (low, high), (least, most) = compliance.period_range, compliance.full_range
            found.append(_reason("narrow_range", low=low, high=high, least=least, most=most))
        if demand.record_scaling == "pga":
            found.append(_reason("pga_scaling"))
        stations = compliance.stations if compliance else circumstances.records
        if stations < MINIMUM_FROM:
            found.append(_reason("few_records", n=stations))
        if circumstances.bundled:
            found.append(_reason("bundled"))
        if not circumstances.both_signs:
            found.append(_reason("one_sign"))
        if not circumstances.exact:
            found.append(_reason("comparison_method"))
    if mechanism == "one_sided" and not wall.back_restraint:
        found.append(_reason("no_restraint"))
    if not demand.soil_factor_stated:
        found.append(_reason("no_soil_factor"))
    alpha = math.degrees(block.slenderness)
    if alpha > STOCKY_DEG:
        found.append(_reason("stocky", alpha=alpha))
    return found


def _sentence(k: int, code: str, wall, block, demand, found, q_code, dynamic) -> str:
    """The sentence of a verdict, in English (k = 0) or Italian (1)."""
    way = code
    if code == "verified" and found.name == "linear_q_code":
        way = "verified_simply" if demand.limit_state == "SLV" else "verified_plainly"
    elif code == "verified" and q_code is None:
        way = "verified_plainly"
    elif code == "verified_refined" and q_code is None:
        way = "verified_alone"
    zeta = f"{found.zeta:.2f}" if found and found.zeta is not None else "–"
    if demand.zeta_target != 1.0:
        zeta += f" ({('required', 'richiesto')[k]} {demand.zeta_target:g})"
    said = SENTENCES[way][k].format(
        state=demand.limit_state, q=demand.q_code, zeta=zeta,
        method=METHOD_WORDS[found.label][k] if found else "",
        demand=demand.confidence_factor * demand.pga / G, a_rm=block.threshold_acceleration / G,
    )  # fmt: skip
    if code not in ("undetermined", "not_activated") and dynamic:
        said += _dynamic_words(k, dynamic, demand.zeta_target)
    if code != "undetermined" and not wall.unloaded_confirmed:
        said = said.removesuffix(".") + ADDED["unloaded"][k]
    return said


def _dynamic_words(k: int, dynamic: DemandCheck, target: float) -> str:
    """How many multipliers around a demand that is met fail, and whether FC on the other side decides
    differently."""
    said, other = "", dynamic.zeta_other
    if dynamic.passed and dynamic.zeta_16 is not None and dynamic.zeta_16 < target:
        part = ("the demand", "lla domanda")[k]
        if target != 1.0:
            part = (f"{target:g} of the demand", f"l {target:g} della domanda")[k]
        said += ADDED["share"][k].format(share=dynamic.share_failing_at_demand, demand=part)
    if other and other.passed != dynamic.passed:
        zeta = "–" if other.zeta is None else f"{other.zeta:.2f}"
        if not other.passed and other.zeta is not None and other.zeta >= target:
            zeta += (
                ", but the rule fails at the demand itself",
                ", ma la regola non vale alla domanda stessa",
            )[k]
        said += ADDED[f"confidence_{other.confidence_on}"][k].format(
            not_="" if other.passed else ("not ", "non ")[k], zeta=zeta
        )
    return said
