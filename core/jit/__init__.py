"""All that knows numba: the decorators of kernels, the cache of their machine code, the fused product."""
