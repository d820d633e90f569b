"""The verdict of a wall: one code, its reasons, one sentence in each language. Never the word "safe"."""

import math
from dataclasses import dataclass

from core.compliance import LEAST_RECORDS, Compliance
from core.demand import DemandResult
from core.demand_check import DemandCheck, numerical_spread
from core.kinematic import Check
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
}  # fmt: skip

SENTENCES = {
    "not_activated": (
        "The mechanism does not start: FC S a_g = {demand:.3f} g does not exceed a_RM = {a_rm:.3f} g.",
        "Il meccanismo non si attiva: FC S a_g = {demand:.3f} g non supera a_RM = {a_rm:.3f} g.",
    ),
    "verified": (
        "Verified at {state}: zeta {zeta:.2f} by {method}; the check with q = {q:g} agrees.",
        "Verificata allo {state}: zeta {zeta:.2f} secondo {method}; la verifica con q = {q:g} concorda.",
    ),
    "verified_simply": (
        "Verified at {state}: zeta {zeta:.2f} by {method}, the simplified one.",
        "Verificata allo {state}: zeta {zeta:.2f} secondo {method}, quella semplificata.",
    ),
    "verified_refined": (
        "Verified at {state} by {method} only: zeta {zeta:.2f}. With q = {q:g} it is not: the designer must "
        "justify the refined method.",
        "Verificata allo {state} solo secondo {method}: zeta {zeta:.2f}. Con q = {q:g} non lo è: il "
        "progettista deve motivare il metodo raffinato.",
    ),
    "q2_unsafe": (
        "Not verified at {state}: zeta {zeta:.2f} by {method}. The check with q = {q:g} alone would pass "
        "and is not conservative here.",
        "Non verificata allo {state}: zeta {zeta:.2f} secondo {method}. La sola verifica con q = {q:g} "
        "sarebbe soddisfatta: qui non è cautelativa.",
    ),
    "not_verified": (
        "Not verified at {state}: zeta {zeta:.2f} by {method}.",
        "Non verificata allo {state}: zeta {zeta:.2f} secondo {method}.",
    ),
    "indicative": (
        "Indicative only: zeta {zeta:.2f} at {state} by {method}, not a verification.",
        "Solo indicativo: zeta {zeta:.2f} allo {state} secondo {method}, non è una verifica.",
    ),
    "undetermined": (
        "Undetermined at {state}: see the reasons.",
        "Non determinabile allo {state}: vedere i motivi.",
    ),
}  # fmt: skip

REASONS = {
    "upper_floor": (
        "The base of the wall is {z:.2f} m above the ground: not assessable with the ground motion alone, a "
        "motion of the floor is needed.",
        "La base della parete è a {z:.2f} m dal suolo: non valutabile con il solo moto del terreno, serve il "
        "moto del piano.",
    ),
    "no_number": (
        "A time history ended without a number (impact limit).",
        "Una storia temporale è terminata senza un valore (limite di urti).",
    ),
    "within_spread": (
        "zeta {zeta:.4f} lies within the numerical spread of the target {target:.2f}.",
        "zeta {zeta:.4f} è entro l'incertezza numerica del valore richiesto {target:.2f}.",
    ),
    "weaker_fails": (
        "The rule holds at the demand itself but fails at {zeta:.2f} of it: a weaker motion is worse.",
        "La regola vale alla domanda ma non a {zeta:.2f} di essa: un moto più debole è più gravoso.",
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
    block,
    demand: DemandResult,
    checks: tuple[Check, ...],
    dynamic: DemandCheck | None,
    compliance: Compliance | None,
    circumstances: Circumstances,
    lower_bound: float | None,
) -> Verdict:
    """The verdict from the checks of a wall, the most refined first. checks : those that were made."""
    made = {check.name: check for check in checks}
    found = next((made[name] for name in ORDER if name in made), None)
    q_code = made.get("linear_q_code")
    zeta = found.zeta if found else None
    target = demand.zeta_target
    doubts, limits = [], []
    first = float(demand.target.acceleration([0.0])[0]) if demand.target else demand.pga
    strongest = max(demand.pga, first, circumstances.strongest) * max(1.0, target)
    at_rest = demand.confidence_factor * strongest <= block.threshold_acceleration
    activated = (
        not wall.moment_law().is_rigid
        or not at_rest
        or any(check.passed is False for check in checks)
    )
    if wall.base_z_m > 0.0:
        doubts.append(_reason("upper_floor", z=wall.base_z_m))
    elif found is None or zeta is None:
        doubts.append(_reason("no_number"))
    elif (
        activated
        and numerical_spread(zeta, target, found.name in ("dynamic", "linear_q_slv"))
        and not (dynamic and found.passed is False)
    ):
        doubts.append(_reason("within_spread", zeta=zeta, target=target))
    if dynamic and dynamic.holds and zeta is not None and zeta < min(1.0, target):
        doubts.append(_reason("weaker_fails", zeta=zeta))
    if dynamic:
        if compliance is None:
            limits.append(_reason("no_spectrum"))
        elif not compliance.compatible:
            limits.append(_reason("not_compatible"))
        if demand.asked.demand_scaling == "pga":
            limits.append(_reason("pga_scaling"))
        stations = compliance.stations if compliance else circumstances.records
        if stations < LEAST_RECORDS:
            limits.append(_reason("few_records", n=stations))
        if circumstances.bundled:
            limits.append(_reason("bundled"))
        if not circumstances.both_signs:
            limits.append(_reason("one_sign"))
        if not circumstances.exact:
            limits.append(_reason("comparison_method"))
    if demand.target is None and demand.asked.soil_factor is None:
        limits.append(_reason("no_soil_factor"))
    alpha = math.degrees(block.slenderness)
    if alpha > STOCKY_DEG:
        limits.append(_reason("stocky", alpha=alpha))
    if wall.base_z_m > 0.0 or zeta is None:
        code = "undetermined"
    elif not activated:
        code = "not_activated"
    elif doubts:
        code = "undetermined"
    elif limits:
        code = "indicative"
    elif found.passed:
        code = "verified" if q_code and q_code.passed else "verified_refined"
    else:
        code = "q2_unsafe" if q_code and q_code.passed else "not_verified"
    notes = [
        tuple(
            REASONS["disagrees"][k].format(
                method=_started(METHOD_WORDS[other.name][k]), zeta=other.zeta,
                outcome=(("passed", "soddisfatta") if other.passed else ("not passed", "non soddisfatta"))[k],
            )
            for k in (0, 1)
        )
        for other in checks
        if found and other is not found and other.passed is not None and other.passed != found.passed
    ]  # fmt: skip
    words = METHOD_WORDS[found.name] if found else ("", "")
    values = {
        "state": demand.limit_state, "zeta": zeta or 0.0, "q": demand.q_code,
        "demand": demand.confidence_factor * demand.pga / G,
        "a_rm": block.threshold_acceleration / G,
    }  # fmt: skip
    simply = code == "verified" and found.name == "linear_q_code"
    english, italian = SENTENCES["verified_simply" if simply else code]
    return Verdict(
        code, found.name if found else None, zeta, target, (*doubts, *limits, *notes),
        english.format(method=words[0], **values), italian.format(method=words[1], **values),
        lower_bound,
    )  # fmt: skip
