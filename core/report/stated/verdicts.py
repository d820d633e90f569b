"""Quantities of the verdict of a wall, of its sensitivities and of its variants."""

from collections.abc import Callable
from typing import NamedTuple

from core.answer.answer import Answer
from core.case.set_aside import ROWS
from core.codes.assumption import DisplayValue
from core.report.stated.checks import REACTION
from core.report.stated.quantity import (
    Quantity,
    flag,
    list_quantity,
    mapping_quantity,
    number,
    numbers,
    object_quantity,
    rebase_group,
    text,
    texts,
    whole,
)
from core.report.verdict_words import outcome_of
from core.study.register import Looked, make_register
from core.study.results import StudyResult, WallResult, WallVerdict
from core.study.wall_verdict import collect_assumptions, governing_check_of_wall, hinge_location
from core.text.sentence import Sentence
from core.units import G
from core.variation.limit_states import LIMIT_STATES
from core.variation.swings import describe_swing_end

SENTENCE_QUANTITIES = (
    text("key", "which remark", "code"),
    text("text_it", "in Italian", lambda said: said.text("it")),
    text("text_en", "in English", lambda said: said.text("en")),
)
"""Quantities read from Sentence."""


def _why(language: str) -> Callable[[Looked], str]:
    def read(looked: Looked) -> str:
        why = looked.row.why
        return why.text(language) if isinstance(why, Sentence) else why

    return read


def _in_english(value: DisplayValue) -> float | str:
    return value.text("en") if isinstance(value, Sentence) else value


ASSUMPTION = (
    text("key", "key of the case"),
    Quantity("value", "any", "value taken; what has words is in English", lambda row: _in_english(row.value)),
    text("source", "given, default, left_out or declared"),
    Quantity("other_end", "any", "the other end of its range", lambda row: _in_english(row.other_end)),
    number("zeta", "-", "zeta_E there"),
    text("outcome", "outcome there"),
    flag("turns", "whether it turns what is satisfied into what is not"),
    text("reason", "of the engineer", lambda row: _in_english(row.reason)),
    text("text_it", "the row in Italian", lambda row: row.words.text("it")),
    text("text_en", "the row in English", lambda row: row.words.text("en")),
)
"""Quantities read from Assumption."""

INTERVAL = (
    number("low", "-", "lower end of zeta_E for nine of ten sets of as many stations"),
    number("high", "-", "upper end"),
    whole("stations", "stations drawn from"),
    flag("open_end", "whether the upper end is that of the search"),
)

MEASURE = (
    text(
        "measure",
        "measure_tie, measure_ties, measure_hold, measure_thrust, measure_height or measure_thickness",
        "code",
    ),
    number("size", "-", "force at each height [kN/m], height or thickness [m], share of the thrusts"),
    number("zeta", "-", "zeta of the wall with it"),
    numbers("heights_m", "m", "at which it acts", "heights"),
    whole("bar_mm", "diameter of the bars of a tie", lambda of: of.bar[0]),
    texts("to_show", "keys of what documents must show once it is there"),
    texts("to_look_at", "mechanisms that have to be looked at once it is there"),
)
"""Quantities read from Measure."""

RATE = (
    text("state", "limit state, or collapse"),
    object_quantity(
        "fragility",
        "lognormal of a_g on rock, FC included",
        (
            number("median", "m/s2", "median"),
            number("deviation", "-", "standard deviation of the logarithm"),
            whole("n", "records"),
        ),
    ),
    number("rate", "1/year", "exceedances"),
    number("low", "1/year", "lower end for nine of ten sets of stations"),
    number("high", "1/year", "upper end"),
    number("in_life", "-", "probability in the nominal life"),
    number("without_factor", "1/year", "rate without FC"),
    number("beyond", "-", "share of the rate from motions stronger than the hazard tells"),
    number("weaker", "-", "walls that fail below the hazard"),
)

END = (
    Quantity("value", "any", "value of the input there", lambda pair: pair[1].value),
    text("record", "record left out", lambda pair: pair[1].name or None),
    number("zeta", "-", "zeta_E there", lambda pair: pair[1].zeta),
    flag("satisfied", "whether the check is surely satisfied", lambda pair: pair[1].sure),
    text("text_it", "in Italian", lambda pair: describe_swing_end(*pair).text("it")),
    text("text_en", "in English", lambda pair: describe_swing_end(*pair).text("en")),
)
"""Quantities read from (Swing, its end)."""

SENSITIVITY = (
    number("base_zeta", "-", "zeta_E as given", "base"),
    list_quantity(
        "moves",
        "inputs moved, the one that matters most first",
        (
            text("input", "input", "key"),
            Quantity("given", "any", "its value", lambda swing: swing.given),
            list_quantity("ends", "both ends", END, lambda swing: [(swing, end) for end in swing.ends]),
        ),
        "swings",
    ),
    texts("without_effect", "inputs that change nothing", "still"),
    list_quantity(
        "refused",
        "values that are refused",
        (
            text("input", "input", lambda pair: pair[0]),
            text("text_it", "why, in Italian", lambda pair: pair[1].text("it")),
            text("text_en", "why, in English", lambda pair: pair[1].text("en")),
        ),
    ),
    texts("turning", "inputs that turn the outcome"),
    list_quantity(
        "at_target",
        "where an input brings the check to the zeta required",
        (
            text("input", "input", "key"),
            Quantity("given", "any", "its value", lambda reach: reach.given),
            Quantity("by_check", "free", "value at the limit, by check", lambda reach: reach.by_check),
            texts("satisfied_throughout", "checks satisfied over the whole range", "throughout"),
        ),
        "reach",
    ),
)
"""Quantities read from Sensitivity."""


class VerdictSource:
    """What the quantities of a verdict are read from. one : of a wall of the case; result : of the study"""

    def __init__(self, one: WallVerdict, result: StudyResult):
        self.one, self.result = one, result
        self.governing: WallResult = result.walls[one.governing]
        self.verdict = self.governing.required_assessment.verdict
        self.check = governing_check_of_wall(self.governing)
        self.answer = Answer(result, one)

    def text(self, language: str) -> str:
        return self.verdict.text(language, self.one.title, hinge_location(self.governing))


DECISION = (
    text("mechanism", "of the register", "mechanism"),
    number("hinge_m", "m", "height above the base from which it moves", "hinge"),
    text("check", "check that decides about it", "check"),
    text("code", "its outcome", "outcome"),
)
"""Quantities read from Decision."""

VERDICT = (
    text("wall", "name", "one.wall.name"),
    text("variant", "stato di fatto or progetto, null of a wall without variants", "one.wall.variant"),
    text("code", "outcome: not_verified, q2_unsafe, at_limit, undetermined, indicative, verified...", "verdict.code"),
    number("zeta_e", "-", "zeta_E of the check that decides", "verdict.zeta_e"),
    number(
        "zeta_least", "-", "lowest zeta_E of all hinges and mechanisms, null where one is unknown", "one.zeta_least"
    ),
    object_quantity("zeta_least_of", "whose that is, null where one is unknown", DECISION, "answer.least"),
    number("zeta_target", "-", "zeta_E required", "verdict.zeta_target"),
    number("pga_c_g", "g", "PGA_C", lambda of: of.one.risk.pga / G if of.one.risk else None),
    number("return_period_c_years", "years", "T_R,C", lambda of: of.one.risk.return_period if of.one.risk else None),
    number("is_v", "-", "IS-V of the wall", lambda of: of.one.risk.index if of.one.risk else None),
    text("is_v_letter", "its letter", lambda of: of.one.risk.letter if of.one.risk else None),
    number("hinge_m", "m", "height above the base of the hinge that decides", "governing.part.hinge"),
    text("mechanism", "mechanism that decides", "governing.mechanism"),
    text("check", "check that decides", "verdict.governing"),
    text("clause", "its clause", lambda of: of.check.clause if of.check else None),
    text("text_it", "the sentence in Italian", lambda of: of.text("it")),
    text("text_en", "the sentence in English", lambda of: of.text("en")),
    text("decides", "what decides", lambda of: of.verdict.decides.text("en") if of.verdict.decides else ""),
    list_quantity("to_do", "what the engineer has to do", SENTENCE_QUANTITIES, "verdict.to_do"),
    list_quantity(
        "assumptions",
        "what raises zeta and nobody measured",
        ASSUMPTION,
        lambda of: collect_assumptions(of.result, of.one),
    ),
    list_quantity(
        "limits",
        "what the number is to be read with",
        SENTENCE_QUANTITIES,
        lambda of: (*of.verdict.limits, *of.one.extra),
    ),
    list_quantity("notes", "what a reader may pass over", SENTENCE_QUANTITIES, "verdict.notes"),
    list_quantity(
        "mechanisms",
        "the register: every mechanism it may have, those looked at the worst first",
        (
            text("name", ", ".join(ROWS), "row.name"),
            text("status", "looked_at, not_possible, not_looked_at or set_aside", "row.status"),
            number("from_m", "m", "height above the base from which it moves", "row.low"),
            number("to_m", "m", "and up to which", "row.high"),
            number("hinge_m", "m", "hinge about which it turns, null where it bends", "row.hinge"),
            text("direction", "outward, inward, both, or an angle in plan", "row.direction"),
            text("why_it", "why it is not possible, or what is missing, in Italian", _why("it")),
            text("why_en", "in English", _why("en")),
            *rebase_group(
                lambda looked: looked.result and looked.result.required_assessment,
                (
                    text("code", "outcome, null of what is not looked at", "verdict.code"),
                    number("zeta", "-", "zeta_E", "verdict.zeta_e"),
                    text("check", "check that decides", "verdict.governing"),
                    list_quantity(
                        "reactions", "what its holds take, where their strength is known, the weakest first", REACTION
                    ),
                ),
            ),
        ),
        lambda of: make_register(of.result, of.one),
    ),
    mapping_quantity(
        "states",
        "the limit states",
        (text("code", "outcome"), number("zeta_e", "-", "zeta_E", "zeta"), text("check", "check that decides")),
        lambda of: {state: of.one.states[state] for state in LIMIT_STATES},
    ),
    object_quantity("interval", "of zeta_E for other samples of records", INTERVAL, "one.interval"),
    list_quantity("rates", "how often limit states are exceeded", RATE, "one.rates"),
    list_quantity("measures", "that make a wall that fails pass", MEASURE, lambda of: of.one.measures or ()),
    object_quantity(
        "sensitivity", "what other values of the inputs do", SENSITIVITY, lambda of: of.one.sensitivity or None
    ),
)
"""Quantities read from OfWall."""


class VariantSummary(NamedTuple):
    """A wall beside its other variant; q alone without a demand."""

    code: str | None = None
    zeta_e: float | None = None
    zeta_least: float | None = None
    check: str | None = None
    q_set: float | None = None

    @classmethod
    def of(cls, wall: VerdictSource) -> "VariantSummary":
        code, check = outcome_of(wall.result, wall.one)
        return cls(code, wall.verdict.zeta_e, wall.one.zeta_least, check, wall.governing.q_set)


COMPARED = (
    text("code", "outcome, null without a demand"),
    number("zeta_e", "-", "zeta_E"),
    number("zeta_least", "-", "lowest zeta_E of all hinges and mechanisms"),
    text("check", "check that decides"),
    number("q_set", "-", "q of the set"),
)

PAIR = (
    text("name", "name of the wall"),
    texts("changed", "keys that differ"),
    object_quantity("before", "stato di fatto", COMPARED),
    object_quantity("after", "progetto", COMPARED),
)
