"""Independent truth in double precision: scipy's DOP853 restarted at samples and events.

It shares no line with the kernels: uplift, impacts, rest and kinks are its own. A second or two a history.
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
    Raises Cancelled.
    """
    from scipy.integrate import solve_ivp

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

            events = [_event(0.0, -1)] + [_event(level, 0) for level in levels if level != phi]
            solution = solve_ivp(
                motion, (t, dt), [phi, speed], "DOP853", rtol=3e-14, atol=1e-18, max_step=dt / 4, events=events
            )
            t = solution.t[-1]
            phi, speed = solution.y[:, -1]
            if solution.status != 1:
                break
            if len(solution.t_events[0]) == 0:
                phi = min(levels, key=lambda level: abs(level - phi))
                continue
            impacts += 1
            speed = ratio_of(-speed) * -speed
            phi = 0.0
            side = side if one_sided else -side
            now = b0 + (b1 - b0) * t / dt
            lifts = now > thresholds[0] or now < -thresholds[1]
            moving = not (speed < rest and not lifts)
        theta.append(side * phi if moving else 0.0)
        if abs(theta[-1]) > 0.5 * math.pi:
            break
    return np.array(theta), impacts


def _event(level, direction):
    def crossing(s, y):
        return y[0] - level

    # attributes by which scipy takes an event
    vars(crossing).update(terminal=True, direction=direction)
    return crossing


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
