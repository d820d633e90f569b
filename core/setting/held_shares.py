"""What a hold between two stretches of a wall has for each of them: shared out as the demand asks for it."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import pairwise

from core.case.held_top import mirror_inward
from core.case.hold import Hold, ShareOfHold
from core.case.wall import Wall
from core.codes.vertical_bending import lowest_hinge
from core.known import require_value
from core.mechanism.bending_reactions import MovingStrip
from core.mechanism.holds import force_on_top, reaction_of_foot
from core.mechanism.sections import Sections
from core.wall.bending import strip_of


def scale_beside(stretch: Wall, factor: float) -> Wall:
    """A stretch whose upper hold takes so many times the inertia of what goes to it beside the stretch."""

    def scaled(hold: Hold) -> Hold:
        if not isinstance(hold, ShareOfHold):
            return hold
        rocking = None if hold.rocking is None else replace(hold.rocking, factor=factor)
        stub = None if hold.stub is None else replace(hold.stub, factor=factor)
        return replace(hold, beside_kn_m=factor * hold.beside_kn_m, rocking=rocking, stub=stub)

    return replace(stretch, hold=tuple(map(scaled, stretch.hold)))


def share_out(stretches: Sequence[Wall], pushes: Sequence[float]) -> list[Wall]:
    """The held stretches of a wall, from below, with what each hold between two of them stands shared out in the
    proportion of what both ask for under the demand. pushes : alpha of the demand of each [-]"""
    shared = list(stretches)
    for n, (lower, upper) in enumerate(pairwise(stretches)):
        below, above = _largest(lower, pushes[n], force_on_top), _largest(upper, pushes[n + 1], reaction_of_foot)
        (top,), (foot,) = _holds_at(lower, lower.height_m), _holds_at(upper, 0.0)
        stands = require_value(top.out_kn_m) + require_value(foot.out_kn_m)
        of_top = below / (below + above)
        shared[n] = _replace_strength(shared[n], top, of_top * stands)
        shared[n + 1] = _replace_strength(shared[n + 1], foot, (1.0 - of_top) * stands)
    return shared


def copy_strength(stretch: Wall, foot: Hold | None, top: Hold | None) -> Wall:
    """A stretch whose holds at its ends stand what these do; None leaves one as it is."""

    def strong(own: Hold) -> Hold:
        of = foot if own.h_m == 0.0 else top if own.h_m == stretch.height_m else None
        if of is None:
            return own
        return replace(own, out_kn_m=of.out_kn_m, in_kn_m=of.in_kn_m, stiffness_kn_m2=of.stiffness_kn_m2)

    return replace(stretch, hold=tuple(map(strong, stretch.hold)))


def _holds_at(stretch: Wall, height: float | None) -> list[Hold]:
    return [hold for hold in stretch.hold if hold.h_m == height]


def _replace_strength(stretch: Wall, hold: Hold, strength: float) -> Wall:
    """A stretch whose hold has this strength outward [kN/m], and inward in proportion."""
    ratio = strength / require_value(hold.out_kn_m) if hold.out_kn_m else 1.0  # of 0: a thrust takes all of it
    inward = None if hold.in_kn_m is None else ratio * hold.in_kn_m
    stiffness = None if hold.stiffness_kn_m2 is None else ratio * hold.stiffness_kn_m2
    own = replace(hold, out_kn_m=strength, in_kn_m=inward, stiffness_kn_m2=stiffness)
    return replace(stretch, hold=tuple(own if each.h_m == hold.h_m else each for each in stretch.hold))


def _largest(stretch: Wall, push: float, reaction: Callable[[Sections, MovingStrip, float], float]) -> float:
    """The larger reaction of a stretch to its two sides [N/m]."""
    sides = stretch.in_si, mirror_inward(stretch).in_si
    strips = [(wall, strip_of(wall)) for wall in sides]
    return max(reaction(Sections(wall), MovingStrip(strip, lowest_hinge(strip)), push) for wall, strip in strips)
