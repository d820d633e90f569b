"""Adaptive embedded Runge-Kutta of order 8(5,3), Dormand and Prince, restarted at samples and events.

Tableau of Hairer, Norsett, Wanner (1993), code DOP853. Cost: 12 evaluations a step. Fails: on a dip
and return within one step; its tolerance bounds the local error, not what the motion makes of it.
"""

import functools
import math

import numpy as np

from core.jit.decorators import subkernel
from core.rocking.compared.branch import acceleration

STAGES = 12


STAGE_ROWS = (
    (0.05260015195876773,),
    (0.0197250569845379, 0.0591751709536137),
    (0.02958758547680685, 0.0, 0.08876275643042054),
    (0.2413651341592667, 0.0, -0.8845494793282861, 0.924834003261792),
    (0.037037037037037035, 0.0, 0.0, 0.17082860872947386, 0.12546768756682242),
    (0.037109375, 0.0, 0.0, 0.17025221101954405, 0.06021653898045596, -0.017578125),
    (
        0.03709200011850479,
        0.0,
        0.0,
        0.17038392571223998,
        0.10726203044637328,
        -0.015319437748624402,
        0.008273789163814023,
    ),
    (
        0.6241109587160757,
        0.0,
        0.0,
        -3.3608926294469414,
        -0.868219346841726,
        27.59209969944671,
        20.154067550477894,
        -43.48988418106996,
    ),
    (
        0.47766253643826434,
        0.0,
        0.0,
        -2.4881146199716677,
        -0.590290826836843,
        21.230051448181193,
        15.279233632882423,
        -33.28821096898486,
        -0.020331201708508627,
    ),
    (
        -0.9371424300859873,
        0.0,
        0.0,
        5.186372428844064,
        1.0914373489967295,
        -8.149787010746927,
        -18.52006565999696,
        22.739487099350505,
        2.4936055526796523,
        -3.0467644718982196,
    ),
    (
        2.273310147516538,
        0.0,
        0.0,
        -10.53449546673725,
        -2.0008720582248625,
        -17.9589318631188,
        27.94888452941996,
        -2.8589982771350235,
        -8.87285693353063,
        12.360567175794303,
        0.6433927460157636,
    ),
)
"""a_ij of the stages after the first."""

WEIGHTS = (
    0.054293734116568765,
    0.0,
    0.0,
    0.0,
    0.0,
    4.450312892752409,
    1.8915178993145003,
    -5.801203960010585,
    0.3111643669578199,
    -0.1521609496625161,
    0.20136540080403034,
    0.04471061572777259,
)
NODES = (
    0.0,
    0.05260015195876773,
    0.0789002279381516,
    0.1183503419072274,
    0.2816496580927726,
    0.3333333333333333,
    0.25,
    0.3076923076923077,
    0.6512820512820513,
    0.6,
    0.8571428571428571,
    1.0,
)
FIFTH = (
    0.01312004499419488,
    0.0,
    0.0,
    0.0,
    0.0,
    -1.2251564463762044,
    -0.4957589496572502,
    1.6643771824549864,
    -0.35032884874997366,
    0.3341791187130175,
    0.08192320648511571,
    -0.022355307863886294,
)
THIRD = (
    -0.18980075407240762,
    0.0,
    0.0,
    0.0,
    0.0,
    4.450312892752409,
    1.8915178993145003,
    -5.801203960010585,
    -0.4226823213237919,
    -0.1521609496625161,
    0.20136540080403034,
    0.02265179219836082,
)
"""b_i, c_i, and the weights of the errors of order 5 and 3."""


@functools.cache
def tableau() -> np.ndarray:
    """Rows a_ij, then b, c, and the error weights of order 5 and 3, flat, shape (16 * 12,)."""
    rows = np.zeros((STAGES + 4, STAGES))
    for k, row in enumerate(STAGE_ROWS, start=1):
        rows[k, :k] = row
    rows[STAGES:] = WEIGHTS, NODES, FIFTH, THIRD
    return rows.ravel()


@subkernel
def single_step(phi, speed, beta, slope, h, model, zone, table, rates, pushes):
    """One step: rotation [rad], velocity [rad/s] and the error relative to alpha and p alpha [-].

    phi : rotation at its start, seen from the pivot [rad]
    speed : velocity at its start [rad/s]
    beta : u''/g at its start, seen from the pivot [-]
    slope : rate of beta [1/s]
    h : its length [s]
    model : RockingModel as the pivot sees it
    zone : branch of the moment law
    table : of `tableau` [-], shape (16 * STAGES,) or longer
    rates : room for the velocities of the stages [rad/s], shape (STAGES,)
    pushes : room for their accelerations [rad/s2], shape (STAGES,)
    """
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
    """Rotation [rad] and velocity [rad/s] after h, in as many steps as the tolerance asks.

    phi : rotation at the start, seen from the pivot [rad]
    speed : velocity at the start [rad/s]
    beta : u''/g at the start, seen from the pivot [-]
    slope : rate of beta [1/s]
    h : time to go [s]
    model : RockingModel as the pivot sees it
    zone : branch of the moment law
    tolerance : largest error of a step, as `single_step` returns it [-]
    table : of `tableau` [-], shape (16 * STAGES,) or longer
    rates : room for the velocities of the stages [rad/s], shape (STAGES,)
    pushes : room for their accelerations [rad/s2], shape (STAGES,)
    """
    done = 0.0
    step = h
    for _ in range(100_000):
        step = min(step, h - done)
        x, v, error = single_step(phi, speed, beta + done * slope, slope, step, model, zone, table, rates, pushes)
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
