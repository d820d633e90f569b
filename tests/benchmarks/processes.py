"""The same lanes and histories in fresh processes, one after another: how far a figure of one process can be trusted.

    python3 run.py bench --processes [--pairs N]

Each of N processes measures its own processor time in turns of its own loop of sin and cos: 64 lanes, the single
history as the median of the first seven calls, and as the median of many.
"""

import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import NamedTuple

from tests.benchmarks.inputs import Command

ROOT = Path(__file__).resolve().parents[2]


class Amount(NamedTuple):
    """How much a process measures. calls : of a history; turns : of the loop; laws : of the walls, one or two"""

    calls: int
    turns: int
    laws: int

    @classmethod
    def of(cls, options: Command) -> "Amount":
        """As much as the words of the command ask for."""
        return cls(options.number(400, 7), options.number(500_000, 1000), options.number(2, 1))


def figures(amount: Amount) -> dict[str, float]:
    """Name -> turns of the loop of sin and cos for one sample, processor time."""
    import numpy as np

    from core.rocking.history import Grounds, integrate_history, scan_records
    from core.rocking.methods import METHODS
    from tests.benchmarks.speed import model_of, sine_cosine_loop

    def seconds(call, repeats: int) -> list[float]:
        call()
        times = []
        for _ in range(repeats):
            start = time.thread_time()
            call()
            times.append(time.thread_time() - start)
        return times

    turn = min(seconds(lambda: sine_cosine_loop(amount.turns), 5)) / amount.turns
    data = np.loadtxt(ROOT / "resources/reference/standard_record.csv", delimiter=",", skiprows=1)
    ground, taylor = np.ascontiguousarray(data[:, 1]), METHODS["taylor"]
    scales, outcomes, peaks = np.linspace(0.8, 1.2, 64), np.zeros(64, np.int64), np.zeros(64)
    grounds, which, samples, found = Grounds.of([ground], 0.01), np.zeros(64, np.int64), ground.size - 1, {}
    for law in ("rigid", "doherty")[: amount.laws]:
        wall = model_of(False, law)

        def lanes(wall=wall):
            scan_records(taylor, grounds, which, scales, wall, outcomes, peaks)

        def single(wall=wall):
            assert integrate_history(ground, 0.01, 1.0, wall, taylor).impact_time.size > 0, "a wall at rest"

        found[f"64 lanes, {law}"] = statistics.median(seconds(lanes, min(amount.calls, 15))) / (
            samples * scales.size * turn
        )
        assert (peaks > 0.0).all()
        times = seconds(single, amount.calls)
        found[f"one history, {law}, 7 calls"] = statistics.median(times[:7]) / (samples * turn)
        found[f"one history, {law}"] = statistics.median(times) / (samples * turn)
    return found


def measured(cache: str | None, level: str | None, amount: Amount) -> dict[str, float]:
    """`figures` of a process of its own. cache : folder of its kernels, else that of the tests; level : of the
    instruction set its kernels are compiled for, a name of `core.jit.shipped.LEVELS`, else this processor's own"""
    variables = dict(os.environ, PYTHONPATH=str(ROOT))
    if cache:
        variables["RIBALTA_CACHE"] = cache
    if level:
        variables["RIBALTA_LEVEL"] = level
    command = [sys.executable, "-P", "-m", "tests.benchmarks.processes", json.dumps(amount)]
    done = subprocess.run(command, env=variables, capture_output=True, text=True, check=True, cwd=ROOT)
    return json.loads(done.stdout)


def main(options: Command) -> None:
    """Print the table."""
    with tempfile.TemporaryDirectory() as folder:
        cache, amount = options.kernels(folder), Amount.of(options)
        measured(cache, None, amount)  # it compiles
        runs = [measured(cache, None, amount) for _ in range(options.number(options.pairs or 7, 1))]
    print(f"{'turns of the loop of sin and cos, a sample':42} {'median':>7} {'range over processes':>22}")
    for name in runs[0]:
        values = sorted(run[name] for run in runs)
        print(f"{name:42} {statistics.median(values):7.3f} {values[0]:14.3f}-{values[-1]:.3f}")


if __name__ == "__main__":
    print(json.dumps(figures(Amount(*json.loads(sys.argv[1])))))
