"""The verdict of a wall: one code, its reasons, one sentence in each language."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from core.codes.assumption import ALL_TOGETHER_KEY, ARCH, DECLARED, RESTRAINT, Assumption, sort_assumptions
from core.codes.demand import SeismicDemand
from core.codes.evidence import (
    Evidence,
    indicative_reasons,
    missing_input_remark,
    optional_remarks,
    reason,
    unconfirmed_remark,
    zeta_limitations,
)
from core.codes.kinematic import ZETA_ROUNDING, Check
from core.codes.kinematic_chain import restraint_multiplier_at_rest
from core.codes.verdict_sentence import CODE_Q, check_sentence, outcome
from core.codes.vertical_bending import bending, uplift_multiplier
from core.text.sentence import FILE_NAMES, FormNames, Key, Number, Sentence, sentence
from core.units import G

TO_MEND = {
    "no_restraint": Sentence("reason", "to_no_restraint", (("key", Key("hold")),)),
    "no_top_restraint": Sentence(
        "reason", "to_no_top_restraint", (("key", Key("hold")), ("one_sided", Sentence("word", "one_sided")))
    ),
    "no_hold_strength": Sentence("reason", "to_no_hold_strength", (("key", Key("out_kn_m")),)),
    "no_arch": sentence(
        "reason",
        "to_no_arch",
        arch=Key("spacing_m"),
        tie=Key("tie_kn_m"),
        elongation=Key("tie_elongation_m"),
        shoulder=Key("shoulder_length_m"),
        strength=Key("compressive_strength_mpa"),
    ),
    "heights_left_out": Sentence("reason", "to_hinges", (("building", Key("[building]")),)),
    "hinges_as_asked": Sentence(
        "reason", "to_set_aside", (("key", Key("hinge_heights")), ("set_aside", Key("set_aside")))
    ),
    "end_left_open": Sentence("reason", "to_end", (("key", Key("to_m")), ("building", Key("[building]")))),
    "direction_left_out": Sentence("reason", "to_directions", (("set_aside", Key("set_aside")),)),
    "stretches_left_out": Sentence("reason", "to_set_aside_stretch", (("set_aside", Key("set_aside")),)),
    "few_sound_records": Sentence("reason", "to_sound_records"),
    "no_spectrum": Sentence("reason", "to_no_spectrum"),
    "not_compatible": Sentence("reason", "to_not_compatible"),
    "few_records": Sentence("reason", "to_few_records"),
    "too_weak": Sentence("reason", "to_too_weak"),
    "weaker_records": Sentence("reason", "to_weaker_records"),
    "bundled": Sentence("reason", "to_bundled"),
    "one_sign": Sentence("reason", "to_one_sign", (("key", Key("polarity")),)),
    "no_soil_factor": Sentence("reason", "to_no_soil_factor"),
    "annex_unseen": Sentence("reason", "to_annex_unseen", (("key", Key("spectrum_file")),)),
    "upper_floor": Sentence("reason", "to_building", (("building", Key("[building]")),)),
    "upper_top": Sentence("reason", "to_building", (("building", Key("[building]")),)),
    "upper_middle": Sentence("reason", "to_building", (("building", Key("[building]")),)),
    "no_check": Sentence("reason", "to_no_check"),
}
"""What makes a verdict indicative, or is missing, and the designer can mend -> what to do; the first two are said."""


@dataclass(frozen=True)
class Verdict:
    """The verdict of a wall about one hinge.

    code : of the group "verdict"
    governing : name of the check that decides, or None
    way, values : the sentence of the group "verdict" and what it says; `text` adds where
    decides : the check that decides with what it compares, or what is missing
    to_do : what the designer does next, all of it
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
        """The sentence in a language. subject : name of the wall; where : `hinge_phrase`; form : words of the keys"""
        words = sentence("verdict", self.way, where=where, **dict(self.values)).text(language, form)
        return f"{subject}: {words}" if subject else words[:1].upper() + words[1:]


def passes_with_q2(check: Check | None, target: float) -> bool:
    """Whether the check with q of the code is satisfied with q = 2 as well, where a larger q was given."""
    if check is None or check.zeta is None:
        return False
    return check.zeta * min(1.0, CODE_Q / (check.q or CODE_Q)) >= target - ZETA_ROUNDING


def find_outcome(seen: Evidence, unfounded: Sequence[Sentence] = (), q_unfounded: bool = False) -> str:
    """Outcome of a wall, a code of the table of outcomes.

    unfounded : inputs without a reason that raise zeta and turn the outcome; q_unfounded : one turns the check with q
        of the code alone
    """
    if missing_input_remark(seen) is not None:
        return "undetermined"
    blocked = bool(unfounded or indicative_reasons(seen) or unconfirmed_remark(seen))  # one gate for all that passes
    if not blocked and not _activated(seen, _threshold(seen)):
        return "not_activated"
    agrees = not q_unfounded and passes_with_q2(seen.made("linear_q_code"), seen.demand.zeta_target)
    return _code(seen, blocked, agrees)


def _threshold(seen: Evidence) -> float:
    """a_RM [m/s2], of a wall between transverse walls that of what holds it before its ties have to stretch."""
    if seen.wall.arch is not None:
        return G * restraint_multiplier_at_rest(seen.wall, bending(seen.wall))
    return G * uplift_multiplier(seen.wall, seen.mechanism)


def make_verdict(
    seen: Evidence,
    lower_bound: float | None,
    own_limits: tuple[Sentence, ...] = (),
    assumed: tuple[Assumption, ...] = (),
    unlooked: tuple[Sentence, ...] = (),
) -> Verdict:
    """The verdict from the checks of a wall, the most refined first.

    lower_bound : zeta of the two-sided motion where the restraint behind a one-sided wall fails, of the overturning
        of a wall no longer held at its top [-], or None
    own_limits : Sentences on the checks and on the floor of a wall above the ground
    assumed : what raises zeta and is not measured
    unlooked : why that was not looked at
    """
    wall, demand, dynamic = seen.wall, seen.demand, seen.dynamic
    missing, threshold = missing_input_remark(seen), _threshold(seen)
    unfounded = [
        row.words for row in assumed if (row.turns and row.open) or (row.turns and row.key == ALL_TOGETHER_KEY)
    ]
    unfounded += unlooked
    blocking = [*indicative_reasons(seen), *unfounded, *unconfirmed_remark(seen)]
    agrees = passes_with_q2(seen.made("linear_q_code"), demand.zeta_target)
    rests_on = [Key(row.key) for row in assumed if row.turns_q and row.open] if agrees else []
    code = find_outcome(seen, unfounded, bool(rests_on))
    limits = [*blocking, *own_limits]
    limits += [row.words for row in assumed if row.turns and row.words not in limits and row.key != ALL_TOGETHER_KEY]
    if rests_on:
        limits.append(reason("q_rests_on", q=Number(CODE_Q, "g"), keys=tuple(rests_on)))
    limits += zeta_limitations(seen, code)
    governing, by = seen.governing, sentence("added", "nothing")
    if governing and governing.zeta is not None:
        by = check_sentence(governing, dynamic, demand)
    largest = demand.pga
    if wall.above_ground and code == "not_activated":
        largest = _strongest(seen)
    carried = tuple(row for row in assumed if row.turns and row.permitted), _shown(assumed)
    way, values = outcome(
        code,
        missing,
        threshold,
        demand,
        governing,
        seen.checks,
        dynamic,
        by,
        largest,
        wall,
        *carried,
        seen.circumstances.histories_off,
        seen.circumstances.beside,
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
        tuple(_to_do(code, [*blocking, *([missing] if missing else [])], assumed, wall.bends)),
        tuple(limits),
        tuple(optional_remarks(seen, code)),
        lower_bound,
        len(blocking),
        sort_assumptions(assumed),
    )


def make_undetermined(demand: SeismicDemand, why: Sentence) -> Verdict:
    """The verdict of a wall of which no check was made. why : in a sentence"""
    values = {"state": demand.limit_state, "missing": why}
    parts = None, None, demand.zeta_target, "undetermined", tuple(values.items())
    return Verdict("undetermined", *parts, decides=why, limits=(why,))


def _shown(assumed: Iterable[Assumption]) -> tuple[Assumption, ...]:
    """Inputs whose other ends would turn the outcome, alone or with others, but for the document that shows them; of a
    key the first."""
    lifting = (row for row in assumed if (row.turns or row.raises) and row.reason and not row.permitted)
    rows = [row for row in lifting if row.key not in (RESTRAINT, ARCH)]
    return tuple({row.key: row for row in reversed(rows)}.values())[::-1]


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


def _to_do(code: str, blocking: list[Sentence], assumed: tuple[Assumption, ...], held_at_top: bool) -> list[Sentence]:
    """Sentences on what the designer does next, the most urgent first. blocking : with what is missing; held_at_top :
    by what has to be shown to stand, not only to be there"""
    actions = []
    codes = {words.code for words in blocking}
    mends = [to_do for why, to_do in TO_MEND.items() if why in codes]
    if code == "undetermined":
        return [mend for mend in mends if mend.code in ("to_building", "to_no_check", "to_weaker_records")]
    if code == "indicative":
        for row in assumed:
            if row.words in blocking and row.source == DECLARED and row.key in (RESTRAINT, ARCH):
                shows = "to_evidence_strength" if row.key == ARCH or held_at_top else "to_evidence"
                actions.append(reason(shows, hold=row.value, evidence=row.asks))
        actions += _documents_to_give(row for row in assumed if row.words in blocking and row.key not in HELD)
        actions += mends
        if "alone" in codes:
            actions.append(reason("justify"))
    elif code == "verified_refined":
        actions.append(reason("justify"))
    return actions


HELD = ALL_TOGETHER_KEY, RESTRAINT, ARCH
"""Keys of rows that no document of a value answers."""


def _documents_to_give(rows: Iterable[Assumption]) -> list[Sentence]:
    """What documents are asked for, one a key."""
    asks = {row.key: row.asks or Key("evidence") for row in rows}
    return [reason("give_reason", key=Key(key), evidence=evidence) for key, evidence in asks.items()]


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
