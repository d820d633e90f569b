"""Analyses at many multipliers, in lanes that step together, each with its own clock.

No lane waits for another: one that bounces falls behind, one that rests is set where the ground uplifts it next, one
that has collapsed, settled or come to its end leaves its place to the next analysis. So lanes may even belong to
different records.
"""

import math
from dataclasses import dataclass

import numpy as np

from core.jit.decorators import inner_kernel, kernel, subkernel
from core.rocking.bar_state import BROKEN, PHASE, YIELDS_AT, all_broken, at_start
from core.rocking.early_stop import (
    LOOKAHEAD,
    MAX_SETTLED_RATIO,
    RECOVERY_EVERY,
    SETTLED_EVERY,
    cannot_recover,
    chatter_ends,
    lookahead_bounds,
    settled,
)
from core.rocking.events import IMPACTS_PER_SAMPLE, REST_FRACTION, BlockState, end_of_record, next_uplift
from core.rocking.lane_events import gather_falling, scalar_step, scatter_impact
from core.rocking.lane_state import (
    FALLS,
    FIRST,
    IMPACTS,
    LANE_ROWS,
    LEFT,
    LONG,
    MOVING,
    NEXT,
    PART,
    PEAK,
    PER_STEP,
    PHI,
    ROW,
    ROWS,
    SAMPLE,
    SCALAR,
    SCALE,
    SECOND,
    SIDE,
    SPEED,
    STEPPED,
    STRONGEST,
    TIME,
    VECTOR,
    WIDTH,
    ZONE,
    lane_thresholds,
    set_lane,
    set_pull,
)
from core.rocking.lanes import (
    lane_initial_terms,
    lane_taylor_coefficients,
    locate_impacts,
    shorten_steps,
    stay_in_sample,
    vector_step,
)
from core.rocking.lanes_on_branch import SHARED_ROWS, begin, ride
from core.rocking.outcome import COLLAPSED, IMPACT_LIMIT, STABLE
from core.rocking.taylor_series import PER_G, wall_constants
from core.rocking.taylor_with_bars import in_still_ground, settled_with_bars
from core.wall.bars import bar_rows
from core.wall.moment_rotation import zone_of
from core.wall.rocking_model import seen_from, unlike

LONG_FOR = 4
"""Passes over the lanes in which steps are shortened, after one was: where each sample takes two parts, the second
is whole."""


@dataclass(frozen=True)
class Grounds:
    """Records of one time step laid end to end, as a pass takes them; made once for all analyses of them.

    ground : [m/s2], a zero after each record; dt : [s]; first, last : index of the samples of each record,
    shape (records,); strongest : |u''| of each [m/s2]; ahead : of `lookahead_bounds`, shape (4, n).
    """

    ground: np.ndarray
    dt: float
    first: np.ndarray
    last: np.ndarray
    strongest: np.ndarray
    ahead: np.ndarray

    @classmethod
    def of(cls, records, dt: float) -> "Grounds":
        """records : ground accelerations [m/s2], each of shape (n,)."""
        end = np.cumsum([record.size + 1 for record in records])
        return cls(
            ground=np.concatenate([np.append(record, 0.0) for record in records]),
            dt=dt,
            first=end - np.array([record.size + 1 for record in records]),
            last=end - 2,
            strongest=np.array([np.abs(record).max() for record in records]),
            ahead=np.hstack([lookahead_bounds(np.append(record, 0.0), dt) for record in records]),
        )


@inner_kernel
def load_next_sample(lanes, ground, busy, state):
    """The ground at the end of each lane's sample. busy : result, the lanes whose NEXT is not STEPPED;
    returns how many these are."""
    count = 0
    for k in range(lanes):
        state[SECOND + k] = ground[int(state[SAMPLE + k]) + 1]
        busy[count] = k
        count += int(state[NEXT + k] > STEPPED)
    return count


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
        return begin(k, first, last, dt, model, constants, ground, ahead, zero, room, state)
    start_bars(k, bars, held)
    skip_to_uplift(k, first, last, dt, model, constants, ground, ahead, bars, held, state)
    return state[SAMPLE + k] >= last, STABLE, 0.0, zero


@inner_kernel
def along_branch(k, outcome, end, dt, model, constants, ground, ahead, zero, room, state):
    """Carry lane k along its branch in closed form where it came onto it and goes on, see `ride`.

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
    over, outcome, peak, clamps = ride(k, block, i, state[TIME + k], end, dt, model, constants, ground, ahead, state)
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
        outcome, after = in_still_ground(dt, model, constants, block_of_lane(k, zero, state), bars, held[k])
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
        at_start((0.0, 0.0), bars, held[k])


@inner_kernel
def remove_lane(k, lanes, numbers, held, state):
    """Take lane k out: the last one takes its place. Returns how many are left. held : as `check_finished`"""
    lanes -= 1
    for row in range(2):
        numbers[WIDTH * row + k] = numbers[WIDTH * row + lanes]
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


def make_lane_kernel(order):
    """The kernel of one pass, specialised at compile time for order 6 or 8.

    Length: it holds the kernel.
    """

    @kernel
    def one_pass(
        ground,
        ahead,
        dt,
        firsts,
        lasts,
        strongest,
        which,
        scales,
        model,
        slopes,
        bars,
        held,
        numbers,
        state,
        room,
        outcomes,
        peaks,
        clamped,
    ):
        """Carry out these analyses, up to WIDTH at a time.

        Length: one loop over the steps of all lanes, whose parts share its counts.

        ground : of `Grounds` [m/s2], shape (n,)
        ahead : of `Grounds`, shape (4, n)
        dt : the sample [s]
        firsts, lasts : of `Grounds`, int64, shape (records,)
        strongest : of `Grounds` [m/s2], shape (records,)
        which : record of each analysis, int64, shape (m,)
        scales : multipliers [-], shape (m,), negative reverses the record
        model : RockingModel
        slopes : of `lanes.branch_of`: the kernel is specialised at compile time for the rigid law
        bars, held : of `bar_rows`, shape (bars, 5), and their state in all lanes, shape (WIDTH, bars, 5), or None: the
            kernel is specialised at compile time for walls without
        numbers : room to work, int64, shape (3 * WIDTH,)
        state : of lane_state.py, zeros, shape (ROWS * ROW,)
        room : of lanes_on_branch.py, of a wall with a branch in closed form, or None: as slopes
        outcomes : results, codes of outcome.py, int64, shape (m,)
        peaks : results [rad], shape (m,)
        clamped : results, counts of clamped velocity ratios, int64, shape (m,)
        """
        constants = wall_constants(model, dt)
        thresholds = constants.thresholds
        zero = np.int64(0)  # a plain 0 would be a type of its own, and compile everything again
        # of each lane its analysis and last sample, then the lanes to be handled one by one
        lane, end, busy = numbers[:WIDTH], numbers[WIDTH : 2 * WIDTH], numbers[2 * WIDTH :]
        far = seen_from(model, -1.0)
        rest_below = (
            REST_FRACTION * math.sqrt(model.p2) * model.slenderness,
            REST_FRACTION * math.sqrt(far.p2) * far.slenderness,
        )
        loss = 1.0 - model.ratio_at_rest if thresholds[0] > 0.0 else 0.0
        fastest = 0.5 * model.p2 * (model.slenderness + (constants.strength - 1.0)) * loss * (LOOKAHEAD - 1) * dt
        waiting = zero
        lanes = zero
        long = zero + 1  # passes in which steps may be shortened; 1 at first, which sets the rows of whole steps
        while True:
            while lanes < WIDTH and waiting < scales.size:
                record = which[waiting]
                lane[lanes], end[lanes] = waiting, lasts[record]
                state[STRONGEST + lanes] = abs(scales[waiting]) * strongest[record] * PER_G
                over, outcome, peak, clamps = start_lane(
                    lanes,
                    scales[waiting],
                    firsts[record],
                    lasts[record],
                    dt,
                    model,
                    constants,
                    ground,
                    ahead,
                    zero,
                    bars,
                    held,
                    room,
                    state,
                )
                clamped[waiting] += clamps
                if over:
                    outcomes[waiting], peaks[waiting] = outcome, peak
                else:
                    schedule_check(lanes, end[lanes], state)
                    lanes += 1
                waiting += 1
            if lanes == 0:
                break
            lane_initial_terms(lanes, dt, model, constants, slopes, bars, state)
            lane_taylor_coefficients(lanes, constants, order, slopes, bars, state)
            shorter = zero
            if long > 0:
                shorter = shorten_steps(lanes, dt, constants, order, slopes, bars, state)
                long = LONG_FOR if shorter > 0 else long - 1
            vector_step(lanes, dt, constants, order, slopes, bars, state)
            if shorter > 0:
                stay_in_sample(lanes, constants, state)
            count = load_next_sample(lanes, ground, busy, state)
            falling = gather_falling(count, busy, bars, state)
            if falling > 0:
                locate_impacts(falling, dt, model, rest_below, order, bars, state)
            # from the last on, so that the lane that takes the place of a removed one has been handled
            while count > 0:
                count -= 1
                k = busy[count]
                step = state[NEXT + k]
                outcome = STABLE
                if step >= FALLS:
                    falling -= int(step < SCALAR)
                    if step == LONG:
                        long = LONG_FOR
                    if step >= SCALAR or not scatter_impact(k, falling, dt, model, constants, bars, held, state):
                        outcome, clamps = scalar_step(k, dt, model, constants, order, zero, bars, held, state)
                        clamped[lane[k]] += clamps
                    if state[IMPACTS + k] > IMPACTS_PER_SAMPLE:
                        outcome = IMPACT_LIMIT
                rides, over, outcome, peak, clamps = along_branch(
                    k, outcome, end[k], dt, model, constants, ground, ahead, zero, room, state
                )
                if rides:
                    clamped[lane[k]] += clamps
                    schedule_check(k, end[k], state)
                    if over:
                        outcomes[lane[k]], peaks[lane[k]] = outcome, peak
                        lanes = remove_lane(k, lanes, numbers, held, state)
                    continue
                if outcome == STABLE and step >= FALLS:
                    i = int(state[SAMPLE + k])
                    if lane_chatter_ends(k, i, fastest, dt, model, constants, ahead, bars, held, state):
                        state[MOVING + k] = 0.0
                        state[SPEED + k] = 0.0
                    elif state[TIME + k] < 1.0:
                        continue
                    if state[MOVING + k] == 0.0:
                        skip_to_uplift(k, i + 1, end[k], dt, model, constants, ground, ahead, bars, held, state)
                    else:
                        start_sample(k, i + 1, dt, ground, state)
                over, peak = True, state[PEAK + k]
                if outcome == STABLE:
                    over, outcome, peak = check_finished(
                        k, end[k], dt, model, constants, ahead, zero, bars, held, state
                    )
                    schedule_check(k, end[k], state)
                if over:
                    outcomes[lane[k]] = outcome
                    peaks[lane[k]] = peak
                    lanes = remove_lane(k, lanes, numbers, held, state)

    return one_pass


LANE_KERNEL = {order: make_lane_kernel(order) for order in (6, 8)}


def scan(order, grounds, which, scales, model, outcomes, peaks):
    """`core.rocking.history.scan` by order 6 or 8. Outcomes and the peaks of stable blocks are those of whole
    histories, bit for bit; the peak of a block that overturns is where its analysis ended.
    (Peaks below 1e-12 rad of chatter that outlives the record can differ by the rounding of an arccosine.)

    order : of the series, 6 or 8
    grounds : Grounds
    which : record of each multiplier, int64, shape (m,)
    scales : multipliers [-], shape (m,), negative reverses the record
    model : RockingModel
    outcomes : results, codes of outcome.py, int64, shape (m,)
    peaks : results [rad], shape (m,)
    Returns the clamped velocity ratios of each, shape (m,).
    """
    clamped = np.zeros(scales.size, np.int64)
    bars = bar_rows(model.bars) if model.bars else None
    numbers, rows = np.zeros(3 * WIDTH, np.int64), np.zeros(ROWS * ROW + VECTOR)
    # from the start of a line of the processor's cache on, so that no vector lies in two: a seventh of a step
    start = -rows.ctypes.data // rows.itemsize % VECTOR
    state = rows[start : start + ROWS * ROW]
    longest = int((grounds.last - grounds.first).max()) + 2
    LANE_KERNEL[order](
        grounds.ground,
        grounds.ahead,
        grounds.dt,
        grounds.first,
        grounds.last,
        grounds.strongest,
        which,
        scales,
        model._replace(bars=()),
        None if model.plateau_end == 0.0 and bars is None else 1.0,
        bars,
        None if bars is None else np.zeros((WIDTH, *bars.shape)),
        numbers,
        state,
        None if model.driven is None else np.zeros((SHARED_ROWS, longest)),
        outcomes,
        peaks,
        clamped,
    )
    return clamped
