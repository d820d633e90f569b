"""What loads cost: a wall whose load lies on the ray of its centroid moves as a bare wall of a stronger gravity.

    python3 run.py bench --loads [--pairs N]

Both do the same steps, so that the ratio of their times is the cost of a and c alone. The third has a load that holds
its two sides differently; its motion is its own, and the time is per analysed sample of the same record.
"""

import argparse
import math
import statistics

import numpy as np

from core.capacity.ida import Search, incremental_dynamic_analysis
from core.rocking.history import history, scan
from core.rocking.methods import METHODS
from core.wall.block import Block
from core.wall.loads import Force, restoring_moment
from core.wall.moment_rotation import LAWS
from core.wall.restitution import restitution
from core.wall.rocking_model import rocking_model
from tests.benchmarks.paired import best_seconds
from tests.benchmarks.scenes import reference
from tests.benchmarks.small import SAMPLES


def pairs_of(one_sided: bool):
    """(ground, bare model and ground factor, loaded model) with the same motion, and one with unlike sides."""
    block = Block.rectangle(7.0, math.radians(6.8))
    free = restitution(block, "one_sided_theoretical" if one_sided else "housner")
    weight = 18e3 * block.height * block.thickness
    held = restoring_moment(block, weight, [Force(0.5 * weight, 0.0, block.thickness, 7.0)])
    loaded = rocking_model(block, one_sided, free, LAWS["rigid"], (held, held))
    bare = rocking_model(block, one_sided, free, LAWS["rigid"])
    bare = bare._replace(p2=held.sine * bare.p2)
    other = restoring_moment(block, weight, [Force(0.5 * weight, 0.0, 0.4 * block.thickness, 7.0)])
    unlike = rocking_model(block, one_sided, free, LAWS["rigid"], (held, other))
    return held.sine, bare, loaded, unlike


def main(options: argparse.Namespace) -> None:
    """Print the table."""
    ground, dt, taylor, n = reference("standard"), 0.01, METHODS["taylor"], 256
    pairs, repeats = (options.pairs or 7), (5, 3, 20)
    if options.small:
        ground, n, pairs, repeats = ground[SAMPLES].copy(), 8, 1, (1, 1, 1)
    outcomes, peaks = np.zeros(n, np.int64), np.zeros(n)
    print(f"{'time with loads over without':32} {'median':>7} {'range':>15}")
    for one_sided in (False, True):
        factor, bare, loaded, unlike = pairs_of(one_sided)
        least = bare.threshold * factor / np.abs(ground).max()
        scales = least * np.linspace(1.1, 6.0, n)

        def peaks_of(model, by, scales=scales):
            scan(taylor, ground / by, dt, scales, model, outcomes, peaks)
            return peaks.copy()

        moved = peaks_of(loaded, 1.0)
        # a one-sided wall is lifted by the larger multipliers; in the median: rounding decides some bounces of a few
        lifted = moved > 0.0
        other = np.median(np.abs(peaks_of(bare, factor)[lifted] / moved[lifted] - 1.0))
        assert lifted.mean() > 0.5 and other < 1e-6, "not the same motion"

        def lanes(model, by, scales=scales):
            return best_seconds(lambda: scan(taylor, ground / by, dt, scales, model, outcomes, peaks), repeats[0])

        def search(model, by):
            pga = float(np.abs(ground).max()) / by
            return best_seconds(
                lambda: incremental_dynamic_analysis(ground / by, dt, pga, 1, model, taylor, Search()), repeats[1]
            )

        def single(model, by, least=least):
            return best_seconds(lambda: history(ground / by, dt, 2.0 * least, model, taylor), repeats[2])

        side = "one-sided" if one_sided else "two-sided"
        for name, call in (("lanes", lanes), ("search", search), ("history", single)):
            ratios = sorted(call(loaded, 1.0) / call(bare, factor) for _ in range(pairs))
            print(f"{f'{name}, {side}':32} {statistics.median(ratios):7.3f}   {ratios[0]:.3f}-{ratios[-1]:.3f}")
        if not one_sided:
            ratios = sorted(lanes(unlike, 1.0) / lanes(loaded, 1.0) for _ in range(pairs))
            print(
                f"{'lanes, sides unlike over alike':32} {statistics.median(ratios):7.3f}   "
                f"{ratios[0]:.3f}-{ratios[-1]:.3f}"
            )
