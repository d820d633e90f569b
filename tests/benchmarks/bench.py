"""Speed of the methods, of the search and of the example batch, each also against a fixed loop.

    python3 run.py bench
    python3 run.py bench --work-precision [--output DIR]    error against time, see work_precision.py
    python3 run.py bench --q-error [--output DIR]           error of q against time, see q_error.py
    python3 run.py bench --loads                           what loads cost, see loads.py
    python3 run.py bench --paired OTHER_TREE               this tree against another, see paired.py
    python3 run.py bench --steps [--output DIR]             q against the step, see step_study.py
    python3 run.py bench --zeta                             zeta of the dynamic check against its grid
    python3 run.py bench --memory                           peak memory and time of large work
    python3 run.py bench --window                           start of the window, redraws, event loop
    python3 run.py bench --screenshots [--output DIR]       every tab, both themes and languages
    python3 run.py bench --records                          a million samples read, 200 files previewed
    python3 run.py bench --screenshots --guide [--output DIR]   the pictures of the guides

Whole batches are timed as processes; the loop of sin and cos is measured in the same run, so that
machines compare by the last column.
"""

import argparse
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

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from core.capacity.ida import Search, incremental_dynamic_analysis  # noqa: E402
from core.jit.decorators import kernel  # noqa: E402
from core.rocking.history import history, scan_records  # noqa: E402
from core.rocking.lane_scheduler import Grounds  # noqa: E402
from core.rocking.methods import AUTO, METHODS  # noqa: E402
from core.study.threads import Threads  # noqa: E402
from core.wall.block import Block  # noqa: E402
from core.wall.moment_rotation import LAWS  # noqa: E402
from core.wall.restitution import restitution  # noqa: E402
from core.wall.rocking_model import rocking_model  # noqa: E402

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


def batch_seconds(cache: str) -> float:
    """Wall time of the example batch as its own process [s]."""
    case = ROOT / "resources" / "cases" / "example.toml"
    variables = dict(os.environ, PYTHONPATH=str(ROOT), RIBALTA_CACHE=cache)
    with tempfile.TemporaryDirectory() as folder:
        start = time.perf_counter()
        subprocess.run(
            [sys.executable, "-P", "-m", "app", "--batch", case, "--output", folder, "--quiet"],
            check=True, env=variables,
        )  # fmt: skip
        return time.perf_counter() - start


def first_analysis_seconds(cache: str) -> float:
    """Start of the process to the end of the first analysis, warm kernels [s]."""
    script = (
        "from core.case.reader import read_case; from core.study import run as study; from pathlib import Path;"
        "from core.study.record_input import read_records;"
        f"p = Path({str(ROOT / 'resources' / 'cases' / 'example.toml')!r}); c = read_case(p);"
        "m, _ = read_records(c, p.parent);"
        "from core.rocking.history import history; w = c.wall[0];"
        "history(m[0].acceleration, m[0].time_step, 1.0, study._model(w, 'two_sided'))"
    )
    variables = dict(os.environ, PYTHONPATH=str(ROOT), RIBALTA_CACHE=cache)
    start = time.perf_counter()
    subprocess.run([sys.executable, "-P", "-c", script], check=True, env=variables)
    return time.perf_counter() - start


def line(label: str, value: float, unit: str, loops: float) -> None:
    print(f"{label:58} {value:12.4g} {unit:22} {loops:10.4g}")


def main() -> None:
    yardstick = median_seconds(lambda: sine_cosine_loop(LOOP)) / LOOP
    print(f"{platform.processor() or platform.machine()}, {os.cpu_count()} cores, "
          f"Python {platform.python_version()}")  # fmt: skip
    print(f"{'measured':58} {'value':>12} {'unit':22} {'in loops':>10}")
    line("loop of sin and cos", yardstick * 1e9, "ns per turn", 1.0)
    data = np.loadtxt(ROOT / "tests/reference/standard_record.csv", delimiter=",", skiprows=1)
    ground = np.ascontiguousarray(data[:, 1])
    pga = float(np.abs(ground).max())
    scales, outcomes, peaks = np.ones(64), np.zeros(64, np.int64), np.zeros(64)
    grounds, which = Grounds.of([ground], 0.01), np.zeros(64, np.int64)
    for law in ("rigid", "doherty"):
        for label, method in METHODS.items():
            model = model_of(False, law)
            if label == "linearised" and law != "rigid":
                continue
            seconds = median_seconds(
                lambda m=method, w=model: scan_records(
                    m, grounds, which, scales, w, outcomes, peaks
                )
            )
            each = seconds / (scales.size * (ground.size - 1))
            line(f"{label}, standard, {law}", each * 1e9, "ns per sample", each / yardstick)
            if label in ("taylor", "taylor_6"):
                seconds = median_seconds(lambda m=method, w=model: history(ground, 0.01, 1.0, w, m))
                each = seconds / (ground.size - 1)
                name = f"{label}, one history at a time, standard, {law}"
                line(name, each * 1e9, "ns per sample", each / yardstick)
    for label, one_sided in (("two-sided", False), ("one-sided", True)):
        model = model_of(one_sided)

        def search(w=model):
            return incremental_dynamic_analysis(ground, 0.01, pga, 1, w, AUTO, Search())

        seconds = median_seconds(search, 5)
        analyses = search().analyses
        line(f"search, {label}: analyses per second", analyses / seconds, "1/s",
             seconds / analyses / yardstick)  # fmt: skip
        line(f"search, {label}, {analyses} analyses", seconds * 1e3, "ms", seconds / yardstick)

    def searches(jobs: int) -> float:
        tasks = {k: lambda stop, w=model_of(k < 8): search(w) for k in range(16)}
        start = time.perf_counter()
        Threads(jobs, lambda: False).run(tasks, lambda key, result: None)
        return time.perf_counter() - start

    pairs = [(searches(1), searches(2)) for _ in range(15)]  # in turn: the machine's pace changes
    ratio = statistics.median(one / two for one, two in pairs)
    line(
        "16 searches: time of one thread over that of two",
        ratio,
        "times",
        min(pairs)[0] / yardstick,
    )
    with tempfile.TemporaryDirectory() as cache:
        cold = batch_seconds(cache)
        line("example batch, cold kernels", cold, "s", cold / yardstick)
        warm = statistics.median(batch_seconds(cache) for _ in range(5))
        line("example batch, warm kernels", warm, "s", warm / yardstick)
        first_analysis_seconds(cache)
        first = statistics.median(first_analysis_seconds(cache) for _ in range(5))
        line("start to first analysis, warm kernels", first, "s", first / yardstick)


if __name__ == "__main__":
    words = argparse.ArgumentParser()
    words.add_argument("--work-precision", action="store_true")
    words.add_argument("--q-error", action="store_true")
    words.add_argument("--steps", action="store_true")
    words.add_argument("--zeta", action="store_true")
    words.add_argument("--memory", action="store_true")
    words.add_argument("--window", action="store_true")
    words.add_argument("--paired", type=Path, metavar="OTHER_TREE")
    words.add_argument("--loads", action="store_true")
    words.add_argument("--pairs", type=int, default=7)
    words.add_argument("--screenshots", action="store_true")
    words.add_argument("--guide", action="store_true")
    words.add_argument("--records", action="store_true")
    words.add_argument("--output", type=Path, default=Path("work_precision"))
    options = words.parse_args()
    if options.work_precision:
        from tests.benchmarks import work_precision

        work_precision.main(options.output)
    elif options.q_error:
        from tests.benchmarks import q_error

        q_error.main(options.output)
    elif options.zeta:
        from tests.benchmarks import zeta_spread

        zeta_spread.main()
    elif options.memory:
        from tests.benchmarks import memory

        memory.main()
    elif options.loads:
        from tests.benchmarks import loads

        loads.main(options.pairs)
    elif options.paired:
        from tests.benchmarks import paired

        paired.main(options.paired, options.pairs)
    elif options.window:
        from tests.benchmarks import window_speed

        window_speed.main()
    elif options.screenshots:
        from tests.benchmarks import screenshots

        (screenshots.guide if options.guide else screenshots.main)(options.output)
    elif options.records:
        from tests.benchmarks import record_speed

        record_speed.main()
    elif options.steps:
        from tests.benchmarks import step_study

        step_study.main(options.output)
    else:
        main()
