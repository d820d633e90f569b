"""The ties along a wall held at its top as its histories take them: functions of its coordinate, and their state.

As bar_state.py, with elongations in metres and places y in place of sines and rotations.
"""

import functools
import math
from typing import NamedTuple

import numpy as np

from core.jit.decorators import subkernel
from core.rocking.bar_state import BREAKS_AT, BROKEN, PHASE, RESIDUAL, SLACK, TAUT, TAUT_AT, YIELDING, YIELDS_AT
from core.rocking.held_top import split_model
from core.rocking.side_functions import DEGREE, OVERLAP, PIECES, THETA, Side, sides_of
from core.wall.bars import BREAK, START, YIELD, Bar, bar_rows
from core.wall.bending import HeldTop, near_rest
from core.wall.moment_rotation import NEVER_REACHED
from core.wall.rocking_model import RockingModel

FORCE, SPRING, LENGTH = range(3)
"""Functions of y of a bar: what a newton of it adds to v, what a newton per metre of it adds, its elongation [m]."""


class HeldBars(NamedTuple):
    """The bars of a wall that bends.

    values : polynomials of FORCE, SPRING and LENGTH in the pieces of y outward, shape (PIECES, bars, 3, DEGREE + 1)
    rows : height [m], stiffness k [N/m2], elongations at yield, at the start and at break [m], shape (bars, 5)
    held : room for the state of each, as of bar_state.py with elongations and y in place of sines and rotations
    room : coefficients of v with the bars, shape (DEGREE + 1,)
    """

    values: np.ndarray
    rows: np.ndarray
    held: np.ndarray
    room: np.ndarray


@functools.lru_cache(maxsize=64)
def _pulls_of(held: HeldTop, slenderness: float, collapse: tuple[float, float]) -> np.ndarray:
    """`HeldBars.values`. slenderness : alpha of the model; collapse : theta_c of both sides [rad]"""
    outward, motion = sides_of(held, slenderness, collapse)[0], held.side(1.0)
    inertia, p2 = float(motion.parts(np.zeros(1))[0][0]), near_rest(motion, slenderness)[0]
    nodes = OVERLAP * np.cos(math.pi * (np.arange(DEGREE + 1) + 0.5) / (DEGREE + 1))
    powers = np.vander(nodes, increasing=True)
    theta = outward.values[:, THETA] @ powers.T
    root_of_inertia = np.sqrt(motion.parts(theta.ravel())[0] / inertia).reshape(theta.shape)
    values = np.zeros((PIECES, len(held.outward.bars), 3, DEGREE + 1))
    for j, bar in enumerate(held.outward.bars):
        length, rate = (part.reshape(theta.shape) for part in motion.stretched(theta.ravel(), bar))
        force = rate / (root_of_inertia * inertia * p2)
        for which, at_nodes in ((FORCE, force), (SPRING, force * length), (LENGTH, length)):
            values[:, j, which] = np.linalg.solve(powers, at_nodes.T).T
    return values


class HeldStrip(NamedTuple):
    """A strip of wall that bends with ties along it, as the kernels take it.

    model : RockingModel without `bending`; outward, inward : Side; bars : HeldBars
    """

    model: RockingModel
    outward: Side
    inward: Side
    bars: HeldBars


def strip_with_bars(model: RockingModel) -> HeldStrip:
    """The strip of a model with `bending` that has bars."""
    bare, outward, inward = split_model(model)
    assert model.bending is not None
    alpha = model.slenderness
    collapse = alpha + model.restoring.lean, alpha + model.mirrored.lean
    given = model.bending.outward.bars
    rows = bar_rows(
        [
            Bar(bar.height, bar.strength / bar.elongation_at_yield, bar.elongation_at_yield, bar.slack, bar.breaks_at)
            for bar in given
        ]
    )
    values = _pulls_of(model.bending, alpha, collapse)
    return HeldStrip(bare, outward, inward, HeldBars(values, rows, np.zeros(rows.shape), np.zeros(DEGREE + 1)))


@subkernel
def bar_length(j, y, side, bars):
    """Elongation of the j-th bar at y [m]."""
    at = y * side.scale
    piece = min(max(int(at), 0), PIECES - 1)
    s, total = 2.0 * (at - piece) - 1.0, 0.0
    for n in range(DEGREE, -1, -1):
        total = total * s + bars.values[piece, j, LENGTH, n]
    return total


@subkernel
def invert_length(j, length, side, bars):
    """y [rad] at which the j-th bar is as long as this [m]; never beyond where the wall has overturned."""
    if bar_length(j, side.end, side, bars) <= length:
        return NEVER_REACHED
    low, high = 0.0, side.end
    for _ in range(60):
        middle = 0.5 * (low + high)
        if bar_length(j, middle, side, bars) < length:
            low = middle
        else:
            high = middle
    return high if length > 0.0 else 0.0


@subkernel
def set_length(j, residual, side, bars):
    """Set the residual elongation of the j-th bar [m], and the places that follow."""
    bars.held[j, RESIDUAL] = residual
    bars.held[j, TAUT_AT] = invert_length(j, residual, side, bars)
    bars.held[j, YIELDS_AT] = invert_length(j, residual + bars.rows[j, YIELD], side, bars)


@subkernel
def begin_bars(y, side, bars):
    """Set the bars at the start of a history. y : outward then [rad]"""
    for j in range(bars.rows.shape[0]):
        length = bar_length(j, y, side, bars)
        set_length(j, max(bars.rows[j, START], length - bars.rows[j, YIELD]), side, bars)
        bars.held[j, BREAKS_AT] = invert_length(j, bars.rows[j, BREAK], side, bars)
        taut = SLACK if y < bars.held[j, TAUT_AT] else TAUT
        bars.held[j, PHASE] = BROKEN if length > bars.rows[j, BREAK] else taut


@subkernel
def residual_length(j, y, side, bars):
    """Residual elongation of the j-th bar [m], also while it yields, inf where it has gone."""
    if bars.held[j, PHASE] == BROKEN:
        return math.inf
    if bars.held[j, PHASE] == YIELDING:
        return bar_length(j, y, side, bars) - bars.rows[j, YIELD]
    return bars.held[j, RESIDUAL]


@subkernel
def turn_back(y, side, bars):
    """The bars that yield are taut where the wall turns back, at y [rad]."""
    for j in range(bars.rows.shape[0]):
        if bars.held[j, PHASE] == YIELDING:
            set_length(j, bar_length(j, y, side, bars) - bars.rows[j, YIELD], side, bars)
            bars.held[j, YIELDS_AT] = y
            bars.held[j, PHASE] = TAUT


@subkernel
def ends_of_branch(sign, bars):
    """y between which no bar changes what it does [rad]."""
    low, high = 0.0, NEVER_REACHED
    if sign > 0.0:
        for j in range(bars.rows.shape[0]):
            phase = bars.held[j, PHASE]
            if phase == SLACK:
                high = min(high, bars.held[j, TAUT_AT])
            elif phase == TAUT:
                low = max(low, bars.held[j, TAUT_AT])
                high = min(high, bars.held[j, YIELDS_AT], bars.held[j, BREAKS_AT])
            elif phase == YIELDING:
                high = min(high, bars.held[j, BREAKS_AT])
    return low, high
