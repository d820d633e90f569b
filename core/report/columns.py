"""A StudyResult in columns: one row a wall, hinge and mechanism, with the numbers of the results JSON."""

import math
from collections.abc import Callable, Iterable, Sequence
from typing import Any, NamedTuple

from core.codes.kinematic import CHECKS
from core.study.results import Q_SOURCES, StudyResult, WallResult, WallVerdict
from core.text.sentence import Sentence
from core.units import G
from core.variation.limit_states import STATES


class Row(NamedTuple):
    """What a row is of.

    number : of the wall in the case, from 1
    verdict : of the wall, None without a demand; decides : whether it is of this result
    """

    wall: WallResult
    number: int
    verdict: WallVerdict | None
    decides: bool
    result: StudyResult


class Column(NamedTuple):
    """A column of the table.

    kind : text, whole, number or flag; "texts", "wholes" and "numbers" are lists
    unit : "" without one
    of : its value in a row, None where there is none
    """

    name: str
    kind: str
    unit: str
    of: Callable[[Row], Any]


def _of_wall(name: str, kind: str, unit: str, of: Callable[[WallResult], Any]) -> Column:
    return Column(name, kind, unit, lambda row: of(row.wall))


def _of_histories(name: str, kind: str, unit: str, of: Callable[[WallResult], Any]) -> Column:
    """A column of what a wall held at its top has not."""
    return Column(name, kind, unit, lambda row: None if row.wall.wall.bends else of(row.wall))


def _of_checks(name: str, kind: str, unit: str, of: Callable[[Any], Any], part: str = "") -> Column:
    """A column of the Assessment, or of a part of it, where it has one."""

    def value(row: Row) -> Any:
        found = row.wall.assessment
        if found is not None and part:
            found = getattr(found, part)
        return None if found is None else of(found)

    return Column(name, kind, unit, value)


def _zeta(name: str) -> Column:
    def value(found) -> float | None:
        return next((check.zeta for check in found.checks if check.name == name), None)

    return _of_checks(f"zeta_{name}", "number", "-", value)


def _zeta_at(state: str) -> Column:
    def value(found) -> float | None:
        return next((one.zeta for one in found.states if one.state == state), None)

    return _of_checks(f"zeta_{state.lower()}", "number", "-", value)


def _eq9(k: int, source: str) -> Column:
    def value(wall: WallResult) -> float | None:
        found = wall.code_check[k] if k < len(wall.code_check) else None
        return found.ratio if found else None

    return _of_wall(f"eq9_{source}", "number", "-", value)


def _in_g(value: float | None) -> float | None:
    return None if value is None else value / G


def _codes(sentences: Iterable[Sentence]) -> list[str]:
    return [one.code for one in sentences]


def _limits(row: Row) -> list[str] | None:
    if row.wall.assessment is None:
        return None
    extra = row.verdict.extra if row.verdict and row.decides else ()
    return _codes((*row.wall.assessed.verdict.limits, *extra))


def _of_the_wall(row: Row):
    """The Verdict of the wall, of its worst hinge."""
    return row.result.walls[row.verdict.governing].assessed.verdict if row.verdict else None


COLUMNS = (
    Column("wall", "whole", "", lambda row: row.number),
    _of_wall("name", "text", "", lambda wall: wall.name),
    _of_wall("variant", "text", "", lambda wall: wall.wall.variant),
    _of_wall("hinge_m", "number", "m", lambda wall: wall.part.hinge),
    _of_wall("mechanism", "text", "", lambda wall: wall.mechanism),
    Column("decides", "flag", "", lambda row: row.decides if row.verdict else None),
    Column("wall_verdict", "text", "", lambda row: _of_the_wall(row).code if row.verdict else None),
    Column("wall_zeta_least", "number", "-", lambda row: row.verdict.zeta_least if row.verdict else None),
    Column("wall_zeta_e", "number", "-", lambda row: _of_the_wall(row).zeta_e if row.verdict else None),
    _of_checks("verdict", "text", "", lambda found: found.code, "verdict"),
    _of_checks("check", "text", "", lambda found: found.governing, "verdict"),
    _of_checks("zeta_e", "number", "-", lambda found: found.zeta_e, "verdict"),
    _of_checks("zeta_target", "number", "-", lambda found: found.zeta_target, "verdict"),
    _of_checks("lower_bound_zeta", "number", "-", lambda found: found.lower_bound, "verdict"),
    *map(_zeta, CHECKS),
    _of_checks("zeta_16", "number", "-", lambda found: found.zeta_16, "dynamic"),
    _of_checks("zeta_first", "number", "-", lambda found: found.zeta_first, "dynamic"),
    *map(_zeta_at, STATES),
    *(_eq9(k, source) for k, source in enumerate(Q_SOURCES)),
    _of_checks("pga_c_g", "number", "g", lambda found: _in_g(found.pga), "risk"),
    _of_checks("return_period_c_years", "number", "years", lambda found: found.return_period, "risk"),
    _of_checks("is_v", "number", "-", lambda found: found.index, "risk"),
    _of_checks("tie_kn_m", "number", "kN/m", lambda found: None if found.force is None else 1e-3 * found.force, "tie"),
    _of_checks("alpha0", "number", "-", lambda found: found.alpha0, "kinematic"),
    _of_checks("e_star", "number", "-", lambda found: found.e_star, "kinematic"),
    _of_checks("a0_star_g", "number", "g", lambda found: found.a0 / G, "kinematic"),
    _of_checks("d0_m", "number", "m", lambda found: found.d0, "kinematic"),
    _of_checks("period_s", "number", "s", lambda found: found.period, "kinematic"),
    _of_wall("height_m", "number", "m", lambda wall: wall.height),
    _of_wall("thickness_m", "number", "m", lambda wall: wall.thickness),
    _of_wall("base_z_m", "number", "m", lambda wall: wall.wall.base_z_m),
    _of_wall("slenderness_deg", "number", "deg", lambda wall: math.degrees(wall.block.slenderness)),
    _of_histories("radius_m", "number", "m", lambda wall: wall.block.radius),
    _of_histories("frequency_parameter_rad_s", "number", "rad/s", lambda wall: wall.block.frequency_parameter),
    _of_wall("threshold_acceleration_g", "number", "g", lambda wall: wall.threshold / G),
    _of_histories("restitution", "text", "", lambda wall: wall.restitution.model),
    _of_histories("velocity_ratio", "number", "-", lambda wall: wall.restitution.ratio_at_rest),
    _of_wall("set_rule", "text", "", lambda wall: wall.set_rule),
    _of_wall("q_set", "number", "-", lambda wall: wall.q_set),
    _of_wall("q_min", "number", "-", lambda wall: wall.q_min),
    _of_wall("q_robust_set", "number", "-", lambda wall: wall.q_robust_set),
    _of_wall("q_slv_set", "number", "-", lambda wall: wall.q_slv_set),
    _of_wall("q_slv_low_set", "number", "-", lambda wall: wall.q_slv_low_set),
    _of_wall("q_05", "number", "-", lambda wall: wall.fragility.q_05 if wall.fragility else None),
    _of_wall("q_16", "number", "-", lambda wall: wall.fragility.q_16 if wall.fragility else None),
    _of_wall("q_50", "number", "-", lambda wall: wall.fragility.q_50 if wall.fragility else None),
    _of_wall("closed_form_q", "number", "-", lambda wall: wall.closed_form_q),
    _of_wall("closed_form_q_eff", "number", "-", lambda wall: wall.closed_form_q_eff),
    _of_wall("record_q", "numbers", "-", lambda wall: [entry.q for entry in wall.per_record]),
    _of_wall("record_q_robust", "numbers", "-", lambda wall: [entry.q_robust for entry in wall.per_record]),
    _of_wall("record_q_slv", "numbers", "-", lambda wall: [entry.q_slv for entry in wall.per_record]),
    _of_wall("record_polarity", "wholes", "", lambda wall: [entry.polarity for entry in wall.per_record]),
    _of_wall("runs_without_q", "whole", "", lambda wall: sum(run.ida.q is None for run in wall.runs)),
    _of_wall("analyses", "whole", "", lambda wall: sum(run.ida.analyses for run in wall.runs)),
    _of_wall("warnings", "texts", "", lambda wall: _codes(wall.warnings)),
    _of_checks("to_do", "texts", "", lambda found: _codes(found.to_do), "verdict"),
    Column("limits", "texts", "", _limits),
)


def columns_of(result: StudyResult, numbers: Sequence[int]) -> dict[str, list]:
    """The rows of a study by column. numbers : of its walls in the case, from 0. Raises ValueError for a number that is
    not finite."""
    verdicts = {one.results[0]: one for one in result.verdicts}
    by_wall = {k: one for one in result.verdicts for k in one.results}
    rows = [
        Row(wall, numbers[wall.part.origin] + 1, by_wall.get(k), k in verdicts, result)
        for k, wall in enumerate(result.walls)
    ]
    table = {column.name: [column.of(row) for row in rows] for column in COLUMNS}
    for column in COLUMNS:
        if column.kind == "number" and not all(value is None or math.isfinite(value) for value in table[column.name]):
            raise ValueError(column.name)
    return table
