"""What the tolerance of a step buys and costs: errors of hostile cases beside the effect of noise, and speed.

    python3 run.py bench --tolerances [--cases N] [--pairs N]

Each pair of tolerances (core/rocking/taylor_bounds.py) has processes of its own, which compile the kernels with it into
a cache of their own. Times are of the processor, the smallest of so many rounds, the pairs measured in turn, over those
of the first.
"""

import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from tests.benchmarks.inputs import Command

ROOT = Path(__file__).resolve().parents[2]

PAIRS = ((1e-17, 1e-15), (1e-16, 1e-14), (1e-15, 1e-13), (1e-14, 1e-12))
"""SERIES_TOLERANCE and RELATIVE_TOLERANCE."""

ROWS = ("lanes", "search", "history")
"""What begins the name of a figure of paired.py that depends on them."""


def with_tolerances(series: float, relative: float, seeds: list[int], amount: list[int]) -> dict:
    """Errors and effects of noise of these cases, or with none of them the seconds of paired.py, in a process
    that has compiled no kernel yet. amount : arguments of `paired.figures`"""
    from core.rocking import taylor_bounds, taylor_series
    from tests.benchmarks import noise_promise, paired

    taylor_series.SERIES_TOLERANCE, taylor_bounds.RELATIVE_TOLERANCE = series, relative
    time.perf_counter = time.process_time  # of this process alone: what the machine's neighbours do does not count
    if seeds:
        return {"found": [tuple(noise_promise.errors(seed)) for seed in seeds]}
    return paired.figures(*amount)


def errors_with(pair: tuple[float, float], seeds: Sequence[int], cache: str | None) -> list[list[float]]:
    """`noise_promise.errors` of these cases with these tolerances."""
    return measured(pair, seeds, (), cache)["found"]


def measured(pair: tuple[float, float], seeds: Sequence[int], amount: Sequence[int], cache: str | None) -> dict:
    """`with_tolerances` in a process of its own. cache : folder of its kernels; None, for the program's pair alone, is
    that of the program"""
    variables = dict(os.environ, PYTHONPATH=str(ROOT)) | ({"RIBALTA_CACHE": cache} if cache else {})
    command = [sys.executable, "-P", __file__]
    asked = json.dumps([*pair, list(seeds), list(amount)])
    done = subprocess.run(command, env=variables, input=asked, capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def main(options: Command) -> None:
    """Print both tables."""
    from core.rocking.taylor_bounds import RELATIVE_TOLERANCE, SERIES_TOLERANCE
    from tests.benchmarks import paired
    from tests.benchmarks.noise_promise import KINDS, TIMES, beyond

    own = (SERIES_TOLERANCE, RELATIVE_TOLERANCE)
    assert own in PAIRS, "the program's tolerances are not among those measured"
    pairs, cases = options.few(PAIRS, first=PAIRS.index(own)), options.number(options.cases, len(KINDS))
    rounds, repeats = options.number(options.pairs or 7, 1), options.number(9, 1)
    amount = options.number(paired.SAMPLES, paired.SAMPLES // 5), repeats
    with tempfile.TemporaryDirectory() as folder:
        caches = {pair: options.kernels(f"{folder}/{pair[0]:g}") for pair in pairs}
        print(f"{'tolerances':14} {'> 1e-9':>7}" + "".join(f" {f'{times:g} x':>6}" for times in TIMES) + "   quiet")
        for pair in pairs:
            found = np.array(errors_with(pair, range(cases), caches[pair]))
            counts = [int(beyond(found, times).sum()) for times in (0.0, *TIMES)]
            quiet = found[found[:, 1] < 1e-11, 0].max(initial=0.0)
            print("{:g}/{:g}".format(*pair).ljust(14) + " {:7} {:6} {:6} {:6} {:6}".format(*counts) + f" {quiet:7.1e}")
        times = [{pair: measured(pair, (), amount, caches[pair]) for pair in pairs} for _ in range(rounds)]
    for name in times[0][pairs[0]]:
        if name.startswith(ROWS):
            best = [min(one[pair][name] for one in times) for pair in pairs]
            print(f"{name:24}" + "".join(f" {seconds / best[0]:7.3f}" for seconds in best))


if __name__ == "__main__":
    print(json.dumps(with_tolerances(*json.load(sys.stdin))))
