"""A stand-in of Windows on Linux: its branches of the program run, over its rules for files that are open.

A file that some handle of the process holds open can be neither deleted, renamed nor replaced; a lock is of a byte and
of one handle; a folder cannot be opened; its processes are asked of kernel32. RIBALTA_AS_WINDOWS has the tests run so
(tests/conftest.py).
"""

import errno
import os
import shutil
import stat
import sys
import types
from pathlib import Path

VARIABLE = "RIBALTA_AS_WINDOWS"

REACHED: set[str] = set()
"""Branches of Windows that asked for the system: file and line of the program."""


class _Seen(types.ModuleType):
    """A module as one file of the program sees it, with another answer to one question."""

    def __init__(self, module, file, name, answer):
        super().__init__(module.__name__)
        self.__dict__["_of"] = module, file, name, answer

    def __getattr__(self, asked):
        module, file, name, answer = self.__dict__["_of"]
        if asked != name:
            return getattr(module, asked)
        REACHED.add(f"{file}:{sys._getframe(1).f_lineno}")
        return answer


def held(path) -> bool:
    """Whether a handle of this process has a file open."""
    try:
        wanted = os.stat(path)
    except OSError:
        return False
    for handle in os.listdir("/proc/self/fd"):
        try:
            if os.path.samestat(os.fstat(int(handle)), wanted) and stat.S_ISREG(wanted.st_mode):
                return True
        except OSError:  # the handle of the list itself
            continue
    return False


def _refused(function, places):
    """A function of os that Windows refuses for open files. places : of its arguments that are paths"""

    def guarded(*paths, **more):
        for path in paths[:places]:
            if "dir_fd" not in more and held(path):
                raise PermissionError(errno.EACCES, "The process cannot access the file", os.fspath(path))
        if function.__name__ == "rename" and os.path.lexists(paths[1]):
            raise FileExistsError(errno.EEXIST, "Cannot create a file when that file already exists", paths[1])
        return function(*paths, **more)

    return guarded


def _opened(function):
    def opened(path, flags, *more, **others):
        if os.path.isdir(path) and not flags & os.O_DIRECTORY:
            raise PermissionError(errno.EACCES, "Permission denied", path)
        return function(path, flags, *more, **others)

    return opened


class Locks(types.ModuleType):
    """msvcrt, as far as the program asks it."""

    LK_NBLCK = 2

    def __init__(self):
        super().__init__("msvcrt")
        self.holders: dict[tuple[int, int], int] = {}

    def locking(self, handle: int, mode: int, length: int) -> None:
        assert (mode, length, os.lseek(handle, 0, os.SEEK_CUR)) == (self.LK_NBLCK, 1, 0)
        own = os.fstat(handle)
        key = own.st_dev, own.st_ino
        holder = self.holders.get(key)
        if holder not in (None, handle):
            try:
                if os.path.samestat(os.fstat(holder), own):
                    raise OSError(errno.EDEADLK, "Resource deadlock avoided")
            except OSError as error:
                if error.errno != errno.EBADF:
                    raise
        self.holders[key] = handle


class _Kernel:
    """kernel32: whether a process runs."""

    @staticmethod
    def OpenProcess(access, inherit, number):
        return int(number > 0 and os.path.isdir(f"/proc/{number}"))

    @staticmethod
    def CloseHandle(handle):
        assert handle

    @staticmethod
    def IsProcessorFeaturePresent(feature):
        return feature == 40


ASKED = {"os": 'os.name == "nt"', "sys": 'sys.platform == "win32"'}


def asking(root: Path) -> dict[str, set[str]]:
    """Lines of the program that ask whether it is on Windows, "file:line" -> the modules they ask."""
    found: dict[str, set[str]] = {}
    for path in sorted([*(root / "core").rglob("*.py"), *(root / "app").rglob("*.py")]):
        for k, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
            if asked := {name for name, words in ASKED.items() if words in line}:
                found[f"{path.relative_to(root).as_posix()}:{k}"] = asked
    return found


def stand_in(patch, root: Path) -> None:
    """From now on this process is on Windows, as far as the program can tell. patch : pytest's monkeypatch"""
    import ctypes
    import importlib

    of_file: dict[str, set[str]] = {}
    for place, asked in asking(root).items():
        of_file.setdefault(place.partition(":")[0], set()).update(asked)
    for file, asked in of_file.items():
        module = importlib.import_module(file.removesuffix(".py").replace("/", "."))
        if "os" in asked:
            patch.setattr(module, "os", _Seen(os, file, "name", "nt"))
        if "sys" in asked:
            patch.setattr(module, "sys", _Seen(sys, file, "platform", "win32"))
    patch.setitem(sys.modules, "msvcrt", Locks())
    patch.setattr(ctypes, "windll", types.SimpleNamespace(kernel32=_Kernel), raising=False)
    for name, places in (("unlink", 1), ("remove", 1), ("rename", 2), ("replace", 2)):
        patch.setattr(os, name, _refused(getattr(os, name), places))
    patch.setattr(os, "open", _opened(os.open))
    patch.setattr(shutil, "_use_fd_functions", False)  # of folders that are opened
