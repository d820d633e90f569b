"""One step of a wall held by bars: the Taylor series with their moment, and where the wall turns back
(resources/docs/physics.md, section 20)."""

from core.jit.decorators import subkernel
from core.jit.fma import fma
from core.rocking.taylor import Crossing
from core.rocking.taylor_bounds import converged_part, neglected, relative_tolerance, shortened
from core.rocking.taylor_polynomial import CURVATURE, RATE, bracketed_root, change, curvature, part_turning_once
from core.rocking.taylor_series import PER_G, InitialTerms, WallConstants, sine_and_cosine

ORDER = 8
"""Of the series."""


@subkernel
def series_with_bars(phi, speed, beta, rise, p2, pull, model, constants, work):
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
    work : room, shape (3, 9)
    """
    restoring = model.restoring
    v, x, y = work[0], work[1], work[2]
    x[0], y[0] = sine_and_cosine(phi)
    v[0] = speed
    outward = fma(constants.cosine, beta - fma(restoring.sine, constants.tangent, restoring.cosine), -pull.constant)
    across = fma(constants.sine, beta - restoring.cosine, restoring.sine * constants.cosine)
    for n in range(1, ORDER + 1):
        product, rate, fall = 0.0, 0.0, 0.0
        for i in range(n):
            product = fma(x[i], y[n - 1 - i], product)
        push = fma(outward, y[n - 1], fma(across, x[n - 1], -pull.spring * product))
        if n > 1:
            push = fma(rise, fma(constants.cosine, y[n - 2], constants.sine * x[n - 2]), push)
        v[n] = p2 * push / n
        for i in range(n):
            rate = fma(v[i], y[n - 1 - i], rate)
            fall = fma(v[i], x[n - 1 - i], fall)
        x[n], y[n] = rate / n, -fall / n
    # at uplift phi'' is zero or outward; its rounding must not push the block down
    v1 = max(v[1], 0.0) if phi == 0.0 and speed == 0.0 else v[1]
    return v[0], v1, v[2], v[3], v[4], v[5], v[6], v[7], v[8]


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
    )


@subkernel
def step_with_bars(state, ground0, ground1, t, dt, pull, model, constants, bounds, work):
    """(v0..v8, InitialTerms, part) as `taylor.converged_step`, of a wall held by bars.

    state : BlockState at t
    ground0, ground1 : ground acceleration at both ends of the sample [m/s2]
    t : where in the sample it is, 0 to 1
    dt : the sample [s]
    pull : Pull
    model : RockingModel as the pivot sees it
    constants : WallConstants
    bounds : of `bounded_with`
    work : room, shape (3, 9)
    """
    rest_of_sample = 1.0 - t
    step = dt * rest_of_sample
    p2 = model.p2 * (step * step)
    to_g = state.side * PER_G
    jump = ground1 - ground0
    beta, rise = to_g * fma(jump, t, ground0), to_g * jump * rest_of_sample
    forcing = max(abs(ground0), abs(ground1)) * PER_G
    speed = state.speed * step
    v = series_with_bars(state.phi, speed, beta, rise, p2, pull, model, constants, work)
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
    if turn >= 0.0:
        return Crossing(turn, -1.0, event.falls, event.margin, event.bend, event.reach), True
    if part < event.part:
        return Crossing(part, -1.0, event.falls, event.margin, event.bend, event.reach), False
    return event, False
