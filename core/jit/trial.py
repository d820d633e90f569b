"""The trial of machine code that was shipped: noted in the user's cache once its numbers proved right.

Each process that begins one has a file there until it ends. The machine code is given up where the numbers were wrong,
or two processes of this machine ended within the trial: a kill alone does not tell that the machine code was at fault.
"""

import contextlib
import os
import threading
import time
from collections.abc import Callable
from pathlib import Path

from core import atomic_write
from core.jit.kernel import COMPILING

TRIAL, PASSED, WRONG = "trial-", "passed-", "wrong-"
"""How the names of the files begin, the hash of the machine code follows: of a process in its trial, of one that ended
well, and of one that did not."""

MAX_ENDED = 2

KEEP_SECONDS = 30 * 86400
"""Age beyond which a process that ended within its trial counts no more."""

self_test: list[Callable[[], bool]] = []
"""Computes what is known and says whether it is right; set by app.__main__, asked before the first kernel is used."""

_begun: list[Path] = []
"""The file of this process."""
failed: list[bool] = []
"""Not empty where the numbers were wrong."""
_tester: list[int] = []
"""The thread of the self-test."""


def given_up(folder: Path, digest: str) -> bool:
    """Whether machine code of this hash is not to be used. folder : of the user's cache"""
    if (folder / f"{WRONG}{digest[:16]}").exists():
        return True
    ended = 0
    for path in folder.glob(f"{TRIAL}{digest[:16]}-{atomic_write.machine()}-*"):
        number = path.name.rpartition("-")[2]
        with contextlib.suppress(OSError):
            recent = time.time() - path.stat().st_mtime < KEEP_SECONDS
            ended += recent and number.isdigit() and not atomic_write.alive(int(number))
    return ended >= MAX_ENDED


def begin(folder: Path, digest: str) -> bool:
    """Whether machine code of this hash may be used: proven by an earlier process, or to be tried by this one. folder :
    of the user's cache"""
    if (folder / f"{PASSED}{digest[:16]}").exists():
        return True
    if given_up(folder, digest):
        return False
    _begun.append(folder / f"{TRIAL}{digest[:16]}-{atomic_write.machine()}-{os.getpid()}")
    with contextlib.suppress(OSError):
        _begun[-1].touch()
    return True


def end(right: bool) -> None:
    """After the self-test: the machine code is kept, or given up."""
    for listed in _begun:
        digest = listed.name[len(TRIAL) :].partition("-")[0]
        with contextlib.suppress(OSError):
            listed.with_name(f"{PASSED if right else WRONG}{digest}").touch()
    withdraw()


def withdraw() -> None:
    """The process ends before its trial."""
    for listed in _begun:
        with contextlib.suppress(OSError):
            listed.unlink(missing_ok=True)
    _begun.clear()


def passed() -> bool:
    """Whether machine code that was shipped gives the numbers of the machine it was made on; tried now where it was
    not. Another thread than that of the self-test waits until it has ended."""
    if _begun and threading.get_ident() not in _tester:
        with COMPILING:
            if _begun and self_test:
                _tester.append(threading.get_ident())
                try:
                    right = self_test[-1]()
                except Exception:  # it computes what is known: whatever ends it is wrong
                    right = False
                _tester.clear()
                self_test.clear()
                if not right:
                    failed.append(True)
                end(right)
    return not failed
