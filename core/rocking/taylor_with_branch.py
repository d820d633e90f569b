"""Analyses of a wall with its elastic branch in closed form (oscillator.py), one after another.

Until a wall that rocks both ways first leaves the branch its motion is proportional to the ground: impacts at zero
keep their share, nothing else has a scale. One pass of the record as it is tells for every multiplier when that is; an
analysis begins there, and where it never is it has ended.
"""

import numpy as np

from core.jit.decorators import kernel, subkernel
from core.rocking.early_stop import MAX_SETTLED_RATIO, SETTLED_EVERY, settled
from core.rocking.events import IMPACTS_PER_SAMPLE, BlockState
from core.rocking.outcome import IMPACT_LIMIT, STABLE
from core.rocking.taylor import at_end, through_sample
from core.rocking.taylor_series import PER_G, wall_constants
from core.wall.moment_rotation import FAR
from core.wall.rocking_model import seen_from

ORDER = 8

ROUNDING = 1e-9
"""Share of the end of the branch below which a proportional motion is surely on it."""


@subkernel
def sample_done(scale, ground, i, dt, model, constants, strongest, state):
    """Carry a wall through a sample, to its end.

    scale : multiplier [-], negative for the reversed record
    ground : ground acceleration [m/s2], shape (n,)
    i : the sample, from i to i + 1
    dt : its length [s]
    model : RockingModel
    constants : WallConstants
    strongest, state : of `through_sample`
    Returns (outcome so far, BlockState).
    """
    t, before, outcome = 0.0, state.impacts, STABLE
    while t < 1.0 and outcome == STABLE:
        outcome, t, _, state = through_sample(
            scale * ground[i], scale * ground[i + 1], dt, model, constants, ORDER, strongest, state, t
        )
        if state.impacts - before > IMPACTS_PER_SAMPLE:
            outcome = IMPACT_LIMIT
    return outcome, state


@kernel
def scan_with_branch(
    ground, ahead, dt, firsts, lasts, strongest, which, scales, model, endless, room, outcomes, peaks, clamped
):
    """Analyses from rest, each until its record ends, it is settled or cannot recover; those of one record and sign
    side by side share their first part.

    ground, ahead, dt, firsts, lasts, strongest, which, scales : as lane_scheduler.py `one_pass`
    model : RockingModel with an Oscillator, alike on both sides if it rocks both ways
    endless : the same, its branch without an end
    room : to work, shape (5, longest record)
    outcomes, peaks, clamped : results, as there
    """
    constants = wall_constants(model, dt)
    unbound = wall_constants(endless, dt)
    zero = np.int64(0)
    at_rest = BlockState(1.0, 0.0, 0.0, False, 0, 0.0, zero, zero)
    # Eq. 7 depends on the speed, and counts clamped ratios to the end of the record
    constant = model.ratio_drop == 0.0
    may_settle = constant and model.ratio_at_rest <= MAX_SETTLED_RATIO
    shares = constant and model.one_sided == 0.0
    sides, moving, rotations, speeds, largest = room[0], room[1], room[2], room[3], room[4]
    record, sign = zero - 1, 0.0
    for k in range(scales.size):
        scale = scales[k]
        first, last = firsts[which[k]], lasts[which[k]]
        state, i = at_rest, first
        if shares:
            if which[k] != record or scale * sign <= 0.0:
                record, sign, one = which[k], -1.0 if scale < 0.0 else 1.0, at_rest
                for n in range(last - first + 1):
                    sides[n], moving[n] = one.side, 1.0 if one.moving else 0.0
                    rotations[n], speeds[n], largest[n] = one.phi, one.speed, one.peak
                    if n < last - first:
                        _, one = sample_done(sign, ground, first + n, dt, model, unbound, FAR, one)
            size = abs(scale)
            n, beyond = zero, last - first + 1  # the last sample before which it surely stays on the branch
            while beyond - n > 1:
                middle = (n + beyond) // 2
                if size * largest[middle] < model.elastic_end * (1.0 - ROUNDING):
                    n = middle
                else:
                    beyond = middle
            phi, speed, peak = size * rotations[n], size * speeds[n], size * largest[n]
            state = BlockState(sides[n], phi, speed, moving[n] != 0.0, 0, peak, zero, zero)
            i = first + n
        strength = abs(scale) * strongest[which[k]] * PER_G
        outcome = STABLE
        while i < last and outcome == STABLE:
            outcome, state = sample_done(scale, ground, i, dt, model, constants, strength, state)
            i += 1
            if may_settle and (i - first) % SETTLED_EVERY == 0 and state.moving and outcome == STABLE and i < last:
                seen = seen_from(model, state.side)
                if settled(state.phi, state.speed, state.peak, abs(scale) * ahead[3, i], seen):
                    break
        peak = state.peak
        if outcome == STABLE and i == last:
            outcome, peak = at_end(state, model)
        outcomes[k], peaks[k], clamped[k] = outcome, peak, state.clamped


def scan(grounds, which, scales, model, outcomes, peaks) -> np.ndarray:
    """`core.rocking.history.scan_records` of such a wall; parameters as there. Results are those of whole histories to
    the rounding of their first part. Returns the clamped velocity ratios of each, shape (m,)."""
    clamped = np.zeros(scales.size, np.int64)
    room = np.empty((5, int((grounds.last - grounds.first).max()) + 1))
    motions = grounds.ground, grounds.ahead, grounds.dt, grounds.first, grounds.last, grounds.strongest
    endless = model._replace(elastic_end=FAR)
    scan_with_branch(*motions, which, scales, model, endless, room, outcomes, peaks, clamped)
    return clamped
