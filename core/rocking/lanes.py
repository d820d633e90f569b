"""Many multipliers of one record in lockstep: the plain step of the Taylor series on all lanes at once.

A loop without branches over contiguous lanes, which the compiler turns into vector instructions. A lane
whose step is not plain (near uplift, impact, a kink or a new peak, a series not converged) goes through
the sample by `taylor.through_sample` instead, so that results equal those of single analyses bit for bit.
Samples in which every lane rests are skipped; lanes that have collapsed or settled leave.
"""

import numpy as np

from core.kernel_cache import kernel, subkernel, widest_vectors
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
    ahead_of,
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


@subkernel
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


def pass_by(order):
    """The kernel of one pass by order 6 or 8, which the compiler is to know: it leaves other terms out."""

    @kernel
    def one_pass(ground, dt, scales, model, ahead, lane, state, outcomes, peaks, clamped):
        """Analyses of one record at up to WIDTH multipliers.

        ahead : of `look_ahead`; lane, state : room to work, int64 of shape (WIDTH,) and zeros of shape
        (ROWS * WIDTH,); the rest as `core.rocking.scan`.
        """
        constants = upright(model)
        threshold = constants[0]
        lowest = -np.inf if model.one_sided != 0.0 else -threshold
        zero = np.int64(0)  # a plain 0 would be a type of its own, and compile everything again
        lanes = scales.size
        each = lanes == 0  # nor is this a plain False
        start = (1.0, 0.0, 0.0, each, zone_of(0.0, model), 0.0, zero, zero)
        strongest = 0.0
        for u in ground:
            strongest = max(strongest, abs(u))
        up = 0.0
        down = 0.0
        for k in range(lanes):
            lane[k] = k
            state[SCALE + k] = scales[k]
            state[STRONGEST + k] = abs(scales[k]) * strongest * PER_G
            put(k, start, model, state)
            up = max(up, scales[k])
            down = min(down, scales[k])
        awake = 0
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
                    scale = state[SCALE + k]
                    outcome, _, _, after = through_sample(
                        scale * ground0, scale * ground1, dt, model, constants, order,
                        state[STRONGEST + k], ahead_of(ahead, i, scale), block_of(k, zero, state),
                        0.0, each,
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
                # Eq. 7 counts clamped ratios to the end of the record
                look = i % LOOK_EVERY == 0 and model.ratio_drop == 0.0
                k = zero
                while k < lanes:
                    x, speed, peak = state[PHI + k], state[SPEED + k], state[PEAK + k]
                    push = abs(state[SCALE + k]) * ahead[3, i + 1]
                    falls = x > model.slenderness and lost(x, speed, state[STRONGEST + k], model)
                    if falls or (look and settled(x, speed, peak, push, model)):
                        outcomes[lane[k]] = COLLAPSED if falls else STABLE
                        peaks[lane[k]] = peak
                        awake -= int(state[MOVING + k])
                        lanes = leave(k, lanes, lane, state)
                    else:
                        k += 1
            if lanes == 0:
                break
        for k in range(zero, lanes):
            outcomes[lane[k]], peaks[lane[k]] = at_end(block_of(k, zero, state), model)

    return one_pass


PASS = {order: pass_by(order) for order in (6, 8)}


def scan(order, ground, dt, scales, model, outcomes, peaks, ahead):
    """`core.rocking.scan` by order 6 or 8, in passes of WIDTH lanes. Outcomes and the peaks of what stays up
    are those of whole histories, bit for bit; the peak of a block that falls is where it was given up.
    (Peaks below 1e-12 rad of chatter that outlives the record can differ by the rounding of an arccosine.)
    """
    clamped = np.zeros(scales.size, np.int64)
    for k in range(0, scales.size, WIDTH):
        part = slice(k, k + WIDTH)
        lane, state = np.zeros(WIDTH, np.int64), np.zeros(ROWS * WIDTH)
        PASS[order](
            ground, dt, scales[part], model, ahead, lane, state, outcomes[part], peaks[part],
            clamped[part],
        )  # fmt: skip
    return clamped


@subkernel
def leave(k, lanes, lane, state):
    """Take lane k out: the last one takes its place. Returns how many are left."""
    lanes -= 1
    lane[k] = lane[lanes]
    for row in range(ROWS):
        state[WIDTH * row + k] = state[WIDTH * row + lanes]
    return lanes


@subkernel
def block_of(k, zero, state):
    """State of one lane as `taylor.through_sample` takes it; nothing is counted yet, zero : of int64."""
    moving = state[MOVING + k] != 0.0
    zone = int(state[ZONE + k])
    return (
        state[SIDE + k], state[PHI + k], state[SPEED + k], moving, zone, state[PEAK + k], zero, zero
    )  # fmt: skip


@subkernel
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
