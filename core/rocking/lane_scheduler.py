"""Analyses at many multipliers, in lanes that step together, each with its own clock.

No lane waits for another: one that bounces falls behind, one that rests is set where the ground uplifts it next, one
that has collapsed, settled or come to its end leaves its place to the next analysis. So lanes may even belong to
different records.
"""

import math
from dataclasses import dataclass

import numpy as np

from core.jit.decorators import inner_kernel, kernel
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
from core.rocking.events import IMPACTS_PER_SAMPLE, REST_FRACTION, end_of_record, next_uplift
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
    set_lane,
)
from core.rocking.lanes import (
    lane_initial_terms,
    lane_taylor_coefficients,
    locate_impacts,
    shorten_steps,
    stay_in_sample,
    vector_step,
)
from core.rocking.outcome import COLLAPSED, IMPACT_LIMIT, STABLE
from core.rocking.taylor_series import PER_G, wall_constants
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
def skip_to_uplift(k, i, end, dt, model, thresholds, ground, ahead, state):
    """Set the resting lane k where the ground uplifts it first, or at the end of its record. While `ahead` shows no
    ground beyond the thresholds, samples are skipped by the window.

    k : lane
    i : sample from which on it rests
    end : last sample of its record
    dt : the sample [s]
    model : RockingModel
    thresholds : of `uplift_thresholds` [m/s2]
    ground : of `Grounds` [m/s2], shape (n,)
    ahead : of `lookahead_bounds`, shape (4, n)
    state : of lane_state.py, shape (ROWS * ROW,)
    """
    scale = state[SCALE + k]
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
            state[TIME + k] = time
            state[PER_STEP + k] = 1.0 / (dt * (1.0 - time))
            return
        i += 1
    start_sample(k, i, dt, ground, state)


@inner_kernel
def lane_chatter_ends(k, i, fastest, dt, model, constants, ahead, state):
    """Whether the chatter of lane k, just after an impact in sample i, surely ends at rest, see `chatter_ends`;
    checked at every fourth impact.

    k : lane
    i : its sample
    fastest : speed above which a chatter outlasts the lookahead [rad/s]
    dt : the sample [s]
    model : RockingModel
    constants : WallConstants
    ahead : of `lookahead_bounds`, shape (4, n)
    state : of lane_state.py, shape (ROWS * ROW,)
    """
    speed = state[SPEED + k]
    if unlike(model.other):  # the bound is of one hinge
        return False
    if not (state[PHI + k] == 0.0 and 0.0 < speed < fastest and int(state[IMPACTS + k]) & 3 == 1):
        return False
    time = (LOOKAHEAD - 1 - state[TIME + k]) * dt
    return chatter_ends(
        speed, state[SCALE + k], ahead, i, dt, time, state[IMPACTS + k], state[PEAK + k], model, constants
    )


@inner_kernel
def schedule_check(k, end, state):
    """When lane k, at the start of a sample, is to be checked for its end, if nothing happens before."""
    i = int(state[SAMPLE + k])
    state[LEFT + k] = min(end - i, SETTLED_EVERY - ((i - 1) & (SETTLED_EVERY - 1)))


@inner_kernel
def check_finished(k, end, model, ahead, state):
    """(whether the analysis of lane k has ended at the start of its sample, its outcome, its peak)."""
    i = int(state[SAMPLE + k])
    phi, speed, peak = state[PHI + k], state[SPEED + k], state[PEAK + k]
    seen = seen_from(model, state[SIDE + k])
    if (
        phi > seen.slenderness + seen.restoring.lean
        and i % RECOVERY_EVERY == 1
        and cannot_recover(phi, speed, state[STRONGEST + k], seen)
    ):
        return True, COLLAPSED, peak
    # Eq. 7 counts clamped ratios to the end of the record; a nearly elastic impact may exceed their limit; the bound is
    # of one hinge
    may_settle = model.ratio_drop == 0.0 and model.ratio_at_rest <= MAX_SETTLED_RATIO and not unlike(model.other)
    if i % SETTLED_EVERY == 1 and may_settle:
        push = abs(state[SCALE + k]) * ahead[3, i]
        if settled(phi, speed, peak, push, seen):
            return True, STABLE, peak
    if i < end:
        return False, STABLE, peak
    if state[MOVING + k] == 0.0:
        return True, STABLE, peak
    outcome, peak = end_of_record(phi, speed, peak, seen)
    return True, outcome, peak


@inner_kernel
def remove_lane(k, lanes, numbers, state):
    """Take lane k out: the last one takes its place. Returns how many are left."""
    lanes -= 1
    for row in range(2):
        numbers[WIDTH * row + k] = numbers[WIDTH * row + lanes]
    for row in range(LANE_ROWS):
        state[ROW * row + k] = state[ROW * row + lanes]
    return lanes


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
        numbers,
        state,
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
        numbers : room to work, int64, shape (3 * WIDTH,)
        state : of lane_state.py, zeros, shape (ROWS * ROW,)
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
                state[SCALE + lanes] = scales[waiting]
                state[STRONGEST + lanes] = abs(scales[waiting]) * strongest[record] * PER_G
                state[PEAK + lanes] = 0.0
                state[PART + lanes] = 1.0
                skip_to_uplift(lanes, firsts[record], lasts[record], dt, model, thresholds, ground, ahead, state)
                waiting += 1
                if state[SAMPLE + lanes] < lasts[record]:
                    schedule_check(lanes, end[lanes], state)
                    lanes += 1
                else:
                    outcomes[waiting - 1] = STABLE
                    peaks[waiting - 1] = 0.0
            if lanes == 0:
                break
            lane_initial_terms(lanes, dt, model, constants, slopes, state)
            lane_taylor_coefficients(lanes, constants, order, slopes, state)
            shorter = zero
            if long > 0:
                shorter = shorten_steps(lanes, dt, constants, order, slopes, state)
                long = LONG_FOR if shorter > 0 else long - 1
            vector_step(lanes, dt, constants, order, slopes, state)
            if shorter > 0:
                stay_in_sample(lanes, constants, state)
            count = load_next_sample(lanes, ground, busy, state)
            falling = gather_falling(count, busy, state)
            if falling > 0:
                locate_impacts(falling, dt, model, rest_below, order, state)
            # from the last on, so that the lane that takes the place of a removed one has been handled
            while count > 0:
                count -= 1
                k = busy[count]
                step = state[NEXT + k]
                outcome = STABLE
                if step >= FALLS:
                    falling -= int(step == FALLS)
                    if step == LONG:
                        long = LONG_FOR
                    if step >= SCALAR or not scatter_impact(k, falling, dt, model, thresholds, state):
                        outcome, clamps = scalar_step(k, dt, model, constants, order, zero, state)
                        clamped[lane[k]] += clamps
                    if state[IMPACTS + k] > IMPACTS_PER_SAMPLE:
                        outcome = IMPACT_LIMIT
                if outcome == STABLE and step >= FALLS:
                    i = int(state[SAMPLE + k])
                    if lane_chatter_ends(k, i, fastest, dt, model, constants, ahead, state):
                        state[MOVING + k] = 0.0
                        state[SPEED + k] = 0.0
                    elif state[TIME + k] < 1.0:
                        continue
                    if state[MOVING + k] == 0.0:
                        skip_to_uplift(k, i + 1, end[k], dt, model, thresholds, ground, ahead, state)
                    else:
                        start_sample(k, i + 1, dt, ground, state)
                over, peak = True, state[PEAK + k]
                if outcome == STABLE:
                    over, outcome, peak = check_finished(k, end[k], model, ahead, state)
                    schedule_check(k, end[k], state)
                if over:
                    outcomes[lane[k]] = outcome
                    peaks[lane[k]] = peak
                    lanes = remove_lane(k, lanes, numbers, state)

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
    numbers, room = np.zeros(3 * WIDTH, np.int64), np.zeros(ROWS * ROW + VECTOR)
    # from the start of a line of the processor's cache on, so that no vector lies in two: a seventh of a step
    start = -room.ctypes.data // room.itemsize % VECTOR
    state = room[start : start + ROWS * ROW]
    LANE_KERNEL[order](
        grounds.ground,
        grounds.ahead,
        grounds.dt,
        grounds.first,
        grounds.last,
        grounds.strongest,
        which,
        scales,
        model,
        None if model.plateau_end == 0.0 else 1.0,
        numbers,
        state,
        outcomes,
        peaks,
        clamped,
    )
    return clamped
