"""Table of what lifts zeta, each row with zeta at the other end of its range."""

from collections.abc import Callable, Iterable
from dataclasses import replace
from functools import reduce
from typing import NamedTuple

from core.codes.assumption import ALL_TOGETHER_KEY, DEFAULT, Assumption
from core.codes.kinematic import Check
from core.codes.multiplier_search import Precision
from core.codes.outcomes import PASSES
from core.codes.verdict import find_outcome
from core.errors import InputError
from core.known import require_value
from core.text.sentence import Key, Number, sentence
from core.variation.evaluate import DECISION, FULL_PRECISION, Evaluation, evaluate, up_to
from core.variation.favourable_input import (
    LOAD_AND_MASONRY_KEYS,
    Alternative,
    AlternativeEvaluations,
    FavourableInput,
    SceneChange,
    zeta_for_sorting,
)
from core.variation.favourable_wall_inputs import favourable_inputs


def _there(end: Evaluation, check: Check) -> Check | None:
    """A check at another end; where records are there by default, in the place of histories and displacement check the
    one of them that decides there."""
    if end.scene.by_default and check.name in ("dynamic", "nonlinear"):
        return end.decides
    return end.made(check.name)


def _zeta(end: Evaluation | None, check: Check) -> float | None:
    """zeta of a check at another end."""
    check_there = _there(end, check) if end else None
    return check_there.zeta if check_there else None


def _turns(end: Evaluation | None, check: Check) -> bool:
    """Whether a check fails, is at its limit or has no number at another end."""
    return end is None or end.judgement(_there(end, check)) != PASSES


def evaluate_assumptions(
    evaluation: Evaluation, cancelled: Callable[[], bool] = lambda: False
) -> tuple[Assumption, ...]:
    """The inputs of a wall that raise zeta and that a clause asks about, each with zeta and the outcome at the other
    end of its range, and all of them together; where no one of them turns the outcome, all together without a reason
    may.

    evaluation : the wall as it is, some check of which has a zeta; of one that fails, only what makes the check with
        q = 2 fail too, without histories
    Raises Cancelled.
    """
    looked: list[LookedAt] = []
    for one in favourable_inputs(evaluation):
        if (found := look_at(evaluation, one, evaluation.satisfied, cancelled, DECISION)) is not None:
            looked.append(found)

    def known(found: LookedAt) -> LookedAt:
        """With the numbers of searches to their end."""
        whole = None if found.known else look_at(evaluation, found.one, evaluation.satisfied, cancelled)
        return whole or found

    if not evaluation.satisfied:
        return tuple(known(found).row for found in looked if found.row.turns_q)
    if _may_turn_together([found.row for found in looked if found.row.open]):
        # of several ends the one with the lowest zeta is taken with the others
        looked = [known(found) if found.row.open and len(found.one.ends) > 1 else found for found in looked]
    rows = _together(
        [found.row for found in looked],
        [(found.row, found.end.change) for found in looked if found.row.raises],
        evaluation,
        cancelled,
    )
    for k, found in enumerate(looked):
        if rows[k].turns:  # alone, or with others: by the check that decides
            rows[k] = replace(known(found).of_outcome, turns=True, turns_q=rows[k].turns_q)
        elif rows[k].turns_q:
            rows[k] = replace(known(found).row, turns_q=True)
    return tuple(rows)


def _may_turn_together(unshown: list[Assumption]) -> bool:
    """Whether rows that nobody shows may turn together what none of them turns alone."""
    return len(unshown) > 1 and not any(row.turns for row in unshown)


class LookedAt(NamedTuple):
    """An input whose other ends were looked at.

    one : the input; row : of the table, of an input that turns the check with q alone with the numbers of that check
    end : with the lowest zeta of the check that decides; of_outcome : its row by that check
    known : the numbers of that row are those of searches to their end
    """

    one: FavourableInput
    row: Assumption
    end: Alternative
    of_outcome: Assumption
    known: bool


def look_at(
    evaluation: Evaluation,
    one: FavourableInput,
    passes: bool,
    cancelled: Callable[[], bool] = lambda: False,
    precision: Precision = FULL_PRECISION,
) -> LookedAt | None:
    """An input at its other ends, None where it moves no check that counts.

    passes : the check that decides may turn; else the one with q of the code alone, without histories
    precision : of histories; whether the row turns something, and raises zeta, does not hang on it
    Raises Cancelled.
    """
    decides, q_check = require_value(evaluation.decides), evaluation.made("linear_q_code")
    touched = passes and (decides.name != "dynamic" or one.histories)
    judged = [check for check in (decides if touched else None, q_check) if check is not None]
    if not judged:
        return None
    ends = _evaluate_ends(evaluation, one, touched, cancelled, precision)
    lowered = _lowered_by_clauses(ends, evaluation)
    turned = touched and any(_turns(end, decides) for end in ends)  # a check that fails as it is turns nothing
    if not turned and not lowered:
        ends = [
            _evaluate_at(evaluation, one.ends[k].change, touched, cancelled) if _is_bound(end, decides) else end
            for k, end in enumerate(ends)
        ]
    turns = {check.name for check in judged if any(_turns(end, check) for end in ends)}
    of_outcome = _told(one, judged, ends, evaluation) if passes else q_check
    if of_outcome is None:
        return None

    def describe(shown: Check) -> Assumption:
        lowest = _lowest(ends, shown)
        row = _row(one, shown, ends, lowest, _outcome(ends[lowest], evaluation, touched))
        return replace(
            row,
            turns=bool(decides.passed) and touched and decides.name in turns,
            turns_q=bool(q_check and q_check.passed) and "linear_q_code" in turns,
            check="" if shown.name == decides.name else shown.name,
            raises=(touched and lowered) or row.raises,
        )

    row, lowest = describe(of_outcome), _lowest(ends, of_outcome)
    shown = describe(q_check) if q_check and row.turns_q and not row.turns else row
    known = of_outcome.name != decides.name or _is_known(one, ends, lowest, decides)
    return LookedAt(one, shown, one.ends[lowest], row, known)


def _is_known(favourable: FavourableInput, ends: AlternativeEvaluations, lowest: int, decides: Check) -> bool:
    """Whether zeta at each end that is written is that of a search to its end. decides : as the wall is"""
    written = ends if favourable.each_written else [ends[lowest]]
    return not any(_is_bound(end, decides) for end in written)


def _is_bound(end: Evaluation | None, check: Check) -> bool:
    """Whether zeta of a check at another end is at least what it says: histories were asked for no more, whichever
    check decides there."""
    check_there = _there(end, check) if end else None
    by_histories = check_there is not None and check_there.name == "dynamic"
    return by_histories and end is not None and end.dynamic is not None and end.dynamic.beyond


def _row(
    favourable: FavourableInput, shown: Check, ends: AlternativeEvaluations, lowest: int, outcome: str
) -> Assumption:
    """The row of an input with the numbers of a check. lowest : number of the end it shows; outcome : there"""
    zetas = [_zeta(end, shown) for end in ends]
    return Assumption(
        favourable.key,
        favourable.phrase(zetas, shown),
        favourable.value,
        favourable.ends[lowest].value,
        favourable.source,
        zetas[lowest],
        outcome,
        reason=favourable.reason,
        permitted=favourable.permitted,
        raises=zeta_for_sorting(zetas[lowest]) < zeta_for_sorting(shown.zeta),
        asks=favourable.asks,
    )


def _lowest(ends: AlternativeEvaluations, check: Check) -> int:
    """Number of the end with the lowest zeta of a check, of several that of the displacement check."""
    return min(range(len(ends)), key=lambda k: (zeta_for_sorting(_zeta(ends[k], check)), _by_clause(ends[k])))


def _evaluate_ends(
    evaluation: Evaluation,
    moved: FavourableInput,
    by_histories: bool,
    cancelled: Callable[[], bool],
    precision: Precision,
) -> AlternativeEvaluations:
    """The wall at each end of an input, the worst by the clauses first: once the check that decides fails at one, of
    the others only a lower zeta counts, unless each is written."""
    decides, target = require_value(evaluation.decides), evaluation.scene.demand.zeta_target
    by_clauses = [0.0]
    if len(moved.ends) > 1:
        by_clauses = [_by_clause(_evaluate_at(evaluation, end.change, False, cancelled)) for end in moved.ends]
    ends: AlternativeEvaluations = [None] * len(moved.ends)
    lowest = None
    for k in sorted(range(len(ends)), key=lambda k: by_clauses[k]):
        looked = precision if moved.each_written else up_to(lowest, precision, target)
        ends[k] = end = _evaluate_at(evaluation, moved.ends[k].change, by_histories, cancelled, looked)
        zeta = _zeta(end, decides)
        if by_histories and zeta is not None and _turns(end, decides) and (lowest is None or zeta < lowest):
            lowest = zeta
    return ends


def _lowered_by_clauses(ends: AlternativeEvaluations, evaluation: Evaluation) -> bool:
    """Whether the displacement check is lower at an end, so that an input raises zeta whatever the histories say; of
    what moves histories alone these have to say it."""
    return min(map(_by_clause, ends)) < _by_clause(evaluation)


def _by_clause(end: Evaluation | None) -> float:
    """zeta of the displacement check at an end, for comparing."""
    check = end.made("nonlinear") if end else None
    return zeta_for_sorting(check.zeta if check else None)


def _evaluate_at(
    evaluation: Evaluation,
    change: SceneChange,
    by_histories: bool,
    cancelled: Callable[[], bool],
    precision: Precision = FULL_PRECISION,
) -> Evaluation | None:
    """The wall with a change, None where it does not stand without what lifts it."""
    decisive = by_histories and not evaluation.scene.beside
    there = evaluation.scene if decisive else evaluation.scene.without_records()
    try:
        return evaluate(change(there), precision, other=False, cancelled=cancelled)
    except InputError:
        return None


def _all_of(changes: Iterable[SceneChange]) -> SceneChange:
    """Several changes, one after the other."""
    return lambda scene: reduce(lambda changed, change: change(changed), tuple(changes), scene)


def evaluate_at_alternatives(
    evaluation: Evaluation, rows: Iterable[Assumption], cancelled: Callable[[], bool] = lambda: False
) -> Evaluation | None:
    """The wall with the inputs of these rows of its table at the other ends that they show; None where it does not
    stand there.

    rows : that have a switch
    Raises Cancelled.
    """
    shown = {row.key: row.other_end for row in rows}
    ends = [
        end
        for one in favourable_inputs(evaluation)
        if one.key in shown
        for end in one.ends
        if end.value == shown[one.key]
    ]
    changes = [end.change for end in ends]
    try:
        return evaluate(_all_of(changes)(evaluation.scene), other=False, cancelled=cancelled)
    except InputError:
        return None


def _outcome(end: Evaluation | None, evaluation: Evaluation, touched: bool) -> str:
    """Code of the outcome at another end; of an input that moves the check with q alone, with this check as it is
    there. A wall that does not stand there fails."""
    if end is None:
        return "not_verified"
    if touched:
        return end.outcome
    checks = tuple(
        (end.made(check.name) or check) if check.name == "linear_q_code" else check for check in evaluation.checks
    )
    return find_outcome(evaluation.evidence._replace(checks=checks))


def _told(
    one: FavourableInput, judged: list[Check], ends: AlternativeEvaluations, evaluation: Evaluation
) -> Check | None:
    """The check whose zeta the words of a raised input give, None where it raises none: of what concerns the linear
    check alone that one, of loads the first that they raise.

    judged : the checks the input moves; ends : at its other ends
    """
    if one.key in LOAD_AND_MASONRY_KEYS:
        lowest = ((check, min(zeta_for_sorting(_zeta(end, check)) for end in ends)) for check in judged)
        return next((check for check, zeta in lowest if zeta < zeta_for_sorting(check.zeta)), None)
    return evaluation.decides if one.histories else evaluation.made("linear_q_code")


def _together(
    rows: list[Assumption],
    worst: list[tuple[Assumption, SceneChange]],
    evaluation: Evaluation,
    cancelled: Callable[[], bool],
) -> list[Assumption]:
    """The rows; where none that nobody shows turns the outcome alone, and all of these do together, each of them does,
    and the last row is of all of them.

    worst : (row, change to the end with the lowest zeta) of each
    """
    decides, q_check = require_value(evaluation.decides), evaluation.made("linear_q_code")
    unshown = [pair for pair in worst if pair[0].open]
    keys = tuple(dict.fromkeys(row.key for row, _ in unshown))
    if not _may_turn_together([row for row, _ in unshown]):
        return rows
    by_q = bool(q_check and q_check.passed) and not any(row.turns_q for row, _ in unshown)
    together = _all_of(change for _, change in unshown)
    end = _evaluate_at(evaluation, together, True, cancelled, DECISION)  # beyond what is enough it turns nothing
    joint = _turns(end, decides)
    joint_q = by_q and q_check is not None and _turns(end, q_check)
    rows = [
        replace(row, turns=row.turns or joint, turns_q=row.turns_q or joint_q) if row.key in keys else row
        for row in rows
    ]
    if joint:
        zeta = _zeta(end, decides)
        words = sentence("reason", "lifts_together", keys=tuple(map(Key, keys)), zeta=Number(zeta))
        outcome = _outcome(end, evaluation, True)
        rows.append(Assumption(ALL_TOGETHER_KEY, words, "", "", DEFAULT, zeta, outcome, True))
    return rows
