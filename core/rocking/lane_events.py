"""Operations on single lanes between two steps of all: impacts gathered and scattered, and the scalar step.

A lane whose step is not plain (a kink, a new peak, an impact that was not located) takes one step by the functions of
single histories, from the rows of the vector loops where they hold its series.
"""

from core.jit.decorators import inner_kernel
from core.rocking.early_stop import cannot_recover
from core.rocking.events import IMPACTS_PER_SAMPLE, BlockState, next_uplift, uplift_side
from core.rocking.lane_state import (
    BETA,
    CONSTANT,
    COSINE,
    FACTOR,
    FALL,
    FALL_ROWS,
    FALLS,
    FIRST,
    FORCING,
    HELD,
    HIGH,
    IMPACTS,
    KINK_SAMPLE,
    KINKS,
    LONG,
    LOW,
    MOVING,
    NET,
    NEXT,
    NOT_LOCATED,
    PART,
    PEAK,
    PER_STEP,
    PHI,
    PLAIN,
    RESTS,
    RISE,
    ROW,
    SAMPLE,
    SCALE,
    SECOND,
    SIDE,
    SINE,
    SLOPE,
    SPEED,
    STEP_P2,
    STRONGEST,
    TIME,
    ZONE,
    set_lane,
)
from core.rocking.lanes import series_of
from core.rocking.oscillator import branches_apart
from core.rocking.outcome import COLLAPSED, IMPACT_LIMIT, STABLE
from core.rocking.short_series import SHORT_SERIES
from core.rocking.taylor import advance, converged_step, cross_kink, first_event, impact
from core.rocking.taylor_series import InitialTerms, constants_seen
from core.wall.moment_rotation import moment_branch, zone_of
from core.wall.rocking_model import seen_from, sides_differ


@inner_kernel
def gather_falling(count, busy, state):
    """Copy the lanes that fall to where they lie side by side, their side to PLAIN. busy : numbers of `count` lanes,
    all that fall among them; returns how many do."""
    falling = 0
    for j in range(count):
        k = busy[j]
        if state[NEXT + k] == FALLS:
            for row in range(FALL_ROWS):
                state[FALL + ROW * row + falling] = state[PHI + ROW * row + k]
            state[PLAIN + falling] = state[SIDE + k]
            falling += 1
    return falling


@inner_kernel
def scatter_impact(k, j, dt, model, thresholds, state):
    """Take over the impact of lane k from the j-th of the falls; False if it was not located.

    k, j : lane, place among the falls
    dt : the sample [s]
    model : RockingModel
    thresholds : of `uplift_thresholds` [m/s2]
    state : of lane_state.py, shape (ROWS * ROW,)
    """
    after = state[PLAIN + j]
    if after == NOT_LOCATED:
        return False
    t = state[FALL - PHI + TIME + j]
    if after == RESTS:
        ground0 = state[FIRST + k]
        jump = state[SCALE + k] * state[SECOND + k] - ground0
        if uplift_side(ground0 + jump * t, thresholds) != 0.0:
            return False
        state[IMPACTS + k] += 1.0
        side = state[SIDE + k] if model.one_sided != 0.0 else -state[SIDE + k]
        set_lane(k, side, 0.0, 0.0, zone_of(0.0, model), model, state)
        state[MOVING + k] = 0.0
        uplift(k, ground0, jump, t, dt, model, thresholds, state)
        return True
    state[PHI + k] = 0.0
    state[SPEED + k] = state[FALL - PHI + SPEED + j]
    state[TIME + k] = t
    state[PER_STEP + k] = state[FALL - PHI + PER_STEP + j]
    state[IMPACTS + k] += 1.0
    state[KINKS + k] = 0.0
    if model.one_sided == 0.0:
        side = -state[SIDE + k]
        state[SIDE + k] = side
        if sides_differ(model):
            set_lane(k, side, 0.0, state[SPEED + k], zone_of(0.0, model), model, state)
    return True


@inner_kernel
def uplift(k, ground0, jump, t, dt, model, thresholds, state):
    """Set the resting lane k where the ground uplifts it in its sample, or to the end of the sample.

    k : lane
    ground0, jump : ground acceleration at the start of the sample, and its change over it [m/s2]
    t : where in the sample it rests, 0 to 1
    dt : the sample [s]
    model : RockingModel
    thresholds : of `uplift_thresholds` [m/s2]
    state : of lane_state.py, shape (ROWS * ROW,)
    """
    t, side = next_uplift(ground0, jump, t, 1.0, thresholds)
    state[TIME + k] = t
    if t < 1.0:
        set_lane(k, side, 0.0, 0.0, zone_of(0.0, model), model, state)
        state[PER_STEP + k] = 1.0 / (dt * (1.0 - t))


@inner_kernel
def step_of_lane(k, dt, model, constants, order, block, state):
    """`taylor.converged_step` of lane k, from the rows of the vector loops where they hold it.

    k : lane
    dt : the sample [s]
    model : RockingModel
    constants : WallConstants
    order : of the series, 6 or 8
    block : BlockState of the lane
    state : of lane_state.py, shape (ROWS * ROW,)
    """
    v = series_of(k, order, state)
    start = InitialTerms(
        v[0],
        state[NET + k],
        state[SINE + k],
        state[COSINE + k],
        state[BETA + k],
        state[RISE + k],
        state[STEP_P2 + k],
        state[FORCING + k],
    )
    part = state[PART + k]
    if state[NEXT + k] == LONG or block.phi > SHORT_SERIES:
        seen, own = seen_from(model, block.side), constants_seen(constants, constants.other, block.side)
        branch = moment_branch(block.zone, seen)
        first, second = state[FIRST + k], state[SCALE + k] * state[SECOND + k]
        v, start, part = converged_step(block, first, second, state[TIME + k], dt, branch, seen, own, order)
    return v, start, part


@inner_kernel
def scalar_step(k, dt, model, constants, order, zero, state):
    """Carry lane k through one step, as `taylor.through_sample` would. Returns (outcome so far, clamped ratios).

    k : lane
    dt : the sample [s]
    model : RockingModel
    constants : WallConstants
    order : of the series, 6 or 8
    zero : of int64
    state : of lane_state.py, shape (ROWS * ROW,)
    """
    ground0, t = state[FIRST + k], state[TIME + k]
    jump = state[SCALE + k] * state[SECOND + k] - ground0
    if state[MOVING + k] == 0.0:
        uplift(k, ground0, jump, t, dt, model, constants.thresholds, state)
        return STABLE, zero
    block = BlockState(
        state[SIDE + k], state[PHI + k], state[SPEED + k], True, int(state[ZONE + k]), state[PEAK + k], zero, zero
    )
    v, start, part = step_of_lane(k, dt, model, constants, order, block, state)
    branch = (
        state[LOW + k],
        state[HIGH + k],
        state[FACTOR + k],
        state[SLOPE + k],
        state[CONSTANT + k],
        state[HELD + k],
    )
    own = constants_seen(constants, constants.other, block.side)
    event = first_event(v, start, block.phi, branch, own)
    block, t = advance(block, v, part, event, t, dt)
    outcome = STABLE
    if event.crossing < 0.0:
        if block.phi > SHORT_SERIES and cannot_recover(
            block.phi, block.speed, state[STRONGEST + k], seen_from(model, block.side)
        ):
            outcome = COLLAPSED
    elif event.falls and state[LOW + k] == 0.0:
        block, _ = impact(block, ground0 + jump * t, seen_from(model, block.side), constants)
        state[IMPACTS + k] += 1.0
        state[KINKS + k] = 0.0
    else:
        block = cross_kink(block, event, branch, branches_apart(model.driven))
        kinks = state[KINKS + k] if state[KINK_SAMPLE + k] == state[SAMPLE + k] else 0.0
        state[KINKS + k] = kinks + 1.0
        state[KINK_SAMPLE + k] = state[SAMPLE + k]
        if kinks + 1.0 > IMPACTS_PER_SAMPLE:
            outcome = IMPACT_LIMIT
    if event.crossing >= 0.0:
        set_lane(k, block.side, block.phi, block.speed, block.zone, model, state)
        state[MOVING + k] = 1.0 if block.moving else 0.0
    state[PHI + k] = block.phi
    state[SPEED + k] = block.speed
    state[PEAK + k] = block.peak
    state[TIME + k] = t
    if t < 1.0:
        state[PER_STEP + k] = 1.0 / (dt * (1.0 - t))
    return outcome, block.clamped
