"""A StudyResult in columns: one row a wall, hinge and mechanism, of the quantities of the results JSON."""

import math
from collections.abc import Callable, Iterable, Sequence
from typing import Any, NamedTuple

from core.codes.kinematic import CHECKS
from core.known import require_value
from core.report.stated.checks import AT_DEMAND, KINEMATIC, RISK
from core.report.stated.quantity import (
    Quantity,
    flag,
    number,
    numbers,
    rebase_group,
    select_quantities,
    text,
    texts,
    whole,
)
from core.report.stated.walls import FRAGILITY, PER_RECORD, WALL, WallResultSource
from core.study.results import Q_SOURCES, StudyResult, WallResult, WallVerdict
from core.text.sentence import Sentence
from core.variation.limit_states import LIMIT_STATES


class Row(NamedTuple):
    """Result, wall and verdict that a row is made of.

    number : of the wall in the case, from 1
    verdict : of the wall, None without a demand; decides : whether it is of this result
    result : None while the study runs
    """

    wall: WallResult
    number: int
    verdict: WallVerdict | None
    decides: bool
    result: StudyResult | None


def _taken(group: Sequence[Quantity], source: Callable[[Row], Any], *keys: str) -> list[Quantity]:
    """Quantities of a group by their keys, read from a row; none where the row has no such source."""
    return rebase_group(source, select_quantities(group, *keys))


def _result(row: Row) -> WallResultSource:
    return WallResultSource(row.wall, row.result)


def _verdict(row: Row) -> Any:
    """Verdict about this hinge."""
    return row.wall.assessment and row.wall.assessment.verdict


def _kinematic(row: Row) -> Any:
    """Assessment of a wall with closed forms, None of any other."""
    assessment = row.wall.assessment
    return assessment if assessment is not None and assessment.kinematic is not None else None


def _risk(row: Row) -> Any:
    assessment = row.wall.assessment
    return assessment if assessment is not None and assessment.risk is not None else None


def _dynamic(row: Row) -> Any:
    """Dynamic check by the histories at the demand, None without them."""
    return row.wall.assessment and row.wall.assessment.dynamic


def _of_records(one: Quantity) -> Quantity:
    """A quantity of each record as a list."""
    return numbers(f"record_{one.key}", "-", one.meaning, lambda row: [one.of(entry) for entry in row.wall.per_record])


def _of_the_wall(row: Row) -> Any:
    """Verdict of the wall, that of its worst hinge; None without a demand."""
    return require_value(row.result).walls[row.verdict.governing].required_assessment.verdict if row.verdict else None


def _zeta(name: str) -> Quantity:
    def value(row: Row) -> float | None:
        checks = row.wall.assessment.checks if row.wall.assessment else ()
        return next((check.zeta for check in checks if check.name == name), None)

    return number(f"zeta_{name}", "-", f"zeta_E of the check {name}", value)


def _zeta_at(state: str) -> Quantity:
    def value(row: Row) -> float | None:
        states = row.wall.assessment.states if row.wall.assessment else ()
        return next((one.zeta for one in states if one.state == state), None)

    return number(f"zeta_{state.lower()}", "-", f"zeta_E at {state}", value)


def _eq9(k: int, source: str) -> Quantity:
    def value(row: Row) -> float | None:
        check = row.wall.code_check[k] if k < len(row.wall.code_check) else None
        return check.ratio if check else None

    return number(f"eq9_{source}", "-", f"capacity over demand of Eq. 9 by {source}", value)


def _codes(sentences: Iterable[Sentence]) -> list[str]:
    return [sentence.code for sentence in sentences]


def _limits(row: Row) -> list[str] | None:
    if row.wall.assessment is None:
        return None
    extra = row.verdict.extra if row.verdict and row.decides else ()
    return _codes((*row.wall.required_assessment.verdict.limits, *extra))


def _of(source: Callable[[Row], Any], name: str) -> Callable[[Row], Any]:
    """An attribute of a source, None where there is none."""
    return lambda row: None if (owner := source(row)) is None else getattr(owner, name)


def _tie(row: Row) -> float | None:
    if row.verdict is None or row.verdict.wall.sought is None:
        return None
    return next((measure.size for measure in row.verdict.measures or () if measure.is_single_tie), None)


SIZE_KEYS = ("slenderness_deg", "radius_m", "frequency_parameter_rad_s", "threshold_acceleration_g")
Q_SLV = ("q_slv_set", "q_slv_low_set", "q_slv_robust_set", "q_slv_safe_set")
SETS = ("set_rule", "q_set", "q_min", "q_robust_set", *Q_SLV)

COLUMNS = (
    whole("wall", "number of the wall in the case, from 1", "number"),
    text("name", "name", "wall.name"),
    text("variant", "stato di fatto or progetto", "wall.wall.variant"),
    number("hinge_m", "m", "height of the hinge above the base", "wall.part.hinge"),
    text("mechanism", "mechanism", "wall.mechanism"),
    flag(
        "decides", "whether the verdict of the wall is of this hinge", lambda row: row.decides if row.verdict else None
    ),
    text("wall_verdict", "outcome of the wall", _of(_of_the_wall, "code")),
    number("wall_zeta_least", "-", "lowest zeta_E of the wall", lambda row: row.verdict and row.verdict.zeta_least),
    number("wall_zeta_e", "-", "zeta_E of the wall", _of(_of_the_wall, "zeta_e")),
    text("verdict", "outcome about this hinge", _of(_verdict, "code")),
    text("check", "check that decides", _of(_verdict, "governing")),
    number("zeta_e", "-", "zeta_E", _of(_verdict, "zeta_e")),
    number("zeta_target", "-", "zeta_E required", _of(_verdict, "zeta_target")),
    number("lower_bound_zeta", "-", "zeta_E where what holds the wall fails", _of(_verdict, "lower_bound")),
    *map(_zeta, CHECKS),
    *_taken(AT_DEMAND, _dynamic, "zeta_16", "zeta_first"),
    *map(_zeta_at, LIMIT_STATES),
    *(_eq9(k, source) for k, source in enumerate(Q_SOURCES)),
    *_taken(RISK, _risk, "pga_c_g", "return_period_c_years", "is_v"),
    number("tie_kn_m", "kN/m", "force of the tie asked for", _tie),
    *_taken(KINEMATIC, _kinematic, "alpha0", "e_star", "a0_star_g", "d0_m", "period_s"),
    *_taken(WALL, _result, "height_m", "thickness_m"),
    number("base_z_m", "m", "height of its base above the ground", "wall.wall.base_z_m"),
    *_taken(WALL, _result, *SIZE_KEYS, "restitution", "velocity_ratio", *SETS),
    *_taken(FRAGILITY, lambda row: row.wall.fragility, "q_05", "q_16", "q_50"),
    number("closed_form_q", "-", "q of Eq. 15 or 16", "wall.closed_form_q"),
    number("closed_form_q_eff", "-", "Eq. 15 or 16", "wall.closed_form_q_eff"),
    *(_of_records(one) for one in PER_RECORD if one.key in ("q", "q_robust", "q_slv")),
    Quantity(
        "record_polarity",
        "wholes",
        "sign of each record that governs",
        lambda row: [entry.polarity for entry in row.wall.per_record],
    ),
    whole("runs_without_q", "runs without a q", lambda row: sum(run.ida.q is None for run in row.wall.runs)),
    whole("analyses", "integrations made", lambda row: sum(run.ida.analyses for run in row.wall.runs)),
    texts("warnings", "keys of the remarks on the run", lambda row: _codes(row.wall.warnings)),
    texts("to_do", "keys of what the engineer has to do", lambda row: _verdict(row) and _codes(_verdict(row).to_do)),
    texts("limits", "keys of what the number is to be read with", _limits),
)
"""Columns of the table, each a quantity of a Row."""

BY_KEY = {column.key: column for column in COLUMNS}


def columns_of(result: StudyResult, numbers: Sequence[int]) -> dict[str, list]:
    """The rows of a study by column. numbers : of its walls in the case, from 0. Raises ValueError for a number that is
    not finite."""
    verdicts = {verdict.results[0]: verdict for verdict in result.verdicts}
    by_wall = {k: verdict for verdict in result.verdicts for k in verdict.results}
    rows = [
        Row(wall, numbers[wall.part.origin] + 1, by_wall.get(k), k in verdicts, result)
        for k, wall in enumerate(result.walls)
    ]
    table = {column.key: [column.of(row) for row in rows] for column in COLUMNS}
    for column in COLUMNS:
        if column.kind == "number" and not all(value is None or math.isfinite(value) for value in table[column.key]):
            raise ValueError(column.key)
    return table
