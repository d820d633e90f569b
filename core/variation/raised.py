"""An input that raises zeta, and the other ends of its range."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

from core.codes.assumption import GIVEN, Shown
from core.codes.kinematic import Check
from core.setting.scene import Scene
from core.text.sentence import Number, Sentence, sentence
from core.variation.evaluate import Evaluation

Ends = list[Evaluation | None]
"""The wall at the other ends of the range of an input; None where it does not stand there."""


Change = Callable[[Scene], Scene]


GIVEN_WORD, NONE_WORD = sentence("accepted", "given"), sentence("accepted", "none")


class End(NamedTuple):
    """The other end of the range of an input: the change to it, and its value as the table shows it."""

    change: Change
    value: Shown


@dataclass(frozen=True)
class Raised:
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
    value: Shown
    ends: tuple[End, ...]
    words: Callable[[list[float | None], Check], Sentence]
    source: str = GIVEN
    histories: bool = True
    permitted: bool = False

    @property
    def reason(self) -> str:
        """Reason the engineer gives, "" without one."""
        return str(getattr(self.reasons, self.key, "") or "") if self.reasons else ""


def worth(zeta: float | None) -> float:
    """zeta for comparing: a number that is missing is the least."""
    return -math.inf if zeta is None else zeta


def of_wall(**values) -> Change:
    return lambda scene: scene.but(wall=replace(scene.wall, **values))


def of_demand(**values) -> Change:
    return lambda scene: scene.but(demand=replace(scene.demand, **values))


def worst_words(code: str, ends: tuple[End, ...]) -> Callable[[list[float | None], Check], Sentence]:
    """The words of an input by the other end with the lowest zeta."""

    def words(zetas: list[float | None], check: Check) -> Sentence:
        k = min(range(len(zetas)), key=lambda k: worth(zetas[k]))
        value = ends[k].value
        end = Number(value, ".2g") if isinstance(value, float) else value
        return sentence("reason", code, zeta=zeta_said(zetas[k]), end=end, check=named(check))

    return words


def zeta_said(zeta: float | None) -> Number | Sentence:
    """zeta at another end within a sentence; where there is none, that the wall may not stand there."""
    return sentence("added", "no_zeta") if zeta is None else Number(zeta)


def named(check: Check) -> Sentence:
    """A check within a sentence."""
    return sentence("short", check.label, q=Number(check.q, "g"))


def one_end(
    key: str, code: str, reasons, value: Shown, end: End, source=GIVEN, histories=True, permitted=False, **values
) -> Raised:
    """An input with one alternative value; its sentence reports zeta there."""

    def words(zetas, check):
        told = {"check": named(check)} if key in OF_LOADS else {}
        return sentence("reason", code, zeta=zeta_said(zetas[0]), **told, **values)

    return Raised(key, reasons, value, (end,), words, source, histories, permitted)


OF_LOADS = ("elongation_m", "slack_mm", "prestress", "anchorage_kn", "load", "h_m", "unit_weight_kn_m3", "masonry")
"""Keys of what loads and masonry raise, told only where the other end is the lower one."""
