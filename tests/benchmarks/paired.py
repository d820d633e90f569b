"""Two states of the code measured in turn, in pairs, on one machine: what changed, whatever else it does.

    python3 run.py bench --paired OTHER_TREE [--pairs N]

Each pair runs this file in a process of its own, once with OTHER_TREE and once with this tree; both keep their kernels
in a cache of their own, compiled before the first pair. Printed: median and range of this tree's time over the
other's, and the ratio of the smallest times, which the machine's neighbours disturb least.
"""

import json
import math
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SAMPLES, TIME_STEP, MULTIPLIERS = 2000, 0.01, 256


def best_seconds(call, repeats: int) -> float:
    """Smallest time of a call [s]."""
    call()
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        call()
        times.append(time.perf_counter() - start)
    return min(times)


def figures() -> dict[str, float]:
    """Name -> time [s], of the tree that is first on the path."""
    import numpy as np

    try:
        from core.capacity.ida import Search, incremental_dynamic_analysis
        from core.rocking.history import history, scan
        from core.rocking.methods import METHODS
        from core.wall.rocking_model import RockingModel
    except ImportError:  # version 0.3.0
        from core.ida import Search, incremental_dynamic_analysis

        from core.rocking import METHODS, RockingModel, history, scan
    random = np.random.default_rng(2)
    walk = np.cumsum(random.normal(size=SAMPLES))
    walk -= np.linspace(0.0, walk[-1], SAMPLES)
    walk *= 2.5 / np.abs(walk).max() * np.sin(np.arange(SAMPLES) * np.pi / SAMPLES)
    ground = np.ascontiguousarray(6.0 * np.diff(walk, append=0.0) + 0.3 * walk)
    pga, alpha, found = float(np.abs(ground).max()), math.radians(6.8), {}
    walls = {"two-sided": (0.0, 0.979, 0.0, 0.0), "one-sided": (1.0, 0.45, 0.0, 0.0),
             "trilinear": (0.0, 0.979, 0.06, 0.28)}  # fmt: skip
    scales = np.linspace(0.8, 1.6, MULTIPLIERS)
    outcomes, peaks = np.zeros(MULTIPLIERS, np.int64), np.zeros(MULTIPLIERS)
    taylor = METHODS["taylor"]
    for name, (one_sided, ratio, first, last) in walls.items():
        model = RockingModel(alpha, 2.0866, one_sided, ratio, 0.0, first * alpha, last * alpha)

        def lanes(model=model):
            scan(taylor, ground, TIME_STEP, scales, model, outcomes, peaks)

        def search(model=model):
            incremental_dynamic_analysis(ground, TIME_STEP, pga, 1, model, taylor, Search())

        found[f"lanes, {name}"] = best_seconds(lanes, 9)
        found[f"search, {name}"] = best_seconds(search, 5)
        found[f"history, {name}"] = best_seconds(
            lambda model=model: history(ground, TIME_STEP, 1.2, model, taylor), 40
        )
    # steps that are taken in parts: 0.05 s under a wall of 1 m, and a stiff elastic branch
    for name, dt, model in (
        ("long steps", 0.05, RockingModel(alpha, 14.6, 0.0, 0.979, 0.0, 0.0, 0.0)),
        ("stiff", TIME_STEP, RockingModel(alpha, 4.87, 1.0, 0.45, 0.0, 0.02 * alpha, 0.28 * alpha)),
    ):

        def searched(model=model, dt=dt):
            incremental_dynamic_analysis(ground, dt, pga, 1, model, taylor, Search())

        found[f"search, {name}"] = best_seconds(searched, 3)
    model = RockingModel(alpha, 2.0866, 0.0, 0.979, 0.0, 0.0, 0.0)
    for name in ("newmark_paper", "newmark_events", "rk4", "dormand_prince", "linearised"):
        found[name] = best_seconds(
            lambda name=name: history(ground, TIME_STEP, 1.2, model, METHODS[name]), 12
        )
    return found


def measured(tree: Path, cache: str) -> dict[str, float]:
    """`figures` of a tree in a process of its own."""
    variables = dict(os.environ, PYTHONPATH=str(tree), RIBALTA_CACHE=cache)
    command = [sys.executable, "-P", __file__]
    done = subprocess.run(command, env=variables, capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def main(other: Path, pairs: int) -> None:
    """Print the table."""
    with tempfile.TemporaryDirectory() as folder:
        trees = {tree: f"{folder}/{k}" for k, tree in enumerate((other.resolve(), ROOT))}
        for tree, cache in trees.items():
            measured(tree, cache)
        runs = [[measured(tree, cache) for tree, cache in trees.items()] for _ in range(pairs)]
    print(
        f"{'this tree over the other':24} {'median':>7} {'range':>15} {'smallest':>9} {'time':>12}"
    )
    for name in runs[0][0]:
        ratios = sorted(mine[name] / theirs[name] for theirs, mine in runs)
        best = [min(run[k][name] for run in runs) for k in (0, 1)]
        print(f"{name:24} {statistics.median(ratios):7.3f} {ratios[0]:7.3f}-{ratios[-1]:.3f} "
              f"{best[1] / best[0]:9.3f} {1e3 * best[1]:9.3f} ms")  # fmt: skip


if __name__ == "__main__":
    print(json.dumps(figures()))
