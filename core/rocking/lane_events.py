"""Operations on single lanes between two steps of all: impacts gathered and scattered, and the scalar step.

A lane whose step is not plain (a kink, a new peak, an impact that was not located) takes one step by the functions of
single histories, from the rows of the vector loops where they hold its series.
"""

from core.jit.decorators import inner_kernel
from core.rocking.bar_state import cross_kinks
from core.rocking.early_stop import cannot_recover
from core.rocking.events import IMPACTS_PER_SAMPLE, BlockState, next_uplift, uplift_side
from core.rocking.lane_state import (
    ACTION,
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
    NOT_LOCATED,
    PART,
    PEAK,
    PER_STEP,
    PHI,
    RESTS,
    RISE,
    RISES,
    ROW,
    SAMPLE,
    SCALAR,
    SCALE,
    SCRATCH,
    SECOND,
    SERIES,
    SIDE,
    SINE,
    SINKS,
    SLOPE,
    SPEED,
    STEP_P2,
    STRONGEST,
    TIME,
    YIELDS,
    ZONE,
    lane_thresholds,
    set_lane,
    set_pull,
)
from core.rocking.lanes import series_of
from core.rocking.oscillator import branch_stride
from core.rocking.outcome import COLLAPSED, IMPACT_LIMIT, STABLE
from core.rocking.series_with_bars import bounds_held
from core.rocking.short_series import SHORT_SERIES
from core.rocking.taylor import advance, converged_step, cross_kink, first_event, impact
from core.rocking.taylor_series import InitialTerms, constants_seen
from core.rocking.taylor_with_bars import AT_IMPACT, AT_KINK, ON, cannot_recover_with_bars, end_of_step
from core.wall.moment_rotation import NEVER_REACHED, zone_of
from core.wall.rocking_model import seen_from, sides_differ


@inner_kernel
def gather_falling(count, busy, bars, state):
    """Copy the lanes that fall to where they lie side by side, their side to PLAIN, and those that come to an end of a
    branch of their bars, 0.0 to PLAIN.

    count, busy : numbers of `count` lanes, all that fall among them
    bars : rows of the bars, or None
    state : of lane_state.py, shape (ROWS * ROW,)
    Returns how many fall.
    """
    falling = 0
    for j in range(count):
        k = busy[j]
        kind = state[ACTION + k]
        if FALLS <= kind < SCALAR:
            for row in range(FALL_ROWS):
                state[FALL + ROW * row + falling] = state[PHI + ROW * row + k]
            state[SCRATCH + falling] = state[SIDE + k]
            if bars is not None and kind != FALLS:
                fall_to_end(k, falling, kind == RISES, state)
            falling += 1
    return falling


@inner_kernel
def fall_to_end(k, j, rises, state):
    """Let the j-th of the falls be lane k on its way to an end of a branch of its bars, the upper one upside down:
    there it comes to zero. rises : whether to the upper one"""
    end, shift = state[(HIGH if rises else LOW) + k], FALL - PHI
    state[SCRATCH + j] = 0.0
    state[shift + PEAK + j] = NEVER_REACHED
    state[shift + PHI + j] = end - state[PHI + k] if rises else state[PHI + k] - end
    if rises:
        state[shift + SPEED + j] = -state[SPEED + k]
        for row in range(9):
            state[shift + SERIES + ROW * row + j] = -state[SERIES + ROW * row + k]


@inner_kernel
def scatter_end(k, j, bars, held, state):
    """Carry lane k beyond the end of a branch of its bars that it came to as the j-th of the falls; False if it was not
    located. Arguments as `scatter_impact`; bars not None."""
    kinks = state[KINKS + k] if state[KINK_SAMPLE + k] == state[SAMPLE + k] else 0.0
    if state[SCRATCH + j] == NOT_LOCATED or kinks >= IMPACTS_PER_SAMPLE:
        return False
    falls, shift = state[ACTION + k] == SINKS, FALL - PHI
    phi = state[(LOW if falls else HIGH) + k]
    cross_kinks(phi, falls, bars, held[k])
    set_pull(k, bars, held, state)
    state[PHI + k] = phi
    state[SPEED + k] = -state[shift + SPEED + j] if falls else state[shift + SPEED + j]
    state[TIME + k] = state[shift + TIME + j]
    state[PER_STEP + k] = state[shift + PER_STEP + j]
    state[PEAK + k] = max(state[PEAK + k], phi)
    state[KINKS + k] = kinks + 1.0
    state[KINK_SAMPLE + k] = state[SAMPLE + k]
    return True


@inner_kernel
def scatter_impact(k, j, dt, model, constants, bars, held, state):
    """Take over the impact of lane k from the j-th of the falls; False if it was not located.

    k, j : lane, place among the falls
    dt : the sample [s]
    model : RockingModel
    constants : WallConstants
    bars, held : rows of the bars and their state in all lanes, or None
    state : of lane_state.py, shape (ROWS * ROW,)
    """
    if bars is not None and state[ACTION + k] != FALLS:
        return scatter_end(k, j, bars, held, state)
    after = state[SCRATCH + j]
    if after == NOT_LOCATED:
        return False
    t = state[FALL - PHI + TIME + j]
    if after == RESTS:
        ground0 = state[FIRST + k]
        jump = state[SCALE + k] * state[SECOND + k] - ground0
        if uplift_side(ground0 + jump * t, lane_thresholds(k, constants, bars, held)) != 0.0:
            return False
        state[IMPACTS + k] += 1.0
        side = state[SIDE + k] if model.one_sided != 0.0 else -state[SIDE + k]
        set_lane(k, side, 0.0, 0.0, zone_of(0.0, model), model, state)
        state[MOVING + k] = 0.0
        uplift(k, ground0, jump, t, dt, model, constants, bars, held, state)
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
        set_pull(k, bars, held, state)
    return True


@inner_kernel
def uplift(k, ground0, jump, t, dt, model, constants, bars, held, state):
    """Set the resting lane k where the ground uplifts it in its sample, or to the end of the sample.

    k : lane
    ground0, jump : ground acceleration at the start of the sample, and its change over it [m/s2]
    t : where in the sample it rests, 0 to 1
    dt : the sample [s]
    model : RockingModel
    constants : WallConstants
    bars, held : rows of the bars and their state in all lanes, or None
    state : of lane_state.py, shape (ROWS * ROW,)
    """
    t, side = next_uplift(ground0, jump, t, 1.0, lane_thresholds(k, constants, bars, held))
    state[TIME + k] = t
    if t < 1.0:
        set_lane(k, side, 0.0, 0.0, zone_of(0.0, model), model, state)
        set_pull(k, bars, held, state)
        state[PER_STEP + k] = 1.0 / (dt * (1.0 - t))


@inner_kernel
def step_of_lane(k, dt, seen, constants, order, block, branch, bars, state):
    """`taylor.converged_step` of lane k, from the rows of the vector loops where they hold it.

    k : lane
    dt : the sample [s]
    seen : RockingModel as the pivot sees it
    constants : WallConstants as the pivot sees them, with bars of `bounds_held`
    order : of the series, 6 or 8
    block : BlockState of the lane
    branch : of the lane
    bars : rows of the bars, or None
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
    if state[ACTION + k] == LONG or block.phi > SHORT_SERIES:
        first, second = state[FIRST + k], state[SCALE + k] * state[SECOND + k]
        v, start, part = converged_step(block, first, second, state[TIME + k], dt, branch, seen, constants, order, bars)
    return v, start, part


@inner_kernel
def end_of_lane_step(k, block, v, start, part, t, dt, ground0, jump, branch, seen, constants, bars, held, state):
    """Carry lane k to the end of a step and through what happens there, as `taylor.through_sample`, or with bars
    `taylor_with_bars.end_of_step`, would.

    k : lane
    block : BlockState at t
    v, start, part : of `step_of_lane`
    t : where in the sample it is, 0 to 1
    dt : the sample [s]
    ground0, jump : ground acceleration at the start of the sample, and its change over it [m/s2]
    branch : of the lane
    seen : RockingModel as the pivot sees it
    constants : WallConstants as the pivot sees them, with bars of `bounds_held`
    bars, held : rows of the bars and their state in all lanes, or None
    state : of lane_state.py, shape (ROWS * ROW,)
    Returns (BlockState, t, ON, AT_IMPACT or AT_KINK).
    """
    if bars is not None:
        yields = state[YIELDS + k] != 0.0
        block, t, _, what = end_of_step(
            block, v, start, part, t, dt, ground0, jump, branch, yields, seen, constants, bars, held[k]
        )
        return block, t, what
    event = first_event(v, start, block.phi, branch, constants, None)
    block, t = advance(block, v, part, event, t, dt)
    if event.crossing < 0.0:
        return block, t, ON
    if event.falls and branch[0] == 0.0:
        block, _ = impact(block, ground0 + jump * t, seen, constants)
        return block, t, AT_IMPACT
    return cross_kink(block, event, branch, branch_stride(seen.driven)), t, AT_KINK


@inner_kernel
def falls_over(k, block, seen, bars, held, state):
    """Whether lane k, beyond SHORT_SERIES, surely overturns. block : BlockState; seen : RockingModel as the pivot sees
    it; bars, held, state : as `end_of_lane_step`"""
    if bars is not None:
        return cannot_recover_with_bars(block, state[STRONGEST + k], seen, held[k])
    return cannot_recover(block.phi, block.speed, state[STRONGEST + k], seen)


@inner_kernel
def scalar_step(k, dt, model, constants, order, zero, bars, held, state):
    """Carry lane k through one step, as `taylor.through_sample` would. Returns (outcome so far, clamped ratios).

    k : lane
    dt : the sample [s]
    model : RockingModel
    constants : WallConstants
    order : of the series, 6 or 8
    zero : of int64
    bars, held : rows of the bars and their state in all lanes, or None
    state : of lane_state.py, shape (ROWS * ROW,)
    """
    ground0, t = state[FIRST + k], state[TIME + k]
    jump = state[SCALE + k] * state[SECOND + k] - ground0
    if state[MOVING + k] == 0.0:
        uplift(k, ground0, jump, t, dt, model, constants, bars, held, state)
        return STABLE, zero
    block = BlockState(
        state[SIDE + k], state[PHI + k], state[SPEED + k], True, int(state[ZONE + k]), state[PEAK + k], zero, zero
    )
    branch = (
        state[LOW + k],
        state[HIGH + k],
        state[FACTOR + k],
        state[SLOPE + k],
        state[CONSTANT + k],
        state[HELD + k],
    )
    seen = seen_from(model, block.side)
    own = bounds_held(constants_seen(constants, constants.other, block.side), branch[2:], bars)
    v, start, part = step_of_lane(k, dt, seen, own, order, block, branch, bars, state)
    block, t, what = end_of_lane_step(
        k, block, v, start, part, t, dt, ground0, jump, branch, seen, own, bars, held, state
    )
    outcome = STABLE
    if what == ON:
        if block.phi > SHORT_SERIES and falls_over(k, block, seen, bars, held, state):
            outcome = COLLAPSED
    elif what == AT_IMPACT:
        state[IMPACTS + k] += 1.0
        state[KINKS + k] = 0.0
    else:
        kinks = state[KINKS + k] if state[KINK_SAMPLE + k] == state[SAMPLE + k] else 0.0
        state[KINKS + k] = kinks + 1.0
        state[KINK_SAMPLE + k] = state[SAMPLE + k]
        if kinks + 1.0 > IMPACTS_PER_SAMPLE:
            outcome = IMPACT_LIMIT
    if what != ON:
        set_lane(k, block.side, block.phi, block.speed, block.zone, model, state)
        set_pull(k, bars, held, state)
        state[MOVING + k] = 1.0 if block.moving else 0.0
    state[PHI + k] = block.phi
    state[SPEED + k] = block.speed
    state[PEAK + k] = block.peak
    state[TIME + k] = t
    if t < 1.0:
        state[PER_STEP + k] = 1.0 / (dt * (1.0 - t))
    return outcome, block.clamped
