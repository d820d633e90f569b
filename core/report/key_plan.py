"""The key plan of a building: where each wall stands, in the colour of its outcome."""

import math
from typing import NamedTuple

from core.answer.answer import answers_worst_first
from core.report.verdict_words import tone_of
from core.study.results import StudyResult, WallResult


class Placed(NamedTuple):
    """A wall in the plan.

    name : its own; result : number of the result that decides about it; ends : (x, y) of both [m]
    tone : as of `tone_of`; zeta : the least of its own, None where one is not known
    """

    name: str
    result: int
    wall: WallResult
    ends: tuple[tuple[float, float], tuple[float, float]]
    tone: str
    zeta: float | None

    @property
    def middle(self) -> tuple[float, float]:
        (x1, y1), (x2, y2) = self.ends
        return 0.5 * (x1 + x2), 0.5 * (y1 + y2)

    def beside(self, centre: tuple[float, float], distance: float) -> tuple[float, float]:
        """A place beside the middle of the wall, away from the centre of the plan [m]."""
        (x1, y1), (x2, y2) = self.ends
        x, y = self.middle
        along = math.hypot(x2 - x1, y2 - y1) or 1.0
        across = (y1 - y2) / along, (x2 - x1) / along
        away = math.copysign(distance, across[0] * (x - centre[0]) + across[1] * (y - centre[1]))
        return x + away * across[0], y + away * across[1]


def key_plan(result: StudyResult) -> list[Placed]:
    """The walls that have a place in the plan, the worst first; of those at one place, as variants are, the worst."""
    placed: dict[tuple, Placed] = {}
    for answer in answers_worst_first(result):
        wall, least = answer.decides, answer.least
        if (plan := answer.wall.plan) is None:
            continue
        ends = (plan.x1_m, plan.y1_m), (plan.x2_m, plan.y2_m)
        zeta, tone = least.zeta if least else None, tone_of(result, wall)
        made = Placed(answer.wall.name, answer.governing.result, wall, ends, tone, zeta)
        placed.setdefault(tuple(sorted(ends)), made)
    return list(placed.values())


def centre_of(placed: list[Placed]) -> tuple[float, float]:
    """The middle of the walls of a plan [m]."""
    points = [one.middle for one in placed]
    return sum(x for x, _ in points) / len(points), sum(y for _, y in points) / len(points)


def size_of(placed: list[Placed]) -> float:
    """The larger side of a plan [m]."""
    points = [point for one in placed for point in one.ends]
    return max(max(p[k] for p in points) - min(p[k] for p in points) for k in (0, 1)) or 1.0
