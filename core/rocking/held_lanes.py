"""Analyses of a wall held at its top at many multipliers, in lanes that step together.

Each lane has its own record and sample. A step that is plain, a whole sample within its piece of the functions in which
the wall does not land nor turn to a new peak, is taken of all lanes at once by vector instructions; any other one by
`held_top.through_sample`, so that results equal those of histories bit for bit.
"""

import numpy as np

from core.jit.decorators import inner_kernel, kernel, subkernel, widest_vectors
from core.rocking.events import uplift_thresholds
from core.rocking.grounds import Grounds
from core.rocking.held_top import outcome_after_record, split_model, through_sample
from core.rocking.outcome import STABLE
from core.rocking.side_functions import DEGREE, OVERLAP, PIECES, V, X, turned_by
from core.rocking.side_series import has_converged, moved, push_of, shift_polynomial, speed_of, terms_of
from core.units import G
from core.wall.rocking_model import RockingModel

MAX_HELD_LANES, VECTOR = 32, 8
"""Lanes of one pass, and of which they are stepped in multiples: no remainder is left to scalar instructions."""

ROW = MAX_HELD_LANES + 8
"""Length of a row of the state: rows of 32 would meet in the same sets of the processor's cache."""

Y, SPEED, SIGN, SCALE, GROUND, GROUND_AHEAD, PEAK, PIECE_HELD, PIECE_REACHED, PLAIN = (ROW * row for row in range(10))
"""Rows: y [rad] and y' [rad/s] seen from the side of SIGN (1.0 outward, -1.0 inward), multiplier, ground at both ends
of the sample [m/s2], largest y to this side [rad], the piece whose coefficients are held and the one the wall is in,
and 1.0 where the step was plain."""

FIRST_V, FIRST_X = ROW * 10, ROW * (11 + DEGREE)
"""Rows of the coefficients of both functions in the piece."""

ROWS = 10 + 2 * (DEGREE + 1)

SAFE_SHARE = 1.0 - 1e-9
"""Share of a threshold below which a sample does not lift the wall whatever is rounded."""


@inner_kernel
def coefficients(first, k, state):
    """Those of one function, of lane k. first : its first row"""
    return (
        state[first + k],
        state[first + ROW + k],
        state[first + 2 * ROW + k],
        state[first + 3 * ROW + k],
        state[first + 4 * ROW + k],
        state[first + 5 * ROW + k],
        state[first + 6 * ROW + k],
        state[first + 7 * ROW + k],
    )


@subkernel
def vector_step_held(lanes, dt, p2, outward, inward, state):
    """Take the plain steps of all lanes, and say in PLAIN which were; `one` as in `lanes.vector_step`.

    lanes : their number
    dt : the sample [s]
    p2 : of the model [1/s2]
    outward, inward : (pieces in a unit of y, y at which the wall has overturned, y of collapse) of both sides
    state : rows of this module, shape (ROWS * ROW,)
    """
    widest_vectors()
    one = dt / dt
    for k in range((lanes + VECTOR - 1) // VECTOR * VECTOR):
        y, speed, sign, scale = state[Y + k], state[SPEED + k], state[SIGN + k], state[SCALE + k]
        ground, peak, piece = state[GROUND + k], state[PEAK + k], state[PIECE_HELD + k]
        slope = scale * (state[GROUND_AHEAD + k] - ground) / dt
        out = sign > 0.0
        pieces, end, top = (
            outward[0] if out else inward[0],
            outward[1] if out else inward[1],
            outward[2] if out else inward[2],
        )
        s, per = 2.0 * (y * pieces - piece) - 1.0, 2.0 * pieces
        v, x = (
            shift_polynomial(s, coefficients(FIRST_V, k, state)),
            shift_polynomial(s, coefficients(FIRST_X, k, state)),
        )
        terms = terms_of(speed, sign / G * (scale * ground), sign / G * slope, p2, per, v, x)
        added, after, pushed, bent = moved(terms, dt), speed_of(terms, dt), push_of(terms, dt), terms[1]
        reached = y + added
        # twice the push at both ends: between them it is more only where it turns round within a step that is far too
        # long for the series to hold
        steepest = 2.0 * max(abs(2.0 * bent), abs(pushed))
        strays = 0.25 * steepest * dt * dt
        onward = ((speed > 0.0) & (after > 0.0)) | ((speed < 0.0) & (after < 0.0))
        tops = (speed > 0.0) & (after < 0.0) & (max(y, reached) + strays <= peak)
        swings = ((bent > 0.0) == (speed < 0.0)) & ((pushed > 0.0) != (bent > 0.0))
        turns = tops | (onward & ((abs(speed) > dt * steepest) | (not swings)))
        within = (abs(s + per * added) <= OVERLAP) & (reached > 0.0) & (reached <= end)
        plain = turns & within & has_converged(terms[7], dt, top)
        higher, y, speed, peak = max(peak, reached), one * y, one * speed, one * peak
        state[Y + k] = reached if plain else y
        state[SPEED + k] = after if plain else speed
        state[PEAK + k] = higher if plain else peak
        state[PIECE_REACHED + k] = min(np.floor(reached * pieces), PIECES - 1.0)
        state[PLAIN + k] = 1.0 if plain else 0.0


@inner_kernel
def set_piece(k, piece, outward, inward, state):
    """Set the coefficients of lane k. piece : its number, of outward or inward, Side"""
    side = outward if state[SIGN + k] > 0.0 else inward
    state[PIECE_HELD + k] = piece
    for n in range(DEGREE + 1):
        state[FIRST_V + n * ROW + k] = side.values[int(piece), V, n]
        state[FIRST_X + n * ROW + k] = side.values[int(piece), X, n]


@subkernel
def advance_to_motion(k, moving, i, end, scale, ground, dt, model, thresholds, outward, inward, none, both, state):
    """Carry lane k through the sample i, and on while it rests at the end of one.

    k : lane
    moving : False at rest
    i, end : samples of `ground`, the last one of its record
    scale : multiplier [-]
    ground : [m/s2], shape (n,)
    dt : the sample [s]
    model : RockingModel, without `bending`
    thresholds : of `uplift_thresholds` [m/s2]
    outward, inward : Side
    none : in place of the impacts, which nobody wants, shape (0,)
    both : largest y of both sides of the lane, shape (2,)
    state : rows of this module, shape (ROWS * ROW,)
    Returns (sample it is at, whether the analysis is over, outcome).
    """
    y, speed, sign = state[Y + k], state[SPEED + k], state[SIGN + k]
    both[0 if sign > 0.0 else 1] = state[PEAK + k]
    outcome = STABLE
    up, down = (0, 1) if scale > 0.0 else (1, 0)
    low, high = -SAFE_SHARE * thresholds[down] / abs(scale), SAFE_SHARE * thresholds[up] / abs(scale)
    while True:
        if not moving:
            while i < end and low <= ground[i] <= high and low <= ground[i + 1] <= high:
                i += 1
        if i >= end:
            break
        ground0, slope = scale * ground[i], scale * (ground[i + 1] - ground[i]) / dt
        y, speed, sign, moving, _, outcome = through_sample(
            y, speed, sign, moving, 0, 0.0, ground0, slope, dt, model, thresholds, outward, inward, none, none, both
        )
        i += 1
        if moving or outcome != STABLE:
            break
    state[Y + k], state[SPEED + k], state[SIGN + k] = y, speed, sign
    state[PEAK + k] = both[0 if sign > 0.0 else 1]
    side = outward if sign > 0.0 else inward
    state[PIECE_REACHED + k], state[PIECE_HELD + k] = min(np.floor(y * side.scale), PIECES - 1.0), -1.0
    over = outcome != STABLE or i >= end
    if over and outcome == STABLE:
        outcome = outcome_after_record(y, speed, sign, moving, model, outward, inward, both)
    return i, over, outcome


@kernel
def one_pass(
    ground,
    dt,
    firsts,
    lasts,
    strongest,
    which,
    scales,
    model,
    outward,
    inward,
    numbers,
    both,
    none,
    state,
    outcomes,
    peaks,
):
    """Carry out these analyses, up to MAX_HELD_LANES at a time.

    ground : of `Grounds` [m/s2], shape (n,)
    dt : the sample [s]
    firsts, lasts : of `Grounds`, int64, shape (records,)
    strongest : of `Grounds` [m/s2], shape (records,)
    which : record of each analysis, int64, shape (m,)
    scales : multipliers [-], shape (m,), negative reverses the record
    model : RockingModel, without `bending`
    outward, inward : Side
    numbers : room to work, int64, shape (3, MAX_HELD_LANES)
    both : room to work, shape (MAX_HELD_LANES, 2)
    none : of `advance_to_motion`, shape (0,)
    state : rows of this module, zeros, shape (ROWS * ROW,)
    outcomes : results, codes of outcome.py, int64, shape (m,)
    peaks : results, of theta [rad], shape (m,)
    """
    thresholds = uplift_thresholds(model)
    analysis, sample, end = numbers[0], numbers[1], numbers[2]
    out, inn = (outward.scale, outward.end, outward.top), (inward.scale, inward.end, inward.top)
    zero = np.int64(0)  # a plain 0 would be a type of its own
    waiting = lanes = zero
    while True:
        k = zero  # the lanes that have stepped, then new ones in the places that are free
        while k < lanes or (waiting < scales.size and lanes < MAX_HELD_LANES):
            begins = k == lanes
            if begins:
                record = which[waiting]
                analysis[k], sample[k], end[k] = waiting, firsts[record], lasts[record]
                if abs(scales[waiting]) * strongest[record] < SAFE_SHARE * min(thresholds[0], thresholds[1]):
                    sample[k] = end[k]  # it never moves
                both[k, 0], both[k, 1], state[SCALE + k] = 0.0, 0.0, scales[waiting]
                state[Y + k], state[SPEED + k], state[SIGN + k], state[PEAK + k] = 0.0, 0.0, 1.0, 0.0
                state[PLAIN + k] = 0.0
                waiting += 1
                lanes += 1
            over, outcome = False, STABLE
            sample[k] += int(state[PLAIN + k])
            if state[PLAIN + k] == 0.0 or sample[k] >= end[k]:
                sample[k], over, outcome = advance_to_motion(
                    k,
                    not begins,
                    sample[k],
                    end[k],
                    state[SCALE + k],
                    ground,
                    dt,
                    model,
                    thresholds,
                    outward,
                    inward,
                    none,
                    both[k],
                    state,
                )
            if over:
                outcomes[analysis[k]] = outcome
                peaks[analysis[k]] = max(turned_by(both[k, 0], outward), turned_by(both[k, 1], inward))
                lanes -= 1
                both[k, 0], both[k, 1] = both[lanes, 0], both[lanes, 1]
                for n in range(3):
                    numbers[n, k] = numbers[n, lanes]
                for row in range(0, ROWS * ROW, ROW):
                    state[row + k] = state[row + lanes]
                continue
            state[GROUND + k], state[GROUND_AHEAD + k] = ground[sample[k]], ground[sample[k] + 1]
            if state[PIECE_REACHED + k] != state[PIECE_HELD + k]:
                set_piece(k, state[PIECE_REACHED + k], outward, inward, state)
            k += 1
        if lanes == 0:
            return
        vector_step_held(lanes, dt, model.p2, out, inn, state)


def scan(grounds: Grounds, which, scales, model: RockingModel, outcomes, peaks) -> np.ndarray:
    """`history.scan_records` of a wall held at its top; no velocity ratio is ever clamped."""
    bare, outward, inward = split_model(model)
    rows = np.zeros(ROWS * ROW + VECTOR)
    start = -rows.ctypes.data // rows.itemsize % VECTOR  # no vector lies in two lines of the processor's cache
    one_pass(
        grounds.ground,
        grounds.dt,
        grounds.first,
        grounds.last,
        grounds.strongest,
        which,
        scales,
        bare,
        outward,
        inward,
        np.zeros((3, MAX_HELD_LANES), np.int64),
        np.zeros((MAX_HELD_LANES, 2)),
        np.zeros(0),
        rows[start : start + ROWS * ROW],
        outcomes,
        peaks,
    )
    return np.zeros(scales.size, np.int64)
