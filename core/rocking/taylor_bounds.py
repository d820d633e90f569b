"""The truncation of a Taylor step, and how far it can stray from its chord (resources/docs/physics.md, sections 7
and 8)."""

from core.jit.decorators import inner_kernel, subkernel
from core.jit.fma import fma

SERIES_TOLERANCE = 1e-16
"""Largest estimated omitted term of the rotation in a step, as a fraction of alpha, where p dt exceeds 0.1; below it
less in proportion to p dt, since the omitted term of the velocity is ten times that of the rotation, over dt: so it
stays below 1e-14 p alpha. Of 1e-17, 1e-16, 1e-15 and 1e-14 it is the largest with which every error of 30 000 histories
is below 1e-9 alpha wherever noise of 1e-15 on the samples does less than 1e-11 alpha (resources/docs/speed.md)."""

RELATIVE_TOLERANCE = 1e-14
"""Largest omitted term as a fraction of what the acceleration of the step moves: a trilinear wall moves under the
smallest ground, and its small motions must be as exact, in relation, as large ones. The omitted term of the velocity is
ten times as much, 1e-13: a hundred times what noise of 1e-15 on the samples does to the step."""

MAX_GROWTH = 2.8
"""Largest growth of a step that is taken whole: a chosen limit, against last coefficients that are small by accident
in a long step. Section 8 needs less than 8."""


@inner_kernel
def neglected(v, growth, forcing, rise, p2, strength, order):
    """Estimate of the first omitted term of the rotation at the end of a step [rad]. Its terms are moduli, so that it
    does not vanish by accident; measured against the remainder in resources/docs/physics.md, section 7.

    From v'' = growth v, differentiated out of Eq. 1: v_n is about growth v_(n-2) / (n (n-1)), and the rotation
    divides by n + 1, hence 1/720 = 1/(10 9 8) and 1/336 = 1/(8 7 6); two coefficients, since one may vanish. Both
    orders add the products of earlier coefficients in v_9 or v_7, which do not follow from the last ones:
    1/45 = 2/(10 9), 1/42 = 1/(7 6).

    v : v0..v8 [rad per step]
    growth : p2 (1 + |beta| + slope of the branch) + phi'^2, all times the step squared [-]
    forcing : largest |u''|/g of the sample [-]
    rise : of the forcing u''/g over the step [-]
    p2 : p^2 times the step squared [-]
    strength : of WallConstants [-]
    order : of the series, 6 or 8
    """
    if order == 8:
        # twice the products of v_9 = P/9 ((beta k_8 - s_8) + dbeta k_7 ...), by absolute values
        squares = fma(abs(v[2]), abs(v[4]) * (1.0 / 15.0), v[3] * v[3] * (1.0 / 32.0))
        crossed = fma(abs(v[1]), abs(v[5]) * (1.0 / 12.0), abs(v[0]) * abs(v[6]) * (1.0 / 7.0))
        risen = fma(abs(v[1]), abs(v[4]) * (1.0 / 10.0), abs(v[2]) * abs(v[3]) * (1.0 / 12.0))
        products = fma(strength + forcing, squares + crossed, abs(rise) * risen)
        return fma(p2 * (1.0 / 45.0), products, (abs(v[7]) + abs(v[8])) * (1.0 / 720.0) * growth)
    products = fma(strength + forcing, fma(v[2], v[2], abs(v[1] * v[3])), abs(rise * v[1] * v[2]))
    return fma(p2 * (1.0 / 42.0), products, (abs(v[5]) + abs(v[6])) * (1.0 / 336.0) * growth)


@inner_kernel
def plus(x, slope):
    """Add the slope of the law: x + slope; x where the law has no slope (None)."""
    if slope is None:
        return x
    return x + slope


@inner_kernel
def largest_moment(factor, sine, slope, rotation, constant):
    """factor sine + slope rotation + constant [-]; slope and constant None where the law has none."""
    if slope is None:
        return factor * sine
    return fma(slope, rotation, fma(factor, sine, constant))


@inner_kernel
def relative_tolerance(x, speed, forcing, p2, branch, constants):
    """Largest omitted term of a step in relation to what its acceleration moves [rad].

    x, speed : rotation [rad] and velocity [rad per step] at its start; forcing, p2 : as `turning_margin`
    branch : (factor, slope, constant, cosine factor) of the moment law, slope None where it has none
    constants : WallConstants
    """
    factor, slope, constant, _ = branch
    moment = largest_moment(factor, constants.sine, slope, x + abs(speed), constant)
    return RELATIVE_TOLERANCE * p2 * (forcing + moment)


@subkernel
def converged_part(tail, growth, order, tolerance, relative):
    """Largest part 1 / 2^n of the step at which the omitted term, `tail` at its end, is below both tolerances and
    growth below MAX_GROWTH. Half a step divides growth and what its acceleration moves by 4, what it may add to the
    rotation at the same error of the velocity by 2, and the term by 2^10 (order 8) or 2^8: its degree."""
    part = 1.0
    for _ in range(60):
        if tail <= min(tolerance, relative) and growth < MAX_GROWTH:
            break
        part *= 0.5
        tolerance *= 0.5
        relative *= 0.25
        growth *= 0.25
        tail *= 1.0 / 1024.0 if order == 8 else 1.0 / 256.0
    return part


@inner_kernel
def shortened(v, p2, rise, part):
    """v0..v8, p2 and rise of the first part of a step in its own units, time from 0 to 1 in it: exact, since the part
    is a power of two. Arguments as `neglected`."""
    second = part * part
    third, fourth = part * second, second * second
    v = (
        part * v[0],
        second * v[1],
        third * v[2],
        fourth * v[3],
        (part * fourth) * v[4],
        (second * fourth) * v[5],
        (third * fourth) * v[6],
        (fourth * fourth) * v[7],
        (part * (fourth * fourth)) * v[8],
    )
    return v, second * p2, part * rise


@inner_kernel
def largest_push(upper, forcing, p2, constants, factor, slope, constant):
    """Bound of |phi''| within a step on its branch [rad per step squared], after Eq. 1 (section 8).

    On the sine branch the moment is at most a (sin(alpha) + |c|/a + phi), and phi exceeds its chord by at most
    p2 (strength + forcing) / 8. On the others it is slope phi + constant; there phi exceeds its chord by at most
    an eighth of the bound, so that the bound is divided by 1 - p2 slope / 8, of which 1 + 0.2 p2 slope is more
    while p2 slope is below 3 (1.6 = 1 / (1 - 3/8), and the quotient is convex).

    upper : the larger rotation of its ends [rad]
    forcing : bound of |u''|/g [-]
    p2 : p^2 times the step squared [-]
    constants : WallConstants
    factor : sine factor of the branch of the moment law [-]
    slope : of that branch [-], None where the law has none
    constant : of that branch [-]
    """
    sine = factor * (fma(0.125 * p2, constants.strength + forcing, upper) + constants.sine_bound)
    if slope is None:
        return p2 * (sine + forcing)
    moment = fma(slope, upper, constant + sine)
    return p2 * ((moment + forcing) * fma(0.2 * p2, slope, 1.0))


@inner_kernel
def turning_margin(speed, change, rise, forcing, p2, strength, push):
    """How far the speed [rad per step] can leave its chord within a step: 1/8 of the bound of its second
    derivative, after Eq. 1.

    speed : at its start [rad per step]
    change : of the speed over the step [rad per step]
    rise : of the forcing u''/g over the step [-]
    forcing : its bound plus the slope of the moment law [-]
    p2 : p^2 times the step squared [-]
    strength : of WallConstants [-]
    push : bound of the angular acceleration [rad per step squared]
    """
    fastest = max(abs(speed), abs(speed + change)) + push
    return 0.125 * p2 * fma(fastest, strength + forcing, abs(rise))
