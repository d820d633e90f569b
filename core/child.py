"""Work on bytes of somebody else in a process of its own, within a bound of time and memory: what decodes them may fail
in any way, and takes nothing along."""

import contextlib
import os
import pickle
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

MODULE = "core.child" if __name__ == "__main__" else __name__
"""Its own name, within a package where the program is installed as one."""

CHILD = "RIBALTA_CHILD"
"""Variable that names to the child the folder of its work and its answer (packaging/entry.py): a program of Windows
without a terminal has no streams."""


class Refused(Exception):
    """The work was not done. reason : what it raised, "" where it took too much time or memory, or ended its process"""

    def __init__(self, reason: str = ""):
        super().__init__(reason)
        self.reason = reason


def bounded(work: Callable, *given: Any, seconds: float, megabytes: int) -> Any:
    """Run work(*given) in a child process within these bounds and return its result. work : a function of a module;
    given : what can be pickled. Raises Refused."""
    root = str(Path(__file__).absolute().parents[MODULE.count(".")])
    module = [] if getattr(sys, "frozen", False) else ["-P", "-m", MODULE]
    path = os.pathsep.join([root, *filter(None, [os.environ.get("PYTHONPATH")])])
    with tempfile.TemporaryDirectory(prefix="ribalta-child-", ignore_cleanup_errors=True) as folder:
        try:
            (Path(folder) / "work").write_bytes(pickle.dumps((work, given, megabytes)))
            done = subprocess.run(
                [sys.executable, *module],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
                timeout=seconds,
                cwd=root,
                env={**os.environ, CHILD: folder, "PYTHONPATH": path},
                creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
            )
            if done.returncode != 0:
                raise Refused
            result, reason = pickle.loads((Path(folder) / "answer").read_bytes())
        except subprocess.TimeoutExpired:
            raise Refused from None
        except OSError as error:
            raise Refused(error.strerror or type(error).__name__) from None
    if reason is not None:
        raise Refused(reason)
    return result


def main() -> None:
    """The child: its work, and as its answer (result, None) or (None, what was raised)."""
    folder = Path(os.environ[CHILD])
    work, given, megabytes = pickle.loads((folder / "work").read_bytes())
    with contextlib.suppress(ImportError, ValueError, OSError):  # Windows has the bound of time alone
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (megabytes << 20, megabytes << 20))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    try:
        answer = pickle.dumps((work(*given), None))
    except MemoryError:
        sys.exit(1)
    except Exception as error:  # whatever a damaged file makes a library raise
        answer = pickle.dumps((None, str(error)[:200] or type(error).__name__))
    (folder / "answer").write_bytes(answer)


if __name__ == "__main__":
    main()
