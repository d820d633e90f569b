"""The truncation of a Taylor step, and how far it can stray from its chord (resources/docs/physics.md, sections 7
and 8)."""

from core.jit.decorators import inner_kernel, subkernel
from core.jit.fma import fma

SERIES_TOLERANCE = 1e-17
"""Largest neglected term of a step, as a fraction of alpha."""

MAX_GROWTH = 2.8
"""Largest square of the rate of growth times the step at which the bound of the neglected term holds."""


@inner_kernel
def neglected(v, growth, forcing, rise, p2, order):
    """Bound of the first neglected term of a step [rad per step].

    growth : p2 (1 + |beta| + slope of the branch) + phi'^2 times the step squared [-], the square of the
    rate at which the terms of the series can grow; the other arguments as `turning_margin`. What order 6
    leaves out also holds products of the two first terms, which do not grow out of its last ones.
    """
    if order == 8:
        return (abs(v[7]) + abs(v[8])) * (1.0 / 720.0) * growth
    products = fma(1.0 + forcing, fma(v[2], v[2], abs(v[1] * v[3])), abs(rise * v[1] * v[2]))
    return fma(p2 * (1.0 / 42.0), products, (abs(v[5]) + abs(v[6])) * (1.0 / 336.0) * growth)


@subkernel
def converged_part(tail, growth, order, alpha):
    """Largest part 1 / 2^n of the step at which the first neglected term, `tail` at its end, is below
    SERIES_TOLERANCE alpha; growth : as `neglected`."""
    part = 1.0
    for _ in range(60):
        if tail <= SERIES_TOLERANCE * alpha and growth < MAX_GROWTH:
            break
        part *= 0.5
        growth *= 0.25
        tail *= 0.0009765625 if order == 8 else 0.00390625
    return part


@inner_kernel
def largest_push(upper, forcing, p2, sine_alpha):
    """Bound of |phi''| within a step [rad per step squared], after Eq. 1.

    upper : the larger rotation of its ends [rad]; forcing : bound of |u''|/g; p2 : p^2 times the step
    squared; sine_alpha : sin(alpha), which no moment law exceeds by more than the rotation.
    """
    return p2 * (fma(0.125 * p2, 1.0 + forcing, upper) + (sine_alpha + forcing))


@inner_kernel
def turning_margin(speed, change, rise, forcing, p2, push):
    """How far the speed [rad per step] can leave its chord within a step: 1/8 of the bound of its second
    derivative, after Eq. 1.

    speed, change : at the start and over the step; rise : of the forcing u''/g over the step [-];
    forcing : its bound plus the slope of the moment law [-]; p2 : times the step squared [-];
    push : bound of the angular acceleration [rad per step squared].
    """
    fastest = max(abs(speed), abs(speed + change)) + push
    return 0.125 * p2 * fma(fastest, 1.0 + forcing, abs(rise))
