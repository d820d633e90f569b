"""Independent truth in double precision: scipy's DOP853 restarted at samples and events.

It shares no line with the kernels: uplift, impacts, rest and kinks are its own. A second or so a history.
"""

import math

import numpy as np

from core.errors import Cancelled
from core.units import G

NO_LOADS = ((1.0, 0.0), (1.0, 0.0))
"""(a, c) of both sides of a wall without loads."""


def law(phi, alpha, kinks, a=1.0, c=0.0):
    """Moment over m g R of the rigid or trilinear law."""
    if kinks is None or phi >= kinks[1]:
        return a * math.sin(alpha - phi) + c * math.cos(alpha - phi)
    plateau = law(kinks[1], alpha, None, a, c)
    return plateau * min(phi / kinks[0], 1.0)


def history(ground, dt, alpha, p2, one_sided, ratio_of, kinks=None, cancelled=lambda: False, loads=NO_LOADS):
    """Rocking history (Coccia et al. 2016, Eq. 1); returns theta at the samples [rad], impact count.

    ground : [m/s2], shape (n,)
    dt : its time step [s]
    alpha : slenderness [rad]
    p2 : squared frequency parameter [1/s2]
    one_sided : whether only positive rotations are possible
    ratio_of : velocity ratio [-] at the speed of an impact [rad/s]
    kinks : (phi1, phi2) of the trilinear law [rad], None for the rigid one
    cancelled : asked every few samples
    loads : (a, c) of the restoring moment for positive and for negative rotations [-]
    Raises Cancelled, and ArithmeticError where the steps of DOP853 become too small.
    """
    from scipy.integrate import DOP853  # all of scipy that the frozen program has: packaging/second_solver.py

    thresholds = [a * math.tan(alpha) + c if kinks is None else 0.0 for a, c in loads]
    if one_sided:
        thresholds[1] = math.inf
    levels = [] if kinks is None else list(kinks)
    side, phi, speed, moving = 1.0, 0.0, 0.0, False
    rest = 1e-6 * math.sqrt(p2) * alpha
    theta, impacts = [0.0], 0
    for i in range(len(ground) - 1):
        if i % 16 == 0 and cancelled():
            raise Cancelled
        b0, b1 = ground[i] / G, ground[i + 1] / G
        t = 0.0
        while t < dt:
            now = b0 + (b1 - b0) * t / dt
            if not moving:
                start = uplift(b0, b1, t, dt, thresholds)
                if start is None:
                    break
                t, side = start
                phi, speed, moving = 0.0, 0.0, True
            on_side = loads[0] if side > 0.0 else loads[1]

            def motion(s, y, b0=b0, b1=b1, side=side, on_side=on_side):
                beta = side * (b0 + (b1 - b0) * s / dt)
                restoring = law(y[0], alpha, kinks, *on_side)
                return [y[1], -p2 * (restoring - beta * math.cos(alpha - y[0]))]

            solver = DOP853(motion, t, [phi, speed], dt, rtol=3e-14, atol=1e-18, max_step=dt / 4)
            passed, others = None, [0.0, *(level for level in levels if level != phi)]
            while passed is None and solver.status == "running":
                if complaint := solver.step():
                    raise ArithmeticError(complaint)
                passed = crossing(solver, others)
            if passed is None:
                phi, speed = solver.y
                break
            t, speed, phi = passed
            if phi > 0.0:
                continue
            impacts += 1
            speed = ratio_of(-speed) * -speed
            side = side if one_sided else -side
            now = b0 + (b1 - b0) * t / dt
            lifts = now > thresholds[0] or now < -thresholds[1]
            moving = not (speed < rest and not lifts)
        theta.append(side * phi if moving else 0.0)
        if abs(theta[-1]) > 0.5 * math.pi:
            break
    return np.array(theta), impacts


def crossing(solver, levels):
    """(time, speed, level) of the first of some levels that phi passes in the last step of a solver, by halves of its
    dense output; None where it passes none. The level 0 is passed downwards alone."""
    found = None
    for level in levels:
        above = level == 0.0 or solver.y_old[0] > level
        if (solver.y[0] > level) == above:
            continue
        inside, low, high = solver.dense_output(), solver.t_old, solver.t
        while (middle := 0.5 * (low + high)) not in (low, high):
            low, high = (middle, high) if (inside(middle)[0] > level) == above else (low, middle)
        if found is None or high < found[0]:
            found = high, inside(high)[1], level
    return found


def uplift(b0, b1, t, dt, thresholds):
    """(time, side) of the next uplift in [t, dt), or None. thresholds : to both sides, infinite where there is none."""
    right, left = thresholds
    now = b0 + (b1 - b0) * t / dt
    if now > right:
        return t, 1.0
    if now < -left:
        return t, -1.0
    if b1 > b0:
        time, side = (right - b0) / (b1 - b0) * dt, 1.0
    elif b1 < b0:
        time, side = (-left - b0) / (b1 - b0) * dt, -1.0
    else:
        return None
    return (max(time, t), side) if time < dt else None
