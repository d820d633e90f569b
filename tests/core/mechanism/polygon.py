"""What any holds of a wall give while it is at rest, by a polygon of states: a way to the closed forms of
core/mechanism/rest.py that shares nothing with them.

From the top down the moment m(z) of the holds above a section is linear between holds, and its slope grows by R_k at
each. So the states (m, slope) that can be reached are a convex polygon: sheared between two heights, cut at each
section, widened at each hold. The wall stays at rest if any state is left at the base, where the slope is the sum of
the reactions.
"""

import itertools
from collections.abc import Sequence
from dataclasses import replace

from core.boundary import narrowed
from core.known import require_value
from core.mechanism.rest import BISECTIONS, MAX_MULTIPLIER, Reach
from core.mechanism.sections import Sections

SECTIONS, ROUNDS = 12, 3
"""Sections looked at between two heights at which the wall changes or is held; rounds in which sections are added."""

State = tuple[float, float]
"""Moment of the holds above a section [N] and their sum [N/m]."""


def holds_at_rest(sections: Sections, holds: Sequence[Reach], alpha: float, friction: float | None = None) -> bool:
    """Whether reactions exist with which a wall stays at rest under an outward push alpha [-]: no section opens, and
    the base does not slide. friction : of the base, None that of the wall"""
    return bool(_reached(sections, holds, alpha, sections.wall.friction if friction is None else friction))


def multiplier_at_rest(sections: Sections, holds: Sequence[Reach], friction: float | None = None) -> float:
    """Largest alpha [-] of `holds_at_rest`, at most MAX_MULTIPLIER; 0 of a wall that does not stand without a push."""
    if not holds_at_rest(sections, holds, 0.0, friction):
        return 0.0
    low, high = 0.0, 1.0
    while high < MAX_MULTIPLIER and holds_at_rest(sections, holds, high, friction):
        low, high = high, 2.0 * high
    stands, _, _ = narrowed(lambda a: holds_at_rest(sections, holds, a, friction), low, high, steps=BISECTIONS)
    return stands


def least_reaction(sections: Sections, holds: Sequence[Reach], n: int, alpha: float) -> float | None:
    """Least reaction [N/m] of hold n with which a wall stays at rest, whatever the others give; None if none does."""
    return _extreme(sections, holds, n, alpha, least=True)


def greatest_reaction(sections: Sections, holds: Sequence[Reach], n: int, alpha: float) -> float | None:
    """Greatest reaction [N/m] of hold n with which a wall stays at rest, whatever the others give; None: none does."""
    return _extreme(sections, holds, n, alpha, least=False)


def _extreme(sections: Sections, holds: Sequence[Reach], n: int, alpha: float, least: bool) -> float | None:
    def stays(value: float) -> bool:
        own = replace(holds[n], outward=value) if least else replace(holds[n], inward=-value)
        return bool(_reached(sections, [*holds[:n], own, *holds[n + 1 :]], alpha, None))

    low, high = -holds[n].inward, holds[n].outward
    if not (stays(high) if least else stays(low)):
        return None
    if stays(low) if least else stays(high):
        return low if least else high
    inside, _, _ = narrowed(stays, *((high, low) if least else (low, high)), steps=BISECTIONS)
    return inside


def _reached(sections: Sections, holds: Sequence[Reach], alpha: float, friction: float | None) -> list[State]:
    """States at the base, the corners of a convex polygon; empty where the wall does not stay at rest. friction : None
    leaves the base out"""
    heights = sorted({*sections.levels, *(hold.height for hold in holds)}, reverse=True)
    uncut = sections.height - require_value(sections.wall.thickness)
    states: list[State] = [(0.0, 0.0)]
    for upper, lower in itertools.pairwise(heights):
        for hold in holds:
            if hold.height == upper:
                states = _widened(states, -hold.inward, hold.outward)
        states = _through_stretch(sections, states, upper, lower, alpha, uncut)
        if not states:
            return []
    if friction is not None:
        base = sections.at(0.0)
        drives, resists = alpha * base.pushed + sections.thrusts, friction * base.weight
        states = _cut(_cut(states, 0.0, 1.0, drives - resists), 0.0, -1.0, -drives - resists)
    return states


def _through_stretch(sections: Sections, entering: list[State], upper: float, lower: float, alpha: float, uncut: float):
    """States below a stretch in which nothing changes. No section opens nearer to the top than the wall is thick, as no
    hinge does: above the height uncut [m]. The greatest moment is convex in z, so that it cuts between two sections,
    where the line of a state touches it: those sections are added for the states that are left."""
    places = [*(upper + (lower - upper) * k / SECTIONS for k in range(1, SECTIONS)), lower]  # not next to it
    places += [uncut] if lower < uncut < upper else []
    # the greatest moment is a quadratic function of z over a stretch of constant section
    inside = sections.at_below(upper), sections.at(0.5 * (upper + lower)), sections.at(lower)
    ends = [section.greatest_moment(alpha) for section in inside]
    depth = upper - lower
    curvature = 4.0 * (ends[0] - 2.0 * ends[1] + ends[2]) / depth**2
    slope = (4.0 * ends[1] - 3.0 * ends[0] - ends[2]) / depth  # by the depth below the upper end
    states: list[State] = []
    for _ in range(ROUNDS):
        states, above = entering, upper
        for z in sorted(set(places), reverse=True):
            states = [(m + s * (above - z), s) for m, s in states]
            section, above = sections.at(z), z
            if z > uncut:
                continue
            states = _cut(states, 1.0, 0.0, section.least_moment(alpha))
            states = _cut(states, -1.0, 0.0, -section.greatest_moment(alpha))
            if not states:
                return []
        if curvature <= 0.0:
            break
        touching = (upper - (s - slope) / curvature for _, s in states)
        places += [z for z in touching if lower < z < upper]
    return states


def _widened(states: list[State], low: float, high: float) -> list[State]:
    """The convex hull of states whose slope may grow by anything from low to high."""
    points = sorted({(m, s + change) for m, s in states for change in (low, high)})
    if len(points) < 3:
        return points

    def chain(ordered: list[State]) -> list[State]:
        hull: list[State] = []
        for point in ordered:
            while len(hull) > 1 and _turn(hull[-2], hull[-1], point) <= 0.0:
                hull.pop()
            hull.append(point)
        return hull

    return chain(points)[:-1] + chain(points[::-1])[:-1]


def _turn(a: State, b: State, c: State) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _cut(states: list[State], of_moment: float, of_slope: float, least: float) -> list[State]:
    """The part of a convex polygon in which of_moment m + of_slope s is at least so much."""
    slack = 1e-12 * (1.0 + abs(least))
    values = [of_moment * m + of_slope * s - least for m, s in states]
    if all(value >= -slack for value in values):
        return states
    kept: list[State] = []
    for n, (state, value) in enumerate(zip(states, values, strict=True)):
        after, beyond = states[(n + 1) % len(states)], values[(n + 1) % len(states)]
        if value >= -slack:
            kept.append(state)
        if (value > slack and beyond < -slack) or (value < -slack and beyond > slack):
            share = value / (value - beyond)
            kept.append((state[0] + share * (after[0] - state[0]), state[1] + share * (after[1] - state[1])))
    return kept
