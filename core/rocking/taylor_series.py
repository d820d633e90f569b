"""The Taylor series of one step (resources/docs/physics.md, section 6).

The ground acceleration is linear between samples, so Eq. 1 is analytic inside a sample and inside a branch of the
moment law, and the coefficients of its solution follow from each other. sin and cos of alpha - phi are formed from
those of alpha and phi by the addition theorem, so that no rounding is carried from step to step.
"""

import math
from typing import NamedTuple

from core.jit.decorators import inner_kernel, subkernel
from core.jit.fma import fma
from core.rocking.events import uplift_thresholds
from core.rocking.oscillator import Oscillation, swing_of
from core.rocking.taylor_bounds import SERIES_TOLERANCE, plus
from core.units import G
from core.wall.rocking_model import OtherSide, seen_from

PER_G = 1.0 / G


class WallConstants(NamedTuple):
    """Constants of a wall that every sample needs.

    thresholds : a_RM of both sides, see `uplift_thresholds` [m/s2]
    tangent, sine, cosine : of alpha [-]
    tolerance : of the omitted term of a step [rad], see `taylor_bounds.SERIES_TOLERANCE`
    strength : bound of a and |c| together in bounds of the equation, 1 + |c| + max(a - 1, 0); 1 without loads [-]
    sine_bound : sin(alpha) + |c|/a, of both sides the larger one; sin(alpha) without loads [-]
    collapse : the smaller theta_c of both sides [rad]
    other : OtherSide of the model
    swing : Swing of its branch in closed form, None where it has none
    """

    thresholds: tuple[float, float]
    tangent: float
    sine: float
    cosine: float
    tolerance: float
    strength: float
    sine_bound: float
    collapse: float
    other: OtherSide | None = None
    swing: Oscillation | None = None


class InitialTerms(NamedTuple):
    """Terms with which the series of a step begins, at its start.

    speed : phi' [rad per step]
    net : moment law less forcing, f sin(alpha - phi) + m phi + k - beta cos(alpha - phi) [-]
    sine, cosine : of alpha - phi [-]
    beta : u''/g seen from the pivot, less the cosine factor of the branch of the moment law [-]
    rise : change of beta over the step [-]
    p2 : p^2 times the step squared [-]
    forcing : largest |u''|/g of the sample [-]
    """

    speed: float
    net: float
    sine: float
    cosine: float
    beta: float
    rise: float
    p2: float
    forcing: float


@subkernel
def wall_constants(model, dt):
    """WallConstants of a RockingModel and the time step of the record [s]."""
    far = seen_from(model, -1.0)
    slower = math.sqrt(min(model.p2, far.p2))
    tolerance = SERIES_TOLERANCE * min(model.slenderness, far.slenderness) * min(1.0, 10.0 * dt * slower)
    right, left = model.restoring, model.mirrored
    return WallConstants(
        uplift_thresholds(model),
        math.tan(model.slenderness),
        math.sin(model.slenderness),
        math.cos(model.slenderness),
        tolerance,
        max(largest_strength(right), largest_strength(left)),
        math.sin(max(model.slenderness, far.slenderness))
        + max(abs(right.cosine) / right.sine, abs(left.cosine) / left.sine),
        model.slenderness + model.lean,
        model.other,
        swing_of(model.driven, model, dt),
    )


@inner_kernel
def constants_seen(constants, other, side):
    """WallConstants as the pivot of this side sees them. other : OtherSide of them, None of a symmetric body"""
    if other is None:
        return constants
    if side > 0.0:
        return constants
    return WallConstants(
        constants.thresholds,
        other.tangent,
        other.sine,
        other.cosine,
        constants.tolerance,
        constants.strength,
        constants.sine_bound,
        constants.collapse,
        other,
        constants.swing,
    )


@subkernel
def largest_strength(restoring):
    """Bound of the strength of a RestoringMoment: max(a, 1) + |c| [-]."""
    return max(restoring.sine, 1.0) + abs(restoring.cosine)


@inner_kernel
def add_slope_term(x, y, z, slope):
    """x y + slope z; x y where the law has no slope (None)."""
    if slope is None:
        return x * y
    return fma(x, y, slope * z)


@inner_kernel
def with_line(x, y, slope, rotation, constant):
    """x y + slope rotation + constant; x y where the law has no slope (None)."""
    if slope is None:
        return x * y
    return fma(x, y, fma(slope, rotation, constant))


@inner_kernel
def slope_acceleration(slope, p2):
    """Slope term of the angular acceleration, -p2 slope [1/s2]; None where the law has no slope."""
    if slope is None:
        return slope
    return -p2 * slope


@inner_kernel
def initial_terms(x, speed, s, c, side, first, second, t, dt, branch, p2, constants):
    """InitialTerms of a step from t to the end of the sample.

    x : rotation at its start, seen from the pivot [rad]
    speed : rate of x [rad/s]
    s, c : sin and cos of x [-]
    side : of the pivot, 1.0 or -1.0
    first, second : ground acceleration at the ends of the sample [m/s2]
    t : start of the step as a fraction of the sample [-]
    dt : the sample [s]
    branch : (factor, slope, constant, cosine factor) of the moment law [-]; slope and constant None where the law has
        none, specialised at compile time
    p2 : squared frequency parameter about the pivot [1/s2]
    constants : WallConstants as the pivot sees them
    """
    tangent, sine_alpha, cosine_alpha = constants.tangent, constants.sine, constants.cosine
    factor, slope, constant, held = branch
    rest_of_sample = 1.0 - t
    step = dt * rest_of_sample
    p2 = p2 * (step * step)
    pull = side * PER_G
    jump = second - first
    beta = fma(pull, fma(jump, t, first), -held)
    rise = pull * jump * rest_of_sample
    forcing = max(abs(first), abs(second)) * PER_G
    sine = fma(-cosine_alpha, s, sine_alpha * c)
    cosine = fma(sine_alpha, s, cosine_alpha * c)
    # factor sin(alpha - phi) - beta cos(alpha - phi), without its cancellation near uplift
    net = with_line(cosine_alpha * fma(factor, tangent, -beta), c, slope, x, constant)
    net = fma(-s, fma(factor, cosine_alpha, beta * sine_alpha), net)
    return InitialTerms(speed * step, net, sine, cosine, beta, rise, p2, forcing)


@inner_kernel
def series(speed, net, sine, cosine, beta, rise, p2, factor, slope, order):
    """Taylor coefficients v0..v8 of phi' about the start of a step, time in units of the step; v7 = v8 = 0 for
    order 6. The velocity is then of the named order, the rotation one higher.

    Eq. 1 on one branch of the moment law, phi'' = -p2 (f sin(alpha - phi) + m phi + c) + p2 (beta + dbeta t)
    cos(alpha - phi). With S_n, K_n the n-th derivatives of sin and cos of alpha - phi at the start and V_n those of
    phi', and sums over i < n with the binomial coefficients of n - 1, differentiated n - 1 times:
        S_n = -sum C_i V_i K_(n-1-i),   K_n = sum C_i V_i S_(n-1-i),
        V_n = -p2 (f S_(n-1) + m V_(n-2)) + p2 (beta K_(n-1) + (n - 1) dbeta K_(n-2)),   v_n = V_n / n!
    Here v2 to v8, s and k are these derivatives until the end, w2 to w6 the coefficients; a1 to a5 are C_i V_i.
    In each sum the term known last comes last, so that the processor waits for one product only.

    speed : phi' at the start, v0 [rad per step]
    net : of `InitialTerms`, minus phi'' over p2 at the start [-]
    sine, cosine : of alpha - phi at the start [-]
    beta : of `InitialTerms` [-]
    rise : dbeta, change of beta over the step [-]
    p2 : p^2 times the step squared [-]
    factor, slope : f and m of the branch of the moment law [-]; m None where the law has no slope
    order : of the series, 6 or 8
    """
    factor, slope = -p2 * factor, slope_acceleration(slope, p2)
    beta, rise = p2 * beta, p2 * rise
    v0 = speed
    v1 = -p2 * net
    s1 = -v0 * cosine
    k1 = v0 * sine
    v2 = fma(beta, k1, fma(factor, s1, add_slope_term(rise, cosine, v0, slope)))
    s2 = fma(-v0, k1, -(v1 * cosine))
    k2 = fma(v0, s1, v1 * sine)
    twice = rise + rise
    v3 = fma(beta, k2, fma(factor, s2, add_slope_term(twice, k1, v1, slope)))
    double = v1 + v1
    s3 = fma(-v0, k2, -fma(v2, cosine, double * k1))
    k3 = fma(v0, s2, fma(v2, sine, double * s1))
    thrice = twice + rise
    v4 = fma(beta, k3, fma(factor, s3, add_slope_term(thrice, k2, v2, slope)))
    a1, a2 = double + v1, 3.0 * v2
    s4 = fma(-v0, k3, -fma(v3, cosine, fma(a1, k2, a2 * k1)))
    k4 = fma(v0, s3, fma(v3, sine, fma(a1, s2, a2 * s1)))
    four = twice + twice
    v5 = fma(beta, k4, fma(factor, s4, add_slope_term(four, k3, v3, slope)))
    a1, a2, a3 = double + double, 6.0 * v2, 4.0 * v3
    s5 = fma(-v0, k4, -fma(v4, cosine, fma(a3, k1, fma(a1, k3, a2 * k2))))
    k5 = fma(v0, s4, fma(v4, sine, fma(a3, s1, fma(a1, s3, a2 * s2))))
    v6 = fma(beta, k5, fma(factor, s5, add_slope_term(four + rise, k4, v4, slope)))
    w2, w3, w4, w5, w6 = 0.5 * v2, (1.0 / 6.0) * v3, (1.0 / 24.0) * v4, (1.0 / 120.0) * v5, (1.0 / 720.0) * v6
    if order == 6:
        return v0, v1, w2, w3, w4, w5, w6, 0.0, 0.0
    a1, a2, a3, a4 = 5.0 * v1, 10.0 * v2, 10.0 * v3, 5.0 * v4
    s6 = fma(-v0, k5, -fma(v5, cosine, fma(a4, k1, fma(a1, k4, fma(a3, k2, a2 * k3)))))
    k6 = fma(v0, s5, fma(v5, sine, fma(a4, s1, fma(a1, s4, fma(a3, s2, a2 * s3)))))
    v7 = fma(beta, k6, fma(factor, s6, add_slope_term(thrice + thrice, k5, v5, slope)))
    a1, a2, a3, a4, a5 = 6.0 * v1, 15.0 * v2, 20.0 * v3, 15.0 * v4, 6.0 * v5
    s7 = fma(a4, k2, fma(a2, k4, a3 * k3))
    k7 = fma(a4, s2, fma(a2, s4, a3 * s3))
    s7 = fma(-v0, k6, -fma(v6, cosine, fma(a5, k1, fma(a1, k5, s7))))
    k7 = fma(v0, s6, fma(v6, sine, fma(a5, s1, fma(a1, s5, k7))))
    v8 = fma(beta, k7, fma(factor, s7, add_slope_term(fma(4.0, rise, thrice), k6, v6, slope)))
    return v0, v1, w2, w3, w4, w5, w6, (1.0 / 5040.0) * v7, (1.0 / 40320.0) * v8


@inner_kernel
def taylor_coefficients(x, start, factor, slope, strength, order):
    """(v0..v8 of `series`, the square of the rate at which they can grow, see `taylor_bounds.neglected`).

    x : rotation at the start [rad]
    start : InitialTerms
    factor, slope : of the branch of the moment law [-]
    strength : of WallConstants
    """
    v = series(start.speed, start.net, start.sine, start.cosine, start.beta, start.rise, start.p2, factor, slope, order)
    # at uplift phi'' is zero or outward; its rounding must not push the block down
    v1 = max(v[1], 0.0) if (x == 0.0) & (start.speed == 0.0) else v[1]
    v = (v[0], v1, v[2], v[3], v[4], v[5], v[6], v[7], v[8])
    bound = plus(strength + start.forcing, slope)
    return v, fma(start.p2, bound, start.speed * start.speed)
