"""What the first batch of a machine compiles, kernel by kernel, in one process and with an empty cache.

python3 run.py bench --compile
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

from tests.benchmarks.inputs import Command
from tests.conftest import ROOT

LEAST = 0.05
"""Kernels that take less are summed [s]."""

MEASURED = """
import sys, time
from core.jit import cache
from core.study import precompile
precompile.start = lambda methods: None
cache.own_process()
from numba.core import event
class Nested(event.Listener):
    def __init__(self):
        self.begun, self.own = [], {}
    def on_start(self, what):
        self.begun.append([time.perf_counter(), 0.0])
    def on_end(self, what):
        start, inside = self.begun.pop()
        whole = time.perf_counter() - start
        name = what.data["dispatcher"].py_func.__name__
        self.own[name] = self.own.get(name, 0.0) + whole - inside
        if self.begun:
            self.begun[-1][1] += whole
listener = Nested()
event.register("numba:compile", listener)
from app.terminal import batch
from pathlib import Path
batch.run(Path(sys.argv[1]), Path(sys.argv[2]), 1, True, False)
for name, seconds in sorted(listener.own.items(), key=lambda one: -one[1]):
    print(name, seconds)
"""


def main(options: Command) -> None:
    """Print the table."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        case = ROOT / "resources" / "cases" / "example.toml"
        command = [sys.executable, "-P", "-c", MEASURED, str(case), str(folder / "out")]
        empty = os.environ | {"RIBALTA_CACHE": str(folder / "cache"), "PYTHONPATH": str(ROOT)}
        done = subprocess.run(command, cwd=ROOT, env=empty, check=True, capture_output=True, text=True)
    found = {kernel: float(seconds) for kernel, seconds in map(str.split, done.stdout.splitlines())}
    assert found, "nothing was compiled"
    for kernel, seconds in found.items():
        if seconds >= LEAST:
            print(f"{kernel:30} {seconds:6.2f} s")
    less = [seconds for seconds in found.values() if seconds < LEAST]
    print(f"{len(less)} others{'':20} {sum(less):6.2f} s")
    print(f"{'together':30} {sum(found.values()):6.2f} s")
