"""The register of the mechanisms of a wall beside their results."""

from typing import NamedTuple

from core.case.register import NOT_POSSIBLE, RegisterRow, other_rows, row_of_part, row_passed_over
from core.codes.outcomes import min_if_all_known
from core.study.results import StudyResult, WallResult, WallVerdict


class Looked(NamedTuple):
    """A row of the register of a wall. result : of what is looked at, None of another row"""

    row: RegisterRow
    result: WallResult | None = None


def make_register(result: StudyResult, verdict: WallVerdict) -> list[Looked]:
    """Every mechanism of a wall: those that are looked at, the worst first, what is left out or set aside, and what is
    not possible."""
    results = [result.walls[k] for k in verdict.results]
    origin = results[0].part.origin
    passed_over = [wall for wall in result.walls if wall.part.origin == origin and wall not in results]
    rows = [Looked(row_of_part(wall.part, wall.mechanism), wall) for wall in results]
    way, rest = max(wall.part.held for wall in results), []
    for wall in passed_over:
        same = (each for each in passed_over if each.part.held == wall.part.held)
        lowest = min_if_all_known(each.required_assessment.verdict.zeta_e for each in same)
        rest.append(row_passed_over(wall.part, wall.mechanism, lowest, way))
    names = {looked.row.name for looked in rows} | {row.name for row in rest}
    rest += other_rows([wall.part for wall in (*results, *passed_over)], names, result.case.building)
    return rows + [Looked(row) for row in sorted(rest, key=lambda row: row.status == NOT_POSSIBLE)]
