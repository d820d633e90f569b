"""Extensions of numba that the kernels need; imported with the first call of one."""

import contextlib
import gc
import hashlib
import sys
from pathlib import Path

import numba
from numba import njit, types
from numba.core.caching import CompileResultCacheImpl, FunctionCache, _CacheLocator
from numba.extending import lower_builtin, type_callable, typeof_impl

from core.jit import cache
from core.jit.fma import fma
from core.jit.kernel import Kernel, value_unless_none, widest_vectors
from core.jit.stamp import stamp
from core.known_internals import internals_known


def compiled(function, inlined: bool, python_wrapper: bool):
    """numba's dispatcher of a kernel's function: compiled once per machine; no lock held while it runs; never
    fastmath, never parallel. Kernels allocate nothing (_nrt), so that no array handed on is counted: that took
    a fifth of a pass. An option not set here would be inherited from the kernel whose compilation asks
    for this one."""
    dispatcher = njit(  # type: ignore[call-overload]  # options numba has and does not declare
        nogil=True,
        error_model="numpy",
        _nrt=False,
        forceinline=inlined,
        no_cpython_wrapper=not python_wrapper,
        no_cfunc_wrapper=not python_wrapper,
    )(function)
    dispatcher._cache = KernelCache(function)  # as its `enable_caching` does with the cache of numba
    return dispatcher


CORE = __name__.removesuffix(".jit.numba_extensions")
"""Name of core: within a package of its own where it is installed as one."""


class Locator(_CacheLocator):
    """Puts the machine code of kernels into the cache, under their module's name. A kernel of another module than
    core's (a test's) is of its own file as well: numba alone would keep it when only core changes."""

    def __init__(self, py_func):
        name, code = py_func.__module__, py_func.__code__
        self._place = f"{name}-{code.co_firstlineno}"
        own = b"" if name.startswith(f"{CORE}.") else Path(code.co_filename).read_bytes()
        self._stamp = stamp() + hashlib.sha256(own).hexdigest()[:16]

    def get_cache_path(self):
        return str(cache.folder())

    def get_source_stamp(self):
        return self._stamp

    def get_disambiguator(self):
        return self._place


class KernelCacheFiles(CompileResultCacheImpl):
    """Where the cache of a kernel lies: in the folder of kernels, whatever numba's own settings say."""

    def __init__(self, py_func):
        self._lineno = py_func.__code__.co_firstlineno
        self._locator = Locator(py_func)
        self._filename_base = self.get_filename_base(
            f"{Path(py_func.__code__.co_filename).stem}.{py_func.__qualname__}", getattr(sys, "abiflags", "")
        )


class KernelCache(FunctionCache):
    """The cache of one kernel. numba's own, and the functions of others in this process, are left as they are."""

    _impl_class = KernelCacheFiles

    def load_overload(self, sig, target_context):
        """Load machine code. numba first imports what it needs to compile, a seventh of a run of one wall
        (resources/docs/speed.md): code from the cache needs none of it, and the compiler asks for it by itself."""
        if not internals_known(numba):
            return super().load_overload(sig, target_context)
        with self._guard_against_spurious_io_errors():
            return self._load_overload(sig, target_context)

    def save_overload(self, sig, data):
        """Save machine code without the listing of the source with its types, which names folders of this machine. A
        full disk must not end a run: what was compiled is of this process alone then."""
        with contextlib.suppress(OSError):
            super().save_overload(sig, data._replace(type_annotation=""))


@typeof_impl.register(Kernel)
def _type_of_kernel(value, context):
    return types.Dispatcher(value.dispatcher)


@type_callable(widest_vectors)
def _nothing(context):
    return lambda: types.none


@type_callable(value_unless_none)
def _value_or_none(context):
    return lambda given, value: types.none if isinstance(given, types.NoneType) else value


@lower_builtin(value_unless_none, types.Float, types.Float)
def _value(context, builder, signature, arguments):
    return arguments[1]


@lower_builtin(value_unless_none, types.NoneType, types.Float)
def _none(context, builder, signature, arguments):
    return context.get_dummy_value()


@type_callable(fma)
def _number(context):
    return lambda x, y, z: types.float64


@lower_builtin(fma, types.Float, types.Float, types.Float)
def _instruction(context, builder, signature, arguments):
    return builder.fma(*arguments)


@lower_builtin(widest_vectors)
def _mark_function(context, builder, signature, arguments):
    # llvmlite's list of known attributes lacks this one
    set.add(builder.function.attributes, '"prefer-vector-width"="512"')
    return context.get_dummy_value()


if cache.owns_process():
    gc.freeze()
    """What numba's import made stays to the end: the collector need not look through it while kernels compile, 4 to 6 %
    of a cold start (resources/docs/speed.md)."""
