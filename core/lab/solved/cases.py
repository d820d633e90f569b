"""Every solved case, subject by subject."""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

from core.lab.solved import bodies, clauses, experiments, floors, hazard, histories, motion, paper, published, ties
from core.lab.solved.solved import Solved, worded
from core.text.sentence import Sentence


class Subject(NamedTuple):
    title: Sentence
    cases: tuple[Solved, ...]


SUBJECTS: tuple[Subject, ...] = (
    Subject(worded("The rocking block in closed form"), motion.CASES),
    Subject(worded("Histories to forty digits"), histories.CASES),
    Subject(worded("The equations of the paper"), paper.CASES),
    Subject(worded("Published worked examples"), published.CASES),
    Subject(worded("Experiments"), experiments.CASES),
    Subject(worded("The Circolare by hand"), clauses.CASES),
    Subject(worded("Ties and walls held at their top"), ties.CASES),
    Subject(worded("Bodies of any shape"), bodies.CASES),
    Subject(worded("Above the ground"), floors.CASES),
    Subject(worded("Hazard, spectra, risk"), hazard.CASES),
)


def subjects(records: Path | None = None) -> tuple[Subject, ...]:
    """`SUBJECTS`, and q of El Centro 1940 by its record in a folder, which does not come with the program. Raises
    InputError where it is not there."""
    if records is None:
        return SUBJECTS
    record = paper.el_centro(records)
    return (*SUBJECTS, Subject(worded("El Centro 1940"), paper.of_el_centro(record)))


def cases_of(chosen: Sequence[Subject]) -> list[Solved]:
    """The cases of subjects, one after the other."""
    return [case for subject in chosen for case in subject.cases]


def solve(cases: Sequence[Solved], progress: Callable[[int, int], None] = lambda done, planned: None) -> list[Solved]:
    """Ask the program for every answer, and return the cases that do not agree with their source."""
    differing = []
    for k, case in enumerate(cases):
        if not case.agrees:
            differing.append(case)
        progress(k + 1, len(cases))
    return differing
