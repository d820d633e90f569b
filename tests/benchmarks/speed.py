"""Speed of the methods, of the search and of the example batch, each also against a fixed loop.

    python3 run.py bench

Whole batches are timed as processes; the loop of sin and cos is measured in the same run, so that
machines compare by the last column. Last come kernels compiled for the narrower vectors this processor has too.
"""

import math
import os
import platform
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

from core.capacity.ida import Search, incremental_dynamic_analysis
from core.jit.decorators import kernel
from core.jit.shipped import has_wide_vectors
from core.rocking.grounds import Grounds
from core.rocking.history import integrate_history, scan_records
from core.rocking.methods import AUTO, METHODS
from core.threads import Threads
from core.wall.block import Block
from core.wall.moment_rotation import LAWS
from core.wall.restitution import restitution
from core.wall.rocking_model import rocking_model
from tests.benchmarks.inputs import MOVING, Command
from tests.benchmarks.processes import Amount, measured

ROOT = Path(__file__).resolve().parents[2]
EXAMPLE = ROOT / "resources" / "cases" / "example.toml"

LOOP = 2_000_000


@kernel
def sine_cosine_loop(n):
    """A fixed dependent loop of sin and cos: the yardstick of this machine."""
    x = 0.5
    for _ in range(n):
        x = math.sin(x) + math.cos(x)
    return x


def median_seconds(call, repeats: int = 7) -> float:
    """Median wall time of a call after one warm-up [s]."""
    call()
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        call()
        times.append(time.perf_counter() - start)
    return statistics.median(times)


def model_of(one_sided: bool, law: str = "rigid"):
    block = Block.rectangle(7.0, math.radians(6.8))
    name = "one_sided_theoretical" if one_sided else "housner"
    return rocking_model(block, one_sided, restitution(block, name), LAWS[law])


def process(cache: str | None, *words) -> float:
    """Wall time of a process of the program's Python [s]. cache : folder of its kernels, else that of the tests"""
    variables = dict(os.environ, PYTHONPATH=str(ROOT))
    if cache:
        variables["RIBALTA_CACHE"] = cache
    start = time.perf_counter()
    subprocess.run([sys.executable, "-P", *words], check=True, env=variables)
    return time.perf_counter() - start


def batch_seconds(case: Path, cache: str | None) -> float:
    """Wall time of a batch as its own process [s]."""
    with tempfile.TemporaryDirectory() as folder:
        seconds = process(cache, "-m", "app", "--batch", case, "--output", folder, "--quiet")
        assert (Path(folder) / f"{case.stem}.json").exists()
        return seconds


def first_analysis_seconds(case: Path, cache: str | None) -> float:
    """Start of the process to the end of the first analysis of a case, its motions made, warm kernels [s]."""
    return process(cache, "-m", "tests.benchmarks.first_analysis", case)


def line(label: str, value: float, unit: str, loops: float) -> None:
    print(f"{label:58} {value:12.4g} {unit:22} {loops:10.4g}")


def main(options: Command) -> None:
    """Print the table."""
    repeats, turns = options.number(7, 1), options.number(LOOP, 1000)
    yardstick = median_seconds(lambda: sine_cosine_loop(turns), repeats) / turns
    print(f"{platform.processor() or platform.machine()}, {os.cpu_count()} cores, Python {platform.python_version()}")
    print(f"{'measured':58} {'value':>12} {'unit':22} {'in loops':>10}")
    line("loop of sin and cos", yardstick * 1e9, "ns per turn", 1.0)
    data = np.loadtxt(ROOT / "resources/reference/standard_record.csv", delimiter=",", skiprows=1)
    ground = np.ascontiguousarray(options.few(data[:, 1], *MOVING))
    pga = float(np.abs(ground).max())
    # spread as a search has them: with one multiplier all lanes would fall together
    scales, outcomes, peaks = np.linspace(0.8, 1.2, 64), np.zeros(64, np.int64), np.zeros(64)
    grounds, which = Grounds.of([ground], 0.01), np.zeros(64, np.int64)
    for law in ("rigid", "doherty"):
        for label, method in METHODS.items():
            model = model_of(False, law)
            if label == "linearised" and law != "rigid":
                continue
            peaks[:] = 0.0
            seconds = median_seconds(
                lambda m=method, w=model: scan_records(m, grounds, which, scales, w, outcomes, peaks), repeats
            )
            assert (peaks > 0.0).all(), f"{label}: a wall that did not move"
            each = seconds / (scales.size * (ground.size - 1))
            line(f"{label}, standard, {law}", each * 1e9, "ns per sample", each / yardstick)
            if label in ("taylor", "taylor_6"):
                # many calls: the first ones find the processor's caches and branch predictor cold
                calls = options.number(400, 7)
                seconds = median_seconds(lambda m=method, w=model: integrate_history(ground, 0.01, 1.0, w, m), calls)
                assert integrate_history(ground, 0.01, 1.0, model, method).impact_time.size > 0
                each = seconds / (ground.size - 1)
                name = f"{label}, one history at a time, standard, {law}"
                line(name, each * 1e9, "ns per sample", each / yardstick)
    for label, one_sided in (("two-sided", False), ("one-sided", True)):
        model = model_of(one_sided)

        def search(w=model):
            found = incremental_dynamic_analysis(ground, 0.01, pga, 1, w, AUTO, Search())
            assert found.status == "collapse_found", found.status
            return found

        seconds = median_seconds(search, min(repeats, 5))
        analyses = search().analyses
        line(f"search, {label}: analyses per second", analyses / seconds, "1/s", seconds / analyses / yardstick)
        line(f"search, {label}, {analyses} analyses", seconds * 1e3, "ms", seconds / yardstick)

    def searches(jobs: int) -> float:
        tasks = {k: lambda stop, w=model_of(k < 8): search(w) for k in range(16)}
        done: list[int] = []
        start = time.perf_counter()
        Threads(jobs, lambda: False).run(tasks, lambda key, result: done.append(key))
        seconds = time.perf_counter() - start
        assert sorted(done) == list(tasks)
        return seconds

    # in turn: the machine's pace changes
    pairs = [(searches(1), searches(2)) for _ in range(options.number(15, 1))]
    ratio = statistics.median(one / two for one, two in pairs)
    line("16 searches: time of one thread over that of two", ratio, "times", min(pairs)[0] / yardstick)
    with tempfile.TemporaryDirectory() as folder:
        cache, times = options.kernels(folder), options.number(5, 1)
        cold = batch_seconds(EXAMPLE, cache)
        line("example batch, cold kernels", cold, "s", cold / yardstick)
        warm = statistics.median(batch_seconds(EXAMPLE, cache) for _ in range(times))
        line("example batch, warm kernels", warm, "s", warm / yardstick)
        first_analysis_seconds(EXAMPLE, cache)  # it compiles what a batch does not use
        first = statistics.median(first_analysis_seconds(EXAMPLE, cache) for _ in range(times))
        line("start to first analysis, warm kernels", first, "s", first / yardstick)
        if has_wide_vectors():
            level = "x86-64-v3"
            measured(cache, level, Amount.of(options))  # it compiles
            for name, turns in measured(cache, level, Amount.of(options)).items():
                line(f"{name}, code for {level}", turns * yardstick * 1e9, "ns per sample", turns)
