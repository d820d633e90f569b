"""Two states of the code measured in turn, in pairs, on one machine: what changed, whatever else it does.

    python3 run.py bench --paired OTHER_TREE [--pairs N]

Each pair runs this file in a process of its own, once with OTHER_TREE and once with this tree; both keep their kernels
in a cache of their own, compiled before the first pair. Printed: median and range of this tree's time over the
other's, and the ratio of the smallest times, which the machine's neighbours disturb least. Times are the processor's.
"""

import argparse
import json
import math
import os
import statistics
import subprocess
import sys
import tempfile
import time
from functools import partial
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SAMPLES, TIME_STEP, MULTIPLIERS = 2000, 0.01, 256


def best_seconds(call, repeats: int) -> float:
    """Smallest processor time of a call [s]."""
    call()
    times = []
    for _ in range(repeats):
        start = time.thread_time()
        call()
        times.append(time.thread_time() - start)
    return min(times)


def figures(small: bool) -> dict[str, float]:
    """Name -> time [s], of the tree that is first on the path. small : a fifth of the record, each call twice"""
    import numpy as np

    try:
        from core.capacity.ida import Search, incremental_dynamic_analysis
        from core.rocking.history import history, scan
        from core.rocking.methods import METHODS
        from core.wall.rocking_model import RockingModel
    except ImportError:  # version 0.3.0
        from core.ida import Search, incremental_dynamic_analysis  # type: ignore

        from core.rocking import METHODS, RockingModel, history, scan  # type: ignore
    samples, most = (SAMPLES // 5, 1) if small else (SAMPLES, 40)
    random = np.random.default_rng(2)
    walk = np.cumsum(random.normal(size=samples))
    walk -= np.linspace(0.0, walk[-1], samples)
    walk *= 2.5 / np.abs(walk).max() * np.sin(np.arange(samples) * np.pi / samples)
    ground = np.ascontiguousarray(6.0 * np.diff(walk, append=0.0) + 0.3 * walk)
    pga, alpha, found = float(np.abs(ground).max()), math.radians(6.8), {}
    walls = {
        "two-sided": (0.0, 0.979, 0.0, 0.0),
        "one-sided": (1.0, 0.45, 0.0, 0.0),
        "trilinear": (0.0, 0.979, 0.06, 0.28),
    }
    scales = np.linspace(0.8, 1.6, MULTIPLIERS)
    outcomes, peaks = np.zeros(MULTIPLIERS, np.int64), np.zeros(MULTIPLIERS)
    taylor = METHODS["taylor"]

    def searched(model, dt=TIME_STEP):
        asked = incremental_dynamic_analysis(ground, dt, pga, 1, model, taylor, Search())
        assert asked.q is not None, "a search without a number"

    def moved(model, method=taylor):
        assert history(ground, TIME_STEP, 1.2, model, method).rotation.any(), "a wall at rest"

    for name, (one_sided, ratio, first, last) in walls.items():
        model = RockingModel(alpha, 2.0866, one_sided, ratio, 0.0, first * alpha, last * alpha)

        def lanes(model=model):
            scan(taylor, ground, TIME_STEP, scales, model, outcomes, peaks)

        found[f"lanes, {name}"] = best_seconds(lanes, min(most, 9))
        assert (peaks > 0.0).all()
        found[f"search, {name}"] = best_seconds(partial(searched, model), min(most, 5))
        found[f"history, {name}"] = best_seconds(partial(moved, model), most)
    # steps that are taken in parts: 0.05 s under a wall of 1 m, and a stiff elastic branch
    for name, dt, model in (
        ("long steps", 0.05, RockingModel(alpha, 14.6, 0.0, 0.979, 0.0, 0.0, 0.0)),
        ("stiff", TIME_STEP, RockingModel(alpha, 4.87, 1.0, 0.45, 0.0, 0.02 * alpha, 0.28 * alpha)),
    ):
        found[f"search, {name}"] = best_seconds(partial(searched, model, dt), min(most, 3))
    model = RockingModel(alpha, 2.0866, 0.0, 0.979, 0.0, 0.0, 0.0)
    for name in ("newmark_paper", "newmark_events", "rk4", "dormand_prince", "linearised"):
        found[name] = best_seconds(partial(moved, model, METHODS[name]), min(most, 12))
    return found


def measured(tree: Path, cache: str | None, *words: str) -> dict[str, float]:
    """`figures` of a tree in a process of its own. cache : folder of its kernels, else that of the tests"""
    variables = dict(os.environ, PYTHONPATH=str(tree))
    if cache:
        variables["RIBALTA_CACHE"] = cache
    command = [sys.executable, "-P", __file__, str(tree), *words]
    done = subprocess.run(command, env=variables, capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def main(options: argparse.Namespace) -> None:
    """Print the table."""
    both = (options.paired.resolve(), ROOT)
    if options.small:
        runs = [[measured(tree, None, "--small") for tree in both]]
    else:
        with tempfile.TemporaryDirectory() as folder:
            trees = [(tree, f"{folder}/{k}") for k, tree in enumerate(both)]
            for tree, cache in trees:
                measured(tree, cache)
            runs = [[measured(*tree) for tree in trees] for _ in range(options.pairs)]
    print(f"{'this tree over the other':24} {'median':>7} {'range':>15} {'smallest':>9} {'time':>12}")
    for name in runs[0][0]:
        ratios = sorted(mine[name] / theirs[name] for theirs, mine in runs)
        best = [min(run[k][name] for run in runs) for k in (0, 1)]
        print(
            f"{name:24} {statistics.median(ratios):7.3f} {ratios[0]:7.3f}-{ratios[-1]:.3f} "
            f"{best[1] / best[0]:9.3f} {1e3 * best[1]:9.3f} ms"
        )


if __name__ == "__main__":
    import core

    given = core.__path__[0]
    assert Path(given).resolve().is_relative_to(sys.argv[1]), f"{given} is measured in place of {sys.argv[1]}"
    print(json.dumps(figures("--small" in sys.argv)))
