"""The bars of a wall while it moves: what each does, and what they do to the wall (resources/docs/physics.md, section
18)."""

import math
from typing import NamedTuple

import numpy as np

from core.jit.decorators import subkernel
from core.rocking.events import BlockState
from core.rocking.short_series import sine_and_cosine
from core.units import G
from core.wall.bars import BREAK, START, STIFFNESS, YIELD, angle_of
from core.wall.moment_rotation import NEVER_REACHED

RESIDUAL, TAUT_AT, YIELDS_AT, BREAKS_AT, PHASE = range(5)
"""Columns of the state of the bars: residual elongation as a sine, the rotations at which a bar is taut, yields and
breaks [rad], and what it does now."""

SLACK, TAUT, YIELDING, BROKEN = 0.0, 1.0, 2.0, 3.0
"""PHASE of a bar."""


class Pull(NamedTuple):
    """Pull of the bars on one branch, over I0 p2: the moment (spring sin(phi) + constant) cos(phi) inward.

    spring, constant : [-]; low, high : ends of the branch [rad]; yields : whether a bar does
    """

    spring: float
    constant: float
    low: float
    high: float
    yields: bool


@subkernel
def set_bar(held, j, residual, bar):
    """Set the residual elongation of the j-th bar [sine], and the rotations that follow."""
    held[j, RESIDUAL] = residual
    held[j, TAUT_AT] = angle_of(residual)
    held[j, YIELDS_AT] = angle_of(residual + bar[YIELD])


@subkernel
def bar_pull(side, bars, held):
    """Pull of the bars on their branch; none on a wall that turns inward."""
    spring, constant, low, high, yields = 0.0, 0.0, 0.0, NEVER_REACHED, False
    if side > 0.0:
        for j in range(bars.shape[0]):
            stiffness, phase = bars[j, STIFFNESS], held[j, PHASE]
            if phase == SLACK:
                high = min(high, held[j, TAUT_AT])
            elif phase == TAUT:
                spring += stiffness
                constant -= stiffness * held[j, RESIDUAL]
                low = max(low, held[j, TAUT_AT])
                high = min(high, held[j, YIELDS_AT], held[j, BREAKS_AT])
            elif phase == YIELDING:
                constant += stiffness * bars[j, YIELD]
                high = min(high, held[j, BREAKS_AT])
                yields = True
    return Pull(spring, constant, low, high, yields)


@subkernel
def thresholds_with(constants, bars, held):
    """Ground accelerations at which the resting wall uplifts [m/s2]: those of the wall, and outward what prestressed
    bars hold."""
    right, left = constants.thresholds
    for j in range(bars.shape[0]):
        if held[j, PHASE] != BROKEN:
            stretched = min(max(-held[j, RESIDUAL], 0.0), bars[j, YIELD])
            right += G * bars[j, STIFFNESS] * stretched / constants.cosine
    return right, left


@subkernel
def residual_of(j, sine, bars, held):
    """Residual elongation of the j-th bar over its height [-], also while it yields. sine : of the rotation of the
    wall"""
    return sine - bars[j, YIELD] if held[j, PHASE] == YIELDING else held[j, RESIDUAL]


@subkernel
def unload(phi, bars, held):
    """The bars that yield are taut where the wall turns back, at phi [rad]."""
    sine, _ = sine_and_cosine(phi)
    for j in range(bars.shape[0]):
        if held[j, PHASE] == YIELDING:
            set_bar(held, j, sine - bars[j, YIELD], bars[j])
            held[j, YIELDS_AT] = phi
            held[j, PHASE] = TAUT


@subkernel
def cross_kinks(phi, falls, bars, held):
    """Carry the bars beyond the end of a branch, phi [rad], that the wall reached."""
    for j in range(bars.shape[0]):
        phase = held[j, PHASE]
        if falls:
            if phase == TAUT and phi <= held[j, TAUT_AT]:
                held[j, PHASE] = SLACK
        elif phase != BROKEN:
            if phase == SLACK and phi >= held[j, TAUT_AT]:
                held[j, PHASE] = TAUT
            elif phase == TAUT and phi >= held[j, YIELDS_AT]:
                held[j, PHASE] = YIELDING
            if phi >= held[j, BREAKS_AT]:
                if phase == YIELDING:
                    held[j, RESIDUAL] = bars[j, BREAK] - bars[j, YIELD]
                held[j, PHASE] = BROKEN


@subkernel
def all_broken(held):
    """Whether no bar is left."""
    intact = 0
    for j in range(held.shape[0]):
        intact += int(held[j, PHASE] != BROKEN)
    return intact == 0


@subkernel
def initial_state(start, bars, held):
    """BlockState at the start of a record, and the state of the bars, held. start : rotation [rad] and velocity
    [rad/s]"""
    zero = np.int64(0)
    side = -1.0 if start[0] < 0.0 or (start[0] == 0.0 and start[1] < 0.0) else 1.0
    phi, outward = side * start[0], max(start[0], 0.0)
    sine, _ = sine_and_cosine(outward)
    for j in range(bars.shape[0]):
        set_bar(held, j, max(bars[j, START], sine - bars[j, YIELD]), bars[j])
        held[j, BREAKS_AT] = angle_of(bars[j, BREAK])
        taut = SLACK if outward < held[j, TAUT_AT] else TAUT
        held[j, PHASE] = BROKEN if sine > bars[j, BREAK] else taut
    return BlockState(side, phi, side * start[1], phi != 0.0 or start[1] != 0.0, 2, phi, zero, zero)


@subkernel
def store_sample(trace, i, state, bars, held):
    """Rotation [rad], velocity [rad/s] and residual elongation of each bar at sample i, inf where it has gone."""
    trace[0, i] = state.side * state.phi if state.moving else 0.0
    trace[1, i] = state.side * state.speed if state.moving else 0.0
    sine, _ = sine_and_cosine(state.phi)
    for j in range(held.shape[0]):
        trace[2 + j, i] = math.inf if held[j, PHASE] == BROKEN else residual_of(j, sine, bars, held)
