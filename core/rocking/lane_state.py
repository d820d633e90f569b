"""The state of the lanes: one array of rows, so that the compiler sees that the rows do not overlap, which it needs
to use vector instructions. Row r of lane k is state[r + k], where r is one of the offsets below.

row                       unit            what it holds
SCALE                     -               multiplier of the record
STRONGEST                 -               bound of |u''|/g of the scaled record
FIRST, SECOND             m/s2            ground at the ends of the sample, the first one scaled
SIDE                      -               of the pivot, 1.0 or -1.0
MOVING                    -               0.0 at rest
IMPACTS                   -               so far in this sample
ZONE                      -               branch of the moment law
LOW, HIGH                 rad             ends of that branch
FACTOR, SLOPE, CONSTANT   -               f, m and k of that branch; with bars a, K and C of `series_with_bars`
HELD                      -               its cosine factor
YIELDS                    -               1.0 while a bar yields
ACTION                    -               one of STEPPED, CHECK, FALLS, SINKS, RISES, SCALAR, LONG
SAMPLE                    -               number of the sample
LEFT                      -               samples until the next check of whether the analysis has ended
KINKS, KINK_SAMPLE        -               kinks since the last impact in that sample
PHI, SPEED                rad, rad/s      rotation seen from the pivot and its rate
TIME                      -               where in the sample the lane is, 0 to 1
PER_STEP                  1/s             one over the time of the step
PEAK                      rad             largest rotation so far
PART                      -               of the way to the end of the sample that the step is
SERIES                    rad per step    v0 to v8, nine rows
NET to FORCING            -               of `taylor_series.InitialTerms`; SINE, COSINE of alpha - phi, with bars of phi
GROWTH                    -               of `taylor_series.taylor_coefficients`
END_TIME                  -               TIME at the end of a shortened step
FIRST_BEFORE              m/s2            FIRST before it
IMPACTS_BEFORE            -               IMPACTS before it
FALL                                      rows PHI to v8 of the lanes that fall, gathered side by side; of those that
                                          come to an end of a branch of their bars see `lane_events.fall_to_end`
PLAIN                     -               of such a lane: MOVES or RESTS after an impact located, else NOT_LOCATED
"""

from core.jit.decorators import inner_kernel
from core.rocking.bar_state import bar_pull, thresholds_with
from core.wall.moment_rotation import moment_branch
from core.wall.rocking_model import seen_from

MAX_LANES = 64
"""Lanes of one pass."""

ROW = MAX_LANES + 8
"""Length of a row. Rows of 64 would meet in the same sets of the processor's cache: padded."""

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
    HELD,
    YIELDS,
    ACTION,
    SAMPLE,
    LEFT,
    KINKS,
    KINK_SAMPLE,
    PHI,
    SPEED,
    TIME,
    PER_STEP,
    PEAK,
    PART,
    SERIES,
) = (ROW * row for row in range(27))
LANE_ROWS = 26
"""Rows that move with a lane to another place: all before SERIES."""
FALL_ROWS = 15
"""Rows from PHI to v8."""
(NET, SINE, COSINE, BETA, RISE, STEP_P2, FORCING, GROWTH, END_TIME, FIRST_BEFORE, IMPACTS_BEFORE) = (
    SERIES + ROW * row for row in range(9, 20)
)
FALL = IMPACTS_BEFORE + ROW
SCRATCH = FALL + ROW * FALL_ROWS
ROWS = SCRATCH // ROW + 1

STEPPED, CHECK, FALLS, SINKS, RISES, SCALAR, LONG = 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0
"""ACTION of a lane after a vector step: stepped; the same, and due to be checked for its end; falling to an
impact in its sample; coming to the lower or the upper end of a branch of its bars; to be taken by the scalar step; the
same, as its series has not converged."""

NOT_LOCATED, MOVES, RESTS = 0.0, 1.0, 2.0

VECTOR = 8
"""Lanes are stepped in multiples of this, so that no remainder is left to scalar instructions; those beyond the
last lane hold old states that nobody reads."""


@inner_kernel
def set_lane(k, side, phi, speed, zone, model, state):
    """Set lane k moving with this state, on this branch of the moment law.

    k : lane
    side : of the pivot, 1.0 or -1.0
    phi : rotation seen from the pivot [rad]
    speed : its rate [rad/s]
    zone : branch of the moment law
    model : RockingModel
    state : of this module, shape (ROWS * ROW,)
    """
    state[SIDE + k] = side
    state[PHI + k] = phi
    state[SPEED + k] = speed
    state[MOVING + k] = 1.0
    state[ZONE + k] = zone
    low, high, factor, slope, constant, held = moment_branch(zone, seen_from(model, side))
    state[LOW + k] = low
    state[HIGH + k] = high
    state[FACTOR + k] = factor
    state[SLOPE + k] = slope
    state[CONSTANT + k] = constant
    state[HELD + k] = held


@inner_kernel
def lane_thresholds(k, constants, bars, held):
    """Ground accelerations at which lane k uplifts from rest [m/s2].

    k : lane
    constants : WallConstants
    bars, held : rows of the bars and their state in all lanes, shape (MAX_LANES, bars, 5), or None
    """
    if bars is None:
        return constants.thresholds
    return thresholds_with(constants, bars, held[k])


@inner_kernel
def set_pull(k, bars, held, state):
    """Set the branch on which lane k is by its bars, if it has any. bars, held : as `lane_thresholds`"""
    if bars is not None:
        pull = bar_pull(state[SIDE + k], bars, held[k])
        state[LOW + k] = pull.low
        state[HIGH + k] = pull.high
        state[SLOPE + k] = pull.spring
        state[CONSTANT + k] = pull.constant
        state[YIELDS + k] = 1.0 if pull.yields else 0.0
