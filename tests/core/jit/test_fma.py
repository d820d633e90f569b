"""x y + z rounded once, compiled and in Python."""

import math
from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.jit.decorators import kernel
from core.jit.fma import fma

number = st.floats(-1e100, 1e100, allow_subnormal=False)


@kernel
def compiled(x, y, z):
    """fma in a kernel."""
    return fma(x, y, z)


@pytest.mark.shows("mechanics.fma")
@settings(max_examples=2000, deadline=None)
@given(number, number, number)
def test_that_the_kernels_instruction_and_python_round_the_exact_value(x, y, z):
    exact = Fraction(x) * Fraction(y) + Fraction(z)
    if exact == 0 or abs(exact) > 1e-250:
        assert compiled(x, y, z) == fma(x, y, z) == float(exact)


def test_that_one_rounding_is_not_two():
    x = 1.0 + 2.0**-30
    assert fma(x, x, -1.0 - 2.0**-29) == 2.0**-60
    assert compiled(x, x, -1.0 - 2.0**-29) == 2.0**-60
    assert x * x - (1.0 + 2.0**-29) == 0.0


def test_that_what_is_not_finite_passes_through():
    assert math.isnan(fma(math.nan, 1.0, 2.0))
    assert fma(math.inf, 1.0, 2.0) == math.inf == compiled(math.inf, 1.0, 2.0)
    assert fma(1e300, 1e300, 0.0) == math.inf == compiled(1e300, 1e300, 0.0)
