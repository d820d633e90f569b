"""The second process of a cold start: it compiles the kernels of single histories while this one compiles others.

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

from core.jit import native
from core.jit.cache import SECOND_PROCESS, TEMPORARY, folder
from core.jit.stamp import stamp
from core.rocking.history import integrate_history
from core.rocking.methods import METHODS
from core.rocking.taylor import through_sample
from core.wall.rocking_model import RockingModel

MAX_WAIT = 20.0
"""Seconds after which the second process is not waited for: what it was to compile is compiled here."""

STEP_FILE = "taylor.through_sample-*.nbc"
"""File of the step of a history in the cache."""

_second: list[subprocess.Popen] = []


def available_cores() -> int:
    """Processors this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def start(names: set[str]) -> None:
    """Begin to compile the histories by the one of these methods that is of the Taylor series, where none was
    ever compiled. Of two, each process would wait for the wrong one."""
    names = names & {"taylor", "taylor_6"}
    compiled = native.library() is not None or any(folder().glob(STEP_FILE))
    if compiled or available_cores() < 2 or len(names) != 1 or _second or not sys.executable:
        return
    root = str(Path(__file__).absolute().parents[2])
    path = [root, *filter(None, [os.environ.get("PYTHONPATH")])]
    through_sample.before_compile = wait
    atexit.register(end)  # after the cache's own, so that it runs before that is closed
    own = {SECOND_PROCESS: str(folder().absolute()), "PYTHONPATH": os.pathsep.join(path)}
    try:
        process = subprocess.Popen(
            [sys.executable, "-m", __name__, *sorted(names)],
            cwd=root,
            env=os.environ | own,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
        )
    except OSError:
        return
    _second.append(process)


def end() -> None:
    """Before this process ends: end the second one."""
    for process in _second:
        process.kill()
        process.wait()


def wait() -> None:
    """Until the step of a history is compiled by the second process, if there is one, or that has ended."""
    latest = time.monotonic() + MAX_WAIT
    for process in _second:
        while process.poll() is None and time.monotonic() < latest and not any(folder().glob(STEP_FILE)):
            time.sleep(0.01)


def main() -> None:
    """The second process: histories by the methods its arguments name."""
    if not folder().name.startswith(f"kernels-{stamp()}") and not folder().name.startswith(TEMPORARY):
        return  # other sources than those of the process that waits

    gc.disable()  # the process ends soon
    ground = np.zeros(2)
    ground.flags.writeable = False  # as that of a record: another type for numba
    model = RockingModel(0.1, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0)
    for method in sys.argv[1:]:
        integrate_history(ground, 0.01, 1.0, model, METHODS[method])


if __name__ == "__main__":
    main()
