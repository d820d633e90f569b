"""The lanes of one pass: their state, and what all of them do at once.

Loops without branches over contiguous lanes, which the compiler turns into vector instructions: what the step
to the end of each lane's sample begins with, its Taylor series, what comes of it, and the landing of the lanes
that fall in it.
A lane whose step is not that plain (a kink, a new peak, a series not converged, an outward pull while it
falls) takes it by `taylor.through_sample`, so that results equal those of single analyses bit for bit.
"""

from core.fused import fma
from core.kernel_cache import inner_kernel, subkernel, widest_vectors
from core.moment_rotation import moment_branch
from core.rocking.bounds import (
    SERIES_TOLERANCE,
    STIFFEST,
    largest_push,
    neglected,
    turning_margin,
)
from core.rocking.polynomial import change, increment, landing, shape
from core.rocking.taylor import (
    SHORT,
    expansion,
    may_top,
    set_out,
    sine_and_cosine_short,
    through_sample,
)

WIDTH = 64
"""Lanes of one pass. Their state is one array of rows: the compiler then sees that the rows do not overlap,
which it needs to use vector instructions."""

ROW = WIDTH + 8
"""Length of a row: of 64, each eighth row would take the same place in the processor's tables."""

(
    SCALE,
    STRONGEST,
    FIRST,
    SECOND,
    SIDE,
    MOVING,
    IMPACTS,
    ZONE,
    LOW,
    HIGH,
    FACTOR,
    SLOPE,
    CONSTANT,
    NEXT,
    SAMPLE,
    LEFT,
    PHI,
    SPEED,
    TIME,
    PER_STEP,
    PEAK,
    SERIES,
) = (ROW * row for row in range(22))
"""FIRST, SECOND : ground acceleration at the ends of the sample, the first one scaled; TIME : where in it the
lane is, 0 to 1; PER_STEP : one over the time to its end [1/s]; IMPACTS : in this sample; NEXT : below; LEFT :
samples until it is to be looked at; SERIES : v0 to v8."""
LANE_ROWS = 21
FALL_ROWS = 14
"""From PHI to v8: what lanes that fall are copied with to where they lie side by side, from FALL on."""
NET, SINE, COSINE, BETA, RISE, STEP_P2, FORCING, GROWTH = (
    SERIES + ROW * row for row in range(9, 17)
)
"""Of `taylor.set_out` and `taylor.expansion`."""

FALL = GROWTH + ROW
PLAIN = FALL + ROW * FALL_ROWS
"""Whether such a fall is that plain."""
ROWS = PLAIN // ROW + 1

STEPPED, LOOKED, FALLS, ALONE = 0.0, 1.0, 2.0, 3.0
"""NEXT of a lane: through its sample; so and to be looked at; to land in it; to be taken through it alone."""

VECTOR = 8
"""Lanes are stepped in multiples of this, so that no remainder is left to single steps; those beyond the
last lane hold old states and are not looked at."""


@subkernel
def settings_out(lanes, dt, model, constants, state):
    """What the series of each lane to the end of its sample begins with."""
    widest_vectors()
    for k in range((lanes + VECTOR - 1) // VECTOR * VECTOR):
        second = state[SCALE + k] * state[SECOND + k]
        x = state[PHI + k]
        s, c = sine_and_cosine_short(x)
        branch = state[FACTOR + k], state[SLOPE + k], state[CONSTANT + k]
        begun = set_out(
            x, state[SPEED + k], s, c, state[SIDE + k], state[FIRST + k], second, state[TIME + k], dt,
            branch, model, constants,
        )  # fmt: skip
        state[SERIES + k] = begun[0]
        state[NET + k] = begun[1]
        state[SINE + k] = begun[2]
        state[COSINE + k] = begun[3]
        state[BETA + k] = begun[4]
        state[RISE + k] = begun[5]
        state[STEP_P2 + k] = begun[6]
        state[FORCING + k] = begun[7]


@subkernel
def expansions(lanes, order, state):
    """The series of each lane from there."""
    widest_vectors()
    for k in range((lanes + VECTOR - 1) // VECTOR * VECTOR):
        begun = (
            state[SERIES + k], state[NET + k], state[SINE + k], state[COSINE + k], state[BETA + k],
            state[RISE + k], state[STEP_P2 + k], state[FORCING + k],
        )  # fmt: skip
        v, growth = expansion(state[PHI + k], begun, state[FACTOR + k], state[SLOPE + k], order)
        state[SERIES + ROW + k] = v[1]
        state[SERIES + 2 * ROW + k] = v[2]
        state[SERIES + 3 * ROW + k] = v[3]
        state[SERIES + 4 * ROW + k] = v[4]
        state[SERIES + 5 * ROW + k] = v[5]
        state[SERIES + 6 * ROW + k] = v[6]
        if order == 8:
            state[SERIES + 7 * ROW + k] = v[7]
            state[SERIES + 8 * ROW + k] = v[8]
        state[GROWTH + k] = growth


@inner_kernel
def series_of(k, order, state):
    """v0 to v8 of the k-th lane or fall."""
    return (
        state[SERIES + k], state[SERIES + ROW + k], state[SERIES + 2 * ROW + k],
        state[SERIES + 3 * ROW + k], state[SERIES + 4 * ROW + k], state[SERIES + 5 * ROW + k],
        state[SERIES + 6 * ROW + k],
        state[SERIES + 7 * ROW + k] if order == 8 else 0.0,
        state[SERIES + 8 * ROW + k] if order == 8 else 0.0,
    )  # fmt: skip


@subkernel
def plain_steps(lanes, dt, model, constants, order, state):
    """One step of each lane to the end of its sample by its series, where that is all there is to it, and NEXT
    of each. (Three loops: in one the processor waits for the results of each lane.)
    """
    widest_vectors()
    sine_upright = constants[2]
    tolerance = SERIES_TOLERANCE * model.slenderness
    per_dt = 1.0 / dt
    for k in range((lanes + VECTOR - 1) // VECTOR * VECTOR):
        v = series_of(k, order, state)
        p2, rise = state[STEP_P2 + k], state[RISE + k]
        forcing, growth = state[FORCING + k], state[GROWTH + k]
        x, low, peak = state[PHI + k], state[LOW + k], state[PEAK + k]
        speed, per_step = state[SPEED + k], state[PER_STEP + k]
        left = state[LEFT + k] - 1.0
        dphi = increment(v, 1.0)
        dv = change(v, 1.0)
        y = x + dphi
        upper = max(x, y)
        push = largest_push(upper, forcing, p2, sine_upright)
        reach = 0.125 * push
        margin = turning_margin(v[0], dv, rise, forcing + state[SLOPE + k], p2, push)
        after = v[0] + dv
        bend, bulges, stays = shape(v, x - low, dphi, dv, 1.0)
        near = (min(x, y) - low <= reach) & (min(v[0], after) <= margin)
        falls = near & (not stays)
        tops = (v[0] > -2.0 * margin) & (after < 2.0 * margin) & (not bulges)
        alone = (
            ((state[HIGH + k] - upper <= reach) & (max(v[0], after) >= -margin))
            | (upper > SHORT)
            | (neglected(v, growth, forcing, rise, p2, order) > tolerance)
            | (growth >= STIFFEST)
            | (falls & (low != 0.0))
            | (state[MOVING + k] == 0.0)
            | ((not falls) & tops & may_top(x, dphi, v[0], bend, reach, peak))
        )
        stays = alone | falls
        looked = (y > model.slenderness) | (left <= 0.0)
        state[NEXT + k] = ALONE if alone else (FALLS if falls else (LOOKED if looked else STEPPED))
        state[SAMPLE + k] += 0.0 if stays else 1.0
        state[LEFT + k] = left + 1.0 if stays else left
        state[FIRST + k] = state[FIRST + k] if stays else state[SCALE + k] * state[SECOND + k]
        state[PHI + k] = x if stays else y
        state[SPEED + k] = speed if stays else fma(dv, per_step, speed)
        state[PEAK + k] = peak if stays else max(peak, y)
        state[TIME + k] = state[TIME + k] if stays else 0.0
        state[PER_STEP + k] = per_step if stays else per_dt
        state[IMPACTS + k] = state[IMPACTS + k] if stays else 0.0


@subkernel
def landings(falling, dt, model, rest_below, order, state):
    """The impact of each lane that falls: time in the sample, speed after it, and whether it is that plain.

    rest_below : [rad/s], see `events.stops_rocking`.
    """
    widest_vectors()
    shift = FALL - PHI
    for j in range((falling + VECTOR - 1) // VECTOR * VECTOR):
        k = shift + j
        v = series_of(k, order, state)
        t = state[TIME + k]
        part, top, found = landing(v, state[PHI + k], 1.0)
        speed = fma(change(v, part), state[PER_STEP + k], state[SPEED + k])
        arriving = max(-speed, 0.0)
        ratio = max(model.ratio_at_rest - model.ratio_drop * arriving * arriving, 0.0)
        speed = ratio * arriving
        t = fma(part, 1.0 - t, t)
        plain = found & (top <= state[PEAK + k]) & (part < 1.0) & (t < 1.0) & (speed >= rest_below)
        state[PLAIN + j] = 1.0 if plain else 0.0
        state[SPEED + k] = speed
        state[TIME + k] = t
        state[PER_STEP + k] = 1.0 / (dt * (1.0 - t))


@inner_kernel
def fallen(count, busy, state):
    """Copy the lanes that fall to where they lie side by side. busy : numbers of `count` lanes, all that
    fall among them; returns how many do."""
    falling = 0
    for j in range(count):
        k = busy[j]
        if state[NEXT + k] == FALLS:
            for row in range(FALL_ROWS):
                state[FALL + ROW * row + falling] = state[PHI + ROW * row + k]
            falling += 1
    return falling


@inner_kernel
def landed(k, j, model, state):
    """Take over the impact of lane k from the j-th of the falls; False if it is not that plain."""
    if state[PLAIN + j] == 0.0:
        return False
    state[PHI + k] = 0.0
    state[SPEED + k] = state[FALL - PHI + SPEED + j]
    state[TIME + k] = state[FALL - PHI + TIME + j]
    state[PER_STEP + k] = state[FALL - PHI + PER_STEP + j]
    state[IMPACTS + k] += 1.0
    if model.one_sided == 0.0:
        state[SIDE + k] = -state[SIDE + k]
    return True


@inner_kernel
def alone(k, dt, model, constants, order, zero, state):
    """Carry lane k to its next impact or through its sample. zero : of int64. Returns (outcome so far,
    clamped ratios)."""
    block = (
        state[SIDE + k], state[PHI + k], state[SPEED + k], state[MOVING + k] != 0.0,
        int(state[ZONE + k]), state[PEAK + k], zero, zero,
    )  # fmt: skip
    outcome, time, _, block = through_sample(
        state[FIRST + k], state[SCALE + k] * state[SECOND + k], dt, model, constants, order,
        state[STRONGEST + k], block, state[TIME + k],
    )  # fmt: skip
    side, phi, speed, moving, zone, peak, impacts, clamped = block
    put(k, side, phi, speed, zone, model, state)
    state[MOVING + k] = 1.0 if moving else 0.0
    state[PEAK + k] = peak
    state[IMPACTS + k] += impacts
    state[TIME + k] = time
    if time < 1.0:
        state[PER_STEP + k] = 1.0 / (dt * (1.0 - time))
    return outcome, clamped


@inner_kernel
def put(k, side, phi, speed, zone, model, state):
    """Lane k moves so, on this branch of the moment law."""
    state[SIDE + k] = side
    state[PHI + k] = phi
    state[SPEED + k] = speed
    state[MOVING + k] = 1.0
    state[ZONE + k] = zone
    low, high, factor, slope, constant = moment_branch(zone, model)
    state[LOW + k] = low
    state[HIGH + k] = high
    state[FACTOR + k] = factor
    state[SLOPE + k] = slope
    state[CONSTANT + k] = constant
