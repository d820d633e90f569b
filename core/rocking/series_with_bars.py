"""The Taylor series of a wall held by bars: what their moment adds to that of a wall without
(resources/docs/physics.md, section 18). Functions that take `bars` leave these terms out where it is None, at compile
time.

A branch of such a wall is (a, K, C, c): over I0 p2 the moment is
    a sin(alpha - phi) + c cos(alpha - phi) + (K sin(phi) + C) cos(phi).
"""

from core.jit.decorators import inner_kernel
from core.jit.fma import fma
from core.rocking.taylor_series import InitialTerms, WallConstants, initial_terms, taylor_coefficients

ORDER = 8
"""Order of the series."""


@inner_kernel
def initial_terms_held(x, speed, s, c, side, first, second, t, dt, branch, p2, constants, bars):
    """`taylor_series.initial_terms`, also of a wall held by bars: its sine and cosine are then those of phi.

    x, speed, s, c, side, first, second, t, dt, p2, constants : as there
    branch : as there, with bars of this module
    bars : their rows, or None
    """
    if bars is None:
        return initial_terms(x, speed, s, c, side, first, second, t, dt, branch, p2, constants)
    factor, _, _, held = branch
    start = initial_terms(x, speed, s, c, side, first, second, t, dt, (factor, None, None, held), p2, constants)
    return InitialTerms(start.speed, start.net, s, c, start.beta, start.rise, start.p2, start.forcing)


@inner_kernel
def taylor_coefficients_held(x, start, branch, constants, order, bars):
    """`taylor_series.taylor_coefficients`, also of a wall held by bars.

    x : rotation at the start [rad]
    start : of `initial_terms_held`
    branch : of the moment law, slope None where it has none; with bars of this module
    constants : WallConstants, with bars of `bounds_held`
    order : of the series, 6 or 8
    bars : their rows, or None
    """
    factor, slope, constant, _ = branch
    if bars is None:
        return taylor_coefficients(x, start, factor, slope, constants.strength, order)
    v = series_with_bars(start, factor, slope, constant, constants)
    # at uplift phi'' is zero or outward; its rounding must not push the block down
    v1 = max(v[1], 0.0) if (x == 0.0) & (start.speed == 0.0) else v[1]
    v = (v[0], v1, v[2], v[3], v[4], v[5], v[6], v[7], v[8])
    bound = strength_with_springs(constants, branch, bars) + start.forcing
    return v, fma(start.p2, bound, start.speed * start.speed)


@inner_kernel
def series_with_bars(start, factor, spring, constant, constants):
    """v0..v8 of phi' about the start of a step, in units of the step.

    With x, y = sin(phi), cos(phi) Eq. 1 is phi'' = p2 (A y + B x - K x y + dbeta t (cos(alpha) y + sin(alpha) x)),
        A = cos(alpha) (beta - a tan(alpha)) - C,  B = sin(alpha) beta + a cos(alpha),
    beta less c, and n x_n = sum_(i<n) v_i y_(n-1-i), n y_n = -sum_(i<n) v_i x_(n-1-i). e_n is the sum of x_i y_(n-i).

    start : of `initial_terms_held`
    factor, spring, constant : a, K and C [-]
    constants : WallConstants
    """
    v0, x0, y0, p2 = start.speed, start.sine, start.cosine, start.p2
    sine, cosine = constants.sine, constants.cosine
    stiff, rise = -p2 * spring, p2 * start.rise
    a = p2 * fma(cosine, fma(-factor, constants.tangent, start.beta), -constant)
    b = p2 * fma(sine, start.beta, factor * cosine)
    c, d = rise * cosine, rise * sine
    e0 = x0 * y0
    v1 = fma(stiff, e0, fma(b, x0, a * y0))
    x1 = v0 * y0
    y1 = -(v0 * x0)
    e1 = fma(x1, y0, x0 * y1)
    v2 = (1.0 / 2.0) * fma(stiff, e1, fma(b, x1, fma(a, y1, fma(d, x0, c * y0))))
    x2 = (1.0 / 2.0) * fma(v1, y0, v0 * y1)
    y2 = (-1.0 / 2.0) * fma(v1, x0, v0 * x1)
    e2 = fma(x2, y0, fma(x0, y2, x1 * y1))
    v3 = (1.0 / 3.0) * fma(stiff, e2, fma(b, x2, fma(a, y2, fma(d, x1, c * y1))))
    x3 = (1.0 / 3.0) * fma(v2, y0, fma(v0, y2, v1 * y1))
    y3 = (-1.0 / 3.0) * fma(v2, x0, fma(v0, x2, v1 * x1))
    e3 = fma(x3, y0, fma(x0, y3, fma(x2, y1, x1 * y2)))
    v4 = (1.0 / 4.0) * fma(stiff, e3, fma(b, x3, fma(a, y3, fma(d, x2, c * y2))))
    x4 = (1.0 / 4.0) * fma(v3, y0, fma(v0, y3, fma(v2, y1, v1 * y2)))
    y4 = (-1.0 / 4.0) * fma(v3, x0, fma(v0, x3, fma(v2, x1, v1 * x2)))
    e4 = fma(x4, y0, fma(x0, y4, fma(x3, y1, fma(x1, y3, x2 * y2))))
    v5 = (1.0 / 5.0) * fma(stiff, e4, fma(b, x4, fma(a, y4, fma(d, x3, c * y3))))
    x5 = (1.0 / 5.0) * fma(v4, y0, fma(v0, y4, fma(v3, y1, fma(v1, y3, v2 * y2))))
    y5 = (-1.0 / 5.0) * fma(v4, x0, fma(v0, x4, fma(v3, x1, fma(v1, x3, v2 * x2))))
    e5 = fma(x5, y0, fma(x0, y5, fma(x4, y1, fma(x1, y4, fma(x3, y2, x2 * y3)))))
    v6 = (1.0 / 6.0) * fma(stiff, e5, fma(b, x5, fma(a, y5, fma(d, x4, c * y4))))
    x6 = (1.0 / 6.0) * fma(v5, y0, fma(v0, y5, fma(v4, y1, fma(v1, y4, fma(v3, y2, v2 * y3)))))
    y6 = (-1.0 / 6.0) * fma(v5, x0, fma(v0, x5, fma(v4, x1, fma(v1, x4, fma(v3, x2, v2 * x3)))))
    e6 = fma(x6, y0, fma(x0, y6, fma(x5, y1, fma(x1, y5, fma(x4, y2, fma(x2, y4, x3 * y3))))))
    v7 = (1.0 / 7.0) * fma(stiff, e6, fma(b, x6, fma(a, y6, fma(d, x5, c * y5))))
    x7 = (1.0 / 7.0) * fma(v6, y0, fma(v0, y6, fma(v5, y1, fma(v1, y5, fma(v4, y2, fma(v2, y4, v3 * y3))))))
    y7 = (-1.0 / 7.0) * fma(v6, x0, fma(v0, x6, fma(v5, x1, fma(v1, x5, fma(v4, x2, fma(v2, x4, v3 * x3))))))
    e7 = fma(x7, y0, fma(x0, y7, fma(x6, y1, fma(x1, y6, fma(x5, y2, fma(x2, y5, fma(x4, y3, x3 * y4)))))))
    v8 = (1.0 / 8.0) * fma(stiff, e7, fma(b, x7, fma(a, y7, fma(d, x6, c * y6))))
    return v0, v1, v2, v3, v4, v5, v6, v7, v8


@inner_kernel
def bounds_held(constants, branch, bars):
    """WallConstants whose bound of the moment holds a constant pull of the bars. branch : of this module; bars : their
    rows, or None"""
    if bars is None:
        return constants
    _, _, constant, _ = branch
    return WallConstants(
        constants.thresholds,
        constants.tangent,
        constants.sine,
        constants.cosine,
        constants.tolerance,
        constants.strength + abs(constant),
        constants.sine_bound,
        constants.collapse,
        constants.other,
        constants.swing,
    )


@inner_kernel
def strength_with_springs(constants, branch, bars):
    """Strength for the growth of a series and for `taylor_bounds.neglected`: sin(2 phi) / 2 has up to four times the
    derivatives of sin(phi). constants : of `bounds_held`; branch, bars : as there"""
    if bars is None:
        return constants.strength
    _, spring, _, _ = branch
    return fma(4.0, spring, constants.strength)


@inner_kernel
def wall_alone(branch, bars):
    """The branch for `taylor_bounds.relative_tolerance`: of a wall held by bars without them, which may pull far more
    than what moves it. branch, bars : as `bounds_held`"""
    if bars is None:
        return branch
    factor, _, _, held = branch
    return factor, 0.0, 0.0, held
