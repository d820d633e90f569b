"""Kernels of a library that was made before (packaging/kernels.py), called without numba.

Such a kernel is the machine code numba made for arguments of certain types. They go to it one after the other as numba
lays them out: a number as it is, None as a pointer, a tuple as its parts, an array as two pointers, its size, the size
of an item, its address, shape and strides; before them the place of the result and that of an error, which no kernel
has.
"""

import ctypes
import struct
import warnings
from collections.abc import Callable
from typing import Any

import numpy as np

from core.errors import InputError
from core.jit import cache, shipped, trial
from core.jit.stamp import once_for_all
from core.text.start import phrase

NUMBERS = {float: "d", np.float64: "d", int: "q", np.int64: "q", bool: "?", np.bool_: "?"}
"""Type of a number -> its letter in a key, which is that of `struct` too."""

ITEMS = {"<f8": "d", "<i8": "q", "|b1": "?"}
"""Items of an array -> their letter."""


LEAST_WHOLE, MOST_WHOLE = -(2**63), 2**63 - 1
"""Whole numbers of 64 bits."""


def spell(value: Any, key: list[str], words: list, readonly: list[bool]) -> None:
    """Add the type of an argument to a key, its words to those of a call, and of each array whether it may not be
    written. Raises LookupError for a type that no kernel takes."""
    kind = type(value)
    if kind in NUMBERS:
        if kind is int and not LEAST_WHOLE <= value <= MOST_WHOLE:
            raise LookupError(value)
        key.append(NUMBERS[kind])
        words.append(value)
    elif kind is np.ndarray:
        flags = value.flags
        if not flags.aligned:
            raise LookupError(kind)
        key.append(f"{ITEMS[value.dtype.str]}{value.ndim}{'C' if flags.c_contiguous else 'A'}")
        readonly.append(not flags.writeable)
        address = value.__array_interface__["data"][0]
        words += (0, 0, value.size, value.itemsize, address, *value.shape, *value.strides)
    elif value is None:
        key.append("n")
        words.append(0)
    elif isinstance(value, tuple):
        key.append("(" if kind is tuple else f"{kind.__name__}(")
        for part in value:
            spell(part, key, words, readonly)
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
            except OSError:  # a folder nothing can be run from, no memory: not the fault of the machine code
                trial.withdraw()
    return None


def ready() -> None:
    """Before a kernel is used: machine code that was shipped has passed its trial, or there is numba. Raises
    InputError."""
    if has_numba() or (library() is not None and trial.passed()):
        trial.passed()
        return
    whole = [level for level in shipped.levels() if shipped.whole_file(level)]
    given_up = [one for one in whole if trial.given_up(cache.folder(), shipped.library().levels[one])]
    if trial.failed or given_up:
        raise InputError("machine_code_differs", folder=cache.folder())
    raise InputError("machine_code_missing", folder=shipped.FOLDER)


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

    symbols : types as `spell` writes them -> (name in the library, letters of its result, "r" or "w" of each array)
    """

    def __init__(self, found: ctypes.CDLL, symbols: dict[str, list[str]], otherwise: Callable):
        self.found, self.symbols, self.otherwise = found, symbols, otherwise
        self.made: dict[str, Callable] = {}

    def __call__(self, *arguments: Any) -> Any:
        if not trial.passed():
            return self.otherwise(*arguments)
        key: list[str] = []
        words: list = []
        readonly: list[bool] = []
        try:
            for value in arguments:
                spell(value, key, words, readonly)
            types = "".join(key)
            writes = self.symbols[types][2]
            if True in readonly and any(kept and mark == "w" for kept, mark in zip(readonly, writes, strict=True)):
                raise LookupError(writes)
            call = self.made.get(types) or self._make(types, words)
        except LookupError:
            return self.otherwise(*arguments)
        return call(words)

    def _make(self, types: str, words: list) -> Callable:
        """The call for these types."""
        symbol, result, _ = self.symbols[types]
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
    the function, else that itself, which is said once. Raises InputError.

    name : of the kernel; compiled() : numba's dispatcher
    """
    ready()

    def otherwise(*arguments):
        if has_numba():
            return compiled()(*arguments)
        text = "{name} is not in the machine code of this program for these values: slow"
        warnings.warn(phrase(text, name=name), stacklevel=2)
        return function(*arguments)

    found = library() if trial.passed() else None
    symbols = shipped.library().kernels.get(name)
    if found and symbols:
        return NativeKernel(found, symbols, otherwise)
    return compiled() if has_numba() else otherwise
