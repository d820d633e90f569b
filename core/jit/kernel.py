"""A function that numba compiles when it is first called."""

import collections
import functools
import threading
from collections.abc import Callable

COMPILING = threading.RLock()
"""Held by the thread that compiles or loads a kernel."""


class Kernel:
    """A function that was compiled before, or that numba compiles or loads from the cache, when it is first called.

    function : the Python function, kept as `py_func`
    compiler : makes numba's dispatcher of (function, inlined, python_wrapper)
    inlined : the function becomes part of its callers, so that their loops can use vector instructions
    python_wrapper : Python may call the compiled code. The wrapper takes longer to compile than most kernels;
        without it a call from Python runs the Python function
    before_compile : called before the function is compiled or loaded, if set
    name : of what was compiled before: its module in core, its name there, its number among those of this name
    """

    made = collections.Counter[str]()

    def __init__(self, function, compiler: Callable, finder: Callable, inlined: bool, python_wrapper: bool):
        """finder(kernel) : what a call from Python goes to"""
        functools.update_wrapper(self, function)
        name = f"{function.__module__.rpartition('core.')[2]}.{function.__qualname__}"
        self.name = f"{name}.{Kernel.made[name]}"
        Kernel.made[name] += 1
        self._finder, self._found = finder, None
        self.py_func, self.inlined, self.python_wrapper = function, inlined, python_wrapper
        self.before_compile: Callable[[], None] | None = None
        self._compiler, self._dispatcher = compiler, None

    def __getstate__(self):
        """Its name alone: numba hashes what a kernel encloses, which must be the same before and after a call."""
        return {"name": self.name}

    @property
    def dispatcher(self):
        """numba's object of this kernel; Python may call it only where there is a wrapper."""
        if self._dispatcher is None:
            if self.before_compile is not None:
                self.before_compile()
            with COMPILING:
                if self._dispatcher is None:
                    made = self._compiler(self.py_func, self.inlined, self.python_wrapper)
                    self._dispatcher = self._dispatcher or made  # a self-test has asked for it too
        return self._dispatcher

    def __call__(self, *arguments):
        if not self.python_wrapper:
            return self.py_func(*arguments)
        if self._found is None:
            self._found = self._finder(self)
        return self._found(*arguments)


def widest_vectors() -> None:
    """Make the loops of the kernel that calls this use the widest vector registers of the processor. LLVM keeps to half
    of them on Intel processors, where a search then takes up to 18 % longer (resources/docs/speed.md)."""


def value_unless_none(given, value):
    """The value, or None where `given` is None: a kernel compiled for None leaves out what the value is for."""
    return None if given is None else value
