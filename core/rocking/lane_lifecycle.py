"""How an analysis begins in its lane, rests, goes along an elastic branch, and ends."""

from core.jit.decorators import inner_kernel, subkernel
from core.rocking.bar_state import BROKEN, PHASE, YIELDS_AT, all_broken, initial_state
from core.rocking.early_stop import (
    LOOKAHEAD,
    MAX_SETTLED_RATIO,
    RECOVERY_EVERY,
    SETTLED_EVERY,
    cannot_recover,
    chatter_ends,
    settled,
)
from core.rocking.events import BlockState, end_of_record, next_uplift
from core.rocking.lane_state import (
    FIRST,
    IMPACTS,
    LANE_ROWS,
    LEFT,
    MAX_LANES,
    MOVING,
    PART,
    PEAK,
    PER_STEP,
    PHI,
    ROW,
    SAMPLE,
    SCALE,
    SECOND,
    SIDE,
    SPEED,
    STRONGEST,
    TIME,
    ZONE,
    lane_thresholds,
    set_lane,
    set_pull,
)
from core.rocking.lanes_on_branch import follow_branch, start_on_branch
from core.rocking.outcome import COLLAPSED, STABLE
from core.rocking.taylor_with_bars import integrate_after_record, settled_with_bars
from core.wall.moment_rotation import zone_of
from core.wall.rocking_model import seen_from, unlike


@inner_kernel
def start_sample(k, i, dt, ground, state):
    """Set lane k at the start of sample i."""
    state[SAMPLE + k] = i
    state[FIRST + k] = state[SCALE + k] * ground[i]
    state[SECOND + k] = ground[i + 1]
    state[TIME + k] = 0.0
    state[PER_STEP + k] = 1.0 / dt
    state[IMPACTS + k] = 0.0


@inner_kernel
def skip_to_uplift(k, i, end, dt, model, constants, ground, ahead, bars, held, state):
    """Set the resting lane k where the ground uplifts it first, or at the end of its record. While `ahead` shows no
    ground beyond the thresholds, samples are skipped by the window.

    k : lane
    i : sample from which on it rests
    end : last sample of its record
    dt : the sample [s]
    model : RockingModel
    constants : WallConstants
    ground : of `Grounds` [m/s2], shape (n,)
    ahead : of `lookahead_bounds`, shape (4, n)
    bars, held : rows of the bars and their state in all lanes, or None
    state : of lane_state.py, shape (ROWS * ROW,)
    """
    scale = state[SCALE + k]
    thresholds = lane_thresholds(k, constants, bars, held)
    right, left = thresholds
    while i < end:
        one, other = scale * ahead[0, i], scale * ahead[1, i]
        if max(one, other) <= right and min(one, other) >= -left:
            i = min(i + LOOKAHEAD - 1, end)
            continue
        first, second = scale * ground[i], scale * ground[i + 1]
        if max(first, second) <= right and min(first, second) >= -left:  # without the division of `next_uplift`
            i += 1
            continue
        time, side = next_uplift(first, second - first, 0.0, 1.0, thresholds)
        if time < 1.0:
            start_sample(k, i, dt, ground, state)
            set_lane(k, side, 0.0, 0.0, zone_of(0.0, model), model, state)
            set_pull(k, bars, held, state)
            state[TIME + k] = time
            state[PER_STEP + k] = 1.0 / (dt * (1.0 - time))
            return
        i += 1
    start_sample(k, i, dt, ground, state)


@inner_kernel
def start_lane(k, scale, first, last, dt, model, constants, ground, ahead, zero, bars, held, room, state):
    """Set lane k at the beginning of an analysis: where the ground uplifts it first, of a wall with a branch in closed
    form where it leaves it first.

    k : lane
    scale : multiplier [-]
    first, last : samples of its record
    dt : the sample [s]
    model : RockingModel
    constants : WallConstants
    ground : of `Grounds` [m/s2], shape (n,)
    ahead : of `lookahead_bounds`, shape (4, n)
    zero : of int64
    bars, held : rows of the bars and their state in all lanes, or None
    room : of lanes_on_branch.py, or None
    state : of lane_state.py, shape (ROWS * ROW,)
    Returns (whether it ends here, its outcome, its peak, clamped ratios).
    """
    state[SCALE + k] = scale
    state[PEAK + k] = 0.0
    state[PART + k] = 1.0
    if room is not None:
        return start_on_branch(k, first, last, dt, model, constants, ground, ahead, zero, room, state)
    start_bars(k, bars, held)
    skip_to_uplift(k, first, last, dt, model, constants, ground, ahead, bars, held, state)
    return state[SAMPLE + k] >= last, STABLE, 0.0, zero


@inner_kernel
def along_branch(k, outcome, end, dt, model, constants, ground, ahead, zero, room, state):
    """Carry lane k along its branch in closed form where it came onto it and goes on, see `follow_branch`.

    k : lane
    outcome : so far
    end : last sample of its record
    dt : the sample [s]
    model : RockingModel
    constants : WallConstants
    ground : of `Grounds` [m/s2], shape (n,)
    ahead : of `lookahead_bounds`, shape (4, n)
    zero : of int64
    room : of lanes_on_branch.py, or None
    state : of lane_state.py, shape (ROWS * ROW,)
    Returns (whether it did, whether its analysis has ended, its outcome, its peak, clamped ratios).
    """
    if room is None:
        return False, False, outcome, 0.0, zero
    if outcome != STABLE or state[ZONE + k] != 0.0:
        return False, False, outcome, 0.0, zero
    block, i = block_of_lane(k, zero, state), int(state[SAMPLE + k])
    over, outcome, peak, clamps = follow_branch(
        k, block, i, state[TIME + k], end, dt, model, constants, ground, ahead, state
    )
    return True, over, outcome, peak, clamps


@inner_kernel
def lane_chatter_ends(k, i, fastest, dt, model, constants, ahead, bars, held, state):
    """Whether the chatter of lane k, just after an impact in sample i, surely ends at rest, see `chatter_ends`;
    checked at every fourth impact.

    k : lane
    i : its sample
    fastest : speed above which a chatter outlasts the lookahead [rad/s]
    dt : the sample [s]
    model : RockingModel
    constants : WallConstants
    ahead : of `lookahead_bounds`, shape (4, n)
    bars, held : rows of the bars and their state in all lanes, or None
    state : of lane_state.py, shape (ROWS * ROW,)
    """
    speed = state[SPEED + k]
    if unlike(model.other):  # the bound is of one hinge
        return False
    if not (state[PHI + k] == 0.0 and 0.0 < speed < fastest and int(state[IMPACTS + k]) & 3 == 1):
        return False
    if bars is not None and not elastic_up_to(state[PEAK + k], held[k]):
        return False
    time = (LOOKAHEAD - 1 - state[TIME + k]) * dt
    return chatter_ends(
        speed, state[SCALE + k], ahead, i, dt, time, state[IMPACTS + k], state[PEAK + k], model, constants
    )


@subkernel
def elastic_up_to(phi, held):
    """Whether no bar yields or breaks below phi [rad]: it then only makes bounces shorter. held : state of the bars of
    a lane, shape (bars, 5)"""
    elastic = True
    for j in range(held.shape[0]):
        elastic &= held[j, PHASE] == BROKEN or held[j, YIELDS_AT] >= phi
    return elastic


@inner_kernel
def schedule_check(k, end, state):
    """When lane k, at the start of a sample, is to be checked for its end, if nothing happens before."""
    i = int(state[SAMPLE + k])
    state[LEFT + k] = min(end - i, SETTLED_EVERY - ((i - 1) & (SETTLED_EVERY - 1)))


@inner_kernel
def check_finished(k, end, dt, model, constants, ahead, zero, bars, held, state):
    """Whether an analysis has ended.

    k : lane, at the start of its sample
    end : last sample of its record
    dt : the sample [s]
    model : RockingModel
    constants : WallConstants
    ahead : of `lookahead_bounds`, shape (4, n)
    zero : of int64
    bars, held : rows of the bars and their state in all lanes, or None
    state : of lane_state.py, shape (ROWS * ROW,)
    Returns (whether it has ended, its outcome, its peak).
    """
    i = int(state[SAMPLE + k])
    phi, speed, peak = state[PHI + k], state[SPEED + k], state[PEAK + k]
    seen = seen_from(model, state[SIDE + k])
    if (
        phi > seen.slenderness + seen.restoring.lean
        and i % RECOVERY_EVERY == 1
        and nothing_holds(k, bars, held)
        and cannot_recover(phi, speed, state[STRONGEST + k], seen)
    ):
        return True, COLLAPSED, peak
    # Eq. 7 counts clamped ratios to the end of the record; a nearly elastic impact may exceed their limit; the bound is
    # of one hinge
    may_settle = model.ratio_drop == 0.0 and model.ratio_at_rest <= MAX_SETTLED_RATIO and not unlike(model.other)
    if i % SETTLED_EVERY == 1 and may_settle:
        push = abs(state[SCALE + k]) * ahead[3, i]
        if bars is not None:
            done = settled_with_bars(block_of_lane(k, zero, state), push, model, bars, held[k])
        else:
            done = settled(phi, speed, peak, push, seen)
        if done:
            return True, STABLE, peak
    if i < end:
        return False, STABLE, peak
    if state[MOVING + k] == 0.0:
        return True, STABLE, peak
    if bars is not None:
        outcome, after = integrate_after_record(dt, model, constants, block_of_lane(k, zero, state), bars, held[k])
        return True, outcome, after.peak
    outcome, peak = end_of_record(phi, speed, peak, seen)
    return True, outcome, peak


@inner_kernel
def nothing_holds(k, bars, held):
    """Whether no bar is left to lane k. bars, held : as `check_finished`"""
    if bars is None:
        return True
    return all_broken(held[k])


@inner_kernel
def block_of_lane(k, zero, state):
    """BlockState of lane k without its counts. zero : of int64"""
    moving, zone = state[MOVING + k] != 0.0, int(state[ZONE + k])
    return BlockState(state[SIDE + k], state[PHI + k], state[SPEED + k], moving, zone, state[PEAK + k], zero, zero)


@inner_kernel
def start_bars(k, bars, held):
    """Set the bars of lane k as they are before the record. bars, held : as `check_finished`"""
    if bars is not None:
        initial_state((0.0, 0.0), bars, held[k])


@inner_kernel
def remove_lane(k, lanes, numbers, held, state):
    """Take lane k out: the last one takes its place. Returns how many are left. held : as `check_finished`"""
    lanes -= 1
    for row in range(2):
        numbers[MAX_LANES * row + k] = numbers[MAX_LANES * row + lanes]
    for row in range(LANE_ROWS):
        state[ROW * row + k] = state[ROW * row + lanes]
    move_bars(k, lanes, held)
    return lanes


@inner_kernel
def move_bars(k, lanes, held):
    """Give lane k the bars of lane `lanes`. held : as `check_finished`"""
    if held is not None:
        for j in range(held.shape[1]):
            for column in range(held.shape[2]):
                held[k, j, column] = held[lanes, j, column]
