"""Many multipliers of one record in lockstep: the plain step of Taylor order 8 on all lanes at once.

A loop without branches over contiguous lanes, which the compiler turns into vector instructions. A lane
whose step is not plain (at rest, near uplift, impact or a new peak, a series not converged) goes through
the sample by `taylor.through_sample` instead, so that results equal those of single analyses bit for bit.
Rigid law; collapsed lanes leave.
"""

import numpy as np

from core.kernel_cache import kernel
from core.moment_rotation import FAR
from core.rocking.events import LOOK_EVERY, remaining_push, settled
from core.rocking.outcome import STABLE
from core.rocking.polynomial import increment, rate
from core.rocking.taylor import (
    SERIES_TOLERANCE,
    at_end,
    series,
    sine_and_cosine_short,
    through_sample,
    turning_margin,
    upright,
)
from core.units import G

SHORT = 0.25
"""Rotation up to which the short series of sin and cos holds [rad]."""

WIDTH = 16
"""Lanes of one pass. Their state is one array of rows this long: the compiler then sees that the rows do
not overlap, which it needs to use vector instructions."""

SCALE, SIDE, PHI, SPEED, PEAK, PLAIN, NEW_PHI, NEW_SPEED = (WIDTH * row for row in range(8))
ROWS = 8

VECTOR = 8
"""Lanes are stepped in multiples of this, so that no remainder is left to single steps; those beyond the
last lane hold old states and are not looked at."""

FEWEST = 4
"""Below this number of multipliers single analyses are faster."""


@kernel
def plain_steps(lanes, ground0, ground1, dt, alpha, p2, constants, state):
    """One full-sample step of each lane; its PLAIN is 1.0 if that is all there is to it, else 0.0."""
    threshold, sine_upright, cosine_upright = constants
    branch = (0.0, FAR, 1.0, 0.0, 0.0)
    for k in range((lanes + VECTOR - 1) // VECTOR * VECTOR):
        g0 = state[SCALE + k] * ground0
        g1 = state[SCALE + k] * ground1
        slope = (g1 - g0) / dt
        sign = state[SIDE + k]
        x = state[PHI + k]
        v = state[SPEED + k]
        beta = (sign / G) * g0
        s, c = sine_and_cosine_short(x)
        sine = sine_upright * c - cosine_upright * s
        cosine = cosine_upright * c + sine_upright * s
        short = (threshold - sign * g0) / G
        net = cosine_upright * short * c - (cosine_upright + beta * sine_upright) * s
        terms = series(x, v, net, sine, cosine, beta, sign / G * slope, p2, branch, 8)
        forcing = max(abs(g0), abs(g1)) / G
        push = p2 * (1.0 + forcing)
        stiff = push + v * v
        square = dt * dt
        power = square * square * dt * square * dt
        tail = power * (abs(terms[8]) + dt * abs(terms[9]))
        ratio = stiff * square * (1.0 / 90.0)
        dphi = increment(terms, dt)
        after = rate(terms, dt)
        reach = 0.125 * dt * dt * push
        margin = turning_margin(v, after, dt * slope / G, forcing, p2, push, dt)
        y = x + dphi
        near = (
            (min(x, y) <= reach)
            | (x > SHORT)
            | (tail * ratio > SERIES_TOLERANCE * alpha)
            | (ratio >= 0.05)
            | ((min(v, -after) > -margin) & (max(x, y) + reach > state[PEAK + k]))
        )
        state[PLAIN + k] = 0.0 if near else 1.0
        state[NEW_PHI + k] = y
        state[NEW_SPEED + k] = after


@kernel
def scan(ground, dt, scales, model, outcomes, peaks):
    """Analyses of one record at up to WIDTH multipliers, rigid law, order 8; returns the clamped ratios.

    Arguments as `core.rocking.scan`; the results are those of `taylor.integrate`, bit for bit.
    """
    constants = upright(model)
    threshold = constants[0]
    alpha = model.slenderness
    p2 = model.p2
    none = np.empty(0)
    lanes = scales.size
    lane = np.arange(lanes)
    moving = np.zeros(lanes, np.bool_)
    state = np.zeros(ROWS * WIDTH)
    for k in range(lanes):
        state[SCALE + k] = scales[k]
        state[SIDE + k] = 1.0
    clamped = 0
    left = remaining_push(ground, dt)
    for i in range(ground.size - 1):
        ground0 = ground[i]
        ground1 = ground[i + 1]
        any_moving = False
        for k in range(lanes):
            any_moving = any_moving | moving[k]
        if any_moving:
            plain_steps(lanes, ground0, ground1, dt, alpha, p2, constants, state)
        k = 0
        while k < lanes:
            first = state[SCALE + k] * ground0
            second = state[SCALE + k] * ground1
            if moving[k]:
                if state[PLAIN + k] == 1.0:
                    state[PHI + k] = state[NEW_PHI + k]
                    state[SPEED + k] = state[NEW_SPEED + k]
                    state[PEAK + k] = max(state[PEAK + k], state[NEW_PHI + k])
                    k += 1
                    continue
            elif max(first, second) <= threshold and (
                min(first, second) >= -threshold or model.one_sided != 0.0
            ):
                k += 1
                continue
            outcome, after = through_sample(
                first, second, dt, model, constants, 8, block_of(state, moving, k), 0.0, none, none
            )
            side, phi, speed, moves, _, peak, _, clamps = after
            state[SIDE + k] = side
            state[PHI + k] = phi
            state[SPEED + k] = speed
            state[PEAK + k] = peak
            moving[k] = moves
            clamped += clamps
            if outcome == STABLE:
                k += 1
                continue
            outcomes[lane[k]] = outcome
            peaks[lane[k]] = peak
            lanes = leave(k, lanes, lane, moving, state)
        if i % LOOK_EVERY == 0 and model.ratio_drop == 0.0:
            k = 0
            while k < lanes:
                push = abs(state[SCALE + k]) * left[i + 1]
                if settled(state[PHI + k], state[SPEED + k], state[PEAK + k], push, model):
                    outcomes[lane[k]] = STABLE
                    peaks[lane[k]] = state[PEAK + k]
                    lanes = leave(k, lanes, lane, moving, state)
                else:
                    k += 1
        if lanes == 0:
            break
    for k in range(lanes):
        outcomes[lane[k]], peaks[lane[k]] = at_end(block_of(state, moving, k), model)
    return clamped


@kernel
def leave(k, lanes, lane, moving, state):
    """Take lane k out: the last one takes its place. Returns how many are left."""
    lanes -= 1
    lane[k] = lane[lanes]
    moving[k] = moving[lanes]
    for row in range(ROWS):
        state[WIDTH * row + k] = state[WIDTH * row + lanes]
    return lanes


@kernel
def block_of(state, moving, k):
    """State of one lane as `taylor.through_sample` takes it: rigid law, nothing counted yet."""
    return (
        state[SIDE + k], state[PHI + k], state[SPEED + k], moving[k], 2, state[PEAK + k], 0, 0
    )  # fmt: skip
