"""Reactions of what holds a wall while it is at rest (rigid masonry without tension).

A section at z carries the wall above it if the moment of the hold above, R (h - z), lies between alpha S - M_o and
alpha S + M_i; a polygon of the states of all sections, for any holds, is in tests/core/mechanism/polygon.py.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from core.boundary import narrowed
from core.known import require_value
from core.mechanism.sections import Sections

BISECTIONS = 40
"""Bisections of a multiplier or of a reaction."""

MAX_MULTIPLIER = 100.0
"""Multiplier beyond which no wall is looked at [-]."""


@dataclass(frozen=True)
class Reach:
    """What a hold can give: outward-holding up to `outward`, pushing the wall out up to `inward` [N/m], at a height
    above the base [m]."""

    height: float
    outward: float
    inward: float = 0.0


NEAR_HOLD = 1e-7
"""How near to a hold its limit is taken [of the height]: nearer the digits of moment and lever cancel."""

INNER, OUTER = slice(5, 8), slice(8, 11)
"""Columns of `Sections.pieces` of the moments about the inner and the outer face."""

ROUNDING = 1e-12
"""What the least and the greatest reaction may miss each other by [of them]."""


def greatest_at_top(sections: Sections, height: float, alpha: float) -> float:
    """Greatest reaction [N/m] of one hold at this height [m] with which a wall stays at rest: the least of (alpha S +
    M_i)/(height - z) over all sections."""
    return float(_over_levers(sections, height, alpha, INNER).min())


def least_at_top(sections: Sections, height: float, alpha: float) -> float:
    """Least reaction [N/m] of one hold at this height [m] with which a wall stays at rest: R_lo, the largest of (alpha
    S - M_o)/(height - z) over all sections, none below 0; with what the bed joint at the base
    cannot take by its friction, where nothing else holds the foot."""
    least = max(0.0, float(_over_levers(sections, height, alpha, OUTER).max()))
    if sections.wall.declared.foot_strength is not None:
        return least
    return max(least, base_reaction(sections, [], alpha) - sections.wall.friction * sections.at(0.0).weight)


def _over_levers(sections: Sections, height: float, alpha: float, of_moment: slice) -> np.ndarray:
    """(alpha S + moment)/(height - z) at the ends of each stretch and where it is extreme inside. of_moment : columns
    of its coefficients in `Sections.pieces`"""
    uncut = sections.height - require_value(sections.wall.thickness)  # above it no section opens, as no hinge does
    highest = min(height * (1.0 - NEAR_HOLD), uncut)
    pieces = sections.pieces[sections.pieces[:, 0] < highest]
    low, high = pieces[:, 0], np.minimum(pieces[:, 1], highest)
    a, b, c = (alpha * pieces[:, 2:5] + pieces[:, of_moment]).T
    with np.errstate(divide="ignore", invalid="ignore"):
        inside = height - np.sqrt(height**2 + (b * height + a) / c)
    places = np.array([low, high, np.clip(np.where(np.isfinite(inside), inside, low), low, high)])
    return (a + b * places + c * places**2) / (height - places)


def top_holds(sections: Sections, reach: Reach, alpha: float, friction: float) -> bool:
    """Whether a hold at the top has a reaction with which a wall stays at rest under an outward push alpha [-]: no
    section opens, and the base does not slide. friction : of the base"""
    slides, base = friction * sections.at(0.0).weight, base_reaction(sections, [], alpha)
    least = max(float(_over_levers(sections, reach.height, alpha, OUTER).max()), base - slides, -reach.inward)
    most = min(greatest_at_top(sections, reach.height, alpha), base + slides, reach.outward)
    return least <= most + ROUNDING * (abs(least) + abs(most))


def top_multiplier(sections: Sections, reach: Reach, friction: float) -> float:
    """Largest alpha [-] of `top_holds`, at most MAX_MULTIPLIER; 0 of a wall that does not stand without a push."""
    if not top_holds(sections, reach, 0.0, friction):
        return 0.0
    low, high = 0.0, 1.0
    while high < MAX_MULTIPLIER and top_holds(sections, reach, high, friction):
        low, high = high, 2.0 * high
    return narrowed(lambda a: top_holds(sections, reach, a, friction), low, high, steps=BISECTIONS)[0]


def simple_reactions(sections: Sections, heights: Sequence[float], alpha: float) -> list[float]:
    """Reactions [N/m] of stiff holds at these heights, each stretch between two of them a simple beam: what acts on it
    goes to its ends by the lever rule, what overhangs to the holds by statics."""
    ends = [0.0, *heights]
    moments = [section.pressing + alpha * section.push for section in map(sections.at, ends)]
    reactions: list[float] = []
    above = lever = 0.0
    for n in range(len(ends) - 1, 0, -1):
        # the moment of all that is above the end below vanishes there: R_n (h_n - h_below) = M_below - sum of others
        span = ends[n] - ends[n - 1]
        force = (moments[n - 1] - (lever + above * span)) / span
        reactions.append(force)
        lever += (above + force) * span
        above += force
    return reactions[::-1]


def base_reaction(sections: Sections, reactions: Sequence[float], alpha: float) -> float:
    """Shear [N/m] that the base takes: what is pushed less what the holds take."""
    base = sections.at(0.0)
    return alpha * base.pushed + sections.thrusts - sum(reactions)
