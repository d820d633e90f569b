"""What loads and ties cost: a wall whose load lies on the ray of its centroid moves as a bare wall of a stronger
gravity.

    python3 run.py bench --loads [--pairs N]

Both do the same steps, so that the ratio of their times is the cost of a and c alone. The third has a load that holds
its two sides differently; its motion is its own, and the time is per analysed sample of the same record. Then the
facade of resources/cases/building.toml with its tie over the same without, about each of its hinges, in turn.
"""

import math
import statistics
import time

import numpy as np

from core.capacity.ida import Run, Search, incremental_dynamic_analyses, incremental_dynamic_analysis
from core.case.reader import read_case
from core.rocking.history import integrate_history, scan_multipliers
from core.rocking.methods import METHODS
from core.setting.plan import make_plan, read_inputs
from core.wall.block import Block
from core.wall.loads import Force, restoring_moment
from core.wall.moment_rotation import LAWS
from core.wall.restitution import restitution
from core.wall.rocking_model import rocking_model
from tests.benchmarks.inputs import MOVING, Command
from tests.benchmarks.paired import best_seconds
from tests.benchmarks.scenes import reference
from tests.conftest import ROOT


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


def ties(options: Command) -> None:
    """Print the times of the searches of a facade without and with its tie."""
    path = ROOT / "resources" / "cases" / "building.toml"
    case = read_case(path)
    plan = make_plan(case, read_inputs(case, path.parent))
    bare = [entry for entry in plan.entries if entry.part.wall.variant == "stato di fatto"]
    tied = [entry for entry in plan.entries if entry.model.bars]
    assert len(bare) == len(tied) == 3
    print(f"{'searches with the tie over without':32} {'median':>7} {'range':>15}   an analysis, and over without")
    pairs = options.number(options.pairs or 7, 1)
    for free, held in options.few(list(zip(bare, tied, strict=True)), first=2):
        times: dict[bool, list[float]] = {False: [], True: []}
        done = {}
        for entry in (free, held) * (pairs + 1):
            runs = [Run(one.acceleration, one.time_step, one.pga, sign) for one in entry.felt for sign in entry.signs]
            runs = options.few(runs)
            start = time.thread_time()
            found = incremental_dynamic_analyses(runs, entry.model, plan.method, plan.search, lambda: False)
            times[bool(entry.model.bars)].append(time.thread_time() - start)
            done[bool(entry.model.bars)] = sum(ida.analyses for ida in found)
        ratios = sorted(one / other for one, other in list(zip(times[True], times[False], strict=True))[1:])
        each = 1e6 * statistics.median(times[True][1:]) / done[True]
        print(
            f"{held.part.wall.name:32} {statistics.median(ratios):7.3f}   {ratios[0]:.3f}-{ratios[-1]:.3f}   "
            f"{each:.1f} us, {statistics.median(ratios) * done[False] / done[True]:.3f}"
        )


def main(options: Command) -> None:
    """Print the tables."""
    ties(options)
    dt, taylor, pairs = 0.01, METHODS["taylor"], options.number(options.pairs or 7, 1)
    ground = np.ascontiguousarray(options.few(reference("standard"), *MOVING))
    repeats = [options.number(count, 1) for count in (5, 3, 20)]
    multiples = options.few(np.linspace(1.1, 6.0, 256), 8, 128)
    outcomes, peaks = np.zeros(multiples.size, np.int64), np.zeros(multiples.size)
    print(f"{'time with loads over without':32} {'median':>7} {'range':>15}")
    for one_sided in (False, True):
        factor, bare, loaded, unlike = pairs_of(one_sided)
        least = bare.threshold * factor / np.abs(ground).max()
        scales = least * multiples

        def peaks_of(model, by, scales=scales):
            scan_multipliers(taylor, ground / by, dt, scales, model, outcomes, peaks)
            return peaks.copy()

        moved = peaks_of(loaded, 1.0)
        # a one-sided wall is lifted by the larger multipliers; in the median: rounding decides some bounces of a few
        lifted = moved > 0.0
        other = np.median(np.abs(peaks_of(bare, factor)[lifted] / moved[lifted] - 1.0))
        assert lifted.mean() > 0.5 and other < 1e-6, "not the same motion"

        def lanes(model, by, scales=scales):
            return best_seconds(
                lambda: scan_multipliers(taylor, ground / by, dt, scales, model, outcomes, peaks), repeats[0]
            )

        def search(model, by):
            pga = float(np.abs(ground).max()) / by
            return best_seconds(
                lambda: incremental_dynamic_analysis(ground / by, dt, pga, 1, model, taylor, Search()), repeats[1]
            )

        def single(model, by, least=least):
            return best_seconds(lambda: integrate_history(ground / by, dt, 2.0 * least, model, taylor), repeats[2])

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
