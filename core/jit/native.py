"""Kernels of a library that was made before (packaging/kernels.py), called without numba.

Such a kernel is the machine code numba made for arguments of certain types. They go to it one after the other as numba
lays them out: a number as it is, None as a pointer, a tuple as its parts, an array as two pointers, its size, the size
of an item, its address, shape and strides; before them the place of the result and that of an error, which no kernel
has.
"""

import ctypes
import struct
from collections.abc import Callable
from typing import Any

import numpy as np

from core.errors import InputError
from core.jit import cache, shipped, trial
from core.jit.stamp import once_for_all

NUMBERS = {float: "d", np.float64: "d", int: "q", np.int64: "q", bool: "?", np.bool_: "?"}
"""Type of a number -> its letter in a key, which is that of `struct` too."""

ITEMS = {"<f8": "d", "<i8": "q", "|b1": "?"}
"""Items of an array -> their letter."""


def spell(value: Any, key: list[str], words: list) -> None:
    """Add the type of an argument to a key, and its words to those of a call. Raises LookupError for a type that no
    kernel takes."""
    kind = type(value)
    if kind in NUMBERS:
        key.append(NUMBERS[kind])
        words.append(value)
    elif kind is np.ndarray:
        key.append(f"{ITEMS[value.dtype.str]}{value.ndim}{'C' if value.flags.c_contiguous else 'A'}")
        address = value.__array_interface__["data"][0]
        words += (0, 0, value.size, value.itemsize, address, *value.shape, *value.strides)
    elif value is None:
        key.append("n")
        words.append(0)
    elif isinstance(value, tuple):
        key.append("(" if kind is tuple else f"{kind.__name__}(")
        for part in value:
            spell(part, key, words)
        key.append(")")
    else:
        raise LookupError(kind)


@once_for_all
def library() -> ctypes.CDLL | None:
    """The machine code shipped for the best level of this processor that is not given up; None where there is none."""
    for level in shipped.levels():
        path = shipped.whole_file(level)
        if path is not None and trial.begin(cache.folder(), shipped.library().levels[level]):
            try:
                return ctypes.CDLL(str(path))
            except OSError:  # not for this system after all
                trial.end(right=False)
    return None


def ready() -> None:
    """Before a kernel is used: machine code that was shipped has passed its trial, or there is numba. Raises
    InputError."""
    if (library() is None or not trial.passed()) and not has_numba():
        raise InputError("machine_code_differs")


@once_for_all
def has_numba() -> bool:
    """Whether numba is there, to compile what was not shipped: the frozen program has none."""
    from importlib.util import find_spec

    return find_spec("numba") is not None


LANES_FILE = "*.one_pass-*.nbc"
"""File of the analyses in lanes in the cache, the last that a search compiles."""


def lacks_lanes() -> bool:
    """Whether the analyses in lanes are to be compiled: neither shipped nor in the cache of this user."""
    return library() is None and not any(cache.folder().glob(LANES_FILE))


class NativeKernel:
    """A kernel of the library, for the types of arguments it was made for, and what is called for others.

    symbols : types as `spell` writes them -> (name in the library, letters of its result)
    """

    def __init__(self, found: ctypes.CDLL, symbols: dict[str, list[str]], otherwise: Callable):
        self.found, self.symbols, self.otherwise = found, symbols, otherwise
        self.made: dict[str, Callable] = {}

    def __call__(self, *arguments: Any) -> Any:
        key: list[str] = []
        words: list = []
        if trial.failed:
            return self.otherwise(*arguments)
        try:
            for value in arguments:
                spell(value, key, words)
            types = "".join(key)
            call = self.made.get(types) or self._make(types, words)
        except LookupError:
            return self.otherwise(*arguments)
        return call(words)

    def _make(self, types: str, words: list) -> Callable:
        """The call for these types. Raises LookupError where the library has none."""
        symbol, result = self.symbols[types]
        function = self.found[symbol]
        function.argtypes = [
            ctypes.c_void_p,
            ctypes.c_void_p,
            *(ctypes.c_double if isinstance(word, float) else ctypes.c_int64 for word in words),
        ]
        form = struct.Struct(f"@{result}")
        place = ctypes.c_char * (form.size + 8)

        def call(words):
            given, error = place(), ctypes.c_void_p()
            if function(given, ctypes.byref(error), *words):
                raise RuntimeError(symbol)
            numbers = form.unpack_from(given)
            return numbers if len(result) > 1 else numbers[0] if result else None

        self.made[types] = call
        return call


def kernel(name: str, function: Callable, compiled: Callable[[], Callable]) -> Callable:
    """What a call of a kernel goes to: the library, for the types of arguments that it has, else what numba makes of
    the function, else that itself. Raises InputError.

    name : of the kernel; compiled() : numba's dispatcher
    """
    ready()

    def otherwise(*arguments):
        return (compiled() if has_numba() else function)(*arguments)

    found = library() if trial.passed() else None
    symbols = shipped.library().kernels.get(name)
    if found and symbols:
        return NativeKernel(found, symbols, otherwise)
    return compiled() if has_numba() else function
