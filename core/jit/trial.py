"""The trial of machine code that was shipped: noted in the user's cache once its numbers proved right.

A file of the cache lists the processes that began one. The machine code is given up where the numbers were wrong, or
two processes ended within the trial: a kill alone does not tell that the machine code was at fault.
"""

import contextlib
import os
from collections.abc import Callable
from pathlib import Path

from core import atomic_write
from core.jit.kernel import COMPILING

TRIAL, PASSED = "trial-", "passed-"
"""How the names of the file of a trial under way and of one that ended well begin; the hash of the machine code
follows."""

WRONG = "wrong"
MAX_ENDED = 2

self_test: list[Callable[[], bool]] = []
"""Computes what is known and says whether it is right; set by app.__main__, asked before the first kernel is used."""

_begun: list[Path] = []
"""The file that lists this process."""
failed: list[bool] = []
"""Not empty where the numbers were wrong."""


def given_up(listed: Path) -> bool:
    """Whether the machine code of the trial of this file is not to be used."""
    try:
        processes = listed.read_text(encoding="ascii", errors="replace").split()
    except OSError:
        return False
    ended = [one for one in processes if not (one.isdigit() and atomic_write.alive(int(one)))]
    return WRONG in ended or len(ended) >= MAX_ENDED


def begin(folder: Path, digest: str) -> bool:
    """Whether machine code of this hash may be used: proven by an earlier process, or to be tried by this one. folder :
    of the user's cache"""
    listed = folder / f"{TRIAL}{digest[:16]}"
    if given_up(listed):
        return False
    if not (folder / f"{PASSED}{digest[:16]}").is_file():
        with contextlib.suppress(OSError), open(listed, "a", encoding="ascii") as stream:
            stream.write(f"{os.getpid()}\n")
        _begun.append(listed)
    return True


def end(right: bool) -> None:
    """After the self-test: the machine code is kept, or given up."""
    for listed in _begun:
        with contextlib.suppress(OSError):
            if right:
                listed.with_name(listed.name.replace(TRIAL, PASSED)).touch()
                listed.unlink(missing_ok=True)
            else:
                listed.write_text(WRONG, encoding="ascii")
    _begun.clear()


def withdraw() -> None:
    """The process ends before its trial."""
    for listed in _begun:
        with contextlib.suppress(OSError):
            listed.unlink(missing_ok=True)
    _begun.clear()


def passed() -> bool:
    """Whether machine code that was shipped gives the numbers of the machine it was made on; tried now where it was
    not."""
    with COMPILING:
        if _begun and self_test:
            right = self_test.pop()()
            end(right)
            if not right:
                failed.append(True)
    return not failed
