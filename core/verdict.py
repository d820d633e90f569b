"""The verdict of a wall: one code, its reasons, one sentence in each language. Never the word "safe"."""

import math
from dataclasses import dataclass

from core.compliance import Compliance
from core.demand import DemandResult
from core.demand_check import DemandCheck
from core.kinematic import Check, Kinematic
from core.limits import MEAN_FROM, MINIMUM_FROM
from core.units import G

ORDER = ("dynamic", "nonlinear", "linear_q_slv", "linear_q_code")
"""The check that governs is the first of these that could be made."""

METHOD_WORDS = {
    "dynamic": ("the dynamic check (C8.7.1.2.1.9)", "la verifica dinamica (C8.7.1.2.1.9)"),
    "nonlinear": ("the nonlinear kinematic check (C8.7.1.2.1.8)",
                  "la verifica cinematica non lineare (C8.7.1.2.1.8)"),
    "linear_q_slv": ("the linear kinematic check with q of the time histories (C8.7.1.2.1.7)",
                     "la verifica cinematica lineare con q delle storie temporali (C8.7.1.2.1.7)"),
    "linear_q_code": ("the linear kinematic check with the q of the code (C8.7.1.2.1.7)",
                      "la verifica cinematica lineare con q di norma (C8.7.1.2.1.7)"),
    "linear_sld": ("the linear kinematic check (C8.7.1.2.1.5)",
                   "la verifica cinematica lineare (C8.7.1.2.1.5)"),
}  # fmt: skip
"""Label of a check -> (English, Italian)."""

SENTENCES = {
    "not_activated": (
        "The mechanism does not start: FC S a_g = {demand:.3f} g does not exceed a_RM = {a_rm:.3f} g.",
        "Il meccanismo non si attiva: FC S a_g = {demand:.3f} g non supera a_RM = {a_rm:.3f} g.",
    ),
    "verified": (
        "Verified at {state}: zeta {zeta} by {method}; the check with q = {q:g} agrees.",
        "Verificata allo {state}: zeta {zeta} secondo {method}; la verifica con q = {q:g} concorda.",
    ),
    "verified_plainly": (
        "Verified at {state}: zeta {zeta} by {method}.",
        "Verificata allo {state}: zeta {zeta} secondo {method}.",
    ),
    "verified_simply": (
        "Verified at {state}: zeta {zeta} by {method}, the simplified one.",
        "Verificata allo {state}: zeta {zeta} secondo {method}, quella semplificata.",
    ),
    "verified_refined": (
        "Verified at {state} by {method} only: zeta {zeta}. With q = {q:g} it is not: the designer must "
        "justify the refined method.",
        "Verificata allo {state} solo secondo {method}: zeta {zeta}. Con q = {q:g} non lo è: il "
        "progettista deve motivare il metodo raffinato.",
    ),
    "verified_alone": (
        "Verified at {state} by {method} only: zeta {zeta}. The check with q = {q:g} could not be made: the "
        "designer must justify the refined method.",
        "Verificata allo {state} solo secondo {method}: zeta {zeta}. La verifica con q = {q:g} non è stata "
        "possibile: il progettista deve motivare il metodo raffinato.",
    ),
    "q2_unsafe": (
        "Not verified at {state}: zeta {zeta} by {method}. The check with q = {q:g} alone would pass "
        "and is not conservative here.",
        "Non verificata allo {state}: zeta {zeta} secondo {method}. La sola verifica con q = {q:g} "
        "sarebbe soddisfatta: qui non è cautelativa.",
    ),
    "not_verified": (
        "Not verified at {state}: zeta {zeta} by {method}.",
        "Non verificata allo {state}: zeta {zeta} secondo {method}.",
    ),
    "indicative": (
        "Indicative only: zeta {zeta} at {state} by {method}, not a verification.",
        "Solo indicativo: zeta {zeta} allo {state} secondo {method}, non è una verifica.",
    ),
    "undetermined": (
        "Undetermined at {state}: see the reasons.",
        "Non determinabile allo {state}: vedere i motivi.",
    ),
}  # fmt: skip
"""Code of a verdict, or one of the ways to say `verified` and `verified_refined` -> (English, Italian)."""

ADDED = {
    "share": (
        " Of the multipliers within 10 % of {demand} {share:.0%} fail.",
        " Dei moltiplicatori entro il 10 % da{demand} il {share:.0%} non soddisfa la regola.",
    ),
    "confidence_demand": (
        " With FC on the demand instead of the strength it is {not_}verified: zeta {zeta}.",
        " Con FC sulla domanda anziché sulla resistenza {not_}è verificata: zeta {zeta}.",
    ),
    "confidence_capacity": (
        " With FC on the strength, as C8.7.1.2.1.3 has it, it is {not_}verified: zeta {zeta}.",
        " Con FC sulla resistenza, come nel C8.7.1.2.1.3, {not_}è verificata: zeta {zeta}.",
    ),
    "unloaded": (", if the wall carries no load.", ", se la parete non porta carichi."),
}
"""What a sentence is followed by."""

REASONS = {
    "upper_floor": (
        "The base of the wall is {z:g} m above the ground: not assessable with the ground motion alone, a "
        "motion of the floor is needed.",
        "La base della parete è a {z:g} m dal suolo: non valutabile con il solo moto del terreno, serve il "
        "moto del piano.",
    ),
    "no_number": (
        "A time history ended without a number (impact limit).",
        "Una storia temporale è terminata senza un valore (limite di urti).",
    ),
    "within_spread": (
        "zeta is known from {low:.3f} to {high:.3f} only, and the required {target:.2f} lies between.",
        "zeta è nota solo fra {low:.3f} e {high:.3f}, e il valore richiesto {target:.2f} sta in mezzo.",
    ),
    "weaker_fails": (
        "The rule holds at {at_en} itself but fails around {zeta:.2f} of it: a weaker motion is worse.",
        "La regola vale {at_it} ma non intorno a {zeta:.2f} di essa: un moto più debole è più "
        "gravoso.",
    ),
    "demand_fails": (
        "The rule fails at {at_en} itself, though at fewer than half of the multipliers around.",
        "La regola non vale {at_it} stessa, benché cada a meno di metà dei moltiplicatori intorno.",
    ),
    "whole_demand_fails": (
        "The rule holds at the {target:g} of the demand that is required, and fails at the demand itself.",
        "La regola vale al {target:g} della domanda richiesto, e non alla domanda stessa.",
    ),
    "narrow_range": (
        "The records are compared with the spectrum from {low:g} to {high:g} s only, as asked: {least:g} to "
        "{most:.2f} s are the periods that matter.",
        "Gli accelerogrammi sono confrontati con lo spettro solo da {low:g} a {high:g} s, come richiesto: contano i "
        "periodi da {least:g} a {most:.2f} s.",
    ),
    "rigid_free": (
        "C8.7.1.2.1.3 asks an initial elastic branch of an element free to vibrate: the histories use the rigid law; "
        "compare with law = {{ elastic_limit, plateau_end }}.",
        "Il C8.7.1.2.1.3 richiede un ramo elastico iniziale per un elemento libero di vibrare: le storie usano la "
        "legge rigida; confrontare con law = {{ elastic_limit, plateau_end }}.",
    ),
    "no_period": (
        "Linear checks not made: an element free to vibrate is compared with the spectrum at T_0 "
        "(C8.7.1.2.1.5, .7), which takes {missing}.",
        "Verifiche lineari non eseguite: un elemento libero di vibrare si confronta con lo spettro in T_0 "
        "(C8.7.1.2.1.5, .7), che richiede {missing}.",
    ),
    "no_check": (
        "No check could be made.", "Nessuna verifica è stata possibile.",
    ),
    "no_restraint": (
        "The restraint behind the wall is not named: one-sided rocking rests on it.",
        "Il vincolo dietro la parete non è indicato: l'oscillazione su un lato si basa su di esso.",
    ),
    "more_records": (
        "{n} stations: C8.7.1.2.1.9 advises more records than the analysis of the whole building takes.",
        "{n} stazioni: il C8.7.1.2.1.9 consiglia un numero di accelerogrammi maggiore che per l'analisi globale.",
    ),
    "no_station": (
        "{n} file(s) name no station: each was counted as a station of its own.",
        "{n} file non indicano la stazione: ognuno è stato contato come una stazione a sé.",
    ),
    "not_compatible": (
        "The set of records is not compatible with the target spectrum.",
        "L'insieme degli accelerogrammi non è compatibile con lo spettro.",
    ),
    "no_spectrum": (
        "No target spectrum is given: the compatibility of the records is not shown.",
        "Spettro non assegnato: la compatibilità degli accelerogrammi non è dimostrata.",
    ),
    "few_records": (
        "{n} record(s): fewer than 3.", "{n} accelerogrammi: meno di 3."
    ),
    "bundled": (
        "The records are the bundled example, for trials only.",
        "Gli accelerogrammi sono quelli di esempio, solo per prova.",
    ),
    "stocky": (
        "alpha {alpha:.1f} deg is outside the range in which the kinematic model is usual (up to 20 deg).",
        "alpha {alpha:.1f}° è fuori dal campo usuale del modello cinematico (fino a 20°).",
    ),
    "pga_scaling": (
        "Every record is rescaled to a_g S: the compatibility of the set is broken.",
        "Ogni accelerogramma è riscalato ad a_g S: la compatibilità dell'insieme non vale più.",
    ),
    "one_sign": (
        "A one-sided wall was given each record with one sign only.",
        "Una parete su un lato è stata analizzata con un solo segno di ogni accelerogramma.",
    ),
    "comparison_method": (
        "The integrator chosen is for comparison only.",
        "L'integratore scelto serve solo per confronto.",
    ),
    "no_soil_factor": (
        "S is not given and taken as 1, rock.", "S non è assegnato ed è posto pari a 1, roccia.",
    ),
    "disagrees": (
        "{method} gives zeta {zeta:.2f}: {outcome}.", "{method}: zeta {zeta:.2f}, {outcome}."
    ),
}  # fmt: skip

STOCKY_DEG = 20.0

MISSING_WORDS = {
    "elastic_modulus_mpa": ("the elastic modulus E", "il modulo elastico E"),
    "unit_weight_kn_m3": ("the unit weight", "il peso specifico"),
    "height_m": ("a rectangular wall", "una parete rettangolare"),
    "spectrum": ("the spectrum of the demand", "lo spettro della domanda"),
    "period_0": (
        "a shorter T_0 (E, unit weight and H/t as given make the wall elastic up to d_SLV)",
        "un T_0 più breve (con E, peso specifico e H/t dati la parete è elastica fino a d_SLV)",
    ),
}
"""What T_0 and the spectrum there take -> (English, Italian)."""


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
        if demand.asked.demand_scaling == "pga":
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
    if demand.target is None and demand.asked.soil_factor is None:
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
