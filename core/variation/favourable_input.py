"""An input that raises zeta, and the other ends of its range."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

from core.case.asked import ASKED, EVIDENCE_TABLES, HOLD
from core.case.document import AnyEvidence, Document, document_of, kinds_that_show
from core.codes.assumption import GIVEN, DisplayValue
from core.codes.kinematic import Check
from core.known import require_value
from core.setting.check_input import CheckInput
from core.text.sentence import Number, Sentence, apart, sentence
from core.variation.evaluate import Evaluation

AlternativeEvaluations = list[Evaluation | None]
"""The wall at the other ends of the range of an input; None where it does not stand there."""


ShownBy = tuple[AnyEvidence, ...] | Document | None
"""Evidence of a wall or of the demand, or the one document of what holds it."""

SceneChange = Callable[[CheckInput], CheckInput]


GIVEN_WORD, NONE_WORD = sentence("accepted", "given"), sentence("accepted", "none")


class Alternative(NamedTuple):
    """The other end of the range of an input: the change to it, and its value as the table shows it."""

    change: SceneChange
    value: DisplayValue


@dataclass(frozen=True)
class FavourableInput:
    """An input that raises zeta, and that a clause asks about.

    code : of its sentence, and of the table of what is asked (core.case.asked.py)
    key : of the case; shown_by : evidence of its section, or the document of what it is about
    value : of it, as the table shows it
    ends : the other ends of its range
    words : from zeta of each end, and its check, the Sentence; by default that of the end with the lowest zeta
    source, permitted : as of an Assumption
    histories : the dynamic check knows of it; otherwise its words are of the linear check
    each_written : its words give zeta at each end, not at the lowest alone
    """

    code: str
    key: str
    shown_by: ShownBy
    value: DisplayValue
    ends: tuple[Alternative, ...]
    words: Callable[[list[float | None], Check], Sentence] | None = None
    source: str = GIVEN
    histories: bool = True
    permitted: bool = False
    each_written: bool = False

    @property
    def clause(self) -> str:
        """Clause that asks about it."""
        return ASKED[self.code].clause

    @property
    def reason(self) -> Sentence | str:
        """The document that shows its value, in words; "" without one."""
        given = self.shown_by
        shown = document_of(given, self.key) if isinstance(given, tuple) else given
        return shown.words if shown else ""

    @property
    def asks(self) -> Sentence | str:
        """The table its document stands in, and the kinds that show it; "" of what a clause permits."""
        row = ASKED[self.code]
        if not row.section:
            return ""
        every = kinds_that_show(row.section, row.shown_by)
        kinds = " | ".join([*every[:MOST_KINDS], *(["…"] if len(every) > MOST_KINDS else [])])
        if row.section == HOLD:
            return sentence("reason", "in_hold", kinds=kinds)
        return sentence("reason", "in_table", table=EVIDENCE_TABLES[row.section], key=self.key, kinds=kinds)

    def phrase(self, zetas: list[float | None], check: Check) -> Sentence:
        """Its sentence. zetas : at each end; check : they are of"""
        if self.words is not None:
            return self.words(zetas, check)
        k = min(range(len(zetas)), key=lambda k: zeta_for_sorting(zetas[k]))
        value = self.ends[k].value
        end = Number(value, ".2g") if isinstance(value, float) else value
        return sentence("reason", self.code, zeta=zeta_phrase(zetas[k]), end=end, check=check_phrase(check))


MOST_KINDS = 4
"""Kinds of documents that a sentence names; verdict.md and the error of another one name all."""


def zeta_for_sorting(zeta: float | None) -> float:
    """zeta for comparing: a number that is missing is the least."""
    return -math.inf if zeta is None else zeta


def wall_change(**values) -> SceneChange:
    return lambda scene: scene.replace_parts(wall=replace(scene.wall, **values))


def demand_change(**values) -> SceneChange:
    return lambda scene: scene.replace_parts(demand=replace(scene.demand, **values))


def zeta_phrase(zeta: float | None) -> Number | Sentence:
    """zeta at another end within a sentence; where there is none, that the wall may not stand there."""
    return sentence("added", "no_zeta") if zeta is None else apart(zeta, 1.0)


def check_phrase(check: Check) -> Sentence:
    """A check within a sentence."""
    return sentence("short", check.label, q=Number(check.q, "g"))


def single_alternative(
    key: str,
    code: str,
    shown_by: ShownBy,
    value: DisplayValue,
    end: Alternative,
    source=GIVEN,
    histories=True,
    permitted=False,
    **values,
) -> FavourableInput:
    """An input with one alternative value; its sentence reports zeta there."""

    def words(zetas, check):
        told = {"check": check_phrase(check)} if key in LOAD_AND_MASONRY_KEYS else {}
        return sentence("reason", code, zeta=zeta_phrase(zetas[0]), **told, **values)

    return FavourableInput(code, key, shown_by, value, (end,), words, source, histories, permitted)


LOAD_AND_MASONRY_KEYS = (
    *("elongation_m", "slack_mm", "prestress", "anchorage_kn", "unit_weight_kn_m3"),
    *("load", "inward", "variable", "h_m"),
)
"""Keys of what loads and masonry raise, told only where the other end is the lower one."""


def with_building(scene: CheckInput, **values) -> CheckInput:
    """The scene with these keys of its building."""
    return scene.replace_parts(building=replace(require_value(scene.building), **values))


def at_period(scene: CheckInput, period: float) -> CheckInput:
    """The building with this first period [s], all its modes in proportion."""
    building = require_value(scene.building)
    if not building.modes:
        return with_building(scene, period_s=period)
    factor = period / building.modes[0].period_s
    return with_building(scene, modes=tuple(replace(mode, period_s=factor * mode.period_s) for mode in building.modes))
