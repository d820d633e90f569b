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

from core.kernel_cache import BESIDE, FOLDER, STAMP, TEMPORARY

LONGEST = 20.0
"""Seconds after which the second process is not waited for: what it was to compile is compiled here."""

STEP = "taylor.through_sample-*.nbc"
"""Its file in FOLDER."""

_second: list[subprocess.Popen] = []


def cores() -> int:
    """Processors this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def start(names: set[str]) -> None:
    """Begin to compile the histories by the one of these methods that is of the Taylor series, where none was
    ever compiled. Of two, each process would wait for the wrong one."""
    names = names & {"taylor", "taylor_6"}
    if cores() < 2 or len(names) != 1 or _second or any(FOLDER.glob(STEP)) or not sys.executable:
        return
    # the frozen program knows by its environment that it is the second one (packaging/entry.py)
    module = [] if getattr(sys, "frozen", False) else ["-m", __name__]
    root = str(Path(__file__).absolute().parents[1])
    path = [root, *filter(None, [os.environ.get("PYTHONPATH")])]
    try:
        process = subprocess.Popen(
            [sys.executable, *module, *sorted(names)],
            cwd=root,
            env={**os.environ, BESIDE: str(FOLDER.absolute()), "PYTHONPATH": os.pathsep.join(path)},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
        )
    except OSError:
        return
    _second.append(process)


@atexit.register
def end() -> None:
    """Before this process ends, and before its cache is closed."""
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
    if FOLDER.name != f"kernels-{STAMP}" and not FOLDER.name.startswith(TEMPORARY):
        return  # other sources than those of the process that waits
    from core.rocking import METHODS, RockingModel, history

    gc.disable()  # the process ends soon
    ground = np.zeros(2)
    ground.flags.writeable = False  # as that of a record: another type for numba
    model = RockingModel(0.1, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0)
    for name in sys.argv[1:]:
        history(ground, 0.01, 1.0, model, METHODS[name])


if __name__ == "__main__":
    main()
