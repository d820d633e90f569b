"""A cold start's second process, which compiles the kernels of single histories while this one compiles others.

numba compiles one kernel at a time in a process, and most of a cold start is its work.
"""

import atexit
import gc
import os
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

from core.kernel_cache import BESIDE, FOLDER

LONGEST = 120.0
"""Seconds after which the second process is not waited for: what it was to compile is compiled here."""

STEP = "taylor.through_sample-*.nbc"
"""Its file in FOLDER."""

_second: list[subprocess.Popen] = []


def start(names: set[str]) -> None:
    """Begin to compile the histories by those of these methods that are of the Taylor series, where none was
    ever compiled."""
    names = names & {"taylor", "taylor_6"}
    if (os.cpu_count() or 1) < 2 or not names or _second or any(FOLDER.glob(STEP)):
        return
    # the frozen program knows by its environment that it is the second one (packaging/entry.py)
    module = [] if getattr(sys, "frozen", False) else ["-m", __name__]
    try:
        process = subprocess.Popen(
            [sys.executable, *module, *sorted(names)],
            cwd=Path(__file__).parents[1],
            env={**os.environ, BESIDE: str(FOLDER.absolute())},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
        )
    except OSError:
        return
    _second.append(process)


@atexit.register
def _end() -> None:
    for process in _second:
        process.kill()
        process.wait()


def wait() -> None:
    """Until the step of a history is compiled by the second process, if there is one, or that has ended."""
    latest = time.monotonic() + LONGEST
    for process in _second:
        while process.poll() is None and time.monotonic() < latest and not any(FOLDER.glob(STEP)):
            time.sleep(0.01)


def main() -> None:
    """The second process: histories by the methods its arguments name."""
    from core.rocking import METHODS, RockingModel, history

    gc.disable()  # the process ends soon
    ground = np.zeros(2)
    ground.flags.writeable = False  # as that of a record: another type for numba
    model = RockingModel(0.1, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0)
    for name in sys.argv[1:]:
        history(ground, 0.01, 1.0, model, METHODS[name])


if __name__ == "__main__":
    main()
