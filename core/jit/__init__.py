"""All that knows how kernels become machine code: their decorators, numba and its cache, the library that was compiled
before, the fused product."""
