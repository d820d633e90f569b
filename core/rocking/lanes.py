"""Operations on all lanes of a pass at once.

Loops without branches over contiguous lanes, which the compiler turns into vector instructions (where every value is
loaded before the conditions: a load under one, `a[k] if c else b`, keeps a loop scalar): the initial terms of
the step to the end of each lane's sample, its Taylor coefficients, what comes of it, and the impacts of the lanes
that fall. A step whose series has not converged is taken in parts, down to a sixteenth. A lane whose step is not that
plain (a kink, a new peak, an outward pull while it falls) takes it by `lane_events.scalar_step`, so that results
equal those of single analyses bit for bit (resources/docs/physics.md, section 10).
"""

from core.jit.decorators import inner_kernel, subkernel, widest_vectors
from core.jit.fma import fma
from core.jit.kernel import value_unless_none
from core.rocking.lane_state import (
    ACTION,
    BETA,
    CHECK,
    CONSTANT,
    COSINE,
    END_TIME,
    FACTOR,
    FALL,
    FALLS,
    FIRST,
    FIRST_BEFORE,
    FORCING,
    GROWTH,
    HELD,
    HIGH,
    IMPACTS,
    IMPACTS_BEFORE,
    LEFT,
    LONG,
    LOW,
    MOVES,
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
    STEPPED,
    TIME,
    VECTOR,
    YIELDS,
)
from core.rocking.series_with_bars import (
    bounds_held,
    initial_terms_held,
    strength_with_springs,
    taylor_coefficients_held,
    wall_alone,
)
from core.rocking.short_series import SHORT_SERIES, sine_and_cosine_short
from core.rocking.taylor import climbs, peak_may_grow
from core.rocking.taylor_bounds import (
    MAX_GROWTH,
    largest_push,
    neglected,
    plus,
    relative_tolerance,
    shortened,
    turning_margin,
)
from core.rocking.taylor_polynomial import landing, speed_increment, step_shape, whole_step
from core.rocking.taylor_series import InitialTerms, constants_seen
from core.wall.moment_rotation import NEVER_REACHED

MAX_HALVINGS = 4
"""Parts of a step that are taken by vector instructions: down to a sixteenth."""


@inner_kernel
def lane_branch(k, slopes, state):
    """(factor, slope, constant, cosine factor) of the branch of lane k; slope and constant None for the rigid law.

    slopes : None for the rigid law, for which the loops are compiled without the terms of a slope, else 1.0
    """
    slope, constant = value_unless_none(slopes, state[SLOPE + k]), value_unless_none(slopes, state[CONSTANT + k])
    return state[FACTOR + k], slope, constant, state[HELD + k]


@inner_kernel
def lower_end(k, slopes, state):
    """Rotation at which the branch of lane k begins [rad]: that of the rigid law at 0. slopes : of `lane_branch`"""
    if slopes is None:
        return 0.0
    return state[LOW + k]


@inner_kernel
def may_reach_upper_end(k, slopes, upper, v, after, bend, reach, margin, bars, state):
    """Whether lane k may come to the end of its branch within the step; the rigid law has one.

    k : lane
    slopes : of `lane_branch`
    upper : larger rotation of the ends of the step [rad]
    v, after : of `series_of`, and its speed at the end of the step [rad per step]
    bend : of `shape`; of walls without bars, which come there less often, it is left to the scalar step
    reach, margin : how far the step strays from its chord [rad], and its speed [rad per step]
    bars : rows of the bars, or None
    state : of lane_state.py, shape (ROWS * ROW,)
    """
    if slopes is None:
        return False
    high = state[HIGH + k]
    near = (high - upper <= reach) & (max(v[0], after) >= -margin)
    if bars is None:
        return near
    return near & climbs(v[0], bend, high - state[PHI + k])


@inner_kernel
def may_unload_yielding_bar(k, slowest, margin, bars, state):
    """Whether lane k may turn back within the step while a bar of it yields.

    k : lane
    slowest : smaller speed of the ends of the step [rad per step]
    margin : how far the speed strays from its chord [rad per step]
    bars : rows of the bars, or None
    state : of lane_state.py, shape (ROWS * ROW,)
    """
    if bars is None:
        return False
    return (state[YIELDS + k] != 0.0) & (slowest <= margin)


@inner_kernel
def classify_scalar_step(k, v, after, x, upper, margin, bars, state):
    """ACTION of lane k where its step is not plain: RISES or SINKS where it moves outward or inward all along, so that
    only an end of a branch of its bars can be what happens, else SCALAR.

    k : lane
    v, after : of `series_of`, and its speed at the end of the step [rad per step]
    x, upper : rotation at the start of the step, and the larger one of its ends [rad]
    margin : how far the speed strays from its chord [rad per step]
    bars : rows of the bars, or None
    state : of lane_state.py, shape (ROWS * ROW,)
    """
    if bars is None:
        return SCALAR
    steady = (state[YIELDS + k] == 0.0) & (upper <= SHORT_SERIES)
    rises = steady & (x < state[HIGH + k]) & (min(v[0], after) > 2.0 * margin)
    sinks = steady & (max(v[0], after) < -2.0 * margin)
    return RISES if rises else (SINKS if sinks else SCALAR)


@inner_kernel
def p2_of(model, other, side):
    """p2 about the hinge of this side. other : OtherSide of the model, which decides at compile time"""
    if other is None:
        return model.p2
    return model.p2 if side > 0.0 else other.p2


@inner_kernel
def ratio_of(model, other, side):
    """Velocity ratio at rest of an impact that leaves the hinge of this side. other : as of `p2_of`"""
    if other is None:
        return model.ratio_at_rest
    return model.ratio_at_rest if side > 0.0 else other.ratio_at_rest


@inner_kernel
def impact_velocity_ratio(model, bars, side, arriving):
    """Velocity ratio of an impact at this speed [rad/s], 1 at an end of a branch of the bars, where side is 0.0. bars :
    their rows, or None"""
    ratio = ratio_of(model, model.other, side) - model.ratio_drop * arriving * arriving
    if bars is None:
        return ratio
    return ratio if side != 0.0 else 1.0


@inner_kernel
def rest_speed(limits, other, side):
    """Speed below which it rests, of both sides, about the hinge of this one. other : as of `p2_of`"""
    if other is None:
        return limits[0]
    return limits[0] if side > 0.0 else limits[1]


@subkernel
def lane_initial_terms(lanes, dt, model, constants, slopes, bars, state):
    """`InitialTerms` of the step of each lane to the end of its sample.

    lanes : their number
    dt : the sample [s]
    model : RockingModel
    constants : WallConstants
    slopes : of `lane_branch`
    bars : rows of the bars, or None
    state : of lane_state.py, shape (ROWS * ROW,)
    """
    widest_vectors()
    for k in range((lanes + VECTOR - 1) // VECTOR * VECTOR):
        second = state[SCALE + k] * state[SECOND + k]
        x = state[PHI + k]
        s, c = sine_and_cosine_short(x)
        branch, side = lane_branch(k, slopes, state), state[SIDE + k]
        start = initial_terms_held(
            x,
            state[SPEED + k],
            s,
            c,
            side,
            state[FIRST + k],
            second,
            state[TIME + k],
            dt,
            branch,
            p2_of(model, model.other, side),
            constants_seen(constants, constants.other, side),
            bars,
        )
        state[SERIES + k] = start.speed
        state[NET + k] = start.net
        state[SINE + k] = start.sine
        state[COSINE + k] = start.cosine
        state[BETA + k] = start.beta
        state[RISE + k] = start.rise
        state[STEP_P2 + k] = start.p2
        state[FORCING + k] = start.forcing


@inner_kernel
def set_higher_terms(k, v, order, state):
    """Set v1 to v8 of the k-th lane; v0 is its speed."""
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
def lane_taylor_coefficients(lanes, constants, order, slopes, bars, state):
    """The Taylor coefficients of each lane from its initial terms. slopes : of `lane_branch`; bars : rows of the bars,
    or None"""
    widest_vectors()
    for k in range((lanes + VECTOR - 1) // VECTOR * VECTOR):
        start = InitialTerms(
            state[SERIES + k],
            state[NET + k],
            state[SINE + k],
            state[COSINE + k],
            state[BETA + k],
            state[RISE + k],
            state[STEP_P2 + k],
            state[FORCING + k],
        )
        branch = lane_branch(k, slopes, state)
        own = bounds_held(constants, branch, bars)
        v, growth = taylor_coefficients_held(state[PHI + k], start, branch, own, order, bars)
        set_higher_terms(k, v, order, state)
        state[GROWTH + k] = growth


@inner_kernel
def series_of(k, order, state):
    """v0 to v8 of the k-th lane, or of the k-th of those that fall."""
    return (
        state[SERIES + k],
        state[SERIES + ROW + k],
        state[SERIES + 2 * ROW + k],
        state[SERIES + 3 * ROW + k],
        state[SERIES + 4 * ROW + k],
        state[SERIES + 5 * ROW + k],
        state[SERIES + 6 * ROW + k],
        state[SERIES + 7 * ROW + k] if order == 8 else 0.0,
        state[SERIES + 8 * ROW + k] if order == 8 else 0.0,
    )


@subkernel
def shorten_steps(lanes, dt, constants, order, slopes, bars, state):
    """Shorten the steps whose series has not converged to the first half, quarter, ... of the step, as
    `taylor_bounds.converged_part`; where MAX_HALVINGS are not enough, GROWTH is MAX_GROWTH or more. Where all steps are
    whole, the rows are as before.

    lanes : their number
    dt : the sample [s]
    constants : WallConstants
    order : of the series, 6 or 8
    slopes : of `lane_branch`
    bars : rows of the bars, or None
    state : of lane_state.py, shape (ROWS * ROW,)
    Returns how many steps are not whole.
    """
    widest_vectors()
    shorter = 0
    for k in range((lanes + VECTOR - 1) // VECTOR * VECTOR):
        v, growth, p2 = series_of(k, order, state), state[GROWTH + k], state[STEP_P2 + k]
        rise, forcing, t = state[RISE + k], state[FORCING + k], state[TIME + k]
        branch = lane_branch(k, slopes, state)
        own = bounds_held(constants_seen(constants, constants.other, state[SIDE + k]), branch, bars)
        omitted = neglected(v, growth, forcing, rise, p2, strength_with_springs(own, branch, bars), order)
        tolerance = constants.tolerance
        relative = relative_tolerance(state[PHI + k], v[0], forcing, p2, wall_alone(branch, bars), own)
        part = 1.0
        for _ in range(MAX_HALVINGS):
            long = (omitted > min(tolerance, relative)) | (growth >= MAX_GROWTH)
            half, quarter = 0.5 if long else 1.0, 0.25 if long else 1.0
            part *= half
            tolerance *= half
            relative *= quarter
            growth *= quarter
            omitted *= (1.0 / 1024.0 if order == 8 else 1.0 / 256.0) if long else 1.0
        v, p2, rise = shortened(v, p2, rise, part)
        state[SERIES + k] = v[0]
        set_higher_terms(k, v, order, state)
        state[STEP_P2 + k] = p2
        state[RISE + k] = rise
        state[GROWTH + k] = NEVER_REACHED if omitted > min(tolerance, relative) else growth
        state[PART + k] = part
        state[PER_STEP + k] = 1.0 / (dt * (1.0 - t)) * (1.0 / part)
        state[END_TIME + k] = fma(part, 1.0 - t, t)
        state[FIRST_BEFORE + k] = state[FIRST + k]
        state[IMPACTS_BEFORE + k] = state[IMPACTS + k]
        shorter += int(part < 1.0) if k < lanes else 0
    return shorter


@subkernel
def restore_partial_steps(lanes, constants, state):
    """Put the lanes that took a part of their sample back into it; `one` as in `vector_step`."""
    widest_vectors()
    one = constants.tolerance / constants.tolerance
    for k in range((lanes + VECTOR - 1) // VECTOR * VECTOR):
        step, ends = state[ACTION + k], state[END_TIME + k]
        t, first, impacts = one * state[TIME + k], one * state[FIRST + k], one * state[IMPACTS + k]
        start, before = one * state[FIRST_BEFORE + k], one * state[IMPACTS_BEFORE + k]
        inside = (state[PART + k] < 1.0) & (step <= CHECK)
        left, sample = (1.0, 0.0) if inside else (0.0, 1.0)
        state[ACTION + k] = sample * step  # STEPPED is 0.0
        state[SAMPLE + k] -= left
        state[LEFT + k] += left
        state[TIME + k] = ends if inside else t
        state[FIRST + k] = start if inside else first
        state[IMPACTS + k] = before if inside else impacts


@subkernel
def vector_step(lanes, dt, constants, order, slopes, bars, state):
    """Take one step of each lane to the end of its sample by its series, where nothing else happens in it, and set
    ACTION of each; of a shortened step, see `restore_partial_steps`. (Initial terms, coefficients and step are three
    loops: in one the processor waits for each lane's results. A value that stays in its row is stored as `one * x`: x
    alone becomes a store under a mask, seven cycles each on AMD's processors.)

    lanes : their number
    dt : the sample [s]
    constants : WallConstants
    order : of the series, 6 or 8
    slopes : of `lane_branch`
    bars : rows of the bars, or None
    state : of lane_state.py, shape (ROWS * ROW,)
    """
    widest_vectors()
    tolerance = constants.tolerance
    one = tolerance / tolerance
    per_dt = 1.0 / dt
    for k in range((lanes + VECTOR - 1) // VECTOR * VECTOR):
        v = series_of(k, order, state)
        p2, rise = state[STEP_P2 + k], state[RISE + k]
        forcing, growth = state[FORCING + k], state[GROWTH + k]
        x = state[PHI + k]
        branch = lane_branch(k, slopes, state)
        own = bounds_held(constants_seen(constants, constants.other, state[SIDE + k]), branch, bars)
        relative = relative_tolerance(x, v[0], forcing, p2, wall_alone(branch, bars), own)
        omitted = neglected(v, growth, forcing, rise, p2, strength_with_springs(own, branch, bars), order)
        long = (omitted > min(tolerance, relative)) | (growth >= MAX_GROWTH)
        low, peak = lower_end(k, slopes, state), state[PEAK + k]
        speed, per_step = state[SPEED + k], state[PER_STEP + k]
        moving, left = state[MOVING + k], state[LEFT + k] - 1.0
        t, first, impacts = state[TIME + k], state[FIRST + k], state[IMPACTS + k]
        second = state[SCALE + k] * state[SECOND + k]
        dphi, dv = whole_step(v)
        y = x + dphi
        upper = max(x, y)
        push = largest_push(upper, forcing, p2, own, *branch[:3])
        reach = 0.125 * push
        margin = turning_margin(v[0], dv, rise, plus(forcing, branch[1]), p2, own.strength, push)
        after = v[0] + dv
        bend, bulges, stays = step_shape(v, x - low, dphi, dv, 1.0)
        near = (min(x, y) - low <= reach) & (min(v[0], after) <= margin)
        falls = near & (not stays)
        tops = (v[0] > -2.0 * margin) & (after < 2.0 * margin) & (not bulges)
        scalar = (
            may_reach_upper_end(k, slopes, upper, v, after, bend, reach, margin, bars, state)
            | (upper > SHORT_SERIES)
            | long
            | (falls & (low != 0.0))
            | (moving == 0.0)
            | may_unload_yielding_bar(k, min(v[0], after), margin, bars, state)
            | ((not falls) & tops & peak_may_grow(x, dphi, v[0], bend, reach, peak))
        )
        stays = scalar | falls
        check = (y > constants.collapse) | (left <= 0.0)
        kind = classify_scalar_step(k, v, after, x, upper, margin, bars, state)
        state[ACTION + k] = (LONG if long else kind) if scalar else (FALLS if falls else (CHECK if check else STEPPED))
        state[SAMPLE + k] += 0.0 if stays else 1.0
        state[LEFT + k] = left + 1.0 if stays else left
        faster, higher = fma(dv, per_step, speed), max(peak, y)
        first, x, speed, peak, per_step = one * first, one * x, one * speed, one * peak, one * per_step
        state[FIRST + k] = first if stays else second
        state[PHI + k] = x if stays else y
        state[SPEED + k] = speed if stays else faster
        state[PEAK + k] = peak if stays else higher
        state[PER_STEP + k] = per_step if stays else per_dt
        goes_on = 1.0 if stays else 0.0
        state[TIME + k] = goes_on * t
        state[IMPACTS + k] = goes_on * impacts


@subkernel
def locate_impacts(falling, dt, model, rest_below, order, bars, state):
    """The impact of each lane that falls: time in the sample, speed after it, whether this located it, and whether the
    wall then rests unless the ground lifts it; of one that comes to an end of a branch of its bars its speed there.

    falling : number of lanes
    dt : the sample [s]
    model : RockingModel
    rest_below : of both sides [rad/s], see `events.stops_rocking`
    order : of the series, 6 or 8
    bars : rows of the bars, or None
    state : PLAIN holds the side of each, see `lane_events.gather_falling`
    """
    widest_vectors()
    shift = FALL - PHI
    for j in range((falling + VECTOR - 1) // VECTOR * VECTOR):
        k = shift + j
        v, side = series_of(k, order, state), state[SCRATCH + j]
        t = state[TIME + k]
        part, top, located = landing(v, state[PHI + k], 1.0)
        speed = fma(speed_increment(v, part), state[PER_STEP + k], state[SPEED + k])
        arriving = max(-speed, 0.0)
        ratio = impact_velocity_ratio(model, bars, side, arriving)
        speed = max(ratio, 0.0) * arriving
        t = fma(part * state[PART + k], 1.0 - t, t)
        plain = located & (top <= state[PEAK + k]) & (part < 1.0) & (t < 1.0) & (ratio >= 0.0)
        after = RESTS if speed < rest_speed(rest_below, model.other, side) else MOVES
        state[SCRATCH + j] = after if plain else NOT_LOCATED
        state[SPEED + k] = speed
        state[TIME + k] = t
        state[PER_STEP + k] = 1.0 / (dt * (1.0 - t))
