"""Analyses of a two-sided body that is not symmetric: another alpha, p and velocity ratio about each hinge.

The step is that of taylor.py, compiled for a model with an OtherSide. One analysis after another: what a side
decides is no constant of the vector loops of lanes.py.
"""

import numpy as np

from core.jit.decorators import kernel
from core.rocking.early_stop import LOOKAHEAD
from core.rocking.events import IMPACTS_PER_SAMPLE, BlockState
from core.rocking.outcome import IMPACT_LIMIT, STABLE
from core.rocking.taylor import at_end, through_sample
from core.rocking.taylor_series import PER_G, wall_constants

ORDER = 8


@kernel
def scan_two_hinges(ground, ahead, dt, firsts, lasts, strongest, which, scales, model, outcomes, peaks, clamped):
    """Analyses from rest, each until its record ends or the body cannot recover.

    ground, ahead, dt, firsts, lasts, strongest, which, scales : as lane_scheduler.py `one_pass`
    model : RockingModel of the rigid law, without bars
    outcomes, peaks, clamped : results, as there
    """
    constants = wall_constants(model, dt)
    right, left = constants.thresholds
    zero = np.int64(0)
    for k in range(scales.size):
        scale, record = scales[k], which[k]
        strength = abs(scale) * strongest[record] * PER_G
        state = BlockState(1.0, 0.0, 0.0, False, 2, 0.0, zero, zero)
        outcome, i, last = STABLE, firsts[record], lasts[record]
        while i < last and outcome == STABLE:
            if not state.moving:
                one, other = scale * ahead[0, i], scale * ahead[1, i]
                if max(one, other) <= right and min(one, other) >= -left:
                    i = min(i + LOOKAHEAD - 1, last)
                    continue
            t, before = 0.0, state.impacts
            while t < 1.0 and outcome == STABLE:
                outcome, t, _, state = through_sample(
                    scale * ground[i], scale * ground[i + 1], dt, model, constants, ORDER, strength, state, t
                )
                if state.impacts - before > IMPACTS_PER_SAMPLE:
                    outcome = IMPACT_LIMIT
            i += 1
        peak = state.peak
        if outcome == STABLE:
            outcome, peak = at_end(state, model)
        outcomes[k], peaks[k], clamped[k] = outcome, peak, state.clamped


def scan(grounds, which, scales, model, outcomes, peaks) -> np.ndarray:
    """`core.rocking.history.scan_records` of such a body; parameters as there. Returns the clamped velocity ratios of
    each, shape (m,)."""
    clamped = np.zeros(scales.size, np.int64)
    records = grounds.first, grounds.last, grounds.strongest
    scan_two_hinges(grounds.ground, grounds.ahead, grounds.dt, *records, which, scales, model, outcomes, peaks, clamped)
    return clamped
