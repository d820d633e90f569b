"""x y + z, rounded once: half the work of a polynomial, and the same number on every machine."""

import math
from fractions import Fraction

import numpy as np


def fma(x: float, y: float, z: float) -> float:
    """x y + z, rounded once. In a kernel one instruction (see core.jit.numba_extensions); in Python slow, and
    exact where x y is finite."""
    near = x * y + z
    if not math.isfinite(near):
        return near
    exact = Fraction(float(x)) * Fraction(float(y)) + Fraction(float(z))
    return np.float64(exact) if exact else near
