"""The decorators of compiled kernels. numba is imported with the first call of one: that takes a third of the window's
start."""

import functools

from core.jit import native
from core.jit.kernel import Kernel, widest_vectors

__all__ = ["Kernel", "inner_kernel", "kernel", "subkernel", "widest_vectors"]


def _compiled(function, inlined: bool, python_wrapper: bool):
    from core.jit.numba_extensions import compiled

    return compiled(function, inlined, python_wrapper)


def _found(kernel: Kernel):
    return native.kernel(kernel.name, kernel.py_func, lambda: kernel.dispatcher)


_made = functools.partial(Kernel, compiler=_compiled, finder=_found)

kernel = functools.partial(_made, inlined=False, python_wrapper=True)
"""A kernel that Python calls."""

subkernel = functools.partial(_made, inlined=False, python_wrapper=False)
"""A kernel that kernels call."""

inner_kernel = functools.partial(_made, inlined=True, python_wrapper=False)
"""A kernel that becomes part of the kernels that call it."""
