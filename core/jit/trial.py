"""The trial of machine code that was shipped: kept in the user's cache once its numbers proved right.

A file in the cache's folder lists the processes that began one. While it is there, other processes try a copy of their
own. The folder is given up where the numbers were wrong, or two processes ended within the trial: a kill alone does not
tell that the machine code was at fault.
"""

import contextlib
import os
from collections.abc import Callable
from pathlib import Path

from core import atomic_write
from core.errors import InputError
from core.jit.kernel import COMPILING

TRIAL = "trial"
WRONG = "wrong"
MAX_ENDED = 2

self_test: list[Callable[[], bool]] = []
"""Computes what is known and says whether it is right; set by app.__main__, asked before the first kernel is used."""

_begun: list[tuple[Path, Path]] = []
"""Folder this process tries, and the file that lists it."""
_failed: list[bool] = []


def under_way(folder: Path) -> bool:
    """Whether a trial was begun in this folder and has not ended."""
    return (folder / TRIAL).exists()


def given_up(folder: Path) -> bool:
    """Whether the machine code of this folder is not to be used."""
    try:
        processes = (folder / TRIAL).read_text(encoding="ascii", errors="replace").split()
    except OSError:
        return False
    ended = [one for one in processes if not (one.isdigit() and atomic_write.alive(int(one)))]
    return WRONG in ended or len(ended) >= MAX_ENDED


def claimed(folder: Path) -> bool:
    """Whether this process, and no other, is to begin the trial in the cache's own folder. Raises OSError."""
    try:
        (folder / TRIAL).touch(exist_ok=False)
    except FileExistsError:
        return False
    return True


def begin(folder: Path, listed_in: Path) -> None:
    """This process tries the machine code of a folder from now on. Raises OSError."""
    with open(listed_in / TRIAL, "a", encoding="ascii") as stream:
        stream.write(f"{os.getpid()}\n")
    _begun.append((folder, listed_in / TRIAL))


def begun() -> bool:
    """Whether this process has a trial before it."""
    return bool(_begun)


def end(right: bool) -> None:
    """After the self-test: the machine code is kept, or given up."""
    for _, listed in _begun:
        with contextlib.suppress(OSError):
            if right:
                listed.unlink(missing_ok=True)
            else:
                listed.write_text(WRONG, encoding="ascii")
    _begun.clear()


def withdraw() -> list[Path]:
    """The process ends before its trial: the folders to delete."""
    folders = [folder for folder, _ in _begun]
    end(right=True)
    return folders


def pass_it() -> None:
    """Before any kernel is used: it gives the numbers of the machine it was made on, or is not used. Raises InputError
    then, at each call: what is loaded cannot be unloaded."""
    with COMPILING:
        if _begun and self_test:
            right = self_test.pop()()
            end(right)
            if not right:
                _failed.append(True)
    if _failed:
        raise InputError("machine_code_differs")
