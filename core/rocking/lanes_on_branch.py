"""Lanes of a wall on its elastic branch in closed form (oscillator.py).

A lane that comes onto the branch goes along it alone, sample after sample, until it leaves it and steps beside the
others again. Until a wall that rocks both ways first leaves the branch its motion is proportional to the ground:
impacts at zero keep their share, nothing else has a scale. One pass of the record as it is tells for every multiplier
when that is; an analysis begins there, and where it never is it has ended.
"""

from core.jit.decorators import subkernel
from core.rocking.early_stop import MAX_SETTLED_RATIO, SETTLED_EVERY, settled
from core.rocking.events import IMPACTS_PER_SAMPLE, BlockState, next_uplift
from core.rocking.lane_state import (
    FIRST,
    IMPACTS,
    KINK_SAMPLE,
    KINKS,
    PART,
    PEAK,
    PER_STEP,
    SAMPLE,
    SCALE,
    SECOND,
    TIME,
    set_lane,
)
from core.rocking.oscillator import SWING_FALLS, SWING_RISES, Oscillation, advance_oscillation
from core.rocking.outcome import IMPACT_LIMIT, STABLE
from core.rocking.taylor import at_end, impact
from core.wall.moment_rotation import NEVER_REACHED
from core.wall.rocking_model import seen_from

SIDES, MOVING_AT, ROTATIONS, SPEEDS, PEAKS, OWNER = range(6)
SHARED_ROWS = 6
"""Rows of the first part that analyses share: side, moving, rotation, speed and largest rotation at each sample under
the record as it is; last, the last sample of this record, and its sign."""

ROUNDING = 1e-9
"""Share of the end of the branch below which a proportional motion is surely on it."""


@subkernel
def through_branch(ground0, ground1, t, model, constants, parts, before, block):
    """Carry a wall on its branch, or at rest, through a sample or to where it leaves the branch.

    ground0, ground1 : ground acceleration at both ends of the sample [m/s2]
    t : where in the sample it is, 0 to 1
    model : RockingModel
    constants : WallConstants
    parts : Swing, of the branch or of one without an end
    before : impacts at the start of the sample
    block : BlockState
    Returns (BlockState, where in the sample, whether it leaves the branch).
    """
    jump = ground1 - ground0
    while t < 1.0 and block.impacts - before <= IMPACTS_PER_SAMPLE:
        if not block.moving:
            t, side = next_uplift(ground0, jump, t, 1.0, constants.thresholds)
            if t >= 1.0:
                break
            block = BlockState(side, 0.0, 0.0, True, 0, block.peak, block.impacts, block.clamped)
        block, t, ended = advance_oscillation(parts, block, ground0, jump, t)
        if ended == SWING_RISES:
            return block, t, True
        if ended == SWING_FALLS:
            block, _ = impact(block, ground0 + jump * t, seen_from(model, block.side), constants)
    return block, t, False


@subkernel
def follow_branch(k, block, i, t, end, dt, model, constants, ground, ahead, state):
    """Carry lane k along its branch until it leaves it or its analysis ends.

    k : lane, its rows SCALE, IMPACTS, KINKS, KINK_SAMPLE set
    block : BlockState on the branch or at rest, without its counts
    i, t : sample, and where in it, 0 to 1
    end : last sample of its record
    dt : the sample [s]
    model : RockingModel
    constants : WallConstants
    ground : of `Grounds` [m/s2], shape (n,)
    ahead : of `lookahead_bounds`, shape (4, n)
    state : of lane_state.py, shape (ROWS * ROW,)
    Returns (whether it has ended, its outcome, its peak, clamped ratios).
    """
    scale, may_settle = state[SCALE + k], model.ratio_drop == 0.0 and model.ratio_at_rest <= MAX_SETTLED_RATIO
    before, kinks = -int(state[IMPACTS + k]), state[KINKS + k] if state[KINK_SAMPLE + k] == i else 0.0
    leaves = False
    if i == end:
        outcome, peak = at_end(block, model)
        return True, outcome, peak, block.clamped
    while not leaves:
        impacts = block.impacts
        block, t, leaves = through_branch(
            scale * ground[i], scale * ground[i + 1], t, model, constants, constants.swing, before, block
        )
        kinks = (kinks if block.impacts == impacts else 0.0) + (1.0 if leaves else 0.0)
        if block.impacts - before > IMPACTS_PER_SAMPLE or kinks > IMPACTS_PER_SAMPLE:
            return True, IMPACT_LIMIT, block.peak, block.clamped
        if t >= 1.0:
            i, t, before, kinks = i + 1, 0.0, block.impacts, 0.0
            if i == end:
                outcome, peak = at_end(block, model)
                return True, outcome, peak, block.clamped
            if may_settle and i % SETTLED_EVERY == 1 and block.moving:
                seen, push = seen_from(model, block.side), abs(scale) * ahead[3, i]
                if settled(block.phi, block.speed, block.peak, push, seen):
                    return True, STABLE, block.peak, block.clamped
    set_lane(k, block.side, block.phi, block.speed, 2, model, state)
    state[SAMPLE + k] = i
    state[FIRST + k] = scale * ground[i]
    state[SECOND + k] = ground[i + 1]
    state[TIME + k] = t
    state[PER_STEP + k] = 1.0 / (dt * (1.0 - t))
    state[PART + k] = 1.0
    state[PEAK + k] = block.peak
    state[IMPACTS + k] = block.impacts - before
    state[KINKS + k] = kinks
    state[KINK_SAMPLE + k] = i
    return False, STABLE, block.peak, block.clamped


@subkernel
def start_on_branch(k, first, last, dt, model, constants, ground, ahead, zero, room, state):
    """Set lane k where it leaves its branch first; analyses of one record and sign one after another share their first
    part, where the wall rocks both ways and its impacts keep their share.

    k : lane, its row SCALE set
    first, last : samples of its record
    dt : the sample [s]
    model : RockingModel
    constants : WallConstants
    ground : of `Grounds` [m/s2], shape (n,)
    ahead : of `lookahead_bounds`, shape (4, n)
    zero : of int64
    room : to work, zeros at first, shape (SHARED_ROWS, longest record and one)
    state : of lane_state.py, shape (ROWS * ROW,)
    Returns what `follow_branch` does.
    """
    scale = state[SCALE + k]
    state[IMPACTS + k] = 0.0
    state[KINKS + k] = 0.0
    block, i = BlockState(1.0, 0.0, 0.0, False, 0, 0.0, zero, zero), first
    if model.ratio_drop == 0.0 and model.one_sided == 0.0:
        if room[OWNER, 0] != last or scale * room[OWNER, 1] <= 0.0:
            room[OWNER, 0], room[OWNER, 1] = last, -1.0 if scale < 0.0 else 1.0
            share_first_part(room[OWNER, 1], first, last, model, constants, ground, zero, room)
        block, i = shared_state(abs(scale), first, last, model, zero, room)
    return follow_branch(k, block, i, 0.0, last, dt, model, constants, ground, ahead, state)


@subkernel
def share_first_part(sign, first, last, model, constants, ground, zero, room):
    """The motion under a record as it is, on a branch without an end.

    sign : 1.0, or -1.0 of the record reversed
    first, last : its samples
    model : RockingModel
    constants : WallConstants
    ground : of `Grounds` [m/s2], shape (n,)
    zero : of int64
    room : of `begin`, but its last row
    """
    own = constants.swing
    parts = Oscillation(own.rate, own.static, NEVER_REACHED, own.span, own.sine, own.versine)
    block = BlockState(1.0, 0.0, 0.0, False, 0, 0.0, zero, zero)
    for n in range(last - first + 1):
        room[SIDES, n], room[MOVING_AT, n] = block.side, 1.0 if block.moving else 0.0
        room[ROTATIONS, n], room[SPEEDS, n], room[PEAKS, n] = block.phi, block.speed, block.peak
        if n < last - first:
            ground0, ground1 = sign * ground[first + n], sign * ground[first + n + 1]
            block, _, _ = through_branch(ground0, ground1, 0.0, model, constants, parts, block.impacts, block)


@subkernel
def shared_state(size, first, last, model, zero, room):
    """(BlockState, sample) of an analysis at the last sample before which it surely stays on the branch. size : of its
    multiplier; the others as `share_first_part`"""
    n, beyond = zero, last - first + 1
    while beyond - n > 1:
        middle = (n + beyond) // 2
        if size * room[PEAKS, middle] < model.elastic_end * (1.0 - ROUNDING):
            n = middle
        else:
            beyond = middle
    phi, speed, peak = size * room[ROTATIONS, n], size * room[SPEEDS, n], size * room[PEAKS, n]
    return BlockState(room[SIDES, n], phi, speed, room[MOVING_AT, n] != 0.0, 0, peak, zero, zero), first + n
