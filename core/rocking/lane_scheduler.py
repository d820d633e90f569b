"""Analyses at many multipliers, in lanes that step together, each with its own clock.

No lane waits for another: one that bounces falls behind, one that rests is set where the ground uplifts it next, one
that has collapsed, settled or come to its end leaves its place to the next analysis. So lanes may even belong to
different records.
"""

import math

import numpy as np

from core.jit.decorators import inner_kernel, kernel
from core.rocking.early_stop import LOOKAHEAD
from core.rocking.events import IMPACTS_PER_SAMPLE, REST_FRACTION
from core.rocking.lane_events import gather_falling, scalar_step, scatter_impact
from core.rocking.lane_lifecycle import (
    along_branch,
    check_finished,
    lane_chatter_ends,
    remove_lane,
    schedule_check,
    skip_to_uplift,
    start_lane,
    start_sample,
)
from core.rocking.lane_state import (
    ACTION,
    FALLS,
    IMPACTS,
    LONG,
    MAX_LANES,
    MOVING,
    PEAK,
    ROW,
    ROWS,
    SAMPLE,
    SCALAR,
    SECOND,
    SPEED,
    STEPPED,
    STRONGEST,
    TIME,
    VECTOR,
)
from core.rocking.lanes import (
    lane_initial_terms,
    lane_taylor_coefficients,
    locate_impacts,
    restore_partial_steps,
    shorten_steps,
    vector_step,
)
from core.rocking.lanes_on_branch import SHARED_ROWS
from core.rocking.outcome import IMPACT_LIMIT, STABLE
from core.rocking.taylor_series import PER_G, wall_constants
from core.wall.bars import bar_rows
from core.wall.rocking_model import seen_from

SHORTENING_PASSES = 4
"""Passes over the lanes in which steps are shortened, after one was: where each sample takes two parts, the second
is whole."""


@inner_kernel
def load_next_sample(lanes, ground, busy, state):
    """The ground at the end of each lane's sample. busy : result, the lanes whose ACTION is not STEPPED;
    returns how many these are."""
    count = 0
    for k in range(lanes):
        state[SECOND + k] = ground[int(state[SAMPLE + k]) + 1]
        busy[count] = k
        count += int(state[ACTION + k] > STEPPED)
    return count


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
        """Carry out these analyses, up to MAX_LANES at a time.

        Length: one loop over the steps of all lanes, whose parts share its counts.

        ground : of `Grounds` [m/s2], shape (n,)
        ahead : of `Grounds`, shape (4, n)
        dt : the sample [s]
        firsts, lasts : of `Grounds`, int64, shape (records,)
        strongest : of `Grounds` [m/s2], shape (records,)
        which : record of each analysis, int64, shape (m,)
        scales : multipliers [-], shape (m,), negative reverses the record
        model : RockingModel
        slopes : of `lanes.lane_branch`: the kernel is specialised at compile time for the rigid law
        bars, held : of `bar_rows`, shape (bars, 5), and their state in all lanes, shape (MAX_LANES, bars, 5), or None:
            the kernel is specialised at compile time for walls without
        numbers : room to work, int64, shape (3 * MAX_LANES,)
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
        lane, end, busy = numbers[:MAX_LANES], numbers[MAX_LANES : 2 * MAX_LANES], numbers[2 * MAX_LANES :]
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
            while lanes < MAX_LANES and waiting < scales.size:
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
                long = SHORTENING_PASSES if shorter > 0 else long - 1
            vector_step(lanes, dt, constants, order, slopes, bars, state)
            if shorter > 0:
                restore_partial_steps(lanes, constants, state)
            count = load_next_sample(lanes, ground, busy, state)
            falling = gather_falling(count, busy, bars, state)
            if falling > 0:
                locate_impacts(falling, dt, model, rest_below, order, bars, state)
            # from the last on, so that the lane that takes the place of a removed one has been handled
            while count > 0:
                count -= 1
                k = busy[count]
                step = state[ACTION + k]
                outcome = STABLE
                if step >= FALLS:
                    falling -= int(step < SCALAR)
                    if step == LONG:
                        long = SHORTENING_PASSES
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
    """`core.rocking.history.scan_multipliers` by order 6 or 8. Outcomes and the peaks of stable blocks are those of
    whole histories, bit for bit; the peak of a block that overturns is where its analysis ended.
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
    numbers, rows = np.zeros(3 * MAX_LANES, np.int64), np.zeros(ROWS * ROW + VECTOR)
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
        None if bars is None else np.zeros((MAX_LANES, *bars.shape)),
        numbers,
        state,
        None if model.driven is None else np.zeros((SHARED_ROWS, longest)),
        outcomes,
        peaks,
        clamped,
    )
    return clamped
