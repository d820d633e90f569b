"""The functions of a wall held at its top by the coordinate of constant mass (resources/docs/physics.md, section 19).

y with y' = sqrt(I(theta)/I_0) theta'; v, x, the potential and theta are polynomials in pieces of y.
"""

import functools
import math
from typing import NamedTuple

import numpy as np

from core.jit.decorators import kernel, subkernel
from core.wall.bending import HeldTop, Motion, near_rest

MAX_OVER_COLLAPSE, MAX_SHARE_OF_REST = 2.5, 0.8
"""The motion is followed to so many times the rotation of collapse, at most to this share of the way to where the
upper block no longer reaches what holds it: beyond it the wall has overturned."""

PIECES, DEGREE, OVERLAP = 32, 7, 1.5
"""Pieces of the functions of y, the degree of each, and how far it holds over its half width: to 1e-13 of their size
(tests/core/rocking/test_held_top.py)."""

SPECTRAL = 96
"""Degree of the series by which y, its inverse and the potential are made."""


class Side(NamedTuple):
    """Functions of y to one side.

    scale : pieces in a unit of y [-]; end : y at which the wall has overturned, top : y of collapse [rad]
    barrier : potential at `top` [-]
    values : polynomials of v, x, the potential and theta in each piece, in -1 to 1, shape (PIECES, 4, DEGREE + 1)
    """

    scale: float
    end: float
    top: float
    barrier: float
    values: np.ndarray


V, X, POTENTIAL, THETA = range(4)
"""The functions of `Side.values`."""


@functools.lru_cache(maxsize=64)
def sides_of(held: HeldTop, slenderness: float, collapse: tuple[float, float]) -> tuple[Side, Side]:
    """The functions outward and inward. slenderness : alpha of the model; collapse : theta_c of both sides [rad]"""
    first = held.side(1.0)
    inertia, (p2, _, _) = float(first.parts(np.zeros(1))[0][0]), near_rest(first, slenderness)
    return side_of(first, inertia, p2, collapse[0]), side_of(held.side(-1.0), inertia, p2, collapse[1])


def side_of(motion: Motion, inertia: float, p2: float, collapse: float) -> Side:
    """The functions of one side. inertia : I_0 [kg m]; collapse : theta_c [rad]. Raises ValueError where they are no
    numbers, of a hinge so near the top that the upper block cannot turn."""
    cheb = np.polynomial.chebyshev.Chebyshev
    last = min(MAX_OVER_COLLAPSE * collapse, collapse + MAX_SHARE_OF_REST * (motion.last - collapse))
    domain = [-last / PIECES, last]  # the first piece overlaps rest
    rate = cheb.interpolate(lambda theta: np.sqrt(motion.parts(theta)[0] / inertia), SPECTRAL, domain)
    work = cheb.interpolate(lambda theta: motion.parts(theta)[1] / (inertia * p2), SPECTRAL, domain)
    y_of, stored = rate.integ(lbnd=0.0), work.integ(lbnd=0.0)
    end = float(y_of(last)) * PIECES / (PIECES + OVERLAP)  # the last piece overlaps it
    nodes = OVERLAP * np.cos(math.pi * (np.arange(DEGREE + 1) + 0.5) / (DEGREE + 1))
    y = ((np.arange(PIECES)[:, None] + 0.5 * (1.0 + nodes)) * (end / PIECES)).ravel()
    theta = y * (last / end)
    for _ in range(50):
        step = (y_of(theta) - y) / rate(theta)
        theta = theta - step
        if np.abs(step).max() < 1e-15:
            break
    inertias, risen, moved = motion.parts(theta)
    slope = np.sqrt(inertias / inertia) * inertia * p2
    at_nodes = np.stack([risen / slope, moved / slope, stored(theta), theta], axis=1).reshape(PIECES, DEGREE + 1, 4)
    values = np.linalg.solve(np.vander(nodes, increasing=True), at_nodes)
    top = float(y_of(collapse))
    if not (math.isfinite(top) and np.isfinite(values).all()):
        raise ValueError(collapse)
    return Side(PIECES / end, end, top, float(stored(collapse)), np.ascontiguousarray(values.transpose(0, 2, 1)))


@subkernel
def evaluate_side(which, y, side):
    """One of the functions of y, continued beyond its ends. which : V, X, POTENTIAL or THETA; side : Side"""
    at = y * side.scale
    piece = min(max(int(at), 0), PIECES - 1)
    s, total = 2.0 * (at - piece) - 1.0, 0.0
    for k in range(DEGREE, -1, -1):
        total = total * s + side.values[piece, which, k]
    return total


@subkernel
def evaluate_side_slope(which, y, side):
    """The derivative of `value` by y."""
    at = y * side.scale
    piece = min(max(int(at), 0), PIECES - 1)
    s, total = 2.0 * (at - piece) - 1.0, 0.0
    for k in range(DEGREE, 0, -1):
        total = total * s + k * side.values[piece, which, k]
    return 2.0 * side.scale * total


@subkernel
def invert_side(which, reached, end, side):
    """y in [0, end] at which one of the functions, which grows there, reaches a value [rad]."""
    low, high = 0.0, end
    for _ in range(80):
        middle = 0.5 * (low + high)
        if evaluate_side(which, middle, side) < reached:
            low = middle
        else:
            high = middle
    return high


@subkernel
def turned_by(y, side):
    """theta [rad] at y, zero exactly at rest."""
    return max(evaluate_side(THETA, y, side), 0.0) if y > 0.0 else 0.0


@kernel
def to_rotations(y, rate, outward, inward):
    """Turn y [rad] and y' [rad/s] into theta and theta' in place, shape (n,). outward, inward : Side"""
    for i in range(y.size):
        side, sign = (outward, 1.0) if y[i] >= 0.0 else (inward, -1.0)
        rate[i] *= evaluate_side_slope(THETA, sign * y[i], side)
        y[i] = sign * turned_by(sign * y[i], side)


@kernel
def to_y(theta, speed, side):
    """y [rad] and y' [rad/s] of a rotation to this side. speed : theta' [rad/s]; side : Side"""
    y = invert_side(THETA, theta, side.end, side) if theta > 0.0 else 0.0
    return y, speed / evaluate_side_slope(THETA, y, side)


@kernel
def rotation_at(y, side):
    """theta [rad] at y; side : Side"""
    return turned_by(y, side)
