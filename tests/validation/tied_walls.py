"""A wall held by tie bars, written from forces and coordinates and integrated by small steps of Runge and Kutta's
fourth order, each event found by cutting the step in halves: nothing of it is of the program."""

import math

import numpy as np
from numba import njit

G = 9.80665

SLACK, TAUT, YIELDS, GONE = 0, 1, 2, 3


@njit
def acceleration(theta, side, phases, residuals, wall, loads, bars, u):
    """theta'' from the hinge of this side, outward from it.

    wall : (H, t, unit weight [N/m3]); loads : (N, distance from the outer face, height) [N/m, m] held elsewhere
    bars : (h, k, F_y) [m, N/m per m, N/m]; u : ground acceleration towards the restraint [m/s2]
    """
    height, thickness, weight = wall
    mass = weight * height * thickness / G
    c, s = math.cos(theta), math.sin(theta)
    inertia = mass * (height**2 + thickness**2) / 3.0
    moment = mass * G * (0.5 * thickness * c - 0.5 * height * s)
    moment -= side * u * mass * (0.5 * height * c + 0.5 * thickness * s)
    for n in range(loads.shape[0]):
        d = loads[n, 1] if side > 0 else thickness - loads[n, 1]
        moment += loads[n, 0] * (d * c - loads[n, 2] * s)
    if side > 0:
        for n in range(bars.shape[0]):
            h, k, most = bars[n, 0], bars[n, 1], bars[n, 2]
            if phases[n] == TAUT:
                moment += k * (h * s - residuals[n]) * h * c
            elif phases[n] == YIELDS:
                moment += most * h * c
    return -moment / inertia


@njit
def ground_at(ground, dt, t):
    i = min(int(t / dt), ground.size - 1)
    if i == ground.size - 1:
        return ground[i] if t <= i * dt else 0.0
    return ground[i] + (ground[i + 1] - ground[i]) * (t / dt - i)


@njit
def stepped(y, v, t, step, side, phases, residuals, wall, loads, bars, ground, dt):
    """(theta, its rate) after one step of the fourth order. The sample of the ground is that of the step's middle."""
    i = int((t + 0.5 * step) / dt)
    first = ground[i] if i < ground.size else 0.0
    last = ground[i + 1] if i + 1 < ground.size else 0.0
    slope = (last - first) / dt
    now, half = first + slope * (t - i * dt), 0.5 * step
    middle, end = now + slope * half, now + slope * step
    a1 = acceleration(y, side, phases, residuals, wall, loads, bars, now)
    v2 = v + half * a1
    a2 = acceleration(y + half * v, side, phases, residuals, wall, loads, bars, middle)
    v3 = v + half * a2
    a3 = acceleration(y + half * v2, side, phases, residuals, wall, loads, bars, middle)
    v4 = v + step * a3
    a4 = acceleration(y + step * v3, side, phases, residuals, wall, loads, bars, end)
    return y + step / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4), v + step / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4)


@njit
def happens(y, v, side, phases, residuals, bars):
    """Whether a state lies beyond the end of what its phases describe."""
    if y < 0.0:
        return True
    if side > 0:
        for n in range(bars.shape[0]):
            u, r = bars[n, 0] * math.sin(y), residuals[n]
            if phases[n] == SLACK and u > r:
                return True
            if phases[n] == TAUT and (u < r or u > r + bars[n, 2] / bars[n, 1] or u > bars[n, 3]):
                return True
            if phases[n] == YIELDS and (v < 0.0 or u > bars[n, 3]):
                return True
    return False


@njit
def run(ground, dt, wall, loads, bars, one_sided, ratio, rest, small, after):
    """(peak rotation outward, peak of both sides, residual elongations [m], whether gone, elastic and plastic work
    [N], whether it overturned).

    ground : [m/s2] towards the restraint, at dt [s]; then still for `after` [s]
    bars : (h, k, F_y, u at which it is gone, residual at the start), shape (n, 5)
    ratio : of the velocities; rest : speed below which it rests after an impact [rad/s]
    small : steps a sample
    """
    phases = np.zeros(bars.shape[0], np.int64)
    residuals = bars[:, 4].copy()
    work = 0.0
    side, y, v, moving = 1, 0.0, 0.0, False
    outward = both = 0.0
    step0 = dt / small
    total = (ground.size - 1 + int(after / dt)) * small
    for n in range(bars.shape[0]):
        phases[n] = SLACK if residuals[n] > 0.0 else TAUT
    for k in range(total):
        t, end = k * step0, (k + 1) * step0
        while t < end - 1e-13 * dt:
            if not moving:
                # uplift is looked for at the ends of a step, and within it by halves
                found = 0
                for way in (1, -1):
                    if (way < 0 and one_sided) or found != 0:
                        continue
                    if acceleration(0.0, way, phases, residuals, wall, loads, bars, ground_at(ground, dt, end)) > 0.0:
                        low, high = t, end
                        if acceleration(0.0, way, phases, residuals, wall, loads, bars, ground_at(ground, dt, t)) > 0.0:
                            high = t
                        while high - low > 1e-14 * dt and high > t:
                            mid = 0.5 * (low + high)
                            if mid <= low or mid >= high:
                                break
                            u = ground_at(ground, dt, mid)
                            if acceleration(0.0, way, phases, residuals, wall, loads, bars, u) > 0.0:
                                high = mid
                            else:
                                low = mid
                        found, t = way, high
                if found == 0:
                    t = end
                    continue
                side, y, v, moving = found, 0.0, 0.0, True
                if t >= end - 1e-13 * dt:
                    continue
            step = end - t
            y1, v1 = stepped(y, v, t, step, side, phases, residuals, wall, loads, bars, ground, dt)
            if happens(y1, v1, side, phases, residuals, bars):
                low, high = 0.0, step
                for _ in range(60):
                    mid = 0.5 * (low + high)
                    ym, vm = stepped(y, v, t, mid, side, phases, residuals, wall, loads, bars, ground, dt)
                    if happens(ym, vm, side, phases, residuals, bars):
                        high = mid
                    else:
                        low = mid
                step = high
                y1, v1 = stepped(y, v, t, step, side, phases, residuals, wall, loads, bars, ground, dt)
            t += step
            y, v = y1, v1
            if y < 0.0:
                y = 0.0
                v = ratio * max(-v, 0.0)
                u = ground_at(ground, dt, t)
                up = acceleration(0.0, 1, phases, residuals, wall, loads, bars, u) > 0.0
                if not one_sided:
                    side = -side
                    up = up or acceleration(0.0, -1, phases, residuals, wall, loads, bars, u) > 0.0
                if v < rest and not up:
                    v, moving = 0.0, False
                for n in range(bars.shape[0]):
                    if phases[n] != GONE:
                        phases[n] = SLACK if residuals[n] > 0.0 else TAUT
                continue
            if side > 0:
                outward = max(outward, y)
                for n in range(bars.shape[0]):
                    x, at_yield = bars[n, 0] * math.sin(y), bars[n, 2] / bars[n, 1]
                    if phases[n] == SLACK and x > residuals[n]:
                        phases[n] = TAUT
                    elif phases[n] == TAUT and x < residuals[n]:
                        phases[n] = SLACK
                    elif phases[n] == TAUT and x > residuals[n] + at_yield:
                        phases[n] = YIELDS
                    elif phases[n] == YIELDS and v < 0.0:
                        work += bars[n, 2] * (x - at_yield - residuals[n])
                        residuals[n] = x - at_yield
                        phases[n] = TAUT
                    if phases[n] != SLACK and phases[n] != GONE and x > bars[n, 3]:
                        if phases[n] == YIELDS:
                            work += bars[n, 2] * (x - at_yield - residuals[n])
                            residuals[n] = x - at_yield
                        phases[n] = GONE
            both = max(both, y)
            if y > 0.5 * math.pi:
                return outward, both, residuals, phases == GONE, work, True
    return outward, both, residuals, phases == GONE, work, False
