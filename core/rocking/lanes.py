"""The lanes of one pass: their state, and what all of them do at once.

Two loops without branches over contiguous lanes, which the compiler turns into vector instructions: the
step of the Taylor series to the end of each lane's sample, and the landing of the lanes that fall in it.
A lane whose step is not that plain (a kink, a new peak, a series not converged, an outward pull while it
falls) takes it by `taylor.through_sample`, so that results equal those of single analyses bit for bit.
"""

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
    PER_G,
    SHORT,
    may_top,
    series,
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
FALL = ROW * 30
PLAIN = FALL + ROW * FALL_ROWS
"""Whether such a fall is that plain."""
ROWS = 30 + FALL_ROWS + 1

STEPPED, LOOKED, FALLS, ALONE = 0.0, 1.0, 2.0, 3.0
"""NEXT of a lane: through its sample; so and to be looked at; to land in it; to be taken through it alone."""

VECTOR = 8
"""Lanes are stepped in multiples of this, so that no remainder is left to single steps; those beyond the
last lane hold old states and are not looked at."""


@subkernel
def plain_steps(lanes, dt, model, constants, order, state):
    """One step of each lane to the end of its sample, where that is all there is to it, and NEXT of each."""
    widest_vectors()
    _, tangent, sine_upright, cosine_upright = constants
    tolerance = SERIES_TOLERANCE * model.slenderness
    per_dt = 1.0 / dt
    for k in range((lanes + VECTOR - 1) // VECTOR * VECTOR):
        first = state[FIRST + k]
        second = state[SCALE + k] * state[SECOND + k]
        left = state[LEFT + k] - 1.0
        t = state[TIME + k]
        per_step = state[PER_STEP + k]
        x = state[PHI + k]
        speed = state[SPEED + k]
        factor = state[FACTOR + k]
        slope = state[SLOPE + k]
        low = state[LOW + k]
        peak = state[PEAK + k]
        rest_of_sample = 1.0 - t
        step = dt * rest_of_sample
        p2 = model.p2 * (step * step)
        pull = state[SIDE + k] * PER_G
        jump = second - first
        beta = pull * (first + jump * t)
        rise = pull * jump * rest_of_sample
        forcing = max(abs(first), abs(second)) * PER_G
        s, c = sine_and_cosine_short(x)
        sine = sine_upright * c - cosine_upright * s
        cosine = cosine_upright * c + sine_upright * s
        net = cosine_upright * (factor * tangent - beta) * c
        net = net - (factor * cosine_upright + beta * sine_upright) * s
        net = net + (slope * x + state[CONSTANT + k])
        v = series(speed * step, net, sine, cosine, beta, rise, p2, factor, slope, order)
        lifted = (x == 0.0) & (speed == 0.0)
        v1 = max(v[1], 0.0) if lifted else v[1]
        v = (v[0], v1, v[2], v[3], v[4], v[5], v[6], v[7], v[8])
        dphi = increment(v, 1.0)
        dv = change(v, 1.0)
        y = x + dphi
        growth = p2 * (1.0 + forcing + slope) + v[0] * v[0]
        upper = max(x, y)
        push = largest_push(upper, forcing, p2, sine_upright)
        reach = 0.125 * push
        margin = turning_margin(v[0], dv, rise, forcing + slope, p2, push)
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
        state[FIRST + k] = first if stays else second
        state[PHI + k] = x if stays else y
        state[SPEED + k] = speed if stays else speed + dv * per_step
        state[PEAK + k] = peak if stays else max(peak, y)
        state[TIME + k] = t if stays else 0.0
        state[PER_STEP + k] = per_step if stays else per_dt
        state[IMPACTS + k] = state[IMPACTS + k] if stays else 0.0
        state[SERIES + k] = v[0]
        state[SERIES + ROW + k] = v[1]
        state[SERIES + 2 * ROW + k] = v[2]
        state[SERIES + 3 * ROW + k] = v[3]
        state[SERIES + 4 * ROW + k] = v[4]
        state[SERIES + 5 * ROW + k] = v[5]
        state[SERIES + 6 * ROW + k] = v[6]
        if order == 8:
            state[SERIES + 7 * ROW + k] = v[7]
            state[SERIES + 8 * ROW + k] = v[8]


@subkernel
def landings(falling, dt, model, rest_below, order, state):
    """The impact of each lane that falls: time in the sample, speed after it, and whether it is that plain.

    rest_below : [rad/s], see `events.stops_rocking`.
    """
    widest_vectors()
    shift = FALL - PHI
    for j in range((falling + VECTOR - 1) // VECTOR * VECTOR):
        k = shift + j
        v = (
            state[SERIES + k], state[SERIES + ROW + k], state[SERIES + 2 * ROW + k],
            state[SERIES + 3 * ROW + k], state[SERIES + 4 * ROW + k],
            state[SERIES + 5 * ROW + k], state[SERIES + 6 * ROW + k],
            state[SERIES + 7 * ROW + k] if order == 8 else 0.0,
            state[SERIES + 8 * ROW + k] if order == 8 else 0.0,
        )  # fmt: skip
        t = state[TIME + k]
        part, top, found = landing(v, state[PHI + k], 1.0)
        speed = state[SPEED + k] + change(v, part) * state[PER_STEP + k]
        arriving = max(-speed, 0.0)
        ratio = max(model.ratio_at_rest - model.ratio_drop * arriving * arriving, 0.0)
        speed = ratio * arriving
        t = t + part * (1.0 - t)
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
