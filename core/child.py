"""Work on bytes of somebody else in a process of its own, within a bound of time and memory: what decodes them may fail
in any way, and takes nothing along."""

import contextlib
import os
import pickle
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

CHILD = "RIBALTA_CHILD"
"""Variable that tells the frozen program that it is a child (packaging/entry.py)."""


class Refused(Exception):
    """The work was not done. reason : what it raised, "" where it took too much time or memory, or ended its process"""

    def __init__(self, reason: str = ""):
        super().__init__(reason)
        self.reason = reason


def bounded(work: Callable, *given: Any, seconds: float, megabytes: int) -> Any:
    """What work(*given) returns. work : a function of a module; given : what can be pickled. Raises Refused."""
    root = str(Path(__file__).absolute().parents[1])
    module = [] if getattr(sys, "frozen", False) else ["-P", "-m", "core.child"]
    path = os.pathsep.join([root, *filter(None, [os.environ.get("PYTHONPATH")])])
    try:
        done = subprocess.run(
            [sys.executable, *module],
            input=pickle.dumps((work, given, megabytes)),
            capture_output=True,
            timeout=seconds,
            cwd=root,
            env={**os.environ, CHILD: "1", "PYTHONPATH": path},
            creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
        )
    except subprocess.TimeoutExpired:
        raise Refused from None
    except OSError as error:
        raise Refused(error.strerror or type(error).__name__) from None
    if done.returncode != 0:
        raise Refused
    found, reason = pickle.loads(done.stdout)
    if reason is not None:
        raise Refused(reason)
    return found


def main() -> None:
    """The child: work from its input, (result, None) or (None, what was raised) to its output."""
    answer = os.fdopen(os.dup(1), "wb")
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # what a library says is no part of it
    work, given, megabytes = pickle.loads(sys.stdin.buffer.read())
    with contextlib.suppress(ImportError, ValueError, OSError):  # Windows has the bound of time alone
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (megabytes << 20, megabytes << 20))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    try:
        found = pickle.dumps((work(*given), None))
    except MemoryError:
        sys.exit(1)
    except Exception as error:  # whatever a damaged file makes a library raise
        found = pickle.dumps((None, str(error)[:200] or type(error).__name__))
    with answer:
        answer.write(found)


if __name__ == "__main__":
    main()
