"""Many multipliers of one record in lockstep: the plain step of the Taylor series on all lanes at once.

A loop without branches over contiguous lanes, which the compiler turns into vector instructions. A lane
whose step is not plain (near uplift, impact, a kink or a new peak, a series not converged) goes through
the sample by `taylor.through_sample` instead, so that results equal those of single analyses bit for bit.
Samples in which every lane rests are skipped; lanes that have collapsed or settled leave.
"""

import numpy as np

from core.kernel_cache import inner_kernel, kernel, widest_vectors
from core.moment_rotation import moment_branch, zone_of
from core.rocking.bounds import (
    SERIES_TOLERANCE,
    STIFFEST,
    largest_push,
    neglected,
    turning_margin,
)
from core.rocking.events import (
    LOOK_EVERY,
    LOST_EVERY,
    UNKNOWN,
    ahead_of,
    quiet_windows,
    remaining_push,
    settled,
)
from core.rocking.outcome import COLLAPSED, STABLE
from core.rocking.polynomial import change, increment
from core.rocking.taylor import (
    PER_G,
    SHORT,
    at_end,
    lost,
    series,
    sine_and_cosine_short,
    strongest_push,
    through_sample,
    upright,
)

WIDTH = 64
"""Lanes of one pass. Their state is one array of rows this long: the compiler then sees that the rows do
not overlap, which it needs to use vector instructions."""

(
    SCALE,
    STRONGEST,
    SIDE,
    PHI,
    SPEED,
    MOVING,
    PEAK,
    ZONE,
    LOW,
    HIGH,
    FACTOR,
    SLOPE,
    CONSTANT,
    EVENT,
) = (WIDTH * row for row in range(14))
ROWS = 14

VECTOR = 8
"""Lanes are stepped in multiples of this, so that no remainder is left to single steps; those beyond the
last lane hold old states and are not looked at."""


@kernel
def plain_steps(lanes, ground0, ground1, dt, model, constants, lowest, order, state):
    """One full-sample step of each lane for which that is all there is to it, or rest; the others stay
    as they are, and their EVENT is 1.0.

    lowest : ground acceleration below which a resting block lifts to the other side [m/s2].
    """
    widest_vectors()
    threshold, tangent, sine_upright, cosine_upright = constants
    tolerance = SERIES_TOLERANCE * model.slenderness
    p2 = model.p2 * (dt * dt)
    per_dt = 1.0 / dt
    for k in range((lanes + VECTOR - 1) // VECTOR * VECTOR):
        scale = state[SCALE + k]
        x = state[PHI + k]
        speed = state[SPEED + k]
        factor = state[FACTOR + k]
        slope = state[SLOPE + k]
        first = scale * ground0
        second = scale * ground1
        pull = state[SIDE + k] * PER_G
        beta = pull * first
        rise = pull * (second - first)
        forcing = max(abs(first), abs(second)) * PER_G
        s, c = sine_and_cosine_short(x)
        sine = sine_upright * c - cosine_upright * s
        cosine = cosine_upright * c + sine_upright * s
        net = cosine_upright * (factor * tangent - beta) * c
        net = net - (factor * cosine_upright + beta * sine_upright) * s
        net = net + (slope * x + state[CONSTANT + k])
        v = series(speed * dt, net, sine, cosine, beta, rise, p2, factor, slope, order)
        dv = change(v, 1.0)
        y = x + increment(v, 1.0)
        growth = p2 * (1.0 + forcing + slope) + v[0] * v[0]
        lower = min(x, y)
        upper = max(x, y)
        push = largest_push(upper, forcing, p2, sine_upright)
        reach = 0.125 * push
        margin = turning_margin(v[0], dv, rise, forcing + slope, p2, push)
        after = v[0] + dv
        event = (
            ((lower - state[LOW + k] <= reach) & (min(v[0], after) <= margin))
            | ((state[HIGH + k] - upper <= reach) & (max(v[0], after) >= -margin))
            | (upper > SHORT)
            | (neglected(v, growth, forcing, rise, p2, order) > tolerance)
            | (growth >= STIFFEST)
            | ((min(v[0], -after) > -2.0 * margin) & (upper + reach > state[PEAK + k]))
        )
        rests = (
            (state[MOVING + k] == 0.0)
            & (max(first, second) <= threshold)
            & (min(first, second) >= lowest)
        )
        state[EVENT + k] = 1.0 if event & (not rests) else 0.0
        state[PHI + k] = x if event else y
        state[SPEED + k] = speed if event else speed + dv * per_dt
        state[PEAK + k] = state[PEAK + k] if event else max(state[PEAK + k], y)


@inner_kernel
def scan(ground, dt, scales, model, order, outcomes, peaks):
    """Analyses of one record at up to WIDTH multipliers; returns the clamped ratios of each.

    Arguments as `core.rocking.scan`, order : 6 or 8. Outcomes and the peaks of what stays up are those of
    `taylor.integrate`, bit for bit; the peak of a block that falls is where it was given up.
    """
    constants = upright(model)
    threshold = constants[0]
    lowest = -np.inf if model.one_sided != 0.0 else -threshold
    zero = np.int64(0)  # a plain 0 would be a type of its own, and compile everything again
    lanes = scales.size
    lane = np.arange(lanes)
    state = np.zeros(ROWS * WIDTH)
    strongest = strongest_push(ground)
    start = (1.0, 0.0, 0.0, False, zone_of(0.0, model), 0.0, zero, zero)
    up = 0.0
    down = 0.0
    for k in range(lanes):
        state[SCALE + k] = scales[k]
        state[STRONGEST + k] = abs(scales[k]) * strongest
        put(k, start, model, state)
        up = max(up, scales[k])
        down = min(down, scales[k])
    awake = 0
    clamped = np.zeros(lanes, np.int64)
    left = remaining_push(ground, dt)
    stops = model.ratio_drop == 0.0
    windows = quiet_windows(ground if stops else ground[:0])
    ahead = UNKNOWN
    for i in range(ground.size - 1):
        ground0 = ground[i]
        ground1 = ground[i + 1]
        high = max(up * max(ground0, ground1), down * min(ground0, ground1))
        low = min(up * min(ground0, ground1), down * max(ground0, ground1))
        if awake > 0 or high > threshold or low < lowest:
            plain_steps(lanes, ground0, ground1, dt, model, constants, lowest, order, state)
            k = zero
            while k < lanes:
                if state[EVENT + k] == 0.0:
                    k += 1
                    continue
                if stops:
                    ahead = ahead_of(windows, i, state[SCALE + k])
                outcome, after = through_sample(
                    state[SCALE + k] * ground0, state[SCALE + k] * ground1, dt, model, constants, order,
                    state[STRONGEST + k], ahead, block_of(k, zero, state), 0.0, None,
                )  # fmt: skip
                awake += int(after[3]) - int(state[MOVING + k])
                clamped[lane[k]] += after[7]
                put(k, after, model, state)
                if outcome == STABLE:
                    k += 1
                    continue
                outcomes[lane[k]] = outcome
                peaks[lane[k]] = state[PEAK + k]
                awake -= int(state[MOVING + k])
                lanes = leave(k, lanes, lane, state)
        if i % LOST_EVERY == 0:
            k = zero
            while k < lanes:
                if state[PHI + k] > model.slenderness and lost(
                    state[PHI + k], state[SPEED + k], state[STRONGEST + k], model
                ):
                    outcomes[lane[k]] = COLLAPSED
                    peaks[lane[k]] = state[PEAK + k]
                    awake -= int(state[MOVING + k])
                    lanes = leave(k, lanes, lane, state)
                else:
                    k += 1
        if i % LOOK_EVERY == 0 and stops:
            k = zero
            while k < lanes:
                push = abs(state[SCALE + k]) * left[i + 1]
                if settled(state[PHI + k], state[SPEED + k], state[PEAK + k], push, model):
                    outcomes[lane[k]] = STABLE
                    peaks[lane[k]] = state[PEAK + k]
                    awake -= int(state[MOVING + k])
                    lanes = leave(k, lanes, lane, state)
                else:
                    k += 1
        if lanes == 0:
            break
    for k in range(zero, lanes):
        outcomes[lane[k]], peaks[lane[k]] = at_end(block_of(k, zero, state), model)
    return clamped


@kernel
def scan_6(ground, dt, scales, model, outcomes, peaks):
    """`scan` by order 6: an order known to the compiler leaves the terms of the other out."""
    return scan(ground, dt, scales, model, 6, outcomes, peaks)


@kernel
def scan_8(ground, dt, scales, model, outcomes, peaks):
    """`scan` by order 8."""
    return scan(ground, dt, scales, model, 8, outcomes, peaks)


SCANS = {6: scan_6, 8: scan_8}


@kernel
def leave(k, lanes, lane, state):
    """Take lane k out: the last one takes its place. Returns how many are left."""
    lanes -= 1
    lane[k] = lane[lanes]
    for row in range(ROWS):
        state[WIDTH * row + k] = state[WIDTH * row + lanes]
    return lanes


@kernel
def block_of(k, zero, state):
    """State of one lane as `taylor.through_sample` takes it; nothing is counted yet, zero : of int64."""
    moving = state[MOVING + k] != 0.0
    zone = int(state[ZONE + k])
    return (
        state[SIDE + k], state[PHI + k], state[SPEED + k], moving, zone, state[PEAK + k], zero, zero
    )  # fmt: skip


@kernel
def put(k, block, model, state):
    """Write this state into lane k, and the branch of the moment law it is on."""
    side, phi, speed, moving, zone, peak, _, _ = block
    state[SIDE + k] = side
    state[PHI + k] = phi
    state[SPEED + k] = speed
    state[MOVING + k] = 1.0 if moving else 0.0
    state[PEAK + k] = peak
    state[ZONE + k] = zone
    low, high, factor, slope, constant = moment_branch(zone, model)
    state[LOW + k] = low
    state[HIGH + k] = high
    state[FACTOR + k] = factor
    state[SLOPE + k] = slope
    state[CONSTANT + k] = constant
