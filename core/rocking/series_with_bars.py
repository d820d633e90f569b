"""One step of a wall held by bars: the Taylor series with their moment, and where the wall turns back
(resources/docs/physics.md, section 18)."""

from core.jit.decorators import subkernel
from core.jit.fma import fma
from core.rocking.short_series import sine_and_cosine
from core.rocking.taylor import Crossing
from core.rocking.taylor_bounds import converged_part, neglected, relative_tolerance, shortened
from core.rocking.taylor_polynomial import (
    CURVATURE,
    RATE,
    bracketed_root,
    change,
    curvature,
    increment,
    part_turning_once,
)
from core.rocking.taylor_series import PER_G, InitialTerms, WallConstants

ORDER = 8
"""Order of the series."""


@subkernel
def series_with_bars(phi, speed, beta, rise, p2, pull, model, constants):
    """v0..v8 of phi' about the start of a step, in units of the step.

    With x, y = sin(phi), cos(phi) Eq. 1 is phi'' = p2 (A y + B x - K x y + dbeta t (cos(alpha) y + sin(alpha) x)),
        A = cos(alpha) (beta - a tan(alpha) - c) - C,  B = sin(alpha) (beta - c) + a cos(alpha),
    K, C spring and constant of the bars, and n x_n = sum_(i<n) v_i y_(n-1-i), n y_n = -sum_(i<n) v_i x_(n-1-i).

    phi : rotation at the start [rad]
    speed : its rate [rad per step]
    beta : u''/g seen from the pivot at the start [-]
    rise : its change over the step [-]
    p2 : p^2 times the step squared [-]
    pull : Pull
    model : RockingModel as the pivot sees it
    constants : WallConstants
    """
    restoring, sine, cosine = model.restoring, constants.sine, constants.cosine
    x0, y0 = sine_and_cosine(phi)
    v0, stiff, rise = speed, p2 * pull.spring, p2 * rise
    outward = p2 * fma(cosine, beta - fma(restoring.sine, constants.tangent, restoring.cosine), -pull.constant)
    across = p2 * fma(sine, beta - restoring.cosine, restoring.sine * cosine)
    e0 = x0 * y0
    v1 = fma(-stiff, e0, fma(across, x0, outward * y0))
    x1 = v0 * y0
    y1 = -(v0 * x0)
    e1 = fma(x1, y0, x0 * y1)
    v2 = (1.0 / 2.0) * fma(rise, fma(sine, x0, cosine * y0), fma(-stiff, e1, fma(across, x1, outward * y1)))
    x2 = (1.0 / 2.0) * (fma(v1, y0, v0 * y1))
    y2 = (-1.0 / 2.0) * (fma(v1, x0, v0 * x1))
    e2 = fma(x2, y0, fma(x0, y2, x1 * y1))
    v3 = (1.0 / 3.0) * fma(rise, fma(sine, x1, cosine * y1), fma(-stiff, e2, fma(across, x2, outward * y2)))
    x3 = (1.0 / 3.0) * (fma(v2, y0, fma(v0, y2, v1 * y1)))
    y3 = (-1.0 / 3.0) * (fma(v2, x0, fma(v0, x2, v1 * x1)))
    e3 = fma(x3, y0, fma(x0, y3, fma(x2, y1, x1 * y2)))
    v4 = (1.0 / 4.0) * fma(rise, fma(sine, x2, cosine * y2), fma(-stiff, e3, fma(across, x3, outward * y3)))
    x4 = (1.0 / 4.0) * (fma(v3, y0, fma(v0, y3, fma(v2, y1, v1 * y2))))
    y4 = (-1.0 / 4.0) * (fma(v3, x0, fma(v0, x3, fma(v2, x1, v1 * x2))))
    e4 = fma(x4, y0, fma(x0, y4, fma(x3, y1, fma(x1, y3, x2 * y2))))
    v5 = (1.0 / 5.0) * fma(rise, fma(sine, x3, cosine * y3), fma(-stiff, e4, fma(across, x4, outward * y4)))
    x5 = (1.0 / 5.0) * (fma(v4, y0, fma(v0, y4, fma(v3, y1, fma(v1, y3, v2 * y2)))))
    y5 = (-1.0 / 5.0) * (fma(v4, x0, fma(v0, x4, fma(v3, x1, fma(v1, x3, v2 * x2)))))
    e5 = fma(x5, y0, fma(x0, y5, fma(x4, y1, fma(x1, y4, fma(x3, y2, x2 * y3)))))
    v6 = (1.0 / 6.0) * fma(rise, fma(sine, x4, cosine * y4), fma(-stiff, e5, fma(across, x5, outward * y5)))
    x6 = (1.0 / 6.0) * (fma(v5, y0, fma(v0, y5, fma(v4, y1, fma(v1, y4, fma(v3, y2, v2 * y3))))))
    y6 = (-1.0 / 6.0) * (fma(v5, x0, fma(v0, x5, fma(v4, x1, fma(v1, x4, fma(v3, x2, v2 * x3))))))
    e6 = fma(x6, y0, fma(x0, y6, fma(x5, y1, fma(x1, y5, fma(x4, y2, fma(x2, y4, x3 * y3))))))
    v7 = (1.0 / 7.0) * fma(rise, fma(sine, x5, cosine * y5), fma(-stiff, e6, fma(across, x6, outward * y6)))
    x7 = (1.0 / 7.0) * (fma(v6, y0, fma(v0, y6, fma(v5, y1, fma(v1, y5, fma(v4, y2, fma(v2, y4, v3 * y3)))))))
    y7 = (-1.0 / 7.0) * (fma(v6, x0, fma(v0, x6, fma(v5, x1, fma(v1, x5, fma(v4, x2, fma(v2, x4, v3 * x3)))))))
    e7 = fma(x7, y0, fma(x0, y7, fma(x6, y1, fma(x1, y6, fma(x5, y2, fma(x2, y5, fma(x4, y3, x3 * y4)))))))
    v8 = (1.0 / 8.0) * fma(rise, fma(sine, x6, cosine * y6), fma(-stiff, e7, fma(across, x7, outward * y7)))
    # at uplift phi'' is zero or outward; its rounding must not push the block down
    v1 = max(v1, 0.0) if phi == 0.0 and speed == 0.0 else v1
    return v0, v1, v2, v3, v4, v5, v6, v7, v8


@subkernel
def bounded_with(constants, pull):
    """WallConstants whose bound of the moment holds the bars. (sin(2 phi) / 2 has up to four times the derivatives.)"""
    return WallConstants(
        constants.thresholds,
        constants.tangent,
        constants.sine,
        constants.cosine,
        constants.tolerance,
        constants.strength + abs(pull.constant) + 4.0 * pull.spring,
        constants.sine_bound,
        constants.collapse,
        constants.other,
    )


@subkernel
def step_with_bars(state, ground0, ground1, t, dt, pull, model, constants, bounds):
    """(v0..v8, InitialTerms, part) as `taylor.converged_step`, of a wall held by bars.

    state : BlockState at t
    ground0, ground1 : ground acceleration at both ends of the sample [m/s2]
    t : where in the sample it is, 0 to 1
    dt : the sample [s]
    pull : Pull
    model : RockingModel as the pivot sees it
    constants : WallConstants
    bounds : of `bounded_with`
    """
    rest_of_sample = 1.0 - t
    step = dt * rest_of_sample
    p2 = model.p2 * (step * step)
    to_g = state.side * PER_G
    jump = ground1 - ground0
    beta, rise = to_g * fma(jump, t, ground0), to_g * jump * rest_of_sample
    forcing = max(abs(ground0), abs(ground1)) * PER_G
    speed = state.speed * step
    v = series_with_bars(state.phi, speed, beta, rise, p2, pull, model, constants)
    growth = fma(p2, bounds.strength + forcing, speed * speed)
    scale = (model.restoring.sine, 0.0, 0.0, 0.0)
    relative = relative_tolerance(state.phi, speed, forcing, p2, scale, constants)
    tail = neglected(v, growth, forcing, rise, p2, bounds.strength, ORDER)
    part = converged_part(tail, growth, ORDER, constants.tolerance, relative)
    if part < 1.0:
        v, p2, rise = shortened(v, p2, rise, part)
    return v, InitialTerms(v[0], 0.0, 0.0, 0.0, beta, rise, p2, forcing), part


@subkernel
def until_turn(v, event):
    """(Crossing that ends no later than where the wall, moving outward, first turns back, whether it does there)."""
    part = part_turning_once(v, event.part)
    turn, low = -1.0, 0.0
    if v[0] <= 0.0 and v[1] <= 0.0:
        turn = 0.0
    elif v[0] + change(v, part) < 0.0:
        if v[0] <= 0.0:  # it starts at rest, outward
            low = bracketed_root(v, 0.0, CURVATURE, 0.0, part)
        turn = bracketed_root(v, 0.0, RATE, low, part)
    elif v[1] < 0.0 < curvature(v, part):
        lowest = bracketed_root(v, 0.0, CURVATURE, 0.0, part)
        if v[0] + change(v, lowest) < 0.0:
            turn = bracketed_root(v, 0.0, RATE, 0.0, lowest)
    if turn < 0.0 and part >= event.part:
        return event, False
    end = turn if turn >= 0.0 else part
    dphi, dv = increment(v, end), change(v, end)
    return Crossing(end, -1.0, event.falls, event.margin, event.bend, event.reach, dphi, dv), turn >= 0.0
