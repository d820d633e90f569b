"""The decorators of compiled kernels. numba is imported with the first call of one: that takes a third of the window's
start."""

import functools

from core.jit import cache
from core.jit.kernel import Kernel, widest_vectors

__all__ = ["Kernel", "inner_kernel", "kernel", "subkernel", "widest_vectors"]


def _compiled(function, inlined: bool, python_wrapper: bool):
    cache.configure_numba()
    cache.proven()
    from core.jit.numba_extensions import compiled

    return compiled(function, inlined, python_wrapper)


kernel = functools.partial(Kernel, compiler=_compiled, inlined=False, python_wrapper=True)
"""A kernel that Python calls."""

subkernel = functools.partial(Kernel, compiler=_compiled, inlined=False, python_wrapper=False)
"""A kernel that kernels call."""

inner_kernel = functools.partial(Kernel, compiler=_compiled, inlined=True, python_wrapper=False)
"""A kernel that becomes part of the kernels that call it."""
