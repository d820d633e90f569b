"""An input that raises zeta, and the other ends of its range."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

from core.codes.assumption import GIVEN, DisplayValue
from core.codes.kinematic import Check
from core.setting.check_input import CheckInput
from core.text.sentence import Number, Sentence, sentence
from core.variation.evaluate import Evaluation

AlternativeEvaluations = list[Evaluation | None]
"""The wall at the other ends of the range of an input; None where it does not stand there."""


SceneChange = Callable[[CheckInput], CheckInput]


GIVEN_WORD, NONE_WORD = sentence("accepted", "given"), sentence("accepted", "none")


class Alternative(NamedTuple):
    """The other end of the range of an input: the change to it, and its value as the table shows it."""

    change: SceneChange
    value: DisplayValue


@dataclass(frozen=True)
class FavourableInput:
    """An input that raises zeta.

    key : of the case and of the reasons; reasons : sections of them, or None
    value : of it, as the table shows it
    ends : the other ends of its range
    words : from zeta of each end, and its check, the Sentence
    source, permitted : as of an Assumption
    histories : the dynamic check knows of it; otherwise its words are of the linear check
    """

    key: str
    reasons: object
    value: DisplayValue
    ends: tuple[Alternative, ...]
    words: Callable[[list[float | None], Check], Sentence]
    source: str = GIVEN
    histories: bool = True
    permitted: bool = False

    @property
    def reason(self) -> str:
        """Reason the engineer gives, "" without one."""
        return str(getattr(self.reasons, self.key, "") or "") if self.reasons else ""


def zeta_for_sorting(zeta: float | None) -> float:
    """zeta for comparing: a number that is missing is the least."""
    return -math.inf if zeta is None else zeta


def wall_change(**values) -> SceneChange:
    return lambda scene: scene.replace_parts(wall=replace(scene.wall, **values))


def demand_change(**values) -> SceneChange:
    return lambda scene: scene.replace_parts(demand=replace(scene.demand, **values))


def lowest_zeta_sentence(code: str, ends: tuple[Alternative, ...]) -> Callable[[list[float | None], Check], Sentence]:
    """The words of an input by the other end with the lowest zeta."""

    def words(zetas: list[float | None], check: Check) -> Sentence:
        k = min(range(len(zetas)), key=lambda k: zeta_for_sorting(zetas[k]))
        value = ends[k].value
        end = Number(value, ".2g") if isinstance(value, float) else value
        return sentence("reason", code, zeta=zeta_phrase(zetas[k]), end=end, check=check_phrase(check))

    return words


def zeta_phrase(zeta: float | None) -> Number | Sentence:
    """zeta at another end within a sentence; where there is none, that the wall may not stand there."""
    return sentence("added", "no_zeta") if zeta is None else Number(zeta)


def check_phrase(check: Check) -> Sentence:
    """A check within a sentence."""
    return sentence("short", check.label, q=Number(check.q, "g"))


def single_alternative(
    key: str,
    code: str,
    reasons,
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

    return FavourableInput(key, reasons, value, (end,), words, source, histories, permitted)


LOAD_AND_MASONRY_KEYS = (
    "elongation_m",
    "slack_mm",
    "prestress",
    "anchorage_kn",
    "load",
    "h_m",
    "unit_weight_kn_m3",
    "masonry",
)
"""Keys of what loads and masonry raise, told only where the other end is the lower one."""
