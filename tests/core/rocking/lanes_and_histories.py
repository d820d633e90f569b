"""Lanes against whole histories."""

import numpy as np

from core.rocking.history import integrate_history, scan_multipliers
from core.rocking.methods import METHODS
from core.rocking.outcome import COLLAPSED


def assert_lanes_are_histories(ground, dt, scales, model, name="taylor"):
    """Outcomes, peaks and clamped ratios of the lanes are those of whole histories, bit for bit; a block
    that falls is given up on its way. Returns the outcomes."""
    outcomes, peaks = np.zeros(scales.size, np.int64), np.zeros(scales.size)
    clamped = scan_multipliers(METHODS[name], ground, dt, scales, model, outcomes, peaks)
    for k, scale in enumerate(scales):
        whole = integrate_history(ground, dt, scale, model, METHODS[name])
        assert (outcomes[k], clamped[k]) == (whole.outcome, whole.clamped)
        if whole.outcome == COLLAPSED:
            assert model.collapse_rotation * (1.0 - 1e-14) <= peaks[k] <= whole.peak  # a sum of alpha and a lean
        else:
            assert peaks[k] == whole.peak
    return outcomes
