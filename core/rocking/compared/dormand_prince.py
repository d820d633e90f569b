"""Adaptive embedded Runge-Kutta of order 8(5,3), Dormand and Prince, restarted at samples and events.

Tableau of Hairer, Norsett, Wanner (1993), as kept by scipy. Cost: 12 evaluations a step. Fails: on a dip
and return within one step; its tolerance bounds the local error, not what the motion makes of it.
"""

import functools
import math

import numpy as np

from core.jit.decorators import subkernel
from core.rocking.compared.branch import acceleration

STAGES = 12


@functools.cache
def tableau() -> np.ndarray:
    """Rows a_ij, then b, c, and the error weights of order 5 and 3, flat, shape (12 * 16,)."""
    from scipy.integrate import DOP853

    rows = [DOP853.A[k, :STAGES] for k in range(STAGES)]
    rows += [DOP853.B, DOP853.C[:STAGES], DOP853.E5[:STAGES], DOP853.E3[:STAGES]]
    return np.ascontiguousarray(np.concatenate(rows))


@subkernel
def single_step(phi, speed, beta, slope, h, model, zone, table, rates, pushes):
    """One step of length h: rotation, velocity and the error relative to alpha and p alpha."""
    for i in range(STAGES):
        x = phi
        v = speed
        for j in range(i):
            x += h * table[i * STAGES + j] * rates[j]
            v += h * table[i * STAGES + j] * pushes[j]
        rates[i] = v
        pushes[i] = acceleration(x, beta + h * table[13 * STAGES + i] * slope, model, zone)
    new_phi = phi
    new_speed = speed
    e5_phi = e5_speed = e3_phi = e3_speed = 0.0
    for i in range(STAGES):
        b = h * table[12 * STAGES + i]
        new_phi += b * rates[i]
        new_speed += b * pushes[i]
        e5_phi += table[14 * STAGES + i] * rates[i]
        e5_speed += table[14 * STAGES + i] * pushes[i]
        e3_phi += table[15 * STAGES + i] * rates[i]
        e3_speed += table[15 * STAGES + i] * pushes[i]
    p = math.sqrt(model.p2)
    fifth = e5_phi * e5_phi + e5_speed * e5_speed / model.p2
    third = e3_phi * e3_phi + e3_speed * e3_speed / model.p2
    total = fifth + 0.01 * third
    error = h * fifth / math.sqrt(total) if total > 0.0 else 0.0
    return new_phi, new_speed, error / model.slenderness * max(1.0, 1.0 / p)


@subkernel
def advance(phi, speed, beta, slope, h, model, zone, tolerance, table, rates, pushes):
    """Rotation [rad] and velocity [rad/s] after h [s], in as many steps as the tolerance asks."""
    done = 0.0
    step = h
    for _ in range(100_000):
        step = min(step, h - done)
        x, v, error = single_step(
            phi, speed, beta + done * slope, slope, step, model, zone, table, rates, pushes
        )
        if error <= tolerance or step < 1e-9 * h:
            phi = x
            speed = v
            if step >= h - done:
                return phi, speed
            done += step
            step *= 3.0
        else:
            step *= max(0.2, 0.9 * (tolerance / error) ** 0.125)
    return phi, speed
