"""A solved case: a question whose answer is known from elsewhere, and what the program finds (NTC 2018, 10.2)."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from functools import cached_property

from core.text.sentence import Sentence


class Kind(StrEnum):
    """Where the expected answer comes from."""

    CLOSED_FORM = "closed_form"
    REFERENCE = "reference"  # a history to 30 or 40 digits
    HAND = "hand"  # a calculation by hand, by the words of a clause
    PRINTED = "printed"  # a table or an example of a page
    EXPERIMENT = "experiment"


@dataclass(frozen=True)
class Sketch:
    """What is drawn of a case: a section, its hinge, loads.

    outline : corners of the body [m], x from the hinge and z upwards
    loads : (x, z, horizontal, vertical), a point [m] and the direction of the force there
    motion : samples of the ground to draw beneath, of any unit; empty where there is none
    """

    outline: tuple[tuple[float, float], ...] = ()
    loads: tuple[tuple[float, float, float, float], ...] = ()
    motion: tuple[float, ...] = ()


@dataclass(frozen=True)
class Answer:
    """One number of a case.

    words : what it is; unit : "" of a ratio
    expected : by the source; tolerance : share of it that the source's own digits or its method leave open
    find : what the program finds, in the same unit
    """

    words: Sentence
    unit: str
    expected: float
    tolerance: float
    find: Callable[[], float]

    @cached_property
    def found(self) -> float:
        """What the program finds."""
        return float(self.find())

    @property
    def difference(self) -> float:
        """Found over expected, less one; the difference itself where zero is expected."""
        return self.found / self.expected - 1.0 if self.expected else self.found

    @property
    def agrees(self) -> bool:
        """Whether they differ by no more than the tolerance."""
        return math.isfinite(self.found) and abs(self.difference) <= self.tolerance


@dataclass(frozen=True)
class Solved:
    """A case.

    key : unique, letters, digits and underscores
    title : what is asked; source : author, year, page or equation, as it is cited
    formula : Typst mathematics, empty where the source alone is cited
    comment : what is to be known of it: the assumptions, why an answer differs from what a textbook prints
    """

    key: str
    kind: Kind
    title: Sentence
    source: str
    answers: tuple[Answer, ...]
    formula: str = ""
    sketch: Sketch = Sketch()
    comment: Sentence | None = None

    @property
    def agrees(self) -> bool:
        """Whether every answer does."""
        return all(answer.agrees for answer in self.answers)
