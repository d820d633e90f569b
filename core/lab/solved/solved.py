"""A solved case: a question whose answer is known from elsewhere, and what the program finds (NTC 2018, 10.2)."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from functools import cache, cached_property, partial
from typing import Any

from core.text.sentence import Sentence, sentence

Outline = tuple[tuple[float, float], ...]
"""Corners of a body [m], x from the hinge and z upwards."""


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
    others : outlines of other solids and of openings
    """

    outline: Outline = ()
    loads: tuple[tuple[float, float, float, float], ...] = ()
    motion: tuple[float, ...] = ()
    others: tuple[Outline, ...] = ()


@dataclass(frozen=True)
class Answer:
    """One number of a case.

    words : what it is, or its symbol; unit : "" of a ratio
    expected : by the source; tolerance : share of it that the source's own digits or its method leave open, where zero
        is expected the difference itself
    find : what the program finds, in the same unit
    decimals : of the source, by which it is written; None : six digits
    """

    words: Sentence | str
    unit: str
    expected: float
    tolerance: float
    find: Callable[[], float]
    decimals: int | None = None

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
    sketch : or what makes it
    comment : what is to be known of it: the assumptions, why an answer differs from what a textbook prints
    table : the case as a case file has it, by which it is run again; None of what no case file says
    shipped : name of the case of resources/cases by which it is run again
    """

    key: str
    kind: Kind
    title: Sentence
    source: str
    answers: tuple[Answer, ...]
    formula: str = ""
    sketch: Sketch | Callable[[], Sketch] = Sketch()
    comment: Sentence | None = None
    table: Mapping[str, object] | None = None
    shipped: str = ""

    @property
    def drawing(self) -> Sketch:
        """Its sketch."""
        return self.sketch() if callable(self.sketch) else self.sketch

    @property
    def agrees(self) -> bool:
        """Whether every answer does."""
        return all(answer.agrees for answer in self.answers)

    @property
    def furthest(self) -> Answer:
        """The answer nearest to what its tolerance allows, or furthest beyond."""
        return max(self.answers, key=lambda one: (abs(one.difference) / (one.tolerance or 1e-300), one.tolerance))


def told(key: str, kind: Kind, source: str, answers: tuple[Answer, ...], **more: Any) -> Solved:
    """A case whose title and comment stand in the catalogue, as its key and `<key>_why`. more : of Solved"""
    return Solved(key, kind, sentence("solved", key), source, answers, comment=sentence("solved", f"{key}_why"), **more)


def worded(english: str, /, **values) -> Sentence:
    """A text of the cases."""
    return Sentence("solved", english, tuple(values.items()))


def answer(code: str, expected: float, find: Callable[[], float], tolerance: float = 1e-4, unit: str = "") -> Answer:
    """An answer. code : of its words; tolerance : the digits it is printed with, where none is said"""
    return Answer(sentence("solved", code), unit, expected, tolerance, find)


Head = tuple[Sentence | str, str]
"""What a number is, and its unit."""


def printed(head: Head, value: str, find: Callable[[], float], units: float = 0.5) -> Answer:
    """An answer as its source prints it: a whole number is exact. units : of the last decimal that are left open"""
    expected, decimals = float(value), len(value.partition(".")[2])
    room = units * 10.0**-decimals * (1.0 + 1e-6) if decimals else 1e-12  # a bound in decimals is rounded
    return Answer(*head, expected, room / abs(expected) if expected else room, find, decimals)


def row(
    heads: Sequence[Head], values: str, find: Callable[[], Sequence[float]], units: float = 0.5
) -> tuple[Answer, ...]:
    """The answers of a row of a printed table, found at once. values : as printed, "-" where there is none"""
    once = cache(find)

    def found(k: int) -> float:
        return once()[k]

    return tuple(
        printed(head, value, partial(found, k), units)
        for k, (head, value) in enumerate(zip(heads, values.split(), strict=True))
        if value != "-"
    )
