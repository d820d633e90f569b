"""The sentence of a verdict: outcome, zeta and what is required, where, by what, and every check that fails."""

from core.codes.assumption import VALUE_UNITS, Assumption, value_format
from core.codes.demand import SeismicDemand
from core.codes.dynamic_check import DynamicCheck
from core.codes.kinematic import Check
from core.codes.outcomes import OUTCOMES, PASSES
from core.text.sentence import Key, Number, Sentence, apart, sentence
from core.units import G
from core.wall.masonry import Declared, Masonry

CODE_Q = 2.0
"""q of C8.7.1.2.1.7."""


def hinge_phrase(height: float, z: float) -> Sentence | str:
    """Words that say where a hinge is, for the sentence of a wall: none at its base on the ground. height : above the
    base of the wall; z : above the ground [m]"""
    if height > 0.0:
        return sentence("added", "at_hinge", height=height)
    return sentence("added", "at_base", z=z) if z > 0.0 else ""


def restraint_phrase(said: Declared) -> Sentence:
    """What stands behind a wall or holds its top, as the engineer declares it, and what shows it."""
    named = sentence("word", f"choice_{said.restraint}") if said.restraint else sentence("word", "unnamed")
    evidence = sentence("word", f"evidence_{said.evidence or 'unstated'}")
    if said.note:
        return sentence("added", "declared_note", restraint=named, note=said.note, evidence=evidence)
    return sentence("added", "declared", restraint=named, evidence=evidence)


def check_sentence(check: Check, dynamic: DynamicCheck | None, demand: SeismicDemand) -> Sentence:
    """Sentence on a check with the demand and the capacity it compares."""
    if check.name != "dynamic" or dynamic is None:
        # zeta is then that of a_g,SLD, which the displacement check is not below (C8.7.1.2.1.8)
        starts = False
        if check.name == "nonlinear" and not (check.zeta is None or check.capacity is None or check.demand is None):
            starts = check.zeta * check.demand > check.capacity * (1.0 + 1e-9)
        return sentence(
            "added",
            "by_nonlinear_start" if starts else f"by_{check.label}",
            q=Number(check.q, "g"),
            state=demand.limit_state,
            capacity=Number(check.capacity, ".3f"),
            demand=Number(check.demand, ".3f"),
        )
    falls = sum(run.status != "stable" for run in dynamic.runs)
    beyond = sum(run.exceeded or run.status != "stable" for run in dynamic.runs)
    at = "at_full_demand" if demand.zeta_target != 1.0 and beyond else "nothing"
    if beyond > falls:  # some come back from beyond theta_c, which the rule does not allow either
        values = {"at": sentence("added", at), "n": beyond, "m": len(dynamic.runs), "falls": falls}
        return sentence("added", "by_dynamic_beyond", **values)
    if falls:
        return sentence("added", "by_dynamic_falls", at=sentence("added", at), n=falls, m=len(dynamic.runs))
    rule = "by_dynamic_mean" if dynamic.set_rule == "mean" else "by_dynamic_maximum"
    return sentence("added", rule, peak=Number(dynamic.peak_ratio), limit=Number(dynamic.limit_ratio))


def _failing(checks, governing, dynamic, demand) -> tuple[Sentence, ...]:
    """Checks beside the one that decides that are not satisfied, with zeta."""
    target = demand.zeta_target
    sentences = [
        sentence(
            "added",
            "check_zeta",
            check=sentence("short", check.label, q=Number(check.q, "g")),
            zeta=apart(check.zeta, target),
        )
        for check in checks
        if check is not governing and check.passed is False
    ]
    other = dynamic.zeta_other if dynamic else None
    if other and not other.passed:
        zeta = Number(None) if other.zeta is None else apart(other.zeta, target)
        if other.zeta is not None and other.zeta >= target:
            zeta = sentence("added", "fails_at_demand", zeta=zeta)
        side = sentence("short", f"confidence_{other.confidence_on}", q="")
        sentences.append(sentence("added", "check_zeta", check=side, zeta=zeta))
    return tuple(sentences)


def _turned_by(row: Assumption, target: float) -> Sentence:
    """A row whose other end turns the outcome, with zeta there."""
    value = row.other_end
    if isinstance(value, float):
        factor, unit = VALUE_UNITS.get(row.key, (1.0, ""))
        value = sentence("added", "measure", value=Number(factor * value, value_format(factor * value)), unit=unit)
    return sentence("added", "turned_by", key=Key(row.key), value=value, zeta=apart(row.zeta, target))


def _carried_by(
    code: str, tail, wall: Masonry, permitted: tuple[Assumption, ...], shown: tuple[Assumption, ...], target: float
):
    """The end of a sentence with what the outcome rests on: what holds the wall, the documents that show what would
    turn it, and permitted values."""
    holds = (wall.declared.at_foot, wall.declared)
    rests_on = [restraint_phrase(held) for held in holds if held is not None and held.restraint]
    rests_on = list(dict.fromkeys(rests_on))
    rests_on += [sentence("added", "shown_key", key=Key(row.key), document=row.reason) for row in shown]
    if code in ("verified", "verified_refined", "not_activated") and rests_on:
        tail = sentence("added", "rests_on", tail=tail, things=tuple(rests_on))
    if code in ("verified", "verified_refined", "indicative", "not_activated") and permitted:
        rows = tuple(_turned_by(row, target) for row in permitted)
        tail = sentence("added", "would_turn", tail=tail, rows=rows)
    return tail


def outcome(
    code: str,
    missing,
    threshold: float,
    demand,
    governing,
    checks,
    dynamic,
    by,
    largest: float,
    wall: Masonry,
    permitted: tuple[Assumption, ...] = (),
    shown: tuple[Assumption, ...] = (),
    histories_off: bool = False,
    zeta_beside: float | None = None,
) -> tuple[str, dict]:
    """Choose the sentence of a verdict: its key in the catalogue, and the values of its placeholders.

    code : of the verdict
    missing : Sentence of what no verdict can be given without, or None
    threshold : a_RM [m/s2]
    demand : DemandResult
    governing : Check that decides, or None
    checks : those that were made
    dynamic : DemandCheck, None where there are no histories
    by : Sentence of what the check that decides compares
    largest : acceleration under the wall at the demand, FC apart [m/s2]
    wall : what is declared of it, and what it carries
    permitted : defaults that a clause permits, and whose other ends turn the outcome
    shown : inputs whose other ends would turn it, but for the document that shows them
    histories_off : none were to be made
    zeta_beside : of those that decide nothing
    """
    target, way = demand.zeta_target, code
    if code == "not_activated" and wall.above_ground:
        way = "not_activated_floor" if wall.arch or not wall.bends else "not_activated_bending"
    zeta = apart(governing.zeta if governing else None, target)
    if target != 1.0:
        zeta = sentence("added", "required", zeta=zeta, target=target)
    fails = _failing(checks, governing, dynamic, demand) if governing and code != "not_activated" else ()
    tail = sentence("added", "not_by", checks=fails) if fails else ""
    beside = any(check.name == "linear_q_code" for check in checks)
    alone = target < 1.0 or wall.ties  # q = 2 says nothing of these
    if code == "verified" and beside and not fails and governing.name != "linear_q_code" and not alone:
        tail = sentence("added", "q_agrees", q=CODE_Q)
    elif code == "q2_unsafe":
        tail = sentence("added", "q_would_pass", q=CODE_Q, tail=tail)
    elif code == "verified_refined" and not beside:
        tail = sentence("added", "no_q_check", q=CODE_Q, tail=tail)
    if histories_off and OUTCOMES[code].judgement == PASSES:
        tail = sentence("added", "no_histories_made", tail=tail)
    if zeta_beside is not None:
        tail = sentence("added", "histories_beside", tail=tail, zeta=apart(zeta_beside, target))
    tail = _carried_by(code, tail, wall, permitted, shown, target)
    low, high = dynamic.zeta_spread if code == "at_limit" else (None, None)
    return way, {
        "state": demand.limit_state,
        "zeta": zeta,
        "by": by,
        "tail": tail,
        "target": target,
        "low": apart(low, target),
        "high": apart(high, target, above=True),
        "missing": missing or "",
        "demand": demand.confidence_factor * largest / G,
        "a_rm": threshold / G,
        "unloaded": ""
        if code == "undetermined" or wall.declared.unloaded or any(load.tie is None for load in wall.loads)
        else sentence("added", "unloaded"),
    }
