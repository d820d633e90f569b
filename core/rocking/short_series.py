"""sin and cos of rotations, which are small: polynomials that the vector loops share with single steps."""

import math

from core.jit.decorators import inner_kernel, subkernel
from core.jit.fma import fma

SHORT_SERIES = 0.8
"""Rotation up to which the polynomials of sin and cos hold to full precision [rad]."""


@inner_kernel
def sine_and_cosine_short(x):
    """sin and cos of a rotation up to SHORT_SERIES to full precision: of the polynomials in x^2 of degree 5 those with
    the least largest error of (sin x / x - 1) / x^2 and (cos x - 1 + x^2 / 2) / x^4, 4e-18 and 7e-20."""
    y = x * x
    z = y * y
    low = fma(y, 8.333333333320385e-3, -1.6666666666666624e-1)
    middle = fma(y, 2.755731307987325e-6, -1.984126982810434e-4)
    high = fma(y, 1.5890963716440038e-10, -2.5050659650507583e-8)
    s = fma(x * y, fma(z, fma(z, high, middle), low), x)
    low = fma(y, -1.3888888888873108e-3, 4.1666666666666595e-2)
    middle = fma(y, -2.7557314041481213e-7, 2.4801587288597082e-5)
    high = fma(y, -1.1356904546063648e-11, 2.087567509607677e-9)
    return s, fma(z, fma(z, fma(z, high, middle), low), fma(-0.5, y, 1.0))


@subkernel
def sine_and_cosine(x):
    """sin and cos of a rotation [rad]."""
    if x > SHORT_SERIES:
        return math.sin(x), math.cos(x)
    return sine_and_cosine_short(x)
