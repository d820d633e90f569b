"""Searches and dynamic checks by their keys in the journal of a study: a resume makes none twice."""

import hashlib
from collections.abc import Callable
from dataclasses import asdict, replace

from core.codes.demand import SeismicDemand
from core.codes.dynamic_check import DynamicCheck, run_dynamic_check
from core.codes.multiplier_search import RUN, Precision
from core.ground.ground_motion import GroundMotion
from core.rocking.methods import Method
from core.study.journal import Journal, MemoryJournal, dataclass_from_json
from core.wall.rocking_model import RockingModel


class CheckCache:
    """Makes `run_dynamic_check` of one wall, with the same parameters, or takes its result from the journal.

    journal : of the finished checks; None keeps none
    made : how many were not there
    """

    def __init__(self, journal: Journal | MemoryJournal | None):
        self.journal, self.made = journal, 0

    def __call__(
        self,
        model: RockingModel,
        motions: list[GroundMotion],
        polarities: tuple[int, ...],
        demand: SeismicDemand,
        method: Method,
        precision: Precision = RUN,
        other: bool = True,
        cancelled: Callable[[], bool] = lambda: False,
    ) -> DynamicCheck | None:

        def make_key(asked: Precision) -> str:
            return check_key(model, motions, polarities, demand, method, asked, other)

        to_the_end = precision._replace(enough=None)
        for asked in dict.fromkeys((to_the_end, precision)):
            known = dataclass_from_json(DynamicCheck, self.journal.get(make_key(asked))) if self.journal else None
            if known is not None:
                return known
        check = run_dynamic_check(model, motions, polarities, demand, method, precision, other, cancelled)
        if check is not None:
            self.made += 1
            if self.journal:  # a search that ended before what is enough is one to its end
                self.journal.add(make_key(precision if check.beyond else to_the_end), asdict(check))
        return check


def check_key(model, motions, polarities, demand, method, *numbers) -> str:
    """Key of a check in the journal: all that decides its result, of the demand and the records also what does not."""
    demand = replace(demand, target=None, warnings=())  # of spectrum and words it takes nothing
    records = [(repr(motion), motion.samples_sha256) for motion in motions]
    # 3: checks kept before may have a zeta above what is required though they fail there
    parts = ("check_3", tuple(model), records, polarities, demand, method, numbers)
    return hashlib.sha256(repr(parts).encode()).hexdigest()


def run_key(model: RockingModel, motion: GroundMotion, polarity: int, method, search) -> str:
    """Key of a run in the journal: all that decides its result, and nothing else."""
    parts = (tuple(model), motion.samples_sha256, polarity, method, search)
    return hashlib.sha256(repr(parts).encode()).hexdigest()
