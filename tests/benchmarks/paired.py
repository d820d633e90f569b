"""Two states of the code measured in turn on one core of one machine: what changed, whatever else it does.

    python3 run.py bench --paired OTHER_TREE [--pairs N]

OTHER_TREE, this tree and OTHER_TREE once more, the control, are three processes that live throughout on one core, each
tree with kernels in a cache of its own. Of each figure they take turns of TURN seconds, in another order each time, so
that what the neighbours do falls on all alike. Printed: the median of this tree's processor time over the other's with
the interval that holds it in 19 of 20 such runs, and the same of the control, whose ratio is 1: what it strays by is
what the machine does. A change is one where the two intervals do not meet.

Beside it stand three probes, measured in every turn: a loop that waits for each result (latency), one of packed
products and sums (throughput), and one of more code than the processor keeps decoded (front end). Turns of the first
do not carry to loops of the other kinds: a neighbour on the sibling thread slows them differently.
"""

import contextlib
import json
import math
import os
import platform
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:  # a process of the comparison has the other tree on its path
    from tests.benchmarks.inputs import Command

ROOT = Path(__file__).resolve().parents[2]
SAMPLES, TIME_STEP, MULTIPLIERS = 2000, 0.01, 256

TURN = 0.03
"""Processor time that a process takes before it is the next one's turn [s]."""

PROBES = ("latency", "throughput", "front end")


def best_seconds(call, repeats: int) -> float:
    """Smallest processor time of a call [s]."""
    call()
    times = []
    for _ in range(repeats):
        start = time.thread_time()
        call()
        times.append(time.thread_time() - start)
    return min(times)


def figures(samples: int, repeats: int) -> dict[str, float]:
    """Name -> smallest time [s] of so many `calls`. samples : of the record, at most SAMPLES"""
    return {name: best_seconds(call, repeats) for name, call in calls(samples).items()}


def calls(samples: int) -> dict[str, Callable[[], None]]:
    """Name -> what is measured, of the tree that is first on the path. samples : those in the middle of the record, at
    most SAMPLES"""
    import numpy as np

    try:
        from core.capacity.ida import Search, incremental_dynamic_analysis
        from core.rocking.methods import METHODS
        from core.wall.rocking_model import RockingModel
    except ImportError:  # version 0.3.0
        from core.ida import Search, incremental_dynamic_analysis  # type: ignore

        from core.rocking import METHODS, RockingModel  # type: ignore
    try:
        from core.rocking.history import integrate_history, scan_multipliers
    except ImportError:  # up to 0.32
        from core.rocking.history import history as integrate_history  # type: ignore
        from core.rocking.history import scan as scan_multipliers  # type: ignore
    random = np.random.default_rng(2)
    walk = np.cumsum(random.normal(size=SAMPLES))
    walk -= np.linspace(0.0, walk[-1], SAMPLES)
    walk *= 2.5 / np.abs(walk).max() * np.sin(np.arange(SAMPLES) * np.pi / SAMPLES)
    first = (SAMPLES - samples) // 2
    ground = np.ascontiguousarray((6.0 * np.diff(walk, append=0.0) + 0.3 * walk)[first : first + samples])
    pga, alpha = float(np.abs(ground).max()), math.radians(6.8)
    found: dict[str, Callable[[], None]] = {}
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
        assert integrate_history(ground, TIME_STEP, 1.2, model, method).rotation.any(), "a wall at rest"

    for name, (one_sided, ratio, first, last) in walls.items():
        model = RockingModel(alpha, 2.0866, one_sided, ratio, 0.0, first * alpha, last * alpha)

        def lanes(model=model):
            scan_multipliers(taylor, ground, TIME_STEP, scales, model, outcomes, peaks)
            assert (peaks > 0.0).all(), "lanes at rest"

        found[f"lanes, {name}"] = lanes
        found[f"search, {name}"] = partial(searched, model)
        found[f"history, {name}"] = partial(moved, model)
    with contextlib.suppress(ImportError, TypeError):  # trees before bodies of unlike hinges
        from core.wall.rocking_model import OtherSide

        unlike = RockingModel(alpha, 2.0866, 0.0, 0.979, 0.0, 0.0, 0.0, other=OtherSide.of(0.8 * alpha, 2.3, 0.985))

        def of_unlike_hinges():
            scan_multipliers(taylor, ground, TIME_STEP, scales, unlike, outcomes, peaks)
            assert (peaks > 0.0).all(), "lanes at rest"

        found["lanes, unlike hinges"] = of_unlike_hinges
    with contextlib.suppress(ImportError):  # trees before ties
        from core.wall.bars import Bar

        # as of resources/cases/building.toml: at 2 % of theta_c it yields, by 2.2 times what the wall has, and breaks
        # at 80 %
        bar = Bar(1.0, 2.2 / 0.02, 0.02 * alpha, 0.0, 0.8 * alpha)
        tied = RockingModel(alpha, 2.0866, 1.0, 0.45, 0.0, 0.0, 0.0, bars=(bar,))

        def of_ties():
            scan_multipliers(taylor, ground, TIME_STEP, scales, tied, outcomes, peaks)
            assert (peaks > 0.0).all(), "lanes at rest"

        found["lanes, ties"] = of_ties
        found["search, ties"] = partial(searched, tied)
        found["history, ties"] = partial(moved, tied)
    with contextlib.suppress(ImportError):  # trees before branches in closed form
        from core.wall.rocking_model import with_branch

        for name, one_sided, ratio in (("two-sided", 0.0, 0.938), ("one-sided", 1.0, 0.45)):
            element = with_branch(RockingModel(alpha, 12.0, one_sided, ratio, 0.0, 0.0, 0.0), 0.005)

            def on_branch(element=element):
                scan_multipliers(taylor, ground, TIME_STEP, scales, element, outcomes, peaks)
                assert (peaks > 0.0).all(), "lanes at rest"

            found[f"lanes, branch, {name}"] = on_branch
    with contextlib.suppress(ImportError):  # trees before walls held at their top
        from core.codes.vertical_bending import model_of_bending
        from core.wall.bending import Strip

        strip = Strip(3.0, 0.3, 0.0, 16.2e3)
        strong = np.convolve(ground, np.hanning(21) / 10.0, "same")  # a record turns no other way at each sample
        strong *= 5.2 / np.abs(strong).max()
        held = model_of_bending(strip, strip, 1.5)

        def held_at_top():
            scan_multipliers(taylor, strong, TIME_STEP, scales, held, outcomes, peaks)
            assert (peaks > 0.0).all(), "lanes at rest"

        def one_held_at_top():
            assert integrate_history(strong, TIME_STEP, 1.2, held).rotation.any(), "a wall at rest"

        found["lanes, held at the top"] = held_at_top
        found["search, held at the top"] = partial(searched, held)
        found["history, held at the top"] = one_held_at_top
    # steps that are taken in parts: 0.05 s under a wall of 1 m, and a stiff elastic branch
    for name, dt, model in (
        ("long steps", 0.05, RockingModel(alpha, 14.6, 0.0, 0.979, 0.0, 0.0, 0.0)),
        ("stiff", TIME_STEP, RockingModel(alpha, 4.87, 1.0, 0.45, 0.0, 0.02 * alpha, 0.28 * alpha)),
    ):
        found[f"search, {name}"] = partial(searched, model, dt)
    model = RockingModel(alpha, 2.0866, 0.0, 0.979, 0.0, 0.0, 0.0)
    for name in ("newmark_paper", "newmark_events", "rk4", "dormand_prince", "linearised"):
        found[name] = partial(moved, model, METHODS[name])
    return found


def probes() -> dict[str, Callable[[], None]]:
    """Name of PROBES -> a loop of some 0.1 ms."""
    import numba
    import numpy as np

    @numba.njit
    def latency(n):
        x = 0.5
        for _ in range(n):
            x = math.sin(x) + math.cos(x)
        return x

    @numba.njit
    def throughput(values, n):
        for _ in range(n):
            for k in range(values.size):
                values[k] = values[k] * 0.999 + 0.001

    lines = ["def front_end(n):", "    a, b, c, d = n, n + 1, n + 2, n + 3", "    for _ in range(n):"]
    signs, names = "+^-&|", "abcd"
    for k in range(1200):  # no two lines alike, so that none become one vector instruction
        one, other = names[k % 4], names[(k * 7 + k // 4 + 1) % 4]
        lines.append(f"        {one} = ({one} {signs[k % 3]} {k * 2654435761 % 65521}) {signs[k * k % 2]} {other}")
    space: dict = {}
    exec("\n".join([*lines, "    return a + b + c + d"]), space)
    front_end, values = numba.njit(space["front_end"]), np.ones(512)
    loops = (lambda: latency(5000), lambda: throughput(values, 1500), lambda: front_end(100))
    return dict(zip(PROBES, loops, strict=True))


def work(samples: int) -> None:
    """A process of the comparison: of each line "name count" it prints the processor time of so many calls [s]."""
    with contextlib.suppress(AttributeError, OSError):
        os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    known = calls(samples) | (probes() if "--probes" in sys.argv else {})
    took = {}
    for name, call in known.items():
        call()
        start = time.thread_time()
        call()
        took[name] = time.thread_time() - start
    print(json.dumps(took), flush=True)
    for line in sys.stdin:
        name, count = json.loads(line)
        start = time.thread_time()
        for _ in range(count):
            known[name]()
        print(time.thread_time() - start, flush=True)


class Worker:
    """A process that measures a tree. cache : folder of its kernels, None for that of the tests"""

    def __init__(self, tree: Path, cache: str | None, *words: str):
        variables = dict(os.environ, PYTHONPATH=str(tree))
        if cache:
            variables["RIBALTA_CACHE"] = cache
        command = [sys.executable, "-P", __file__, str(tree), *words]
        self._process = subprocess.Popen(
            command, env=variables, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )
        self.took: dict[str, float] = json.loads(self._line())

    def _line(self) -> str:
        assert self._process.stdout is not None
        line = self._process.stdout.readline()
        if not line:
            sys.exit("a process of the comparison has ended")
        return line

    def seconds(self, name: str, count: int) -> float:
        """Processor time of a call [s], of so many."""
        assert self._process.stdin is not None
        print(json.dumps([name, count]), file=self._process.stdin, flush=True)
        return float(self._line()) / count

    def end(self) -> None:
        with self._process:  # which closes its pipes
            self._process.terminate()


@contextlib.contextmanager
def workers(options: "Command") -> Iterator[tuple[Worker, Worker, Worker]]:
    """Those of the other tree, of this one, and of the other once more."""
    other, samples = options.paired.resolve(), str(options.number(SAMPLES, SAMPLES // 5))
    with tempfile.TemporaryDirectory() as folder, contextlib.ExitStack() as stack:
        made = []
        for tree, more in ((other, []), (ROOT, ["--probes"]), (other, [])):
            one = Worker(tree, options.kernels(f"{folder}/{tree is ROOT}"), samples, *more)
            stack.callback(one.end)
            made.append(one)
        yield made[0], made[1], made[2]


def interval(values: list[float]) -> tuple[float, float, float]:
    """Median of some values, and the order statistics between which it lies in 19 of 20 draws."""
    ordered, n = sorted(values), len(values)
    out = max(0, math.floor(0.5 * (n - 1.96 * math.sqrt(n))))
    return statistics.median(ordered), ordered[out], ordered[n - 1 - out]


def machine() -> list[str]:
    """What of this machine decides such times."""
    name, said = platform.processor() or platform.machine(), []
    with contextlib.suppress(OSError):
        about = Path("/proc/cpuinfo").read_text()
        name = next((line.split(":")[1].strip() for line in about.splitlines() if line.startswith("model name")), name)
        if " hypervisor" in about:
            said.append("a virtual machine: neighbours may share its cores and their caches")
    with contextlib.suppress(OSError):
        core = Path("/sys/devices/system/cpu/cpu0/topology/thread_siblings_list").read_text().strip()
        if core != "0":
            said.append(f"threads {core} are one core")
    with contextlib.suppress(OSError):
        if (load := os.getloadavg()[0]) > 0.5:
            said.append(f"load {load:.1f} when it began: not quiet")
    if sys.dont_write_bytecode:
        said.append("no bytecode is written (PYTHONDONTWRITEBYTECODE): each process compiles its modules, 0.35 s")
    return [f"{name}, Python {platform.python_version()}", *said]


def main(options: "Command") -> None:
    """Print the tables."""
    pairs = options.number(options.pairs or 25, 2)
    for line in machine():
        print(line)
    waited: dict[str, list[float]] = {name: [] for name in PROBES}
    with workers(options) as trees:
        heads = ("ratio", 7), ("19 of 20", 15), ("control", 8), ("19 of 20", 15), ("time", 12)
        print(f"\n{'this tree over the other':24} " + " ".join(f"{head:>{width}}" for head, width in heads))
        for name in trees[1].took:
            if name in PROBES:
                continue
            if any(name not in tree.took for tree in trees):
                print(f"{name:24} not in the other tree")
                continue
            count = max(1, round(TURN / max(one.took[name] for one in trees)))
            times: list[list[float]] = []
            for k in range(pairs):
                order = [(k + shift) % 3 for shift in range(3)]
                found = {place: trees[place].seconds(name, count) for place in order}
                times.append([found[place] for place in range(3)])
                probe = PROBES[sum(map(len, waited.values())) % 3]
                waited[probe].append(trees[1].seconds(probe, max(1, round(0.1 * TURN / trees[1].took[probe]))))
            mine, same = (interval([row[place] / row[0] for row in times]) for place in (1, 2))
            least = min(row[1] for row in times)
            print(
                f"{name:24} {mine[0]:7.3f} {mine[1]:7.3f}-{mine[2]:.3f} {same[0]:9.3f} {same[1]:7.3f}-{same[2]:.3f} "
                f"{1e3 * least:9.3f} ms"
            )
    print(f"\n{'probe':24} {'least':>9} {'median':>9} {'9 of 10':>9}, of a loop of some 0.1 ms")
    for name, values in waited.items():
        ordered = sorted(values) or [math.nan]
        shown = (ordered[0], statistics.median(ordered), ordered[int(0.9 * (len(ordered) - 1))])
        print(f"{name:24} " + " ".join(f"{1e6 * value:6.1f} us" for value in shown))


if __name__ == "__main__":
    import core

    given = core.__path__[0]
    assert Path(given).resolve().is_relative_to(sys.argv[1]), f"{given} is measured in place of {sys.argv[1]}"
    work(int(sys.argv[2]))
