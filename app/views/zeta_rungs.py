"""The checks of a wall as rungs of a ladder."""

from collections.abc import Mapping

from app.look.language import current_language, number, tr
from app.views.ladder import Rung
from core.codes.dynamic_check import DynamicCheck
from core.codes.kinematic import Check
from core.codes.multiplier_search import Precision
from core.text.sentence import Number, sentence
from core.variation.evaluate import FULL_PRECISION
from core.variation.wall_evaluation import WallEvaluation


def check_words(label: str, q: float | None) -> str:
    """Name of a check. q : of the linear check"""
    return sentence("short", label, q=Number(q, "g")).text(current_language())


def digits(value: float | None, figures: int = 2) -> str:
    """A number with so many decimals."""
    return number(value, f".{figures}f")


def rung_of(check: Check, decides: bool, dynamic: DynamicCheck | None) -> Rung:
    """A check that was made: its clause, and capacity over demand or how many runs overturn. dynamic : by histories"""
    values = ""
    if check.name == "dynamic" and dynamic and dynamic.n_exceeded:
        count = tr("{n} of {m} overturn", n=dynamic.n_exceeded, m=len(dynamic.runs))
        values = f"{digits(check.capacity, 3)} / {count}"
    elif check.capacity is not None and check.demand is not None:
        unit = check.unit.replace("-", "")
        values = f"{digits(check.capacity, 3)} / {digits(check.demand, 3)} {unit}".strip()
    tone = "quiet" if check.passed is None else "good" if check.passed else "bad"
    return Rung(check_words(check.label, check.q), check.clause, check.zeta, values, tone, decides)


def rungs_of(
    whole: WallEvaluation,
    q_code: float,
    precision: Precision | None,
    given: Mapping[str, float | None],
    moved: bool,
    awaited: bool,
) -> list[Rung]:
    """The checks of a wall that is not run, the one that decides first.

    q_code : q of the linear check
    precision : of the histories, None while none are made; those of a run follow
    given : label -> zeta of the wall as it is, empty where that is not known
    moved : the wall is another one than the wall as it is
    awaited : histories decide, also while they are not made
    """
    rungs, labels = [], list(given) or list(whole.by_check)
    if precision is None and awaited and "dynamic" not in labels:
        labels.insert(0, "dynamic")
    for k, label in enumerate(labels):
        zeta, as_it_is = whole.by_check.get(label), given.get(label)
        said = "" if precision == FULL_PRECISION or label != "dynamic" else "…" if precision is None else tr("about")
        values = tr("as it is {zeta}", zeta=number(as_it_is, ".2f")) if as_it_is is not None and moved else said
        rungs.append(Rung(check_words(label, q_code), said, zeta, values, _tone(whole, label, precision), k == 0))
    return rungs


def _tone(whole: WallEvaluation, label: str, precision: Precision | None) -> str:
    """Green where a check is surely satisfied; a glance of the histories says no outcome."""
    if whole.by_check.get(label) is None or (label == "dynamic" and precision is not FULL_PRECISION):
        return "amber"
    return {True: "good", False: "bad", None: "amber"}[whole.satisfied.get(label)]
