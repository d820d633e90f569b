"""A wall of a case evaluated about all its hinges, without the search of q: as it is, or with another input."""

import functools
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

from core.capacity.limit_states import LIMIT_FRACTION
from core.case.floor_loads import isolate_wall
from core.case.hinges import best_way
from core.case.rules import replace_walls
from core.case.schema import Case
from core.case.site import FULL_FACTOR
from core.case.wall import Wall
from core.codes.demand import SeismicDemand
from core.codes.dynamic_check import run_dynamic_check
from core.codes.multiplier_search import Precision
from core.codes.outcomes import FAILS, OPEN, OUTCOMES, PASSES, min_if_all_known, way_key
from core.setting.check_input import rescale_records
from core.setting.plan import FloorCache, Inputs, make_plan
from core.variation.evaluate import AT_LIMIT, FULL_PRECISION, Evaluation, evaluate


@dataclass(frozen=True)
class WallEvaluation:
    """A wall evaluated about each of its hinges, by each of its mechanisms; none of a wall that does not stand.

    The linear check with the wall's own q is not made: it asks for a search.
    """

    hinges: tuple[Evaluation, ...]

    @cached_property
    def by_check(self) -> dict[str, float | None]:
        """Label of a check -> the lowest zeta, None where one is not known; in the order of the first hinge."""
        return {
            label: min_if_all_known(check.zeta for _, check in hinge_checks)
            for label, hinge_checks in self._by_label.items()
        }

    @cached_property
    def satisfied(self) -> dict[str, bool | None]:
        """Label -> whether the check is satisfied about every hinge; None where that is open or at its limit."""
        outcomes = {}
        for label, hinges in self._by_label.items():
            said = {hinge.judgement(check) for hinge, check in hinges}
            outcomes[label] = False if FAILS in said else None if said & {AT_LIMIT, OPEN} else True
        return outcomes

    @property
    def _by_label(self) -> dict[str, list]:
        by_label: dict[str, list] = {}
        for hinge in self.hinges:
            for check in hinge.checks:
                by_label.setdefault(check.label, []).append((hinge, check))
        return by_label

    @property
    def zeta(self) -> float | None:
        """The lowest of the checks that decide."""
        return min_if_all_known(hinge.zeta for hinge in self.hinges)

    @property
    def beyond(self) -> bool:
        """Whether zeta is at least this: more of the histories was not asked for."""
        return any(hinge.beyond for hinge in self.hinges if hinge.zeta == self.zeta)

    @property
    def sure(self) -> bool:
        """Whether the check that decides about each hinge is satisfied, its spread included."""
        return bool(self.hinges) and all(hinge.satisfied for hinge in self.hinges)


NO_EVALUATION = WallEvaluation(())
"""A wall that does not stand."""


@dataclass(frozen=True)
class WallContext:
    """Setting that stays the same while inputs of a wall move.

    case : with that wall alone; inputs : of `read_inputs`
    histories : `run_dynamic_check`, or one that keeps its results
    """

    case: Case
    base_dir: Path
    inputs: Inputs
    histories: Callable = run_dynamic_check

    @property
    def demand(self) -> SeismicDemand:
        """Demand of the case, which must have one."""
        demand = self.inputs[0]
        assert demand is not None
        return demand

    @property
    def has_histories(self) -> bool:
        """Whether time histories decide."""
        return bool(self.inputs[1]) and self.demand.limit_state in LIMIT_FRACTION


def make_wall_context(
    case: Case, k: int, base_dir: Path, inputs: Inputs, histories: Callable = run_dynamic_check
) -> WallContext:
    """Setting of the k-th wall of a case with a demand; no tie is sought."""
    case = isolate_wall(case, k)
    wall = case.wall[0].without_sought()
    # whether an FC below 1.35 is founded was judged; a strength that is moved is no tested one
    demand = replace(case.demand, confidence_factor=FULL_FACTOR) if case.demand else None
    analysis = replace(case.analysis, accuracy=False)
    alone = replace(case, wall=(wall,), demand=demand, sensitivity=None, analysis=analysis)
    return WallContext(alone, base_dir, inputs, histories)


def replace_wall(setting: WallContext, wall: Wall) -> WallContext:
    """The setting with another wall. Raises InputError where it breaks a rule, or does not stand."""
    return replace(setting, case=replace_walls(setting.case, [wall]))


def replace_demand(setting: WallContext, demand: SeismicDemand) -> WallContext:
    """The setting with another demand; records that are used as given follow its a_g S."""
    _, motions, kinds = setting.inputs
    return replace(setting, inputs=(demand, [*rescale_records(motions, setting.demand, demand)], kinds))


def drop_record(setting: WallContext, k: int) -> WallContext:
    """The setting without its k-th record."""
    demand, motions, kinds = setting.inputs
    return replace(setting, inputs=(demand, motions[:k] + motions[k + 1 :], kinds[:k] + kinds[k + 1 :]))


def evaluate_wall(
    setting: WallContext,
    precision: Precision | None = FULL_PRECISION,
    floors: FloorCache | None = None,
    cancelled: Callable[[], bool] = lambda: False,
) -> WallEvaluation:
    """The wall of a setting about all its hinges.

    precision : of the histories; None makes none
    floors : of the building, kept for the next call with the same demand and building
    Raises InputError, Cancelled.
    """
    plan = make_plan(setting.case, setting.inputs, floors=floors, complete=False)
    scenes = [plan.scene(k, setting.demand, histories=setting.histories) for k in range(len(plan.entries))]

    @functools.cache
    def hinge(n: int) -> Evaluation:
        if precision is None:
            return evaluate(scenes[n].without_records())
        return evaluate(scenes[n], precision, other=False, cancelled=cancelled)

    def worst(numbers: list[int]) -> tuple:
        return way_key((outcome(n), hinge(n).zeta, setting.demand.zeta_target) for n in numbers)

    def outcome(n: int) -> str:
        """Outcome of a part: what holds it and is not shown to hold it leaves it indicative, as in the run."""
        code, hold = hinge(n).outcome, plan.entries[n].part.wall.held_by
        shown = not plan.entries[n].part.held or (hold is not None and hold.shows_strength)
        return code if shown or OUTCOMES[code].judgement != PASSES else "indicative"

    parts = [entry.part for entry in plan.entries]
    return WallEvaluation(tuple(map(hinge, best_way(parts, worst, lambda n: hinge(n).loses_hold))))
