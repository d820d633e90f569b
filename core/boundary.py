"""Search of the boundary at which something begins to hold: the only one outside the kernels.

`holds` of a value is True, False, or None where the value is refused.
"""

import math
from collections.abc import Callable
from typing import NamedTuple

Holds = Callable[[float], bool | None]

MAX_STEPS = 200
"""Halvings after which a bracket is as narrow as its numbers allow."""


class Boundary(NamedTuple):
    """Both sides of a boundary. good : a value at which it holds, None where it holds at none that was tried; bad : one
    at which it does not, None where it holds at all; refused : the bad one is refused"""

    good: float | None
    bad: float | None
    refused: bool = False


class Bracket(NamedTuple):
    """Both sides of a boundary that is there, as of `Edge`."""

    good: float
    bad: float
    refused: bool


def narrowed(holds: Holds, good: float, bad: float, close: float = 0.0, steps: int = MAX_STEPS) -> Bracket:
    """Narrow by bisection the boundary between a value at which something holds and one at which it does not.

    close : difference of both sides, over the larger one, at which it stops; steps : halvings at the most
    """
    refused = False
    for _ in range(steps):
        middle = 0.5 * (good + bad)
        if abs(good - bad) <= close * max(abs(good), abs(bad)) or middle in (good, bad):
            break
        held = holds(middle)
        if held:
            good = middle
        else:
            bad, refused = middle, held is None
    return Bracket(good, bad, refused)


def find_boundary(
    holds: Holds, start: float, ends: tuple[float, float], rises: bool, step: float, close: float
) -> Boundary:
    """Search the boundary nearest to a value by growing steps, then narrow it by bisection.

    start : where the search begins, above 0; ends : the smallest and the largest value that is tried
    rises : it holds at large values rather than at small ones
    step : factor of one step; close : as of `narrowed`
    """
    inside = bool(holds(start))
    upwards = inside != rises
    value, last, refused = start, ends[1] if upwards else ends[0], False
    while value != last:
        before = value
        value = min(step * value, last) if upwards else max(value / step, last)
        held = holds(value)
        if bool(held) != inside:
            sides = (before, value) if inside else (value, before)
            refused = inside and held is None
            good, bad, last_refused = narrowed(holds, *sides, close)
            return Boundary(good, bad, last_refused or (refused and bad == sides[1]))
    return Boundary(value, None) if inside else Boundary(None, value)


def written_up(value: float, unit: float) -> float:
    """A value rounded up to the digits it is written with. unit : of its last digit"""
    return math.ceil(value / unit - 1e-9) * unit
